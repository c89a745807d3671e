// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_INTERNAL_COMPLEX_WEIGHTED_GRAPH_H
#define CGAL_REEB_GRAPH_INTERNAL_COMPLEX_WEIGHTED_GRAPH_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/internal/base/Index.h>

#include <CGAL/Iterator_range.h>
#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/properties.h>

#include <boost/graph/graph_traits.hpp>

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <unordered_map>
#include <unordered_set>
#include <utility>
#include <vector>

namespace CGAL::Reeb_graph::internal {

// The vertices and edges of a surface, numbered from 0 on (for fields by position in vertices(mesh)), with a weight for each
// edge at each of its ends, in compressed rows. The neighbors
// of a vertex are sorted.
class Weighted_graph
{
public:
  struct Neighbor
  {
    Index vertex;
    double weight;
  };
  struct Contribution
  {
    Index from, to;
    double weight;
  };

  // `visit_contributions(visit)` calls `visit(contribution)` for parts of the weights, in any order, the same each
  // time. They are added up.
  template <class VisitContributions>
  Weighted_graph(std::size_t number_of_vertices, const VisitContributions& visit_contributions)
    : first_(number_of_vertices + 1, 0)
  {
    visit_contributions([&](const Contribution& c) { ++first_[c.from + 1]; });
    std::partial_sum(first_.begin(), first_.end(), first_.begin());
    neighbors_.resize(first_.back());
    std::vector<std::size_t> next(first_.begin(), first_.end() - 1);
    visit_contributions([&](const Contribution& c) { neighbors_[next[c.from]++] = {c.to, c.weight}; });
    add_up();
  }

  Index number_of_vertices() const { return static_cast<Index>(first_.size() - 1); }

  Iterator_range<const Neighbor*> neighbors(Index v) const
  {
    return {neighbors_.data() + first_[v], neighbors_.data() + first_[v + 1]};
  }

  double weight(Index from, Index to) const
  {
    const auto range = neighbors(from);
    return std::lower_bound(range.begin(), range.end(), to, [](const Neighbor& n, Index v) { return n.vertex < v; })
      ->weight;
  }

private:
  void add_up()
  {
    std::size_t end = 0, begin = 0;
    for(std::size_t v = 0; v + 1 != first_.size(); ++v)
    {
      const std::size_t old_begin = begin, old_end = first_[v + 1];
      std::sort(neighbors_.data() + old_begin, neighbors_.data() + old_end,
                [](const Neighbor& a, const Neighbor& b) { return a.vertex < b.vertex; });
      first_[v] = end;
      for(begin = old_begin; begin != old_end; ++begin)
        if(end != first_[v] && neighbors_[end - 1].vertex == neighbors_[begin].vertex)
          neighbors_[end - 1].weight += neighbors_[begin].weight;
        else
          neighbors_[end++] = neighbors_[begin];
    }
    first_.back() = end;
    neighbors_.resize(end);
    neighbors_.shrink_to_fit();
  }

  std::vector<std::size_t> first_;
  std::vector<Neighbor> neighbors_;
};

// The edges of a complex, with the weight 1, for what needs neither faces nor points.
template <class Complex>
Weighted_graph edge_graph(const Complex& complex)
{
  return Weighted_graph(complex.number_of_vertices(), [&](const auto& visit) {
    for(const Edge_index e : Index_range<Edge_index>(complex.number_of_edges()))
    {
      if(!complex.is_on_triangle(e))
        continue;
      const Index u = complex.source(even_halfedge(e)).number(), v = complex.target(even_halfedge(e)).number();
      visit(Weighted_graph::Contribution{u, v, 1});
      visit(Weighted_graph::Contribution{v, u, 1});
    }
  });
}

// The vertices in the order of a breadth-first search, which keeps neighbors close to each other in memory, and by
// vertex the number of its connected component, in the order of their first vertices.
struct Breadth_first_search
{
  std::vector<Index> order;
  std::vector<Index> components;

