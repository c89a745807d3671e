// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_TEST_QUOTIENT_ORACLE_H
#define CGAL_REEB_GRAPH_TEST_QUOTIENT_ORACLE_H

#include "brute_force_oracle.h"
#include "oracle_parts.h"

#include <algorithm>
#include <cstddef>
#include <map>
#include <set>
#include <utility>
#include <vector>

// The Reeb graph of a field with ties, by definition: its points at the values of the vertices are the components of
// the level sets {f = c}, and in between there is a strip for each component of {c < f < c'}. Slow, and nothing in
// common with the package.
namespace quotient_oracle {
using brute_force_oracle::none;
using brute_force_oracle::Triangle;
using oracle_parts::Arc;
using oracle_parts::Strip;

struct Point
{
  std::size_t value;                 // the number of the value among all different ones, ascending
  std::vector<std::size_t> vertices; // ascending by index
  std::vector<std::size_t> strips_below, strips_above;
  std::size_t node, arc; // one of them is none
};

class Quotient
{
public:
  std::vector<Point> points;
  std::vector<Strip> strips;
  std::vector<std::size_t> point_of_vertex;
  std::vector<std::size_t> nodes; // the points that are nodes, in the order of name_of_node()
  std::vector<Arc> arcs;          // in no particular order
  bool is_consistent = true;      // false if a strip leads to two points

  // is_critical tells by vertex whether it is critical when ties are broken by the index
  template <class Scalar>
  Quotient(std::size_t number_of_vertices,
           const std::vector<Triangle>& triangles,
           const std::vector<Scalar>& values,
           const std::vector<bool>& is_critical,
           bool keeps_degree_two_nodes)
    : point_of_vertex(number_of_vertices, none),
      triangles_(triangles),
      is_critical_(is_critical)
  {
    const std::set<Scalar> sorted(values.begin(), values.end());
    for(const Scalar& value : values)
      values_.push_back(static_cast<std::size_t>(std::distance(sorted.begin(), sorted.find(value))));
    for(const Triangle& t : triangles)
      for(int i = 0; i < 3; ++i)
      {
        const auto ends = std::minmax(values_[t.vertices[i]], values_[t.vertices[(i + 1) % 3]]);
        const std::size_t lower = values_[t.vertices[i]] == ends.first ? t.vertices[i] : t.vertices[(i + 1) % 3];
        const std::size_t upper = lower == t.vertices[i] ? t.vertices[(i + 1) % 3] : t.vertices[i];
        edges_[t.edges[i]] = {lower, upper};
      }
    for(std::size_t value = 0; value < sorted.size(); ++value)
      find_points(value);
    for(std::size_t value = 0; value + 1 < sorted.size(); ++value)
      find_strips(value);
    find_nodes(keeps_degree_two_nodes);
    arcs = oracle_parts::number_arcs(nodes, points, strips);
  }

  // the lowest critical vertex
  std::size_t name_of_node(std::size_t node) const { return lowest_critical_vertex(points[nodes[node]]); }

private:
  typedef std::pair<bool, std::size_t> Element; // a vertex, or (true, an edge)

  // the components of elements that are joined by triangles
  class Partition
  {
  public:
    void add(Element element) { representatives_.emplace(element, element); }

    Element find(Element element)
    {
      while(representatives_.at(element) != element)
        element = representatives_.at(element);
      return element;
    }

    void unite(Element element, Element other) { representatives_[find(element)] = find(other); }

    const std::map<Element, Element>& elements() const { return representatives_; }

  private:
    std::map<Element, Element> representatives_;
  };

  // whether an edge has points strictly between the numbers of values `below` and `above`
  bool crosses(std::size_t edge, std::size_t below, std::size_t above) const
  {
    const auto& ends = edges_.at(edge);
    return values_[ends.first] <= below && values_[ends.second] >= above;
  }

  bool crosses(std::size_t edge, std::size_t value) const { return value > 0 && crosses(edge, value - 1, value + 1); }

