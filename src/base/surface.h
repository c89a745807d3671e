// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_SRC_SURFACE_H
#define CGAL_REEB_GRAPH_SRC_SURFACE_H

#include "base/input_findings.h"

#include <CGAL/Reeb_graph_soup_traits.h>
#include <CGAL/Reeb_graph_traits.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <boost/property_map/property_map.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace reeb_graph_program {
typedef CGAL::Simple_cartesian<double>::Point_3 Point;
typedef std::vector<Point> Polyline; // if it is closed, its first point is its last one as well
typedef CGAL::Surface_mesh<Point> Surface;
typedef Surface::Property_map<Surface::Vertex_index, double> Scalar_map;
typedef Surface::Property_map<Surface::Face_index, int> Patch_map;
typedef CGAL::Reeb_graph_traits<Surface, Scalar_map>::Graph Graph;

// A property of the vertices that a file has besides their points.
template <class Number>
using Vertex_property = Surface::Property_map<Surface::Vertex_index, Number>;
typedef std::variant<Vertex_property<std::int8_t>,
                     Vertex_property<std::uint8_t>,
                     Vertex_property<std::int16_t>,
                     Vertex_property<std::uint16_t>,
                     Vertex_property<std::int32_t>,
                     Vertex_property<std::uint32_t>,
                     Vertex_property<float>,
                     Vertex_property<double>>
  Any_vertex_property;

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

// The numbers by which files know vertices: those of the surface, or others where the surface has the vertices of nodes
// only.
class Vertex_numbers
{
public:
  typedef Surface::Vertex_index key_type;
  typedef std::uint64_t value_type;
  typedef std::uint64_t reference;
  typedef boost::readable_property_map_tag category;

  Vertex_numbers() = default;
  // `numbers` has to outlive this object.
  explicit Vertex_numbers(const std::vector<std::uint64_t>& numbers) : numbers_(&numbers) {}
  explicit Vertex_numbers(const std::vector<std::uint64_t>&&) = delete;

  friend std::uint64_t get(const Vertex_numbers& map, Surface::Vertex_index v)
  {
    return map.numbers_ == nullptr ? v.idx() : (*map.numbers_)[v.idx()];
  }

private:
  const std::vector<std::uint64_t>* numbers_ = nullptr;
};

} // namespace reeb_graph_program

#endif // CGAL_REEB_GRAPH_SRC_SURFACE_H
