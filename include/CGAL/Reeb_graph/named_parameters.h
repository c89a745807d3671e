// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_NAMED_PARAMETERS_H
#define CGAL_REEB_GRAPH_NAMED_PARAMETERS_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Named_function_parameters.h>

#include <cstddef>
#include <functional>
#include <type_traits>

namespace CGAL {

namespace Reeb_graph {

/// \ingroup PkgReebGraphEnums
///
/// \brief what becomes of vertices of equal value.
enum class Ties
{
  PERTURB, ///< they are ordered by their position in `vertices(mesh)`; arcs of length zero keep every handle
  CONTRACT ///< arcs of length zero are contracted: the graph is that of the field as it is, where each connected
           ///< component of a level set is one point
};

/// \ingroup PkgReebGraphEnums
///
/// \brief how the arcs are found; the graph is the same.
enum class Method
{
  AUTOMATIC,     ///< the same as `CONTOUR_TREES`, which is the faster one for smooth fields as well as for noise
  CRITICAL_SETS, ///< critical sets and ascending paths: the method of the paper, quadratic for noise
  CONTOUR_TREES  ///< contour trees joined by loop surgery: near-linear for any field
};

/// \ingroup PkgReebGraphEnums
///
/// \brief the weights \f$ w_{ij} \f$ of the Laplace equation \f$ \sum_j w_{ij} (f_j - f_i) = 0 \f$.
enum class Laplacian_weights
{
  /// \f$ (\tan(\theta / 2) + \tan(\phi / 2)) / |v_j - v_i| \f$ with the angles at \f$ v_i \f$ on both sides of the
  /// edge, which are positive for any triangles (Floater 2003). With finer and finer meshes, the field converges to the
  /// smooth one only if the triangles get about equilateral
  MEAN_VALUE,
  /// \f$ (\cot \alpha + \cot \beta) / 2 \f$ with the two angles that face the edge, those of linear finite elements;
  /// some of them are negative if there are obtuse angles
  COTANGENT,
  UNIFORM ///< one for each edge; the geometry of the faces plays no role
};

namespace internal {

// The tags of the package's own parameters; everything else about them is CGAL's.
enum keep_degree_two_nodes_t
{
  keep_degree_two_nodes
};
enum ties_t
{
  ties
};
enum method_t
{
  method
};
enum number_of_slabs_t
{
  number_of_slabs
};
enum laplacian_weights_t
{
  laplacian_weights
};

template <class Tag, class T>
auto start_parameters(const T& value)
{
  return Named_function_parameters<T, Tag>(value);
}

template <class Tag, class T, class Parameters>
auto append_parameter(const T& value, const Parameters& np)
{
  return Named_function_parameters<T, Tag, Parameters>(value, np);
}

// Whether get_parameter() has found one, by the type that it returns.
template <class Parameter>
constexpr bool is_given = !std::is_same_v<std::decay_t<Parameter>, internal_np::Param_not_found>;

// A parameter that may be given by value or as std::reference_wrapper.
template <class T>
T& unwrap_reference(T& parameter)
{
  return parameter;
}

template <class T>
T& unwrap_reference(std::reference_wrapper<T>& parameter)
{
  return parameter;
}

} // namespace internal
} // namespace Reeb_graph

namespace parameters {

/// \ingroup PkgReebGraphNamedParameters
///
/// \brief starts a pack of named parameters with `keep_degree_two_nodes`, see `compute_reeb_graph()`.
inline auto keep_degree_two_nodes(bool is_kept)
{
  return Reeb_graph::internal::start_parameters<Reeb_graph::internal::keep_degree_two_nodes_t>(is_kept);
}

/// \ingroup PkgReebGraphNamedParameters
///
/// \brief appends `keep_degree_two_nodes` to the pack `np`.
template <class T, class Tag, class Base>
auto keep_degree_two_nodes(bool is_kept, const Named_function_parameters<T, Tag, Base>& np)
{
  return Reeb_graph::internal::append_parameter<Reeb_graph::internal::keep_degree_two_nodes_t>(is_kept, np);
}

/// \ingroup PkgReebGraphNamedParameters
///
/// \brief starts a pack of named parameters with `ties`, see `compute_reeb_graph()`.
inline auto ties(Reeb_graph::Ties ties)
{
  return Reeb_graph::internal::start_parameters<Reeb_graph::internal::ties_t>(ties);
}

/// \ingroup PkgReebGraphNamedParameters
///
/// \brief appends `ties` to the pack `np`.
template <class T, class Tag, class Base>
auto ties(Reeb_graph::Ties ties, const Named_function_parameters<T, Tag, Base>& np)
{
  return Reeb_graph::internal::append_parameter<Reeb_graph::internal::ties_t>(ties, np);
}

/// \ingroup PkgReebGraphNamedParameters
///
/// \brief starts a pack of named parameters with `method`, see `compute_reeb_graph()`.
inline auto method(Reeb_graph::Method method)
{
  return Reeb_graph::internal::start_parameters<Reeb_graph::internal::method_t>(method);
}

/// \ingroup PkgReebGraphNamedParameters
///
/// \brief appends `method` to the pack `np`.
template <class T, class Tag, class Base>
auto method(Reeb_graph::Method method, const Named_function_parameters<T, Tag, Base>& np)
{
  return Reeb_graph::internal::append_parameter<Reeb_graph::internal::method_t>(method, np);
}

/// \ingroup PkgReebGraphNamedParameters
///
/// \brief starts a pack of named parameters with `number_of_slabs`, see `compute_reeb_graph()`.
inline auto number_of_slabs(std::size_t number)
{
  return Reeb_graph::internal::start_parameters<Reeb_graph::internal::number_of_slabs_t>(number);
}

/// \ingroup PkgReebGraphNamedParameters
///
/// \brief appends `number_of_slabs` to the pack `np`.
template <class T, class Tag, class Base>
auto number_of_slabs(std::size_t number, const Named_function_parameters<T, Tag, Base>& np)
{
  return Reeb_graph::internal::append_parameter<Reeb_graph::internal::number_of_slabs_t>(number, np);
}

/// \ingroup PkgReebGraphNamedParameters
///
/// \brief starts a pack of named parameters with `laplacian_weights`, see `Reeb_graph::compute_harmonic_field()`.
inline auto laplacian_weights(Reeb_graph::Laplacian_weights weights)
{
  return Reeb_graph::internal::start_parameters<Reeb_graph::internal::laplacian_weights_t>(weights);
}

/// \ingroup PkgReebGraphNamedParameters
///
/// \brief appends `laplacian_weights` to the pack `np`.
template <class T, class Tag, class Base>
auto laplacian_weights(Reeb_graph::Laplacian_weights weights, const Named_function_parameters<T, Tag, Base>& np)
{
  return Reeb_graph::internal::append_parameter<Reeb_graph::internal::laplacian_weights_t>(weights, np);
}

} // namespace parameters
} // namespace CGAL

#endif // CGAL_REEB_GRAPH_NAMED_PARAMETERS_H
