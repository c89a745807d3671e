// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_SRC_COMPLEX_H
#define CGAL_REEB_GRAPH_SRC_COMPLEX_H

#include "base/input_findings.h"
#include "base/surface.h"

#include <CGAL/Reeb_graph_soup_traits.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace reeb_graph_program {
typedef CGAL::Reeb_graph_soup_traits<double>::Graph Complex_graph;

// The cells, by the numbers of their vertices, of a mesh that is no oriented manifold surface. Faces of tetrahedra, and
// edges of triangles, need not be listed.
struct Complex
{
  std::vector<std::array<std::uint32_t, 2>> edges;
  std::vector<std::array<std::uint32_t, 3>> triangles;
  std::vector<std::array<std::uint32_t, 4>> tetrahedra;
  bool has_triangles_and_tetrahedra() const { return !triangles.empty() && !tetrahedra.empty(); }

  // Faces of the file that repeat an earlier one, in either orientation.
  std::size_t duplicate_faces = 0;
  std::optional<std::size_t> first_duplicate_face;
};

// What a mesh file has: an oriented manifold surface or, if there is a complex, a surface that has its vertices only.
struct Mesh
{
  Surface surface;
  std::optional<Complex> complex;
  std::vector<std::string> notes = {}; // on what was left out when it was read
  Input_findings findings = {};
  std::optional<Repair_counts> repair = {}; // of the copy that this is, if the file has no surface
};

} // namespace reeb_graph_program

#endif // CGAL_REEB_GRAPH_SRC_COMPLEX_H
