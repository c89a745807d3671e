// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_SIMPLIFICATION_INTERNAL_SIMPLIFIED_VALUES_H
#define CGAL_REEB_GRAPH_SIMPLIFICATION_INTERNAL_SIMPLIFIED_VALUES_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/Flat_field.h>
#include <CGAL/Reeb_graph/exceptions.h>
#include <CGAL/Reeb_graph/internal/base/Index.h>
#include <CGAL/Reeb_graph/internal/base/Progress.h>
#include <CGAL/Reeb_graph/internal/base/arrays.h>
#include <CGAL/Reeb_graph/internal/base/compiled.h>
#include <CGAL/Reeb_graph/internal/base/interpolation.h>
#include <CGAL/Reeb_graph/internal/complex/Flat_mesh.h>
#include <CGAL/Reeb_graph/internal/complex/Weighted_graph.h>
#include <CGAL/Reeb_graph/internal/graph/Leaf_pruning.h>
#include <CGAL/Reeb_graph/internal/graph/graph_loops.h>
#include <CGAL/Reeb_graph/named_parameters.h>
#include <CGAL/Reeb_graph/simplification/simplify.h>
#include <CGAL/compute_reeb_graph.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/boost/graph/iterator.h>
#include <CGAL/number_utils.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/property_map/function_property_map.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <map>
#include <set>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::Reeb_graph::internal {

// The numbers that the values of a field may have: all doubles, or those that are floats, too.
class Number_format
{
public:
  explicit Number_format(bool are_floats) : are_floats_(are_floats) {}

  // The nearest one of a double.
  double rounded(double number) const { return are_floats_ ? static_cast<double>(static_cast<float>(number)) : number; }

  // The next one behind one of them, on the way to another number.
  double next(double number, double target) const
  {
    return are_floats_ ? std::nextafter(static_cast<float>(number), static_cast<float>(target))
                       : std::nextafter(number, target);
  }

private:
  bool are_floats_;
};

// The removed pieces of a surface. All vertices of a piece have been removed together with branches at one saddle, and
// are moved next to it in the order of the vertices: just above it if one of them is below it, else just below it. The
// vertices around the piece do not change sides. Within it, the vertices are numbered so that each has a lower and a
// higher neighbor. So no extremum is left, and as the indices of the piece and of its saddle add up to the same as
// before, no other saddle than that of the arcs that stay if the piece has no handle and no border.
template <class Complex>
class Moved_pieces
{
public:
  // `saddles` has for each vertex that is to be moved the vertex of the saddle, and no_index for each other one.
  // `rooms` has for the vertex of a saddle how far the next values of nodes are: a saddle in a piece must not pass
  // them.
  Moved_pieces(const Complex& complex,
               const Weighted_graph& graph,
               const std::vector<Index>& saddles,
               const std::vector<double>& rooms,
               const std::vector<double>& values,
               double threshold,
               Number_format format)
    : complex_(complex),
      graph_(graph),
      saddles_(saddles),
      rooms_(rooms),
      values_(values),
      threshold_(threshold),
      format_(format),
      st_numbering_(graph),
      numbers_(values.size(), no_index)
  {}

  // The values with those of the pieces changed, but not those of a piece with all its surroundings on one side.
  std::vector<double> move()
  {
    std::vector<double> moved = values_;
    Index number = 0;
    for(Index v = 0; v != graph_.number_of_vertices(); ++v)
    {
      if(saddles_[v] == no_index || numbers_[v] != no_index)
        continue;
      const Piece piece = collect_piece(v, number++);
      if(!piece.has_source || !piece.has_sink)
        continue;
      const auto order = st_numbering_(
        piece.vertices, [&](Index u) { return numbers_[u] == number - 1; },
        [&](Index u) { return is_source(u, piece); });
      put_values(order, choose_values(piece), moved);
    }
    return moved;
  }

private:
  static constexpr double infinity = std::numeric_limits<double>::infinity();

