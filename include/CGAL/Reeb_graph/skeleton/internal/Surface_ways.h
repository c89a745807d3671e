// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_SKELETON_INTERNAL_SURFACE_WAYS_H
#define CGAL_REEB_GRAPH_SKELETON_INTERNAL_SURFACE_WAYS_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/internal/base/Progress.h>
#include <CGAL/Reeb_graph/skeleton/internal/Component_filling.h>
#include <CGAL/Reeb_graph/skeleton/internal/Surface_tree.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <optional>
#include <queue>
#include <unordered_map>
#include <utility>
#include <vector>

namespace CGAL::Reeb_graph::internal::skeleton {

// A path of faces, by the first one and the halfedges through which faces are left.
struct Face_path
{
  Mesh::Face_index begin;
  std::vector<Mesh::Halfedge_index> steps;

  Mesh::Face_index end(const Mesh& mesh) const
  {
    return steps.empty() ? begin : mesh.face(mesh.opposite(steps.back()));
  }

  Face_path reversed(const Mesh& mesh) const
  {
    Face_path result = {end(mesh), {}};
    for(auto h = steps.rbegin(); h != steps.rend(); ++h)
      result.steps.push_back(mesh.opposite(*h));
    return result;
  }

  // The path to a face in a tree, by the halfedges through which faces are reached, none for the first one.
  template <class Through>
  static Face_path in_tree(const Mesh& mesh, Mesh::Face_index to, const Through& through)
  {
    Face_path path = {to, {}};
    for(auto h = through(to); h.is_valid(); h = through(path.begin))
    {
      path.steps.push_back(h);
      path.begin = mesh.face(h);
    }
    std::reverse(path.steps.begin(), path.steps.end());
    return path;
  }

  // The loop that a halfedge closes with a tree, from its first face.
  template <class Through>
  static Face_path closed_by(const Mesh& mesh, Mesh::Halfedge_index h, const Through& through)
  {
    Face_path loop = in_tree(mesh, mesh.face(h), through);
    loop.steps.push_back(h);
    const Face_path back = in_tree(mesh, mesh.face(mesh.opposite(h)), through).reversed(mesh);
    loop.steps.insert(loop.steps.end(), back.steps.begin(), back.steps.end());
    return loop;
  }

  // A loop without what it goes there and back.
  Face_path without_tail(const Mesh& mesh) const
  {
    auto first = steps.begin(), beyond = steps.end();
    while(first != beyond && *first == mesh.opposite(*(beyond - 1)))
    {
      ++first;
      --beyond;
    }
    return {first == beyond ? begin : mesh.face(*first), {first, beyond}};
  }
};

// Finds ways inside of a surface right beneath its faces, as close to them as need be.
class Surface_ways
{
public:
  // A long way looks at the progress, so that it can be cancelled.
  Surface_ways(const Surface_tree& tree, const Stage_progress& progress)
    : tree_(tree),
      mesh_(tree.mesh()),
      progress_(progress)
  {}

  // A way from a place to another one that does not cross the surface: beneath its faces, as close as need be, with
  // shortcuts. It is empty if there is none.
  std::vector<Point> way_beneath(const Surface_place& from, const Surface_place& to) const
  {
    if(!tree_.has_area())
      return {};
    std::vector<Sunk_place> begin = {{from}}, end = {{to}};
    const Mesh::Face_index first = add_foot(from, begin);
    const Face_path path = path_of_faces(first, add_foot(to, end));
    for(const std::size_t most_turned : {std::size_t(6), path.steps.size()})
    {
      std::vector<Sunk_place> way = begin;
      const bool is_turned = add_path(path, most_turned, way);
      way.insert(way.end(), end.rbegin(), end.rend());
      if(raise_until_free(way, false))
        return shortened(way);
      if(!is_turned)
        break;
    }
    return {};
  }

  // A way from a place to another one along a path of faces, to which it can be brought without meeting the surface, if that is
  // asked, and shorter as long as the surface does not meet the triangles that it then sweeps. It is empty if there is none.
  std::vector<Point> way_along(const Surface_place& from,
                               const Surface_place& to,
                               const Face_path& path,
                               bool is_swept) const
  {
    if(!tree_.has_area())
      return {};
    std::vector<Sunk_place> way = {{from}}, end = {{to}};
    const Face_path there = path_of_faces(add_foot(from, way), path.begin);
    const Face_path back = path_of_faces(add_foot(to, end), path.end(mesh_)).reversed(mesh_);
    Face_path whole = there;
    for(const Face_path* part : {&path, &back})
      whole.steps.insert(whole.steps.end(), part->steps.begin(), part->steps.end());
    add_path(whole, whole.steps.size(), way);
    way.insert(way.end(), end.rbegin(), end.rend());
    return raise_until_free(way, is_swept) ? pulled(way) : std::vector<Point>();
  }

