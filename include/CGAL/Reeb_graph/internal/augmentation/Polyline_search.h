// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_INTERNAL_AUGMENTATION_POLYLINE_SEARCH_H
#define CGAL_REEB_GRAPH_INTERNAL_AUGMENTATION_POLYLINE_SEARCH_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/internal/augmentation/Level_set_component.h>
#include <CGAL/Reeb_graph/internal/base/Index.h>

#include <cstddef>
#include <numeric>
#include <vector>

namespace CGAL {
namespace Reeb_graph {
namespace internal {

// Splits the lines of a component of a level set into polylines, which end where not exactly two lines meet.
class Polyline_search
{
public:
  typedef std::vector<std::size_t> Polyline; // the numbers of its points

  explicit Polyline_search(const Level_set_component& component)
    : lines_(component.lines),
      first_of_points_(component.edges.size() + 1, 0),
      lines_of_points_(2 * lines_.size()),
      is_used_(lines_.size(), false)
  {
    for(const Line& line : lines_)
      for(const Number point : line)
        ++first_of_points_[point + 1];
    std::partial_sum(first_of_points_.begin(), first_of_points_.end(), first_of_points_.begin());
    std::vector<std::size_t> places(first_of_points_);
    for(std::size_t line = 0; line != lines_.size(); ++line)
      for(const Number point : lines_[line])
        lines_of_points_[places[point]++] = line;
  }

  std::vector<std::size_t> branch_points() const
  {
    std::vector<std::size_t> result;
    for(std::size_t point = 0; point != number_of_points(); ++point)
    {
      if(number_of_lines(point) > 2)
        result.push_back(point);
    }
    return result;
  }

  // The polylines from branch points and points of the border, in the order of their first points, or the only one, if
  // the component is a closed curve.
  std::vector<Polyline> find_polylines()
  {
    std::vector<Polyline> result;
    for(std::size_t point = 0; point != number_of_points(); ++point)
    {
      if(number_of_lines(point) != 2)
        follow_lines(point, result);
    }
    if(result.empty() && !lines_.empty())
      result.push_back(follow(0, lines_of_points_[0]));
    return result;
  }

private:
  typedef Level_set_component::Line Line;

  std::size_t number_of_points() const { return first_of_points_.size() - 1; }
  std::size_t number_of_lines(std::size_t point) const { return first_of_points_[point + 1] - first_of_points_[point]; }

  void follow_lines(std::size_t point, std::vector<Polyline>& polylines)
  {
    for(std::size_t i = first_of_points_[point]; i != first_of_points_[point + 1]; ++i)
    {
      if(!is_used_[lines_of_points_[i]])
        polylines.push_back(follow(point, lines_of_points_[i]));
    }
  }

  Polyline follow(std::size_t first_point, std::size_t line)
  {
    Polyline polyline = {first_point};
    for(;;)
    {
      is_used_[line] = true;
      const std::size_t point = lines_[line][lines_[line][0] == polyline.back() ? 1 : 0];
      polyline.push_back(point);
      if(point == first_point || number_of_lines(point) != 2)
        return polyline;
      const std::size_t first = first_of_points_[point];
      line = lines_of_points_[lines_of_points_[first] == line ? first + 1 : first];
    }
  }

  const std::vector<Line>& lines_;
  std::vector<std::size_t> first_of_points_; // in lines_of_points_; and the end
  std::vector<std::size_t> lines_of_points_;
  std::vector<bool> is_used_;
};

} // namespace internal
} // namespace Reeb_graph
} // namespace CGAL

#endif // CGAL_REEB_GRAPH_INTERNAL_AUGMENTATION_POLYLINE_SEARCH_H
