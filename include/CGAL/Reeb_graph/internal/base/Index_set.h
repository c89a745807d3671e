// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_INTERNAL_BASE_INDEX_SET_H
#define CGAL_REEB_GRAPH_INTERNAL_BASE_INDEX_SET_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/internal/base/Index.h>
#include <CGAL/Reeb_graph/internal/base/Plain_vector.h>

#include <bitset>
#include <cstddef>
#include <cstdint>

namespace CGAL {
namespace Reeb_graph {
namespace internal {

// A set of indices below a bound, one bit for each, that tells the rank of an index in it.
template <class Key>
class Index_set
{
public:
  struct Rank_tag;
  typedef Index_of<Rank_tag> Rank_index;

  typedef std::uint64_t Word;
  static constexpr std::size_t bits_per_word = 64;

  explicit Index_set(std::size_t bound) : words_(bound / bits_per_word + 1, 0) {}

  // Indices in different words can be added from different threads.
  void add(Key key) { words_[word_of(key)] |= Word(1) << bit_of(key); }

  // Ranks can be asked for after this call, and no index added.
  void count_ranks()
  {
    ranks_.resize(words_.size());
    Number rank = 0;
    for(std::size_t i = 0; i != words_.size(); ++i)
    {
      ranks_[i] = rank;
      rank += count(words_[i]);
    }
    size_ = rank;
  }

  Number size() const { return size_; }

  // How many lower indices are in the set: the name of one that is in it.
  Rank_index rank(Key key) const
  {
    const Word lower_bits = (Word(1) << bit_of(key)) - 1;
    return Rank_index(ranks_[word_of(key)] + count(words_[word_of(key)] & lower_bits));
  }

  // Calls visit(index) in ascending order.
  template <class Visit>
  void for_each(const Visit& visit) const
  {
    for(std::size_t i = 0; i != words_.size(); ++i)
    {
      for(Word word = words_[i]; word != 0; word &= word - 1)
        visit(Key(i * bits_per_word + count((word & (~word + 1)) - 1)));
    }
  }

private:
  static std::size_t word_of(Key key) { return key.number() / bits_per_word; }
  static Number bit_of(Key key) { return key.number() % bits_per_word; }
  static Number count(Word word) { return static_cast<Number>(std::bitset<bits_per_word>(word).count()); }

  Plain_vector<Word> words_;
  Plain_vector<Number> ranks_; // by word
  Number size_ = 0;
};

} // namespace internal
} // namespace Reeb_graph
} // namespace CGAL

#endif // CGAL_REEB_GRAPH_INTERNAL_BASE_INDEX_SET_H
