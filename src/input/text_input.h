// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_SRC_TEXT_INPUT_H
#define CGAL_REEB_GRAPH_SRC_TEXT_INPUT_H

#include "input/input_error.h"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>
#include <string_view>
#include <system_error>
#include <type_traits>

namespace reeb_graph_program {
// Reads all of a text as a number, whatever the locale.
template <class Number>
std::errc parse_number(std::string_view text, Number& number)
{
  if(text.size() > 1 && text[0] == '+' && text[1] != '-')
    text.remove_prefix(1); // std::from_chars takes no plus sign
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if(error == std::errc() && end != text.data() + text.size())
    return std::errc::invalid_argument;
  return error;
}

// The next word of a line from `begin` on, empty at the end.
inline std::string_view next_word(std::string_view line, std::size_t begin)
{
  const char* const blanks = " \t\r\v\f";
  begin = line.find_first_not_of(blanks, begin);
  if(begin == std::string_view::npos)
    return {};
  return line.substr(begin, line.find_first_of(blanks, begin) - begin);
}

inline std::string lower_case_extension(const std::string& path)
{
  std::string extension = std::filesystem::path(path).extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return extension;
}

// A text file, read line by line and word by word.
class Text_input
{
public:
  explicit Text_input(const std::string& path) : path_(path), file_(path, std::ios::binary)
  {
    if(!file_)
      throw Input_error(path_, "the file cannot be read");
  }

  bool next_line()
  {
    position_ = 0;
    line_.clear();
    if(!std::getline(file_, line_))
    {
      if(file_.bad())
        fail("the file cannot be read");
      return false;
    }
    ++line_number_;
    return true;
  }

  // Leaves out what is behind the character at which comments begin.
  void remove_comment(char begin) { line_.resize((std::min)(line_.find(begin), line_.size())); }

  // Makes the next line a part of this one if this one ends in a backslash.
  void join_next_line()
  {
    for(std::size_t last = line_.find_last_not_of(" \t\r"); last != std::string::npos && line_[last] == '\\';
        last = line_.find_last_not_of(" \t\r"))
    {
      line_[last] = ' ';
      std::string next;
      if(!std::getline(file_, next))
        return;
      ++line_number_;
      line_ += next;
    }
  }

  // The next word of this line, empty at its end.
  std::string_view word_of_line()
  {
    const std::string_view word = next_word(line_, position_);
    position_ = word.empty() ? line_.size() : static_cast<std::size_t>(word.data() + word.size() - line_.data());
    return word;
  }

  // The same word as the next call of word_of_line().
  std::string_view next_word_of_line() const { return next_word(line_, position_); }

  // Leaves out the words of this line that have not been read.
  void finish_line() { position_ = line_.size(); }

  // Goes back to the beginning of the file.
  void restart()
  {
    file_.clear();
    file_.seekg(0);
    line_.clear();
    position_ = line_number_ = 0;
  }

  // The next word of this line or of a later one, empty at the end of the file.
  std::string_view word_of_file()
  {
    std::string_view word = word_of_line();
    while(word.empty() && next_line())
      word = word_of_line();
    return word;
  }

  template <class Number>
  Number number(std::string_view word) const
  {
    Number result{};
    const std::errc error = parse_number(word, result);
    if(std::is_floating_point<Number>::value && error == std::errc::result_out_of_range)
      return rounded_to_zero<Number>(word);
    if(error != std::errc())
      fail(word.empty() ? "a number is missing"
                        : quote(word) + " is not "
                            + (std::is_floating_point<Number>::value ? "a number" : "a number that is possible here"));
    return result;
  }

  std::ifstream& file() { return file_; }
  std::size_t line_number() const { return line_number_; }

  [[noreturn]] void fail(const std::string& message) const { throw Input_error(path_, line_number_, message); }

private:
  template <class Number>
  Number rounded_to_zero(std::string_view word) const
  {
    const double value = std::strtod(std::string(word).c_str(), nullptr);
    if(!(std::abs(value) < 1))
      fail(quote(word) + " is too large");
    return static_cast<Number>(value);
  }

  std::string path_, line_;
  std::ifstream file_;
  std::size_t position_ = 0, line_number_ = 0;
};

} // namespace reeb_graph_program

#endif // CGAL_REEB_GRAPH_SRC_TEXT_INPUT_H
