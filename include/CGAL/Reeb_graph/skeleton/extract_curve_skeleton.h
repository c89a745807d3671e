// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_SKELETON_EXTRACT_CURVE_SKELETON_H
#define CGAL_REEB_GRAPH_SKELETON_EXTRACT_CURVE_SKELETON_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/exceptions.h>
#include <CGAL/Reeb_graph/internal/base/Progress.h>
#include <CGAL/Reeb_graph/internal/base/Threads.h>
#include <CGAL/Reeb_graph/internal/complex/Flat_mesh.h>
#include <CGAL/Reeb_graph/named_parameters.h>
#include <CGAL/Reeb_graph/skeleton/Curve_skeleton.h>
#include <CGAL/Reeb_graph/skeleton/internal/Component_filling.h>
#include <CGAL/Reeb_graph/skeleton/internal/Component_skeleton.h>
#ifndef CGAL_REEB_GRAPH_ARE_SKELETONS_COMPILED
#include <CGAL/Reeb_graph/skeleton/internal/make_component_skeleton.h>
#endif
#include <CGAL/Reeb_graph/skeleton/measure_branches.h>
#include <CGAL/Reeb_graph_traits.h>

#include <CGAL/number_utils.h>

#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL::Reeb_graph {
namespace internal::skeleton {

template <class NamedParameters>
Skeleton_options choose_options(const NamedParameters& np)
{
  using parameters::choose_parameter;
  using parameters::get_parameter;
  Skeleton_options options;
  options.pruning_ratio = choose_parameter(get_parameter(np, internal::pruning_ratio), options.pruning_ratio);
  options.sampling_ratio = choose_parameter(get_parameter(np, internal::sampling_ratio), options.sampling_ratio);
  options.spacing = choose_parameter(get_parameter(np, internal::spacing), options.spacing);
  options.smooth = choose_parameter(get_parameter(np, internal::smooth), options.smooth);
  options.are_borders_ends = choose_parameter(get_parameter(np, internal::ends_at_borders), options.are_borders_ends);
  if(!(options.pruning_ratio >= 0))
    throw Parameter_error("the pruning ratio has to be at least 0");
  if(!(options.sampling_ratio >= 0.01 && options.sampling_ratio <= 100))
    throw Parameter_error("the sampling ratio has to be from 0.01 to 100");
  if(!(options.spacing >= 0))
    throw Parameter_error("the spacing has to be at least 0");
  if(!(options.smooth >= 0 && options.smooth <= 100))
    throw Parameter_error("the smoothness has to be from 0 to 100");
  return options;
}

// A mesh that has been checked, with its points and, if a scalar map is given, values as numbers.
template <class FaceListGraph, class NamedParameters>
class Surface_reading
{
public:
  Surface_reading(const FaceListGraph& mesh, const NamedParameters& np)
    : flat_(flatten(Threads(), mesh, scalar_map(np), traits(np), np))
  {
    const std::vector<Point> points = read_points<Point>(mesh, choose_point_map(mesh, np));
    points_.resize(complex().number_of_vertices());
    std::size_t position = 0;
    for(const Vertex_index v : complex().vertices())
      if(complex().has_vertex(v))
        points_[v] = points[position++];
  }

  const auto& complex() const { return flat_.mesh->complex; }
  const Indexed_vector<Vertex_index, Point>& points() const { return points_; }
  auto vertex(Index number) const { return flat_.mesh->numbers.vertices[Vertex_index(number)]; }

  void set_values(Filled_component& component) const
  {
    if constexpr(has_values)
    {
      double size = 0;
      for(const Index v : component.given)
      {
        component.values.push_back(CGAL::to_double(flat_.field.value(Vertex_index(v))));
        if(!std::isfinite(component.values.back()))
          throw Non_finite_scalar_error(complex().position(Vertex_index(v)));
        size = (std::max)(size, std::abs(component.values.back()));
      }
      for(double& value : component.values) // so that no difference overflows
        value = std::scalbn(value, size > 0 ? -std::ilogb(size) : 0);
    }
  }

private:
  static constexpr bool has_values =
    is_given<decltype(parameters::get_parameter(std::declval<const NamedParameters&>(), internal_np::scalar_map))>;

