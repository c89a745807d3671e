// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_HANDLES_INTERNAL_LOOP_CHOICE_H
#define CGAL_REEB_GRAPH_HANDLES_INTERNAL_LOOP_CHOICE_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/handles/internal/Closed_surface.h>
#include <CGAL/Reeb_graph/handles/internal/Handle_homology.h>
#include <CGAL/Reeb_graph/handles/internal/Loop_halves.h>
#include <CGAL/Reeb_graph/handles/internal/Loop_search.h>
#include <CGAL/Reeb_graph/internal/base/Index.h>
#include <CGAL/Reeb_graph/internal/base/Progress.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <set>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL::Reeb_graph::internal {

// A loop of each half whose intersection number is 1.
typedef std::array<Halfedge_walk, 2> Pair_of_loops;

// Chooses loops of a component that are dual bases of both halves: greedily by length among candidates, which are
// loops that edges close with trees of shortest paths.
class Loop_choice
{
  struct Candidate
  {
    double length;
    int half;
    Halfedge_walk walk;
    std::vector<Integer> coordinates;
  };

public:
  // Of a component without inside, the halves are any two: its loops need cross their partners only.
  Loop_choice(const Closed_surface& surface, const Component_loops& loops, const Loop_halves& halves, bool has_inside)
    : surface_(surface),
      loops_(loops),
      halves_(halves),
      has_inside_(has_inside),
      bases_(halves.size())
  {}

  void add_candidate(int half, Halfedge_walk walk)
  {
    reduce(walk);
    const double length = surface_.length(walk);
    std::vector<Integer> its_coordinates = coordinates(half, walk);
    candidates_.push_back({length, half, std::move(walk), std::move(its_coordinates)});
  }

  void choose()
  {
    sort_candidates();
    bases_ = Dual_bases(halves_.size());
    for(auto& walks : walks_)
      walks.assign(halves_.size(), Halfedge_walk());
    for(const Candidate& candidate : candidates_)
    {
      const auto choice = bases_.choose(candidate.half, candidate.coordinates);
      if(choice)
        walks_[candidate.half][choice->place] = choice->sign > 0 ? candidate.walk : reversed(candidate.walk);
    }
  }

  // The lengths of the shorter loops of all pairs.
  std::vector<double> sizes() const
  {
    std::vector<double> result;
    for(std::size_t i = 0; i != halves_.size(); ++i)
      result.push_back((std::min)(surface_.length(walk(0, i)), surface_.length(walk(1, i))));
    return result;
  }

  // Adds loops that are shorter as candidates, and chooses again. Loops that are not shorter than `size` need not be found:
  // the bound is so much larger that no shorter one is missed for what is not worth a search.
  void shorten(Loop_searchers& searchers, double size, const Stage_progress& progress)
  {
    const double bound = size / precision;
    add_loops_at_left_over_edges(searchers, bound, progress.part(0, 0.3));
    choose();
    for(int pass = 0;
        pass != 2 && add_loops_across(searchers, bound, progress.part(0.2 * pass + 0.3, 0.2 * pass + 0.5)); ++pass)
      choose();
    find_in_classes(searchers, bound, progress.part(0.7, 0.8));
    searchers(1, progress.part(0.8, 1), [&](std::size_t, auto& searcher, const auto& report) {
      if(!has_inside_)
        shorten_across(searcher.crossing_bounds, bound, report);
      shorten_in_classes(searcher, bound, report);
    });
  }

  std::vector<Pair_of_loops> take_pairs()
  {
    std::vector<Pair_of_loops> result;
    for(std::size_t i = 0; i != halves_.size(); ++i)
      result.push_back({walk(0, i), walk(1, i)});
    return result;
  }

private:
  std::vector<Integer> coordinates(int half, const Halfedge_walk& walk) const
  {
    return halves_.coordinates(half, loops_.coordinates(walk));
  }

  // By length. Of those about as long as each other, those come first of whose half there are fewer: a plate has more bars between
  // and beside holes than holes, and the bars to take are those that belong to a hole each.
  void sort_candidates()
  {
    std::stable_sort(candidates_.begin(), candidates_.end(),
                     [](const Candidate& a, const Candidate& b) { return a.length < b.length; });
    const auto end = candidates_.end();
    for(auto first = candidates_.begin(), beyond = first; first != end; first = beyond)
    {
      beyond = std::find_if(first, end, [&](const Candidate& c) { return precision * c.length > first->length; });
      const auto is_of_half_1 = [](const Candidate& c) { return c.half == 1; };
      const bool is_half_1_rarer = 2 * std::count_if(first, beyond, is_of_half_1) < beyond - first;
      std::stable_partition(first, beyond, [&](const Candidate& c) { return is_of_half_1(c) == is_half_1_rarer; });
    }
  }

