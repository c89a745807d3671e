// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#include "page/page_output.h"

#include "base/progress_bar.h"
#include "computation/simplification.h"
#include "output/output_file.h"
#include "page/page_template.h"

#include <CGAL/Reeb_graph/simplification/simplify.h>

#include <boost/algorithm/string/replace.hpp>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <limits>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace fs = std::filesystem;

namespace reeb_graph_program {
namespace {
// The threshold of persistence at which a graph that is too large for a page has become small enough.
std::optional<double> threshold_for_page(const Graph& given, const Graph& wanted, double least_threshold)
{
  constexpr std::size_t largest_number_of_arcs = 2000;
  if(num_edges(wanted) <= largest_number_of_arcs)
    return std::nullopt;
  constexpr double infinity = std::numeric_limits<double>::infinity();
  std::vector<double> candidates;
  for(const Persistence_pair& pair : find_persistence_pairs(given))
    candidates.push_back((std::max)(std::nextafter(CGAL::Reeb_graph::persistence(given, pair), infinity),
                                    std::isfinite(least_threshold) ? least_threshold : 0));
  std::sort(candidates.begin(), candidates.end());
  const auto are_too_many_left = [&](double threshold) {
    Graph simplified;
    CGAL::Reeb_graph::simplify(given, threshold, simplified, CGAL::parameters::cancel_loops(true));
    return num_edges(simplified) > largest_number_of_arcs;
  };
  return *std::partition_point(candidates.begin(), std::prev(candidates.end()), are_too_many_left);
}

// Bytes that are no UTF-8, as a file name can have, are replaced. JSON has < within strings only, and a script without
// any cannot be ended by them.
std::string script_text(const nlohmann::ordered_json& data)
{
  std::string text = data.dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace);
  boost::replace_all(text, "<", "\\u003c");
  return text;
}

std::string html_text(const nlohmann::ordered_json& string)
{
  // As JSON, it has been made UTF-8.
  const std::string text = string.dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace);
  std::string html = nlohmann::json::parse(text).get<std::string>();
  boost::replace_all(html, "&", "&amp;");
  boost::replace_all(html, "<", "&lt;");
  boost::replace_all(html, ">", "&gt;");
  return html;
}

// Writes the page up to the marker and what stands for it, and returns what follows.
std::string_view write_up_to(std::ostream& stream,
                             std::string_view page,
                             std::string_view marker,
                             std::string_view replacement)
{
  const std::size_t position = (std::min)(page.find(marker), page.size());
  stream << page.substr(0, position);
  if(position == page.size())
    return {};
  stream << replacement;
  return page.substr(position + marker.size());
}

void write_data(const fs::path& path, const nlohmann::ordered_json& data, const std::string& title)
{
  const std::string text = script_text(data);
  write_file(path, [&](std::ostream& stream) {
    const std::string_view body = write_up_to(stream, page_template(), "<!-- title -->", html_text(title));
    stream << write_up_to(stream, body, "<!-- data -->", text);
  });
}

} // namespace

bool is_page_available() { return !page_template().empty(); }

void check_page(const fs::path& path, const std::string& up, bool is_strict)
{
  if(path.empty() && !up.empty())
    throw std::runtime_error("--up goes with --html only");
  if(path.empty() && is_strict)
    throw std::runtime_error("--strict goes with --html only");
  if(path.empty())
    return;
  if(!is_page_available())
    throw std::runtime_error(
      "this program has been built without the page: install three.js, Debian's package libjs-three, or name its "
      "folder by the CMake variable CGAL_REEB_GRAPH_THREE_JS_DIR, and build the program again");
  ending_of(path, "a page", {".html"});
}

void write_page(const fs::path& path, const Page_request& request)
{
  const Progress_bar progress_bar("page");
  const Graph& given = request.graph.given();
  const Graph& wanted = request.graph.result();
  const std::optional<double> threshold = threshold_for_page(given, wanted, request.graph.threshold());
  std::unique_ptr<Mesh_graph> smaller;
  if(threshold)
  {
    Simplification_options options = request.simplification;
    options.threshold = {*threshold, false};
    options.number_of_leaves.reset();
    options.are_loops_cancelled = true;
    smaller = request.graph.simplify(options, *threshold);
  }
  Mesh_graph& shown = smaller ? *smaller : request.graph;
  nlohmann::ordered_json data = page_data(request, shown);
  data["graph"]["is_simplified"] = threshold.has_value();
  data["graph"]["arcs_of_input"] = num_edges(wanted);
  data["graph"]["threshold"] = threshold.value_or(0);
  write_data(path, data, request.title);
}

void write_page(const fs::path& path, const Page_of_skeleton& page)
{
  const Progress_bar progress_bar("page");
  write_data(path, page_data(page), page.title);
}

void write_page(const fs::path& path, const Page_of_shapes& page)
{
  const Progress_bar progress_bar("page");
  write_data(path, page_data(page), page.a.title + " and " + page.b.title);
}

} // namespace reeb_graph_program
