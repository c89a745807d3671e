// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_TEST_COMPLEX_ORACLE_H
#define CGAL_REEB_GRAPH_TEST_COMPLEX_ORACLE_H

#include "oracle_parts.h"

#include <CGAL/Reeb_graph/options.h>

#include <boost/graph/properties.hpp>

#include <algorithm>
#include <cstddef>
#include <set>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

// The Reeb graph of any simplicial complex by definition. Vertices have heights: their rank in the total order, or the
// number of their value if ties are contracted. The points of the graph at the heights are the components of the level
// sets {h = k}, and in between there is a strip for each component of {k < h < k + 1}. The intersection of a simplex
// with a level set is connected, so it joins all edges of the simplex that cross. Slow, without any rule about
// triangles at an edge or about the 2-skeleton of tetrahedra, and nothing in common with the package.
namespace complex_oracle {
using CGAL::Reeb_graph::Node_kind;
using CGAL::Reeb_graph::Ties;
using oracle_parts::Arc;
using oracle_parts::none;
using oracle_parts::Strip;

typedef std::vector<std::size_t> Simplex;         // two vertices or more
typedef std::pair<std::size_t, std::size_t> Edge; // vertices, the lower index first

inline Edge make_edge(std::size_t u, std::size_t v) { return {(std::min)(u, v), (std::max)(u, v)}; }

struct Point
{
  std::size_t height;
  std::vector<std::size_t> vertices; // ascending by index
  std::vector<std::size_t> strips_below, strips_above;
  std::size_t node, arc; // one of them is none
};

// The components of numbered elements that have been added.
class Partition
{
public:
  explicit Partition(std::size_t size) : representatives_(size, none) {}

  bool contains(std::size_t element) const { return representatives_[element] != none; }

  void add(std::size_t element)
  {
    if(!contains(element))
      representatives_[element] = element;
  }

  std::size_t find(std::size_t element)
  {
    while(representatives_[element] != element)
      element = representatives_[element] = representatives_[representatives_[element]];
    return element;
  }

  void add_united(const std::vector<std::size_t>& elements)
  {
    for(const std::size_t element : elements)
    {
      add(element);
      representatives_[find(element)] = find(elements.front());
    }
  }

private:
  std::vector<std::size_t> representatives_;
};

class Oracle
{
public:
  std::vector<Edge> edges;                               // all faces of dimension 1 of the simplices, sorted
  std::vector<std::size_t> rank;                         // of each vertex in the order by (value, index)
  std::vector<std::size_t> heights;                      // of each vertex
  std::vector<std::size_t> lower_sectors, upper_sectors; // of the link of each vertex, in the total order
  std::vector<Point> points;                             // ascending by height
  std::vector<Strip> strips;                             // ascending by height
  std::vector<std::size_t> point_of_vertex;
  std::vector<std::size_t> nodes; // the points that are nodes, in the order of the graph
  std::vector<Arc> arcs;          // in no particular order
  std::string fault;              // of the oracle itself, empty if there is none

  template <class Scalar>
  Oracle(std::size_t number_of_vertices,
         const std::vector<Simplex>& simplices,
         const std::vector<Scalar>& values,
         Ties ties = Ties::PERTURB,
         bool keeps_degree_two_nodes = false)
    : heights(number_of_vertices),
      point_of_vertex(number_of_vertices, none),
      simplices_(simplices)
  {
    number_of_heights_ = find_order(values, ties);
    find_edges();
    find_sectors();
    points_of_edges_.resize(number_of_heights_);
    for(std::size_t height = 0; height < number_of_heights_; ++height)
      find_points(height);
    strips_of_edges_.resize(number_of_heights_);
    for(std::size_t height = 0; height + 1 < number_of_heights_; ++height)
      find_strips(height);
    find_nodes(ties, keeps_degree_two_nodes);
    arcs = oracle_parts::number_arcs(nodes, points, strips);
  }

  bool is_critical(std::size_t v) const { return lower_sectors[v] != 1 || upper_sectors[v] != 1; }

  std::size_t number_of_heights() const { return number_of_heights_; }

