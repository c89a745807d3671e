// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_INTERNAL_BASE_BUCKETS_H
#define CGAL_REEB_GRAPH_INTERNAL_BASE_BUCKETS_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/internal/base/arrays.h>

#include <CGAL/Iterator_range.h>

#include <cstddef>

namespace CGAL::Reeb_graph::internal {

// Items in buckets, one for each key, one behind the other in one array: made by counting, then placing them. In a
// bucket, they have the order in which they come.
template <class Key, class Item>
class Buckets
{
public:
  typedef Iterator_range<const Item*> Bucket;

  Buckets() = default;

  // for_each_item(visit) calls visit(key, item), and is called twice.
  template <class ForEachItem>
  Buckets(std::size_t number_of_keys, const ForEachItem& for_each_item) : first_items_(number_of_keys + 2, 0)
  {
    // The counts are two places ahead, so that placing leaves each bucket's begin behind, at its own place.
    std::size_t number_of_items = 0;
    for_each_item([&](Key key, const Item&) {
      ++first_items_[Key(key.number() + 2)];
      ++number_of_items;
    });
    checked_index(number_of_items);
    Index sum = 0;
    for(Index& first : first_items_)
      first = sum += first;
    items_.resize(number_of_items);
    for_each_item([&](Key key, const Item& item) { items_[first_items_[Key(key.number() + 1)]++] = item; });
    first_items_.resize(number_of_keys + 1);
  }

  std::size_t size() const { return items_.size(); }

  Iterator_range<Item*> operator[](Key key)
  {
    return {items_.data() + first_items_[key], items_.data() + first_items_[Key(key.number() + 1)]};
  }
  Bucket operator[](Key key) const
  {
    return {items_.data() + first_items_[key], items_.data() + first_items_[Key(key.number() + 1)]};
  }

private:
  Indexed_vector<Key, Index> first_items_; // by key; and the end
  Vector_of<Item> items_;
};

} // namespace CGAL::Reeb_graph::internal

#endif // CGAL_REEB_GRAPH_INTERNAL_BASE_BUCKETS_H
