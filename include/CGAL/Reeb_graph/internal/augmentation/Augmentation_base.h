// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_INTERNAL_AUGMENTATION_AUGMENTATION_BASE_H
#define CGAL_REEB_GRAPH_INTERNAL_AUGMENTATION_AUGMENTATION_BASE_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/Contour.h>
#include <CGAL/Reeb_graph/Vertex_locations.h>
#include <CGAL/Reeb_graph/augmentation_exceptions.h>
#include <CGAL/Reeb_graph/exceptions.h>
#include <CGAL/Reeb_graph/internal/arcs/find_arcs.h>
#include <CGAL/Reeb_graph/internal/arcs/reduce_arcs.h>
#include <CGAL/Reeb_graph/internal/base/Index.h>
#include <CGAL/Reeb_graph/internal/base/Large_vector.h>
#include <CGAL/Reeb_graph/internal/base/Progress.h>
#include <CGAL/Reeb_graph/internal/critical_vertices/classify_vertices.h>
#include <CGAL/Reeb_graph/internal/mesh/Vertex_order.h>
#include <CGAL/Reeb_graph/internal/mesh/flatten.h>
#include <CGAL/Reeb_graph/internal/walks/Level.h>
#include <CGAL/Reeb_graph/internal/walks/contour_tracing.h>
#include <CGAL/Reeb_graph/named_parameters.h>
#include <CGAL/Reeb_graph/simplification_parameters.h>
#include <CGAL/Reeb_graph_traits.h>

#include <CGAL/boost/graph/iterator.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Reeb_graph {
namespace internal {

// The type of the named parameter geom_traits, or else the default.
template <class FaceListGraph,
          class ScalarMap,
          class NamedParameters,
          class Default = Reeb_graph_traits<FaceListGraph, ScalarMap>>
using Chosen_traits = std::decay_t<decltype(parameters::choose_parameter<Default>(
  parameters::get_parameter(std::declval<const NamedParameters&>(), internal_np::geom_traits)))>;

// What Augmentation does, on the flat surface. See there.
template <class FaceListGraph, class ScalarMap, class ReebGraph, class Traits>
class Augmentation_base
{
protected:
  typedef typename Traits::Scalar Scalar;
  typedef typename boost::graph_traits<FaceListGraph>::vertex_descriptor vertex_descriptor;
  typedef typename boost::graph_traits<FaceListGraph>::halfedge_descriptor halfedge_descriptor;
  typedef typename boost::graph_traits<FaceListGraph>::face_descriptor face_descriptor;
  typedef typename boost::graph_traits<ReebGraph>::vertex_descriptor node_descriptor;
  typedef typename boost::graph_traits<ReebGraph>::edge_descriptor arc_descriptor;
  typedef Vertex_order<Scalar, typename Traits::Less_scalar> Order;
  typedef Reeb_graph::Contour<arc_descriptor, halfedge_descriptor> Contour;
  typedef Reeb_graph::Vertex_locations<vertex_descriptor, ReebGraph> Vertex_locations;

  struct Valued_level
  {
    Level<Scalar, Order> is_below;
    double value;
  };

  template <class NamedParameters>
  Augmentation_base(const FaceListGraph& mesh,
                    const ScalarMap& scalar_map,
                    const ReebGraph& graph,
                    const NamedParameters& np)
    : mesh_(mesh),
      graph_(graph),
      traits_(parameters::choose_parameter<Traits>(parameters::get_parameter(np, internal_np::geom_traits))),
      ties_(parameters::choose_parameter(parameters::get_parameter(np, ties), Ties::PERTURB)),
      are_degree_two_nodes_kept_(
        parameters::choose_parameter(parameters::get_parameter(np, keep_degree_two_nodes), false)),
      surface_(flatten<Sequential_tag>(mesh, scalar_map, traits_, np)),
      order_(surface_.values, traits_.less_scalar_object()),
      position_(find_vertex_numbers(mesh, surface_.vertices, np)),
      new_places_(read_new_places(parameters::get_parameter(np, simplification)))
  {
    static_assert(std::is_same_v<Chosen_traits<FaceListGraph, ScalarMap, NamedParameters, Traits>, Traits>,
                  "The last template parameter of Augmentation must be the type of the named parameter geom_traits.");
    check_nodes();
    check_arcs();
  }

