// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_INTERNAL_ENGINE_LOOPS_OF_COMPLEXES_H
#define CGAL_REEB_GRAPH_INTERNAL_ENGINE_LOOPS_OF_COMPLEXES_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/internal/base/Offline_connectivity.h>
#include <CGAL/Reeb_graph/internal/complex/Components_of_complex.h>
#include <CGAL/Reeb_graph/internal/engine/cut_loops.h>
#include <CGAL/Reeb_graph/internal/engine/stages_of_complexes.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL::Reeb_graph::internal {

// Searches contours of one level of a complex, a triangle by turns. Edges keep the name of the search that has found
// them, so no search has to forget anything.
class Contour_search : public Contours_by_turns<Contour_search>
{
public:
  explicit Contour_search(const Simplicial_complex& complex)
    : complex_(complex),
      searches_(complex.number_of_edges(), 0)
  {}

  template <class IsBelow>
  void begin(const Plain_vector<Halfedge_index>& starts, const IsBelow& is_below)
  {
    first_search_ += static_cast<Index>(pending_.size());
    pending_.assign(starts.size(), {});
    for(std::size_t i = 0; i != starts.size(); ++i)
      reach(i, edge_of(starts[i]), is_below);
  }

  // Looks at one triangle, if there is one left.
  template <class IsBelow>
  bool go_on(std::size_t i, const IsBelow& is_below)
  {
    Plain_vector<Pending_edge>& pending = pending_[i];
    while(!pending.empty() && pending.back().number_of_triangles == complex_.triangles_of(pending.back().edge).size())
      pending.pop_back();
    if(pending.empty())
      return false;
    const Edge_index edge = pending.back().edge;
    const Triangle_index triangle = complex_.triangles_of(edge).begin()[pending.back().number_of_triangles++];
    reach(i, crossed_edge_beside(complex_, edge, triangle, is_below), is_below);
    return true;
  }

  bool is_border_reached(std::size_t) const { return false; } // Where a complex has its border is not asked.

private:
  // An edge that has been found, and how many of its triangles have been looked at.
  struct Pending_edge
  {
    Edge_index edge;
    Index number_of_triangles;
  };

  // An edge belongs to a contour now. If it does already, and to another one, these two are one.
  template <class IsBelow>
  void reach(std::size_t i, Edge_index edge, const IsBelow& is_below)
  {
    if(searches_[edge] < first_search_)
    {
      searches_[edge] = first_search_ + static_cast<Index>(i);
      const Halfedge_index even = even_halfedge(edge);
      crossed_edges_[i].push_back(is_below(complex_.source(even)) ? even : opposite_of(even));
      pending_[i].push_back({edge, 0});
      return;
    }
    const std::size_t other = leader(searches_[edge] - first_search_);
    if(other != i)
      join(i, other);
  }

  void join(std::size_t i, std::size_t other)
  {
    const bool is_smaller = crossed_edges_[i].size() < crossed_edges_[other].size();
    const std::size_t large = is_smaller ? other : i, small = is_smaller ? i : other;
    crossed_edges_[large].append(crossed_edges_[small].begin(), crossed_edges_[small].end());
    pending_[large].append(pending_[small].begin(), pending_[small].end());
    pending_[small] = {};
    close(small, large);
  }

  const Simplicial_complex& complex_;
  Indexed_vector<Edge_index, Index> searches_; // the number of the start from which the edge has been found
  Index first_search_ = 1;
  std::vector<Plain_vector<Pending_edge>> pending_;
};

// The links of the level sets, by the times of the vertices: an edge crosses the levels from the time of its lower end
// to that of its higher end. A triangle whose edges cross none of the levels has no link.
inline Plain_vector<Timed_link> find_links(const Simplicial_complex& complex,
                                           const Indexed_vector<Vertex_index, Index>& times)
{
  Plain_vector<Timed_link> links;
  for(const Triangle_index triangle : complex.triangles())
  {
    const std::array<Vertex_index, 3>& v = complex.vertices_of(triangle);
    const std::array<Index, 3> time = {times[v[0]], times[v[1]], times[v[2]]};
    if(time[0] == time[1] && time[1] == time[2])
      continue;
    std::array<std::size_t, 3> places = {0, 1, 2};
    std::sort(places.begin(), places.end(), [&](std::size_t i, std::size_t j) { return time[i] < time[j]; });
    // Edges are in the order of the vertices that they do not have, from the last one.
    const auto edge_opposite = [&](std::size_t i) {
      return Graph_node(complex.edges_of(triangle)[2 - places[i]].number());
    };
    const Index low = time[places[0]], middle = time[places[1]], high = time[places[2]];
    if(low != middle)
      links.push_back({edge_opposite(1), edge_opposite(2), low, middle});
    if(middle != high)
      links.push_back({edge_opposite(1), edge_opposite(0), middle, high});
  }
  return links;
}

