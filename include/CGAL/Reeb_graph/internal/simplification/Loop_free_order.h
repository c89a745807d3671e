// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_INTERNAL_SIMPLIFICATION_LOOP_FREE_ORDER_H
#define CGAL_REEB_GRAPH_INTERNAL_SIMPLIFICATION_LOOP_FREE_ORDER_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/internal/base/Index.h>
#include <CGAL/Reeb_graph/internal/base/Indexed_vector.h>
#include <CGAL/Reeb_graph/internal/simplification/Piece_sweep.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <random>
#include <set>
#include <unordered_set>
#include <utility>
#include <vector>

namespace CGAL {
namespace Reeb_graph {
namespace internal {

// The search looks at so many states before it begins anew: all sets of this many members.
inline constexpr int members_of_exhaustive_search = 16;

// The search for an order in which the members of a sweep pass without a leaf or a loop in the Reeb graph. It goes from
// step to step, and back where there is none. Regular vertices come first: they change neither contours nor what is
// below or above. So a hole of the surface at which a contour has been opened is passed before the next one is, if that
// can be. What is possible next depends only on which members have passed, and no such state is looked at twice. So few
// members are searched exhaustively; with many, the search begins anew in another order a few times.
template <class Sweep>
class Loop_free_order
{
  typedef typename Sweep::Step Step;

public:
  explicit Loop_free_order(Sweep& sweep) : sweep_(sweep), ranks_(sweep.members().size()), places_(ranks_.size()) {}

  // Finds the order, and leaves the sweep at its end; returns whether it has been found. The order of the members is
  // tried first.
  bool find()
  {
    for(const Member_index m : ranks_.keys())
      places_[m.number()] = m;
    if(follow_members())
      return true;
    std::mt19937 random;
    std::size_t number_of_states = std::size_t(1) << members_of_exhaustive_search;
    for(int attempt = 0; attempt != number_of_attempts; ++attempt)
    {
      const Outcome outcome = search(number_of_states);
      if(outcome != Outcome::GIVEN_UP)
        return outcome == Outcome::FOUND;
      number_of_states = 1000 + 4 * places_.size();
      for(std::size_t i = places_.size(); i > 1; --i)
        std::swap(places_[i - 1], places_[random() % i]);
    }
    return false;
  }

private:
  static constexpr int number_of_attempts = 16;

  enum class Outcome
  {
    FOUND,
    NONE,
    GIVEN_UP
  };

  bool is_finished() const { return sweep_.swept().size() == ranks_.size(); }

  bool follow_members()
  {
    for(const Member_index m : ranks_.keys())
    {
      if(sweep_.step(m) == Step::IMPOSSIBLE)
        break;
      sweep_.add(m);
    }
    if(is_finished())
      return true;
    go_back();
    return false;
  }

  void go_back()
  {
    while(!sweep_.swept().empty())
      sweep_.remove_last();
  }

  // The steps that are left to try from a state, the next one last.
  struct State
  {
    std::vector<Member_index> steps;
    Member_index first = no_index; // the regular vertex that is tried before the other steps are looked for
    bool is_complete = false;
  };

  Outcome search(std::size_t number_of_states)
  {
    failed_states_.clear();
    front_.clear();
    for(std::size_t i = 0; i != places_.size(); ++i)
      ranks_[places_[i]] = i;
    for(const Member_index m : places_)
      update_front(m);
    std::vector<State> states(1);
    for(begin_state(states.back()); !states.empty() && !is_finished();)
    {
      State& state = states.back();
      if(state.steps.empty() && !state.is_complete)
        complete(state);
      if(state.steps.empty())
      {
        remember_failure();
        states.pop_back();
        if(!states.empty())
          step_back();
        continue;
      }
      const Member_index m = state.steps.back();
      state.steps.pop_back();
      const bool is_regular = m == state.first;
      step_to(m);
      if(is_failure() || (!is_regular && sweep_.has_pocket()))
        step_back();
      else if(number_of_states-- == 0)
        break;
      else
      {
        states.emplace_back();
        begin_state(states.back());
      }
    }
    if(is_finished())
      return Outcome::FOUND;
    go_back();
    return states.empty() ? Outcome::NONE : Outcome::GIVEN_UP;
  }

  // A regular vertex will do in most cases.
  void begin_state(State& state)
  {
    for(const auto& [rank, m] : front_)
    {
      if(sweep_.step(m) == Step::REGULAR)
      {
        state.first = m;
        state.steps.push_back(m);
        return;
      }
    }
  }

  void complete(State& state)
  {
    state.is_complete = true;
    std::vector<std::pair<Step, Member_index>> steps;
    for(const auto& [rank, m] : front_)
    {
      const Step step = m == state.first ? Step::IMPOSSIBLE : sweep_.step(m);
      if(step != Step::IMPOSSIBLE)
        steps.emplace_back(step, m);
    }
    std::stable_sort(steps.begin(), steps.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
    for(auto it = steps.rbegin(); it != steps.rend(); ++it)
      state.steps.push_back(it->second);
  }

  void step_to(Member_index m)
  {
    sweep_.add(m);
    update_front(m);
    sweep_.for_each_neighbor(m, [&](Member_index n) { update_front(n); });
  }

  void step_back()
  {
    const Member_index m = sweep_.swept().back();
    sweep_.remove_last();
    update_front(m);
    sweep_.for_each_neighbor(m, [&](Member_index n) { update_front(n); });
  }

  void update_front(Member_index m)
  {
    if(!sweep_.is_swept(m) && sweep_.has_lower_neighbor(m))
      front_.emplace(ranks_[m], m);
    else
      front_.erase({ranks_[m], m});
  }

  typedef std::uint64_t State_number; // the set of the members that have passed

  // Larger sets have no number.
  bool is_remembered() const { return ranks_.size() <= std::numeric_limits<State_number>::digits; }

  State_number state_number() const
  {
    State_number number = 0;
    for(const Member_index m : sweep_.swept())
      number |= State_number(1) << m.number();
    return number;
  }

  void remember_failure()
  {
    if(is_remembered())
      failed_states_.insert(state_number());
  }

  bool is_failure() const { return is_remembered() && failed_states_.count(state_number()) != 0; }

  Sweep& sweep_;
  Indexed_vector<Member_index, std::size_t> ranks_;      // the order in which steps of one kind are tried
  std::vector<Member_index> places_;                     // the members in this order
  std::set<std::pair<std::size_t, Member_index>> front_; // the members next to those that have passed, by rank
  std::unordered_set<State_number> failed_states_;
};

} // namespace internal
} // namespace Reeb_graph
} // namespace CGAL

#endif // CGAL_REEB_GRAPH_INTERNAL_SIMPLIFICATION_LOOP_FREE_ORDER_H
