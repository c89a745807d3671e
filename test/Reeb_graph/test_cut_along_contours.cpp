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
#include <CGAL/Reeb_graph/curves/cut_along_contours.h>
#include <CGAL/Reeb_graph/scalar_maps.h>
#include <CGAL/compute_reeb_graph.h>

#include <boost/mpl/list.hpp>

#include <algorithm>
#include <cstddef>
#include <functional>
#include <iterator>
#include <map>
#include <numeric>
#include <string>
#include <utility>
#include <vector>

// Meshes cut along many contours at a time, of any field, with borders that contours may end at.

BOOST_AUTO_TEST_SUITE(test_cut_along_contours)

using namespace cut_mesh_checks;
using curve_samples::number_of_samples;
using curve_samples::Sample;
using mesh_builders::Polyhedron;
using mesh_builders::Surface_mesh;

typedef boost::mpl::list<Surface_mesh, Polyhedron> Meshes;

namespace {
template <class Mesh>
struct Cut_sample
{
  typedef typename boost::graph_traits<Mesh>::vertex_descriptor vertex_descriptor;
  typedef typename boost::graph_traits<Mesh>::halfedge_descriptor halfedge_descriptor;
  typedef decltype(CGAL::Reeb_graph::make_scalar_map(std::declval<Mesh&>(), std::vector<double>())) Scalar_map;
  typedef typename CGAL::Reeb_graph_traits<Mesh, Scalar_map>::Graph Graph;
  typedef CGAL::Reeb_graph::Augmentation<Mesh, Scalar_map> Augmentation;

  explicit Cut_sample(const Sample& sample)
    : mesh(curve_samples::make_mesh<Mesh>(sample.soup)),
      scalar_map(CGAL::Reeb_graph::make_scalar_map(mesh, sample.values)),
      components(pieces_of(mesh))
  {
    CGAL::compute_reeb_graph(mesh, scalar_map, graph);
    const Augmentation augmentation(mesh, scalar_map, graph);
    for(const auto node : CGAL::make_range(vertices(graph)))
    {
      const auto critical_set = augmentation.critical_set(node);
      contours.insert(contours.end(), critical_set.lower_contours.begin(), critical_set.lower_contours.end());
      contours.insert(contours.end(), critical_set.upper_contours.begin(), critical_set.upper_contours.end());
    }
    for(const auto arc : CGAL::make_range(edges(graph)))
      for(const double t : {0.5, 0.25, 0.500001, 0.5})
        contours.push_back(augmentation.contour(arc, t));
    for(const vertex_descriptor v : vertices(mesh))
      order.emplace(v, std::make_pair(get(scalar_map, v), order.size()));
    for(const auto& contour : contours)
    {
      levels.push_back(order.at(source(contour.edges.front(), mesh)));
      for(const halfedge_descriptor h : contour.edges)
        levels.back() = (std::max)(levels.back(), order.at(source(h, mesh)));
    }
  }

  template <class NamedParameters>
  void cut(const NamedParameters& np)
  {
    CGAL::Reeb_graph::cut_along_contours(mesh, scalar_map, contours, std::back_inserter(curves), np);
  }

  // On both sides of each curve, the vertices of the input are on the side where their places in the order are.
  std::string fault_of_sides() const
  {
    for(std::size_t i = 0; i < curves.size(); ++i)
      for(std::size_t j = 0; j < curves[i].halfedges.size(); ++j)
      {
        const auto upper = order.find(target(next(curves[i].halfedges[j], mesh), mesh));
        const auto lower = order.find(target(next(curves[i].lower_halfedges[j], mesh), mesh));
        if((upper != order.end() && upper->second <= levels[i]) || (lower != order.end() && levels[i] < lower->second))
          return "the higher side of a curve is not on the left";
      }
    return "";
  }

  Mesh mesh;
  Scalar_map scalar_map;
  std::vector<Piece> components;
  Graph graph;
  std::vector<typename Augmentation::Contour> contours;
  std::map<vertex_descriptor, std::pair<double, std::size_t>> order;
  std::vector<std::pair<double, std::size_t>> levels;
  std::vector<CGAL::Reeb_graph::Curve<halfedge_descriptor>> curves;
};

long sum_of_euler_characteristics(const std::vector<Piece>& pieces)
{
  return std::accumulate(pieces.begin(), pieces.end(), 0l,
                         [](long sum, const Piece& piece) { return sum + piece.euler_characteristic; });
}
} // namespace

