// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#include <boost/test/unit_test.hpp>

#include "curve_samples.h"
#include "mesh_builders.h"

#include <CGAL/Quotient.h>
#include <CGAL/Reeb_graph/fields/make_borders_level.h>
#include <CGAL/Reeb_graph/scalar_maps.h>
#include <CGAL/compute_reeb_graph.h>

#include <boost/mpl/list.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <set>
#include <string>
#include <utility>
#include <vector>

// Fields are changed so that borders are extremal levels.

BOOST_AUTO_TEST_SUITE(test_make_borders_level)

using CGAL::Reeb_graph::Border_extremum;
using CGAL::Reeb_graph::Border_level_changes;
using curve_samples::Sample;
using mesh_builders::Polyhedron;
using mesh_builders::Surface_mesh;
using random_meshes::Combinatorial_mesh;
using random_meshes::Random;

typedef boost::mpl::list<Surface_mesh, Polyhedron> Meshes;
typedef boost::mpl::list<float, int, CGAL::Quotient<long>> Other_scalars;

namespace {
constexpr std::size_t everywhere = std::numeric_limits<std::size_t>::max();

struct Result
{
  std::vector<double> values;
  Border_level_changes changes;
};

template <class Mesh>
Result make_level(const Sample& sample, Border_extremum extremum, std::size_t width)
{
  const Mesh mesh = curve_samples::make_mesh<Mesh>(sample.soup);
  const auto scalar_map = CGAL::Reeb_graph::make_scalar_map(mesh, sample.values);
  Result result;
  result.changes = CGAL::Reeb_graph::make_borders_level(
    mesh, scalar_map, CGAL::parameters::border_extremum(extremum).collar_width(width));
  for(const auto v : vertices(mesh))
    result.values.push_back(get(scalar_map, v));
  return result;
}

double distance(double a, double b) { return a == b ? 0 : std::abs(a - b); }

// What the results are compared with, found from the triangles only.
class Oracle
{
public:
  explicit Oracle(const Sample& sample)
    : sample_(sample),
      neighbors_(sample.values.size()),
      number_of_border_(sample.values.size(), everywhere),
      loops_(random_meshes::border_loops({sample.values.size(), sample.soup.triangles}))
  {
    for(const auto& t : sample.soup.triangles)
      for(const std::size_t u : t)
        for(const std::size_t v : t)
          if(u != v)
            neighbors_[u].insert(v);
    for(std::size_t i = 0; i < loops_.size(); ++i)
      for(const std::size_t v : loops_[i])
        number_of_border_[v] = i;
  }

  std::size_t number_of_borders() const { return loops_.size(); }

  std::string fault(const Result& result, std::size_t width) const
  {
    if(!curve_samples::are_borders_extremal({sample_.soup, result.values}))
      return "a border is no extremal level";
    const std::string fault_of_changes = fault_of_report(result);
    if(!fault_of_changes.empty())
      return fault_of_changes;
    const std::vector<std::size_t> distances = distances_from_changed_borders(result.values);
    for(std::size_t v = 0; v < distances.size(); ++v)
      if(is_changed(result.values, v) && distances[v] > width)
        return "a vertex outside of the collar has changed";
    for(std::size_t i = 0; i < loops_.size(); ++i)
      if(!touches_another(i))
      {
        const auto [lowest, highest] = range_of_border(i);
        const double largest = is_extremal_level(i) ? 0 : (highest - lowest) * (1 + 1 / 1023.);
        for(const std::size_t v : loops_[i])
          if(distance(sample_.values[v], result.values[v]) > largest)
            return "a border has changed too much";
      }
    return "";
  }

  // Minima, or maxima if the sign is -1, on no border that there were not before. Those are left out the basin of which
  // reaches a border before it reaches lower ground, so that no pass is below the border.
  std::size_t number_of_needless_minima(const std::vector<double>& values, int sign) const
  {
    std::size_t number = 0;
    for(std::size_t v = 0; v < values.size(); ++v)
      if(is_minimum(values, sign, v) && !is_minimum(sample_.values, sign, v) && number_of_border_[v] == everywhere
         && !does_basin_reach_border(values, sign, v))
        ++number;
    return number;
  }

  std::size_t number_of_new_extrema(const std::vector<double>& values) const
  {
    std::size_t number = 0;
    for(std::size_t v = 0; v < values.size(); ++v)
      for(const int sign : {1, -1})
        number +=
          number_of_border_[v] == everywhere && is_minimum(values, sign, v) && !is_minimum(sample_.values, sign, v) ? 1
                                                                                                                    : 0;
    return number;
  }

private:
  bool is_changed(const std::vector<double>& values, std::size_t v) const { return values[v] != sample_.values[v]; }

