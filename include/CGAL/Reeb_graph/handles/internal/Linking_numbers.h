// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_HANDLES_INTERNAL_LINKING_NUMBERS_H
#define CGAL_REEB_GRAPH_HANDLES_INTERNAL_LINKING_NUMBERS_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/handles/internal/Closed_surface.h>
#include <CGAL/Reeb_graph/internal/base/Index.h>
#include <CGAL/Reeb_graph/internal/space/Projected_segments.h>

#include <boost/multiprecision/cpp_int.hpp>

#include <array>
#include <cstddef>
#include <map>
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

} // namespace CGAL::Reeb_graph::internal

#endif // CGAL_REEB_GRAPH_HANDLES_INTERNAL_LINKING_NUMBERS_H
