// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#include "computation/Mesh_graph.h"

#include "base/costs.h"
#include "base/progress_bar.h"
#include "base/surface.h"
#include "computation/Report_visitor.h"
#include "computation/analysis.h"
#include "computation/arc_columns.h"
#include "computation/nearest_place.h"

#include <CGAL/Reeb_graph/Complex_augmentation.h>
#include <CGAL/Reeb_graph/IO/json.h>
#include <CGAL/Reeb_graph/arc_measures.h>
#include <CGAL/Reeb_graph/embed.h>
#include <CGAL/Reeb_graph/internal/base/lengths.h>
#include <CGAL/Reeb_graph/simplification/simplify_field.h>
#include <CGAL/compute_reeb_graph.h>
#include <CGAL/compute_reeb_graph_of_soup.h>
#include <CGAL/property_map.h>
#include <CGAL/tags.h>

#include <boost/property_map/property_map.hpp>
#include <boost/range/irange.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <iterator>
#include <limits>
#include <memory>
#include <sstream>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace reeb_graph_program {
namespace {
typedef CGAL::Parallel_if_available_tag Parallel_tag;
typedef CGAL::Reeb_graph::Soup_augmentation<double> Soup_augmentation;
typedef CGAL::Reeb_graph::Tetrahedra_augmentation<double> Tetrahedra_augmentation;

// The places of vertices, by their indices, as functions that measure pieces of a mesh ask for them.
struct Vertex_places
{
  const std::vector<std::size_t>& places;
  std::size_t index(std::size_t v) const { return places[v]; }
};

// The three kinds of meshes, each with what is called in another way for it. Ends are those of an edge of a chain.

class Surface_kind
{
public:
  typedef reeb_graph_program::Graph Graph;
  typedef reeb_graph_program::Augmentation Augmentation;

  Surface_kind(const Mesh& mesh, Scalar_map scalar_map) : surface_(mesh.surface), scalar_map_(scalar_map) {}

  auto named_parameters(const Graph_options& options) const { return reeb_graph_program::named_parameters(options); }

  template <class NamedParameters>
  void compute(Graph& graph, const NamedParameters& np) const
  {
    CGAL::compute_reeb_graph<Parallel_tag>(surface_, scalar_map_, graph, np);
  }

  template <class NamedParameters>
  auto augment(const Graph& graph, const NamedParameters& np) const
  {
    return std::make_unique<const Augmentation>(surface_, scalar_map_, graph, np);
  }

  const Graph& on_surface(const Graph& graph, std::optional<Graph>&) const { return graph; }
  auto vertex_numbers() const { return get(boost::vertex_index, surface_); }
  auto points() const { return surface_.points(); }
  auto ends(Surface::Halfedge_index h) const { return std::pair(surface_.source(h), surface_.target(h)); }

  // The lengths, the areas, and the mean values of arcs.
  template <class MakeAugmentation>
  std::vector<Arc_column> measure_arcs(const Graph& graph, const Vertex_places& places, const MakeAugmentation&) const
  {
    return {length_column(CGAL::Reeb_graph::arc_lengths(surface_, scalar_map_, graph)),
            size_column("area", CGAL::Reeb_graph::arc_areas(surface_, graph, places)),
            mean_value_column(CGAL::Reeb_graph::arc_mean_values(surface_, scalar_map_, graph, places))};
  }

private:
  const Surface& surface_;
  const Scalar_map scalar_map_;
};

// Triangles or tetrahedra. Where both are together, the faces of all tetrahedra are triangles too: the graph is the same.
template <class Augmentation_>
class Complex_kind
{
  static constexpr bool has_tetrahedra = std::is_same_v<Augmentation_, Tetrahedra_augmentation>;

public:
  typedef Complex_graph Graph;
  typedef Augmentation_ Augmentation;

  Complex_kind(const Mesh& mesh, Scalar_map scalar_map) : mesh_(mesh), scalar_map_(scalar_map) {}

  auto named_parameters(const Graph_options& options) const
  {
    return reeb_graph_program::named_parameters(options).edges(std::cref(mesh_.complex->edges));
  }

