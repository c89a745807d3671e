// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_SKELETON_INTERNAL_SKELETON_LINES_H
#define CGAL_REEB_GRAPH_SKELETON_INTERNAL_SKELETON_LINES_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/internal/base/Index.h>
#include <CGAL/Reeb_graph/internal/base/Progress.h>
#include <CGAL/Reeb_graph/skeleton/internal/Component_filling.h>
#include <CGAL/Reeb_graph/skeleton/internal/Graph_chains.h>
#include <CGAL/Reeb_graph/skeleton/internal/Skeleton_options.h>
#include <CGAL/Reeb_graph/skeleton/internal/Surface_tree.h>

#include <CGAL/Bbox_3.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL::Reeb_graph::internal::skeleton {

// A point of the skeleton.
struct Line_point
{
  Point point;
  double radius = 0;
  double inscribed_radius = 0;
  double place = 0;          // on its chain
  Point on_surface;          // a point of the surface near it
  Vector area = NULL_VECTOR; // that of the contour
};

// The kinds of nodes of the skeleton.
enum class Line_end
{
  TIP,
  BORDER,
  JUNCTION
};

// The lines of a skeleton: the centers of contours of the chains, and between them junctions where the lines of the
// chains meet.
class Skeleton_lines
{
public:
  struct Node
  {
    Line_end kind = Line_end::JUNCTION;
    Line_point point;
    std::optional<Mesh::Vertex_index> vertex = std::nullopt; // of the filled surface, where the point is on it,
    std::optional<Mesh::Face_index> face = std::nullopt;     // or the face
    double rim = 0;                                          // how far the contours of a chain from a border pass that
    double reach = 0;                                        // how far contours are not those of tubes, at a junction

    Surface_place place() const { return {point.point, vertex, face}; }
  };
  typedef std::vector<Line_point> Line; // without the ends

  Skeleton_lines(const Sampled_graph& graph,
                 const Graph_chains& chains,
                 const Filled_component& component,
                 const Skeleton_options& options,
                 bool are_values_distances,
                 const Stage_progress& progress)
    : graph_(graph),
      chains_(chains),
      ratio_(options.sampling_ratio),
      are_borders_ends_(options.are_borders_ends),
      are_values_distances_(are_values_distances),
      least_radius_(least_radius(graph.mesh()))
  {
    for(const Graph_chains::Chain& chain : chains.chains())
    {
      for(const Index end : chain.ends)
        ends_of_[end] += 1;
      chains_between_[std::minmax(chain.ends[0], chain.ends[1])] += 1;
    }
    for(const auto& [node, degree] : ends_of_)
      nodes_[node] = make_node(node, degree, component);
    for(Index chain = 0; chain != chains.chains().size(); ++chain)
    {
      progress.report_step(chain, chains.chains().size());
      lines_.push_back(sample_chain(chain));
      line_ends_.push_back(chains.chains()[chain].ends);
    }
    std::map<Index, std::vector<Chain_end>> chain_ends;
    for(Index chain = 0; chain != lines_.size(); ++chain)
      for(const bool is_last : {false, true})
        chain_ends[chains.chains()[chain].ends[is_last ? 1 : 0]].push_back({chain, is_last});
    for(Index chain = 0; chain != lines_.size(); ++chain)
      straighten_radii(lines_[chain]);
    lines_before_ = lines_;
    for(const auto& [node, at_node] : chain_ends)
      if(nodes_[node].kind == Line_end::JUNCTION)
        find_junction(node, at_node);
    // The front parts in the crotch, behind the place where the lines meet: the first turn is drawn to that.
    for(int turn = 0; turn != 2; ++turn)
    {
      lines_ = lines_before_;
      for(const auto& [node, at_node] : chain_ends)
        if(nodes_[node].kind == Line_end::JUNCTION)
          clear_junction(node, at_node);
      for(const auto& [node, at_node] : chain_ends)
        if(nodes_[node].kind == Line_end::JUNCTION)
          place_junction(node, at_node, turn == 0);
    }
    for(const auto& [node, at_node] : chain_ends)
      if(nodes_[node].kind == Line_end::TIP)
        nodes_[node].point.radius = radius_beside(at_node.front());
  }

  std::map<Index, Node>& nodes() { return nodes_; } // by node of the graph
  std::vector<Line>& lines() { return lines_; }     // by chain

  // The nodes at the ends of lines. One without points that ends where it begins has become that node.
  std::vector<std::array<Index, 2>>& ends() { return line_ends_; }
  void join(Index node, Index other) { joined_[node] = other; }
  Index node_at(Index node) const { return joined_.count(node) != 0 ? joined_.at(node) : node; }
  bool has_gone(Index chain) const { return lines_[chain].empty() && line_ends_[chain][0] == line_ends_[chain][1]; }

