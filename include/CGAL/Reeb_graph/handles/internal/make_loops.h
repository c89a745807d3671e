// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_HANDLES_INTERNAL_MAKE_LOOPS_H
#define CGAL_REEB_GRAPH_HANDLES_INTERNAL_MAKE_LOOPS_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/handles/Handle_loop.h>
#include <CGAL/Reeb_graph/handles/internal/Closed_surface.h>
#include <CGAL/Reeb_graph/handles/internal/Handle_homology.h>
#include <CGAL/Reeb_graph/handles/internal/Integer_rows.h>
#include <CGAL/Reeb_graph/handles/internal/Reeb_loops.h>
#include <CGAL/Reeb_graph/handles/internal/Self_intersections.h>
#include <CGAL/Reeb_graph/internal/base/Index.h>
#include <CGAL/Reeb_graph/internal/base/Progress.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <unordered_set>
#include <utility>
#include <vector>

namespace CGAL {
namespace Reeb_graph {
namespace internal {

// A loop as that of the public interface, with numbers of halfedges.
struct Surface_loop
{
  Loop_kind kind;
  Halfedge_walk walk;
  std::size_t partner = Handle_loop<Index>::no_partner;
  double length = 0;
  double persistence = 0;
  std::size_t component = 0;
  bool is_simple = true;
};

// Finds the loops, and keeps what answers questions about them.
class Found_loops
{
public:
  Found_loops(Closed_surface surface, const Stage_progress& progress) : homology_(std::move(surface), progress) {}

  const Handle_homology& homology() const { return homology_; }

  // Whether each component intersects itself.
  std::vector<bool> self_intersections() const { return Self_intersections(homology_.surface(), homology_.trees())(); }

  // A component that intersects itself has no inside.
  void refuse_self_intersections(const std::vector<bool>& is_crossed)
  {
    for(auto& component : homology_.components())
    {
      if(is_crossed[component.number])
        component.projection.clear();
    }
  }

  // Loops are made shorter than `bound`, and than the `number`-th size of a pair, where that can be.
  std::vector<Surface_loop> make_loops(double bound, std::size_t number, const Stage_progress& progress)
  {
    std::vector<Surface_loop> result;
    const auto pairs = find_pairs(bound, number, progress);
    for(std::size_t place = 0; place != pairs.size(); ++place)
      add_pairs(homology_.components()[place], pairs[place], result);
    for(const Halfedge_walk& cycle : homology_.surface().border_cycles)
      result.push_back(make_loop(Loop_kind::HOLE, cycle));
    return result;
  }

  // Whether a loop of the surface bounds inside, or outside, but not on the surface.
  bool is_bounding(const Halfedge_walk& walk, bool is_inside) const
  {
    const auto* component = component_of(walk);
    if(!component || component->projection.empty())
      return false;
    const auto loop = coordinates(*component, walk);
    if(std::all_of(loop.begin(), loop.end(), [](const Large_integer& number) { return number == 0; }))
      return false;
    const auto front = part_in_front(*component, loop);
    const bool is_behind = is_inside == component->is_front_outside;
    return is_behind ? std::all_of(front.begin(), front.end(), [](const Large_integer& number) { return number == 0; })
                     : front == loop;
  }

  long long intersection_number(const Halfedge_walk& a, const Halfedge_walk& b) const
  {
    const auto* component = component_of(a);
    if(!component || component != component_of(b))
      return 0;
    return crossing(*component, coordinates(*component, a), coordinates(*component, b));
  }

  // That of a with b pushed outside. In front, it is that of b with the part of a that bounds in front.
  long long linking_number(const Halfedge_walk& a, const Halfedge_walk& b) const
  {
    const auto* component = component_of(a);
    if(!component || component != component_of(b) || component->projection.empty())
      return 0;
    const auto loop = coordinates(*component, a), other = coordinates(*component, b);
    const long long in_front = crossing(*component, other, part_in_front(*component, loop));
    return component->is_front_outside ? in_front : in_front + crossing(*component, loop, other);
  }

private:
  typedef Handle_homology::Component Component;
  typedef std::vector<Large_integer> Class;

  std::vector<std::vector<Pair_of_loops>> find_pairs(double bound, std::size_t number, const Stage_progress& progress)
  {
    try
    {
      return All_loops<Checked_integer>(homology_)(bound, number, progress);
    }
    catch(const Integer_overflow&)
    {
      return All_loops<Large_integer>(homology_)(bound, number, progress);
    }
  }

