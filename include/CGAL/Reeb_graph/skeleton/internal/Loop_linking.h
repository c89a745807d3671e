// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_SKELETON_INTERNAL_LOOP_LINKING_H
#define CGAL_REEB_GRAPH_SKELETON_INTERNAL_LOOP_LINKING_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/internal/base/Index.h>
#include <CGAL/Reeb_graph/internal/base/Progress.h>
#include <CGAL/Reeb_graph/internal/base/arrays.h>
#include <CGAL/Reeb_graph/internal/space/Projected_segments.h>
#include <CGAL/Reeb_graph/skeleton/internal/Branch_pruning.h>
#include <CGAL/Reeb_graph/skeleton/internal/Surface_ways.h>

#include <boost/multiprecision/cpp_int.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <deque>
#include <map>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL::Reeb_graph::internal::skeleton {

typedef boost::multiprecision::number<boost::multiprecision::cpp_int_backend<>, boost::multiprecision::et_off> Integer;
typedef std::map<std::size_t, Integer> Row; // by column, without zeros

// Adds a multiple of another row. Numbers are those modulo `modulus`, where that is not 0.
inline void add_multiple(Row& row, const Row& other, const Integer& factor, const Integer& modulus = 0)
{
  for(const auto& [column, number] : other)
  {
    Integer& sum = row[column];
    sum += factor * number;
    if(modulus != 0)
      sum %= modulus;
    if(sum == 0)
      row.erase(column);
  }
}

// The group that rows generate, in echelon form: each row of the basis has a first column of its own.
class Generated_group
{
public:
  // Numbers are those modulo `modulus`, where that is not 0. Returns which rows depend on those before them.
  std::vector<std::size_t> add_all(const std::vector<Row>& rows, const Integer& modulus = 0)
  {
    std::vector<std::size_t> dependent;
    for(std::size_t i = 0; i != rows.size(); ++i)
    {
      Row row;
      add_multiple(row, rows[i], 1, modulus);
      if(!add(std::move(row), modulus))
        dependent.push_back(i);
    }
    return dependent;
  }

  // A row for each rank, by its first column.
  const std::map<std::size_t, Row>& basis() const { return basis_; }

  // The index of the group in that of all rows of integers that have a multiple in it.
  Integer index() const
  {
    std::map<std::size_t, Row> columns;
    for(const auto& [first, row] : basis_)
      for(const auto& [column, number] : row)
        columns[column][first] = number;
    Generated_group by_columns; // of all minors, those of the highest rank have the index as greatest common divisor
    for(const auto& [column, numbers] : columns)
      by_columns.add(numbers, 0);
    Integer result = 1;
    for(const auto& [first, row] : by_columns.basis_)
      result *= abs(row.begin()->second);
    return result;
  }

private:
  // Returns whether the rank has grown.
  bool add(Row row, const Integer& modulus)
  {
    while(!row.empty())
    {
      const std::size_t column = row.begin()->first;
      Row& pivot = basis_[column];
      pivot.swap(row);
      if(row.empty())
        return true;
      while(row.count(column) != 0) // as Euclid
      {
        add_multiple(row, pivot, -(row[column] / pivot[column]), modulus);
        if(row.count(column) != 0)
          row.swap(pivot);
      }
    }
    return false;
  }

  std::map<std::size_t, Row> basis_; // by first column
};

// The group that loops generate among those of a solid, by their linking numbers with curves.
struct Loop_group
{
  std::size_t number_of_dependent = 0;
  Integer index = 1; // of the group in that of all loops that have a multiple in it

  explicit Loop_group(const std::vector<Row>& rows)
  {
    Generated_group group;
    number_of_dependent = group.add_all(rows).size();
    index = group.index();
  }

  bool is_whole() const { return number_of_dependent == 0 && index == 1; }
  bool operator<(const Loop_group& other) const
  {
    return std::tie(number_of_dependent, index) < std::tie(other.number_of_dependent, other.index);
  }
};

