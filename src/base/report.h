// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_SRC_REPORT_H
#define CGAL_REEB_GRAPH_SRC_REPORT_H

#include "base/costs.h"
#include "base/input_findings.h"
#include "base/surface.h"

#include <CGAL/Reeb_graph/curves/Curve.h>
#include <CGAL/Reeb_graph/fields/exceptions.h>
#include <CGAL/Reeb_graph/fields/make_borders_level.h>
#include <CGAL/Reeb_graph/options.h>
#include <CGAL/Reeb_graph/simplification/simplify.h>

#include <boost/core/noncopyable.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace reeb_graph_program {
// What is known of the arcs of a graph, by their numbers. Files, reports, the page and Python show columns by what is
// said here: none of them knows one by its name.

// How the number of an arc of a simplified graph comes from those of the given graph.
enum class Arc_joining
{
  ALONG_CHAIN,   // the sum over the arcs that its chain passes
  WITH_ABSORBED, // the sum over all arcs that it has taken up
  WITH_NODES,    // the sum over all arcs and nodes that it has taken up
  MEAN_BY_AREA,  // the mean over all arcs that it has taken up, weighted by their areas or volumes
  RECOMPUTED     // by a function of the simplified graph
};

enum class Arc_unit
{
  VALUE,      // of the field
  DIFFERENCE, // of two values
  PLAIN,      // that of the points, or none
  COUNT
};

struct Arc_column
{
  CGAL::Reeb_graph::Attribute attribute;
  Arc_joining joining;
  Arc_unit unit;
  bool is_in_text = true;                                              // of the report; all others show all columns
  std::vector<std::int64_t> of_nodes = {};                             // for WITH_NODES: what belongs to each node
  std::vector<double> (*recompute)(const Graph& simplified) = nullptr; // for RECOMPUTED
};

struct Arc_ends
{
  std::size_t lower_node = 0, upper_node = 0;
  double lower_value = 0, upper_value = 0;
};

struct Arc_table
{
  std::vector<Arc_ends> ends;
  std::vector<Arc_column> columns;

  // What files write, with `base` added to values.
  std::vector<CGAL::Reeb_graph::Attribute> attributes(double base = 0) const
  {
    std::vector<CGAL::Reeb_graph::Attribute> attributes;
    for(const Arc_column& column : columns)
    {
      attributes.push_back(column.attribute);
      if(column.unit == Arc_unit::VALUE)
        for(double& value : std::get<std::vector<double>>(attributes.back().numbers))
          value += base;
    }
    return attributes;
  }
};

// A complex that is no oriented manifold surface. Vertices are numbered from 0; edges come in the order of their two
// vertices. Where there are tetrahedra, neither edges of many faces nor fans are counted.
struct Complex_counts
{
  struct Edge_of_many_faces
  {
    std::size_t u = 0, v = 0, faces = 0;
  };
  struct Vertex_of_several_fans
  {
    std::size_t vertex = 0, fans = 0;
  };

  std::size_t vertices = 0;
  std::size_t edges = 0;
  std::size_t edges_without_triangles = 0;
  std::size_t triangles = 0;
  std::size_t tetrahedra = 0;
  std::size_t components = 0;
  long euler_characteristic() const
  {
    return static_cast<long>(vertices + triangles) - static_cast<long>(edges + tetrahedra);
  }

  std::size_t duplicate_faces = 0;     // that repeat an earlier one of the file
  std::size_t edges_of_many_faces = 0; // more than two
  std::size_t vertices_of_several_fans = 0;
  std::optional<std::pair<std::size_t, std::size_t>> first_edge_without_triangles;
  std::optional<std::size_t> first_duplicate_face;
  std::optional<Edge_of_many_faces> first_edge_of_many_faces;
  std::optional<Vertex_of_several_fans> first_vertex_of_several_fans;
  // That at which no orientation of its two triangles goes with those before it.
  std::optional<std::pair<std::size_t, std::size_t>> first_edge_without_orientation;
};

struct Graph_counts
{
  std::size_t nodes = 0;
  std::size_t arcs = 0;
  std::size_t loops = 0;
  std::size_t arcs_of_length_zero = 0;
  std::optional<long> hidden_handles; // of a connected surface without border: those that are no loop
};

struct Simplification_counts
{
  double threshold = 0; // infinite if only the number of leaves counts
  Graph_counts graph;
  std::optional<double> largest_change; // of the field, if that has been simplified
  bool are_ties_contracted = false;     // of that field, though not asked for
};

// Where a field has been given its values. A border is named by its first vertex.
struct Fixed_values
{
  struct Place
  {
    std::size_t vertex = 0;
    double value = 0;
  };

  std::string field; // its name: harmonic for one that is made of that
  std::vector<Place> vertices, borders;
};

