// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_SRC_MESH_GRAPH_OF_H
#define CGAL_REEB_GRAPH_SRC_MESH_GRAPH_OF_H

#include "base/progress_bar.h"
#include "base/stopwatch.h"
#include "computation/Mesh_graph.h"
#include "computation/Report_visitor.h"
#include "computation/arc_columns.h"
#include "computation/augmentation.h"
#include "computation/choose_contours.h"
#include "computation/simplification.h"

#include <CGAL/Reeb_graph/IO/json.h>
#include <CGAL/property_map.h>

#include <cstddef>
#include <functional>
#include <iterator>
#include <memory>
#include <optional>
#include <stdexcept>
#include <type_traits>
#include <utility>
#include <vector>

namespace reeb_graph_program {
// Computes the Reeb graph by compute(np), and adds what it took to the report.
template <class NamedParameters, class Compute>
auto compute_and_time(const NamedParameters& np, Report& report, const Compute& compute)
{
  Report_visitor visitor(report);
  Progress_bar progress_bar("graph");
  const Timed_computation timed(report);
  return compute(np.visitor(std::ref(visitor)).callback(std::ref(progress_bar)));
}

// A Mesh_graph. `Kind` knows the mesh: it has the types Graph and Augmentation, and functions that are called as they
// are here.
template <class Kind>
class Mesh_graph_of : public Mesh_graph
{
  typedef typename Kind::Graph Any_graph;
  typedef typename Kind::Augmentation Any_augmentation;

public:
  Mesh_graph_of(const Mesh& mesh,
                Scalar_map scalar_map,
                const Graph_options& options,
                const Simplification_options& simplification,
                double threshold,
                Report& report)
    : kind_(mesh, scalar_map),
      options_(options),
      given_(new Any_graph(compute(options.are_places_wanted, report))) // not make_shared(), which copies it
  {
    const Stopwatch stopwatch;
    simplified_.emplace(*given_, simplification, threshold);
    if(simplification.is_anything_removed())
      report.seconds.emplace_back("simplify", stopwatch.seconds());
  }

  Mesh_graph_of(const Mesh_graph_of& other, const Simplification_options& simplification, double threshold)
    : kind_(other.kind_),
      options_(other.options_),
      given_places_(other.given_places_),
      given_(other.given_)
  {
    simplified_.emplace(*given_, simplification, threshold);
  }

  std::unique_ptr<Mesh_graph> simplify(const Simplification_options& simplification, double threshold) const override
  {
    return std::make_unique<Mesh_graph_of>(*this, simplification, threshold);
  }

  const Graph& given() const override { return kind_.on_surface(*given_, given_on_surface_); }
  const Graph& result() const override
  {
    return simplified_->simplification() ? kind_.on_surface(simplified_->result(), result_on_surface_) : given();
  }
  double threshold() const override { return simplified_->threshold(); }

  std::vector<std::vector<std::size_t>> chains() const override
  {
    std::vector<std::vector<std::size_t>> chains;
    const Any_graph& graph = simplified_->result();
    for(const auto arc : CGAL::make_range(edges(graph)))
    {
      std::vector<std::size_t>& vertices = chains.emplace_back();
      for(const auto& edge : graph[arc].chain)
      {
        const std::pair<std::size_t, std::size_t> ends = kind_.ends(edge);
        if(vertices.empty() || vertices.back() != ends.first) // where it passes a plateau, it can go on elsewhere
          vertices.push_back(ends.first);
        vertices.push_back(ends.second);
      }
    }
    return chains;
  }

  const std::vector<std::size_t>& given_places() override
  {
    if(!*given_places_)
    {
      Report unused;
      compute(true, unused);
    }
    return **given_places_;
  }

  const std::vector<std::size_t>& places() override
  {
    const auto& simplification = simplified_->simplification();
    if(simplification && !places_)
      places_ = simplified_places(given_places(), *simplification);
    return simplification ? *places_ : given_places();
  }

