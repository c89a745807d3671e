// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_SRC_MESH_GRAPH_H
#define CGAL_REEB_GRAPH_SRC_MESH_GRAPH_H

#include "base/options.h"
#include "base/report.h"
#include "base/surface.h"
#include "computation/simplification.h"

#include <CGAL/Reeb_graph/embed.h>
#include <CGAL/Reeb_graph/options.h>
#include <CGAL/boost/graph/iterator.h>

#include <array>
#include <cstddef>
#include <memory>
#include <optional>
#include <ostream>
#include <vector>

namespace reeb_graph_program {
typedef CGAL::Reeb_graph::Embedding<Point> Embedding;

// Which contours of which graph: those at the place `t`, those at the levels, or the one closest to a point.
struct Contour_choice
{
  Graph_options graph;
  Simplification_options simplification;
  std::optional<double> t;                     // between 0 and 1 on each arc
  std::vector<double> parametrization;         // with t: a number for each vertex, by which t is measured along arcs;
                                               // by those of the field if there are none
  std::optional<std::size_t> arc;              // with t: the only arc
  std::vector<double> levels;                  // of which some may have no contour
  std::optional<std::size_t> number_of_levels; // that cut the range of the field into equal steps
  std::optional<Point> point;
  bool may_be_none = false; // else it is an error if there is no contour
};

// What files and Python have of a contour of any kind. Each point is on the edge of the same number, and that leads from
// its lower to its higher vertex.
struct Contour
{
  static constexpr std::size_t no_arc = static_cast<std::size_t>(-1);

  std::size_t arc = 0; // by its number; no_arc for a curve in a plateau
  double value = 0;    // of the level
  bool is_closed = false;
  std::vector<std::array<std::size_t, 2>> edges;
  std::vector<Point> points;
  std::vector<std::vector<std::size_t>> polylines;   // of points; if one is closed, its first point is its last one too
  std::vector<std::array<std::size_t, 3>> triangles; // of points: in tetrahedra, instead of polylines
};

// What a node stands for.
struct Critical_set
{
  std::vector<Contour> lower_contours, upper_contours; // one for each arc
  std::vector<std::size_t> star;                       // the faces or tetrahedra at the vertex
  std::vector<std::size_t> border_loop;                // the vertices of the border that is in the level of the node
};

// The Reeb graph of what a mesh file has, simplified if that is asked for, and what is asked of the mesh by way of it:
// one interface for surfaces, and for complexes of triangles or of tetrahedra.
class Mesh_graph
{
public:
  virtual ~Mesh_graph() = default;

  virtual const Mesh& mesh() const = 0;
  virtual Scalar_map scalar_map() const = 0;

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

// The same of the whole graph, with the places of the vertices.
std::unique_ptr<Mesh_graph> compute_mesh_graph(const Mesh& mesh, Scalar_map scalar_map, Graph_options options);

// N levels between the least and the greatest value, which they cut into N + 1 equal steps.
std::vector<double> equal_steps(std::size_t number_of_levels, Scalar_map scalar_map);

// The graph with values to which `base` is added, in `copy` if need be.
template <class AnyGraph>
const AnyGraph& with_base(const AnyGraph& graph, double base, std::optional<AnyGraph>& copy)
{
  if(base == 0)
    return graph;
  copy = graph;
  for(const auto node : CGAL::make_range(vertices(*copy)))
    (*copy)[node].value += base;
  return *copy;
}

struct Simplified_field
{
  double largest_change;    // of a value
  bool are_ties_contracted; // though not asked for, as there is no such field otherwise
};

// Computes a field that has the simplified graph with the ties of these options or, if that fails, with contracted ones.
// The graph is that of the field with these options. `simplified_map` can be `scalar_map`. Throws the exceptions of the
// library.
Simplified_field compute_simplified_field(const Mesh& mesh,
                                          Scalar_map scalar_map,
                                          Mesh_graph& graph,
                                          const Graph_options& graph_options,
                                          const Simplification_options& simplification,
                                          Scalar_map simplified_map);

} // namespace reeb_graph_program

#endif // CGAL_REEB_GRAPH_SRC_MESH_GRAPH_H
