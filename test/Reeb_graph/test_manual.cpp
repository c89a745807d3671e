// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#include <boost/test/unit_test.hpp>

#include "mesh_builders.h"

#include <CGAL/Reeb_graph.h>
#include <CGAL/Reeb_graph/curves/Refinement_visitor.h>
#include <CGAL/Reeb_graph/curves/branch_curves.h>
#include <CGAL/Reeb_graph/curves/cut_along_contours.h>
#include <CGAL/Reeb_graph/curves/cutting_system.h>
#include <CGAL/Reeb_graph/curves/harmonic_pants_decomposition.h>
#include <CGAL/Reeb_graph/curves/segmentation.h>
#include <CGAL/Reeb_graph/curves/unfold_multi_saddles.h>
#include <CGAL/Reeb_graph/fields/field_constraints.h>
#include <CGAL/Reeb_graph/fields/geodesic_field.h>
#include <CGAL/Reeb_graph/fields/gradient_and_divergence.h>
#include <CGAL/Reeb_graph/fields/harmonic_field.h>
#include <CGAL/Reeb_graph/fields/height_field.h>
#include <CGAL/Reeb_graph/fields/make_borders_level.h>
#include <CGAL/Reeb_graph/fields/poisson_field.h>
#include <CGAL/boost/graph/Euler_operations.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <limits>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

// The pieces of code that the manual shows, between marks of their names, do what it says.

BOOST_AUTO_TEST_SUITE(test_manual)

namespace {
typedef mesh_builders::Kernel Kernel;
typedef mesh_builders::Surface_mesh Mesh;
typedef boost::graph_traits<Mesh>::vertex_descriptor vertex_descriptor;
typedef boost::graph_traits<Mesh>::halfedge_descriptor halfedge_descriptor;
typedef boost::graph_traits<Mesh>::face_descriptor face_descriptor;
typedef Mesh::Property_map<vertex_descriptor, double> Scalar_map;
typedef CGAL::Reeb_graph_traits<Mesh, Scalar_map>::Graph Graph;
typedef std::vector<CGAL::Reeb_graph::Curve<halfedge_descriptor>> Curves;

// A double torus, whose long axis has the values 0 to 5.
struct Double_torus
{
  Mesh mesh = mesh_builders::make_mesh<Mesh>(generated_surfaces::closed_surface(2, 1000));
  Scalar_map scalar_map = mesh.add_property_map<vertex_descriptor, double>("v:scalar").first;
  vertex_descriptor tail, nose;
  Graph graph;

  Double_torus()
  {
    for(const vertex_descriptor v : vertices(mesh))
      scalar_map[v] = mesh.point(v).x();
    const auto [lowest, highest] = std::minmax_element(scalar_map.begin(), scalar_map.end());
    const double low = *lowest, high = *highest;
    tail = *std::next(vertices(mesh).begin(), lowest - scalar_map.begin());
    nose = *std::next(vertices(mesh).begin(), highest - scalar_map.begin());
    for(const vertex_descriptor v : vertices(mesh))
      scalar_map[v] = 5 * (scalar_map[v] - low) / (high - low);
    CGAL::compute_reeb_graph(mesh, scalar_map, graph);
  }

  auto arc_at(double value) const
  {
    return *std::find_if(edges(graph).first, edges(graph).second, [&](auto arc) {
      return graph[source(arc, graph)].value < value && value < graph[target(arc, graph)].value;
    });
  }

  // A hole as a scanner leaves it. Returns a halfedge of its border.
  halfedge_descriptor make_hole(vertex_descriptor v)
  {
    const halfedge_descriptor h = CGAL::Euler::remove_center_vertex(halfedge(v, mesh), mesh);
    CGAL::Euler::remove_face(h, mesh);
    return h;
  }
};

} // namespace

