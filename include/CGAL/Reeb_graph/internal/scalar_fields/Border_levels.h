// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_INTERNAL_SCALAR_FIELDS_BORDER_LEVELS_H
#define CGAL_REEB_GRAPH_INTERNAL_SCALAR_FIELDS_BORDER_LEVELS_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/internal/scalar_fields/Field_border.h>
#include <CGAL/Reeb_graph/internal/scalar_fields/Weighted_graph.h>
#include <CGAL/Reeb_graph/options.h>

#include <algorithm>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Reeb_graph {
namespace internal {
namespace scalar_fields {

// Chooses a level for each border component, so that it is an extremum of the field.
//
// Borders that share an edge become extrema of opposite kinds where that can be. Where it cannot, as for three borders
// each of which touches the other two, those of one kind that touch each other, a group, share one level.
template <class Scalar, class Traits>
class Border_levels
{
  typedef Field_border<Scalar> Border;
  typedef std::optional<Border_extremum> Kind; // MINIMUM or MAXIMUM, nothing before it is chosen
  typedef Level_arithmetic<Scalar, Traits> Arithmetic;

public:
  Border_levels(const Weighted_graph& graph,
                const std::vector<Scalar>& values,
                const std::vector<std::vector<Position>>& borders,
                const Traits& traits)
    : arithmetic_(traits),
      borders_(find_field_borders(graph, values, borders, traits.less_scalar_object())),
      kinds_(borders.size()),
      groups_of_borders_(borders.size(), no_position)
  {}

  // The levels of the borders. Those that are extremal levels already keep theirs, unless they touch others that leave
  // them no choice.
  std::vector<Scalar> operator()(Border_extremum wish)
  {
    choose_kinds(wish);
    for(Position b = 0; b != borders_.size(); ++b)
    {
      if(groups_of_borders_[b] == no_position)
        add_group(b);
    }
    part_groups();
    std::vector<Scalar> levels;
    for(Position b = 0; b != borders_.size(); ++b)
      levels.push_back(groups_[groups_of_borders_[b]].level);
    return levels;
  }

private:
  // Borders of one level, and all that bounds it.
  struct Group
  {
    Border_extremum kind;
    Border bounds;
    Scalar level;
  };

  static Border_extremum opposite_kind(Border_extremum kind)
  {
    return kind == Border_extremum::MINIMUM ? Border_extremum::MAXIMUM : Border_extremum::MINIMUM;
  }

  void choose_kinds(Border_extremum wish)
  {
    std::vector<Position> decided;
    for(Position b = 0; b != borders_.size(); ++b)
    {
      if(borders_[b].kept_level && borders_[b].has_lower_neighbor != borders_[b].has_higher_neighbor)
        kinds_[b] = borders_[b].has_lower_neighbor ? Border_extremum::MAXIMUM : Border_extremum::MINIMUM;
      else if(wish != Border_extremum::AUTOMATIC)
        kinds_[b] = wish;
      if(kinds_[b])
        decided.push_back(b);
    }
    spread_kinds(std::move(decided));
    for(Position b = 0; b != borders_.size(); ++b)
    {
      if(!kinds_[b])
        choose_kinds_around(b);
    }
  }

  // Gives the borders that are connected with the decided ones the kind opposite to that of a decided neighbor, or the
  // one that changes less where they have neighbors of both kinds. Returns all that are decided then.
  std::vector<Position> spread_kinds(std::vector<Position> decided)
  {
    for(std::size_t i = 0; i != decided.size(); ++i)
      for(const Position b : borders_[decided[i]].adjacent_borders)
      {
        if(kinds_[b])
          continue;
        kinds_[b] = opposite_kind(*kinds_[decided[i]]);
        const auto has_same_kind = [&](Position a) { return kinds_[a] == kinds_[b]; };
        const auto& adjacent = borders_[b].adjacent_borders;
        if(std::any_of(adjacent.begin(), adjacent.end(), has_same_kind))
          kinds_[b] = kind_of_less_change(borders_[b]);
        decided.push_back(b);
      }
    return decided;
  }

  double change(const Border& border, Border_extremum kind) const
  {
    return arithmetic_.largest_distance(border, arithmetic_.choose_level(border, kind));
  }

