// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_SKELETON_INTERNAL_MAKE_COMPONENT_SKELETON_H
#define CGAL_REEB_GRAPH_SKELETON_INTERNAL_MAKE_COMPONENT_SKELETON_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/exceptions.h>
#include <CGAL/Reeb_graph/internal/base/Index.h>
#include <CGAL/Reeb_graph/internal/base/Progress.h>
#include <CGAL/Reeb_graph/internal/base/compiled.h>
#include <CGAL/Reeb_graph/internal/space/Self_intersections.h>
#include <CGAL/Reeb_graph/skeleton/internal/Branch_pruning.h>
#include <CGAL/Reeb_graph/skeleton/internal/Component_filling.h>
#include <CGAL/Reeb_graph/skeleton/internal/Component_skeleton.h>
#include <CGAL/Reeb_graph/skeleton/internal/Edge_splitting.h>
#include <CGAL/Reeb_graph/skeleton/internal/Graph_chains.h>
#include <CGAL/Reeb_graph/skeleton/internal/Inside_lines.h>
#include <CGAL/Reeb_graph/skeleton/internal/Line_centering.h>
#include <CGAL/Reeb_graph/skeleton/internal/Line_sampling.h>
#include <CGAL/Reeb_graph/skeleton/internal/Sampled_graph.h>
#include <CGAL/Reeb_graph/skeleton/internal/Skeleton_lines.h>
#include <CGAL/Reeb_graph/skeleton/internal/Surface_tree.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <vector>

namespace CGAL::Reeb_graph::internal::skeleton {

// Puts the lines, and the vertices that their points stand for, into the result.
class Skeleton_writing
{
public:
  Skeleton_writing(const Filled_component& component,
                   Graph_chains& chains,
                   Skeleton_lines& lines,
                   Component_skeleton& result)
    : component_(component),
      chains_(chains),
      lines_(lines),
      result_(result)
  {
    // Each vertex has an arc: the first line stays where all have become points, as where all is flat.
    bool is_any_left = false;
    for(Index chain = 0; chain != lines.lines().size(); ++chain)
      is_any_left = is_any_left || !lines.has_gone(chain);
    if(!is_any_left)
      lines.lines().front().assign(2, lines.nodes().at(lines.ends().front()[0]).point);
    for(Index chain = 0; chain != lines.lines().size(); ++chain)
      for(const Index end : lines.ends()[chain])
        degrees_[end] += lines.has_gone(chain) ? 0 : 1;
    for(const auto& [index, node] : lines.nodes())
      if(degrees_.count(index) != 0)
        add_node(index, node);
    for(Index chain = 0; chain != lines.lines().size(); ++chain)
      add_arc(chain);
    map_vertices();
    const auto unscaled = [&](double x) { return std::scalbn(x, -component.exponent); };
    for(auto& [point, radius, inscribed_radius, arc, place] : result.vertices)
    {
      point = Point(unscaled(point.x()), unscaled(point.y()), unscaled(point.z()));
      radius = unscaled(radius);
      inscribed_radius = unscaled(inscribed_radius);
    }
  }

private:
  void add_node(Index index, const Skeleton_lines::Node& node)
  {
    numbers_[index] = static_cast<Index>(result_.vertices.size());
    result_.vertices.push_back({node.point.point, node.point.radius, node.point.inscribed_radius, no_index, 0});
    if(node.kind == Line_end::JUNCTION)
      result_.number_of_junctions += degrees_[index] > 2 ? 1 : 0;
    else
      ++result_.number_of_ends;
    result_.number_of_border_ends += node.kind == Line_end::BORDER ? 1 : 0;
  }

  void add_arc(Index chain)
  {
    std::vector<Index>& arc = arcs_.emplace_back();
    const auto& ends = lines_.ends()[chain];
    arc.push_back(numbers_.at(ends[0]));
    if(lines_.has_gone(chain))
      return;
    for(const Line_point& point : lines_.lines()[chain])
    {
      arc.push_back(static_cast<Index>(result_.vertices.size()));
      result_.vertices.push_back(
        {point.point, point.radius, point.inscribed_radius, static_cast<Index>(result_.arcs.size()), 0});
    }
    arc.push_back(numbers_.at(ends[1]));
    set_places(arc);
    result_.arcs.push_back(arc);
  }

  // Places by lengths, from 0 to 1.
  void set_places(const std::vector<Index>& arc)
  {
    std::vector<double> lengths = {0};
    for(std::size_t i = 1; i != arc.size(); ++i)
      lengths.push_back(lengths.back() + distance(result_.vertices[arc[i - 1]].point, result_.vertices[arc[i]].point));
    for(std::size_t i = 1; i + 1 < arc.size(); ++i)
      result_.vertices[arc[i]].place = lengths.back() > 0 ? lengths[i] / lengths.back() : 0.5;
  }

