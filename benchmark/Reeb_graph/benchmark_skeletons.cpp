// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

// Times of curve skeletons with their certificates, beside CGAL's mean curvature flow skeletons of the same surfaces in the
// same run; and, of meshes in files, how good both are: how far they are from the middle, how much they turn, and how much
// of them is inside. Those of the manual are characters among the meshes that CGAL comes with. How many ends are missing, and
// false: of such characters that have been looked at, and of balls and tubes with spikes.
//
// Usage: benchmark_skeletons [REPETITIONS] [NUMBERS OF VERTICES | FILES...], or benchmark_skeletons ends [FILES...]

#include "generated_surfaces.h"
#include "generated_surfaces/build_mesh.h"
#include "generated_surfaces/standing_figure.h"
#include "measurements.h"
#include "quadruped_samples.h"
#include "skeleton_quality.h"
#include "tube_samples.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Reeb_graph/skeleton/extract_curve_skeleton.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>
#include <CGAL/boost/graph/split_graph_into_polylines.h>
#include <CGAL/extract_mean_curvature_flow_skeleton.h>

#include <array>
#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <functional>
#include <map>
#include <string>
#include <utility>
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

typedef CGAL::Exact_predicates_inexact_constructions_kernel Exact_kernel;
typedef CGAL::Surface_mesh<Exact_kernel::Point_3> Exact_mesh;
typedef benchmark::Skeleton_judge<Exact_kernel, Exact_mesh> Judge;
typedef CGAL::Mean_curvature_flow_skeletonization<Mesh>::Skeleton Flow_skeleton;

Exact_kernel::Point_3 converted(const Kernel::Point_3& p) { return {p.x(), p.y(), p.z()}; }

// Takes the polylines of a graph.
struct Line_taking
{
  const Flow_skeleton& graph;
  Judge::Lines& lines;

  void start_new_polyline() { lines.emplace_back(); }
  void add_node(Flow_skeleton::vertex_descriptor v) { lines.back().push_back(converted(graph[v].point)); }
  void end_polyline() {}
};

Judge::Lines lines_of(const Flow_skeleton& flow)
{
  Judge::Lines lines;
  Line_taking taking{flow, lines};
  CGAL::split_graph_into_polylines(flow, taking);
  return lines;
}

Judge::Lines lines_of(const CGAL::Reeb_graph::Curve_skeleton<Mesh>& skeleton)
{
  Judge::Lines lines;
  for(const auto& arc : skeleton_arcs(skeleton))
  {
    lines.emplace_back();
    for(const auto v : arc)
      lines.back().push_back(converted(skeleton[v].point));
  }
  return lines;
}

void print_quality(const char* name, const benchmark::Skeleton_quality& quality, double turning, double milliseconds)
{
  std::printf("  %-10s %9.3f %9.2f %8.1f %% %6zu %9.0f\n", name, quality.centered, quality.turning / turning,
              100 * quality.inside, quality.ends, milliseconds);
}

void compare(const std::string& path, std::size_t repetitions)
{
  Mesh mesh;
  Exact_mesh exact;
  if(!CGAL::IO::read_polygon_mesh(path, mesh) || !CGAL::IO::read_polygon_mesh(path, exact))
  {
    std::fprintf(stderr, "%s cannot be read\n", path.c_str());
    std::exit(EXIT_FAILURE);
  }
  const Judge judge(exact);
  const std::size_t samples = 500;
  benchmark::Skeleton_quality quality_of_flow;
  benchmark::Sample times, turnings; // The flow differs from run to run.
  for(std::size_t i = 0; i != repetitions; ++i)
  {
    Flow_skeleton flow;
    times.add(benchmark::milliseconds([&] { CGAL::extract_mean_curvature_flow_skeleton(mesh, flow); }));
    quality_of_flow = judge(lines_of(flow), samples);
    turnings.add(quality_of_flow.turning);
  }
  std::printf("%s, %zu vertices\n", path.c_str(), std::size_t(mesh.number_of_vertices()));
  print_quality("flow", quality_of_flow, *turnings.median(), *times.median());
  for(const double smooth : {0., 1.})
  {
    CGAL::Reeb_graph::Curve_skeleton<Mesh> skeleton;
    const double time = benchmark::milliseconds(
      [&] { CGAL::Reeb_graph::extract_curve_skeleton(mesh, skeleton, CGAL::parameters::smooth(smooth)); });
    print_quality(smooth > 0 ? "ours" : "not moved", judge(lines_of(skeleton), samples), *turnings.median(), time);
  }
  std::fflush(stdout);
}

