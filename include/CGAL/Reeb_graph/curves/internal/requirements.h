// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_CURVES_INTERNAL_REQUIREMENTS_H
#define CGAL_REEB_GRAPH_CURVES_INTERNAL_REQUIREMENTS_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/internal/base/graph_requirements.h>
#include <CGAL/Reeb_graph/internal/base/requirements.h>

#include <type_traits>

// Requirements of the functions that refine a mesh on the types of their arguments.

namespace CGAL::Reeb_graph::internal {

template <class Mesh, class ScalarMap, class Traits>
struct Refinable_mesh_with_field : std::conjunction<Refinable_mesh<Mesh>, Field_of_numbers<Mesh, ScalarMap, Traits>>
{
};

template <class Mesh, class ScalarMap, class Traits, class VertexMap>
struct Refinable_mesh_with_field_and_map
  : std::conjunction<Refinable_mesh<Mesh>, Field_of_numbers_and_map<Mesh, ScalarMap, Traits, VertexMap>>
{
};

template <class Mesh, class FacePatchMap>
struct Refinable_mesh_with_patches : std::conjunction<Refinable_mesh<Mesh>, Writable_face_map<FacePatchMap, Mesh>>
{
};

template <class Mesh, class ScalarMap, class Graph, class Traits, class FacePatchMap>
struct Refinable_mesh_with_graph : std::conjunction<Refinable_mesh<Mesh>,
                                                    Field_and_graph<Mesh, ScalarMap, Graph, Traits>,
                                                    Scalars_are_numbers<Traits>,
                                                    Writable_face_map<FacePatchMap, Mesh>>
{
};

} // namespace CGAL::Reeb_graph::internal

#endif // CGAL_REEB_GRAPH_CURVES_INTERNAL_REQUIREMENTS_H
