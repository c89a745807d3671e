// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#include <boost/test/unit_test.hpp>

#include "graph_checks.h"
#include "mesh_builders.h"
#include "random_fields.h"
#include "random_meshes.h"

#include <CGAL/Exact_rational.h>
#include <CGAL/Linear_cell_complex_for_bgl_combinatorial_map_helper.h>
#include <CGAL/Reeb_graph/Augmentation.h>
#include <CGAL/Reeb_graph/IO.h>
#include <CGAL/boost/graph/Face_filtered_graph.h>
#include <CGAL/boost/graph/graph_traits_Linear_cell_complex_for_combinatorial_map.h>

#include <boost/concept_check.hpp>
#include <boost/graph/graph_concepts.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <iterator>
#include <sstream>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

// Models of the concepts that have what the concepts ask for, and nothing else.

BOOST_AUTO_TEST_SUITE(test_concepts)

using graph_checks::compute_plain;
using graph_checks::Plain_graph;
using mesh_builders::Surface_mesh;
using random_meshes::Field_class;
using random_meshes::Random;

typedef boost::graph_traits<Surface_mesh>::vertex_descriptor vertex_descriptor;
typedef boost::graph_traits<Surface_mesh>::halfedge_descriptor halfedge_descriptor;

namespace archetypes {
// Default constructible and copyable, but without operators.
class Scalar
{
public:
  Scalar() = default;
  explicit Scalar(double value) : value_(value) {}

  friend double reveal(const Scalar& scalar) { return scalar.value_; }

private:
  bool operator<(const Scalar&) const;
  bool operator==(const Scalar&) const;
  void operator&() const;

  double value_ = 0;
};

// A ReadablePropertyMap that can be copied and read.
class Scalar_map
{
public:
  typedef vertex_descriptor key_type;
  typedef Scalar value_type;
  typedef Scalar reference;
  typedef boost::readable_property_map_tag category;

  explicit Scalar_map(const std::vector<double>& values) : values_(&values) {}

  friend Scalar get(const Scalar_map& map, vertex_descriptor v) { return Scalar((*map.values_)[v]); }

private:
  Scalar_map& operator=(const Scalar_map&) = delete;

  const std::vector<double>* values_;

public:
  Scalar_map(const Scalar_map&) = default;
};

// A model of ReebGraphTraits that is no Reeb_graph_traits: its order is upside down and has a state, and one value is
// refused.
class Traits
{
public:
  typedef Surface_mesh Triangle_mesh;
  typedef archetypes::Scalar_map Scalar_map;
  typedef archetypes::Scalar Scalar;

  struct Node
  {
    vertex_descriptor vertex;
    archetypes::Scalar value;
    CGAL::Reeb_graph::Node_kind kind;
    int additional_member = 5;
  };

  struct Arc
  {
    CGAL::Reeb_graph::Halfedge_chain<halfedge_descriptor> chain;
    int additional_member = 6;
  };

  typedef boost::adjacency_list<boost::vecS, boost::vecS, boost::bidirectionalS, Node, Arc> Graph;

  class Less_scalar
  {
  public:
    explicit Less_scalar(double factor) : factor_(factor) {}
    bool operator()(const archetypes::Scalar& a, const archetypes::Scalar& b) const
    {
      return factor_ * reveal(a) < factor_ * reveal(b);
    }

  private:
    double factor_;
  };

  struct Is_ordered
  {
    bool operator()(const archetypes::Scalar& a) const { return reveal(a) != 1000; }
  };

  explicit Traits(double factor) : factor_(factor) {}
  Less_scalar less_scalar_object() const { return Less_scalar(factor_); }
  Is_ordered is_ordered_object() const { return Is_ordered(); }

private:
  double factor_;
};

// A model of ReebGraphVisitor that is no Default_visitor, and cannot be copied.
class Visitor
{
public:
  Visitor() = default;
  Visitor(const Visitor&) = delete;
  Visitor& operator=(const Visitor&) = delete;

  void begin_stage(CGAL::Reeb_graph::Stage stage) { begun.push_back(stage); }
  void end_stage(CGAL::Reeb_graph::Stage stage) { ended.push_back(stage); }
  void critical_vertices(const CGAL::Reeb_graph::Critical_vertex_counts& c)
  {
    counts.push_back(c);
    stages_of_counts.push_back(begun.back());
  }