  const Arc_table& arc_table() override
  {
    if(!arc_table_)
    {
      Arc_table table = table_of_graph(result());
      std::vector<Arc_column> measures = kind_.measure_arcs(
        simplified_->result(), places(), [this]() -> const Any_augmentation& { return augmentation(); });
      std::move(measures.begin(), measures.end(), std::back_inserter(table.columns));
      arc_table_ = std::move(table);
    }
    return *arc_table_;
  }

  Embedding embed(CGAL::Reeb_graph::Embedding_manner manner) override
  {
    Progress_bar progress_bar("embedding");
    const auto np = CGAL::parameters::embedding_manner(manner).callback(std::ref(progress_bar));
    return kind_.embed(augmentation(), np);
  }

  void write_json(std::ostream& stream,
                  const Embedding& embedding,
                  const std::vector<CGAL::Reeb_graph::Attribute>& arc_attributes,
                  double base) override
  {
    std::optional<Any_graph> copy;
    CGAL::Reeb_graph::write_json(stream, augmentation().mesh(), with_base(augmentation().graph(), base, copy),
                                 embedding, kind_.vertex_numbers(), CGAL::parameters::arc_attributes(arc_attributes));
  }

  const Augmentation& surface_augmentation() override
  {
    if constexpr(std::is_same_v<Any_augmentation, Augmentation>)
      return augmentation();
    else
      throw std::logic_error("the mesh is not a surface");
  }

  std::vector<Contour> find_contours(const Contour_choice& choice) override
  {
    return choose_contours(
      augmentation(), [this](const auto& contour) { return convert(contour); }, kind_.scalar_map(), choice,
      [this](const Point& point) { return kind_.nearest_place(point); });
  }

  Critical_set critical_set(std::size_t node) override
  {
    const auto set = augmentation().critical_set(node);
    Critical_set result = {{}, {}, {set.star.begin(), set.star.end()}, kind_.border_loop(set)};
    for(const auto& contour : set.lower_contours)
      result.lower_contours.push_back(convert(contour));
    for(const auto& contour : set.upper_contours)
      result.upper_contours.push_back(convert(contour));
    return result;
  }

private:
  // Keeps the places of the vertices, if they are wanted.
  Any_graph compute(bool are_places_wanted, Report& report) const
  {
    const auto compute = [&](const auto& np) { return kind_.compute(np); };
    const auto np = kind_.named_parameters(options_);
    if(!are_places_wanted)
      return compute_and_time(np, report, compute);
    std::vector<std::size_t> places(kind_.end_of_vertices());
    Any_graph graph = compute_and_time(np.vertex_place_map(CGAL::make_property_map(places)), report, compute);
    *given_places_ = std::move(places);
    return graph;
  }

  Contour convert(const typename Any_augmentation::Contour& contour)
  {
    Contour result = kind_.contour(augmentation(), contour);
    result.arc = get(boost::edge_index, augmentation().graph(), contour.arc);
    result.value = contour.value;
    return result;
  }

  const Any_augmentation& augmentation()
  {
    if(augmentation_)
      return *augmentation_;
    Progress_bar progress_bar("surface");
    const auto np = kind_.named_parameters(options_);
    if(const auto& simplification = simplified_->simplification())
      augmentation_ =
        kind_.augment(simplified_->result(), np.simplification(*simplification).callback(std::ref(progress_bar)));
    else
      augmentation_ = kind_.augment(*given_, np.callback(std::ref(progress_bar)));
    return *augmentation_;
  }

  const Kind kind_;
  const Graph_options options_;
  // Those of the given graph, shared as that is; none while nobody has asked for them.
  const std::shared_ptr<std::optional<std::vector<std::size_t>>> given_places_ =
    std::make_shared<std::optional<std::vector<std::size_t>>>();
  const std::shared_ptr<const Any_graph> given_;
  std::optional<Simplified_graph_of<Any_graph>> simplified_;
  mutable std::optional<Graph> given_on_surface_, result_on_surface_;
  std::unique_ptr<const Any_augmentation> augmentation_;
  std::optional<std::vector<std::size_t>> places_; // in a simplified graph
  std::optional<Arc_table> arc_table_;
};

} // namespace reeb_graph_program

#endif // CGAL_REEB_GRAPH_SRC_MESH_GRAPH_OF_H
