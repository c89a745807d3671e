// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_CURVES_CURVE_H
#define CGAL_REEB_GRAPH_CURVES_CURVE_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/named_parameters.h>
#include <CGAL/Reeb_graph/options.h>

#include <cstddef>
#include <vector>

namespace CGAL::Reeb_graph {

/// \ingroup PkgReebGraphCurves
///
/// \brief a contour that has become a path of mesh edges: what `cut_along_contours()` and the functions that use it
/// write.
///
/// \tparam HalfedgeDescriptor a halfedge descriptor of the mesh
template <class HalfedgeDescriptor>
struct Curve
{
  /// consecutive halfedges of the refined mesh: each starts where the one before ends. The higher side is on the left.
  std::vector<HalfedgeDescriptor> halfedges;

  /// if the mesh has been cut open: for each halfedge the one that it has been parted from, with the lower side on its
  /// left, so that it leads the opposite way. Else the opposite halfedges.
  std::vector<HalfedgeDescriptor> lower_halfedges;

  /// `true` if the curve is closed, `false` if it leads from border to border
  bool is_closed = false;

  /// the value of the scalar field along the curve
  double value = 0;

  /// the length of the curve
  double length = 0;
};

/// \ingroup PkgReebGraphCurves
///
/// \brief a place where a curve can be: what the function object `parameters::curve_cost()` is called with.
struct Candidate_curve
{
  /// the length of the contour
  double length = 0;

  /// the value of the scalar field along the contour
  double value = 0;

  /// the place of the contour between the ends of what it can be moved along, 0 at the one end and 1 at the other,
  /// measured by the number of edges of the chains. For a branch, 0 is where it is attached and 1 is its tip. Else the
  /// direction is not specified.
  double position = 0;
};

/// \ingroup PkgReebGraphCurves
///
/// \brief what `cut_along_levels()` has done to a mesh.
struct Level_cut_report
{
  std::size_t number_of_levels = 0;         ///< the number of different levels
  std::size_t number_of_added_vertices = 0; ///< the number of points at which edges have been split
  std::size_t number_of_added_faces = 0;    ///< the number of faces that are there more than before
  /// the number of faces at added vertices that are slivers: the height on the longest edge is less than a hundredth of
  /// this edge. Some may have no area, where the point of a level is rounded to a vertex.
  std::size_t number_of_slivers = 0;
};

} // namespace CGAL::Reeb_graph

// The named parameters of curves and of cutting along them, and what the functions that share them say of them. All are
// in the list `PkgReebGraphNamedParameters`.

/// \defgroup PkgReebGraphPlaceParameters Named Parameters for the Places of Curves
/// \ingroup PkgReebGraphCurves
///
/// Parameters of the functions that choose contours of a Reeb graph.
///
/// <b>Where the curves are:</b>
///
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{curve_cost}
///     \cgalParamDescription{chooses the place of each curve: the candidate of least cost is taken}
///     \cgalParamType{a function object that is called with a `Reeb_graph::Candidate_curve` and returns a `double`}
///     \cgalParamDefault{the length; for `branch_curves()`, the length for positions up to 0.5, else more than that of
///                       any of these}
///     \cgalParamExtra{use the function `parameters::curve_cost()`}
///   \cgalParamNEnd
///   \cgalParamNBegin{number_of_candidates}
///     \cgalParamDescription{the number of places that are tried for each curve, at least 1. They are evenly spread
///                           over the edges of the chains of the arcs.}
///     \cgalParamType{`std::size_t`}
///     \cgalParamDefault{16}
///     \cgalParamExtra{use the function `parameters::number_of_candidates()`}
///   \cgalParamNEnd
/// \cgalNamedParamsEnd

/// \defgroup PkgReebGraphBorderParameters Named Parameters for Borders
/// \ingroup PkgReebGraphCurves
///
/// Parameters of the functions that find curves by the Reeb graph, and need borders that are extremal levels.
///
/// <b>What is done with borders:</b>
///
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{borders}
///     \cgalParamDescription{what happens if a border component does not lie in one level, or is neither a minimum nor
///                           a maximum. Either there is an exception, or the field is changed as by
///                           `make_borders_level()`, whose named parameters `border_extremum` and `collar_width` count
///                           then. `scalar_map` itself stays as it is, but for vertices that are added. To have the
///                           changed field, call that function first.}
///     \cgalParamType{`Reeb_graph::Borders`}
///     \cgalParamDefault{`Reeb_graph::Borders::LEVEL`}
///     \cgalParamExtra{use the function `parameters::borders()`}
///   \cgalParamNEnd
/// \cgalNamedParamsEnd

