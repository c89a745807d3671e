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

#include <CGAL/Reeb_graph/Augmentation.h>
#include <CGAL/Reeb_graph/curves/Refinement_visitor.h>
#include <CGAL/Reeb_graph/curves/branch_curves.h>
#include <CGAL/Reeb_graph/curves/cut_along_contours.h>
#include <CGAL/Reeb_graph/curves/cutting_system.h>
#include <CGAL/Reeb_graph/curves/internal/cut_and_mark.h>
#include <CGAL/Reeb_graph/curves/pants_decomposition.h>
#include <CGAL/Reeb_graph/curves/segmentation.h>
#include <CGAL/Reeb_graph/curves/unfold_multi_saddles.h>
#include <CGAL/Reeb_graph/scalar_maps.h>
#include <CGAL/compute_reeb_graph.h>

#include <CGAL/Exact_rational.h>
#include <CGAL/Polygon_mesh_processing/measure.h>

#include <boost/mpl/list.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <iterator>
#include <limits>
#include <map>
#include <set>
#include <string>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

// The field and the attributes of a mesh that has been cut: the Reeb graph of the field is the same as before.

BOOST_AUTO_TEST_SUITE(test_refined_fields)

using namespace cut_mesh_checks;
using CGAL::Reeb_graph::Borders;
using CGAL::Reeb_graph::Node_kind;
using CGAL::Reeb_graph::Ties;
using curve_samples::Sample;
using mesh_builders::Polyhedron;
using mesh_builders::Surface_mesh;

typedef boost::mpl::list<Surface_mesh, Polyhedron> Meshes;
typedef boost::mpl::list<std::int16_t, std::uint16_t, std::int32_t, std::uint32_t, std::int64_t, std::uint64_t>
  Integers;

namespace {
template <class Mesh>
using Curves_of = std::vector<CGAL::Reeb_graph::Curve<typename boost::graph_traits<Mesh>::halfedge_descriptor>>;

// A map that can be written at vertices that are added.
template <class Mesh, class Scalar>
auto make_writable_map(Mesh& mesh, const std::vector<Scalar>& values)
{
  const auto scalar_map = get(CGAL::dynamic_vertex_property_t<Scalar>(), mesh);
  auto value = values.begin();
  for(const auto v : vertices(mesh))
    put(scalar_map, v, *value++);
  return scalar_map;
}

// A graph by the positions of the vertices of its nodes. Vertices that are added come behind the others.
struct Outline
{
  std::vector<std::pair<std::size_t, Node_kind>> nodes;
  std::vector<std::pair<std::size_t, std::size_t>> arcs;

