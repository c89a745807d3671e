// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_SRC_TEXT_INPUT_H
#define CGAL_REEB_GRAPH_SRC_TEXT_INPUT_H

#include "base/threads.h"
#include "input/input_error.h"

#include <CGAL/Reeb_graph/internal/io/text.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <filesystem>
#include <functional>
#include <string>
#include <string_view>
#include <system_error>
#include <type_traits>
#include <vector>

namespace reeb_graph_program {
// Reads all of a text as a number, whatever the locale.
template <class Number>
std::errc parse_number(std::string_view text, Number& number)
{
  if(text.size() > 1 && text[0] == '+' && text[1] != '-')
    text.remove_prefix(1); // std::from_chars takes no plus sign
  const auto [end, error] = CGAL::Reeb_graph::internal::read_number(text.data(), text.data() + text.size(), number);
  if(error == std::errc() && end != text.data() + text.size())
    return std::errc::invalid_argument;
  return error;
}

// Whether a character stands between words; lines end otherwise.
inline bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\r' || c == '\v' || c == '\f'; }

// The next word of a line from `begin` on, empty at the end.
inline std::string_view next_word(std::string_view line, std::size_t begin)
{
  while(begin < line.size() && is_blank(line[begin]))
    ++begin;
  std::size_t end = begin;
  while(end < line.size() && !is_blank(line[end]))
    ++end;
  return line.substr(begin, end - begin);
}

inline std::string lower_case(std::string text)
{
  std::transform(text.begin(), text.end(), text.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return text;
}

inline std::string lower_case_extension(const std::string& path)
{
  return is_standard_input(path) ? extension_of_standard_input()
                                 : lower_case(std::filesystem::path(path).extension().string());
}

// Some programs begin a text with this mark of UTF-8, which says nothing of it.
inline std::string_view without_byte_order_mark(std::string_view text)
{
  constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";
  return text.substr(text.substr(0, byte_order_mark.size()) == byte_order_mark ? byte_order_mark.size() : 0);
}

// A text, read line by line and word by word: that of a file, or a part of it.
class Text_input
{
public:
  // `first_line` is the number of lines of the file before the text, which has to outlive this object. A byte order mark
  // before the first one is left out.
  Text_input(const std::string& path, std::string_view text, std::size_t first_line = 0)
    : path_(path),
      rest_(first_line == 0 ? without_byte_order_mark(text) : text),
      line_number_(first_line)
  {}

  bool next_line()
  {
    position_ = 0;
    line_ = take_line();
    return line_.data() != nullptr;
  }

  // Leaves out what is behind the character at which comments begin.
  void remove_comment(char begin) { line_ = line_.substr(0, line_.find(begin)); }

  // Makes the next line a part of this one if this one ends in a backslash.
  void join_next_line()
  {
    const auto last_of = [](std::string_view text) { return text.find_last_not_of(" \t\r"); };
    std::size_t last = last_of(line_);
    if(last == std::string_view::npos || line_[last] != '\\')
      return;
    joined_line_ = line_;
    for(; last != std::string::npos && joined_line_[last] == '\\'; last = last_of(joined_line_))
    {
      joined_line_[last] = ' ';
      const std::string_view next = take_line();
      joined_line_ += next;
      if(next.data() == nullptr)
        break;
    }
    line_ = joined_line_;
  }

  // The next word of this line, empty at its end.
  std::string_view word_of_line()
  {
    const std::string_view word = next_word_of_line();
    position_ = word.empty() ? line_.size() : static_cast<std::size_t>(word.data() + word.size() - line_.data());
    return word;
  }

  // The same word as the next call of word_of_line().
  std::string_view next_word_of_line() const { return next_word(line_, position_); }

  // Leaves out the words of this line that have not been read.
  void finish_line() { position_ = line_.size(); }

  // The next word of this line or of a later one, empty at the end of the text.
  std::string_view word_of_file()
  {
    std::string_view word = word_of_line();
    while(word.empty() && next_line())
      word = word_of_line();
    return word;
  }

  // Whether this is how the word that is read next begins.
  bool is_next(std::string_view begin_of_word) const
  {
    std::string_view text = next_word_of_line();
    if(text.empty())
      text = rest_.substr(std::min(rest_.find_first_not_of(" \t\r\v\f\n"), rest_.size()));
    return text.substr(0, begin_of_word.size()) == begin_of_word;
  }

  // Takes bytes behind this line, which are no text.
  std::string_view take_bytes(std::size_t size)
  {
    finish_line();
    if(size > rest_.size())
      fail("the file ends too early");
    const std::string_view bytes = rest_.substr(0, size);
    rest_.remove_prefix(size);
    return bytes;
  }

  template <class Number>
  Number number(std::string_view word) const
  {
    Number result{};
    const std::errc error = parse_number(word, result);
    if(error == std::errc())
      return result;
    if(std::is_floating_point<Number>::value && error == std::errc::result_out_of_range)
      return rounded_to_zero<Number>(word);
    fail(word.empty() ? "a number is missing"
                      : quote(word) + " is not "
                          + (std::is_floating_point<Number>::value ? "a number" : "a number that is possible here"));
  }

  // The line that was read last, without its end.
  std::string_view line() const { return line_; }

  // Behind that line.
  std::string_view rest() const { return rest_; }
  std::size_t line_number() const { return line_number_; }
  const std::string& path() const { return path_; }

  [[noreturn]] void fail(const std::string& message) const { throw Input_error(path_, line_number_, message); }

private:
  // The next line of the text, without its end; nothing, not even an empty text, at the end.
  std::string_view take_line()
  {
    if(rest_.empty())
      return {};
    const std::size_t end = rest_.find('\n');
    const std::string_view line = rest_.substr(0, end);
    rest_.remove_prefix(end == std::string_view::npos ? rest_.size() : end + 1);
    ++line_number_;
    return line;
  }

  template <class Number>
  Number rounded_to_zero(std::string_view word) const
  {
    const double value = std::strtod(std::string(word).c_str(), nullptr);
    if(!(std::abs(value) < 1))
      fail(quote(word) + " is too large");
    return static_cast<Number>(value);
  }

  std::string path_, joined_line_;
  std::string_view rest_, line_;
  std::size_t position_ = 0, line_number_;
};

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

#endif // CGAL_REEB_GRAPH_SRC_TEXT_INPUT_H
