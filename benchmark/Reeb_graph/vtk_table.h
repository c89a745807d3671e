// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_BENCHMARK_VTK_TABLE_H
#define CGAL_REEB_GRAPH_BENCHMARK_VTK_TABLE_H

#include "Table.h"
#include "inputs.h"
#include "measurements.h"
#include "tables.h"
#include "timed_runs.h"

#include <vtkCellArray.h>
#include <vtkDoubleArray.h>
#include <vtkIdList.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkReebGraph.h>

#include <cstddef>
#include <string>

// vtkReebGraph beside our own graph, at a size of its own, as its time can grow like the square of it.
namespace benchmark {
inline void copy_to_vtk(const Input& input, vtkPolyData* surface, vtkDoubleArray* scalars)
{
  vtkNew<vtkPoints> points;
  for(const Mesh::Vertex_index v : input.mesh().vertices())
  {
    const Kernel::Point_3& p = input.mesh().point(v);
    points->InsertNextPoint(p.x(), p.y(), p.z());
    scalars->InsertNextValue(input.scalar_map()[v]);
  }
  vtkNew<vtkCellArray> triangles;
  for(const auto& t : input.triangles())
    triangles->InsertNextCell({vtkIdType(t[0]), vtkIdType(t[1]), vtkIdType(t[2])});
  surface->SetPoints(points);
  surface->SetPolys(triangles);
  surface->BuildCells();
}

// Returns the number of arcs.
inline std::size_t run_vtk(vtkPolyData* surface, vtkDoubleArray* scalars, Sample& times)
{
  vtkNew<vtkReebGraph> graph;
  times.add(milliseconds([&] { graph->Build(surface, scalars); }));
  return static_cast<std::size_t>(graph->GetNumberOfEdges());
}

inline void print_vtk(const Options& options, std::size_t size)
{
  const Table table("Beside vtkReebGraph, one thread", {{"surface", "", 8},
                                                        {"field", "", 6},
                                                        {"vertices", "", 8},
                                                        {"arcs", "", 7},
                                                        {"arcs", "VTK", 7},
                                                        {"trees", "ms", 7},
                                                        {"VTK", "ms", 9},
                                                        {"VTK", "/ trees", 7}});
  for(const std::string& surface : options.surfaces)
  {
    Input input(surface, size);
    for(const std::string& field : options.fields)
    {
      input.set_field(field);
      vtkNew<vtkPolyData> vtk_surface;
      vtkNew<vtkDoubleArray> scalars;
      copy_to_vtk(input, vtk_surface, scalars);
      const std::size_t number_of_arcs = num_edges(find_properties(input).graph);
      Engine_times ours;
      Sample theirs;
      std::size_t number_of_vtk_arcs = 0;
      for(std::size_t repetition = 0; repetition != options.number_of_repetitions; ++repetition)
      {
        run_engine(input, Method::CONTOUR_TREES, 1, ours);
        number_of_vtk_arcs = run_vtk(vtk_surface, scalars, theirs);
      }
      table.print_row({surface, field, cell(std::size_t(input.mesh().number_of_vertices())), cell(number_of_arcs),
                       cell(number_of_vtk_arcs), cell(ours.total.median(), 1), cell(theirs.median(), 1),
                       cell(ratio(theirs.median(), ours.total.median()), 0)});
    }
  }
}

} // namespace benchmark

#endif // CGAL_REEB_GRAPH_BENCHMARK_VTK_TABLE_H