  std::string fault_of_report(const Result& result) const
  {
    Border_level_changes expected;
    expected.number_of_borders = loops_.size();
    for(const auto& loop : loops_)
      expected.number_of_changed_borders +=
        std::any_of(loop.begin(), loop.end(), [&](std::size_t v) { return is_changed(result.values, v); }) ? 1 : 0;
    for(std::size_t v = 0; v < result.values.size(); ++v)
    {
      expected.number_of_changed_vertices += is_changed(result.values, v) ? 1 : 0;
      expected.largest_change = std::max(expected.largest_change, distance(sample_.values[v], result.values[v]));
    }
    return expected.number_of_borders == result.changes.number_of_borders
            && expected.number_of_changed_borders == result.changes.number_of_changed_borders
            && expected.number_of_changed_vertices == result.changes.number_of_changed_vertices
            && expected.largest_change == result.changes.largest_change
           ? ""
           : "the report is wrong";
  }

  std::vector<std::size_t> distances_from_changed_borders(const std::vector<double>& values) const
  {
    std::vector<std::size_t> distances(values.size(), everywhere), reached;
    for(const auto& loop : loops_)
      for(const std::size_t v : loop)
        if(is_changed(values, v))
        {
          distances[v] = 0;
          reached.push_back(v);
        }
    for(std::size_t i = 0; i < reached.size(); ++i)
      for(const std::size_t v : neighbors_[reached[i]])
        if(distances[v] == everywhere && number_of_border_[v] == everywhere)
        {
          distances[v] = distances[reached[i]] + 1;
          reached.push_back(v);
        }
    return distances;
  }

  bool touches_another(std::size_t border) const
  {
    for(const std::size_t v : loops_[border])
      for(const std::size_t u : neighbors_[v])
        if(number_of_border_[u] != everywhere && number_of_border_[u] != border)
          return true;
    return false;
  }

  // the range of the values of a border and its neighbors
  std::pair<double, double> range_of_border(std::size_t border) const
  {
    const double first = sample_.values[loops_[border].front()];
    std::pair<double, double> range(first, first);
    const auto add = [&](std::size_t v) {
      range = {std::min(range.first, sample_.values[v]), std::max(range.second, sample_.values[v])};
    };
    for(const std::size_t v : loops_[border])
    {
      add(v);
      std::for_each(neighbors_[v].begin(), neighbors_[v].end(), add);
    }
    return range;
  }

  bool is_extremal_level(std::size_t border) const
  {
    const double value = sample_.values[loops_[border].front()];
    const auto range = range_of_border(border);
    return (value == range.first || value == range.second)
        && std::all_of(loops_[border].begin(), loops_[border].end(),
                       [&](std::size_t v) { return sample_.values[v] == value; });
  }

  static bool is_lower(const std::vector<double>& values, int sign, std::size_t u, std::size_t v)
  {
    return sign > 0 ? std::make_pair(values[u], u) < std::make_pair(values[v], v)
                    : std::make_pair(values[v], v) < std::make_pair(values[u], u);
  }

  bool is_minimum(const std::vector<double>& values, int sign, std::size_t v) const
  {
    return std::none_of(neighbors_[v].begin(), neighbors_[v].end(),
                        [&](std::size_t u) { return is_lower(values, sign, u, v); });
  }

  bool does_basin_reach_border(const std::vector<double>& values, int sign, std::size_t minimum) const
  {
    std::set<std::size_t> basin = {minimum}, shore = neighbors_[minimum];
    const auto less = [&](std::size_t u, std::size_t v) { return is_lower(values, sign, u, v); };
    while(!shore.empty())
    {
      const auto lowest = std::min_element(shore.begin(), shore.end(), less);
      const std::size_t v = *lowest;
      if(number_of_border_[v] != everywhere)
        return true;
      shore.erase(lowest);
      basin.insert(v);
      for(const std::size_t u : neighbors_[v])
      {
        if(basin.count(u) != 0)
          continue;
        if(less(u, v))
          return false;
        shore.insert(u);
      }
    }
    return true;
  }

  Sample sample_;
  std::vector<std::set<std::size_t>> neighbors_;
  std::vector<std::size_t> number_of_border_;
  std::vector<std::vector<std::size_t>> loops_;
};

// as many different values as vertices, in their order, and integers
void part_ties(std::vector<double>& values)
{
  std::vector<std::pair<double, std::size_t>> order;
  for(std::size_t v = 0; v < values.size(); ++v)
    order.emplace_back(values[v], v);
  std::sort(order.begin(), order.end());
  for(std::size_t i = 0; i < order.size(); ++i)
    values[order[i].second] = static_cast<double>(i);
}
} // namespace

