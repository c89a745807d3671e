// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_INTERNAL_AUGMENTATION_WAY_BACK_H
#define CGAL_REEB_GRAPH_INTERNAL_AUGMENTATION_WAY_BACK_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/internal/augmentation/Arc_contours.h>
#include <CGAL/Reeb_graph/internal/augmentation/New_places.h>
#include <CGAL/Reeb_graph/internal/augmentation/check_graph.h>
#include <CGAL/Reeb_graph/internal/augmentation/locate_vertices.h>
#include <CGAL/Reeb_graph/internal/base/Progress.h>
#include <CGAL/Reeb_graph/internal/base/named_parameter.h>
#include <CGAL/Reeb_graph/named_parameters.h>
#include <CGAL/Reeb_graph/options.h>

namespace CGAL {
namespace Reeb_graph {
namespace internal {

// What the classes for the way from a graph back to a mesh, or to a complex, have in common: the graph on the complex,
// the contours of its arcs, and what it has been computed with.
template <class GraphOnComplex, class Tracer>
class Way_back
{
public:
  typedef Arc_contours<GraphOnComplex, Tracer> Contours;

  // make_graph_on_complex(progress) returns the graph on the complex, which is not moved. The last arguments are those
  // of the tracer. It throws Graph_mismatch_error if a node or an arc does not fit, and tells the end of the progress
  // otherwise.
  template <class NamedParameters, class MakeGraphOnComplex, class... TracerArguments>
  Way_back(const NamedParameters& np,
           const Progress& progress,
           const MakeGraphOnComplex& make_graph_on_complex,
           const TracerArguments&... arguments)
    : ties_(parameters::choose_parameter(parameters::get_parameter(np, internal::ties), Ties::PERTURB)),
      are_degree_two_nodes_kept_(
        parameters::choose_parameter(parameters::get_parameter(np, internal::keep_degree_two_nodes), false)),
      on_complex_(make_graph_on_complex(progress)),
      contours_(on_complex_, ties_, arguments...),
      new_places_(parameters::get_parameter(np, internal::simplification))
  {
    check_nodes(on_complex_);
    check_arcs(on_complex_, ties_);
    progress.report_end();
  }

  const GraphOnComplex& on_complex() const { return on_complex_; }
  const Contours& contours() const { return contours_; }

  // The value of a vertex that may be one of another mesh.
  double value(typename GraphOnComplex::vertex_descriptor v) const
  {
    return on_complex_.value(checked_number(on_complex_, v));
  }

  template <class ConcurrencyTag, class NamedParameters>
  auto locate_vertices(const NamedParameters& np) const
  {
    return internal::locate_vertices<ConcurrencyTag>(on_complex_, ties_, are_degree_two_nodes_kept_, new_places_,
                                                     Progress(np));
  }

private:
  const Ties ties_;
  const bool are_degree_two_nodes_kept_;
  const GraphOnComplex on_complex_;
  const Contours contours_;
  const New_places new_places_;
};

} // namespace internal
} // namespace Reeb_graph
} // namespace CGAL

#endif // CGAL_REEB_GRAPH_INTERNAL_AUGMENTATION_WAY_BACK_H
