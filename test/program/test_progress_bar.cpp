// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#include "base/progress_bar.h"

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <iostream>
#include <sstream>
#include <string>
#include <thread>

// The progress bar as a terminal shows it; a run of the program is too short for one.

using reeb_graph_program::Progress_bar;

namespace {
// What is left on the line of a terminal to which the text is written.
std::string last_line(const std::string& text)
{
  std::string line;
  std::size_t place = 0;
  for(const char c : text)
    if(c == '\r')
      place = 0;
    else
    {
      line.resize(std::max(line.size(), place + 1), ' ');
      line[place++] = c;
    }
  return line;
}

void expect(bool is_right, const std::string& what)
{
  if(is_right)
    return;
  std::cerr << what << '\n';
  std::exit(EXIT_FAILURE);
}

} // namespace

int main()
{
  std::ostringstream terminal;
  {
    Progress_bar bar("graph", &terminal, 0);
    expect(terminal.str().empty(), "a bar is shown before anything is known");
    expect(bar(0), "the bar stops the work");
    expect(last_line(terminal.str()) == "graph [" + std::string(40, ' ') + "]   0 %", "a wrong bar at 0");
    bar(0.25);
    expect(last_line(terminal.str()) == "graph [##########" + std::string(30, ' ') + "]  25 %", "a wrong bar at 0.25");
    bar(1);
    expect(last_line(terminal.str()) == "graph [" + std::string(40, '#') + "] 100 %", "a wrong bar at 1");
  }
  expect(last_line(terminal.str()).find_first_not_of(' ') == std::string::npos, "the bar is left behind");

  std::ostringstream other_terminal;
  {
    Progress_bar bar_of_short_work("graph", &other_terminal, 1000);
    bar_of_short_work(0);
    bar_of_short_work(1);
    Progress_bar bar_without_terminal("graph", nullptr, 0);
    expect(bar_without_terminal(0.5), "the bar stops the work");
  }
  expect(other_terminal.str().empty(), "short work shows a bar");

  std::ostringstream third_terminal;
  {
    const Progress_bar bar("page", &third_terminal, 0.01);
    std::this_thread::sleep_for(std::chrono::milliseconds(500));
    Progress_bar inner_bar("embedding", &third_terminal, 0);
    inner_bar(0.5);
  }
  const std::string shown = third_terminal.str();
  expect(shown.find("\rpage ...\r        \r\rembedding [#") == 0,
         "not the name of work without steps, then that in it");
  expect(last_line(third_terminal.str()).find_first_not_of(' ') == std::string::npos, "bars are left behind");
  return EXIT_SUCCESS;
}
