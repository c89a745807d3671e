// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_FIELDS_HARMONIC_FIELD_H
#define CGAL_REEB_GRAPH_FIELDS_HARMONIC_FIELD_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/fields/exceptions.h>
#include <CGAL/Reeb_graph/fields/field_constraints.h>
#include <CGAL/Reeb_graph/fields/internal/Indexed_surface.h>
#include <CGAL/Reeb_graph/fields/internal/constraints.h>
#include <CGAL/Reeb_graph/fields/internal/solve.h>
#include <CGAL/Reeb_graph/internal/base/Index.h>
#include <CGAL/Reeb_graph/internal/base/Progress.h>
#include <CGAL/Reeb_graph/internal/base/interpolation.h>
#include <CGAL/Reeb_graph/internal/base/requirements.h>
#include <CGAL/Reeb_graph/internal/complex/Weighted_graph.h>
#include <CGAL/Reeb_graph/named_parameters.h>
#include <CGAL/Reeb_graph/options.h>

#include <CGAL/Named_function_parameters.h>

#include <boost/graph/graph_traits.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL::Reeb_graph::internal::scalar_fields {

// An order of the vertices in which each free one has a lower and a higher neighbor, as close to that of the values as
// this needs. Vertices that are monotone already, those from which a path of strictly falling values and one of
// strictly rising values lead to fixed vertices, stay in the order of their values. Each connected part of the other
// ones, such as a thin leg where the field is flat to all digits, is numbered anew, in one place between two of its
// monotone or fixed neighbors.
//
// Such a place exists: no vertex of a connected surface parts it, as its link is connected. So if some of the
// neighbors become one source and the other ones one sink, the part with both has an st-numbering, in which each
// vertex has a lower and a higher neighbor. The only exception is a part whose neighbors are fixed to one value; it
// is constant.
template <class Scalar>
class Extremum_free_order
{
public:
  Extremum_free_order(const Weighted_graph& graph, const std::vector<bool>& is_fixed, const std::vector<Scalar>& values)
    : graph_(graph),
      is_fixed_(is_fixed),
      values_(values),
      is_monotone_(graph.number_of_vertices(), true)
  {
    find_monotone_vertices();
    if(is_changed())
    {
      place_other_vertices();
      merge();
    }
  }

  // Whether there is a vertex that is not monotone. Only then is there an order.
  bool is_changed() const { return std::find(is_monotone_.begin(), is_monotone_.end(), false) != is_monotone_.end(); }

  // The vertices, from the lowest to the highest one.
  const std::vector<Index>& ascending() const { return ascending_; }

  // Gives the vertices of parts that can have no value but that of the fixed vertices around them this value.
  void set_constant_values(std::vector<Scalar>& values) const
  {
    for(const Part& part : parts_)
      if(part.lower_neighbor == no_index)
        for(const Index v : part.vertices)
          values[v] = part.constant_value;
  }

private:
  // The order by value; of equal values, fixed vertices come first, so that a value is fixed once or not at all.
  bool is_lower(Index u, Index v) const
  {
    return std::make_tuple(values_[u], !is_fixed_[u], u) < std::make_tuple(values_[v], !is_fixed_[v], v);
  }

  template <class IsStrictlyHigher>
  std::vector<bool> reach_from_fixed_vertices(const IsStrictlyHigher& is_strictly_higher) const
  {
    std::vector<bool> is_reached = is_fixed_;
    std::vector<Index> stack;
    for(Index v = 0; v != graph_.number_of_vertices(); ++v)
      if(is_fixed_[v])
        stack.push_back(v);
    while(!stack.empty())
    {
      const Index v = stack.back();
      stack.pop_back();
      for(const auto& n : graph_.neighbors(v))
        if(!is_reached[n.vertex] && is_strictly_higher(values_[n.vertex], values_[v]))
        {
          is_reached[n.vertex] = true;
          stack.push_back(n.vertex);
        }
    }
    return is_reached;
  }

  void find_monotone_vertices()
  {
    const auto is_reached_upwards = reach_from_fixed_vertices([](Scalar a, Scalar b) { return a > b; });
    const auto is_reached_downwards = reach_from_fixed_vertices([](Scalar a, Scalar b) { return a < b; });
    for(Index v = 0; v != graph_.number_of_vertices(); ++v)
      is_monotone_[v] = is_reached_upwards[v] && is_reached_downwards[v];
  }