  // none if there is no such edge
  std::size_t edge(std::size_t u, std::size_t v) const
  {
    const auto found = std::lower_bound(edges.begin(), edges.end(), make_edge(u, v));
    return found == edges.end() || *found != make_edge(u, v) ? none : static_cast<std::size_t>(found - edges.begin());
  }

  // the strip above a height that an edge crosses, none if it does not
  std::size_t strip_of_edge(std::size_t height, std::size_t edge) const { return strips_of_edges_[height][edge]; }

  // the point at a height that an edge crosses or ends at, none if it does not
  std::size_t point_of_edge(std::size_t height, std::size_t edge) const
  {
    for(const std::size_t v : {edges[edge].first, edges[edge].second})
      if(heights[v] == height)
        return point_of_vertex[v];
    return points_of_edges_[height][edge];
  }

  // the vertex that a node is named by: the lowest critical one
  std::size_t vertex_of_node(std::size_t node) const { return lowest_critical_vertex(points[nodes[node]]); }

  Node_kind kind_of_node(std::size_t node) const
  {
    const Point& point = points[nodes[node]];
    if(point.strips_below.empty())
      return point.strips_above.empty() ? Node_kind::ISOLATED : Node_kind::MINIMUM;
    if(point.strips_above.empty())
      return Node_kind::MAXIMUM;
    return is_passed(point) ? Node_kind::DEGREE_TWO : Node_kind::SADDLE;
  }

  std::size_t number_of_loops() const
  {
    Partition components(nodes.size());
    for(std::size_t node = 0; node < nodes.size(); ++node)
      components.add(node);
    for(const Arc& arc : arcs)
      components.add_united({arc.lower, arc.upper});
    std::size_t number_of_components = 0;
    for(std::size_t node = 0; node < nodes.size(); ++node)
      number_of_components += components.find(node) == node ? 1 : 0;
    return arcs.size() + number_of_components - nodes.size();
  }

private:
  template <class Scalar>
  std::size_t find_order(const std::vector<Scalar>& values, Ties ties)
  {
    const std::vector<std::size_t> order = oracle_parts::order_by_value(values);
    rank = oracle_parts::ranks_in(order);
    std::size_t height = 0;
    for(std::size_t i = 0; i < order.size(); ++i)
    {
      const bool is_new = i > 0 && (ties == Ties::PERTURB || values[order[i - 1]] < values[order[i]]);
      height += is_new ? 1 : 0;
      heights[order[i]] = height;
    }
    return order.empty() ? 0 : height + 1;
  }

  void find_edges()
  {
    std::set<Edge> all;
    for(const Simplex& simplex : simplices_)
      for(std::size_t i = 0; i < simplex.size(); ++i)
        for(std::size_t j = 0; j < i; ++j)
          all.insert(make_edge(simplex[i], simplex[j]));
    edges.assign(all.begin(), all.end());
    for(const Simplex& simplex : simplices_)
    {
      edges_of_simplices_.emplace_back();
      for(std::size_t i = 0; i < simplex.size(); ++i)
        for(std::size_t j = 0; j < i; ++j)
          edges_of_simplices_.back().push_back(edge(simplex[i], simplex[j]));
    }
  }

  // The other vertices of a simplex at v that are on the same side of v are joined in its link.
  void find_sectors()
  {
    for(std::size_t v = 0; v < rank.size(); ++v)
      for(const bool is_upper : {false, true})
      {
        Partition sectors(rank.size());
        for(const Simplex& simplex : simplices_)
        {
          if(std::find(simplex.begin(), simplex.end(), v) == simplex.end())
            continue;
          std::vector<std::size_t> neighbors;
          for(const std::size_t w : simplex)
            if(w != v && (rank[w] > rank[v]) == is_upper)
              neighbors.push_back(w);
          sectors.add_united(neighbors);
        }
        std::size_t number_of_sectors = 0;
        for(std::size_t w = 0; w < rank.size(); ++w)
          number_of_sectors += sectors.contains(w) && sectors.find(w) == w ? 1 : 0;
        (is_upper ? upper_sectors : lower_sectors).push_back(number_of_sectors);
      }
  }

