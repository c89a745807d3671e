// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_SRC_SKELETON_OUTPUT_H
#define CGAL_REEB_GRAPH_SRC_SKELETON_OUTPUT_H

#include "base/report.h"
#include "computation/skeleton.h"

#include <filesystem>
#include <iosfwd>
#include <string>
#include <vector>

namespace reeb_graph_program {
// The report of a skeleton, with what certifies it, and a table of its arcs.
struct Skeleton_report : Work_report
{
  std::string field; // its name
  Skeleton skeleton;
};

// Throws std::runtime_error, which names the formats, unless the file name ends with one of them.
void check_skeleton_format(const std::filesystem::path& path);
void check_path_format(const std::filesystem::path& path);

// Writes a .swc, .vtp, .polylines.txt, .graphml, or .csv file.
// If there are paths, the files .vtp and .polylines.txt have these.
void write_skeleton(const std::filesystem::path& path, const Skeleton& skeleton, const Swc_options& options = {});

// Writes the surface as .ply or .vtp, with the branch of each face, the same as its arc, but -1 in junctions, and whether it
// is in one.
void write_skeleton_mesh(const std::filesystem::path& path, const Surface& surface, const Skeleton& skeleton);

// Notes what such a file has no room for: loops of trees, radii of polylines.
void note_lost_parts(const std::filesystem::path& path, const Skeleton& skeleton, std::vector<std::string>& notes);

// Notes the branches for which there is no piece, as no face is nearest to them.
void note_branches_without_face(const Skeleton& skeleton, std::vector<std::string>& notes);

// Notes how many components are inside out.
void note_inside_out(const Skeleton& skeleton, std::vector<std::string>& notes);

// Notes lengths, areas and volumes that are too large or too small for a double.
void note_lost_numbers(const Skeleton& skeleton, std::vector<std::string>& notes);

void write_text(std::ostream& out, const Skeleton_report& report);
void write_json(std::ostream& out, const Skeleton_report& report);

} // namespace reeb_graph_program

#endif // CGAL_REEB_GRAPH_SRC_SKELETON_OUTPUT_H
