// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

// Times of curve skeletons with their certificates, beside CGAL's mean curvature flow skeletons of the same surfaces in the
// same run.
//
// Usage: benchmark_skeletons [REPETITIONS] [NUMBERS OF VERTICES...]

#include "generated_surfaces.h"
#include "generated_surfaces/build_mesh.h"
#include "generated_surfaces/standing_figure.h"
#include "measurements.h"

#include <CGAL/Reeb_graph/skeleton/extract_curve_skeleton.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/extract_mean_curvature_flow_skeleton.h>

#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <string>
#include <vector>

typedef CGAL::Simple_cartesian<double> Kernel;
typedef CGAL::Surface_mesh<Kernel::Point_3> Mesh;

namespace {
void measure(const std::string& name, const generated_surfaces::Triangle_soup& soup, std::size_t repetitions)
{
  const Mesh mesh = generated_surfaces::make_mesh<Mesh>(soup);
  CGAL::Mean_curvature_flow_skeletonization<Mesh>::Skeleton flow;
  CGAL::Reeb_graph::Curve_skeleton<Mesh> skeleton;
  CGAL::Reeb_graph::Skeleton_certificate known;
  benchmark::Sample ours, theirs; // in turns
  for(std::size_t i = 0; i != repetitions; ++i)
  {
    flow.clear();
    theirs.add(benchmark::milliseconds([&] { CGAL::extract_mean_curvature_flow_skeleton(mesh, flow); }));
    ours.add(benchmark::milliseconds([&] { known = CGAL::Reeb_graph::extract_curve_skeleton(mesh, skeleton); }));
  }
  std::printf("%-10s %9zu %12.0f %12.0f %8.2f %6zu %6zu %8zu %8zu\n", name.c_str(),
              std::size_t(mesh.number_of_vertices()), *theirs.median(), *ours.median(),
              *ours.median() / *theirs.median(), known.genus, known.number_of_loops, known.number_of_vertices_outside,
              known.number_of_crossing_edges);
  std::fflush(stdout);
}
} // namespace

int main(int argc, char* argv[])
{
  const std::size_t repetitions = argc > 1 ? std::strtoul(argv[1], nullptr, 10) : 3;
  std::vector<std::size_t> sizes;
  for(int i = 2; i < argc; ++i)
    sizes.push_back(std::strtoul(argv[i], nullptr, 10));
  if(sizes.empty())
    sizes = {20000, 50000};
  std::printf("%-10s %9s %12s %12s %8s %6s %6s %8s %8s\n", "surface", "vertices", "flow [ms]", "ours [ms]", "ratio",
              "genus", "loops", "outside", "crossing");
  for(const std::size_t size : sizes)
  {
    measure("figure", generated_surfaces::standing_figure(size), repetitions);
    measure("genus-3", generated_surfaces::closed_surface(3, size), repetitions);
  }
}
