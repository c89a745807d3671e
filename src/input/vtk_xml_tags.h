// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_SRC_VTK_XML_TAGS_H
#define CGAL_REEB_GRAPH_SRC_VTK_XML_TAGS_H

#include <cstddef>
#include <map>
#include <string>
#include <string_view>

namespace reeb_graph_program {
// The opening tag of an element of XML, and where what it holds begins.
struct Xml_tag
{
  std::string name; // with a slash at its beginning if it closes the element
  std::map<std::string, std::string> attributes;
  std::size_t end = 0;

  std::string attribute(const std::string& key, const std::string& otherwise = std::string()) const
  {
    const auto found = attributes.find(key);
    return found == attributes.end() ? otherwise : found->second;
  }
};

// The next tag of a file from a place on; one without a name at its end. Comments and declarations are left out. Throws
// Input_error. Readers of XML take no file whose end is no XML, as VTK's files with raw data are.
Xml_tag next_tag(const std::string& path, std::string_view text, std::size_t begin);

} // namespace reeb_graph_program

#endif // CGAL_REEB_GRAPH_SRC_VTK_XML_TAGS_H
