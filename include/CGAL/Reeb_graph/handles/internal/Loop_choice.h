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
#include <CGAL/Reeb_graph/internal/base/Threads.h>
#include <CGAL/Reeb_graph/internal/space/Self_intersections.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <functional>
#include <limits>
#include <memory>
#include <optional>
#include <random>
#include <set>
#include <tuple>
#include <unordered_map>
#include <unordered_set>
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
  Loop_choice(const Closed_surface& surface, const Component_loops& loops, const Loop_halves& halves)
    : surface_(surface),
      loops_(loops),
      halves_(halves),
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
    std::stable_sort(candidates_.begin(), candidates_.end(),
                     [](const Candidate& a, const Candidate& b) { return a.length < b.length; });
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
    searchers(1, progress.part(0.8, 1),
              [&](std::size_t, auto& searcher, const auto& report) { shorten_in_classes(searcher, bound, report); });
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
      bool is_any_odd = false;
      found[k] = find_loop_across(searcher, half, k / 2, bound, is_any_odd, report);
      if(!is_any_odd)
        searched[k] = {partner, found[k].empty() ? given : found[k]};
    });
    for(auto& pair : searched)
      if(pair)
        searched_.insert(std::move(*pair));
    return add_candidates(found);
  }

  // Tells whether there is a loop that crosses the partner an odd number of times greater than one. A shortest loop among
  // those that cross it an odd number of times is closed by an edge with the tree. If it crosses it 3 times, one that
  // crosses it once can be missed.
  template <class Report>
  Halfedge_walk find_loop_across(Loop_searchers::Searcher& searcher,
                                 int half,
                                 std::size_t place,
                                 double bound,
                                 bool& is_any_odd,
                                 const Report& report) const
  {
    const auto accept = [&](const Halfedge_walk& walk) {
      const Integer number = abs(dot_product(coordinates(half, walk), bases_.vector(1 - half, place)));
      is_any_odd = is_any_odd || (number != 1 && number % 2 != 0);
      return number == 1;
    };
    const Halfedge_walk& given = walks_[half][place];
    const double length = given.empty() ? bound : (std::min)(bound, surface_.length(given));
    return shortest_across(searcher.crossing_bounds, walk(1 - half, place), length, report, 1,
                           [&](Index root, double its_bound) {
                             return searcher.search(root, 1 - half, its_bound, largest_search(), accept);
                           });
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
  Dual_bases bases_;
  std::vector<Candidate> candidates_;
  std::set<Pair_of_loops> searched_;                // loops behind the partners across which there are no shorter ones
  std::array<std::vector<Halfedge_walk>, 2> walks_; // by half and place; empty if none has been chosen
};

// Finds dual loops of all components, by component. Those whose linking numbers are not those of a surface with two
// sides, or that have a border, get the loops of their tree.
class All_loops
{
public:
  explicit All_loops(Handle_homology& homology) : homology_(homology), surface_(homology.surface()) {}

