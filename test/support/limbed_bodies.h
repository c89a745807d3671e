// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_TEST_LIMBED_BODIES_H
#define CGAL_REEB_GRAPH_TEST_LIMBED_BODIES_H

#include "generated_surfaces/implicit_surface.h"
#include "random_meshes.h"
#include "tube_samples.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

// Bodies with limbs that a person counts: blended tubes whose ends are known. Quadrupeds, whose limbs come in mirrored pairs, and
// plain things.
namespace limbed_bodies {
using generated_surfaces::Triangle_soup;
using tube_samples::Point;
using tube_samples::Tube;

// Where a limb ends, and how near to that a tip of a skeleton is its one.
struct End
{
  Point tip;
  double reach;
};

struct Body
{
  std::string name;
  std::vector<Tube> tubes;
  std::vector<End> ends;
  std::vector<End> disputed; // what one person counts, and another one does not
  double blend = 0.06;
  double cell_size = 0.2;

  // A limb out of the body: a tube, or several ones in a row.
  void add_limb(const std::vector<Point>& joints, double radius, double tip_radius, bool is_disputed = false)
  {
    const double count = static_cast<double>(joints.size() - 1);
    double length = 0;
    for(std::size_t i = 1; i != joints.size(); ++i)
    {
      const double before = static_cast<double>(i - 1) / count, after = static_cast<double>(i) / count;
      tubes.push_back(
        {joints[i - 1], joints[i], radius + before * (tip_radius - radius), radius + after * (tip_radius - radius)});
      length += tube_samples::distance(joints[i - 1], joints[i]);
    }
    const Point& last = joints.back();
    const Point& previous = joints[joints.size() - 2];
    const double size = tube_samples::distance(previous, last);
    (is_disputed ? disputed : ends)
      .push_back({tube_samples::between(previous, last, 1 + tip_radius / size),
                  std::max({1.6 * tip_radius, 0.4 * length, 1.5 * cell_size})});
  }

