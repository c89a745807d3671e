// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_CURVES_CURVE_PARAMETERS_H
#define CGAL_REEB_GRAPH_CURVES_CURVE_PARAMETERS_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/named_parameters.h>

#include <CGAL/Named_function_parameters.h>

#include <cstddef>

// The named parameters of curves and of cutting along them.

namespace CGAL {
namespace Reeb_graph {
namespace internal {

enum cut_open_t
{
  cut_open
};
enum edge_curve_map_t
{
  edge_curve_map
};
enum curve_cost_t
{
  curve_cost
};
enum arc_weight_t
{
  arc_weight
};
enum number_of_candidates_t
{
  number_of_candidates
};
enum persistence_threshold_t
{
  persistence_threshold
};
enum area_threshold_t
{
  area_threshold
};

} // namespace internal
} // namespace Reeb_graph

namespace parameters {

/// \ingroup PkgReebGraphNamedParameters
///
/// \brief starts a pack of named parameters with `cut_open`, see `Reeb_graph::cut_along_contours()`.
inline auto cut_open(bool is_cut_open)
{
  return Reeb_graph::internal::start_parameters<Reeb_graph::internal::cut_open_t>(is_cut_open);
}

/// \ingroup PkgReebGraphNamedParameters
///
/// \brief appends `cut_open` to the pack `np`.
template <class T, class Tag, class Base>
auto cut_open(bool is_cut_open, const Named_function_parameters<T, Tag, Base>& np)
{
  return Reeb_graph::internal::append_parameter<Reeb_graph::internal::cut_open_t>(is_cut_open, np);
}

/// \ingroup PkgReebGraphNamedParameters
///
/// \brief starts a pack of named parameters with `edge_curve_map`, see `Reeb_graph::cut_along_contours()`.
template <class EdgeCurveMap>
auto edge_curve_map(const EdgeCurveMap& map)
{
  return Reeb_graph::internal::start_parameters<Reeb_graph::internal::edge_curve_map_t>(map);
}

/// \ingroup PkgReebGraphNamedParameters
///
/// \brief appends `edge_curve_map` to the pack `np`.
template <class EdgeCurveMap, class T, class Tag, class Base>
auto edge_curve_map(const EdgeCurveMap& map, const Named_function_parameters<T, Tag, Base>& np)
{
  return Reeb_graph::internal::append_parameter<Reeb_graph::internal::edge_curve_map_t>(map, np);
}

/// \ingroup PkgReebGraphNamedParameters
///
/// \brief starts a pack of named parameters with `curve_cost`, see `Reeb_graph::cutting_system()`,
/// `Reeb_graph::pants_decomposition()`, and `Reeb_graph::branch_curves()`.
template <class CurveCost>
auto curve_cost(const CurveCost& cost)
{
  return Reeb_graph::internal::start_parameters<Reeb_graph::internal::curve_cost_t>(cost);
}

/// \ingroup PkgReebGraphNamedParameters
///
/// \brief appends `curve_cost` to the pack `np`.
template <class CurveCost, class T, class Tag, class Base>
auto curve_cost(const CurveCost& cost, const Named_function_parameters<T, Tag, Base>& np)
{
  return Reeb_graph::internal::append_parameter<Reeb_graph::internal::curve_cost_t>(cost, np);
}

/// \ingroup PkgReebGraphNamedParameters
///
/// \brief starts a pack of named parameters with `arc_weight`, see `Reeb_graph::cutting_system()`.
template <class ArcWeight>
auto arc_weight(const ArcWeight& weight)
{
  return Reeb_graph::internal::start_parameters<Reeb_graph::internal::arc_weight_t>(weight);
}

/// \ingroup PkgReebGraphNamedParameters
///
/// \brief appends `arc_weight` to the pack `np`.
template <class ArcWeight, class T, class Tag, class Base>
auto arc_weight(const ArcWeight& weight, const Named_function_parameters<T, Tag, Base>& np)
{
  return Reeb_graph::internal::append_parameter<Reeb_graph::internal::arc_weight_t>(weight, np);
}

/// \ingroup PkgReebGraphNamedParameters
///
/// \brief starts a pack of named parameters with `number_of_candidates`, see `Reeb_graph::cutting_system()`,
/// `Reeb_graph::pants_decomposition()`, and `Reeb_graph::branch_curves()`.
inline auto number_of_candidates(std::size_t number)
{
  return Reeb_graph::internal::start_parameters<Reeb_graph::internal::number_of_candidates_t>(number);
}

/// \ingroup PkgReebGraphNamedParameters
///
/// \brief appends `number_of_candidates` to the pack `np`.
template <class T, class Tag, class Base>
auto number_of_candidates(std::size_t number, const Named_function_parameters<T, Tag, Base>& np)
{
  return Reeb_graph::internal::append_parameter<Reeb_graph::internal::number_of_candidates_t>(number, np);
}

/// \ingroup PkgReebGraphNamedParameters
///
/// \brief starts a pack of named parameters with `persistence_threshold`, see `Reeb_graph::branch_curves()`.
inline auto persistence_threshold(double threshold)
{
  return Reeb_graph::internal::start_parameters<Reeb_graph::internal::persistence_threshold_t>(threshold);
}

/// \ingroup PkgReebGraphNamedParameters
///
/// \brief appends `persistence_threshold` to the pack `np`.
template <class T, class Tag, class Base>
auto persistence_threshold(double threshold, const Named_function_parameters<T, Tag, Base>& np)
{
  return Reeb_graph::internal::append_parameter<Reeb_graph::internal::persistence_threshold_t>(threshold, np);
}

/// \ingroup PkgReebGraphNamedParameters
///
/// \brief starts a pack of named parameters with `area_threshold`, see `Reeb_graph::branch_curves()`.
inline auto area_threshold(double threshold)
{
  return Reeb_graph::internal::start_parameters<Reeb_graph::internal::area_threshold_t>(threshold);
}

/// \ingroup PkgReebGraphNamedParameters
///
/// \brief appends `area_threshold` to the pack `np`.
template <class T, class Tag, class Base>
auto area_threshold(double threshold, const Named_function_parameters<T, Tag, Base>& np)
{
  return Reeb_graph::internal::append_parameter<Reeb_graph::internal::area_threshold_t>(threshold, np);
}

} // namespace parameters
} // namespace CGAL

#endif // CGAL_REEB_GRAPH_CURVES_CURVE_PARAMETERS_H
