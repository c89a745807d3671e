// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#include "output/loops_output.h"

#include "output/output_file.h"
#include "output/polylines_output.h"

#include <CGAL/Reeb_graph/IO/vtp.h>
#include <CGAL/Reeb_graph/internal/io/text.h>

#include <cstdint>
#include <limits>
#include <ostream>
#include <string>
#include <vector>

namespace reeb_graph_program {
namespace {
std::string format_of_loops(const std::filesystem::path& path, const std::string& contents = "loops")
{
  return ending_of(path, contents, {".vtp", ".obj", ".polylines.txt"});
}

// Each loop is a line; its first point is not repeated.
void write_vtp_of_loops(std::ostream& out, const Loops_of_surface& loops)
{
  CGAL::Reeb_graph::internal::Vtp_document::Cells lines;
  std::vector<double> coordinates, lengths, persistences, areas, centers, lower_corners, upper_corners;
  std::vector<std::int64_t> numbers, kinds, partners, components;
  const double none = std::numeric_limits<double>::quiet_NaN();
  for(std::size_t i = 0; i != loops.rows.size(); ++i)
  {
    const Loop_row& row = loops.rows[i];
    const std::size_t first = coordinates.size() / 3;
    for(std::size_t k = 0; k + 1 < loops.polylines[i].size(); ++k)
    {
      lines.add_point(coordinates.size() / 3);
      CGAL::Reeb_graph::internal::add_coordinates(loops.polylines[i][k], coordinates);
    }
    lines.add_point(first);
    lines.end_cell();
    numbers.push_back(static_cast<std::int64_t>(i));
    kinds.push_back(row.kind == "handle" ? 0 : row.kind == "tunnel" ? 1 : row.kind == "hole" ? 2 : 3);
    partners.push_back(row.partner ? static_cast<std::int64_t>(*row.partner) : -1);
    components.push_back(static_cast<std::int64_t>(row.component));
    lengths.push_back(row.length);
    persistences.push_back(row.persistence.value_or(none));
    areas.push_back(row.area.value_or(none));
    centers.insert(centers.end(), row.place.center.begin(), row.place.center.end());
    lower_corners.insert(lower_corners.end(), row.place.box[0].begin(), row.place.box[0].end());
    upper_corners.insert(upper_corners.end(), row.place.box[1].begin(), row.place.box[1].end());
  }
  CGAL::Reeb_graph::internal::Vtp_document document(out, coordinates.size() / 3, {}, lines, {});
  document.write_section("Points", "", [&] { document.write_array("Points", coordinates, 3); });
  document.write_section("CellData", "kind", [&] {
    document.write_array("loop", numbers);
    document.write_array("kind", kinds);
    document.write_array("partner", partners);
    document.write_array("component", components);
    document.write_array("length", lengths);
    document.write_array("persistence", persistences);
    document.write_array("area", areas);
    document.write_array("center", centers, 3);
    document.write_array("box_min", lower_corners, 3);
    document.write_array("box_max", upper_corners, 3);
  });
  document.finish();
}

// Each loop is a line in a group of its own, whose name has its kind.
void write_obj_of_loops(std::ostream& out, const Loops_of_surface& loops)
{
  const CGAL::Reeb_graph::internal::Classic_locale classic_locale(out);
  out.precision(std::numeric_limits<double>::max_digits10);
  std::size_t first = 1;
  for(std::size_t i = 0; i != loops.rows.size(); ++i)
  {
    const std::size_t size = loops.polylines[i].size() - 1;
    for(std::size_t k = 0; k != size; ++k)
      out << "v " << loops.polylines[i][k] << '\n';
    out << "g " << loops.rows[i].kind << '_' << i << "\nl";
    for(std::size_t k = 0; k != size; ++k)
      out << ' ' << first + k;
    out << ' ' << first << '\n';
    first += size;
  }
}

} // namespace

void check_loops_format(const std::filesystem::path& path, const std::string& contents)
{
  format_of_loops(path, contents);
}

void write_loops(const std::filesystem::path& path, const Loops_of_surface& loops)
{
  const std::string format = format_of_loops(path);
  if(format == ".polylines.txt")
    write_polylines(path.string(), loops.polylines);
  else
    write_file(path, [&](std::ostream& stream) {
      if(format == ".vtp")
        write_vtp_of_loops(stream, loops);
      else
        write_obj_of_loops(stream, loops);
    });
}

} // namespace reeb_graph_program
