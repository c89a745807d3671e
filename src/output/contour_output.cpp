// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#include "output/contour_output.h"

#include "output/output_file.h"

#include <CGAL/IO/OFF.h>
#include <CGAL/Reeb_graph/IO/polylines.h>
#include <CGAL/Reeb_graph/IO/vtp.h>
#include <CGAL/Reeb_graph/internal/base/lengths.h>
#include <CGAL/Reeb_graph/internal/io/text.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <ostream>
#include <utility>
#include <vector>

namespace reeb_graph_program {
namespace {
constexpr int all_digits = std::numeric_limits<double>::max_digits10;

// A line of a contour; a point alone where that is on an edge without triangles.
struct Contour_line
{
  Polyline points;
  std::int64_t arc = 0; // -1 for none
  double value = 0;
  double length = 0;
  bool is_closed = false;
};

std::vector<Contour_line> lines_of(const std::vector<Contour>& contours)
{
  std::vector<Contour_line> lines;
  for(const Contour& contour : contours)
    for(const std::vector<std::size_t>& numbers : contour.polylines)
    {
      Contour_line line = {{},
                           static_cast<std::int64_t>(contour.arc),
                           contour.value,
                           0,
                           numbers.size() > 1 && numbers.front() == numbers.back()};
      for(const std::size_t i : numbers)
      {
        if(!line.points.empty())
          line.length += CGAL::Reeb_graph::internal::distance_between(line.points.back(), contour.points[i]);
        line.points.push_back(contour.points[i]);
      }
      lines.push_back(std::move(line));
    }
  return lines;
}

void write_off(std::ostream& stream, const std::vector<Contour>& contours)
{
  std::vector<Point> points;
  std::vector<std::array<std::size_t, 3>> triangles;
  for(const Contour& contour : contours)
  {
    for(const auto& [a, b, c] : contour.triangles)
      triangles.push_back({points.size() + a, points.size() + b, points.size() + c});
    points.insert(points.end(), contour.points.begin(), contour.points.end());
  }
  CGAL::IO::write_OFF(stream, points, triangles, CGAL::parameters::stream_precision(all_digits));
}

// The number of points of a line if the first one is not repeated.
std::size_t number_of_points(const Contour_line& line) { return line.points.size() - (line.is_closed ? 1 : 0); }

// Calls visit(number of a point, counted from 0 in the file) along the line.
template <class Visit>
void visit_points(const Contour_line& line, std::size_t first, const Visit& visit)
{
  for(std::size_t i = 0; i < line.points.size(); ++i)
    visit(first + i % number_of_points(line));
}

void write_obj(std::ostream& stream, const std::vector<Contour_line>& lines)
{
  stream.precision(all_digits);
  std::size_t first = 1;
  for(const Contour_line& line : lines)
  {
    for(std::size_t i = 0; i < number_of_points(line); ++i)
      stream << "v " << line.points[i] << '\n';
    stream << "# arc " << line.arc << " value " << line.value << " length " << line.length << " closed "
           << line.is_closed << "\ng arc_" << line.arc << '\n'
           << (line.points.size() > 1 ? 'l' : 'p');
    visit_points(line, first, [&](std::size_t point) { stream << ' ' << point; });
    stream << '\n';
    first += number_of_points(line);
  }
}

void write_json(std::ostream& stream, const std::vector<Contour_line>& lines)
{
  using CGAL::Reeb_graph::internal::json_list;
  using CGAL::Reeb_graph::internal::json_of;
  stream << "{\n\"contours\": [";
  for(std::size_t i = 0; i < lines.size(); ++i)
  {
    const Contour_line& line = lines[i];
    stream << (i == 0 ? "\n" : ",\n") << "{\"arc\": " << line.arc << ", \"value\": " << json_of(line.value)
           << ", \"length\": " << json_of(line.length) << ", \"closed\": " << (line.is_closed ? "true" : "false")
           << ", \"polyline\": "
           << json_list(line.points, [](const Point& p) { return CGAL::Reeb_graph::internal::json_of_point(p); })
           << '}';
  }
  stream << "\n]\n}\n";
}

// A row for each point.
void write_csv(std::ostream& stream, const std::vector<Contour_line>& lines)
{
  CGAL::Reeb_graph::internal::Text_output text(stream);
  text << "contour,arc,value,length,closed,x,y,z\n";
  for(std::size_t i = 0; i < lines.size(); ++i)
    for(const Point& p : lines[i].points)
      text << i << ',' << lines[i].arc << ',' << lines[i].value << ',' << lines[i].length << ','
           << (lines[i].is_closed ? 1 : 0) << ',' << p.x() << ',' << p.y() << ',' << p.z() << '\n';
  text.flush();
}

// A line of one point, of an edge without triangles, is a vertex for VTK, whose cells come before all lines.
void write_vtp(std::ostream& stream, const std::vector<Contour_line>& lines)
{
  CGAL::Reeb_graph::internal::Vtp_document::Cells vertex_cells, line_cells;
  std::vector<double> coordinates, values, lengths;
  std::vector<std::int64_t> arcs, closed;
  for(const bool has_lines : {false, true})
    for(const Contour_line& line : lines)
    {
      if((line.points.size() > 1) != has_lines)
        continue;
      auto& cells = has_lines ? line_cells : vertex_cells;
      visit_points(line, coordinates.size() / 3, [&](std::size_t point) { cells.add_point(point); });
      cells.end_cell();
      for(std::size_t i = 0; i < number_of_points(line); ++i)
        CGAL::Reeb_graph::internal::add_coordinates(line.points[i], coordinates);
      arcs.push_back(line.arc);
      values.push_back(line.value);
      lengths.push_back(line.length);
      closed.push_back(line.is_closed ? 1 : 0);
    }
  CGAL::Reeb_graph::internal::Vtp_document document(stream, coordinates.size() / 3, vertex_cells, line_cells, {});
  document.write_section("Points", "", [&] { document.write_array("Points", coordinates, 3); });
  document.write_section("CellData", "value", [&] {
    document.write_array("arc", arcs);
    document.write_array("value", values);
    document.write_array("length", lengths);
    document.write_array("closed", closed);
  });
  document.finish();
}

std::vector<Polyline> polylines_of(const std::vector<Contour_line>& lines)
{
  std::vector<Polyline> polylines;
  for(const Contour_line& line : lines)
    polylines.push_back(line.points);
  return polylines;
}

} // namespace

void check_contour_format(const std::string& path)
{
  ending_of(path, "contours", {".polylines.txt", ".vtp", ".obj", ".json", ".csv", ".off"});
}

void check_contour_format(const std::string& path, bool are_contours_surfaces)
{
  if(are_contours_surfaces)
    ending_of(path, "contours in tetrahedra, which are surfaces,", {".off"});
  else
    ending_of(path, "contours", {".polylines.txt", ".vtp", ".obj", ".json", ".csv"});
}

void write_contours(const std::string& path, const std::vector<Contour>& contours, bool are_contours_surfaces)
{
  write_file(path, [&](std::ostream& stream) {
    if(are_contours_surfaces)
      return write_off(stream, contours);
    const std::vector<Contour_line> lines = lines_of(contours);
    const std::string ending = ending_of(path, "contours", {".polylines.txt", ".vtp", ".obj", ".json", ".csv"});
    if(ending == ".vtp")
      write_vtp(stream, lines);
    else if(ending == ".obj")
      write_obj(stream, lines);
    else if(ending == ".json")
      write_json(stream, lines);
    else if(ending == ".csv")
      write_csv(stream, lines);
    else
      CGAL::Reeb_graph::write_polylines(stream, polylines_of(lines));
  });
}

} // namespace reeb_graph_program