  struct Piece
  {
    std::vector<Index> vertices;
    Index saddle = 0;
    bool is_above = false;     // whether it is moved to just above the saddle
    bool has_source, has_sink; // among the vertices around it
    double highest_source, lowest_sink;
  };

  bool is_lower(Index u, Index v) const { return std::make_pair(values_[u], u) < std::make_pair(values_[v], v); }

  // Where a vertex around a piece is when all pieces have been moved: at itself, or next to its saddle.
  Index place(Index u) const { return saddles_[u] == no_index ? u : saddles_[u]; }

  bool is_source(Index u, const Piece& piece) const
  {
    return place(u) == piece.saddle ? piece.is_above : is_lower(place(u), piece.saddle);
  }

  Piece collect_piece(Index first, Index number)
  {
    Piece piece;
    piece.saddle = saddles_[first];
    piece.vertices.push_back(first);
    numbers_[first] = number;
    for(std::size_t i = 0; i != piece.vertices.size(); ++i)
    {
      const Index v = piece.vertices[i];
      piece.is_above = piece.is_above || is_lower(v, piece.saddle);
      for(const auto& neighbor : graph_.neighbors(v))
        if(saddles_[neighbor.vertex] == piece.saddle && numbers_[neighbor.vertex] == no_index)
        {
          numbers_[neighbor.vertex] = number;
          piece.vertices.push_back(neighbor.vertex);
        }
    }
    look_around(piece, number);
    if(!piece.has_source || !piece.has_sink) // Pieces of several branches can have all their surroundings on one side.
    {
      piece.is_above = !piece.is_above;
      look_around(piece, number);
    }
    return piece;
  }

  // Finds what bounds the values of a piece.
  void look_around(Piece& piece, Index number) const
  {
    piece.has_source = piece.has_sink = false;
    piece.highest_source = -infinity;
    piece.lowest_sink = infinity;
    for(const Index v : piece.vertices)
      for(const auto& neighbor : graph_.neighbors(v))
      {
        const Index u = neighbor.vertex;
        if(numbers_[u] == number)
          continue;
        (is_source(u, piece) ? piece.has_source : piece.has_sink) = true;
        if(is_source(u, piece))
          piece.highest_source = (std::max)(piece.highest_source, values_[place(u)]);
        else
          piece.lowest_sink = (std::min)(piece.lowest_sink, values_[place(u)]);
      }
  }

  // As many values as the piece has vertices, ascending, between the saddle and the middle of the way to the next of
  // the vertices around the piece: the other half is for a piece that comes the other way. They take a small part of the
  // room, so that the largest change stays below the threshold.
  std::vector<double> choose_values(const Piece& piece) const
  {
    const bool is_above = piece.is_above;
    const double from = values_[piece.saddle], to = is_above ? piece.lowest_sink : piece.highest_source;
    const double middle = std::isinf(to) ? to : from / 2 + to / 2;
    const double slack = threshold_ - largest_distance(piece.vertices, from);
    const double room =
      (std::min)({std::abs(middle - from), std::abs(slack), rooms_[piece.saddle], (std::max)(std::abs(from), 1.)});
    const std::size_t size = piece.vertices.size();
    std::vector<double> values;
    double last = from;
    for(std::size_t i = 0; i != size; ++i)
    {
      const double step = room / 4 * (static_cast<double>(i + 1) / static_cast<double>(size));
      last = is_above ? (std::max)(format_.rounded(from + step), format_.next(last, infinity))
                      : (std::min)(format_.rounded(from - step), format_.next(last, -infinity));
      if(!(is_above ? from < last && last < middle : last < from && middle < last))
        throw_too_few_numbers(piece.vertices.front());
      values.push_back(last);
    }
    if(!is_above)
      std::reverse(values.begin(), values.end());
    return values;
  }

