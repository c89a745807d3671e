// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_BENCHMARK_TABLE_H
#define CGAL_REEB_GRAPH_BENCHMARK_TABLE_H

#include <algorithm>
#include <cstddef>
#include <cstdio>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace benchmark {
struct Column
{
  std::string first_line, second_line; // of the head
  std::size_t width = 0;               // at least
};

inline std::string cell(std::optional<double> value, int number_of_digits)
{
  if(!value)
    return "-";
  char text[64];
  std::snprintf(text, sizeof(text), "%.*f", number_of_digits, *value);
  return text;
}

inline std::string cell(std::size_t number) { return std::to_string(number); }

// A table whose rows are printed as they come.
class Table
{
public:
  Table(const std::string& title, std::vector<Column> columns) : columns_(std::move(columns))
  {
    std::vector<std::string> first_line, second_line;
    for(Column& column : columns_)
    {
      column.width = std::max({column.width, column.first_line.size(), column.second_line.size()});
      first_line.push_back(column.first_line);
      second_line.push_back(column.second_line);
    }
    std::printf("\n%s\n\n", title.c_str());
#if defined(__GNUC__) && !defined(__OPTIMIZE__)
    std::printf("NOT OPTIMIZED: only scripts/benchmark, or an own build, tells what the package takes.\n\n");
#endif
    print_row(first_line);
    print_row(second_line);
  }

  void print_row(const std::vector<std::string>& cells) const
  {
    std::string line;
    for(std::size_t i = 0; i < cells.size() && i < columns_.size(); ++i)
    {
      const std::size_t padding = columns_[i].width - std::min(columns_[i].width, cells[i].size());
      line += (i == 0 ? "" : "  ") + std::string(padding, ' ') + cells[i];
    }
    std::printf("%s\n", line.c_str());
    std::fflush(stdout);
  }

private:
  std::vector<Column> columns_;
};

} // namespace benchmark

#endif // CGAL_REEB_GRAPH_BENCHMARK_TABLE_H