  Augmentation_base(const Augmentation_base&) = delete;
  Augmentation_base& operator=(const Augmentation_base&) = delete;

  const FaceListGraph& mesh() const { return mesh_; }
  const ReebGraph& graph() const { return graph_; }
  auto arcs() const { return CGAL::make_range(edges(graph_)); }

  void check_parameter(double t) const
  {
    if(!(t > 0 && t < 1))
      throw Parameter_error(t);
  }

  void check_node(node_descriptor node) const
  {
    if(node >= num_vertices(graph_))
      throw Unknown_node_error();
  }

  void check_arc(arc_descriptor arc) const
  {
    const node_descriptor lower = source(arc, graph_), upper = target(arc, graph_);
    if(lower >= num_vertices(graph_) || upper >= num_vertices(graph_))
      throw Unknown_arc_error();
    const auto is_in = [&](const auto& range) { return std::find(range.first, range.second, arc) != range.second; };
    // Nodes of high degree mostly have neighbors of low degree.
    const bool is_known = out_degree(lower, graph_) < in_degree(upper, graph_) ? is_in(out_edges(lower, graph_))
                                                                               : is_in(in_edges(upper, graph_));
    if(!is_known)
      throw Unknown_arc_error();
  }

  bool is_alive_at(arc_descriptor arc, const Scalar& value) const
  {
    return !order_.is_higher(lower_vertex(arc), value) && order_.is_higher(upper_vertex(arc), value);
  }

  Valued_level level_of_value(const Scalar& value) const
  {
    return {Level<Scalar, Order>::above_value(order_, value), CGAL::to_double(value)};
  }

  Valued_level level_below_node(node_descriptor node) const
  {
    const Vertex_index v = node_vertex(node);
    return {ties_ == Ties::CONTRACT ? Level<Scalar, Order>::below_value(order_, surface_.values[v])
                                    : Level<Scalar, Order>::below_vertex(order_, v),
            value_of(v)};
  }

  Valued_level level_above_node(node_descriptor node) const
  {
    const Vertex_index v = node_vertex(node);
    return {ties_ == Ties::CONTRACT ? Level<Scalar, Order>::above_value(order_, surface_.values[v])
                                    : Level<Scalar, Order>::above_vertex(order_, v),
            value_of(v)};
  }

  Valued_level level_of_parameter(arc_descriptor arc, double t) const
  {
    const double lower = value_of(lower_vertex(arc)), upper = value_of(upper_vertex(arc));
    const auto& chain = graph_[arc].chain;
    const std::size_t step = (std::min)(static_cast<std::size_t>(t * chain.size()), chain.size() - 1);
    return level_between(arc, lower + t * (upper - lower), position_(source(chain[step], mesh_)));
  }

  // The piece of a chain that is used ends where the next one begins: the last halfedge of a piece overshoots.
  template <class ParametrizationMap>
  Valued_level level_of_parameter(arc_descriptor arc, double t, const ParametrizationMap& parametrization) const
  {
    const auto& chain = graph_[arc].chain;
    const double scale = 0.5 / static_cast<double>(chain.size()); // so that no sum is infinite
    const auto scaled_value = [&](vertex_descriptor v) {
      const double value = static_cast<double>(get(parametrization, v));
      if(!std::isfinite(value))
        throw Non_finite_scalar_error(surface_.vertices.position(position_(v)));
      return scale * value;
    };
    std::vector<double> sums = {0};
    for(std::size_t i = 0; i != chain.size(); ++i)
    {
      const double difference = scaled_value(target(chain[i], mesh_)) - scaled_value(source(chain[i], mesh_));
      sums.push_back(sums.back() + std::abs(difference) * used_fraction(arc, i));
    }
    const double sum = t * sums.back();
    if(!(sum > 0))
      return level_of_parameter(arc, t);
    const std::size_t step =
      (std::min)(std::size_t(std::lower_bound(sums.begin() + 1, sums.end(), sum) - sums.begin()), chain.size()) - 1;
    const double fraction = used_fraction(arc, step) * (sum - sums[step]) / (sums[step + 1] - sums[step]);
    const Vertex_index from = position_(source(chain[step], mesh_)), to = position_(target(chain[step], mesh_));
    return level_between(arc, value_of(from) + fraction * (value_of(to) - value_of(from)), from);
  }

