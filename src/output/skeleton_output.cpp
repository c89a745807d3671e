// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#include "output/skeleton_output.h"

#include "output/mesh_output.h"
#include "output/output_file.h"
#include "output/report_output.h"

#include <CGAL/Reeb_graph/IO/polylines.h>
#include <CGAL/Reeb_graph/IO/vtp.h>
#include <CGAL/Reeb_graph/internal/io/text.h>
#include <CGAL/boost/graph/iterator.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <iomanip>
#include <limits>
#include <numeric>
#include <optional>
#include <ostream>
#include <string>
#include <utility>
#include <vector>

namespace reeb_graph_program {
namespace {
std::string format_of_skeleton(const std::filesystem::path& path)
{
  return ending_of(path, "a skeleton", {".swc", ".vtp", ".polylines.txt", ".graphml", ".csv"});
}

// Radii that readers of SWC take, which refuse 0. Where one is 0, as at a tip, it is that of the point with one that is the fewest steps
// away. Inscribed ones fall back to those of contours where a tree has none, and these, as between two sheets on each other, to
// half of the mean step. A component that is one point has the least radius of all.
std::vector<double> radii_for_swc(const Skeleton& skeleton, bool are_inscribed)
{
  const auto& graph = skeleton.graph;
  std::vector<double> radii(num_vertices(graph), 0);
  const auto set = [&](const auto& radius_of) {
    std::vector<std::size_t> queue;
    for(std::size_t v = 0; v != radii.size(); ++v)
    {
      if(!(radii[v] > 0))
        radii[v] = radius_of(v);
      if(radii[v] > 0)
        queue.push_back(v);
    }
    for(std::size_t i = 0; i != queue.size(); ++i)
      for(const auto neighbor : CGAL::make_range(boost::adjacent_vertices(queue[i], graph)))
        if(!(radii[neighbor] > 0))
        {
          radii[neighbor] = radii[queue[i]];
          queue.push_back(neighbor);
        }
  };
  if(are_inscribed)
    set([&](std::size_t v) { return graph[v].inscribed_radius; });
  set([&](std::size_t v) { return graph[v].radius; });
  set([&](std::size_t v) {
    double half = 0;
    for(const auto neighbor : CGAL::make_range(boost::adjacent_vertices(v, graph)))
      half += CGAL::Reeb_graph::internal::distance_between(graph[v].point, graph[neighbor].point) / 2
            / static_cast<double>(out_degree(v, graph));
    return half;
  });
  double least = std::numeric_limits<double>::infinity();
  for(const double radius : radii)
    least = radius > 0 ? (std::min)(least, radius) : least;
  std::replace_if(
    radii.begin(), radii.end(), [](double radius) { return !(radius > 0); },
    std::isfinite(least) ? least : double(std::numeric_limits<float>::min()));
  return radii;
}

// The numbers of points in SWC, from 1: 0 of ends without length, as of a component that is one point.
std::vector<std::size_t> numbers_for_swc(const Skeleton& skeleton)
{
  const auto& trees = skeleton.trees;
  std::vector<std::size_t> numbers(trees.size(), 1);
  const auto point = [&](std::size_t i) { return skeleton.graph[trees[i].vertex].point; };
  for(std::size_t i = 0; i != trees.size(); ++i)
    if(trees[i].parent != Skeleton::none)
      numbers[i] = point(i) != point(trees[i].parent) ? 1 : 0;
  for(std::size_t i = trees.size(); i-- != 0;) // Points come behind their parents.
    if(numbers[i] != 0 && trees[i].parent != Skeleton::none)
      numbers[trees[i].parent] = 1;
  std::size_t number = 0;
  for(std::size_t& n : numbers)
    n = n == 0 ? 0 : ++number;
  return numbers;
}

// The type is 1, that of a soma, where the thickest point is the root.
void write_swc(std::ostream& out, const Skeleton& skeleton, const Swc_options& options)
{
  const CGAL::Reeb_graph::internal::Classic_locale classic_locale(out);
  out.precision(std::numeric_limits<double>::max_digits10);
  out << "# id type x y z radius parent\n";
  const auto& trees = skeleton.trees;
  const std::vector<std::size_t> numbers = numbers_for_swc(skeleton);
  for(std::size_t i = 0; i != trees.size(); ++i)
    if(trees[i].original != Skeleton::none && numbers[i] != 0)
      out << "# CYCLE_BREAK reconnect " << numbers[i] << ' ' << numbers[trees[i].original] << '\n';
  const std::vector<double> radii = radii_for_swc(skeleton, options.are_radii_inscribed);
  for(std::size_t i = 0; i != trees.size(); ++i)
  {
    if(numbers[i] == 0)
      continue;
    const Point& p = skeleton.graph[trees[i].vertex].point;
    out << numbers[i] << ' ' << (i == skeleton.soma ? 1 : options.type) << ' ' << p.x() << ' ' << p.y() << ' ' << p.z()
        << ' ' << radii[trees[i].vertex] << ' ';
    if(trees[i].parent == Skeleton::none)
      out << "-1\n";
    else
      out << numbers[trees[i].parent] << '\n';
  }
}

typedef std::vector<std::pair<std::string, std::vector<std::int64_t>>> Line_numbers;

void write_lines(std::ostream& out,
                 const CGAL::Reeb_graph::internal::Vtp_document::Cells& lines,
                 const std::vector<double>& coordinates,
                 const std::vector<double>& radii,
                 const std::vector<double>& inscribed_radii,
                 const Line_numbers& numbers)
{
  CGAL::Reeb_graph::internal::Vtp_document document(out, radii.size(), {}, lines, {});
  document.write_section("PointData", "Radius", [&] {
    document.write_array("Radius", radii);
    document.write_array("MaximumInscribedSphereRadius", inscribed_radii);
  });
  document.write_section("CellData", numbers.front().first, [&] {
    for(const auto& [name, of_lines] : numbers)
      document.write_array(name, of_lines);
  });
  document.write_section("Points", "", [&] { document.write_array("Points", coordinates, 3); });
  document.finish();
}

// Lines of a skeleton that lie in junctions, or outside, without loops, with numbers as VMTK has them for centerlines.
struct Grouped_lines
{
  explicit Grouped_lines(const Skeleton& skeleton) : points(num_vertices(skeleton.graph))
  {
    const auto& graph = skeleton.graph;
    std::iota(points.begin(), points.end(), std::size_t(0));
    std::vector<std::size_t> copies(num_edges(graph), Skeleton::none); // at which loops are cut
    for(const auto& record : skeleton.trees)
      if(record.original != Skeleton::none)
      {
        copies[record.edge] = points.size();
        points.push_back(record.vertex);
      }
    std::vector<std::size_t> lines_of_edges;
    auto e = edges(graph).first; // along the arcs, in their order
    for(std::size_t arc = 0; arc != skeleton.arcs.size(); ++arc)
      for(std::size_t i = 1; i != skeleton.arcs[arc].size(); ++i)
      {
        const bool is_in_junction = graph[*e++].is_in_junction;
        std::size_t from = skeleton.arcs[arc][i - 1], to = skeleton.arcs[arc][i];
        if(const std::size_t copy = copies[lines_of_edges.size()]; copy != Skeleton::none)
          (points[copy] == to ? to : from) = copy;
        if(i == 1 || lines.back().back() != from || are_in_junctions.back() != is_in_junction)
        {
          lines.push_back({from});
          arcs.push_back(arc);
          are_in_junctions.push_back(is_in_junction);
        }
        lines.back().push_back(to);
        lines_of_edges.push_back(lines.size() - 1);
      }
    tracts.assign(lines.size(), Skeleton::none);
    for(const auto& record : skeleton.trees)
      if(record.parent != Skeleton::none)
      {
        const std::size_t line = lines_of_edges[record.edge], before = skeleton.trees[record.parent].edge;
        if(tracts[line] == Skeleton::none)
          tracts[line] = before == Skeleton::none ? 0 : tracts[lines_of_edges[before]] + 1;
      }
  }