/// \defgroup PkgReebGraphCuttingParameters Named Parameters of Cutting
/// \ingroup PkgReebGraphCurves
///
/// Parameters of all functions that cut a mesh along curves.
///
/// <b>How the mesh is cut, and what is written:</b>
///
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{cut_open}
///     \cgalParamDescription{whether the mesh is cut open along the curves, so that each closed curve becomes two
///                           border cycles. The lower side gets new vertices at the points of the curve.}
///     \cgalParamType{`bool`}
///     \cgalParamDefault{`false`}
///     \cgalParamExtra{use the function `parameters::cut_open()`}
///   \cgalParamNEnd
///   \cgalParamNBegin{edge_is_constrained_map}
///     \cgalParamDescription{is set to `true` for each edge of a curve; other edges are not written}
///     \cgalParamType{a model of `WritablePropertyMap` with the edge descriptors as key type and `bool` as value type}
///     \cgalParamDefault{none}
///   \cgalParamNEnd
///   \cgalParamNBegin{edge_curve_map}
///     \cgalParamDescription{is set to the number of the curve, from 0, for each edge of a curve; other edges are not
///                           written}
///     \cgalParamType{a model of `WritablePropertyMap` with the edge descriptors as key type and an integer type as
///                    value type}
///     \cgalParamDefault{none}
///     \cgalParamExtra{use the function `parameters::edge_curve_map()`}
///   \cgalParamNEnd
///   \cgalParamNBegin{face_patch_map}
///     \cgalParamDescription{is set to the number of the piece that the face belongs to once the mesh is cut along all
///                           curves, from 0. The functions that segment a mesh take this map as an argument.}
///     \cgalParamType{a model of `WritablePropertyMap` with the face descriptors as key type and an integer type as
///                    value type}
///     \cgalParamDefault{none}
///   \cgalParamNEnd
///   \cgalParamNBegin{face_count_callback}
///     \cgalParamDescription{is called once with the number of faces that the cut mesh will have, when the curves
///                           are found and before the mesh is cut. On noise, many curves can cross one face, and each
///                           adds two. If it returns `false`, `Reeb_graph::Face_count_error` is thrown, and the mesh
///                           is as `callback` leaves it.}
///     \cgalParamType{a function object that can be called with a `std::size_t` and returns `bool`}
///     \cgalParamDefault{none}
///     \cgalParamExtra{use the function `parameters::face_count_callback()`}
///   \cgalParamNEnd
/// \cgalNamedParamsEnd

/// \defgroup PkgReebGraphRefinementParameters Named Parameters of Refinements
/// \ingroup PkgReebGraphCurves
///
/// Parameters of all functions that split edges and faces of a mesh.
///
/// <b>The field of the refined mesh:</b> If the scalar map can be written, each vertex that is added gets a value. On a
/// curve it is that of the contour, elsewhere one next to that of the vertex that has been unfolded or of the border.
/// Both lie strictly between the values of the vertices below and above wherever there is such a number. So the Reeb
/// graph of the refined mesh has the nodes and arcs that it had, but for multi-saddles, which have been unfolded, and
/// for the cuts of `cut_open`. Three kinds of maps are only read: those that are not a model of `ReadWritePropertyMap`,
/// those over a range of fixed size, such as `boost::iterator_property_map`, and dynamic property maps of a
/// `Surface_mesh` that is `const`, which `make_scalar_map()` returns. Other property maps are carried over by an
/// `Interpolating_visitor`.
///
/// <b>What is known of the mesh and the field:</b>
///
/// \cgalNamedParamsBegin
///   \reebGraphPoints{ReadWritePropertyMap}
///   \cgalParamNBegin{visitor}
///     \cgalParamDescription{is called for all edges and faces that are split, so that attributes can be carried over}
///     \cgalParamType{a model of `ReebGraphRefinementVisitor`, by value or as `std::reference_wrapper`}
///     \cgalParamDefault{`Reeb_graph::Default_refinement_visitor`}
///   \cgalParamNEnd
///   \cgalParamNBegin{geom_traits}
///     \cgalParamDescription{an instance of a traits class, for scalar values ordered by another function object, or
///                           that are not numbers. `scalar_to_double_object()` converts values to numbers. New vertices
///                           get values of `scalar_from_double_object()`, where the order has them between the ones
///                           around them. The order has to take any value between those of the field, if the scalar
///                           map can be written.}
///     \cgalParamType{a model of `ReebGraphTraits`; for values that are not numbers, of `ReebGraphNumberTraits`}
///     \cgalParamDefault{`Reeb_graph_traits<MutableFaceGraph, ScalarMap>`}
///   \cgalParamNEnd
/// \cgalNamedParamsEnd
///
/// <b>How far the work is:</b>
///
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{callback}
///     \cgalParamDescription{is called now and then with the fraction of the work done, from 0 to 1, by the calling
///                           thread. If it returns `false`, the work stops with `Reeb_graph::Cancelled_error`, except
///                           when all faces are split, and only the result is to be written. Splits that have
///                           been made are undone then: the mesh has the vertices, edges and faces that it had, with
///                           the same descriptors, the field has its values there, and nothing has been output. The
///                           visitor has been called for the splits, and a `Surface_mesh` has garbage. To be undone,
///                           each split takes 24 bytes on it until all are made.}
///     \cgalParamType{a function object that can be called with a `double` and returns `bool`}
///     \cgalParamDefault{none}
///   \cgalParamNEnd
/// \cgalNamedParamsEnd

#endif // CGAL_REEB_GRAPH_CURVES_CURVE_H
