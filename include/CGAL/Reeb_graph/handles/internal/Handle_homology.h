// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_HANDLES_INTERNAL_HANDLE_HOMOLOGY_H
#define CGAL_REEB_GRAPH_HANDLES_INTERNAL_HANDLE_HOMOLOGY_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/handles/internal/Closed_surface.h>
#include <CGAL/Reeb_graph/internal/base/Index.h>
#include <CGAL/Reeb_graph/internal/base/Progress.h>
#include <CGAL/Reeb_graph/internal/space/Projected_segments.h>

#include <CGAL/Exact_rational.h>

#include <boost/multiprecision/cpp_int.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <deque>
#include <limits>
#include <map>
#include <unordered_map>
#include <utility>
#include <vector>

namespace CGAL::Reeb_graph::internal {

typedef boost::multiprecision::number<boost::multiprecision::cpp_int_backend<>, boost::multiprecision::et_off> Integer;
typedef std::vector<std::vector<Integer>> Rows;

// The linking numbers of the loops of edges of a component with its loops of faces, pushed off the surface.
//
// The side to which the normals of the faces point is called the front. A loop c of faces leads through the middles of
// triangles and of edges; pushed to the front, it is disjoint from every loop of edges. Seen in a direction, the
// linking number of a loop b of edges with it is the sum of the signs of all crossings of b over it. Edges of b and
// segments of c have no point in common, and are crossed as they are, but where c crosses b in the middle of an edge.
// There, the pushed c turns around the edge from one side to the other on the front. It passes below the edge if and
// only if what is just below the edge is in front of the surface, and this crossing has the sign of the intersection of
// b and c. So no point has to be moved, and exact signs of determinants decide everything.
class Linking_numbers
{
  typedef Projected_segments::Segment Segment;

  // A segment of a loop, in the direction in which loops of edges lead away from the root, and loops of faces to it.
  struct Located_segment
  {
    Segment segment;
    Index piece;
    Index edge; // the halfedge that a loop of faces crosses, if this edge is in no tree, or no_index
  };

public:
  // `pieces_of_vertices` and `pieces_of_faces` hold no_index for all vertices and faces of the component.
  Linking_numbers(const Closed_surface& surface,
                  const Tree_and_cotree& trees,
                  const Tree_and_cotree::Component& component,
                  const Forest_pieces& pieces,
                  const Forest_pieces& copieces)
    : surface_(surface),
      trees_(trees),
      left_over_(component.left_over),
      pieces_(pieces),
      copieces_(copieces)
  {
    collect_segments();
  }

  // Minus the linking number of each loop b_i of edges with each loop c_j of faces pushed to the front. Empty if no
  // direction is in general position, as there is none where triangles have no area, or points are the same.
  Rows operator()() const
  {
    return in_general_direction<Rows>([&](const std::array<double, 3>& direction) { return numbers_in(direction); });
  }

private:
  typedef std::vector<long long> Row;

  Mean_point vertex(Index v) const { return {{&surface_.points[v], nullptr, nullptr}, 1}; }
  Mean_point middle(Index h) const
  {
    return {{&surface_.points[surface_.source(h)], &surface_.points[surface_.target[h]], nullptr}, 2};
  }
  Mean_point middle_of_face(Index f) const
  {
    const Index h = surface_.halfedge[f];
    return {{&surface_.points[surface_.source(h)], &surface_.points[surface_.target[h]],
             &surface_.points[surface_.target[surface_.next[h]]]},
            3};
  }
  Segment segment(Index h) const { return {vertex(surface_.source(h)), vertex(surface_.target[h])}; }

  void collect_segments()
  {
    for(const Index v : pieces_.nodes())
      edges_.push_back({segment(trees_.to_vertex(v)), pieces_.piece_of(v), no_index});
    for(std::size_t k = 0; k != left_over_.size(); ++k)
      edges_.push_back({segment(left_over_[k]), static_cast<Index>(pieces_.size() + k), left_over_[k]});
    for(const Index f : copieces_.nodes())
      add_crossing(trees_.to_parent(f), copieces_.piece_of(f), no_index);
    for(std::size_t k = 0; k != left_over_.size(); ++k)
      add_crossing(surface_.opposite(left_over_[k]), static_cast<Index>(copieces_.size() + k), left_over_[k]);
  }

