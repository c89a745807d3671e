// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

// Times of harmonic and Poisson fields, beside a plain factorization and solution of the Laplace equation with
// cotangent weights and the same two poles by Eigen in the same run. Then how the times of harmonic fields, and the
// numbers of steps of their iteration, grow with the mesh.
//
// Usage: benchmark_scalar_fields [NUMBER OF VERTICES] [REPETITIONS] [LARGEST NUMBER OF VERTICES]

#include "base/costs.h"
#include "generated_surfaces.h"
#include "generated_surfaces/build_mesh.h"
#include "measurements.h"

#include <CGAL/Eigen_solver_traits.h>
#include <CGAL/Reeb_graph/fields/geodesic_field.h>
#include <CGAL/Reeb_graph/fields/harmonic_field.h>
#include <CGAL/Reeb_graph/fields/poisson_field.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Weights/utils.h>

#include <Eigen/SparseCholesky>

#include <array>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <iterator>
#include <string>
#include <utility>
#include <vector>

typedef CGAL::Simple_cartesian<double> Kernel;
typedef CGAL::Surface_mesh<Kernel::Point_3> Mesh;
typedef Mesh::Vertex_index Vertex;
typedef Mesh::Property_map<Vertex, double> Scalar_map;
typedef std::vector<std::pair<Vertex, double>> Constraints;
typedef CGAL::Eigen_solver_traits<Eigen::SimplicialLDLT<CGAL::Eigen_sparse_matrix<double>::EigenType>> Factorization;

namespace fields = CGAL::Reeb_graph;

namespace {
double median_of_seconds(std::size_t repetitions, const std::function<void()>& function)
{
  benchmark::Sample seconds;
  for(std::size_t i = 0; i != repetitions; ++i)
    seconds.add(benchmark::milliseconds(function) / 1000);
  return *seconds.median();
}

// The sparse matrix of the triangles, SimplicialLDLT, one solution. The rows of the poles are those of the
// identity.
void solve_plainly(const Mesh& mesh, const Constraints& poles, Scalar_map scalar_map)
{
  typedef Eigen::Triplet<double> Triplet;
  const auto is_pole = [&](Vertex v) { return v == poles[0].first || v == poles[1].first; };
  Eigen::VectorXd right_side = Eigen::VectorXd::Zero(mesh.number_of_vertices());
  std::vector<Triplet> triplets;
  triplets.reserve(12 * mesh.number_of_faces());
  for(const auto& pole : poles)
  {
    triplets.emplace_back(pole.first, pole.first, 1);
    right_side[pole.first] = pole.second;
  }
  for(const Mesh::Halfedge_index h : mesh.halfedges())
  {
    const Vertex u = mesh.source(h), v = mesh.target(h), w = mesh.target(mesh.next(h));
    const double weight = CGAL::Weights::cotangent(mesh.point(u), mesh.point(w), mesh.point(v)) / 2;
    for(const auto& [from, to] : {std::make_pair(u, v), std::make_pair(v, u)})
    {
      if(is_pole(from))
        continue;
      triplets.emplace_back(from, from, weight);
      if(!is_pole(to))
        triplets.emplace_back(from, to, -weight);
      else
        right_side[from] += weight * right_side[to];
    }
  }
  Eigen::SparseMatrix<double> matrix(mesh.number_of_vertices(), mesh.number_of_vertices());
  matrix.setFromTriplets(triplets.begin(), triplets.end());
  const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> solver(matrix);
  const Eigen::VectorXd solution = solver.solve(right_side);
  for(const Vertex v : mesh.vertices())
    scalar_map[v] = solution[v];
}

Constraints far_apart_poles(const Mesh& mesh)
{
  std::vector<std::pair<Vertex, Vertex>> pairs;
  CGAL::Reeb_graph::find_far_apart_vertices(mesh, std::back_inserter(pairs));
  return {{pairs[0].first, 0.}, {pairs[0].second, 1.}};
}

void measure(const std::string& name, const generated_surfaces::Triangle_soup& soup, std::size_t repetitions)
{
  Mesh mesh = generated_surfaces::make_mesh<Mesh>(soup);
  const Scalar_map field = mesh.add_property_map<Vertex, double>("v:field").first;
  const Scalar_map other_field = mesh.add_property_map<Vertex, double>("v:other").first;
  const Constraints poles = far_apart_poles(mesh), source = {poles[0]};

  const double plain = median_of_seconds(repetitions, [&] { solve_plainly(mesh, poles, other_field); });
  const auto print = [&](const std::string& field_name, const std::function<void()>& compute) {
    const double time = median_of_seconds(repetitions, compute);
    std::printf("%-10s %-22s %9zu %8.2f %8.2f %8.2f %8zu\n", name.c_str(), field_name.c_str(),
                std::size_t(mesh.number_of_vertices()), plain, time, time / plain,
                reeb_graph_program::peak_memory_bytes() / 1000000);
    std::fflush(stdout);
  };
  const auto harmonic = [&](fields::Laplacian_weights weights) {
    return [&, weights] {
      fields::compute_harmonic_field(mesh, field, poles, CGAL::parameters::laplacian_weights(weights));
    };
  };
  print("mean value, factorized", [&] {
    fields::compute_harmonic_field(mesh, field, poles, CGAL::parameters::sparse_linear_solver(Factorization()));
  });
  print("harmonic, cotangent", harmonic(fields::Laplacian_weights::COTANGENT));
  print("harmonic, uniform", harmonic(fields::Laplacian_weights::UNIFORM));
  print("harmonic, mean value", harmonic(fields::Laplacian_weights::MEAN_VALUE));
  print("unit gradient", [&] { fields::compute_unit_gradient_field(mesh, field, other_field); });
  print("poisson", [&] { fields::compute_curvature_poisson_field(mesh, other_field, source); });
  const std::array<Vertex, 1> sources = {poles[0].first};
  print("geodesic", [&] { fields::compute_geodesic_field(mesh, other_field, sources); });
}

// One line for each field: three meshes, each with four or five times as many vertices as the one before.
void measure_growth(std::size_t largest_number_of_vertices, std::size_t repetitions)
{
  const std::array<std::string, 4> names = {"harmonic, cotangent", "harmonic, uniform", "harmonic, mean value",
                                            "poisson"};
  std::array<std::vector<std::pair<double, double>>, names.size()> times;
  std::array<std::vector<std::size_t>, names.size()> steps;
  for(const std::size_t divisor : {20, 5, 1})
  {
    Mesh mesh =
      generated_surfaces::make_mesh<Mesh>(generated_surfaces::closed_surface(3, largest_number_of_vertices / divisor));
    const Scalar_map field = mesh.add_property_map<Vertex, double>("v:field").first;
    const Constraints poles = far_apart_poles(mesh), source = {poles[0]};
    const auto harmonic = [&](fields::Laplacian_weights weights) {
      return fields::compute_harmonic_field(mesh, field, poles, CGAL::parameters::laplacian_weights(weights));
    };
    const std::array<std::function<fields::Field_report()>, names.size()> computations = {
      [&] { return harmonic(fields::Laplacian_weights::COTANGENT); },
      [&] { return harmonic(fields::Laplacian_weights::UNIFORM); },
      [&] { return harmonic(fields::Laplacian_weights::MEAN_VALUE); },
      [&] { return fields::compute_curvature_poisson_field(mesh, field, source); }};
    for(std::size_t i = 0; i != names.size(); ++i)
    {
      fields::Field_report report;
      const double time = median_of_seconds(repetitions, [&] { report = computations[i](); });
      times[i].emplace_back(mesh.number_of_vertices(), time);
      steps[i].push_back(report.number_of_iterations);
    }
  }
  std::printf("\ngrowth on genus 3; steps: of the iteration, 0 if factorized; exponent: of the number of vertices\n");
  std::printf("%-22s", "field");
  for(std::size_t i = 0; i != times[0].size(); ++i)
    std::printf(" %9s %8s %6s", "vertices", "s", "steps");
  std::printf(" %8s\n", "exponent");
  for(std::size_t i = 0; i != names.size(); ++i)
  {
    std::printf("%-22s", names[i].c_str());
    for(std::size_t j = 0; j != times[i].size(); ++j)
      std::printf(" %9.0f %8.3f %6zu", times[i][j].first, times[i][j].second, steps[i][j]);
    std::printf(" %8.2f\n", benchmark::growth_exponent(times[i]));
  }
}
} // namespace