  template <class NamedParameters>
  void compute(Graph& graph, const NamedParameters& np) const
  {
    with_cells([&](const auto& cells) {
      if constexpr(has_tetrahedra)
        CGAL::compute_reeb_graph_of_tetrahedra<Parallel_tag>(number_of_vertices(), cells, scalars(), graph, np);
      else
        CGAL::compute_reeb_graph_of_soup<Parallel_tag>(number_of_vertices(), cells, scalars(), graph, np);
    });
  }

  template <class NamedParameters>
  auto augment(const Graph& graph, const NamedParameters& np) const
  {
    return with_cells([&](const auto& cells) {
      return std::make_unique<const Augmentation>(number_of_vertices(), cells, scalars(), graph, np);
    });
  }

  // The same graph with descriptors of the surface that has the vertices, without chains.
  const reeb_graph_program::Graph& on_surface(const Graph& graph,
                                              std::optional<reeb_graph_program::Graph>& result) const
  {
    if(result)
      return *result;
    result.emplace();
    for(const auto node : CGAL::make_range(boost::vertices(graph)))
    {
      const Surface::Vertex_index v(static_cast<Surface::size_type>(graph[node].vertex));
      add_vertex(reeb_graph_program::Graph::vertex_bundled{graph[node].value, v, graph[node].kind}, *result);
    }
    for(const auto arc : CGAL::make_range(edges(graph)))
      put(boost::edge_index, *result, add_edge(source(arc, graph), target(arc, graph), *result).first,
          get(boost::edge_index, graph, arc));
    return *result;
  }

  boost::typed_identity_property_map<std::size_t> vertex_numbers() const { return {}; }
  auto points() const { return CGAL::make_range(mesh_.surface.points().begin(), mesh_.surface.points().end()); }
  auto ends(const std::pair<std::size_t, std::size_t>& edge) const { return edge; }

  template <class MakeAugmentation>
  std::vector<Arc_column> measure_arcs(const Graph&,
                                       const Vertex_places& places,
                                       const MakeAugmentation& make_augmentation) const
  {
    const Augmentation& augmentation = make_augmentation();
    const auto sizes = [&] {
      if constexpr(has_tetrahedra)
        return CGAL::Reeb_graph::arc_volumes(augmentation, places, points());
      else
        return CGAL::Reeb_graph::arc_areas(augmentation, places, points());
    };
    return {length_column(CGAL::Reeb_graph::arc_lengths(augmentation, points())),
            size_column(has_tetrahedra ? "volume" : "area", sizes()),
            mean_value_column(CGAL::Reeb_graph::arc_mean_values(augmentation, places, points()))};
  }

private:
  std::size_t number_of_vertices() const { return mesh_.surface.number_of_vertices(); }
  auto scalars() const { return CGAL::make_range(scalar_map_.begin(), scalar_map_.end()); }

  template <class Function>
  auto with_cells(const Function& function) const
  {
    const Complex& complex = *mesh_.complex;
    if constexpr(has_tetrahedra)
      return function(complex.tetrahedra);
    else if(complex.tetrahedra.empty())
      return function(complex.triangles);
    else
    {
      std::vector<std::array<std::uint32_t, 3>> triangles = complex.triangles;
      for(const auto& t : complex.tetrahedra)
        triangles.insert(triangles.end(),
                         {{t[0], t[1], t[2]}, {t[0], t[1], t[3]}, {t[0], t[2], t[3]}, {t[1], t[2], t[3]}});
      return function(triangles);
    }
  }

