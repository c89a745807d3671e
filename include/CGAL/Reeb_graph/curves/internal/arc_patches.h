// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_CURVES_INTERNAL_ARC_PATCHES_H
#define CGAL_REEB_GRAPH_CURVES_INTERNAL_ARC_PATCHES_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/curves/Curve.h>
#include <CGAL/Reeb_graph/curves/internal/Contour_choice.h>
#include <CGAL/Reeb_graph/curves/internal/cut_and_mark.h>
#include <CGAL/Reeb_graph/internal/base/Progress.h>
#include <CGAL/Reeb_graph/internal/base/requirements.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <unordered_map>
#include <vector>

namespace CGAL::Reeb_graph::internal {

// The contours that part the regions of the arcs of a Reeb graph. At each node, these are the contours of all arcs but
// one, to which the node belongs: the one whose contour crosses the most edges.
template <class RankedMesh, class ReebGraph>
struct Arc_borders
{
  typedef typename RankedMesh::halfedge_descriptor halfedge_descriptor;

  std::vector<Contour_to_cut<halfedge_descriptor>> contours;
  std::vector<std::size_t> higher_arcs, lower_arcs; // numbers of the arcs on both sides, by contour
};

template <class RankedMesh, class ReebGraph, class Augmentation>
Arc_borders<RankedMesh, ReebGraph> find_arc_borders(const RankedMesh& ranked,
                                                    const ReebGraph& graph,
                                                    const Augmentation& augmentation,
                                                    const Stage_progress& progress)
{
  typedef typename Augmentation::Contour Contour;
  std::unordered_map<const void*, std::size_t> numbers; // arcs have no order, but each has its own properties
  for(const auto arc : CGAL::make_range(edges(graph)))
    numbers.emplace(&graph[arc], numbers.size());

  Arc_borders<RankedMesh, ReebGraph> result;
  for(const auto node : CGAL::make_range(vertices(graph)))
  {
    progress.report_step(node, num_vertices(graph));
    if(in_degree(node, graph) + out_degree(node, graph) < 2)
      continue;
    const auto critical_set = augmentation.critical_set(node);
    std::vector<const Contour*> contours;
    for(const Contour& contour : critical_set.lower_contours)
      contours.push_back(&contour);
    for(const Contour& contour : critical_set.upper_contours)
      contours.push_back(&contour);
    const auto longest = std::max_element(contours.begin(), contours.end(), [](const Contour* a, const Contour* b) {
      return a->halfedges.size() < b->halfedges.size();
    });
    const std::size_t arc_of_node = numbers.at(&graph[(*longest)->arc]);
    for(std::size_t i = 0; i != contours.size(); ++i)
    {
      if(contours[i] == *longest)
        continue;
      const std::size_t arc = numbers.at(&graph[contours[i]->arc]);
      const bool is_above_node = i >= critical_set.lower_contours.size();
      result.contours.push_back(make_contour_to_cut(ranked, contours[i]->halfedges, contours[i]->is_closed));
      result.higher_arcs.push_back(is_above_node ? arc : arc_of_node);
      result.lower_arcs.push_back(is_above_node ? arc_of_node : arc);
    }
  }
  return result;
}

// Writes the number of its arc for each face of a mesh that has been cut along the borders of arcs. Components without
// an arc get the numbers behind. Returns how many numbers there are.
template <class RankedMesh, class ReebGraph, class PatchMap>
std::size_t mark_arc_patches(const RankedMesh& ranked,
                             const ReebGraph& graph,
                             const Arc_borders<RankedMesh, ReebGraph>& borders,
                             const std::vector<Curve<typename RankedMesh::halfedge_descriptor>>& curves,
                             PatchMap patch_map)
{
  const auto& mesh = ranked.mesh();
  const auto piece_map = get(dynamic_face_property_t<std::size_t>(), mesh);
  constexpr std::size_t none = (std::numeric_limits<std::size_t>::max)();
  std::vector<std::size_t> arc_of_piece(number_patches(mesh, curves, piece_map), none);
  const auto set_arc = [&](typename RankedMesh::halfedge_descriptor h, std::size_t arc) {
    arc_of_piece[get(piece_map, face(h, mesh))] = arc;
  };
  for(std::size_t i = 0; i != curves.size(); ++i)
  {
    set_arc(curves[i].halfedges.front(), borders.higher_arcs[i]);
    set_arc(curves[i].lower_halfedges.front(), borders.lower_arcs[i]);
  }
  std::size_t number = 0;
  for(const auto arc : CGAL::make_range(edges(graph)))
  {
    for(const auto node : {source(arc, graph), target(arc, graph)})
    {
      const auto h = halfedge(graph[node].vertex, mesh);
      if(in_degree(node, graph) + out_degree(node, graph) == 1)
        set_arc(is_border(h, mesh) ? opposite(h, mesh) : h, number);
    }
    ++number;
  }
  for(std::size_t& arc : arc_of_piece)
  {
    if(arc == none)
      arc = number++;
  }
  for(const auto f : faces(mesh))
    put(patch_map, f, arc_of_piece[get(piece_map, f)]);
  return number;
}

// Calls cut(patch map), copies what it writes to the map of the user, and returns the number of patches.
template <class Mesh, class FacePatchMap, class Cut>
std::size_t cut_and_count_patches(Mesh& mesh, FacePatchMap face_patch_map, const Cut& cut)
{
  if constexpr(Refinable_mesh_with_patches<Mesh, FacePatchMap>::value)
  {
    const auto patch_map = get(dynamic_face_property_t<std::size_t>(), mesh);
    cut(patch_map);
    std::size_t number_of_patches = 0;
    for(const auto f : faces(mesh))
    {
      const std::size_t patch = get(patch_map, f);
      number_of_patches = (std::max)(number_of_patches, patch + 1);
      put(face_patch_map, f, patch);
    }
    return number_of_patches;
  }
  else
    return 0;
}

} // namespace CGAL::Reeb_graph::internal

#endif // CGAL_REEB_GRAPH_CURVES_INTERNAL_ARC_PATCHES_H
