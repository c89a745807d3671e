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

#include <CGAL/Reeb_graph/internal/base/Index.h>

#include <CGAL/Surface_mesh/Surface_mesh_fwd.h>

#include <cstddef>
#include <cstdint>

namespace CGAL::Reeb_graph::internal {

// The parts that are there for speed alone. The benchmark leaves out one at a time, by the macro, to tell what it
// gains.
enum class Tuned_part
{
  NONE,
  PREFETCH,
  KEPT_NEIGHBORS,
  BRANCHLESS_ORDER,
  TRIANGLE_SWEEP,
  STARS_AHEAD
};

#ifdef CGAL_REEB_GRAPH_LEFT_OUT
#undef CGAL_REEB_GRAPH_COMPILED // Compiled stages leave nothing out.
#else
#define CGAL_REEB_GRAPH_LEFT_OUT NONE
#endif

constexpr bool is_left_out(Tuned_part part) { return part == Tuned_part::CGAL_REEB_GRAPH_LEFT_OUT; }
constexpr bool is_used(Tuned_part part) { return !is_left_out(part); }

// Loops that jump about in memory, but know where to, tell so some rounds ahead.
inline void prefetch(const void* address)
{
#ifdef __GNUC__
  if(is_used(Tuned_part::PREFETCH))
    __builtin_prefetch(address);
#else
  static_cast<void>(address);
#endif
}

// Has g++ keep a function that does nothing but fetch: it takes it to have no effect, and leaves out calls of it.
inline void keep_fetching()
{
#ifdef __GNUC__
  __asm__ volatile("");
#endif
}

// The place where the element of a vector is or would be that `key` names: for any key.
template <class Vector, class Key>
void prefetch_element(const Vector& vector, Key key)
{
  // Computed as a number, as a pointer must not leave its array.
  const std::uintptr_t begin = reinterpret_cast<std::uintptr_t>(vector.data());
  // NOLINTNEXTLINE(performance-no-int-to-ptr): nothing is read from there
  prefetch(reinterpret_cast<const void*>(begin + key.number() * sizeof(typename Vector::value_type)));
}

} // namespace CGAL::Reeb_graph::internal

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