  // The segments that lead through the middle of a halfedge from the face on its left.
  void add_crossing(Index h, Index piece, Index left_over)
  {
    crossings_.push_back({{middle_of_face(surface_.face[h]), middle(h)}, piece, left_over});
    crossings_.push_back({{middle(h), middle_of_face(surface_.face[surface_.opposite(h)])}, piece, left_over});
  }

  Rows numbers_in(const std::array<double, 3>& direction) const
  {
    const Projected_segments view(direction);
    std::map<std::pair<Index, Index>, long long> crossings;
    cross_segments(view, crossings);
    Rows result = sum_over_loops(crossings);
    for(std::size_t k = 0; k != left_over_.size(); ++k)
      result[k][k] += is_front_below(view, left_over_[k]) ? 1 : 0;
    return result;
  }

  // Adds minus the sign of each crossing of an edge over a segment, by their pieces.
  void cross_segments(const Projected_segments& view, std::map<std::pair<Index, Index>, long long>& crossings) const
  {
    view.for_each_pair_that_may_cross(edges_, crossings_,
                                      [&](const Located_segment& edge, const Located_segment& crossing) {
                                        if(edge.edge != no_index && edge.edge == crossing.edge)
                                          return; // They touch.
                                        const int sign = view.crossing_over(edge.segment, crossing.segment);
                                        if(sign != 0)
                                          crossings[{edge.piece, crossing.piece}] -= sign;
                                      });
  }

  // Whether what is just below the middle of an edge is in front of the surface: in the wedge that begins at the face
  // on the left and ends at the face on the right, counterclockwise as seen against the halfedge.
  bool is_front_below(const Projected_segments& view, Index h) const
  {
    const Segment edge = segment(h);
    const Mean_point left = vertex(surface_.target[surface_.next[h]]);
    const Mean_point right = vertex(surface_.target[surface_.next[surface_.opposite(h)]]);
    // signs of turns by less than half a turn, where `below` is opposite to the direction
    const int left_to_right = view.turn(edge, left, right);
    const int left_to_below = view.turn_from_direction(edge, left);
    const int below_to_right = -view.turn_from_direction(edge, right);
    if(left_to_right > 0)
      return left_to_below > 0 && below_to_right > 0;
    if(left_to_right < 0)
      return left_to_below > 0 || below_to_right > 0;
    return left_to_below > 0;
  }

  // The numbers of pieces, added up along the loops.
  Rows sum_over_loops(const std::map<std::pair<Index, Index>, long long>& crossings) const
  {
    const std::size_t number_of_loops = left_over_.size();
    std::vector<Row> rows(pieces_.size() + number_of_loops, Row(number_of_loops, 0));
    Row sums;
    for(auto crossing = crossings.begin(); crossing != crossings.end();)
    {
      const Index piece = crossing->first.first;
      sums.assign(copieces_.size() + number_of_loops, 0);
      for(; crossing != crossings.end() && crossing->first.first == piece; ++crossing)
        sums[crossing->first.second] = crossing->second;
      copieces_.add_up(sums);
      for(std::size_t k = 0; k != number_of_loops; ++k)
      {
        const Index left = surface_.face[left_over_[k]], right = surface_.face[surface_.opposite(left_over_[k])];
        rows[piece][k] = sums[copieces_.size() + k] + copieces_.at(sums, left) - copieces_.at(sums, right);
      }
    }
    for(Index piece = 0; piece != pieces_.size(); ++piece)
    {
      if(pieces_.parent(piece) != no_index)
        add(rows[piece], rows[pieces_.parent(piece)], 1);
    }
    Rows result;
    for(std::size_t k = 0; k != number_of_loops; ++k)
    {
      Row& row = rows[pieces_.size() + k];
      add_row_at(row, rows, surface_.source(left_over_[k]), 1);
      add_row_at(row, rows, surface_.target[left_over_[k]], -1);
      result.emplace_back(row.begin(), row.end());
    }
    return result;
  }

  static void add(Row& row, const Row& other, long long factor)
  {
    for(std::size_t k = 0; k != row.size(); ++k)
      row[k] += factor * other[k];
  }

  void add_row_at(Row& row, const std::vector<Row>& rows, Index v, long long factor) const
  {
    if(pieces_.piece_of(v) != no_index)
      add(row, rows[pieces_.piece_of(v)], factor);
  }

  const Closed_surface& surface_;
  const Tree_and_cotree& trees_;
  const std::vector<Index>& left_over_;
  const Forest_pieces &pieces_, &copieces_;
  std::vector<Located_segment> edges_, crossings_;
};

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