  // Negative inside: a soft minimum, which is the same for a mirrored body.
  double distance_from(const Point& p) const
  {
    double least = tube_samples::distance_from(tubes, p), sum = 0;
    std::vector<double> shares;
    for(const Tube& tube : tubes)
      if(const double more = (tube.distance_to(p) - least) / blend; more < 30)
        shares.push_back(std::exp(-more));
    std::sort(shares.begin(), shares.end());
    for(const double share : shares)
      sum += share;
    return least - blend * std::log(sum);
  }
};

inline Triangle_soup surface(const Body& body)
{
  const auto function = [&](const Point& p) { return body.distance_from(p); };
  Point lowest = body.tubes[0].from, highest = lowest;
  for(const Tube& tube : body.tubes)
    for(std::size_t i = 0; i != 3; ++i)
    {
      const double reach = std::max(tube.radius_from, tube.radius_to) + 4 * body.blend + 2 * body.cell_size;
      lowest[i] = std::min({lowest[i], tube.from[i] - reach, tube.to[i] - reach});
      highest[i] = std::max({highest[i], tube.from[i] + reach, tube.to[i] + reach});
    }
  generated_surfaces::internal::Marching_tetrahedra marching(function, lowest, highest, body.cell_size);
  Triangle_soup soup = marching.take_surface();
  generated_surfaces::internal::smooth(soup, function, 3);
  return soup;
}

// With points moved by up to a distance along each axis.
inline Triangle_soup surface(const Body& body, double noise, std::size_t seed)
{
  Triangle_soup soup = surface(body);
  random_meshes::Random random(seed);
  for(Point& p : soup.points)
    for(double& coordinate : p)
      coordinate += noise * (static_cast<double>(random.below(1001)) / 500 - 1);
  return soup;
}

class Dice
{
public:
  explicit Dice(std::size_t seed) : random_(seed) {}
  double in(double least, double most)
  {
    return least + (most - least) * static_cast<double>(random_.below(1001)) / 1000;
  }
  bool toss() { return random_.below(2) == 0; }
  std::size_t below(std::size_t bound) { return random_.below(bound); }

private:
  random_meshes::Random random_;
};

// Limbs are longer than they are thick. A head with ears or horns is an end for some, if it has no long muzzle.
inline Body quadruped(std::size_t seed)
{
  Dice dice(seed);
  Body body;
  body.name = "quadruped";
  body.cell_size = dice.in(0.15, 0.19);
  const double length = dice.in(2.2, 4.5), radius = dice.in(0.8, 1.1), rear = radius * dice.in(0.8, 1.2);
  body.tubes.push_back({{-length / 2, 0, 0}, {length / 2, 0, 0}, rear, radius});
  if(dice.toss()) // a belly
    body.tubes.push_back({{-length / 8, 0, -0.1}, {length / 8, 0, -0.1}, radius * 1.2, radius * 1.2});
  const double thickest = 1.3 * std::max(radius, rear);
  const double leg_radius = dice.in(0.25, 0.4), foot_radius = leg_radius * dice.in(0.7, 1.1);
  const double leg = thickest + std::max(leg_radius, foot_radius) * dice.in(2.2, 6), stance = dice.in(0, 0.5);
  const double bend = dice.in(-0.3, 0.3);
  for(const double x : {-length / 2, length / 2})
    for(const double side : {-1., 1.})
    {
      const double hip = side * std::max((x < 0 ? rear : radius) * 0.6, leg_radius + 0.25), foot = hip + side * stance;
      body.add_limb({{x, hip, 0}, {x + bend, (hip + foot) / 2, -leg / 2}, {x, foot, foot_radius - leg}}, leg_radius,
                    foot_radius);
    }
  const double neck = dice.in(0.3, 1.5), lift = dice.in(0.3, 1.3), head = dice.in(0.6, 0.8);
  const Point middle = {length / 2 + (radius + neck) * std::cos(lift), 0, (radius + neck) * std::sin(lift)};
  body.tubes.push_back({{length / 2, 0, 0}, middle, radius * 0.7, head * 0.8});
  const bool has_horns = dice.toss(), has_ears = !has_horns || dice.toss(), has_muzzle = dice.toss();
  const double muzzle = has_muzzle ? dice.in(2, 2.8) * head : 0.4 * head;
  body.add_limb({middle, {middle[0] + muzzle, 0, middle[2] - 0.3 * muzzle}}, head, has_muzzle ? head * 0.6 : head * 0.9,
                !has_muzzle);
  if(has_muzzle)
    body.ends.back().reach = std::max(body.ends.back().reach, 0.8 * head);
  const double ear_radius = dice.in(0.2, 0.25), ear = head + 3 * ear_radius * dice.in(1, 1.8);
  const double horn_radius = dice.in(0.19, 0.23), horn = head + 4 * horn_radius * dice.in(1, 2);
  for(const double side : {-1., 1.})
  {
    if(has_ears)
      body.add_limb({middle, {middle[0] - 0.3 * ear, side * 0.9 * ear, middle[2] + (has_horns ? 0.1 : 0.4) * ear}},
                    ear_radius, ear_radius * 0.9);
    if(has_horns)
      body.add_limb({middle, {middle[0] + 0.1 * horn, side * 0.5 * horn, middle[2] + 0.87 * horn}}, horn_radius,
                    horn_radius * 0.85);
  }
  const double tail_radius = dice.in(0.19, 0.25), tail = tail_radius * dice.in(4, 9);
  if(dice.toss())
    body.add_limb({{-length / 2, 0, 0.3 * rear},
                   {-length / 2 - 1.05 * rear, 0, 0.5 * rear},
                   {-length / 2 - 1.05 * rear - tail, 0, 0.5 * rear - tail * dice.in(-0.5, 0.5)}},
                  tail_radius, tail_radius);
  return body;
}

// Four short legs on a thick belly, whose roots are reached from two sides at once.
inline Body short_legged(std::size_t seed)
{
  Dice dice(seed);
  Body body;
  body.name = "short-legged";
  body.cell_size = 0.18;
  body.blend = 0.04;
  const double length = dice.in(1, 4), radius = dice.in(0.9, 1.3), leg_radius = dice.in(0.25, 0.35);
  body.tubes.push_back({{-length / 2, 0, 0}, {length / 2, 0, 0}, radius, radius});
  for(const double side : {-1., 1.})
  {
    body.disputed.push_back({{side * (length / 2 + radius), 0, 0}, radius});
    for(const double x : {-1., 1.})
      body.add_limb({{x * length / 2, side * 0.4 * radius, 0},
                     {x * (length / 2 + 0.1), side * (0.4 * radius + 0.3), -radius - leg_radius * dice.in(2, 3.5)}},
                    leg_radius, leg_radius);
  }
  return body;
}

// A thin branch on a thick trunk that is not much longer than a way around it.
inline Body thin_branched(std::size_t seed)
{
  Dice dice(seed);
  Body body;
  body.name = "thin branch";
  body.blend = 0.03;
  const double half = dice.in(1.8, 3), radius = dice.in(0.2, 0.4), lean = dice.in(1.05, 1.57),
               length = dice.in(2.5, 3.5), x = half * dice.in(-0.3, 0.3);
  body.cell_size = std::min(0.2, radius / 1.1);
  body.tubes.push_back({{-half, 0, 0}, {half, 0, 0}, 1, 1});
  for(const double side : {-1., 1.})
    body.ends.push_back({{side * (half + 1), 0, 0}, 1.6});
  body.add_limb({{x, 0, 0}, {x + length * std::cos(lean), 0, length * std::sin(lean)}}, radius, radius);
  return body;
}

} // namespace limbed_bodies

#endif // CGAL_REEB_GRAPH_TEST_LIMBED_BODIES_H
