// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_CURVES_INTERNAL_RANKED_MESH_H
#define CGAL_REEB_GRAPH_CURVES_INTERNAL_RANKED_MESH_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Kernel/global_functions.h>
#include <CGAL/Reeb_graph/curves/exceptions.h>
#include <CGAL/Reeb_graph/internal/base/Scalar_conversion.h>
#include <CGAL/Reeb_graph/internal/base/compiled.h>
#include <CGAL/Reeb_graph/internal/base/interpolation.h>
#include <CGAL/Reeb_graph/internal/base/lengths.h>
#include <CGAL/Reeb_graph/internal/complex/Flat_mesh.h>
#include <CGAL/boost/graph/Euler_operations.h>
#include <CGAL/boost/graph/iterator.h>
#include <CGAL/boost/graph/properties.h>
#include <CGAL/number_utils.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/unordered_set.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <tuple>
#include <vector>

namespace CGAL::Reeb_graph::internal {

// A mesh that is refined, with the rank of each vertex, and its value as far as it places the points of new vertices. Ranks
// are numbers that a double holds, so that they are their own keys in graphs.
template <class Mesh_, class VertexPointMap, class Visitor>
class Ranked_mesh
{
public:
  typedef Mesh_ Mesh;
  typedef typename boost::graph_traits<Mesh>::vertex_descriptor vertex_descriptor;
  typedef typename boost::graph_traits<Mesh>::halfedge_descriptor halfedge_descriptor;
  typedef typename boost::graph_traits<Mesh>::edge_descriptor edge_descriptor;
  typedef typename boost::graph_traits<Mesh>::face_descriptor face_descriptor;
  typedef typename boost::property_map<Mesh, dynamic_vertex_property_t<double>>::type Rank_map;

  Ranked_mesh(Mesh& mesh, VertexPointMap vertex_point_map, Visitor& visitor)
    : mesh_(mesh),
      vertex_point_map_(vertex_point_map),
      visitor_(visitor),
      rank_spacing_((Long_index(1) << std::numeric_limits<double>::digits) / (num_vertices(mesh) + 1)),
      rank_map_(get(dynamic_vertex_property_t<double>(), mesh)),
      value_map_(get(dynamic_vertex_property_t<double>(), mesh))
  {}

  // Undoes all splits, the last one first, unless they are to be kept: something has been thrown. What was there before
  // them is there again, with the same descriptors.
  ~Ranked_mesh()
  {
    for(; !splits_.empty(); splits_.pop_back())
      undo(splits_.back());
  }

  Ranked_mesh(const Ranked_mesh&) = delete;
  Ranked_mesh& operator=(const Ranked_mesh&) = delete;

  Mesh& mesh() const { return mesh_; }
  Visitor& visitor() const { return visitor_; }
  Rank_map rank_map() const { return rank_map_; }
  Long_index rank(vertex_descriptor v) const { return static_cast<Long_index>(get(rank_map_, v)); }
  double value(vertex_descriptor v) const { return get(value_map_, v); }

  // Between the ranks of two vertices of the input there is room for those of the vertices that a refinement adds.
  Long_index rank_spacing() const { return rank_spacing_; }

  const VertexPointMap& vertex_point_map() const { return vertex_point_map_; }

  void place(vertex_descriptor v, Long_index rank, double value) const
  {
    put(rank_map_, v, static_cast<double>(rank));
    put(value_map_, v, value);
  }

  // The place of the value on the edge from `u` to the higher `w`: 0 at `u`, 1 at `w`, in the middle if it is unclear.
  double crossing_fraction(vertex_descriptor u, vertex_descriptor w, double value) const
  {
    return internal::crossing_fraction(this->value(u), this->value(w), value);
  }

  auto point_between(vertex_descriptor u, vertex_descriptor w, double t) const
  {
    return internal::point_between(get(vertex_point_map_, u), get(vertex_point_map_, w), t);
  }

  double distance(vertex_descriptor u, vertex_descriptor w) const
  {
    return distance_between(get(vertex_point_map_, u), get(vertex_point_map_, w));
  }