// How often loops are to wind around curves, so that they generate as much as can be. Numbers are those modulo a prime number,
// beyond which no index is that matters.
class Winding_choice
{
public:
  // By linking numbers of loops, and by those that one winding of each adds.
  Winding_choice(const std::vector<Row>& loops, const std::vector<Row>& added) : windings_(loops.size(), 0)
  {
    Generated_group all; // of which loops are to be a basis
    all.add_all(loops);
    all.add_all(added);
    if(all.basis().size() != loops.size())
      return;
    for(const std::size_t loop : Generated_group().add_all(loops, prime()))
      windings_[loop] = 1;
    Matrix of_loops, of_added;
    Integer index = 1;
    for(const auto& [column, row] : all.basis())
      index = reduced(index * row.at(column));
    for(std::size_t i = 0; i != loops.size(); ++i)
    {
      Row wound = loops[i];
      add_multiple(wound, added[i], windings_[i]);
      of_loops.push_back(restricted(wound, all));
      of_added.push_back(restricted(added[i], all));
    }
    const Integer determinant = divide(of_added, of_loops);
    if(determinant != 0)
      improve(of_added, reduced(determinant * inverse(index)));
  }

  const std::vector<int>& windings() const { return windings_; }

private:
  typedef std::vector<std::vector<Integer>> Matrix;

  static const Integer& prime()
  {
    static const Integer result = (Integer(1) << 127) - 1;
    return result;
  }

  // The number of least size.
  static Integer reduced(Integer number)
  {
    number %= prime();
    if(2 * abs(number) > prime())
      number += number < 0 ? prime() : -prime();
    return number;
  }

  static Integer inverse(const Integer& number)
  {
    return powm(Integer((number + prime()) % prime()), prime() - 2, prime());
  }

  static std::vector<Integer> restricted(const Row& row, const Generated_group& group)
  {
    std::vector<Integer> result;
    for(const auto& [column, any] : group.basis())
      result.push_back(row.count(column) != 0 ? row.at(column) : Integer(0));
    return result;
  }

  // Divides by a matrix, by operations on columns, and returns its determinant.
  static Integer divide(Matrix& numbers, Matrix by)
  {
    Integer determinant = 1;
    const std::size_t size = by.size();
    const auto for_each_row = [&](const auto& act) {
      for(Matrix* matrix : {&by, &numbers})
        for(auto& row : *matrix)
          act(row);
    };
    for(std::size_t i = 0; i != size; ++i)
    {
      std::size_t pivot = i;
      while(pivot != size && by[i][pivot] == 0)
        ++pivot;
      if(pivot == size)
        return 0;
      if(pivot != i)
      {
        for_each_row([&](auto& row) { row[pivot].swap(row[i]); });
        determinant = -determinant;
      }
      determinant = reduced(determinant * by[i][i]);
      const Integer factor = inverse(by[i][i]);
      for_each_row([&](auto& row) { row[i] = reduced(row[i] * factor); });
      const std::vector<Integer> pivots = by[i];
      for_each_row([&](auto& row) {
        for(std::size_t k = 0; k != size && row[i] != 0; ++k)
          if(k != i && pivots[k] != 0)
            row[k] = reduced(row[k] - pivots[k] * row[i]);
      });
    }
    return determinant;
  }

  // A loop that winds some times more, and a second one, if any.
  struct Change
  {
    std::array<std::size_t, 2> loops = {};
    std::array<int, 2> times = {};
    Integer index;
  };