  Contour trace(arc_descriptor arc, const Valued_level& level) const
  {
    return trace_from(arc, find_start(arc, level.is_below), level);
  }

  // A halfedge of a triangle on the edge at which the chain of the arc crosses the level. Chains can overlap where a
  // piece ends; then the later one is inside the arc.
  Halfedge_index find_start(arc_descriptor arc, const Level<Scalar, Order>& is_below) const
  {
    const auto& chain = graph_[arc].chain;
    const auto first_above = std::partition_point(chain.begin() + 1, chain.end(),
                                                  [&](halfedge_descriptor h) { return is_below(checked_source(h)); });
    const halfedge_descriptor h = first_above[-1];
    if(!is_below(checked_source(h)) || is_below(checked_source(opposite(h, mesh_))))
      throw Graph_mismatch_error();
    return number_of(h);
  }

  Contour trace_from(arc_descriptor arc, Halfedge_index start, const Valued_level& level) const
  {
    Contour contour;
    contour.arc = arc;
    contour.value = level.value;
    Large_vector<Halfedge_index> crossed;
    contour.is_closed = trace_oriented_contour(surface_.complex, start, level.is_below, crossed);
    contour.halfedges.reserve(crossed.size());
    for(const Halfedge_index halfedge : crossed)
    {
      const bool is_target_below = level.is_below(surface_.complex.target(halfedge));
      const Halfedge_index ascending = is_target_below ? opposite_of(halfedge) : halfedge;
      contour.halfedges.push_back(surface_.halfedges(mesh_, ascending));
    }
    return contour;
  }

  // Where the value lies on an ascending halfedge: 0 at its source, 1 at its target, in the middle if that is unclear.
  double crossing_fraction(halfedge_descriptor h, double value) const
  {
    const double lower = value_of(position_(source(h, mesh_))), upper = value_of(position_(target(h, mesh_)));
    const double fraction = (value - lower) / (upper - lower);
    return std::isfinite(fraction) ? (std::min)((std::max)(fraction, 0.), 1.) : 0.5;
  }

  std::vector<face_descriptor> star(node_descriptor node) const
  {
    std::vector<face_descriptor> faces;
    surface_.complex.for_each_halfedge_around(node_vertex(node), [&](Halfedge_index halfedge) {
      faces.push_back(face(surface_.halfedges(mesh_, halfedge), mesh_));
    });
    std::reverse(faces.begin(), faces.end()); // counterclockwise
    return faces;
  }

  std::vector<halfedge_descriptor> border_loop(node_descriptor node) const
  {
    std::vector<halfedge_descriptor> loop;
    const Vertex_index v = node_vertex(node);
    if(!surface_.complex.is_on_border(v))
      return loop;
    const Halfedge_index along_border = opposite_of(surface_.complex.first_halfedge(v));
    const halfedge_descriptor first = surface_.halfedges(mesh_, along_border);
    halfedge_descriptor h = first;
    do
    {
      if(!order_.are_tied(v, position_(target(h, mesh_))))
        return {};
      loop.push_back(h);
      h = next(h, mesh_);
    } while(h != first);
    return loop;
  }