// Finds which lower sectors of vertices, which have to ascend, are in one contour just below their vertex. The level
// sets are a graph that changes while the level rises: its nodes are the edges that cross the level, and a triangle
// joins two of them, first those at its lowest vertex, and above its middle vertex those at its highest one. (S. Parsa,
// A deterministic O(m log m) time algorithm for the Reeb graph, 2013, where links are replaced one by one.)
//
// Sets by lower sector of the vertices: the name of its contour, among those of its vertex. Components of the complex in
// which none of the vertices in question is can be left out: is_left_out(vertex). Returns how many links have been
// looked at.
template <class IsLeftOut>
std::size_t find_contours_of_sectors(const Simplicial_complex& complex,
                                     const Vertex_order& order,
                                     const Swept_vertices& critical_vertices,
                                     const Plain_vector<Swept_index>& vertices,
                                     const IsLeftOut& is_left_out,
                                     Indexed_vector<Sector_index, Index>& contours)
{
  if(vertices.empty())
    return 0;
  // The time of a vertex is how many of the vertices in question are not higher. What is left out stays at time 0.
  Indexed_vector<Vertex_index, Index> times(complex.number_of_vertices(), 0);
  for(const Vertex_index v : complex.vertices())
  {
    if(is_left_out(v))
      continue;
    const auto is_not_higher = [&](Swept_index i) { return !order(v, critical_vertices.vertex(i)); };
    times[v] =
      static_cast<Index>(std::partition_point(vertices.begin(), vertices.end(), is_not_higher) - vertices.begin());
  }
  Plain_vector<Graph_node> questions;
  Plain_vector<Index> first_questions = {0};
  for(const Swept_index i : vertices)
  {
    for(const Sector_index sector : critical_vertices.sectors(i, Side::LOWER))
      questions.push_back(Graph_node(edge_of(critical_vertices.sector(Side::LOWER, sector).edge).number()));
    first_questions.push_back(static_cast<Index>(questions.size()));
  }
  Offline_connectivity connectivity(std::move(questions), first_questions);
  const Plain_vector<Graph_node> components = connectivity(complex.number_of_edges(), find_links(complex, times));
  auto component = components.begin();
  for(const Swept_index i : vertices)
    for(const Sector_index sector : critical_vertices.sectors(i, Side::LOWER))
      contours[sector] = (component++)->number();
  return connectivity.number_of_steps();
}

// The loop surgery of a complex that may be no surface. It is found for all vertices at once which of the lower sectors in
// one sublevel component are in one contour, but where counting excludes loops. Each contour that is cut closes a loop of
// the graph, so there are at most as many cuts as the first Betti number of the complex.
template <>
class Loop_surgery<Simplicial_complex> : public Lower_contours<Simplicial_complex, Contour_search>
{
public:
  Loop_surgery(const Slab<Simplicial_complex>& slab,
               const Vertex_order& order,
               const Merge_tree& join_tree,
               const Merge_tree& split_tree)
    : Lower_contours(slab, order, join_tree, split_tree),
      last_vertices_at_edges_(complex_.number_of_edges(), 0)
  {
    contours_.assign(critical_vertices_.total_number_of_sectors(Side::LOWER), no_index);
    const auto& shared = join_tree.is_class_shared;
    const auto number_of_shared = std::count(shared.begin(), shared.end(), true);
    // To look at each triangle once pays if otherwise most would be looked at several times.
    if(static_cast<std::size_t>(number_of_shared) > complex_.number_of_vertices() / 1024)
      components_.emplace(complex_);
    find_contours([&](Vertex_index v) { return is_simply_connected(v) || is_closed(v); });
  }

