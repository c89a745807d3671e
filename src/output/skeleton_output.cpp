// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#include "output/skeleton_output.h"

#include "output/output_file.h"

#include <CGAL/Reeb_graph/IO/polylines.h>
#include <CGAL/Reeb_graph/IO/vtp.h>
#include <CGAL/Reeb_graph/internal/io/text.h>

#include <cstddef>
#include <cstdint>
#include <limits>
#include <ostream>
#include <utility>
#include <vector>

namespace reeb_graph_program {
namespace {
std::string format_of_skeleton(const std::filesystem::path& path)
{
  return ending_of(path, "a skeleton", {".swc", ".vtp", ".polylines.txt", ".graphml"});
}

// The records of an SWC file: trees, whose parents come first. An edge that would close a loop ends at a copy of the
// point that it leads to.
class Swc_trees
{
public:
  struct Record
  {
    std::size_t point;
    std::size_t parent; // as the number of its record, from 1; 0 for none
  };

  explicit Swc_trees(const Skeleton& skeleton)
    : edges_of_points_(skeleton.points.size()),
      numbers_(skeleton.points.size(), 0)
  {
    for(const auto& arc : skeleton.arcs)
      for(std::size_t i = 1; i != arc.size(); ++i)
      {
        for(const std::size_t v : {arc[i - 1], arc[i]})
          edges_of_points_[v].push_back(ends_.size());
        ends_.emplace_back(arc[i - 1], arc[i]);
      }
    is_passed_.assign(ends_.size(), false);
    for(const auto& arc : skeleton.arcs)
      if(numbers_[arc.front()] == 0)
        add_tree(arc.front());
  }

  const std::vector<Record>& records() const { return records_; }
  // Copies, and what they are copies of, by the numbers of their records.
  const std::vector<std::pair<std::size_t, std::size_t>>& breaks() const { return breaks_; }

private:
  void add(std::size_t point, std::size_t parent)
  {
    records_.push_back({point, parent});
    if(numbers_[point] == 0)
      numbers_[point] = records_.size();
    else
      breaks_.emplace_back(records_.size(), numbers_[point]);
  }

  // Depth first, so that the points of an arc follow each other.
  void add_tree(std::size_t root)
  {
    add(root, 0);
    std::vector<std::size_t> path = {root};
    while(!path.empty())
    {
      const std::size_t v = path.back();
      std::vector<std::size_t>& edges = edges_of_points_[v];
      while(!edges.empty() && is_passed_[edges.back()])
        edges.pop_back();
      if(edges.empty())
      {
        path.pop_back();
        continue;
      }
      const auto [a, b] = ends_[edges.back()];
      is_passed_[edges.back()] = true;
      const std::size_t next = a == v ? b : a;
      const bool is_new = numbers_[next] == 0;
      add(next, numbers_[v]);
      if(is_new)
        path.push_back(next);
    }
  }