  // Has the edge an end at `lowest` or below, and one at `highest` or above?
  bool reaches(std::size_t edge, std::size_t lowest, std::size_t highest) const
  {
    const auto ends = std::minmax(heights[edges[edge].first], heights[edges[edge].second]);
    return ends.first <= lowest && ends.second >= highest;
  }

  bool crosses(std::size_t edge, std::size_t height) const
  {
    return height > 0 && reaches(edge, height - 1, height + 1);
  }

  // Elements are vertices, and behind them edges.
  void find_points(std::size_t height)
  {
    Partition partition(rank.size() + edges.size());
    for(std::size_t v = 0; v < rank.size(); ++v)
      if(heights[v] == height)
        partition.add(v);
    for(std::size_t i = 0; i < simplices_.size(); ++i)
    {
      std::vector<std::size_t> elements;
      for(const std::size_t v : simplices_[i])
        if(heights[v] == height)
          elements.push_back(v);
      for(const std::size_t edge : edges_of_simplices_[i])
        if(crosses(edge, height))
          elements.push_back(rank.size() + edge);
      partition.add_united(elements);
    }
    std::vector<std::size_t> point_of_component(rank.size() + edges.size(), none);
    points_of_edges_[height].assign(edges.size(), none);
    for(std::size_t element = 0; element < point_of_component.size(); ++element)
    {
      if(!partition.contains(element))
        continue;
      std::size_t& point = point_of_component[partition.find(element)];
      if(point == none)
      {
        point = points.size();
        points.push_back({height, {}, {}, {}, none, none});
      }
      if(element >= rank.size())
      {
        points_of_edges_[height][element - rank.size()] = point;
        continue;
      }
      points[point].vertices.push_back(element);
      point_of_vertex[element] = point;
    }
  }

  // the strips between a height and the next one
  void find_strips(std::size_t height)
  {
    Partition partition(edges.size());
    for(const std::vector<std::size_t>& edges_of_simplex : edges_of_simplices_)
    {
      std::vector<std::size_t> elements;
      for(const std::size_t edge : edges_of_simplex)
        if(reaches(edge, height, height + 1))
          elements.push_back(edge);
      partition.add_united(elements);
    }
    std::vector<std::size_t> strip_of_component(edges.size(), none);
    strips_of_edges_[height].assign(edges.size(), none);
    for(std::size_t edge = 0; edge < edges.size(); ++edge)
    {
      if(!partition.contains(edge))
        continue;
      const std::size_t lower = point_of_edge(height, edge), upper = point_of_edge(height + 1, edge);
      std::size_t& strip = strip_of_component[partition.find(edge)];
      if(strip == none)
      {
        strip = strips.size();
        strips.push_back({{}, lower, upper, none});
        points[lower].strips_above.push_back(strip);
        points[upper].strips_below.push_back(strip);
      }
      if(strips[strip].lower != lower || strips[strip].upper != upper)
        fault = "the oracle is wrong: a strip leads to two points";
      strips[strip].edges.push_back(edge);
      strips_of_edges_[height][edge] = strip;
    }
  }

  static bool is_passed(const Point& point) { return point.strips_below.size() == 1 && point.strips_above.size() == 1; }

  std::size_t lowest_critical_vertex(const Point& point) const
  {
    for(const std::size_t v : point.vertices)
      if(is_critical(v))
        return v;
    return none;
  }

  void find_nodes(Ties ties, bool keeps_degree_two_nodes)
  {
    std::vector<oracle_parts::Node_key> keys;
    for(std::size_t i = 0; i < points.size(); ++i)
    {
      const std::size_t name = lowest_critical_vertex(points[i]);
      if(ties == Ties::PERTURB && points[i].vertices.size() > 1)
        fault = "the oracle is wrong: a height has two vertices";
      if(!is_passed(points[i]) && name == none)
        fault = "the oracle is wrong: a node without a critical vertex";
      if(!is_passed(points[i]) || (keeps_degree_two_nodes && name != none))
        keys.emplace_back(points[i].height, name, i);
    }
    nodes = oracle_parts::number_nodes(std::move(keys), points);
  }

