// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_AUGMENTATION_H
#define CGAL_REEB_GRAPH_AUGMENTATION_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/Contour.h>
#include <CGAL/Reeb_graph/exceptions.h>
#include <CGAL/Reeb_graph/internal/base/Index.h>
#include <CGAL/Reeb_graph/internal/base/Progress.h>
#include <CGAL/Reeb_graph/internal/base/Threads.h>
#include <CGAL/Reeb_graph/internal/base/interpolation.h>
#include <CGAL/Reeb_graph/internal/base/requirements.h>
#include <CGAL/Reeb_graph/internal/complex/Flat_mesh.h>
#include <CGAL/Reeb_graph/internal/way_back/Graph_on_mesh.h>
#include <CGAL/Reeb_graph/named_parameters.h>
#include <CGAL/Reeb_graph/options.h>
#include <CGAL/Reeb_graph_traits.h>

#include <CGAL/Iterator_range.h>
#include <CGAL/boost/graph/iterator.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <memory>
#include <string>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

namespace CGAL::Reeb_graph {

/// \ingroup PkgReebGraphAugmentation
///
/// \brief the place of each vertex of the mesh in the Reeb graph, and the vertices of each arc and node.
///
/// It is made by `Augmentation::locate_vertices()`. The vertices of arcs and nodes are sorted when they are asked for
/// the first time, in \f$ O(n \log n) \f$ for \f$ n \f$ vertices of the mesh; several threads may ask at a time. It can
/// outlive the `Augmentation` and the mesh, but holds copies of the arc descriptors and of a `vertex_index_map`: as
/// long as it is used, the graph must not lose arcs, and the map must stay valid. `get(vertex_places, v)` is the
/// same as `vertex_places[v]`.
///
/// \tparam VertexDescriptor a vertex descriptor of the mesh
/// \tparam ReebGraph the type of the Reeb graph
///
/// \cgalModels{ReadablePropertyMap}
template <class VertexDescriptor, class ReebGraph>
class Vertex_places
{
public:
  typedef typename boost::graph_traits<ReebGraph>::vertex_descriptor node_descriptor; ///< a node of the graph
  typedef typename boost::graph_traits<ReebGraph>::edge_descriptor arc_descriptor;    ///< an arc of the graph

  /// a node or an arc: `std::holds_alternative<arc_descriptor>(place)`, `std::get<arc_descriptor>(place)`
  typedef std::variant<node_descriptor, arc_descriptor> Place;

  typedef VertexDescriptor key_type;                            ///< the key type
  typedef Place value_type;                                     ///< the value type
  typedef Place reference;                                      ///< the same
  typedef boost::readable_property_map_tag category;            ///< the category
  typedef Iterator_range<const VertexDescriptor*> Vertex_range; ///< the type of a range of vertices

  /// returns the place of the vertex `v`: the node that it belongs to, or the arc that passes it.
  ///
  /// \exception Unknown_vertex_error if the mesh had no such vertex
  Place operator[](VertexDescriptor v) const
  {
    const std::size_t place = index(v);
    if(place < number_of_nodes_)
      return node_descriptor(place);
    return arcs_[place - number_of_nodes_];
  }

  /// returns the number of the place of the vertex `v`: nodes are numbered from 0 by their descriptors, arcs after the
  /// last node, in the order of `edges(graph)`.
  ///
  /// \exception Unknown_vertex_error if the mesh had no such vertex
  std::size_t index(VertexDescriptor v) const
  {
    const internal::Vertex_index position = position_(v);
    if(!places_->contains(position) || (*places_)[position] == internal::no_index)
      throw Unknown_vertex_error();
    return (*places_)[position];
  }

  /// returns the vertices of a node in ascending order. It has more than one if ties are contracted.
  Vertex_range vertices_of_node(node_descriptor node) const { return (*lists_)(node); }

  /// returns the vertices of the arc number `i`, in the order of `edges(graph)`, in ascending order. That is the arc of
  /// the vertices whose `index()` is the number of nodes plus `i`.
  Vertex_range vertices_of_arc(std::size_t i) const { return (*lists_)(number_of_nodes_ + i); }

