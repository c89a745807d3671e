// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_FIELDS_MAKE_BORDERS_LEVEL_H
#define CGAL_REEB_GRAPH_FIELDS_MAKE_BORDERS_LEVEL_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/fields/internal/level_border_values.h>
#include <CGAL/Reeb_graph/internal/base/Progress.h>
#include <CGAL/Reeb_graph/internal/base/Scalar_conversion.h>
#include <CGAL/Reeb_graph/named_parameters.h>
#include <CGAL/Reeb_graph_traits.h>

#include <CGAL/Named_function_parameters.h>

#include <cstddef>

namespace CGAL::Reeb_graph {

/// \ingroup PkgReebGraphFields
///
/// \brief what `make_borders_level()` has changed.
struct Border_level_changes
{
  std::size_t number_of_borders = 0;          ///< all border components of the mesh
  std::size_t number_of_changed_borders = 0;  ///< those of which a value has been changed
  std::size_t number_of_changed_vertices = 0; ///< on borders and beside them
  double largest_change = 0;                  ///< the largest absolute difference of a new value and the given one
};

/// \ingroup PkgReebGraphFields
///
/// \brief changes a field so that each border component lies in one level and is an extremum of the surface, as
/// `cutting_system()`, `pants_decomposition()` and `branch_curves()` need it.
///
/// All vertices of a border get one value, which is higher than those of all vertices next to it, or lower. Of the
/// values that are, it is the one nearest to those of the border. Maximum or minimum is what changes less, if
/// `border_extremum()` does not say which. A border that has one value already, with no neighbor below it or with none
/// above it, keeps it.
///
/// - <b>Borders that touch each other</b>, that is, share an edge, become extrema of opposite kinds, the maximum above
///   the minimum, where that can be. Where it cannot, as for three borders each of which touches the other two, those
///   of one kind that touch share one level. So there is a result for each mesh, also for an annulus or a disk without
///   inner vertices, which becomes constant. A border that is an extremal level already changes only if those that
///   touch it leave it no choice.
/// - <b>In a collar</b> around the borders that have been changed, extrema that the change would make are removed
///   again. It consists of all vertices on no border that are at most `collar_width()` edges away. The basin of a new
///   minimum is filled to just above its lowest pass, so that each of its vertices has a lower and a higher neighbor;
///   that of a new maximum is cut down likewise. All other values in the collar stay. So the only new critical points
///   are the borders, and the saddles that belong to them by the Euler characteristic. An extremum stays, and nothing
///   changes for it, if its pass is outside of the collar, or tied with the next vertex around the basin. It also stays
///   if the pass is beyond the border: for instance, if a border at the bottom of a valley becomes a maximum.
///
/// <b>How much changes:</b> Values outside of the collar stay as they are. With \f$ r \f$ for the range of the values
/// of a border and the vertices next to it, no value of the border changes by more than \f$ (1 + 1/1024)\, r \f$ if it
/// touches no other border. A vertex beside it moves by at most 17/16 of the depth of its basin, once for each basin
/// that it is in.
///
/// It takes \f$ O(n \log n + c \log c) \f$ time for \f$ n \f$ vertices, where \f$ c \f$ is the sum of the numbers of
/// vertices in the basins and next to them.
///
/// \tparam FaceListGraph a model of `FaceListGraph` with dynamic property maps
/// \tparam ScalarMap a model of `ReadWritePropertyMap` with the vertex descriptors of the mesh as key type, and with a
///         value type of numbers, or one that `geom_traits` makes numbers of. If it is not a built-in floating-point
///         type, or is ordered by another function object, there is no arithmetic. Then a border gets a value of one of
///         its vertices or of those next to them. It has no higher neighbor, or no lower one, but can have equal ones,
///         and nothing else changes.
/// \tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"
///
/// \param mesh the triangulated surface; it is only read
/// \param scalar_map the scalar field, which is changed
/// \param np an optional sequence of \ref bgl_namedparameters "Named Parameters" among the ones listed below
///
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{border_extremum}
///     \cgalParamDescription{whether borders become minima or maxima}
///     \cgalParamType{`Reeb_graph::Border_extremum`}
///     \cgalParamDefault{`Reeb_graph::Border_extremum::AUTOMATIC`}
///     \cgalParamExtra{use the function `parameters::border_extremum()`}
///   \cgalParamNEnd
///   \cgalParamNBegin{collar_width}
///     \cgalParamDescription{the number of edges from a border up to which values are changed; 0 changes those of
///                           borders only}
///     \cgalParamType{`std::size_t`}
///     \cgalParamDefault{3}
///     \cgalParamExtra{use the function `parameters::collar_width()`}
///   \cgalParamNEnd
///   \cgalParamNBegin{geom_traits}
///     \cgalParamDescription{an instance of a traits class, for scalar values ordered by another function object}
///     \cgalParamType{a model of `ReebGraphTraits`}
///     \cgalParamDefault{`Reeb_graph_traits<FaceListGraph, ScalarMap>`}
///   \cgalParamNEnd
///   \cgalParamNBegin{callback}
///     \cgalParamDescription{is called now and then with the fraction of the work done, from 0 to 1. If it returns
///                           `false`, the work stops, except at 1, when the field is written.}
///     \cgalParamType{a function object that can be called with a `double` and returns `bool`}
///     \cgalParamDefault{none}
///   \cgalParamNEnd
/// \cgalNamedParamsEnd
///
/// \reebGraphComplexity
///
/// \returns how many borders and vertices have been changed, and by how much.
///
/// It throws the exceptions of `compute_reeb_graph()`. When one is thrown, `scalar_map` is as it was before.
template <class FaceListGraph, class ScalarMap, class NamedParameters = parameters::Default_named_parameters>
Border_level_changes make_borders_level(const FaceListGraph& mesh,
                                        ScalarMap scalar_map,
                                        const NamedParameters& np = parameters::default_values())
{
  typedef internal::Chosen_traits<Reeb_graph_traits<FaceListGraph, ScalarMap>, NamedParameters> Traits;
  static_assert(internal::are_met<internal::Field_of_numbers<FaceListGraph, ScalarMap, Traits>,
                                  internal::Writable_vertex_map<ScalarMap, FaceListGraph>>);
  return internal::scalar_fields::write_level_borders<Border_level_changes>(
    mesh, scalar_map, internal::choose_traits<Traits>(np),
    internal::parameter_or(np, internal::border_extremum, Border_extremum::AUTOMATIC),
    internal::parameter_or(np, internal::collar_width, std::size_t(3)), internal::Progress(np));
}

} // namespace CGAL::Reeb_graph

#endif // CGAL_REEB_GRAPH_FIELDS_MAKE_BORDERS_LEVEL_H
