// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#include <boost/test/unit_test.hpp>

#include "compared_bodies.h"
#include "computed_graphs.h"
#include "generated_surfaces.h"

#include <CGAL/Reeb_graph/comparison/bottleneck_distance.h>
#include <CGAL/Reeb_graph/comparison/match_arcs.h>
#include <CGAL/Reeb_graph/comparison/match_tips.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <iterator>
#include <limits>
#include <utility>
#include <vector>

BOOST_AUTO_TEST_SUITE(test_comparison)

using namespace compared_bodies;
using CGAL::Reeb_graph::Persistence_pair_kind;
using CGAL::Reeb_graph::Persistence_values;
using computed_graphs::Field_class;
using computed_graphs::make_mesh;
using computed_graphs::Mesh_class;
using computed_graphs::Random;

namespace {
typedef std::vector<Persistence_values> Pairs;

constexpr double infinity = std::numeric_limits<double>::infinity();

// Few values, so that many are equal, and both kinds that are compared apart.
Pairs random_pairs(std::size_t most, Random& random)
{
  Pairs pairs(random.below(most + 1));
  for(Persistence_values& pair : pairs)
  {
    pair.lower = static_cast<double>(random.below(8));
    pair.upper = pair.lower + static_cast<double>(random.below(6));
    pair.kind = random.below(2) == 0 ? Persistence_pair_kind::LOOP : Persistence_pair_kind::MINIMUM_SADDLE;
  }
  return pairs;
}

double half_persistence(const Persistence_values& pair) { return (pair.upper - pair.lower) / 2; }

// By definition: the least price over all assignments of a[i...] to what is left of b, or to nothing.
double least_price(const Pairs& a, std::size_t i, const Pairs& b, std::vector<bool>& is_taken)
{
  double least = infinity;
  if(i == a.size())
  {
    least = 0;
    for(std::size_t j = 0; j != b.size(); ++j)
      if(!is_taken[j])
        least = (std::max)(least, half_persistence(b[j]));
    return least;
  }
  least = (std::max)(half_persistence(a[i]), least_price(a, i + 1, b, is_taken));
  for(std::size_t j = 0; j != b.size(); ++j)
    if(!is_taken[j] && a[i].kind == b[j].kind)
    {
      is_taken[j] = true;
      const double price = (std::max)(std::abs(a[i].lower - b[j].lower), std::abs(a[i].upper - b[j].upper));
      least = (std::min)(least, (std::max)(price, least_price(a, i + 1, b, is_taken)));
      is_taken[j] = false;
    }
  return least;
}

Pairs pairs_of(const mesh_builders::Surface_mesh& mesh, const std::vector<double>& values)
{
  Pairs pairs;
  CGAL::Reeb_graph::persistence_values(graph_checks::compute(mesh, values), std::back_inserter(pairs));
  return pairs;
}

// The surface with its box from 0 on, whose diagonal is 1, and with points moved by at most `noise` in each direction.
generated_surfaces::Triangle_soup of_size_1(generated_surfaces::Triangle_soup soup, double noise = 0)
{
  std::array<double, 3> low, side;
  for(std::size_t i = 0; i != 3; ++i)
  {
    const auto [least, greatest] = std::minmax_element(soup.points.begin(), soup.points.end(),
                                                       [i](const auto& p, const auto& q) { return p[i] < q[i]; });
    low[i] = (*least)[i];
    side[i] = (*greatest)[i] - low[i];
  }
  Random random(soup.points.size());
  for(auto& point : soup.points)
    for(std::size_t i = 0; i != 3; ++i)
      point[i] = (point[i] - low[i]) / std::hypot(side[0], side[1], side[2])
               + noise * (static_cast<double>(random.below(2000001)) / 1000000 - 1);
  return soup;
}

// The pairs of the first coordinate.
Pairs pairs_of_x(const generated_surfaces::Triangle_soup& soup)
{
  std::vector<double> values;
  for(const auto& point : soup.points)
    values.push_back(point[0]);
  return pairs_of(generated_surfaces::make_mesh<mesh_builders::Surface_mesh>(soup), values);
}

// The pairs of the distance from a vertex.
Pairs pairs_of_distances(const generated_surfaces::Triangle_soup& soup, std::size_t source)
{
  const auto mesh = generated_surfaces::make_mesh<Mesh>(soup);
  std::vector<double> values(soup.points.size());
  const auto map = CGAL::make_property_map(values);
  CGAL::Reeb_graph::compute_geodesic_field(
    mesh, map, std::array<Mesh::Vertex_index, 1>{Mesh::Vertex_index(static_cast<Mesh::size_type>(source))});
  return pairs_of(generated_surfaces::make_mesh<mesh_builders::Surface_mesh>(soup), values);
}

std::size_t leftmost(const generated_surfaces::Triangle_soup& soup)
{
  return static_cast<std::size_t>(std::min_element(soup.points.begin(), soup.points.end()) - soup.points.begin());
}

constexpr unsigned number_of_genera = 4; // 0, 1, 2, 3

// One pair of a loop for each handle, and farther from the others than anything here moves them.
void check_that_genera_are_apart(const std::vector<Pairs>& shapes)
{
  for(std::size_t genus = 0; genus != number_of_genera; ++genus)
  {
    BOOST_TEST(std::count_if(shapes[genus].begin(), shapes[genus].end(),
                             [](const auto& pair) { return pair.kind == Persistence_pair_kind::LOOP; })
               == static_cast<std::ptrdiff_t>(genus));
    for(std::size_t other = 0; other != genus; ++other)
    {
      const double distance = CGAL::Reeb_graph::bottleneck_distance(shapes[genus], shapes[other]);
      double least = infinity;
      for(const Persistence_values& pair : shapes[genus])
        least = pair.kind == Persistence_pair_kind::LOOP ? (std::min)(least, half_persistence(pair)) : least;
      BOOST_TEST(distance >= least); // a loop has no partner
      BOOST_TEST(distance > 0.08);
      BOOST_TEST(distance == CGAL::Reeb_graph::bottleneck_distance(shapes[other], shapes[genus]));
    }
  }
}

} // namespace