BOOST_AUTO_TEST_CASE_TEMPLATE(many_contours_at_a_time, Mesh, Meshes)
{
  for(std::size_t seed = 0; seed < number_of_samples<Mesh>(400); ++seed)
    BOOST_TEST_CONTEXT("seed " << seed)
    {
      Cut_sample<Mesh> sample(curve_samples::any_sample(seed));
      Face_history<Mesh> history(sample.mesh);
      auto visitor = history.visitor();
      std::size_t number_of_faces = 0; // that is told before
      const auto tell = [&](std::size_t number) {
        number_of_faces = number;
        return true;
      };
      sample.cut(CGAL::parameters::face_count_callback(tell).visitor(std::ref(visitor)));
      BOOST_TEST(number_of_faces == num_faces(sample.mesh));
      BOOST_REQUIRE(sample.curves.size() == sample.contours.size());
      long number_of_open_curves = 0;
      for(std::size_t i = 0; i < sample.curves.size(); ++i)
      {
        BOOST_TEST(sample.curves[i].is_closed == sample.contours[i].is_closed());
        BOOST_TEST(sample.curves[i].value == sample.contours[i].value);
        number_of_open_curves += sample.curves[i].is_closed ? 0 : 1;
      }
      const auto pieces = pieces_between(sample.mesh, sample.curves);
      BOOST_TEST(fault_of_cut_mesh(sample.mesh, sample.curves, pieces) == "");
      BOOST_TEST(sum_of_euler_characteristics(pieces)
                 == sum_of_euler_characteristics(sample.components) + number_of_open_curves);
      BOOST_TEST(sample.fault_of_sides() == "");
      BOOST_TEST(history.fault() == "");
    }
}

BOOST_AUTO_TEST_CASE_TEMPLATE(cutting_open_parts_the_pieces, Mesh, Meshes)
{
  for(std::size_t seed = 0; seed < number_of_samples<Mesh>(400); ++seed)
    BOOST_TEST_CONTEXT("seed " << seed)
    {
      Cut_sample<Mesh> sample(curve_samples::any_sample(seed)), opened(curve_samples::any_sample(seed));
      sample.cut(CGAL::parameters::default_values());
      opened.cut(CGAL::parameters::cut_open(true));
      BOOST_TEST(is_valid_mesh(opened.mesh));
      auto pieces = pieces_between(sample.mesh, sample.curves), opened_pieces = pieces_of(opened.mesh);
      std::sort(pieces.begin(), pieces.end());
      std::sort(opened_pieces.begin(), opened_pieces.end());
      BOOST_REQUIRE(pieces.size() == opened_pieces.size());
      for(std::size_t i = 0; i < pieces.size(); ++i)
        BOOST_TEST(!(pieces[i] < opened_pieces[i] || opened_pieces[i] < pieces[i]));

      std::size_t number_of_new_vertices = 0;
      const auto point_map = get(CGAL::vertex_point, opened.mesh);
      for(const auto& curve : opened.curves)
      {
        number_of_new_vertices += curve.halfedges.size() + (curve.is_closed ? 0 : 1);
        bool is_parted = true;
        for(std::size_t i = 0; i < curve.halfedges.size(); ++i)
        {
          const auto h = curve.halfedges[i], g = curve.lower_halfedges[i];
          is_parted = is_parted && !is_border(h, opened.mesh) && !is_border(g, opened.mesh)
                   && is_border(opposite(h, opened.mesh), opened.mesh)
                   && is_border(opposite(g, opened.mesh), opened.mesh)
                   && source(h, opened.mesh) != target(g, opened.mesh)
                   && get(point_map, source(h, opened.mesh)) == get(point_map, target(g, opened.mesh))
                   && get(point_map, target(h, opened.mesh)) == get(point_map, source(g, opened.mesh));
        }
        BOOST_TEST(is_parted);
      }
      BOOST_TEST(num_vertices(opened.mesh) == num_vertices(sample.mesh) + number_of_new_vertices);
      BOOST_TEST(num_faces(opened.mesh) == num_faces(sample.mesh));
      BOOST_TEST(opened.fault_of_sides() == "");
    }
}

BOOST_AUTO_TEST_CASE_TEMPLATE(property_maps_tell_the_curves_and_the_pieces, Mesh, Meshes)
{
  for(std::size_t seed = 0; seed < number_of_samples<Mesh>(200); ++seed)
    for(const bool is_cut_open : {false, true})
      BOOST_TEST_CONTEXT("seed " << seed << (is_cut_open ? ", cut open" : ""))
      {
        typedef typename boost::graph_traits<Mesh>::edge_descriptor edge_descriptor;
        typedef typename boost::graph_traits<Mesh>::face_descriptor face_descriptor;
        Cut_sample<Mesh> sample(curve_samples::any_sample(seed));
        std::map<edge_descriptor, bool> is_constrained;
        std::map<edge_descriptor, std::size_t> curve_of_edge;
        std::map<face_descriptor, std::size_t> patch_of_face;
        sample.cut(CGAL::parameters::cut_open(is_cut_open)
                     .edge_curve_map(boost::make_assoc_property_map(curve_of_edge))
                     .edge_is_constrained_map(boost::make_assoc_property_map(is_constrained))
                     .face_patch_map(boost::make_assoc_property_map(patch_of_face)));

        std::map<edge_descriptor, std::size_t> expected;
        for(std::size_t i = 0; i < sample.curves.size(); ++i)
          for(const auto* halfedges : {&sample.curves[i].halfedges, &sample.curves[i].lower_halfedges})
            for(const auto h : *halfedges)
              expected[edge(h, sample.mesh)] = i;
        BOOST_TEST((curve_of_edge == expected));
        BOOST_TEST(is_constrained.size() == expected.size());
        BOOST_TEST(std::all_of(is_constrained.begin(), is_constrained.end(),
                               [&](const auto& item) { return item.second && expected.count(item.first) == 1; }));

        BOOST_TEST(patch_of_face.size() == num_faces(sample.mesh));
        const auto is_cut = [&](typename boost::graph_traits<Mesh>::halfedge_descriptor h) {
          return expected.count(edge(h, sample.mesh)) != 0;
        };
        const auto piece_of_triangle = Flat_mesh(sample.mesh, is_cut).pieces().second;
        std::vector<std::size_t> patches;
        for(const auto f : faces(sample.mesh))
          patches.push_back(patch_of_face[f]);
        BOOST_TEST((patches == piece_of_triangle));
      }
}

