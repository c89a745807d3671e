// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_HANDLES_INTERNAL_FOUND_LOOPS_H
#define CGAL_REEB_GRAPH_HANDLES_INTERNAL_FOUND_LOOPS_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/handles/internal/Closed_surface.h>
#include <CGAL/Reeb_graph/handles/internal/Handle_homology.h>
#include <CGAL/Reeb_graph/handles/internal/Loop_choice.h>
#include <CGAL/Reeb_graph/handles/internal/Loop_halves.h>
#include <CGAL/Reeb_graph/handles/internal/Loop_search.h>
#include <CGAL/Reeb_graph/internal/base/Index.h>
#include <CGAL/Reeb_graph/internal/base/Progress.h>
#include <CGAL/Reeb_graph/internal/base/Threads.h>
#include <CGAL/Reeb_graph/internal/space/Self_intersections.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <functional>
#include <limits>
#include <memory>
#include <random>
#include <unordered_map>
#include <unordered_set>
#include <utility>
#include <vector>

namespace CGAL::Reeb_graph::internal {

// Finds dual loops of all components, by component. Those whose linking numbers are not those of a surface with two
// sides, or that have a border, get the loops of their tree.
class All_loops
{
public:
  explicit All_loops(Handle_homology& homology) : homology_(homology), surface_(homology.surface()) {}

  // Loops are shortened as far as that makes them shorter than `bound`, and than the `number`-th size of a pair.
  std::vector<std::vector<Pair_of_loops>> operator()(double bound,
                                                     std::size_t number,
                                                     const Threads& threads,
                                                     const Stage_progress& progress)
  {
    Class_codes codes(surface_.next.size() / 2, {0, 0});
    for(auto& component : homology_.components())
    {
      if(!component.projection.empty())
        halves_.emplace_back(component, component.projection);
      if(component.projection.empty() || !halves_.back().is_valid())
      {
        if(!component.projection.empty())
          halves_.pop_back();
        component.projection.clear();
        halves_.emplace_back(component, splitting(surface_, component));
      }
      std::vector<std::uint64_t> random(component.size());
      std::generate(random.begin(), random.end(), std::mt19937_64());
      for(std::size_t k = 0; k != component.size(); ++k)
        codes[component.component().left_over[k] / 2] = halves_.back().code(k, random);
    }
    complete_codes(surface_, homology_.trees(), codes);
    for(std::size_t i = 0; i != halves_.size(); ++i)
      choices_.emplace_back(surface_, homology_.components()[i], halves_[i],
                            !homology_.components()[i].projection.empty());
    add_loops_of_tree(codes);
    std::vector<double> sizes;
    for(auto& choice : choices_)
    {
      choice.choose();
      const std::vector<double> its_sizes = choice.sizes();
      sizes.insert(sizes.end(), its_sizes.begin(), its_sizes.end());
    }
    if(0 < number && number < sizes.size())
    {
      std::nth_element(sizes.begin(), sizes.begin() + static_cast<std::ptrdiff_t>(number - 1), sizes.end());
      bound = (std::min)(bound, std::nextafter(sizes[number - 1], std::numeric_limits<double>::infinity()));
    }
    if(bound > 0)
    {
      Loop_searchers searchers(surface_, codes, threads);
      const double number_of_choices = static_cast<double>(choices_.size());
      for(std::size_t i = 0; i != choices_.size(); ++i)
        choices_[i].shorten(
          searchers, bound,
          progress.part(static_cast<double>(i) / number_of_choices, static_cast<double>(i + 1) / number_of_choices));
    }
    std::vector<std::vector<Pair_of_loops>> result;
    for(auto& choice : choices_)
      result.push_back(choice.take_pairs());
    return result;
  }

private:
  // The shortest loop of each class among those that an edge closes with the tree.
  void add_loops_of_tree(const Class_codes& codes)
  {
    typedef std::unordered_map<std::uint64_t, std::pair<double, Index>> Shortest;
    std::vector<std::array<Shortest, 2>> shortest(choices_.size());
    const auto& trees = homology_.trees();
    for(Index h = 0; h != surface_.number_of_given_halfedges; h += 2)
    {
      const auto& code = codes[h / 2];
      if((code[0] == 0) == (code[1] == 0))
        continue;
      const int half = code[0] == 0 ? 1 : 0;
      const Index u = surface_.source(h), v = surface_.target[h];
      const double length = trees.distance(u) + surface_.length(h) + trees.distance(v);
      const std::uint64_t key = (std::min)(code[half], std::uint64_t(0) - code[half]);
      const std::size_t place = homology_.place_of(u);
      const auto found = shortest[place][half].emplace(key, std::make_pair(length, h)).first;
      if(length < found->second.first)
        found->second = {length, h};
    }
    for(std::size_t place = 0; place != choices_.size(); ++place)
      for(int half : {0, 1})
      {
        std::vector<std::pair<double, Index>> loops;
        for(const auto& entry : shortest[place][half])
          loops.push_back(entry.second);
        std::sort(loops.begin(), loops.end());
        for(const auto& loop : loops)
          choices_[place].add_candidate(half, trees.walk_through(loop.second));
      }
  }