int main(int argc, char* argv[])
{
  const std::size_t number_of_vertices = argc > 1 ? std::strtoul(argv[1], nullptr, 10) : 200000;
  const std::size_t repetitions = argc > 2 ? std::strtoul(argv[2], nullptr, 10) : 3;
  const std::size_t largest_number_of_vertices = argc > 3 ? std::strtoul(argv[3], nullptr, 10) : 1000000;
  if(number_of_vertices == 0 || repetitions == 0 || largest_number_of_vertices < 20)
  {
    std::fprintf(stderr,
                 "usage: benchmark_scalar_fields [NUMBER OF VERTICES] [REPETITIONS] [LARGEST NUMBER OF VERTICES]\n");
    return EXIT_FAILURE;
  }
  benchmark::Stopwatch stopwatch;
  std::printf("times in s, medians of %zu; one thread; plain: SimplicialLDLT of the cotangent Laplacian\n",
              repetitions);
  std::printf("%-10s %-22s %9s %8s %8s %8s %8s\n", "surface", "field", "vertices", "plain", "field", "field", "memory");
  std::printf("%-10s %-22s %9s %8s %8s %8s %8s\n", "", "", "", "s", "s", "/ plain", "MB, peak");
  measure("genus 0", generated_surfaces::closed_surface(0, number_of_vertices), repetitions);
  measure("genus 3", generated_surfaces::closed_surface(3, number_of_vertices), repetitions);
  std::printf("%.0f seconds\n", stopwatch.milliseconds() / 1000);
  stopwatch = benchmark::Stopwatch();
  measure_growth(largest_number_of_vertices, repetitions);
  std::printf("%.0f seconds\n", stopwatch.milliseconds() / 1000);
  return EXIT_SUCCESS;
}