  // Winds loops as long as the index falls. A winding of loop i multiplies it by 1 + shares[i][i].
  void improve(Matrix& shares, const Integer& index)
  {
    Change best = {{}, {}, index};
    for(bool is_better = true; is_better && abs(best.index) != 1;)
    {
      is_better = false;
      const Integer before = best.index;
      const auto offer = [&](const Change& change) {
        if(change.index == 0 || abs(change.index) >= abs(best.index))
          return;
        best = change;
        is_better = true;
      };
      for(std::size_t i = 0; i != shares.size(); ++i)
        for(const int t : {-2, -1, 1, 2})
        {
          const Integer next = reduced(before + t * before * shares[i][i]);
          offer({{i, i}, {t, 0}, next});
          for(std::size_t j = 0; j != i && next != 0; ++j)
            for(const int u : {-1, 1})
              offer({{i, j},
                     {t, u},
                     reduced(next + u * before * (shares[j][j] + t * shares[i][i] * shares[j][j])
                             - u * t * before * reduced(shares[i][j] * shares[j][i]))});
        }
      for(const int k : {0, 1})
        if(is_better && best.times[k] != 0)
          wind(best.loops[k], best.times[k], shares);
    }
  }

  void wind(std::size_t loop, int times, Matrix& shares)
  {
    windings_[loop] += times;
    const Integer factor = reduced(times * inverse(reduced(1 + times * shares[loop][loop])));
    const std::vector<Integer> row = shares[loop];
    for(auto& other : shares)
      if(const Integer share = reduced(other[loop] * factor); share != 0)
        for(std::size_t k = 0; k != row.size(); ++k)
          other[k] = reduced(other[k] - share * row[k]);
  }

  std::vector<int> windings_;
};

// Which chains can keep lines of their own in place of ways that are led: as many as are found one after the other, so that the
// loops generate as much as with all ways. Numbers are those modulo a prime number.
class Kept_lines
{
public:
  struct Candidate
  {
    std::vector<std::pair<Index, int>> cycles; // that pass the chain, with 1 or -1 for a direction
    Row change;                                // what its line adds more than its way
  };

  // By linking numbers of loops with ways, and the chains in the order in which they are tried.
  Kept_lines(const std::vector<Row>& loops, const std::vector<Candidate>& candidates)
    : is_kept_(candidates.size(), false)
  {
    const std::vector<Numbers> sums = as_sums_of_loops(loops, candidates);
    if(sums.empty())
      return;
    // A line that is kept multiplies the index by 1 + shares[i][i].
    std::vector<Numbers> shares(candidates.size(), Numbers(candidates.size(), 0));
    for(std::size_t i = 0; i != shares.size(); ++i)
      for(std::size_t j = 0; j != shares.size(); ++j)
        for(const auto& [cycle, direction] : candidates[j].cycles)
          shares[i][j] = (shares[i][j] + (direction > 0 ? 1 : prime - 1) * sums[cycle][loops.size() + i]) % prime;
    for(bool is_any_new = true; is_any_new;)
    {
      is_any_new = false;
      for(std::size_t i = 0; i != shares.size(); ++i)
        if(const Number factor = (1 + shares[i][i]) % prime; !is_kept_[i] && (factor == 1 || factor == prime - 1))
        {
          const Numbers row = shares[i];
          for(Numbers& other : shares)
            add(other, (prime - other[i]) * factor % prime, row);
          is_kept_[i] = is_any_new = true;
        }
    }
  }

  bool is_kept(std::size_t candidate) const { return is_kept_[candidate]; }

private:
  typedef std::uint64_t Number;
  typedef std::vector<Number> Numbers;
  static constexpr Number prime = 2147483647;

  static void add(Numbers& row, Number factor, const Numbers& other)
  {
    for(std::size_t k = 0; factor != 0 && k != row.size(); ++k)
      row[k] = (row[k] + factor * other[k]) % prime;
  }

  static Number inverse(Number number)
  {
    Number result = 1;
    for(Number exponent = prime - 2; exponent != 0; exponent /= 2, number = number * number % prime)
      result = exponent % 2 == 1 ? result * number % prime : result;
    return result;
  }