  /// returns the place of `v`.
  friend Place get(const Vertex_places& places, VertexDescriptor v) { return places[v]; }

#ifndef DOXYGEN_RUNNING
  Vertex_places(std::function<internal::Vertex_index(VertexDescriptor)> position,
                std::size_t number_of_nodes,
                std::vector<arc_descriptor> arcs,
                std::shared_ptr<const internal::Place_of_vertex> places,
                std::shared_ptr<const internal::Vertex_lists<VertexDescriptor>> lists)
    : position_(std::move(position)),
      number_of_nodes_(number_of_nodes),
      arcs_(std::move(arcs)),
      places_(std::move(places)),
      lists_(std::move(lists))
  {}
#endif

private:
  std::function<internal::Vertex_index(VertexDescriptor)> position_;
  std::size_t number_of_nodes_;
  std::vector<arc_descriptor> arcs_;
  std::shared_ptr<const internal::Place_of_vertex> places_; // nodes come first, then arcs
  std::shared_ptr<const internal::Vertex_lists<VertexDescriptor>> lists_;
};

/// \ingroup PkgReebGraphAugmentation
///
/// \brief the way from a Reeb graph back to a mesh, to a triangle soup, or to tetrahedra: the contours of arcs, the
/// critical sets of nodes, and the place of each vertex in the graph.
///
/// It implements the map \f$ F: R(M, f) \to M \f$ of \cgalCite{hr-edrprg-20}, Section 6. `Augmentation`,
/// `Soup_augmentation` and `Tetrahedra_augmentation` are names of it for each kind of input, which tell what they are
/// constructed from. What a contour is differs, but not how it is read: see `Crossed_edges`. So a function that takes a
/// `Basic_augmentation` runs on all three.
///
/// The graph has to outlive it and must not change. It can be neither copied nor moved. All member functions can be
/// called from several threads at a time. Those that return contours throw `Graph_mismatch_error` if the chain of an
/// arc does not lead to them, and for an arc or a node that is none of the graph. `Unknown_vertex_error` is thrown for a
/// vertex that is none of the mesh.
///
/// \tparam GraphOnMesh unspecified: a graph with the cells that it is of: the faces of a mesh, triangles, or tetrahedra
template <class GraphOnMesh>
class Basic_augmentation
{
public:
  /// the mesh; for a soup and for tetrahedra, an unspecified type that has its edges
  typedef typename GraphOnMesh::Mesh Mesh;
  /// the graph
  typedef typename GraphOnMesh::Graph Graph;
  /// a scalar value
  typedef typename GraphOnMesh::Scalar Scalar;
  /// a vertex of the mesh; for a soup and for tetrahedra, its number, a `std::size_t`
  typedef typename GraphOnMesh::vertex_descriptor vertex_descriptor;
  /// a halfedge of the mesh; for a soup and for tetrahedra, the pair of its source and its target
  typedef typename GraphOnMesh::halfedge_descriptor halfedge_descriptor;
  /// a node of the graph
  typedef typename GraphOnMesh::node_descriptor node_descriptor;
  /// an arc of the graph
  typedef typename GraphOnMesh::arc_descriptor arc_descriptor;

  /// a contour: `Reeb_graph::Contour` on a mesh, `Soup_contour` in triangles, `Isosurface_patch` in tetrahedra
  typedef typename GraphOnMesh::Contour Contour;
  /// a critical set: a `Reeb_graph::Critical_set`
  typedef typename GraphOnMesh::Critical_set Critical_set;
  /// the places of all vertices
  typedef Reeb_graph::Vertex_places<vertex_descriptor, Graph> Vertex_places;

  /// returns the mesh.
  const Mesh& mesh() const { return on_mesh_.mesh(); }
  /// returns the graph.
  const Graph& graph() const { return on_mesh_.graph(); }

  /// \brief returns the value of the vertex `v` as that of a contour: as a `double`, NaN if the values of the field are
  /// no numbers.
  double value(vertex_descriptor v) const { return on_mesh_.value(internal::checked_number(on_mesh_, v)); }