  bool can_close_loop(Swept_index critical)
  {
    if(!join_tree_.is_class_shared[critical])
      return false;
    const Vertex_index vertex = critical_vertices_.vertex(critical);
    if(is_simply_connected(vertex) || (is_closed(vertex) && !can_close_loop_of_curves(critical)))
      return false;
    sort_contours(critical);
    return contours_of_vertex_.size() > count_classes(critical, Side::LOWER);
  }

  template <class Visit>
  void visit_loop_contours(Swept_index critical, const Visit& visit)
  {
    Lower_contours::visit_loop_contours(critical, visit);
    find_contours_if_steps_are_lost();
  }

private:
  bool is_simply_connected(Vertex_index vertex) const
  {
    return components_ && components_->is_simply_connected(vertex);
  }
  bool is_closed(Vertex_index vertex) const { return components_ && components_->is_closed(vertex); }

  // Finds the contours of all vertices in question, those in components that are left out excepted.
  template <class IsLeftOut>
  void find_contours(const IsLeftOut& is_left_out)
  {
    Plain_vector<Swept_index> vertices;
    for(const Swept_index i : critical_vertices_.ascending())
    {
      if(join_tree_.is_class_shared[i] && !is_left_out(critical_vertices_.vertex(i)))
        vertices.push_back(i);
    }
    find_contours_of_sectors(complex_, order_, critical_vertices_, vertices, is_left_out, contours_);
  }

  // On closed components, searches that close no loop are rare but where contours pass one-sided saddles twice: there,
  // they could take quadratic time.
  void find_contours_if_steps_are_lost()
  {
    if(are_all_found_ || number_of_lost_steps_ <= complex_.number_of_triangles())
      return;
    find_contours([&](Vertex_index v) { return is_simply_connected(v) || !is_closed(v); });
    are_all_found_ = true;
  }

  // Whether two lower contours at the vertex might be in one sublevel component, where contours are closed curves. The
  // fans around the vertex are disks in a surface between two levels, whose Euler characteristic is at most 2 less the
  // number of its borders: so a fan with l lower sectors and as many upper ones passes at most l + 1 contours, one with
  // a single sector passes one.
  bool can_close_loop_of_curves(Swept_index critical)
  {
    return largest_number_of_contours(critical_vertices_.vertex(critical))
         > count_classes(critical, Side::LOWER) + count_classes(critical, Side::UPPER);
  }

  // How many contours can be just below and just above the vertex, by its fans.
  Index largest_number_of_contours(Vertex_index vertex)
  {
    Index result = 0;
    complex_.for_each_edge_around(vertex, [&](Vertex_index, Halfedge_index halfedge) {
      if(last_vertices_at_edges_[edge_of(halfedge)] != vertex.number() + 1)
        result += count_changes_around(vertex, edge_of(halfedge)) / 2 + 1;
    });
    return result;
  }

  // How often lower and higher neighbors change in the fan of an edge at the vertex.
  Index count_changes_around(Vertex_index vertex, Edge_index first)
  {
    const auto is_upper = [&](Edge_index edge) {
      const Vertex_index low = complex_.lower_end(edge);
      return order_(vertex, low == vertex ? complex_.higher_end(edge) : low);
    };
    Index changes = 0;
    Edge_index edge = first;
    Triangle_index triangle = *complex_.triangles_of(first).begin();
    do
    {
      last_vertices_at_edges_[edge] = vertex.number() + 1;
      const std::array<Edge_index, 3>& edges = complex_.edges_of(triangle);
      const auto is_next = [&](Edge_index e) {
        return e != edge && (complex_.lower_end(e) == vertex || complex_.higher_end(e) == vertex);
      };
      const Edge_index next = *std::find_if(edges.begin(), edges.end(), is_next);
      changes += is_upper(edge) != is_upper(next) ? 1 : 0;
      const auto triangles = complex_.triangles_of(next);
      triangle = *triangles.begin() == triangle ? triangles.begin()[1] : *triangles.begin();
      edge = next;
    } while(edge != first);
    return changes;
  }

  std::optional<Components_of_complex> components_;          // if there are many vertices to ask about
  Indexed_vector<Edge_index, Index> last_vertices_at_edges_; // whose fans have been turned around; from 1 on
  bool are_all_found_ = false;
};

} // namespace CGAL::Reeb_graph::internal

#endif // CGAL_REEB_GRAPH_INTERNAL_ENGINE_LOOPS_OF_COMPLEXES_H
