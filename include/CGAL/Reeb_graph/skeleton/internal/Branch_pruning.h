// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_SKELETON_INTERNAL_BRANCH_PRUNING_H
#define CGAL_REEB_GRAPH_SKELETON_INTERNAL_BRANCH_PRUNING_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/internal/base/Index.h>
#include <CGAL/Reeb_graph/internal/base/Progress.h>
#include <CGAL/Reeb_graph/skeleton/internal/Edge_walk.h>
#include <CGAL/Reeb_graph/skeleton/internal/Plane_contour.h>
#include <CGAL/Reeb_graph/skeleton/internal/Sampled_graph.h>
#include <CGAL/Reeb_graph/skeleton/internal/Surface_tree.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <numeric>
#include <optional>
#include <queue>
#include <utility>
#include <vector>

namespace CGAL::Reeb_graph::internal::skeleton {

// Takes branches off a graph, the least persistent ones first: paths from a leaf to the node where they leave the trunk,
// or, if the rest is a loop, where they leave that. A branch goes if its persistence is below a share of its radius there, or
// of three quarters of that of the trunk, if it protrudes from the trunk by less than a share of its radius, or if it leads
// across or around a tube, or to the corner of a bend. A limb as long as wide stays where it protrudes by half of that share, and
// so does one to a border.
class Branch_pruning
{
public:
  Branch_pruning(const Sampled_graph& graph,
                 const Surface_tree& tree,
                 const std::vector<double>& given_lengths,
                 double ratio,
                 bool are_values_distances,
                 const std::vector<bool>& is_border,
                 const Stage_progress& progress)
    : graph_(graph),
      tree_(tree),
      ratio_(ratio),
      are_values_distances_(are_values_distances),
      is_border_(is_border),
      progress_(progress),
      is_alive_(graph.number_of_arcs(), true),
      degrees_(graph.number_of_nodes()),
      redirections_(graph.number_of_nodes(), no_index),
      branches_(graph.number_of_nodes()),
      waiting_(graph.number_of_nodes()),
      walk_(tree.mesh(), given_lengths)
  {
    for(Index node = 0; node != graph.number_of_nodes(); ++node)
      degrees_[node] = static_cast<Index>(graph.arcs_of(node).size());
    for(Index node = 0; node != graph.number_of_nodes(); ++node)
    {
      if(degrees_[node] != 1)
        continue;
      branches_[node].end = node;
      grow(node);
    }
    run();
  }

  bool is_alive(Index arc) const { return is_alive_[arc]; }
  Index degree(Index node) const { return degrees_[node]; }

  // Where the branch with a node, or arc, has left what is still there.
  Index trunk_of(Index node)
  {
    Index root = node;
    while(redirections_[root] != no_index)
      root = redirections_[root];
    while(redirections_[node] != no_index)
      node = std::exchange(redirections_[node], root);
    return root;
  }

private:
  struct Branch
  {
    Index end = no_index;
    double persistence = 0;
    std::vector<Index> arcs; // from the tip
  };
  typedef std::pair<double, Index> Entry; // of a tip

  // A distance from a node along an arc, and the contour there.
  struct Way
  {
    Index arc, node;
    double distance;
    Contour_sample sample;
  };

  // Goes on with the branch of a tip through nodes with two arcs, and queues it if it ends at one with more.
  void grow(Index tip)
  {
    if(degrees_[tip] == 0) // It has been removed.
      return;
    Branch& branch = branches_[tip];
    while(degrees_[branch.end] == 2 || branch.arcs.empty())
    {
      Index next = no_index;
      for(const Index arc : graph_.arcs_of(branch.end))
        if(is_alive_[arc] && (branch.arcs.empty() || arc != branch.arcs.back()))
          next = arc;
      branch.arcs.push_back(next);
      branch.end = graph_.other_end(next, branch.end);
      branch.persistence = (std::max)(branch.persistence, height(tip, branch.end));
    }
    if(degrees_[branch.end] > 2)
      queue_.push({branch.persistence, tip});
  }

  // The height of a tip over a node: for values that are no distances, how far it is away.
  double height(Index tip, Index node) const
  {
    return are_values_distances_ ? std::abs(graph_.value(tip) - graph_.value(node))
                                 : distance(graph_.point(tip), graph_.point(node));
  }

