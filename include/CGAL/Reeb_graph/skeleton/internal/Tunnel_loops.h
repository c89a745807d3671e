// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_SKELETON_INTERNAL_TUNNEL_LOOPS_H
#define CGAL_REEB_GRAPH_SKELETON_INTERNAL_TUNNEL_LOOPS_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/handles/handle_and_tunnel_loops.h>
#include <CGAL/Reeb_graph/internal/base/Index.h>
#include <CGAL/Reeb_graph/internal/base/Progress.h>
#include <CGAL/Reeb_graph/skeleton/internal/Component_filling.h>
#include <CGAL/Reeb_graph/skeleton/internal/Loop_group.h>
#include <CGAL/Reeb_graph/skeleton/internal/Loop_linking.h>
#include <CGAL/Reeb_graph/skeleton/internal/Sampled_graph.h>
#include <CGAL/Reeb_graph/skeleton/internal/Surface_tree.h>
#include <CGAL/Reeb_graph/skeleton/internal/Surface_ways.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <queue>
#include <random>
#include <unordered_map>
#include <utility>
#include <vector>

namespace CGAL::Reeb_graph::internal::skeleton {

// The tunnels of a surface: a basis of the loops of its solid. How often another loop of faces has each of them is told by how
// often it passes its handle. Where the surface tells no sides, all loops are handles, and there are no tunnels.
class Tunnel_loops
{
public:
  Tunnel_loops(const Surface_tree& tree, Field field, const Stage_progress& progress)
    : mesh_(tree.mesh()),
      tree_(tree),
      handles_of_(mesh_.num_edges())
  {
    const auto np = parameters::check_self_intersections(false).shorten_loops(false).callback(progress.callback());
    const auto found = handle_and_tunnel_loops(mesh_, field, np);
    for(std::size_t i = 0; i != found.loops().size(); ++i)
    {
      const auto& loop = found.loops()[i];
      if(loop.kind == Loop_kind::LOOP)
        add_handle(loop.halfedges);
      else if(loop.kind == Loop_kind::HANDLE)
        add(loop.halfedges, found.loops()[loop.partner].halfedges, found.linking_number(loop.partner, i));
    }
  }

  // Puts others in place of tunnels: loops beneath which a way can pass though the surface crosses itself. They pass handles
  // independently, the shortest ones of those that an edge closes with a tree of shortest paths (J. Erickson and K. Whittlesey 2005).
  void free(const Surface_ways& ways)
  {
    are_free_ = true;
    tunnels_.clear();
    std::vector<Mesh::Halfedge_index> through(mesh_.num_faces(), Mesh::null_halfedge());
    Generated_group group;
    for(const auto& [length, h] : closing_edges(ways, through))
    {
      if(tunnels_.size() == handles_.size())
        return;
      const auto loop = Face_path::closed_by(mesh_, h, [&](Mesh::Face_index f) { return through[f.idx()]; });
      const std::size_t rank = group.basis().size();
      group.add_all({tunnels_of(loop)}, 2147483647);
      if(group.basis().size() != rank)
        tunnels_.push_back(loop.without_tail(mesh_));
    }
  }

  const std::vector<Face_path>& tunnels() const { return tunnels_; } // Each ends where it begins.
  // Each tunnel winds once around its handle, and around no other one, unless they are free.
  const std::vector<Polyline>& handles() const { return handles_; }
  bool are_free() const { return are_free_; }

  double length_of(const Face_path& path) const
  {
    double sum = 0;
    for(const auto h : path.steps)
      sum += step(h);
    return sum;
  }

  // How often a loop has each tunnel.
  Row tunnels_of(const Face_path& loop) const
  {
    Row result;
    for(const auto h : loop.steps)
      for_each_passed(h, [&](std::size_t tunnel, int sign) { add_multiple(result, {{tunnel, sign}}, 1); });
    return result;
  }

  // A loop from a face and back that is shorter than a bound, among those that an edge closes with a tree of shortest paths.
  // Its tunnels have values, whose sum is to be one of two.
  std::optional<Face_path> shorter_loop(Mesh::Face_index from,
                                        double bound,
                                        const std::vector<std::int64_t>& values,
                                        const std::array<std::int64_t, 2>& wanted) const
  {
    const auto passed = [&](Mesh::Halfedge_index h) {
      std::int64_t sum = 0;
      for_each_passed(h, [&](std::size_t tunnel, int sign) { sum += sign * values[tunnel]; });
      return sum;
    };
    std::unordered_map<std::size_t, Reached> reached = {{from.idx(), {0, 0, Mesh::null_halfedge(), false}}};
    typedef std::pair<double, Mesh::Face_index> Entry;
    std::priority_queue<Entry, std::vector<Entry>, std::greater<Entry>> queue;
    std::optional<Mesh::Halfedge_index> closing;
    for(queue.push({0, from}); !queue.empty() && 2 * queue.top().first < bound;)
    {
      const auto f = queue.top().second;
      queue.pop();
      Reached& at = reached.at(f.idx());
      if(std::exchange(at.is_final, true))
        continue;
      const auto [so_far, sum_so_far] = std::make_pair(at.distance, at.sum);
      auto h = mesh_.halfedge(f);
      for(int i = 0; i != 3; ++i, h = mesh_.next(h))
      {
        const Reached next = {so_far + step(h), sum_so_far + passed(h), h, false};
        Reached& other = reached.insert({across(h).idx(), next}).first->second;
        if(!other.is_final && next.distance <= other.distance)
        {
          other = next;
          queue.push({next.distance, across(h)});
        }
        else if(other.is_final && next.distance + other.distance < bound)
          for(const int sign : {-1, 1})
            if(std::count(wanted.begin(), wanted.end(), sign * (next.sum - other.sum)) != 0)
            {
              bound = next.distance + other.distance;
              closing = sign > 0 ? h : mesh_.opposite(h);
            }
      }
    }
    if(!closing)
      return std::nullopt;
    return Face_path::closed_by(mesh_, *closing, [&](Mesh::Face_index f) { return reached.at(f.idx()).through; });
  }

private:
  struct Reached
  {
    double distance;
    std::int64_t sum;
    Mesh::Halfedge_index through;
    bool is_final;
  };