BOOST_AUTO_TEST_CASE(scalar_maps)
{
  Double_torus torus;
  const Mesh& mesh = torus.mesh;
  const std::vector<double> values(mesh.number_of_vertices(), 1);
  //! [scalar_maps]
  auto from_range = CGAL::Reeb_graph::make_scalar_map(mesh, values); // copies them
  auto from_function = CGAL::Reeb_graph::make_scalar_map_from_function(mesh, [&](auto v) { return mesh.point(v).z(); });
  //! [scalar_maps]
  BOOST_TEST(get(from_range, torus.nose) == 1);
  BOOST_TEST(get(from_function, torus.nose) == mesh.point(torus.nose).z());
}

namespace {
typedef Mesh::Property_map<vertex_descriptor, std::pair<double, int>> Pair_map;
//! [traits]
struct Traits_of_pairs : CGAL::Reeb_graph_traits<Mesh, Pair_map>
{
  auto scalar_to_double_object() const
  {
    return [](const std::pair<double, int>& a) { return a.first; };
  }
  auto scalar_from_double_object() const
  {
    return [](double a) { return std::pair<double, int>(a, 0); };
  }
};
//! [traits]

typedef Mesh::Property_map<vertex_descriptor, int> Key_map;
//! [traits_of_keys]
struct Traits_of_keys : CGAL::Reeb_graph_traits<Mesh, Key_map>
{
  struct Less_scalar
  {
    const std::vector<double>* table;
    bool operator()(int a, int b) const { return (*table)[a] < (*table)[b]; }
  };
  Less_scalar less_scalar_object() const { return {table}; }
  auto scalar_to_double_object() const
  {
    return [table = table](int key) { return (*table)[key]; };
  }

  const std::vector<double>* table = nullptr;
};
//! [traits_of_keys]
} // namespace

BOOST_AUTO_TEST_CASE(graphs)
{
  Double_torus torus;
  const Mesh& mesh = torus.mesh;
  const Scalar_map scalar_map = torus.scalar_map, first_map = scalar_map;
  const auto second_map = CGAL::Reeb_graph::make_scalar_map_from_function(mesh, [&](auto v) { return -scalar_map[v]; });
  Graph graph;
  double done = 0;
  const auto callback = [&](double fraction) {
    done = fraction;
    return true;
  };
  //! [named_parameters]
  namespace parameters = CGAL::parameters;

  CGAL::compute_reeb_graph(
    mesh, scalar_map, graph,
    parameters::ties(CGAL::Reeb_graph::Ties::CONTRACT).keep_degree_two_nodes(true).callback(callback));
  //! [named_parameters]
  BOOST_TEST(done == 1);

  //! [flat_field]
  CGAL::Reeb_graph::Flat_field field(mesh, first_map);
  CGAL::compute_reeb_graph(mesh, field, graph);
  field.set_values(second_map);
  CGAL::compute_reeb_graph(mesh, field, graph); // the mesh is not checked again
  //! [flat_field]
  BOOST_TEST(graph[*vertices(graph).first].value == -5);

  //! [components]
  // Counts as number_of_components() does, and numbers the component of each node.
  std::vector<std::size_t> component(num_vertices(graph));
  const std::size_t number = CGAL::Reeb_graph::connected_components(
    graph, boost::make_iterator_property_map(component.begin(), get(boost::vertex_index, graph)));
  std::vector<Graph::vertex_descriptor> tips;
  CGAL::Reeb_graph::leaves(graph, std::back_inserter(tips));
  //! [components]
  BOOST_TEST(tips.size() == 2);
  BOOST_TEST(number == 1);
  BOOST_TEST(component.back() == 0);

  Pair_map pairs = torus.mesh.add_property_map<vertex_descriptor, std::pair<double, int>>("v:pair").first;
  for(const vertex_descriptor v : vertices(mesh))
    pairs[v] = {scalar_map[v], 7};
  Traits_of_pairs::Graph graph_of_pairs;
  CGAL::compute_reeb_graph(mesh, pairs, graph_of_pairs, parameters::geom_traits(Traits_of_pairs()));
  CGAL::Reeb_graph::arc_persistences(graph_of_pairs, parameters::geom_traits(Traits_of_pairs()));

  Key_map keys = torus.mesh.add_property_map<vertex_descriptor, int>("v:key").first;
  std::vector<double> table;
  for(const vertex_descriptor v : vertices(mesh))
  {
    keys[v] = int(mesh.number_of_vertices()) - 1 - int(table.size()); // falls as the vertices go on
    table.push_back(scalar_map[v]);
  }
  std::reverse(table.begin(), table.end());
  Traits_of_keys traits;
  traits.table = &table;
  Traits_of_keys::Graph graph_of_keys, simplified_by_keys;
  CGAL::compute_reeb_graph(mesh, keys, graph_of_keys, parameters::geom_traits(traits));
  CGAL::Reeb_graph::simplify(graph_of_keys, 0.1, simplified_by_keys,
                             parameters::cancel_loops(true).geom_traits(traits));
  Graph plain_graph, simplified;
  CGAL::compute_reeb_graph(mesh, scalar_map, plain_graph);
  CGAL::Reeb_graph::simplify(plain_graph, 0.1, simplified, parameters::cancel_loops(true));
  BOOST_TEST(num_vertices(graph_of_keys) == num_vertices(plain_graph));
  BOOST_TEST(num_vertices(simplified_by_keys) == num_vertices(simplified));
}

