// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_BENCHMARK_INPUTS_H
#define CGAL_REEB_GRAPH_BENCHMARK_INPUTS_H

#include "meshes_as_they_come.h"

#include "generated_surfaces.h"
#include "generated_surfaces/build_mesh.h"
#include "random_meshes.h"
#include "shuffle.h"

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <random>
#include <string>
#include <vector>

// The surfaces and the fields of the benchmark.
namespace benchmark {
typedef CGAL::Simple_cartesian<double> Kernel;
typedef CGAL::Surface_mesh<Kernel::Point_3> Mesh;
typedef Mesh::Property_map<Mesh::Vertex_index, double> Scalar_map;

inline const std::vector<std::string>& surface_names()
{
  static const std::vector<std::string> names = {"genus-0", "genus-3", "genus-25",   "terrain",   "cells",
                                                 "across",  "sorted",  "subdivided", "decimated", "remeshed"};
  return names;
}

inline const std::vector<std::string>& field_names()
{
  static const std::vector<std::string> names = {"smooth", "height", "noise", "tied"};
  return names;
}

inline generated_surfaces::Triangle_soup make_surface(const std::string& name, std::size_t number_of_vertices)
{
  if(name == "terrain")
  {
    const auto side = static_cast<std::size_t>(std::sqrt(static_cast<double>(number_of_vertices)));
    return generated_surfaces::terrain(side, side);
  }
  if(name == "cells" || name == "across")
    return isosurface(number_of_vertices, name == "across");
  if(name == "sorted")
    return with_sorted_vertices(isosurface(number_of_vertices, false));
  if(name == "subdivided")
    return subdivided_surface(number_of_vertices);
  const std::string genus = name.rfind("genus-", 0) == 0 ? name.substr(6) : "3";
  return generated_surfaces::closed_surface(static_cast<unsigned>(std::stoul(genus)), number_of_vertices);
}

enum class Mesh_order
{
  GENERATED,
  SHUFFLED
};

// A mesh with a field, and its triangles as flat triples.
class Input
{
public:
  Input(const std::string& surface, std::size_t number_of_vertices, Mesh_order order = Mesh_order::GENERATED)
    : surface_(surface)
  {
    auto soup = make_surface(surface, number_of_vertices);
    if(order == Mesh_order::SHUFFLED)
    {
      random_meshes::Random random(1);
      generated_surfaces::shuffle(soup, random);
    }
    generated_surfaces::build(mesh_, soup);
    if(surface == "decimated")
      decimate(mesh_);
    if(surface == "remeshed")
      remesh(mesh_);
    triangles_.reserve(mesh_.number_of_faces());
    for(const Mesh::Face_index f : mesh_.faces())
    {
      const Mesh::Halfedge_index h = mesh_.halfedge(f);
      triangles_.push_back({mesh_.source(h).idx(), mesh_.target(h).idx(), mesh_.target(mesh_.next(h)).idx()});
    }
    scalar_map_ = mesh_.add_property_map<Mesh::Vertex_index, double>("v:scalar").first;
  }

  Input(const Input&) = delete; // the scalar map belongs to the mesh
  Input& operator=(const Input&) = delete;

  void set_field(const std::string& field)
  {
    field_ = field;
    std::mt19937 random(1);
    for(const Mesh::Vertex_index v : mesh_.vertices())
      scalar_map_[v] = field_value(mesh_.point(v), random);
  }

  const std::string& surface() const { return surface_; }
  const std::string& field() const { return field_; }
  const Mesh& mesh() const { return mesh_; }
  const Scalar_map& scalar_map() const { return scalar_map_; }
  const std::vector<std::array<std::uint32_t, 3>>& triangles() const { return triangles_; }

private:
  double field_value(const Kernel::Point_3& p, std::mt19937& random) const
  {
    if(field_ == "height")
      return p.y();
    if(field_ == "noise")
      return static_cast<double>(random());
    const double smooth = std::sin(2 * p.x()) + 0.5 * std::sin(3 * p.y() + p.x()) + 0.1 * p.z();
    return field_ == "smooth" ? smooth : std::floor(20 * smooth);
  }

  std::string surface_, field_;
  Mesh mesh_;
  Scalar_map scalar_map_;
  std::vector<std::array<std::uint32_t, 3>> triangles_;
};

} // namespace benchmark

#endif // CGAL_REEB_GRAPH_BENCHMARK_INPUTS_H
