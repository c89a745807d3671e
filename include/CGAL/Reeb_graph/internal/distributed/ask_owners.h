// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors
#ifndef CGAL_REEB_GRAPH_INTERNAL_DISTRIBUTED_ASK_OWNERS_H
#define CGAL_REEB_GRAPH_INTERNAL_DISTRIBUTED_ASK_OWNERS_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/internal/distributed/Slab_surface.h>
#include <CGAL/Reeb_graph/internal/distributed/Vertex_numbering.h>
#include <CGAL/Reeb_graph/internal/distributed/Vertex_ranges.h>
#include <CGAL/Reeb_graph/internal/distributed/exchange.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <vector>

namespace CGAL {
namespace Reeb_graph {
namespace internal {

// The number of answers that a rank gives, or gets, in a round.
inline constexpr std::size_t most_answers = std::size_t(1) << 21;

// How many questions each rank may ask this one in a round, of those that it has left. All that have any may ask some.
inline std::vector<std::uint64_t> share_answers(std::vector<std::uint64_t> left)
{
  const std::uint64_t sum = std::accumulate(left.begin(), left.end(), std::uint64_t(0));
  if(sum > most_answers)
    for(std::uint64_t& number : left)
      number = number == 0 ? 0 : number * most_answers / sum + 1;
  return left;
}

// The questions of one rank to all others about some vertices, in rounds: in each, as many to each rank as it allows.
class Questions
{
public:
  Questions(const Vertex_ranges& ranges, const Vertex_numbering& vertices, std::size_t number_of_ranks)
    : vertices_(&vertices),
      ranges_(number_of_ranks, {0, 0, 0}),
      next_words_(number_of_ranks, 0),
      left_(number_of_ranks, 0)
  {
    for(const Vertex_range& range : ranges.ranges())
    {
      ranges_[range.rank] = range;
      next_words_[range.rank] = range.begin / Vertex_word::size;
      for_each_word(range.rank, [&](const Vertex_word& word) {
        left_[range.rank] += word.number_of_vertices();
        return true;
      });
    }
  }

  // How many there are left for each rank.
  const std::vector<std::uint64_t>& left() const { return left_; }

  // The words of the next round, of as many vertices as are allowed for each rank, and few more. Behind the call,
  // first_numbers()[rank] is the number of the first vertex of a parcel.
  Parcels<Vertex_word> next_round(const std::vector<std::uint64_t>& allowed)
  {
    Parcels<Vertex_word> parcels(ranges_.size());
    first_numbers_.assign(ranges_.size(), 0);
    std::uint64_t sum_of_ranks = 0;
    for(std::size_t rank = 0; rank != ranges_.size(); ++rank)
    {
      const std::size_t old_size = parcels.items.size();
      std::uint64_t sum = 0;
      next_words_[rank] = for_each_word(rank, [&](const Vertex_word& word) {
        if(sum >= allowed[rank] || sum_of_ranks >= most_answers)
          return false;
        if(sum == 0)
          first_numbers_[rank] = (*vertices_)[word.first()].number();
        sum += word.number_of_vertices();
        sum_of_ranks += word.number_of_vertices();
        parcels.items.push_back(word);
        return true;
      });
      left_[rank] -= sum;
      parcels.counts[rank] = static_cast<int>(parcels.items.size() - old_size);
    }
    return parcels;
  }

  const std::vector<std::size_t>& first_numbers() const { return first_numbers_; }

private:
  // Calls visit(word) for the words in the range of a rank that have not been asked, until it returns false. Returns
  // the position of that one.
  template <class Visit>
  std::uint64_t for_each_word(std::size_t rank, const Visit& visit) const
  {
    const Vertex_range& range = ranges_[rank];
    if(range.begin == range.end)
      return 0;
    return vertices_->for_each_word(next_words_[rank], [&](Vertex_word word) {
      if(word.position * Vertex_word::size >= range.end)
        return false;
      word.keep_between(range.begin, range.end);
      return word.bits == 0 || visit(word);
    });
  }

  const Vertex_numbering* vertices_;
  std::vector<Vertex_range> ranges_; // by rank
  std::vector<std::uint64_t> next_words_;
  std::vector<std::size_t> first_numbers_;
  std::vector<std::uint64_t> left_; // by rank
};

// The parcels of answers to parcels of questions: answer_of(vertex) for each.
template <class Answer, class AnswerOf>
Parcels<Answer> answer_questions(const std::vector<Vertex_word>& words,
                                 const std::vector<int>& counts,
                                 const AnswerOf& answer_of)
{
  Parcels<Answer> answers(counts.size());
  std::size_t size = 0;
  for(const Vertex_word& word : words)
    size += word.number_of_vertices();
  answers.items.reserve(size);
  auto word = words.begin();
  for(std::size_t rank = 0; rank != counts.size(); ++rank)
  {
    const std::size_t old_size = answers.items.size();
    for(const auto end = word + counts[rank]; word != end; ++word)
      word->for_each([&](Global_vertex vertex) { answers.items.push_back(answer_of(vertex)); });
    answers.counts[rank] = static_cast<int>(answers.items.size() - old_size);
  }
  return answers;
}

// Writes answer_of(vertex), asked at the rank in whose range the vertex is, to the place of its number in `result`, for
// all vertices of the numbering. Collective.
template <class Array, class AnswerOf>
void ask_owners(Exchange& exchange,
                const Vertex_ranges& ranges,
                const Vertex_numbering& vertices,
                const AnswerOf& answer_of,
                Array& result)
{
  typedef typename Array::value_type Answer;
  const std::size_t number_of_ranks = exchange.number_of_ranks();
  Questions questions(ranges, vertices, number_of_ranks);
  Parcels<Vertex_word> asked(number_of_ranks);
  Parcels<Answer> answers(number_of_ranks);
  const auto ask = [&] {
    const auto allowed = exchange.all_to_all(share_answers(exchange.all_to_all(questions.left())));
    exchange.in_agreement([&] { asked = questions.next_round(allowed); });
    return exchange.is_on_any_rank(!asked.items.empty());
  };
  exchange.in_agreement([&] { result.resize(vertices.size()); });
  while(ask())
  {
    std::vector<Vertex_word> words;
    const std::vector<int> word_counts = exchange.send(asked, words);
    exchange.in_agreement([&] { answers = answer_questions<Answer>(words, word_counts, answer_of); });
    std::vector<Answer> received;
    const std::vector<int> counts = exchange.send(answers, received);
    auto begin = received.begin();
    for(std::size_t rank = 0; rank != number_of_ranks; begin += counts[rank], ++rank)
      std::copy(begin, begin + counts[rank],
                result.begin() + static_cast<std::ptrdiff_t>(questions.first_numbers()[rank]));
  }
}

} // namespace internal
} // namespace Reeb_graph
} // namespace CGAL

#endif // CGAL_REEB_GRAPH_INTERNAL_DISTRIBUTED_ASK_OWNERS_H
