// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_HANDLES_INTERNAL_HANDLE_HOMOLOGY_H
#define CGAL_REEB_GRAPH_HANDLES_INTERNAL_HANDLE_HOMOLOGY_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/handles/internal/Closed_surface.h>
#include <CGAL/Reeb_graph/handles/internal/Component_loops.h>
#include <CGAL/Reeb_graph/handles/internal/Crossing_bounds.h>
#include <CGAL/Reeb_graph/handles/internal/Integer_rows.h>
#include <CGAL/Reeb_graph/handles/internal/Linking_numbers.h>
#include <CGAL/Reeb_graph/handles/internal/Loop_choice.h>
#include <CGAL/Reeb_graph/handles/internal/Loop_halves.h>
#include <CGAL/Reeb_graph/handles/internal/Loop_search.h>
#include <CGAL/Reeb_graph/internal/base/Index.h>
#include <CGAL/Reeb_graph/internal/base/Progress.h>

#include <CGAL/Exact_rational.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <deque>
#include <limits>
#include <unordered_map>
#include <utility>
#include <vector>

namespace CGAL {
namespace Reeb_graph {
namespace internal {

// All components of a surface, with the linking numbers of their loops.
class Handle_homology
{
public:
  struct Component
  {
    Component_loops loops;
    std::size_t number;      // among all components of the surface
    Integer_rows projection; // empty if there is no inside
    bool is_front_outside = true;
    std::size_t number_of_vertices = 0;
  };

  Handle_homology(Closed_surface surface, const Stage_progress& progress)
    : surface_(std::move(surface)),
      trees_(surface_),
      pieces_of_vertices_(surface_.points.size(), no_index),
      pieces_of_faces_(surface_.halfedge.size(), no_index)
  {
    progress(0.4);
    for(std::size_t i = 0; i != trees_.components().size(); ++i)
    {
      places_.push_back(components_.size());
      if(trees_.components()[i].genus() != 0)
        components_.push_back(
          {Component_loops(surface_, trees_, trees_.components()[i], pieces_of_vertices_, pieces_of_faces_), i, {}});
    }
    for(Index v = 0; v != surface_.number_of_given_vertices; ++v)
    {
      if(Component* component = component_of(v))
        ++component->number_of_vertices;
    }
    find_sides();
    progress(0.5);
    for(std::size_t i = 0; i != components_.size(); ++i)
    {
      if(!components_[i].loops.component().has_border)
        components_[i].projection = components_[i].loops.linking_numbers();
      progress.part(0.5, 1).report_step(i, components_.size());
    }
  }

  Handle_homology(const Handle_homology&) = delete;
  Handle_homology& operator=(const Handle_homology&) = delete;

  const Closed_surface& surface() const { return surface_; }
  const Tree_and_cotree& trees() const { return trees_; }
  std::deque<Component>& components() { return components_; } // those of genus greater than 0
  const std::deque<Component>& components() const { return components_; }

  // That of a vertex, or nullptr if its genus is 0.
  const Component* component_of(Index v) const
  {
    const Index number = trees_.component_of(v);
    if(number == no_index || trees_.components()[number].genus() == 0)
      return nullptr;
    return &components_[places_[number]];
  }
  Component* component_of(Index v)
  {
    return const_cast<Component*>(static_cast<const Handle_homology*>(this)->component_of(v));
  }

  // The place of that of a vertex in components().
  std::size_t place_of(Index v) const { return places_[trees_.component_of(v)]; }

private:
  template <class FT>
  using Corners = std::array<std::array<FT, 3>, 3>;

  // Six times the volume between a face and the origin.
  template <class FT>
  static FT volume(const Corners<FT>& p)
  {
    return p[0][0] * (p[1][1] * p[2][2] - p[1][2] * p[2][1]) + p[0][1] * (p[1][2] * p[2][0] - p[1][0] * p[2][2])
         + p[0][2] * (p[1][0] * p[2][1] - p[1][1] * p[2][0]);
  }

  // A volume with a bound of what rounding has changed: interval arithmetic takes ten times as long.
  struct Rounded_volume
  {
    double sum = 0, magnitude = 0, largest = 0;
    std::size_t number_of_faces = 0;

    void add(const Corners<double>& p)
    {
      Corners<double> m;
      for(std::size_t i = 0; i != 3; ++i)
        for(std::size_t k = 0; k != 3; ++k)
        {
          m[i][k] = std::abs(p[i][k]);
          largest = (std::max)(largest, m[i][k]);
        }
      sum += volume(p);
      magnitude += m[0][0] * (m[1][1] * m[2][2] + m[1][2] * m[2][1]) + m[0][1] * (m[1][2] * m[2][0] + m[1][0] * m[2][2])
                 + m[0][2] * (m[1][0] * m[2][1] + m[1][1] * m[2][0]);
      ++number_of_faces;
    }

