// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_SRC_MESH_GRAPH_H
#define CGAL_REEB_GRAPH_SRC_MESH_GRAPH_H

#include "base/complex.h"
#include "base/options.h"
#include "base/report.h"
#include "base/surface.h"
#include "computation/embedding.h"

#include <array>
#include <cstddef>
#include <memory>
#include <optional>
#include <ostream>
#include <vector>

namespace reeb_graph_program {
// Which contours of which graph.
struct Contour_choice
{
  Graph_options graph;
  Simplification_options simplification;
  std::optional<std::size_t>
    arc; // its contour at the place `t` between 0 and 1; if not given, all contours at the level
  double t = 0;
  double level = 0;
};

// Contours: curves, or triangles in tetrahedra.
struct Contours
{
  std::size_t number = 0;
  std::vector<Polyline> polylines;
  std::vector<Point> points;
  std::vector<std::array<std::size_t, 3>> triangles;
};

// The Reeb graph of what a mesh file has, simplified if that is asked for, and what is asked of the mesh by way of it:
// one interface for surfaces, and for complexes of triangles or of tetrahedra.
class Mesh_graph
{
public:
  virtual ~Mesh_graph() = default;

  // The graph before and after it has been simplified. Nodes know their vertices by those of the surface of the mesh;
  // on complexes, arcs have no chains.
  virtual const Graph& given() const = 0;
  virtual const Graph& result() const = 0;

  // What --simplify has been.
  virtual double threshold() const = 0;

  // What follows is that of the result. Vertices are located when one of the next two functions is called, if they have
  // not been before.
  virtual void locate_vertices() = 0;

  // The place of each vertex, numbered as in the graph files.
  virtual const std::vector<std::size_t>& places() = 0;

  // The arcs, by their numbers.
  virtual std::vector<Arc_row> measure_arcs() = 0;

  // Without rows of arcs, there are no measures.
  virtual Graph_in_space embed(CGAL::Reeb_graph::Embedding_manner manner, const std::vector<Arc_row>* arcs) = 0;

  // Writes the graph in space with its chains.
  virtual void write_json(std::ostream& stream, const Graph_in_space& graph_in_space) = 0;

  // Throws std::runtime_error if there is no such arc. There is no contour at a level at which no arc is alive.
  virtual Contours find_contours(const Contour_choice& choice) = 0;
};

// Computes the graph, and adds what it took to the report. The mesh has to outlive the result.
std::unique_ptr<Mesh_graph> compute_mesh_graph(const Mesh& mesh,
                                               Scalar_map scalar_map,
                                               const Graph_options& options,
                                               const Simplification_options& simplification,
                                               double threshold,
                                               Report& report);

// The part of it for complexes.
std::unique_ptr<Mesh_graph> compute_complex_graph(const Mesh& mesh,
                                                  Scalar_map scalar_map,
                                                  const Graph_options& options,
                                                  const Simplification_options& simplification,
                                                  double threshold,
                                                  Report& report);

} // namespace reeb_graph_program

#endif // CGAL_REEB_GRAPH_SRC_MESH_GRAPH_H