  // A point of a line, from 0 for the node where it begins.
  Surface_place place(Index line, std::size_t i) const
  {
    const Line& points = lines_[line];
    if(i != 0 && i <= points.size())
      return {points[i - 1].point};
    return nodes_.at(line_ends_[line][i == 0 ? 0 : 1]).place();
  }

  // Makes one node of two at one point that a line without points joins: a branch without length tells nothing. A cycle of two such
  // lines stays.
  void join_nodes_at_one_point()
  {
    for(Index line = 0; line != lines_.size(); ++line)
    {
      Index from = line_ends_[line][0], to = line_ends_[line][1];
      if(!lines_[line].empty() || from == to || nodes_.at(from).point.point != nodes_.at(to).point.point)
        continue;
      if(nodes_.at(to).kind != Line_end::JUNCTION)
        std::swap(from, to);
      const auto is_beside = [&](Index other) {
        return lines_[other].empty()
            && std::minmax(from, to) == std::minmax(line_ends_[other][0], line_ends_[other][1]);
      };
      std::size_t number_beside = 0;
      for(Index other = 0; other != lines_.size(); ++other)
        number_beside += is_beside(other) ? 1 : 0;
      if(nodes_.at(to).kind != Line_end::JUNCTION || nodes_.at(from).kind == Line_end::BORDER || number_beside > 1)
        continue;
      for(auto& ends : line_ends_)
        std::replace(ends.begin(), ends.end(), from, to);
      for(auto& [node, other] : joined_)
        other = other == from ? to : other;
      join(from, to);
      nodes_.erase(from);
    }
  }

  double least_radius() const { return least_radius_; }

  // A point at a place of a chain.
  Line_point make_point(Index chain, double place) const
  {
    const Contour_sample sample = chains_.sample(chain, place);
    return {sample.shape.centroid, sample.shape.radius(), 0, place, sample.on_surface, sample.shape.area};
  }

  // How far samples are to be apart: nearer ones tell no more of a surface of large triangles.
  double step(double radius) const { return ratio_ * (std::max)(radius, least_radius_); }

private:
  // Half of a mean edge, but no more than a fiftieth of the surface.
  static double least_radius(const Mesh& mesh)
  {
    double mean = 0;
    for(const auto e : mesh.edges())
      mean +=
        distance(mesh.point(mesh.vertex(e, 0)), mesh.point(mesh.vertex(e, 1))) / static_cast<double>(mesh.num_edges());
    const auto box = CGAL::bbox_3(mesh.points().begin(), mesh.points().end());
    return (std::min)(mean / 2,
                      distance({box.xmin(), box.ymin(), box.zmin()}, {box.xmax(), box.ymax(), box.zmax()}) / 50);
  }

  // The last sample of a chain that ends there, or the first one of one that begins there.
  struct Chain_end
  {
    Index chain;
    bool is_last;
  };

  Node make_node(Index node, std::size_t degree, const Filled_component& component) const
  {
    const auto v = graph_.vertex(node);
    Node result;
    if(degree == 1)
      result.kind = are_borders_ends_ && component.is_apex(v) ? Line_end::BORDER : Line_end::TIP;
    if(result.kind == Line_end::BORDER)
    {
      const Filled_border& border = component.borders[component.border_of(v)];
      result.point.radius = border.radius;
      for(const auto u : border.rim)
        result.rim = (std::max)(result.rim, std::abs(graph_.value(u) - graph_.value(v)));
    }
    result.point.point = result.point.on_surface = graph_.mesh().point(v);
    if(result.kind != Line_end::JUNCTION)
      result.vertex = v;
    return result;
  }

  // Places twice a step apart for the widest contour, then half of it where two samples are farther apart than the radius allows.
  Line sample_chain(Index chain) const
  {
    const auto& [ends, pieces, length] = chains_.chains()[chain];
    const std::size_t least = ends[0] == ends[1] ? 8 : 4;
    double radius = 0;
    for(const double t : {0.125, 0.375, 0.5, 0.625, 0.875})
      radius = (std::max)(radius, make_point(chain, t * length).radius);
    const double wanted = length > 0 ? length / step(radius) / 2 : 0; // The points of a component can all be one.
    const std::size_t number = are_values_distances_ ? (std::max)(static_cast<std::size_t>(wanted), least) : 16;
    Line line;
    for(std::size_t i = 0; i != number; ++i)
    {
      const double place = length * (static_cast<double>(i) + 0.5) / static_cast<double>(number);
      Line_point point = make_point(chain, place);
      if(!line.empty())
        add_between(chain, Line_point(line.back()), point, 0, line);
      line.push_back(point);
    }
    drop_tops(chains_.chains()[chain], line);
    return line;
  }

