// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_IO_SVG_H
#define CGAL_REEB_GRAPH_IO_SVG_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/graph_topology.h>
#include <CGAL/Reeb_graph/internal/base/Scalar_conversion.h>
#include <CGAL/Reeb_graph/internal/base/lengths.h>
#include <CGAL/Reeb_graph/internal/drawing/Value_scale.h>
#include <CGAL/Reeb_graph/internal/graph/graph_loops.h>
#include <CGAL/Reeb_graph/internal/io/text.h>
#include <CGAL/Reeb_graph/named_parameters.h>
#include <CGAL/Reeb_graph/options.h>
#include <CGAL/Reeb_graph/plane_layout.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <locale>
#include <ostream>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Reeb_graph::internal {

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

// Boxes of all that has been drawn, in a grid, to find places that are free.
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

// A graph that is to be drawn.
struct Drawn_node
{
  double position, value; // in columns
  Node_kind kind;
  std::string label, title;
};

struct Drawn_arc
{
  std::vector<std::array<double, 2>> points; // positions and values
  std::string label, title;
};

// Draws a graph: an axis with its grid, arcs, nodes, labels where there is room for them, and a legend.
class Svg_drawing
{
public:
  Svg_drawing(std::vector<Drawn_node> nodes, std::vector<Drawn_arc> arcs, std::string axis_title)
    : nodes_(std::move(nodes)),
      arcs_(std::move(arcs)),
      axis_title_(std::move(axis_title)),
      scale_(values())
  {
    double columns = 0;
    for(const Drawn_node& node : nodes_)
      columns = (std::max)(columns, node.position);
    for(const Drawn_arc& arc : arcs_)
    {
      for(const std::array<double, 2>& point : arc.points)
        columns = (std::max)(columns, point[0]);
    }
    height_ = height_of_drawing(nodes_.size());
    column_width_ = (std::clamp)(1100 / (columns + 1), 30., 56.);
    radius_ = (std::min)(column_width_ * node_width, largest_node_diameter) / 2.4;
    std::size_t longest_label = 0;
    for(const Drawn_node& node : nodes_)
      longest_label = (std::max)(longest_label, node.label.size());
    width_ = column_width_ * (columns + 1) + 2 * Svg_text::width(longest_label);
    indent_ = (width_ - column_width_ * columns) / 2;
    for(Drawn_arc& arc : arcs_)
    {
      for(std::array<double, 2>& point : arc.points)
        point = {x(point[0]), y(point[1])};
    }
  }

  void write(std::ostream& out, const std::string& title, const std::string& description) const
  {
    const double width = left + width_ + right, height = top + height_ + bottom;
    out << "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 "
        << pixels(width) << ' ' << pixels(height)
        << "\" role=\"img\" font-family=\"Helvetica, Arial, sans-serif\" font-size=\"" << pixels(Svg_text::size)
        << "\">\n<title>" << escape_xml(title) << "</title>\n<desc>" << escape_xml(description)
        << "</desc>\n<rect fill=\"white\" width=\"" << pixels(width) << "\" height=\"" << pixels(height) << "\"/>\n";
    write_axis(out);
    out << "<g id=\"arcs\" fill=\"none\" stroke=\"#455a64\" stroke-width=\"" << (radius_ < 5 ? "1.3" : "1.8")
        << "\" stroke-linejoin=\"round\">\n";
    for(const Drawn_arc& arc : arcs_)
      write_polyline(out, arc.points, arc.title);
    out << "</g>\n<g id=\"nodes\" stroke=\"#263238\" stroke-width=\".18\">\n";
    for(const Drawn_node& node : nodes_)
      write_node_shape(out, style_of(node.kind), x(node.position), y(node.value), radius_, node.title);
    out << "</g>\n";
    write_labels(out);
    write_legend(out, description);
    out << "</svg>\n";
  }

private:
  static constexpr double left = 84, right = 140, top = 24, bottom = 24; // around the drawing

  std::vector<double> values() const
  {
    std::vector<double> values;
    values.reserve(nodes_.size());
    for(const Drawn_node& node : nodes_)
      values.push_back(node.value);
    return values;
  }

  double x(double position) const { return left + indent_ + column_width_ * position; }
  double y(double value) const { return top + height_ * (1 - scale_.height(value)); }

  static const Node_style& style_of(Node_kind kind)
  {
    return *std::find_if(node_styles.begin(), node_styles.end() - 1,
                         [&](const Node_style& style) { return style.kind == kind; });
  }