  // With all vertices in the place of the critical ones, the engine finds the arc between critical vertices that each
  // regular vertex is on; merging those arcs gives the graph once more, and says what has become of them.
  template <class ConcurrencyTag>
  Vertex_locations make_vertex_locations() const
  {
    const Swept_vertices all_vertices = sort_all_vertices<ConcurrencyTag>(surface_.complex, order_);
    const Flat_graph all_arcs = reduce_arcs<ConcurrencyTag>(
      surface_.complex, order_, all_vertices,
      find_arcs<ConcurrencyTag>(surface_.complex, order_, all_vertices, Method::CONTOUR_TREES, 1, No_progress()),
      Ties::PERTURB, true, true);
    const Swept_vertices critical_vertices = classify_vertices<ConcurrencyTag>(surface_.complex, order_);
    check_nodes_are_critical(all_arcs, critical_vertices);
    Slab_arcs critical_arcs;
    for(const Flat_arc& arc : all_arcs.arcs)
      critical_arcs.push_back({node_of(critical_vertices.ascending()[arc.lower.number()]),
                               node_of(critical_vertices.ascending()[arc.upper.number()]),
                               all_arcs.pieces[arc.first_piece].first_step});
    const Flat_graph flat_graph = reduce_arcs<ConcurrencyTag>(surface_.complex, order_, critical_vertices,
                                                              critical_arcs, ties_, are_degree_two_nodes_kept_, true);
    check_same_graph(flat_graph);

    // A place is a number: nodes come first, then arcs.
    const auto new_place = [&](Index place) { return new_places_.empty() ? place : new_places_[place]; };
    const auto place_of_arc = [&](Arc_index arc, Vertex_index vertex) {
      if(arc == no_index)
        surface_.complex.throw_contradiction_near(vertex);
      return new_place(static_cast<Index>(flat_graph.nodes.size()) + arc.number());
    };
    const auto place_of_critical = [&](Swept_index critical) {
      const Node_index node = flat_graph.node_of_critical[critical];
      return node != no_index ? new_place(node.number())
                              : place_of_arc(flat_graph.arc_of_critical[critical], critical_vertices.vertex(critical));
    };
    // On a plateau, a vertex is where the end of its arc is.
    const auto place_on_arc = [&](Vertex_index vertex, Arc_index arc) {
      if(arc == no_index)
        surface_.complex.throw_contradiction_near(vertex);
      const Slab_arc& critical_arc = critical_arcs[Slab_arc_index(arc.number())];
      if(ties_ == Ties::CONTRACT && order_.are_tied(vertex, critical_vertices.vertex(critical_arc.lower_vertex())))
        return place_of_critical(critical_arc.lower_vertex());
      if(ties_ == Ties::CONTRACT && order_.are_tied(vertex, critical_vertices.vertex(critical_arc.upper_vertex())))
        return place_of_critical(critical_arc.upper_vertex());
      return place_of_arc(flat_graph.arc_of_critical_arc[Slab_arc_index(arc.number())], vertex);
    };

    checked_index(flat_graph.nodes.size() + flat_graph.arcs.size());
    std::vector<std::pair<vertex_descriptor, Index>> sorted_places;
    sorted_places.reserve(all_vertices.size());
    for(const Swept_index i : all_vertices.ascending())
    {
      const Vertex_index vertex = all_vertices.vertex(i);
      const Node_index critical = all_arcs.node_of_critical[i];
      sorted_places.emplace_back(surface_.vertices[vertex],
                                 critical != no_index
                                   ? place_of_critical(critical_vertices.ascending()[critical.number()])
                                   : place_on_arc(vertex, all_arcs.arc_of_critical[i]));
    }
    const auto arc_range = edges(graph_);
    return Vertex_locations(position_, surface_.vertices.size(), num_vertices(graph_),
                            std::vector<arc_descriptor>(arc_range.first, arc_range.second), sorted_places);
  }

private:
  Vertex_index node_vertex(node_descriptor node) const { return position_(graph_[node].vertex); }
  Vertex_index lower_vertex(arc_descriptor arc) const { return node_vertex(source(arc, graph_)); }
  Vertex_index upper_vertex(arc_descriptor arc) const { return node_vertex(target(arc, graph_)); }
  // The source of a halfedge that may be one of another mesh.
  Vertex_index checked_source(halfedge_descriptor h) const
  {
    if(!can_be_halfedge(mesh_, h))
      throw Graph_mismatch_error();
    const Vertex_index v = position_(source(h, mesh_));
    if(v.number() >= surface_.vertices.size())
      throw Graph_mismatch_error();
    return v;
  }

