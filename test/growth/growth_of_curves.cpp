// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#include "Table.h"
#include "surfaces.h"

#include <CGAL/Reeb_graph/Augmentation.h>
#include <CGAL/Reeb_graph/curves/branch_curves.h>
#include <CGAL/Reeb_graph/curves/cut_along_contours.h>
#include <CGAL/Reeb_graph/curves/cut_along_levels.h>
#include <CGAL/Reeb_graph/curves/cut_to_disks.h>
#include <CGAL/Reeb_graph/curves/cutting_system.h>
#include <CGAL/Reeb_graph/curves/pants_decomposition.h>
#include <CGAL/Reeb_graph/curves/segmentation.h>
#include <CGAL/Reeb_graph/curves/unfold_multi_saddles.h>
#include <CGAL/compute_reeb_graph.h>
#include <CGAL/iterator.h>

#include <algorithm>
#include <cstddef>
#include <string>
#include <vector>

// Curves and pieces. The mesh is refined along the curves: what that adds is the output.
namespace growth {
namespace {
namespace parameters = CGAL::parameters;
using namespace CGAL::Reeb_graph;
typedef CGAL::Reeb_graph_traits<Mesh, Scalar_map>::Graph Graph;
typedef Surface_with_field Subject;

// Calls `cut` with a copy of the mesh and its field.
template <class Cut>
Function<Subject> curves(const std::string& name, const Cut& cut)
{
  return {name, [cut](const Subject& s) {
            Mesh mesh = s.mesh;
            const Scalar_map field = mesh.add_property_map<Mesh::Vertex_index, double>("v:field").first; // it is there
            cut(mesh, field);
            return mesh.number_of_faces() - s.mesh.number_of_faces();
          }};
}

std::vector<Function<Subject>> functions_on_any_surface()
{
  const auto borders = [] { return parameters::borders(Borders::MAKE_LEVEL); };
  return {
    curves("cutting_system",
           [=](Mesh& mesh, Scalar_map field) { cutting_system(mesh, field, CGAL::Emptyset_iterator(), borders()); }),
    curves("branch_curves",
           [=](Mesh& mesh, Scalar_map field) { branch_curves(mesh, field, CGAL::Emptyset_iterator(), borders()); }),
    curves("segment_by_branches",
           [=](Mesh& mesh, Scalar_map field) {
             segment_by_branches(mesh, field, mesh.add_property_map<Mesh::Face_index, int>("f:patch").first, borders());
           }),
    curves("segment_by_arcs",
           [](Mesh& mesh, Scalar_map field) {
             Graph graph;
             CGAL::compute_reeb_graph(mesh, field, graph);
             segment_by_arcs(mesh, field, graph, mesh.add_property_map<Mesh::Face_index, int>("f:patch").first);
           }),
    curves("cut_along_contours",
           [](Mesh& mesh, Scalar_map field) {
             Graph graph;
             CGAL::compute_reeb_graph(mesh, field, graph);
             const Augmentation augmentation(mesh, field, graph);
             const auto contours = augmentation.contours_at_value(graph[num_vertices(graph) / 2].value);
             cut_along_contours(mesh, field, contours, CGAL::Emptyset_iterator());
           }),
    curves("cut_along_levels",
           [](Mesh& mesh, Scalar_map field) {
             std::vector<double> levels(field.begin(), field.end());
             std::sort(levels.begin(), levels.end());
             levels = {levels.front(), levels[levels.size() / 3], levels[levels.size() / 2], levels.back()};
             cut_along_levels(mesh, field, levels, CGAL::Emptyset_iterator());
           }),
    curves("cut_to_disks", [](Mesh& mesh, Scalar_map) { cut_to_disks(mesh, CGAL::Emptyset_iterator()); }),
    curves("unfold_multi_saddles",
           [](Mesh& mesh, Scalar_map field) {
             unfold_multi_saddles(mesh, field, mesh.add_property_map<Mesh::Vertex_index, std::size_t>("v:rank").first);
           }),
  };
}

// For surfaces of negative Euler characteristic. On noise, the curves are much longer than the mesh is large.
std::vector<Function<Subject>> functions_of_pants()
{
  const auto borders = [] { return parameters::borders(Borders::MAKE_LEVEL); };
  return {
    curves(
      "pants_decomposition",
      [=](Mesh& mesh, Scalar_map field) { pants_decomposition(mesh, field, CGAL::Emptyset_iterator(), borders()); }),
    curves("segment_by_pants",
           [=](Mesh& mesh, Scalar_map field) {
             segment_by_pants(mesh, field, mesh.add_property_map<Mesh::Face_index, int>("f:patch").first, borders());
           }),
  };
}
} // namespace

void measure_curves(Table& table)
{
  const std::size_t n = 6000, number_of_inputs = all_inputs(100).size();
  for(std::size_t i = 0; i < number_of_inputs; ++i)
  {
    const auto subjects = at_three_sizes<Subject>(n, [i](std::size_t size) { return all_inputs(size)[i]; });
    const std::string name = all_inputs(100)[i].name;
    for(const Function<Subject>& function : functions_on_any_surface())
      table.measure(name, subjects, function);
    if(name.find("k^2") != std::string::npos && name.find("noise") == std::string::npos)
      for(const Function<Subject>& function : functions_of_pants())
        table.measure(name, subjects, function);
  }
}
} // namespace growth
