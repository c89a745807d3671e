// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_CURVES_CUT_TO_DISKS_H
#define CGAL_REEB_GRAPH_CURVES_CUT_TO_DISKS_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/curves/Curve.h>
#include <CGAL/Reeb_graph/curves/internal/Contour_cutting.h>
#include <CGAL/Reeb_graph/curves/internal/cut_and_mark.h>
#include <CGAL/Reeb_graph/internal/base/Index.h>
#include <CGAL/Reeb_graph/internal/base/Progress.h>
#include <CGAL/Reeb_graph/internal/base/arrays.h>
#include <CGAL/Reeb_graph/internal/base/lengths.h>
#include <CGAL/Reeb_graph/internal/complex/Curve_opening.h>
#include <CGAL/Reeb_graph/internal/complex/Flat_mesh.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <functional>
#include <limits>
#include <queue>
#include <utility>
#include <vector>

namespace CGAL::Reeb_graph::internal {

// Finds edges of a surface along which it is cut to disks, one for each component: tree and cotree (J. Erickson and K.
// Whittlesey, Greedy optimal homotopy and homology generators, 2005).
//
// Shortest paths from the border, or from one vertex of a component without, are a tree. The cotree joins all triangles
// of a component across edges that are not in the tree, across those first with the longest way from sources to sources
// through them. What neither crosses nor joins is a graph that cuts the component, with its border, to one disk; edges
// that end nowhere can be left out. A sphere has no others then, and is cut along two.
//
// Where a component has no border, all is done twice, the second time from the vertex at which most edges of the cut
// meet, as the first one can be far from the handles. The shorter cut counts.
template <class Complex>
class Disk_cut
{
  typedef Indexed_vector<Edge_index, bool> Marks;
  typedef std::pair<double, Index> Entry; // a length, and what has it
  typedef std::priority_queue<Entry, std::vector<Entry>, std::greater<Entry>> Queue;

public:
  // The lengths are those of all edges.
  Disk_cut(const Complex& complex, const Indexed_vector<Edge_index, double>& lengths)
    : complex_(complex),
      lengths_(lengths),
      components_(complex.number_of_vertices(), 0),
      sources_(1, Vertex_index(no_index))
  {}

  std::vector<Edge_index> operator()(const Stage_progress& progress)
  {
    find_cut(progress.part(0, 0.5));
    if(sources_.size() > 1)
    {
      const Marks first = is_cut_;
      const std::vector<double> first_lengths = lengths_of_cuts();
      choose_sources();
      find_cut(progress.part(0.5, 1));
      const std::vector<double> second_lengths = lengths_of_cuts();
      for(const Edge_index e : is_cut_.keys())
        if(!(second_lengths[component_of(e)] < first_lengths[component_of(e)]))
          is_cut_[e] = first[e];
    }
    cut_spheres();
    std::vector<Edge_index> edges;
    for(const Edge_index e : is_cut_.keys())
      if(is_cut_[e])
        edges.push_back(e);
    return edges;
  }

private:
  void find_cut(const Stage_progress& progress)
  {
    progress(0);
    find_tree();
    progress(0.4);
    find_cotree();
    progress(0.8);
    remove_dead_ends();
  }

  bool is_inside(Edge_index e) const { return complex_.has_edge(e) && !complex_.is_on_border_edge(even_halfedge(e)); }
  std::size_t component_of(Edge_index e) const { return components_[complex_.target(even_halfedge(e))]; }

  // The number of the triangle of a halfedge.
  Halfedge_index triangle_of(Halfedge_index h) const
  {
    const Halfedge_index second = complex_.next(h), third = complex_.next(second);
    return (std::min)({h, second, third});
  }

  // Grows trees from the border, then from the sources of the components without, which it finds the first time.
  void find_tree()
  {
    distances_.assign(complex_.number_of_vertices(), 0);
    parents_.assign(complex_.number_of_vertices(), no_index);
    is_reached_.assign(complex_.number_of_vertices(), false);
    for(const Vertex_index v : complex_.vertices())
      if(complex_.has_vertex(v) && complex_.is_on_border(v))
        queue_.push({0, v.number()});
    grow_tree(0);
    for(std::size_t component = 1; component != sources_.size(); ++component)
    {
      queue_.push({0, sources_[component].number()});
      grow_tree(component);
    }
    for(const Vertex_index v : complex_.vertices())
    {
      if(is_reached_[v] || !complex_.has_vertex(v) || complex_.first_halfedge(v) == no_index)
        continue;
      queue_.push({0, v.number()});
      sources_.push_back(v);
      grow_tree(sources_.size() - 1);
    }
  }

