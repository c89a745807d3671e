// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#include <boost/test/unit_test.hpp>

#include "curve_samples.h"
#include "cut_mesh_checks.h"
#include "level_oracle.h"

#include <CGAL/Dynamic_property_map.h>
#include <CGAL/Exact_rational.h>
#include <CGAL/Reeb_graph/curves/cut_along_levels.h>

#include <boost/mpl/list.hpp>
#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <iterator>
#include <limits>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

// Meshes cut along the level sets of values, compared with marching from triangle to triangle in exact fractions.

BOOST_AUTO_TEST_SUITE(test_cut_along_levels)

using curve_samples::Sample;
using level_oracle::Key;
using mesh_builders::Polyhedron;
using mesh_builders::Surface_mesh;
namespace parameters = CGAL::parameters;

typedef boost::mpl::list<Surface_mesh, Polyhedron> Meshes;

namespace {
// Values of vertices, values between those of two, and values beyond all.
std::vector<double> random_levels(const Sample& sample, std::size_t seed)
{
  random_meshes::Random random(seed + 7);
  std::vector<double> levels;
  for(std::size_t i = random.below(6); i > 0 && !sample.values.empty(); --i)
  {
    const double a = sample.values[random.below(sample.values.size())],
                 b = sample.values[random.below(sample.values.size())];
    const std::vector<double> choices = {a, a, a + 0.25 * (b - a), a + 0.3 * (b - a), a + 1e-9 * (b - a)};
    const double level = choices[random.below(choices.size())];
    levels.push_back(std::isnan(level) ? 0 : level);
  }
  if(random.below(4) == 0)
    levels.push_back(1e9);
  if(random.below(4) == 0 && !levels.empty())
    levels.push_back(levels.front());
  return levels;
}

// Where vertices are: on which edge of the input, at which fraction.
template <class Mesh>
struct Places : CGAL::Reeb_graph::Default_refinement_visitor<Mesh>
{
  typedef typename boost::graph_traits<Mesh>::vertex_descriptor vertex_descriptor;

  explicit Places(const Mesh& mesh)
  {
    for(const auto v : vertices(mesh))
    {
      const std::size_t number = keys.size();
      keys[v] = {number, number};
    }
  }

  void vertex_added(vertex_descriptor v, vertex_descriptor u, vertex_descriptor w, double t)
  {
    keys[v] = {keys.at(u)[0], keys.at(w)[0]};
    fractions[v] = t;
  }
  void vertex_duplicated(vertex_descriptor old, vertex_descriptor created) { keys[created] = keys.at(old); }

  std::map<vertex_descriptor, Key> keys;
  std::map<vertex_descriptor, double> fractions;
};

template <class Mesh>
struct Level_sample
{
  typedef typename boost::graph_traits<Mesh>::halfedge_descriptor halfedge_descriptor;
  typedef typename boost::graph_traits<Mesh>::face_descriptor face_descriptor;
  typedef typename boost::graph_traits<Mesh>::vertex_descriptor vertex_descriptor;
  typedef typename boost::property_map<Mesh, CGAL::dynamic_vertex_property_t<double>>::type Scalar_map;

  explicit Level_sample(const Sample& sample, const std::vector<double>& given_levels)
    : mesh(curve_samples::make_mesh<Mesh>(sample.soup)),
      scalar_map(get(CGAL::dynamic_vertex_property_t<double>(), mesh)),
      places(mesh),
      levels(given_levels)
  {
    std::size_t number = 0;
    for(const auto v : vertices(mesh))
      put(scalar_map, v, sample.values[number++]);
  }

  template <class NamedParameters>
  void cut(const NamedParameters& np)
  {
    cut_with(with_maps(np));
  }
  template <class NamedParameters>
  void cut(const NamedParameters& np, const std::function<bool(double)>& callback)
  {
    cut_with(with_maps(np).callback(callback));
  }