BOOST_AUTO_TEST_CASE(way_back)
{
  Double_torus torus;
  const Mesh& mesh = torus.mesh;
  const Scalar_map scalar_map = torus.scalar_map;
  const Graph& graph = torus.graph;
  const auto arc = torus.arc_at(2.5);
  //! [augmentation]
  const CGAL::Reeb_graph::Augmentation augmentation(mesh, scalar_map, graph);
  const auto contour = augmentation.contour(arc, 0.5); // halfway up the arc
  const auto at_value = augmentation.contour_at_value(arc, 2.5);
  const auto level_set = augmentation.contours_at_value(2.5); // a vector of contours, of all arcs
  const auto places = augmentation.locate_vertices();         // the arc or node of each vertex
  //! [augmentation]
  BOOST_TEST(contour.edges.size() > 2);
  BOOST_TEST(at_value.value == 2.5);

  //! [measures]
  const auto lengths = CGAL::Reeb_graph::arc_lengths(mesh, scalar_map, graph); // of the chains, as polylines
  const auto areas = CGAL::Reeb_graph::arc_areas(mesh, graph, places);         // they add up to that of the mesh
  const auto pieces = CGAL::Reeb_graph::areas_of_places(mesh, graph, places);  // nodes and arcs apart
  const auto counts = CGAL::Reeb_graph::vertex_counts_of_places(mesh, graph, places);
  const auto means = CGAL::Reeb_graph::arc_mean_values(mesh, scalar_map, graph, places); // weighted by area
  //! [measures]
  BOOST_TEST(means.size() == num_edges(graph));
  BOOST_TEST(lengths.size() == num_edges(graph));
  BOOST_TEST(areas.size() == num_edges(graph));
  BOOST_TEST(pieces.size() == num_vertices(graph) + num_edges(graph));
  BOOST_TEST(counts.size() == pieces.size());

  Graph simplified;
  //! [simplify]
  namespace parameters = CGAL::parameters;
  CGAL::Reeb_graph::simplify(graph, 0.5, simplified, parameters::place_weights(pieces)); // by area
  CGAL::Reeb_graph::simplify(graph, 0.1, simplified, parameters::cancel_loops(true));    // loops, too
  //! [simplify]
  BOOST_TEST(CGAL::Reeb_graph::number_of_loops(simplified) == 2);

  Curves curves;
  //! [cut_along_contours]
  CGAL::Reeb_graph::cut_along_contours(torus.mesh, scalar_map, level_set, std::back_inserter(curves));
  //! [cut_along_contours]
  BOOST_TEST(curves.size() == level_set.size());
}