  void run()
  {
    const std::size_t number_of_tips = queue_.size();
    for(std::size_t step = 0; !queue_.empty(); ++step)
    {
      progress_.report_step(step, number_of_tips);
      const Index tip = queue_.top().second;
      queue_.pop();
      const Index end = branches_[tip].end;
      if(degrees_[end] == 2) // A branch that ended there has gone.
        grow(tip);
      else if(is_to_go(branches_[tip], tip))
        remove(tip);
      else
        waiting_[end].push_back(tip);
    }
  }

  bool is_to_go(const Branch& branch, Index tip)
  {
    if(!(ratio_ > 0) || is_border_[tip])
      return false;
    if(!stands_out_little(branch, graph_.vertex(tip)))
      return false;
    const auto corner = farthest_corner(branch, tip);
    return corner == graph_.vertex(tip) || stands_out_little(branch, corner);
  }

  // Where the front comes last to the middle of the flat end of a thick limb, behind others that are thin, the corner of that end
  // that is farthest from where the branch leaves the trunk; else the vertex of the tip.
  Mesh::Vertex_index farthest_corner(const Branch& branch, Index tip)
  {
    const auto top = graph_.vertex(tip);
    if(!are_values_distances_
       || std::any_of(balls_.begin(), balls_.end(), [&](const Inner_ball& ball) { return is_short(branch, ball); }))
      return top;
    const Vector inwards = tree_.inward_direction(top);
    const auto is_beside = [&](const Point& p) {
      const Vector way = p - graph_.point(tip);
      return std::abs(way * inwards) < 0.2 * length(way);
    };
    const auto length_beside = [&](Index arc) { return graph_.sample_beside(arc, branch.end).shape.length; };
    const double around = length_beside(branch.arcs.back());
    if(!(branch.persistence > 0.75 * around / (2 * pi)))
      return top;
    int number_of_thick = 0;
    for(const Index arc : graph_.arcs_of(branch.end))
      if(is_alive_[arc] && arc != branch.arcs.back())
      {
        const Index other = graph_.other_end(arc, branch.end);
        number_of_thick += length_beside(arc) > around / 2 ? 1 : 0;
        if(number_of_thick > 1 || (degrees_[other] == 1 && is_beside(graph_.point(other))))
          return top;
      }
    auto corner = top;
    const auto way_to = [&](Mesh::Vertex_index v) { return distance(tree_.mesh().point(v), graph_.point(branch.end)); };
    for(walk_.start(top); walk_.next_distance() < around / pi; walk_.step())
      if(is_of(branch, walk_.last()) && way_to(walk_.last()) > way_to(corner))
        corner = walk_.last();
    return is_beside(tree_.mesh().point(corner)) ? corner : top;
  }

  // Whether a vertex is one of a branch, or of what has been taken off it.
  bool is_of(const Branch& branch, Mesh::Vertex_index v)
  {
    const Index place = graph_.place(v), arc = place - graph_.number_of_nodes();
    if(place >= graph_.number_of_nodes() && is_alive_[arc])
      return std::find(branch.arcs.begin(), branch.arcs.end(), arc) != branch.arcs.end();
    const auto is_in = [&](Index node) {
      return node != branch.end && std::any_of(branch.arcs.begin(), branch.arcs.end(), [&](Index own) {
               return graph_.ends(own)[0] == node || graph_.ends(own)[1] == node;
             });
    };
    return place < graph_.number_of_nodes()
           ? is_in(trunk_of(place))
           : is_in(trunk_of(graph_.ends(arc)[0])) && is_in(trunk_of(graph_.ends(arc)[1]));
  }