  explicit Breadth_first_search(const Weighted_graph& graph) : components(graph.number_of_vertices(), no_index)
  {
    order.reserve(graph.number_of_vertices());
    Index component = 0;
    std::size_t next = 0;
    const auto reach = [&](Index v) {
      if(components[v] != no_index)
        return;
      order.push_back(v);
      components[v] = component;
    };
    for(Index first = 0; first != graph.number_of_vertices(); ++first)
    {
      for(reach(first); next != order.size(); ++next)
        for(const auto& n : graph.neighbors(order[next]))
          reach(n.vertex);
      component = components[order.back()] + 1;
    }
  }
};

inline std::vector<Index> label_components(const Weighted_graph& graph)
{
  return Breadth_first_search(graph).components;
}

// Orders the vertices of a connected part of a graph so that each has a lower and a higher neighbor, where the
// neighbors outside of the part count as one vertex below it, the source, or as one above it, the sink. That is the
// st-numbering of R. E. Tarjan, Two Streamlined Depth-First Search Algorithms, 1986, for a graph that stays connected
// without any one vertex if source and sink are joined. The time is linear in the size of the part.
class St_numbering
{
public:
  explicit St_numbering(const Weighted_graph& graph) : graph_(graph), records_(graph.number_of_vertices()) {}

  // The order of `part`. `is_in_part` tells its vertices from the other ones, and `is_source` tells which of these
  // belong to the source.
  template <class IsInPart, class IsSource>
  std::vector<Index> operator()(const std::vector<Index>& part, const IsInPart& is_in_part, const IsSource& is_source)
  {
    const auto is_sink = [&](const auto& n) { return !is_in_part(n.vertex) && !is_source(n.vertex); };
    const Index root = *std::find_if(part.begin(), part.end(), [&](Index v) {
      const auto neighbors = graph_.neighbors(v);
      return std::any_of(neighbors.begin(), neighbors.end(), is_sink);
    });
    for(const Index v : part) // It may have been in another part before.
      records_[v].preorder = no_index;
    search(root, is_in_part, is_source);
    return list(root);
  }

private:
  // The number of a vertex in preorder; those of the source and the sink are 0 and 1.
  typedef Index Preorder;
  static constexpr Preorder source = 0, sink = 1;

  struct Record
  {
    Preorder preorder = no_index;
    Preorder low; // lowest number that is joined to a vertex of the subtree, or in it
    Preorder parent;
    Index next_edge;
  };

  template <class IsInPart, class IsSource>
  void search(Index root, const IsInPart& is_in_part, const IsSource& is_source)
  {
    preordered_ = {no_index, no_index};
    std::vector<Index> path;
    const auto enter = [&](Index v, Preorder parent) {
      const auto preorder = static_cast<Preorder>(preordered_.size());
      records_[v] = {preorder, preorder, parent, 0};
      preordered_.push_back(v);
      path.push_back(v);
    };
    enter(root, sink);
    while(!path.empty())
    {
      const Index v = path.back();
      Record& record = records_[v];
      const auto neighbors = graph_.neighbors(v);
      if(record.next_edge == neighbors.size())
      {
        path.pop_back();
        if(!path.empty())
          records_[path.back()].low = (std::min)(records_[path.back()].low, record.low);
        continue;
      }
      const Index u = (neighbors.begin() + record.next_edge++)->vertex;
      if(!is_in_part(u))
        record.low = (std::min)(record.low, is_source(u) ? source : sink);
      else if(records_[u].preorder == no_index)
        enter(u, record.preorder);
      else
        record.low = (std::min)(record.low, records_[u].preorder);
    }
  }

