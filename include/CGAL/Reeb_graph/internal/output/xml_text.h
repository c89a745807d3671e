// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_INTERNAL_OUTPUT_XML_TEXT_H
#define CGAL_REEB_GRAPH_INTERNAL_OUTPUT_XML_TEXT_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/internal/output/utf8.h>

#include <string>

namespace CGAL {
namespace Reeb_graph {
namespace internal {

// The text in UTF-8, with spaces for the control characters that XML does not allow; entities are left to the caller.
inline std::string xml_characters(const std::string& text)
{
  std::string result = to_utf8(text);
  for(char& c : result)
    if(static_cast<unsigned char>(c) < 0x20 && c != '\n' && c != '\t')
      c = ' ';
  return result;
}

} // namespace internal
} // namespace Reeb_graph
} // namespace CGAL

#endif // CGAL_REEB_GRAPH_INTERNAL_OUTPUT_XML_TEXT_H