  Border_extremum kind_of_less_change(const Border& border) const
  {
    return change(border, Border_extremum::MINIMUM) < change(border, Border_extremum::MAXIMUM)
           ? Border_extremum::MINIMUM
           : Border_extremum::MAXIMUM;
  }

  // Decides a border and all that are connected with it so that the largest change is the smaller one of two choices.
  void choose_kinds_around(Position first)
  {
    std::vector<Position> decided;
    double changes[2] = {0, 0};
    for(const Border_extremum kind : {Border_extremum::MINIMUM, Border_extremum::MAXIMUM})
    {
      double& largest_change = changes[kind == Border_extremum::MAXIMUM];
      decided = decide(first, kind);
      for(const Position b : decided)
        largest_change = (std::max)(largest_change, change(borders_[b], *kinds_[b]));
      for(const Position b : decided)
        kinds_[b].reset();
    }
    decide(first, changes[0] < changes[1] ? Border_extremum::MINIMUM : Border_extremum::MAXIMUM);
  }

  std::vector<Position> decide(Position border, Border_extremum kind)
  {
    kinds_[border] = kind;
    return spread_kinds({border});
  }

  // Adds the group of a border, all borders of its kind that touch each other.
  void add_group(Position first)
  {
    const auto number = static_cast<Position>(groups_.size());
    Group group = {*kinds_[first], borders_[first], borders_[first].lowest};
    std::vector<Position> members = {first};
    groups_of_borders_[first] = number;
    for(std::size_t i = 0; i != members.size(); ++i)
      for(const Position b : borders_[members[i]].adjacent_borders)
      {
        if(kinds_[b] != kinds_[first] || groups_of_borders_[b] != no_position)
          continue;
        groups_of_borders_[b] = number;
        members.push_back(b);
        arithmetic_.add(group.bounds, borders_[b], group.kind);
      }
    group.level = arithmetic_.choose_level(group.bounds, group.kind);
    groups_.push_back(std::move(group));
  }

  // Calls visit(group of maxima, group of minima) for those that touch each other.
  template <class Visit>
  void for_each_touching_pair(const Visit& visit) const
  {
    for(Position b = 0; b != borders_.size(); ++b)
      for(const Position a : borders_[b].adjacent_borders)
      {
        if(kinds_[b] == Border_extremum::MAXIMUM && kinds_[a] == Border_extremum::MINIMUM)
          visit(groups_of_borders_[b], groups_of_borders_[a]);
      }
  }

  // Puts maxima above the minima that they touch. Kept levels stay if those of the other group can give way.
  void part_groups()
  {
    std::vector<Scalar> levels;
    for(const Group& group : groups_)
      levels.push_back(group.level);
    for_each_touching_pair([&](Position above, Position below) {
      const Scalar &low = groups_[above].level, &high = groups_[below].level;
      if(!arithmetic_.less(low, high))
        return;
      const bool is_above_kept = is_kept(groups_[above]), is_below_kept = is_kept(groups_[below]);
      const Scalar middle = is_above_kept == is_below_kept ? arithmetic_.middle(low, high) : is_above_kept ? low : high;
      if(arithmetic_.less(levels[above], middle))
        levels[above] = middle;
      if(arithmetic_.less(middle, levels[below]))
        levels[below] = middle;
    });
    for(std::size_t i = 0; i != groups_.size(); ++i)
      groups_[i].level = levels[i];
    for_each_touching_pair([&](Position above, Position below) {
      Group &upper = groups_[above], &lower = groups_[below];
      if(arithmetic_.less(lower.level, upper.level) || (is_kept(upper) && is_kept(lower)))
        return;
      Group& moved = is_kept(upper) ? lower : upper;
      moved.level = arithmetic_.beyond(moved.level, moved.kind, moved.bounds);
    });
  }

  static bool is_kept(const Group& group) { return group.bounds.kept_level.has_value(); }

  Arithmetic arithmetic_;
  std::vector<Border> borders_;
  std::vector<Kind> kinds_;
  std::vector<Position> groups_of_borders_;
  std::vector<Group> groups_;
};

} // namespace scalar_fields
} // namespace internal
} // namespace Reeb_graph
} // namespace CGAL

#endif // CGAL_REEB_GRAPH_INTERNAL_SCALAR_FIELDS_BORDER_LEVELS_H
