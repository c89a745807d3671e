// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_INTERNAL_COMPLEX_REGULAR_VERTICES_H
#define CGAL_REEB_GRAPH_INTERNAL_COMPLEX_REGULAR_VERTICES_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/internal/base/Threads.h>
#include <CGAL/Reeb_graph/internal/base/Tuned_part.h>
#include <CGAL/Reeb_graph/internal/base/arrays.h>
#include <CGAL/Reeb_graph/internal/base/prefetch.h>
#include <CGAL/Reeb_graph/internal/complex/Vertex_order.h>
#include <CGAL/Reeb_graph/internal/complex/surface_complexes.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <vector>

namespace CGAL::Reeb_graph::internal {

// Findings of turns around some vertices in a row, at several places.
struct Sampled_turns
{
  std::size_t number = 0;
  std::size_t pages = 0;             // of memory that the halfedges of the vertices in a row are on
  std::size_t changes_of_length = 0; // from a vertex to the next one, which the processor cannot foresee
  std::size_t plain_links = 0;       // which ascend once and descend once
};

// Adds a turn, and the pages on which its halfedges are. Returns its length. Nothing has been checked yet.
template <class Complex, class Order>
std::size_t sample_turn(const Complex& complex,
                        const Order& order,
                        Vertex_index vertex,
                        Sampled_turns& sample,
                        Plain_vector<Index>& pages)
{
  constexpr std::size_t halfedges_per_page = 256, most_steps = 16;
  const auto can_go_on = [&](Halfedge_index h) {
    return h.number() < complex.number_of_halfedges() && complex.has_triangle(h)
        && complex.source(h).number() < complex.number_of_vertices();
  };
  const Halfedge_index begin = complex.kept_halfedge(vertex);
  std::size_t length = 0, changes_of_direction = 0;
  bool is_first_higher = false, is_last_higher = false;
  for(Halfedge_index h = begin; can_go_on(h) && length != most_steps; ++length)
  {
    pages.push_back(h.number() / halfedges_per_page);
    const Halfedge_index turned = opposite_of(complex.next(h));
    if(!can_go_on(turned))
      break;
    const bool is_higher = order(complex.source(h), complex.source(turned));
    is_first_higher = length == 0 ? is_higher : is_first_higher;
    changes_of_direction += length != 0 && is_higher != is_last_higher ? 1 : 0;
    is_last_higher = is_higher;
    h = turned;
    if(h == begin)
    {
      changes_of_direction += is_first_higher != is_last_higher ? 1 : 0;
      sample.plain_links += changes_of_direction == 2 ? 1 : 0;
      break;
    }
  }
  return length;
}

// Samples no turns if the mesh is small.
template <class Complex, class Order>
Sampled_turns sample_turns(const Complex& complex, const Order& order)
{
  constexpr std::size_t number_of_rows = 16, vertices_per_row = 32;
  constexpr std::size_t smallest_number_of_edges = 100000; // Fewer ones are in the caches.
  Sampled_turns sample;
  if(complex.number_of_edges() < smallest_number_of_edges
     || complex.number_of_vertices() < smallest_number_of_edges / 4)
    return sample;
  Plain_vector<Index> pages;
  for(std::size_t row = 0; row != number_of_rows; ++row)
  {
    const std::size_t first = row * (complex.number_of_vertices() - vertices_per_row) / number_of_rows;
    std::size_t last_length = 0;
    pages.clear();
    for(std::size_t v = first; v != first + vertices_per_row; ++v, ++sample.number)
    {
      const std::size_t length = sample_turn(complex, order, Vertex_index(v), sample, pages);
      sample.changes_of_length += length != last_length ? 1 : 0;
      last_length = length;
    }
    std::sort(pages.begin(), pages.end());
    sample.pages += static_cast<std::size_t>(std::unique(pages.begin(), pages.end()) - pages.begin());
  }
  return sample;
}

enum class Way_of_turning
{
  ONE_BY_ONE,
  BEHIND_SWEEP, // which finds regular vertices
  STARS_AHEAD
};

// The fastest way to turn around all vertices. A sweep finds vertices to be regular faster than turns around them if it
// finds nearly all, and turns wait: for memory, as each step is known only when the last one has come, or as the
// processor cannot foresee where they end. Where the sweep jumps about in memory, too, or does not find them, stars are
// fetched ahead if they are far. The bounds have been measured.
template <class Complex, class Order>
Way_of_turning fastest_way(const Complex& complex, const Order& order)
{
  const Sampled_turns sample = sample_turns(complex, order);
  const bool are_plain = 25 * sample.plain_links > 24 * sample.number,
             are_waiting = 4 * sample.pages + sample.changes_of_length > sample.number,
             are_jumping = 2 * sample.pages > 5 * sample.number;
  if(is_used(Tuned_part::TRIANGLE_SWEEP) && are_plain && are_waiting
     && !(is_used(Tuned_part::STARS_AHEAD) && are_jumping))
    return Way_of_turning::BEHIND_SWEEP;
  if(is_used(Tuned_part::STARS_AHEAD) && 5 * sample.pages > 2 * sample.number)
    return Way_of_turning::STARS_AHEAD;
  return Way_of_turning::ONE_BY_ONE;
}

// Addends of a triangle to the counts of its vertices, and to those of what is opposite of its halfedges.
struct Triangle_addends
{
  // Counts of a vertex, as one number, so that it is written once for each corner: of the corners of triangles; of those
  // where it is not the middle vertex; and of those with the halfedge that the mesh keeps for it. Where there are too
  // many of them for their bits, the sum of all corners is wrong, if it is below 2^31.
  static constexpr Index corner = 1 << 16, no_middle = 2, kept = 1;

