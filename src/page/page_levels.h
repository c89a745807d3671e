// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_SRC_PAGE_LEVELS_H
#define CGAL_REEB_GRAPH_SRC_PAGE_LEVELS_H

#include "page/page_graph.h"

#include <nlohmann/json_fwd.hpp>

namespace reeb_graph_program {
// The graph, and simplified graphs for thresholds that ascend, loops cancelled: all there are if they are few, else
// those of the largest thresholds, and some of the others.
nlohmann::ordered_json page_levels(const Embedded_graph& given,
                                   const Page_frame& frame,
                                   const Value_scale& value_scale);

// The thresholds that matter, each with the last of these levels that it reaches, and whether it is the suggested one.
nlohmann::ordered_json page_ticks(const Graph& graph, const nlohmann::ordered_json& levels);

} // namespace reeb_graph_program

#endif // CGAL_REEB_GRAPH_SRC_PAGE_LEVELS_H
