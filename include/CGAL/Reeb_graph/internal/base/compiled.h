// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_INTERNAL_BASE_COMPILED_H
#define CGAL_REEB_GRAPH_INTERNAL_BASE_COMPILED_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Surface_mesh/Surface_mesh_fwd.h>

// The seam of the library CGAL::Reeb_graph_compiled, in which the stages are compiled once for what nearly all use. Its
// target defines CGAL_REEB_GRAPH_COMPILED: then headers declare that these are instantiated elsewhere. For all other
// types, and without the macro, they are templates as any.
//
// A stage says so behind its definition, by a macro M(PREFIX, COMPLEX) with its signature, which one of the lists below is
// given. A stage has to be a function that is neither in a class nor inline, and whose result is not
// `auto`, as g++ instantiates all others nevertheless. No kernel is included here: only the library needs them all.

namespace CGAL {

template <class FieldNumber>
struct Simple_cartesian;
class Epick;
class Epeck;
template <class Kernel>
class Point_3;
class SM_Vertex_index;
class SM_Halfedge_index;

namespace Reeb_graph::internal {

template <class Point>
class Surface_mesh_complex;
class Triangle_complex;
class Simplicial_complex;

typedef Point_3<Simple_cartesian<double>> Cartesian_point;
typedef Point_3<Epick> Epick_point;
typedef Point_3<Epeck> Epeck_point;
typedef Surface_mesh_complex<Cartesian_point> Cartesian_complex;
typedef Surface_mesh_complex<Epick_point> Epick_complex;
typedef Surface_mesh_complex<Epeck_point> Epeck_complex;

} // namespace Reeb_graph::internal
} // namespace CGAL

#ifdef CGAL_REEB_GRAPH_LEFT_OUT
#undef CGAL_REEB_GRAPH_COMPILED // Compiled stages leave out no Tuned_part.
#endif

// A source of the library defines as empty what it is there to instantiate.
#ifndef CGAL_REEB_GRAPH_STAGES
#define CGAL_REEB_GRAPH_STAGES extern
#endif
#ifndef CGAL_REEB_GRAPH_LOOPS
#define CGAL_REEB_GRAPH_LOOPS extern
#endif
#ifndef CGAL_REEB_GRAPH_SKELETONS
#define CGAL_REEB_GRAPH_SKELETONS extern
#endif
#ifndef CGAL_REEB_GRAPH_SOLVERS
#define CGAL_REEB_GRAPH_SOLVERS extern
#endif

#ifdef CGAL_REEB_GRAPH_COMPILED
#define CGAL_REEB_GRAPH_IF_COMPILED(...) __VA_ARGS__
#else
#define CGAL_REEB_GRAPH_IF_COMPILED(...)
#endif

#define CGAL_REEB_GRAPH_FOR_SURFACES(M)                                                                                \
  CGAL_REEB_GRAPH_IF_COMPILED(M(CGAL_REEB_GRAPH_STAGES, Cartesian_complex) M(CGAL_REEB_GRAPH_STAGES, Epick_complex)    \
                                M(CGAL_REEB_GRAPH_STAGES, Epeck_complex) M(CGAL_REEB_GRAPH_STAGES, Triangle_complex))
#define CGAL_REEB_GRAPH_FOR_SOUPS(M) CGAL_REEB_GRAPH_IF_COMPILED(M(CGAL_REEB_GRAPH_STAGES, Simplicial_complex))
#define CGAL_REEB_GRAPH_FOR_COMPLEXES(M) CGAL_REEB_GRAPH_FOR_SURFACES(M) CGAL_REEB_GRAPH_FOR_SOUPS(M)
// Functions that write graphs get the point of a Surface_mesh instead of a complex.
#define CGAL_REEB_GRAPH_FOR_POINTS(M)                                                                                  \
  CGAL_REEB_GRAPH_IF_COMPILED(M(CGAL_REEB_GRAPH_STAGES, Cartesian_point) M(CGAL_REEB_GRAPH_STAGES, Epick_point)        \
                                M(CGAL_REEB_GRAPH_STAGES, Epeck_point))
// Functions of handles, which know surfaces by numbers, and in the same way of skeletons. They have no parameters but
// M(PREFIX), and only the library sees their definition.
#define CGAL_REEB_GRAPH_FOR_LOOPS(M) CGAL_REEB_GRAPH_IF_COMPILED(M(CGAL_REEB_GRAPH_LOOPS))
#define CGAL_REEB_GRAPH_FOR_SKELETONS(M) CGAL_REEB_GRAPH_IF_COMPILED(M(CGAL_REEB_GRAPH_SKELETONS))
#if defined(CGAL_REEB_GRAPH_COMPILED) && !defined(CGAL_REEB_GRAPH_DEFINE_LOOPS)
#define CGAL_REEB_GRAPH_ARE_LOOPS_COMPILED
#endif
#if defined(CGAL_REEB_GRAPH_COMPILED) && !defined(CGAL_REEB_GRAPH_DEFINE_SKELETONS)
#define CGAL_REEB_GRAPH_ARE_SKELETONS_COMPILED
#endif
// Functions that need Eigen, on both sides.
#if defined(CGAL_REEB_GRAPH_COMPILED_SOLVERS) && defined(CGAL_EIGEN3_ENABLED)
#define CGAL_REEB_GRAPH_FOR_SOLVERS(M) CGAL_REEB_GRAPH_IF_COMPILED(M(CGAL_REEB_GRAPH_SOLVERS))
#else
#define CGAL_REEB_GRAPH_FOR_SOLVERS(M)
#endif

#endif // CGAL_REEB_GRAPH_INTERNAL_BASE_COMPILED_H
