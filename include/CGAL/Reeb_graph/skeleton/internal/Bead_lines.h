// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_SKELETON_INTERNAL_BEAD_LINES_H
#define CGAL_REEB_GRAPH_SKELETON_INTERNAL_BEAD_LINES_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/internal/base/Index.h>
#include <CGAL/Reeb_graph/skeleton/internal/Bead_ways.h>
#include <CGAL/Reeb_graph/skeleton/internal/Graph_chains.h>
#include <CGAL/Reeb_graph/skeleton/internal/Loop_linking.h>
#include <CGAL/Reeb_graph/skeleton/internal/Skeleton_lines.h>
#include <CGAL/Reeb_graph/skeleton/internal/Surface_tree.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <utility>
#include <vector>

namespace CGAL::Reeb_graph::internal::skeleton {

// The lines of a skeleton as numbers of beads, which know how far the surface is: gives them other points, or fewer ones, where
// the surface does not meet the triangles that lines then sweep, so that no line crosses it, and no loop leaves its handle.
class Bead_lines : protected Bead_ways
{
protected:
  typedef std::vector<std::size_t> Numbers; // of beads
  struct Line
  {
    Numbers beads;                     // from node to node; none if it has become a point
    std::array<double, 2> places = {}; // of its ends, on the chain
    std::size_t joined = 0;            // the node that it has become
    bool is_fixed = false, is_on_cycle = false;
    bool is_resting = false; // needs no other points
  };
  struct End_of_line
  {
    std::size_t line;
    bool is_last;
  };

  Bead_lines(const Graph_chains& chains, const Surface_tree& tree, Skeleton_lines& lines, double smooth)
    : Bead_ways(tree),
      smooth_(smooth),
      least_depth_(lines.least_radius())
  {
    for(const auto& [index, node] : lines.nodes())
    {
      numbers_[index] = beads_.size();
      beads_.push_back(make_bead(node));
    }
    const Loop_linking loops(lines.ends());
    for(Index chain = 0; chain != lines.lines().size(); ++chain)
    {
      Numbers beads = {numbers_.at(lines.ends()[chain][0])};
      for(const Line_point& point : lines.lines()[chain])
      {
        beads.push_back(beads_.size());
        beads_.push_back(make_bead(point));
      }
      beads.push_back(numbers_.at(lines.ends()[chain][1]));
      add_pieces(with_ways_to_crossings(beads, chains.chains()[chain].length), chains.chains()[chain].length,
                 loops.is_on_cycle(chain));
    }
    let_go();
    find_ends();
  }

  // Of an edge that crosses the surface, little is to stay: gives it points in balls along it from both sides.
  Numbers with_ways_to_crossings(const Numbers& beads, double length)
  {
    Numbers result = {beads.front()};
    for(std::size_t i = 0; i + 1 != beads.size(); ++i)
    {
      std::array<Numbers, 2> ways;
      const double size = distance(beads_[beads[i]].point.point, beads_[beads[i + 1]].point.point);
      const bool is_led = !is_free({beads[i], beads[i + 1]}) && !tree_.has_openings() && !is_outside(beads[i])
                       && !is_outside(beads[i + 1]);
      for(const int side : {0, 1})
        for(double depth = beads_[beads[i + side]].depth, way = 0; is_led && depth > 0.05 * size;)
        {
          way += 0.8 * depth / size;
          ways[side].push_back(beads_.size());
          beads_.push_back(between(beads, i, side == 0 ? way : 1 - way, {0, length}));
          depth = beads_.back().depth;
        }
      result.insert(result.end(), ways[0].begin(), ways[0].end());
      result.insert(result.end(), ways[1].rbegin(), ways[1].rend());
      result.push_back(beads[i + 1]);
    }
    return result;
  }

  // Edges that are not inside, as where the surface intersects itself or has no volume, could go anywhere: they stay, and what
  // is between them are lines of their own.
  void add_pieces(const Numbers& beads, double length, bool is_on_cycle)
  {
    pieces_.emplace_back();
    const auto place_of = [&](std::size_t i) {
      return i == 0 ? 0 : i + 1 == beads.size() ? length : beads_[beads[i]].point.place;
    };
    bool was_outside = is_outside(beads[0]);
    for(std::size_t i = 1; i != beads.size(); ++i)
    {
      const bool is_last_outside = std::exchange(was_outside, is_outside(beads[i]));
      const bool is_fixed = is_last_outside || was_outside || is_wrong(beads[i - 1], beads[i]);
      if(i == 1 || is_fixed != lines_.back().is_fixed)
      {
        pieces_.back().push_back(lines_.size());
        lines_.push_back({{beads[i - 1]}, {place_of(i - 1), 0}, 0, is_fixed, is_on_cycle});
      }
      lines_.back().beads.push_back(beads[i]);
      lines_.back().places[1] = place_of(i);
    }
  }

