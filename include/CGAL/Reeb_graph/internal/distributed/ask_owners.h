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
#include <vector>

namespace CGAL {
namespace Reeb_graph {
namespace internal {

// The questions of one rank to all others about some vertices, in rounds: in each, a bounded number to each rank.
class Questions
{
public:
  Questions(const Vertex_ranges& ranges, const Vertex_numbering& vertices, std::size_t number_of_ranks)
    : vertices_(&vertices),
      ranges_(number_of_ranks, {0, 0, 0}),
      next_words_(number_of_ranks, 0),
      most_in_round_((std::max)(most_answers / number_of_ranks, Vertex_word::size))
  {
    for(const Vertex_range& range : ranges.ranges())
    {
      ranges_[range.rank] = range;
      next_words_[range.rank] = range.begin / Vertex_word::size;
    }
  }

  // The words of the next round. Behind the call, first_numbers()[rank] is the number of the first vertex of a parcel.
  Parcels<Vertex_word> next_round()
  {
    Parcels<Vertex_word> parcels(ranges_.size());
    first_numbers_.assign(ranges_.size(), 0);
    for(std::size_t rank = 0; rank != ranges_.size(); ++rank)
    {
      const Vertex_range& range = ranges_[rank];
      const std::size_t old_size = parcels.items.size();
      std::size_t sum = 0;
      if(range.begin != range.end)
        next_words_[rank] = vertices_->for_each_word(next_words_[rank], [&](Vertex_word word) {
          if(word.position * Vertex_word::size >= range.end || sum >= most_in_round_)
            return false;
          word.keep_between(range.begin, range.end);
          if(word.bits == 0)
            return true;
          if(sum == 0)
            first_numbers_[rank] = (*vertices_)[word.first()].number();
          sum += word.number_of_vertices();
          parcels.items.push_back(word);
          return true;
        });
      parcels.counts[rank] = static_cast<int>(parcels.items.size() - old_size);
    }
    return parcels;
  }

  const std::vector<std::size_t>& first_numbers() const { return first_numbers_; }

private:
  // The number of answers that a rank gives in a round if all others ask it the most they may.
  static constexpr std::size_t most_answers = std::size_t(1) << 21;

  const Vertex_numbering* vertices_;
  std::vector<Vertex_range> ranges_; // by rank
  std::vector<std::uint64_t> next_words_;
  std::vector<std::size_t> first_numbers_;
  std::size_t most_in_round_;
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
  exchange.in_agreement([&] {
    result.resize(vertices.size());
    asked = questions.next_round();
  });
  while(exchange.is_on_any_rank(!asked.items.empty()))
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
    exchange.in_agreement([&] { asked = questions.next_round(); });
  }
}

} // namespace internal
} // namespace Reeb_graph
} // namespace CGAL

#endif // CGAL_REEB_GRAPH_INTERNAL_DISTRIBUTED_ASK_OWNERS_H