  friend bool operator==(const Outline& a, const Outline& b) { return a.nodes == b.nodes && a.arcs == b.arcs; }
};

template <class Mesh, class Graph>
Outline outline(const Mesh& mesh, const Graph& graph)
{
  std::map<typename boost::graph_traits<Mesh>::vertex_descriptor, std::size_t> positions;
  for(const auto v : vertices(mesh))
    positions.emplace(v, positions.size());
  Outline result;
  for(const auto node : CGAL::make_range(vertices(graph)))
    result.nodes.emplace_back(positions.at(graph[node].vertex), graph[node].kind);
  for(const auto arc : CGAL::make_range(edges(graph)))
    result.arcs.emplace_back(result.nodes[source(arc, graph)].first, result.nodes[target(arc, graph)].first);
  std::sort(result.nodes.begin(), result.nodes.end());
  std::sort(result.arcs.begin(), result.arcs.end());
  return result;
}

template <class Mesh, class ScalarMap, class NamedParameters>
Outline outline_of_field(const Mesh& mesh, ScalarMap scalar_map, const NamedParameters& np)
{
  typename CGAL::Reeb_graph_traits<Mesh, ScalarMap>::Graph graph;
  CGAL::compute_reeb_graph(mesh, scalar_map, graph, np);
  return outline(mesh, graph);
}

// That of the graph whose saddles are simple, from which curves are chosen.
template <class Mesh, class Scalar, class NamedParameters>
Outline outline_of_unfolded(const Sample& sample, const std::vector<Scalar>& values, const NamedParameters& np)
{
  Mesh mesh = curve_samples::make_mesh<Mesh>(sample.soup);
  const auto scalar_map = make_writable_map(mesh, values);
  const auto rank_map = get(CGAL::dynamic_vertex_property_t<std::uint64_t>(), mesh);
  CGAL::Reeb_graph::unfold_multi_saddles(mesh, scalar_map, rank_map, np);
  const Outline result = outline_of_field(mesh, scalar_map, np);
  BOOST_TEST((result == outline_of_field(mesh, rank_map, CGAL::parameters::default_values())));
  return result;
}

// Cuts by cut(mesh, scalar map, curves), and returns what is wrong with the field afterwards.
template <class Mesh, class Scalar, class Cut, class NamedParameters>
std::string fault_of_field(const Sample& sample,
                           const std::vector<Scalar>& values,
                           const Outline& expected,
                           const NamedParameters& np,
                           const Cut& cut)
{
  Mesh mesh = curve_samples::make_mesh<Mesh>(sample.soup);
  const auto scalar_map = make_writable_map(mesh, values);
  Curves_of<Mesh> curves;
  cut(mesh, scalar_map, curves);
  std::size_t position = 0;
  for(const auto v : vertices(mesh))
  {
    if(position < values.size() && get(scalar_map, v) != values[position])
      return "the value of a vertex has changed";
    ++position;
  }
  for(const auto& curve : curves)
  {
    const Scalar value = get(scalar_map, source(curve.halfedges.front(), mesh));
    if(std::abs(CGAL::to_double(value) - curve.value) > 1e-9 * (1 + std::abs(curve.value))
       && !std::is_integral_v<Scalar>)
      return "the value of a curve is not that of its contour";
    for(const auto h : curve.halfedges)
      if(get(scalar_map, target(h, mesh)) != value || get(scalar_map, source(h, mesh)) != value)
        return "a curve has several values";
  }
  return outline_of_field(mesh, scalar_map, np) == expected ? "" : "the graph is another one";
}

template <class Mesh, class Scalar, class NamedParameters>
void test_all_cuts(const Sample& sample, const std::vector<Scalar>& values, const NamedParameters& np)
{
  const Outline unfolded = outline_of_unfolded<Mesh>(sample, values, np);
  BOOST_TEST((fault_of_field<Mesh>(sample, values, unfolded, np,
                                   [&](Mesh& mesh, auto scalar_map, auto& curves) {
                                     CGAL::Reeb_graph::pants_decomposition(mesh, scalar_map, std::back_inserter(curves),
                                                                           np);
                                   }))
             == "");
  BOOST_TEST((fault_of_field<Mesh>(sample, values, unfolded, np,
                                   [&](Mesh& mesh, auto scalar_map, auto& curves) {
                                     CGAL::Reeb_graph::cutting_system(mesh, scalar_map, std::back_inserter(curves), np);
                                   }))
             == "");
  BOOST_TEST((fault_of_field<Mesh>(sample, values, unfolded, np,
                                   [&](Mesh& mesh, auto scalar_map, auto& curves) {
                                     CGAL::Reeb_graph::branch_curves(mesh, scalar_map, std::back_inserter(curves), np);
                                   }))
             == "");
}

std::vector<int> integers(const std::vector<double>& values)
{
  std::vector<int> result;
  for(const double value : values)
    result.push_back(10 * static_cast<int>(value));
  return result;
}
} // namespace