  // The walk that has been chosen, or one that passes the loops b as often as the class asks for.
  Halfedge_walk walk(int half, std::size_t place) const
  {
    if(!walks_[half][place].empty())
      return walks_[half][place];
    Halfedge_walk sum;
    const auto loop = halves_.loop(half, bases_.vector(half, place));
    for(std::size_t k = 0; k != loop.size(); ++k)
    {
      long long times = to_machine_integer(loop[k]);
      const Halfedge_walk part = times < 0 ? reversed(loops_.walk(k)) : loops_.walk(k);
      for(times = std::abs(times); times != 0; --times)
        sum.insert(sum.end(), part.begin(), part.end());
    }
    reduce(sum);
    return sum;
  }

  // Where a handle is in the way of the tree, an edge is left over near by.
  void add_loops_at_left_over_edges(Loop_searchers& searchers, double bound, const Stage_progress& progress)
  {
    std::set<Index> sources;
    for(const Index h : loops_.component().left_over)
      sources.insert(surface_.source(h));
    const std::vector<Index> roots(sources.begin(), sources.end());
    std::vector<Halfedge_walk> found(2 * roots.size());
    searchers(found.size(), progress, [&](std::size_t k, auto& searcher, const auto&) {
      const int closed_half = k % 2 == 0 ? 1 : 0;
      found[k] =
        searcher.search(roots[k / 2], closed_half, bound, largest_search(), [](const Halfedge_walk&) { return true; })
          .walk;
    });
    add_candidates(found);
  }

  // Walks of half 0 and half 1 in turns, of which some may be empty. Returns whether there is one.
  bool add_candidates(std::vector<Halfedge_walk>& walks)
  {
    bool is_any_found = false;
    for(std::size_t k = 0; k != walks.size(); ++k)
    {
      if(walks[k].empty())
        continue;
      add_candidate(k % 2 == 0 ? 0 : 1, std::move(walks[k]));
      is_any_found = true;
    }
    return is_any_found;
  }

  // So many places of the cover may be seen in one search, so that all searches together take a time that is linear.
  std::size_t largest_search() const { return 4000 + 8 * loops_.number_of_vertices / halves_.size(); }

  bool is_short(int half, std::size_t place) const
  {
    return !walks_[half][place].empty() && searched_.count({walk(1 - half, place), walks_[half][place]}) != 0;
  }

  // Adds loops that cross the partner of a loop once, as that one does, and are shorter. Returns whether one is found.
  bool add_loops_across(Loop_searchers& searchers, double bound, const Stage_progress& progress)
  {
    std::vector<Halfedge_walk> found(2 * halves_.size());
    std::vector<std::optional<Pair_of_loops>> searched(found.size());
    searchers(found.size(), progress, [&](std::size_t k, auto& searcher, const auto& report) {
      const int half = k % 2 == 0 ? 0 : 1;
      const Halfedge_walk partner = walk(1 - half, k / 2), &given = walks_[half][k / 2];
      if(searched_.count({partner, given}) != 0)
        return;
      bool is_any_missed = false;
      found[k] = find_loop_across(searcher, half, k / 2, bound, is_any_missed, report);
      if(!is_any_missed)
        searched[k] = {partner, found[k].empty() ? given : found[k]};
    });
    for(auto& pair : searched)
      if(pair)
        searched_.insert(std::move(*pair));
    return add_candidates(found);
  }

  // Tells whether a shorter one can be missed. A shortest loop among those that cross the partner an odd number of times is closed
  // by an edge with the tree. If it crosses it 3 times, one that crosses it once can be missed, and so can one if the search has
  // stopped, where one that is closed along the partner is shorter.
  template <class Report>
  Halfedge_walk find_loop_across(Loop_searchers::Searcher& searcher,
                                 int half,
                                 std::size_t place,
                                 double bound,
                                 bool& is_any_missed,
                                 const Report& report) const
  {
    const auto accept = [&](const Halfedge_walk& walk) {
      const Integer number = abs(dot_product(coordinates(half, walk), bases_.vector(1 - half, place)));
      is_any_missed = is_any_missed || (number != 1 && number % 2 != 0);
      return number == 1;
    };
    const Halfedge_walk& given = walks_[half][place];
    const double length = given.empty() ? bound : (std::min)(bound, surface_.length(given));
    const Halfedge_walk partner = walk(1 - half, place);
    Halfedge_walk found =
      shortest_across(searcher.crossing_bounds, partner, length, report, 1, [&](Index root, double its_bound) {
        return searcher.search(root, 1 - half, its_bound, largest_search(), accept);
      });
    Halfedge_walk closed = closed_along(partner, searcher.crossing_bounds.shortest_part(), half, place,
                                        precision * (found.empty() ? length : surface_.length(found)), true);
    if(closed.empty())
      return found;
    is_any_missed = true;
    return closed;
  }