  bool is_outside(std::size_t bead) const
  {
    return !beads_[bead].is_on_surface() && !tree_.is_inside(beads_[bead].point.point);
  }

  bool is_wrong(std::size_t a, std::size_t b) const
  {
    const Bead &p = beads_[a], &q = beads_[b];
    return !is_free({a, b})
        || (p.is_on_surface() && q.is_on_surface() && !tree_.is_inside(CGAL::midpoint(p.point.point, q.point.point)));
  }

  // Lines that have come inside are as others, and one with what they go on to.
  void let_go()
  {
    for(Numbers& pieces : pieces_)
      for(std::size_t i = pieces.size(); i-- != 0;)
      {
        Line& line = lines_[pieces[i]];
        bool is_wrong_still = false;
        for(std::size_t k = 1; k < line.beads.size() && line.is_fixed && !is_wrong_still; ++k)
        {
          const std::size_t a = line.beads[k - 1], b = line.beads[k];
          is_wrong_still = is_outside(a) || is_outside(b) || is_wrong(a, b);
        }
        line.is_resting = line.is_resting && line.is_fixed == is_wrong_still;
        line.is_fixed = is_wrong_still;
        if(line.is_fixed || i + 1 == pieces.size() || lines_[pieces[i + 1]].is_fixed)
          continue;
        Line& next = lines_[pieces[i + 1]];
        next.beads.insert(next.beads.begin(), line.beads.begin(), line.beads.end() - 1);
        next.places[0] = line.places[0];
        next.is_resting = false;
        line.beads.clear();
        pieces.erase(pieces.begin() + static_cast<std::ptrdiff_t>(i));
      }
    for(Bead& bead : beads_)
      bead.is_fixed = false;
    for(const Line& line : lines_)
      for(const std::size_t bead : line.beads)
        beads_[bead].is_fixed = beads_[bead].is_fixed || line.is_fixed;
  }

  void find_ends()
  {
    ends_of_nodes_.clear();
    for(std::size_t line = 0; line != lines_.size(); ++line)
      if(const Numbers& beads = lines_[line].beads; !beads.empty())
      {
        ends_of_nodes_[beads.front()].push_back({line, false});
        ends_of_nodes_[beads.back()].push_back({line, true});
      }
    for(const auto& [node, ends] : ends_of_nodes_)
      beads_[node].is_settled = false;
  }

  // The bead of a line that is so far from one of its ends.
  std::size_t from_end(const End_of_line& end, std::size_t i) const
  {
    const Numbers& beads = lines_[end.line].beads;
    return end.is_last ? beads[beads.size() - 1 - i] : beads[i];
  }

  // Whether the surface does not meet any edge of a line.
  using Bead_ways::is_free;
  bool is_free(const Numbers& line) const
  {
    for(std::size_t i = 1; i != line.size(); ++i)
      if(!is_free(beads_[line[i - 1]], beads_[line[i]]))
        return false;
    return true;
  }

  // Whether a line can go straight on from one point of it to another one.
  bool is_free(const Numbers& line, std::size_t from, std::size_t to) const
  {
    for(std::size_t i = from + 2; i <= to; ++i)
      if(!is_free(beads_[line[from]], beads_[line[i - 1]], beads_[line[i]].place()))
        return false;
    return true;
  }

  // Leaves points out where a line folds back on itself, and before tips: from where the tip is about as near as the rest of
  // the surface, the way to it is straight, as no place there is in the middle.
  void leave_out_folds_and_tops(Numbers& beads) const
  {
    const auto is_top = [&](const Bead& bead, const Bead& tip) {
      return tip.depth == 0 && distance(bead.point.point, tip.point.point) < 1.4 * bead.depth;
    };
    for(std::size_t i = 1; i + 1 < beads.size() && beads.size() > 4;)
    {
      const Bead &a = beads_[beads[i - 1]], &b = beads_[beads[i]], &c = beads_[beads[i + 1]];
      const Vector from = b.point.point - a.point.point, to = c.point.point - b.point.point;
      const bool is_fold = from * to < -0.3 * length(from) * length(to);
      if((is_fold || is_top(b, a) || is_top(b, c)) && is_free(a, b, c.place()))
      {
        beads.erase(beads.begin() + static_cast<std::ptrdiff_t>(i));
        i = (std::max)(i, std::size_t(2)) - 1;
      }
      else
        ++i;
    }
  }