  struct Part
  {
    std::vector<Index> vertices;     // ascending once the part is placed
    Index lower_neighbor = no_index; // none for a constant part
    Scalar constant_value = 0;
  };

  void place_other_vertices()
  {
    part_of_vertex_.assign(graph_.number_of_vertices(), no_index);
    St_numbering st_numbering(graph_);
    for(Index v = 0; v != graph_.number_of_vertices(); ++v)
    {
      if(is_monotone_[v] || part_of_vertex_[v] != no_index)
        continue;
      const auto number = static_cast<Index>(parts_.size());
      parts_.push_back(collect_part(v, number));
      place(parts_.back(), number, st_numbering);
    }
  }

  Part collect_part(Index first, Index number)
  {
    Part part;
    part.vertices.push_back(first);
    part_of_vertex_[first] = number;
    for(std::size_t i = 0; i != part.vertices.size(); ++i)
      for(const auto& n : graph_.neighbors(part.vertices[i]))
        if(!is_monotone_[n.vertex] && part_of_vertex_[n.vertex] == no_index)
        {
          part_of_vertex_[n.vertex] = number;
          part.vertices.push_back(n.vertex);
        }
    return part;
  }

  // The monotone and fixed vertices next to a part, from the lowest to the highest.
  std::vector<Index> neighbors_of_part(const Part& part) const
  {
    std::vector<Index> result;
    for(const Index v : part.vertices)
      for(const auto& n : graph_.neighbors(v))
        if(is_monotone_[n.vertex])
          result.push_back(n.vertex);
    std::sort(result.begin(), result.end(), [&](Index u, Index v) { return is_lower(u, v); });
    result.erase(std::unique(result.begin(), result.end()), result.end());
    return result;
  }

  // Places a part in the largest gap between the values of its neighbors, where there is the most room.
  void place(Part& part, Index number, St_numbering& st_numbering)
  {
    const std::vector<Index> neighbors = neighbors_of_part(part);
    std::size_t best = 0;
    for(std::size_t i = 1; i < neighbors.size(); ++i)
    {
      const Index u = neighbors[i - 1], v = neighbors[i];
      const bool are_fixed_to_one_value = is_fixed_[u] && is_fixed_[v] && values_[u] == values_[v];
      if(!are_fixed_to_one_value && (best == 0 || gap(neighbors, i) > gap(neighbors, best)))
        best = i;
    }
    if(best == 0)
    {
      part.constant_value = values_[neighbors.front()];
      return;
    }
    const Index lowest_of_upper = neighbors[best];
    part.lower_neighbor = neighbors[best - 1];
    part.vertices = st_numbering(
      part.vertices, [&](Index v) { return part_of_vertex_[v] == number; },
      [&](Index v) { return is_lower(v, lowest_of_upper); });
  }

  Scalar gap(const std::vector<Index>& neighbors, std::size_t i) const
  {
    return values_[neighbors[i]] - values_[neighbors[i - 1]];
  }

  // Merges the parts into the order of the monotone vertices; each follows its lower neighbor.
  void merge()
  {
    std::vector<Index> monotone_vertices;
    for(Index v = 0; v != graph_.number_of_vertices(); ++v)
      if(is_monotone_[v])
        monotone_vertices.push_back(v);
    std::sort(monotone_vertices.begin(), monotone_vertices.end(), [&](Index u, Index v) { return is_lower(u, v); });
    std::vector<std::size_t> next_part(parts_.size(), parts_.size());
    std::vector<std::size_t> first_part(graph_.number_of_vertices(), parts_.size());
    for(std::size_t i = parts_.size(); i-- > 0;)
      if(parts_[i].lower_neighbor != no_index)
      {
        next_part[i] = first_part[parts_[i].lower_neighbor];
        first_part[parts_[i].lower_neighbor] = i;
      }
    ascending_.reserve(graph_.number_of_vertices());
    for(const Index v : monotone_vertices)
    {
      ascending_.push_back(v);
      for(std::size_t i = first_part[v]; i != parts_.size(); i = next_part[i])
        ascending_.insert(ascending_.end(), parts_[i].vertices.begin(), parts_[i].vertices.end());
    }
  }

  const Weighted_graph& graph_;
  const std::vector<bool>& is_fixed_;
  const std::vector<Scalar>& values_;
  std::vector<bool> is_monotone_;
  std::vector<Part> parts_;
  std::vector<Index> part_of_vertex_;
  std::vector<Index> ascending_;
};

