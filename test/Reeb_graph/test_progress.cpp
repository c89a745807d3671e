// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#include <boost/test/unit_test.hpp>

#include "computed_graphs.h"
#include "curve_samples.h"

#include <CGAL/Reeb_graph/curves/branch_curves.h>
#include <CGAL/Reeb_graph/curves/cut_along_contours.h>
#include <CGAL/Reeb_graph/curves/cutting_system.h>
#include <CGAL/Reeb_graph/curves/pants_decomposition.h>
#include <CGAL/Reeb_graph/curves/segmentation.h>
#include <CGAL/Reeb_graph/curves/unfold_multi_saddles.h>
#include <CGAL/Reeb_graph/fields/make_borders_level.h>
#include <CGAL/Reeb_graph/simplification/simplify_field.h>
#ifdef CGAL_EIGEN3_ENABLED
#include <CGAL/Reeb_graph/curves/harmonic_pants_decomposition.h>
#endif
#include <CGAL/Dynamic_property_map.h>
#include <CGAL/boost/graph/helpers.h>

#include <boost/iterator/function_output_iterator.hpp>
#include <boost/mpl/list.hpp>
#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <iterator>
#include <map>
#include <string>
#include <tuple>
#include <type_traits>
#include <vector>

// The named parameter callback: how far the work is, and how it is stopped; and face_count_callback, which tells how
// large a cut mesh will be.

BOOST_AUTO_TEST_SUITE(test_progress)

namespace parameters = CGAL::parameters;
using namespace computed_graphs;
using mesh_builders::Polyhedron;
using mesh_builders::Surface_mesh;

template <class Mesh_, class Tag>
struct Case
{
  typedef Mesh_ Mesh;
  typedef Tag Concurrency_tag;
};

typedef boost::mpl::list<Case<Surface_mesh, CGAL::Sequential_tag>,
                         Case<Surface_mesh, CGAL::Parallel_if_available_tag>,
                         Case<Polyhedron, CGAL::Parallel_if_available_tag>>
  Cases;

namespace {
// Tells which fractions it has been told, and wants no more at one of them.
class Listener
{
public:
  explicit Listener(std::size_t number_of_calls = 1000) : last_(number_of_calls) {}

  bool operator()(double fraction)
  {
    fractions_.push_back(fraction);
    return fractions_.size() != last_;
  }

  const std::vector<double>& fractions() const { return fractions_; }

private:
  std::size_t last_;
  std::vector<double> fractions_;
};

// a small one, and one that is worked on in parallel
std::vector<Combinatorial_mesh> meshes()
{
  return {Combinatorial_mesh(), random_meshes::tetrahedron(), random_meshes::cylinder(110, 110)};
}

template <class Case>
class Computation
{
  typedef typename Case::Mesh Mesh;

public:
  Computation(const Combinatorial_mesh& mesh, Method method, std::size_t number_of_slabs)
    : mesh_(make_mesh<Mesh>(mesh)),
      scalar_map_(CGAL::Reeb_graph::make_scalar_map(mesh_, std::vector<double>(mesh.number_of_vertices, 1)))
  {
    settings_.method = method;
    settings_.number_of_slabs = number_of_slabs;
  }

  void operator()(graph_checks::Graph_of<Mesh>& graph, Listener& listener) const
  {
    CGAL::compute_reeb_graph<typename Case::Concurrency_tag>(mesh_, scalar_map_, graph,
                                                             named_parameters(settings_).callback(std::ref(listener)));
  }

private:
  Mesh mesh_;
  graph_checks::Scalar_map_of<Mesh> scalar_map_;
  Settings settings_;
};
} // namespace

BOOST_AUTO_TEST_CASE_TEMPLATE(fractions_grow_to_one, C, Cases)
{
  for(const Combinatorial_mesh& mesh : meshes())
    for(const Method method : {Method::CONTOUR_TREES, Method::CRITICAL_SETS})
      for(const std::size_t number_of_slabs : {std::size_t(1), std::size_t(3)})
      {
        Listener listener;
        graph_checks::Graph_of<typename C::Mesh> graph;
        Computation<C>(mesh, method, number_of_slabs)(graph, listener);
        BOOST_TEST_REQUIRE(listener.fractions().size() > 2u);
        BOOST_TEST(listener.fractions().front() >= 0);
        BOOST_TEST(std::is_sorted(listener.fractions().begin(), listener.fractions().end()));
        BOOST_TEST(listener.fractions().back() == 1);
      }
}