BOOST_AUTO_TEST_CASE(files_of_embeddings)
{
  Double_torus torus;
  const Mesh& mesh = torus.mesh;
  const Graph& graph = torus.graph;
  const CGAL::Reeb_graph::Augmentation augmentation(mesh, torus.scalar_map, graph);
  const auto embedding = CGAL::Reeb_graph::embed(augmentation);
  //! [write_embedding]
  const auto index_map = get(boost::vertex_index, mesh);
  CGAL::Reeb_graph::write_vtp("graph.vtp", graph, embedding, index_map);             // for ParaView
  CGAL::Reeb_graph::write_obj("graph.obj", graph, embedding);                        // lines
  CGAL::Reeb_graph::write_json("graph.json", mesh, graph, embedding, index_map);     // with chains
  CGAL::Reeb_graph::write_csv("nodes.csv", "arcs.csv", graph, embedding, index_map); // two tables
  //! [write_embedding]
  BOOST_TEST(embedding.node_points.size() == num_vertices(graph));
}

BOOST_AUTO_TEST_CASE(curves)
{
  {
    Double_torus torus;
    Mesh& mesh = torus.mesh;
    const Scalar_map scalar_map = torus.scalar_map;
    //! [branch_curves]
    namespace parameters = CGAL::parameters;
    std::vector<CGAL::Reeb_graph::Curve<halfedge_descriptor>> curves;
    CGAL::Reeb_graph::branch_curves(mesh, scalar_map, std::back_inserter(curves), parameters::area_threshold(0.5));
    // or by a function object, of a Reeb_graph::Branch whose weight is its area:
    CGAL::Reeb_graph::branch_curves(
      mesh, scalar_map, std::back_inserter(curves),
      parameters::measure_threshold(0.5).branch_measure([](const auto& branch) { return branch.weight; }));
    //! [branch_curves]
    curves.clear();
    //! [choice_of_curves]
    // near the middles of arcs, and in at most a million faces
    CGAL::Reeb_graph::cutting_system(
      mesh, scalar_map, std::back_inserter(curves),
      parameters::number_of_candidates(32)
        .curve_cost([](const CGAL::Reeb_graph::Candidate_curve& place) { return std::abs(place.position - 0.5); })
        .face_count_callback([](std::size_t number_of_faces) { return number_of_faces <= 1000000; }));
    //! [choice_of_curves]
    BOOST_TEST(curves.size() == 2);
    curves.clear();
    //! [harmonic_pants]
    CGAL::Reeb_graph::harmonic_pants_decomposition(mesh, std::back_inserter(curves));
    //! [harmonic_pants]
    BOOST_TEST(curves.size() == 3);
  }
  Double_torus torus;
  Mesh& mesh = torus.mesh;
  const Scalar_map scalar_map = torus.scalar_map;
  const auto rank_map = mesh.add_property_map<vertex_descriptor, std::size_t>("v:rank").first;
  //! [unfold]
  // rank_map gets numbers in the order of the field on the mesh with simple saddles.
  CGAL::Reeb_graph::unfold_multi_saddles(mesh, scalar_map, rank_map);
  //! [unfold]
  const auto face_patch_map = mesh.add_property_map<face_descriptor, std::size_t>("f:patch").first;
  //! [segment_by_pants]
  const std::size_t number_of_pants = CGAL::Reeb_graph::segment_by_pants(mesh, scalar_map, face_patch_map);
  //! [segment_by_pants]
  BOOST_TEST(number_of_pants == 2);
}

BOOST_AUTO_TEST_CASE(borders)
{
  Double_torus torus;
  torus.make_hole(torus.tail);
  torus.mesh.collect_garbage();
  Mesh& mesh = torus.mesh;
  const Scalar_map scalar_map = torus.scalar_map;
  const auto color_map = mesh.add_property_map<vertex_descriptor, double>("v:color").first;
  const auto material_map = mesh.add_property_map<face_descriptor, int>("f:material", 3).first;
  Curves curves;
  {
    //! [interpolating_visitor]
    CGAL::Reeb_graph::Interpolating_visitor<Mesh> visitor;
    visitor.add_vertex_map(color_map).add_face_map(material_map);
    CGAL::Reeb_graph::pants_decomposition(
      mesh, scalar_map, std::back_inserter(curves),
      CGAL::parameters::borders(CGAL::Reeb_graph::Borders::MAKE_LEVEL).visitor(visitor));
    //! [interpolating_visitor]
  }
  BOOST_TEST(curves.size() == 4);
  BOOST_TEST(material_map[*std::prev(faces(mesh).end())] == 3);
  curves.clear();
  //! [level_borders]
  // 1. Let the function change the field next to borders.
  CGAL::Reeb_graph::pants_decomposition(mesh, scalar_map, std::back_inserter(curves),
                                        CGAL::parameters::borders(CGAL::Reeb_graph::Borders::MAKE_LEVEL));
  // 2. Change it before, and see by how much.
  const auto changes = CGAL::Reeb_graph::make_borders_level(mesh, scalar_map);
  // 3. Compute a field that has level borders, and is smooth there.
  CGAL::Reeb_graph::compute_harmonic_field_between_borders(mesh, scalar_map);
  //! [level_borders]
  BOOST_TEST(curves.size() == 4);
  BOOST_TEST(changes.number_of_borders == 1);
}

