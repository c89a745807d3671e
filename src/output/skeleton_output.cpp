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
#include <CGAL/boost/graph/iterator.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <ostream>
#include <vector>

namespace reeb_graph_program {
namespace {
std::string format_of_skeleton(const std::filesystem::path& path)
{
  return ending_of(path, "a skeleton", {".swc", ".vtp", ".polylines.txt", ".graphml", ".csv"});
}

void write_swc(std::ostream& out, const Skeleton& skeleton)
{
  const CGAL::Reeb_graph::internal::Classic_locale classic_locale(out);
  out.precision(std::numeric_limits<double>::max_digits10);
  out << "# id type x y z radius parent\n";
  const auto& trees = skeleton.trees;
  for(std::size_t i = 0; i != trees.size(); ++i)
    if(trees[i].original != Skeleton::none)
      out << "# CYCLE_BREAK reconnect " << i + 1 << ' ' << trees[i].original + 1 << '\n';
  for(std::size_t i = 0; i != trees.size(); ++i)
  {
    const auto& point = skeleton.graph[trees[i].vertex];
    const Point& p = point.point;
    out << i + 1 << " 0 " << p.x() << ' ' << p.y() << ' ' << p.z() << ' ' << point.radius << ' ';
    if(trees[i].parent == Skeleton::none)
      out << "-1\n";
    else
      out << trees[i].parent + 1 << '\n';
  }
}

// A line for each arc, with the arrays that VMTK has for centerlines.
void write_vtp(std::ostream& out, const Skeleton& skeleton)
{
  CGAL::Reeb_graph::internal::Vtp_document::Cells lines;
  std::vector<double> coordinates, radii, inscribed_radii;
  for(const auto v : CGAL::make_range(vertices(skeleton.graph)))
  {
    CGAL::Reeb_graph::internal::add_coordinates(skeleton.graph[v].point, coordinates);
    radii.push_back(skeleton.graph[v].radius);
    inscribed_radii.push_back(skeleton.graph[v].inscribed_radius);
  }
  std::vector<std::int64_t> arcs, components, depths, zeros;
  for(std::size_t arc = 0; arc != skeleton.arcs.size(); ++arc)
  {
    for(const std::size_t v : skeleton.arcs[arc])
      lines.add_point(v);
    lines.end_cell();
    arcs.push_back(static_cast<std::int64_t>(arc));
    components.push_back(static_cast<std::int64_t>(skeleton.branches[arc].component));
    depths.push_back(static_cast<std::int64_t>(skeleton.branches[arc].depth));
    zeros.push_back(0);
  }
  CGAL::Reeb_graph::internal::Vtp_document document(out, radii.size(), {}, lines, {});
  document.write_section("PointData", "Radius", [&] {
    document.write_array("Radius", radii);
    document.write_array("MaximumInscribedSphereRadius", inscribed_radii);
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
  for(const auto v : CGAL::make_range(vertices(skeleton.graph)))
  {
    const auto& point = skeleton.graph[v];
    const Point& p = point.point;
    out << "<node id=\"" << v << "\"><data key=\"x\">" << p.x() << "</data><data key=\"y\">" << p.y()
        << "</data><data key=\"z\">" << p.z() << "</data><data key=\"radius\">" << point.radius
        << "</data><data key=\"inscribed_radius\">" << point.inscribed_radius << "</data></node>\n";
  }
  for(const auto e : CGAL::make_range(edges(skeleton.graph)))
    out << "<edge source=\"" << source(e, skeleton.graph) << "\" target=\"" << target(e, skeleton.graph)
        << "\"><data key=\"arc\">" << skeleton.graph[e].arc << "</data></edge>\n";
  out << "</graph>\n</graphml>\n";
}

// A line for each branch. What there is not is empty.
void write_csv(std::ostream& out, const Skeleton& skeleton)
{
  CGAL::Reeb_graph::internal::Text_output text(out);
  text << "branch,component,parent,from,to,length,tortuosity,strahler,radius,least_radius,greatest_radius,"
          "inscribed_radius,volume,area\n";
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
                          branch.volume, branch.area})
      text << ',' << x;
    text << '\n';
  }
  text.flush();
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
    else if(format == ".csv")
      write_csv(out, skeleton);
    else
      CGAL::Reeb_graph::write_polylines(out, polylines_of(skeleton));
  });
}

} // namespace reeb_graph_program
