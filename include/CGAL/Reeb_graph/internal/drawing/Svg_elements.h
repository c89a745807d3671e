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
#include <CGAL/Reeb_graph/internal/drawing/Occupied_plane.h>
#include <CGAL/Reeb_graph/internal/output/number_text.h>
#include <CGAL/Reeb_graph/internal/output/xml_text.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <ostream>
#include <string>
#include <vector>

namespace CGAL {
namespace Reeb_graph {
namespace internal {

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