  std::vector<CGAL::Reeb_graph::Stage> begun, ended, stages_of_counts;
  std::vector<CGAL::Reeb_graph::Critical_vertex_counts> counts;
};
} // namespace archetypes

namespace {
struct Sample
{
  Surface_mesh mesh;
  std::vector<double> values;
};

Sample make_sample(std::size_t seed, Field_class field_class)
{
  Random random(seed);
  const auto mesh = random_meshes::random_closed_surface(2, 15, random);
  Sample sample = {Surface_mesh(), random_meshes::random_field(mesh, field_class, random)};
  mesh_builders::build(sample.mesh, mesh_builders::make_soup(mesh));
  return sample;
}

struct Throwing_visitor : CGAL::Reeb_graph::Default_visitor
{
  void begin_stage(CGAL::Reeb_graph::Stage stage)
  {
    if(stage == CGAL::Reeb_graph::Stage::WRITE)
      throw std::logic_error("stop");
  }
};

struct Counting_visitor
{
  std::size_t* number_of_stages;
  void begin_stage(CGAL::Reeb_graph::Stage) {}
  void end_stage(CGAL::Reeb_graph::Stage) { ++*number_of_stages; }
  void critical_vertices(const CGAL::Reeb_graph::Critical_vertex_counts&) {}
};

template <class Scalar>
void test_scalar_type()
{
  for(std::size_t seed = 0; seed < 50; ++seed)
    BOOST_TEST_CONTEXT("seed " << seed)
    {
      const Sample sample = make_sample(seed, seed % 2 == 0 ? Field_class::INTEGERS : Field_class::PERMUTATION);
      std::vector<Scalar> scalars;
      for(double value : sample.values)
        scalars.push_back(static_cast<Scalar>(static_cast<int>(value)));
      BOOST_TEST((compute_plain(sample.mesh, scalars) == compute_plain(sample.mesh, sample.values)));
      BOOST_TEST(graph_checks::fault_of_reeb_graph(sample.mesh, scalars, true) == "");
    }
}
} // namespace

BOOST_AUTO_TEST_CASE(the_archetypes_model_what_they_claim)
{
  BOOST_CONCEPT_ASSERT((boost::ReadablePropertyMapConcept<archetypes::Scalar_map, vertex_descriptor>));
  BOOST_CONCEPT_ASSERT((boost::BidirectionalGraphConcept<archetypes::Traits::Graph>));
  BOOST_CONCEPT_ASSERT((boost::VertexAndEdgeListGraphConcept<archetypes::Traits::Graph>));
}

BOOST_AUTO_TEST_CASE(a_traits_class_of_the_user)
{
  for(std::size_t seed = 0; seed < 50; ++seed)
    BOOST_TEST_CONTEXT("seed " << seed)
    {
      const Sample sample = make_sample(seed, Field_class::INTEGERS);
      const archetypes::Scalar_map scalar_map(sample.values);
      for(const double factor : {1., -1.})
      {
        std::vector<double> ordered_values;
        for(double value : sample.values)
          ordered_values.push_back(factor * value);

        archetypes::Traits::Graph graph;
        const archetypes::Traits traits(factor);
        CGAL::compute_reeb_graph(sample.mesh, scalar_map, graph, CGAL::parameters::geom_traits(traits));
        const Plain_graph result = graph_checks::plain(mesh_builders::Mesh_numbers<Surface_mesh>(sample.mesh), graph);
        BOOST_TEST((result == compute_plain(sample.mesh, ordered_values)));
        for(std::size_t node = 0; node < num_vertices(graph); ++node)
        {
          BOOST_TEST(reveal(graph[node].value) == sample.values[graph[node].vertex]);
          BOOST_TEST(graph[node].additional_member == 5);
        }
      }
    }
}

