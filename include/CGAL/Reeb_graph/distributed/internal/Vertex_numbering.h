// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_DISTRIBUTED_INTERNAL_VERTEX_NUMBERING_H
#define CGAL_REEB_GRAPH_DISTRIBUTED_INTERNAL_VERTEX_NUMBERING_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/distributed/internal/exchange.h>
#include <CGAL/Reeb_graph/distributed/internal/solve_slab.h>
#include <CGAL/Reeb_graph/internal/base/Index.h>
#include <CGAL/Reeb_graph/internal/base/arrays.h>

#include <boost/mpi/collectives.hpp>

#include <algorithm>
#include <array>
#include <bitset>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <numeric>
#include <random>
#include <vector>

namespace CGAL::Reeb_graph::internal {

// 64 global indices, of which some are meant: how sets of vertices are sent.
struct Vertex_word
{
  typedef std::uint64_t Bits;
  static constexpr std::size_t size = 64;

  // Calls visit(vertex) in ascending order.
  template <class Visit>
  void for_each(const Visit& visit) const
  {
    if(bits == ~Bits(0))
    {
      for(std::size_t i = 0; i != size; ++i)
        visit(position * size + i);
    }
    else
    {
      for(Bits rest = bits; rest != 0; rest &= rest - 1)
        visit(position * size + lowest(rest));
    }
  }

  // Leaves out the vertices that are not from `begin` to the one before `end`, where some of the word are.
  void keep_between(Long_index begin, Long_index end)
  {
    const Long_index first = position * size;
    if(begin > first)
      bits &= ~Bits(0) << (begin - first);
    if(end < first + size)
      bits &= ~(~Bits(0) << (end - first));
  }

  Long_index first() const { return position * size + lowest(bits); }
  std::size_t number_of_vertices() const { return count(bits); }

  static Index lowest(Bits bits) { return count((bits & (~bits + 1)) - 1); }
  static Index count(Bits bits) { return static_cast<Index>(std::bitset<size>(bits).count()); }

  std::uint64_t position; // the first index divided by 64
  Bits bits;
};

// Some of the vertices of all ranks, numbered in ascending order. A page is kept for each 4096 indices of which any is
// in the set; it has a bit for each of them.
class Vertex_numbering
{
public:
  explicit Vertex_numbering(Long_index number_of_vertices = 0)
    : pages_(static_cast<std::size_t>(number_of_vertices / page_size) + 1)
  {}

  void add(Long_index vertex)
  {
    page_of(vertex / page_size).bits[word_of(vertex)] |= Vertex_word::Bits(1) << (vertex % Vertex_word::size);
  }

  void add(const Vertex_word& word)
  {
    page_of(word.position / words_per_page).bits[word.position % words_per_page] |= word.bits;
  }

  // Numbers the vertices. No others can be added afterwards. Throws if they are too many.
  void number()
  {
    std::size_t size = 0;
    for(const std::unique_ptr<Page>& page : pages_)
      if(page != nullptr)
        size = page->number(size);
    size_ = checked_index(size);
  }

  Index size() const { return size_; }

  // The number of a vertex of the set.
  Vertex_index operator[](Long_index vertex) const
  {
    const Page& page = *pages_[vertex / page_size];
    const std::size_t word = word_of(vertex);
    const Vertex_word::Bits lower = (Vertex_word::Bits(1) << (vertex % Vertex_word::size)) - 1;
    return Vertex_index(std::size_t(page.first) + page.ranks[word] + Vertex_word::count(page.bits[word] & lower));
  }

  // Calls visit(word) for the words from `position` on which have any vertex, in ascending order, until it returns
  // false. Returns the position of that one.
  template <class Visit>
  std::uint64_t for_each_word(std::uint64_t position, const Visit& visit) const
  {
    for(; position < pages_.size() * words_per_page; ++position)
    {
      const std::unique_ptr<Page>& page = pages_[position / words_per_page];
      if(page == nullptr)
        position |= words_per_page - 1;
      else
      {
        const Vertex_word word = {position, page->bits[position % words_per_page]};
        if(word.bits != 0 && !visit(word))
          break;
      }
    }
    return position;
  }

private:
  static constexpr std::size_t words_per_page = 64;
  static constexpr std::size_t page_size = words_per_page * Vertex_word::size;

  struct Page
  {
    std::size_t number(std::size_t begin)
    {
      first = static_cast<Index>(begin);
      std::size_t rank = 0;
      for(std::size_t i = 0; i != words_per_page; ++i)
      {
        ranks[i] = static_cast<std::uint16_t>(rank);
        rank += Vertex_word::count(bits[i]);
      }
      return begin + rank;
    }

    std::array<Vertex_word::Bits, words_per_page> bits = {};
    std::array<std::uint16_t, words_per_page> ranks;
    Index first;
  };

  static std::size_t word_of(Long_index vertex) { return vertex / Vertex_word::size % words_per_page; }

  Page& page_of(std::uint64_t position)
  {
    std::unique_ptr<Page>& page = pages_[position];
    if(page == nullptr)
      page.reset(new Page);
    return *page;
  }

