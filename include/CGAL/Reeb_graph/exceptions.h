// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_EXCEPTIONS_H
#define CGAL_REEB_GRAPH_EXCEPTIONS_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/Error.h>
#include <CGAL/Reeb_graph/graph_exceptions.h>
#include <CGAL/Reeb_graph/mesh_exceptions.h>

#include <cstddef>
#include <string>

namespace CGAL {
namespace Reeb_graph {

/// \addtogroup PkgReebGraphExceptions
/// @{

/// \brief thrown if the named parameter `callback` returns `false`.
class Cancelled_error : public Error
{
public:
  Cancelled_error() : Error("the computation has been cancelled") {} ///< constructs the exception.
};

/// \brief thrown if there is not one number of an attribute for each arc, vertex, or face.
class Attribute_count_error : public Error
{
public:
  /// constructs the exception from the name of the attribute, and how many numbers there are and should be.
  Attribute_count_error(const std::string& name, std::size_t given, std::size_t needed)
    : Error("the attribute " + name + " has " + std::to_string(given) + " numbers instead of " + std::to_string(needed))
  {}
};

/// \brief thrown for a file that cannot be read or written, or that has no graph of the mesh.
class File_error : public Error
{
public:
  /// constructs the error with a message.
  explicit File_error(const std::string& message) : Error(message) {}
};

/// @}

} // namespace Reeb_graph
} // namespace CGAL

#endif // CGAL_REEB_GRAPH_EXCEPTIONS_H