BOOST_AUTO_TEST_CASE_TEMPLATE(the_graph_is_the_same_after_cutting, Mesh, Meshes)
{
  for(std::size_t seed = 0; seed < 40; ++seed)
    BOOST_TEST_CONTEXT("seed " << seed)
    {
      const Sample sample = curve_samples::random_sample(8 * seed, false, 1 + seed % 2, 2); // permutations
      test_all_cuts<Mesh>(sample, sample.values, CGAL::parameters::default_values());
      // Exact numbers are on the other type of mesh, below.
      if constexpr(std::is_same_v<Mesh, Polyhedron>)
        if(seed < 10)
          test_all_cuts<Mesh>(sample, integers(sample.values), CGAL::parameters::default_values());
    }
  for(const unsigned genus : {2u, 7u})
    for(const std::size_t kind : {0, 1})
    {
      const Sample sample = curve_samples::smooth_sample(genus, 2000, kind);
      test_all_cuts<Mesh>(sample, sample.values, CGAL::parameters::default_values());
    }
}

// Between any two integers of any type there is a value unless they are next to each other.
BOOST_AUTO_TEST_CASE_TEMPLATE(integers_up_to_the_ends_of_their_range, Scalar, Integers)
{
  const Scalar lowest = std::numeric_limits<Scalar>::lowest(), highest = (std::numeric_limits<Scalar>::max)();
  const auto test = [](Scalar lower, Scalar upper) {
    const double infinity = std::numeric_limits<double>::infinity(), middle = (double(lower) + double(upper)) / 2;
    for(const double wish : {-infinity, double(lower), middle, double(upper), infinity, std::nan("")})
    {
      const Scalar value = CGAL::Reeb_graph::internal::value_between(lower, upper, wish, std::less<Scalar>());
      BOOST_TEST((static_cast<Scalar>(lower + 1) == upper ? value == lower : lower < value && value < upper));
      const Scalar falling = CGAL::Reeb_graph::internal::value_between(upper, lower, wish, std::greater<Scalar>());
      BOOST_TEST((static_cast<Scalar>(lower + 1) == upper ? falling == upper : falling == value));
    }
  };
  test(lowest, highest);
  for(int difference = 1; difference != 5; ++difference)
  {
    test(lowest, static_cast<Scalar>(lowest + difference));
    test(static_cast<Scalar>(highest - difference), highest);
    test(static_cast<Scalar>(highest / 2), static_cast<Scalar>(highest / 2 + difference));
  }
}

BOOST_AUTO_TEST_CASE(the_graph_of_exact_numbers_is_the_same_after_cutting)
{
  for(std::size_t seed = 0; seed < 10; ++seed)
    BOOST_TEST_CONTEXT("seed " << seed)
    {
      const Sample sample = curve_samples::random_sample(8 * seed, false, 1, 2); // permutations
      const CGAL::Exact_rational tiny = CGAL::Exact_rational(1) / CGAL::Exact_rational(1e300);
      std::vector<CGAL::Exact_rational> values;
      for(const double value : sample.values)
        values.push_back(1 + tiny * CGAL::Exact_rational(value));
      test_all_cuts<Surface_mesh>(sample, values, CGAL::parameters::default_values());
    }
}

BOOST_AUTO_TEST_CASE(the_graph_of_another_order_is_the_same_after_cutting)
{
  typedef boost::property_map<Surface_mesh, CGAL::dynamic_vertex_property_t<double>>::type Scalar_map;
  struct Descending : CGAL::Reeb_graph_traits<Surface_mesh, Scalar_map>
  {
    struct Less_scalar
    {
      bool operator()(double a, double b) const { return a > b; }
    };
    Less_scalar less_scalar_object() const { return Less_scalar(); }
  };
  const auto cut = [](Surface_mesh& mesh, auto scalar_map, auto& curves) {
    CGAL::Reeb_graph::pants_decomposition(mesh, scalar_map, std::back_inserter(curves),
                                          CGAL::parameters::geom_traits(Descending()));
  };
  for(std::size_t seed = 0; seed < 10; ++seed)
    BOOST_TEST_CONTEXT("seed " << seed)
    {
      const Sample sample = curve_samples::random_sample(8 * seed, false, 1, 2); // permutations
      auto mesh = curve_samples::make_mesh<Surface_mesh>(sample.soup);
      const Scalar_map scalar_map = make_writable_map(mesh, sample.values);
      const auto rank_map = get(CGAL::dynamic_vertex_property_t<std::uint64_t>(), mesh);
      CGAL::Reeb_graph::unfold_multi_saddles(mesh, scalar_map, rank_map, CGAL::parameters::geom_traits(Descending()));
      const Outline expected = outline_of_field(mesh, rank_map, CGAL::parameters::default_values());
      BOOST_TEST((fault_of_field<Surface_mesh>(sample, sample.values, expected,
                                               CGAL::parameters::geom_traits(Descending()), cut))
                 == "");
    }
}

