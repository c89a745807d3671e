// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_INTERNAL_BASE_UNION_FIND_H
#define CGAL_REEB_GRAPH_INTERNAL_BASE_UNION_FIND_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/internal/base/Index.h>
#include <CGAL/Reeb_graph/internal/base/arrays.h>
#include <CGAL/Reeb_graph/internal/base/compiled.h>

#include <numeric>
#include <utility>

namespace CGAL::Reeb_graph::internal {

// The root of the set of an element, where parent(element) is a reference to the element that it has been linked to:
// itself at the root. Paths are halved on the way.
template <class Element, class Parent>
Element find_root(Element element, const Parent& parent)
{
  while(parent(element) != element)
    element = parent(element) = parent(parent(element));
  return element;
}

// Disjoint sets of indices. The root of a set stands for all of it.
template <class Element>
class Disjoint_sets
{
public:
  explicit Disjoint_sets(Index size) : parents_(size) { std::iota(parents_.begin(), parents_.end(), Element(0)); }

  Element find(Element element)
  {
    return find_root(element, [&](Element i) -> Element& { return parents_[i]; });
  }

  // Joins two sets, given by their roots; `root` is the root of both then.
  void link(Element old_root, Element root) { parents_[old_root] = root; }

  void unite(Element a, Element b) { link(find(a), find(b)); }

  // The roots of the sets, by element. The sets are gone then.
  Indexed_vector<Element, Element> take_roots()
  {
    for(Element& parent : parents_)
      parent = find(parent);
    return std::move(parents_);
  }

private:
  Indexed_vector<Element, Element> parents_;
};

struct Component_tag;
typedef Index_of<Component_tag> Component_index;

// The components of sublevel or superlevel sets that merge in a sweep: disjoint sets, each with a top, the node at
// which the sweep has met it last. Both in one place, as a sweep jumps about in memory.
template <class Node>
class Merging_components
{
public:
  Index size() const { return static_cast<Index>(components_.size()); }

  // Adds a component of which `node` is all.
  Component_index add(Node node)
  {
    components_.push_back({components_.end_key(), node});
    return components_.last_key();
  }

  Component_index find(Component_index component)
  {
    return find_root(component, [&](Component_index i) -> Component_index& { return components_[i].parent; });
  }

  // Joins two components, given by their roots; `root` is the root of both then, and its top is that of both.
  void link(Component_index old_root, Component_index root) { components_[old_root].parent = root; }

  Node top(Component_index root) const { return components_[root].top; }
  void set_top(Component_index root, Node node) { components_[root].top = node; }

  // Fetches a component ahead of find(). Any index is allowed.
  void prefetch(Component_index component) const { prefetch_element(components_, component); }

private:
  struct Component
  {
    Component_index parent;
    Node top;
  };

  Indexed_vector<Component_index, Component> components_;
};

} // namespace CGAL::Reeb_graph::internal

#endif // CGAL_REEB_GRAPH_INTERNAL_BASE_UNION_FIND_H
