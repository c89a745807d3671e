// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#include "input/assemble_surface.h"

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace reeb_graph_program {
namespace {
typedef Surface::size_type Index;
typedef Surface::Halfedge_index Halfedge;

// Links one face after the other to those that share its edges, in one turn over them. Edges are numbered in the order
// of their first sides, which are their even halfedges.
//
// The faces at a vertex that are joined so far are fans. The border halfedge that leads to the vertex along an open fan
// has the one that leads away along it as the next one, so that a face finds the far ends of the fans that it joins.
class Face_linking
{
public:
  Face_linking(const Polygons& polygons, std::size_t number_of_vertices, Surface& surface)
    : polygons_(polygons),
      surface_(surface),
      numbers_of_corners_(number_of_vertices),
      last_edges_(number_of_vertices, none)
  {
    for(const Corner v : polygons.corners())
      ++numbers_of_corners_[v];
    const auto least_edges = static_cast<Index>(polygons.number_of_corners() / 2); // all if there is no border
    surface_.resize(static_cast<Index>(number_of_vertices), least_edges, static_cast<Index>(polygons.size()));
    earlier_edges_.reserve(least_edges);
  }

  // Returns false if two faces are on one side of an edge, or the faces at a vertex are several fans.
  bool link()
  {
    for(std::size_t i = 0; i < polygons_.size(); ++i)
      if(!link(Surface::Face_index(static_cast<Index>(i)), polygons_[i]))
        return false;
    resize(number_of_edges());
    if(!is_each_vertex_in_one_fan())
      return false;
    link_vertices_to_borders();
    return true;
  }

private:
  static constexpr Index none = static_cast<Index>(-1);

  static bool is_first_side(Halfedge h) { return h.idx() % 2 == 0; }
  Index number_of_edges() const { return static_cast<Index>(earlier_edges_.size()); }
  void resize(Index number_of_edges)
  {
    surface_.resize(surface_.number_of_vertices(), number_of_edges, surface_.number_of_faces());
  }

  bool link(Surface::Face_index face, Polygons::Polygon polygon)
  {
    sides_.clear();
    for(const Corner* source = polygon.begin(); source != polygon.end(); ++source)
    {
      const Corner target = source + 1 == polygon.end() ? *polygon.begin() : source[1];
      sides_.push_back(find_or_add_side(*source, target));
      if(sides_.back() == Surface::null_halfedge())
        return false;
    }
    Halfedge previous = sides_.back();
    surface_.set_halfedge(face, previous);
    for(const Halfedge side : sides_)
    {
      surface_.set_face(side, face);
      link_at_corner(previous, side);
      previous = side;
    }
    return true;
  }

  // The side of a face, none if it is taken. An edge is listed at the end with fewer corners, so that lists are short
  // even where a vertex has many edges.
  Halfedge find_or_add_side(Corner source, Corner target)
  {
    const auto key = [&](Corner v) { return std::make_pair(numbers_of_corners_[v], v); };
    Index& last_edge = last_edges_[key(source) < key(target) ? source : target];
    for(Index edge = last_edge; edge != none; edge = earlier_edges_[edge])
    {
      const Halfedge first(2 * edge), second(2 * edge + 1);
      const Corner first_target = surface_.target(first), second_target = surface_.target(second);
      if(first_target == source && second_target == target)
        return surface_.is_border(second) ? second : Surface::null_halfedge();
      if(first_target == target && second_target == source)
        return Surface::null_halfedge();
    }
    const Index edge = number_of_edges();
    if(edge == surface_.number_of_edges())
      resize(edge + edge / 8 + 64);
    surface_.set_target(Halfedge(2 * edge), Surface::Vertex_index(target));
    surface_.set_target(Halfedge(2 * edge + 1), Surface::Vertex_index(source));
    earlier_edges_.push_back(last_edge);
    last_edge = edge;
    return Halfedge(2 * edge);
  }

  // Joins the corner of a face between two of its sides to the fans along them.
  void link_at_corner(Halfedge to_vertex, Halfedge from_vertex)
  {
    const Halfedge next = is_first_side(to_vertex) ? surface_.opposite(to_vertex) : surface_.next(to_vertex);
    const Halfedge previous = is_first_side(from_vertex) ? surface_.opposite(from_vertex) : surface_.prev(from_vertex);
    if(next == from_vertex)
      ++number_of_closed_fans_;
    else
      surface_.set_next(previous, next);
    surface_.set_next(to_vertex, from_vertex);
    surface_.set_halfedge(surface_.target(to_vertex), to_vertex);
  }

  // Whether there are no more fans than vertices with faces. Each corner begins as a fan, each edge between two faces
  // joins two of them at both ends, and that makes one fewer unless it closes a fan.
  bool is_each_vertex_in_one_fan() const
  {
    const std::size_t number_of_corners = polygons_.number_of_corners();
    const std::size_t number_of_joins = 2 * (number_of_corners - number_of_edges());
    const auto number_of_isolated_vertices =
      static_cast<std::size_t>(std::count(numbers_of_corners_.begin(), numbers_of_corners_.end(), Index(0)));
    return number_of_corners + number_of_closed_fans_
        == number_of_joins + numbers_of_corners_.size() - number_of_isolated_vertices;
  }

  void link_vertices_to_borders()
  {
    if(polygons_.number_of_corners() == 2 * std::size_t(number_of_edges()))
      return;
    for(const Halfedge h : surface_.halfedges())
      if(surface_.is_border(h))
        surface_.set_halfedge(surface_.target(h), h);
  }

  const Polygons& polygons_;
  Surface& surface_;
  std::vector<Index> numbers_of_corners_; // at the vertices
  std::vector<Index> last_edges_;         // listed at the vertices, and for each edge the one listed before
  std::vector<Index> earlier_edges_;
  std::vector<Halfedge> sides_; // of the face that is linked
  std::size_t number_of_closed_fans_ = 0;
};

} // namespace

bool assemble_surface(const Polygon_soup& soup, Surface& surface)
{
  surface.clear();
  if(!Face_linking(soup.polygons, soup.points.size(), surface).link())
    return false;
  for(const Surface::Vertex_index v : surface.vertices())
    surface.point(v) = soup.points[v];
  return true;
}

Polygon_soup soup_of(const Surface& surface)
{
  Polygon_soup soup;
  soup.points.assign(surface.points().begin(), surface.points().end());
  for(const Surface::Face_index f : surface.faces())
  {
    for(const Surface::Vertex_index v : surface.vertices_around_face(surface.halfedge(f)))
      soup.polygons.add_corner(v);
    soup.polygons.end_polygon();
  }
  return soup;
}

} // namespace reeb_graph_program