    // Whether the sign is that of the volume. Each face is rounded at most 8 times, and the sum once for each face; numbers
    // beyond the limits could underflow or overflow.
    bool is_clear() const
    {
      const double error =
        (static_cast<double>(number_of_faces) + 8) * std::numeric_limits<double>::epsilon() * magnitude;
      return largest < 1e100 && magnitude > 1e-150 && std::abs(sum) > error;
    }
  };

  // The sign of the volume tells on which side the bounded part of space is.
  void find_sides()
  {
    std::vector<Rounded_volume> volumes(components_.size());
    visit_faces<double>([](const Component&) { return true; },
                        [&](std::size_t place, const auto& corners) { volumes[place].add(corners); });
    std::vector<Exact_rational> exact_volumes(components_.size(), Exact_rational(0));
    const auto is_unclear = [&](const Component& component) { return !volumes[places_[component.number]].is_clear(); };
    if(std::any_of(components_.begin(), components_.end(), is_unclear))
      visit_faces<Exact_rational>(
        is_unclear, [&](std::size_t place, const auto& corners) { exact_volumes[place] += volume(corners); });
    for(std::size_t i = 0; i != components_.size(); ++i)
      components_[i].is_front_outside = is_unclear(components_[i]) ? exact_volumes[i] > 0 : volumes[i].sum > 0;
  }

  // Calls act(place of the component, corners as seen from its root) for each face of closed components.
  template <class FT, class Filter, class Act>
  void visit_faces(const Filter& filter, const Act& act) const
  {
    for(const Index h : surface_.halfedge)
    {
      const Component* component = component_of(surface_.target[h]);
      if(!component || component->loops.component().has_border || !filter(*component))
        continue;
      const auto& o = surface_.points[component->loops.component().root];
      Corners<FT> p;
      Index g = h;
      for(auto& point : p)
      {
        for(std::size_t k = 0; k != 3; ++k)
          point[k] = FT(surface_.points[surface_.source(g)][k]) - FT(o[k]);
        g = surface_.next[g];
      }
      act(places_[component->number], p);
    }
  }

  const Closed_surface surface_;
  const Tree_and_cotree trees_;
  std::vector<Index> pieces_of_vertices_, pieces_of_faces_;
  std::deque<Component> components_;
  std::vector<std::size_t> places_; // in components_, by the number of the component
};

// Finds dual loops of all components. What is valid for `Integer` is written to `result`, by component; components whose
// linking numbers are not those of a surface with two sides, or that have a border, get the loops of their tree.
template <class Integer>
class All_loops
{
public:
  explicit All_loops(Handle_homology& homology) : homology_(homology), surface_(homology.surface()) {}

  // Loops are shortened as far as that makes them shorter than `bound`, and than the `number`-th size of a pair.
  std::vector<std::vector<Pair_of_loops>> operator()(double bound, std::size_t number, const Stage_progress& progress)
  {
    Class_codes codes(surface_.next.size() / 2, {0, 0});
    for(auto& component : homology_.components())
    {
      if(!component.projection.empty())
        halves_.emplace_back(component.loops, component.projection);
      if(component.projection.empty() || !halves_.back().is_valid())
      {
        if(!component.projection.empty())
          halves_.pop_back();
        component.projection.clear();
        halves_.emplace_back(component.loops, splitting<Integer>(component.loops));
      }
      const auto random = random_numbers(component.loops.size());
      for(std::size_t k = 0; k != component.loops.size(); ++k)
        codes[component.loops.component().left_over[k] / 2] = halves_.back().code(k, random);
    }
    complete_codes(surface_, homology_.trees(), codes);
    for(std::size_t i = 0; i != halves_.size(); ++i)
    {
      const auto& component = homology_.components()[i];
      choices_.emplace_back(surface_, component.loops, halves_[i], component.number_of_vertices);
    }
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
    Loop_search search(surface_, codes);
    Crossing_bounds crossing_bounds(surface_);
    std::vector<std::vector<Pair_of_loops>> result;
    for(std::size_t i = 0; i != choices_.size(); ++i)
    {
      const double number_of_choices = static_cast<double>(choices_.size());
      if(bound > 0)
        choices_[i].shorten(search, crossing_bounds, bound,
                            progress.part(i / number_of_choices, (i + 1) / number_of_choices));
      result.push_back(choices_[i].take_pairs());
    }
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
  std::deque<Loop_halves<Integer>> halves_;
  std::deque<Loop_choice<Integer>> choices_;
};

} // namespace internal
} // namespace Reeb_graph
} // namespace CGAL

#endif // CGAL_REEB_GRAPH_HANDLES_INTERNAL_HANDLE_HOMOLOGY_H