// The supports of each free vertex: a neighbor that is to be strictly lower, and one that is to be strictly higher.
struct Supports
{
  std::vector<Index> lower, upper; // no_index for fixed and constant vertices

  template <class Scalar>
  Supports(const Weighted_graph& graph, const std::vector<bool>& is_fixed, const Extremum_free_order<Scalar>& order)
    : lower(graph.number_of_vertices(), no_index),
      upper(graph.number_of_vertices(), no_index)
  {
    std::vector<Index> ranks(graph.number_of_vertices(), no_index);
    Index rank = 0;
    for(const Index v : order.ascending())
      ranks[v] = rank++;
    const auto is_lower = [&](const auto& a, const auto& b) { return ranks[a.vertex] < ranks[b.vertex]; };
    for(const Index v : order.ascending())
      if(!is_fixed[v])
      {
        const auto neighbors = graph.neighbors(v);
        const auto lowest_and_highest = std::minmax_element(neighbors.begin(), neighbors.end(), is_lower);
        lower[v] = lowest_and_highest.first->vertex;
        upper[v] = lowest_and_highest.second->vertex;
      }
  }
};

// Sweeps over the vertices upwards, and raises each to `move` of its lower support, and its upper support to that of
// it; or sweeps downwards, and lowers them.
template <class Scalar, class Move>
std::vector<Scalar> sweep(Side begin,
                          const std::vector<Index>& ascending,
                          const Supports& supports,
                          std::vector<Scalar> values,
                          const Move& move)
{
  const bool is_upwards = begin == Side::LOWER;
  const std::vector<Index>&before = is_upwards ? supports.lower : supports.upper,
        &behind = is_upwards ? supports.upper : supports.lower;
  const auto push = [&](Index v, Index support) {
    const Scalar bound = move(values[support]);
    values[v] = is_upwards ? (std::max)(values[v], bound) : (std::min)(values[v], bound);
  };
  for(std::size_t i = 0; i != ascending.size(); ++i)
  {
    const Index v = ascending[is_upwards ? i : ascending.size() - 1 - i];
    if(before[v] == no_index)
      continue;
    push(v, before[v]);
    if(before[behind[v]] != no_index)
      push(behind[v], v);
  }
  return values;
}

// Moves values of free vertices as little as it takes, so that each has a neighbor of strictly lower and one of
// strictly higher value. Without rounding to neighboring numbers it would be the least in the maximum norm: the mean
// of the lowest monotone function above the values and of the highest one below them.
template <class Scalar>
void remove_extrema(const Weighted_graph& graph, const std::vector<bool>& is_fixed, std::vector<Scalar>& values)
{
  const Extremum_free_order<Scalar> order(graph, is_fixed, values);
  if(!order.is_changed())
    return;
  const Supports supports(graph, is_fixed, order);
  const auto& ascending = order.ascending();
  constexpr Scalar infinity = std::numeric_limits<Scalar>::infinity();
  const auto same = [](Scalar value) { return value; };
  const auto next_above = [](Scalar value) { return std::nextafter(value, infinity); };
  const auto next_below = [](Scalar value) { return std::nextafter(value, -infinity); };
  std::vector<Scalar> lowest = values, highest = values;
  for(const Index v : ascending)
    if(!is_fixed[v])
    {
      lowest[v] = -infinity;
      highest[v] = infinity;
    }
  lowest = sweep(Side::LOWER, ascending, supports, std::move(lowest), next_above);
  highest = sweep(Side::UPPER, ascending, supports, std::move(highest), next_below);

  const std::vector<Scalar> above = sweep(Side::LOWER, ascending, supports, values, same);
  const std::vector<Scalar> below = sweep(Side::UPPER, ascending, supports, values, same);
  for(const Index v : ascending)
  {
    if(is_fixed[v])
      continue;
    if(!(lowest[v] <= highest[v]))
      throw Scalar_resolution_error(v);
    if(above[v] != below[v])
      values[v] = above[v] / 2 + below[v] / 2;
  }
  for(const Index v : ascending)
    if(!is_fixed[v])
      values[v] = (std::min)((std::max)(values[v], lowest[v]), highest[v]);
  values = sweep(Side::LOWER, ascending, supports, std::move(values), next_above);
  order.set_constant_values(values);
}

// The fixed values, mapped linearly to those from 0 to 1.
template <class Scalar>
struct Unit_range
{
  double lowest, highest;