  // A row for each loop: after a part of the unit matrix, how often each change has the loop. None if loops are dependent.
  static std::vector<Numbers> as_sums_of_loops(const std::vector<Row>& loops, const std::vector<Candidate>& candidates)
  {
    std::map<std::size_t, Numbers> by_curve;
    for(std::size_t i = 0; i != loops.size() + candidates.size(); ++i)
      for(const auto& [curve, number] : i < loops.size() ? loops[i] : candidates[i - loops.size()].change)
      {
        Numbers& row = by_curve[curve];
        row.resize(loops.size() + candidates.size());
        row[i] = static_cast<Number>((number % prime + prime) % prime);
      }
    std::vector<Numbers> rows;
    for(auto& [curve, row] : by_curve)
      rows.push_back(std::move(row));
    for(std::size_t i = 0; i != loops.size(); ++i)
    {
      std::size_t pivot = i;
      while(pivot < rows.size() && rows[pivot][i] == 0)
        ++pivot;
      if(pivot >= rows.size())
        return {};
      rows[i].swap(rows[pivot]);
      const Number factor = inverse(rows[i][i]);
      for(Number& number : rows[i])
        number = number * factor % prime;
      for(Numbers& row : rows)
        if(&row != &rows[i])
          add(row, (prime - row[i]) % prime, rows[i]);
    }
    rows.resize(loops.size());
    return rows;
  }

  std::vector<bool> is_kept_;
};

// Closed curves on a surface, as sums of polygons.
struct Surface_curves
{
  typedef std::pair<Index, int> Step; // a number, and 1 or -1 for a direction

  std::vector<std::vector<Point>> polygons;
  std::vector<std::vector<Step>> curves_of; // of each polygon

  // Adds a curve that is one polygon.
  void add(std::vector<Point> polygon)
  {
    polygon.push_back(polygon.front());
    curves_of.push_back({{static_cast<Index>(polygons.size()), 1}});
    polygons.push_back(std::move(polygon));
  }
};

// The loops of a skeleton, as cycles of chains, and around which curves on the surface they wind.
class Loop_linking
{
public:
  typedef Surface_curves::Step Step; // a chain
  typedef std::vector<Step> Cycle;
  typedef std::vector<Point> Line;

  // By the nodes at the ends of chains.
  explicit Loop_linking(const std::vector<std::array<Index, 2>>& ends) : ends_(ends)
  {
    find_tree();
    cycles_of_.resize(ends_.size());
    for(const Index chain : closing_)
    {
      const auto number = static_cast<Index>(cycles_.size());
      cycles_.push_back(cycle_through(chain));
      for(const auto& [passed, direction] : cycles_.back())
        cycles_of_[passed].push_back({number, direction});
    }
  }

  const std::vector<Cycle>& cycles() const { return cycles_; }
  const std::vector<Index>& closing_chains() const { return closing_; } // one of each cycle
  bool is_on_cycle(Index chain) const { return !cycles_of_[chain].empty(); }
  const std::vector<Step>& cycles_of(Index chain) const { return cycles_of_[chain]; }

  // The rows that the line of each chain adds to linking numbers with curves: its signed crossings over them. A chain can have no
  // line. The lines must not meet the polygons.
  std::vector<Row> crossings(const std::vector<Line>& lines,
                             const Surface_curves& curves,
                             const Stage_progress& progress) const
  {
    Segments over, under;
    for(Index chain = 0; chain != lines.size(); ++chain)
      if(is_on_cycle(chain))
        over.add(lines[chain], chain);
    for(Index polygon = 0; polygon != curves.polygons.size(); ++polygon)
      under.add(curves.polygons[polygon], polygon);
    typedef std::map<std::array<Index, 2>, int> Crossings; // by chain and polygon
    const auto all = in_general_direction<Crossings>([&](const std::array<double, 3>& direction) {
      Crossings result;
      std::size_t number = 0;
      const Projected_segments view(direction);
      view.for_each_pair_that_may_cross(over.all, under.all, [&](const auto& a, const auto& b) {
        if(++number % 4096 == 0)
          progress(0); // so that it can be cancelled
        if(const int sign = view.crossing_over(a.segment, b.segment))
          result[{a.piece, b.piece}] += sign;
      });
      return result;
    });
    std::vector<Row> rows(lines.size());
    for(const auto& [pair, number] : all)
      for(const auto& [curve, direction] : curves.curves_of[pair[1]])
        add_multiple(rows[pair[0]], {{curve, number}}, direction);
    return rows;
  }