  void find_points(std::size_t value)
  {
    Partition partition;
    for(std::size_t v = 0; v < values_.size(); ++v)
      if(values_[v] == value)
        partition.add({false, v});
    for(const Triangle& t : triangles_)
    {
      std::vector<Element> elements;
      for(int i = 0; i < 3; ++i)
      {
        if(values_[t.vertices[i]] == value)
          elements.push_back({false, t.vertices[i]});
        if(crosses(t.edges[i], value))
          elements.push_back({true, t.edges[i]});
      }
      unite_all(partition, elements);
    }
    std::map<Element, std::size_t> point_of_component;
    for(const auto& entry : partition.elements())
    {
      const Element element = entry.first;
      const auto found = point_of_component.emplace(partition.find(element), points.size());
      if(found.second)
        points.push_back({value, {}, {}, {}, none, none});
      point_of_element_[{value, element}] = found.first->second;
      if(element.first)
        continue;
      points[found.first->second].vertices.push_back(element.second);
      point_of_vertex[element.second] = found.first->second;
    }
  }

  // the strips between a value and the next one
  void find_strips(std::size_t value)
  {
    Partition partition;
    for(const Triangle& t : triangles_)
    {
      std::vector<Element> elements;
      for(const std::size_t edge : t.edges)
        if(crosses(edge, value, value + 1))
          elements.push_back({true, edge});
      unite_all(partition, elements);
    }
    std::map<Element, std::size_t> strip_of_component;
    for(const auto& entry : partition.elements())
    {
      const std::size_t edge = entry.first.second;
      const std::size_t lower = end_of_edge(edge, value), upper = end_of_edge(edge, value + 1);
      const auto found = strip_of_component.emplace(partition.find(entry.first), strips.size());
      if(found.second)
      {
        points[lower].strips_above.push_back(strips.size());
        points[upper].strips_below.push_back(strips.size());
        strips.push_back({{}, lower, upper, none});
      }
      Strip& strip = strips[found.first->second];
      strip.edges.push_back(edge);
      is_consistent = is_consistent && strip.lower == lower && strip.upper == upper;
    }
  }

  static void unite_all(Partition& partition, const std::vector<Element>& elements)
  {
    for(const Element& element : elements)
    {
      partition.add(element);
      partition.unite(element, elements.front());
    }
  }

  // the point to which an edge leads at a value
  std::size_t end_of_edge(std::size_t edge, std::size_t value) const
  {
    const auto& ends = edges_.at(edge);
    for(const std::size_t v : {ends.first, ends.second})
      if(values_[v] == value)
        return point_of_vertex[v];
    return point_of_element_.at({value, {true, edge}});
  }

  std::size_t lowest_critical_vertex(const Point& point) const
  {
    const auto found =
      std::find_if(point.vertices.begin(), point.vertices.end(), [&](std::size_t v) { return is_critical_[v]; });
    return found == point.vertices.end() ? none : *found;
  }

  void find_nodes(bool keeps_degree_two_nodes)
  {
    std::vector<oracle_parts::Node_key> keys;
    for(std::size_t i = 0; i < points.size(); ++i)
    {
      const Point& point = points[i];
      const bool is_passed = point.strips_below.size() == 1 && point.strips_above.size() == 1;
      const std::size_t name = lowest_critical_vertex(point);
      if(!is_passed || (keeps_degree_two_nodes && name != none))
        keys.emplace_back(point.value, name, i);
    }
    nodes = oracle_parts::number_nodes(std::move(keys), points);
  }

  std::vector<Triangle> triangles_;
  std::vector<bool> is_critical_;
  std::vector<std::size_t> values_;                                         // by vertex, the number of its value
  std::map<std::size_t, std::pair<std::size_t, std::size_t>> edges_;        // lower and upper end
  std::map<std::pair<std::size_t, Element>, std::size_t> point_of_element_; // by number of value and element
};

} // namespace quotient_oracle

#endif // CGAL_REEB_GRAPH_TEST_QUOTIENT_ORACLE_H