BOOST_AUTO_TEST_CASE(a_value_that_the_traits_class_refuses)
{
  Sample sample = make_sample(1, Field_class::PERMUTATION);
  sample.values[3] = 1000;
  archetypes::Traits::Graph graph;
  BOOST_CHECK_EXCEPTION(CGAL::compute_reeb_graph(sample.mesh, archetypes::Scalar_map(sample.values), graph,
                                                 CGAL::parameters::geom_traits(archetypes::Traits(1))),
                        CGAL::Reeb_graph::Unordered_scalar_error,
                        [](const CGAL::Reeb_graph::Unordered_scalar_error& error) { return error.vertex() == 3; });
}

BOOST_AUTO_TEST_CASE(a_visitor_of_the_user)
{
  using CGAL::Reeb_graph::Stage;
  const Sample sample = make_sample(2, Field_class::PERMUTATION);
  const auto scalar_map = CGAL::Reeb_graph::make_scalar_map(sample.mesh, sample.values);
  archetypes::Visitor visitor;
  graph_checks::Graph_of<Surface_mesh> graph;
  CGAL::compute_reeb_graph(sample.mesh, scalar_map, graph, CGAL::parameters::visitor(std::ref(visitor)));

  const std::vector<Stage> stages = {Stage::FLATTEN, Stage::CLASSIFY, Stage::ARCS, Stage::WRITE};
  BOOST_TEST((visitor.begun == stages));
  BOOST_TEST((visitor.ended == stages));
  BOOST_TEST((visitor.stages_of_counts == std::vector<Stage>{Stage::CLASSIFY}));

  const auto oracle =
    graph_checks::make_oracle(mesh_builders::Mesh_numbers<Surface_mesh>(sample.mesh), sample.values, false);
  CGAL::Reeb_graph::Critical_vertex_counts expected;
  for(std::size_t v = 0; v < sample.values.size(); ++v)
    if(oracle.lower_link_sectors[v] == 0)
      ++expected.minima;
    else if(oracle.upper_link_sectors[v] == 0)
      ++expected.maxima;
    else if(oracle.lower_link_sectors[v] > 1)
      ++expected.saddles[oracle.lower_link_sectors[v] - 1];
  BOOST_TEST(visitor.counts.front().minima == expected.minima);
  BOOST_TEST(visitor.counts.front().maxima == expected.maxima);
  BOOST_TEST((visitor.counts.front().saddles == expected.saddles));
}

BOOST_AUTO_TEST_CASE(a_visitor_by_value_among_other_parameters)
{
  const Sample sample = make_sample(3, Field_class::PERMUTATION);
  const auto scalar_map = CGAL::Reeb_graph::make_scalar_map(sample.mesh, sample.values);
  std::size_t number_of_stages = 0;
  graph_checks::Graph_of<Surface_mesh> graph;
  const Counting_visitor visitor = {&number_of_stages};
  CGAL::compute_reeb_graph(sample.mesh, scalar_map, graph,
                           CGAL::parameters::keep_degree_two_nodes(true).visitor(visitor));
  BOOST_TEST(number_of_stages == 4u);
  const mesh_builders::Mesh_numbers<Surface_mesh> numbers(sample.mesh);
  BOOST_TEST((graph_checks::plain(numbers, graph) == compute_plain(sample.mesh, sample.values, true)));
}

// Whether `ties` can be appended to a sequence of named parameters.
template <class NamedParameters, class = void>
struct Can_be_followed_by_ties : std::false_type
{
};

template <class NamedParameters>
struct Can_be_followed_by_ties<
  NamedParameters,
  std::void_t<decltype(std::declval<NamedParameters>().ties(CGAL::Reeb_graph::Ties::CONTRACT))>> : std::true_type
{
};