  // Grows a tree from the vertices in the queue.
  void grow_tree(std::size_t component)
  {
    while(!queue_.empty())
    {
      const auto [distance, number] = queue_.top();
      const Vertex_index v(number);
      queue_.pop();
      if(is_reached_[v])
        continue;
      is_reached_[v] = true;
      components_[v] = component;
      distances_[v] = distance;
      complex_.for_each_edge_around(v, [&, distance = distance](Vertex_index neighbor, Halfedge_index h) {
        const double longer = distance + lengths_[edge_of(h)];
        const bool is_first = parents_[neighbor] == no_index && !complex_.is_on_border(neighbor);
        if(is_reached_[neighbor] || !(is_first || longer < distances_[neighbor]))
          return;
        distances_[neighbor] = longer;
        parents_[neighbor] = edge_of(h);
        queue_.push({longer, neighbor.number()});
      });
    }
  }

  // Edges that are not in the cotree remain.
  void find_cotree()
  {
    Marks is_in_tree(complex_.number_of_edges(), false);
    for(const Edge_index parent : parents_)
      if(parent != no_index)
        is_in_tree[parent] = true;
    is_cut_.assign(complex_.number_of_edges(), false);
    std::vector<Entry> ways;
    for(const Edge_index e : is_cut_.keys())
    {
      is_cut_[e] = is_inside(e);
      if(!is_cut_[e] || is_in_tree[e])
        continue;
      const Halfedge_index h = even_halfedge(e);
      ways.emplace_back(distances_[complex_.source(h)] + lengths_[e] + distances_[complex_.target(h)], e.number());
    }
    std::sort(ways.begin(), ways.end(), std::greater<Entry>());
    Disjoint_sets<Halfedge_index> trees(complex_.number_of_halfedges()); // of triangles
    for(const Entry& way : ways)
    {
      const Halfedge_index h = even_halfedge(Edge_index(way.second));
      if(trees.unite(triangle_of(h), triangle_of(opposite_of(h))))
        is_cut_[edge_of(h)] = false;
    }
  }

  // Leaves out edges at a vertex where the cut meets neither another one nor the border.
  void remove_dead_ends()
  {
    Indexed_vector<Vertex_index, Index> numbers(complex_.number_of_vertices(), 0); // of edges that are there
    for(const Vertex_index v : complex_.vertices())
      if(complex_.has_vertex(v))
        complex_.for_each_edge_around(v, [&](Vertex_index, Halfedge_index h) { numbers[v] += is_bound(h) ? 1 : 0; });
    for(const Vertex_index v : complex_.vertices())
      for(Vertex_index end = v; numbers[end] == 1;)
      {
        Vertex_index following = end;
        complex_.visit_edges_around(end, [&](Vertex_index neighbor, Halfedge_index h) {
          if(!is_bound(h))
            return false;
          is_cut_[edge_of(h)] = false;
          following = neighbor;
          return true;
        });
        --numbers[end];
        --numbers[following];
        end = following;
      }
  }

  // Whether a disk ends at an edge.
  bool is_bound(Halfedge_index h) const { return is_cut_[edge_of(h)] || complex_.is_on_border_edge(h); }

  std::vector<double> lengths_of_cuts() const
  {
    std::vector<double> sums(sources_.size(), 0);
    for(const Edge_index e : is_cut_.keys())
      if(is_cut_[e])
        sums[component_of(e)] += lengths_[e];
    return sums;
  }

  // Takes the vertices at which most edges of the cut meet.
  void choose_sources()
  {
    std::vector<Index> most(sources_.size(), 0);
    for(const Vertex_index v : complex_.vertices())
    {
      Index number = 0;
      if(complex_.has_vertex(v))
        complex_.for_each_edge_around(v,
                                      [&](Vertex_index, Halfedge_index h) { number += is_cut_[edge_of(h)] ? 1 : 0; });
      if(number <= most[components_[v]])
        continue;
      most[components_[v]] = number;
      sources_[components_[v]] = v;
    }
  }