namespace {
template <class Mesh>
struct Recording_visitor : CGAL::Reeb_graph::Default_refinement_visitor<Mesh>
{
  typedef typename boost::graph_traits<Mesh>::vertex_descriptor vertex_descriptor;
  typedef typename boost::graph_traits<Mesh>::halfedge_descriptor halfedge_descriptor;
  typedef typename boost::graph_traits<Mesh>::face_descriptor face_descriptor;

  void edge_split(halfedge_descriptor first, halfedge_descriptor second)
  {
    ++splits;
    is_fine = is_fine && target(first, *mesh) == source(second, *mesh);
  }
  void vertex_added(vertex_descriptor v, vertex_descriptor u, vertex_descriptor w, double t)
  {
    ++added;
    const auto point_map = get(CGAL::vertex_point, *mesh);
    const auto p = get(point_map, u), q = get(point_map, w);
    is_fine = is_fine && t > 0 && t < 1 && get(point_map, v) == p + t * (q - p);
  }
  void face_split(face_descriptor, face_descriptor) { ++face_splits; }
  void vertex_duplicated(vertex_descriptor old, vertex_descriptor created)
  {
    ++duplicates;
    is_fine = is_fine && old != created;
  }
  void halfedge_duplicated(halfedge_descriptor old, halfedge_descriptor created)
  {
    ++halfedge_duplicates;
    is_fine = is_fine && old != created;
  }

  const Mesh* mesh = nullptr;
  bool is_fine = true;
  std::size_t splits = 0, added = 0, face_splits = 0, duplicates = 0, halfedge_duplicates = 0;
};
} // namespace

BOOST_AUTO_TEST_CASE_TEMPLATE(a_visitor_is_told_of_everything_that_is_new, Mesh, Meshes)
{
  for(std::size_t seed = 0; seed < 60; ++seed)
    BOOST_TEST_CONTEXT("seed " << seed)
    {
      Cut_sample<Mesh> sample(curve_samples::any_sample(seed));
      const std::size_t number_of_vertices = num_vertices(sample.mesh), number_of_faces = num_faces(sample.mesh);
      Recording_visitor<Mesh> visitor;
      visitor.mesh = &sample.mesh;
      sample.cut(CGAL::parameters::cut_open(true).visitor(std::ref(visitor)));
      std::size_t number_of_curve_edges = 0;
      for(const auto& curve : sample.curves)
        number_of_curve_edges += curve.halfedges.size();
      BOOST_TEST(visitor.is_fine);
      BOOST_TEST(visitor.splits == visitor.added);
      BOOST_TEST(visitor.halfedge_duplicates == number_of_curve_edges);
      BOOST_TEST(num_vertices(sample.mesh) == number_of_vertices + visitor.added + visitor.duplicates);
      BOOST_TEST(num_faces(sample.mesh) == number_of_faces + visitor.face_splits);
    }
}

BOOST_AUTO_TEST_CASE(what_is_no_contour_is_refused)
{
  typedef Cut_sample<Surface_mesh> Sample_of_mesh;
  const Sample input = curve_samples::any_sample(3 * 6); // closed
  const auto check = [&](const std::function<void(Sample_of_mesh&)>& spoil) {
    Sample_of_mesh sample(input);
    const std::size_t number_of_vertices = num_vertices(sample.mesh);
    spoil(sample);
    BOOST_CHECK_EXCEPTION(sample.cut(CGAL::parameters::default_values()), CGAL::Reeb_graph::Invalid_contour_error,
                          [](const CGAL::Reeb_graph::Invalid_contour_error& error) { return error.contour() == 2; });
    BOOST_TEST(num_vertices(sample.mesh) == number_of_vertices);
    BOOST_TEST(sample.curves.empty());
  };
  BOOST_REQUIRE(Sample_of_mesh(input).contours.at(2).is_closed());
  check([](Sample_of_mesh& sample) { sample.contours[2].edges.clear(); });
  check([](Sample_of_mesh& sample) { sample.contours[2].edges.pop_back(); });
  check([](Sample_of_mesh& sample) { sample.contours[2].is_cyclic = false; });
  check([](Sample_of_mesh& sample) {
    auto& halfedges = sample.contours[2].edges;
    std::reverse(halfedges.begin(), halfedges.end());
  });
  check([](Sample_of_mesh& sample) {
    for(auto& h : sample.contours[2].edges)
      h = opposite(h, sample.mesh);
  });
}

BOOST_AUTO_TEST_SUITE_END()