  static auto scalar_map(const NamedParameters& np)
  {
    typedef typename boost::graph_traits<FaceListGraph>::vertex_descriptor vertex_descriptor;
    return parameters::choose_parameter(parameters::get_parameter(np, internal_np::scalar_map),
                                        boost::static_property_map<double, vertex_descriptor>(0));
  }
  typedef decltype(scalar_map(std::declval<const NamedParameters&>())) Scalar_map;
  typedef Reeb_graph_traits<FaceListGraph, Scalar_map> Traits;
  static Traits traits(const NamedParameters&) { return Traits(); }

  Flat_values<FaceListGraph, typename Traits::Scalar> flat_;
  Indexed_vector<Vertex_index, Point> points_;
};

template <class Reading, class CurveSkeleton>
void add_component(const Reading& reading,
                   const std::vector<Index>& given,
                   const Component_skeleton& part,
                   CurveSkeleton& skeleton,
                   Skeleton_certificate& certificate)
{
  const std::size_t first = num_vertices(skeleton);
  typedef typename boost::vertex_bundle_type<CurveSkeleton>::type Vertex;
  for(const Component_skeleton::Vertex& v : part.vertices)
  {
    Vertex& added = skeleton[add_vertex(skeleton)];
    added.point = decltype(added.point)(v.point.x(), v.point.y(), v.point.z());
    added.radius = v.radius;
    added.inscribed_radius = v.inscribed_radius;
    added.arc = v.arc == no_index ? Vertex::no_arc : certificate.number_of_arcs + v.arc;
    added.place = v.place;
  }
  for(const std::vector<Index>& arc : part.arcs)
  {
    for(std::size_t i = 1; i != arc.size(); ++i)
      add_edge(first + arc[i - 1], first + arc[i], {certificate.number_of_arcs}, skeleton);
    ++certificate.number_of_arcs;
  }
  std::vector<std::pair<Index, Index>>
    numbers; // of the given vertices, in the order of the mesh, and of those of the skeleton
  for(std::size_t i = 0; i != given.size(); ++i)
    numbers.emplace_back(given[i], part.vertex_map[i]);
  std::sort(numbers.begin(), numbers.end());
  for(const auto& [number, vertex] : numbers)
    skeleton[first + vertex].vertices.push_back(reading.vertex(number));
  certificate.number_of_components += 1;
  certificate.number_of_ends += part.number_of_ends;
  certificate.number_of_border_ends += part.number_of_border_ends;
  certificate.number_of_junctions += part.number_of_junctions;
  certificate.number_of_loops += part.number_of_loops;
  certificate.genus += part.genus;
  certificate.number_of_hidden_handles += part.genus - part.number_of_loops;
  certificate.number_of_contractible_loops += part.number_of_contractible_loops;
  const std::size_t most = (std::numeric_limits<std::size_t>::max)() / part.loop_index;
  certificate.loop_index = (std::min)(certificate.loop_index, most) * part.loop_index;
  certificate.number_of_vertices_outside += part.number_outside;
  certificate.number_of_crossing_edges += part.number_of_crossings;
  certificate.number_of_crossing_components += part.is_self_intersecting ? 1 : 0;
}

} // namespace internal::skeleton