  template <class NamedParameters>
  auto with_maps(const NamedParameters& np)
  {
    return np.face_band_map(boost::make_assoc_property_map(bands))
      .face_patch_map(boost::make_assoc_property_map(patches))
      .visitor(std::ref(places));
  }
  template <class NamedParameters>
  void cut_with(const NamedParameters& np)
  {
    report = CGAL::Reeb_graph::cut_along_levels(mesh, scalar_map, levels, std::back_inserter(curves), np);
    std::sort(levels.begin(), levels.end());
    levels.erase(std::unique(levels.begin(), levels.end()), levels.end());
  }

  double area(face_descriptor f) const
  {
    const auto map = get(CGAL::vertex_point, mesh);
    const auto h = halfedge(f, mesh);
    const auto p = get(map, source(h, mesh)), q = get(map, target(h, mesh)), r = get(map, target(next(h, mesh), mesh));
    return std::sqrt(CGAL::cross_product(q - p, r - p).squared_length()) / 2;
  }

  std::vector<std::pair<std::size_t, double>> pieces() const
  {
    std::map<std::size_t, std::pair<std::size_t, double>> sums;
    for(const face_descriptor f : faces(mesh))
    {
      sums[patches.at(f)].first = bands.at(f);
      sums[patches.at(f)].second += area(f);
    }
    std::vector<std::pair<std::size_t, double>> result;
    for(const auto& [patch, piece] : sums)
      result.push_back(piece);
    std::sort(result.begin(), result.end());
    return result;
  }

  Mesh mesh;
  Scalar_map scalar_map;
  Places<Mesh> places;
  std::vector<double> levels;
  std::vector<CGAL::Reeb_graph::Curve<halfedge_descriptor>> curves;
  std::map<face_descriptor, std::size_t> bands, patches;
  CGAL::Reeb_graph::Level_cut_report report;
};

bool is_finite(const Sample& sample)
{
  return std::all_of(sample.values.begin(), sample.values.end(), [](double value) { return std::isfinite(value); });
}

// The curves are the segments of the oracle, each once, and end where there are not two of them.
template <class Mesh>
std::string fault_of_curves(const Level_sample<Mesh>& sample, const level_oracle::Marching& oracle)
{
  std::map<double, std::set<level_oracle::Segment>> found;
  std::map<Key, std::size_t> degrees;
  std::map<double, std::map<Key, std::size_t>> degrees_of_levels;
  double last = -std::numeric_limits<double>::infinity();
  for(const auto& curve : sample.curves)
  {
    if(curve.value < last)
      return "the curves are not in the order of their levels";
    last = curve.value;
    for(const auto h : curve.halfedges)
    {
      const Key a = sample.places.keys.at(source(h, sample.mesh)), b = sample.places.keys.at(target(h, sample.mesh));
      if(!found[curve.value].insert(level_oracle::make_segment(a, b)).second)
        return "a segment is there twice";
      ++degrees_of_levels[curve.value][a];
      ++degrees_of_levels[curve.value][b];
    }
  }
  for(const double level : sample.levels)
    if(found[level] != oracle.segments(level))
      return "other segments at level " + std::to_string(level);
  for(const auto& curve : sample.curves)
  {
    const auto degree = [&](auto v) { return degrees_of_levels[curve.value].at(sample.places.keys.at(v)); };
    for(std::size_t i = 0; i + 1 < curve.halfedges.size(); ++i)
      if(target(curve.halfedges[i], sample.mesh) != source(curve.halfedges[i + 1], sample.mesh)
         || degree(target(curve.halfedges[i], sample.mesh)) != 2)
        return "a curve passes where it has to branch";
    const auto first = source(curve.halfedges.front(), sample.mesh), end = target(curve.halfedges.back(), sample.mesh);
    if(curve.is_closed != (first == end))
      return "a curve is closed, or is not, unlike it says";
    if((degree(first) == 2 || degree(end) == 2) && !curve.is_closed)
      return "a curve ends too early";
  }
  return "";
}

typedef std::vector<std::pair<std::size_t, double>> Pieces;

std::string fault_of_pieces(const Pieces& pieces, const Pieces& expected)
{
  if(pieces.size() != expected.size())
    return std::to_string(pieces.size()) + " pieces, expected " + std::to_string(expected.size());
  for(std::size_t i = 0; i < pieces.size(); ++i)
    if(pieces[i].first != expected[i].first || !(std::abs(pieces[i].second - expected[i].second) < 1e-3))
      return "a piece of band " + std::to_string(pieces[i].first) + " has an area of "
           + std::to_string(pieces[i].second) + " instead of " + std::to_string(expected[i].second);
  return "";
}

// The vertices of the input are where they were, with their values, and the others are where the field has the value.
template <class Mesh>
std::string fault_of_vertices(const Level_sample<Mesh>& sample,
                              const Sample& input,
                              const level_oracle::Marching& oracle)
{
  const auto point_map = get(CGAL::vertex_point, sample.mesh);
  const auto point = [&](std::size_t v) {
    const auto& p = input.soup.points[v];
    return mesh_builders::Point(p[0], p[1], p[2]);
  };
  for(const auto v : vertices(sample.mesh))
  {
    const auto [key, value] = std::make_pair(sample.places.keys.at(v), get(sample.scalar_map, v));
    if(key[0] == key[1])
    {
      if(get(point_map, v) != point(key[0]) || value != input.values[key[0]])
        return "a vertex of the input has changed";
      continue;
    }
    const double t = sample.places.fractions.at(v);
    if(std::count(sample.levels.begin(), sample.levels.end(), value) != 1)
      return "an added vertex is at no level";
    if(std::isfinite(input.values[key[0]]) && std::isfinite(input.values[key[1]]))
    {
      const double exact = CGAL::to_double(oracle.fraction(key, value));
      if(std::abs(t - exact) > 4 * std::numeric_limits<double>::epsilon() * exact)
        return "an added vertex is not at the fraction of its level";
    }
    if(get(point_map, v) != point(key[0]) + t * (point(key[1]) - point(key[0])))
      return "an added vertex is not where it says";
  }
  return "";
}
} // namespace

