// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_SRC_MESSAGE_OF_H
#define CGAL_REEB_GRAPH_SRC_MESSAGE_OF_H

#include <exception>
#include <filesystem>
#include <new>
#include <stdexcept>
#include <string>

namespace reeb_graph_program {
// What the user reads of an exception: not the names of functions that some of the standard library have.
inline std::string message_of(const std::exception& error)
{
  if(dynamic_cast<const std::bad_alloc*>(&error) != nullptr
     || dynamic_cast<const std::length_error*>(&error) != nullptr)
    return "out of memory";
  if(const auto* const of_file = dynamic_cast<const std::filesystem::filesystem_error*>(&error))
    return of_file->path1().string() + ": " + of_file->code().message();
  return error.what();
}

} // namespace reeb_graph_program

#endif // CGAL_REEB_GRAPH_SRC_MESSAGE_OF_H