  // Whether a way can pass right beneath an edge from the center of a face to that of the next one.
  bool can_pass(Mesh::Halfedge_index h) const
  {
    const Mesh::Face_index f = mesh_.face(h), g = mesh_.face(mesh_.opposite(h));
    const Vector in_f = tree_.inward_normal(f), in_g = tree_.inward_normal(g);
    const Point middle = CGAL::midpoint(mesh_.point(mesh_.source(h)), mesh_.point(mesh_.target(h)));
    const auto beneath = [&](const Point& p, const Vector& inwards) {
      return Surface_place{p + 1e-6 * distance(tree_.center(f), tree_.center(g)) * inwards};
    };
    const Surface_place at_edge = beneath(middle, in_f + in_g);
    return in_f != NULL_VECTOR && in_g != NULL_VECTOR && !tree_.is_crossed(beneath(tree_.center(f), in_f), at_edge)
        && !tree_.is_crossed(at_edge, beneath(tree_.center(g), in_g));
  }

private:
  // A place of a way, which can be brought nearer to where it has been on the surface, on an edge or in a face.
  struct Sunk_place
  {
    Surface_place place;
    Vector inwards = NULL_VECTOR; // of length 1, or null if the place is to stay
    double depth = 0;
    Point foot = ORIGIN;
    std::array<Mesh::Face_index, 2> faces = {}; // none if the place is to stay
  };

  std::vector<Point> pulled(const std::vector<Sunk_place>& way) const
  {
    std::vector<Point> result;
    for(const Sunk_place& place : way)
      result.push_back(place.place.point);
    while(is_pulled(result))
      ;
    return result;
  }

  // Leaves points of a way out, no two beside each other, so that triangles stay small. Returns whether many were left out.
  bool is_pulled(std::vector<Point>& way) const
  {
    const std::vector<Point> old = std::exchange(way, {way.front()});
    bool is_last_left_out = false;
    for(std::size_t i = 1; i + 1 < old.size(); ++i)
    {
      look(i);
      is_last_left_out = !is_last_left_out && !tree_.is_met_by_triangle(old[i - 1], old[i], old[i + 1]);
      if(!is_last_left_out)
        way.push_back(old[i]);
    }
    way.push_back(old.back());
    return 20 * way.size() < 19 * old.size();
  }

  // Whether the surface meets what is between two places of a way and the faces that they are beneath: those are in the same
  // face, and what is beneath two faces at an edge meets none of them.
  bool is_met_between(const Sunk_place& a, const Sunk_place& b) const
  {
    const std::array<Mesh::Face_index, 4> own = {a.faces[0], a.faces[1], b.faces[0], b.faces[1]};
    return a.faces[0].is_valid() && b.faces[0].is_valid()
        && (tree_.is_met_by_triangle(a.foot, a.place.point, b.place.point, own)
            || tree_.is_met_by_triangle(a.foot, b.foot, b.place.point, own));
  }

  // Looks at the progress at some steps of a way.
  void look(std::size_t step) const
  {
    if(step % 128 == 0)
      progress_(0);
  }

