// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_INTERNAL_COMPLEX_VERTEX_ORDER_H
#define CGAL_REEB_GRAPH_INTERNAL_COMPLEX_VERTEX_ORDER_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/internal/base/Tuned_part.h>
#include <CGAL/Reeb_graph/internal/base/arrays.h>
#include <CGAL/Reeb_graph/internal/base/prefetch.h>

namespace CGAL::Reeb_graph::internal {

// The field as the stages see it: a number for each vertex, none of them NaN. Keyed_field makes these of the values of
// a user, whatever their type and order are.
typedef Indexed_vector<Vertex_index, double> Vertex_keys;

// The total order of the vertices: by key, then by index (simulation of simplicity). Everything that the stages decide
// about the field, they decide by this comparison; a tie is broken nowhere else.
class Vertex_order
{
public:
  // A name of a vertex with its key, to be sorted without access to the array of all keys. Names are in the order of the
  // vertices' indices.
  template <class Name>
  struct Key
  {
    double key;
    Name name;

    friend bool operator<(const Key& a, const Key& b) { return a.key < b.key || (!(b.key < a.key) && a.name < b.name); }
  };

  // The order refers to the keys.
  explicit Vertex_order(const Vertex_keys& keys) : keys_(&keys) {}

  // Whether vertex u is lower than vertex v. Sweeps ask in the order of the mesh, in which a branch on the first
  // comparison is foreseen where the field is smooth, and what depends on the answer need not wait for the keys.
  bool operator()(Vertex_index u, Vertex_index v) const { return key(u, u) < key(v, v); }

  void prefetch(Vertex_index v) const { prefetch_element(*keys_, v); }

  template <class Name>
  Key<Name> key(Vertex_index v, Name name) const
  {
    return {(*keys_)[v], name};
  }

  // Sorting asks what cannot be foreseen, so the answer is computed without a branch but on ties, which are few or come
  // in a row.
  template <class Name>
  bool operator()(const Key<Name>& a, const Key<Name>& b) const
  {
    if constexpr(is_used(Tuned_part::BRANCHLESS_ORDER))
      return a.key == b.key ? a.name < b.name : a.key < b.key;
    else
      return a < b;
  }

  // Tells the order without a branch, where the answer cannot be foreseen.
  bool is_lower(Vertex_index u, Vertex_index v) const { return (*this)(key(u, u), key(v, v)); }

  // Whether the keys are the same, so that only the indices order the vertices.
  bool are_tied(Vertex_index u, Vertex_index v) const { return (*keys_)[u] == (*keys_)[v]; }

private:
  const Vertex_keys* keys_;
};

} // namespace CGAL::Reeb_graph::internal

#endif // CGAL_REEB_GRAPH_INTERNAL_COMPLEX_VERTEX_ORDER_H