  const Mesh& mesh_;
  const Scalar_map scalar_map_;
};

Nearest_place find_nearest_place(const Mesh& mesh, Scalar_map scalar_map, const Point& point)
{
  Nearest_place place(point);
  const auto at = [&](auto v) { return mesh.surface.point(Surface::Vertex_index(v)); };
  const auto value = [&](auto v) { return scalar_map[Surface::Vertex_index(v)]; };
  const auto add_triangle = [&](auto a, auto b, auto c) {
    place.add_triangle({at(a), at(b), at(c)}, {value(a), value(b), value(c)});
  };
  for(const Surface::Face_index f : mesh.surface.faces())
  {
    const Surface::Halfedge_index h = mesh.surface.halfedge(f);
    add_triangle(mesh.surface.target(h), mesh.surface.target(mesh.surface.next(h)), mesh.surface.source(h));
  }
  if(!mesh.complex)
    return place;
  for(const auto& [a, b] : mesh.complex->edges)
    add_triangle(a, b, b);
  for(const auto& [a, b, c] : mesh.complex->triangles)
    add_triangle(a, b, c);
  for(const auto& [a, b, c, d] : mesh.complex->tetrahedra)
    place.add_tetrahedron({at(a), at(b), at(c), at(d)}, {value(a), value(b), value(c), value(d)});
  return place;
}

double distance_to(const Point& point, const Contour& contour)
{
  double least = std::numeric_limits<double>::infinity();
  const std::vector<Point>& points = contour.points;
  const auto visit = [&](std::size_t a, std::size_t b, std::size_t c) {
    const Point nearest = nearest_point(point, {points[a], points[b], points[c]});
    least = (std::min)(least, CGAL::Reeb_graph::internal::distance_between(point, nearest));
  };
  for(const std::vector<std::size_t>& line : contour.polylines)
    for(std::size_t i = 0; i < line.size(); ++i)
      visit(line[i == 0 ? 0 : i - 1], line[i], line[i]);
  for(const auto& [a, b, c] : contour.triangles)
    visit(a, b, c);
  return least;
}

std::string no_contour(const Contour_choice& choice)
{
  std::ostringstream message;
  message << "there is no contour";
  if(choice.point)
    message << " near the point";
  else if(choice.t)
    message << ": the graph has no arc";
  else if(choice.levels.size() == 1)
    message << " at the level " << choice.levels.front();
  else
    message << " at these levels";
  return message.str();
}

// The graph of a mesh of a kind.
template <class Kind>
class Mesh_graph_of : public Mesh_graph
{
  typedef typename Kind::Graph Any_graph;
  typedef typename Kind::Augmentation Any_augmentation;

public:
  Mesh_graph_of(const Mesh& mesh,
                Scalar_map scalar_map,
                const Graph_options& options,
                const Simplification_options& simplification,
                double threshold,
                Report& report)
    : mesh_(mesh),
      scalar_map_(scalar_map),
      kind_(mesh, scalar_map),
      options_(options),
      given_(new Any_graph(compute(options.are_places_wanted, report))) // not make_shared(), which copies it
  {
    const Stopwatch stopwatch;
    simplified_.emplace(*given_, simplification, threshold);
    if(simplification.is_anything_removed())
      report.seconds.emplace_back("simplify", stopwatch.seconds());
  }

  Mesh_graph_of(const Mesh_graph_of& other, const Simplification_options& simplification, double threshold)
    : mesh_(other.mesh_),
      scalar_map_(other.scalar_map_),
      kind_(other.kind_),
      options_(other.options_),
      given_places_(other.given_places_),
      given_(other.given_)
  {
    simplified_.emplace(*given_, simplification, threshold);
  }

  std::unique_ptr<Mesh_graph> simplify(const Simplification_options& simplification, double threshold) const override
  {
    return std::make_unique<Mesh_graph_of>(*this, simplification, threshold);
  }

  const Mesh& mesh() const override { return mesh_; }
  Scalar_map scalar_map() const override { return scalar_map_; }
  const Graph& given() const override { return kind_.on_surface(*given_, given_on_surface_); }
  const Graph& result() const override
  {
    return simplified_->simplification() ? kind_.on_surface(simplified_->result(), result_on_surface_) : given();
  }
  double threshold() const override { return simplified_->threshold(); }

  std::vector<std::vector<std::size_t>> chains() const override
  {
    std::vector<std::vector<std::size_t>> chains;
    const Any_graph& graph = simplified_->result();
    for(const auto arc : CGAL::make_range(edges(graph)))
    {
      std::vector<std::size_t>& vertices = chains.emplace_back();
      for(const auto& edge : graph[arc].chain)
      {
        const auto [lower, upper] = kind_.ends(edge);
        if(vertices.empty() || vertices.back() != lower) // where it passes a plateau, it can go on elsewhere
          vertices.push_back(lower);
        vertices.push_back(upper);
      }
    }
    return chains;
  }