  void write_axis(std::ostream& out) const
  {
    const auto [lowest, highest] = scale_.finite_range();
    const std::vector<double> ticks = round_ticks(lowest, highest, static_cast<int>(height_ / 100));
    const double step = ticks.size() > 1 ? ticks[1] - ticks[0] : 1;
    const double largest = (std::max)(std::abs(lowest), std::abs(highest));
    const int digits = (std::clamp)(static_cast<int>(std::ceil(std::log10((std::max)(largest / step, 1.)))) + 1, 6, 17);
    std::vector<std::pair<double, std::string>> marks;
    marks.reserve(ticks.size() + 2);
    for(const double tick : ticks)
      marks.emplace_back(tick, to_string_with_precision(tick, digits));
    if(scale_.lowest() < lowest)
      marks.emplace_back(scale_.lowest(), "-\xe2\x88\x9e");
    if(scale_.highest() > highest)
      marks.emplace_back(scale_.highest(), "\xe2\x88\x9e");

    out << "<g id=\"grid\" stroke=\"#e3e8ea\">\n";
    for(const auto& mark : marks)
      out << "<path d=\"M" << pixels(left) << ' ' << pixels(y(mark.first)) << 'h' << pixels(width_) << "\"/>\n";
    out << "</g>\n<path stroke=\"#90a4ae\" d=\"M" << pixels(left) << ' ' << pixels(top - 8) << 'V'
        << pixels(top + height_ + 8) << "\"/>\n<g id=\"ticks\" fill=\"#455a64\">\n";
    for(const auto& mark : marks)
      Svg_text{mark.second, left - 8, y(mark.first), Svg_text::END}.write(out);
    out << "</g>\n<text id=\"axis\" text-anchor=\"middle\" fill=\"#263238\" transform=\"translate(18 "
        << pixels(top + height_ / 2) << ") rotate(-90)\">" << escape_xml(axis_title_) << "</text>\n";
  }

  void write_legend(std::ostream& out, const std::string& description) const
  {
    const double x = left + width_ + 24;
    double y = top + 4;
    out << "<g id=\"legend\" fill=\"#263238\">\n";
    for(const Node_style& style : node_styles)
    {
      const auto number =
        std::count_if(nodes_.begin(), nodes_.end(), [&](const Drawn_node& node) { return node.kind == style.kind; });
      if(number == 0)
        continue;
      out << "<path stroke=\"#263238\" stroke-width=\".18\" fill=\"" << style.colour << "\" transform=\"translate("
          << pixels(x) << ' ' << pixels(y) << ") scale(5.5)\" d=\"M0 0" << style.shape << "\"/>\n";
      Svg_text{to_string(style.kind) + " (" + std::to_string(number) + ")", x + 14, y, Svg_text::START}.write(out);
      y += 20;
    }
    y += 4;
    for(std::size_t begin = 0; begin < description.size();)
    {
      const std::size_t end = (std::min)(description.find(", ", begin), description.size());
      Svg_text{description.substr(begin, end - begin), x - 6, y, Svg_text::START}.write(out);
      y += 16;
      begin = end + 2;
    }
    out << "</g>\n";
  }

  // Labels of nodes come first.
  void write_labels(std::ostream& out) const
  {
    constexpr std::size_t most_nodes = 5000; // with labels, whose places would take more memory than all the rest
    if(nodes_.size() > most_nodes)
      return;
    Occupied_plane plane({left + 2, 2, left + width_ + 10, top + height_ + bottom - 2});
    for(const Drawn_node& node : nodes_)
    {
      const double x0 = x(node.position), y0 = y(node.value), reach = 1.2 * radius_;
      plane.add({x0 - reach, y0 - reach, x0 + reach, y0 + reach});
    }
    for(const Drawn_arc& arc : arcs_)
    {
      for(std::size_t i = 1; i < arc.points.size(); ++i)
        plane.add_line(arc.points[i - 1], arc.points[i], 3);
    }
    const auto place = [&](const std::vector<Svg_text>& candidates) {
      const auto found = std::find_if(candidates.begin(), candidates.end(),
                                      [&](const Svg_text& text) { return plane.is_free(text.box()); });
      if(found == candidates.end())
        return;
      plane.add(found->box());
      found->write(out);
    };
    out << "<g id=\"node_labels\" fill=\"#263238\">\n";
    for(const Drawn_node& node : nodes_)
      place(places_of_label(node));
    out << "</g>\n<g id=\"arc_labels\" fill=\"#78909c\" font-style=\"italic\">\n";
    for(const Drawn_arc& arc : arcs_)
      place(places_of_label(arc));
    out << "</g>\n";
  }

