// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#include "input/assemble_surface.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace reeb_graph_program {
namespace {
typedef Surface::size_type Index;
constexpr Index none = static_cast<Index>(-1);

// The sides of the faces, by the vertex at which each begins: a side leads from a corner of a face to the next one.
class Sides_by_vertex
{
public:
  struct Side
  {
    Corner target;
    Index number; // that of the corner at which it begins
  };

  Sides_by_vertex(const Polygons& polygons, std::size_t number_of_vertices)
    : begins_(number_of_vertices + 2),
      sides_(polygons.number_of_corners())
  {
    for(std::size_t i = 0; i < polygons.size(); ++i)
      for(const Corner v : polygons[i])
        ++begins_[v + 2];
    for(std::size_t v = 2; v < begins_.size(); ++v)
      begins_[v] += begins_[v - 1];
    Index number = 0;
    for(std::size_t i = 0; i < polygons.size(); ++i)
    {
      const Polygons::Polygon polygon = polygons[i];
      for(auto corner = polygon.begin(); corner != polygon.end(); ++corner)
        sides_[begins_[*corner + 1]++] = Side{corner + 1 == polygon.end() ? *polygon.begin() : corner[1], number++};
    }
  }

  // Returns false if two sides lead from one vertex to the same one.
  bool sort()
  {
    const auto by_target = [](const Side& a, const Side& b) { return a.target < b.target; };
    const auto have_same_target = [](const Side& a, const Side& b) { return a.target == b.target; };
    for(std::size_t v = 0; v + 2 < begins_.size(); ++v)
    {
      std::sort(sides_.begin() + begins_[v], sides_.begin() + begins_[v + 1], by_target);
      if(std::adjacent_find(sides_.begin() + begins_[v], sides_.begin() + begins_[v + 1], have_same_target)
         != sides_.begin() + begins_[v + 1])
        return false;
    }
    return true;
  }

  Index number_at(Corner v) const { return begins_[v + 1] - begins_[v]; }

  // The number of the side from `source` to `target`, `none` if there is none.
  Index find(Corner source, Corner target) const
  {
    const auto end = sides_.begin() + begins_[source + 1];
    const auto side = std::lower_bound(sides_.begin() + begins_[source], end, target,
                                       [](const Side& s, Corner v) { return s.target < v; });
    return side != end && side->target == target ? side->number : none;
  }

private:
  std::vector<Index> begins_; // of each vertex; one behind while they are filled
  std::vector<Side> sides_;
};

// The halfedge of each side, by the number of the side. Edges are numbered in the order of their first sides.
std::vector<Index> number_halfedges(const Polygons& polygons, const Sides_by_vertex& sides, Index& number_of_edges)
{
  std::vector<Index> halfedges(polygons.number_of_corners(), none);
  number_of_edges = 0;
  for(std::size_t i = 0; i < polygons.size(); ++i)
  {
    const Polygons::Polygon polygon = polygons[i];
    const Index first = static_cast<Index>(polygons.begin(i)), size = static_cast<Index>(polygon.size());
    for(Index j = 0; j < size; ++j)
    {
      if(halfedges[first + j] != none)
        continue;
      halfedges[first + j] = 2 * number_of_edges++;
      const Index opposite = sides.find(polygon.begin()[j + 1 == size ? 0 : j + 1], polygon.begin()[j]);
      if(opposite != none)
        halfedges[opposite] = halfedges[first + j] + 1;
    }
  }
  return halfedges;
}

// The halfedge that leads to a vertex is that of its last face, as long as the vertex is on no border.
void link_faces(const Polygons& polygons, const std::vector<Index>& halfedges, Surface& surface)
{
  typedef Surface::Halfedge_index Halfedge;
  for(std::size_t i = 0; i < polygons.size(); ++i)
  {
    const Surface::Face_index f(static_cast<Index>(i));
    const Polygons::Polygon polygon = polygons[i];
    const Index* const sides = halfedges.data() + polygons.begin(i);
    Halfedge previous(sides[polygon.size() - 1]);
    surface.set_halfedge(f, previous);
    for(std::size_t j = 0; j < polygon.size(); ++j)
    {
      const Halfedge h(sides[j]);
      const Surface::Vertex_index source(polygon.begin()[j]);
      surface.set_target(previous, source);
      surface.set_target(surface.opposite(h), source);
      surface.set_halfedge(source, previous);
      surface.set_face(h, f);
      surface.set_next(previous, h);
      previous = h;
    }
  }
}

// Returns false if a vertex has two gaps between its faces.
bool link_borders(Surface& surface)
{
  std::vector<Surface::Halfedge_index> border_halfedges;
  for(const Surface::Halfedge_index h : surface.halfedges())
    if(surface.is_border(h))
    {
      border_halfedges.push_back(h);
      surface.set_halfedge(surface.target(h), h);
    }
  for(const Surface::Halfedge_index h : border_halfedges)
  {
    const Surface::Halfedge_index previous = surface.halfedge(surface.source(h));
    if(surface.halfedge(surface.target(h)) != h)
      return false;
    surface.set_next(previous, h);
  }
  return true;
}

// Whether the faces at each vertex are one fan: the turn around it meets all of them.
bool are_vertices_manifold(const Surface& surface, const Sides_by_vertex& sides)
{
  for(const Surface::Vertex_index v : surface.vertices())
  {
    const Surface::Halfedge_index begin = surface.halfedge(v);
    if(begin == Surface::null_halfedge())
      continue;
    Index number = 0;
    Surface::Halfedge_index h = begin;
    do
    {
      number += surface.is_border(h) ? 0 : 1;
      h = surface.opposite(surface.next(h));
    } while(h != begin);
    if(number != sides.number_at(v))
      return false;
  }
  return true;
}

} // namespace

bool assemble_surface(const Polygon_soup& soup, Surface& surface)
{
  const Polygons& polygons = soup.polygons;
  Sides_by_vertex sides(polygons, soup.points.size());
  if(!sides.sort())
    return false;
  Index number_of_edges = 0;
  const std::vector<Index> halfedges = number_halfedges(polygons, sides, number_of_edges);
  surface.clear();
  surface.resize(static_cast<Index>(soup.points.size()), number_of_edges, static_cast<Index>(polygons.size()));
  for(const Surface::Vertex_index v : surface.vertices())
    surface.point(v) = soup.points[v];
  link_faces(polygons, halfedges, surface);
  return link_borders(surface) && are_vertices_manifold(surface, sides);
}

} // namespace reeb_graph_program