  // Cuts each component that has neither a cut nor a border along the two edges at a vertex that are the shortest ones.
  void cut_spheres()
  {
    std::vector<bool> is_bounded(sources_.size(), false);
    is_bounded[0] = true;
    for(const Edge_index e : is_cut_.keys())
      if(is_cut_[e])
        is_bounded[component_of(e)] = true;
    std::vector<double> least(sources_.size(), std::numeric_limits<double>::infinity()); // lengths of paths
    for(const Vertex_index v : complex_.vertices())
      if(const std::size_t component = components_[v]; !is_bounded[component])
        if(const double length = length_of_path(v); length < least[component])
        {
          least[component] = length;
          sources_[component] = v;
        }
    for(std::size_t component = 0; component != sources_.size(); ++component)
      if(!is_bounded[component])
        for(const Edge_index e : shortest_edges(sources_[component]))
          is_cut_[e] = true;
  }

  double length_of_path(Vertex_index v) const
  {
    const auto edges = shortest_edges(v);
    return lengths_[edges[0]] + lengths_[edges[1]];
  }

  // The two shortest edges at a vertex that lead to different ones.
  std::array<Edge_index, 2> shortest_edges(Vertex_index v) const
  {
    std::array<Edge_index, 2> edges = {no_index, no_index};
    std::array<Vertex_index, 2> ends = {no_index, no_index};
    const auto is_shorter = [&](Edge_index e, Edge_index than) {
      return than == no_index || lengths_[e] < lengths_[than];
    };
    complex_.for_each_edge_around(v, [&](Vertex_index end, Halfedge_index h) {
      const Edge_index e = edge_of(h);
      if(is_shorter(e, edges[0]))
      {
        if(end != ends[0])
        {
          edges[1] = edges[0];
          ends[1] = ends[0];
        }
        edges[0] = e;
        ends[0] = end;
      }
      else if(end != ends[0] && is_shorter(e, edges[1]))
      {
        edges[1] = e;
        ends[1] = end;
      }
    });
    return edges;
  }

  const Complex& complex_;
  const Indexed_vector<Edge_index, double>& lengths_;
  Indexed_vector<Vertex_index, std::size_t>
    components_;                                     // 0 of all that have a border, and of vertices without triangles
  std::vector<Vertex_index> sources_;                // by component; none of those with a border
  Indexed_vector<Vertex_index, double> distances_;   // from the sources
  Indexed_vector<Vertex_index, Edge_index> parents_; // the last edges of shortest paths
  Indexed_vector<Vertex_index, bool> is_reached_;
  Queue queue_;
  Marks is_cut_;
};

// The edges along which a mesh is cut to disks, after it has been checked.
template <class Mesh, class VertexPointMap>
std::vector<typename boost::graph_traits<Mesh>::edge_descriptor> find_disk_cut(const Mesh& mesh,
                                                                               const VertexPointMap& vertex_point_map,
                                                                               const Stage_progress& progress)
{
  const auto flat_mesh = make_flat_mesh(mesh);
  const auto& complex = flat_mesh->complex;
  const auto halfedge_of = [&](Edge_index e) { return flat_mesh->numbers.halfedges(mesh, even_halfedge(e)); };
  Indexed_vector<Edge_index, double> lengths(complex.number_of_edges(), 0);
  for(const Edge_index e : lengths.keys())
  {
    if(!complex.has_edge(e))
      continue;
    const auto h = halfedge_of(e);
    const double length =
      distance_between(get(vertex_point_map, source(h, mesh)), get(vertex_point_map, target(h, mesh)));
    lengths[e] = length >= 0 ? length : 0; // not NaN
  }
  std::vector<typename boost::graph_traits<Mesh>::edge_descriptor> edges;
  for(const Edge_index e : Disk_cut(complex, lengths)(progress))
    edges.push_back(edge(halfedge_of(e), mesh));
  return edges;
}

} // namespace CGAL::Reeb_graph::internal