  // How far one sample is from the next one.
  double gap(const Line_point& a, const Line_point& b) const
  {
    return are_values_distances_ ? std::abs(a.place - b.place) : distance(a.point, b.point);
  }

  static constexpr int greatest_depth = 6;

  void add_between(Index chain, const Line_point& a, const Line_point& b, int depth, Line& line) const
  {
    if(depth == greatest_depth || !(gap(a, b) > 1.5 * step((a.radius + b.radius) / 2)))
      return;
    const Line_point middle = make_point(chain, (a.place + b.place) / 2);
    add_between(chain, a, middle, depth + 1, line);
    line.push_back(middle);
    add_between(chain, middle, b, depth + 1, line);
  }

  // At a tip, contours shrink to a point of the surface, away from the axis: those nearer than their own radius go. So do
  // those that pass a border.
  void drop_tops(const Graph_chains::Chain& chain, Line& line) const
  {
    const auto is_top = [&](const Line_point& p, bool is_last) {
      const Node& end = nodes_.at(chain.ends[is_last ? 1 : 0]);
      if(end.kind == Line_end::BORDER)
        return std::abs(p.place - (is_last ? chain.length : 0)) <= end.rim;
      return end.kind == Line_end::TIP && distance(p.point, end.point.point) < p.radius;
    };
    while(line.size() > 1 && is_top(line.back(), true))
      line.pop_back();
    std::size_t first = 0;
    while(line.size() - first > 1 && is_top(line[first], false))
      ++first;
    line.erase(line.begin(), line.begin() + static_cast<std::ptrdiff_t>(first));
  }

  // Looks at contours along the line: those of a front that comes from a side are oblique, and larger than the tube.
  static void straighten_radii(Line& line)
  {
    for(std::size_t i = 0; i != line.size(); ++i)
    {
      const Vector along = line[(std::min)(i + 1, line.size() - 1)].point - line[i == 0 ? 0 : i - 1].point;
      if(const double size = length(along); size > 0)
        line[i].radius = radius_along(line[i].area, along / size);
    }
  }

  const Line_point& from_end(const Line& line, bool is_last, std::size_t i) const
  {
    return is_last ? line[line.size() - 1 - i] : line[i];
  }

  // How far from a junction contours are not those of tubes yet.
  void find_junction(Index node, const std::vector<Chain_end>& chain_ends)
  {
    Vector sum = NULL_VECTOR;
    for(const auto& [chain, is_last] : chain_ends)
      sum = sum + (from_end(lines_before_[chain], is_last, 0).point - ORIGIN);
    const Point center = ORIGIN + sum / static_cast<double>(chain_ends.size());
    double reach = 0;
    for(const auto& [chain, is_last] : chain_ends)
    {
      const Line& line = lines_before_[chain];
      std::size_t i = 0;
      while(i + 1 < line.size()
            && distance(from_end(line, is_last, i).point, center) < from_end(line, is_last, i).radius)
        ++i;
      reach = (std::max)(reach, from_end(line, is_last, i).radius);
    }
    nodes_[node].point.point = center;
    nodes_[node].reach = reach;
  }

  // Takes these samples away.
  void clear_junction(Index node, const std::vector<Chain_end>& chain_ends)
  {
    const double reach = nodes_[node].reach;
    const Point center = nodes_[node].point.point;
    for(const auto& [chain, is_last] : chain_ends)
    {
      const Line& before = lines_before_[chain];
      Line& line = lines_[chain];
      const std::size_t least = is_of_loop(chain)                                                                   ? 2
                              : nodes_.at(chains_.chains()[chain].ends[is_last ? 0 : 1]).kind == Line_end::JUNCTION ? 0
                                                                                                                    : 1;
      for(std::size_t i = 0;
          2 * i < before.size() && line.size() > least && distance(from_end(before, is_last, i).point, center) < reach;
          ++i)
      {
        if(is_last)
          line.pop_back();
        else
          line.erase(line.begin());
      }
    }
  }

  // Whether a chain and another one, or itself, close a loop without further nodes.
  bool is_of_loop(Index chain) const
  {
    const auto& ends = chains_.chains()[chain].ends;
    if(ends[0] == ends[1])
      return true;
    return chains_between_.at(std::minmax(ends[0], ends[1])) > 1;
  }