BOOST_AUTO_TEST_CASE_TEMPLATE(any_meshes_and_fields, Mesh, Meshes)
{
  std::size_t number_of_borders = 0, number_of_changed = 0;
  for(std::size_t seed = 0; seed < 600; ++seed)
    BOOST_TEST_CONTEXT("seed " << seed)
    {
      const Sample sample = curve_samples::any_sample(seed);
      const Oracle oracle(sample);
      for(const Border_extremum extremum :
          {Border_extremum::AUTOMATIC, Border_extremum::MINIMUM, Border_extremum::MAXIMUM})
        for(const std::size_t width : {std::size_t(0), std::size_t(1), std::size_t(3), everywhere})
        {
          const Result result = make_level<Mesh>(sample, extremum, width);
          BOOST_TEST(oracle.fault(result, width) == "");
          const Result again = make_level<Mesh>({sample.soup, result.values}, extremum, width);
          BOOST_TEST(again.changes.number_of_changed_vertices == 0u);
          number_of_borders += result.changes.number_of_borders;
          number_of_changed += result.changes.number_of_changed_borders;
        }
    }
  BOOST_TEST(number_of_borders > 5000u);
  BOOST_TEST(number_of_changed > 4000u);
}

BOOST_AUTO_TEST_CASE(no_extremum_arises_that_need_not)
{
  std::size_t number_of_narrow = 0, number_of_wide = 0;
  for(std::size_t seed = 0; seed < 1500; ++seed)
    BOOST_TEST_CONTEXT("seed " << seed)
    {
      Sample sample = curve_samples::any_sample(seed);
      part_ties(sample.values);
      const Oracle oracle(sample);
      for(const Border_extremum extremum :
          {Border_extremum::AUTOMATIC, Border_extremum::MINIMUM, Border_extremum::MAXIMUM})
      {
        const Result narrow = make_level<Surface_mesh>(sample, extremum, 0);
        const Result wide = make_level<Surface_mesh>(sample, extremum, everywhere);
        for(const int sign : {1, -1})
          BOOST_TEST(oracle.number_of_needless_minima(wide.values, sign) == 0u);
        number_of_narrow += oracle.number_of_new_extrema(narrow.values);
        number_of_wide += oracle.number_of_new_extrema(wide.values);
      }
    }
  BOOST_TEST(2 * number_of_narrow > 3 * number_of_wide);
}

namespace {
Sample make_sample(const Combinatorial_mesh& mesh, std::vector<double> values)
{
  return {mesh_builders::make_soup(mesh), std::move(values)};
}

template <class Scalar, class Mesh>
auto add_map(Mesh& mesh, const std::vector<double>& values)
{
  const auto map = get(CGAL::dynamic_vertex_property_t<Scalar>(), mesh);
  auto value = values.begin();
  for(const auto v : vertices(mesh))
    put(map, v, static_cast<Scalar>(*value++));
  return map;
}

// whether there are three borders, all vertices are on them, and each touches the other two
bool do_three_borders_touch(const Combinatorial_mesh& mesh)
{
  const auto loops = random_meshes::border_loops(mesh);
  if(loops.size() != 3 || loops[0].size() + loops[1].size() + loops[2].size() != mesh.number_of_vertices)
    return false;
  const auto number_of = [&](std::size_t v) {
    return std::find_if(loops.begin(), loops.end(),
                        [&](const auto& loop) { return std::count(loop.begin(), loop.end(), v) != 0; })
         - loops.begin();
  };
  std::set<std::ptrdiff_t> sums;
  for(const auto& t : mesh.triangles)
    for(std::size_t i = 0; i < 3; ++i)
      if(number_of(t[i]) != number_of(t[(i + 1) % 3]))
        sums.insert(number_of(t[i]) + number_of(t[(i + 1) % 3]));
  return sums.size() == 3;
}

std::size_t number_of_nodes(const Sample& sample)
{
  const auto mesh = curve_samples::make_mesh<Surface_mesh>(sample.soup);
  const auto scalar_map = CGAL::Reeb_graph::make_scalar_map(mesh, sample.values);
  typename CGAL::Reeb_graph_traits<Surface_mesh, std::decay_t<decltype(scalar_map)>>::Graph graph;
  CGAL::compute_reeb_graph(mesh, scalar_map, graph, CGAL::parameters::ties(CGAL::Reeb_graph::Ties::CONTRACT));
  return num_vertices(graph);
}
} // namespace