  std::vector<Simplex> simplices_;
  std::vector<std::vector<std::size_t>> edges_of_simplices_;
  std::size_t number_of_heights_ = 0;
  std::vector<std::vector<std::size_t>> points_of_edges_; // by height and edge; none where the edge does not cross
  std::vector<std::vector<std::size_t>> strips_of_edges_; // the same for the strip above the height
};

// The rank of a matrix over the field of two elements. A column is the set of its rows that are not 0.
inline std::size_t rank_of_matrix(const std::vector<std::set<std::size_t>>& columns, std::size_t number_of_rows)
{
  std::vector<std::set<std::size_t>> reduced(number_of_rows); // by their last row
  std::size_t rank = 0;
  for(std::set<std::size_t> column : columns)
  {
    while(!column.empty() && !reduced[*column.rbegin()].empty())
      for(const std::size_t row : reduced[*column.rbegin()])
        if(!column.insert(row).second)
          column.erase(row);
    if(column.empty())
      continue;
    reduced[*column.rbegin()] = column;
    ++rank;
  }
  return rank;
}

// The first Betti number, with coefficients of two elements, of the complex of an oracle.
inline std::size_t first_betti_number(const Oracle& oracle, const std::vector<Simplex>& simplices)
{
  std::vector<std::set<std::size_t>> boundaries_of_edges, boundaries_of_triangles;
  for(const Edge& edge : oracle.edges)
    boundaries_of_edges.push_back({edge.first, edge.second});
  for(const Simplex& s : simplices)
    for(std::size_t i = 0; i < s.size(); ++i)
      for(std::size_t j = 0; j < i; ++j)
        for(std::size_t k = 0; k < j; ++k)
          boundaries_of_triangles.push_back(
            {oracle.edge(s[i], s[j]), oracle.edge(s[j], s[k]), oracle.edge(s[i], s[k])});
  return oracle.edges.size() - rank_of_matrix(boundaries_of_edges, oracle.rank.size())
       - rank_of_matrix(boundaries_of_triangles, oracle.edges.size());
}

// The checks below return the first fault that they find, the empty string if none. The graph is one whose vertex
// descriptors are the vertices by number, and whose chains are pairs of them.

// The nodes are those of the oracle, in its order.
template <class Graph, class Scalar>
std::string fault_of_nodes(const Oracle& oracle, const Graph& graph, const std::vector<Scalar>& values)
{
  if(num_vertices(graph) != oracle.nodes.size())
    return std::to_string(num_vertices(graph)) + " nodes instead of " + std::to_string(oracle.nodes.size());
  for(std::size_t node = 0; node < oracle.nodes.size(); ++node)
  {
    const Point& point = oracle.points[oracle.nodes[node]];
    const std::string name = "node " + std::to_string(node) + ": ";
    if(graph[node].vertex != oracle.vertex_of_node(node))
      return name + "vertex " + std::to_string(graph[node].vertex) + " instead of "
           + std::to_string(oracle.vertex_of_node(node));
    if(!(graph[node].value == values[graph[node].vertex]))
      return name + "another value";
    if(graph[node].kind != oracle.kind_of_node(node))
      return name + "another kind";
    if(in_degree(node, graph) != point.strips_below.size() || out_degree(node, graph) != point.strips_above.size())
      return name + "another degree";
  }
  return "";
}

// The chain begins in the lower node, is connected, ascends, and reaches the upper node; where an arc passes a plateau,
// another vertex of the plateau may go on. All of the way it is in one arc of the oracle, whose number is returned too.
template <class Chain>
std::pair<std::string, std::size_t> fault_of_chain(const Oracle& oracle,
                                                   const Chain& chain,
                                                   std::size_t lower,
                                                   std::size_t upper,
                                                   bool contracts_ties)
{
  std::size_t oracle_arc = none;
  if(chain.empty())
    return {"the chain is empty", none};
  const std::size_t first = chain.front().first;
  if(oracle.point_of_vertex[first] != oracle.nodes[lower])
    return {"the chain begins elsewhere", none};
  if(!contracts_ties && first != oracle.vertex_of_node(lower))
    return {"the chain begins at another vertex", none};
  for(std::size_t i = 0; i < chain.size(); ++i)
  {
    const std::string name = "edge " + std::to_string(i) + " of the chain ";
    const bool is_last = i + 1 == chain.size();
    const std::size_t from = chain[i].first, to = chain[i].second, edge = oracle.edge(from, to);
    const std::size_t stop = is_last ? oracle.vertex_of_node(upper) : chain[i + 1].first;
    if(edge == none)
      return {name + "is not one of the complex", none};
    if(oracle.rank[from] >= oracle.rank[to])
      return {name + "does not ascend", none};
    if(!contracts_ties && !is_last && (to != stop || oracle.rank[to] >= oracle.rank[oracle.vertex_of_node(upper)]))
      return {name + "does not lead to the next one, or passes the upper node", none};
    const std::size_t height = oracle.heights[stop];
    if(oracle.heights[from] > height || oracle.heights[to] < height
       || oracle.point_of_edge(height, edge) != oracle.point_of_vertex[stop])
      return {name + "does not reach the place where the chain goes on", none};
    if(height > oracle.points[oracle.nodes[upper]].height)
      return {name + "leads above the upper node", none};
    for(std::size_t level = oracle.heights[from]; level < height; ++level)
    {
      const std::size_t crossed_arc = oracle.strips[oracle.strip_of_edge(level, edge)].arc;
      if(oracle_arc == none)
        oracle_arc = crossed_arc;
      if(crossed_arc != oracle_arc)
        return {name + "leaves its arc", none};
    }
  }
  return {oracle_arc == none ? "the chain crosses nothing" : "", oracle_arc};
}

// The arcs are those of the oracle, sorted and numbered; the arc of the oracle of each of them is returned too.
template <class Graph>
std::pair<std::string, std::vector<std::size_t>> fault_of_arcs(const Oracle& oracle,
                                                               const Graph& graph,
                                                               Ties ties = Ties::PERTURB)
{
  if(num_edges(graph) != oracle.arcs.size())
    return {std::to_string(num_edges(graph)) + " arcs instead of " + std::to_string(oracle.arcs.size()), {}};
  std::vector<std::size_t> oracle_arcs;
  std::vector<std::tuple<std::size_t, std::size_t, std::size_t>> keys;
  const auto range = edges(graph);
  for(auto arc = range.first; arc != range.second; ++arc)
  {
    const std::string name = "arc " + std::to_string(oracle_arcs.size()) + ": ";
    const std::size_t lower = source(*arc, graph), upper = target(*arc, graph);
    if(get(boost::edge_index, graph, *arc) != oracle_arcs.size())
      return {name + "another number", {}};
    const auto fault = fault_of_chain(oracle, graph[*arc].chain, lower, upper, ties == Ties::CONTRACT);
    if(!fault.first.empty())
      return {name + fault.first, {}};
    if(oracle.arcs[fault.second].lower != lower || oracle.arcs[fault.second].upper != upper)
      return {name + "the chain is in an arc between other nodes", {}};
    oracle_arcs.push_back(fault.second);
    keys.emplace_back(lower, upper, oracle.rank[graph[*arc].chain.front().second]);
  }
  if(std::set<std::size_t>(oracle_arcs.begin(), oracle_arcs.end()).size() != oracle_arcs.size())
    return {"two chains are in the same arc", {}};
  return {std::is_sorted(keys.begin(), keys.end()) ? "" : "the arcs are not sorted", oracle_arcs};
}

// All of the above.
template <class Graph, class Scalar>
std::string fault_of_graph(const Oracle& oracle,
                           const Graph& graph,
                           const std::vector<Scalar>& values,
                           Ties ties = Ties::PERTURB)
{
  if(!oracle.fault.empty())
    return oracle.fault;
  const std::string fault = fault_of_nodes(oracle, graph, values);
  return fault.empty() ? fault_of_arcs(oracle, graph, ties).first : fault;
}

} // namespace complex_oracle

#endif // CGAL_REEB_GRAPH_TEST_COMPLEX_ORACLE_H
