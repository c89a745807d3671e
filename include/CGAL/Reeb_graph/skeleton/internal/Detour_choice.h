// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_SKELETON_INTERNAL_DETOUR_CHOICE_H
#define CGAL_REEB_GRAPH_SKELETON_INTERNAL_DETOUR_CHOICE_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/internal/base/Index.h>
#include <CGAL/Reeb_graph/internal/base/Progress.h>
#include <CGAL/Reeb_graph/skeleton/internal/Loop_group.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <utility>
#include <vector>

namespace CGAL::Reeb_graph::internal::skeleton {

// A chain that passes a tunnel some times more, in one direction or the other one.
struct Tunnel_detour
{
  std::size_t chain, tunnel;
  int times;
};

// Which chains make detours along tunnels, so that loops generate as much as can be. Loops are sums of tunnels, as many as they are,
// or both are told by their crossings with curves: then loops get independent only.
// Numbers are those modulo a prime number, by which few indices can be divided.
class Detour_choice
{
public:
  typedef std::vector<std::pair<Index, int>> Cycles; // that pass a chain, with 1 or -1 for a direction

  // By the tunnels or crossings of loops, the crossings of tunnels, if any, as many as columns, the cycles of each chain, and the
  // detours that may be chosen, the best first.
  Detour_choice(std::vector<Row> loops,
                std::vector<Row> tunnels,
                std::vector<Cycles> cycles_of,
                std::vector<Tunnel_detour> offers,
                const Stage_progress& progress)
    : progress_(progress),
      cycles_of_(std::move(cycles_of)),
      offers_(std::move(offers)),
      are_independent_(tunnels.empty()),
      tunnels_(std::move(tunnels)),
      loops_(std::move(loops))
  {
    for(std::size_t tunnel = 0; are_independent_ && tunnel != loops_.size(); ++tunnel)
      tunnels_.push_back({{tunnel, 1}});
    raise_rank();
    if(are_independent_)
      find_shares();
    lower_index();
  }

  const std::vector<Tunnel_detour>& detours() const { return detours_; }

  // By tunnel, what the index is multiplied with, less 1, where a chain passes it once more.
  std::vector<std::int64_t> shares_of(std::size_t chain) const
  {
    std::vector<std::int64_t> result;
    for(const auto& row : shares_)
      result.push_back(least(row[chain]));
    return result;
  }

  // Lets a chain pass tunnels more (J. Sherman and W. J. Morrison 1950).
  void change(std::size_t chain, const Row& tunnels)
  {
    Numbers row(cycles_of_.size(), 0);
    for(const auto& [tunnel, number] : tunnels)
      add(row, modulo(number), shares_[tunnel]);
    const Number factor = inverse(1 + row[chain]);
    for(Numbers& other : shares_)
      add(other, (prime - other[chain]) * factor % prime, row);
  }

private:
  typedef std::uint64_t Number;
  typedef std::vector<Number> Numbers;
  static constexpr Number prime = 2147483647;

  static Number modulo(const Integer& number) { return static_cast<Number>((number % prime + prime) % prime); }
  static std::int64_t least(Number number)
  {
    return static_cast<std::int64_t>(number) - (2 * number > prime ? static_cast<std::int64_t>(prime) : 0);
  }

  static Number inverse(Number number)
  {
    Number result = 1;
    for(Number exponent = prime - 2; exponent != 0; exponent /= 2, number = number * number % prime)
      result = exponent % 2 == 1 ? result * number % prime : result;
    return result;
  }

  static void add(Numbers& row, Number factor, const Numbers& other)
  {
    for(std::size_t k = 0; factor != 0 && k != row.size(); ++k)
      row[k] = (row[k] + factor * other[k]) % prime;
  }

  void choose(const Tunnel_detour& detour)
  {
    progress_(0); // so that it can be cancelled
    detours_.push_back(detour);
    for(const auto& [cycle, direction] : cycles_of_[detour.chain])
      add_multiple(loops_[cycle], tunnels_[detour.tunnel], detour.times * direction);
  }

  // The sums of numbers by cycle, by chain.
  Numbers sums_by_chain(const Numbers& by_cycle) const
  {
    Numbers result;
    for(const Cycles& cycles : cycles_of_)
    {
      Number sum = 0;
      for(const auto& [cycle, direction] : cycles)
        sum += direction > 0 ? by_cycle[cycle] : prime - by_cycle[cycle];
      result.push_back(sum % prime);
    }
    return result;
  }

  // The matrix of loops, or that with its columns as rows, each with a row of the unit matrix behind it.
  std::vector<Numbers> rows(bool are_columns) const
  {
    const std::size_t height = are_columns ? tunnels_.size() : loops_.size(),
                      width = loops_.size() + tunnels_.size() - height;
    std::vector<Numbers> result(height, Numbers(width + height, 0));
    for(std::size_t i = 0; i != height; ++i)
      result[i][width + i] = 1;
    for(std::size_t i = 0; i != loops_.size(); ++i)
      for(const auto& [k, number] : loops_[i])
        result[are_columns ? k : i][are_columns ? i : k] = modulo(number);
    return result;
  }

