// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#include "input/merge_points.h"

#include "input/close_points.h"
#include "input/find_duplicates.h"
#include "input/pair_faces.h"
#include "input/repeated_vertex.h"
#include "input/soup_counts.h"

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <utility>
#include <vector>

namespace reeb_graph_program {
namespace {
// Polygons of other vertices, without those that have one of them twice, and once what is there several times.
struct Joined_polygons
{
  Joined_polygons(const Polygons& given, const std::vector<Corner>& vertices)
  {
    Polygons all;
    std::vector<std::size_t> numbers;
    std::vector<Corner> corners, sorted;
    for(std::size_t i = 0; i < given.size(); ++i)
    {
      corners.clear();
      for(const Corner v : given[i])
        corners.push_back(vertices[v]);
      if(find_repeated_vertex(Polygons::Polygon(corners.data(), corners.data() + corners.size()), sorted))
        continue;
      all.add(corners);
      numbers.push_back(i);
    }
    const std::vector<std::size_t> repeated = find_duplicates(all, true).numbers;
    for(std::size_t i = 0; i < all.size(); ++i)
      if(!std::binary_search(repeated.begin(), repeated.end(), i))
      {
        polygons.add(all[i]);
        corners_given.insert(corners_given.end(), given[numbers[i]].begin(), given[numbers[i]].end());
      }
  }

  Polygons polygons;
  std::vector<Corner> corners_given; // the given vertex at each corner
};

class Point_merging
{
public:
  Point_merging(const Polygon_soup& soup, bool is_cut_kept)
    : soup_(soup),
      is_cut_kept_(is_cut_kept),
      fans_(count_fans(soup.polygons, sides_of(soup.polygons), soup.points.size()))
  {
    std::vector<Corner> all(soup.points.size());
    std::iota(all.begin(), all.end(), Corner(0));
    places_ = join_close_points(soup.points, all, 0);
  }

  // Where something is wrong, the points there are left as they are, and those around a vertex. What is wrong after many
  // turns is left with its whole component.
  std::vector<Corner> merge()
  {
    constexpr int most_turns = 8;
    for(int turn = 0;; ++turn)
    {
      std::vector<Corner> joined = join();
      std::vector<char> is_wrong = find_wrong(joined);
      if(std::find(is_wrong.begin(), is_wrong.end(), 1) == is_wrong.end())
        return joined;
      if(turn >= most_turns)
        spread_in_components(is_wrong);
      std::vector<char> is_left(places_.size(), 0);
      for(std::size_t v = 0; v < places_.size(); ++v)
        is_left[places_[v]] |= is_wrong[v];
      for(std::size_t v = 0; v < places_.size(); ++v) // the first vertex of a place comes before the other ones
        if(is_left[places_[v]] != 0)
        {
          is_left[v] = 1;
          places_[v] = static_cast<Corner>(v);
        }
    }
  }

private:
  // Joins both vertices at the ends of each edge of two faces, and what is on no face.
  std::vector<Corner> join() const
  {
    const Joined_polygons at_places(soup_.polygons, places_);
    Union_find_of_indices vertices(places_.size());
    std::vector<char> is_on_face(places_.size(), 0);
    for(const Corner v : at_places.corners_given)
      is_on_face[v] = 1;
    const Face_pairs pairs = pair_two_faces(at_places.polygons);
    const std::vector<Polygon_side>& sides = pairs.sides;
    for(std::size_t s = 1; s < sides.size(); ++s)
    {
      const bool is_of_two = !(sides[s - 1] < sides[s]) && (s == 1 || sides[s - 2] < sides[s])
                          && (s + 1 == sides.size() || sides[s] < sides[s + 1]);
      if(!is_of_two || (is_cut_kept_ && pairs.mates[s] == s))
        continue;
      const auto given = [&](std::size_t corner) { return at_places.corners_given[corner]; };
      vertices.unite(given(sides[s - 1].corner_of_u), given(sides[s].corner_of_u));
      vertices.unite(given(sides[s - 1].corner_of_v), given(sides[s].corner_of_v));
    }
    for(std::size_t v = 0; v < places_.size(); ++v)
      if(is_on_face[v] == 0)
        vertices.unite(v, places_[v]);
    std::vector<Corner> firsts(places_.size(), too_large_corner), joined(places_.size());
    for(std::size_t v = 0; v < places_.size(); ++v)
    {
      Corner& first = firsts[vertices.find(v)];
      first = std::min(first, static_cast<Corner>(v));
      joined[v] = first;
    }
    return joined;
  }

  // The vertices of edges that would get more than two faces, and those around vertices that would get several fans.
  std::vector<char> find_wrong(const std::vector<Corner>& joined) const
  {
    std::vector<char> is_wrong(joined.size(), 0), has_new_fans(joined.size(), 0);
    const Joined_polygons result(soup_.polygons, joined);
    const std::vector<Polygon_side> sides = sides_of(result.polygons);
    const auto ends = [&](std::size_t s) {
      return std::make_pair(result.corners_given[sides[s].corner_of_u], result.corners_given[sides[s].corner_of_v]);
    };
    for(std::size_t begin = 0, end = 0; begin < sides.size(); begin = end)
    {
      end = end_of_edge(sides, begin);
      for(std::size_t s = begin + 1; end - begin > 2 && s < end; ++s)
        if(ends(s) != ends(begin))
          is_wrong[sides[s].u] = is_wrong[sides[s].v] = 1;
    }
    const std::vector<std::size_t> fans = count_fans(result.polygons, sides, joined.size());
    std::vector<std::size_t> given_fans(joined.size(), 0);
    for(std::size_t v = 0; v < joined.size(); ++v)
      given_fans[joined[v]] = std::max(given_fans[joined[v]], fans_[v]);
    for(std::size_t i = 0; i < soup_.polygons.size(); ++i)
    {
      const Polygons::Polygon polygon = soup_.polygons[i];
      if(std::any_of(polygon.begin(), polygon.end(),
                     [&](Corner v) { return fans[joined[v]] > std::max<std::size_t>(given_fans[joined[v]], 1); }))
        for(const Corner v : polygon)
          is_wrong[v] = 1;
    }
    return is_wrong;
  }

  void spread_in_components(std::vector<char>& is_wrong) const
  {
    Union_find_of_indices components(places_.size());
    for(std::size_t v = 0; v < places_.size(); ++v)
      components.unite(v, places_[v]);
    for(std::size_t i = 0; i < soup_.polygons.size(); ++i)
      for(const Corner v : soup_.polygons[i])
        components.unite(*soup_.polygons[i].begin(), v);
    std::vector<char> is_any_wrong(places_.size(), 0);
    for(std::size_t v = 0; v < places_.size(); ++v)
      is_any_wrong[components.find(v)] |= is_wrong[v];
    for(std::size_t v = 0; v < places_.size(); ++v)
      is_wrong[v] = is_any_wrong[components.find(v)];
  }

  const Polygon_soup& soup_;
  bool is_cut_kept_;
  std::vector<std::size_t> fans_; // of the given vertices
  std::vector<Corner> places_;    // the first vertex where each one is; itself where points are left as they are
};

} // namespace

std::vector<Corner> merge_coinciding_points(const Polygon_soup& soup, bool is_cut_kept)
{
  return Point_merging(soup, is_cut_kept).merge();
}

} // namespace reeb_graph_program
