// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#include "input/vtk_xml_tags.h"

#include "input/input_error.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <string>
#include <string_view>
#include <utility>

namespace reeb_graph_program {
namespace {
// The end of the tag that begins at a place: the first closing bracket that is not in a quoted value.
std::size_t end_of_tag(std::string_view text, std::size_t place)
{
  char quotation = '\0';
  for(; place < text.size(); ++place)
  {
    const char c = text[place];
    if(quotation == '\0' && c == '>')
      return place;
    if(quotation == '\0' && (c == '"' || c == '\''))
      quotation = c;
    else if(c == quotation)
      quotation = '\0';
  }
  return std::string_view::npos;
}

std::string decode_entities(std::string_view text)
{
  static constexpr std::array<std::pair<std::string_view, char>, 5> entities = {
    {{"&lt;", '<'}, {"&gt;", '>'}, {"&quot;", '"'}, {"&apos;", '\''}, {"&amp;", '&'}}};
  std::string decoded;
  while(!text.empty())
  {
    const auto found = std::find_if(entities.begin(), entities.end(), [&](const auto& entity) {
      return text.substr(0, entity.first.size()) == entity.first;
    });
    decoded += found == entities.end() ? text.front() : found->second;
    text.remove_prefix(found == entities.end() ? 1 : found->first.size());
  }
  return decoded;
}

} // namespace

Xml_tag next_tag(const std::string& path, std::string_view text, std::size_t begin)
{
  Xml_tag tag;
  for(begin = text.find('<', begin); begin != std::string_view::npos; begin = text.find('<', begin + 1))
  {
    if(text.substr(begin, 4) == "<!--")
      begin = std::min(text.find("-->", begin), text.size());
    else if(text.substr(begin, 2) != "<?" && text.substr(begin, 2) != "<!")
      break;
  }
  tag.end = end_of_tag(text, begin);
  if(tag.end == std::string_view::npos)
    return tag;
  std::string_view inside = text.substr(begin + 1, tag.end++ - begin - 1);
  const std::size_t end_of_name = inside.find_first_of(" \t\r\n");
  tag.name = std::string(inside.substr(0, end_of_name));
  inside.remove_prefix(std::min(end_of_name, inside.size()));
  for(std::size_t equals = inside.find('='); equals != std::string_view::npos; equals = inside.find('='))
  {
    const std::size_t quotation = inside.find_first_of("\"'", equals);
    const std::size_t end =
      quotation == std::string_view::npos ? quotation : inside.find(inside[quotation], quotation + 1);
    if(end == std::string_view::npos)
      throw Input_error(path, "an attribute of XML has no end");
    std::string_view key = inside.substr(0, equals);
    key.remove_prefix(std::min(key.find_first_not_of(" \t\r\n"), key.size()));
    key = key.substr(0, key.find_first_of(" \t\r\n"));
    tag.attributes[std::string(key)] = decode_entities(inside.substr(quotation + 1, end - quotation - 1));
    inside.remove_prefix(end + 1);
  }
  return tag;
}

} // namespace reeb_graph_program