BOOST_AUTO_TEST_CASE(named_parameters_in_a_row)
{
  namespace parameters = CGAL::parameters;
  namespace tags = CGAL::Reeb_graph::internal;
  using CGAL::Reeb_graph::Ties;
  const auto check = [](const auto& np) {
    BOOST_TEST(parameters::get_parameter(np, tags::number_of_slabs) == 3u);
    BOOST_TEST(parameters::get_parameter(np, tags::keep_degree_two_nodes));
    BOOST_TEST((parameters::get_parameter(np, tags::ties) == Ties::CONTRACT));
    BOOST_TEST(parameters::get_parameter(np, tags::edges_of_soup) == 5.5);
  };
  const auto of_package =
    parameters::edges(5.5).keep_degree_two_nodes(true).number_of_slabs(3).ties(Ties::CONTRACT); // in any order
  check(of_package);
  check(parameters::ties(Ties::CONTRACT).number_of_slabs(3).edges(5.5).keep_degree_two_nodes(true));
  check(of_package.verbose(true).random_seed(7));
  check(parameters::ties(Ties::CONTRACT).edges(5.5).keep_degree_two_nodes(true).number_of_slabs(3));
  BOOST_TEST(parameters::get_parameter(of_package.verbose(true).random_seed(7), CGAL::internal_np::random_seed) == 7);

  // Behind those of CGAL there is no way to lose one.
  static_assert(Can_be_followed_by_ties<decltype(of_package)>::value);
  static_assert(!Can_be_followed_by_ties<decltype(of_package.verbose(true))>::value);
  static_assert(!Can_be_followed_by_ties<decltype(parameters::verbose(true))>::value);

  const Sample sample = make_sample(3, Field_class::PERMUTATION);
  const auto scalar_map = CGAL::Reeb_graph::make_scalar_map(sample.mesh, sample.values);
  std::size_t number_of_stages = 0;
  const Counting_visitor visitor = {&number_of_stages};
  graph_checks::Graph_of<Surface_mesh> graph;
  CGAL::compute_reeb_graph(sample.mesh, scalar_map, graph,
                           parameters::ties(Ties::PERTURB).keep_degree_two_nodes(true).visitor(visitor));
  BOOST_TEST(number_of_stages == 4u);
  const mesh_builders::Mesh_numbers<Surface_mesh> numbers(sample.mesh);
  BOOST_TEST((graph_checks::plain(numbers, graph) == compute_plain(sample.mesh, sample.values, true)));
}

BOOST_AUTO_TEST_CASE(an_exception_of_a_visitor_leaves_the_graph_as_it_was)
{
  const Sample sample = make_sample(4, Field_class::PERMUTATION);
  const auto scalar_map = CGAL::Reeb_graph::make_scalar_map(sample.mesh, sample.values);
  graph_checks::Graph_of<Surface_mesh> graph(3);
  Throwing_visitor visitor;
  BOOST_CHECK_THROW(
    CGAL::compute_reeb_graph(sample.mesh, scalar_map, graph, CGAL::parameters::visitor(std::ref(visitor))),
    std::logic_error);
  BOOST_TEST(num_vertices(graph) == 3u);
}

BOOST_AUTO_TEST_CASE(scalars_float) { test_scalar_type<float>(); }
BOOST_AUTO_TEST_CASE(scalars_int) { test_scalar_type<int>(); }
BOOST_AUTO_TEST_CASE(scalars_unsigned_char) { test_scalar_type<unsigned char>(); }
BOOST_AUTO_TEST_CASE(scalars_exact_rational) { test_scalar_type<CGAL::Exact_rational>(); }

namespace {
typedef std::pair<int, int> Digits;
struct Digits_traits : CGAL::Reeb_graph_traits<Surface_mesh, graph_checks::Scalar_map_of<Surface_mesh, Digits>>
{
  struct To_double
  {
    double operator()(const Digits& digits) const { return 10 * digits.first + digits.second; }
  };
  struct From_double
  {
    Digits operator()(double number) const
    {
      const int rounded = static_cast<int>(std::floor(number));
      return {rounded / 10, rounded % 10};
    }
  };
  To_double scalar_to_double_object() const { return To_double(); }
  From_double scalar_from_double_object() const { return From_double(); }
};

// The same contours at the nodes as with numbers; the values are those of the numbers, or NaN.
template <class Augmentation, class Numbers>
void test_contours(const Augmentation& augmentation, const Numbers& numbers, std::size_t nodes, bool has_values)
{
  for(std::size_t node = 0; node < nodes; ++node)
  {
    const auto critical_set = augmentation.critical_set(node), expected = numbers.critical_set(node);
    for(const auto& [contours, expected_contours] :
        {std::make_pair(critical_set.lower_contours, expected.lower_contours),
         std::make_pair(critical_set.upper_contours, expected.upper_contours)})
      for(std::size_t i = 0; i < expected_contours.size(); ++i)
      {
        BOOST_TEST((contours.at(i).edges == expected_contours[i].edges));
        BOOST_TEST((has_values ? contours[i].value == expected_contours[i].value : std::isnan(contours[i].value)));
      }
  }
}
} // namespace

