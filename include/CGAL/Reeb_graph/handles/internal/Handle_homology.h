// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_HANDLES_INTERNAL_HANDLE_HOMOLOGY_H
#define CGAL_REEB_GRAPH_HANDLES_INTERNAL_HANDLE_HOMOLOGY_H

#include <CGAL/Reeb_graph/handles/internal/Closed_surface.h>
#include <CGAL/Reeb_graph/handles/internal/Linking_numbers.h>
#include <CGAL/Reeb_graph/internal/base/Index.h>
#include <CGAL/Reeb_graph/internal/base/Progress.h>

#include <CGAL/Exact_rational.h>
#include <CGAL/license/Reeb_graph.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <deque>
#include <limits>
#include <unordered_map>
#include <utility>
#include <vector>

namespace CGAL::Reeb_graph::internal {

// The loops of one component: coordinates of closed walks in the basis b of its tree, intersection numbers, and linking
// numbers.
class Component_loops
{
public:
  // `pieces_of_vertices` and `pieces_of_faces` are places for numbers, no_index for this component.
  Component_loops(const Closed_surface& surface,
                  const Tree_and_cotree& trees,
                  std::size_t number_of_component,
                  std::vector<Index>& pieces_of_vertices,
                  std::vector<Index>& pieces_of_faces)
    : number(number_of_component),
      surface_(surface),
      trees_(trees),
      component_(trees.components()[number_of_component]),
      pieces_(ends([&](Index h) { return surface.source(h); }),
              pieces_of_vertices,
              [&](Index v) { return trees.parent(v); }),
      copieces_(ends([&](Index h) { return surface.face[h]; }), pieces_of_faces, [&](Index f) {
        return trees.parent_face(f);
      })
  {
    for(std::size_t k = 0; k != size(); ++k)
      numbers_.emplace(component_.left_over[k], k);
  }

  std::size_t number;      // among all components of the surface
  Rows projection;         // empty if linking numbers split no loops
  bool is_refused = false; // as it intersects itself: the projection makes loops short, but tells no sides
  bool is_front_outside = true;
  std::size_t number_of_vertices = 0;

  bool has_inside() const { return !projection.empty() && !is_refused; }
  std::size_t size() const { return component_.left_over.size(); } // twice the genus
  const Tree_and_cotree::Component& component() const { return component_; }
  Halfedge_walk walk(std::size_t k) const { return trees_.walk_through(component_.left_over[k]); }

  Rows linking_numbers() const { return Linking_numbers(surface_, trees_, component_, pieces_, copieces_)(); }

  // The coordinates of a closed walk in the basis b: how often each loop c crosses it from its right to its left.
  std::vector<Integer> coordinates(const Halfedge_walk& walk) const
  {
    std::vector<long long> result(size(), 0), sums(copieces_.size(), 0);
    for(const Index h : walk)
    {
      const auto left_over = numbers_.find(h & ~Index(1));
      if(left_over != numbers_.end())
        result[left_over->second] += h == component_.left_over[left_over->second] ? 1 : -1;
      for(const Index g : {h, surface_.opposite(h)})
      {
        // A loop c that leads to the parent of the face on the left of a halfedge crosses it from its left.
        const Index face = surface_.face[g];
        if(trees_.to_parent(face) == g && copieces_.piece_of(face) != no_index)
          sums[copieces_.piece_of(face)] -= g == h ? 1 : -1;
      }
    }
    copieces_.add_up(sums);
    for(std::size_t k = 0; k != size(); ++k)
    {
      const Index h = component_.left_over[k];
      result[k] += copieces_.at(sums, surface_.face[h]) - copieces_.at(sums, surface_.face[surface_.opposite(h)]);
    }
    return {result.begin(), result.end()};
  }