  // For a halfedge with a triangle, and if the vertex opposite of it is the highest one, or the lowest one.
  static constexpr std::uint8_t is_there = 4, is_highest = 1, is_lowest = 2;

  std::array<Index, 3> counts = {};
  std::array<std::uint8_t, 3> apexes = {}; // opposite of the halfedge that ends at each vertex
};

// By the bits of a number: whether each vertex of the triangle is lower than the next one; and whether the halfedge that
// ends at each is the one that the mesh keeps for it.
constexpr std::array<Triangle_addends, 64> make_triangle_addends()
{
  std::array<Triangle_addends, 64> result = {};
  for(unsigned code = 0; code != result.size(); ++code)
    for(unsigned i = 0; i != 3; ++i)
    {
      const auto is_below_next = [&](unsigned vertex) { return (code >> vertex % 3 & 1) != 0; };
      Triangle_addends& addends = result[code];
      addends.counts[i] = Triangle_addends::corner;
      if(is_below_next(i) != is_below_next(i + 2))
        addends.counts[i] += Triangle_addends::no_middle;
      if((code >> (i + 3) & 1) != 0)
        addends.counts[i] += Triangle_addends::kept;
      addends.apexes[i] = Triangle_addends::is_there;
      if(is_below_next(i) != is_below_next(i + 1))
        addends.apexes[i] |= is_below_next(i) ? Triangle_addends::is_highest : Triangle_addends::is_lowest;
    }
  return result;
}
inline constexpr std::array<Triangle_addends, 64> triangle_addends = make_triangle_addends();

// The vertices that are seen to be regular, and to have one fan, with no turn around them: by a sweep over the
// triangles, in the order in which they are in memory.
//
// Each triangle has a lowest, a middle and a highest vertex. They are the vertices that are
// - the middle one of two triangles,
// - only on edges with two triangles,
// - on no edge up whose other vertices in both triangles are the highest ones, and
// - on no edge down whose other vertices in both triangles are the lowest ones.
// By the second condition, each of their fans is inside of the surface: its link is a closed curve, which changes
// between lower and higher vertices in those triangles in which its vertex is the middle one. So by the first condition
// one fan has one lower and one upper part, or there is none but such with a link that is all lower or all higher; as
// the changes of a closed curve are an even number, they are not of two fans. If the link of a fan is all higher, it has
// a lowest vertex, which is on an edge of the third kind; if it is all lower, its highest one is on one of the fourth.
// So there is no such fan, and the one that is left has one lower and one upper part.
//
// These are nearly all vertices of a smooth field. There are none here if something is wrong with a face, nor is a vertex
// for which the mesh keeps a halfedge that does not end there.
class Regular_vertices
{
public:
  // No vertices.
  Regular_vertices() = default;

