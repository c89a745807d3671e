// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_SRC_HELP_H
#define CGAL_REEB_GRAPH_SRC_HELP_H

#include <CLI/CLI.hpp>

#include <cstddef>
#include <sstream>
#include <string>

// What --help prints: options in groups, a list of the fields, and an example, in lines of at most 100 characters.
namespace reeb_graph_program {
class Help_formatter : public CLI::Formatter
{
  std::string make_option_desc(const CLI::Option* option) const override
  {
    constexpr std::size_t width = 68; // beside the column of names
    std::istringstream words(CLI::Formatter::make_option_desc(option));
    std::string text;
    std::size_t length = 0;
    for(std::string word; words >> word; length += word.size())
    {
      if(length != 0)
        text += length + 1 + word.size() > width ? '\n' : ' ';
      length = text.empty() || text.back() == '\n' ? 0 : length + 1;
      text += word;
    }
    return text;
  }
};

// Puts the options that are added next under this heading.
inline void begin_group(CLI::App& command, const std::string& name) { command.option_defaults()->group(name); }

inline const std::string coordinate_fields = "  x, y, z                   a coordinate\n";
inline const std::string height_field = "  height                    along --direction, by default 0,0,1\n";
inline const std::string computed_fields =
  height_field
  + "  harmonic                  0 at the vertex --min and 1 at --max, or between two vertices of each\n"
    "                            component that are far apart\n"
    "  harmonic-between-borders  0 on the first border of a component and 1 on its others; if there is\n"
    "                            one border only, 1 at a vertex far from it\n"
    "  poisson                   follows mean curvature, with 0 at the vertices --source, or at a tip\n"
    "  geodesic                  the distance from the vertices --source, or from a tip\n"
    "  unit-gradient             follows --scalars, or else harmonic, with gradients of length 1\n";
inline const std::string fields_of_files =
  "  NAME                      a property of the vertices of a PLY, VTK, VTU, or VTP file\n";

// Both stand behind the options, in this order.
inline void add_list_of_fields(CLI::App& command, const std::string& option, const std::string& fields)
{
  command.footer("Fields, for " + option + ":\n" + fields);
}

inline void add_example(CLI::App& command, const std::string& example)
{
  const std::string footer = command.get_footer();
  command.footer(footer + (footer.empty() ? "" : "\n") + "Example:\n  " + example);
}

} // namespace reeb_graph_program

#endif // CGAL_REEB_GRAPH_SRC_HELP_H