  double spacing(const Bead& bead) const { return 0.8 * (std::max)(bead.depth, least_depth_); }

  // How many times as far apart as they are to be two points are.
  double steps_between(const Bead& a, const Bead& b) const
  {
    const double sum = spacing(a) + spacing(b), most = (std::max)(spacing(a), spacing(b));
    return distance(a.point.point, b.point.point) / (a.depth > 0 && b.depth > 0 ? sum / 2 : 1.2 * most);
  }

  // Points at equal steps by the distance from the surface; those of the line between them where the way there is not free.
  void resample(Line& resampled)
  {
    const Numbers line = resampled.beads;
    if(line.empty())
      return;
    std::vector<double> steps = {0};
    for(std::size_t i = 1; i != line.size(); ++i)
      steps.push_back(steps.back() + steps_between(beads_[line[i - 1]], beads_[line[i]]));
    const std::size_t least = line.front() == line.back() ? 4 : 1;
    const std::size_t number = (std::max)(static_cast<std::size_t>(std::ceil(steps.back())), least);
    Numbers dense = {line.front()}; // the points of the line, and the new ones between them
    Numbers kept = {0};
    std::size_t i = 0;
    const auto pass = [&](double step) {
      for(; i + 2 < line.size() && steps[i + 1] <= step; ++i)
        dense.push_back(line[i + 1]);
    };
    for(std::size_t k = 1; k < number; ++k)
    {
      const double step = steps.back() * static_cast<double>(k) / static_cast<double>(number);
      pass(step);
      const double size = steps[i + 1] - steps[i];
      kept.push_back(dense.size());
      dense.push_back(beads_.size());
      beads_.push_back(between(line, i, size > 0 ? (step - steps[i]) / size : 0, resampled.places));
    }
    pass(steps.back());
    kept.push_back(dense.size());
    dense.push_back(line.back());
    resampled.beads = {dense.front()};
    for(std::size_t k = 1; k != kept.size(); ++k)
    {
      const auto from = dense.begin() + static_cast<std::ptrdiff_t>(kept[k - 1]),
                 to = dense.begin() + static_cast<std::ptrdiff_t>(kept[k]);
      resampled.beads.insert(resampled.beads.end(), is_free(dense, kept[k - 1], kept[k]) ? to : from + 1, to + 1);
    }
    if(!is_free(resampled.beads)) // Points on an edge are rounded.
      resampled.beads = line;
  }

  // Lets a line go straight on before a tip where that is farther from the surface than what is as far from the tip on the way to it.
  void go_on_before_tip(Line& line, bool is_last)
  {
    Numbers& beads = line.beads;
    if(beads.size() < 3 || beads_[is_last ? beads.back() : beads.front()].depth > 0)
      return;
    const std::size_t i = is_last ? beads.size() - 2 : 1;
    const Bead tip = beads_[is_last ? beads.back() : beads.front()], last = beads_[beads[i]];
    const Vector along = last.point.point - beads_[beads[is_last ? i - 1 : i + 1]].point.point;
    const double way = distance(last.point.point, tip.point.point);
    for(double share = 0.875; share > 0 && length(along) > 0; share -= 0.125)
    {
      Bead on_way = between(beads, is_last ? i : 0, is_last ? share : 1 - share, line.places), next = on_way;
      next.point.point = last.point.point + share * way / length(along) * along;
      next = make_bead(next.point);
      const double rest = distance(next.point.point, tip.point.point);
      on_way.point.point = tip.point.point + rest / way * (last.point.point - tip.point.point);
      if(!(rest > 1.2 * next.depth && next.depth > make_bead(on_way.point).depth) || !is_free(last, tip, next.place()))
        continue;
      beads.insert(beads.begin() + static_cast<std::ptrdiff_t>(is_last ? i + 1 : 1), beads_.size());
      beads_.push_back(next);
      return;
    }
  }

  double place(const Numbers& line, std::size_t i, const std::array<double, 2>& of_ends) const
  {
    return i == 0 ? of_ends[0] : i + 1 == line.size() ? of_ends[1] : beads_[line[i]].point.place;
  }

  // A bead between two of a line. It goes on at their pace.
  Bead between(const Numbers& line, std::size_t i, double t, const std::array<double, 2>& of_ends) const
  {
    Bead a = beads_[line[i]], b = beads_[line[i + 1]];
    a.point.place = place(line, i, of_ends);
    b.point.place = place(line, i + 1, of_ends);
    Bead bead = Bead_ways::between(a, b, t);
    bead.pace = std::clamp((std::max)(a.pace, b.pace), 0.05, bead.pace);
    return bead;
  }