  std::vector<std::size_t> points; // of the skeleton
  std::vector<std::vector<std::size_t>> lines;
  std::vector<std::size_t> arcs, tracts; // of lines; a tract is the number of lines that lead there from the root
  std::vector<bool> are_in_junctions;
};

// A line for each path, as VMTK has centerlines before it groups them.
void write_paths(std::ostream& out, const Skeleton& skeleton)
{
  CGAL::Reeb_graph::internal::Vtp_document::Cells lines;
  std::vector<double> coordinates, radii, inscribed_radii;
  std::vector<std::int64_t> numbers;
  for(const auto& path : skeleton.paths)
  {
    for(const std::size_t v : path)
    {
      lines.add_point(radii.size());
      CGAL::Reeb_graph::internal::add_coordinates(skeleton.graph[v].point, coordinates);
      radii.push_back(skeleton.graph[v].radius);
      inscribed_radii.push_back(skeleton.graph[v].inscribed_radius);
    }
    lines.end_cell();
    numbers.push_back(static_cast<std::int64_t>(numbers.size()));
  }
  write_lines(out, lines, coordinates, radii, inscribed_radii, {{"CenterlineIds", numbers}});
}

// With the arrays that VMTK has for centerlines.
void write_vtp(std::ostream& out, const Skeleton& skeleton)
{
  const Grouped_lines grouped(skeleton);
  CGAL::Reeb_graph::internal::Vtp_document::Cells lines;
  std::vector<double> coordinates, radii, inscribed_radii;
  for(const std::size_t v : grouped.points)
  {
    CGAL::Reeb_graph::internal::add_coordinates(skeleton.graph[v].point, coordinates);
    radii.push_back(skeleton.graph[v].radius);
    inscribed_radii.push_back(skeleton.graph[v].inscribed_radius);
  }
  typedef std::vector<std::int64_t> Numbers;
  Numbers groups, components;
  for(std::size_t i = 0; i != grouped.lines.size(); ++i)
  {
    for(const std::size_t point : grouped.lines[i])
      lines.add_point(point);
    lines.end_cell();
    groups.push_back(static_cast<std::int64_t>(i));
    components.push_back(static_cast<std::int64_t>(skeleton.branches[grouped.arcs[i]].component));
  }
  write_lines(out, lines, coordinates, radii, inscribed_radii,
              {{"GroupIds", groups},
               {"CenterlineIds", components},
               {"TractIds", Numbers(grouped.tracts.begin(), grouped.tracts.end())},
               {"Blanking", Numbers(grouped.are_in_junctions.begin(), grouped.are_in_junctions.end())},
               {"BranchIds", Numbers(grouped.arcs.begin(), grouped.arcs.end())}});
}

// A node for each point, an edge for each segment.
void write_graphml(std::ostream& out, const Skeleton& skeleton)
{
  const CGAL::Reeb_graph::internal::Classic_locale classic_locale(out);
  out.precision(std::numeric_limits<double>::max_digits10);
  out << "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<graphml xmlns=\"http://graphml.graphdrawing.org/xmlns\">\n";
  for(const char* name : {"x", "y", "z", "radius", "inscribed_radius"})
    out << "<key id=\"" << name << "\" for=\"node\" attr.name=\"" << name << "\" attr.type=\"double\"/>\n";
  out << "<key id=\"arc\" for=\"edge\" attr.name=\"arc\" attr.type=\"long\"/>\n"
         "<key id=\"junction\" for=\"all\" attr.name=\"junction\" attr.type=\"boolean\"/>\n"
         "<graph edgedefault=\"undirected\">\n";
  const auto is_in_junction = [](const auto& part) {
    return std::string("<data key=\"junction\">") + (part.is_in_junction ? "true" : "false") + "</data>";
  };
  for(const auto v : CGAL::make_range(vertices(skeleton.graph)))
  {
    const auto& point = skeleton.graph[v];
    const Point& p = point.point;
    out << "<node id=\"" << v << "\"><data key=\"x\">" << p.x() << "</data><data key=\"y\">" << p.y()
        << "</data><data key=\"z\">" << p.z() << "</data><data key=\"radius\">" << point.radius
        << "</data><data key=\"inscribed_radius\">" << point.inscribed_radius << "</data>" << is_in_junction(point)
        << "</node>\n";
  }
  for(const auto e : CGAL::make_range(edges(skeleton.graph)))
    out << "<edge source=\"" << source(e, skeleton.graph) << "\" target=\"" << target(e, skeleton.graph)
        << "\"><data key=\"arc\">" << skeleton.graph[e].arc << "</data>" << is_in_junction(skeleton.graph[e])
        << "</edge>\n";
  out << "</graph>\n</graphml>\n";
}

// None of what is nothing, or beyond double.
std::optional<double> share(double part, double whole)
{
  return whole > 0 && std::isfinite(whole) ? std::make_optional(part / whole) : std::nullopt;
}

// A line for each branch. What there is not is empty.
void write_csv(std::ostream& out, const Skeleton& skeleton)
{
  CGAL::Reeb_graph::internal::Text_output text(out);
  text << "branch,component,parent,from,to,length,tortuosity,strahler,radius,least_radius,greatest_radius,"
          "inscribed_radius,volume,area,junction_volume,junction_area\n";
  for(std::size_t i = 0; i != skeleton.branches.size(); ++i)
  {
    const auto& branch = skeleton.branches[i];
    text << i << ',' << branch.component << ',';
    if(branch.parent != Skeleton::none)
      text << branch.parent;
    text << ',' << branch.first << ',' << branch.last << ',' << branch.length << ',';
    if(!std::isnan(branch.tortuosity))
      text << branch.tortuosity;
    text << ',' << branch.order;
    for(const double x : {branch.radius, branch.least_radius, branch.greatest_radius, branch.inscribed_radius,
                          branch.volume, branch.area, branch.junction_volume, branch.junction_area})
      text << ',' << x;
    text << '\n';
  }
  text.flush();
}

} // namespace

void write_skeleton_mesh(const std::filesystem::path& path, const Surface& surface, const Skeleton& skeleton)
{
  std::vector<int> branches(skeleton.face_arcs.begin(), skeleton.face_arcs.end()), arcs = branches;
  const std::vector<int> junctions(skeleton.are_faces_in_junctions.begin(), skeleton.are_faces_in_junctions.end());
  for(std::size_t i = 0; i != arcs.size(); ++i)
    if(junctions[i] != 0)
      arcs[i] = -1;
  write_surface_with_numbers(path, surface, {{"branch", branches}, {"arc", arcs}, {"junction", junctions}});
}

void check_path_format(const std::filesystem::path& path) { ending_of(path, "paths", {".vtp", ".polylines.txt"}); }

void check_skeleton_format(const std::filesystem::path& path) { format_of_skeleton(path); }

void note_lost_parts(const std::filesystem::path& path, const Skeleton& skeleton, std::vector<std::string>& notes)
{
  const std::string format = format_of_skeleton(path);
  const std::size_t loops = skeleton.certificate.number_of_loops;
  if(format == ".swc" && loops > 0)
    notes.push_back(path.string() + ": each loop is cut once, as SWC has trees only: " + std::to_string(loops));
  if(format == ".polylines.txt")
    notes.push_back(path.string() + ": radii are left out, for which .swc, .vtp and .graphml have room");
}

void note_branches_without_face(const Skeleton& skeleton, std::vector<std::string>& notes)
{
  std::vector<char> has_face(skeleton.arcs.size(), 0);
  for(const std::size_t arc : skeleton.face_arcs)
    has_face[arc] = 1;
  std::string names;
  for(std::size_t arc = 0; arc != has_face.size(); ++arc)
    if(has_face[arc] == 0)
      names += (names.empty() ? "" : ", ") + std::to_string(arc);
  if(!names.empty())
    notes.push_back("branches without a face, and so without a piece: " + names);
}

void note_inside_out(const Skeleton& skeleton, std::vector<std::string>& notes)
{
  if(skeleton.number_inside_out > 0)
    notes.push_back("the faces look inwards, volumes are those of the solid all the same: "
                    + count(skeleton.number_inside_out, "component"));
}

void note_lost_numbers(const Skeleton& skeleton, std::vector<std::string>& notes)
{
  typedef CGAL::Reeb_graph::Skeleton_branch Branch;
  if(std::isinf(numbers_of(skeleton).cable_length))
    notes.push_back("the length of the cable is beyond double, null in JSON");
  for(const auto& [name, number] :
      {std::make_pair("lengths", &Branch::length), {"areas", &Branch::area}, {"volumes", &Branch::volume}})
  {
    std::size_t large = 0, small = 0;
    for(const Branch& branch : skeleton.branches)
    {
      const bool is_small = branch.radius > 0 && branch.length > 0 && branch.radius * branch.length < 1e-150;
      large += std::isinf(branch.*number) ? 1 : 0;
      small += is_small && branch.*number < (std::numeric_limits<double>::min)() ? 1 : 0;
    }
    if(large > 0)
      notes.push_back(std::string(name) + " beyond double, null in JSON, inf in .csv: " + std::to_string(large));
    if(small > 0)
      notes.push_back(std::string(name) + " too small for double, about 0: " + std::to_string(small));
  }
}

void write_skeleton(const std::filesystem::path& path, const Skeleton& skeleton, const Swc_options& options)
{
  const std::string format = format_of_skeleton(path);
  write_file(path, [&](std::ostream& out) {
    if(format == ".swc")
      write_swc(out, skeleton, options);
    else if(format == ".vtp" && !skeleton.paths.empty())
      write_paths(out, skeleton);
    else if(format == ".vtp")
      write_vtp(out, skeleton);
    else if(format == ".graphml")
      write_graphml(out, skeleton);
    else if(format == ".csv")
      write_csv(out, skeleton);
    else
      CGAL::Reeb_graph::write_polylines(out, polylines_of(skeleton));
  });
}

void write_text(std::ostream& out, const Skeleton_report& report)
{
  const auto& known = report.skeleton.certificate;
  out << "surface   " << count(known.number_of_components, "component") << ", " << count(known.genus, "handle")
      << " with borders filled\n";
  write_input_text(out, report);
  out << "field     " << report.field << '\n';
  out << "skeleton  " << count(num_vertices(report.skeleton.graph), "point") << ", "
      << count(known.number_of_arcs, "arc") << ", " << count(known.number_of_ends, "end") << " ("
      << known.number_of_border_ends << " at borders), " << count(known.number_of_junctions, "junction") << ", "
      << count(known.number_of_loops, "loop") << ", " << count(known.number_of_hidden_handles, "hidden handle") << '\n';
  out << "inside    " << count(known.number_of_vertices_outside, "vertex", "vertices") << " outside, "
      << count(known.number_of_crossing_edges, "crossing edge") << ", "
      << count(known.number_of_contractible_loops, "contractible loop") << ", "
      << count(known.number_of_crossing_components, "self-intersecting component") << '\n';
  if(known.loop_index != 1)
    out << "loops     no basis: they generate a part of index " << known.loop_index << '\n';
  const Skeleton_numbers numbers = numbers_of(report.skeleton);
  out << "cable     length " << numbers.cable_length << ", " << count(known.number_of_arcs, "branch", "branches");
  if(numbers.mean_tortuosity)
    out << ", mean tortuosity " << *numbers.mean_tortuosity;
  out << ", Strahler order " << numbers.order << '\n';
  for(const Place_of_point& place : report.skeleton.places)
    out << "place     " << place.given.x() << ' ' << place.given.y() << ' ' << place.given.z() << " is "
        << place.distance << " from the line; nearest to it is point " << place.point << '\n';
  out << "solid     volume " << numbers.volume << ", area " << numbers.area;
  if(const auto of_volume = share(numbers.junction_volume, numbers.volume))
    out << ", " << 100 * *of_volume << " % of the volume in junctions";
  out << '\n';
  if(!report.skeleton.paths.empty())
    out << "paths     " << report.skeleton.paths.size() << '\n';
  for(const auto& [step, seconds] : report.seconds)
    out << std::left << std::setw(10) << step << std::right << std::fixed << std::setprecision(3) << seconds << " s\n";
  out << std::defaultfloat << std::setprecision(6)
      << "\n  arc   from     to          length     mean radius    least radius greatest radius  mean inscribed  "
         "component\n";
  std::size_t number = 0;
  for(const auto& row : report.skeleton.branches)
  {
    out << std::setw(5) << number++ << std::setw(7) << row.first << std::setw(7) << row.last;
    for(const double x : {row.length, row.radius, row.least_radius, row.greatest_radius, row.inscribed_radius})
      out << std::setw(16) << x;
    out << std::setw(11) << row.component << '\n';
  }
  if(!report.skeleton.paths.empty())
    out << "\n path   from     to          length\n";
  number = 0;
  for(const std::vector<std::size_t>& path : report.skeleton.paths)
    out << std::setw(5) << number++ << std::setw(7) << path.front() << std::setw(7) << path.back() << std::setw(16)
        << length_of_path(report.skeleton, path) << '\n';
}

void write_json(std::ostream& out, const Skeleton_report& report)
{
  const auto& known = report.skeleton.certificate;
  nlohmann::ordered_json json;
  json["components"] = known.number_of_components;
  json["genus"] = known.genus;
  json["field"] = report.field;
  json["points"] = num_vertices(report.skeleton.graph);
  json["ends"] = known.number_of_ends;
  json["border_ends"] = known.number_of_border_ends;
  json["junctions"] = known.number_of_junctions;
  json["loops"] = known.number_of_loops;
  json["hidden_handles"] = known.number_of_hidden_handles;
  json["contractible_loops"] = known.number_of_contractible_loops;
  json["loop_index"] = known.loop_index;
  json["vertices_outside"] = known.number_of_vertices_outside;
  json["crossing_edges"] = known.number_of_crossing_edges;
  json["self_intersecting"] = known.number_of_crossing_components != 0;
  json["self_intersecting_components"] = known.number_of_crossing_components;
  const Skeleton_numbers numbers = numbers_of(report.skeleton);
  json["cable_length"] = numbers.cable_length;
  json["volume"] = numbers.volume;
  json["area"] = numbers.area;
  json["junction_share_of_volume"] = share(numbers.junction_volume, numbers.volume);
  json["junction_share_of_area"] = share(numbers.junction_area, numbers.area);
  json["inside_out_components"] = report.skeleton.number_inside_out;
  json["branches"] = known.number_of_arcs;
  json["mean_tortuosity"] = numbers.mean_tortuosity;
  json["strahler_order"] = numbers.order;
  json["arcs"] = nlohmann::ordered_json::array();
  for(const auto& row : report.skeleton.branches)
    json["arcs"].push_back({{"from", row.first},
                            {"to", row.last},
                            {"component", row.component},
                            {"parent", row.parent == Skeleton::none ? std::nullopt : std::make_optional(row.parent)},
                            {"strahler", row.order},
                            {"tortuosity", row.tortuosity},
                            {"volume", row.volume},
                            {"area", row.area},
                            {"junction_volume", row.junction_volume},
                            {"junction_area", row.junction_area},
                            {"length", row.length},
                            {"radius", row.radius},
                            {"least_radius", row.least_radius},
                            {"greatest_radius", row.greatest_radius},
                            {"inscribed_radius", row.inscribed_radius}});
  for(const auto& path : report.skeleton.paths)
    json["paths"].push_back(
      {{"from", path.front()}, {"to", path.back()}, {"length", length_of_path(report.skeleton, path)}});
  for(const Place_of_point& place : report.skeleton.places)
    json["places"].push_back(
      {{"given", nlohmann::ordered_json::array({place.given.x(), place.given.y(), place.given.z()})},
       {"point", place.point},
       {"distance", place.distance}});
  write_with_costs(out, std::move(json), report);
}

} // namespace reeb_graph_program