// What the field took, and each step of the work.
struct Work_report
{
  std::optional<Input_findings> input;                 // of a mesh that has been read from a file
  std::optional<Repair_counts> repair;                 // of a copy of that, which is used in its place
  std::string repair_command;                          // which writes the copy
  std::optional<CGAL::Reeb_graph::Field_report> field; // of a field that depends on the geometry of faces
  std::optional<Fixed_values> fixed_values;            // of a field that solves equations, or of distances
  std::vector<std::string> notes;                      // on the input, and on what the user may not expect
  std::vector<std::pair<std::string, double>> seconds; // in the order in which they were spent

  // Adds to the seconds of a step, which is a new one if there is none of this name: the last one, or at a place.
  void add_seconds(const std::string& step, double spent, std::size_t place = static_cast<std::size_t>(-1))
  {
    for(auto& [name, sum] : seconds)
      if(name == step)
      {
        sum += spent;
        return;
      }
    seconds.emplace(seconds.begin() + static_cast<std::ptrdiff_t>(std::min(place, seconds.size())), step, spent);
  }
};

// As long as it lives, a step is done: its seconds go into the report, before those of steps within it.
class Timed_step : boost::noncopyable
{
public:
  Timed_step(Work_report& report, const std::string& step) : report_(report), step_(step), place_(report.seconds.size())
  {}
  ~Timed_step() { report_.add_seconds(step_, stopwatch_.seconds(), place_); }

private:
  Work_report& report_;
  std::string step_;
  std::size_t place_;
  Stopwatch stopwatch_;
};

// What a step gives.
template <class Work>
auto timed(Work_report& report, const std::string& step, const Work& work)
{
  const Timed_step timed(report, step);
  return work();
}

// Where a loop is. Its center is the mean of its points, by length.
struct Loop_place
{
  std::array<double, 3> center = {};
  std::array<std::array<double, 3>, 2> box = {}; // lower and upper corner
  std::vector<std::size_t> vertices = {};        // along the loop, if it passes edges
};

// A loop of the list of the command handles, or of the graph.
struct Loop_row
{
  std::string kind;                   // handle, tunnel, hole, or loop
  std::optional<std::size_t> partner; // its number
  double length = 0;
  std::optional<double> persistence; // of a pair
  std::optional<double> area;        // of the disc that fills it, where one does
  std::size_t component = 0;
  bool is_simple = true;
  bool is_certain = true; // its kind, as its component does not intersect itself
  Loop_place place = {};
};

// What a rank of MPI did.
struct Rank_report
{
  std::size_t vertices = 0;   // in its slab
  std::size_t triangles = 0;  // that meet its slab
  std::size_t copies = 0;     // those of them that a lower rank has as well
  std::size_t bytes_sent = 0; // to other ranks
  std::size_t peak_memory_bytes = 0;
  std::vector<std::pair<std::string, double>> cpu_seconds; // of each step, and of all in the end
};

// What all ranks of MPI did.
struct Ranks_report
{
  std::size_t slabs = 0;
  double slabs_per_triangle = 0; // that a triangle would meet if there were a slab for each rank, on a sample
  std::vector<Rank_report> ranks;
};

struct Report : Work_report
{
  std::optional<Ranks_report> ranks; // of a computation on several processes
  Mesh_counts surface;
  std::optional<Complex_counts> complex; // instead of the surface
  CGAL::Reeb_graph::Critical_vertex_counts critical_vertices;
  Graph_counts graph;
  std::optional<Simplification_counts> simplification;
  std::vector<CGAL::Reeb_graph::Simplification_threshold> thresholds; // that matter for the given graph
  std::optional<CGAL::Reeb_graph::Embedding_manner> embedding_manner; // of a graph in space
  const Arc_table* arc_table = nullptr;                               // of the simplified graph if there is one
  std::optional<Loop_row> longest_loop;                               // the same
};

// What the mesh was cut into.
struct Curves_report : Work_report
{
  std::optional<CGAL::Reeb_graph::Level_cut_report> levels; // of curves of levels
  std::string field_name;
  std::size_t curves = 0;
  std::size_t patches = 0;
  CGAL::Reeb_graph::Border_level_changes border_changes; // of the field
  bool are_ties_contracted = false;                      // of the simplified field
};

// A handle that was to be removed.
struct Removal_row
{
  std::string kind; // of the loop along which the mesh has been cut, or would have been
  double length = 0;
  std::size_t component = 0;
  bool is_removed = true;
  std::string reason; // why not
  Loop_place place;   // before any cut along the loop
};

// How the file was made another one.
struct Repair_report : Work_report
{
  Repair_counts counts;
  std::size_t lines_left_out = 0;       // of the file
  std::vector<Merged_field> fields;     // that have been written
  std::vector<std::string> lost_fields; // that are not kept
};

struct Handles_report : Work_report
{
  std::size_t self_intersections = 0; // pairs of faces
  bool are_self_intersections_ignored = false;
  std::string field;                                // its name
  std::vector<Loop_row> loops;                      // in the order of the file
  std::optional<std::vector<Removal_row>> removals; // if any were to be removed
};

} // namespace reeb_graph_program

#endif // CGAL_REEB_GRAPH_SRC_REPORT_H
