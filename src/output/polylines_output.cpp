// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#include "output/polylines_output.h"

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
#include <string>
#include <utility>
#include <vector>

namespace reeb_graph_program {
void check_polylines_format(const std::string& path) { ending_of(path, "polylines", {".polylines.txt", ".csv"}); }

void write_polylines(const std::string& path, const std::vector<Polyline>& polylines)
{
  write_file(path, [&](std::ostream& stream) {
    if(ending_of(path, "polylines", {".polylines.txt", ".csv"}) != ".csv")
      return CGAL::Reeb_graph::write_polylines(stream, polylines);
    CGAL::Reeb_graph::internal::Text_output text(stream);
    text << "curve,x,y,z\n";
    for(std::size_t i = 0; i < polylines.size(); ++i)
      for(const Point& p : polylines[i])
        text << i << ',' << p.x() << ',' << p.y() << ',' << p.z() << '\n';
    text.flush();
  });
}

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