BOOST_AUTO_TEST_CASE(distances_that_are_known)
{
  const Pairs sphere = {{0, 3, Persistence_pair_kind::MINIMUM_MAXIMUM}};
  Pairs torus = sphere;
  torus.push_back({1, 2, Persistence_pair_kind::LOOP});
  BOOST_TEST(CGAL::Reeb_graph::bottleneck_distance(sphere, torus) == 0.5); // the loop closes half way
  BOOST_TEST(CGAL::Reeb_graph::bottleneck_distance(torus, torus) == 0);
  BOOST_TEST(CGAL::Reeb_graph::bottleneck_distance(Pairs(), Pairs()) == 0);
  Pairs moved = torus;
  moved.back().upper = 2.25;
  BOOST_TEST(CGAL::Reeb_graph::bottleneck_distance(torus, moved) == 0.25);
  moved.back().kind = Persistence_pair_kind::SADDLE_MAXIMUM; // pairs of other kinds are no partners
  BOOST_TEST(CGAL::Reeb_graph::bottleneck_distance(torus, moved) == 0.625);
  moved.back().upper = std::numeric_limits<double>::quiet_NaN();
  BOOST_CHECK_THROW(CGAL::Reeb_graph::bottleneck_distance(torus, moved), CGAL::Reeb_graph::Parameter_error);
}

BOOST_AUTO_TEST_CASE(the_distance_is_the_least_price)
{
  for(std::size_t seed = 0; seed != 2000; ++seed)
    BOOST_TEST_CONTEXT("seed " << seed)
    {
      Random random(seed);
      const Pairs a = random_pairs(5, random), b = random_pairs(5, random), c = random_pairs(5, random);
      std::vector<bool> is_taken(b.size(), false);
      const double distance = CGAL::Reeb_graph::bottleneck_distance(a, b);
      BOOST_TEST(distance == least_price(a, 0, b, is_taken));
      BOOST_TEST(distance == CGAL::Reeb_graph::bottleneck_distance(b, a));
      BOOST_TEST(CGAL::Reeb_graph::bottleneck_distance(a, c) <= distance + CGAL::Reeb_graph::bottleneck_distance(b, c));
    }
}