  // Whether a branch hardly stands out, if a vertex is its tip. Compares with the trunk: contours of the other arcs near where the
  // branch ends, and what lies between two of them. The tip protrudes from the one that hides it best.
  bool stands_out_little(const Branch& branch, Mesh::Vertex_index tip)
  {
    if(is_beside_large_ball(branch, tip))
      return true;
    const Point& top = tree_.mesh().point(tip);
    std::vector<Index> trunk;
    double radius = 0;
    for(const Index arc : graph_.arcs_of(branch.end))
      if(is_alive_[arc] && arc != branch.arcs.back())
      {
        trunk.push_back(arc);
        radius = (std::max)(radius, graph_.sample_beside(arc, branch.end).shape.radius());
      }
    const double step = radius / 2; // Where the branch leaves the trunk, contours of this lean towards the tip.
    std::vector<Way> ways;
    for(const Index arc : trunk)
      add_ways(arc, branch.end, step, branch.end, 4, ways);
    std::vector<double> lengths;
    for(const Way& way : ways)
      if(way.node == branch.end)
        lengths.push_back(way.sample.shape.length);
    const double protrusion = compare(top, branch.end, ways, step, radius);
    // The trunk's contour at a hand or foot is that of all fingers or toes: each is compared with its own one.
    const double length = graph_.sample_beside(branch.arcs.back(), branch.end).shape.length;
    const double own = std::clamp(length / (2 * pi), radius / 4, radius);
    if(protrusion < ratio_ / 2 * radius || is_across_tube(branch, tip, length)
       || is_corner(branch, tip, trunk, radius, own))
      return true;
    if(protrusion < 5 * ratio_ * radius && is_around_tube(branch.persistence, length, radius, lengths))
      return !is_limb(tip, ratio_ * own, 2 * protrusion, 1.45);
    // Values that are no distances from a tip have extrema anywhere.
    return (!are_values_distances_ || protrusion < ratio_ * radius
            || branch.persistence <= ratio_ * (std::max)(own, 0.75 * radius) || is_bump(tip, branch.persistence))
        && !is_limb(tip, ratio_ * own, 2 * protrusion);
  }

  // Whether a branch is short beside a ball inside of the surface near where it leaves the trunk, or its tip hardly protrudes from
  // that, and it is no limb. Most branches of noise go so, by balls that have been met: contours need not be measured, which can
  // be as long as the surface is large. One that is not of noise has a ball of its own, as another one near can be in its limb.
  bool is_beside_large_ball(const Branch& branch, Mesh::Vertex_index tip)
  {
    const Point& top = tree_.mesh().point(tip);
    const auto protrusion = [&](const Inner_ball& ball) { return distance(top, ball.center) - ball.radius; };
    for(const Inner_ball& ball : balls_)
      if(is_short(branch, ball) && protrusion(ball) < ratio_ * ball.radius)
        return true;
    const Inner_ball ball = tree_.ball_beneath(graph_.vertex(branch.end));
    if(!is_near(branch, ball))
      return false;
    balls_.push_back(ball);
    return (is_short(branch, ball) || protrusion(ball) < ratio_ * ball.radius)
        && (protrusion(ball) < ratio_ / 2 * ball.radius
            || !is_limb(tip, ratio_ / 2 * ball.radius, 2 * protrusion(ball)));
  }

  bool is_near(const Branch& branch, const Inner_ball& ball) const
  {
    return distance(graph_.point(branch.end), ball.center) < 1.5 * ball.radius;
  }

  // Whether a branch is that beside a ball near where it leaves the trunk.
  bool is_short(const Branch& branch, const Inner_ball& ball) const
  {
    return branch.persistence < ratio_ / 2 * ball.radius && is_near(branch, ball);
  }

