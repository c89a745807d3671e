// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_PLANE_LAYOUT_H
#define CGAL_REEB_GRAPH_PLANE_LAYOUT_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/exceptions.h>
#include <CGAL/Reeb_graph/internal/base/Index.h>
#include <CGAL/Reeb_graph/internal/base/Scalar_conversion.h>
#include <CGAL/Reeb_graph/internal/drawing/Branch_order.h>
#include <CGAL/Reeb_graph/internal/drawing/Value_scale.h>
#include <CGAL/Reeb_graph/internal/graph/graph_loops.h>
#include <CGAL/Reeb_graph/named_parameters.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <iterator>
#include <map>
#include <queue>
#include <utility>
#include <vector>

namespace CGAL::Reeb_graph::internal {

typedef std::array<double, 2> Plane_point; // column and height

// The height of a drawing of so many nodes, and the diameter of its largest nodes, in pixels.
inline double height_of_drawing(std::size_t number_of_nodes)
{
  return (std::clamp)(360 + 26 * std::sqrt(static_cast<double>(number_of_nodes)), 420., 1400.);
}
constexpr double largest_node_diameter = 13.2;

// The diameter of a node in columns, which are at least two of it apart.
constexpr double node_width = 0.25;

// Gives each of some heights, which ascend, a place beside each other, so that at each place the distance from one
// height to the next is not less than the given one. Returns the number of places as well.
inline std::pair<std::vector<std::size_t>, std::size_t> places_side_by_side(const std::vector<double>& heights,
                                                                            double distance)
{
  typedef std::pair<double, std::size_t> Last; // height at a place
  std::priority_queue<Last, std::vector<Last>, std::greater<Last>> last;
  std::vector<std::size_t> places;
  for(const double height : heights)
  {
    std::size_t place = last.size();
    if(!last.empty() && last.top().first + distance <= height)
    {
      place = last.top().second;
      last.pop();
    }
    last.emplace(height, place);
    places.push_back(place);
  }
  return {std::move(places), last.size()};
}

// How much room a column of such nodes takes to either side, beyond that for two of them.
inline double room_of_nodes(const std::vector<double>& heights, double distance)
{
  constexpr std::size_t most = 24; // more nodes lie closer together
  const std::size_t number = places_side_by_side(heights, distance).second;
  return node_width / 2 * static_cast<double>(std::clamp<std::size_t>(number, 2, most) - 2);
}

// Moves nodes of one column sideways where they would lie on each other, and all that is drawn around them. Points keep
// their height and, at each height, their order from the left to the right, so that no crossing comes or goes.
class Node_spreading
{
public:
  explicit Node_spreading(double distance) : distance_(distance) {}

  // Spreads the nodes of a column, whose heights ascend.
  void add_column(double column, const std::vector<double>& heights, double room)
  {
    for(auto begin = heights.begin(), end = begin; begin != heights.end(); begin = end)
    {
      for(++end; end != heights.end() && *end - *std::prev(end) < distance_;)
        ++end;
      if(end - begin > 1)
        zones_[column].push_back(zone(std::vector<double>(begin, end), room));
    }
    largest_room_ = (std::max)(largest_room_, room);
  }

  Plane_point operator()(Plane_point point) const
  {
    const double given = point[0];
    for_each_zone(point, [&](double column, const Zone& zone) {
      point[0] += zone.shift(point[1]) * (std::max)(0., 1 - std::abs(given - column) / zone.half_width);
    });
    return point;
  }

  // A polyline gets the points that its image needs.
  std::vector<Plane_point> operator()(const std::vector<Plane_point>& polyline) const
  {
    std::vector<Plane_point> result;
    for(std::size_t i = 0; i + 1 < polyline.size(); ++i)
    {
      const Plane_point &from = polyline[i], &to = polyline[i + 1];
      for(const double t : breaks(from, to))
        result.push_back((*this)({from[0] + t * (to[0] - from[0]), from[1] + t * (to[1] - from[1])}));
    }
    result.push_back((*this)(polyline.back()));
    return result;
  }

private:
  // Where a column is bent: by how much at some heights, linearly between them, and less beside the column.
  struct Zone
  {
    std::vector<Plane_point> shifts; // and heights, which ascend
    double half_width;