BOOST_AUTO_TEST_CASE_TEMPLATE(curves_and_bands_are_those_of_marching, Mesh, Meshes)
{
  for(std::size_t seed = 0; seed < 400; ++seed)
    BOOST_TEST_CONTEXT("seed " << seed)
    {
      const Sample input = curve_samples::any_sample(seed);
      Level_sample<Mesh> sample(input, random_levels(input, seed));
      std::size_t number_of_faces = 0; // that is told before
      const auto tell = [&](std::size_t number) {
        number_of_faces = number;
        return true;
      };
      sample.cut(parameters::face_count_callback(tell));
      const level_oracle::Marching oracle(input, sample.levels);
      BOOST_TEST(cut_mesh_checks::is_valid_mesh(sample.mesh));
      BOOST_TEST(number_of_faces == faces(sample.mesh).size());
      BOOST_TEST(sample.report.number_of_levels == sample.levels.size());
      BOOST_TEST(sample.report.number_of_added_faces + input.soup.triangles.size() == faces(sample.mesh).size());
      BOOST_TEST(sample.report.number_of_added_vertices == sample.places.fractions.size());
      BOOST_TEST(fault_of_curves(sample, oracle) == "");
      BOOST_TEST(fault_of_vertices(sample, input, oracle) == "");
      if(!is_finite(input))
        continue;
      BOOST_TEST(fault_of_pieces(sample.pieces(), oracle.pieces()) == "");
    }
}

