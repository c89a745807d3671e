// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#include "input/vtk_input.h"

#include "input/File_contents.h"
#include "input/input_error.h"
#include "input/mesh_formats.h"
#include "input/vtk_numbers.h"

#include <algorithm>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace reeb_graph_program {
namespace {
// What begins as XML is XML, whatever the file is called.
Polygon_soup read_any_vtk(const std::string& path, const Vtk_field_choice& choice)
{
  const File_contents file(path);
  const std::string_view text = file.text();
  const std::size_t begin = text.find_first_of("<#");
  return begin != std::string_view::npos && text[begin] == '<' ? read_vtk_xml(path, text, choice)
                                                               : read_vtk_legacy(path, text, choice);
}

} // namespace

void Vtk_field_choice::add(const Vertex_field& field, Polygon_soup& soup) const
{
  const auto is_first = [&](const std::vector<double>& numbers) { // of its name in the piece
    return numbers.size() + field.numbers.size() <= soup.points.size();
  };
  if(!name.empty() && field.name == name && is_first(soup.scalars))
    soup.scalars.insert(soup.scalars.end(), field.numbers.begin(), field.numbers.end());
  if(!are_all_wanted)
    return;
  const auto known = std::find_if(soup.fields.begin(), soup.fields.end(),
                                  [&](const Vertex_field& other) { return other.name == field.name; });
  if(known == soup.fields.end())
    soup.fields.push_back(field);
  else if(is_first(known->numbers))
    known->numbers.insert(known->numbers.end(), field.numbers.begin(), field.numbers.end());
}

Polygon_soup read_vtk(const std::string& path, const std::string& vertex_property)
{
  Field_names names;
  Polygon_soup soup = read_any_vtk(path, {false, vertex_property, &names});
  if(!vertex_property.empty() && soup.scalars.size() != soup.points.size())
    throw Input_error(path, names.message(vertex_property, "cells"));
  return soup;
}

std::vector<Vertex_field> read_vtk_fields(const std::string& path, Field_names& names)
{
  Polygon_soup soup = read_any_vtk(path, {true, "", &names});
  std::vector<Vertex_field> fields;
  for(Vertex_field& field : soup.fields)
    if(field.numbers.size() == soup.points.size() && call_with_vtk_type(field.type, [](auto) {}))
      fields.push_back(std::move(field));
  return fields;
}

} // namespace reeb_graph_program