  double value_of(Vertex_index v) const { return CGAL::to_double(surface_.values[v]); }

  // The level of the value, if that is inside the arc. If it has been rounded up to the upper end, it is the last level
  // of lower values; if values do not tell, because they are tied or infinite, it is next to a vertex of the chain.
  // With another order than that of numbers, values can fall along an arc.
  Valued_level level_between(arc_descriptor arc, double value, Vertex_index chain_vertex) const
  {
    const Vertex_index upper = upper_vertex(arc);
    const double lower_end = value_of(lower_vertex(arc)), upper_end = value_of(upper);
    const bool is_falling = upper_end < lower_end;
    const bool is_rounded_up = is_falling ? value <= upper_end : value >= upper_end;
    if(!is_rounded_up && (is_falling ? value <= lower_end : value >= lower_end))
    {
      // For integers, the vertices below 2.5 are those below 2.
      const double rounded = is_falling ? std::ceil(value) : std::floor(value);
      const Scalar scalar = static_cast<Scalar>(std::is_integral<Scalar>::value ? rounded : value);
      if(is_alive_at(arc, scalar))
        return {Level<Scalar, Order>::above_value(order_, scalar), value};
    }
    const Scalar& upper_value = surface_.values[upper];
    const bool is_chain_vertex_lower = order_.is_lower(chain_vertex, upper_value);
    if(is_chain_vertex_lower ? is_rounded_up && std::isfinite(value) : ties_ == Ties::CONTRACT)
      return {Level<Scalar, Order>::below_value(order_, upper_value), upper_end};
    return {ties_ == Ties::CONTRACT ? Level<Scalar, Order>::above_value(order_, surface_.values[chain_vertex])
                                    : Level<Scalar, Order>::above_vertex(order_, chain_vertex),
            value_of(chain_vertex)};
  }

  // The part of halfedge i of the chain that is below the upper node, and below the next piece of the chain.
  double used_fraction(arc_descriptor arc, std::size_t i) const
  {
    const auto& chain = graph_[arc].chain;
    const vertex_descriptor end =
      i + 1 == chain.size() ? graph_[target(arc, graph_)].vertex : source(chain[i + 1], mesh_);
    return end == target(chain[i], mesh_) ? 1 : crossing_fraction(chain[i], value_of(position_(end)));
  }

  // The number of h or of its opposite, whichever has a triangle.
  Halfedge_index number_of(halfedge_descriptor h) const
  {
    Halfedge_index result = no_index;
    surface_.complex.visit_edges_around(position_(source(h, mesh_)), [&](Vertex_index, Halfedge_index halfedge) {
      const halfedge_descriptor around = surface_.halfedges(mesh_, halfedge);
      if(around != h && around != opposite(h, mesh_))
        return false;
      result = halfedge;
      return true;
    });
    return result;
  }

  void check_nodes() const
  {
    const auto mesh_vertices = vertices(mesh_);
    if(num_vertices(graph_) == 0 && mesh_vertices.first != mesh_vertices.second)
      throw Graph_mismatch_error();
    Vertex_index lower_vertex = no_index;
    for(const node_descriptor node : CGAL::make_range(vertices(graph_)))
    {
      const Vertex_index v = node_vertex(node);
      const bool is_vertex = v.number() < surface_.vertices.size() && surface_.vertices.contains(v)
                          && surface_.vertices[v] == graph_[node].vertex;
      if(!is_vertex || order_.is_lower(v, graph_[node].value) || order_.is_higher(v, graph_[node].value)
         || (lower_vertex != no_index && !order_(lower_vertex, v)))
        throw Graph_mismatch_error();
      lower_vertex = v;
    }
  }