  double area(vertex_descriptor u, vertex_descriptor v, vertex_descriptor w) const
  {
    return area_of(get(vertex_point_map_, u), get(vertex_point_map_, v), get(vertex_point_map_, w));
  }

  // Splits the edge of `h` by a vertex at the fraction `t` of the way from `u` to `w`, the ends of the edge of which
  // that of `h` is a part. Returns the new halfedge that ends at it; `h` starts there then.
  halfedge_descriptor split_edge(halfedge_descriptor h, vertex_descriptor u, vertex_descriptor w, double t) const
  {
    const auto point = point_between(u, w, t);
    const Split split = {h,
                         true,
                         halfedge(source(h, mesh_), mesh_),
                         halfedge(target(h, mesh_), mesh_),
                         halfedge_of_face(h),
                         halfedge_of_face(opposite(h, mesh_))};
    const halfedge_descriptor first = remember(split, [&] { return Euler::split_edge(h, mesh_); });
    put(vertex_point_map_, target(first, mesh_), point);
    visitor_.edge_split(first, h);
    visitor_.vertex_added(target(first, mesh_), u, w, t);
    return first;
  }

  // Joins the targets of two halfedges of a face. The new face is behind `h2`. Returns the halfedge that follows `h1`.
  halfedge_descriptor split_face(halfedge_descriptor h1, halfedge_descriptor h2) const
  {
    const halfedge_descriptor of_face = halfedge_of_face(h1);
    const Split split = {h1,      false,  halfedge(target(h1, mesh_), mesh_), halfedge(target(h2, mesh_), mesh_),
                         of_face, of_face};
    const halfedge_descriptor h = remember(split, [&] { return Euler::split_face(h1, h2, mesh_); });
    if(are_splits_remembered_)
      splits_.back().halfedge = h;
    visitor_.face_split(face(h, mesh_), face(opposite(h, mesh_), mesh_));
    return h;
  }

  // The halfedges of a triangle, which may have been refined, that lead to a lowest and to a highest one of the vertices
  // that have a rank.
  template <class HasRank>
  std::array<halfedge_descriptor, 2> ends_of(face_descriptor f, const HasRank& has_rank) const
  {
    std::array<halfedge_descriptor, 2> ends = {boost::graph_traits<Mesh>::null_halfedge(),
                                               boost::graph_traits<Mesh>::null_halfedge()};
    for(const halfedge_descriptor h : halfedges_around_face(halfedge(f, mesh_), mesh_))
    {
      if(!has_rank(h))
        continue;
      const bool is_first = ends[0] == boost::graph_traits<Mesh>::null_halfedge();
      if(is_first || rank(target(h, mesh_)) < rank(target(ends[0], mesh_)))
        ends[0] = h;
      if(is_first || rank(target(h, mesh_)) > rank(target(ends[1], mesh_)))
        ends[1] = h;
    }
    return ends;
  }

  // Splits a triangle, whose edges have been split, by segments between the points on its sides; calls visit(segment),
  // with the higher side on its left. Two ways lead from its lowest to its highest corner, and each segment joins the
  // left one to the right one. Both are climbed at the same time; what is left below a segment is a polygon of up to
  // five edges.
  template <class IsPoint, class Visit>
  void split_triangle(const std::array<halfedge_descriptor, 2>& ends, const IsPoint& is_point, const Visit& visit) const
  {
    const vertex_descriptor top = target(ends[1], mesh_);
    halfedge_descriptor left = next(ends[0], mesh_), right = prev(ends[0], mesh_), segment = left;
    for(;;)
    {
      while(!is_point(left) && target(left, mesh_) != top)
        left = next(left, mesh_);
      while(!is_point(right) && target(right, mesh_) != top)
        right = prev(right, mesh_);
      if(target(left, mesh_) == top || target(right, mesh_) == top)
        break;
      segment = split_face(right, left);
      visit(segment);
      triangulate(opposite(segment, mesh_));
      left = next(segment, mesh_);
      right = prev(right, mesh_);
    }
    triangulate(segment);
  }

