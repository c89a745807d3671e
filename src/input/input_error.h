// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_SRC_INPUT_ERROR_H
#define CGAL_REEB_GRAPH_SRC_INPUT_ERROR_H

#include "base/standard_input.h"

#include <cstddef>
#include <filesystem>
#include <stdexcept>
#include <string>
#include <string_view>
#include <system_error>

namespace reeb_graph_program {
// What is wrong with an input file, and where.
class Input_error : public std::runtime_error
{
public:
  Input_error(const std::string& path, const std::string& message)
    : std::runtime_error((is_standard_input(path) ? name_of_input(path) : path) + ": " + message)
  {}
  Input_error(const std::string& path, std::size_t line, const std::string& message)
    : Input_error((is_standard_input(path) ? name_of_input(path) : path) + ":" + std::to_string(line), message)
  {}
};

// Why a file is not read.
inline Input_error unreadable_file(const std::string& path)
{
  std::error_code ignored;
  return Input_error(path, !std::filesystem::exists(path, ignored)        ? "there is no such file"
                           : std::filesystem::is_directory(path, ignored) ? "this is a folder"
                                                                          : "the file cannot be read");
}

// A part of a file as messages show it: in quotation marks, at most 60 characters of it, and none that control a
// terminal.
inline std::string quote(std::string_view text)
{
  constexpr std::size_t longest = 60;
  const bool is_cut = text.size() > longest;
  std::size_t end = is_cut ? longest - 3 : text.size();
  // not within a character of UTF-8
  while(is_cut && end > 0 && (static_cast<unsigned char>(text[end]) & 0xC0U) == 0x80U)
    --end;
  std::string shown(text.substr(0, end));
  for(char& c : shown)
    if(static_cast<unsigned char>(c) < ' ' || c == '\x7f')
      c = '?';
  return "'" + shown + (is_cut ? "...'" : "'");
}

} // namespace reeb_graph_program

#endif // CGAL_REEB_GRAPH_SRC_INPUT_ERROR_H
