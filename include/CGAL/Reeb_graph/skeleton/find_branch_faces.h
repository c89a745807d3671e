// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors
#ifndef CGAL_REEB_GRAPH_SKELETON_FIND_BRANCH_FACES_H
#define CGAL_REEB_GRAPH_SKELETON_FIND_BRANCH_FACES_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/skeleton/Curve_skeleton.h>

#include <CGAL/boost/graph/iterator.h>
#include <CGAL/boost/graph/properties.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL::Reeb_graph {
namespace internal::skeleton {

// Pieces of a mesh, one for each arc of its skeleton, which grow from face to face.
template <class FaceListGraph, class FaceArcMap>
class Branch_pieces
{
public:
  typedef boost::graph_traits<FaceListGraph> Graph_traits;
  typedef typename Graph_traits::face_descriptor face_descriptor;
  static constexpr std::size_t none = (std::numeric_limits<std::size_t>::max)();

  Branch_pieces(const FaceListGraph& mesh, FaceArcMap arc_map) : mesh_(mesh), arc_map_(arc_map) {}

  // Takes the faces whose corners belong to one arc only, but for those at nodes, and keeps the largest part of each piece.
  template <class CurveSkeleton>
  void begin(const CurveSkeleton& skeleton)
  {
    const auto point_map = get(CGAL::dynamic_vertex_property_t<std::size_t>(), mesh_);
    for(const auto v : CGAL::make_range(vertices(skeleton)))
      for(const auto of_mesh : skeleton[v].vertices)
        put(point_map, of_mesh, v);
    for(const auto e : CGAL::make_range(edges(skeleton)))
      number_of_arcs_ = (std::max)(number_of_arcs_, skeleton[e].arc + 1);
    std::vector<face_descriptor> faces_at_arcs; // of which none may be whole
    for(const face_descriptor f : faces(mesh_))
    {
      std::size_t arc = none;
      bool is_one = true;
      for(const auto v : CGAL::vertices_around_face(halfedge(f, mesh_), mesh_))
      {
        const std::size_t of_corner = skeleton[get(point_map, v)].arc;
        is_one = is_one && (of_corner == none || arc == none || of_corner == arc);
        arc = of_corner == none ? arc : of_corner;
      }
      put(arc_map_, f, is_one ? arc : none);
      if(!is_one)
        faces_at_arcs.push_back(f);
    }
    keep_largest_parts();
    for(const face_descriptor f : faces_at_arcs)
      for(const auto v : CGAL::vertices_around_face(halfedge(f, mesh_), mesh_))
        add(f, skeleton[get(point_map, v)].arc);
    grow();
    for(const face_descriptor f : faces(mesh_)) // of components without any
      if(get(arc_map_, f) == none)
      {
        const auto edges_of_node = out_edges(get(point_map, target(halfedge(f, mesh_), mesh_)), skeleton);
        put(arc_map_, f, skeleton[*edges_of_node.first].arc);
        queue_.push_back(f);
        grow();
      }
  }

private:
  // Makes the face the first one of an arc that has none.
  void add(face_descriptor f, std::size_t arc)
  {
    if(arc == none || has_faces_[arc] || get(arc_map_, f) != none)
      return;
    put(arc_map_, f, arc);
    has_faces_[arc] = true;
    queue_.push_back(f);
  }

  template <class Visitor>
  void visit_neighbors(face_descriptor f, const Visitor& visit) const
  {
    for(const auto h : CGAL::halfedges_around_face(halfedge(f, mesh_), mesh_))
      if(!is_border(opposite(h, mesh_), mesh_))
        visit(face(opposite(h, mesh_), mesh_));
  }

  void keep_largest_parts()
  {
    const auto part_map = get(CGAL::dynamic_face_property_t<std::size_t>(), mesh_);
    for(const face_descriptor f : faces(mesh_))
      put(part_map, f, none);
    std::vector<std::vector<face_descriptor>> parts(number_of_arcs_); // the largest one of each arc
    for(const face_descriptor first : faces(mesh_))
    {
      const std::size_t arc = get(arc_map_, first);
      if(arc == none || get(part_map, first) != none)
        continue;
      std::vector<face_descriptor> part = {first};
      put(part_map, first, arc);
      for(std::size_t i = 0; i != part.size(); ++i)
        visit_neighbors(part[i], [&](face_descriptor f) {
          if(get(arc_map_, f) != arc || get(part_map, f) != none)
            return;
          put(part_map, f, arc);
          part.push_back(f);
        });
      if(part.size() > parts[arc].size())
        parts[arc].swap(part);
    }
    for(const face_descriptor f : faces(mesh_))
      put(arc_map_, f, none);
    has_faces_.assign(number_of_arcs_, false);
    for(std::size_t arc = 0; arc != number_of_arcs_; ++arc)
      for(const face_descriptor f : parts[arc])
      {
        put(arc_map_, f, arc);
        has_faces_[arc] = true;
        queue_.push_back(f);
      }
  }

  // Gives faces without an arc that of the nearest face with one.
  void grow()
  {
    for(std::size_t i = 0; i != queue_.size(); ++i)
    {
      const face_descriptor f = queue_[i]; // which the queue moves
      visit_neighbors(f, [&](face_descriptor neighbor) {
        if(get(arc_map_, neighbor) != none)
          return;
        put(arc_map_, neighbor, get(arc_map_, f));
        queue_.push_back(neighbor);
      });
    }
    queue_.clear();
  }

  const FaceListGraph& mesh_;
  FaceArcMap arc_map_;
  std::size_t number_of_arcs_ = 0;
  std::vector<bool> has_faces_; // of arcs
  std::vector<face_descriptor> queue_;
};

} // namespace internal::skeleton

/// \ingroup PkgReebGraphSkeleton
///
/// \brief finds the faces around each arc of a curve skeleton.
///
/// The faces of an arc are connected, and each face has an arc. Arcs without a vertex of the mesh, as short ones between
/// nodes, may have no face. It takes linear time.
///
/// \tparam FaceListGraph a model of `FaceListGraph`, with triangles as faces
/// \tparam CurveSkeleton a `Curve_skeleton` of that mesh
/// \tparam FaceArcMap a model of `ReadWritePropertyMap` with the face descriptors of the mesh as key type and `std::size_t`
///         as value type
///
/// \param mesh the mesh
/// \param skeleton its skeleton, as it has been extracted
/// \param face_arc_map the result: the number of an arc for each face
template <class FaceListGraph, class CurveSkeleton, class FaceArcMap>
void find_branch_faces(const FaceListGraph& mesh, const CurveSkeleton& skeleton, FaceArcMap face_arc_map)
{
  internal::skeleton::Branch_pieces<FaceListGraph, FaceArcMap>(mesh, face_arc_map).begin(skeleton);
}

} // namespace CGAL::Reeb_graph

#endif // CGAL_REEB_GRAPH_SKELETON_FIND_BRANCH_FACES_H
