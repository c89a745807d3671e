// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_FLAT_FIELD_H
#define CGAL_REEB_GRAPH_FLAT_FIELD_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/exceptions.h>
#include <CGAL/Reeb_graph/internal/base/Index.h>
#include <CGAL/Reeb_graph/internal/base/requirements.h>
#include <CGAL/Reeb_graph/internal/complex/Flat_mesh.h>
#include <CGAL/Reeb_graph/named_parameters.h>
#include <CGAL/Reeb_graph_traits.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/tags.h>

#include <boost/property_map/property_map.hpp>

#include <array>
#include <cstddef>
#include <memory>
#include <type_traits>
#include <utility>

namespace CGAL::Reeb_graph {
namespace internal {

// Counts that most edits of a mesh change: its numbers of vertices, edges and faces, and the first number behind those of a
// Surface_mesh, whose removed elements keep theirs.
typedef std::array<std::size_t, 5> Element_counts;

template <class FaceListGraph>
Element_counts count_elements(const FaceListGraph& mesh)
{
  std::size_t number_of_edges = 0;
  if constexpr(Has<Edge_list, FaceListGraph>::value)
    number_of_edges = num_edges(mesh);
  return {num_vertices(mesh), number_of_edges, num_faces(mesh), 0, 0};
}

template <class Point>
Element_counts count_elements(const Surface_mesh<Point>& mesh)
{
  return {mesh.number_of_vertices(), mesh.number_of_edges(), mesh.number_of_faces(), mesh.num_vertices(),
          mesh.num_edges()};
}

} // namespace internal

/// \ingroup PkgReebGraphRef
///
/// \brief a scalar field on a mesh that has been checked and numbered, to be kept for several functions and several
/// fields.
///
/// Each function of the package checks the mesh, and reads the field and, but for a `Surface_mesh`, the faces into
/// arrays. A `Flat_field` is a scalar map that has all this already. As the scalar map of its mesh it saves that work
/// in `compute_reeb_graph()`, `Augmentation` and `simplify_field()`. For any other function it is a map as others are.
/// The results are the same.
///
/// Copies share their memory. `set_values()` gives an object another field; its copies, and the augmentations that have
/// been made with it, keep the one that they have.
///
/// <b>The mesh must stay as it is.</b> It has to outlive the object, in its place in memory. After an edit, each use of
/// the object compares the numbers of vertices, edges and faces, and throws `Graph_mismatch_error` if they are others. An
/// edit that keeps the numbers, such as the flip of an edge, is not noticed. The connectivity of a `Surface_mesh` is
/// seen and not copied, so results are then undefined. On any other mesh, they are those of the mesh as it was. Points
/// may move. A change of the scalar map that the values came from has no effect until `set_values()`.
///
/// \tparam FaceListGraph a model of `FaceListGraph`
/// \tparam Scalar the type of the scalar values
///
/// \cgalModels{ReadablePropertyMap}
template <class FaceListGraph, class Scalar>
class Flat_field
{
public:
  typedef typename internal::Descriptors<FaceListGraph>::vertex_descriptor key_type; ///< the key type
  typedef Scalar value_type;                                                         ///< the value type
  typedef typename internal::Keyed_field<Scalar>::reference
    reference;                                       ///< the value of a built-in number, a reference to any other one
  typedef boost::readable_property_map_tag category; ///< the category

  /// checks the mesh, and reads it and the field.
  ///
  /// \tparam ScalarMap a model of `ReadablePropertyMap` with the vertex descriptors of the mesh as key type
  ///
  /// \param mesh the triangulated surface; it is only read
  /// \param scalar_map the scalar field, whose values are copied
  /// \param np an optional sequence of \ref bgl_namedparameters "Named Parameters": `vertex_index_map`,
  ///        `face_index_map` and `geom_traits` of `compute_reeb_graph()`. The functions that the object is given to
  ///        need the same `geom_traits`
  ///
  /// \exception Error one of those that `compute_reeb_graph()` throws for a mesh, a field or an index map
  template <class ScalarMap, class NamedParameters = parameters::Default_named_parameters>
  Flat_field(const FaceListGraph& mesh,
             const ScalarMap& scalar_map,
             const NamedParameters& np = parameters::default_values())
    : mesh_(&mesh),
      counts_(internal::count_elements(mesh))
  {
    static_assert(internal::are_met<Is_field<ScalarMap, NamedParameters>>);
    flat_values_ = std::make_shared<Flat_values>(
      internal::flatten(internal::Threads(), mesh, scalar_map, traits<ScalarMap>(np), np));
  }