    double low() const { return shifts.front()[1]; }
    double high() const { return shifts.back()[1]; }

    std::vector<Plane_point>::const_iterator first_above(double height) const
    {
      return std::upper_bound(shifts.begin(), shifts.end(), height,
                              [](double value, const Plane_point& shift) { return value < shift[1]; });
    }

    double shift(double height) const
    {
      const auto above = first_above(height);
      if(above == shifts.begin() || above == shifts.end())
        return 0;
      const Plane_point &from = *std::prev(above), &to = *above;
      return from[0] + (height - from[1]) / (to[1] - from[1]) * (to[0] - from[0]);
    }
  };

  Zone zone(const std::vector<double>& heights, double room) const
  {
    const auto [places, number] = places_side_by_side(heights, distance_);
    const double size = static_cast<double>(number), half_width = node_width + room;
    const double step = (std::min)(node_width, 2 * half_width / size);
    Zone zone = {{{0, heights.front() - distance_ / 2}}, half_width};
    for(std::size_t i = 0; i != heights.size(); ++i)
      zone.shifts.push_back({step * (static_cast<double>(places[i]) - (size - 1) / 2), heights[i]});
    zone.shifts.push_back({0, heights.back() + distance_ / 2});
    return zone;
  }

  // The first zone that does not end below a height. The zones of a column are apart.
  static std::vector<Zone>::const_iterator first_zone(const std::vector<Zone>& zones, double height)
  {
    return std::lower_bound(zones.begin(), zones.end(), height,
                            [](const Zone& zone, double value) { return zone.high() < value; });
  }

  // Calls visit(column, zone) for the zones that a point is in.
  template <class Visit>
  void for_each_zone(const Plane_point& point, const Visit& visit) const
  {
    const double reach = node_width + largest_room_;
    for(auto column = zones_.lower_bound(point[0] - reach); column != zones_.end() && column->first < point[0] + reach;
        ++column)
    {
      const auto zone = first_zone(column->second, point[1]);
      if(zone != column->second.end() && zone->low() <= point[1]
         && std::abs(point[0] - column->first) < zone->half_width)
        visit(column->first, *zone);
    }
  }

  // Where the image of a segment is bent, from 0 to less than 1. What passes by several columns needs no bend there, as
  // it is all but horizontal.
  std::vector<double> breaks(const Plane_point& from, const Plane_point& to) const
  {
    std::vector<double> result = {0};
    const auto add = [&](int axis, double coordinate) {
      const double t = (coordinate - from[axis]) / (to[axis] - from[axis]);
      if(t > 0 && t < 1)
        result.push_back(t);
    };
    const auto add_zone = [&](double column, const Zone& zone) {
      for(const double side : {-1, 0, 1})
        add(0, column + side * zone.half_width);
      for(auto shift = zone.first_above(from[1]); shift != zone.shifts.end() && (*shift)[1] < to[1]; ++shift)
        add(1, (*shift)[1]);
    };
    for_each_zone(from, add_zone);
    for_each_zone(to, add_zone);
    if(from[0] == to[0]) // which can pass by several zones of its column
    {
      const auto column = zones_.find(from[0]);
      if(column != zones_.end())
      {
        auto zone = first_zone(column->second, from[1]);
        for(; zone != column->second.end() && zone->low() < to[1]; ++zone)
          add_zone(column->first, *zone);
      }
    }
    std::sort(result.begin(), result.end());
    result.erase(std::unique(result.begin(), result.end()), result.end());
    return result;
  }