  const std::vector<std::size_t>& given_places() override
  {
    if(!*given_places_)
    {
      Report unused;
      compute(true, unused);
    }
    return **given_places_;
  }

  const std::vector<std::size_t>& places() override
  {
    const auto& simplification = simplified_->simplification();
    if(!simplification || places_)
      return simplification ? *places_ : given_places();
    const std::size_t number_of_nodes = simplification->number_of_old_nodes();
    places_ = given_places();
    for(std::size_t& place : *places_)
      place = place < number_of_nodes ? simplification->index_of_node(place)
                                      : simplification->index_of_arc(place - number_of_nodes);
    return *places_;
  }

  const Arc_table& arc_table() override
  {
    if(arc_table_)
      return *arc_table_;
    const Any_graph& graph = simplified_->result();
    const auto make_augmentation = [this]() -> const Any_augmentation& { return augmentation(); };
    std::vector<Arc_column> measures = kind_.measure_arcs(graph, Vertex_places{places()}, make_augmentation);
    measures.insert(measures.begin() + 2,
                    vertices_column(mesh_.surface.vertices(), places(), num_vertices(graph), num_edges(graph)));
    Arc_table table = table_of_graph(result());
    std::move(measures.begin(), measures.end(), std::back_inserter(table.columns));
    arc_table_ = std::move(table);
    return *arc_table_;
  }

  Embedding embed(CGAL::Reeb_graph::Embedding_manner manner) override
  {
    Progress_bar progress_bar("embedding");
    return CGAL::Reeb_graph::embed<Parallel_tag>(
      augmentation(), kind_.points(), CGAL::parameters::embedding_manner(manner).callback(std::ref(progress_bar)));
  }

  void write_json(std::ostream& stream,
                  const Embedding& embedding,
                  const std::vector<CGAL::Reeb_graph::Attribute>& arc_attributes,
                  double base) override
  {
    std::optional<Any_graph> copy;
    CGAL::Reeb_graph::write_json(stream, augmentation().mesh(), with_base(augmentation().graph(), base, copy),
                                 embedding, kind_.vertex_numbers(), CGAL::parameters::arc_attributes(arc_attributes));
  }

  const Augmentation& surface_augmentation() override
  {
    if constexpr(std::is_same_v<Any_augmentation, Augmentation>)
      return augmentation();
    else
      throw std::logic_error("the mesh is not a surface");
  }

  std::vector<Contour> find_contours(const Contour_choice& choice) override
  {
    const Any_graph& graph = augmentation().graph();
    std::vector<Contour> contours;
    const auto add = [&](const auto arc) {
      contours.push_back(
        convert(choice.parametrization.empty()
                  ? augmentation().contour(arc, *choice.t)
                  : augmentation().contour(arc, *choice.t, CGAL::make_property_map(choice.parametrization))));
    };
    if(choice.point)
      contours = nearest_contour(find_nearest_place(mesh_, scalar_map_, *choice.point));
    else if(choice.arc && *choice.arc >= num_edges(graph))
      throw std::runtime_error("there is no arc " + std::to_string(*choice.arc) + ": the graph has "
                               + std::to_string(num_edges(graph)) + ", numbered from 0");
    else if(choice.arc)
      add(*std::next(edges(graph).first, static_cast<std::ptrdiff_t>(*choice.arc)));
    else if(choice.t)
      std::for_each(edges(graph).first, edges(graph).second, add);
    else if(choice.number_of_levels)
      contours = contours_at(equal_steps(*choice.number_of_levels, scalar_map_));
    for(Contour& contour : contours_at(choice.levels))
      contours.push_back(std::move(contour));
    if(contours.empty() && !choice.may_be_none)
      throw std::runtime_error(no_contour(choice));
    return contours;
  }