namespace CGAL::Reeb_graph {

/// \ingroup PkgReebGraphCurves
///
/// \brief cuts each connected component of a mesh to a disk along edges, as it is needed to flatten it.
///
/// Each component has Euler characteristic 1 and one border then, whatever its genus and its borders were. No face is
/// changed, and no point is new: vertices of the cut are doubled, or multiplied where it branches. The cut is a tree of
/// shortest paths and what a spanning tree of the faces does not join, without dead ends: short, but not the shortest
/// one, which is hard to find. A component that is a disk already is not cut. A closed one of genus 0 is cut along two
/// edges at one vertex. Vertices without faces stay as they are.
///
/// The curves are the longest paths of the edges of the cut through vertices at which two of these meet. Along them, the
/// left side keeps halfedges and vertices, which are `halfedges`; the other side gets `lower_halfedges`. Their values
/// are 0.
///
/// It takes \f$ O(n \log n) \f$ time for \f$ n \f$ vertices and faces. See \cgalCite{ew-gohhg-05}.
///
/// \tparam MutableFaceGraph a model of `MutableFaceGraph`
/// \tparam OutputIterator a model of `OutputIterator` for `Reeb_graph::Curve`
/// \tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"
///
/// \param mesh the mesh, which is changed: an oriented manifold surface of triangles. To keep it, pass a copy made by
///        `CGAL::copy_face_graph()`.
/// \param curves the output
/// \param np an optional sequence of \ref bgl_namedparameters "Named Parameters": `edge_is_constrained_map`,
///        `edge_curve_map` and `face_patch_map` as for \ref PkgReebGraphCuttingParameters "cutting along curves", whose
///        pieces are the disks; `visitor` and `callback` as for \ref PkgReebGraphRefinementParameters "refinements",
///        where the visitor is called for vertices and halfedges that are doubled; and those below
///
/// \cgalNamedParamsBegin
///   \reebGraphPoints{ReadWritePropertyMap}
///   \cgalParamNBegin{original_vertex_map}
///     \cgalParamDescription{is set to the vertex of the given mesh that each vertex is, or is a copy of}
///     \cgalParamType{a model of `WritablePropertyMap` with the vertex descriptors as key type and as value type}
///     \cgalParamDefault{none}
///     \cgalParamExtra{use the functions `parameters::original_vertex_map()`}
///   \cgalParamNEnd
/// \cgalNamedParamsEnd
///
/// \reebGraphComplexity
///
/// \returns the output iterator behind the last curve.
///
/// It throws the exceptions of `compute_reeb_graph()` that are not about a field; the mesh is as it was before then.
template <class MutableFaceGraph, class OutputIterator, class NamedParameters = parameters::Default_named_parameters>
OutputIterator cut_to_disks(MutableFaceGraph& mesh,
                            OutputIterator curves,
                            const NamedParameters& np = parameters::default_values())
{
  static_assert(internal::are_met<internal::Refinable_mesh<MutableFaceGraph>>);
  using parameters::get_parameter;
  typedef typename boost::graph_traits<MutableFaceGraph>::halfedge_descriptor halfedge_descriptor;
  const internal::Progress progress(np);
  progress.report(0);
  const auto vertex_point_map =
    internal::parameter_or(np, internal_np::vertex_point, get_property_map(vertex_point, mesh));
  const auto edges = internal::find_disk_cut(mesh, vertex_point_map, internal::Stage_progress(progress, 0.1, 0.8));
  std::vector<Curve<halfedge_descriptor>> found;
  for(auto& path : internal::Edge_tracing(mesh)(edges))
    found.push_back(internal::make_curve(mesh, vertex_point_map, std::move(path), 0));
  progress.report(0.9);

  auto original_map = get_parameter(np, internal::original_vertex_map);
  const auto set_original = [&](auto old, auto created) {
    if constexpr(internal::is_given<decltype(original_map)>)
      put(original_map, created, old);
  };
  for(const auto v : vertices(mesh))
    set_original(v, v);
  auto visitor_parameter = internal::choose_refinement_visitor(mesh, np);
  auto& visitor = internal::unwrap_reference(visitor_parameter);
  internal::Curve_opening open(mesh, vertex_point_map, visitor, set_original);
  open(found);
  internal::mark_edges_and_pieces(mesh, found, np);
  progress.report_end();
  return std::copy(found.begin(), found.end(), curves);
}

} // namespace CGAL::Reeb_graph

#endif // CGAL_REEB_GRAPH_CURVES_CUT_TO_DISKS_H