  double distance_; // nodes of less are spread
  double largest_room_ = 0;
  std::map<double, std::vector<Zone>> zones_;
};

// Gives a column to each branch, the nearest to its trunk or to its parent that its place in the order leaves free at
// all of its heights. Components lie side by side, or above each other, the tallest at the left.
class Branch_columns
{
public:
  // `sorted_heights` are those of the nodes.
  // `own_heights` are those of the nodes of each branch, `distance` is from where on nodes lie above each other.
  Branch_columns(const Branch_tree& tree,
                 const Branch_order& order,
                 const std::vector<double>& sorted_heights,
                 const std::vector<std::vector<double>>& own_heights,
                 double distance)
    : tree_(tree),
      order_(order),
      own_heights_(own_heights),
      distance_(distance),
      columns_(tree.branches.size(), 0)
  {
    for(const std::vector<double>& heights : own_heights)
      rooms_.push_back(room_of_nodes(heights, distance));
    std::vector<Index> trunks;
    for(Index branch = 0; branch != tree.branches.size(); ++branch)
    {
      if(tree.branches[branch].parent == no_index)
        trunks.push_back(branch);
    }
    const auto length = [&](Index trunk) { return order.extent(trunk).high - order.extent(trunk).low; };
    std::sort(trunks.begin(), trunks.end(), [&](Index a, Index b) {
      return length(a) != length(b) ? length(a) > length(b) : tree.branches[a].lower < tree.branches[b].lower;
    });
    Skyline components(sorted_heights, -gap_of_components);
    for(const Index trunk : trunks)
    {
      const std::vector<Index> branches = order.branches_of_trunk(trunk);
      place_component(branches, trunk);
      const Height_range extent = widened(order.extent(trunk));
      const double shift = components.highest(extent) + gap_of_components - left_end(branches);
      double right = 0;
      for(const Index branch : branches)
        right = (std::max)(right, (columns_[branch] += shift) + rooms_[branch]);
      components.raise(extent, right);
    }
  }

  double operator[](Index branch) const { return columns_[branch]; }

  // The room that nodes take beside the column, and beyond that of two.
  double room(Index branch) const { return rooms_[branch]; }

  // The distance to the next branch on the way to its parent: short ones lie closer.
  double width(Index branch) const
  {
    constexpr double short_length = 1. / 40;
    const Height_range& extent = order_.extent(branch);
    return extent.high - extent.low < short_length ? 0.5 : 1;
  }

private:
  static constexpr double gap_of_components = 1.5; // in columns
  static constexpr double gap_of_ends = 1. / 60;   // in a column, of the whole height

  static Height_range widened(const Height_range& range) { return {range.low - gap_of_ends, range.high + gap_of_ends}; }

  double left_end(const std::vector<Index>& branches) const
  {
    double left = 0;
    for(const Index branch : branches)
      left = (std::min)(left, columns_[branch] - rooms_[branch]);
    return left;
  }

  // The heights at which a branch is, with some distance to what lies above or below it in the same column.
  Height_range taken_heights(Index branch) const
  {
    const Drawn_branch& drawn = tree_.branches[branch];
    Height_range range = order_.own_extent(branch);
    range.low -= drawn.is_lower_attached ? 0 : gap_of_ends;
    range.high += drawn.is_upper_attached || drawn.is_closing ? 0 : gap_of_ends;
    const std::vector<double>& nodes = own_heights_[branch];
    if(!nodes.empty())
      range.extend({nodes.front() - distance_, nodes.back() + distance_});
    return range;
  }

  void place_component(const std::vector<Index>& branches, Index trunk)
  {
    const auto middle = std::find(branches.begin(), branches.end(), trunk);
    const std::vector<Index> right(middle + 1, branches.end());
    const std::vector<Index> left(std::make_reverse_iterator(middle), branches.rend());
    place_side(right, rooms_[trunk], 1);
    place_side(left, rooms_[trunk], -1);
  }

