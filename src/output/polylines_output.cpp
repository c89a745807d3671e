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

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <iterator>
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

// write_heading(number of a line) writes what is before it.
template <class WriteHeading>
void write_obj(std::ostream& stream, const std::vector<Contour_line>& lines, const WriteHeading& write_heading)
{
  const CGAL::Reeb_graph::internal::Classic_locale classic_locale(stream);
  stream.precision(all_digits);
  std::size_t first = 1;
  for(std::size_t i = 0; i < lines.size(); ++i)
  {
    for(std::size_t k = 0; k < number_of_points(lines[i]); ++k)
      stream << "v " << lines[i].points[k] << '\n';
    write_heading(i);
    stream << '\n' << (lines[i].points.size() > 1 ? 'l' : 'p');
    visit_points(lines[i], first, [&](std::size_t point) { stream << ' ' << point; });
    stream << '\n';
    first += number_of_points(lines[i]);
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

using CGAL::Reeb_graph::internal::Vtp_document;

// A line of one point, of an edge without triangles, is a vertex for VTK, and has to come before all others.
template <class WriteColumns>
void write_vtp(std::ostream& stream,
               const std::vector<Contour_line>& lines,
               const std::string& active_column,
               const WriteColumns& write_columns)
{
  Vtp_document::Cells vertex_cells, line_cells;
  std::vector<double> coordinates;
  for(const Contour_line& line : lines)
  {
    Vtp_document::Cells& cells = line.points.size() > 1 ? line_cells : vertex_cells;
    visit_points(line, coordinates.size() / 3, [&](std::size_t point) { cells.add_point(point); });
    cells.end_cell();
    for(std::size_t i = 0; i < number_of_points(line); ++i)
      CGAL::Reeb_graph::internal::add_coordinates(line.points[i], coordinates);
  }
  Vtp_document document(stream, coordinates.size() / 3, vertex_cells, line_cells, {});
  document.write_section("Points", "", [&] { document.write_array("Points", coordinates, 3); });
  document.write_section("CellData", active_column, [&] { write_columns(document); });
  document.finish();
}

// Writes a number of each row.
template <class Row, class NumberOf>
void write_column(Vtp_document& document,
                  const std::string& name,
                  const std::vector<Row>& rows,
                  const NumberOf& number_of)
{
  std::vector<decltype(number_of(rows[0]))> numbers;
  std::transform(rows.begin(), rows.end(), std::back_inserter(numbers), number_of);
  document.write_array(name, numbers);
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
    std::vector<Contour_line> lines = lines_of(contours);
    const std::string ending = ending_of(path, "contours", {".polylines.txt", ".vtp", ".obj", ".json", ".csv"});
    if(ending == ".vtp")
    {
      typedef Contour_line Line;
      std::stable_partition(lines.begin(), lines.end(), [](const Line& line) { return line.points.size() == 1; });
      write_vtp(stream, lines, "value", [&](Vtp_document& document) {
        write_column(document, "arc", lines, [](const Line& line) { return line.arc; });
        write_column(document, "value", lines, [](const Line& line) { return line.value; });
        write_column(document, "length", lines, [](const Line& line) { return line.length; });
        write_column(document, "closed", lines, [](const Line& line) { return std::int64_t{line.is_closed}; });
      });
    }
    else if(ending == ".obj")
      write_obj(stream, lines, [&](std::size_t i) {
        stream << "# arc " << lines[i].arc << " value " << lines[i].value << " length " << lines[i].length << " closed "
               << lines[i].is_closed << "\ng arc_" << lines[i].arc;
      });
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

void write_vtp_of_loops(std::ostream& out, const std::vector<Contour_line>& lines, const std::vector<Loop_row>& rows)
{
  write_vtp(out, lines, "kind", [&](Vtp_document& document) {
    typedef Loop_row Row;
    const auto write = [&](const std::string& name, const auto& number_of) {
      write_column(document, name, rows, number_of);
    };
    const auto write_points = [&](const std::string& name, const auto& point_of) {
      std::vector<double> coordinates;
      for(const Row& row : rows)
        coordinates.insert(coordinates.end(), point_of(row).begin(), point_of(row).end());
      document.write_array(name, coordinates, 3);
    };
    const double none = std::numeric_limits<double>::quiet_NaN();
    write("loop", [&, i = rows.data()](const Row& row) { return static_cast<std::int64_t>(&row - i); });
    write("kind", [](const Row& row) {
      return std::int64_t{row.kind == "handle" ? 0 : row.kind == "tunnel" ? 1 : row.kind == "hole" ? 2 : 3};
    });
    write("partner", [](const Row& row) { return row.partner ? static_cast<std::int64_t>(*row.partner) : -1; });
    write("component", [](const Row& row) { return static_cast<std::int64_t>(row.component); });
    write("length", [](const Row& row) { return row.length; });
    write("persistence", [&](const Row& row) { return row.persistence.value_or(none); });
    write("area", [&](const Row& row) { return row.area.value_or(none); });
    write_points(
      "center", [](const Row& row) -> const auto& { return row.place.center; });
    write_points(
      "box_min", [](const Row& row) -> const auto& { return row.place.box[0]; });
    write_points(
      "box_max", [](const Row& row) -> const auto& { return row.place.box[1]; });
  });
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
      std::vector<Contour_line> lines;
      for(const Polyline& polyline : loops.polylines)
        lines.push_back({polyline, 0, 0, 0, true});
      if(format == ".vtp")
        write_vtp_of_loops(stream, lines, loops.rows);
      else // each in a group of its own, whose name has its kind
        write_obj(stream, lines, [&](std::size_t i) { stream << "g " << loops.rows[i].kind << '_' << i; });
    });
}

} // namespace reeb_graph_program
