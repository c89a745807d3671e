// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_SRC_VTK_XML_ARRAYS_H
#define CGAL_REEB_GRAPH_SRC_VTK_XML_ARRAYS_H

#include "input/vtk_xml_tags.h"

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace reeb_graph_program {
// The numbers of an element DataArray, as they are in the file.
struct Vtk_xml_array
{
  Xml_tag tag;
  std::string_view text;
};

// Reads the numbers of arrays: as text, in base64 code, or raw, each of which may be behind all elements, and the last
// two compressed by zlib.
class Vtk_xml_arrays
{
public:
  Vtk_xml_arrays(const std::string& path, std::string_view file) : path_(path), file_(file) {}

  // Takes the order of bytes, and whether they are compressed. Throws Input_error if not by zlib.
  void read_file_tag(const Xml_tag& tag);
  // Finds the data behind all elements.
  void read_appended_tag(const Xml_tag& tag);

  // All numbers of an array. `name` is for messages.
  std::vector<double> numbers(const std::string& name, const Vtk_xml_array& array) const;
  std::vector<std::size_t> indices(const std::string& name, const Vtk_xml_array& array) const;

private:
  template <class Number>
  std::vector<Number> read(const std::string& name, const Vtk_xml_array& array) const;
  template <class Number>
  std::vector<Number> read_text(std::string_view text) const;

  std::string path_;
  std::string_view file_, appended_;
  bool are_bytes_swapped_ = false, are_numbers_compressed_ = false, is_appended_raw_ = false;
  std::size_t size_of_header_number_ = 4;
};

} // namespace reeb_graph_program

#endif // CGAL_REEB_GRAPH_SRC_VTK_XML_ARRAYS_H