  // Heights of the nodes at the ends of branches, ascending, each once: branches are apart where these are.
  std::vector<double> heights_of_ends(const std::vector<Index>& branches) const
  {
    std::vector<double> heights;
    heights.reserve(2 * branches.size());
    for(const Index branch : branches)
    {
      heights.push_back(order_.own_extent(branch).low);
      heights.push_back(order_.own_extent(branch).high);
    }
    std::sort(heights.begin(), heights.end());
    heights.erase(std::unique(heights.begin(), heights.end()), heights.end());
    return heights;
  }

  // The branches at one side of the trunk, from the inside to the outside.
  void place_side(const std::vector<Index>& branches, double room_of_trunk, int side)
  {
    const std::vector<double> heights = heights_of_ends(branches);
    Skyline inner(heights, room_of_trunk);
    for(const Index branch : branches)
    {
      const Height_range range = taken_heights(branch);
      const double column = inner.highest(range) + (std::max)(width(branch), 2 * node_width + rooms_[branch]);
      inner.raise(range, column + rooms_[branch]);
      columns_[branch] = side * column;
    }
    draw_to_parents(branches, heights, side);
  }

  // Moves those branches outwards whose parents lie there.
  void draw_to_parents(const std::vector<Index>& branches, const std::vector<double>& heights, int side)
  {
    const double far_out = -2. - static_cast<double>(branches.size());
    Skyline outer(heights, far_out); // the columns, turned around
    for(auto branch = branches.rbegin(); branch != branches.rend(); ++branch)
    {
      const Height_range range = taken_heights(*branch);
      const double bound = outer.highest(range);
      if(order_.side(*branch) == -side && bound != far_out)
        columns_[*branch] = side * (std::max)(side * columns_[*branch], -bound - 1 - rooms_[*branch]);
      outer.raise(range, rooms_[*branch] - side * columns_[*branch]);
    }
  }

  const Branch_tree& tree_;
  const Branch_order& order_;
  const std::vector<std::vector<double>>& own_heights_;
  double distance_;
  std::vector<double> rooms_, columns_;
};

// The curve by which an arc goes from a node at `from` to a point at `to` in another column: sideways first, and then
// in a rounded corner to the vertical. On the way it rises by a small part of `gap`, the less the farther it goes, so
// that arcs that go on at other columns do not meet it.
inline void add_corner(Plane_point from,
                       Plane_point to,
                       double largest_radius,
                       double gap,
                       std::vector<Plane_point>& curve)
{
  constexpr int steps = 8;
  constexpr double right_angle = 1.57079632679489661923;
  const double distance = to[0] - from[0], height = to[1] - from[1];
  const bool is_far = std::abs(distance) > largest_radius;
  const double radius = is_far ? std::copysign(largest_radius, distance) : distance;
  const double rise = is_far ? std::copysign(0.1 * gap / (1 + std::abs(distance)), height) : 0;
  curve.push_back(from);
  for(int i = is_far ? 0 : 1; i != steps; ++i)
  {
    const double angle = right_angle * i / steps;
    curve.push_back({to[0] - radius * (1 - std::sin(angle)), from[1] + rise + (height - rise) * (1 - std::cos(angle))});
  }
  curve.push_back(to);
}

// Where nodes and arcs lie, in columns and heights from 0 to 1.
class Plane_drawing
{
public:
  Plane_drawing(const std::vector<Leaf_pruning::Arc>& arcs, const std::vector<double>& heights)
    : heights_(made_different(heights)),
      tree_(arcs, heights_),
      positions_(heights.size()),
      curves_(arcs.size())
  {
    const double distance = largest_node_diameter / height_of_drawing(heights.size());
    std::vector<std::vector<double>> own_heights(tree_.branches.size());
    for(Index node = 0; node != positions_.size(); ++node)
      own_heights[tree_.branch_of_node[node]].push_back(heights_[node]);
    const Branch_order order(tree_, heights_);
    const Branch_columns columns(tree_, order, heights_, own_heights, distance);
    for(Index node = 0; node != positions_.size(); ++node)
      positions_[node] = columns[tree_.branch_of_node[node]];
    for(Index branch = 0; branch != tree_.branches.size(); ++branch)
    {
      const Drawn_branch& drawn = tree_.branches[branch];
      for(std::size_t i = drawn.first_arc; i != drawn.end_of_arcs; ++i)
        curves_[tree_.arcs[i]] = curve(arcs[tree_.arcs[i]], columns[branch], columns.width(branch));
    }
    spread(columns, distance);
  }

