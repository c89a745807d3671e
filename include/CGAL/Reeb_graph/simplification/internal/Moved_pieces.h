// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_SIMPLIFICATION_INTERNAL_MOVED_PIECES_H
#define CGAL_REEB_GRAPH_SIMPLIFICATION_INTERNAL_MOVED_PIECES_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/internal/base/Index.h>
#include <CGAL/Reeb_graph/internal/complex/Weighted_graph.h>
#include <CGAL/Reeb_graph/simplification/exceptions.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL::Reeb_graph::internal {

// The removed pieces of a surface. All vertices of a piece have been removed together with branches at one saddle, and
// are moved next to it in the order of the vertices: just above it if one of them is below it, else just below it. The
// vertices around the piece do not change sides. Within it, the vertices are numbered so that each has a lower and a
// higher neighbor. So no extremum is left, and as the indices of the piece and of its saddle add up to the same as
// before, no other saddle than that of the arcs that stay if the piece has no handle and no border.
template <class Complex, class Scalar>
class Moved_pieces
{
public:
  // `saddles` has for each vertex that is to be moved the vertex of the saddle, and no_index for each other one.
  // `rooms` has for the vertex of a saddle how far the next values of nodes are: a saddle in a piece must not pass
  // them.
  Moved_pieces(const Complex& complex,
               const Weighted_graph& graph,
               const std::vector<Index>& saddles,
               const std::vector<Scalar>& rooms,
               const std::vector<Scalar>& values,
               double threshold)
    : complex_(complex),
      graph_(graph),
      saddles_(saddles),
      rooms_(rooms),
      values_(values),
      threshold_(threshold),
      st_numbering_(graph),
      numbers_(values.size(), no_index)
  {}

  // The values with those of the pieces changed, but not those of a piece with all its surroundings on one side.
  std::vector<Scalar> move()
  {
    std::vector<Scalar> moved = values_;
    Index number = 0;
    for(Index v = 0; v != graph_.number_of_vertices(); ++v)
    {
      if(saddles_[v] == no_index || numbers_[v] != no_index)
        continue;
      const Piece piece = collect_piece(v, number++);
      if(!piece.has_source || !piece.has_sink)
        continue;
      const auto order = st_numbering_(
        piece.vertices, [&](Index u) { return numbers_[u] == number - 1; },
        [&](Index u) { return is_source(u, piece); });
      put_values(order, choose_values(piece), moved);
    }
    return moved;
  }

private:
  struct Piece
  {
    std::vector<Index> vertices;
    Index saddle = 0;
    bool is_above = false;     // whether it is moved to just above the saddle
    bool has_source, has_sink; // among the vertices around it
    Scalar highest_source, lowest_sink;
  };

  bool is_lower(Index u, Index v) const { return std::make_pair(values_[u], u) < std::make_pair(values_[v], v); }

  // Where a vertex around a piece is when all pieces have been moved: at itself, or next to its saddle.
  Index place(Index u) const { return saddles_[u] == no_index ? u : saddles_[u]; }

  bool is_source(Index u, const Piece& piece) const
  {
    return place(u) == piece.saddle ? piece.is_above : is_lower(place(u), piece.saddle);
  }

  Piece collect_piece(Index first, Index number)
  {
    Piece piece;
    piece.saddle = saddles_[first];
    piece.vertices.push_back(first);
    numbers_[first] = number;
    for(std::size_t i = 0; i != piece.vertices.size(); ++i)
    {
      const Index v = piece.vertices[i];
      piece.is_above = piece.is_above || is_lower(v, piece.saddle);
      for(const auto& neighbor : graph_.neighbors(v))
        if(saddles_[neighbor.vertex] == piece.saddle && numbers_[neighbor.vertex] == no_index)
        {
          numbers_[neighbor.vertex] = number;
          piece.vertices.push_back(neighbor.vertex);
        }
    }
    look_around(piece, number);
    if(!piece.has_source || !piece.has_sink) // Pieces of several branches can have all their surroundings on one side.
    {
      piece.is_above = !piece.is_above;
      look_around(piece, number);
    }
    return piece;
  }

