// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_INTERNAL_BASE_INDEXED_VECTOR_H
#define CGAL_REEB_GRAPH_INTERNAL_BASE_INDEXED_VECTOR_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/internal/base/Index.h>
#include <CGAL/Reeb_graph/internal/base/Plain_vector.h>

#include <cstddef>

namespace CGAL {
namespace Reeb_graph {
namespace internal {

// A vector whose elements are named by indices of one kind.
template <class Key, class T>
class Indexed_vector : private Vector_of<T>
{
  typedef Vector_of<T> Base;

public:
  using typename Base::const_iterator;
  using typename Base::const_reference;
  using typename Base::iterator;
  using typename Base::reference;
  using typename Base::value_type;

  using Base::assign;
  using Base::back;
  using Base::Base;
  using Base::begin;
  using Base::capacity;
  using Base::clear;
  using Base::data;
  using Base::empty;
  using Base::end;
  using Base::erase;
  using Base::front;
  using Base::push_back;
  using Base::rbegin;
  using Base::rend;
  using Base::reserve;
  using Base::resize;
  using Base::size;

  reference operator[](Key key) { return Base::operator[](number_of(key)); }
  const_reference operator[](Key key) const { return Base::operator[](number_of(key)); }

  // Replaces the content, which takes less time to compile than to resize, which keeps it.
  void renew(std::size_t size) { *this = Indexed_vector(size); }
  void renew(std::size_t size, const T& value) { *this = Indexed_vector(size, value); }

  bool contains(Key key) const { return number_of(key) < size(); }

  // The key of the element that push_back() adds next, and of the last one.
  Key end_key() const { return Key(size()); }
  Key last_key() const { return Key(size() - 1); }

  Index_range<Key> keys() const { return Index_range<Key>(size()); }
};

} // namespace internal
} // namespace Reeb_graph
} // namespace CGAL

#endif // CGAL_REEB_GRAPH_INTERNAL_BASE_INDEXED_VECTOR_H