  // Inserts the vertices in preorder into a list from the source to the sink, before or behind their parents.
  std::vector<Index> list(Index root)
  {
    const std::size_t size = preordered_.size();
    std::vector<Preorder> next(size), previous(size);
    std::vector<bool> is_plus(size, false);
    next[source] = sink;
    previous[sink] = source;
    for(Preorder i = records_[root].preorder; i != size; ++i)
    {
      const Record& record = records_[preordered_[i]];
      const bool is_behind_parent = is_plus[record.low];
      const Preorder before = is_behind_parent ? record.parent : previous[record.parent];
      const Preorder behind = is_behind_parent ? next[record.parent] : record.parent;
      is_plus[record.parent] = !is_behind_parent;
      next[before] = i;
      previous[i] = before;
      next[i] = behind;
      previous[behind] = i;
    }
    std::vector<Index> result;
    result.reserve(size - 2);
    for(Preorder i = next[source]; i != sink; i = next[i])
      result.push_back(preordered_[i]);
    return result;
  }

  const Weighted_graph& graph_;
  std::vector<Record> records_;
  std::vector<Index> preordered_;
};

// The visitor that an opening calls: `on_vertex` comes before the visitor of the user.
template <class OnVertex, class Visitor>
struct Opening_visitor
{
  OnVertex on_vertex;
  Visitor& visitor;

  template <class VertexDescriptor>
  void vertex_duplicated(VertexDescriptor old, VertexDescriptor created)
  {
    on_vertex(old, created);
    visitor.vertex_duplicated(old, created);
  }
  template <class HalfedgeDescriptor>
  void halfedge_duplicated(HalfedgeDescriptor old, HalfedgeDescriptor created)
  {
    visitor.halfedge_duplicated(old, created);
  }
};

// Parts a mesh along curves, which may branch, and end anywhere. The left side of a curve keeps the halfedges, which
// become border, and the vertices; the other side gets copies of both. Of several fans on the left of curves, the first
// one keeps a vertex. Edges of the border stay as they are, and so does an edge that is a curve by itself and ends at no
// other one and at no border: its two copies would have the same ends.
template <class Mesh, class VertexPointMap, class Visitor>
class Curve_opening
{
  typedef boost::graph_traits<Mesh> Graph_traits;
  typedef typename Graph_traits::vertex_descriptor vertex_descriptor;
  typedef typename Graph_traits::halfedge_descriptor halfedge_descriptor;

public:
  Curve_opening(Mesh& mesh, const VertexPointMap& vertex_point_map, Visitor& visitor)
    : mesh_(mesh),
      vertex_point_map_(vertex_point_map),
      visitor_(visitor)
  {}

  // Opens one curve, which has the members `halfedges` and `lower_halfedges` of a `Reeb_graph::Curve`. One call is
  // allowed.
  template <class Curve>
  void operator()(Curve& curve)
  {
    std::vector<Curve> curves;
    curves.push_back(std::move(curve));
    (*this)(curves);
    curve = std::move(curves.front());
  }

  template <class Curve>
  void operator()(std::vector<Curve>& curves)
  {
    count_edges(curves);
    for(Curve& curve : curves)
    {
      first_added_.push_back(added_.size());
      if(!is_alone(curve))
        add_edges(curve);
    }
    first_added_.push_back(added_.size());
    for(const auto* borders : {&kept_, &added_})
      for(const halfedge_descriptor h : *borders)
        link(h);
    part_fans(kept_, 0, kept_.size());
    for(std::size_t i = 0; i != curves.size(); ++i)
      part_fans(added_, first_added_[i], first_added_[i + 1]);
  }

private:
  // Counts the edges of curves at each of their vertices.
  template <class Curves>
  void count_edges(const Curves& curves)
  {
    for(const auto& curve : curves)
      for(const halfedge_descriptor h : curve.halfedges)
        for(const vertex_descriptor v : {source(h, mesh_), target(h, mesh_)})
          ++number_of_edges_[v];
  }

