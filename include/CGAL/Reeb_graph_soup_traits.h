// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_SOUP_TRAITS_H
#define CGAL_REEB_GRAPH_SOUP_TRAITS_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/internal/complex/Simplicial_complex.h>
#include <CGAL/Reeb_graph_traits.h>

namespace CGAL {

/// \ingroup PkgReebGraphRef
///
/// \brief the types and predicates of a Reeb graph of a scalar field on a soup of triangles or tetrahedra.
///
/// `vertex_descriptor` is `std::size_t`, the index of a vertex, and `halfedge_descriptor` is
/// `std::pair<std::size_t, std::size_t>`, the source and the target of an edge, so that the chains of the arcs are
/// ascending pairs of indices. All other types are those of `Reeb_graph_traits`. There is no mesh: `Triangle_mesh` and
/// `Scalar_map` are unspecified.
///
/// \tparam Scalar_ the type of a scalar value, which has `operator<` as strict weak order. To order by another function
///         object, derive from this class.
///
/// \cgalModels{ReebGraphTraits}
template <class Scalar_>
class Reeb_graph_soup_traits
  : public Reeb_graph_traits<Reeb_graph::internal::Simplicial_complex, Reeb_graph::internal::Soup_scalars<Scalar_>>
{
};

} // namespace CGAL

#endif // CGAL_REEB_GRAPH_SOUP_TRAITS_H