  // How far a tip protrudes from the balls in the middle of contours on ways from a node, and between two of them, of which the
  // largest at the node gives the radius: fronts about to meet have contours that fold around the tube. Where contours are shared,
  // more are looked for farther away.
  double compare(const Point& tip, Index node, std::vector<Way> ways, double step, double& radius) const
  {
    double protrusion = std::numeric_limits<double>::infinity(), largest = radius;
    const auto add = [&](const Point& center, const Point& hint, bool is_at_node) {
      const double inscribed = tree_.distance_from_wall(center, hint);
      largest = (std::max)(largest, is_at_node ? inscribed : 0);
      protrusion = (std::min)(protrusion, distance(tip, center) - inscribed);
    };
    bool is_any_shared = true;
    for(int turn = 0; turn != 3 && is_any_shared; ++turn)
    {
      is_any_shared = false;
      std::vector<Contour_sample> samples, farther;
      for(Way& way : ways)
      {
        samples.push_back(way.sample);
        farther.push_back(sample_farther(way.arc, way.node, way.distance + 2 * step));
        if(turn == 0)
          add(way.sample.shape.centroid, way.sample.on_surface, way.node == node);
        if(turn != 2 && is_shared(way.sample))
        {
          way.distance *= 2;
          way.sample = sample_farther(way.arc, way.node, way.distance);
          is_any_shared = true;
        }
      }
      for(std::size_t i = 1; i < samples.size(); ++i)
        for(std::size_t j = 0; j != i; ++j)
          if((std::max)(samples[i].shape.radius(), samples[j].shape.radius())
             > radius / 3) // Two fingers hide none between them.
            for(const Point& middle : middles(samples[j], farther[j], samples[i], farther[i]))
              if(turn == 0 || tree_.is_inside(middle))
                add(middle, samples[i].on_surface, turn == 0 && ways[i].node == node && ways[j].node == node);
    }
    radius = largest;
    return protrusion;
  }

  // Whether a ball touches both ends of a branch, and the contour where it leaves the trunk goes around the ball on both
  // sides: the fronts that part or meet there are two sections of one tube.
  bool is_across_tube(const Branch& branch, Mesh::Vertex_index tip, double contour_length) const
  {
    const Point &top = tree_.mesh().point(tip), &bottom = graph_.point(branch.end);
    const double inscribed = tree_.distance_from_wall(CGAL::midpoint(top, bottom), top);
    return distance(top, bottom) / 2 < (1 + ratio_ / 2) * inscribed && contour_length > 3 * pi * inscribed;
  }

  // Whether a branch is hardly longer than the way around half of the trunk, where the front from its tip meets itself: the contour
  // there is two sections of the trunk. So it is from corners of what is bent, and from edges along it.
  bool is_around_tube(double persistence,
                      double contour_length,
                      double radius,
                      const std::vector<double>& lengths_of_trunk) const
  {
    const double sum = std::accumulate(lengths_of_trunk.begin(), lengths_of_trunk.end(), 0.);
    double least = contour_length;
    for(const double length : lengths_of_trunk)
      least = (std::min)(least, length);
    return contour_length > (std::max)(0.85 * sum, 3 * pi * radius) && persistence < (1 + ratio_ / pi) * least / 2;
  }

  struct Limb_section
  {
    Point center;
    Vector along; // of length 1
    double width; // from the center
  };

  // Whether a tip is the corner of a bend: if two limbs of the trunk about as thick as the branch went straight on, at an angle, it
  // would hardly stand out from each of them, but is across both from where they meet.
  bool is_corner(const Branch& branch,
                 Mesh::Vertex_index tip,
                 const std::vector<Index>& trunk,
                 double radius,
                 double own) const
  {
    const double cosine_of_30 = 0.866;
    const Point &top = tree_.mesh().point(tip), &bottom = graph_.point(branch.end);
    std::vector<Vector> directions;
    for(std::size_t i = 0; i != trunk.size() && directions.size() + trunk.size() - i > 1; ++i)
    {
      const auto limb = thinnest_section(trunk[i], branch.end, radius, top);
      if(limb && (std::max)(limb->width, own) < 2 * (std::min)(limb->width, own)
         && distance(top, bottom) > 1.1 * limb->width && is_hidden(top, *limb))
        directions.push_back((top - limb->center) * limb->along > 0 ? limb->along : -limb->along);
    }
    for(const Vector& u : directions)
      for(const Vector& v : directions)
        if(u * v < cosine_of_30)
          return true;
    return false;
  }

  // Whether a point would hardly stand out from a limb that went straight on, and that can go on so till near the point.
  bool is_hidden(const Point& p, const Limb_section& limb) const
  {
    const Vector way = p - limb.center;
    const double height = way * limb.along, straight = std::abs(height) - 2.5 * limb.width;
    return length(cross_product(way, limb.along)) < (1 + 0.4 * ratio_) * limb.width
        && !(straight > 0
             && tree_.is_crossed({limb.center}, {limb.center + (height > 0 ? straight : -straight) * limb.along}));
  }