BOOST_AUTO_TEST_CASE_TEMPLATE(work_can_be_stopped_at_each_call_but_the_last, C, Cases)
{
  for(const Combinatorial_mesh& mesh : meshes())
    for(const Method method : {Method::CONTOUR_TREES, Method::CRITICAL_SETS})
      for(const std::size_t number_of_slabs : {std::size_t(1), std::size_t(3)})
      {
        const Computation<C> compute(mesh, method, number_of_slabs);
        graph_checks::Graph_of<typename C::Mesh> expected, graph(2);
        add_edge(0, 1, graph);
        graph[1].value = 17;
        Listener undisturbed;
        compute(expected, undisturbed);
        const std::size_t last_call = undisturbed.fractions().size();
        for(std::size_t call = 1; call < last_call; ++call)
        {
          Listener listener(call);
          BOOST_CHECK_THROW(compute(graph, listener), CGAL::Reeb_graph::Cancelled_error);
          BOOST_TEST(listener.fractions().size() == call);
          BOOST_TEST(num_vertices(graph) == 2u);
          BOOST_TEST(num_edges(graph) == 1u);
          BOOST_TEST(graph[1].value == 17);
        }
        // There is nothing left to stop at the end.
        Listener listener(last_call);
        compute(graph, listener);
        BOOST_TEST(num_vertices(graph) == num_vertices(expected));
        BOOST_TEST(num_edges(graph) == num_edges(expected));
      }
}

// The slow parts of the work are several steps each.
BOOST_AUTO_TEST_CASE(arcs_are_found_in_steps)
{
  const auto number_of_calls_within = [](Method method, double begin, double end) {
    Listener listener;
    graph_checks::Graph_of<Surface_mesh> graph;
    const auto mesh = random_meshes::cylinder(110, 110);
    Computation<Case<Surface_mesh, CGAL::Sequential_tag>>(mesh, method, 1)(graph, listener);
    return std::count_if(listener.fractions().begin(), listener.fractions().end(),
                         [&](double fraction) { return fraction > begin && fraction < end; });
  };
  BOOST_TEST(number_of_calls_within(Method::CONTOUR_TREES, 0.3, 0.7) > 1);
  BOOST_TEST(number_of_calls_within(Method::CRITICAL_SETS, 0.3, 0.7) > 0);
}

BOOST_AUTO_TEST_CASE(being_stopped_is_an_error)
{
  BOOST_TEST((std::is_base_of_v<CGAL::Reeb_graph::Error, CGAL::Reeb_graph::Cancelled_error>));
}

// What changes a mesh or a field, and what takes long otherwise: each is a function of a mesh, a field and a callback.

namespace {
typedef std::reference_wrapper<Listener> Callback;
using curve_samples::Sample;

template <class Mesh>
using Field = typename boost::property_map<Mesh, CGAL::dynamic_vertex_property_t<double>>::type;

template <class Mesh>
struct Work
{
  const char* name;
  std::function<void(Mesh& mesh, Field<Mesh> field, Callback callback)> run;
};

// Nothing is written unless the work is done.
struct No_output
{
  template <class T>
  void operator()(const T&) const
  {
    ++number_of_outputs;
  }

  static inline std::size_t number_of_outputs = 0;
};

// What is told of the number of faces of a cut mesh.
struct Face_counts
{
  bool operator()(std::size_t number) const
  {
    numbers.push_back(number);
    return !are_refused;
  }