  // Leaves points out that are near to a straight line (D. Douglas and T. Peucker 1973), among so many at a time, as a way is
  // tested by the fan of triangles that it leaves out.
  void decimate(Numbers& beads) const
  {
    const bool is_ring = !beads.empty() && beads.front() == beads.back();
    if(beads.empty() || (is_ring && beads.size() < 7))
      return;
    const Numbers line = std::exchange(beads, {beads.front()});
    const auto add = [&](const auto& self, std::size_t from, std::size_t to) -> void {
      std::size_t farthest = from;
      double greatest = 1;
      for(std::size_t i = from + 1; i < to; ++i)
        if(const double share = share_beside(line, from, to, i); share > greatest)
        {
          greatest = share;
          farthest = i;
        }
      if(farthest == from && !is_free(line, from, to))
        farthest = (from + to) / 2;
      if(farthest == from)
        return beads.push_back(line[to]);
      self(self, from, farthest);
      self(self, farthest, to);
    };
    const std::size_t last = line.size() - 1, at_once = is_ring ? (std::min)(last / 3, most_at_once) : most_at_once;
    for(std::size_t from = 0; from < last; from += at_once)
      add(add, from, (std::min)(from + at_once, last));
  }

  // How far a bead is from a chord, as a share of what may be.
  double share_beside(const Numbers& line, std::size_t from, std::size_t to, std::size_t i) const
  {
    const Bead& bead = beads_[line[i]];
    return distance(bead.point.point, foot(line, from, to, i)) / (tolerance * smooth_ * bead.depth);
  }

  // The point of a chord that is closest to a bead.
  Point foot(const Numbers& line, std::size_t from, std::size_t to, std::size_t i) const
  {
    const Point& p = beads_[line[from]].point.point;
    const Vector chord = beads_[line[to]].point.point - p, way = beads_[line[i]].point.point - p;
    const double square = chord.squared_length();
    return p + (square > 0 ? std::clamp(way * chord / square, 0., 1.) : 0) * chord;
  }

  void write(Skeleton_lines& lines, Index next)
  {
    std::map<std::size_t, Index> nodes;
    for(const auto& [index, number] : numbers_)
      nodes[number] = index;
    find_ends();
    for(const auto& [number, ends] : ends_of_nodes_)
      if(nodes.count(number) == 0 && !beads_[number].is_fixed)
        nodes[number] = next++;
    for(const auto& [number, index] : nodes)
    {
      Skeleton_lines::Node& node = lines.nodes()[index];
      node.point = beads_[number].point;
      node.vertex = beads_[number].vertex;
      node.face = beads_[number].face;
    }
    for(std::size_t i = pieces_.empty() ? 0 : pieces_.back().back() + 1; i != lines_.size(); ++i)
      pieces_.push_back({i});
    lines.lines().resize(pieces_.size());
    lines.ends().resize(pieces_.size());
    const auto node_of = [&](std::size_t bead) {
      while(joined_.count(bead) != 0)
        bead = joined_.at(bead);
      return nodes.at(bead);
    };
    for(const auto& [index, number] : numbers_)
      lines.join(index, node_of(number));
    for(std::size_t i = 0; i != pieces_.size(); ++i)
    {
      Numbers beads;
      for(const std::size_t piece : pieces_[i])
        append(lines_[piece], beads);
      lines.ends()[i] = {node_of(beads.front()), node_of(beads.back())};
      Skeleton_lines::Line& line = lines.lines()[i];
      line.clear();
      for(std::size_t k = 1; k + 1 < beads.size(); ++k)
        line.push_back(beads_[beads[k]].point);
    }
  }

  void append(Line& line, Numbers& beads)
  {
    if(line.beads.empty())
      line.beads = {line.joined, line.joined};
    beads.insert(beads.end(), line.beads.begin() + (beads.empty() ? 0 : 1), line.beads.end());
  }

  static constexpr std::size_t most_at_once = 32;
  static constexpr double tolerance = 0.055; // of the distance from the surface, in straight parts

  const double smooth_, least_depth_;
  std::vector<Bead> beads_; // those that have been left out, too
  std::vector<Line> lines_;
  std::vector<Numbers> pieces_; // the lines of a chain
  std::map<std::size_t, std::vector<End_of_line>> ends_of_nodes_;
  std::map<Index, std::size_t> numbers_;      // of nodes
  std::map<std::size_t, std::size_t> joined_; // nodes that have become others
};

} // namespace CGAL::Reeb_graph::internal::skeleton

#endif // CGAL_REEB_GRAPH_SKELETON_INTERNAL_BEAD_LINES_H