  // A part that leaves a partner and comes back on its other side, closed along the partner: the shorter way, or as often around
  // as lets the loop have no part in its half. What searches for such a loop winds around a thin ring as often as this is longer
  // than thick, and stops. Empty if the loop has another part in that half, or is not shorter than `bound`.
  Halfedge_walk closed_along(const Halfedge_walk& partner,
                             Halfedge_walk part,
                             int half,
                             std::size_t place,
                             double bound,
                             bool is_of_half) const
  {
    if(part.empty())
      return part;
    Halfedge_walk around = partner; // from where the part comes back
    const auto begin = std::find_if(around.begin(), around.end(),
                                    [&](Index h) { return surface_.source(h) == surface_.target[part.back()]; });
    std::rotate(around.begin(), begin, around.end());
    const std::size_t size = part.size();
    for(std::size_t i = 0; surface_.target[part.back()] != surface_.source(part.front()); ++i)
      part.push_back(around[i]);
    const std::vector<Integer> windings = coordinates(1 - half, part), &once = bases_.vector(1 - half, place);
    const auto pivot = std::find_if(once.begin(), once.end(), [](const Integer& number) { return number != 0; });
    Integer times = windings[static_cast<std::size_t>(pivot - once.begin())] / *pivot;
    for(std::size_t k = 0; k != once.size(); ++k)
      if(windings[k] != times * once[k])
        return {};
    if(!is_of_half)
      times =
        2 * surface_.length({part.begin() + static_cast<std::ptrdiff_t>(size), part.end()}) > surface_.length(partner);
    const auto number = static_cast<double>(abs(times));
    if(!(number < 1e4 && number * surface_.length(partner) < bound))
      return {};
    if(times > 0)
      around = reversed(around);
    for(int k = 0; k < number; ++k)
      part.insert(part.begin() + static_cast<std::ptrdiff_t>(size), around.begin(), around.end());
    reduce(part);
    return surface_.length(part) < bound ? part : Halfedge_walk();
  }

  // Finds loops for the classes of which none has been chosen.
  void find_in_classes(Loop_searchers& searchers, double bound, const Stage_progress& progress)
  {
    searchers(halves_.size(), progress, [&](std::size_t place, auto& searcher, const auto& report) {
      for(int half : {0, 1})
      {
        if(!walks_[half][place].empty())
          continue;
        const auto accept = [&](const Halfedge_walk& walk) { return is_in_class(half, place, walk); };
        set_walk(half, place,
                 shortest_across(searcher.crossing_bounds, walk(1 - half, place), bound, report, 1,
                                 [&](Index root, double its_bound) {
                                   return searcher.search(root, 1 - half, its_bound, largest_search(), accept);
                                 }));
      }
    });
  }

  // Searches in the classes that are chosen for what the passes can have missed: the shortest loop across a partner may
  // have had no room in any choice. The shortest loops come first, as the searches together may see only some times the
  // surface, so that they take little time, and some more of small surfaces.
  template <class Report>
  void shorten_in_classes(Loop_searchers::Searcher& searcher, double bound, const Report& report)
  {
    std::vector<std::tuple<double, int, std::size_t>> loops;
    for(int half : {0, 1})
      for(std::size_t i = 0; i != halves_.size(); ++i)
        if(!is_short(half, i))
          loops.emplace_back(surface_.length(walk(half, i)), half, i);
    std::sort(loops.begin(), loops.end());
    std::size_t left = 4 * loops_.number_of_vertices + 100000; // places that may be seen
    for(const auto& [length, half, place] : loops)
    {
      const std::uint64_t code = searcher.search.code(walk(half, place));
      const auto search_from = [&](Index root, double its_bound) {
        auto loop = searcher.search.of_class(root, code, its_bound, (std::min)(largest_search(), left));
        left -= (std::min)(left, loop.number_of_places);
        return loop;
      };
      if(left != 0)
        set_walk(half, place,
                 shortest_across(searcher.crossing_bounds, walk(1 - half, place), (std::min)(bound, length), report,
                                 1.5, search_from));
    }
  }