BOOST_AUTO_TEST_CASE(contours_of_scalars_that_are_no_numbers)
{
  for(std::size_t seed = 0; seed < 10; ++seed)
    BOOST_TEST_CONTEXT("seed " << seed)
    {
      const Sample sample = make_sample(seed, Field_class::PERMUTATION);
      std::vector<Digits> digits;
      for(const double value : sample.values)
        digits.emplace_back(static_cast<int>(value) / 10, static_cast<int>(value) % 10);
      const auto scalar_map = CGAL::Reeb_graph::make_scalar_map(sample.mesh, digits);
      const auto number_map = CGAL::Reeb_graph::make_scalar_map(sample.mesh, sample.values);
      const auto graph = graph_checks::compute(sample.mesh, digits);
      const auto number_graph = graph_checks::compute(sample.mesh, sample.values);
      const CGAL::Reeb_graph::Augmentation plain(sample.mesh, scalar_map, graph);
      const CGAL::Reeb_graph::Augmentation converting(sample.mesh, scalar_map, graph,
                                                      CGAL::parameters::geom_traits(Digits_traits()));
      const CGAL::Reeb_graph::Augmentation numbers(sample.mesh, number_map, number_graph);
      test_contours(plain, numbers, num_vertices(graph), false);
      test_contours(converting, numbers, num_vertices(graph), true);
      auto number_arc = edges(number_graph).first;
      for(const auto arc : CGAL::make_range(edges(graph)))
      {
        for(const double t : {0.1, 0.5, 0.9})
        {
          const auto contour = converting.contour(arc, t), expected = numbers.contour(*number_arc, t);
          BOOST_TEST((contour.edges == expected.edges));
          BOOST_TEST(contour.value == expected.value);
          BOOST_TEST(!plain.contour(arc, t).edges.empty());
          std::vector<mesh_builders::Point> points, expected_points;
          converting.points_of_contour(contour, std::back_inserter(points));
          numbers.points_of_contour(expected, std::back_inserter(expected_points));
          BOOST_TEST((points == expected_points));
        }
        ++number_arc;
      }
    }
}

BOOST_AUTO_TEST_CASE(small_integers_are_written_as_numbers)
{
  Surface_mesh mesh;
  mesh_builders::build(mesh, mesh_builders::make_soup(random_meshes::tetrahedron()));
  const auto scalar_map = CGAL::Reeb_graph::make_scalar_map(mesh, std::vector<unsigned char>{7, 65, 66, 200});
  CGAL::Reeb_graph_traits<Surface_mesh, std::decay_t<decltype(scalar_map)>>::Graph graph;
  CGAL::compute_reeb_graph(mesh, scalar_map, graph);
  const auto vertex_index_map = get(boost::vertex_index, mesh);
  std::ostringstream graphml, graphviz;
  CGAL::Reeb_graph::write_graphml(graphml, graph, vertex_index_map);
  CGAL::Reeb_graph::write_graphviz(graphviz, graph, vertex_index_map);
  for(const std::string& text : {graphml.str(), graphviz.str()})
  {
    BOOST_TEST(std::all_of(text.begin(), text.end(), [](char c) { return c == '\n' || (c >= ' ' && c <= '~'); }));
    BOOST_TEST(text.find("200") != std::string::npos);
  }
  BOOST_TEST(graphml.str().find(">7<") != std::string::npos);
}

BOOST_AUTO_TEST_CASE(exact_rationals_are_not_rounded)
{
  // values that no double tells apart, descending
  const Sample sample = make_sample(5, Field_class::PERMUTATION);
  const CGAL::Exact_rational tiny = CGAL::Exact_rational(1) / CGAL::Exact_rational(1e300);
  std::vector<CGAL::Exact_rational> scalars;
  for(double value : sample.values)
    scalars.push_back(1 + tiny * CGAL::Exact_rational(value));
  BOOST_TEST((compute_plain(sample.mesh, scalars) == compute_plain(sample.mesh, sample.values)));
}