  // Triangulates the face of `h`, a polygon of few edges that is convex but for rounding, by the fan whose worst
  // triangle is the best one.
  void triangulate(halfedge_descriptor h) const
  {
    std::vector<halfedge_descriptor> polygon;
    for(const halfedge_descriptor g : halfedges_around_face(h, mesh_))
      polygon.push_back(g);
    if(polygon.size() < 4)
      return;
    std::size_t best_apex = 0;
    double best_quality = -1;
    for(std::size_t apex = 0; apex != polygon.size(); ++apex)
    {
      const double quality = quality_of_fan(polygon, apex);
      if(quality > best_quality)
      {
        best_quality = quality;
        best_apex = apex;
      }
    }
    const halfedge_descriptor to_apex = polygon[best_apex];
    for(std::size_t i = 3; i != polygon.size(); ++i)
      split_face(next(next(to_apex, mesh_), mesh_), to_apex);
  }

  // The splits so far and those to come are not undone.
  void keep_splits() const
  {
    are_splits_remembered_ = false;
    splits_ = std::vector<Split>();
  }

private:
  // A split of the edge of a halfedge, or of a face by a new one, and the halfedges that were those of its ends, and of
  // the faces on both sides.
  struct Split
  {
    halfedge_descriptor halfedge;
    bool is_of_edge;
    halfedge_descriptor of_source, of_target, of_face, of_opposite_face;
  };

  // Calls a function that splits. A split that fails is not remembered, and one that cannot be remembered is not done.
  template <class Function>
  halfedge_descriptor remember(const Split& split, const Function& function) const
  {
    if(!are_splits_remembered_)
      return function();
    splits_.push_back(split);
    try
    {
      return function();
    }
    catch(...)
    {
      splits_.pop_back();
      throw;
    }
  }

  halfedge_descriptor halfedge_of_face(halfedge_descriptor h) const
  {
    return is_border(h, mesh_) ? h : halfedge(face(h, mesh_), mesh_);
  }

  void restore_face(face_descriptor f, halfedge_descriptor h) const
  {
    if(f != boost::graph_traits<Mesh>::null_face())
      set_halfedge(f, h, mesh_);
  }

  void undo(const Split& split) const
  {
    const halfedge_descriptor h = split.halfedge;
    if(split.is_of_edge)
      Euler::join_vertex(opposite(prev(h, mesh_), mesh_), mesh_);
    const vertex_descriptor u = source(h, mesh_), w = target(h, mesh_);
    const face_descriptor f = face(h, mesh_), g = split.is_of_edge ? face(opposite(h, mesh_), mesh_) : f;
    if(!split.is_of_edge)
      Euler::join_face(h, mesh_);
    set_halfedge(u, split.of_source, mesh_);
    set_halfedge(w, split.of_target, mesh_);
    restore_face(f, split.of_face);
    restore_face(g, split.of_opposite_face);
  }

  double quality_of_fan(const std::vector<halfedge_descriptor>& polygon, std::size_t apex) const
  {
    const auto corner = [&](std::size_t i) { return target(polygon[(apex + i) % polygon.size()], mesh_); };
    double quality = (std::numeric_limits<double>::max)();
    for(std::size_t i = 1; i + 1 != polygon.size(); ++i)
      quality = (std::min)(quality, quality_of_triangle(corner(0), corner(i), corner(i + 1)));
    return quality;
  }

  // The quality is positive for a triangle that is not degenerate, and the highest for an equilateral one.
  double quality_of_triangle(vertex_descriptor u, vertex_descriptor v, vertex_descriptor w) const
  {
    const auto& p = get(vertex_point_map_, u);
    const auto uv = get(vertex_point_map_, v) - p, uw = get(vertex_point_map_, w) - p;
    const double lengths = CGAL::to_double(uv.squared_length() + uw.squared_length() + (uw - uv).squared_length());
    return lengths > 0 ? area(u, v, w) / lengths : 0;
  }

