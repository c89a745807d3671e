// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_CURVES_SEGMENTATION_H
#define CGAL_REEB_GRAPH_CURVES_SEGMENTATION_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/Augmentation.h>
#include <CGAL/Reeb_graph/curves/Curve.h>
#include <CGAL/Reeb_graph/curves/branch_curves.h>
#include <CGAL/Reeb_graph/curves/internal/cut_and_mark.h>
#include <CGAL/Reeb_graph/curves/pants_decomposition.h>
#include <CGAL/Reeb_graph/internal/base/Progress.h>

#include <CGAL/iterator.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <unordered_map>
#include <vector>

namespace CGAL::Reeb_graph {

namespace internal {

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
      return a->number_of_crossings() < b->number_of_crossings();
    });
    const std::size_t arc_of_node = numbers.at(&graph[(*longest)->arc]);
    for(std::size_t i = 0; i != contours.size(); ++i)
    {
      if(contours[i] == *longest)
        continue;
      const std::size_t arc = numbers.at(&graph[contours[i]->arc]);
      const bool is_above_node = i >= critical_set.lower_contours.size();
      result.contours.push_back(make_contour_to_cut(ranked, contours[i]->edges, contours[i]->is_closed()));
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
  static_assert(are_met<Refinable_mesh<Mesh>, Writable_face_map<FacePatchMap, Mesh>>);
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

} // namespace internal

/// \ingroup PkgReebGraphCurves
///
/// \brief refines a mesh and numbers the pairs of pants that it consists of.
///
/// The mesh is cut along the curves of `pants_decomposition()`, and in its time: each patch is a sphere with three
/// holes.
///
/// \reebGraphRefinedMeshAndField
/// \tparam FacePatchMap a model of `WritablePropertyMap` with the face descriptors of the mesh as key type and an
///         integer type as value type
/// \tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"
///
/// \param mesh the mesh, which is changed. To keep it, pass a copy made by `CGAL::copy_face_graph()`.
/// \param scalar_map the scalar field
/// \param face_patch_map the result: the number of its patch for each face, from 0, in the order of the first faces
/// \param np the named parameters of `pants_decomposition()`, without `face_patch_map`
///
/// \reebGraphComplexity
///
/// \returns the number of patches.
///
/// It throws the exceptions of `pants_decomposition()`.
template <class MutableFaceGraph,
          class ScalarMap,
          class FacePatchMap,
          class NamedParameters = parameters::Default_named_parameters>
std::size_t segment_by_pants(MutableFaceGraph& mesh,
                             ScalarMap scalar_map,
                             FacePatchMap face_patch_map,
                             const NamedParameters& np = parameters::default_values())
{
  return internal::cut_and_count_patches(mesh, face_patch_map, [&](const auto& patch_map) {
    pants_decomposition(mesh, scalar_map, Emptyset_iterator(), np.face_patch_map(patch_map));
  });
}

/// \ingroup PkgReebGraphCurves
///
/// \brief refines a mesh and numbers its branches, and what is left without them.
///
/// The mesh is cut along the curves of `branch_curves()`, and in its time. A figure is segmented into head, arms, legs
/// and body, if the field rises or falls along each of them. Choose a threshold, as noise makes branches, too.
///
/// \param mesh the mesh, which is changed
/// \param scalar_map the scalar field
/// \param face_patch_map the result, as that of `segment_by_pants()`
/// \param np the named parameters of `branch_curves()`, without `face_patch_map`
///
/// \reebGraphComplexity
///
/// \returns the number of patches.
///
/// It throws the exceptions of `branch_curves()`.
template <class MutableFaceGraph,
          class ScalarMap,
          class FacePatchMap,
          class NamedParameters = parameters::Default_named_parameters>
std::size_t segment_by_branches(MutableFaceGraph& mesh,
                                ScalarMap scalar_map,
                                FacePatchMap face_patch_map,
                                const NamedParameters& np = parameters::default_values())
{
  return internal::cut_and_count_patches(mesh, face_patch_map, [&](const auto& patch_map) {
    branch_curves(mesh, scalar_map, Emptyset_iterator(), np.face_patch_map(patch_map));
  });
}