  void put_values(const std::vector<Index>& order, const std::vector<double>& values, std::vector<double>& moved) const
  {
    for(std::size_t i = 0; i != order.size(); ++i)
    {
      moved[order[i]] = values[i];
      if(!(std::abs(values[i] - values_[order[i]]) < threshold_))
        throw_too_few_numbers(order[i]);
    }
  }

  [[noreturn]] void throw_too_few_numbers(Index v) const
  {
    throw Perturbed_ties_error(complex_.position(Vertex_index(v)));
  }

  double largest_distance(const std::vector<Index>& vertices, double value) const
  {
    double distance = 0;
    for(const Index v : vertices)
      distance = (std::max)(distance, std::abs(values_[v] - value));
    return distance;
  }

  const Complex& complex_;
  const Weighted_graph& graph_; // its edges
  const std::vector<Index>& saddles_;
  const std::vector<double>& rooms_;
  const std::vector<double>& values_;
  const double threshold_;
  const Number_format format_;
  St_numbering st_numbering_;
  std::vector<Index> numbers_; // by vertex, of its piece
};

// The part of the threshold, and of the range of the values, that vertices of one value are spread over at the most.
inline constexpr int largest_spread_divisor = 1024;

// The saddles of one value with which other vertices are tied where there has to be room for a piece.
struct Tied_saddles
{
  std::set<Index> saddles;
  double largest_change; // keeps the changes in the pieces below the threshold
};

// These saddles, by value: those of pieces with a neighbor of the value of the saddle, as no number is between the two.
// `saddles` are those of Moved_pieces.
inline std::map<double, Tied_saddles> find_tied_saddles(const Weighted_graph& graph,
                                                        const std::vector<Index>& saddles,
                                                        const std::vector<double>& values,
                                                        double threshold)
{
  std::map<double, Tied_saddles> tied_saddles;
  const auto add = [&](Index saddle) {
    auto& tied = tied_saddles[values[saddle]];
    tied.saddles.insert(saddle);
    tied.largest_change = threshold / largest_spread_divisor;
  };
  const auto place = [&](Index v) { return saddles[v] == no_index ? v : saddles[v]; };
  for(Index v = 0; v != values.size(); ++v)
  {
    if(saddles[v] == no_index)
      continue;
    for(const auto& neighbor : graph.neighbors(v))
    {
      if(place(neighbor.vertex) != saddles[v] && values[place(neighbor.vertex)] == values[saddles[v]])
        add(saddles[v]);
    }
  }
  for(Index v = 0; v != values.size() && !tied_saddles.empty(); ++v)
  {
    const auto tied = saddles[v] == no_index ? tied_saddles.end() : tied_saddles.find(values[saddles[v]]);
    if(tied != tied_saddles.end())
      tied->second.largest_change =
        (std::min)(tied->second.largest_change, (threshold - std::abs(values[v] - tied->first)) / 2);
  }
  return tied_saddles;
}

