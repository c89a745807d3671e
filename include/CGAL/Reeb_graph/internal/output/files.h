// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_INTERNAL_OUTPUT_FILES_H
#define CGAL_REEB_GRAPH_INTERNAL_OUTPUT_FILES_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/exceptions.h>

#include <boost/io/ios_state.hpp>

#include <fstream>
#include <locale>
#include <ostream>
#include <string>

namespace CGAL {
namespace Reeb_graph {
namespace internal {

// Lets a stream write numbers as programs read them, whatever its locale is before and after.
class Classic_locale
{
public:
  explicit Classic_locale(std::ostream& out) : saver_(out, std::locale::classic()) {}

private:
  boost::io::ios_locale_saver saver_;
};

template <class Write>
void write_file(const std::string& filename, const Write& write)
{
  std::ofstream out(filename);
  if(out)
    write(out);
  out.close();
  if(!out)
    throw File_error(filename + " cannot be written");
}

} // namespace internal
} // namespace Reeb_graph
} // namespace CGAL

#endif // CGAL_REEB_GRAPH_INTERNAL_OUTPUT_FILES_H