BOOST_AUTO_TEST_CASE(the_distance_is_at_most_that_of_the_fields)
{
  for(std::size_t seed = 0; seed != 300; ++seed)
    BOOST_TEST_CONTEXT("seed " << seed)
    {
      Random random(seed);
      const auto combinatorial_mesh = random_meshes::random_mesh(static_cast<Mesh_class>(seed % 6), random);
      const auto values = random_meshes::random_field(combinatorial_mesh, Field_class::PERMUTATION, random);
      auto others = values;
      for(double& value : others)
        value += static_cast<double>(random.below(9)) - 4;
      const auto mesh = make_mesh<mesh_builders::Surface_mesh>(combinatorial_mesh);
      BOOST_TEST(CGAL::Reeb_graph::bottleneck_distance(pairs_of(mesh, values), pairs_of(mesh, others)) <= 4);
    }
}

BOOST_AUTO_TEST_CASE(the_distance_of_a_torus_and_a_sphere_is_half_of_the_hole)
{
  auto sphere = generated_surfaces::closed_surface(0, 2500);
  const auto torus = generated_surfaces::torus(24, 48); // its hole is from -0.6 to 0.6, it from -1.4 to 1.4
  const double left = sphere.points[leftmost(sphere)][0];
  for(auto& point : sphere.points)
    point[0] *= -1.4 / left;
  BOOST_TEST(std::abs(CGAL::Reeb_graph::bottleneck_distance(pairs_of_x(sphere), pairs_of_x(torus)) - 0.6) < 1e-9);
}

BOOST_AUTO_TEST_CASE(genera_are_told_apart_by_a_coordinate)
{
  std::vector<generated_surfaces::Triangle_soup> soups;
  std::vector<Pairs> shapes;
  for(unsigned genus = 0; genus != number_of_genera; ++genus)
  {
    soups.push_back(of_size_1(generated_surfaces::closed_surface(genus, 2500)));
    shapes.push_back(pairs_of_x(soups.back()));
  }
  check_that_genera_are_apart(shapes);
  for(const double noise : {0., 0.01, 0.03, 0.05})
    for(unsigned genus = 0; genus != number_of_genera; ++genus)
      BOOST_TEST_CONTEXT("noise " << noise << ", genus " << genus)
      {
        const Pairs moved = noise > 0 ? pairs_of_x(of_size_1(generated_surfaces::closed_surface(genus, 2500), noise))
                                      : pairs_of_x(of_size_1(generated_surfaces::closed_surface(genus, 5000)));
        const double own = CGAL::Reeb_graph::bottleneck_distance(moved, shapes[genus]);
        BOOST_TEST(own <= (noise > 0 ? noise : 0.001));
        for(unsigned other = 0; other != number_of_genera; ++other)
          if(other != genus)
            BOOST_TEST(own < CGAL::Reeb_graph::bottleneck_distance(moved, shapes[other]) / 2);
      }
}

BOOST_AUTO_TEST_CASE(genera_are_told_apart_by_distances_however_they_lie)
{
  std::vector<Pairs> shapes;
  for(unsigned genus = 0; genus != number_of_genera; ++genus)
  {
    const auto soup = of_size_1(generated_surfaces::closed_surface(genus, 2500));
    const std::size_t source = leftmost(soup);
    shapes.push_back(pairs_of_distances(soup, source));
    Random random(genus);
    for(const double unit : {1., 1e150, 1e-150})
    {
      auto turned = soup;
      for(auto& p : turned.points) // by a matrix of thirds
        p = {unit * (2 * p[0] - 2 * p[1] + p[2]) / 3, unit * (p[0] + 2 * p[1] + 2 * p[2]) / 3,
             unit * (-2 * p[0] - p[1] + 2 * p[2]) / 3};
      auto numbers = own_numbers(soup.points.size());
      random.shuffle(numbers);
      generated_surfaces::renumber(turned, numbers);
      random.shuffle(turned.triangles);
      Pairs pairs = pairs_of_distances(turned, numbers[source]);
      for(Persistence_values& pair : pairs)
      {
        pair.lower /= unit;
        pair.upper /= unit;
      }
      BOOST_TEST(CGAL::Reeb_graph::bottleneck_distance(pairs, shapes.back()) < 1e-9);
    }
    const auto finer = of_size_1(generated_surfaces::closed_surface(genus, 5000));
    BOOST_TEST(CGAL::Reeb_graph::bottleneck_distance(pairs_of_distances(finer, leftmost(finer)), shapes.back()) < 0.01);
  }
  check_that_genera_are_apart(shapes);
}

