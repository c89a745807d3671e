// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_INTERNAL_BASE_TUNING_H
#define CGAL_REEB_GRAPH_INTERNAL_BASE_TUNING_H

#include <CGAL/license/Reeb_graph.h>

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
  TRIANGLE_SWEEP
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

#endif // CGAL_REEB_GRAPH_INTERNAL_BASE_TUNING_H
