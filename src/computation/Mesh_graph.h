// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_SRC_MESH_GRAPH_H
#define CGAL_REEB_GRAPH_SRC_MESH_GRAPH_H

#include "base/Arc_table.h"
#include "base/complex.h"
#include "base/options.h"
#include "base/report.h"
#include "base/surface.h"
#include "computation/contours.h"
#include "computation/simplification.h"

#include <CGAL/Reeb_graph/Embedding.h>
#include <CGAL/Reeb_graph/options.h>

#include <cstddef>
#include <memory>
#include <ostream>
#include <vector>

namespace reeb_graph_program {
typedef CGAL::Reeb_graph::Embedding<Point> Embedding;

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

  // The given graph with other options of simplification. Both share it, and both need the mesh.
  virtual std::unique_ptr<Mesh_graph> simplify(const Simplification_options& simplification,
                                               double threshold) const = 0;

  // What follows is that of the result. The vertices of the chain of each arc, ascending.
  virtual std::vector<std::vector<std::size_t>> chains() const = 0;

  // The place of each vertex, by its index, numbered as in the graph files: in the result, and in the given graph. If the
  // options have not asked for places, the first call computes the graph again.
  virtual const std::vector<std::size_t>& places() = 0;
  virtual const std::vector<std::size_t>& given_places() = 0;

  // What is measured of arcs, by the first call.
  virtual const Arc_table& arc_table() = 0;

  virtual Embedding embed(CGAL::Reeb_graph::Embedding_manner manner) = 0;

  // Writes the graph in space with its chains, and with the values that with_base() gives it.
  virtual void write_json(std::ostream& stream,
                          const Embedding& embedding,
                          const std::vector<CGAL::Reeb_graph::Attribute>& arc_attributes,
                          double base) = 0;

  // The way to the surface. Throws std::logic_error on complexes.
  virtual const Augmentation& surface_augmentation() = 0;

  // Throws std::runtime_error if there is no such arc, no contour, or none at one of the levels: no arc is alive there.
  virtual std::vector<Contour> find_contours(const Contour_choice& choice) = 0;
  virtual Critical_set critical_set(std::size_t node) = 0;
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