  // Takes the first row out that has a number in a column, as a multiple with 1 there, and lets others have none there. It
  // is empty if there is none.
  static Numbers take_pivot(std::size_t column, std::vector<Numbers>& rows)
  {
    const auto found = std::find_if(rows.begin(), rows.end(), [&](const Numbers& row) { return row[column] != 0; });
    if(found == rows.end())
      return {};
    Numbers pivot(found->size(), 0);
    add(pivot, inverse((*found)[column]), *found);
    rows.erase(found);
    for(Numbers& row : rows)
      add(row, (prime - row[column]) % prime, pivot);
    return pivot;
  }

  // The sums of rows that are 0, as multiples of these.
  std::vector<Numbers> kernel(bool is_of_columns) const
  {
    std::vector<Numbers> result = rows(is_of_columns);
    const std::size_t width = is_of_columns ? loops_.size() : tunnels_.size();
    for(std::size_t column = 0; column != width; ++column)
      take_pivot(column, result);
    for(Numbers& row : result)
      row.erase(row.begin(), row.begin() + static_cast<std::ptrdiff_t>(width));
    return result;
  }

  // The sums of numbers by column, by tunnel.
  Numbers sums_by_tunnel(const Numbers& by_column) const
  {
    Numbers result;
    for(const Row& tunnel : tunnels_)
    {
      Number sum = 0;
      for(const auto& [column, number] : tunnel)
        sum = (sum + modulo(number) * by_column[column]) % prime;
      result.push_back(sum);
    }
    return result;
  }

  // Chooses detours until loops are independent: one makes them so if a sum of loops that is 0 passes its chain, and a sum of
  // columns that is 0 for all loops is not for its tunnel.
  void raise_rank()
  {
    std::vector<Numbers> sums = kernel(false), columns = kernel(true);
    for(Numbers& row : sums)
      row = sums_by_chain(row);
    for(Numbers& row : columns)
      row = sums_by_tunnel(row);
    const auto has = [](const std::vector<Numbers>& rows, std::size_t column) {
      return std::any_of(rows.begin(), rows.end(), [&](const Numbers& row) { return row[column] != 0; });
    };
    for(const Tunnel_detour& offer : offers_)
      if(has(sums, offer.chain) && has(columns, offer.tunnel))
      {
        take_pivot(offer.chain, sums);
        take_pivot(offer.tunnel, columns);
        choose(offer);
      }
  }

  // Finds the inverse of the matrix of loops, in sums of columns by chain.
  void find_shares()
  {
    std::vector<Numbers> left = rows(false), pivots;
    const std::size_t size = loops_.size();
    for(std::size_t column = 0; column != size; ++column)
    {
      const Numbers pivot = take_pivot(column, left);
      if(pivot.empty())
        return; // The index can be divided by the prime number.
      for(Numbers& row : pivots)
        add(row, (prime - row[column]) % prime, pivot);
      pivots.push_back(pivot);
    }
    for(Numbers& row : pivots)
    {
      row.erase(row.begin(), row.begin() + static_cast<std::ptrdiff_t>(size));
      shares_.push_back(sums_by_chain(row));
    }
  }

  // Chooses detours as long as the index falls.
  void lower_index()
  {
    const Integer before = Loop_group(loops_).index;
    if(shares_.empty() || before > prime / 2)
      return;
    for(Number index = modulo(before); index != 1;)
    {
      Number lowest = index;
      Tunnel_detour best = {};
      for(const Tunnel_detour& offer : offers_)
        for(const int times : {-2, -1, 1, 2})
        {
          const Number share = shares_[offer.tunnel][offer.chain];
          const Number next = index * (1 + (times < 0 ? prime - share : share) * std::abs(times)) % prime;
          if(const Number size = (std::min)(next, prime - next); size != 0 && size < lowest)
          {
            lowest = size;
            best = {offer.chain, offer.tunnel, times};
          }
        }
      if(lowest == index)
        return;
      choose(best);
      change(best.chain, {{best.tunnel, best.times}});
      index = lowest;
    }
  }

  const Stage_progress progress_;
  const std::vector<Cycles> cycles_of_; // by chain
  const std::vector<Tunnel_detour> offers_;
  const bool are_independent_;       // tunnels
  std::vector<Row> tunnels_, loops_; // what each is made of
  std::vector<Tunnel_detour> detours_;
  std::vector<Numbers> shares_; // by tunnel and chain
};

} // namespace CGAL::Reeb_graph::internal::skeleton

#endif // CGAL_REEB_GRAPH_SKELETON_INTERNAL_DETOUR_CHOICE_H
