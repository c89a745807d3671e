// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#include "input/assemble_surface.h"
#include "input/repair_soup.h"

#include <CGAL/Bbox_3.h>
#include <CGAL/Box_intersection_d/Box_with_info_d.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/box_intersection_d.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <set>
#include <utility>
#include <vector>

namespace reeb_graph_program {
namespace {
typedef CGAL::Exact_predicates_inexact_constructions_kernel Kernel;
typedef Kernel::Vector_3 Vector;

double largest_side(const CGAL::Bbox_3& box)
{
  double half = 0;
  for(int i = 0; i < 3; ++i)
    half = std::max(half, (box.max)(i) / 2 - (box.min)(i) / 2);
  return half;
}

// Differences of points of a box, multiplied by a power of two so that they are about 1.
class Unit
{
public:
  explicit Unit(const CGAL::Bbox_3& box)
  {
    const double side = largest_side(box);
    exponent_ = side > 0 ? -std::ilogb(side) : 0;
  }
  Vector difference(const Point& p, const Point& q) const
  {
    const auto scaled = [&](double x, double y) { return std::scalbn(x / 2 - y / 2, exponent_); };
    return {scaled(p.x(), q.x()), scaled(p.y(), q.y()), scaled(p.z(), q.z())};
  }

private:
  int exponent_;
};

// Faces that are joined by edges.
struct Shell
{
  std::vector<std::size_t> faces;
  CGAL::Bbox_3 box;
  bool is_closed = true; // as many faces run along each edge as against it
  int sign = 0;          // of the volume, if it is closed; 0 if it has none
};

CGAL::Bbox_3 box_of(const Polygon_soup& soup, std::size_t face)
{
  CGAL::Bbox_3 box;
  for(const Corner v : soup.polygons[face])
    box += soup.points[v].bbox();
  return box;
}

// Calls visit(a, b, c) for the triangles of a face.
template <class Visit>
void visit_triangles(const Polygon_soup& soup, std::size_t face, const Visit& visit)
{
  const Corner* const v = soup.polygons[face].begin();
  for(std::size_t k = 2; k < soup.polygons[face].size(); ++k)
    visit(soup.points[v[0]], soup.points[v[k - 1]], soup.points[v[k]]);
}

int sign_of_volume(const Polygon_soup& soup, const Shell& shell)
{
  const Unit unit(shell.box);
  const Point& origin = soup.points[*soup.polygons[shell.faces.front()].begin()];
  double volume = 0, size = 0; // size: what the volume would be without any sign
  for(const std::size_t face : shell.faces)
    visit_triangles(soup, face, [&](const Point& a, const Point& b, const Point& c) {
      const double part =
        CGAL::determinant(unit.difference(a, origin), unit.difference(b, origin), unit.difference(c, origin));
      volume += part;
      size += std::abs(part);
    });
  return std::abs(volume) <= 1e-12 * size ? 0 : volume < 0 ? -1 : 1;
}

// In the order of their first faces.
std::vector<Shell> shells_of(const Polygon_soup& soup)
{
  const std::vector<Polygon_side> sides = sides_of(soup.polygons);
  Union_find_of_indices sets(soup.polygons.size());
  std::vector<std::size_t> faces_of_open_edges;
  for_each_edge(sides, [&](std::size_t begin, std::size_t end) {
    std::size_t descending = 0;
    for(std::size_t s = begin; s < end; ++s)
    {
      sets.unite(sides[begin].face, sides[s].face);
      descending += sides[s].is_descending ? 1 : 0;
    }
    if(2 * descending != end - begin)
      faces_of_open_edges.push_back(sides[begin].face);
  });
  std::vector<Shell> shells;
  std::vector<std::size_t> numbers(soup.polygons.size(), no_vertex); // of the sets
  for(std::size_t i = 0; i < soup.polygons.size(); ++i)
  {
    std::size_t& number = numbers[sets.find(i)];
    if(number == no_vertex)
    {
      number = shells.size();
      shells.emplace_back();
    }
    shells[number].faces.push_back(i);
    shells[number].box += box_of(soup, i);
  }
  for(const std::size_t face : faces_of_open_edges)
    shells[numbers[sets.find(face)]].is_closed = false;
  for(Shell& shell : shells)
    shell.sign = shell.is_closed ? sign_of_volume(soup, shell) : 0;
  return shells;
}

// Which solids lie in which, by rays upwards from some of their points. Only closed shells with a volume are solids.
class Nesting
{
public:
  Nesting(const Polygon_soup& soup, const std::vector<Shell>& shells)
    : soup_(soup),
      shells_(shells),
      containers_(shells.size())
  {
    find_candidates();
    if(!candidates_.empty())
      find_containers();
  }