  // Places beneath the edges between faces, and the centers of the first and the last one, no deeper than in the middle between these
  // and what is seen from there, and not much deeper than the place before. No two are at one depth, as else a way that is pulled
  // straight can touch edges of what is regular, and pass curves there by rounding. Where more steps than `most_turned` turn around
  // a vertex, the way goes beneath that: returns whether there are such.
  bool add_path(const Face_path& path, std::size_t most_turned, std::vector<Sunk_place>& way) const
  {
    const double golden_ratio = (std::sqrt(5.) - 1) / 2;
    double depth = 0, share = 0;
    bool is_turned = false;
    const auto add = [&](const Point& p, const Vector& inwards, Mesh::Face_index f, Mesh::Face_index g) {
      const double size = length(inwards);
      if(!(size > 0))
        return; // Faces without area have no side.
      const Vector down = inwards / size;
      const double reach = 4 * (depth > 0 ? depth : tree_.size()), clearance = tree_.clearance(p, down, {f, g}, reach);
      // On the other side of what has no volume nothing is seen.
      depth = clearance < reach || tree_.is_inside(p + reach / 2 * down) ? clearance / 2 : 1e-6 * tree_.size();
      // Rays miss edges by rounding.
      while(depth > 1e-9 * tree_.size() && tree_.is_near(p + depth * down, 1e-6 * depth))
        depth /= 2;
      share = std::fmod(share + golden_ratio, 1.);
      const double own_depth = (0.9 + 0.1 * share) * depth;
      way.push_back({{p + own_depth * down}, down, own_depth, p, {f, g}});
    };
    add(tree_.center(path.begin), tree_.inward_normal(path.begin), path.begin, path.begin);
    for(std::size_t i = 0; i != path.steps.size(); ++i)
    {
      look(i);
      if(const auto [v, number] = turn_from(path, i); number > most_turned)
      {
        const Vector down = tree_.inward_direction(v);
        depth = (std::max)(tree_.depth_beneath(v, down) / 2, 1e-6 * tree_.size());
        way.push_back({{mesh_.point(v) + depth * down}, down, depth, mesh_.point(v), {}});
        i += number - 1;
        is_turned = true;
        const Mesh::Face_index g = mesh_.face(mesh_.opposite(path.steps[i]));
        add(tree_.center(g), tree_.inward_normal(g), g, g);
        continue;
      }
      const auto h = path.steps[i];
      const Mesh::Face_index f = mesh_.face(h), g = mesh_.face(mesh_.opposite(h));
      add(CGAL::midpoint(mesh_.point(mesh_.source(h)), mesh_.point(mesh_.target(h))),
          tree_.inward_normal(f) + tree_.inward_normal(g), f, g);
    }
    const Mesh::Face_index last = path.end(mesh_);
    add(tree_.center(last), tree_.inward_normal(last), last, last);
    return is_turned;
  }

  // The vertex around which most steps turn from one on, and how many do.
  std::pair<Mesh::Vertex_index, std::size_t> turn_from(const Face_path& path, std::size_t first) const
  {
    std::pair<Mesh::Vertex_index, std::size_t> best;
    for(const auto v : {mesh_.source(path.steps[first]), mesh_.target(path.steps[first])})
    {
      std::size_t end = first + 1;
      while(end != path.steps.size() && (mesh_.source(path.steps[end]) == v || mesh_.target(path.steps[end]) == v))
        ++end;
      if(end - first > best.second)
        best = {v, end - first};
    }
    return best;
  }

  // A face at a place, and, if that is inside, on a way to it a point on a ray to the face.
  Mesh::Face_index add_foot(const Surface_place& from, std::vector<Sunk_place>& way) const
  {
    if(from.vertex)
      return mesh_.face(mesh_.halfedge(*from.vertex));
    const auto [foot, f] = seen_foot(from.point);
    const double height = distance(foot, from.point);
    if(height > 0)
      way.push_back({{from.point}, (from.point - foot) / height, height, foot, {f, f}});
    return f;
  }

  // A place on the surface that is seen from a point, and its face. That of the closest point can be hidden if this is at
  // a corner, behind other faces there: then another one that is near, or any one.
  std::pair<Point, Mesh::Face_index> seen_foot(const Point& p) const
  {
    const auto closest = tree_.closest_place(p);
    std::vector<Vector> rays;
    for(double t = 0.5; t > 1e-3; t /= 2)
      rays.push_back(closest.first + t * (tree_.center(closest.second) - closest.first) - p);
    for(int i = 0; i != 27; ++i)
      rays.push_back(Vector(i % 3 - 1, i / 3 % 3 - 1, i / 9 - 1));
    std::optional<std::pair<Point, Mesh::Face_index>> first;
    for(const Vector& ray : rays)
      if(const auto seen = tree_.first_seen(p, ray))
      {
        // Rounding puts what is right at an edge, or in the plane of the face, on either side of that. One that is
        // seen from behind tells that the surface crosses itself there.
        const auto inner = tree_.first_seen(p, CGAL::midpoint(seen->first, tree_.center(seen->second)) - p);
        if(inner && inner->second == seen->second
           && std::abs((p - inner->first) * tree_.inward_normal(inner->second)) > 1e-3 * distance(p, inner->first))
          return *inner;
        first = first ? first : seen;
      }
    return first.value_or(closest);
  }