  static inline std::vector<std::size_t> numbers;
  static inline bool are_refused = false;
};

auto with_face_counts(Callback callback) { return parameters::face_count_callback(Face_counts()).callback(callback); }

auto with_level_borders(Callback callback)
{
  return parameters::borders(CGAL::Reeb_graph::Borders::MAKE_LEVEL)
    .face_count_callback(Face_counts())
    .callback(callback);
}

template <class Mesh>
std::vector<Work<Mesh>> cuts()
{
  using namespace CGAL::Reeb_graph;
  const auto output = boost::make_function_output_iterator(No_output());
  return {
    {"cutting_system", [=](Mesh& mesh, Field<Mesh> field,
                           Callback callback) { cutting_system(mesh, field, output, with_level_borders(callback)); }},
    {"segment_by_arcs", [](Mesh& mesh, Field<Mesh> field, Callback callback) {
       typename CGAL::Reeb_graph_traits<Mesh, Field<Mesh>>::Graph graph;
       CGAL::compute_reeb_graph(mesh, field, graph);
       const auto patch_map = get(CGAL::dynamic_face_property_t<std::size_t>(), mesh);
       segment_by_arcs(mesh, field, graph, patch_map, with_face_counts(callback));
     }}};
}

std::vector<Work<Surface_mesh>> all_works()
{
  using namespace CGAL::Reeb_graph;
  typedef Field<Surface_mesh> Map;
  typedef CGAL::Reeb_graph_traits<Surface_mesh, Map>::Graph Graph;
  const auto output = boost::make_function_output_iterator(No_output());
  std::vector<Work<Surface_mesh>> works = cuts<Surface_mesh>();
  const auto add = [&](const char* name, const auto& run) { works.push_back({name, run}); };
  add("pants_decomposition", [=](Surface_mesh& mesh, Map field, Callback callback) {
    pants_decomposition(
      mesh, field, output,
      parameters::cut_open(true).borders(Borders::MAKE_LEVEL).face_count_callback(Face_counts()).callback(callback));
  });
  add("branch_curves", [=](Surface_mesh& mesh, Map field, Callback callback) {
    branch_curves(mesh, field, output, with_level_borders(callback).area_threshold(1e-9));
  });
  add("cut_along_contours", [=](Surface_mesh& mesh, Map field, Callback callback) {
    Graph graph;
    CGAL::compute_reeb_graph(mesh, field, graph);
    std::vector<Augmentation<Surface_mesh, Map>::Contour> contours;
    const Augmentation<Surface_mesh, Map> augmentation(mesh, field, graph);
    for(const auto arc : CGAL::make_range(edges(graph)))
      contours.push_back(augmentation.contour(arc, 0.5));
    cut_along_contours(mesh, field, contours, output, with_face_counts(callback));
  });
  add("unfold_multi_saddles", [](Surface_mesh& mesh, Map field, Callback callback) {
    const auto rank_map = get(CGAL::dynamic_vertex_property_t<std::uint64_t>(), mesh);
    unfold_multi_saddles(mesh, field, rank_map, parameters::callback(callback));
  });
  add("make_borders_level", [](Surface_mesh& mesh, Map field, Callback callback) {
    make_borders_level(mesh, field, parameters::callback(callback));
  });
  for(const auto ties : {Ties::PERTURB, Ties::CONTRACT})
    add("simplify_field", [ties](Surface_mesh& mesh, Map field, Callback callback) {
      simplify_field(mesh, field, 1e-6, field, parameters::ties(ties).callback(callback));
    });
  add("Augmentation", [](Surface_mesh& mesh, Map field, Callback callback) {
    Graph graph;
    CGAL::compute_reeb_graph(mesh, field, graph);
    const Augmentation<Surface_mesh, Map> augmentation(mesh, field, graph, parameters::callback(callback));
  });
  add("compute_reeb_graph with places", [](Surface_mesh& mesh, Map field, Callback callback) {
    Graph graph;
    std::map<Surface_mesh::Vertex_index, std::size_t> places;
    const auto np = parameters::vertex_place_map(boost::make_assoc_property_map(places)).callback(callback);
    CGAL::compute_reeb_graph<CGAL::Parallel_if_available_tag>(mesh, field, graph, np);
  });
  add("locate_vertices", [](Surface_mesh& mesh, Map field, Callback callback) {
    Graph graph;
    CGAL::compute_reeb_graph(mesh, field, graph);
    const Augmentation<Surface_mesh, Map> augmentation(mesh, field, graph);
    augmentation.locate_vertices<CGAL::Parallel_if_available_tag>(parameters::callback(callback));
  });
#ifdef CGAL_EIGEN3_ENABLED
  add("harmonic_pants_decomposition", [=](Surface_mesh& mesh, Map, Callback callback) {
    harmonic_pants_decomposition(mesh, output, with_face_counts(callback));
  });
#endif
  return works;
}

// A mesh and its field, with all descriptors.
template <class Mesh>
struct Snapshot
{
  typedef boost::graph_traits<Mesh> Traits;
  typedef typename Traits::vertex_descriptor vertex_descriptor;
  typedef typename Traits::halfedge_descriptor halfedge_descriptor;
  typedef typename Traits::face_descriptor face_descriptor;

  std::vector<std::tuple<vertex_descriptor, halfedge_descriptor, double>> vertices;
  std::vector<std::tuple<halfedge_descriptor, halfedge_descriptor, vertex_descriptor, face_descriptor>> halfedges;
  std::vector<std::tuple<face_descriptor, halfedge_descriptor>> faces;

  Snapshot(const Mesh& mesh, const Field<Mesh>& field)
  {
    for(const auto v : CGAL::make_range(CGAL::vertices(mesh)))
      vertices.emplace_back(v, halfedge(v, mesh), get(field, v));
    for(const auto h : CGAL::make_range(CGAL::halfedges(mesh)))
      halfedges.emplace_back(h, next(h, mesh), target(h, mesh), face(h, mesh));
    for(const auto f : CGAL::make_range(CGAL::faces(mesh)))
      faces.emplace_back(f, halfedge(f, mesh));
  }

  bool operator==(const Snapshot& other) const
  {
    return vertices == other.vertices && halfedges == other.halfedges && faces == other.faces;
  }
};

template <class Mesh>
struct Input
{
  Mesh mesh;
  Field<Mesh> field;