  // Loops are shortened as far as that makes them shorter than `bound`, and than the `number`-th size of a pair.
  std::vector<std::vector<Pair_of_loops>> operator()(double bound,
                                                     std::size_t number,
                                                     const Threads& threads,
                                                     const Stage_progress& progress)
  {
    Class_codes codes(surface_.next.size() / 2, {0, 0});
    for(auto& component : homology_.components())
    {
      if(!component.projection.empty())
        halves_.emplace_back(component, component.projection);
      if(component.projection.empty() || !halves_.back().is_valid())
      {
        if(!component.projection.empty())
          halves_.pop_back();
        component.projection.clear();
        halves_.emplace_back(component, splitting(surface_, component));
      }
      std::vector<std::uint64_t> random(component.size());
      std::generate(random.begin(), random.end(), std::mt19937_64());
      for(std::size_t k = 0; k != component.size(); ++k)
        codes[component.component().left_over[k] / 2] = halves_.back().code(k, random);
    }
    complete_codes(surface_, homology_.trees(), codes);
    for(std::size_t i = 0; i != halves_.size(); ++i)
      choices_.emplace_back(surface_, homology_.components()[i], halves_[i]);
    add_loops_of_tree(codes);
    std::vector<double> sizes;
    for(auto& choice : choices_)
    {
      choice.choose();
      const std::vector<double> its_sizes = choice.sizes();
      sizes.insert(sizes.end(), its_sizes.begin(), its_sizes.end());
    }
    if(0 < number && number < sizes.size())
    {
      std::nth_element(sizes.begin(), sizes.begin() + static_cast<std::ptrdiff_t>(number - 1), sizes.end());
      bound = (std::min)(bound, std::nextafter(sizes[number - 1], std::numeric_limits<double>::infinity()));
    }
    if(bound > 0)
    {
      Loop_searchers searchers(surface_, codes, threads);
      const double number_of_choices = static_cast<double>(choices_.size());
      for(std::size_t i = 0; i != choices_.size(); ++i)
        choices_[i].shorten(
          searchers, bound,
          progress.part(static_cast<double>(i) / number_of_choices, static_cast<double>(i + 1) / number_of_choices));
    }
    std::vector<std::vector<Pair_of_loops>> result;
    for(auto& choice : choices_)
      result.push_back(choice.take_pairs());
    return result;
  }

private:
  // The shortest loop of each class among those that an edge closes with the tree.
  void add_loops_of_tree(const Class_codes& codes)
  {
    typedef std::unordered_map<std::uint64_t, std::pair<double, Index>> Shortest;
    std::vector<std::array<Shortest, 2>> shortest(choices_.size());
    const auto& trees = homology_.trees();
    for(Index h = 0; h != surface_.number_of_given_halfedges; h += 2)
    {
      const auto& code = codes[h / 2];
      if((code[0] == 0) == (code[1] == 0))
        continue;
      const int half = code[0] == 0 ? 1 : 0;
      const Index u = surface_.source(h), v = surface_.target[h];
      const double length = trees.distance(u) + surface_.length(h) + trees.distance(v);
      const std::uint64_t key = (std::min)(code[half], std::uint64_t(0) - code[half]);
      const std::size_t place = homology_.place_of(u);
      const auto found = shortest[place][half].emplace(key, std::make_pair(length, h)).first;
      if(length < found->second.first)
        found->second = {length, h};
    }
    for(std::size_t place = 0; place != choices_.size(); ++place)
      for(int half : {0, 1})
      {
        std::vector<std::pair<double, Index>> loops;
        for(const auto& entry : shortest[place][half])
          loops.push_back(entry.second);
        std::sort(loops.begin(), loops.end());
        for(const auto& loop : loops)
          choices_[place].add_candidate(half, trees.walk_through(loop.second));
      }
  }

  Handle_homology& homology_;
  const Closed_surface& surface_;
  std::deque<Loop_halves> halves_;
  std::deque<Loop_choice> choices_;
};

// Finds the loops, and keeps what answers questions about them.
class Found_loops : public Loop_finder
{
public:
  Found_loops(Closed_surface surface, const Stage_progress& progress) : homology_(std::move(surface), progress) {}

  const Closed_surface& surface() const override { return homology_.surface(); }
  std::size_t number_of_components() const override { return homology_.trees().components().size(); }
  Index component_of(Index v) const override { return homology_.trees().component_of(v); }

  std::vector<std::size_t> self_intersections(bool are_counted) const override
  {
    const Tree_and_cotree& trees = homology_.trees();
    return Self_intersections(surface(), trees.closed_components_with_handles(), number_of_components(),
                              are_counted)(No_progress());
  }

  void refuse_self_intersections(const std::vector<std::size_t>& self_intersections) override
  {
    for(auto& component : homology_.components())
      component.is_refused = self_intersections[component.number] != 0;
  }

  std::vector<Surface_loop> make_loops(double bound,
                                       std::size_t number,
                                       const std::function<void()>& find_crossed,
                                       const Threads& threads,
                                       const Stage_progress& progress) override
  {
    std::vector<Surface_loop> result;
    std::vector<std::vector<Pair_of_loops>> pairs;
    threads.for_each_index(2, [&](std::size_t task) {
      if(task == 0)
        find_crossed();
      else
        pairs = All_loops(homology_)(bound, number, threads, progress);
    });
    for(std::size_t place = 0; place != pairs.size(); ++place)
      add_pairs(homology_.components()[place], pairs[place], result);
    for(const Halfedge_walk& cycle : homology_.surface().border_cycles)
      result.push_back(make_loop(Loop_kind::HOLE, cycle));
    return result;
  }