  Mesh& mesh_;
  VertexPointMap vertex_point_map_;
  Visitor& visitor_;
  const Long_index rank_spacing_;
  Rank_map rank_map_, value_map_;
  mutable bool are_splits_remembered_ = true;
  mutable std::vector<Split> splits_;
};

// A border component all of whose vertices have one value, which no neighbor is below, or none is above.
template <class VertexDescriptor>
struct Level_border
{
  std::vector<VertexDescriptor> vertices;
  bool is_minimum = true;
  std::size_t group = 0; // number of the group of borders at one level on one side
};

// All border components of a mesh, each of which is an extremum of the field.
template <class Mesh>
struct Level_borders
{
  typedef typename boost::graph_traits<Mesh>::vertex_descriptor vertex_descriptor;
  typedef typename boost::property_map<Mesh, dynamic_vertex_property_t<std::size_t>>::type Number_map;

  explicit Level_borders(Mesh& mesh) : number_map(get(dynamic_vertex_property_t<std::size_t>(), mesh)) {}

  bool is_on_border(vertex_descriptor v) const { return get(number_map, v) != 0; }
  const Level_border<vertex_descriptor>& border_of(vertex_descriptor v) const
  {
    return borders[get(number_map, v) - 1];
  }

  std::vector<Level_border<vertex_descriptor>> borders;
  Number_map number_map;              // number of the border of a vertex plus one, 0 if it is on none
  std::vector<Long_index> last_ranks; // rank nearest to those of the other vertices, by group
};

// Finds out on which side of the field the border is. Throws if it is on none.
template <class Mesh, class ScalarMap, class Less>
void check_level_border(const Mesh& mesh,
                        const ScalarMap& scalar_map,
                        const Less& less,
                        std::size_t first_vertex,
                        Level_border<typename boost::graph_traits<Mesh>::vertex_descriptor>& border)
{
  const auto value = get(scalar_map, border.vertices.front());
  bool has_lower = false, has_higher = false;
  for(const auto v : border.vertices)
  {
    const auto value_of_vertex = get(scalar_map, v);
    if(less(value, value_of_vertex) || less(value_of_vertex, value))
      throw Border_level_error(first_vertex, Border_level_error::Reason::SEVERAL_VALUES);
    for(const auto h : halfedges_around_target(v, mesh))
    {
      const auto value_of_neighbor = get(scalar_map, source(h, mesh));
      has_lower = has_lower || less(value_of_neighbor, value);
      has_higher = has_higher || less(value, value_of_neighbor);
    }
  }
  if(has_lower && has_higher)
    throw Border_level_error(first_vertex, Border_level_error::Reason::NOT_EXTREMAL);
  border.is_minimum = !has_lower;
}

// Finds the border components, in the order of their first vertices in vertices(mesh).
template <class Mesh, class ScalarMap, class Less>
Level_borders<Mesh> find_level_borders(Mesh& mesh, const ScalarMap& scalar_map, const Less& less)
{
  Level_borders<Mesh> result(mesh);
  for(const auto v : vertices(mesh))
    put(result.number_map, v, 0);
  for(const auto& cycle : find_border_cycles(mesh))
  {
    result.borders.emplace_back();
    for(const auto v : vertices_around_face(cycle.halfedge, mesh))
    {
      result.borders.back().vertices.push_back(v);
      put(result.number_map, v, result.borders.size());
    }
    check_level_border(mesh, scalar_map, less, cycle.first_vertex, result.borders.back());
  }
  return result;
}

// Splits all edges between two vertices of borders that lie at one level on the same side, so that each border is
// strictly lower or strictly higher than all its other neighbors.
template <class RankedMesh>
void split_chords(const RankedMesh& ranked, Level_borders<typename RankedMesh::Mesh>& borders)
{
  typedef typename RankedMesh::halfedge_descriptor halfedge_descriptor;
  auto& mesh = ranked.mesh();
  std::vector<halfedge_descriptor> chords;
  boost::unordered_set<typename RankedMesh::edge_descriptor> listed;
  for(const auto& border : borders.borders)
    for(const auto v : border.vertices)
      for(const halfedge_descriptor h : halfedges_around_target(v, mesh))
      {
        const auto u = source(h, mesh);
        const bool is_chord = borders.is_on_border(u) && borders.border_of(u).group == border.group
                           && !is_border(h, mesh) && !is_border(opposite(h, mesh), mesh);
        if(is_chord && listed.insert(edge(h, mesh)).second)
          chords.push_back(h);
      }
  const Long_index step = ranked.rank_spacing() / 2 / (chords.size() + 1);
  for(const halfedge_descriptor h : chords)
  {
    const auto u = source(h, mesh), w = target(h, mesh);
    const auto& border = borders.border_of(u);
    Long_index& rank = borders.last_ranks[border.group];
    rank += border.is_minimum ? step : Long_index(0) - step;
    const halfedge_descriptor first = ranked.split_edge(h, u, w, 0.5);
    ranked.place(target(first, mesh), rank, ranked.value(u));
    ranked.split_face(first, next(h, mesh));
    ranked.split_face(opposite(h, mesh), next(opposite(first, mesh), mesh));
  }
}

// The place of a vertex in the order: by value, then by side, then by position. The side is -1 for vertices of a border
// that is a minimum, 1 for those of one that is a maximum, and 0 else. All vertices of such a border have one position.
template <class RankedMesh, class Scalar>
struct Vertex_key
{
  Scalar value;
  int side;
  std::size_t position;
  typename RankedMesh::vertex_descriptor vertex;
};

template <class RankedMesh, class ScalarMap, class Traits>
auto sorted_vertex_keys(const RankedMesh& ranked,
                        const ScalarMap& scalar_map,
                        const Traits& traits,
                        const Level_borders<typename RankedMesh::Mesh>* borders)
{
  typedef Vertex_key<RankedMesh, typename Traits::Scalar> Key;
  std::vector<Key> keys;
  for(const auto v : vertices(ranked.mesh()))
  {
    const bool is_on_border = borders && borders->is_on_border(v);
    const int side = !is_on_border ? 0 : borders->border_of(v).is_minimum ? -1 : 1;
    const std::size_t position = is_on_border ? get(borders->number_map, v) : keys.size();
    keys.push_back({get(scalar_map, v), side, position, v});
  }
  const auto less = traits.less_scalar_object();
  std::stable_sort(keys.begin(), keys.end(), [&](const Key& a, const Key& b) {
    if(less(a.value, b.value))
      return true;
    return !less(b.value, a.value) && std::tie(a.side, a.position) < std::tie(b.side, b.position);
  });
  return keys;
}

// Gives each vertex the rank of its place in the total order, but, if there are `borders`, all vertices of a border
// component one rank, beyond all other vertices of their value.
template <class RankedMesh, class ScalarMap, class Traits>
void rank_vertices(const RankedMesh& ranked,
                   const ScalarMap& scalar_map,
                   const Traits& traits,
                   Level_borders<typename RankedMesh::Mesh>* borders = nullptr)
{
  const Scalar_conversion<Traits> conversion(traits);
  const auto less = traits.less_scalar_object();
  const auto keys = sorted_vertex_keys(ranked, scalar_map, traits, borders);
  Long_index rank = 0;
  for(std::size_t i = 0; i != keys.size(); ++i)
  {
    const bool is_same_side =
      i != 0 && keys[i].side != 0 && keys[i].side == keys[i - 1].side && !less(keys[i - 1].value, keys[i].value);
    const bool is_same_border = is_same_side && keys[i].position == keys[i - 1].position;
    if(!is_same_border)
      rank += ranked.rank_spacing();
    ranked.place(keys[i].vertex, rank, conversion.to_double(keys[i].value));
    if(keys[i].side == 0 || is_same_border)
      continue;
    if(!is_same_side)
      borders->last_ranks.push_back(rank); // where a group of maxima begins
    if(keys[i].side < 0)
      borders->last_ranks.back() = rank; // where a group of minima ends
    borders->borders[keys[i].position - 1].group = borders->last_ranks.size() - 1;
  }
}

} // namespace CGAL::Reeb_graph::internal

#endif // CGAL_REEB_GRAPH_CURVES_INTERNAL_RANKED_MESH_H