// Many contours on each arc, at its ends as well, of which some are the same.
BOOST_AUTO_TEST_CASE_TEMPLATE(the_graph_is_the_same_after_cutting_along_many_contours, Mesh, Meshes)
{
  for(std::size_t seed = 0; seed < 40; ++seed)
    BOOST_TEST_CONTEXT("seed " << seed)
    {
      const Sample sample = curve_samples::random_sample(8 * seed, seed % 2 == 1, 1, 0); // permutations
      Mesh mesh = curve_samples::make_mesh<Mesh>(sample.soup);
      auto values = sample.values;
      for(std::size_t i = 0; i < values.size(); ++i)
        values[i] = values[i] * static_cast<double>(values.size()) + static_cast<double>(i); // no ties on borders
      const auto scalar_map = make_writable_map(mesh, values);
      typename CGAL::Reeb_graph_traits<Mesh, std::decay_t<decltype(scalar_map)>>::Graph graph;
      CGAL::compute_reeb_graph(mesh, scalar_map, graph);
      const Outline expected = outline(mesh, graph);
      const auto cut = [&](Mesh& mesh_to_cut, auto map, auto& curves) {
        CGAL::compute_reeb_graph(mesh_to_cut, map, graph);
        const CGAL::Reeb_graph::Augmentation augmentation(mesh_to_cut, map, graph);
        std::vector<typename decltype(augmentation)::Contour> contours;
        for(const auto node : CGAL::make_range(vertices(graph)))
        {
          const auto critical_set = augmentation.critical_set(node);
          contours.insert(contours.end(), critical_set.lower_contours.begin(), critical_set.lower_contours.end());
          contours.insert(contours.end(), critical_set.upper_contours.begin(), critical_set.upper_contours.end());
        }
        for(const auto arc : CGAL::make_range(edges(graph)))
          for(const double t : {0.5, 0.25, 0.500001, 0.5})
            contours.push_back(augmentation.contour(arc, t));
        CGAL::Reeb_graph::cut_along_contours(mesh_to_cut, map, contours, std::back_inserter(curves));
      };
      BOOST_TEST((fault_of_field<Mesh>(sample, values, expected, CGAL::parameters::default_values(), cut)) == "");
      const auto segment = [&](Mesh& mesh_to_cut, auto map, auto&) {
        CGAL::compute_reeb_graph(mesh_to_cut, map, graph);
        CGAL::Reeb_graph::segment_by_arcs(mesh_to_cut, map, graph,
                                          get(CGAL::dynamic_face_property_t<std::size_t>(), mesh_to_cut));
      };
      BOOST_TEST((fault_of_field<Mesh>(sample, values, expected, CGAL::parameters::default_values(), segment)) == "");
    }
}