  /// replaces the values. Only they are read, and checked.
  ///
  /// \param scalar_map another scalar field on the mesh; of any type, but its values convert to `Scalar`
  /// \param np an optional sequence of \ref bgl_namedparameters "Named Parameters": `geom_traits`
  ///
  /// \exception Graph_mismatch_error if the mesh has another number of vertices, edges or faces than before
  /// \exception Unordered_scalar_error if a scalar value is NaN
  ///
  /// When one of these is thrown, the object is as it was before.
  template <class ScalarMap, class NamedParameters = parameters::Default_named_parameters>
  void set_values(const ScalarMap& scalar_map, const NamedParameters& np = parameters::default_values())
  {
    static_assert(internal::are_met<Is_field<ScalarMap, NamedParameters>>);
    check_mesh(*mesh_);
    const auto& flat_mesh = flat_values_->mesh;
    auto field =
      internal::read_field(internal::Threads(), flat_mesh->numbers.vertices, scalar_map, traits<ScalarMap>(np));
    if(flat_values_.use_count() == 1)
      flat_values_->field = std::move(field);
    else // What shares them keeps its values.
      flat_values_ = std::make_shared<Flat_values>(Flat_values{flat_mesh, std::move(field)});
  }

  /// returns the mesh.
  const FaceListGraph& mesh() const { return *mesh_; }

  /// returns the value of a vertex of the mesh.
  ///
  /// \exception Unknown_vertex_error if it is not one, and the mesh numbers its vertices so that this shows
  friend reference get(const Flat_field& field, const key_type& vertex) { return field.value(vertex); }

#ifndef DOXYGEN_RUNNING
  typedef internal::Flat_values<FaceListGraph, Scalar> Flat_values;

  // Values that all functions share which take the field as scalar map of `mesh`.
  std::shared_ptr<const Flat_values> flat_values(const FaceListGraph& mesh) const
  {
    check_mesh(mesh);
    return flat_values_;
  }
#endif

private:
  template <class ScalarMap, class NamedParameters>
  using Traits = internal::Chosen_traits<Reeb_graph_traits<FaceListGraph, ScalarMap>, NamedParameters>;

  template <class ScalarMap, class NamedParameters>
  struct Is_field : internal::Scalar_field<FaceListGraph, ScalarMap, Traits<ScalarMap, NamedParameters>>
  {
    static_assert(std::is_same_v<typename Traits<ScalarMap, NamedParameters>::Scalar, Scalar>,
                  "The values of the scalar map are not those of the Flat_field: they need the same type.");
  };

  template <class ScalarMap, class NamedParameters>
  static auto traits(const NamedParameters& np)
  {
    return internal::choose_traits<Reeb_graph_traits<FaceListGraph, ScalarMap>>(np);
  }

  void check_mesh(const FaceListGraph& mesh) const
  {
    if(&mesh != mesh_ || internal::count_elements(mesh) != counts_)
      throw Graph_mismatch_error("the mesh is another one than that of the flat field, or has been changed since");
  }

  reference value(const key_type& vertex) const
  {
    const internal::Vertex_index number = flat_values_->mesh->numbers.number_of(vertex);
    if(number.number() >= flat_values_->field.keys().size())
      throw Unknown_vertex_error();
    return flat_values_->field.value(number);
  }

  const FaceListGraph* mesh_;
  internal::Element_counts counts_;
  std::shared_ptr<Flat_values> flat_values_;
};

template <class FaceListGraph, class ScalarMap, class NamedParameters = parameters::Default_named_parameters>
Flat_field(const FaceListGraph&, const ScalarMap&, const NamedParameters& = parameters::default_values())
  -> Flat_field<FaceListGraph,
                typename internal::Chosen_traits<Reeb_graph_traits<FaceListGraph, ScalarMap>, NamedParameters>::Scalar>;

namespace internal {

// A scalar map as Flat_field, which it may be already.
template <class FaceListGraph, class ScalarMap, class NamedParameters>
auto make_flat_field(const FaceListGraph& mesh, const ScalarMap& scalar_map, const NamedParameters& np)
{
  typedef typename Chosen_traits<Reeb_graph_traits<FaceListGraph, ScalarMap>, NamedParameters>::Scalar Scalar;
  if constexpr(Is_flat_field<ScalarMap, Scalar>::value)
    return scalar_map;
  else
    return Flat_field<FaceListGraph, Scalar>(mesh, scalar_map, np);
}

} // namespace internal
} // namespace CGAL::Reeb_graph

#endif // CGAL_REEB_GRAPH_FLAT_FIELD_H