  // The shell around all others that one lies in, itself if it lies in none. There is no circle, as boxes say which can be
  // around which.
  std::size_t outermost(std::size_t shell) const
  {
    while(!containers_[shell].empty())
      shell = containers_[shell].front();
    return shell;
  }

private:
  typedef CGAL::Box_intersection_d::Box_with_info_d<double, 3, std::size_t> Box;
  typedef std::pair<std::size_t, std::size_t> Pair; // a shell, and one whose box is around that of the former

  // How often a shell winds around a point, unless the point lies on it.
  struct Winding
  {
    int number = 0;
    bool is_on_shell = false;
  };

  bool is_box_around(std::size_t outer, std::size_t inner) const
  {
    const CGAL::Bbox_3 &o = shells_[outer].box, &i = shells_[inner].box;
    return o + i == o && (o != i || outer < inner);
  }

  void find_candidates()
  {
    std::vector<Box> boxes;
    for(std::size_t i = 0; i < shells_.size(); ++i)
      if(shells_[i].sign != 0)
        boxes.emplace_back(shells_[i].box, i);
    CGAL::box_self_intersection_d(boxes.begin(), boxes.end(), [&](const Box& a, const Box& b) {
      for(const auto& [inner, outer] : {Pair(a.info(), b.info()), Pair(b.info(), a.info())})
        if(is_box_around(outer, inner))
          candidates_.insert({inner, outer});
    });
  }

  // Centers of triangles, evenly spread over the list of faces: few, as most of them say the same.
  std::vector<Point> samples_of(std::size_t shell) const
  {
    constexpr std::size_t most = 8;
    const std::vector<std::size_t>& faces = shells_[shell].faces;
    const std::size_t number = std::min(most, faces.size());
    std::vector<Point> samples;
    for(std::size_t i = 0; i < number; ++i)
    {
      const Corner* const v = soup_.polygons[faces[i * faces.size() / number]].begin();
      samples.push_back(mean_of(soup_.points, std::array<Corner, 3>{v[0], v[1], v[2]}));
    }
    return samples;
  }

  // A shell lies in another one if more of its points are inside than outside.
  void find_containers()
  {
    std::vector<std::size_t> shells_of_samples, shells_of_faces(soup_.polygons.size());
    std::vector<std::size_t> numbers(shells_.size(), 0); // of samples
    std::vector<Kernel::Point_3> samples;
    std::vector<char> is_outer(shells_.size(), 0);
    CGAL::Bbox_3 all;
    for(const auto& [inner, outer] : candidates_)
    {
      is_outer[outer] = 1;
      all += shells_[outer].box;
      if(numbers[inner] == 0)
        for(const Point& p : samples_of(inner))
        {
          ++numbers[inner];
          samples.emplace_back(p.x(), p.y(), p.z());
          shells_of_samples.push_back(inner);
        }
    }
    std::vector<Box> rays, faces;
    for(std::size_t k = 0; k < samples.size(); ++k)
      rays.emplace_back(
        samples[k].bbox()
          + CGAL::Bbox_3(samples[k].x(), samples[k].y(), all.zmax(), samples[k].x(), samples[k].y(), all.zmax()),
        k);
    for(std::size_t i = 0; i < shells_.size(); ++i)
      for(const std::size_t face : is_outer[i] != 0 ? shells_[i].faces : std::vector<std::size_t>())
      {
        shells_of_faces[face] = i;
        faces.emplace_back(box_of(soup_, face), face);
      }
    std::map<Pair, Winding> windings; // around samples, of shells
    CGAL::box_intersection_d(rays.begin(), rays.end(), faces.begin(), faces.end(),
                             [&](const Box& ray, const Box& face) {
                               const std::size_t k = ray.info(), outer = shells_of_faces[face.info()];
                               if(candidates_.count({shells_of_samples[k], outer}) == 0)
                                 return;
                               Winding& winding = windings[{k, outer}];
                               visit_triangles(soup_, face.info(), [&](const Point& a, const Point& b, const Point& c) {
                                 cross(samples[k], {exact(a), exact(b), exact(c)}, winding);
                               });
                             });
    std::map<Pair, std::size_t> votes; // two for each point inside, one for each on the outer shell
    for(const auto& [place, winding] : windings)
      votes[{shells_of_samples[place.first], place.second}] += winding.is_on_shell ? 1 : winding.number != 0 ? 2 : 0;
    for(const auto& [pair, number] : votes)
      if(number > numbers[pair.first])
        containers_[pair.first].push_back(pair.second);
  }