  // A vertex belongs to the point of its chain that is next in place.
  void map_vertices()
  {
    std::vector<std::vector<double>> places(chains_.chains().size());
    for(Index chain = 0; chain != places.size(); ++chain)
    {
      places[chain].push_back(0);
      for(const Line_point& point : lines_.lines()[chain])
        places[chain].push_back((std::max)(places[chain].back(), point.place));
      places[chain].push_back(chains_.chains()[chain].length);
    }
    result_.vertex_map.resize(component_.given.size());
    for(std::size_t i = 0; i != component_.given.size(); ++i)
    {
      Index node = no_index;
      const auto [chain, place] = chains_.place_of(Mesh::Vertex_index(static_cast<Mesh::size_type>(i)), node);
      if(chain == no_index || lines_.has_gone(chain))
      {
        result_.vertex_map[i] = chain == no_index ? numbers_.at(lines_.node_at(node)) : arcs_[chain].front();
        continue;
      }
      const auto& all = places[chain];
      const auto after =
        static_cast<std::size_t>(std::lower_bound(all.begin() + 1, all.end() - 1, place) - all.begin());
      result_.vertex_map[i] = arcs_[chain][place - all[after - 1] < all[after] - place ? after - 1 : after];
    }
  }

  const Filled_component& component_;
  Graph_chains& chains_;
  Skeleton_lines& lines_;
  Component_skeleton& result_;
  std::map<Index, Index> numbers_; // of the nodes of the graph
  std::map<Index, std::size_t> degrees_;
  std::vector<std::vector<Index>> arcs_; // by chain, with those that have become a node
};

inline bool does_self_intersect(const Mesh& mesh, const Stage_progress& progress)
{
  progress(0);
  const Closed_triangles triangles = closed_triangles(mesh);
  Self_intersections intersections(triangles, std::vector<Index>(mesh.num_vertices(), 0), 1, false);
  return intersections(progress.part(0.2, 1))[0] != 0;
}

// Steps in the unit of a component. Their number is to be one that memory can hold.
inline double spacing_of(const Filled_component& component, const Skeleton_options& options)
{
  const double spacing = std::scalbn(options.spacing, component.exponent);
  if(options.spacing > 0 && !(spacing > 1e-7))
    throw Parameter_error("the spacing is below a ten-millionth of the size of the surface");
  return spacing;
}

template <class Component>
Component_skeleton make_component_skeleton(Component component,
                                           const Skeleton_options& options,
                                           const Stage_progress& progress)
{
  const Mesh& mesh = component.mesh;
  Component_skeleton result;
  result.is_self_intersecting = does_self_intersect(mesh, progress.part(0, 0.05));
  const bool are_distances = component.values.empty();
  if(are_distances)
    const Edge_splitting splitting(component);
  const Field field = component.mesh.template add_property_map<Mesh::Vertex_index, double>("v:value", 0).first;
  if(are_distances)
    write_distances(component, options.are_borders_ends, field, progress.part(0.05, 0.15));
  else
    write_values(component, options.are_borders_ends, field);
  const Sampled_graph graph(mesh, field, progress.part(0.15, 0.2));
  const std::size_t edges_less_vertices = mesh.num_edges() - mesh.num_vertices();
  result.genus = (2 + edges_less_vertices - mesh.num_faces()) / 2;
  result.number_of_loops = std::size_t(graph.number_of_arcs()) + 1 - graph.number_of_nodes();
  progress(0.2);
  const Surface_tree tree(component, options.are_borders_ends);
  result.is_self_intersecting = result.is_self_intersecting || tree.is_flat();
  progress(0.2);
  std::vector<bool> is_border(graph.number_of_nodes(), false);
  for(Index node = 0; node != graph.number_of_nodes(); ++node)
    is_border[node] = options.are_borders_ends && component.is_apex(graph.vertex(node));
  Branch_pruning pruning(graph, tree, component.given_lengths, options.pruning_ratio, are_distances, is_border,
                         progress.part(0.2, 0.4));
  Graph_chains chains(graph, pruning);
  Skeleton_lines lines(graph, chains, component, options, are_distances, progress.part(0.4, 0.45));
  Inside_lines inside(graph, chains, tree, lines, field, progress.part(0.45, 0.6));
  if(options.smooth > 0 && tree.has_area())
    const Line_centering centering(graph, chains, tree, lines, options.smooth, progress.part(0.6, 0.9));
  if(tree.has_area())
    const Line_sampling sampling(chains, tree, lines, spacing_of(component, options), progress.part(0.9, 0.97));
  lines.join_nodes_at_one_point();
  inside.certify(progress.part(0.97, 1));
  result.number_of_contractible_loops = inside.loop_group().number_of_dependent;
  result.loop_index = inside.loop_group().index_or_most();
  result.number_outside = inside.number_outside();
  result.number_of_crossings = inside.number_of_crossings();
  const Skeleton_writing writing(component, chains, lines, result);
  return result;
}

#define CGAL_REEB_GRAPH_MAKE_COMPONENT_SKELETON(PREFIX)                                                                \
  PREFIX template Component_skeleton make_component_skeleton<Filled_component>(                                        \
    Filled_component, const Skeleton_options&, const Stage_progress&);
CGAL_REEB_GRAPH_FOR_SKELETONS(CGAL_REEB_GRAPH_MAKE_COMPONENT_SKELETON)

} // namespace CGAL::Reeb_graph::internal::skeleton

#endif // CGAL_REEB_GRAPH_SKELETON_INTERNAL_MAKE_COMPONENT_SKELETON_H
