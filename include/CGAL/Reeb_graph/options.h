// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_OPTIONS_H
#define CGAL_REEB_GRAPH_OPTIONS_H

#include <CGAL/license/Reeb_graph.h>

#include <cstddef>
#include <cstdint>
#include <map>
#include <ostream>
#include <string>
#include <variant>
#include <vector>

namespace CGAL::Reeb_graph {

/// \addtogroup PkgReebGraphEnums
/// @{

/// \brief what happens to the contours at a node of the Reeb graph.
enum class Node_kind
{
  ISOLATED,  ///< no contour below and none above: a vertex without a face, or a component that ties contract
  MINIMUM,   ///< a contour is born: no arc below
  SADDLE,    ///< contours join, split, or both: at least three arcs
  MAXIMUM,   ///< a contour dies: no arc above
  DEGREE_TWO ///< a critical vertex that is touched by one contour below and by one above; kept on request only
};

/// \brief returns the name under which a kind of node is written:
/// `"isolated"`, `"minimum"`, `"saddle"`, `"maximum"`, or `"degree-two"`.
///
/// \param kind the kind
inline std::string to_string(Node_kind kind)
{
  switch(kind)
  {
  case Node_kind::ISOLATED: return "isolated";
  case Node_kind::MINIMUM: return "minimum";
  case Node_kind::SADDLE: return "saddle";
  case Node_kind::MAXIMUM: return "maximum";
  case Node_kind::DEGREE_TWO: return "degree-two";
  }
  return "unknown";
}

/// \brief writes what `to_string()` returns.
///
/// \param out the stream
/// \param kind the kind
inline std::ostream& operator<<(std::ostream& out, Node_kind kind) { return out << to_string(kind); }

/// \brief what becomes of vertices of equal value.
enum class Ties
{
  PERTURB, ///< they are ordered by their position in `vertices(mesh)`; arcs of length zero keep every handle
  CONTRACT ///< arcs of length zero are contracted: the graph is that of the field as it is, where each connected
           ///< component of a level set is one point
};

/// \brief the method that finds the arcs; the graph is the same for each.
enum class Method
{
  AUTOMATIC,     ///< `CONTOUR_TREES`, which is the faster one for smooth fields as well as for noise
  CRITICAL_SETS, ///< critical sets and ascending paths: the method of the paper, quadratic for noise
  CONTOUR_TREES  ///< contour trees joined by loop surgery: near-linear for any field
};

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

/// \brief what `make_borders_level()` makes of a border component that is not an extremal level yet.
enum class Border_extremum
{
  AUTOMATIC, ///< what changes less
  MINIMUM,   ///< a minimum of the field
  MAXIMUM    ///< a maximum of the field
};

/// \brief what the functions that find curves do if a border component does not lie in one level of the field, or is
/// neither a minimum nor a maximum.
enum class Borders
{
  LEVEL,     ///< they throw `Border_level_error`
  MAKE_LEVEL ///< they go on with the field that `make_borders_level()` makes; old vertices keep their values in the map
};

/// \brief where `embed()` puts the arcs of a graph.
enum class Embedding_manner
{
  CENTROIDS,  ///< through the centroids of contours: inside of the surface where that is a tube
  ON_SURFACE, ///< on the surface, ascending: along the chain of the arc
  STRAIGHT,   ///< straight from node to node
  BY_COST     ///< `CENTROIDS`, or `STRAIGHT` if the contours are much longer than the mesh is large, as those of noise
};

/// @}

/// \ingroup PkgReebGraphIO
///
/// \brief numbers that are written to a file with a name: one for each arc, vertex, or face.
struct Attribute
{
  /// the name, in files a column or an array; in files of XML and JSON, bytes that are not UTF-8 become U+FFFD
  std::string name;

  /// the numbers, in the order of `edges(graph)`, `vertices(mesh)`, or `faces(mesh)`
  std::variant<std::vector<double>, std::vector<std::int64_t>> numbers;
};

/// \ingroup PkgReebGraphRef
///
/// \brief the number of critical vertices of each kind: a property of the field, not of its Reeb graph.
///
/// With \f$ m \f$ the multiplicity, the number of lower link sectors minus one, a closed surface has Euler
/// characteristic \f$ minima - \sum m + maxima \f$.
struct Critical_vertex_counts
{
  std::size_t isolated = 0; ///< vertices without a face
  std::size_t minima = 0;   ///< vertices whose link is all above, border vertices included
  std::size_t maxima = 0;   ///< vertices whose link is all below, border vertices included
  /// interior vertices with at least two lower link sectors, by multiplicity
  std::map<std::size_t, std::size_t> saddles;
  std::size_t border_saddles = 0; ///< border vertices with at least two lower or two upper link sectors
};

/// \ingroup PkgReebGraphEnums
///
/// \brief the stages of `compute_reeb_graph()`, in the order in which they run.
enum class Stage
{
  FLATTEN,  ///< the scalar map is copied, and the mesh, if it is no `CGAL::Surface_mesh`
  CLASSIFY, ///< the mesh is checked; critical vertices are found and sorted
  ARCS,     ///< the arcs between critical vertices are found
  WRITE     ///< the halfedge chains of the arcs are walked, and the graph is written
};

/// \ingroup PkgReebGraphRef
///
/// \brief a visitor of `compute_reeb_graph()` that does nothing; derive from it, and redefine one or more members.
///
/// \cgalModels{ReebGraphVisitor}
struct Default_visitor
{
  void begin_stage(Stage) {} ///< called before a stage
  void end_stage(Stage) {}   ///< called after a stage
  /// called once in the stage `Stage::CLASSIFY`.
  void critical_vertices(const Critical_vertex_counts&) {}
};

} // namespace CGAL::Reeb_graph

#endif // CGAL_REEB_GRAPH_OPTIONS_H
