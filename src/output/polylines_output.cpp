// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#include "output/polylines_output.h"

#include "output/output_file.h"

#include <CGAL/Reeb_graph/IO/polylines.h>
#include <CGAL/Reeb_graph/internal/io/text.h>

#include <cstddef>
#include <ostream>

namespace reeb_graph_program {
void check_polylines_format(const std::string& path) { ending_of(path, "polylines", {".polylines.txt", ".csv"}); }

void write_polylines(const std::string& path, const std::vector<Polyline>& polylines)
{
  write_file(path, [&](std::ostream& stream) {
    if(ending_of(path, "polylines", {".polylines.txt", ".csv"}) != ".csv")
      return CGAL::Reeb_graph::write_polylines(stream, polylines);
    CGAL::Reeb_graph::internal::Text_output text(stream);
    text << "curve,x,y,z\n";
    for(std::size_t i = 0; i < polylines.size(); ++i)
      for(const Point& p : polylines[i])
        text << i << ',' << p.x() << ',' << p.y() << ',' << p.z() << '\n';
    text.flush();
  });
}

} // namespace reeb_graph_program