  // A place at a share of its depth.
  static Sunk_place raised(Sunk_place p, double share)
  {
    p.place.point = p.place.point - (1 - share) * p.depth * p.inwards;
    p.depth *= share;
    return p;
  }

  // Brings the ends of segments that cross the surface nearer to it until none does, and, if that is asked, until nothing is
  // between the way and its faces: those that share an edge hide nothing from each other right beneath them.
  bool raise_until_free(std::vector<Sunk_place>& way, bool is_swept) const
  {
    const int number_of_turns = 24;
    const auto is_met = [&](const Sunk_place& a, const Sunk_place& b) {
      return tree_.is_crossed(a.place, b.place) || (is_swept && is_met_between(a, b));
    };
    std::vector<bool> has_moved(way.size(), true);
    for(int turn = 0; turn != number_of_turns; ++turn)
    {
      std::vector<bool> is_bad(way.size(), false);
      for(std::size_t i = 0; i + 1 < way.size(); ++i)
      {
        look(i);
        if(!(has_moved[i] || has_moved[i + 1]) || !is_met(way[i], way[i + 1]))
          continue;
        // Segments that are met right beneath the surface, where that crosses itself, stay so.
        if(turn == 0 && is_met(raised(way[i], 1e-6), raised(way[i + 1], 1e-6)))
          return false;
        is_bad[i] = is_bad[i + 1] = true;
      }
      if(std::find(is_bad.begin(), is_bad.end(), true) == is_bad.end())
        return true;
      for(std::size_t i = 0; i != way.size(); ++i)
        if(is_bad[i])
          way[i] = raised(way[i], 0.25);
      has_moved = std::move(is_bad);
    }
    return false;
  }

  // Leaves points out as long as nothing is crossed.
  std::vector<Point> shortened(const std::vector<Sunk_place>& way) const
  {
    const auto is_free = [&](std::size_t i, std::size_t j) { return !tree_.is_crossed(way[i].place, way[j].place); };
    std::vector<Point> result = {way.front().place.point};
    for(std::size_t i = 0; i + 1 < way.size();)
    {
      std::size_t j = i + 1;
      for(std::size_t step = 2; i + step < way.size() && is_free(i, i + step);
          step = (std::min)(2 * step, way.size() - 1 - i))
      {
        j = i + step;
        if(j + 1 == way.size())
          break;
      }
      while(j + 1 < way.size() && is_free(i, j + 1))
        ++j;
      result.push_back(way[j].place.point);
      i = j;
    }
    return result;
  }

  // A short path of faces, along the centers.
  Face_path path_of_faces(Mesh::Face_index from, Mesh::Face_index to) const
  {
    struct Reached
    {
      double distance;
      Mesh::Halfedge_index through;
    };
    typedef std::pair<double, Mesh::Face_index> Entry;
    std::unordered_map<std::size_t, Reached> reached = {{from.idx(), {0, Mesh::null_halfedge()}}};
    std::priority_queue<Entry, std::vector<Entry>, std::greater<Entry>> queue;
    queue.push({distance(tree_.center(from), tree_.center(to)), from});
    while(!queue.empty() && queue.top().second != to)
    {
      const auto f = queue.top().second;
      queue.pop();
      const double so_far = reached.at(f.idx()).distance;
      auto h = mesh_.halfedge(f);
      for(int i = 0; i != 3; ++i, h = mesh_.next(h))
      {
        const auto g = mesh_.face(mesh_.opposite(h));
        const double next = so_far + distance(tree_.center(f), tree_.center(g));
        const auto found = reached.find(g.idx());
        if(found != reached.end() && !(next < found->second.distance))
          continue;
        reached[g.idx()] = {next, h};
        queue.push({next + distance(tree_.center(g), tree_.center(to)), g});
      }
    }
    return Face_path::in_tree(mesh_, to, [&](Mesh::Face_index f) { return reached.at(f.idx()).through; });
  }

  const Surface_tree& tree_;
  const Mesh& mesh_;
  const Stage_progress progress_;
};

} // namespace CGAL::Reeb_graph::internal::skeleton

#endif // CGAL_REEB_GRAPH_SKELETON_INTERNAL_SURFACE_WAYS_H