  // Finds what bounds the values of a piece.
  void look_around(Piece& piece, Index number) const
  {
    constexpr Scalar infinity = std::numeric_limits<Scalar>::infinity();
    piece.has_source = piece.has_sink = false;
    piece.highest_source = -infinity;
    piece.lowest_sink = infinity;
    for(const Index v : piece.vertices)
      for(const auto& neighbor : graph_.neighbors(v))
      {
        const Index u = neighbor.vertex;
        if(numbers_[u] == number)
          continue;
        (is_source(u, piece) ? piece.has_source : piece.has_sink) = true;
        if(is_source(u, piece))
          piece.highest_source = (std::max)(piece.highest_source, values_[place(u)]);
        else
          piece.lowest_sink = (std::min)(piece.lowest_sink, values_[place(u)]);
      }
  }

  // As many values as the piece has vertices, ascending, between the saddle and the middle of the way to the next of
  // the vertices around the piece: the other half is for a piece that comes the other way. They take a small part of the
  // room, so that the largest change stays below the threshold.
  std::vector<Scalar> choose_values(const Piece& piece) const
  {
    const bool is_above = piece.is_above;
    const Scalar from = values_[piece.saddle], to = is_above ? piece.lowest_sink : piece.highest_source;
    const Scalar infinity = std::numeric_limits<Scalar>::infinity();
    const Scalar middle = std::isinf(to) ? to : from / 2 + to / 2;
    const Scalar slack = static_cast<Scalar>(threshold_) - largest_distance(piece.vertices, from);
    const Scalar room = (std::min)(
      {std::abs(middle - from), std::abs(slack), rooms_[piece.saddle], (std::max)(std::abs(from), Scalar(1))});
    const std::size_t size = piece.vertices.size();
    std::vector<Scalar> values;
    Scalar last = from;
    for(std::size_t i = 0; i != size; ++i)
    {
      const Scalar step = room / 4 * (static_cast<Scalar>(i + 1) / static_cast<Scalar>(size));
      last = is_above ? (std::max)(from + step, std::nextafter(last, infinity))
                      : (std::min)(from - step, std::nextafter(last, -infinity));
      if(!(is_above ? from < last && last < middle : last < from && middle < last))
        throw_too_few_numbers(piece.vertices.front());
      values.push_back(last);
    }
    if(!is_above)
      std::reverse(values.begin(), values.end());
    return values;
  }

  void put_values(const std::vector<Index>& order, const std::vector<Scalar>& values, std::vector<Scalar>& moved) const
  {
    for(std::size_t i = 0; i != order.size(); ++i)
    {
      moved[order[i]] = values[i];
      if(!(std::abs(static_cast<double>(values[i]) - static_cast<double>(values_[order[i]])) < threshold_))
        throw_too_few_numbers(order[i]);
    }
  }

  [[noreturn]] void throw_too_few_numbers(Index v) const
  {
    throw Perturbed_ties_error(complex_.position(Vertex_index(v)));
  }

  Scalar largest_distance(const std::vector<Index>& vertices, Scalar value) const
  {
    Scalar distance = 0;
    for(const Index v : vertices)
      distance = (std::max)(distance, std::abs(values_[v] - value));
    return distance;
  }

  const Complex& complex_;
  const Weighted_graph& graph_; // its edges
  const std::vector<Index>& saddles_;
  const std::vector<Scalar>& rooms_;
  const std::vector<Scalar>& values_;
  const double threshold_;
  St_numbering st_numbering_;
  std::vector<Index> numbers_; // by vertex, of its piece
};

} // namespace CGAL::Reeb_graph::internal

#endif // CGAL_REEB_GRAPH_SIMPLIFICATION_INTERNAL_MOVED_PIECES_H
