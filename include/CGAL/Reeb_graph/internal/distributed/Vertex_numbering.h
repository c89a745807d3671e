// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors
#ifndef CGAL_REEB_GRAPH_INTERNAL_DISTRIBUTED_VERTEX_NUMBERING_H
#define CGAL_REEB_GRAPH_INTERNAL_DISTRIBUTED_VERTEX_NUMBERING_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/internal/base/Index.h>
#include <CGAL/Reeb_graph/internal/distributed/Slab_surface.h>
#include <CGAL/Reeb_graph/internal/mesh/mesh_indices.h>

#include <array>
#include <bitset>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

namespace CGAL {
namespace Reeb_graph {
namespace internal {

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
  void keep_between(Global_vertex begin, Global_vertex end)
  {
    const Global_vertex first = position * size;
    if(begin > first)
      bits &= ~Bits(0) << (begin - first);
    if(end < first + size)
      bits &= ~(~Bits(0) << (end - first));
  }

  Global_vertex first() const { return position * size + lowest(bits); }
  std::size_t number_of_vertices() const { return count(bits); }

  static Number lowest(Bits bits) { return count((bits & (~bits + 1)) - 1); }
  static Number count(Bits bits) { return static_cast<Number>(std::bitset<size>(bits).count()); }

  std::uint64_t position; // the first index divided by 64
  Bits bits;
};

// Some of the vertices of all ranks, numbered in ascending order. A page is kept for each 4096 indices of which any is
// in the set; it has a bit for each of them, and where many are, also their numbers.
class Vertex_numbering
{
public:
  explicit Vertex_numbering(Global_vertex number_of_vertices = 0)
    : pages_(static_cast<std::size_t>(number_of_vertices / page_size) + 1)
  {}

  void add(Global_vertex vertex)
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
    for(std::size_t i = 0; i != pages_.size(); ++i)
      if(pages_[i] != nullptr)
        pages_[i]->write_numbers();
  }

  Number size() const { return size_; }

  // The number of a vertex of the set.
  Vertex_index operator[](Global_vertex vertex) const
  {
    const Page& page = *pages_[vertex / page_size];
    return page.numbers != nullptr ? (*page.numbers)[vertex % page_size] : Vertex_index(page.count_up_to(vertex));
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

  typedef std::array<Vertex_index, page_size> Numbers;

  struct Page
  {
    std::size_t number(std::size_t begin)
    {
      first = static_cast<Number>(begin);
      std::size_t rank = 0;
      for(std::size_t i = 0; i != words_per_page; ++i)
      {
        ranks[i] = static_cast<std::uint16_t>(rank);
        rank += Vertex_word::count(bits[i]);
      }
      size = static_cast<Number>(rank);
      return begin + rank;
    }

    void write_numbers()
    {
      if(size < page_size / 4)
        return;
      numbers.reset(new Numbers);
      Vertex_index number(first);
      for(std::size_t i = 0; i != words_per_page; ++i)
        Vertex_word{i, bits[i]}.for_each([&](std::size_t place) {
          (*numbers)[place] = number;
          ++number;
        });
    }

    std::size_t count_up_to(Global_vertex vertex) const
    {
      const std::size_t word = word_of(vertex);
      const Vertex_word::Bits lower = (Vertex_word::Bits(1) << (vertex % Vertex_word::size)) - 1;
      return std::size_t(first) + ranks[word] + Vertex_word::count(bits[word] & lower);
    }

    std::array<Vertex_word::Bits, words_per_page> bits = {};
    std::array<std::uint16_t, words_per_page> ranks;
    Number first;
    Number size;
    std::unique_ptr<Numbers> numbers;
  };

  static std::size_t word_of(Global_vertex vertex) { return vertex / Vertex_word::size % words_per_page; }

  Page& page_of(std::uint64_t position)
  {
    std::unique_ptr<Page>& page = pages_[position];
    if(page == nullptr)
      page.reset(new Page);
    return *page;
  }

  std::vector<std::unique_ptr<Page>> pages_;
  Number size_ = 0;
};

} // namespace internal
} // namespace Reeb_graph
} // namespace CGAL

#endif // CGAL_REEB_GRAPH_INTERNAL_DISTRIBUTED_VERTEX_NUMBERING_H