  // The group that the loops generate, by what their chains add to linking numbers.
  Loop_group group(const std::vector<Row>& of_chains) const { return Loop_group(linking_numbers(of_chains)); }

  // The linking numbers of each cycle: the sums of what its chains add.
  std::vector<Row> linking_numbers(const std::vector<Row>& of_chains) const
  {
    std::vector<Row> rows(cycles_.size());
    for(Index chain = 0; chain != of_chains.size(); ++chain)
      for(const auto& [cycle, direction] : cycles_of_[chain])
        add_multiple(rows[cycle], of_chains[chain], direction);
    return rows;
  }

  std::vector<Index> chains_on_cycles() const
  {
    std::vector<Index> result;
    for(Index chain = 0; chain != cycles_of_.size(); ++chain)
      if(is_on_cycle(chain))
        result.push_back(chain);
    return result;
  }

private:
  // Segments with the number of their line.
  struct Segments
  {
    struct Located
    {
      Projected_segments::Segment segment;
      Index piece;
    };
    std::deque<std::array<double, 3>> points;
    std::vector<Located> all;

    void add(const Line& line, Index piece)
    {
      for(std::size_t i = 0; i != line.size(); ++i)
      {
        if(i != 0 && line[i] == line[i - 1])
          continue;
        points.push_back({line[i].x(), line[i].y(), line[i].z()});
        const auto end = [&](std::size_t k) { return Mean_point{{&points[points.size() - k], nullptr, nullptr}, 1}; };
        if(i != 0)
          all.push_back({{end(2), end(1)}, piece});
      }
    }
  };

  void find_tree()
  {
    const auto& all = ends_;
    Index number_of_nodes = 0;
    for(const auto& ends : all)
      number_of_nodes = (std::max)({number_of_nodes, ends[0] + 1, ends[1] + 1});
    arcs_of_.resize(number_of_nodes);
    Disjoint_sets<Index> parts(number_of_nodes);
    for(Index chain = 0; chain != all.size(); ++chain)
    {
      const auto& ends = all[chain];
      if(parts.find(ends[0]) == parts.find(ends[1]))
      {
        closing_.push_back(chain);
        continue;
      }
      parts.unite(ends[0], ends[1]);
      for(const Index end : ends)
        arcs_of_[end].push_back(chain);
    }
  }

  // The chain, and then the path in the tree from its end to its begin.
  Cycle cycle_through(Index closing) const
  {
    const auto& all = ends_;
    const Index begin = all[closing][0], end = all[closing][1];
    std::map<Index, Step> reached = {{begin, {no_index, 0}}};
    std::vector<Index> queue = {begin};
    for(std::size_t i = 0; i != queue.size() && reached.count(end) == 0; ++i)
      for(const Index chain : arcs_of_[queue[i]])
      {
        const auto& ends = all[chain];
        const bool is_upwards = ends[1] == queue[i]; // on the way back
        const Index other = ends[is_upwards ? 0 : 1];
        if(reached.insert({other, {chain, is_upwards ? -1 : 1}}).second)
          queue.push_back(other);
      }
    Cycle cycle = {{closing, 1}};
    for(Index node = end; node != begin;)
    {
      const auto [chain, direction] = reached.at(node);
      cycle.push_back({chain, -direction});
      node = all[chain][direction == 1 ? 0 : 1];
    }
    return cycle;
  }

  const std::vector<std::array<Index, 2>> ends_;
  std::vector<std::vector<Index>> arcs_of_; // of the tree, by node
  std::vector<Index> closing_;
  std::vector<Cycle> cycles_;
  std::vector<std::vector<Step>> cycles_of_; // by chain
};