BOOST_AUTO_TEST_CASE(fields)
{
  Double_torus torus;
  const vertex_descriptor source = torus.nose, tail = torus.tail, nose = torus.nose, tip_of_the_head = nose;
  Mesh& mesh = torus.mesh;
  const Scalar_map scalar_map = torus.scalar_map;
  //! [heights]
  CGAL::Reeb_graph::compute_height_field(mesh, scalar_map, Kernel::Vector_3(0, 0, 1));
  CGAL::Reeb_graph::compute_geodesic_field(mesh, scalar_map, std::vector<vertex_descriptor>{source});
  //! [heights]
  BOOST_TEST(scalar_map[source] == 0);
  {
    const auto curvature_map = mesh.add_property_map<vertex_descriptor, double>("v:curvature").first;
    //! [poisson]
    const std::vector<std::pair<vertex_descriptor, double>> fixed = {{tip_of_the_head, 0.}};
    CGAL::Reeb_graph::compute_curvature_poisson_field(mesh, scalar_map, fixed);
    // or step by step:
    CGAL::Reeb_graph::compute_mean_curvature(mesh, curvature_map);
    CGAL::Reeb_graph::compute_poisson_field(mesh, scalar_map, curvature_map, fixed);
    //! [poisson]
    BOOST_TEST(scalar_map[tip_of_the_head] == 0);
  }
  {
    const auto gradient_map = mesh.add_property_map<face_descriptor, Kernel::Vector_3>("f:gradient").first;
    const auto divergence_map = mesh.add_property_map<vertex_descriptor, double>("v:divergence").first;
    //! [gradient]
    CGAL::Reeb_graph::compute_gradient(mesh, scalar_map, gradient_map);
    CGAL::Reeb_graph::compute_divergence(mesh, gradient_map, divergence_map);
    //! [gradient]
  }
  const halfedge_descriptor border_halfedge = torus.make_hole(*vertices(mesh).begin());
  //! [harmonic]
  CGAL::Reeb_graph::compute_harmonic_field_between(mesh, scalar_map, tail, nose);
  // or with any vertices and borders of given values:
  std::vector<std::pair<vertex_descriptor, double>> fixed = {{nose, 1.}};
  CGAL::Reeb_graph::fix_border_cycle(border_halfedge, mesh, 0., std::back_inserter(fixed));
  CGAL::Reeb_graph::compute_harmonic_field(mesh, scalar_map, fixed);
  //! [harmonic]
  BOOST_TEST(scalar_map[nose] == 1);
}

BOOST_AUTO_TEST_CASE(exceptions)
{
  Double_torus torus;
  const Mesh& mesh = torus.mesh;
  const Scalar_map scalar_map = torus.scalar_map;
  Graph graph;
  put(scalar_map, torus.nose, std::numeric_limits<double>::quiet_NaN());
  std::ostringstream out;
  //! [exceptions]
  try
  {
    CGAL::compute_reeb_graph(mesh, scalar_map, graph);
  }
  catch(const CGAL::Reeb_graph::Vertex_error& error) // Face_error has face(), Error only what()
  {
    out << error.what() << ", at " << mesh.point(*std::next(vertices(mesh).begin(), error.vertex())) << std::endl;
  }
  //! [exceptions]
  BOOST_TEST(out.str().find(", at ") != std::string::npos);
}

BOOST_AUTO_TEST_SUITE_END()
