// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_SRC_REFUSED_FORMATS_H
#define CGAL_REEB_GRAPH_SRC_REFUSED_FORMATS_H

#include <string>

namespace reeb_graph_program {
// What is said of a file whose extension is that of no format that is read: what it is, and what converts it, where that
// is known.
std::string refused_format(const std::string& path);

// The same of a VTK file by the type of data that is in it, such as ImageData.
std::string refused_vtk_type(const std::string& type);

} // namespace reeb_graph_program

#endif // CGAL_REEB_GRAPH_SRC_REFUSED_FORMATS_H