// Borders are one node each if ties are contracted, and each handle is a loop.
BOOST_AUTO_TEST_CASE(fields_on_meshes_with_borders)
{
  std::size_t number_of_samples = 0;
  for(std::size_t seed = 0; seed < 40; ++seed)
    BOOST_TEST_CONTEXT("seed " << seed)
    {
      const Sample sample = curve_samples::random_sample(8 * seed, true, 1, 1); // permutations but for the borders
      if(!curve_samples::are_borders_extremal(sample))
        continue;
      ++number_of_samples;
      auto mesh = curve_samples::make_mesh<Surface_mesh>(sample.soup);
      const Piece whole = pieces_of(mesh).front();
      const auto scalar_map = make_writable_map(mesh, sample.values);
      Curves_of<Surface_mesh> curves;
      CGAL::Reeb_graph::pants_decomposition(mesh, scalar_map, std::back_inserter(curves));
      CGAL::Reeb_graph_traits<Surface_mesh, std::decay_t<decltype(scalar_map)>>::Graph graph;
      CGAL::compute_reeb_graph(mesh, scalar_map, graph, CGAL::parameters::ties(Ties::CONTRACT));
      const long loops = static_cast<long>(num_edges(graph)) - static_cast<long>(num_vertices(graph)) + 1;
      BOOST_TEST(loops == (2 - whole.euler_characteristic - static_cast<long>(whole.border_loops)) / 2);
    }
  BOOST_TEST(number_of_samples > 10u);
}

// Each vertex gets a value, between those of the field if no border has been made level.
BOOST_AUTO_TEST_CASE_TEMPLATE(fields_with_ties, Mesh, Meshes)
{
  for(std::size_t seed = 0; seed < 80; ++seed)
    BOOST_TEST_CONTEXT("seed " << seed)
    {
      Sample sample = curve_samples::any_sample(seed);
      for(double& value : sample.values)
        value += 1000; // not that of a map where nothing has been written
      Mesh mesh = curve_samples::make_mesh<Mesh>(sample.soup);
      const auto scalar_map = make_writable_map(mesh, sample.values);
      Curves_of<Mesh> curves;
      const bool is_closed = CGAL::is_closed(mesh);
      CGAL::Reeb_graph::cutting_system(mesh, scalar_map, std::back_inserter(curves),
                                       CGAL::parameters::borders(Borders::MAKE_LEVEL).cut_open(seed % 2 == 1));
      const auto [lowest, highest] = std::minmax_element(sample.values.begin(), sample.values.end());
      std::size_t position = 0, number_of_faults = 0;
      for(const auto v : vertices(mesh))
      {
        const double value = get(scalar_map, v);
        number_of_faults += position < sample.values.size() ? value != sample.values[position]
                          : is_closed                       ? !(value >= *lowest && value <= *highest)
                                                            : value == 0 && std::isfinite(*lowest);
        ++position;
      }
      BOOST_TEST(number_of_faults == 0u);
    }
}

BOOST_AUTO_TEST_CASE(maps_without_room_are_only_read)
{
  const Sample sample = curve_samples::smooth_sample(2, 1000, 0);
  auto values = sample.values;
  auto mesh = curve_samples::make_mesh<Surface_mesh>(sample.soup), other_mesh = mesh;
  Curves_of<Surface_mesh> curves;
  CGAL::Reeb_graph::pants_decomposition(
    mesh, boost::make_iterator_property_map(values.begin(), get(boost::vertex_index, mesh)),
    std::back_inserter(curves));
  BOOST_TEST(num_vertices(mesh) > values.size());
  BOOST_TEST((values == sample.values));
  auto third_mesh = other_mesh;
  CGAL::Reeb_graph::pants_decomposition(third_mesh, CGAL::Reeb_graph::make_scalar_map(third_mesh, values),
                                        std::back_inserter(curves)); // of a const mesh
  const auto read_only = CGAL::Reeb_graph::make_scalar_map_from_function(
    other_mesh, [&](Surface_mesh::Vertex_index v) { return values.at(std::size_t(v)); });
  CGAL::Reeb_graph::pants_decomposition(other_mesh, read_only, std::back_inserter(curves));
  BOOST_TEST(curves.size() == 9u);
}

