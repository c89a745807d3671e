// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_SRC_TEXT_BLOCKS_H
#define CGAL_REEB_GRAPH_SRC_TEXT_BLOCKS_H

#include "base/threads.h"
#include "input/text_input.h"

#include <algorithm>
#include <cstddef>
#include <functional>
#include <string_view>
#include <vector>

namespace reeb_graph_program {
// A text in blocks of whole lines, which threads read at the same time. Lines that are joined by a backslash stay
// together. A small text is one block, as is any text if there is one thread.
class Text_blocks
{
public:
  explicit Text_blocks(const Text_input& input, std::size_t smallest_block = 1 << 20) : path_(input.path())
  {
    cut(input.rest(), smallest_block);
    first_lines_.resize(texts_.size() + 1, input.line_number());
    run_tasks(texts_.empty() ? 0 : texts_.size() - 1, [&](std::size_t i) {
      first_lines_[i + 1] = static_cast<std::size_t>(std::count(texts_[i].begin(), texts_[i].end(), '\n'));
    });
    for(std::size_t i = 1; i < texts_.size(); ++i)
      first_lines_[i] += first_lines_[i - 1];
  }

  std::size_t size() const { return texts_.size(); }

  // That of the text and of what is before it.
  std::size_t number_of_lines() const
  {
    if(texts_.empty())
      return first_lines_.front();
    Text_input last = input(size() - 1);
    while(last.next_line())
      continue;
    return last.line_number();
  }

  Text_input input(std::size_t block) const { return Text_input(path_, texts_[block], first_lines_[block]); }

  // Counts something in each block, and returns for each block what is before it. There is nothing before a single
  // block.
  std::vector<std::size_t> count_before(const std::function<std::size_t(Text_input&)>& count) const
  {
    std::vector<std::size_t> before(size());
    if(size() < 2)
      return before;
    run_tasks(size() - 1, [&](std::size_t i) {
      Text_input block = input(i);
      before[i + 1] = count(block);
    });
    for(std::size_t i = 1; i < size(); ++i)
      before[i] += before[i - 1];
    return before;
  }

private:
  void cut(std::string_view text, std::size_t smallest_block)
  {
    constexpr std::size_t blocks_per_thread = 4;
    const std::size_t number = number_of_threads() == 1 ? 1 : blocks_per_thread * number_of_threads();
    const std::size_t block_size = (std::max)(text.size() / number + 1, smallest_block);
    while(!text.empty())
    {
      const std::size_t size = size_of_block(text, block_size);
      texts_.push_back(text.substr(0, size));
      text.remove_prefix(size);
    }
  }

  // The least size from `size` on at which a whole line ends that is joined to none behind it: a backslash joins two
  // lines also if only blank ones are between them.
  static std::size_t size_of_block(std::string_view text, std::size_t size)
  {
    std::size_t begin = size < text.size() ? text.find('\n', size) : std::string_view::npos;
    while(begin != std::string_view::npos)
    {
      const std::size_t end = text.find('\n', ++begin);
      const std::string_view line = text.substr(begin, end - begin);
      if(end != std::string_view::npos && !next_word(line, 0).empty() && line.find('\\') == std::string_view::npos)
        return end + 1;
      begin = end;
    }
    return text.size();
  }

  std::string path_;
  std::vector<std::string_view> texts_;
  std::vector<std::size_t> first_lines_;
};

} // namespace reeb_graph_program

#endif // CGAL_REEB_GRAPH_SRC_TEXT_BLOCKS_H