BOOST_AUTO_TEST_CASE_TEMPLATE(cutting_open_parts_the_pieces, Mesh, Meshes)
{
  for(std::size_t seed = 0; seed < 400; ++seed)
    BOOST_TEST_CONTEXT("seed " << seed)
    {
      const Sample input = curve_samples::any_sample(seed);
      Level_sample<Mesh> sample(input, random_levels(input, seed)), opened(input, random_levels(input, seed));
      sample.cut(parameters::cut_open(false));
      opened.cut(parameters::cut_open(true));
      BOOST_TEST(cut_mesh_checks::is_valid_mesh(opened.mesh));
      BOOST_TEST(faces(sample.mesh).size() == faces(opened.mesh).size());
      BOOST_TEST(fault_of_pieces(opened.pieces(), sample.pieces()) == "");
      BOOST_TEST(cut_mesh_checks::pieces_of(opened.mesh).size() == sample.pieces().size());
      auto pieces = cut_mesh_checks::pieces_of(opened.mesh),
           expected = cut_mesh_checks::pieces_between(sample.mesh, sample.curves);
      long characteristic = 0, expected_characteristic = 0;
      for(const auto& piece : pieces)
        characteristic += piece.euler_characteristic;
      for(const auto& piece : expected)
        expected_characteristic += piece.euler_characteristic;
      std::size_t number_of_shut_edges = 0;
      for(const auto& curve : opened.curves)
        for(std::size_t i = 0; i < curve.halfedges.size(); ++i)
        {
          const auto h = curve.halfedges[i], g = curve.lower_halfedges[i];
          const bool is_parted = is_border(edge(h, opened.mesh), opened.mesh);
          number_of_shut_edges += is_parted ? 0 : 1;
          BOOST_TEST((is_parted || curve.halfedges.size() == 1));
          for(const auto& [a, b] : {std::make_pair(source(h, opened.mesh), target(g, opened.mesh)),
                                    std::make_pair(target(h, opened.mesh), source(g, opened.mesh))})
          {
            BOOST_TEST((opened.places.keys.at(a) == opened.places.keys.at(b)));
            BOOST_TEST(get(opened.scalar_map, a) == get(opened.scalar_map, b));
          }
        }
      // An edge that is not opened is no hole.
      BOOST_TEST(characteristic == expected_characteristic + static_cast<long>(number_of_shut_edges));
    }
}