  std::vector<Svg_text> places_of_label(const Drawn_node& node) const
  {
    const double x0 = x(node.position), y0 = y(node.value), d = radius_ + 3, line = 0.55 * Svg_text::size + radius_ + 2;
    const std::string& text = node.label;
    return {{text, x0 + d, y0, Svg_text::START},
            {text, x0 - d, y0, Svg_text::END},
            {text, x0 + d, y0 - line + 4, Svg_text::START},
            {text, x0 + d, y0 + line - 4, Svg_text::START},
            {text, x0 - d, y0 - line + 4, Svg_text::END},
            {text, x0 - d, y0 + line - 4, Svg_text::END},
            {text, x0, y0 - line, Svg_text::MIDDLE},
            {text, x0, y0 + line, Svg_text::MIDDLE}};
  }

  // Beside the middle of the longest straight part, or elsewhere along the arc.
  static std::vector<Svg_text> places_of_label(const Drawn_arc& arc)
  {
    std::size_t longest = 0;
    const auto length = [&](std::size_t i) {
      return length_of(arc.points[i + 1][0] - arc.points[i][0], arc.points[i + 1][1] - arc.points[i][1], 0);
    };
    for(std::size_t i = 0; i + 1 < arc.points.size(); ++i)
    {
      if(length(i) > length(longest))
        longest = i;
    }
    std::vector<Svg_text> places;
    const auto &from = arc.points[longest], &to = arc.points[longest + 1];
    const auto add_beside = [&](double x0, double y0) {
      places.push_back({arc.label, x0 + 4, y0, Svg_text::START});
      places.push_back({arc.label, x0 - 4, y0, Svg_text::END});
    };
    for(const double t : {0.5, 0.35, 0.65, 0.2, 0.8})
      add_beside(from[0] + t * (to[0] - from[0]), from[1] + t * (to[1] - from[1]));
    for(const std::array<double, 2>& point : arc.points) // a bend of an arc whose straight part is short
    {
      places.push_back({arc.label, point[0], point[1] - 8, Svg_text::MIDDLE});
      places.push_back({arc.label, point[0], point[1] + 8, Svg_text::MIDDLE});
      add_beside(point[0], point[1]);
    }
    return places;
  }

  std::vector<Drawn_node> nodes_;
  std::vector<Drawn_arc> arcs_; // their points in pixels
  std::string axis_title_;
  Value_scale scale_;
  double width_, height_, column_width_, indent_, radius_; // in pixels
};

// A number and what it counts.
inline std::string counted(std::size_t number, const std::string& name)
{
  return std::to_string(number) + ' ' + name + (number == 1 ? "" : "s");
}

} // namespace CGAL::Reeb_graph::internal