BOOST_AUTO_TEST_CASE(scalar_maps_of_functions_and_of_surface_mesh_properties)
{
  Sample sample = make_sample(6, Field_class::PERMUTATION);
  const mesh_builders::Mesh_numbers<Surface_mesh> numbers(sample.mesh);
  const Plain_graph expected = compute_plain(sample.mesh, sample.values);

  const auto function_map =
    CGAL::Reeb_graph::make_scalar_map_from_function(sample.mesh, [&](vertex_descriptor v) { return sample.values[v]; });
  CGAL::Reeb_graph_traits<Surface_mesh, std::remove_cv_t<decltype(function_map)>>::Graph graph;
  CGAL::compute_reeb_graph(sample.mesh, function_map, graph);
  BOOST_TEST((graph_checks::plain(numbers, graph) == expected));

  const auto property_map = sample.mesh.add_property_map<vertex_descriptor, double>("v:height").first;
  for(const auto v : sample.mesh.vertices())
    property_map[v] = sample.values[v];
  CGAL::Reeb_graph_traits<Surface_mesh, Surface_mesh::Property_map<vertex_descriptor, double>>::Graph other_graph;
  CGAL::compute_reeb_graph(sample.mesh, property_map, other_graph);
  BOOST_TEST((graph_checks::plain(numbers, other_graph) == expected));
}

BOOST_AUTO_TEST_CASE(a_filtered_mesh)
{
  typedef CGAL::Face_filtered_graph<Surface_mesh> Filtered_mesh;
  std::size_t number_of_borders_inside = 0;
  for(std::size_t seed = 0; seed < 200; ++seed)
    BOOST_TEST_CONTEXT("seed " << seed)
    {
      Random random(seed);
      const auto whole = random_meshes::random_closed_surface(2, 15, random);
      auto part = whole;
      random_meshes::remove_random_triangles(part, 10, random);
      Surface_mesh mesh;
      mesh_builders::build(mesh, mesh_builders::make_soup(whole));
      std::vector<Surface_mesh::Face_index> selected_faces;
      for(std::size_t f = 0; f < whole.triangles.size(); ++f)
        if(std::find(part.triangles.begin(), part.triangles.end(), whole.triangles[f]) != part.triangles.end())
          selected_faces.push_back(Surface_mesh::Face_index(static_cast<Surface_mesh::size_type>(f)));
      const Filtered_mesh filtered_mesh(mesh, selected_faces);

      const std::size_t n = std::distance(vertices(filtered_mesh).begin(), vertices(filtered_mesh).end());
      const auto values = random_meshes::random_integers(n, 1 + random.below(n), random);
      for(bool keeps_degree_two_nodes : {false, true})
        BOOST_TEST(graph_checks::fault_of_reeb_graph(filtered_mesh, values, keeps_degree_two_nodes) == "");
      number_of_borders_inside += selected_faces.size() < whole.triangles.size() ? 1 : 0;
    }
  BOOST_TEST(number_of_borders_inside > 100u);
}

BOOST_AUTO_TEST_CASE(a_linear_cell_complex)
{
  typedef CGAL::Linear_cell_complex_traits<3, mesh_builders::Kernel> Cell_traits;
  typedef CGAL::Linear_cell_complex_for_bgl_combinatorial_map_helper<2, 3, Cell_traits>::type Cell_complex;
  for(std::size_t seed = 0; seed < 50; ++seed)
    BOOST_TEST_CONTEXT("seed " << seed)
    {
      Random random(seed);
      auto mesh = random_meshes::random_closed_surface(1, 15, random);
      random_meshes::remove_random_triangles(mesh, random.below(8), random);
      Cell_complex cell_complex;
      mesh_builders::build(cell_complex, mesh_builders::make_soup(mesh));
      const auto values = random_meshes::random_integers(mesh.number_of_vertices, 20, random);
      BOOST_TEST(graph_checks::fault_of_reeb_graph(cell_complex, values, false) == "");
    }
}

BOOST_AUTO_TEST_SUITE_END()