  explicit Unit_range(const Constraints<Scalar>& constraints)
  {
    lowest = std::numeric_limits<double>::infinity();
    highest = -lowest;
    for(std::size_t v = 0; v != constraints.values.size(); ++v)
      if(constraints.is_fixed[v])
      {
        lowest = (std::min)(lowest, static_cast<double>(constraints.values[v]));
        highest = (std::max)(highest, static_cast<double>(constraints.values[v]));
      }
    if(highest >= lowest && (std::isinf(lowest) || std::isinf(highest)))
      throw Linear_solver_error();
  }

  double to_unit(Scalar value) const { return lowest < highest ? crossing_fraction(lowest, highest, value) : 0; }
  Scalar from_unit(double t) const { return static_cast<Scalar>(value_at_fraction(lowest, highest, t)); }
};

// The harmonic field with the values that fix_vertices(surface, graph, constraints) gives, and without extrema at free
// vertices.
template <class FaceListGraph, class FieldMap, class NamedParameters, class FixVertices>
Field_report write_harmonic_field(const FaceListGraph& mesh,
                                  FieldMap field_map,
                                  const NamedParameters& np,
                                  const FixVertices& fix_vertices)
{
  typedef Scalar_of_field<FieldMap> Scalar;
  const auto weights = internal::parameter_or(np, internal::laplacian_weights, Laplacian_weights::MEAN_VALUE);
  const auto solve = [&](const Indexed_surface& surface, const Weighted_graph& graph,
                         const Constraints<Scalar>& constraints, const Stage_progress& progress, Field_report& report) {
    const Unit_range<Scalar> range(constraints);
    std::vector<double> fixed_values(graph.number_of_vertices(), 0);
    for(Index v = 0; v != graph.number_of_vertices(); ++v)
      if(constraints.is_fixed[v])
        fixed_values[v] = range.to_unit(constraints.values[v]);
    progress(0);
    const Stage_progress solution_progress = progress.part(0, 0.9);
    const Dirichlet_solution solution =
      solve_dirichlet_problem({surface, graph, weights, constraints.is_fixed, fixed_values, solution_progress}, 1, np);
    report.number_of_iterations = solution.number_of_steps;
    std::vector<Scalar> values = constraints.values;
    for(Index v = 0; v != graph.number_of_vertices(); ++v)
      if(!constraints.is_fixed[v])
        values[v] = range.from_unit(solution.values[v]);
    check_finite(values);
    progress(0.9);
    remove_extrema(graph, constraints.is_fixed, values);
    progress(1);
    return values;
  };
  return write_solution<Scalar>(mesh, field_map, weights, np, fix_vertices, solve);
}

} // namespace CGAL::Reeb_graph::internal::scalar_fields