  explicit Input(const Sample& sample)
    : mesh(curve_samples::make_mesh<Mesh>(sample.soup)),
      field(get(CGAL::dynamic_vertex_property_t<double>(), mesh))
  {
    std::size_t position = 0;
    for(const auto v : vertices(mesh))
      put(field, v, sample.values[position++]);
  }
};

template <class Mesh>
std::size_t number_of_faces(const Mesh& mesh)
{
  return static_cast<std::size_t>(std::distance(faces(mesh).first, faces(mesh).second));
}

// Each function that cuts tells how many faces it will make, and makes them, or leaves everything as it was.
template <class Mesh>
void check_face_counts(const Work<Mesh>& work, const Sample& sample)
{
  Listener listener;
  Input<Mesh> input(sample), cut(sample);
  const Snapshot<Mesh> before(input.mesh, input.field);
  Face_counts::numbers.clear();
  work.run(cut.mesh, cut.field, std::ref(listener));
  if(number_of_faces(cut.mesh) != number_of_faces(input.mesh) && work.name != std::string("unfold_multi_saddles"))
    BOOST_TEST_REQUIRE(Face_counts::numbers.size() == 1u);
  if(Face_counts::numbers.empty())
    return;
  BOOST_TEST(Face_counts::numbers.front() == number_of_faces(cut.mesh));

  No_output::number_of_outputs = 0;
  Face_counts::are_refused = true;
  BOOST_CHECK_EXCEPTION(work.run(input.mesh, input.field, std::ref(listener)), CGAL::Reeb_graph::Face_count_error,
                        [&](const auto& error) { return error.number_of_faces() == number_of_faces(cut.mesh); });
  Face_counts::are_refused = false;
  BOOST_TEST((Snapshot<Mesh>(input.mesh, input.field) == before));
  BOOST_TEST(No_output::number_of_outputs == 0u);
}

// The work can be stopped at each call but the last few, and leaves everything as it was then.
template <class Mesh>
void check_work(const Work<Mesh>& work, const Sample& sample)
{
  Listener undisturbed;
  Input<Mesh> expected(sample);
  work.run(expected.mesh, expected.field, std::ref(undisturbed));
  const std::vector<double>& fractions = undisturbed.fractions();
  BOOST_TEST_REQUIRE(fractions.size() > 2u);
  BOOST_TEST(fractions.front() == 0);
  BOOST_TEST(std::is_sorted(fractions.begin(), fractions.end()));
  BOOST_TEST(fractions.back() == 1);
  BOOST_TEST(std::count(fractions.begin(), fractions.end(), 1) == 1);
  No_output::number_of_outputs = 0;
  std::size_t number_of_stops = 0;
  Input<Mesh> input(sample);
  const Snapshot<Mesh> before(input.mesh, input.field);
  for(std::size_t call = 1; call <= fractions.size(); ++call)
  {
    Listener listener(call);
    try
    {
      work.run(input.mesh, input.field, std::ref(listener));
      break;
    }
    catch(const CGAL::Reeb_graph::Cancelled_error&)
    {
      ++number_of_stops;
      BOOST_TEST(listener.fractions().size() == call);
      BOOST_TEST_REQUIRE((Snapshot<Mesh>(input.mesh, input.field) == before));
      BOOST_TEST_REQUIRE(No_output::number_of_outputs == 0u);
      BOOST_TEST_REQUIRE(CGAL::is_valid_polygon_mesh(input.mesh));
    }
  }
  BOOST_TEST(number_of_stops < fractions.size());
  BOOST_TEST(number_of_stops + 2 >= fractions.size());
  // What could not be stopped gives what it gives on a mesh on which nothing has been undone.
  BOOST_TEST(number_of_faces(input.mesh) == number_of_faces(expected.mesh));
  BOOST_TEST(CGAL::is_triangle_mesh(input.mesh));
}

template <class Mesh>
void check_works(const std::vector<Work<Mesh>>& works, void (*check)(const Work<Mesh>&, const Sample&))
{
  for(const Work<Mesh>& work : works)
    for(const bool has_borders : {false, true})
      for(std::size_t seed = 0; seed < 3; ++seed)
      {
        BOOST_TEST_CONTEXT(work.name << ", borders " << has_borders << ", seed " << seed)
        check(work, curve_samples::random_sample(seed, has_borders, 1, 2));
      }
}
} // namespace

BOOST_AUTO_TEST_CASE(work_that_is_stopped_changes_nothing) { check_works(all_works(), check_work<Surface_mesh>); }

BOOST_AUTO_TEST_CASE(splits_are_undone_in_polyhedra) { check_works(cuts<Polyhedron>(), check_work<Polyhedron>); }

BOOST_AUTO_TEST_CASE(the_size_of_a_cut_mesh_is_told_before)
{
  check_works(all_works(), check_face_counts<Surface_mesh>);
  check_works(cuts<Polyhedron>(), check_face_counts<Polyhedron>);
}

BOOST_AUTO_TEST_SUITE_END()
