// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#include "Table.h"
#include "surfaces.h"

#include <CGAL/Reeb_graph/curves/harmonic_pants_decomposition.h>
#include <CGAL/Reeb_graph/fields/field_constraints.h>
#include <CGAL/Reeb_graph/fields/geodesic_field.h>
#include <CGAL/Reeb_graph/fields/gradient_and_divergence.h>
#include <CGAL/Reeb_graph/fields/harmonic_field.h>
#include <CGAL/Reeb_graph/fields/height_field.h>
#include <CGAL/Reeb_graph/fields/make_borders_level.h>
#include <CGAL/Reeb_graph/fields/poisson_field.h>
#include <CGAL/Reeb_graph/scalar_maps.h>
#include <CGAL/iterator.h>

#include <array>
#include <cstddef>
#include <iterator>
#include <string>
#include <utility>
#include <vector>

// Fields: what is read of the mesh, and equations on it.
namespace growth {
namespace {
using namespace CGAL::Reeb_graph;
typedef Mesh::Vertex_index Vertex;
typedef reeb_graph_program::Point Point;
typedef CGAL::Kernel_traits<Point>::Kernel::Vector_3 Vector;
typedef Surface_with_field Subject;
typedef std::vector<std::pair<Vertex, double>> Constraints;

// Calls `compute` with a map for the result.
template <class Compute>
Function<Subject> field(const std::string& name, const Compute& compute, double largest_exponent = near_linear)
{
  return {name,
          [compute](const Subject& s) {
            std::vector<double> result(s.mesh.number_of_vertices());
            compute(s, make_scalar_map(s.mesh, result));
            return std::size_t(0);
          },
          largest_exponent};
}

// Where a matrix is factorized, as on small meshes and those that multigrid fails on, it takes n^1.5.
constexpr double factorized = 1.85;

std::vector<Function<Subject>> functions()
{
  return {
    field("compute_height_field",
          [](const Subject& s, auto map) { compute_height_field(s.mesh, map, Vector(1, 2, 3)); }),
    {"find_far_apart_vertices",
     [](const Subject& s) {
       std::vector<std::pair<Vertex, Vertex>> pairs;
       find_far_apart_vertices(s.mesh, std::back_inserter(pairs));
       return std::size_t(0);
     }},
    {"compute_gradient",
     [](const Subject& s) {
       std::vector<Vector> gradients(s.mesh.number_of_faces());
       compute_gradient(s.mesh, s.field, CGAL::make_property_map(gradients));
       return std::size_t(0);
     }},
    field("compute_divergence",
          [](const Subject& s, auto map) {
            const std::vector<Vector> vectors(s.mesh.number_of_faces(), Vector(1, 2, 3));
            compute_divergence(s.mesh, CGAL::make_property_map(vectors), map);
          }),
    {"make_borders_level",
     [](const Subject& s) {
       std::vector<double> result(s.mesh.number_of_vertices());
       const auto map = make_scalar_map(s.mesh, result);
       for(const Vertex v : s.mesh.vertices())
         put(map, v, s.field[v]);
       make_borders_level(s.mesh, map);
       return std::size_t(0);
     }},
    field("compute_mean_curvature", [](const Subject& s, auto map) { compute_mean_curvature(s.mesh, map); }),
    field(
      "compute_harmonic_field",
      [](const Subject& s, auto map) { compute_harmonic_field_between_far_apart_vertices(s.mesh, map); }, factorized),
    field(
      "... between borders", [](const Subject& s, auto map) { compute_harmonic_field_between_borders(s.mesh, map); },
      factorized),
    field(
      "compute_poisson_field",
      [](const Subject& s, auto map) {
        compute_curvature_poisson_field(s.mesh, map, Constraints{{Vertex(0), 0.}});
      },
      factorized),
    field(
      "compute_unit_gradient_field",
      [](const Subject& s, auto map) { compute_unit_gradient_field(s.mesh, s.field, map); }, factorized),
    field("compute_geodesic_field",
          [](const Subject& s, auto map) { compute_geodesic_field(s.mesh, map, std::array<Vertex, 1>{Vertex(0)}); }),
  };
}
} // namespace

void measure_fields(Table& table)
{
  const std::size_t n = 8000, number_of_inputs = all_inputs(100).size();
  for(std::size_t i = 0; i < number_of_inputs; ++i)
  {
    const std::string name = all_inputs(100)[i].name;
    if(name.find("noise") != std::string::npos) // the surface is another one's
      continue;
    const auto subjects = at_three_sizes<Subject>(n, [i](std::size_t size) { return all_inputs(size)[i]; });
    for(const Function<Subject>& function : functions())
      table.measure(name, subjects, function);
    if(name.find("k^2") != std::string::npos)
      table.measure(name, subjects,
                    Function<Subject>{"harmonic_pants_decomposition",
                                      [](const Subject& s) {
                                        Mesh mesh = s.mesh;
                                        harmonic_pants_decomposition(mesh, CGAL::Emptyset_iterator());
                                        return mesh.number_of_faces() - s.mesh.number_of_faces();
                                      },
                                      factorized});
  }
}
} // namespace growth