  Handle_homology& homology_;
  const Closed_surface& surface_;
  std::deque<Loop_halves> halves_;
  std::deque<Loop_choice> choices_;
};

// Finds the loops, and keeps what answers questions about them.
class Found_loops : public Loop_finder
{
public:
  Found_loops(Closed_surface surface, const Stage_progress& progress) : homology_(std::move(surface), progress) {}

  const Closed_surface& surface() const override { return homology_.surface(); }
  std::size_t number_of_components() const override { return homology_.trees().components().size(); }
  Index component_of(Index v) const override { return homology_.trees().component_of(v); }

  std::vector<std::size_t> self_intersections(bool are_counted) const override
  {
    const Tree_and_cotree& trees = homology_.trees();
    return Self_intersections(surface(), trees.closed_components_with_handles(), number_of_components(),
                              are_counted)(No_progress());
  }

  void refuse_self_intersections(const std::vector<std::size_t>& self_intersections) override
  {
    for(auto& component : homology_.components())
      component.is_refused = self_intersections[component.number] != 0;
  }

  std::vector<Surface_loop> make_loops(double bound,
                                       std::size_t number,
                                       const std::function<void()>& find_crossed,
                                       const Threads& threads,
                                       const Stage_progress& progress) override
  {
    std::vector<Surface_loop> result;
    std::vector<std::vector<Pair_of_loops>> pairs;
    threads.for_each_index(2, [&](std::size_t task) {
      if(task == 0)
        find_crossed();
      else
        pairs = All_loops(homology_)(bound, number, threads, progress);
    });
    for(std::size_t place = 0; place != pairs.size(); ++place)
      add_pairs(homology_.components()[place], pairs[place], result);
    for(const Halfedge_walk& cycle : homology_.surface().border_cycles)
      result.push_back(make_loop(Loop_kind::HOLE, cycle));
    return result;
  }

  bool is_bounding(const Halfedge_walk& walk, bool is_inside) const override
  {
    const auto* component = homology_component_of(walk);
    if(!component || !component->has_inside())
      return false;
    const Class loop = component->coordinates(walk);
    if(std::all_of(loop.begin(), loop.end(), [](const Integer& number) { return number == 0; }))
      return false;
    const Class front = combination(loop, component->projection);
    const bool is_behind = is_inside == component->is_front_outside;
    return is_behind ? std::all_of(front.begin(), front.end(), [](const Integer& number) { return number == 0; })
                     : front == loop;
  }

  long long intersection_number(const Halfedge_walk& a, const Halfedge_walk& b) const override
  {
    const auto* component = homology_component_of(a);
    if(!component || component != homology_component_of(b))
      return 0;
    return crossing(*component, component->coordinates(a), component->coordinates(b));
  }

  // In front, it is the intersection number of b with the part of a that bounds in front.
  long long linking_number(const Halfedge_walk& a, const Halfedge_walk& b) const override
  {
    const auto* component = homology_component_of(a);
    if(!component || component != homology_component_of(b) || !component->has_inside())
      return 0;
    const Class loop = component->coordinates(a), other = component->coordinates(b);
    const long long in_front = crossing(*component, other, combination(loop, component->projection));
    return component->is_front_outside ? in_front : in_front + crossing(*component, loop, other);
  }

private:
  typedef Handle_homology::Component Component;
  typedef std::vector<Integer> Class;

  void add_pairs(const Component& component, const std::vector<Pair_of_loops>& pairs, std::vector<Surface_loop>& loops)
  {
    const bool has_inside = component.has_inside();
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
    loop.component = component_of(surface.target[walk.front()]);
    std::unordered_set<Index> passed;
    for(const Index h : walk)
      loop.is_simple = passed.insert(surface.target[h]).second && loop.is_simple;
    return loop;
  }

  const Component* homology_component_of(const Halfedge_walk& walk) const
  {
    return walk.empty() ? nullptr : homology_.component_of(homology_.surface().target[walk.front()]);
  }

  static long long crossing(const Component& component, const Class& a, const Class& b)
  {
    return to_machine_integer(dot_product(combination(a, component.intersection_numbers()[0]), b));
  }

  Handle_homology homology_;
};

template <class Surface>
std::unique_ptr<Loop_finder> make_loop_finder(Surface surface, const Stage_progress& progress)
{
  return std::make_unique<Found_loops>(std::move(surface), progress);
}

} // namespace CGAL::Reeb_graph::internal

#endif // CGAL_REEB_GRAPH_HANDLES_INTERNAL_FOUND_LOOPS_H
