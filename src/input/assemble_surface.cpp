// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#include "input/assemble_surface.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <string>
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

namespace {
typedef std::array<Corner, 3> Triangle_corners;

Triangle_corners sorted(Triangle_corners corners)
{
  std::sort(corners.begin(), corners.end());
  return corners;
}

// The four sides of a tetrahedron, as they are seen from outside.
std::array<Triangle_corners, 4> sides_of(std::array<Corner, 4> t, const std::vector<Point>& points)
{
  typedef CGAL::Exact_predicates_inexact_constructions_kernel Kernel;
  const auto point = [&](Corner v) { return Kernel::Point_3(points[v].x(), points[v].y(), points[v].z()); };
  if(CGAL::orientation(point(t[0]), point(t[1]), point(t[2]), point(t[3])) == CGAL::NEGATIVE)
    std::swap(t[2], t[3]);
  return {{{t[0], t[2], t[1]}, {t[0], t[1], t[3]}, {t[1], t[2], t[3]}, {t[2], t[0], t[3]}}};
}
} // namespace

void take_border_of_tetrahedra(Polygon_soup& soup)
{
  std::vector<std::array<Corner, 4>> tetrahedra;
  for(std::array<Corner, 4> t : soup.tetrahedra)
  {
    std::sort(t.begin(), t.end());
    tetrahedra.push_back(t);
  }
  std::sort(tetrahedra.begin(), tetrahedra.end());
  tetrahedra.erase(std::unique(tetrahedra.begin(), tetrahedra.end()), tetrahedra.end()); // a repeated one counts once
  std::vector<std::array<Triangle_corners, 2>> sides;                                    // sorted, and as it is
  for(const std::array<Corner, 4>& t : tetrahedra)
    for(const Triangle_corners& side : sides_of(t, soup.points))
      sides.push_back({sorted(side), side});
  const auto is_before = [](const auto& a, const auto& b) { return a[0] < b[0]; };
  std::sort(sides.begin(), sides.end(), is_before);
  std::size_t others = 0;
  for(std::size_t i = 0; i != soup.polygons.size(); ++i)
  {
    const auto corners = soup.polygons[i];
    Triangle_corners triangle = {};
    std::copy_n(corners.begin(), std::min<std::size_t>(corners.size(), 3), triangle.begin());
    const std::array<Triangle_corners, 2> side = {sorted(triangle), triangle};
    others += corners.size() == 3 && std::binary_search(sides.begin(), sides.end(), side, is_before) ? 0 : 1;
  }
  Polygons border;
  for(std::size_t i = 0; i != sides.size(); ++i)
    if((i == 0 || sides[i - 1][0] != sides[i][0]) && (i + 1 == sides.size() || sides[i][0] != sides[i + 1][0]))
      border.add(sides[i][1]);
  const auto number = [](std::size_t n, const std::string& singular, const std::string& plural) {
    return std::to_string(n) + (n == 1 ? singular : plural);
  };
  soup.notes.push_back("the border surface of " + number(tetrahedra.size(), " tetrahedron", " tetrahedra")
                       + " is taken: " + number(border.size(), " face", " faces"));
  if(others > 0)
    soup.notes.push_back(number(others, " face of no tetrahedron is", " faces of no tetrahedron are") + " left out");
  soup.polygons = std::move(border);
  soup.copies.clear();
  soup.tetrahedra.clear();
}

} // namespace reeb_graph_program