  // Puts a junction where the lines of its chains meet in least squares.
  void place_junction(Index node, const std::vector<Chain_end>& chain_ends, bool is_first_turn)
  {
    const double reach = nodes_[node].reach;
    const Point center = nodes_[node].point.point;
    std::vector<std::pair<Point, Vector>> axes;
    Vector sum = NULL_VECTOR;
    double radius = 0;
    std::size_t count = 0;
    for(const auto& [chain, is_last] : chain_ends)
    {
      const Line& line = lines_[chain];
      radius += from_end(line.empty() ? lines_before_[chain] : line, is_last, 0).radius;
      if(line.empty())
        continue;
      sum = sum + (from_end(line, is_last, 0).point - ORIGIN);
      ++count;
      Line part;
      for(std::size_t i = 0;
          i != line.size() && (part.size() < 2 || distance(from_end(line, is_last, i).point, center) < 2 * reach); ++i)
        part.push_back(from_end(line, is_last, i));
      if(const auto axis = axis_of(part))
        axes.push_back(*axis);
    }
    nodes_[node].point.radius = radius / static_cast<double>(chain_ends.size());
    nodes_[node].point.on_surface =
      from_end(lines_before_[chain_ends.front().chain], chain_ends.front().is_last, 0).on_surface;
    if(count == 0)
      return;
    const Point mean = ORIGIN + sum / static_cast<double>(count);
    const Point base = is_first_turn ? mean : center;
    const Vector away = meeting_point(axes, mean) - base;
    const double size = length(away);
    nodes_[node].point.point = base + (size > reach ? reach / size : 1) * away;
  }

  // The line through samples by regression on their places.
  static std::optional<std::pair<Point, Vector>> axis_of(const Line& part)
  {
    if(part.size() < 2)
      return std::nullopt;
    const double size = static_cast<double>(part.size());
    Vector mean = NULL_VECTOR, slope = NULL_VECTOR;
    double mean_place = 0;
    for(const Line_point& p : part)
    {
      mean = mean + (p.point - part.front().point) / size;
      mean_place += p.place / size;
    }
    for(const Line_point& p : part)
      slope = slope + (p.place - mean_place) * (p.point - part.front().point - mean);
    const double steepness = length(slope);
    if(!(steepness > 0))
      return std::nullopt;
    return std::make_pair(part.front().point + mean, slope / steepness);
  }

  // The point that is closest to some lines in least squares, drawn to a point a little, which is the result where all
  // are parallel.
  static Point meeting_point(const std::vector<std::pair<Point, Vector>>& axes, const Point& mean)
  {
    const double weight = 0.05;
    std::array<Vector, 3> rows = {Vector(weight, 0, 0), Vector(0, weight, 0), Vector(0, 0, weight)};
    Vector right = NULL_VECTOR; // relative to the mean
    for(const auto& [p, d] : axes)
    {
      const Vector to_line = (p - mean) - ((p - mean) * d) * d;
      right = right + to_line / static_cast<double>(axes.size());
      for(int i = 0; i != 3; ++i)
      {
        Vector unit(i == 0 ? 1 : 0, i == 1 ? 1 : 0, i == 2 ? 1 : 0);
        rows[i] = rows[i] + (unit - d[i] * d) / static_cast<double>(axes.size());
      }
    }
    const double determinant = rows[0] * cross_product(rows[1], rows[2]);
    const Vector x = (right[0] * cross_product(rows[1], rows[2]) + right[1] * cross_product(rows[2], rows[0])
                      + right[2] * cross_product(rows[0], rows[1]))
                   / determinant;
    return mean + x;
  }

  // At a tip, where a contour is a point, the radius of the next sample.
  double radius_beside(const Chain_end& chain_end) const
  {
    const auto& [chain, is_last] = chain_end;
    if(lines_[chain].empty())
      return nodes_.at(chains_.chains()[chain].ends[is_last ? 0 : 1]).point.radius;
    return from_end(lines_[chain], is_last, 0).radius;
  }

  const Sampled_graph& graph_;
  const Graph_chains& chains_;
  const double ratio_;
  const bool are_borders_ends_;
  const bool are_values_distances_;
  const double least_radius_;
  std::map<Index, std::size_t> ends_of_;
  std::map<std::pair<Index, Index>, std::size_t> chains_between_;
  std::map<Index, Node> nodes_;
  std::vector<Line> lines_, lines_before_;
  std::vector<std::array<Index, 2>> line_ends_;
  std::map<Index, Index> joined_; // nodes that have become others
};

} // namespace CGAL::Reeb_graph::internal::skeleton

#endif // CGAL_REEB_GRAPH_SKELETON_INTERNAL_SKELETON_LINES_H