BOOST_AUTO_TEST_CASE(prices_are_known)
{
  typedef CGAL::Reeb_graph::internal::Compared_arc Arc; // whether ends are leaves, values, length, root of area
  const Arc limb = {false, true, 0.5, 1, 0.25, 0.5};
  BOOST_TEST(Arc::price(limb, limb) == 0);
  BOOST_TEST(Arc::price(limb, {false, false, 0.5, 1, 0.25, 0.5}) == 0.5);
  BOOST_TEST(Arc::price(limb, {true, false, 0.5, 1, 0.25, 0.5}) == 1);
  const auto tolerance = boost::test_tools::tolerance(1e-12); // Each difference has a millionth of its square more.
  BOOST_TEST(Arc::price(limb, {false, true, 0.25, 0.5, 0.25, 0.5}) == 0.75 + 0.3125e-6, tolerance);
  BOOST_TEST(Arc::price({false, true, 0.5, 1, 0.75, 1}, limb) == 0.5 + 0.25e-6, tolerance);
}

// The differences of lengths 1 and 2 from 3 and 4 have the sum 4, whoever is whose partner.
BOOST_AUTO_TEST_CASE(equal_sums_are_told_apart_whatever_the_order)
{
  typedef CGAL::Reeb_graph::internal::Compared_arc Arc;
  const auto arc = [](double length) { return Arc{false, true, 0.5, 1, length, 0.5}; };
  const std::vector<Arc> a = {arc(0.1), arc(0.2)}, b = {arc(0.3), arc(0.4)}, turned = {arc(0.4), arc(0.3)};
  const auto partners = [](const std::vector<Arc>& first, const std::vector<Arc>& second) {
    return CGAL::Reeb_graph::internal::match(first, second, 1).partners;
  };
  const std::vector<std::size_t> same = {0, 1}, other = {1, 0};
  BOOST_TEST(partners(a, b) == same);
  BOOST_TEST(partners(b, a) == same);
  BOOST_TEST(partners(a, turned) == other);
  BOOST_TEST(partners(turned, a) == other);
}

BOOST_AUTO_TEST_CASE(a_high_price_leaves_no_more_alone_than_it_must)
{
  const Compared_body a = body(0, 0), b = body(4, 2);
  typedef boost::graph_traits<Graph>::edge_descriptor Arc;
  std::vector<std::pair<Arc, Arc>> expected;
  for(const double price : {1e4, 1e20, infinity})
  {
    std::vector<std::pair<Arc, Arc>> found;
    CGAL::Reeb_graph::match_arcs(a.graph, a.augmentation(), b.graph, b.augmentation(), std::back_inserter(found),
                                 CGAL::parameters::price_alone(price));
    BOOST_TEST(found.size() == (std::min)(num_edges(a.graph), num_edges(b.graph)));
    BOOST_TEST((expected.empty() || found == expected));
    expected = found;
  }
}

BOOST_AUTO_TEST_CASE(limbs_are_partners_of_limbs)
{
  std::size_t number = 0, number_of_right_ones = 0;
  for(unsigned i = 0; i != 6; ++i)
  {
    const Compared_body a = body(i, 10 * i), b = body(i + 1, 10 * i + 5);
    for(const auto& [leaf_a, leaf_b] : matched_leaves(a, b))
    {
      ++number;
      number_of_right_ones += a.parts[leaf_a] == b.parts[leaf_b] ? 1 : 0;
    }
  }
  BOOST_TEST(number >= 29u); // a head, two arms, and two legs
  BOOST_TEST(number_of_right_ones >= 29u);
}

