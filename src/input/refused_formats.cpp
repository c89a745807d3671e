// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#include "input/refused_formats.h"

#include "input/input_error.h"
#include "input/text_input.h"
#include "input/vtk_cells.h"

#include <array>
#include <fstream>
#include <map>
#include <string>

namespace reeb_graph_program {
namespace {
const char* const formats = "the extension of a mesh file is .off, .obj, .ply, .stl, .ts, .mesh, .vtk, .vtu, or .vtp; "
                            "faces and edges are read, and the tetrahedra of .mesh, .vtk, and .vtu, but neither voxels "
                            "nor point clouds";

bool is_freesurfer_surface(const std::string& path)
{
  std::array<char, 3> begin = {};
  std::ifstream(path, std::ios::binary).read(begin.data(), begin.size());
  return begin == std::array<char, 3>{'\xff', '\xff', '\xfe'};
}

std::string convert(const std::string& format, const std::string& tool)
{
  return format + " is not read: " + tool + " converts it; " + formats;
}

} // namespace

std::string refused_format(const std::string& path)
{
  static const std::string trimesh = "trimesh, as by trimesh.load(FILE, force='mesh').export('mesh.ply'),";
  static const std::string meshio = "'meshio convert FILE mesh.vtu'";
  static const std::string freesurfer = "FreeSurfer's 'mris_convert FILE mesh.vtk'";
  static const std::string cloud = convert("a point cloud", "CGAL's or MeshLab's Poisson reconstruction");
  static const std::string voxels = convert("an image of voxels", "ParaView's filter Contour");
  static const std::map<std::string, std::string> others = {{".xyz", cloud},
                                                            {".pcd", cloud},
                                                            {".las", cloud},
                                                            {".laz", cloud},
                                                            {".nii", voxels},
                                                            {".nrrd", voxels},
                                                            {".mha", voxels},
                                                            {".mhd", voxels},
                                                            {".tif", voxels},
                                                            {".glb", convert("glTF", trimesh)},
                                                            {".gltf", convert("glTF", trimesh)},
                                                            {".3mf", convert("3MF", trimesh)},
                                                            {".gii", convert("GIFTI", freesurfer)},
                                                            {".msh", convert("a mesh of Gmsh", meshio)},
                                                            {".vti", refused_vtk_type("ImageData")},
                                                            {".vtr", refused_vtk_type("RectilinearGrid")},
                                                            {".vts", refused_vtk_type("StructuredGrid")},
                                                            {".vtm", refused_vtk_type("vtkMultiBlockDataSet")},
                                                            {".pvtu", refused_vtk_type("PUnstructuredGrid")},
                                                            {".pvtp", refused_vtk_type("PPolyData")}};
  const auto found = others.find(lower_case_extension(path));
  if(found != others.end())
    return found->second;
  return is_freesurfer_surface(path) ? convert("a surface of FreeSurfer", freesurfer) : formats;
}

std::string refused_vtk_type(const std::string& type)
{
  const bool is_list = type.substr(0, 1) == "P" || type.substr(0, 3) == "vtk" || type == "Collection";
  return "data of VTK's type " + quote(type) + " are not read, but UnstructuredGrid and PolyData: "
       + (is_list ? "the file names others, which ParaView's filters Merge Blocks and Extract Surface join"
                  : vtk_way_out);
}

} // namespace reeb_graph_program