// A hole in a slope: the border goes up or down, whichever is nearer, and the saddle that belongs to it is the only
// one.
BOOST_AUTO_TEST_CASE(the_nearer_extremum_is_taken)
{
  // the plane cylinder of three rings, with values 0..3 on the inner one, and a slope on the other ones
  const Combinatorial_mesh mesh = random_meshes::cylinder(4, 3);
  const Sample sample = make_sample(mesh, {6, 7, 8, 7, 0, 5, 9, 5, -20, -20, -20, -20});
  const Result automatic = make_level<Surface_mesh>(sample, Border_extremum::AUTOMATIC, 3);
  BOOST_TEST(automatic.changes.number_of_borders == 2u);
  BOOST_TEST(automatic.changes.number_of_changed_borders == 1u);
  BOOST_TEST(automatic.values[0] == 9 + 9. / 1024);
  BOOST_TEST(automatic.values[4] == 0);
  const Result lower = make_level<Surface_mesh>(sample, Border_extremum::MINIMUM, 3);
  BOOST_TEST(lower.values[0] == -9. / 1024);
  BOOST_TEST(lower.values[8] == -20);
  BOOST_TEST(number_of_nodes({sample.soup, automatic.values}) == 2u);
}

BOOST_AUTO_TEST_CASE(two_borders_without_inner_vertices)
{
  const Combinatorial_mesh mesh = random_meshes::cylinder(3, 2);
  const Sample sample = make_sample(mesh, {4, 5, 6, 0, 1, 2});
  for(const Border_extremum extremum : {Border_extremum::AUTOMATIC, Border_extremum::MINIMUM, Border_extremum::MAXIMUM})
  {
    const Result result = make_level<Surface_mesh>(sample, extremum, 3);
    BOOST_TEST(result.changes.number_of_changed_vertices == (extremum == Border_extremum::AUTOMATIC ? 4u : 6u));
    const bool is_constant = extremum != Border_extremum::AUTOMATIC;
    BOOST_TEST(result.values == (is_constant ? std::vector<double>(6, 3) : std::vector<double>({5, 5, 5, 1, 1, 1})),
               boost::test_tools::per_element());
    BOOST_TEST(number_of_nodes({sample.soup, result.values}) == (is_constant ? 1u : 2u));
  }
}

// Three holes of three edges each that have all vertices of a sphere. Two of them share one level.
BOOST_AUTO_TEST_CASE(three_borders_that_touch_each_other)
{
  Combinatorial_mesh mesh;
  std::vector<double> values;
  std::size_t number_found = 0;
  for(std::size_t seed = 0; seed < 400; ++seed)
    BOOST_TEST_CONTEXT("seed " << seed)
    {
      Random random(seed);
      mesh = random_meshes::random_closed_surface(0, 5, random);
      random_meshes::remove_far_triangles(mesh, 3, random);
      if(!do_three_borders_touch(mesh))
        continue;
      ++number_found;
      const Sample sample = make_sample(mesh, random_meshes::random_permutation(9, random));
      const Result result = make_level<Surface_mesh>(sample, Border_extremum::AUTOMATIC, 3);
      BOOST_TEST(curve_samples::are_borders_extremal({sample.soup, result.values}));
      BOOST_TEST(std::set<double>(result.values.begin(), result.values.end()).size() == 2u);
    }
  BOOST_TEST(number_found > 20u);
}

BOOST_AUTO_TEST_CASE(a_disk_becomes_constant_only_without_inner_vertices)
{
  const Sample fan = make_sample(random_meshes::half_disk(5), {3, 1, 4, 1, 5, 9});
  BOOST_TEST(make_level<Surface_mesh>(fan, Border_extremum::AUTOMATIC, 3).values == std::vector<double>(6, 5),
             boost::test_tools::per_element());
  const Sample disk = make_sample(random_meshes::disk(4), {2, 1, 2, 3, 4});
  for(const auto& values : {make_level<Polyhedron>(disk, Border_extremum::AUTOMATIC, 3).values,
                            make_level<Surface_mesh>(disk, Border_extremum::MAXIMUM, 3).values})
    BOOST_TEST(values == std::vector<double>({2, 2.5, 2.5, 2.5, 2.5}), boost::test_tools::per_element());
  BOOST_TEST(make_level<Surface_mesh>(disk, Border_extremum::MINIMUM, 3).values[1] < 2);
}