namespace CGAL::Reeb_graph {

/// \ingroup PkgReebGraphDrawing
///
/// \brief draws a Reeb graph as a picture in the format SVG, which web browsers show and vector graphics programs edit.
///
/// The height of a node is its value, as the axis shows. The axis falls if larger numbers come first in the order, and
/// counts the nodes in any order but that of numbers. `lay_out_in_plane()` puts nodes and arcs in their places. Colors
/// and shapes of nodes show their kinds; people with color blindness can distinguish the colors. The label of a node
/// is `n` and its number, and in a small graph its value, too. The label of an arc is its number in the order of
/// `edges(graph)`. Labels are where there is room: none lies on another one, on a node, or on an arc. A graph of more
/// than 5,000 nodes has no labels. Point at a node or an arc to read all about it. There is no script in the file.
/// Equal graphs give equal files. Bytes of names that are not UTF-8 become U+FFFD.
///
/// \tparam ReebGraph the type `Graph` of a model of `ReebGraphTraits`
///
/// \param output a stream, whose state tells whether writing succeeded, or the name of a file
/// \param graph a Reeb graph, computed with any named parameters
/// \param np an optional sequence of \ref bgl_namedparameters "Named Parameters" among the ones listed below
///
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{field_name}
///     \cgalParamDescription{what the values are, in UTF-8, for the axis}
///     \cgalParamType{`std::string`}
///     \cgalParamDefault{`"value"`}
///   \cgalParamNEnd
///   \cgalParamNBegin{field_unit}
///     \cgalParamDescription{the unit of the values, in UTF-8, for the axis}
///     \cgalParamType{`std::string`}
///     \cgalParamDefault{none}
///   \cgalParamNEnd
///   \cgalParamNBegin{vertex_index_map}
///     \cgalParamDescription{a property map that associates an index with each vertex of the mesh: that of a node is
///                           told where the pointer rests on it}
///     \cgalParamType{a model of `ReadablePropertyMap` with the vertex descriptors of the mesh as key type and an
///                    integer type as value type}
///     \cgalParamDefault{none}
///   \cgalParamNEnd
///   \cgalParamNBegin{geom_traits}
///     \cgalParamDescription{an instance of a traits class whose `scalar_to_double_object()` makes numbers of the
///                           values}
///     \cgalParamType{a model of `ReebGraphNumberTraits`}
///     \cgalParamDefault{none: `CGAL::to_double()` of the values}
///   \cgalParamNEnd
/// \cgalNamedParamsEnd
///
/// \reebGraphComplexity
///
/// \exception Reeb_graph::Parameter_error if the number of a value is NaN
/// \exception Reeb_graph::Graph_mismatch_error if an arc does not lead to a node of higher number
/// \exception Reeb_graph::File_error if the file cannot be written
template <class ReebGraph, class NamedParameters = parameters::Default_named_parameters>
void write_svg(const internal::Output& output,
               const ReebGraph& graph,
               const NamedParameters& np = parameters::default_values())
{
  static_assert(internal::are_met<internal::Augmented_reeb_graph<ReebGraph>,
                                  internal::Nodes_have_numbers<ReebGraph, NamedParameters>>);
  using parameters::get_parameter;
  const std::string name = internal::parameter_or(np, internal::field_name, std::string("value"));
  const std::string unit = internal::parameter_or(np, internal::field_unit, std::string());
  const auto vertex_index_map = get_parameter(np, internal_np::vertex_index);
  const std::string unit_text = unit.empty() ? "" : ' ' + unit;
  const std::vector<double> values = internal::numbers_of_nodes(graph, np), heights = internal::drawn_values(values);
  const auto value_text = [&](std::size_t node, int digits = 6) {
    return internal::to_string_with_precision(values[node], digits);
  };
  constexpr std::size_t few_nodes = 40;

  Plane_layout layout = lay_out_in_plane(graph, np);
  std::vector<internal::Drawn_node> nodes;
  for(std::size_t node = 0; node != num_vertices(graph); ++node)
  {
    std::ostringstream title;
    title.imbue(std::locale::classic());
    title << "node " << node << ": " << graph[node].kind << '\n' << name << ' ' << value_text(node) << unit_text;
    if constexpr(internal::is_given<decltype(vertex_index_map)>)
      title << "\nvertex " << get(vertex_index_map, graph[node].vertex);
    nodes.push_back({layout.node_positions[node], heights[node], graph[node].kind,
                     'n' + std::to_string(node) + (num_vertices(graph) > few_nodes ? "" : ": " + value_text(node, 4)),
                     title.str()});
  }
  std::vector<internal::Drawn_arc> arcs;
  for(auto range = edges(graph); range.first != range.second; ++range.first)
  {
    const std::size_t lower = source(*range.first, graph), upper = target(*range.first, graph), number = arcs.size();
    std::ostringstream title;
    title.imbue(std::locale::classic());
    title << "arc " << number << ": from node " << lower << " to node " << upper << '\n'
          << name << " from " << value_text(lower) << " to " << value_text(upper) << unit_text;
    arcs.push_back({std::move(layout.arc_polylines[number]), std::to_string(number), title.str()});
  }
  std::string description = internal::counted(num_vertices(graph), "node");
  description.append(", ").append(internal::counted(num_edges(graph), "arc"));
  description.append(", ").append(internal::counted(number_of_loops(graph), "loop"));
  description.append(", ").append(internal::counted(number_of_components(graph), "component"));
  const std::string axis_title = heights != values ? "order of " + name
                               : unit.empty()      ? name
                                                   : name + " [" + unit + "]";
  const internal::Svg_drawing drawing(std::move(nodes), std::move(arcs), axis_title);
  output([&](std::ostream& out) { drawing.write(out, "Reeb graph", description); });
}

} // namespace CGAL::Reeb_graph

#endif // CGAL_REEB_GRAPH_IO_SVG_H
