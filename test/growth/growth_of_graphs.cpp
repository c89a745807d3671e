// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#include "Table.h"
#include "random_graphs.h"
#include "random_meshes.h"
#include "surfaces.h"

#include <CGAL/Reeb_graph.h>
#include <CGAL/Reeb_graph/comparison/bottleneck_distance.h>
#include <CGAL/compute_reeb_graph.h>

#include <boost/property_map/function_property_map.hpp>

#include <array>
#include <cstddef>
#include <functional>
#include <iterator>
#include <memory>
#include <sstream>
#include <string>
#include <vector>

// Graphs, the ways back to the mesh, simplification, drawing and writing.
namespace growth {
namespace {
namespace parameters = CGAL::parameters;
using namespace CGAL::Reeb_graph;
typedef CGAL::Reeb_graph_traits<Mesh, Scalar_map>::Graph Graph;
typedef CGAL::Reeb_graph::Augmentation<Mesh, Scalar_map> Surface_augmentation;
typedef Surface_augmentation::Contour Surface_contour;

struct Graph_of_surface : Surface_with_field
{
  explicit Graph_of_surface(const Input& input) : Surface_with_field(input)
  {
    CGAL::compute_reeb_graph(mesh, field, graph);
    augmentation = std::make_unique<Surface_augmentation>(mesh, field, graph);
    places = std::make_unique<Surface_augmentation::Vertex_places>(augmentation->locate_vertices());
    embedding = CGAL::Reeb_graph::embed(*augmentation, parameters::embedding_manner(Embedding_manner::STRAIGHT));
    std::ostringstream text;
    write_graphml(text, graph, get(boost::vertex_index, mesh), make_halfedge_index_map(mesh));
    graphml = text.str();
    range = graph[num_vertices(graph) - 1].value - graph[0].value;
  }