  template <class Curve>
  bool is_alone(const Curve& curve) const
  {
    const halfedge_descriptor h = curve.halfedges.front();
    const auto is_end = [&](vertex_descriptor v) { return number_of_edges_.at(v) == 1 && !is_border(v, mesh_); };
    return curve.halfedges.size() == 1 && is_end(source(h, mesh_)) && is_end(target(h, mesh_));
  }

  // Gives the faces on the right of the curve new edges in the place of those of the curve.
  template <class Curve>
  void add_edges(Curve& curve)
  {
    for(std::size_t i = 0; i != curve.halfedges.size(); ++i)
    {
      const halfedge_descriptor old = opposite(curve.halfedges[i], mesh_);
      if(is_border(edge(old, mesh_), mesh_))
        continue;
      const halfedge_descriptor inner = halfedge(add_edge(mesh_), mesh_), outer = opposite(inner, mesh_);
      kept_.push_back(old);
      added_.push_back(outer);
      set_target(inner, target(old, mesh_), mesh_);
      set_target(outer, source(old, mesh_), mesh_);
      set_next(prev(old, mesh_), inner, mesh_);
      set_next(inner, next(old, mesh_), mesh_);
      set_face(inner, face(old, mesh_), mesh_);
      if(halfedge(face(old, mesh_), mesh_) == old) // so that faces begin where they did
        set_halfedge(face(old, mesh_), inner, mesh_);
      set_face(old, Graph_traits::null_face(), mesh_);
      set_face(outer, Graph_traits::null_face(), mesh_);
      curve.lower_halfedges[i] = inner;
      visitor_.halfedge_duplicated(old, inner);
    }
  }

  // Links a border halfedge with those before and behind it, on the other sides of the fans of faces at its ends.
  void link(halfedge_descriptor border)
  {
    halfedge_descriptor following = opposite(border, mesh_), preceding = following;
    while(!is_border(following, mesh_))
      following = opposite(prev(following, mesh_), mesh_);
    while(!is_border(preceding, mesh_))
      preceding = opposite(next(preceding, mesh_), mesh_);
    set_next(border, following, mesh_);
    set_next(preceding, border, mesh_);
  }

  // Gives a vertex to each fan at some of the halfedges that have become border.
  void part_fans(const std::vector<halfedge_descriptor>& borders, std::size_t begin, std::size_t end)
  {
    for(std::size_t i = begin; i != end; ++i)
      part_fan(borders[i]);
    for(std::size_t i = begin; i != end; ++i)
      part_fan(prev(borders[i], mesh_));
  }

  // The fan is the one that the border enters: the first one keeps the vertex.
  void part_fan(halfedge_descriptor border)
  {
    if(!done_fans_.insert(border).second)
      return;
    const vertex_descriptor old = target(border, mesh_);
    if(kept_vertices_.insert(old).second)
    {
      set_halfedge(old, border, mesh_);
      return;
    }
    const vertex_descriptor created = add_vertex(mesh_);
    const auto point = get(vertex_point_map_, old);
    put(vertex_point_map_, created, point);
    set_halfedge(created, border, mesh_);
    halfedge_descriptor h = border;
    do
    {
      set_target(h, created, mesh_);
      h = opposite(next(h, mesh_), mesh_);
    } while(h != border);
    visitor_.vertex_duplicated(old, created);
  }

  Mesh& mesh_;
  const VertexPointMap& vertex_point_map_;
  Visitor& visitor_;
  std::unordered_map<vertex_descriptor, std::size_t> number_of_edges_; // of curves
  std::unordered_set<vertex_descriptor> kept_vertices_;                // by a fan
  std::unordered_set<halfedge_descriptor> done_fans_;                  // by the border that enters the fan
  std::vector<halfedge_descriptor> kept_, added_; // border halfedges on the left and on the right of the curves
  std::vector<std::size_t> first_added_;          // positions in `added_`, by curve, and one more
};

} // namespace CGAL::Reeb_graph::internal

#endif // CGAL_REEB_GRAPH_INTERNAL_COMPLEX_WEIGHTED_GRAPH_H
