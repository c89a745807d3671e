// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors
#ifndef CGAL_REEB_GRAPH_SKELETON_MEASURE_BRANCHES_H
#define CGAL_REEB_GRAPH_SKELETON_MEASURE_BRANCHES_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/internal/base/lengths.h>
#include <CGAL/Reeb_graph/skeleton/Curve_skeleton.h>
#include <CGAL/Reeb_graph/skeleton/internal/Junction_balls.h>
#include <CGAL/Reeb_graph/skeleton/skeleton_trees.h>

#include <CGAL/boost/graph/iterator.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL::Reeb_graph {

/// \addtogroup PkgReebGraphSkeleton
/// @{

/// \brief what is measured of an arc of a curve skeleton, as a branch of a tree.
///
/// Radii are those of the part that lies in no junction, if there is one.
struct Skeleton_branch
{
  /// no branch
  static constexpr std::size_t none = Skeleton_record::none;

  std::size_t component = 0;       ///< the number of its tree
  std::size_t parent = none;       ///< the branch that leads to it, `none` at a root
  std::size_t depth = 0;           ///< how many branches lead to it
  std::size_t order = 0;           ///< the Strahler number
  std::size_t first = 0, last = 0; ///< the ends of the arc
  double length = 0;
  double tortuosity =
    std::numeric_limits<double>::quiet_NaN(); ///< the length over the distance of the ends, if these differ
  double radius = 0;                          ///< the mean by length
  double least_radius = 0, greatest_radius = 0;
  double inscribed_radius = 0; ///< the mean by length
  double area =
    std::numeric_limits<double>::quiet_NaN(); ///< that of its faces: `measure_branch_faces()` sets what follows
  double volume = std::numeric_limits<double>::quiet_NaN();          ///< that of the solid between its faces
  double junction_area = std::numeric_limits<double>::quiet_NaN();   ///< how much of the area lies in junctions
  double junction_volume = std::numeric_limits<double>::quiet_NaN(); ///< how much of the volume does
};

/// @}

namespace internal::skeleton {

// Of each branch of the trees: the component, parent, depth, and Strahler number.
inline void place_branches(const std::vector<Skeleton_record>& records, std::vector<Skeleton_branch>& branches)
{
  constexpr std::size_t none = Skeleton_branch::none;
  std::vector<bool> is_placed(branches.size(), false);
  std::size_t number_of_components = 0;
  for(const Skeleton_record& record : records)
  {
    number_of_components += record.parent == none ? 1 : 0;
    if(record.arc == none || is_placed[record.arc])
      continue;
    is_placed[record.arc] = true;
    Skeleton_branch& branch = branches[record.arc];
    branch.component = number_of_components - 1;
    branch.parent = records[record.parent].arc;
    branch.depth = branch.parent == none ? 0 : branches[branch.parent].depth + 1;
  }
  const std::vector<std::size_t> orders = strahler_orders(records);
  for(std::size_t i = 0; i != records.size(); ++i)
    if(records[i].arc != none)
      branches[records[i].arc].order = (std::max)(branches[records[i].arc].order, orders[i]);
}

// Within junctions, radii are those where the arc leaves them, and have no weight in means.
template <class CurveSkeleton>
Skeleton_branch measure_branch(const CurveSkeleton& skeleton,
                               const Junction_balls<CurveSkeleton>& balls,
                               std::size_t number)
{
  const std::vector<std::size_t>& arc = balls.arcs()[number];
  const std::size_t begin = balls.number_inside(number, false), rest = balls.number_inside(number, true);
  const std::size_t first = begin + rest < arc.size() ? begin : 0;
  const std::size_t last = begin + rest < arc.size() ? arc.size() - 1 - rest : arc.size() - 1;
  const auto point = [&](std::size_t i) -> const auto& { return skeleton[arc[std::clamp(i, first, last)]]; };
  const auto radius = [&](std::size_t i) { return point(i).radius; };
  Skeleton_branch branch;
  branch.first = arc.front();
  branch.last = arc.back();
  branch.radius = branch.least_radius = branch.greatest_radius = radius(0);
  branch.inscribed_radius = point(0).inscribed_radius; // of an arc without length
  double weight = 0;
  for(std::size_t i = 0; i + 1 != arc.size(); ++i)
    weight += balls.share_outside(number, i);
  const bool are_all_inside = !(weight > 0);
  weight = 0;
  for(std::size_t i = 0; i + 1 != arc.size(); ++i)
  {
    const double length = distance_between(skeleton[arc[i]].point, skeleton[arc[i + 1]].point);
    const double part = are_all_inside ? length : length * balls.share_outside(number, i);
    const double r = radius(i), s = radius(i + 1);
    weight += part;
    const double share =
      part > 0 ? part / weight : 0; // of the mean, as products of two lengths overflow in large units
    branch.length += length;
    branch.radius += share * ((r + s) / 2 - branch.radius);
    branch.inscribed_radius +=
      share * ((point(i).inscribed_radius + point(i + 1).inscribed_radius) / 2 - branch.inscribed_radius);
    branch.least_radius = (std::min)(branch.least_radius, s);
    branch.greatest_radius = (std::max)(branch.greatest_radius, s);
  }
  const double distance = distance_between(skeleton[arc.front()].point, skeleton[arc.back()].point);
  if(distance > 0)
    branch.tortuosity = branch.length / distance;
  return branch;
}

} // namespace internal::skeleton

/// \ingroup PkgReebGraphSkeleton
///
/// \brief sets `is_in_junction` of the vertices and edges of a curve skeleton, as `extract_curve_skeleton()` does. It takes
/// linear time.
///
/// \param skeleton a curve skeleton, whose edges have the arcs, in their order
template <class CurveSkeleton>
void mark_junctions(CurveSkeleton& skeleton)
{
  const internal::skeleton::Junction_balls<CurveSkeleton> balls(skeleton);
  auto e = edges(skeleton).first; // which are in the order of the arcs
  for(std::size_t arc = 0; arc != balls.arcs().size(); ++arc)
  {
    const std::vector<std::size_t>& points = balls.arcs()[arc];
    for(std::size_t i = 0; i != points.size(); ++i)
      if(i < balls.number_inside(arc, false) || points.size() - i <= balls.number_inside(arc, true))
        skeleton[points[i]].is_in_junction = true;
    for(std::size_t i = 0; i + 1 != points.size(); ++i)
      skeleton[*e++].is_in_junction = balls.share_outside(arc, i) < 0.5;
  }
}

/// \ingroup PkgReebGraphSkeleton
///
/// \brief measures each arc of a curve skeleton, as a branch of the trees that `skeleton_trees()` makes, but for areas and volumes. It
/// takes linear time.
///
/// \param skeleton a curve skeleton, as it has been extracted
/// \param trees its trees
template <class CurveSkeleton>
std::vector<Skeleton_branch> measure_branches(const CurveSkeleton& skeleton, const std::vector<Skeleton_record>& trees)
{
  const internal::skeleton::Junction_balls<CurveSkeleton> balls(skeleton);
  std::vector<Skeleton_branch> branches;
  for(std::size_t arc = 0; arc != balls.arcs().size(); ++arc)
    branches.push_back(internal::skeleton::measure_branch(skeleton, balls, arc));
  internal::skeleton::place_branches(trees, branches);
  return branches;
}

} // namespace CGAL::Reeb_graph

#endif // CGAL_REEB_GRAPH_SKELETON_MEASURE_BRANCHES_H