BOOST_AUTO_TEST_CASE(noise_changes_no_partner)
{
  for(const double noise : {0.01, 0.03, 0.05})
    BOOST_TEST_CONTEXT("noise " << noise)
    {
      const Compared_body a = body(4, 2), b = body(5, 8), noisy = body(5, 8, noise);
      std::vector<generated_surfaces::Body_part> partners(a.parts.size());
      for(const auto& [leaf_a, leaf_b] : matched_leaves(a, b))
        partners[leaf_a] = b.parts[leaf_b];
      std::size_t number = 0;
      for(const auto& [leaf_a, leaf_b] : matched_leaves(a, noisy))
      {
        BOOST_TEST((noisy.parts[leaf_b] == partners[leaf_a]));
        ++number;
      }
      BOOST_TEST(number == 5u);
    }
}

BOOST_AUTO_TEST_CASE(tips_are_found_without_a_field)
{
  typedef CGAL::Reeb_graph::Tip_pair<Mesh::Vertex_index, Mesh::Vertex_index> Pair;
  const Compared_body a = body(2, 25), b = body(2, 27), c = body(3, 31);
  const auto match = [](const Compared_body& first, const Compared_body& second) {
    std::vector<Pair> tips;
    CGAL::Reeb_graph::match_tips(first.mesh, second.mesh, std::back_inserter(tips));
    return tips;
  };
  for(const auto& other : {std::cref(b), std::cref(c)})
  {
    const auto tips = match(a, other), turned = match(other, a);
    BOOST_TEST(tips.size() == 5u);
    BOOST_TEST((a.parts[tips.front().tip_a] == other.get().parts[tips.front().tip_b]));
    BOOST_TEST(
      std::is_sorted(tips.begin(), tips.end(), [](const Pair& p, const Pair& q) { return p.price < q.price; }));
    BOOST_REQUIRE(turned.size() == tips.size());
    BOOST_TEST((turned.front().tip_a == tips.front().tip_b));
    BOOST_TEST((turned.front().tip_b == tips.front().tip_a));
  }
  for(const Pair& pair : match(a, a))
  {
    BOOST_TEST((pair.tip_a == pair.tip_b));
    BOOST_TEST(std::abs(pair.price) < 1e-9);
  }
  const auto posed = generated_surfaces::posed_body(2, 25, 4500);
  auto numbers = own_numbers(posed.parts.size());
  Random random(3);
  random.shuffle(numbers);
  const auto renumbered = match(a, Compared_body(posed, 1e-150, numbers));
  BOOST_TEST(renumbered.size() == 5u);
  std::vector<Mesh::Vertex_index> originals(numbers.size());
  for(const auto v : a.mesh.vertices())
    originals[numbers[v]] = v;
  for(const Pair& pair : renumbered) // not of another limb, nor elsewhere on this one
    BOOST_TEST((a.mesh.point(pair.tip_a) - a.mesh.point(originals[pair.tip_b])).squared_length() < 0.01);
  Compared_body with_a_point = body(2, 27);
  with_a_point.mesh.add_vertex(a.mesh.point(a.top_of_head)); // of no face
  BOOST_TEST((match(a, with_a_point).front().tip_b == match(a, b).front().tip_b));
  Mesh two = a.mesh;
  two += b.mesh;
  std::vector<Pair> none;
  CGAL::Reeb_graph::match_tips(two, a.mesh, std::back_inserter(none));
  BOOST_TEST(none.empty());
}