  // By node and by arc.
  const std::vector<double>& positions() const { return positions_; }
  const std::vector<std::vector<Plane_point>>& curves() const { return curves_; }

private:
  static constexpr double corner_height = 0.05;

  // Heights of nodes, which ascend, such that no two are the same.
  static std::vector<double> made_different(std::vector<double> heights)
  {
    constexpr double least_step = 1e-12;
    for(std::size_t node = 1; node < heights.size(); ++node)
      heights[node] = (std::max)(heights[node], heights[node - 1] + least_step);
    return heights;
  }

  // Nodes of nearly one height in one column lie beside each other.
  void spread(const Branch_columns& columns, double distance)
  {
    std::map<double, std::pair<std::vector<double>, double>> nodes; // by column, their heights and their room
    for(Index node = 0; node != positions_.size(); ++node)
    {
      auto& [heights, room] = nodes[positions_[node]];
      heights.push_back(heights_[node]);
      room = (std::max)(room, columns.room(tree_.branch_of_node[node]));
    }
    Node_spreading spreading(distance);
    for(const auto& [column, heights_and_room] : nodes)
      spreading.add_column(column, heights_and_room.first, heights_and_room.second);
    for(Index node = 0; node != positions_.size(); ++node)
      positions_[node] = spreading({positions_[node], heights_[node]})[0];
    for(std::vector<Plane_point>& curve : curves_)
      curve = spreading(curve);
  }

  // The distances of a height to the next ones that nodes have.
  double gap_above(double height) const
  {
    const auto next = std::upper_bound(heights_.begin(), heights_.end(), height);
    return next == heights_.end() ? 0 : *next - height;
  }
  double gap_below(double height) const
  {
    const auto next = std::lower_bound(heights_.begin(), heights_.end(), height);
    return next == heights_.begin() ? 0 : height - *(next - 1);
  }

  // The curve of an arc that is vertical in a column, with corners where its nodes are not in this column.
  std::vector<Plane_point> curve(const Leaf_pruning::Arc& arc, double column, double radius) const
  {
    const Plane_point lower = {positions_[arc.lower], heights_[arc.lower]};
    const Plane_point upper = {positions_[arc.upper], heights_[arc.upper]};
    const bool is_bent_below = lower[0] != column, is_bent_above = upper[0] != column;
    const double height = (std::min)((upper[1] - lower[1]) / (is_bent_below && is_bent_above ? 2 : 1), corner_height);
    std::vector<Plane_point> points = {lower}, points_from_above = {upper};
    if(is_bent_below)
      add_corner(lower, {column, lower[1] + height}, radius, (std::min)(gap_above(lower[1]), corner_height), points);
    if(is_bent_above)
      add_corner(upper, {column, upper[1] - height}, radius, (std::min)(gap_below(upper[1]), corner_height),
                 points_from_above);
    points.insert(points.end(), points_from_above.rbegin(), points_from_above.rend());
    points.erase(std::unique(points.begin(), points.end()), points.end());
    if(points.size() == 1)
      points.push_back(upper);
    return points;
  }

  std::vector<double> heights_; // which ascend
  Branch_tree tree_;
  std::vector<double> positions_;
  std::vector<std::vector<Plane_point>> curves_;
};

} // namespace CGAL::Reeb_graph::internal

namespace CGAL::Reeb_graph {

/// \ingroup PkgReebGraphDrawing
///
/// \brief where the nodes and the arcs of a Reeb graph lie in a drawing in the plane whose vertical axis is the scalar
/// value; see `lay_out_in_plane()`.
struct Plane_layout
{
  /// by number of node, its horizontal position. Neighboring columns are 1 apart, those of short branches half of that,
  /// and those with many nodes of nearly one value more. Such nodes, whose signs would lie on each other in the drawing
  /// of `write_svg()`, are 0.25 apart, or less if they are more than 24. The position is greater than -0.5. The
  /// vertical position of a node is its value, or in an order that is not that of numbers up or down its number.
  std::vector<double> node_positions;