  /// \brief returns the contour of an arc at a place between its ends.
  ///
  /// The values along the arc are parametrized linearly, `t` = 0 at the lower node and `t` = 1 at the upper one. The
  /// contour is one of the arc for any `t`; where no value lies between those of the ends, or values are not numbers,
  /// the vertices of the chain are counted instead.
  ///
  /// \exception Parameter_error if `t` is not greater than 0 and less than 1
  Contour contour(arc_descriptor arc, double t) const { return contour_at_parameter(arc, t); }

  /// \brief returns the contour of an arc at a place between its ends, parametrized by another field.
  ///
  /// The absolute differences of the values of `parametrization` along the chain of the arc are added up: `t` is the
  /// fraction of the whole sum. With a field of unit gradient and the same level sets, equal steps of `t` are equal
  /// distances on the surface. If the sum is 0, the result is the same as without `parametrization`. It takes time
  /// linear in the length of the chain as well.
  ///
  /// \tparam ParametrizationMap a model of `ReadablePropertyMap` with the vertices as key type, and a value type that
  ///         can be converted to `double`
  ///
  /// \exception Parameter_error if `t` is not greater than 0 and less than 1
  /// \exception Non_finite_scalar_error if a value along the chain is infinite or NaN
  template <class ParametrizationMap>
  Contour contour(arc_descriptor arc, double t, ParametrizationMap parametrization) const
  {
    return contour_at_parameter(arc, t, parametrization);
  }

  /// \brief returns the contour of an arc at the level just above the last vertex of value at most `value`.
  ///
  /// \exception Parameter_error if the arc has no contour at that level: its lower node must not be higher, and its upper
  ///            node must be higher than `value`
  Contour contour_at_value(arc_descriptor arc, const Scalar& value) const
  {
    internal::check_is_arc(graph(), arc);
    return checked_trace(arc, level_at_value(value));
  }

  /// \brief returns the contour of an arc at the level just below a vertex, which the contour need not be near. Just
  /// below the upper node of the arc, it is one of the critical set of that.
  ///
  /// \exception Parameter_error if the arc has no contour at that level: its lower node must be lower than `v`, and its
  ///            upper node must not be; if ties are contracted, in value
  Contour contour_below(arc_descriptor arc, vertex_descriptor v) const
  {
    return contour_beside(internal::Side::LOWER, arc, v);
  }

  /// \brief returns the contour of an arc at the level just above a vertex, which the contour need not be near. Just
  /// above the lower node of the arc, it is one of the critical set of that.
  ///
  /// \exception Parameter_error if the arc has no contour at that level: its lower node must not be higher than `v`, and
  ///            its upper node must be; if ties are contracted, in value
  Contour contour_above(arc_descriptor arc, vertex_descriptor v) const
  {
    return contour_beside(internal::Side::UPPER, arc, v);
  }

  /// \brief returns the contours of all arcs at the level just above the last vertex of value at most `value`: all
  /// connected components of a level set, in the order of the arcs. It takes time linear in the arcs of the graph, and
  /// for each contour that of `contour()`.
  ///
  /// \tparam ConcurrencyTag `Sequential_tag`, `Parallel_tag`, or `Parallel_if_available_tag`: whether the contours are
  ///         traced in parallel
  template <class ConcurrencyTag = Sequential_tag>
  std::vector<Contour> contours_at_value(const Scalar& value) const
  {
    const Level level = level_at_value(value);
    std::vector<arc_descriptor> arcs;
    std::vector<decltype(find_start(arcs[0], level))> starts;
    for(const arc_descriptor arc : on_mesh_.arcs())
    {
      if(is_crossed(arc, level))
      {
        arcs.push_back(arc);
        starts.push_back(find_start(arc, level));
      }
    }
    std::vector<Contour> contours(arcs.size());
    internal::threads_of<ConcurrencyTag>().for_each_index(
      arcs.size(), [&](std::size_t i) { contours[i] = on_mesh_.trace(arcs[i], starts[i], level); });
    return contours;
  }

