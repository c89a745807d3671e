// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_SRC_PAGE_TEMPLATE_H
#define CGAL_REEB_GRAPH_SRC_PAGE_TEMPLATE_H

#include <string_view>

namespace reeb_graph_program {
// The page in HTML, with the markers <!-- title --> and <!-- data --> where these go; empty if the program has been
// built without it.
std::string_view page_template();

} // namespace reeb_graph_program

#endif // CGAL_REEB_GRAPH_SRC_PAGE_TEMPLATE_H