// Tells these saddles apart from the vertices tied with them, by values between this one and the next larger one: those
// of the value that come before the first saddle keep it, and those between two saddles have one value. The order of
// all vertices, and so the graph, stays the same.
template <class Complex>
std::vector<double> spread_ties(const Complex& complex,
                                const std::vector<double>& values,
                                const std::map<double, Tied_saddles>& tied_saddles,
                                Number_format format)
{
  std::vector<double> spread = values;
  if(tied_saddles.empty())
    return spread;
  std::vector<Index> ascending;
  for(const Vertex_index v : complex.vertices())
  {
    if(complex.has_vertex(v))
      ascending.push_back(v.number());
  }
  std::stable_sort(ascending.begin(), ascending.end(), [&](Index u, Index v) { return values[u] < values[v]; });
  constexpr double infinity = std::numeric_limits<double>::infinity();
  const double lowest = values[ascending.front()], highest = values[ascending.back()];
  const double largest_spread =
    lowest < highest ? part_of_difference(lowest, highest, largest_spread_divisor) : infinity;
  for(const auto& [value, tied] : tied_saddles)
  {
    const auto begin = std::partition_point(ascending.begin(), ascending.end(),
                                            [&, value = value](Index v) { return values[v] < value; });
    const auto end =
      std::partition_point(begin, ascending.end(), [&, value = value](Index v) { return !(value < values[v]); });
    const double next = end == ascending.end() ? infinity : values[*end];
    const double room = (std::min)({tied.largest_change, largest_spread, (next - value) / 2});
    const auto size = static_cast<double>(2 * tied.saddles.size() + 1);
    std::size_t number_of_steps = 0;
    for(auto it = begin; it != end; ++it)
    {
      const bool is_step = it != begin && (tied.saddles.count(*it) != 0 || tied.saddles.count(it[-1]) != 0);
      number_of_steps += is_step ? 1 : 0;
      if(number_of_steps != 0)
        spread[*it] = format.rounded(value + room * (static_cast<double>(number_of_steps) / size));
      if((is_step && !(spread[it[-1]] < spread[*it])) || !(spread[*it] < next || number_of_steps == 0))
        throw Perturbed_ties_error(complex.position(Vertex_index(*it)));
    }
  }
  return spread;
}

// By node, the number of its vertex.
template <class MeshNumbers, class ReebGraph>
std::vector<Index> vertices_of_nodes(const MeshNumbers& numbers, const ReebGraph& graph)
{
  std::vector<Index> result;
  result.reserve(num_vertices(graph));
  for(const auto node : CGAL::make_range(vertices(graph)))
    result.push_back(numbers.number_of(graph[node].vertex).number());
  return result;
}

// By vertex of a node, the distance to the next value of another node.
inline std::vector<double> rooms_of_nodes(const std::vector<Index>& nodes, const std::vector<double>& values)
{
  std::vector<double> rooms(values.size(), std::numeric_limits<double>::infinity());
  for(std::size_t node = 1; node < nodes.size(); ++node)
  {
    const double room = values[nodes[node]] - values[nodes[node - 1]];
    for(const Index v : {nodes[node - 1], nodes[node]})
    {
      if(room > 0)
        rooms[v] = (std::min)(rooms[v], room);
    }
  }
  return rooms;
}

// Whether a graph is the simplified one, if nodes are told by the place of their vertices, `place_of_node(node)`. A
// node at which several saddles are in one vertex may have come apart into a tree of nodes in the same place.
template <class ReebGraph, class SimplifiedGraph, class PlaceOfNode>
bool is_simplified_graph(const ReebGraph& graph, const SimplifiedGraph& simplified, const PlaceOfNode& place_of_node)
{
  std::vector<std::pair<std::size_t, std::size_t>> arcs, expected_arcs;
  std::vector<bool> is_found(num_vertices(simplified), false);
  for(std::size_t node = 0; node != num_vertices(graph); ++node)
  {
    const std::size_t place = place_of_node(node);
    if(place >= num_vertices(simplified))
      return false;
    const bool is_minimum = in_degree(node, graph) == 0, is_maximum = out_degree(node, graph) == 0;
    if((is_minimum && in_degree(place, simplified) != 0) || (is_maximum && out_degree(place, simplified) != 0))
      return false;
    is_found[place] = true;
  }
  std::size_t number_of_trees = num_vertices(graph);
  Disjoint_sets<Index> trees(static_cast<Index>(num_vertices(graph)));
  for(const auto arc : CGAL::make_range(edges(graph)))
  {
    const std::size_t lower = place_of_node(source(arc, graph)), upper = place_of_node(target(arc, graph));
    if(lower != upper)
    {
      arcs.emplace_back(lower, upper);
      continue;
    }
    if(!trees.unite(static_cast<Index>(source(arc, graph)), static_cast<Index>(target(arc, graph))))
      return false; // a loop
    --number_of_trees;
  }
  for(const auto arc : CGAL::make_range(edges(simplified)))
    expected_arcs.emplace_back(source(arc, simplified), target(arc, simplified));
  std::sort(arcs.begin(), arcs.end());
  std::sort(expected_arcs.begin(), expected_arcs.end());
  return number_of_trees == num_vertices(simplified) && arcs == expected_arcs
      && std::find(is_found.begin(), is_found.end(), false) == is_found.end();
}