/// \ingroup PkgReebGraphSkeleton
///
/// \brief extracts a curve skeleton: thin lines inside of a surface, with a cycle for each handle, an end for each limb
/// and each border, and radii.
///
/// It is the Reeb graph of the distances from a tip of each connected component, drawn through the centers of contours. Borders
/// are filled first, each by a fan of triangles around its center, which the mesh does not see: then each is an end, and holes
/// in the wall of a tube make no cycles. Edges that are longer than the square root of a five-hundredth of the area are cut in
/// halves there, up to 2,000 times: where they are as long as limbs, fronts do not see where these fork. Branches are pruned
/// that stand out less from the trunk than a share of its radius, or are shorter than a share of their own. What is left has as
/// many cycles as the surface, borders filled, has handles, less those that are hidden in multi-saddles, which are counted.
///
/// Then points that are outside are moved inside, and edges that cross the surface are bent until they do not. Where loops would be
/// no basis of those inside, by linking numbers, lines make detours along tunnels, as `handle_and_tunnel_loops()` finds them, or
/// along shorter loops that do as well. At last, lines are
/// moved to where the sum of length by distance from the surface is least, with a price on bends. Junctions nearer to each other
/// than the surface, with a line between them in the balls around them, are joined, and lines within a quarter of that from
/// where they part. Tips of limbs that end bluntly go to the middle of their caps. Each step is taken only if the surface does
/// not meet what it sweeps; edges that cross a component that intersects itself stay. So no vertex is
/// outside, no edge crosses a component that does not intersect itself, and loops are a basis there. What remains on others, or
/// where the numbers of the points end, or no detours make a basis, is counted.
/// Where a border passes a point twice, as at both sides of a slit, it is closed there, and what is left on one line is no end.
/// The order of vertices does not matter if no two are at the same place, and neither does a unit that is a power of two.
/// Each component is looked at without the others. In balls and flat parts, which have no axis, a line is one of many.
///
/// It takes \f$ O(n \log n + s \sqrt{n}) \f$ time for \f$ n \f$ vertices and a skeleton of \f$ s \f$, on surfaces whose
/// contours are short, as those of tubes. On noise, contours can be as long as the surface is large, but most branches are
/// pruned by balls inside of the surface, without any contour.
/// Where detours are needed, the time of `handle_and_tunnel_loops()` comes on top.
///
/// The idea is that of \cgalCite{lv-lsdpo-99}.
///
/// \tparam FaceListGraph a model of `FaceListGraph`, with triangles as faces
/// \tparam CurveSkeleton a `Curve_skeleton` of that mesh
/// \tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"
///
/// \param mesh the triangulated surface; it is only read
/// \param skeleton the result. What it has before is removed
/// \param np an optional sequence of \ref bgl_namedparameters "Named Parameters" among those below
///
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{scalar_map}
///     \cgalParamDescription{a scalar field, whose contours give the lines, in place of distances from a tip}
///     \cgalParamType{a model of `ReadablePropertyMap` with the vertex descriptors as key type and numbers as value type}
///     \cgalParamDefault{none: the distances from a tip of each component. Of the vertex that is farthest, along edges, from the
///                       one that is farthest from the centroid, and the vertex that is farthest from that, it is the second
///                       one, or the first one where only that is the blunt end of a thick limb.}
///   \cgalParamNEnd
///   \cgalParamNBegin{pruning_ratio}
///     \cgalParamDescription{A branch goes if its persistence is below this share of its own radius where it leaves the
///                           trunk, or of three quarters of that of the trunk. It also goes if its tip is not farther outside of
///                           the ball inscribed there than this share of the radius of the trunk, or, if what is near the tip is
///                           about as long as wide, than half of that. Such limbs stay, and corners of what is bent go.
///                           Branches to borders stay.
///                           0 prunes nothing. In a given field, other tips than those of such limbs go.}
///     \cgalParamType{`double`}
///     \cgalParamDefault{0.5}
///     \cgalParamExtra{use the functions `parameters::pruning_ratio()`}
///   \cgalParamNEnd
///   \cgalParamNBegin{sampling_ratio}
///     \cgalParamDescription{how far the points of an arc are apart, as a share of the radius, from 0.01 to 100: at most one and a
///                           half times that. A radius below half a mean edge counts as that, or as a fiftieth of the size if
///                           that is less.}
///     \cgalParamType{`double`}
///     \cgalParamDefault{0.5}
///     \cgalParamExtra{use the functions `parameters::sampling_ratio()`}
///   \cgalParamNEnd
///   \cgalParamNBegin{spacing}
///     \cgalParamDescription{how far the points of an arc are apart, in the unit of the mesh, but the last one. They are nearer
///                           where the surface is in the way. 0 leaves that to the sampling ratio.}
///     \cgalParamType{`double`}
///     \cgalParamDefault{0}
///     \cgalParamExtra{use the functions `parameters::spacing()`}
///   \cgalParamNEnd
///   \cgalParamNBegin{smooth}
///     \cgalParamDescription{the price of bends when lines are moved to the middle, and how far from the line nearly straight parts
///                           are drawn straight, from 0 to 100. 0 leaves lines at the centers of contours.}
///     \cgalParamType{`double`}
///     \cgalParamDefault{1}
///     \cgalParamExtra{use the functions `parameters::smooth()`}
///   \cgalParamNEnd
///   \cgalParamNBegin{ends_at_borders}
///     \cgalParamDescription{whether each border is an end. If not, as for a scan with holes that are no openings, they
///                           are filled, and treated like the rest of the surface.}
///     \cgalParamType{`bool`}
///     \cgalParamDefault{`true`}
///     \cgalParamExtra{use the functions `parameters::ends_at_borders()`}
///   \cgalParamNEnd
///   \reebGraphPoints{ReadablePropertyMap}
///   \cgalParamNBegin{vertex_index_map, face_index_map}
///     \cgalParamDescription{as for `compute_reeb_graph()`}
///   \cgalParamNEnd
///   \reebGraphCallback
/// \cgalNamedParamsEnd
///
/// \reebGraphComplexity
///
/// \returns what is known of the skeleton.
///
/// \exception Reeb_graph::Parameter_error if a ratio is out of its range, or the spacing is negative, or positive but below a
/// ten-millionth of the size of a component
/// \exception Reeb_graph::Non_finite_point_error if a coordinate of a point is infinite or NaN
/// \exception Reeb_graph::Non_finite_scalar_error if a value of the scalar map is infinite
///
/// and the exceptions of `compute_reeb_graph()`. When one of them is thrown, `skeleton` is as it was before.
template <class FaceListGraph, class CurveSkeleton, class NamedParameters = parameters::Default_named_parameters>
Skeleton_certificate extract_curve_skeleton(const FaceListGraph& mesh,
                                            CurveSkeleton& skeleton,
                                            const NamedParameters& np = parameters::default_values())
{
  namespace parts = internal::skeleton;
  const internal::Progress progress(np);
  progress.report(0);
  const parts::Skeleton_options options = parts::choose_options(np);
  const parts::Surface_reading<FaceListGraph, NamedParameters> reading(mesh, np);
  progress.report(0.05);
  parts::Component_filling filling(reading.complex(), reading.points());
  progress.report(0.1);
  CurveSkeleton result;
  Skeleton_certificate certificate;
  const std::size_t number = filling.number_of_components();
  for(std::size_t i = 0; i != number; ++i)
  {
    parts::Filled_component component = filling.make(i);
    reading.set_values(component);
    const std::vector<internal::Index> given = component.given;
    const double begin = 0.1 + 0.9 * static_cast<double>(i) / static_cast<double>(number);
    const double end = 0.1 + 0.9 * static_cast<double>(i + 1) / static_cast<double>(number);
    const auto part =
      parts::make_component_skeleton(std::move(component), options, internal::Stage_progress(progress, begin, end));
    parts::add_component(reading, given, part, result, certificate);
  }
  mark_junctions(result);
  skeleton.swap(result);
  progress.report_end();
  return certificate;
}

} // namespace CGAL::Reeb_graph

#endif // CGAL_REEB_GRAPH_SKELETON_EXTRACT_CURVE_SKELETON_H
