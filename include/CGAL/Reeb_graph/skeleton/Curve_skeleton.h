// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_SKELETON_CURVE_SKELETON_H
#define CGAL_REEB_GRAPH_SKELETON_CURVE_SKELETON_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/boost/graph/iterator.h>
#include <CGAL/boost/graph/properties.h>

#include <boost/graph/adjacency_list.hpp>
#include <boost/graph/graph_traits.hpp>
#include <boost/property_map/property_map.hpp>

#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL::Reeb_graph {

/// \addtogroup PkgReebGraphSkeleton
/// @{

/// \brief a vertex of a curve skeleton.
///
/// \tparam Point_ a point of a three-dimensional kernel
/// \tparam VertexDescriptor a vertex descriptor of the mesh
template <class Point_, class VertexDescriptor>
struct Skeleton_vertex
{
  /// the arc of a node: a vertex of the skeleton where its arcs end
  static constexpr std::size_t no_arc = (std::numeric_limits<std::size_t>::max)();

  /// the place in space
  Point_ point = Point_();

  /// the vertices of the mesh that it stands for, in the order of the mesh: each vertex of a face is in one such list
  std::vector<VertexDescriptor> vertices;

  /// the radius of a circle with the area of the contour there: \f$ \sqrt{A / \pi} \f$, but at least the inscribed radius. The
  /// contour is that in the plane across the line. If that one is not across a tube, as its radius is one and a half times as large
  /// as its distance from the point, the radius is between those around, or, if there are none, that of the contour of the field. At a
  /// junction it is the mean where the lines leave the ball inscribed there, at the end of a tube without border that of the neighbor.
  double radius = 0;

  /// the distance from the surface: the radius of the largest ball around the point that it does not cross. Borders count as
  /// filled where they are no ends. It is 0 at the end of a tube without border.
  double inscribed_radius = 0;

  /// the number of the arc that it is on, `no_arc` for a node
  std::size_t arc = no_arc;

  /// its place on that arc, by length: greater than 0, and less than 1; 0 for a node
  double place = 0;

  /// whether it lies in a junction: on a part of an arc, from a node of three arcs or more on, that is in the ball there. The
  /// ball is as wide as the widest tube that begins there.
  bool is_in_junction = false;
};

/// \brief an edge of a curve skeleton.
struct Skeleton_edge
{
  /// the number of the arc that it is a part of
  std::size_t arc = 0;

  /// whether most of it lies in a junction
  bool is_in_junction = false;
};

/// \brief a curve skeleton, as `extract_curve_skeleton()` makes it: a `boost::adjacency_list` with a `Skeleton_vertex` for
/// each vertex and a `Skeleton_edge` for each edge.
///
/// \tparam FaceListGraph the type of the mesh
/// \tparam Point_ the type of the points
template <class FaceListGraph,
          class Point_ = typename boost::property_traits<
            typename boost::property_map<FaceListGraph, vertex_point_t>::const_type>::value_type>
using Curve_skeleton =
  boost::adjacency_list<boost::vecS,
                        boost::vecS,
                        boost::undirectedS,
                        Skeleton_vertex<Point_, typename boost::graph_traits<FaceListGraph>::vertex_descriptor>,
                        Skeleton_edge>;

/// \brief what is known of a curve skeleton: what `extract_curve_skeleton()` returns.
struct Skeleton_certificate
{
  std::size_t number_of_components = 0;     ///< connected components of the surface, and of the skeleton
  std::size_t number_of_arcs = 0;           ///< arcs: paths from node to node
  std::size_t number_of_ends = 0;           ///< nodes with one arc
  std::size_t number_of_border_ends = 0;    ///< those of them that are at borders
  std::size_t number_of_junctions = 0;      ///< nodes with three arcs or more
  std::size_t number_of_loops = 0;          ///< independent cycles
  std::size_t genus = 0;                    ///< handles of the surface, borders filled; those of all components
  std::size_t number_of_hidden_handles = 0; ///< handles that are no loop, since they are hidden in a multi-saddle
  /// loops that can be pulled to a point inside of the surface, or depend on others there; hardly ever any
  std::size_t number_of_contractible_loops = 0;
  /// the index of what the loops generate among all loops inside that have a multiple in it: 1 if they are a basis; at most what
  /// the type holds, as it can be large for a hundred handles
  std::size_t loop_index = 1;
  std::size_t number_of_vertices_outside = 0; ///< vertices that are outside; ends do not count
  std::size_t number_of_crossing_edges = 0;   ///< edges that cross the surface other than in an end
  /// components that, with their borders filled, intersect themselves, or have no volume but for rounding
  std::size_t number_of_crossing_components = 0;

  /// returns whether nothing is outside, and nothing crosses the surface
  bool is_inside() const { return number_of_vertices_outside == 0 && number_of_crossing_edges == 0; }
};

/// \brief returns the arcs of a curve skeleton as sequences of vertices, from node to node. A loop without any node but
/// one, as that of a ring, begins and ends there. It takes linear time.
///
/// \param skeleton a curve skeleton, as it has been extracted
///
/// \reebGraphComplexity
template <class CurveSkeleton>
std::vector<std::vector<typename boost::graph_traits<CurveSkeleton>::vertex_descriptor>> skeleton_arcs(
  const CurveSkeleton& skeleton)
{
  typedef typename boost::graph_traits<CurveSkeleton>::vertex_descriptor vertex_descriptor;
  std::vector<std::vector<vertex_descriptor>> arcs;
  for(const auto e : CGAL::make_range(edges(skeleton))) // in the order of the arcs, along each
  {
    if(skeleton[e].arc >= arcs.size())
      arcs.push_back({source(e, skeleton)});
    const vertex_descriptor last = arcs.back().back();
    arcs.back().push_back(source(e, skeleton) == last ? target(e, skeleton) : source(e, skeleton));
  }
  return arcs;
}

/// @}

} // namespace CGAL::Reeb_graph

#endif // CGAL_REEB_GRAPH_SKELETON_CURVE_SKELETON_H
