// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_TEST_QUADRUPED_SAMPLES_H
#define CGAL_REEB_GRAPH_TEST_QUADRUPED_SAMPLES_H

#include "random_meshes.h"
#include "shuffle.h"
#include "tube_samples.h"

#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

// Animals on four legs, whose ends a person counts.
namespace quadruped_samples {
using generated_surfaces::Triangle_soup;
using tube_samples::Point;

// The tubes of an animal, and the tips that it has.
struct Quadruped
{
  tube_samples::Tubes body;
  std::vector<Point> tips;
};

// An animal that looks along x, and stands on z = 0, about four units long: four legs, of which the hind ones are mirrored, a
// belly thicker than they are, a neck with a snout, two horns or none, two ears or none, and a tail or none. What is an end
// is at least twice as long as it is thick.
inline Quadruped quadruped(std::size_t seed)
{
  random_meshes::Random random(seed);
  const auto between = [&](double low, double high) {
    return low + (high - low) * static_cast<double>(random.below(100001)) / 1e5;
  };
  Quadruped animal;
  const auto add = [&](const Point& from, const Point& to, double radius_from, double radius_to) {
    animal.body.tubes.push_back({from, to, radius_from, radius_to});
  };
  const auto add_tip = [&](const Point& from, const Point& to, double radius) {
    const double length = tube_samples::distance(from, to);
    animal.tips.push_back(tube_samples::between(from, to, 1 + radius / length));
  };
  const double height = between(1.2, 1.8), belly = between(.42, .62), chest = between(.36, .52);
  const Point hips = {-1.1, 0, height}, middle = {0, 0, height - between(0, .12)}, shoulders = {1.1, 0, height};
  const double rump = between(.36, .5);
  add(hips, middle, rump, belly);
  add(middle, shoulders, belly, chest);
  const double leg = between(.13, .2), foot = between(.1, .16);
  for(const bool is_hind : {true, false})
  {
    const double apart = between(.22, .34), splay = between(0, .12), knee = between(-.15, .2);
    for(const double side : {-1., 1.})
    {
      const double skew = is_hind ? 0 : between(-.25, .25); // The front legs walk.
      const double x = is_hind ? -1.1 : 1.05;
      const Point hip = {x, side * apart, height - .15};
      const Point middle_of_leg = {x + (is_hind ? -knee : knee) / 2 + skew / 2, side * (apart + splay / 2), height / 2};
      const Point toe = {x + skew, side * (apart + splay), foot};
      add(hip, middle_of_leg, leg * 1.2, leg);
      add(middle_of_leg, toe, leg, foot);
      add_tip(middle_of_leg, toe, foot);
    }
  }
  const double raised = between(.3, .9);
  const Point nape = {1.1 + between(.5, .8), 0, height + raised};
  const double neck = between(.2, .3), head = between(.2, .28);
  add({1.15, 0, height + .05}, nape, neck * 1.2, neck);
  const Point snout = {nape[0] + between(.55, .8), 0, nape[2] - between(.1, .35)};
  add(nape, snout, head, head * between(.55, .8));
  add_tip(nape, snout, animal.body.tubes.back().radius_to);
  const auto add_pair = [&](double thick, double long_at_least, double long_at_most, double forwards, double aside,
                            double up) {
    const double length = between(long_at_least, long_at_most) + head;
    const double size = std::sqrt(forwards * forwards + aside * aside + up * up);
    for(const double side : {-1., 1.})
    {
      const Point tip = {nape[0] + length * forwards / size, side * length * aside / size,
                         nape[2] + length * up / size};
      add(nape, tip, thick * 1.15, thick * .8);
      add_tip(nape, tip, thick * .8);
    }
  };
  if(random.below(4) != 0)
    add_pair(between(.1, .13), .35, .7, between(.2, .5), between(.35, .6), 1); // horns
  if(random.below(4) != 0)
    add_pair(between(.1, .13), .35, .5, between(-.7, -.4), 1, between(-.1, .15)); // ears
  if(random.below(4) != 0)
  {
    const double thick = between(.08, .12);
    const Point root = {-1.2, 0, height + .1}, bend = {-1.6 - between(.1, .3), 0, height + between(-.1, .3)};
    const Point tip = {bend[0] - between(.1, .5), between(-.2, .2), height - between(.3, .8)};
    add(root, bend, thick * 1.3, thick);
    add(bend, tip, thick, thick * .8);
    add_tip(bend, tip, thick * .8);
  }
  animal.body.ends = animal.tips.size();
  animal.body.cell_size = between(.06, .075);
  return animal;
}

// Its surface: with noise of 1 % of the radii, mirrored, and in any order, as the seed has it.
inline Triangle_soup surface(Quadruped& animal, std::size_t seed)
{
  Triangle_soup soup = tube_samples::surface(animal.body, 0.01, seed);
  if(seed % 2 == 1)
  {
    for(Point& p : soup.points)
      p[1] = -p[1];
    for(Point& p : animal.tips)
      p[1] = -p[1];
    for(auto& triangle : soup.triangles)
      std::swap(triangle[0], triangle[1]);
  }
  random_meshes::Random random(seed);
  generated_surfaces::shuffle(soup, random);
  return soup;
}

} // namespace quadruped_samples

#endif // CGAL_REEB_GRAPH_TEST_QUADRUPED_SAMPLES_H