  std::vector<std::pair<std::size_t, std::size_t>> ends_; // of edges
  std::vector<std::vector<std::size_t>> edges_of_points_;
  std::vector<bool> is_passed_;
  std::vector<std::size_t> numbers_;
  std::vector<Record> records_;
  std::vector<std::pair<std::size_t, std::size_t>> breaks_;
};

void write_swc(std::ostream& out, const Skeleton& skeleton)
{
  const CGAL::Reeb_graph::internal::Classic_locale classic_locale(out);
  out.precision(std::numeric_limits<double>::max_digits10);
  const Swc_trees trees(skeleton);
  out << "# id type x y z radius parent\n";
  for(const auto& [duplicate, original] : trees.breaks())
    out << "# CYCLE_BREAK reconnect " << duplicate << ' ' << original << '\n';
  for(std::size_t i = 0; i != trees.records().size(); ++i)
  {
    const auto& [v, parent] = trees.records()[i];
    const Point& p = skeleton.points[v];
    out << i + 1 << " 0 " << p.x() << ' ' << p.y() << ' ' << p.z() << ' ' << skeleton.radii[v] << ' ';
    if(parent == 0)
      out << "-1\n";
    else
      out << parent << '\n';
  }
}

// A line for each arc, with the arrays that VMTK has for centerlines.
void write_vtp(std::ostream& out, const Skeleton& skeleton)
{
  CGAL::Reeb_graph::internal::Vtp_document::Cells lines;
  std::vector<double> coordinates;
  for(const Point& p : skeleton.points)
    CGAL::Reeb_graph::internal::add_coordinates(p, coordinates);
  const std::vector<Arc_place> places = places_of_arcs(skeleton);
  std::vector<std::int64_t> arcs, components, depths, zeros;
  for(std::size_t arc = 0; arc != skeleton.arcs.size(); ++arc)
  {
    for(const std::size_t v : skeleton.arcs[arc])
      lines.add_point(v);
    lines.end_cell();
    arcs.push_back(static_cast<std::int64_t>(arc));
    components.push_back(static_cast<std::int64_t>(places[arc].component));
    depths.push_back(static_cast<std::int64_t>(places[arc].depth));
    zeros.push_back(0);
  }
  CGAL::Reeb_graph::internal::Vtp_document document(out, skeleton.points.size(), {}, lines, {});
  document.write_section("PointData", "Radius", [&] {
    document.write_array("Radius", skeleton.radii);
    document.write_array("MaximumInscribedSphereRadius", skeleton.inscribed_radii);
  });
  document.write_section("CellData", "GroupIds", [&] {
    document.write_array("GroupIds", arcs);
    document.write_array("CenterlineIds", components);
    document.write_array("TractIds", depths);
    document.write_array("Blanking", zeros);
  });
  document.write_section("Points", "", [&] { document.write_array("Points", coordinates, 3); });
  document.finish();
}

// A node for each point, an edge for each segment.
void write_graphml(std::ostream& out, const Skeleton& skeleton)
{
  const CGAL::Reeb_graph::internal::Classic_locale classic_locale(out);
  out.precision(std::numeric_limits<double>::max_digits10);
  out << "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<graphml xmlns=\"http://graphml.graphdrawing.org/xmlns\">\n";
  for(const char* name : {"x", "y", "z", "radius", "inscribed_radius"})
    out << "<key id=\"" << name << "\" for=\"node\" attr.name=\"" << name << "\" attr.type=\"double\"/>\n";
  out << "<key id=\"arc\" for=\"edge\" attr.name=\"arc\" attr.type=\"long\"/>\n<graph edgedefault=\"undirected\">\n";
  for(std::size_t v = 0; v != skeleton.points.size(); ++v)
  {
    const Point& p = skeleton.points[v];
    out << "<node id=\"" << v << "\"><data key=\"x\">" << p.x() << "</data><data key=\"y\">" << p.y()
        << "</data><data key=\"z\">" << p.z() << "</data><data key=\"radius\">" << skeleton.radii[v]
        << "</data><data key=\"inscribed_radius\">" << skeleton.inscribed_radii[v] << "</data></node>\n";
  }
  for(std::size_t arc = 0; arc != skeleton.arcs.size(); ++arc)
    for(std::size_t i = 1; i != skeleton.arcs[arc].size(); ++i)
      out << "<edge source=\"" << skeleton.arcs[arc][i - 1] << "\" target=\"" << skeleton.arcs[arc][i]
          << "\"><data key=\"arc\">" << arc << "</data></edge>\n";
  out << "</graph>\n</graphml>\n";
}

} // namespace

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

void write_skeleton(const std::filesystem::path& path, const Skeleton& skeleton)
{
  const std::string format = format_of_skeleton(path);
  write_file(path, [&](std::ostream& out) {
    if(format == ".swc")
      write_swc(out, skeleton);
    else if(format == ".vtp")
      write_vtp(out, skeleton);
    else if(format == ".graphml")
      write_graphml(out, skeleton);
    else
      CGAL::Reeb_graph::write_polylines(out, polylines_of(skeleton));
  });
}

} // namespace reeb_graph_program