// The wave around the hole leaves minima in two valleys, if the border becomes a maximum; the lower one is an extremum
// by need, and the other one is filled to the pass between them, which is 3.
BOOST_AUTO_TEST_CASE(a_basin_is_filled_to_its_lowest_pass)
{
  const Combinatorial_mesh mesh = random_meshes::cylinder(4, 3);
  const Sample sample = make_sample(mesh, {0, 0, 0, -1, 1, 4, 2, 3, 9, 9, 9, 9});
  const Result narrow = make_level<Surface_mesh>(sample, Border_extremum::MAXIMUM, 0);
  const Result wide = make_level<Surface_mesh>(sample, Border_extremum::MAXIMUM, 1);
  for(const std::size_t v : {4, 5, 7, 8})
    BOOST_TEST(wide.values[v] == sample.values[v]);
  BOOST_TEST(narrow.values[6] == 2);
  BOOST_TEST(wide.values[6] > 3);
  BOOST_TEST(wide.values[6] <= 3 + 1. / 16);
  BOOST_TEST(wide.changes.number_of_changed_vertices == narrow.changes.number_of_changed_vertices + 1);
}

// Without arithmetic, a border gets a value of a vertex next to it, or of its own.
BOOST_AUTO_TEST_CASE_TEMPLATE(other_scalars, Scalar, Other_scalars)
{
  for(std::size_t seed = 0; seed < 200; ++seed)
    BOOST_TEST_CONTEXT("seed " << seed)
    {
      Sample sample = curve_samples::any_sample(seed);
      part_ties(sample.values);
      auto mesh = curve_samples::make_mesh<Surface_mesh>(sample.soup);
      const auto scalar_map = add_map<Scalar>(mesh, sample.values);
      const std::set<double> values(sample.values.begin(), sample.values.end());
      CGAL::Reeb_graph::make_borders_level(mesh, scalar_map);
      Sample result = {sample.soup, {}};
      for(const auto v : vertices(mesh))
        result.values.push_back(CGAL::to_double(get(scalar_map, v)));
      BOOST_TEST(curve_samples::are_borders_extremal(result));
      if(!std::is_floating_point_v<Scalar>)
        BOOST_TEST(std::all_of(result.values.begin(), result.values.end(),
                               [&](double value) { return values.count(value) != 0; }));
    }
}

namespace {
// descending values
struct Descending_traits
  : CGAL::Reeb_graph_traits<Surface_mesh, Surface_mesh::Property_map<Surface_mesh::Vertex_index, double>>
{
  typedef std::greater<double> Less_scalar;
  Less_scalar less_scalar_object() const { return Less_scalar(); }
};
} // namespace

BOOST_AUTO_TEST_CASE(another_order)
{
  const Sample sample = make_sample(random_meshes::cylinder(4, 3), {6, 7, 8, 7, 0, 5, 9, 5, -20, -20, -20, -20});
  auto mesh = curve_samples::make_mesh<Surface_mesh>(sample.soup);
  const auto scalar_map = mesh.add_property_map<Surface_mesh::Vertex_index, double>("v:scalar").first;
  for(const auto v : vertices(mesh))
    scalar_map[v] = sample.values[v];
  CGAL::Reeb_graph::make_borders_level(
    mesh, scalar_map, CGAL::parameters::border_extremum(Border_extremum::MAXIMUM).geom_traits(Descending_traits()));
  const std::vector<double> expected = {0, 0, 0, 0, 0, 5, 9, 5, -20, -20, -20, -20};
  for(const auto v : vertices(mesh))
    BOOST_TEST(scalar_map[v] == expected[v]);
}

BOOST_AUTO_TEST_CASE_TEMPLATE(wrong_input_leaves_the_field, Mesh, Meshes)
{
  Sample sample = make_sample(random_meshes::cylinder(4, 3), {6, 7, 8, 7, 0, 5, 9, 5, -20, -20, -20, -20});
  sample.values[5] = std::numeric_limits<double>::quiet_NaN();
  auto mesh = curve_samples::make_mesh<Mesh>(sample.soup);
  const auto scalar_map = add_map<double>(mesh, sample.values);
  BOOST_CHECK_EXCEPTION(CGAL::Reeb_graph::make_borders_level(mesh, scalar_map),
                        CGAL::Reeb_graph::Unordered_scalar_error,
                        [](const auto& error) { return error.vertex() == 5; });
  BOOST_TEST(get(scalar_map, *vertices(mesh).first) == 6);
}

BOOST_AUTO_TEST_SUITE_END()