  template <class Complex>
  Regular_vertices(const Threads& threads, const Complex& complex, const Vertex_order& order)
  {
    counts_.resize((std::min)(threads.number(), most_parts));
    Apexes apexes(complex.number_of_halfedges() + 2 * edges_per_group, 0);
    Relaxed_value<bool> is_any_bad;
    threads.for_each_part(counts_.size(), complex.end_of_triangles(),
                          [&](std::size_t part, std::size_t begin, std::size_t end) {
                            counts_[part].reset(complex.number_of_vertices(), 0);
                            if(!sweep(complex, order, begin, end, counts_[part], apexes))
                              is_any_bad.set(true);
                          });
    if(is_any_bad.get() || complex.number_of_halfedges() >> 31 != 0 || !join_counts(threads, complex))
      counts_.clear();
    else
      exclude_ends_of_edges(threads, complex, order, apexes);
  }

  // How many corners of triangles are at a vertex, 0 if it is none of these.
  Index number_of_corners(Vertex_index vertex) const
  {
    if(counts_.empty())
      return 0;
    const Index count = counts_[0][vertex], number = count / Triangle_addends::corner;
    return count
            == number * Triangle_addends::corner + (number - 2) * Triangle_addends::no_middle + Triangle_addends::kept
           ? number
           : 0;
  }

private:
  typedef Indexed_vector<Vertex_index, Index> Counts;

  // For the triangle of a halfedge, and for the vertex opposite of it there. Zero where there is no triangle.
  typedef Indexed_vector<Halfedge_index, std::uint8_t> Apexes;

  static constexpr std::size_t edges_per_group = 4;
  static constexpr std::size_t most_parts = 16; // each of which needs memory for all vertices

  // Triangles that have been read, whose vertices are fetched before they are compared.
  struct Fetched_block
  {
    Triangle_block block;
    std::array<Index, Triangle_block::capacity> codes; // as triangle_addends has them
  };

  // Returns whether all is right with the triangles.
  template <class Complex>
  static bool sweep(const Complex& complex,
                    const Vertex_order& order,
                    std::size_t begin,
                    std::size_t end,
                    Counts& counts,
                    Apexes& apexes)
  {
    std::array<Fetched_block, 2> blocks;
    std::size_t number = 0;
    const auto add_last = [&] { add_triangles(order, blocks[(number + 1) % 2], counts, apexes); };
    for(std::size_t i = begin; i < end; i += Triangle_block::capacity, ++number)
    {
      Fetched_block& fetched = blocks[number % 2];
      if(!complex.read_triangles(i, (std::min)(i + Triangle_block::capacity, end), fetched.block))
        return false;
      for(std::size_t t = 0; t != fetched.block.size; ++t)
      {
        const auto& [halfedges, vertices] = fetched.block.triangles[t];
        fetched.codes[t] = 0;
        for(std::size_t k = 0; k != 3; ++k)
        {
          order.prefetch(vertices[k]);
          prefetch(&counts[vertices[k]]);
          fetched.codes[t] |= static_cast<Index>(complex.kept_halfedge(vertices[k]) == halfedges[k]) << (k + 3);
        }
      }
      add_last();
    }
    add_last();
    return true;
  }

  // Without branches on what is compared, as none could be foreseen. The first loop writes no bytes to memory, which
  // might be addresses for all that a compiler knows.
  static void add_triangles(const Vertex_order& order, Fetched_block& fetched, Counts& all_counts, Apexes& all_apexes)
  {
    const Triangle_block& block = fetched.block;
    for(std::size_t i = 0; i != block.size; ++i)
    {
      const auto& [a, b, c] = block.triangles[i].vertices;
      fetched.codes[i] |= static_cast<Index>(order.is_lower(a, b)) | static_cast<Index>(order.is_lower(b, c)) << 1
                        | static_cast<Index>(order.is_lower(c, a)) << 2;
    }
    Index* const counts = &all_counts[Vertex_index(0)];
    std::uint8_t* const apexes = &all_apexes[Halfedge_index(0)];
    for(std::size_t i = 0; i != block.size; ++i)
    {
      const Triangle_addends& addends = triangle_addends[fetched.codes[i]];
      const auto& [halfedges, vertices] = block.triangles[i];
      for(std::size_t k = 0; k != 3; ++k)
        counts[vertices[k].number()] += addends.counts[k];
      for(std::size_t k = 0; k != 3; ++k)
        apexes[halfedges[k].number()] = addends.apexes[k];
    }
  }

