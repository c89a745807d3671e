// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_CURVES_REFINEMENT_VISITOR_H
#define CGAL_REEB_GRAPH_CURVES_REFINEMENT_VISITOR_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/internal/base/interpolation.h>
#include <CGAL/Reeb_graph/internal/base/requirements.h>

#include <CGAL/IO/Color.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/property_map/property_map.hpp>

#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <type_traits>
#include <vector>

namespace CGAL::Reeb_graph {

/// \addtogroup PkgReebGraphCurves
/// @{

/// \brief a visitor of a refinement that does nothing; derive from it, and redefine one or more members.
///
/// \tparam FaceGraph the type of the mesh
///
/// \cgalModels{ReebGraphRefinementVisitor}
template <class FaceGraph>
struct Default_refinement_visitor
{
  typedef typename boost::graph_traits<FaceGraph>::vertex_descriptor vertex_descriptor;     ///< a vertex
  typedef typename boost::graph_traits<FaceGraph>::halfedge_descriptor halfedge_descriptor; ///< a halfedge
  typedef typename boost::graph_traits<FaceGraph>::face_descriptor face_descriptor;         ///< a face

  /// called when the halfedge `first` has been split off from `second`, which it leads to.
  void edge_split(halfedge_descriptor /* first */, halfedge_descriptor /* second */) {}

  /// called when `v` has been placed at the fraction `t` of the way from `source` to `target`.
  void vertex_added(vertex_descriptor /* v */,
                    vertex_descriptor /* source */,
                    vertex_descriptor /* target */,
                    double /* t */)
  {}

  /// called when the face `created` has been split off from `old`.
  void face_split(face_descriptor /* old */, face_descriptor /* created */) {}

  /// called when the mesh is cut open and the lower side of a curve gets the vertex `created` in the place of `old`.
  void vertex_duplicated(vertex_descriptor /* old */, vertex_descriptor /* created */) {}

  /// called when the mesh is cut open and the lower side of a curve gets the halfedge `created` in the place of `old`.
  void halfedge_duplicated(halfedge_descriptor /* old */, halfedge_descriptor /* created */) {}
};

/// \brief linear interpolation between two values of one type: the default of `Interpolating_visitor`.
///
/// Numbers, points and vectors are interpolated, `std::array` and `CGAL::IO::Color` by their components. Integers are
/// rounded to the nearest one; a `bool` is that of the nearer end.
struct Linear_interpolation
{
  /// returns the value at the fraction `t` of the way from `a` to `b`.
  template <class Value>
  Value operator()(const Value& a, const Value& b, double t) const
  {
    if constexpr(std::is_same_v<Value, bool>)
      return t < 0.5 ? a : b;
    else if constexpr(std::is_integral_v<Value>)
      // not larger than the larger one, as differences of small numbers are exact
      return static_cast<Value>(a + std::llround(t * (static_cast<double>(b) - static_cast<double>(a))));
    else
      return internal::value_at_fraction(a, b, t);
  }

  /// returns the same, component by component.
  template <class Value, std::size_t size>
  std::array<Value, size> operator()(const std::array<Value, size>& a, const std::array<Value, size>& b, double t) const
  {
    std::array<Value, size> result = a;
    for(std::size_t i = 0; i != size; ++i)
      result[i] = (*this)(a[i], b[i], t);
    return result;
  }

  /// returns the same, channel by channel.
  IO::Color operator()(const IO::Color& a, const IO::Color& b, double t) const
  {
    return IO::Color((*this)(a.red(), b.red(), t), (*this)(a.green(), b.green(), t), (*this)(a.blue(), b.blue(), t),
                     (*this)(a.alpha(), b.alpha(), t));
  }
};

/// \brief a visitor of a refinement that carries property maps over to the vertices and faces that are added.
///
/// Add the maps, and pass it as named parameter `visitor`, by value or as `std::reference_wrapper`. A vertex that is
/// placed on an edge gets a value between those of the ends of the edge. One that doubles another when the mesh is cut
/// open gets the value of that one. A part of a face gets the value of the face. The points and the scalar field need
/// no visitor.
///
/// \tparam FaceGraph the type of the mesh
///
/// \cgalModels{ReebGraphRefinementVisitor}
template <class FaceGraph>
class Interpolating_visitor : public Default_refinement_visitor<FaceGraph>
{
public:
  typedef typename boost::graph_traits<FaceGraph>::vertex_descriptor vertex_descriptor; ///< a vertex
  typedef typename boost::graph_traits<FaceGraph>::face_descriptor face_descriptor;     ///< a face

  /// adds a property map of the vertices.
  ///
  /// \tparam VertexMap a model of `ReadWritePropertyMap` with the vertex descriptors as key type
  /// \tparam Interpolation a function object that is called with two values and a `double` between 0 and 1, and returns
  ///         a value; 0 stands for the first one and 1 for the second one
  ///
  /// \returns this visitor, so that calls can follow each other.
  template <class VertexMap, class Interpolation = Linear_interpolation>
  Interpolating_visitor& add_vertex_map(VertexMap map, Interpolation interpolate = Interpolation())
  {
    static_assert(internal::are_met<internal::Writable_vertex_map<VertexMap, FaceGraph>>);
    vertex_actions_.push_back(
      [map, interpolate](vertex_descriptor v, vertex_descriptor source, vertex_descriptor target, double t) mutable {
        typedef typename boost::property_traits<VertexMap>::value_type Value;
        const Value a = get(map, source), b = get(map, target); // no references: writing can move them
        put(map, v, t == 0 ? a : interpolate(a, b, t));
      });
    return *this;
  }

  /// adds a property map of the faces.
  ///
  /// \tparam FaceMap a model of `ReadWritePropertyMap` with the face descriptors as key type
  ///
  /// \returns this visitor, so that calls can follow each other.
  template <class FaceMap>
  Interpolating_visitor& add_face_map(FaceMap map)
  {
    static_assert(internal::are_met<internal::Writable_face_map<FaceMap, FaceGraph>>);
    face_actions_.push_back([map](face_descriptor old, face_descriptor created) mutable {
      const typename boost::property_traits<FaceMap>::value_type value = get(map, old);
      put(map, created, value);
    });
    return *this;
  }

  /// interpolates the values at a vertex that is placed on an edge.
  void vertex_added(vertex_descriptor v, vertex_descriptor source, vertex_descriptor target, double t)
  {
    for(const auto& act : vertex_actions_)
      act(v, source, target, t);
  }

  /// copies the values of a vertex that is doubled.
  void vertex_duplicated(vertex_descriptor old, vertex_descriptor created) { vertex_added(created, old, old, 0); }

  /// copies the values of a face that is split.
  void face_split(face_descriptor old, face_descriptor created)
  {
    for(const auto& act : face_actions_)
      act(old, created);
  }

private:
  std::vector<std::function<void(vertex_descriptor, vertex_descriptor, vertex_descriptor, double)>> vertex_actions_;
  std::vector<std::function<void(face_descriptor, face_descriptor)>> face_actions_;
};

/// @}

} // namespace CGAL::Reeb_graph

#endif // CGAL_REEB_GRAPH_CURVES_REFINEMENT_VISITOR_H
