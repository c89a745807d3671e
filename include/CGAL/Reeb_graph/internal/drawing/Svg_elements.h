// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_INTERNAL_DRAWING_SVG_ELEMENTS_H
#define CGAL_REEB_GRAPH_INTERNAL_DRAWING_SVG_ELEMENTS_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/Node_kind.h>
#include <CGAL/Reeb_graph/internal/io/text.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <ostream>
#include <string>
#include <vector>

namespace CGAL {
namespace Reeb_graph {
namespace internal {

// A rectangle, in pixels.
struct Box
{
  double left, top, right, bottom;

  bool overlaps(const Box& other) const
  {
    return left < other.right && other.left < right && top < other.bottom && other.top < bottom;
  }
  bool contains(const Box& other) const
  {
    return left <= other.left && top <= other.top && other.right <= right && other.bottom <= bottom;
  }
};

// What has been drawn, as boxes in a grid, to find places that are free.
class Occupied_plane
{
public:
  explicit Occupied_plane(const Box& bounds)
    : bounds_(bounds),
      columns_(number_of_cells(bounds.right - bounds.left)),
      rows_(number_of_cells(bounds.bottom - bounds.top)),
      cells_(columns_ * rows_)
  {}

  void add(const Box& box)
  {
    visit_cells(box, [&](std::size_t cell) { cells_[cell].push_back(box); });
  }

  // Adds a line of some width, in pieces whose boxes are about as small as it.
  void add_line(std::array<double, 2> from, std::array<double, 2> to, double width)
  {
    const double dx = to[0] - from[0], dy = to[1] - from[1], longest_piece = 6;
    const bool is_upright = (std::min)(std::abs(dx), std::abs(dy)) < 0.5;
    const double pieces = is_upright ? 1 : std::ceil((std::max)(std::abs(dx), std::abs(dy)) / longest_piece);
    for(std::size_t piece = 0; static_cast<double>(piece) < pieces; ++piece)
    {
      const auto i = static_cast<double>(piece);
      const double x0 = from[0] + dx * i / pieces, x1 = from[0] + dx * (i + 1) / pieces;
      const double y0 = from[1] + dy * i / pieces, y1 = from[1] + dy * (i + 1) / pieces;
      add({(std::min)(x0, x1) - width / 2, (std::min)(y0, y1) - width / 2, (std::max)(x0, x1) + width / 2,
           (std::max)(y0, y1) + width / 2});
    }
  }

  // Whether a box lies within the bounds and overlaps nothing.
  bool is_free(const Box& box) const
  {
    bool is_free = bounds_.contains(box);
    visit_cells(box, [&](std::size_t cell) {
      is_free = is_free && std::none_of(cells_[cell].begin(), cells_[cell].end(), [&](const Box& other) {
                  return box.overlaps(other);
                });
    });
    return is_free;
  }

private:
  static constexpr double cell_size = 32;

  static std::size_t number_of_cells(double length)
  {
    return static_cast<std::size_t>((std::max)(length, 0.) / cell_size) + 1;
  }

  static std::size_t cell_of(double distance, std::size_t size)
  {
    return static_cast<std::size_t>((std::clamp)(distance / cell_size, 0., static_cast<double>(size - 1)));
  }

  template <class Visit>
  void visit_cells(const Box& box, const Visit& visit) const
  {
    const std::size_t right = cell_of(box.right - bounds_.left, columns_),
                      bottom = cell_of(box.bottom - bounds_.top, rows_);
    for(std::size_t row = cell_of(box.top - bounds_.top, rows_); row <= bottom; ++row)
    {
      for(std::size_t column = cell_of(box.left - bounds_.left, columns_); column <= right; ++column)
        visit(row * columns_ + column);
    }
  }

  Box bounds_;
  std::size_t columns_, rows_;
  std::vector<std::vector<Box>> cells_;
};

// How a kind of nodes is drawn: colours that differ for all eyes (Okabe and Ito), and shapes that differ as well.
struct Node_style
{
  Node_kind kind;
  const char* colour;
  const char* shape; // a path around the node, for a radius of 1
};

constexpr std::array<Node_style, 5> node_styles = {
  {{Node_kind::MAXIMUM, "#d55e00", "m0-1.2l1.1 1.9h-2.2z"},
   {Node_kind::SADDLE, "#f0e442", "m-1 0a1 1 0 1 0 2 0a1 1 0 1 0-2 0z"},
   {Node_kind::MINIMUM, "#0072b2", "m0 1.2l1.1-1.9h-2.2z"},
   {Node_kind::DEGREE_TWO, "#009e73", "m-.7-.7h1.4v1.4h-1.4z"},
   {Node_kind::ISOLATED, "#cc79a7", "m0-1.2l1.2 1.2-1.2 1.2-1.2-1.2z"}}};

// A length in pixels, to a hundredth.
inline std::string pixels(double length)
{
  const double rounded = std::round(100 * length) / 100;
  return to_string_with_precision(rounded == 0 ? 0. : rounded, 9);
}

// Text as XML has it.
inline std::string escape_xml(const std::string& text)
{
  std::string escaped;
  for(const char c : xml_characters(text))
  {
    switch(c)
    {
    case '&': escaped += "&amp;"; break;
    case '<': escaped += "&lt;"; break;
    case '>': escaped += "&gt;"; break;
    case '"': escaped += "&quot;"; break;
    default: escaped += c;
    }
  }
  return escaped;
}

// A text in a drawing, and the box that it takes at most.
struct Svg_text
{
  std::string text;
  double x, y; // of its left or right end, or its middle, at half its height
  enum
  {
    START,
    MIDDLE,
    END
  } anchor;

  static constexpr double size = 11;
  static double width(std::string::size_type length) { return 0.62 * size * static_cast<double>(length); }

  Box box() const
  {
    const double length = width(text.size()), left = anchor == START ? x : anchor == END ? x - length : x - length / 2;
    return {left, y - 0.55 * size, left + length, y + 0.55 * size};
  }

  void write(std::ostream& out) const
  {
    out << "<text x=\"" << pixels(x) << "\" y=\"" << pixels(y + 0.35 * size) << '"'
        << (anchor == MIDDLE ? " text-anchor=\"middle\""
            : anchor == END  ? " text-anchor=\"end\""
                             : "")
        << '>' << escape_xml(text) << "</text>\n";
  }
};

inline void write_node_shape(std::ostream& out,
                             const Node_style& style,
                             double x,
                             double y,
                             double radius,
                             const std::string& title)
{
  out << "<g transform=\"translate(" << pixels(x) << ' ' << pixels(y) << ")\"><title>" << escape_xml(title)
      << "</title><path transform=\"scale(" << pixels(radius) << ")\" fill=\"" << style.colour << "\" d=\"M0 0"
      << style.shape << "\"/></g>\n";
}

inline void write_polyline(std::ostream& out,
                           const std::vector<std::array<double, 2>>& points,
                           const std::string& title)
{
  out << "<path d=\"";
  for(std::size_t i = 0; i != points.size(); ++i)
    out << (i == 0 ? "M" : i == 1 ? "L" : " ") << pixels(points[i][0]) << ' ' << pixels(points[i][1]);
  out << "\"><title>" << escape_xml(title) << "</title></path>\n";
}

} // namespace internal
} // namespace Reeb_graph
} // namespace CGAL

#endif // CGAL_REEB_GRAPH_INTERNAL_DRAWING_SVG_ELEMENTS_H