  /// \brief returns what a node stands for: the contours just below and just above it that touch it, each with its
  /// arc, its star, and, on a mesh, the border loop that it collapses. It takes the time of `contour()` for each of its
  /// arcs.
  Critical_set critical_set(node_descriptor node) const
  {
    internal::check_is_node(graph(), node);
    const auto contours_of = [&](const auto& arcs, internal::Side side) {
      std::vector<Contour> contours;
      for(const arc_descriptor arc : CGAL::make_range(arcs))
        contours.push_back(trace(arc, level_beside(side, on_mesh_.node_vertex(node))));
      return contours;
    };
    return {contours_of(in_edges(node, graph()), internal::Side::LOWER),
            contours_of(out_edges(node, graph()), internal::Side::UPPER), on_mesh_.star(node),
            on_mesh_.border_loop(node)};
  }

  /// \brief returns where on its edge point number `i` of a contour is, by linear interpolation: 0 at the lower vertex, 1
  /// at the higher one.
  double fraction(const Contour& contour, std::size_t i) const
  {
    return internal::crossing_fraction(on_mesh_, contour.edge(i), contour.value);
  }

  /// \brief writes the points of a contour, by linear interpolation, in the order of its edges.
  ///
  /// \tparam OutputIterator a model of `OutputIterator` for points
  /// \tparam Points for a soup and for tetrahedra, a random access range of the points of the vertices. For a mesh, a
  ///         model of `ReadablePropertyMap` with their points, or \ref bgl_namedparameters "Named Parameters", of which
  ///         `vertex_point_map` counts; by default, they are those of the mesh. All functions that take an augmentation
  ///         and points take them so
  ///
  /// \param contour a contour
  /// \param output the output; the first point is not repeated at the end
  /// \param points the points of the vertices
  ///
  /// \returns the output iterator behind the last point.
  ///
  /// \exception Attribute_count_error if points are a range, and not one for each vertex
  template <class OutputIterator, class Points = parameters::Default_named_parameters>
  OutputIterator points_of_contour(const Contour& contour,
                                   OutputIterator output,
                                   const Points& points = parameters::default_values()) const
  {
    const auto point_map = on_mesh_.point_map(points); // It may return points that do not outlive the descriptor.
    for(std::size_t i = 0; i != contour.number_of_crossings(); ++i)
      *output++ = internal::point_between(get(point_map, source(contour.edge(i), mesh())),
                                          get(point_map, target(contour.edge(i), mesh())), fraction(contour, i));
    return output;
  }

  /// \brief finds the place of each vertex in the graph: the segmentation by the arcs.
  ///
  /// \tparam ConcurrencyTag `Sequential_tag`, `Parallel_tag`, or `Parallel_if_available_tag`
  ///
  /// \param np an optional sequence of \ref bgl_namedparameters "Named Parameters": `callback`, as for
  ///        `compute_reeb_graph()`, and `vertex_place_map`, a model of `ReadablePropertyMap`: the map that
  ///        `compute_reeb_graph()` has written with the graph, before it was simplified if it has been. The places are
  ///        then read from it, in linear time. Only the range of its numbers is checked.
  ///
  /// \exception Graph_mismatch_error if the graph is not the one that has been computed of this input, or if
  ///            `vertex_place_map` has a number that is none of a place
  /// \exception Cancelled_error if `callback` returns `false`
  template <class ConcurrencyTag = Sequential_tag, class NamedParameters = parameters::Default_named_parameters>
  Vertex_places locate_vertices(const NamedParameters& np = parameters::default_values()) const
  {
    return internal::locate_vertices<Vertex_places>(internal::threads_of<ConcurrencyTag>(), on_mesh_, ties_,
                                                    are_degree_two_nodes_kept_, simplified_places_, np);
  }

#ifndef DOXYGEN_RUNNING
  // The cells and the points, for those who measure them.
  const GraphOnMesh& on_mesh() const { return on_mesh_; }

protected:
  // From what a GraphOnMesh is made of besides a traits class, the named parameters, and the progress.
  template <class NamedParameters, class... Input>
  Basic_augmentation(const internal::Progress& progress, const NamedParameters& np, const Input&... input)
    : ties_(internal::parameter_or(np, internal::ties, Ties::PERTURB)),
      are_degree_two_nodes_kept_(internal::parameter_or(np, internal::keep_degree_two_nodes, false)),
      on_mesh_(input..., internal::choose_traits<Traits>(np), np, progress),
      simplified_places_(internal::read_simplified_places(np))
  {
    static_assert(std::is_same_v<internal::Chosen_traits<Traits, NamedParameters>, Traits>,
                  "The last template parameter must be the type of the named parameter geom_traits.");
    internal::check_nodes(on_mesh_);
    internal::check_arcs(on_mesh_, ties_);
    progress.report_end();
  }
#endif

private:
  typedef typename GraphOnMesh::Traits Traits;
  // A level with its value.
  struct Level
  {
    internal::Level is_below;
    double value;
  };