  /// by arc, in the order of `edges(graph)`, the points of a curve from its lower node to its upper one, horizontal and
  /// vertical position. The vertical ones do not descend, or do not ascend if larger numbers come first in the order.
  /// Instead of an infinite value there is a finite one, a tenth of the range beyond the finite values.
  std::vector<std::vector<std::array<double, 2>>> arc_polylines;
};

/// \ingroup PkgReebGraphDrawing
///
/// \brief lays out a Reeb graph in the plane: the height of a node is its value, arcs ascend.
///
/// In another order than that of `operator<`, larger numbers may come first. Then draw the axis with the largest number
/// at the bottom, and arcs ascend again. If the numbers neither ascend nor fall from node to node, the height of a node
/// is its number, its place in the order.
///
/// The graph consists of branches, from the least persistent one to the trunk of each component, as for `simplify()`.
/// Of the sides of a loop, all but one are branches that end where the loop closes. A branch is drawn in a column of
/// its own, and is led in a curve to the branch at which it is attached. Branches share a column where they are at
/// different heights. Their sides and their order are chosen so that few arcs cross: none in a graph whose branches all
/// go up, as in a merge tree, or all go down. Components lie side by side, the tallest first. Nodes of nearly one value
/// lie beside each other.
///
/// With \f$ n \f$ nodes and arcs it takes \f$ O(n \log^2 n) \f$ time. Equal graphs have equal layouts.
///
/// \tparam ReebGraph the type `Graph` of the traits class, or another bidirectional graph with `std::size_t` as vertex
///         descriptor
///
/// \param graph a Reeb graph, computed with any named parameters
/// \param np an optional sequence of \ref bgl_namedparameters "Named Parameters": `geom_traits`, as for `simplify()`
///
/// \reebGraphComplexity
///
/// \exception Reeb_graph::Parameter_error if the number of a value is NaN
/// \exception Reeb_graph::Graph_mismatch_error if an arc does not lead to a node of higher number
template <class ReebGraph, class NamedParameters = parameters::Default_named_parameters>
Plane_layout lay_out_in_plane(const ReebGraph& graph, const NamedParameters& np = parameters::default_values())
{
  static_assert(
    internal::are_met<internal::Plain_reeb_graph<ReebGraph>, internal::Nodes_have_numbers<ReebGraph, NamedParameters>>);
  const std::vector<internal::Ascending_arc> arcs = internal::read_arcs(graph);
  const std::vector<double> values = internal::drawn_values(internal::numbers_of_nodes(graph, np));
  const internal::Value_scale scale(values);
  std::vector<double> heights;
  heights.reserve(values.size());
  for(const double value : values)
    heights.push_back(scale.height(value));
  const internal::Plane_drawing drawing(arcs, heights);
  Plane_layout layout;
  layout.node_positions = drawing.positions();
  layout.arc_polylines = drawing.curves();
  for(std::size_t i = 0; i != arcs.size(); ++i)
  {
    double last = scale.finite_value(values[arcs[i].lower]);
    const double end = scale.finite_value(values[arcs[i].upper]);
    layout.arc_polylines[i].front()[1] = last;
    for(std::size_t k = 1; k != layout.arc_polylines[i].size(); ++k)
    {
      double& value = layout.arc_polylines[i][k][1];
      const auto [low, high] = std::minmax(last, end);
      value = last = (std::clamp)(scale.value(value), low, high); // rounded values could go back
    }
    layout.arc_polylines[i].back()[1] = end;
  }
  return layout;
}

} // namespace CGAL::Reeb_graph

#endif // CGAL_REEB_GRAPH_PLANE_LAYOUT_H