  bool is_bounding(const Halfedge_walk& walk, bool is_inside) const override
  {
    const auto* component = homology_component_of(walk);
    if(!component || !component->has_inside())
      return false;
    const Class loop = component->coordinates(walk);
    if(std::all_of(loop.begin(), loop.end(), [](const Integer& number) { return number == 0; }))
      return false;
    const Class front = combination(loop, component->projection);
    const bool is_behind = is_inside == component->is_front_outside;
    return is_behind ? std::all_of(front.begin(), front.end(), [](const Integer& number) { return number == 0; })
                     : front == loop;
  }

  long long intersection_number(const Halfedge_walk& a, const Halfedge_walk& b) const override
  {
    const auto* component = homology_component_of(a);
    if(!component || component != homology_component_of(b))
      return 0;
    return crossing(*component, component->coordinates(a), component->coordinates(b));
  }

  // In front, it is the intersection number of b with the part of a that bounds in front.
  long long linking_number(const Halfedge_walk& a, const Halfedge_walk& b) const override
  {
    const auto* component = homology_component_of(a);
    if(!component || component != homology_component_of(b) || !component->has_inside())
      return 0;
    const Class loop = component->coordinates(a), other = component->coordinates(b);
    const long long in_front = crossing(*component, other, combination(loop, component->projection));
    return component->is_front_outside ? in_front : in_front + crossing(*component, loop, other);
  }

private:
  typedef Handle_homology::Component Component;
  typedef std::vector<Integer> Class;

  void add_pairs(const Component& component, const std::vector<Pair_of_loops>& pairs, std::vector<Surface_loop>& loops)
  {
    const bool has_inside = component.has_inside();
    std::vector<std::array<Surface_loop, 2>> made;
    for(const Pair_of_loops& pair : pairs)
    {
      const std::size_t inside = has_inside && !component.is_front_outside ? 1 : 0;
      made.push_back({make_loop(has_inside ? Loop_kind::HANDLE : Loop_kind::LOOP, pair[inside]),
                      make_loop(has_inside ? Loop_kind::TUNNEL : Loop_kind::LOOP, pair[1 - inside])});
    }
    const auto size = [](const std::array<Surface_loop, 2>& pair) {
      return std::make_pair((std::min)(pair[0].length, pair[1].length), pair[0].length + pair[1].length);
    };
    std::stable_sort(made.begin(), made.end(), [&](const auto& a, const auto& b) { return size(a) < size(b); });
    for(auto& pair : made)
      for(std::size_t k : {0, 1})
      {
        pair[k].partner = k == 0 ? loops.size() + 1 : loops.size() - 1;
        loops.push_back(std::move(pair[k]));
      }
  }

  Surface_loop make_loop(Loop_kind kind, const Halfedge_walk& walk) const
  {
    const Closed_surface& surface = homology_.surface();
    Surface_loop loop = {kind, walk};
    loop.length = surface.length(walk);
    loop.component = component_of(surface.target[walk.front()]);
    std::unordered_set<Index> passed;
    for(const Index h : walk)
      loop.is_simple = passed.insert(surface.target[h]).second && loop.is_simple;
    return loop;
  }

  const Component* homology_component_of(const Halfedge_walk& walk) const
  {
    return walk.empty() ? nullptr : homology_.component_of(homology_.surface().target[walk.front()]);
  }

  static long long crossing(const Component& component, const Class& a, const Class& b)
  {
    return to_machine_integer(dot_product(combination(a, component.intersection_numbers()[0]), b));
  }

  Handle_homology homology_;
};

template <class Surface>
std::unique_ptr<Loop_finder> make_loop_finder(Surface surface, const Stage_progress& progress)
{
  return std::make_unique<Found_loops>(std::move(surface), progress);
}

} // namespace CGAL::Reeb_graph::internal

#endif // CGAL_REEB_GRAPH_HANDLES_INTERNAL_LOOP_CHOICE_H
