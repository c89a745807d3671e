// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_INTERNAL_BASE_NUMBER_SET_H
#define CGAL_REEB_GRAPH_INTERNAL_BASE_NUMBER_SET_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/internal/base/Index.h>
#include <CGAL/Reeb_graph/internal/base/Large_vector.h>

#include <bitset>
#include <cstddef>
#include <cstdint>

namespace CGAL {
namespace Reeb_graph {
namespace internal {

// A set of numbers below a bound, one bit for each, that tells the rank of a number in it.
class Number_set
{
public:
  typedef std::uint64_t Word;
  static constexpr std::size_t bits_per_word = 64;

  explicit Number_set(std::size_t bound) : words_(bound / bits_per_word + 1, 0) {}

  // Numbers in different words can be added from different threads.
  void add(Index number) { words_[number / bits_per_word] |= Word(1) << number % bits_per_word; }

  // To be called after the last number has been added.
  void count_ranks()
  {
    ranks_.resize(words_.size());
    Index rank = 0;
    for(std::size_t i = 0; i != words_.size(); ++i)
    {
      ranks_[i] = rank;
      rank += count(words_[i]);
    }
    size_ = rank;
  }

  Index size() const { return size_; }

  // How many lower numbers are in the set.
  Index rank(Index number) const
  {
    const Word lower_bits = (Word(1) << number % bits_per_word) - 1;
    return ranks_[number / bits_per_word] + count(words_[number / bits_per_word] & lower_bits);
  }

  // Calls visit(number) in ascending order.
  template <class Visit>
  void for_each(const Visit& visit) const
  {
    for(std::size_t i = 0; i != words_.size(); ++i)
    {
      for(Word word = words_[i]; word != 0; word &= word - 1)
        visit(static_cast<Index>(i * bits_per_word + count((word & (~word + 1)) - 1)));
    }
  }

private:
  static Index count(Word word) { return static_cast<Index>(std::bitset<bits_per_word>(word).count()); }

  Large_vector<Word> words_;
  Large_vector<Index> ranks_; // by word
  Index size_ = 0;
};

} // namespace internal
} // namespace Reeb_graph
} // namespace CGAL

#endif // CGAL_REEB_GRAPH_INTERNAL_BASE_NUMBER_SET_H
