// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_SOUP_AUGMENTATION_H
#define CGAL_REEB_GRAPH_SOUP_AUGMENTATION_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/Complex_augmentation.h>
#include <CGAL/Reeb_graph/Soup_contour.h>
#include <CGAL/Reeb_graph/internal/way_back/cells.h>
#include <CGAL/Reeb_graph/named_parameters.h>
#include <CGAL/Reeb_graph_soup_traits.h>

namespace CGAL::Reeb_graph {

/// \ingroup PkgReebGraphAugmentation
///
/// \brief the way from the Reeb graph of a triangle soup back to it.
///
/// A contour is a graph in the triangles, see `Soup_contour`: on a surface a curve, elsewhere curves that meet where an
/// edge has more than two triangles.
///
/// It is constructed as `Complex_augmentation` is, from the points, the triangles, the scalars, the graph, and named
/// parameters.
///
/// \tparam Scalar the type of the scalar values. It is deduced by
///         `Soup_augmentation augmentation(points, triangles, scalars, graph, np)`, as the other types are.
/// \tparam ReebGraph the type `Graph` of the traits class
/// \tparam Traits the traits class: the type of the named parameter `geom_traits`, if that is given
template <class Scalar,
          class ReebGraph = typename Reeb_graph_soup_traits<Scalar>::Graph,
          class Traits = Reeb_graph_soup_traits<Scalar>>
class Soup_augmentation : public Complex_augmentation<internal::Graph_on_triangles<ReebGraph, Traits>>
{
  typedef Complex_augmentation<internal::Graph_on_triangles<ReebGraph, Traits>> Base;

public:
  using Base::Base;
};

#ifndef DOXYGEN_RUNNING
template <class PointsOrNumber,
          class Cells,
          class Scalars,
          class ReebGraph,
          class NamedParameters = parameters::Default_named_parameters>
Soup_augmentation(const PointsOrNumber&,
                  const Cells&,
                  const Scalars&,
                  const ReebGraph&,
                  const NamedParameters& = parameters::default_values())
  -> Soup_augmentation<internal::Value_of_range<Scalars>,
                       ReebGraph,
                       internal::Soup_traits_of<Scalars, NamedParameters>>;
#endif

} // namespace CGAL::Reeb_graph

#endif // CGAL_REEB_GRAPH_SOUP_AUGMENTATION_H