namespace CGAL::Reeb_graph {

/// \ingroup PkgReebGraphFields
///
/// \brief computes the harmonic field with given values at some vertices.
///
/// The field solves the Laplace equation \f$ \sum_j w_{ij} (f_j - f_i) = 0 \f$ at each vertex \f$ v_i \f$ whose value
/// is not given, with the sum over its neighbors. See \cgalCite{hr-edrprg-20}, Section 8.1.
///
/// <b>There is no local extremum but at the vertices whose values are given</b>, on any mesh and with any weights.
/// After rounding each other vertex has a neighbor of strictly lower and one of strictly higher value, even where the
/// solution is flat to all digits, and even if faces have no area. So with two given values a closed surface of genus
/// \f$ g \f$ has exactly one minimum, one maximum, and saddles of total multiplicity \f$ 2g \f$. The only exception are
/// parts of the surface around which all given values are the same, so that the solution is constant there. Where the
/// plain solution keeps the promise, it is the result; elsewhere values are moved as little as it takes.
///
/// From 5000 vertices on, the equations are solved by iteration: stabilized bi-conjugate gradients, with algebraic
/// multigrid as preconditioner. On most meshes that takes ten to twenty steps, whatever the number of vertices
/// \f$ n \f$, and time and memory in proportion to it, plus \f$ O(n \log n) \f$ time. Where it takes too many steps,
/// as on meshes of needles, and on small meshes, a matrix is factorized, in about \f$ O(n^{3/2}) \f$ time and
/// \f$ O(n \log n) \f$ memory. Computing it again gives the same field, to the byte.
///
/// \tparam FaceListGraph a model of `FaceListGraph`, with triangles as faces
/// \tparam FieldMap a model of `WritablePropertyMap` with the vertex descriptors of the mesh as key type, and a value
///         type that can be constructed from `double`. For `float`, the promise holds after rounding to `float`.
/// \tparam ConstraintRange a range of pairs of a vertex descriptor and a number
/// \tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"
///
/// \param mesh the triangulated surface, with or without border; it is only read
/// \param field_map the result
/// \param constraints vertices with their values, at least one in each connected component; for whole border cycles
///        see `fix_border_cycle()`
/// \param np an optional sequence of \ref bgl_namedparameters "Named Parameters" among the ones listed below
///
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{laplacian_weights}
///     \cgalParamDescription{the weights \f$ w_{ij} \f$}
///     \cgalParamType{`Reeb_graph::Laplacian_weights`}
///     \cgalParamDefault{`Reeb_graph::Laplacian_weights::MEAN_VALUE`}
///     \cgalParamExtra{use the function `parameters::laplacian_weights()`}
///   \cgalParamNEnd
///   \cgalParamNBegin{sparse_linear_solver}
///     \cgalParamDescription{a solver that takes the place of multigrid and of the default factorization. All matrices
///                           that it gets are symmetric and, unless there are negative weights, diagonally dominant.}
///     \cgalParamType{a model of `SparseLinearAlgebraWithFactorTraits_d`}
///     \cgalParamDefault{multigrid on large meshes; else `Eigen_solver_traits` with `Eigen::SimplicialLDLT`. Both need
///                       the macro `CGAL_EIGEN3_ENABLED`.}
///   \cgalParamNEnd
///   \cgalParamNBegin{solver_tolerance}
///     \cgalParamDescription{the error at which iteration stops, as a part of the range of the field. It is estimated
///                           by the preconditioner; on bad meshes it can be a hundred times as large.}
///     \cgalParamType{a positive `double`}
///     \cgalParamDefault{10<sup>-12</sup>, so that 10<sup>-10</sup> is kept on bad meshes too. A digit takes about one
///                       step, so 10<sup>-6</sup> saves an eighth of the time only; and errors above the differences
///                       between neighbors make extrema that have to be removed.}
///     \cgalParamExtra{It is not used where the matrix itself is factorized: small meshes and solvers that are given,
///                     but for mean value weights.}
///     \cgalParamExtra{use the function `parameters::solver_tolerance()`}
///   \cgalParamNEnd
///   \cgalParamNBegin{callback}
///     \cgalParamDescription{is called between the steps with the fraction that is done; `false` stops, but for the
///                           last call, with 1}
///     \cgalParamType{a function object that takes a `double` and returns a `bool`}
///     \cgalParamDefault{a function that returns `true`}
///   \cgalParamNEnd
///   \cgalParamNBegin{vertex_point_map}
///     \cgalParamDescription{a property map from the vertices to their points}
///     \cgalParamType{a model of `ReadablePropertyMap` with points of a \cgal kernel as value type}
///     \cgalParamDefault{`get(CGAL::vertex_point, mesh)`}
///   \cgalParamNEnd
/// \cgalNamedParamsEnd
///
/// \pre The mesh is a triangulated surface, and each connected component has a vertex with a given value.
///
/// \reebGraphComplexity
///
/// \returns what was changed because of bad faces, see `Field_report`; uniform weights need no geometry
///
/// \exception Non_triangular_face_error if a face is not a triangle
/// \exception Degenerate_face_error if a face has one vertex at two corners
/// \exception Edge_without_face_error if an edge is on no face
/// \exception Non_manifold_vertex_error if the faces of a vertex form more than one fan
/// \exception Mesh_size_error if there are too many vertices or face corners for 32-bit indices
/// \exception Non_finite_point_error if a coordinate is infinite or NaN
/// \exception Unknown_vertex_error if a vertex of `constraints` is not one of the mesh
/// \exception Contradictory_constraints_error if a vertex gets two different values
/// \exception Unconstrained_component_error if a component has no vertex with a given value
/// \exception Non_finite_scalar_error if a given value, or one of the result, is infinite or NaN
/// \exception Scalar_resolution_error if there are fewer numbers between the given values than the promise needs
/// \exception Solver_tolerance_error if `solver_tolerance` is not a positive number
/// \exception Linear_solver_error if the solver fails
/// \exception Cancelled_error if `callback` returns `false`
///
/// When one of these is thrown, `field_map` is as it was before.
template <class FaceListGraph,
          class FieldMap,
          class ConstraintRange,
          class NamedParameters = parameters::Default_named_parameters>
Field_report compute_harmonic_field(const FaceListGraph& mesh,
                                    FieldMap field_map,
                                    const ConstraintRange& constraints,
                                    const NamedParameters& np = parameters::default_values())
{
  namespace fields = internal::scalar_fields;
  return fields::write_harmonic_field(mesh, field_map, np, [&](const auto& surface, const auto&, auto& fixed) {
    fields::fix_vertices(surface, constraints, fixed);
  });
}

/// \ingroup PkgReebGraphFields
///
/// \brief computes the harmonic field that is 0 at the vertex `lowest` and 1 at the vertex `highest` of a connected
/// mesh.
///
/// It is `compute_harmonic_field()` with these two constraints, and has its result and exceptions.
///
/// \pre The mesh is connected.
///
/// \param mesh the mesh; it is only read
/// \param field_map the result
/// \param lowest the vertex of value 0
/// \param highest the vertex of value 1
/// \param np the named parameters of `compute_harmonic_field()`
///
/// \reebGraphComplexity
template <class FaceListGraph, class FieldMap, class NamedParameters = parameters::Default_named_parameters>
Field_report compute_harmonic_field_between(const FaceListGraph& mesh,
                                            FieldMap field_map,
                                            typename boost::graph_traits<FaceListGraph>::vertex_descriptor lowest,
                                            typename boost::graph_traits<FaceListGraph>::vertex_descriptor highest,
                                            const NamedParameters& np = parameters::default_values())
{
  typedef typename boost::graph_traits<FaceListGraph>::vertex_descriptor vertex_descriptor;
  const std::array<std::pair<vertex_descriptor, double>, 2> constraints = {{{lowest, 0.}, {highest, 1.}}};
  return compute_harmonic_field(mesh, field_map, constraints, np);
}

/// \ingroup PkgReebGraphFields
///
/// \brief computes the harmonic field that is 0 and 1 at two vertices of each component that are far apart.
///
/// The two are those of `find_far_apart_vertices()`. An isolated vertex gets the value 0. The result and the exceptions
/// are those of `compute_harmonic_field()`.
///
/// \param mesh the mesh; it is only read
/// \param field_map the result
/// \param np the named parameters of `compute_harmonic_field()`
///
/// \reebGraphComplexity
template <class FaceListGraph, class FieldMap, class NamedParameters = parameters::Default_named_parameters>
Field_report compute_harmonic_field_between_far_apart_vertices(const FaceListGraph& mesh,
                                                               FieldMap field_map,
                                                               const NamedParameters& np = parameters::default_values())
{
  namespace fields = internal::scalar_fields;
  return fields::write_harmonic_field(mesh, field_map, np, [](const auto& surface, const auto& graph, auto& fixed) {
    for(const auto& [lowest, highest] : fields::far_apart_vertices(surface, graph))
    {
      fixed.fix(lowest, 0);
      if(highest != lowest)
        fixed.fix(highest, 1);
    }
  });
}

/// \ingroup PkgReebGraphFields
///
/// \brief computes the harmonic field whose extrema are the borders of the mesh, so that they are levels, as
/// `cutting_system()`, `pants_decomposition()` and `branch_curves()` need it.
///
/// In each connected component, the field is 0 on the first border component and 1 on the other ones, in the order of
/// their first vertices. If there is one border, the field is 1 at a vertex far from it, or 0 all over where all
/// vertices are on it. If there is none, it is 0 and 1 at the two vertices of `find_far_apart_vertices()`. An isolated
/// vertex gets the value 0. Borders at 1 that share edges are one plateau.
///
/// The template parameters, the result, and the exceptions are those of `compute_harmonic_field()`.
///
/// \param mesh the mesh; it is only read
/// \param field_map the result
/// \param np the named parameters of `compute_harmonic_field()`
///
/// \reebGraphComplexity
template <class FaceListGraph, class FieldMap, class NamedParameters = parameters::Default_named_parameters>
Field_report compute_harmonic_field_between_borders(const FaceListGraph& mesh,
                                                    FieldMap field_map,
                                                    const NamedParameters& np = parameters::default_values())
{
  static_assert(internal::are_met<internal::Mesh_with_vertex_map<FaceListGraph, FieldMap>>);
  return compute_harmonic_field(mesh, field_map, internal::scalar_fields::fix_borders(mesh, np), np);
}

} // namespace CGAL::Reeb_graph

#endif // CGAL_REEB_GRAPH_FIELDS_HARMONIC_FIELD_H