// With perturbed ties, a removed piece is moved next to its saddle. `nodes` are the vertices of the nodes.
template <class Complex>
std::vector<double> perturbed_values(const Complex& complex,
                                     const std::vector<Index>& nodes,
                                     std::vector<Index> saddles, // at first, nodes
                                     const std::vector<double>& values,
                                     double threshold,
                                     Number_format format)
{
  for(Index& saddle : saddles)
    saddle = saddle == no_index ? no_index : nodes[saddle];
  const auto graph = edge_graph(complex);
  const std::vector<double> spread =
    spread_ties(complex, values, find_tied_saddles(graph, saddles, values, format.rounded(threshold)), format);
  const std::vector<double> rooms = rooms_of_nodes(nodes, spread);
  return Moved_pieces<Complex>(complex, graph, saddles, rooms, spread, threshold, format).move();
}

#define CGAL_REEB_GRAPH_PERTURBED_VALUES(PREFIX, COMPLEX)                                                              \
  PREFIX template std::vector<double> perturbed_values(const COMPLEX&, const std::vector<Index>&, std::vector<Index>,  \
                                                       const std::vector<double>&, double, Number_format);
CGAL_REEB_GRAPH_FOR_SURFACES(CGAL_REEB_GRAPH_PERTURBED_VALUES)

// Computes the graph with the places of the vertices, by their numbers.
template <class Graph, class FlatField, class NamedParameters>
Place_of_vertex compute_with_places(const FlatField& flat_field,
                                    Graph& graph,
                                    const NamedParameters& np,
                                    const Stage_progress& progress)
{
  const auto flat_mesh = flat_field.flat_values(flat_field.mesh())->mesh;
  const auto& numbers = flat_mesh->numbers;
  Place_of_vertex places(flat_mesh->complex.number_of_vertices(), no_index);
  const auto place_map = boost::make_function_property_map<typename FlatField::key_type, Index&>(
    [&](const auto& v) -> Index& { return places[numbers.number_of(v)]; });
  const auto np_of_graph = np.callback(progress.callback());
  compute_reeb_graph(
    flat_field.mesh(), flat_field, graph,
    Reeb_parameters<decltype(place_map), vertex_place_map_t, decltype(np_of_graph)>(place_map, np_of_graph));
  return places;
}