/// \ingroup PkgReebGraphCurves
///
/// \brief refines a mesh and cuts it into the regions of the arcs of its Reeb graph: one connected patch for each arc.
///
/// At each node, the mesh is cut along all contours next to it but one, the one that crosses the most edges: the node
/// belongs to the patch of its arc. So no face is divided between two arcs, unlike in a segmentation of the vertices.
/// Time and refinement are those of `cut_along_contours()` for the contours next to the nodes.
///
/// Any mesh and any field will do, borders need not be levels. A component on which the field is constant has no arc if
/// ties are contracted; it is a patch of its own, numbered behind those of the arcs. The halfedges of the chains of
/// `graph` are those of the mesh before: an edge that has been split has kept its upper part.
///
/// \reebGraphRefinedMeshAndField
/// \tparam ReebGraph the type `Graph` of the traits class
/// \tparam FacePatchMap a model of `WritablePropertyMap` with the face descriptors of the mesh as key type and an
///         integer type as value type
/// \tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"
///
/// \param mesh the mesh, which is changed. To keep it, pass a copy made by `CGAL::copy_face_graph()`.
/// \param scalar_map the scalar field
/// \param graph the Reeb graph of the mesh and the field
/// \param face_patch_map the result: for each face the number of its arc, in the order of `edges(graph)`, from 0
/// \param np an optional sequence of \ref bgl_namedparameters "Named Parameters": `ties` and `keep_degree_two_nodes`
///        that the graph has been computed with, and those below
///
/// \copydetails PkgReebGraphCuttingParameters
///
/// \copydetails PkgReebGraphRefinementParameters
///
/// \pre The graph is that of the mesh and the field.
///
/// \reebGraphComplexity
///
/// \returns the number of patches: that of the arcs, and of the components without an arc.
///
/// \exception Reeb_graph::Graph_mismatch_error if a node is not one of this mesh and field, or an arc none that `ties`
///            gives. That all nodes and arcs are there is not checked.
///
/// and the exceptions of `compute_reeb_graph()`. When one is thrown, the mesh is as it was before.
template <class MutableFaceGraph,
          class ScalarMap,
          class ReebGraph,
          class FacePatchMap,
          class NamedParameters = parameters::Default_named_parameters>
std::size_t segment_by_arcs(MutableFaceGraph& mesh,
                            ScalarMap scalar_map,
                            const ReebGraph& graph,
                            FacePatchMap face_patch_map,
                            const NamedParameters& np = parameters::default_values())
{
  typedef internal::Chosen_traits<Reeb_graph_traits<MutableFaceGraph, ScalarMap>, NamedParameters> Traits;
  static_assert(internal::are_met<internal::Refinable_mesh<MutableFaceGraph>,
                                  internal::Field_and_graph<MutableFaceGraph, ScalarMap, ReebGraph, Traits>,
                                  internal::Scalars_are_numbers<Traits>,
                                  internal::Writable_face_map<FacePatchMap, MutableFaceGraph>>);
  const internal::Progress progress(np);
  const auto stage = [&](double begin, double end) { return internal::Stage_progress(progress, begin, end); };
  const auto traits = internal::choose_traits<Traits>(np);
  auto visitor_parameter = internal::choose_refinement_visitor(mesh, np);
  const auto ranked = internal::make_ranked_mesh(mesh, internal::unwrap_reference(visitor_parameter), np);
  const Augmentation<MutableFaceGraph, ScalarMap, ReebGraph, Traits> augmentation(
    mesh, scalar_map, graph, np.callback(stage(0, 0.05).callback())); // It checks the values before they are sorted.
  internal::rank_vertices(ranked, scalar_map, traits);
  const auto borders = internal::find_arc_borders(ranked, graph, augmentation, stage(0.1, 0.2));
  const auto curves = internal::cut_and_mark(ranked, borders.contours, scalar_map, traits, np, stage(0.2, 0.65));
  const std::size_t number_of_patches = internal::mark_arc_patches(ranked, graph, borders, curves, face_patch_map);
  progress.report_end();
  return number_of_patches;
}

} // namespace CGAL::Reeb_graph

#endif // CGAL_REEB_GRAPH_CURVES_SEGMENTATION_H
