// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_SRC_LOCAL_INPUT_H
#define CGAL_REEB_GRAPH_SRC_LOCAL_INPUT_H

#include "base/options.h"
#include "mpi/Local_mesh.h"
#include "mpi/local_files.h"
#include "mpi/ranks.h"

namespace reeb_graph_program {
// The field as a function of the points, if it is a coordinate or height. Throws Parameter_error.
Field_of_point field_of_point(const Input_options& options);

// Each rank reads its own part of the mesh and of the field: of a binary PLY file, or of a raw file. All of them throw
// the same exception if there is something wrong with the file or with the options. Collective.
Local_mesh read_local_mesh(const Communicator& communicator, const Input_options& options);

} // namespace reeb_graph_program

#endif // CGAL_REEB_GRAPH_SRC_LOCAL_INPUT_H