// Leads lines of loops as the surface leads, where centers of contours have left the family of contours: beneath the faces
// along their arcs.
class Loop_tracing
{
public:
  Loop_tracing(const Sampled_graph& graph, const Graph_chains& chains, const Surface_tree& tree)
    : graph_(graph),
      chains_(chains),
      tree_(tree)
  {}

  // A path of faces from that of the node at one end of a chain to that at the other one, which goes so many times around a
  // contour of its first arc.
  Face_path path(Index chain, int windings) const
  {
    const auto& [ends, pieces, length] = chains_.chains()[chain];
    Face_path result = {face_of(ends[0]), {}};
    for(const auto& piece : pieces)
    {
      const Face_path next = path_of_arc(piece.arc, piece.is_upwards, &piece == &pieces.front() ? windings : 0);
      turn(graph_.vertex(graph_.ends(piece.arc)[piece.is_upwards ? 0 : 1]), result.end(mesh()), next.begin,
           result.steps);
      result.steps.insert(result.steps.end(), next.steps.begin(), next.steps.end());
    }
    turn(graph_.vertex(ends[1]), result.end(mesh()), face_of(ends[1]), result.steps);
    return result;
  }

  // A polygon on the surface along a chain.
  std::vector<Point> curve(Index chain) const
  {
    const Face_path along = path(chain, 0);
    std::vector<Point> points = {tree_.center(along.begin)};
    for(const auto h : along.steps)
    {
      points.push_back(CGAL::midpoint(mesh().point(mesh().source(h)), mesh().point(mesh().target(h))));
      points.push_back(tree_.center(mesh().face(mesh().opposite(h))));
    }
    return points;
  }

private:
  const Mesh& mesh() const { return graph_.mesh(); }
  Mesh::Face_index face_of(Index node) const { return mesh().face(mesh().halfedge(graph_.vertex(node))); }
  // Around a vertex from one face to another one.
  void turn(Mesh::Vertex_index v,
            Mesh::Face_index from,
            Mesh::Face_index to,
            std::vector<Mesh::Halfedge_index>& path) const
  {
    auto h = mesh().halfedge(from);
    while(mesh().source(h) != v)
      h = mesh().next(h);
    for(; mesh().face(h) != to; h = mesh().next(mesh().opposite(h)))
      path.push_back(h);
  }

  Face_path path_of_arc(Index arc, bool is_upwards, int windings) const
  {
    const auto [chain, contour] = graph_.chain_and_end(arc);
    Face_path result = {mesh().face(chain.front()), {}};
    for(std::size_t i = 1; i < chain.size(); ++i)
      turn_to(chain[i - 1], chain[i], result.steps);
    // Along the contour below the upper end to that.
    const auto top = graph_.vertex(graph_.ends(arc)[1]);
    const std::size_t size = contour.size();
    auto step = static_cast<std::size_t>(std::find(contour.begin(), contour.end(), chain.back()) - contour.begin());
    for(std::size_t i = 0; i != size * static_cast<std::size_t>(std::abs(windings)); ++i)
      result.steps.push_back(windings > 0 ? contour[(step + i) % size]
                                          : mesh().opposite(contour[(step + size - 1 - i % size) % size]));
    for(; mesh().target(contour[step]) != top; step = (step + 1) % size)
      result.steps.push_back(contour[step]);
    return is_upwards ? result : result.reversed(mesh());
  }

  // From the face of one halfedge around its target to that of the next one.
  void turn_to(Mesh::Halfedge_index h, Mesh::Halfedge_index next, std::vector<Mesh::Halfedge_index>& steps) const
  {
    for(auto g = mesh().next(h); g != next; g = mesh().next(mesh().opposite(g)))
      steps.push_back(g);
  }

  const Sampled_graph& graph_;
  const Graph_chains& chains_;
  const Surface_tree& tree_;
};

} // namespace CGAL::Reeb_graph::internal::skeleton

#endif // CGAL_REEB_GRAPH_SKELETON_INTERNAL_LOOP_LINKING_H