  bool are_ties_contracted() const { return ties_ == Ties::CONTRACT; }

  // The contour at a fraction of the values, or of the differences of another field, along the arc.
  template <class... ParametrizationMap>
  Contour contour_at_parameter(arc_descriptor arc, double t, const ParametrizationMap&... parametrization) const
  {
    internal::check_is_arc(graph(), arc);
    if(!(t > 0 && t < 1))
      throw Parameter_error("the place on an arc must be greater than 0 and less than 1, not " + std::to_string(t));
    return trace(arc, level_at_parameter(arc, t, parametrization...));
  }

  // Just below the vertex, or just above it.
  Contour contour_beside(internal::Side side, arc_descriptor arc, vertex_descriptor v) const
  {
    const Level level = level_beside(side, internal::checked_number(on_mesh_, v));
    internal::check_is_arc(graph(), arc);
    return checked_trace(arc, level);
  }

  // Where the chain of the arc crosses the level. Chains can overlap where a piece ends; then the later one is inside the
  // arc.
  auto find_start(arc_descriptor arc, const Level& level) const
  {
    const auto& chain = on_mesh_.chain(arc);
    const auto is_source_below = [&](const auto& h) { return level.is_below(on_mesh_.checked_source(h)); };
    const auto h = std::partition_point(chain.begin() + 1, chain.end(), is_source_below)[-1];
    if(!is_source_below(h) || level.is_below(on_mesh_.checked_target(h)))
      throw Graph_mismatch_error();
    return on_mesh_.find_start(h);
  }

  Contour trace(arc_descriptor arc, const Level& level) const
  {
    return on_mesh_.trace(arc, find_start(arc, level), level);
  }

  Contour checked_trace(arc_descriptor arc, const Level& level) const
  {
    if(!is_crossed(arc, level))
      throw Parameter_error("the arc has no contour at this level");
    return trace(arc, level);
  }

  // Whether the level crosses the arc.
  bool is_crossed(arc_descriptor arc, const Level& level) const
  {
    return level.is_below(on_mesh_.lower_vertex(arc)) && !level.is_below(on_mesh_.upper_vertex(arc));
  }

  Level level_at_value(const Scalar& value) const
  {
    return {internal::Level(on_mesh_.order(), internal::Side::UPPER, on_mesh_.key_of(value)),
            on_mesh_.conversion().to_double(value)};
  }

  Level level_beside(internal::Side side, internal::Vertex_index v) const
  {
    return {are_ties_contracted() ? internal::Level(on_mesh_.order(), side, on_mesh_.key(v))
                                  : internal::Level(on_mesh_.order(), side, v),
            on_mesh_.value(v)};
  }

  // The level at the fraction t of the values along the arc.
  Level level_at_parameter(arc_descriptor arc, double t) const
  {
    const double lower = on_mesh_.value(on_mesh_.lower_vertex(arc)), upper = on_mesh_.value(on_mesh_.upper_vertex(arc));
    const auto& chain = on_mesh_.chain(arc);
    const std::size_t step =
      (std::min)(static_cast<std::size_t>(t * static_cast<double>(chain.size())), chain.size() - 1);
    return between(arc, internal::value_at_fraction(lower, upper, t), on_mesh_.source_of(chain[step]));
  }