  static Kernel::Point_3 exact(const Point& p) { return {p.x(), p.y(), p.z()}; }

  // How a ray upwards passes a triangle: once more from its front, once less from its back. Of an edge that it meets, one
  // side counts.
  static void cross(const Kernel::Point_3& p, const std::array<Kernel::Point_3, 3>& t, Winding& winding)
  {
    int sign = 0;
    for(std::size_t k = 0; k < 3; ++k)
    {
      const Kernel::Point_3 &a = t[k], &b = t[(k + 1) % 3];
      if((a.y() <= p.y()) == (b.y() <= p.y()))
        continue;
      const bool is_up = a.y() <= p.y();
      const Kernel::Point_3 &low = is_up ? a : b, &high = is_up ? b : a;
      if(CGAL::orientation(Kernel::Point_2(low.x(), low.y()), Kernel::Point_2(high.x(), high.y()),
                           Kernel::Point_2(p.x(), p.y()))
         == CGAL::POSITIVE)
        sign += is_up ? 1 : -1;
    }
    if(sign == 0)
      return;
    const CGAL::Orientation side = CGAL::orientation(t[0], t[1], t[2], p);
    winding.is_on_shell = winding.is_on_shell || side == CGAL::COPLANAR;
    winding.number += side == CGAL::COPLANAR || (side == CGAL::POSITIVE) == (sign > 0) ? 0 : sign;
  }

  const Polygon_soup& soup_;
  const std::vector<Shell>& shells_;
  std::set<Pair> candidates_;
  std::vector<std::vector<std::size_t>> containers_; // of each shell
};

} // namespace

std::vector<std::size_t> faces_of_lesser_pieces(const Polygon_soup& soup, double least_share, Repair_counts& counts)
{
  CGAL::Bbox_3 box;
  for(const Corner v : soup.polygons.corners())
    box += soup.points[v].bbox();
  const Unit unit(box);
  const std::vector<std::size_t> components = components_of_polygons(soup.polygons, soup.points.size());
  std::vector<double> areas(soup.points.size(), 0);
  std::vector<char> has_inside(soup.points.size(), 0), is_counted(soup.points.size(), 0);
  double area = 0;
  for(std::size_t i = 0; i < components.size(); ++i)
    visit_triangles(soup, i, [&](const Point& a, const Point& b, const Point& c) {
      const double part = std::sqrt(CGAL::cross_product(unit.difference(b, a), unit.difference(c, a)).squared_length());
      areas[components[i]] += part;
      area += part;
    });
  for(const Shell& shell : shells_of(soup))
    if(!shell.is_closed || shell.sign != 0)
      has_inside[components[shell.faces.front()]] = 1;
  std::vector<std::size_t> result;
  for(std::size_t i = 0; i < components.size(); ++i)
  {
    const std::size_t component = components[i];
    const bool is_small = areas[component] < least_share * area;
    if(!is_small && has_inside[component] != 0)
      continue;
    result.push_back(i);
    if(std::exchange(is_counted[component], 1) == 0)
      ++(is_small ? counts.small_pieces : counts.pieces_without_volume);
  }
  return result;
}

Inside_out find_inside_out(const Polygon_soup& soup)
{
  Inside_out result;
  result.is_inside_out.resize(soup.polygons.size(), 0);
  const std::vector<Shell> shells = shells_of(soup);
  if(std::none_of(shells.begin(), shells.end(), [](const Shell& shell) { return shell.sign < 0; }))
    return result;
  const Nesting nesting(soup, shells);
  for(std::size_t i = 0; i < shells.size(); ++i)
  {
    const std::size_t outermost = nesting.outermost(i);
    if(shells[outermost].sign >= 0)
      continue;
    result.solids += outermost == i ? 1 : 0;
    for(const std::size_t face : shells[i].faces)
      result.is_inside_out[face] = 1;
  }
  return result;
}

std::size_t count_inside_out_solids(const Surface& surface) { return find_inside_out(soup_of(surface)).solids; }

} // namespace reeb_graph_program