  // Makes loops shorter by what winds around their partners: they cross these, and no others, as before.
  template <class Report>
  void shorten_across(Crossing_bounds& crossing_bounds, double bound, const Report& report)
  {
    for(int half : {0, 1, 0}) // No part is found across one that meets itself.
      for(std::size_t place = 0; place != halves_.size(); ++place)
      {
        report();
        const Halfedge_walk partner = walk(1 - half, place);
        const double length = (std::min)(bound, surface_.length(walk(half, place)));
        crossing_bounds(partner, length);
        set_walk(half, place,
                 closed_along(partner, crossing_bounds.shortest_part(), half, place, precision * length, false));
      }
  }

  bool is_in_class(int half, std::size_t place, const Halfedge_walk& walk) const
  {
    const auto found = coordinates(half, walk), sought = bases_.vector(half, place);
    return found == sought || coordinates(half, reversed(walk)) == sought;
  }

  void set_walk(int half, std::size_t place, const Halfedge_walk& found)
  {
    if(!found.empty())
      walks_[half][place] = coordinates(half, found) == bases_.vector(half, place) ? found : reversed(found);
  }

  static constexpr double precision = 0.96; // of lengths for which another search is worth it

  // The shortest loop that searches find from vertices of a loop that it crosses, to within this; empty if none is
  // shorter than `bound`. From one vertex to the next, the length of the shortest loop through it changes by at most
  // twice the way between, and what crosses the partner at a vertex is not shorter than the way from it to its other
  // side. So few have to be tried, the fewer the farther a search sees.
  template <class Report, class SearchFrom>
  Halfedge_walk shortest_across(Crossing_bounds& crossing_bounds,
                                const Halfedge_walk& partner,
                                double bound,
                                const Report& report,
                                double reach,
                                const SearchFrom& search_from) const
  {
    Loop_search::Loop best = {bound, {}};
    std::vector<double> least_lengths = crossing_bounds(partner, best.length);
    std::vector<std::size_t> order = coarse_to_fine(partner.size());
    const auto least = std::min_element(least_lengths.begin(), least_lengths.end()) - least_lengths.begin();
    order.insert(order.begin(), static_cast<std::size_t>(least));
    int number_of_failures = 0;
    for(const std::size_t k : order)
    {
      if(least_lengths[k] >= precision * best.length)
        continue;
      report(); // so that it can be cancelled
      auto loop = search_from(surface_.source(partner[k]), reach * best.length);
      if(!loop.is_shortest && ++number_of_failures == 2)
        break;
      raise_near(partner, k, loop.length, least_lengths);
      if(!loop.walk.empty() && loop.length < best.length)
        best = std::move(loop);
    }
    return best.walk;
  }

  // Raises least lengths near a vertex where that is `length`: they fall by at most twice the way from there.
  void raise_near(const Halfedge_walk& walk, std::size_t k, double length, std::vector<double>& least_lengths) const
  {
    for(const std::size_t step : {std::size_t(1), walk.size() - 1})
    {
      double way = 0;
      std::size_t i = k;
      for(std::size_t n = 0; n != walk.size() && 2 * way < length; ++n)
      {
        least_lengths[i] = (std::max)(least_lengths[i], length - 2 * way);
        const std::size_t next = (i + step) % walk.size();
        way += surface_.length(walk[step == 1 ? i : next]);
        i = next;
      }
    }
  }

  static std::vector<std::size_t> coarse_to_fine(std::size_t size)
  {
    std::vector<std::size_t> result(size == 0 ? 0 : 1, 0);
    std::size_t stride = 1;
    while(stride < size)
      stride *= 2;
    for(stride /= 2; stride != 0; stride /= 2)
      for(std::size_t k = stride; k < size; k += 2 * stride)
        result.push_back(k);
    return result;
  }

  const Closed_surface& surface_;
  const Component_loops& loops_;
  const Loop_halves& halves_;
  const bool has_inside_;
  Dual_bases bases_;
  std::vector<Candidate> candidates_;
  std::set<Pair_of_loops> searched_;                // loops behind the partners across which there are no shorter ones
  std::array<std::vector<Halfedge_walk>, 2> walks_; // by half and place; empty if none has been chosen
};

} // namespace CGAL::Reeb_graph::internal

#endif // CGAL_REEB_GRAPH_HANDLES_INTERNAL_LOOP_CHOICE_H
