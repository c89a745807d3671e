// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_TEST_FIELD_SAMPLES_H
#define CGAL_REEB_GRAPH_TEST_FIELD_SAMPLES_H

#include "field_checks.h"
#include "mesh_builders.h"
#include "random_meshes.h"

#include <CGAL/boost/graph/properties.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <utility>
#include <vector>

// Surfaces that scalar fields are tested on, and maps for fields and vectors on them.
namespace field_samples {
using namespace field_checks;
using mesh_builders::Surface_mesh;
typedef mesh_builders::Kernel::Vector_3 Vector_3;
typedef std::vector<std::pair<Surface_mesh::Vertex_index, double>> Constraints;
typedef Surface_mesh::Property_map<Surface_mesh::Vertex_index, double> Field_map;

template <class Mesh>
auto vertex_map(const Mesh& mesh)
{
  return get(CGAL::dynamic_vertex_property_t<double>(), mesh);
}

template <class Mesh>
auto face_vector_map(const Mesh& mesh)
{
  return get(CGAL::dynamic_face_property_t<Vector_3>(), mesh);
}

inline double length(const Vector_3& vector) { return std::sqrt(vector.squared_length()); }

inline Triangle_soup noisy_surface()
{
  Random random(5);
  return with_noise(generated_surfaces::closed_surface(2, 800), 0.01, random);
}

// The unit sphere: an octahedron each of whose faces is cut into `size` squared ones.
inline Triangle_soup sphere(std::size_t size)
{
  std::map<std::array<long, 3>, std::size_t> names;
  Triangle_soup soup;
  const auto n = static_cast<long>(size);
  const auto vertex = [&](long x, long y, long sx, long sy, long sz) {
    const std::array<long, 3> key = {sx * x, sy * y, sz * (n - x - y)};
    const auto [it, is_new] = names.emplace(key, soup.points.size());
    if(is_new)
    {
      const double norm = std::sqrt(static_cast<double>(key[0] * key[0] + key[1] * key[1] + key[2] * key[2]));
      soup.points.push_back({key[0] / norm, key[1] / norm, key[2] / norm});
    }
    return it->second;
  };
  for(long sx : {-1, 1})
    for(long sy : {-1, 1})
      for(long sz : {-1, 1})
        for(long x = 0; x < n; ++x)
          for(long y = 0; x + y < n; ++y)
            for(const bool is_upright : {true, false})
            {
              if(!is_upright && x + y + 2 > n)
                continue;
              std::array<std::size_t, 3> t = {is_upright ? vertex(x, y, sx, sy, sz) : vertex(x + 1, y + 1, sx, sy, sz),
                                              is_upright ? vertex(x + 1, y, sx, sy, sz) : vertex(x, y + 1, sx, sy, sz),
                                              is_upright ? vertex(x, y + 1, sx, sy, sz) : vertex(x + 1, y, sx, sy, sz)};
              if(sx * sy * sz < 0)
                std::swap(t[0], t[1]);
              soup.triangles.push_back(t);
            }
  return soup;
}

// A flat square of side 1.
inline Triangle_soup square(std::size_t size, double randomness)
{
  Random random(size);
  const double n = static_cast<double>(size);
  return generated_surfaces::internal::grid(size + 1, size + 1, false, false, [&](std::size_t x, std::size_t y) {
    const auto move = [&](std::size_t i) {
      const double moved = static_cast<double>(i) + randomness * (random_unit(random) - 0.5);
      return i == 0 || i == size ? static_cast<double>(i) / n : moved / n;
    };
    return std::array<double, 3>{move(x), move(y), 0};
  });
}

inline Triangle_soup small_surface() { return generated_surfaces::closed_surface(1, 200); }

inline Surface_mesh small_mesh() { return mesh_builders::make_mesh<Surface_mesh>(small_surface()); }

} // namespace field_samples

#endif // CGAL_REEB_GRAPH_TEST_FIELD_SAMPLES_H