  // The intersection numbers of the loops b with each other, and of the loops c with each other. The second matrix
  // has the coordinates of the loops c in the basis b, and its transpose is the inverse of the first one.
  std::array<Rows, 2> intersection_numbers() const
  {
    const std::vector<Index> ends = ends_around_tree();
    std::unordered_map<Index, std::size_t> places;
    for(std::size_t i = 0; i != ends.size(); ++i)
      places.emplace(ends[i], i);
    // The border of the polygon that is left if the surface is cut along the loops b, as it is passed counterclockwise.
    std::vector<Index> sides;
    for(std::size_t place = 0; sides.size() != ends.size();)
    {
      sides.push_back(ends[place]);
      place = (places[surface_.opposite(ends[place])] + ends.size() - 1) % ends.size();
    }
    return {crossings(ends), crossings(sides)};
  }

private:
  // Lists what `of` gives for both halfedges of each edge that is left over.
  template <class Of>
  std::vector<Index> ends(const Of& of) const
  {
    std::vector<Index> result;
    for(const Index h : component_.left_over)
    {
      result.push_back(of(h));
      result.push_back(of(surface_.opposite(h)));
    }
    return result;
  }
  bool is_in_pieces(Index h) const
  {
    const Index v = surface_.target[h], u = surface_.source(h);
    return (trees_.to_vertex(v) == h && pieces_.piece_of(v) != no_index)
        || (trees_.to_vertex(u) == surface_.opposite(h) && pieces_.piece_of(u) != no_index);
  }

  // The halfedges that leave the tree along an edge that is left over, as they lie around it, counterclockwise.
  std::vector<Index> ends_around_tree() const
  {
    std::vector<Index> result;
    const Index first = surface_.outgoing[component_.root];
    Index h = first;
    do
    {
      if(numbers_.count(h & ~Index(1)) != 0)
        result.push_back(h);
      h = surface_.turned(is_in_pieces(h) ? surface_.opposite(h) : h);
    } while(h != first);
    return result;
  }

  // The intersection numbers of chords of a circle: chord k leads from the place of left_over[k] to that of its
  // opposite, and around the tree, the other way round on the outside. Counterclockwise, they begin, begin, end, end if
  // the second one crosses the first one from its right to its left.
  Rows crossings(const std::vector<Index>& places) const
  {
    std::vector<std::array<std::size_t, 2>> chords(size());
    for(std::size_t i = 0; i != places.size(); ++i)
    {
      const std::size_t k = numbers_.at(places[i] & ~Index(1));
      chords[k][places[i] == component_.left_over[k] ? 0 : 1] = i;
    }
    Rows result(size(), std::vector<Integer>(size(), Integer(0)));
    for(std::size_t i = 0; i != size(); ++i)
      for(std::size_t j = 0; j != size(); ++j)
      {
        if(i == j)
          continue;
        const auto after_begin = [&](std::size_t place) {
          return (place + places.size() - chords[i][0]) % places.size();
        };
        const bool begins_right = after_begin(chords[j][0]) < after_begin(chords[i][1]);
        const bool ends_right = after_begin(chords[j][1]) < after_begin(chords[i][1]);
        result[i][j] = begins_right == ends_right ? 0 : begins_right ? 1 : -1;
      }
    return result;
  }

  const Closed_surface& surface_;
  const Tree_and_cotree& trees_;
  const Tree_and_cotree::Component& component_;
  Forest_pieces pieces_, copieces_;
  std::unordered_map<Index, std::size_t> numbers_; // of the even halfedges that are left over
};

// All components of a surface, with the linking numbers of their loops.
class Handle_homology
{
public:
  typedef Component_loops Component;

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
        components_.emplace_back(surface_, trees_, i, pieces_of_vertices_, pieces_of_faces_);
    }
    for(Index v = 0; v != surface_.number_of_given_vertices; ++v)
    {
      if(component_of(v) != nullptr)
        ++components_[place_of(v)].number_of_vertices;
    }
    find_sides();
    progress(0.5);
    for(std::size_t i = 0; i != components_.size(); ++i)
    {
      if(!components_[i].component().has_border)
        components_[i].projection = components_[i].linking_numbers();
      progress.part(0.5, 1).report_step(i, components_.size());
    }
  }

  Handle_homology(const Handle_homology&) = delete;
  Handle_homology& operator=(const Handle_homology&) = delete;

  const Closed_surface& surface() const { return surface_; }
  const Tree_and_cotree& trees() const { return trees_; }
  std::deque<Component>& components() { return components_; } // those of genus greater than 0
  const std::deque<Component>& components() const { return components_; }

  // The component of a vertex, or nullptr if its genus is 0.
  const Component* component_of(Index v) const
  {
    const Index number = trees_.component_of(v);
    if(number == no_index || trees_.components()[number].genus() == 0)
      return nullptr;
    return &components_[places_[number]];
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
    return dot(p[0], cross(p[1], p[2]));
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
      if(!component || component->component().has_border || !filter(*component))
        continue;
      const auto& o = surface_.points[component->component().root];
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

} // namespace CGAL::Reeb_graph::internal

#endif // CGAL_REEB_GRAPH_HANDLES_INTERNAL_HANDLE_HOMOLOGY_H