  Critical_set critical_set(std::size_t node) override
  {
    const auto set = augmentation().critical_set(node);
    Critical_set result;
    result.star.assign(set.star.begin(), set.star.end());
    for(const auto& h : set.border_loop)
      result.border_loop.push_back(kind_.ends(h).second);
    for(const auto& contour : set.lower_contours)
      result.lower_contours.push_back(convert(contour));
    for(const auto& contour : set.upper_contours)
      result.upper_contours.push_back(convert(contour));
    return result;
  }

private:
  // Computes the graph, and adds what it took to the report. Keeps the places of the vertices, if they are wanted.
  Any_graph compute(bool are_places_wanted, Report& report) const
  {
    Any_graph graph;
    Report_visitor visitor(report);
    Progress_bar progress_bar("graph");
    const Timed_step timed(report, "compute");
    const auto compute = [&](const auto& np) {
      kind_.compute(graph, np.visitor(std::ref(visitor)).callback(std::ref(progress_bar)));
    };
    const auto np = kind_.named_parameters(options_);
    if(are_places_wanted)
    {
      std::vector<std::size_t> places(mesh_.surface.number_of_vertices() + mesh_.surface.number_of_removed_vertices());
      compute(np.vertex_place_map(CGAL::make_property_map(places)));
      *given_places_ = std::move(places);
    }
    else
      compute(np);
    return graph;
  }

  Contour convert(const typename Any_augmentation::Contour& contour)
  {
    Contour result;
    result.arc = get(boost::edge_index, augmentation().graph(), contour.arc);
    result.value = contour.value;
    result.is_closed = contour.is_closed();
    for(const auto& edge : contour.edges)
    {
      const auto [lower, upper] = kind_.ends(edge);
      result.edges.push_back({lower, upper});
    }
    augmentation().points_of_contour(contour, std::back_inserter(result.points), kind_.points());
    contour.for_each_polyline([&](const std::vector<std::size_t>& line) { result.polylines.push_back(line); });
    contour.for_each_triangle([&](std::size_t i, std::size_t j, std::size_t k) {
      result.triangles.push_back({i, j, k});
    });
    return result;
  }

  std::vector<Contour> contours_at(const std::vector<double>& levels)
  {
    std::vector<Contour> contours;
    for(const double level : levels)
      for(const auto& contour : augmentation().template contours_at_value<Parallel_tag>(level))
        contours.push_back(convert(contour));
    return contours;
  }

  std::vector<Contour> nearest_contour(const Nearest_place& place)
  {
    std::vector<Contour> nearest;
    if(!place.is_found())
      return nearest;
    // Where the place is the highest one of its cell, the level just above it can be elsewhere.
    std::vector<double> levels = {place.value()};
    if(!place.is_level_in_cell())
      levels.push_back(std::nextafter(place.value(), -std::numeric_limits<double>::infinity()));
    double least = std::numeric_limits<double>::infinity();
    for(Contour& contour : contours_at(levels))
    {
      const double distance = distance_to(place.place(), contour);
      if(!(distance < least))
        continue;
      least = distance;
      nearest = {std::move(contour)};
    }
    return nearest;
  }

  const Any_augmentation& augmentation()
  {
    if(augmentation_)
      return *augmentation_;
    Progress_bar progress_bar("surface");
    const auto np = kind_.named_parameters(options_);
    if(const auto& simplification = simplified_->simplification())
      augmentation_ =
        kind_.augment(simplified_->result(), np.simplification(*simplification).callback(std::ref(progress_bar)));
    else
      augmentation_ = kind_.augment(*given_, np.callback(std::ref(progress_bar)));
    return *augmentation_;
  }

  const Mesh& mesh_;
  const Scalar_map scalar_map_;
  const Kind kind_;
  const Graph_options options_;
  // Those of the given graph, shared as that is; none while nobody has asked for them.
  const std::shared_ptr<std::optional<std::vector<std::size_t>>> given_places_ =
    std::make_shared<std::optional<std::vector<std::size_t>>>();
  const std::shared_ptr<const Any_graph> given_;
  std::optional<Simplified_graph_of<Any_graph>> simplified_;
  mutable std::optional<Graph> given_on_surface_, result_on_surface_;
  std::unique_ptr<const Any_augmentation> augmentation_;
  std::optional<std::vector<std::size_t>> places_; // in a simplified graph
  std::optional<Arc_table> arc_table_;
};

} // namespace