  Graph graph;
  std::unique_ptr<const Surface_augmentation> augmentation;
  std::unique_ptr<const Surface_augmentation::Vertex_places> places;
  Embedding<Point> embedding;
  std::string graphml;
  double range;
};
typedef Graph_of_surface Subject;
typedef std::vector<Function<Subject>> Functions;

template <class NamedParameters>
std::size_t compute(const Subject& s, const NamedParameters& np)
{
  Graph graph;
  CGAL::compute_reeb_graph(s.mesh, s.field, graph, np);
  return 0;
}

std::size_t length(const std::vector<Surface_contour>& contours)
{
  std::size_t sum = contours.size();
  for(const Surface_contour& contour : contours)
    sum += contour.edges.size();
  return sum;
}

template <class Write>
Function<Subject> writer(const std::string& name, const Write& write)
{
  return {name, [write](const Subject& s) {
            std::ostringstream out;
            write(out, s);
            return out.str().size() / 100; // as many characters take about as long as a face
          }};
}

Functions functions_of_computation()
{
  return {
    {"compute_reeb_graph", [](const Subject& s) { return compute(s, parameters::default_values()); }},
    {"... ties contracted", [](const Subject& s) { return compute(s, parameters::ties(Ties::CONTRACT)); }},
    {"... 8 slabs", [](const Subject& s) { return compute(s, parameters::number_of_slabs(8)); }},
    {"... vertex_place_map",
     [](const Subject& s) {
       std::vector<std::size_t> places(s.mesh.number_of_vertices());
       return compute(s, parameters::vertex_place_map(CGAL::make_property_map(places)));
     }},
  };
}

Functions functions_of_augmentation()
{
  return {
    {"Augmentation",
     [](const Subject& s) {
       const Surface_augmentation augmentation(s.mesh, s.field, s.graph);
       return std::size_t(0);
     }},
    {"locate_vertices",
     [](const Subject& s) {
       s.augmentation->locate_vertices();
       return std::size_t(0);
     }},
    {"contours_at_value",
     [](const Subject& s) {
       return length(s.augmentation->contours_at_value(s.graph[num_vertices(s.graph) / 2].value));
     }},
    {"contour, of each arc",
     [](const Subject& s) {
       std::size_t sum = 0, number = 0;
       for(const auto arc : CGAL::make_range(edges(s.graph)))
         if(number++ % 8 == 0)
           sum += 1 + s.augmentation->contour(arc, 0.5).edges.size();
       return sum;
     }},
    {"critical_set, of each node",
     [](const Subject& s) {
       std::size_t sum = 0, number = 0;
       for(const auto node : CGAL::make_range(vertices(s.graph)))
         if(number++ % 8 == 0)
         {
           const auto set = s.augmentation->critical_set(node);
           sum += length(set.lower_contours) + length(set.upper_contours) + set.star.size();
         }
       return sum;
     }},
    {"embed",
     [](const Subject& s) {
       CGAL::Reeb_graph::embed(*s.augmentation);
       return std::size_t(0);
     }},
    {"vertex_counts_of_places",
     [](const Subject& s) { return 0 * vertex_counts_of_places(s.mesh, s.graph, *s.places).size(); }},
    {"areas_of_places", [](const Subject& s) { return 0 * areas_of_places(s.mesh, s.graph, *s.places).size(); }},
    {"arc_areas", [](const Subject& s) { return 0 * arc_areas(s.mesh, s.graph, *s.places).size(); }},
    {"arc_mean_values",
     [](const Subject& s) { return 0 * arc_mean_values(s.mesh, s.field, s.graph, *s.places).size(); }},
    {"arc_lengths",
     [](const Subject& s) {
       std::size_t sum = 0;
       for(const auto arc : CGAL::make_range(edges(s.graph)))
         sum += s.graph[arc].chain.size();
       return sum + 0 * arc_lengths(s.mesh, s.field, s.graph).size();
     }},
    {"loop_contours",
     [](const Subject& s) {
       std::vector<Surface_contour> contours;
       loop_contours(s.graph, *s.augmentation, std::back_inserter(contours));
       return length(contours);
     }},
  };
}

Functions functions_of_graphs()
{
  return {
    {"number_of_components, _loops",
     [](const Subject& s) { return 0 * (number_of_components(s.graph) + number_of_loops(s.graph)); }},
    {"cycle_basis",
     [](const Subject& s) {
       std::vector<std::vector<boost::graph_traits<Graph>::edge_descriptor>> loops;
       cycle_basis(s.graph, std::back_inserter(loops));
       std::size_t sum = 0;
       for(const auto& loop : loops)
         sum += loop.size();
       return sum;
     }},
    {"persistence_pairs",
     [](const Subject& s) {
       std::vector<Persistence_pair<boost::graph_traits<Graph>::vertex_descriptor>> pairs;
       persistence_pairs(s.graph, std::back_inserter(pairs));
       return std::size_t(0);
     }},
    {"arc_persistences", [](const Subject& s) { return 0 * arc_persistences(s.graph).size(); }},
    {"simplify",
     [](const Subject& s) {
       Graph simplified;
       simplify(s.graph, 0.2 * s.range, simplified);
       return std::size_t(0);
     }},
    {"simplification_thresholds",
     [](const Subject& s) {
       std::vector<Simplification_threshold> thresholds;
       simplification_thresholds(s.graph, std::back_inserter(thresholds));
       return 0 * thresholds.size();
     }},
    {"simplify, cancel_loops",
     [](const Subject& s) {
       Graph simplified;
       simplify(s.graph, 0.2 * s.range, simplified, parameters::cancel_loops(true));
       return std::size_t(0);
     }},
    {"simplify_field, ties contracted",
     [](const Subject& s) {
       std::vector<double> result(s.mesh.number_of_vertices());
       simplify_field(s.mesh, s.field, 0.2 * s.range, make_scalar_map(s.mesh, result),
                      parameters::ties(Ties::CONTRACT));
       return std::size_t(0);
     }},
    {"simplify_field, with the graph",
     [](const Subject& s) {
       std::vector<double> result(s.mesh.number_of_vertices());
       const auto places =
         boost::make_function_property_map<Mesh::Vertex_index>([&](auto v) { return s.places->index(v); });
       try
       {
         simplify_field(s.mesh, s.field, s.graph, 0.2 * s.range, make_scalar_map(s.mesh, result),
                        parameters::vertex_place_map(places));
       }
       catch(const Perturbed_ties_error&)
       {}
       return std::size_t(0);
     }},
    {"simplify_field",
     [](const Subject& s) {
       std::vector<double> result(s.mesh.number_of_vertices());
       try
       {
         simplify_field(s.mesh, s.field, 0.2 * s.range, make_scalar_map(s.mesh, result));
       }
       catch(const Perturbed_ties_error&)
       {} // a refusal takes as long
       return std::size_t(0);
     }},
    {"lay_out_in_plane", [](const Subject& s) { return 0 * lay_out_in_plane(s.graph).arc_polylines.size(); }},
  };
}

Functions functions_of_files()
{
  return {
    writer("write_svg", [](std::ostream& out, const Subject& s) { write_svg(out, s.graph); }),
    writer("write_graphml",
           [](std::ostream& out, const Subject& s) {
             write_graphml(out, s.graph, get(boost::vertex_index, s.mesh), make_halfedge_index_map(s.mesh));
           }),
    writer("write_graphviz",
           [](std::ostream& out, const Subject& s) { write_graphviz(out, s.graph, get(boost::vertex_index, s.mesh)); }),
    writer("write_vtp",
           [](std::ostream& out, const Subject& s) {
             write_vtp(out, s.graph, s.embedding, get(boost::vertex_index, s.mesh));
           }),
    writer("write_obj", [](std::ostream& out, const Subject& s) { write_obj(out, s.graph, s.embedding); }),
    writer("write_json",
           [](std::ostream& out, const Subject& s) {
             write_json(out, s.mesh, s.graph, s.embedding, get(boost::vertex_index, s.mesh));
           }),
    writer("write_nodes_csv, write_arcs_csv",
           [](std::ostream& out, const Subject& s) {
             write_nodes_csv(out, s.graph, s.embedding, get(boost::vertex_index, s.mesh));
             write_arcs_csv(out, s.graph, s.embedding);
           }),
    writer("write_polylines",
           [](std::ostream& out, const Subject& s) { write_polylines(out, s.embedding.arc_polylines); }),
    writer("write_mesh_vtp", [](std::ostream& out, const Subject& s) { write_mesh_vtp(out, s.mesh); }),
    {"read_graphml",
     [](const Subject& s) {
       std::istringstream in(s.graphml);
       Graph graph;
       read_graphml(in, s.mesh, graph);
       return s.graphml.size() / 100;
     }},
  };
}

// The pairs of two fields of noise.
struct Noisy_pairs
{
  explicit Noisy_pairs(std::size_t number)
  {
    random_meshes::Random random(number);
    const auto unit = [&] { return static_cast<double>(random.below(1000000)) / 1000000; };
    for(auto* pairs : {&a, &b})
      for(std::size_t i = 0; i < number; ++i)
      {
        const double lower = unit();
        pairs->push_back({lower, lower + (1 - lower) * unit() * unit(), Persistence_pair_kind::MINIMUM_SADDLE});
      }
  }
  std::size_t size() const { return a.size(); }

