// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_PYTHON_GRAPH_OF_ARRAYS_H
#define CGAL_REEB_GRAPH_PYTHON_GRAPH_OF_ARRAYS_H

#include "Input.h"

#include "base/Field_label.h"
#include "base/report.h"
#include "computation/augmentation.h"
#include "computation/embedding.h"
#include "computation/simplification.h"

#include <CGAL/Reeb_graph/Soup_augmentation.h>
#include <CGAL/Reeb_graph/Tetrahedra_augmentation.h>

#include <array>
#include <cstddef>
#include <filesystem>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace reeb_graph_python {
typedef Simplified_graph_of<Complex_graph> Simplified_complex_graph;

// A contour by numbers: point number i is on edge number i, from its lower to its higher vertex.
struct Contour_of_arrays
{
  std::size_t arc = 0;
  double value = 0;
  bool is_closed = false;
  std::vector<std::array<std::size_t, 2>> edges;
  std::vector<Point> points;
  std::vector<std::vector<std::size_t>> polylines; // of points by their numbers
  std::vector<std::array<std::size_t, 3>> triangles;
};

struct Critical_set_of_arrays
{
  std::vector<Contour_of_arrays> lower_contours, upper_contours;
  std::vector<std::size_t> star;        // triangles, or tetrahedra
  std::vector<std::size_t> border_loop; // vertices
};

struct Arc_measures
{
  std::vector<double> lengths, areas, persistences;
  std::vector<std::size_t> numbers_of_vertices;
};

// How a file is written.
struct File_options
{
  Field_label label;
  std::string title;
  std::optional<CGAL::Reeb_graph::Embedding_manner> manner;
};

// The Reeb graph of a mesh that was given as arrays, or what simplify() has made of it. All functions can be called from
// several threads, one waits for the other. Arcs and nodes have the numbers that they have in the files of the program.
class Graph_of_arrays
{
public:
  // Computes the graph.
  Graph_of_arrays(std::shared_ptr<Input> input, const Graph_options& options);

  // Simplifies the graph that has been computed, also if `given` has been simplified.
  Graph_of_arrays(const Graph_of_arrays& given, const Simplification_options& options);

  Graph_of_arrays& operator=(const Graph_of_arrays&) = delete;

  const Input& input() const { return *input_; }
  bool is_surface() const { return !input_->mesh.complex; }
  const Graph_options& options() const { return options_; }

  // The graph; its values are ranks if the field is.
  const Graph& graph() const { return is_surface() ? surface_graph_->result() : *graph_on_vertices_; }

  // For each arc, the vertices of its chain.
  std::vector<std::vector<std::size_t>> chains() const;

  // The place of each vertex: nodes are numbered from 0, arcs behind the last node.
  std::vector<std::size_t> places() const;

  // The contour at the place `t` of an arc, or at the level of a rank or value, and the value that its points have.
  Contour_of_arrays contour_at_parameter(std::size_t arc, double t) const;
  Contour_of_arrays contour_at_level(std::size_t arc, double level, std::optional<double> value) const;
  std::vector<Contour_of_arrays> contours_at_level(double level, std::optional<double> value) const;
  Critical_set_of_arrays critical_set(std::size_t node) const;

  std::vector<Persistence_pair> pairs() const { return find_persistence_pairs(graph()); }
  std::vector<std::vector<std::size_t>> loops() const;
  std::vector<std::size_t> components() const;
  Arc_measures measures() const;
  Graph_in_space embed(std::optional<CGAL::Reeb_graph::Embedding_manner> manner) const;

  // A field that has the graph, and whether ties were contracted for it, though not asked for.
  std::pair<std::vector<double>, bool> simplified_scalars() const;

  // Writes the graph, the page, the pairs, or the coloured mesh, by the ending of the name.
  void write(const std::filesystem::path& path, const File_options& options) const;

  // The report of the program, as JSON.
  std::string report() const;

private:
  typedef CGAL::Reeb_graph::Soup_augmentation<double> Soup_augmentation;
  typedef CGAL::Reeb_graph::Tetrahedra_augmentation<double> Tetrahedra_augmentation;

  void simplify();
  Complex_graph compute_complex(Report& report) const;
  Graph on_vertices(const Complex_graph& graph) const;
  std::vector<std::size_t> places_in_complex() const;
  CGAL::Reeb_graph::Embedding<Point> embed_on_surface(CGAL::Reeb_graph::Embedding_manner manner) const;
  std::shared_ptr<const Graph> with_values(const Graph& graph) const;
  std::shared_ptr<const Graph> to_write(const Graph& graph) const; // with the base as well
  Graph_in_space embed_locked(CGAL::Reeb_graph::Embedding_manner manner, const std::vector<Arc_row>* rows) const;
  void write_page_or_mesh(const std::filesystem::path& path, const File_options& options) const;
  void write_in_space(const std::filesystem::path& path, const File_options& options) const;

  // These make on demand what they return.
  const Augmentation& augmentation() const;
  const Vertex_locations& locations() const;
  std::vector<Arc_row> measure_rows() const;
  template <class Function>
  auto with_augmentation(const Function& function) const;
  template <class AnyAugmentation>
  const AnyAugmentation& make(std::unique_ptr<AnyAugmentation>& augmentation) const;

  std::shared_ptr<Input> input_;
  Graph_options options_;
  std::shared_ptr<const Report> report_;
  std::shared_ptr<const Graph> given_;                 // of a surface
  std::shared_ptr<const Complex_graph> given_complex_; // else
  Simplification_options simplification_;
  double threshold_ = 0;

  // What has the values where the given graph has ranks, if it has been simplified.
  std::shared_ptr<const Graph> given_with_values_;
  std::shared_ptr<const Complex_graph> given_complex_with_values_;
  std::optional<Simplified_graph> surface_graph_;
  std::optional<Simplified_complex_graph> complex_graph_;
  std::optional<Graph> graph_on_vertices_; // of a complex

  mutable std::mutex mutex_; // of what follows
  mutable std::optional<Augmentation> augmentation_;
  mutable std::optional<Vertex_locations> locations_;
  mutable std::unique_ptr<Soup_augmentation> soup_augmentation_;
  mutable std::unique_ptr<Tetrahedra_augmentation> tetrahedra_augmentation_;
};

} // namespace reeb_graph_python

#endif // CGAL_REEB_GRAPH_PYTHON_GRAPH_OF_ARRAYS_H