// The ends of characters that a person counts, and those with the ones that another person could count, too.
const std::map<std::string, std::array<std::size_t, 2>> ends_by_eye = {
  {"armadillo", {18, 18}}, {"bear", {6, 6}},    {"bull", {8, 12}},      {"cactus", {4, 4}},
  {"camel", {12, 13}},     {"cow", {10, 14}},   {"dino", {12, 12}},     {"diplodocus", {6, 6}},
  {"elephant", {8, 9}},    {"homer", {11, 12}}, {"triceratops", {8, 8}}};

// Errors by the number of ends of each shape.
struct Errors_of_ends
{
  std::size_t all = 0, missing = 0, excess = 0;

  void add(const Mesh& mesh, double ratio, std::size_t least, std::size_t most)
  {
    CGAL::Reeb_graph::Curve_skeleton<Mesh> skeleton;
    const auto parameters = CGAL::parameters::pruning_ratio(ratio);
    const std::size_t found = CGAL::Reeb_graph::extract_curve_skeleton(mesh, skeleton, parameters).number_of_ends;
    all += least;
    missing += found < least ? least - found : 0;
    excess += found > most ? found - most : 0;
  }
};

void count_ends(const std::vector<std::string>& files)
{
  std::printf("%-6s %-10s %5s %8s %6s\n", "ratio", "shapes", "ends", "missing", "false");
  for(const double ratio : {0.3, 0.5})
  {
    Errors_of_ends characters, spikes, quadrupeds;
    for(const std::string& file : files)
    {
      Mesh mesh;
      const auto known = ends_by_eye.find(std::filesystem::path(file).stem().string());
      if(known != ends_by_eye.end() && CGAL::IO::read_polygon_mesh(file, mesh))
        characters.add(mesh, ratio, known->second[0], known->second[1]);
      else
        std::fprintf(stderr, "%s is no character whose ends are known\n", file.c_str());
    }
    for(const bool is_ball : {false, true})
      for(const double radius : {0.2, 0.35})
        for(const double height : {0.25, 0.5, 0.75, 1.5, 2., 3., 5.})
        {
          if(is_ball && height < 1) // has no axis
            continue;
          const auto sample = tube_samples::spiked(is_ball, radius, height);
          spikes.add(generated_surfaces::make_mesh<Mesh>(tube_samples::surface(sample, 0.01, 7)), ratio, sample.ends,
                     sample.ends);
        }
    for(std::size_t seed = 0; seed != 200; ++seed)
    {
      auto animal = quadruped_samples::quadruped(seed);
      const auto soup = quadruped_samples::surface(animal, seed);
      quadrupeds.add(generated_surfaces::make_mesh<Mesh>(soup), ratio, animal.tips.size(), animal.tips.size());
    }
    for(const auto& [name, errors] :
        {std::pair("characters", characters), std::pair("spikes", spikes), std::pair("quadrupeds", quadrupeds)})
      std::printf("%-6.1f %-10s %5zu %8zu %6zu\n", ratio, name, errors.all, errors.missing, errors.excess);
  }
}
} // namespace

int main(int argc, char* argv[])
{
  if(argc > 1 && std::string(argv[1]) == "ends")
  {
    count_ends({argv + 2, argv + argc});
    return EXIT_SUCCESS;
  }
  const std::size_t repetitions = argc > 1 ? std::strtoul(argv[1], nullptr, 10) : 3;
  std::vector<std::size_t> sizes;
  std::vector<std::string> files;
  for(int i = 2; i < argc; ++i)
    if(const std::size_t size = std::strtoul(argv[i], nullptr, 10))
      sizes.push_back(size);
    else
      files.push_back(argv[i]);
  if(!files.empty())
    std::printf("  %-10s %9s %9s %10s %6s %9s\n", "lines", "centered", "turning", "inside", "ends", "[ms]");
  for(const std::string& file : files)
    compare(file, repetitions);
  if(sizes.empty() && !files.empty())
    return EXIT_SUCCESS;
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
