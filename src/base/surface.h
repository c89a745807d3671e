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
#include <CGAL/version.h>

#include <boost/property_map/function_property_map.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <type_traits>
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

// Calls visit(u, v) for the ends of each edge, in either order, and of some edges again.
template <class Visit>
void visit_edges(const Mesh& mesh, const Visit& visit)
{
  for(const Surface::Edge_index e : mesh.surface.edges())
    visit(mesh.surface.vertex(e, 0).idx(), mesh.surface.vertex(e, 1).idx());
  const auto visit_all = [&](const auto& cells) {
    for(const auto& cell : cells)
      for(std::size_t i = 1; i < cell.size(); ++i)
        for(std::size_t j = 0; j < i; ++j)
          visit(cell[i], cell[j]);
  };
  if(!mesh.complex)
    return;
  visit_all(mesh.complex->edges);
  visit_all(mesh.complex->triangles);
  visit_all(mesh.complex->tetrahedra);
}

// The numbers by which files know vertices: those of the surface, or others where the surface has the vertices of nodes
// only.
typedef boost::
  function_property_map<std::function<std::uint64_t(Surface::Vertex_index)>, Surface::Vertex_index, std::uint64_t>
    Vertex_numbers;
inline const Vertex_numbers own_numbers([](Surface::Vertex_index v) { return v.idx(); });

template <class Number>
std::optional<Vertex_property<Number>> find_vertex_property(const Surface& surface, const std::string& name)
{
  const auto found = surface.property_map<Surface::Vertex_index, Number>(name);
#if CGAL_VERSION_NR >= 1060000000
  return found;
#else
  return found.second ? std::make_optional(found.first) : std::nullopt;
#endif
}

template <class Visit, class... Number>
void visit_vertex_property(const Surface& surface,
                           const std::string& name,
                           const Visit& visit,
                           const std::variant<Vertex_property<Number>...>*)
{
  const auto visit_if_found = [&](const auto& map) {
    if(map)
      visit(name.substr(2), *map);
  };
  (visit_if_found(find_vertex_property<Number>(surface, name)), ...);
}

// The given vertices of which each one is a copy, or between which it is, if a repair has added some: the given ones come
// first, and are their own.
typedef Vertex_property<std::array<std::uint32_t, 2>> Origin_map;
constexpr const char* name_of_origins = "origins";

inline std::size_t number_of_given_vertices(const Surface& surface)
{
  const auto origins = find_vertex_property<std::array<std::uint32_t, 2>>(surface, name_of_origins);
  std::size_t number = 0;
  for(const Surface::Vertex_index v : surface.vertices())
    number += !origins || (*origins)[v][0] == v ? 1 : 0;
  return number;
}

// Gives those that have been added the numbers of what they are copies of, or a mean.
template <class Map>
void set_added_vertices(const Surface& surface, Map map)
{
  typedef typename Map::value_type Number;
  if(const auto origins = find_vertex_property<std::array<std::uint32_t, 2>>(surface, name_of_origins))
    for(const Surface::Vertex_index v : surface.vertices())
    {
      const auto [a, b] = (*origins)[v];
      map[v] = map[Surface::Vertex_index(a)];
      if(std::is_floating_point_v<Number> && a != b)
        map[v] = static_cast<Number>(map[v] / 2 + map[Surface::Vertex_index(b)] / 2);
    }
}

// Calls visit(name, map) for the properties of numbers that a surface has: those that files have besides the points, whose
// names begin with v: in the surface.
template <class Visit>
void visit_vertex_properties(const Surface& surface, const Visit& visit)
{
  for(const std::string& name : surface.properties<Surface::Vertex_index>())
    if(name.compare(0, 2, "v:") == 0)
      visit_vertex_property(surface, name, visit, static_cast<const Any_vertex_property*>(nullptr));
}

} // namespace reeb_graph_program

#endif // CGAL_REEB_GRAPH_SRC_SURFACE_H