  // With other ties than those of the graph, the levels next to a node could miss its arcs.
  void check_arcs() const
  {
    for(const arc_descriptor arc : arcs())
    {
      const Vertex_index lower = lower_vertex(arc), upper = upper_vertex(arc);
      if(!order_(lower, upper) || graph_[arc].chain.empty())
        throw Graph_mismatch_error();
      const Vertex_index first = checked_source(graph_[arc].chain.front());
      const bool fits =
        ties_ == Ties::CONTRACT ? order_.are_tied(lower, first) && !order_.are_tied(lower, upper) : lower == first;
      if(!fits)
        throw Graph_mismatch_error();
    }
  }

  // With an order that contradicts itself, a regular vertex can be a node.
  void check_nodes_are_critical(const Flat_graph& all_arcs, const Swept_vertices& critical_vertices) const
  {
    for(const Node_index node : all_arcs.nodes.keys())
    {
      const Vertex_index vertex = all_arcs.nodes[node].vertex;
      const std::size_t place = node.number();
      if(place >= critical_vertices.size() || critical_vertices.vertex(critical_vertices.ascending()[place]) != vertex)
        surface_.complex.throw_contradiction_near(vertex);
    }
  }

  // The places in this graph of the nodes, and behind them the arcs, of the one that has been simplified to it. None if
  // it is not a simplified one.
  template <class Parameter>
  static std::vector<Index> read_new_places(const Parameter& parameter)
  {
    std::vector<Index> places;
    if constexpr(is_given<Parameter>)
    {
      for(std::size_t node = 0; node != parameter.number_of_old_nodes(); ++node)
        places.push_back(static_cast<Index>(parameter.index_of_node(node)));
      for(std::size_t arc = 0; arc != parameter.number_of_old_arcs(); ++arc)
        places.push_back(static_cast<Index>(parameter.index_of_arc(arc)));
    }
    return places;
  }

  void check_same_graph(const Flat_graph& flat_graph) const
  {
    if(!(new_places_.empty() ? is_same_graph(flat_graph) : is_simplified_graph(flat_graph)))
      throw Graph_mismatch_error();
  }

  bool is_same_graph(const Flat_graph& flat_graph) const
  {
    bool is_same = flat_graph.nodes.size() == num_vertices(graph_) && flat_graph.arcs.size() == num_edges(graph_);
    for(std::size_t node = 0; is_same && node != flat_graph.nodes.size(); ++node)
      is_same = flat_graph.nodes[Node_index(node)].vertex == node_vertex(node);
    auto flat_arc = flat_graph.arcs.begin();
    for(auto arc = edges(graph_).first; is_same && flat_arc != flat_graph.arcs.end(); ++arc, ++flat_arc)
      is_same = source(*arc, graph_) == flat_arc->lower.number() && target(*arc, graph_) == flat_arc->upper.number();
    return is_same;
  }

  // Each of its nodes is one that is in its own place.
  bool is_simplified_graph(const Flat_graph& flat_graph) const
  {
    const std::size_t number_of_places = num_vertices(graph_) + num_edges(graph_);
    if(new_places_.size() != flat_graph.nodes.size() + flat_graph.arcs.size()
       || std::any_of(new_places_.begin(), new_places_.end(), [&](Index place) { return place >= number_of_places; }))
      return false;
    std::size_t number_of_nodes = 0;
    for(std::size_t node = 0; node != flat_graph.nodes.size(); ++node)
    {
      const Index place = new_places_[node];
      if(place < num_vertices(graph_) && node_vertex(place) == flat_graph.nodes[Node_index(node)].vertex)
        ++number_of_nodes;
    }
    return number_of_nodes == num_vertices(graph_);
  }

  const FaceListGraph& mesh_;
  const ReebGraph& graph_;
  const Traits traits_;
  const Ties ties_;
  const bool are_degree_two_nodes_kept_;
  const Flat_surface<FaceListGraph, Scalar> surface_;
  const Order order_;
  const std::function<Vertex_index(vertex_descriptor)> position_;
  const std::vector<Index> new_places_;
};

} // namespace internal
} // namespace Reeb_graph
} // namespace CGAL

#endif // CGAL_REEB_GRAPH_INTERNAL_AUGMENTATION_AUGMENTATION_BASE_H