// The values of the simplified field, by number of the vertex; see simplify_field(). They are those of `flat_field`
// then, if the graph has been computed again to see that it is the simplified one. `places` are those in the given graph.
template <class Branch, class Graph, class FlatField, class NamedParameters>
auto simplified_values(FlatField& flat_field,
                       const Graph& graph,
                       const Place_of_vertex& places,
                       double threshold,
                       const NamedParameters& np,
                       const Stage_progress& progress)
{
  typedef typename FlatField::value_type Scalar;
  const auto& mesh = flat_field.mesh();
  const auto flat_mesh = flat_field.flat_values(mesh)->mesh;
  const auto& numbers = flat_mesh->numbers;
  const Leaf_pruning pruned = prune_graph<Branch>(graph, threshold, np);
  const std::vector<Index> saddles_of_places = pruned.find_saddles();
  std::vector<Index> saddles;
  saddles.reserve(places.size());
  for(const Index place : places)
    saddles.push_back(place == no_index ? no_index : saddles_of_places[place]);
  const auto& field = flat_field.flat_values(mesh)->field;
  std::vector<Scalar> values(places.size());
  if(internal::parameter_or(np, ties, Ties::PERTURB) == Ties::CONTRACT)
  {
    // A removed piece is part of the plateau of its saddle. Nothing can be in the way: the contour of the saddle and the
    // piece are connected, and no other edge crosses another level than before.
    for(std::size_t v = 0; v != values.size(); ++v)
      values[v] = saddles[v] == no_index ? field.value(Vertex_index(v)) : graph[saddles[v]].value;
    return values;
  }
  if constexpr(std::is_floating_point_v<Scalar> && has_exact_keys<Scalar, std::less<Scalar>>)
  {
    Graph simplified, graph_of_moved;
    const auto simplification = write_simplified_graph(graph, pruned, simplified);
    const std::vector<double> moved = perturbed_values(flat_mesh->complex, vertices_of_nodes(numbers, graph),
                                                       std::move(saddles), {field.keys().begin(), field.keys().end()},
                                                       threshold, Number_format(std::is_same_v<Scalar, float>));
    std::transform(moved.begin(), moved.end(), values.begin(), [](double value) { return static_cast<Scalar>(value); });
    progress(0.75);
    flat_field.set_values(boost::make_function_property_map<typename FlatField::key_type>(
      [&](const auto& v) { return values[numbers.number_of(v).number()]; }));
    compute_reeb_graph(mesh, flat_field, graph_of_moved, parameters::callback(progress.part(0.75, 1).callback()));
    const std::vector<Index> nodes = vertices_of_nodes(numbers, graph_of_moved);
    const auto place_of_node = [&](std::size_t node) {
      const Index place = places[Vertex_index(nodes[node])];
      return place < num_vertices(graph) ? simplification.index_of_node(place)
                                         : simplification.index_of_arc(place - num_vertices(graph));
    };
    if(!is_simplified_graph(graph_of_moved, simplified, place_of_node))
      throw Perturbed_ties_error("a removed piece has a border or a handle that makes a loop of its own");
    return values;
  }
  else
    throw Perturbed_ties_error("the values are neither of type double nor float");
}

// Writes them, and returns the largest difference. find_graph(flat field, progress) returns the given graph, or a
// reference to it, and the places of the vertices there.
template <class Mesh, class ScalarMap, class SimplifiedScalarMap, class NamedParameters, class FindGraph>
double write_simplified_field(const Mesh& mesh,
                              const ScalarMap& scalar_map,
                              double threshold,
                              const SimplifiedScalarMap& simplified_scalar_map,
                              const NamedParameters& np,
                              const FindGraph& find_graph)
{
  if(internal::parameter_or(np, cancel_loops, false))
    throw Parameter_error("loops of a field cannot be cancelled, but only those of a graph");
  const Progress progress(np);
  progress.report(0);
  auto flat_field = make_flat_field(mesh, scalar_map, np);
  const auto given = find_graph(flat_field, Stage_progress(progress, 0.1, 0.6));
  typedef std::decay_t<decltype(given.first)> Graph;
  typedef Branch<typename boost::graph_traits<Graph>::vertex_descriptor> Branch;
  const auto values =
    simplified_values<Branch>(flat_field, given.first, given.second, threshold, np, Stage_progress(progress, 0, 0.98));
  double largest_difference = 0;
  const auto flat_mesh = flat_field.flat_values(mesh)->mesh;
  for(const Vertex_index number : flat_mesh->complex.vertices())
  {
    if(!flat_mesh->complex.has_vertex(number))
      continue;
    const auto v = flat_mesh->numbers.vertices[number];
    const auto& value = values[number.number()];
    largest_difference =
      (std::max)(largest_difference, persistence(CGAL::to_double(get(scalar_map, v)), CGAL::to_double(value)));
    put(simplified_scalar_map, v, value);
  }
  progress.report_end();
  return largest_difference;
}

} // namespace CGAL::Reeb_graph::internal

#endif // CGAL_REEB_GRAPH_SIMPLIFICATION_INTERNAL_SIMPLIFIED_VALUES_H