  // A section of the limb of an arc where it is thinnest near a node, on the way to a tip.
  std::optional<Limb_section> thinnest_section(Index arc, Index node, double radius, const Point& tip) const
  {
    std::optional<Limb_section> result;
    for(const double share : {0.15, 0.3, 0.5, 0.7})
    {
      const Contour_sample sample = sample_farther(arc, node, 6 * share * radius, share),
                           farther = sample_farther(arc, node, 8 * share * radius, share + 0.2);
      const Vector to_tip = tip - sample.shape.centroid;
      for(const Vector& start : {sample.shape.centroid - farther.shape.centroid, sample.shape.area})
      {
        const auto section = section_across(sample, start * to_tip > 0 ? start : -start);
        if(section && !(result && section->width > 0.95 * result->width))
          result = section;
      }
    }
    return result;
  }

  // A section across a limb that is as thick a radius behind, at a contour of the field. That leans: one that is across has its
  // center in front of the one of another one behind.
  std::optional<Limb_section> section_across(const Contour_sample& sample, Vector along) const
  {
    const double cosine_of_1 = 0.99985;
    Point center = sample.shape.centroid;
    for(int turn = 0; along != NULL_VECTOR; ++turn)
    {
      along = along / length(along);
      const Plane_contour here(tree_, center, along, sample.on_surface);
      if(!here.radius())
        return std::nullopt;
      center = here.centroid();
      const double radius = *here.radius();
      const auto behind = [&](double share) {
        return Plane_contour(tree_, center - share * radius * along, along, sample.on_surface);
      };
      const Plane_contour other = behind(0.25);
      const Vector next = other.radius() ? center - other.centroid() : Vector(NULL_VECTOR);
      if(turn == 4 || next * along > cosine_of_1 * length(next))
      {
        const auto thickness = behind(1).radius();
        if(!thickness || std::abs(*thickness - radius) > 0.5 * radius || !here.is_across_tube()
           || distance(center, sample.shape.centroid) > here.extent())
          return std::nullopt;
        return Limb_section{center, along, here.extent()};
      }
      along = next;
    }
    return std::nullopt;
  }

  // Adds a way, and, if the arc ends before it, or soon behind a contour that fronts share, the first ones on from there: where a
  // loop joins a limb, fronts that have met are arcs behind a short one. None comes back to where they begin.
  void add_ways(Index arc, Index node, double distance, Index begin, int most_arcs, std::vector<Way>& ways) const
  {
    ways.push_back({arc, node, distance, sample_farther(arc, node, distance)});
    const Index next = graph_.other_end(arc, node);
    const double left = distance - size(arc);
    if(most_arcs == 0 || next == begin || !(left + 2 * distance > 0) || !(left > 0 || is_shared(ways.back().sample)))
      return;
    for(const Index other : graph_.arcs_of(next))
      if(is_alive_[other] && other != arc)
      {
        const double radius = graph_.sample_beside(other, next).shape.radius(), most = left > 0 ? left : distance;
        add_ways(other, next, degrees_[next] == 2 ? most : (std::min)(most, radius / 2), begin, most_arcs - 1, ways);
      }
  }

  bool is_shared(const Contour_sample& sample) const
  {
    return sample.shape.length > 3 * pi * tree_.distance_from_wall(sample.shape.centroid, sample.on_surface);
  }

  double size(Index arc) const
  {
    return std::abs(graph_.value(graph_.ends(arc)[1]) - graph_.value(graph_.ends(arc)[0]));
  }

  // A contour on the way from a node along an arc, and on through nodes with two arcs, about a distance away, before a share of
  // the last arc.
  Contour_sample sample_farther(Index arc, Index node, double distance, double most = 0.5) const
  {
    double passed = 0;
    while(true)
    {
      const double size = this->size(arc);
      const bool is_upwards = graph_.ends(arc)[0] == node;
      const Index next = graph_.other_end(arc, node);
      if(passed + size >= distance || degrees_[next] != 2)
      {
        const double t = size > 0 ? (std::min)((distance - passed) / size, most) : most;
        return graph_.sample(arc, is_upwards ? t : 1 - t);
      }
      passed += size;
      node = next;
      Index other = arc;
      for(const Index candidate : graph_.arcs_of(next))
        if(is_alive_[candidate] && candidate != arc)
          other = candidate;
      arc = other;
    }
  }