  // Returns whether there are no more corners at a vertex than fit.
  template <class Complex>
  bool join_counts(const Threads& threads, const Complex& complex)
  {
    const auto join = [&](std::size_t begin, std::size_t end, std::size_t& number_of_corners) {
      const Index_range<Vertex_index> vertices(Vertex_index{begin}, Vertex_index{end});
      for(std::size_t part = 1; part != counts_.size(); ++part)
        for(const Vertex_index v : vertices)
          counts_[0][v] += counts_[part][v];
      for(const Vertex_index v : vertices)
        number_of_corners += counts_[0][v] / Triangle_addends::corner;
    };
    return threads.sum_of_parts<std::size_t>(complex.number_of_vertices(), join) == 3 * complex.number_of_faces();
  }

  // Excludes the vertices that the edges exclude. It looks at four edges at a time: there are few that do.
  template <class Complex>
  void exclude_ends_of_edges(const Threads& threads,
                             const Complex& complex,
                             const Vertex_order& order,
                             const Apexes& apexes)
  {
    const std::size_t number_of_edges = complex.number_of_edges(),
                      number_of_groups = (number_of_edges + edges_per_group - 1) / edges_per_group;
    std::vector<Plain_vector<Vertex_index>> excluded(threads.number_of_parts(number_of_groups));
    const auto find_excluded = [&](std::size_t part, std::size_t begin, std::size_t end) {
      for(std::size_t group = begin; group != end; ++group)
        if(is_decisive(apexes, group))
          for(std::size_t e = group * edges_per_group; e != (group + 1) * edges_per_group; ++e)
            if(e < number_of_edges && complex.has_edge(Edge_index(e)))
              add_excluded_ends(complex, order, even_halfedge(Edge_index(e)), apexes, excluded[part]);
    };
    threads.for_each_part(excluded.size(), number_of_groups, find_excluded);
    for(const auto& vertices : excluded)
      for(const Vertex_index v : vertices)
        counts_[0][v] = 0;
  }

  // Whether an edge of a group has one triangle, or none, or two whose opposite vertices are both the highest ones or
  // both the lowest ones.
  static bool is_decisive(const Apexes& apexes, std::size_t group)
  {
    std::uint64_t at_halfedges;
    static_assert(sizeof(at_halfedges) == 2 * edges_per_group);
    std::memcpy(&at_halfedges, &apexes[even_halfedge(Edge_index(group * edges_per_group))], sizeof(at_halfedges));
    constexpr std::uint64_t lowest_bits = 0x0001000100010001; // of one halfedge of each edge
    const std::uint64_t at_opposite = at_halfedges >> 8, difference = at_halfedges ^ at_opposite,
                        are_extreme = (at_halfedges ^ at_halfedges >> 1) & ~(difference | difference >> 1),
                        have_triangles = (at_halfedges & at_opposite) >> 2;
    return ((are_extreme | ~have_triangles) & lowest_bits) != 0;
  }

  template <class Complex>
  static void add_excluded_ends(const Complex& complex,
                                const Vertex_order& order,
                                Halfedge_index even,
                                const Apexes& apexes,
                                Plain_vector<Vertex_index>& excluded)
  {
    const Vertex_index ends[] = {complex.source(even), complex.target(even)};
    const unsigned apex = apexes[even], opposite_apex = apexes[opposite_of(even)];
    const bool has_triangles = apex != 0 && opposite_apex != 0,
               are_extreme = apex == opposite_apex && apex != Triangle_addends::is_there;
    for(const std::size_t i : {0, 1})
      if(!has_triangles || (are_extreme && order(ends[i], ends[1 - i]) == ((apex & Triangle_addends::is_highest) != 0)))
        excluded.push_back(ends[i]);
  }

  std::vector<Counts> counts_; // of the parts, the first one then of all
};

// The regular vertices if to find them is the way.
template <class Complex>
Regular_vertices find_regular_vertices(const Threads& threads,
                                       const Complex& complex,
                                       const Vertex_order& order,
                                       Way_of_turning way)
{
  if(way == Way_of_turning::BEHIND_SWEEP)
    return {threads, complex, order};
  return {};
}

} // namespace CGAL::Reeb_graph::internal

#endif // CGAL_REEB_GRAPH_INTERNAL_COMPLEX_REGULAR_VERTICES_H