  Mesh::Face_index across(Mesh::Halfedge_index h) const { return mesh_.face(mesh_.opposite(h)); }
  bool is_forward(Mesh::Halfedge_index h) const { return h < mesh_.opposite(h); }
  double step(Mesh::Halfedge_index h) const { return distance(tree_.center(mesh_.face(h)), tree_.center(across(h))); }

  template <class Halfedges>
  std::vector<Point> polygon(const Halfedges& loop) const
  {
    std::vector<Point> points;
    for(const auto h : loop)
      points.push_back(mesh_.point(mesh_.source(h)));
    return points;
  }

  template <class Halfedges>
  void add_handle(const Halfedges& handle)
  {
    for(const auto h : handle)
      handles_of_[mesh_.edge(h).idx()].emplace_back(handles_.size(), is_forward(h) ? 1 : -1);
    handles_.push_back(polygon(handle));
    signs_.push_back(1);
  }

  template <class Halfedges>
  void add(const Halfedges& handle, const Halfedges& tunnel, long long linking_number)
  {
    add_handle(handle);
    if(linking_number < 0)
      std::reverse(handles_.back().begin(), handles_.back().end());
    Face_path path = {mesh_.face(tunnel.front()), {}};
    for(std::size_t i = 0; i != tunnel.size(); ++i)
      for(auto g = mesh_.next(tunnel[i]); g != tunnel[(i + 1) % tunnel.size()]; g = mesh_.next(mesh_.opposite(g)))
        path.steps.push_back(g);
    tunnels_.push_back(std::move(path));
    signs_.back() = static_cast<int>(tunnels_of(tunnels_.back())[tunnels_.size() - 1]);
  }

  // The edges that close loops with trees that pass handles, the shortest loop first: sums of random numbers of handles tell.
  std::vector<std::pair<double, Mesh::Halfedge_index>> closing_edges(const Surface_ways& ways,
                                                                     std::vector<Mesh::Halfedge_index>& through) const
  {
    std::mt19937_64 random;
    std::vector<std::uint64_t> codes(handles_.size()), sums(mesh_.num_faces(), 0);
    std::generate(codes.begin(), codes.end(), std::ref(random));
    typedef std::pair<double, Mesh::Halfedge_index> Entry;
    std::vector<Entry> closing;
    std::vector<double> distances(mesh_.num_faces(), -1);
    std::priority_queue<Entry, std::vector<Entry>, std::greater<Entry>> queue;
    const auto reach = [&](Mesh::Face_index f, double so_far) {
      distances[f.idx()] = so_far;
      for(const auto h : CGAL::halfedges_around_face(mesh_.halfedge(f), mesh_))
        queue.push({so_far + step(h), h});
    };
    for(const auto root : mesh_.faces())
    {
      if(distances[root.idx()] < 0)
        reach(root, 0);
      while(!queue.empty())
      {
        const auto [so_far, h] = queue.top();
        const auto g = across(h);
        queue.pop();
        std::uint64_t sum = sums[mesh_.face(h).idx()];
        for_each_passed(h, [&](std::size_t handle, int sign) { sum += sign > 0 ? codes[handle] : -codes[handle]; });
        if(distances[g.idx()] < 0 && ways.can_pass(h))
        {
          through[g.idx()] = h;
          sums[g.idx()] = sum;
          reach(g, so_far);
        }
        else if(distances[g.idx()] >= 0 && is_forward(h) && sums[g.idx()] != sum && ways.can_pass(h))
          closing.push_back({so_far + distances[g.idx()], h});
      }
    }
    std::sort(closing.begin(), closing.end());
    return closing;
  }

  // Calls visit(tunnel, sign) for those whose handles a step passes.
  template <class Visit>
  void for_each_passed(Mesh::Halfedge_index h, const Visit& visit) const
  {
    for(const auto& [tunnel, sign] : handles_of_[mesh_.edge(h).idx()])
      visit(tunnel, is_forward(h) ? sign * signs_[tunnel] : -sign * signs_[tunnel]);
  }

  const Mesh& mesh_;
  const Surface_tree& tree_;
  std::vector<std::vector<std::pair<std::size_t, int>>> handles_of_; // by edge
  std::vector<int> signs_;                                           // by handle: of what passes it as its tunnel does
  std::vector<Face_path> tunnels_;
  std::vector<Polyline> handles_;
  bool are_free_ = false;
};

} // namespace CGAL::Reeb_graph::internal::skeleton

#endif // CGAL_REEB_GRAPH_SKELETON_INTERNAL_TUNNEL_LOOPS_H