  // The middle between two contours, straight, and on a curve that goes on as the trunk does.
  static std::vector<Point> middles(const Contour_sample& a,
                                    const Contour_sample& behind_a,
                                    const Contour_sample& b,
                                    const Contour_sample& behind_b)
  {
    const Point &p = a.shape.centroid, &q = b.shape.centroid;
    const Vector from_p = p - behind_a.shape.centroid, from_q = q - behind_b.shape.centroid;
    std::vector<Point> result = {CGAL::midpoint(p, q)};
    if(length(from_p) > 0 && length(from_q) > 0)
      result.push_back(result[0] + distance(p, q) / 8 * (from_p / length(from_p) + from_q / length(from_q)));
    return result;
  }

  // Whether a tip hardly protrudes from a ball beneath it that is larger than the branch, as those do that the front
  // leaves on a large body, where contours between limbs are small.
  bool is_bump(Mesh::Vertex_index tip, double persistence) const
  {
    const auto inwards = tree_.inward_direction(tip);
    const double depth = tree_.depth_beneath(tip, inwards);
    const int number_of_steps = 8;
    for(int i = 1; i != number_of_steps; ++i)
    {
      const double step = depth * i / number_of_steps;
      const Point center = tree_.mesh().point(tip) + step * inwards;
      const double inscribed = tree_.distance_from_wall(center, tree_.mesh().point(tip));
      if(step - inscribed < ratio_ / 2 * inscribed && persistence < 2 * ratio_ * inscribed)
        return true;
    }
    return false;
  }

  // Whether what is nearer to a tip than some distance is about as long as it is wide. The persistence of a limb that the front
  // passes across, or reaches from two sides, tells nothing of its length. Spikes of noise have edges as long as they are. At a corner
  // of what is bent by a right angle, what is on both sides is 1.4 times as wide as far.
  bool is_limb(Mesh::Vertex_index tip, double least, double most, double most_width = Edge_walk::width_of_limb)
  {
    const double fineness = 0.4; // of the edges: at most this share of the limb's length
    walk_.start(tip);
    for(double d = (std::max)(least, most / 16); d > 0 && d <= most; d *= 1.1)
    {
      while(walk_.next_distance() <= d && walk_.longest_edge() < fineness * most)
        walk_.step();
      if(!std::isfinite(walk_.next_distance()) || walk_.longest_edge() >= fineness * most)
        return false;
      if(walk_.longest_edge() < fineness * d && walk_.width_by_distance() < most_width)
        return true;
    }
    return false;
  }

  void remove(Index tip)
  {
    Branch& branch = branches_[tip];
    const Index end = branch.end;
    for(const Index arc : branch.arcs)
    {
      is_alive_[arc] = false;
      for(const Index node : graph_.ends(arc))
        if(node != end)
        {
          redirections_[node] = end;
          degrees_[node] = 0;
        }
    }
    branch.arcs.clear();
    if(--degrees_[end] != 2)
      return;
    const std::vector<Index> waiting = std::exchange(waiting_[end], {});
    for(const Index other : waiting)
      grow(other);
  }

  const Sampled_graph& graph_;
  const Surface_tree& tree_;
  const double ratio_;
  const bool are_values_distances_;
  const std::vector<bool>& is_border_; // by node, whether it is an end by force
  const Stage_progress progress_;
  std::vector<bool> is_alive_; // by arc
  std::vector<Index> degrees_;
  std::vector<Index> redirections_;         // of nodes that have gone
  std::vector<Branch> branches_;            // of tips
  std::vector<std::vector<Index>> waiting_; // the tips whose branches end at a node, and stay
  std::priority_queue<Entry, std::vector<Entry>, std::greater<Entry>> queue_;
  Edge_walk walk_;
  std::vector<Inner_ball> balls_; // those that have been met
};

} // namespace CGAL::Reeb_graph::internal::skeleton

#endif // CGAL_REEB_GRAPH_SKELETON_INTERNAL_BRANCH_PRUNING_H