// Of a sphere, a torus, and a double one with noise, whose graphs can be alike wherever they begin.
BOOST_AUTO_TEST_CASE(tips_do_not_depend_on_numbers_or_on_which_mesh_is_first)
{
  const generated_surfaces::Triangle_soup plain[] = {generated_surfaces::closed_surface(0, 300),
                                                     generated_surfaces::torus(24, 12),
                                                     generated_surfaces::closed_surface(2, 400)};
  std::size_t different = 0, asymmetric = 0, number = 0;
  for(std::size_t seed = 0; seed < 10; ++seed)
    for(const auto& given : plain)
    {
      Random random(seed);
      auto soup = given, other = plain[seed % 3];
      for(auto* points : {&soup.points, &other.points})
        for(auto& p : *points)
          for(double& x : p)
            x += 1e-3 * static_cast<double>(random.below(1000)) / 100;
      auto numbers = own_numbers(soup.points.size());
      random.shuffle(numbers);
      generated_surfaces::Triangle_soup renumbered = soup;
      for(std::size_t v = 0; v < numbers.size(); ++v)
        renumbered.points[numbers[v]] = soup.points[v];
      for(auto& triangle : renumbered.triangles)
        for(std::size_t& v : triangle)
          v = numbers[v];
      const auto a = generated_surfaces::make_mesh<Mesh>(soup), b = generated_surfaces::make_mesh<Mesh>(renumbered),
                 c = generated_surfaces::make_mesh<Mesh>(other);
      std::vector<CGAL::Reeb_graph::Tip_pair<Mesh::Vertex_index, Mesh::Vertex_index>> same, there, back;
      CGAL::Reeb_graph::match_tips(a, b, std::back_inserter(same));
      CGAL::Reeb_graph::match_tips(a, c, std::back_inserter(there));
      CGAL::Reeb_graph::match_tips(c, a, std::back_inserter(back));
      BOOST_REQUIRE(!same.empty());
      different += numbers[same.front().tip_a] == same.front().tip_b ? 0 : 1;
      asymmetric += there.front().tip_a == back.front().tip_b && there.front().tip_b == back.front().tip_a ? 0 : 1;
      ++number;
    }
  BOOST_TEST_MESSAGE(different << " and " << asymmetric << " of " << number);
  BOOST_TEST(20 * different <= number);
  BOOST_TEST(20 * asymmetric <= number);
}

BOOST_AUTO_TEST_CASE(units_numbers_and_order_change_no_partner)
{
  const auto posed = generated_surfaces::posed_body(3, 7, 4500);
  const Compared_body a = body(2, 4), b(posed, 1, own_numbers(posed.parts.size()));
  auto expected = matched_leaves(a, b);
  Random random(1);
  auto numbers = own_numbers(posed.parts.size());
  random.shuffle(numbers);
  auto turned = matched_leaves(b, a);
  for(auto& [leaf_a, leaf_b] : expected)
    leaf_b = numbers[leaf_b];
  for(const double unit : {1e-200, 1e150, 1e200})
    BOOST_TEST((matched_leaves(a, Compared_body(posed, unit, numbers)) == expected));
  for(auto& [leaf_b, leaf_a] : turned)
    std::swap(leaf_b = numbers[leaf_b], leaf_a);
  std::sort(expected.begin(), expected.end());
  std::sort(turned.begin(), turned.end());
  BOOST_TEST((turned == expected));
}

BOOST_AUTO_TEST_CASE(what_cannot_be_matched_is_refused)
{
  const Compared_body a = body(0, 0);
  std::vector<std::pair<boost::graph_traits<Graph>::edge_descriptor, boost::graph_traits<Graph>::edge_descriptor>> none;
  const auto match = [&](const Compared_body& other, double price) {
    CGAL::Reeb_graph::match_arcs(a.graph, a.augmentation(), other.graph, other.augmentation(), std::back_inserter(none),
                                 CGAL::parameters::price_alone(price));
  };
  BOOST_CHECK_THROW(match(a, -1), CGAL::Reeb_graph::Parameter_error);
  Compared_body noisy = body(0, 0);
  Random random(0);
  for(const auto v : vertices(noisy.mesh))
    noisy.field[v] = static_cast<double>(random.below(1000000));
  CGAL::compute_reeb_graph(noisy.mesh, noisy.field, noisy.graph);
  BOOST_CHECK_THROW(match(noisy, 1), CGAL::Reeb_graph::Too_many_arcs_error);
  BOOST_TEST(none.empty());
  match(a, 0); // nothing is as near as that but what is equal
  BOOST_TEST(none.size() == num_edges(a.graph));
}

BOOST_AUTO_TEST_SUITE_END()