  // The level at the fraction t of the differences of another field, summed up along the chain.
  template <class ParametrizationMap>
  Level level_at_parameter(arc_descriptor arc, double t, const ParametrizationMap& parametrization) const
  {
    const auto& chain = on_mesh_.chain(arc);
    const double scale = 0.5 / static_cast<double>(chain.size()); // so that no sum is infinite
    const auto scaled_value = [&](internal::Vertex_index v) {
      const double value = static_cast<double>(get(parametrization, on_mesh_.vertex(v)));
      if(!std::isfinite(value))
        throw Non_finite_scalar_error(on_mesh_.position(v));
      return scale * value;
    };
    std::vector<double> sums = {0};
    for(std::size_t i = 0; i != chain.size(); ++i)
    {
      const double difference = scaled_value(on_mesh_.target_of(chain[i])) - scaled_value(on_mesh_.source_of(chain[i]));
      sums.push_back(sums.back() + std::abs(difference) * used_fraction(arc, i));
    }
    const double sum = t * sums.back();
    if(!(sum > 0))
      return level_at_parameter(arc, t);
    const std::size_t step =
      (std::min)(std::size_t(std::lower_bound(sums.begin() + 1, sums.end(), sum) - sums.begin()), chain.size()) - 1;
    const double fraction = used_fraction(arc, step) * (sum - sums[step]) / (sums[step + 1] - sums[step]);
    const internal::Vertex_index from = on_mesh_.source_of(chain[step]), to = on_mesh_.target_of(chain[step]);
    return between(arc, internal::value_at_fraction(on_mesh_.value(from), on_mesh_.value(to), fraction), from);
  }

  // The level of the value, if that is inside the arc. If it has been rounded up to the upper end, it is the last level
  // of lower values; if values do not tell, because they are tied or infinite, it is next to a vertex of the chain.
  // With another order than that of numbers, values can fall along an arc.
  Level between(arc_descriptor arc, double value, internal::Vertex_index chain_vertex) const
  {
    const internal::Vertex_index upper = on_mesh_.upper_vertex(arc);
    const double lower_end = on_mesh_.value(on_mesh_.lower_vertex(arc)), upper_end = on_mesh_.value(upper);
    const bool is_falling = upper_end < lower_end;
    const bool is_rounded_up = is_falling ? value <= upper_end : value >= upper_end;
    if(!is_rounded_up && (is_falling ? value <= lower_end : value >= lower_end))
    {
      // For integers, the vertices below 2.5 are those below 2.
      const auto scalar = on_mesh_.conversion().from_double(value, is_falling);
      if(scalar && is_crossed(arc, level_at_value(*scalar)))
        return {level_at_value(*scalar).is_below, value};
    }
    const internal::Level below_upper(on_mesh_.order(), internal::Side::LOWER, on_mesh_.key(upper));
    if(below_upper(chain_vertex) ? is_rounded_up && std::isfinite(value) : are_ties_contracted())
      return {below_upper, upper_end};
    return level_beside(internal::Side::UPPER, chain_vertex);
  }

  // The part of halfedge i of the chain that is used: that below the upper node, and below the next piece of the chain,
  // as the last halfedge of a piece overshoots.
  double used_fraction(arc_descriptor arc, std::size_t i) const
  {
    const auto& chain = on_mesh_.chain(arc);
    const internal::Vertex_index end =
      i + 1 == chain.size() ? on_mesh_.upper_vertex(arc) : on_mesh_.source_of(chain[i + 1]);
    const bool is_all_used = end == on_mesh_.target_of(chain[i]);
    return is_all_used ? 1 : internal::crossing_fraction(on_mesh_, chain[i], on_mesh_.value(end));
  }

