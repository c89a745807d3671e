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

#include <cerrno>
#include <fstream>
#include <locale>
#include <ostream>
#include <string>
#include <system_error>

namespace CGAL {
namespace Reeb_graph {
namespace internal {

// Lets a stream write numbers as programs read them, whatever its locale is before and after. A stream that has failed
// keeps this locale: to set another one on a full disk would break its buffer, which then throws std::bad_cast.
class Classic_locale
{
public:
  explicit Classic_locale(std::ostream& out) : out_(out), before_(out.getloc())
  {
    if(out.flush())
      out.imbue(std::locale::classic());
  }
  ~Classic_locale()
  {
    try
    {
      if(out_.flush())
        out_.imbue(before_);
    }
    catch(...) // The state of the stream tells it, too.
    {}
  }
  Classic_locale(const Classic_locale&) = delete;
  Classic_locale& operator=(const Classic_locale&) = delete;

private:
  std::ostream& out_;
  std::locale before_;
};

// Says why, where the system does.
template <class Write>
void write_file(const std::string& filename, const Write& write)
{
  errno = 0;
  std::ofstream out(filename);
  if(out)
    write(out);
  out.close();
  if(!out)
    throw File_error(filename + " cannot be written"
                     + (errno == 0 ? "" : ": " + std::generic_category().message(errno)));
}

} // namespace internal
} // namespace Reeb_graph
} // namespace CGAL

#endif // CGAL_REEB_GRAPH_INTERNAL_OUTPUT_FILES_H