namespace {
// A square of two triangles with the values of its four corners, and the levels.
template <class Scalar, class Level>
std::size_t number_of_curves(const std::vector<Scalar>& values, const std::vector<Level>& levels)
{
  Surface_mesh mesh =
    curve_samples::make_mesh<Surface_mesh>({{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, {{0, 1, 2}, {0, 2, 3}}});
  auto map = mesh.add_property_map<Surface_mesh::Vertex_index, Scalar>("v:scalar").first;
  std::copy(values.begin(), values.end(), map.begin());
  std::vector<CGAL::Reeb_graph::Curve<Surface_mesh::Halfedge_index>> curves;
  CGAL::Reeb_graph::cut_along_levels(mesh, map, levels, std::back_inserter(curves));
  for(const auto v : mesh.vertices())
    if(std::size_t(v) >= values.size())
      BOOST_TEST((std::find(levels.begin(), levels.end(), map[v]) != levels.end()));
  return curves.size();
}
} // namespace

BOOST_AUTO_TEST_CASE(fields_of_other_numbers)
{
  BOOST_TEST((number_of_curves<int, int>({0, 2, 4, 2}, {1, 2, 3, 5}) == 3u));
  BOOST_TEST((number_of_curves<float, float>({0, 1, 2, 1}, {0.5, 1.25}) == 2u));
  typedef CGAL::Exact_rational Q;
  BOOST_TEST((number_of_curves<Q, Q>({Q(0), Q(1, 3), Q(1), Q(1, 3)}, {Q(1, 3), Q(1, 7)}) == 2u));
}

BOOST_AUTO_TEST_CASE(a_plateau_is_in_the_band_below_and_each_of_its_edges_is_a_curve)
{
  // The corner 4 is in the middle of a square.
  const Sample input = {
    {{{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}, {1, 1, 0}}, {{0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}}},
    {1, 1, 2, 0, 1}};
  Level_sample<Surface_mesh> sample(input, {1});
  sample.cut(parameters::cut_open(false));
  std::vector<std::size_t> bands;
  for(const auto f : sample.mesh.faces())
    bands.push_back(sample.bands.at(f));
  BOOST_TEST(bands == (std::vector<std::size_t>{0, 1, 1, 0, 0}), boost::test_tools::per_element());
  BOOST_TEST(sample.curves.size() == 2u); // The loop around the plateau ends where the other one begins.
  BOOST_TEST(sample.pieces().size() == 3u);
}

BOOST_AUTO_TEST_CASE(slivers_are_counted)
{
  const Sample input = {{{{0, 0, 0}, {1, 0, 1}, {0, 1, 2}}, {{0, 1, 2}}}, {0, 1, 2}};
  Level_sample<Surface_mesh> sample(input, {1 - 1e-3, 1, 1 + 1e-3});
  sample.cut(parameters::cut_open(false));
  BOOST_TEST(sample.report.number_of_added_faces == 5u);
  BOOST_TEST(sample.report.number_of_slivers == 4u);
  for(const int exponent : {-660, -300, 300, 660})
  {
    const double unit = std::ldexp(1., exponent);
    Sample scaled = input;
    for(auto& point : scaled.soup.points)
      for(double& x : point)
        x *= unit;
    Level_sample<Surface_mesh> in_unit(scaled, {1 - 1e-3, 1, 1 + 1e-3});
    in_unit.cut(parameters::cut_open(false));
    BOOST_TEST(in_unit.report.number_of_slivers == 4u);
  }
  std::set<double> heights;
  for(const auto v : sample.mesh.vertices())
    heights.insert(sample.mesh.point(v).z());
  BOOST_TEST(heights.size() == 5u);
  Level_sample<Surface_mesh> low(input, {0.01});
  low.cut(parameters::cut_open(false));
  for(const auto v : low.mesh.vertices())
    BOOST_TEST((v < Surface_mesh::Vertex_index(3) || low.mesh.point(v).z() == 0.01));
}

BOOST_AUTO_TEST_CASE(the_higher_side_is_on_the_left)
{
  for(std::size_t seed = 0; seed < 100; ++seed)
    BOOST_TEST_CONTEXT("seed " << seed)
    {
      Sample input = curve_samples::smooth_sample(static_cast<unsigned>(seed % 4), 300, 0);
      Level_sample<Surface_mesh> sample(input, {-0.5, 0.1, 0.3});
      sample.cut(parameters::cut_open(seed % 2 == 0));
      const auto value_beside = [&](auto h) {
        return get(sample.scalar_map, target(next(h, sample.mesh), sample.mesh));
      };
      for(const auto& curve : sample.curves)
        for(std::size_t i = 0; i < curve.halfedges.size(); ++i)
        {
          BOOST_TEST(value_beside(curve.halfedges[i]) > curve.value);
          BOOST_TEST(value_beside(curve.lower_halfedges[i]) < curve.value);
        }
    }
}

BOOST_AUTO_TEST_CASE_TEMPLATE(what_is_thrown_leaves_the_mesh_as_it_was, Mesh, Meshes)
{
  const Sample input = curve_samples::smooth_sample(2, 400, 0);
  const auto check = [&](const std::vector<double>& levels, const auto& cut, const auto& is_expected) {
    Level_sample<Mesh> sample(input, levels);
    BOOST_CHECK_EXCEPTION(cut(sample), CGAL::Reeb_graph::Error, is_expected);
    BOOST_TEST(vertices(sample.mesh).size() == input.soup.points.size());
    BOOST_TEST(faces(sample.mesh).size() == input.soup.triangles.size());
    BOOST_TEST(cut_mesh_checks::is_valid_mesh(sample.mesh));
    BOOST_TEST(sample.curves.empty());
  };
  const double nan = std::numeric_limits<double>::quiet_NaN();
  check(
    {0, nan}, [](auto& sample) { sample.cut(parameters::cut_open(false)); },
    [](const CGAL::Reeb_graph::Error& error) {
      const auto* level_error = dynamic_cast<const CGAL::Reeb_graph::Unordered_level_error*>(&error);
      return level_error != nullptr && level_error->level() == 1;
    });
  check(
    {0}, [](auto& sample) { sample.cut(parameters::face_count_callback([](std::size_t) { return false; })); },
    [](const CGAL::Reeb_graph::Error& error) {
      return dynamic_cast<const CGAL::Reeb_graph::Face_count_error*>(&error) != nullptr;
    });
  for(const double last : {0., 0.2, 0.5, 0.7})
    check(
      {-0.2, 0, 0.1},
      [last](auto& sample) { sample.cut(parameters::cut_open(true), [last](double done) { return done <= last; }); },
      [](const CGAL::Reeb_graph::Error& error) {
        return dynamic_cast<const CGAL::Reeb_graph::Cancelled_error*>(&error) != nullptr;
      });
}

BOOST_AUTO_TEST_SUITE_END()