std::vector<double> equal_steps(std::size_t number_of_levels, Scalar_map scalar_map)
{
  std::vector<double> levels;
  if(scalar_map.begin() == scalar_map.end())
    return levels;
  const auto [lowest, highest] = std::minmax_element(scalar_map.begin(), scalar_map.end());
  if(!std::isfinite(*lowest) || !std::isfinite(*highest))
    throw std::runtime_error("--levels needs a field of finite range");
  for(std::size_t i = 1; i <= number_of_levels; ++i)
  {
    const double t = static_cast<double>(i) / (static_cast<double>(number_of_levels) + 1);
    levels.push_back((1 - t) * *lowest + t * *highest);
  }
  return levels;
}

std::unique_ptr<Mesh_graph> compute_mesh_graph(const Mesh& mesh,
                                               Scalar_map scalar_map,
                                               const Graph_options& options,
                                               const Simplification_options& simplification,
                                               double threshold,
                                               Report& report)
{
  const auto compute = [&](const auto* kind) -> std::unique_ptr<Mesh_graph> {
    typedef std::remove_const_t<std::remove_pointer_t<decltype(kind)>> Kind;
    return std::make_unique<Mesh_graph_of<Kind>>(mesh, scalar_map, options, simplification, threshold, report);
  };
  if(!mesh.complex)
    return compute(static_cast<const Surface_kind*>(nullptr));
  if(mesh.complex->triangles.empty() && !mesh.complex->tetrahedra.empty())
    return compute(static_cast<const Complex_kind<Tetrahedra_augmentation>*>(nullptr));
  return compute(static_cast<const Complex_kind<Soup_augmentation>*>(nullptr));
}

std::unique_ptr<Mesh_graph> compute_mesh_graph(const Mesh& mesh, Scalar_map scalar_map, Graph_options options)
{
  options.are_places_wanted = true;
  Report unused;
  return compute_mesh_graph(mesh, scalar_map, options, {}, 0, unused);
}

namespace {
bool has_ties(Scalar_map scalar_map)
{
  std::vector<double> values(scalar_map.begin(), scalar_map.end());
  std::sort(values.begin(), values.end());
  return std::adjacent_find(values.begin(), values.end()) != values.end();
}

} // namespace

Simplified_field compute_simplified_field(const Mesh& mesh,
                                          Scalar_map scalar_map,
                                          Mesh_graph& graph,
                                          const Graph_options& graph_options,
                                          const Simplification_options& simplification,
                                          Scalar_map simplified_map)
{
  namespace parameters = CGAL::parameters;
  typedef CGAL::Reeb_graph::Ties Ties;
  Graph_options without_degree_two = graph_options;
  without_degree_two.are_degree_two_nodes_kept = false;
  const std::unique_ptr<Mesh_graph> other =
    graph_options.are_degree_two_nodes_kept ? compute_mesh_graph(mesh, scalar_map, without_degree_two) : nullptr;
  Mesh_graph& given = other ? *other : graph;
  const auto leaves = parameters::number_of_leaves(simplification.number_of_leaves.value_or(0));
  const auto simplify_given = [&](Ties ties) {
    Progress_bar progress_bar("simplified field");
    const auto place_map = CGAL::make_property_map(given.given_places().data());
    return CGAL::Reeb_graph::simplify_field(
      mesh.surface, scalar_map, given.given(), graph.threshold(), simplified_map,
      leaves.ties(ties).vertex_place_map(place_map).callback(std::ref(progress_bar)));
  };
  try
  {
    return {simplify_given(graph_options.ties), false};
  }
  catch(const CGAL::Reeb_graph::Perturbed_ties_error&)
  {
    if(!has_ties(scalar_map)) // With contracted ties, the graph is the same one.
      return {simplify_given(Ties::CONTRACT), true};
  }
  Progress_bar progress_bar("simplified field");
  return {CGAL::Reeb_graph::simplify_field(mesh.surface, scalar_map, graph.threshold(), simplified_map,
                                           leaves.ties(Ties::CONTRACT).callback(std::ref(progress_bar))),
          true};
}

} // namespace reeb_graph_program