// Linear functions of the points are interpolated as the points are, and each part of a face knows its face.
BOOST_AUTO_TEST_CASE_TEMPLATE(attributes_are_carried_over, Mesh, Meshes)
{
  typedef std::array<float, 2> Texture;
  const Sample sample = curve_samples::smooth_sample(3, 1000, 1);
  Mesh mesh = curve_samples::make_mesh<Mesh>(sample.soup);
  const auto point_map = get(CGAL::vertex_point, mesh);
  const auto linear = [](const auto& p) { return p.x() + 2 * p.y() - p.z() / 3 + 4; };
  const auto number_map = get(CGAL::dynamic_vertex_property_t<double>(), mesh);
  const auto byte_map = get(CGAL::dynamic_vertex_property_t<unsigned char>(), mesh);
  const auto texture_map = get(CGAL::dynamic_vertex_property_t<Texture>(), mesh);
  const auto color_map = get(CGAL::dynamic_vertex_property_t<CGAL::IO::Color>(), mesh);
  const auto other_point_map = get(CGAL::dynamic_vertex_property_t<mesh_builders::Point>(), mesh);
  const auto name_map = get(CGAL::dynamic_vertex_property_t<std::string>(), mesh);
  const auto face_map = get(CGAL::dynamic_face_property_t<std::size_t>(), mesh);
  for(const auto v : vertices(mesh))
  {
    const double number = linear(get(point_map, v));
    const auto byte = static_cast<unsigned char>(std::lround(10 * number));
    put(number_map, v, number);
    put(byte_map, v, byte);
    put(texture_map, v, Texture{static_cast<float>(number), 7.f});
    put(color_map, v, CGAL::IO::Color(byte, 3, static_cast<unsigned char>(255 - byte)));
    put(other_point_map, v, get(point_map, v));
    put(name_map, v, "given");
  }
  std::vector<double> areas, sums;
  for(const auto f : faces(mesh))
  {
    put(face_map, f, areas.size());
    areas.push_back(CGAL::Polygon_mesh_processing::face_area(f, mesh));
  }
  sums.resize(areas.size());

  CGAL::Reeb_graph::Interpolating_visitor<Mesh> visitor;
  visitor.add_vertex_map(number_map).add_vertex_map(byte_map).add_vertex_map(texture_map);
  visitor.add_vertex_map(color_map).add_vertex_map(other_point_map).add_face_map(face_map);
  visitor.add_vertex_map(name_map, [](const std::string&, const std::string&, double) { return "added"; });
  std::vector<CGAL::Reeb_graph::Curve<typename boost::graph_traits<Mesh>::halfedge_descriptor>> curves;
  CGAL::Reeb_graph::pants_decomposition(mesh, make_writable_map(mesh, sample.values), std::back_inserter(curves),
                                        CGAL::parameters::cut_open(true).visitor(visitor));
  std::size_t position = 0, number_of_faults = 0;
  for(const auto v : vertices(mesh))
  {
    const double number = linear(get(point_map, v));
    const auto is_near = [&](double value, double tolerance) { return std::abs(value - number) < tolerance; };
    number_of_faults += is_near(get(number_map, v), 1e-12) ? 0 : 1;
    number_of_faults += is_near(get(byte_map, v) / 10., 0.21) ? 0 : 1;
    number_of_faults += is_near(get(texture_map, v)[0], 1e-5) && get(texture_map, v)[1] == 7.f ? 0 : 1;
    number_of_faults += is_near(get(color_map, v).red() / 10., 0.21) && get(color_map, v).green() == 3 ? 0 : 1;
    number_of_faults += is_near((255 - get(color_map, v).blue()) / 10., 0.21) ? 0 : 1;
    number_of_faults += CGAL::squared_distance(get(other_point_map, v), get(point_map, v)) < 1e-24 ? 0 : 1;
    const bool is_added = position++ >= sample.values.size();
    number_of_faults += get(name_map, v) == (is_added ? "added" : "given") ? 0 : 1;
  }
  BOOST_TEST(number_of_faults == 0u);
  BOOST_TEST(position > 2 * sample.values.size());
  for(const auto f : faces(mesh))
    sums.at(get(face_map, f)) += CGAL::Polygon_mesh_processing::face_area(f, mesh);
  for(std::size_t f = 0; f < areas.size(); ++f)
    BOOST_TEST(sums[f] == areas[f], boost::test_tools::tolerance(1e-9));
}

BOOST_AUTO_TEST_SUITE_END()