  std::vector<std::unique_ptr<Page>> pages_;
  Index size_ = 0;
};

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
      word->for_each([&](Long_index vertex) { answers.items.push_back(answer_of(vertex)); });
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

// Calls visit(i) for numbers below `size`, of each of `sample_size` equal parts one at random; for all if they are
// fewer.
template <class Visit>
void for_each_of_sample(std::uint64_t size, std::uint64_t sample_size, const Visit& visit)
{
  std::minstd_rand random;
  sample_size = (std::min)(sample_size, size);
  for(std::uint64_t i = 0; i != sample_size; ++i)
  {
    const std::uint64_t begin = i * size / sample_size, end = (i + 1) * size / sample_size;
    visit(begin + random() % (end - begin)); // NOLINT(clang-analyzer-core.DivideZero): parts are not empty
  }
}

// The share of a rank that has `local_size` of `size` things in a sample of all, rounded up.
inline std::uint64_t share_of_sample(std::uint64_t sample_size, std::uint64_t local_size, std::uint64_t size)
{
  return size <= sample_size ? local_size : (local_size * sample_size + size - 1) / size;
}

// A sample of the vertices, ascending, at rank 0: that of this rank has the indices from `begin` on, and the given values.
// The numbers of vertices of slabs differ by about the square root of their number in the sample in as many. Rank 0 has
// room for it. Collective.
template <class Scalars>
std::vector<Order_key> sample_vertices(Exchange& exchange,
                                       Long_index begin,
                                       const Scalars& scalars,
                                       std::uint64_t number_of_vertices,
                                       std::size_t number_of_slabs)
{
  constexpr std::uint64_t most_per_slab = 2048, least_per_slab = 64, most = std::uint64_t(1) << 22;
  const std::uint64_t sample_size =
    number_of_slabs * (std::max)(least_per_slab, (std::min)(most_per_slab, most / number_of_slabs));
  std::vector<Order_key> own;
  exchange.in_agreement([&] {
    const std::uint64_t size = static_cast<std::uint64_t>(std::end(scalars) - std::begin(scalars));
    for_each_of_sample(size, share_of_sample(sample_size, size, number_of_vertices), [&](std::uint64_t i) {
      const auto place = std::begin(scalars) + static_cast<std::ptrdiff_t>(i);
      own.push_back({static_cast<double>(*place), begin + i});
    });
  });
  std::vector<Order_key> sample = gather_arrays(exchange, own).elements;
  std::sort(sample.begin(), sample.end());
  return sample;
}

// The levels between slabs by a sample, so that slabs have about the same number of vertices; the same on all ranks.
// Collective.
inline Splitters choose_splitters(Exchange& exchange, const std::vector<Order_key>& sample, std::size_t number_of_slabs)
{
  Splitters splitters;
  exchange.in_agreement([&] {
    if(exchange.rank() == 0)
      for(std::size_t slab = 1; slab < number_of_slabs; ++slab)
        splitters.push_back(sample[slab * sample.size() / number_of_slabs - 1]);
  });
  exchange.broadcast(splitters);
  return splitters;
}

// Some triangles of this rank, by the places of their vertices, to foresee how many slabs triangles meet.
// key_of(vertex) is asked for vertices of this rank's range. Collective.
template <class Triangles, class KeyOf>
std::vector<std::array<Order_key, 3>> sample_triangles(Exchange& exchange,
                                                       const Vertex_ranges& ranges,
                                                       const Triangles& triangles,
                                                       std::uint64_t number_of_triangles,
                                                       const KeyOf& key_of)
{
  constexpr std::uint64_t sample_size = std::uint64_t(1) << 15;
  std::vector<std::array<Long_index, 3>> sample;
  Vertex_numbering vertices;
  exchange.in_agreement([&] {
    vertices = Vertex_numbering(ranges.number_of_vertices());
    const std::uint64_t size = static_cast<std::uint64_t>(std::end(triangles) - std::begin(triangles));
    for_each_of_sample(size, share_of_sample(sample_size, size, number_of_triangles), [&](std::uint64_t i) {
      const auto& triangle = std::begin(triangles)[static_cast<std::ptrdiff_t>(i)];
      sample.push_back({static_cast<Long_index>(triangle[0]), static_cast<Long_index>(triangle[1]),
                        static_cast<Long_index>(triangle[2])});
      for(const Long_index vertex : sample.back())
        vertices.add(vertex);
    });
    vertices.number();
  });
  Vertex_keys keys;
  ask_owners(exchange, ranges, vertices, key_of, keys);
  std::vector<std::array<Order_key, 3>> result;
  exchange.in_agreement([&] {
    const auto place = [&](Long_index v) { return Order_key{keys[vertices[v]], v}; };
    for(const std::array<Long_index, 3>& t : sample)
      result.push_back({place(t[0]), place(t[1]), place(t[2])});
  });
  return result;
}

// How many slabs a triangle of a sample meets, on average. Collective.
inline double slabs_per_triangle(const Exchange& exchange,
                                 const std::vector<std::array<Order_key, 3>>& triangles,
                                 const Splitters& splitters)
{
  std::array<std::uint64_t, 2> counts = {0, triangles.size()}, sums = {};
  for(const std::array<Order_key, 3>& triangle : triangles)
  {
    const auto ends = std::minmax_element(triangle.begin(), triangle.end());
    counts[0] += slab_of(splitters, *ends.second) - slab_of(splitters, *ends.first) + 1;
  }
  boost::mpi::all_reduce(exchange.communicator(), counts.data(), 2, sums.data(), std::plus<std::uint64_t>());
  return sums[1] == 0 ? 1 : static_cast<double>(sums[0]) / static_cast<double>(sums[1]);
}

} // namespace CGAL::Reeb_graph::internal

#endif // CGAL_REEB_GRAPH_DISTRIBUTED_INTERNAL_VERTEX_NUMBERING_H