  const Ties ties_;
  const bool are_degree_two_nodes_kept_;
  const GraphOnMesh on_mesh_;
  const internal::Simplified_places simplified_places_;
};

/// \ingroup PkgReebGraphAugmentation
///
/// \brief the way from a Reeb graph back to a surface mesh.
///
/// At construction it copies the field, and a mesh that is no `CGAL::Surface_mesh`, in linear time and memory. The mesh
/// has to outlive it as the graph has, and must not change, and neither must what a `vertex_index_map` refers to.
///
/// The contour of an arc takes time linear in its length and in the lower one of the degrees of the ends of the arc,
/// and logarithmic in the length of the chain. Unless the mesh is a `CGAL::Surface_mesh`, the degrees at the halfedge
/// that it starts from count as well. So contours of many arcs at one vertex take hardly longer than those elsewhere.
///
/// Locating vertices takes linear time on a field with few critical vertices, hardly longer than the graph. On noise,
/// sorting all vertices comes on top: near-linear for any field. The named parameter `vertex_place_map` of
/// `compute_reeb_graph()` finds the places without computing anything twice.
///
/// \tparam FaceListGraph a model of `FaceListGraph`
/// \tparam ScalarMap a model of `ReadablePropertyMap` with the vertex descriptors of the mesh as key type. Values that
///         are not numbers are those of contours only if the traits class converts them, see `ReebGraphNumberTraits`
/// \tparam ReebGraph the type `Graph` of the traits class
/// \tparam Traits a model of `ReebGraphTraits`: the type of the named parameter `geom_traits`, if that is given. It is
///         deduced by `Augmentation augmentation(mesh, scalar_map, graph, np)`.
template <class FaceListGraph,
          class ScalarMap,
          class ReebGraph = typename Reeb_graph_traits<FaceListGraph, ScalarMap>::Graph,
          class Traits = Reeb_graph_traits<FaceListGraph, ScalarMap>>
class Augmentation
#ifdef DOXYGEN_RUNNING
  : public Basic_augmentation<unspecified_type>
#else
  : public Basic_augmentation<
      internal::Checked_type<internal::Field_and_graph<FaceListGraph, ScalarMap, ReebGraph, Traits>,
                             internal::Graph_on_mesh<FaceListGraph, ReebGraph, Traits>>>
#endif
{
  typedef Basic_augmentation<internal::Graph_on_mesh<FaceListGraph, ReebGraph, Traits>> Base;

public:
  /// a face of the mesh
  typedef typename boost::graph_traits<FaceListGraph>::face_descriptor face_descriptor;

  /// \brief prepares the way back from `graph` to `mesh`.
  ///
  /// \param mesh the mesh that the graph has been computed of
  /// \param scalar_map the field that it has been computed of
  /// \param graph the graph
  /// \param np the named parameters that the graph has been computed with: `ties`, `keep_degree_two_nodes`,
  ///        `vertex_index_map`, `face_index_map` and `geom_traits` count. `callback` is as for `compute_reeb_graph()`.
  ///        To locate vertices in a graph made by `simplify()`, pass what that has returned as `simplification`
  ///
  /// \exception Graph_mismatch_error if a node is not one of this mesh and field, or an arc none that `ties` gives.
  ///            That all nodes and arcs are there is checked by `locate_vertices()` only.
  ///
  /// and the exceptions of `compute_reeb_graph()`.
  template <class NamedParameters = parameters::Default_named_parameters>
  Augmentation(const FaceListGraph& mesh,
               ScalarMap scalar_map,
               const ReebGraph& graph,
               const NamedParameters& np = parameters::default_values())
    : Base(internal::Progress(np), np, mesh, scalar_map, graph)
  {}

#ifndef DOXYGEN_RUNNING
  // Neither the mesh nor the graph is copied.
  template <class... NamedParameters>
  Augmentation(const FaceListGraph&&, ScalarMap, const ReebGraph&, const NamedParameters&...) = delete;
  template <class... NamedParameters>
  Augmentation(const FaceListGraph&, ScalarMap, const ReebGraph&&, const NamedParameters&...) = delete;
#endif
};

#ifndef DOXYGEN_RUNNING
template <class FaceListGraph, class ScalarMap, class ReebGraph, class NamedParameters>
Augmentation(const FaceListGraph&, ScalarMap, const ReebGraph&, const NamedParameters&)
  -> Augmentation<FaceListGraph,
                  ScalarMap,
                  ReebGraph,
                  internal::Chosen_traits<Reeb_graph_traits<FaceListGraph, ScalarMap>, NamedParameters>>;
#endif

} // namespace CGAL::Reeb_graph

#endif // CGAL_REEB_GRAPH_AUGMENTATION_H
