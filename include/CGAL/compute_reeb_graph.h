// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_COMPUTE_REEB_GRAPH_H
#define CGAL_COMPUTE_REEB_GRAPH_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/internal/base/requirements.h>
#include <CGAL/Reeb_graph/internal/engine/classify_vertices.h>
#include <CGAL/Reeb_graph/internal/engine/find_arcs.h>
#include <CGAL/Reeb_graph/internal/engine/write_graph.h>
#include <CGAL/Reeb_graph/internal/way_back/vertex_places.h>
#include <CGAL/Reeb_graph/named_parameters.h>
#include <CGAL/Reeb_graph/scalar_maps.h>
#include <CGAL/Reeb_graph_traits.h>

#include <functional>
#include <utility>

namespace CGAL {
namespace Reeb_graph::internal {

// A Flat_field, as flatten_unchecked() gives another one.
template <class FaceListGraph, class Scalar>
struct Checked_surface
{
  std::reference_wrapper<const Complex_of_t<FaceListGraph>> complex;
  const Mesh_numbers<FaceListGraph>& numbers;
  const Keyed_field<Scalar>& field;
};

// The first stage: the mesh and its field by numbers.
template <class FaceListGraph, class ScalarMap, class Traits, class NamedParameters>
auto flatten_for_graph(const Threads& threads,
                       const FaceListGraph& mesh,
                       const ScalarMap& scalar_map,
                       const Traits& traits,
                       const NamedParameters& np)
{
  typedef typename Traits::Scalar Scalar;
  if constexpr(Is_flat_field<ScalarMap, Scalar>::value)
  {
    const auto& [flat_mesh, field] = *flat_values_of(scalar_map, mesh, traits); // which the map holds
    return Checked_surface<FaceListGraph, Scalar>{flat_mesh->complex, flat_mesh->numbers, field};
  }
  else
  {
    auto surface = flatten_unchecked(threads, mesh, scalar_map, traits, np);
    surface.numbers.number_of = nullptr; // They take memory, and nobody asks for them.
    return surface;
  }
}

// The stages. `mesh_of` tells by what the numbers of a complex lead back to descriptors. Overloads for soups may come
// later.
template <class Flatten, class MeshOf, class ReebGraph, class NamedParameters>
void run_pipeline(const Threads& threads,
                  const Flatten& flatten,
                  const MeshOf& mesh_of,
                  ReebGraph& graph,
                  const NamedParameters& np)
{
  auto visitor_parameter = internal::parameter_or(np, internal_np::visitor, Default_visitor());
  auto& visitor = internal::unwrap_reference(visitor_parameter);
  const Progress progress(np);
  const auto ties = internal::parameter_or(np, internal::ties, Ties::PERTURB);
  const auto method = internal::parameter_or(np, internal::method, Default_method());
  const bool are_degree_two_nodes_kept = internal::parameter_or(np, keep_degree_two_nodes, false);
  const auto number_of_slabs = internal::parameter_or(np, internal::number_of_slabs, Default_number_of_slabs());
  const auto place_map = parameters::get_parameter(np, vertex_place_map);
  constexpr bool are_places_wanted = is_given<decltype(place_map)>;

  progress.report(0);
  visitor.begin_stage(Stage::FLATTEN);
  auto [unchecked_complex, numbers, field] = flatten(threads);
  const Vertex_order order(field.keys());
  visitor.end_stage(Stage::FLATTEN);
  progress.report(0.2);

  visitor.begin_stage(Stage::CLASSIFY);
  auto [complex, critical_vertices] = check_and_classify_vertices(threads, std::move(unchecked_complex), order);
  visitor.critical_vertices(count_critical_vertices(critical_vertices));
  visitor.end_stage(Stage::CLASSIFY);
  progress.report(0.3);

  visitor.begin_stage(Stage::ARCS);
  const Stage_progress arcs_progress(progress, 0.3, 0.7);
  Swept_arcs arcs;
  Arc_of_vertex arc_of_vertex;
  if constexpr(are_places_wanted)
    arcs = find_arcs_and_locate_vertices(threads, complex, order, critical_vertices, arc_of_vertex, arcs_progress);
  else
    arcs = find_arcs(threads, complex, order, critical_vertices, method, number_of_slabs, arcs_progress);
  progress.report(0.7);
  const Flat_graph flat_graph =
    reduce_arcs(threads, complex, order, critical_vertices, arcs, ties, are_degree_two_nodes_kept, are_places_wanted);
  Place_of_vertex places;
  if constexpr(are_places_wanted)
    places = find_vertex_places(threads, complex, order, critical_vertices, arcs, arc_of_vertex, flat_graph, ties);
  critical_vertices = Swept_vertices(); // The graph takes much memory.
  arcs = Swept_arcs();
  arc_of_vertex = Arc_of_vertex();
  visitor.end_stage(Stage::ARCS);
  progress.report(0.8);

  // Not written aside and swapped: to swap graphs of Boost copies them.
  visitor.begin_stage(Stage::WRITE);
  internal::write_graph(threads, mesh_of(complex), complex, numbers, field, flat_graph, graph);
  if constexpr(are_places_wanted)
    write_places(places, numbers.vertices, place_map);
  visitor.end_stage(Stage::WRITE);
  progress.report_end();
}

#define CGAL_REEB_GRAPH_WRITE_GRAPH(PREFIX, POINT)                                                                     \
  PREFIX template void write_graph(const Threads&, const Surface_mesh<POINT>&, const Surface_mesh_complex<POINT>&,     \
                                   const Mesh_numbers<Surface_mesh<POINT>>&, const Keyed_field<double>&,               \
                                   const Flat_graph&, Surface_graph<double>&);
CGAL_REEB_GRAPH_FOR_POINTS(CGAL_REEB_GRAPH_WRITE_GRAPH)

} // namespace Reeb_graph::internal

/// \ingroup PkgReebGraphRef
///
/// \brief computes the augmented Reeb graph of a scalar field on a triangulated surface.
///
/// The surface is the piecewise linear one of `mesh`: orientable, of any genus, with or without border, of any
/// number of components, isolated vertices included. The field is linear on each face. The graph is exact: only
/// comparisons of scalar values decide it. Vertices of equal value are ordered by their position in
/// `vertices(mesh)` (simulation of simplicity), so constant parts of a field need no care.
///
/// A node is a vertex at which the contours, the connected components of the level sets, are born, die, join or
/// split. An arc is a maximal family of contours in between, directed from its lower to its upper node. Each arc
/// carries a chain of ascending mesh halfedges, from which every contour of the arc can be reached.
/// Nodes are numbered in the order of their vertices, arcs are sorted by lower node, upper node, and the second, then
/// the first vertex of their chain. The same input gives the same graph, whatever the type of the mesh.
///
/// The named parameter `method` chooses between two methods. `CRITICAL_SETS` is that of \cgalCite{hr-edrprg-20}. By
/// default, the surface is cut along one contour for each loop of the graph. The cut surface has a contour tree, which
/// is made as by \cgalCite{cllr-sooscc-05}, and \cgalCite{csa-cctad-03}. Then the cuts are glued. This is the loop
/// surgery of \cgalCite{tgsp-lsvmrg-09}.
///
/// Let there be \f$ n \f$ vertices and faces, and \f$ c \f$ critical vertices, and let \f$ l \f$ be the length of the
/// contours at the vertices where loops close. The default takes \f$ O(n + c \log c + l \log l) \f$ time and
/// \f$ O(n + l) \f$ memory. On a closed surface of genus \f$ g \f$ there are at most \f$ 2g \f$ such vertices.
///
/// \tparam ConcurrencyTag `Sequential_tag`, `Parallel_tag`, or `Parallel_if_available_tag`. It has no influence on the
///         result. `Parallel_tag` needs TBB; the threads are those of the calling `tbb::task_arena`. One thread works
///         on meshes of fewer than 20,000 faces.
/// \tparam FaceListGraph a model of `FaceListGraph`
/// \tparam ScalarMap a model of `ReadablePropertyMap` with the vertex descriptors of the mesh as key type. The value
///         type is the scalar type of the traits class. With `Parallel_tag`, several threads copy and compare values
///         at the same time. They also read built-in numbers from the map, but not from a dynamic property map of a
///         mesh that is not a `Surface_mesh`.
/// \tparam ReebGraph the type `Graph` of the traits class
///
/// \param mesh the triangulated surface; it is only read
/// \param scalar_map the scalar field
/// \param graph the result; whatever it held before is cleared
/// \param np an optional sequence of \ref bgl_namedparameters "Named Parameters" among the ones listed below
///
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{keep_degree_two_nodes}
///     \cgalParamDescription{whether critical vertices that are touched by one contour just below and by one just
///                           above become nodes of degree 2. They are none in the Reeb graph proper.}
///     \cgalParamType{`bool`}
///     \cgalParamDefault{`false`}
///   \cgalParamNEnd
///   \cgalParamNBegin{ties}
///     \cgalParamDescription{what becomes of vertices of equal value}
///     \cgalParamType{`Reeb_graph::Ties`}
///     \cgalParamDefault{`Reeb_graph::Ties::PERTURB`}
///   \cgalParamNEnd
///   \cgalParamNBegin{method}
///     \cgalParamDescription{how the arcs are found. It has no influence on the result.}
///     \cgalParamType{`Reeb_graph::Method`}
///     \cgalParamDefault{`Reeb_graph::Method::AUTOMATIC`}
///   \cgalParamNEnd
///   \cgalParamNBegin{number_of_slabs}
///     \cgalParamDescription{into how many slabs, between level sets, the surface is cut so that the arcs of each are
///                           found on their own; 0 leaves the choice to the function. It has no influence on the
///                           result. There are never more slabs than critical vertices, and fewer where the edges
///                           that they cross would take much more memory than the mesh.}
///     \cgalParamType{`std::size_t`}
///     \cgalParamDefault{0}
///   \cgalParamNEnd
///   \cgalParamNBegin{vertex_place_map}
///     \cgalParamDescription{is given the number of the place of each vertex in the graph: nodes are numbered from 0 by
///                           their descriptors, arcs after the last node, in the order of `edges(graph)`. These are the
///                           numbers of `Vertex_places::index()`, found in one turn with the graph, which takes less
///                           time than to ask `Augmentation::locate_vertices()` for them afterwards. `method` and
///                           `number_of_slabs` do not count then.}
///     \cgalParamType{a model of `WritablePropertyMap` with the vertex descriptors as key type and an integer type as
///                    value type}
///     \cgalParamDefault{none: the places are not looked for}
///   \cgalParamNEnd
///   \cgalParamNBegin{callback}
///     \cgalParamDescription{is called now and then with the fraction of the work done, from 0 to 1. If it returns
///                           `false`, the computation stops, except at 1, when the graph is written.}
///     \cgalParamType{a function object that can be called with a `double` and returns `bool`}
///     \cgalParamDefault{none}
///   \cgalParamNEnd
///   \cgalParamNBegin{vertex_index_map}
///     \cgalParamDescription{a property map that gives each vertex a different non-negative integer, used to find
///                           vertices fast. It has no influence on the result. Memory is taken for the largest
///                           index.}
///     \cgalParamType{a model of `ReadablePropertyMap` with the vertex descriptors as key type and an integer type
///                    as value type}
///     \cgalParamDefault{the index that the mesh has for its vertices, if it has a constant one, else a dynamic
///                       property map}
///   \cgalParamNEnd
///   \cgalParamNBegin{face_index_map}
///     \cgalParamDescription{a property map of that kind for the faces. A `CGAL::Surface_mesh` needs neither of the
///                           two; they are only checked.}
///     \cgalParamType{a model of `ReadablePropertyMap` with the face descriptors as key type and an integer type as
///                    value type}
///     \cgalParamDefault{as for vertices}
///   \cgalParamNEnd
///   \cgalParamNBegin{geom_traits}
///     \cgalParamDescription{an instance of a traits class, for scalar values ordered by another function object}
///     \cgalParamType{a model of `ReebGraphTraits`}
///     \cgalParamDefault{`Reeb_graph_traits<FaceListGraph, ScalarMap>`}
///   \cgalParamNEnd
///   \cgalParamNBegin{visitor}
///     \cgalParamDescription{is called when each stage begins and ends, and with the counts of critical vertices}
///     \cgalParamType{a model of `ReebGraphVisitor`, by value or as `std::reference_wrapper`}
///     \cgalParamDefault{`Reeb_graph::Default_visitor`}
///   \cgalParamNEnd
/// \cgalNamedParamsEnd
///
/// \pre The mesh is a triangulated, orientable surface, with or without border: each vertex has one fan of faces.
///
/// \reebGraphComplexity
///
/// \exception Reeb_graph::Non_triangular_face_error if a face is not a triangle
/// \exception Reeb_graph::Degenerate_face_error if a face has one vertex at two corners
/// \exception Reeb_graph::Edge_without_face_error if an edge is on no face, and the mesh lists its edges
/// \exception Reeb_graph::Non_manifold_vertex_error if the faces of a vertex form more than one fan
/// \exception Reeb_graph::Unordered_scalar_error if a scalar value is NaN, or if the order of the values is found to
///            contradict itself
/// \exception Reeb_graph::Invalid_index_map_error if an index map is not one to one
/// \exception Reeb_graph::Cancelled_error if `callback` returns `false`
/// \exception Reeb_graph::Mesh_size_error if there are too many vertices or halfedges for 32-bit indices
///
/// After one of these, `graph` is as it was before. After any other exception, such as `std::bad_alloc`, or if the
/// order of the values contradicts itself, it can be empty.
template <class ConcurrencyTag = Sequential_tag,
          class FaceListGraph,
          class ScalarMap,
          class ReebGraph,
          class NamedParameters = parameters::Default_named_parameters>
void compute_reeb_graph(const FaceListGraph& mesh,
                        ScalarMap scalar_map,
                        ReebGraph& graph,
                        const NamedParameters& np = parameters::default_values())
{
  namespace internal = Reeb_graph::internal;
  typedef Reeb_graph_traits<FaceListGraph, ScalarMap> Default_traits;
  typedef internal::Chosen_traits<Default_traits, NamedParameters> Traits;
  static_assert(internal::are_met<internal::Graph_is_not_const<ReebGraph>,
                                  internal::Field_and_graph<FaceListGraph, ScalarMap, ReebGraph, Traits>>);
  const auto traits = internal::choose_traits<Default_traits>(np);
  const auto flatten = [&](const internal::Threads& threads) {
    return internal::flatten_for_graph(threads, mesh, scalar_map, traits, np);
  };
  const auto mesh_of = [&](const auto&) -> const FaceListGraph& { return mesh; };
  internal::Threads threads = internal::threads_of<ConcurrencyTag>();
  if(threads.are_parallel() && num_faces(mesh) < internal::smallest_parallel_mesh)
    threads = internal::Threads();
  internal::run_pipeline(threads, flatten, mesh_of, graph, np);
}

} // namespace CGAL

#endif // CGAL_COMPUTE_REEB_GRAPH_H