  std::vector<Persistence_values> a, b;
};

// Loops each of which is on a branch of the one before, and keeps that as long as it stays: simplify() removes one of
// them a turn.
struct Nested_loops
{
  explicit Nested_loops(std::size_t loops)
  {
    std::vector<random_graphs::Arc> arcs;
    for(std::size_t i = 0; i < loops; ++i)
    {
      const std::size_t pit = i, split = loops + i, from = 2 * loops + 2 * i, to = from + 1;
      const std::size_t join = 4 * loops + i, peak = 5 * loops + i;
      arcs.insert(arcs.end(), {{pit, split}, {split, from}, {split, to}, {from, join}, {to, join}, {join, peak}});
      if(i + 1 < loops)
        arcs.emplace_back(to, from + 2);
    }
    graph = random_graphs::make_graph(6 * loops, arcs);
  }
  std::size_t size() const { return num_vertices(graph); }

  random_graphs::Graph graph;
};

template <class NamedParameters>
std::size_t simplify_all(const Nested_loops& s, const NamedParameters& np)
{
  random_graphs::Graph simplified;
  return 0 * simplify(s.graph, 1e9, simplified, np).number_of_old_nodes();
}
} // namespace

void measure_graphs(Table& table)
{
  const std::size_t n = 25000, number_of_inputs = all_inputs(100).size();
  for(std::size_t i = 0; i < number_of_inputs; ++i)
  {
    const auto subjects = at_three_sizes<Subject>(n, [i](std::size_t size) { return all_inputs(size)[i]; });
    const std::string name = all_inputs(100)[i].name;
    for(const Functions& functions :
        {functions_of_computation(), functions_of_augmentation(), functions_of_graphs(), functions_of_files()})
      for(const Function<Subject>& function : functions)
        table.measure(name, subjects, function);
    if(name.find("noise") == std::string::npos && name != "comb") // there, the contours at saddles are long
      table.measure(name, subjects, Function<Subject>{"... critical sets", [](const Subject& s) {
                                                        return compute(s, parameters::method(Method::CRITICAL_SETS));
                                                      }});
  }
  const auto noisy = at_three_sizes<Noisy_pairs>(4000, [](std::size_t pairs) { return pairs; });
  table.measure("two of noise", noisy, Function<Noisy_pairs>{"bottleneck_distance", [](const Noisy_pairs& s) {
                                                               return 0 * std::size_t(bottleneck_distance(s.a, s.b));
                                                             }});
  const auto graphs = at_three_sizes<Nested_loops>(500, [](std::size_t loops) { return loops; });
  table.measure("nested loops", graphs, Function<Nested_loops>{"arc_persistences", [](const Nested_loops& s) {
                                                                 return 0 * arc_persistences(s.graph).size();
                                                               }});
  table.measure("nested loops", graphs, Function<Nested_loops>{"simplify", [](const Nested_loops& s) {
                                                                 return simplify_all(s, parameters::default_values());
                                                               }});
  // the same again for each of them, as its reference says
  table.measure(
    "nested loops", graphs,
    Function<Nested_loops>{"simplify, cancel_loops",
                           [](const Nested_loops& s) { return simplify_all(s, parameters::cancel_loops(true)); }, 2.3});
}
} // namespace growth