  void add_pairs(const Component& component, const std::vector<Pair_of_loops>& pairs, std::vector<Surface_loop>& loops)
  {
    const bool has_inside = !component.projection.empty();
    std::vector<std::array<Surface_loop, 2>> made;
    for(const Pair_of_loops& pair : pairs)
    {
      const std::size_t inside = has_inside && !component.is_front_outside ? 1 : 0;
      made.push_back({make_loop(has_inside ? Loop_kind::HANDLE : Loop_kind::LOOP, pair[inside]),
                      make_loop(has_inside ? Loop_kind::TUNNEL : Loop_kind::LOOP, pair[1 - inside])});
    }
    const auto size = [](const std::array<Surface_loop, 2>& pair) {
      return std::make_pair((std::min)(pair[0].length, pair[1].length), pair[0].length + pair[1].length);
    };
    std::stable_sort(made.begin(), made.end(), [&](const auto& a, const auto& b) { return size(a) < size(b); });
    for(auto& pair : made)
      for(std::size_t k : {0, 1})
      {
        pair[k].partner = k == 0 ? loops.size() + 1 : loops.size() - 1;
        loops.push_back(std::move(pair[k]));
      }
  }

  Surface_loop make_loop(Loop_kind kind, const Halfedge_walk& walk) const
  {
    const Closed_surface& surface = homology_.surface();
    Surface_loop loop = {kind, walk};
    loop.length = surface.length(walk);
    loop.component = homology_.trees().component_of(surface.target[walk.front()]);
    std::unordered_set<Index> passed;
    for(const Index h : walk)
      loop.is_simple = passed.insert(surface.target[h]).second && loop.is_simple;
    return loop;
  }

  const Component* component_of(const Halfedge_walk& walk) const
  {
    return walk.empty() ? nullptr : homology_.component_of(homology_.surface().target[walk.front()]);
  }

  static Class coordinates(const Component& component, const Halfedge_walk& walk)
  {
    const auto numbers = component.loops.coordinates(walk);
    return Class(numbers.begin(), numbers.end());
  }

  static Class part_in_front(const Component& component, const Class& loop)
  {
    Class sum(loop.size(), 0);
    for(std::size_t i = 0; i != loop.size(); ++i)
      for(std::size_t k = 0; k != loop.size(); ++k)
        sum[k] += loop[i] * component.projection[i][k];
    return sum;
  }

  static long long crossing(const Component& component, const Class& a, const Class& b)
  {
    const Integer_rows forms = component.loops.intersection_numbers()[0];
    Large_integer sum = 0;
    for(std::size_t i = 0; i != a.size(); ++i)
      for(std::size_t k = 0; k != a.size(); ++k)
        sum += a[i] * forms[i][k] * b[k];
    return to_machine_integer(sum);
  }

  Handle_homology homology_;
};

// Sets the persistences of the loops that have partners.
template <class ReebLoops, class Number>
void set_persistences(const ReebLoops& reeb_loops, const Number& number, std::vector<Surface_loop>& loops)
{
  std::vector<std::size_t> firsts; // of pairs, by size
  for(std::size_t i = 0; i != loops.size(); ++i)
  {
    if(loops[i].kind != Loop_kind::HOLE && loops[i].partner > i)
      firsts.push_back(i);
  }
  const auto size = [&](std::size_t i) { return (std::min)(loops[i].length, loops[i + 1].length); };
  std::stable_sort(firsts.begin(), firsts.end(), [&](std::size_t a, std::size_t b) { return size(a) < size(b); });
  std::vector<std::array<const Halfedge_walk*, 2>> pairs;
  for(const std::size_t i : firsts)
    pairs.push_back({&loops[i].walk, &loops[i + 1].walk});
  const std::vector<double> persistences = persistences_of_pairs(reeb_loops, pairs, number);
  for(std::size_t k = 0; k != firsts.size(); ++k)
    loops[firsts[k]].persistence = loops[firsts[k] + 1].persistence = persistences[k];
}

} // namespace internal
} // namespace Reeb_graph
} // namespace CGAL

#endif // CGAL_REEB_GRAPH_HANDLES_INTERNAL_MAKE_LOOPS_H
