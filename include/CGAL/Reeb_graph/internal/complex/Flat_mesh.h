// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_INTERNAL_COMPLEX_FLAT_MESH_H
#define CGAL_REEB_GRAPH_INTERNAL_COMPLEX_FLAT_MESH_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/internal/base/interpolation.h>
#include <CGAL/Reeb_graph/internal/complex/Regular_vertices.h>
#include <CGAL/Reeb_graph/internal/complex/Stars_ahead.h>
#include <CGAL/Reeb_graph/internal/complex/flatten.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/iterator.h>
#include <CGAL/boost/graph/properties.h>
#include <CGAL/tags.h>

#include <boost/graph/graph_traits.hpp>

#include <cmath>
#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

namespace CGAL::Reeb_graph::internal {

// A mesh that has been checked, by numbers, without points and without values: what graphs, fields and handles are
// computed from. It is shared, and never changes.
template <class FaceListGraph>
struct Flat_mesh
{
  Complex_of_t<FaceListGraph> complex;
  Mesh_numbers<FaceListGraph> numbers;
};

// A field on a flat mesh.
template <class FaceListGraph, class Scalar>
struct Flat_values
{
  std::shared_ptr<const Flat_mesh<FaceListGraph>> mesh;
  Keyed_field<Scalar> field;
};

// Makes them of what has been checked.
template <class FaceListGraph, class Scalar>
Flat_values<FaceListGraph, Scalar> keep_flat(
  Complex_with_field<Complex_of_t<FaceListGraph>, FaceListGraph, Scalar> checked)
{
  return {std::make_shared<const Flat_mesh<FaceListGraph>>(
            Flat_mesh<FaceListGraph>{std::move(checked.complex), std::move(checked.numbers)}),
          std::move(checked.field)};
}

struct No_visitor_of_fan
{
  void begin(Vertex_index) {}
  void add(Vertex_index) {}
};

// The order of vertices without values.
struct No_order
{
  bool operator()(Vertex_index, Vertex_index) const { return false; }
  void prefetch(Vertex_index) const {}
};

// Sets the fans of all vertices, and checks the complex. Vertices that are known to be regular need no turn.
template <class Complex, class Order>
Complex check_complex(const Threads& threads,
                      Unchecked_complex<Complex> unchecked,
                      const Order& order,
                      Way_of_turning way,
                      const Regular_vertices& regular_vertices)
{
  const Stars_ahead stars(unchecked.at_set_fans(), order, way == Way_of_turning::STARS_AHEAD);
  const auto vertex_at = [](std::size_t i) { return Vertex_index(i); };
  const auto set_fans = [&](std::size_t begin, std::size_t end, Fan_counts& counts) {
    No_visitor_of_fan visitor;
    stars.visit(begin, end, vertex_at, [&](std::size_t i) {
      const Vertex_index v(i);
      const Index number_of_corners = regular_vertices.number_of_corners(v);
      if(number_of_corners == 0)
      {
        unchecked.set_fan(v, counts, visitor);
        return;
      }
      unchecked.set_closed_fan(v);
      counts.corners += number_of_corners;
    });
  };
  return std::move(unchecked).check(threads.sum_of_parts<Fan_counts>(unchecked.number_of_vertices(), set_fans));
}

// Checks a mesh, and numbers it.
template <class FaceListGraph>
std::shared_ptr<const Flat_mesh<FaceListGraph>> make_flat_mesh(const FaceListGraph& mesh)
{
  auto [complex, numbers] = number_mesh(mesh, Vertex_list<FaceListGraph>(mesh), parameters::default_values());
  const No_order order;
  const Way_of_turning way = fastest_way(complex.at_set_fans(), order);
  return std::make_shared<const Flat_mesh<FaceListGraph>>(Flat_mesh<FaceListGraph>{
    check_complex(Threads(), std::move(complex), order, way, Regular_vertices()), std::move(numbers)});
}

// Throws what compute_reeb_graph() throws for a mesh that has no Reeb graph.
template <class FaceListGraph>
void check_mesh(const FaceListGraph& mesh)
{
  make_flat_mesh(mesh);
}

// Checks the mesh and the field, and numbers them.
template <class FaceListGraph, class ScalarMap, class Traits, class NamedParameters>
Flat_values<FaceListGraph, typename Traits::Scalar> flatten(const Threads& threads,
                                                            const FaceListGraph& mesh,
                                                            const ScalarMap& scalar_map,
                                                            const Traits& traits,
                                                            const NamedParameters& np)
{
  auto [unchecked, numbers, field] = flatten_unchecked(threads, mesh, scalar_map, traits, np);
  const Vertex_order order(field.keys());
  const Way_of_turning way = fastest_way(unchecked.at_set_fans(), order);
  const auto regular_vertices = find_regular_vertices(threads, unchecked.at_set_fans(), order, way);
  auto complex = check_complex(threads, std::move(unchecked), order, way, regular_vertices);
  return keep_flat<FaceListGraph, typename Traits::Scalar>({std::move(complex), std::move(numbers), std::move(field)});
}

// Shares the flat values; those of a Flat_field are there already.
template <class FaceListGraph, class ScalarMap, class Traits, class NamedParameters>
std::shared_ptr<const Flat_values<FaceListGraph, typename Traits::Scalar>> share_flat(const Threads& threads,
                                                                                      const FaceListGraph& mesh,
                                                                                      const ScalarMap& scalar_map,
                                                                                      const Traits& traits,
                                                                                      const NamedParameters& np)
{
  if constexpr(Is_flat_field<ScalarMap, typename Traits::Scalar>::value)
    return flat_values_of(scalar_map, mesh, traits);
  else
    return std::make_shared<const Flat_values<FaceListGraph, typename Traits::Scalar>>(
      flatten(threads, mesh, scalar_map, traits, np));
}

// The positions in vertices(mesh) by number, no_index for those of removed vertices.
template <class FaceListGraph>
Indexed_vector<Vertex_index, Index> list_positions(const Flat_mesh<FaceListGraph>& flat_mesh)
{
  Indexed_vector<Vertex_index, Index> positions;
  positions.reserve(flat_mesh.complex.number_of_vertices());
  Index position = 0;
  for(const Vertex_index v : flat_mesh.complex.vertices())
    positions.push_back(flat_mesh.complex.has_vertex(v) ? position++ : Index(no_index));
  return positions;
}

// The coordinates of the vertices, as a type that is made from three, by position.
template <class Point, class FaceListGraph, class PointMap>
std::vector<Point> read_points(const FaceListGraph& mesh, const PointMap& point_map)
{
  std::vector<Point> points;
  points.reserve(num_vertices(mesh));
  for(const auto v : CGAL::make_range(vertices(mesh)))
  {
    const Coordinates c = coordinates_of(get(point_map, v));
    if(!std::isfinite(c[0]) || !std::isfinite(c[1]) || !std::isfinite(c[2]))
      throw Non_finite_point_error(points.size());
    points.push_back(Point{c[0], c[1], c[2]});
  }
  return points;
}

template <class FlatMesh, class PlaceMap>
Place_of_vertex read_places(const FlatMesh& flat_mesh, const PlaceMap& map, std::size_t number_of_places)
{
  using boost::get; // for a pointer, whatever has been included before
  Place_of_vertex places(flat_mesh.complex.number_of_vertices(), no_index);
  for(const Vertex_index v : places.keys())
  {
    if(!flat_mesh.complex.has_vertex(v))
      continue;
    // A negative one is too large then.
    const auto place = static_cast<std::size_t>(get(map, flat_mesh.numbers.vertices[v]));
    if(place >= number_of_places)
      throw Graph_mismatch_error();
    places[v] = static_cast<Index>(place);
  }
  return places;
}

// Looks for a halfedge or its opposite around a vertex, which may be unknown. Returns whether it has been found, or is
// not there.
template <class FaceListGraph, class HalfedgeDescriptor>
bool find_around(const FaceListGraph& mesh,
                 const Flat_mesh<FaceListGraph>& flat_mesh,
                 Vertex_index v,
                 const HalfedgeDescriptor& h,
                 std::size_t most_steps,
                 Halfedge_index& found)
{
  if(v.number() >= flat_mesh.complex.number_of_vertices())
    return true;
  std::size_t number_of_steps = 0;
  flat_mesh.complex.visit_edges_around(v, [&](Vertex_index, Halfedge_index number) {
    const HalfedgeDescriptor around = flat_mesh.numbers.halfedges(mesh, number);
    if(around == h || around == opposite(h, mesh))
      found = around == h ? number : opposite_of(number);
    return found != no_index || ++number_of_steps == most_steps;
  });
  return number_of_steps != most_steps;
}

// The number of a halfedge, no_index if the mesh has none such, which a Surface_mesh tells of removed ones only.
template <class FaceListGraph, class HalfedgeDescriptor>
Halfedge_index find_halfedge(const FaceListGraph& mesh,
                             const Flat_mesh<FaceListGraph>& flat_mesh,
                             const HalfedgeDescriptor& h)
{
  Halfedge_index found = flat_mesh.numbers.halfedges.find(mesh, h);
  // Around the ends by turns, ever farther: the one of lower degree ends the search.
  std::size_t most_steps = 8;
  for(bool is_done = found != no_index; !is_done; most_steps *= 2)
    for(const auto v : {source(h, mesh), target(h, mesh)})
      is_done = is_done || find_around(mesh, flat_mesh, flat_mesh.numbers.number_of(v), h, most_steps, found);
  return found;
}

// Whether a halfedge can be one of the mesh. Only a mesh that numbers its halfedges tells those of other meshes.
template <class FaceListGraph, class HalfedgeDescriptor>
bool can_be_halfedge(const FaceListGraph&, const HalfedgeDescriptor&)
{
  return true;
}

template <class Point>
bool can_be_halfedge(const Surface_mesh<Point>& mesh, typename Surface_mesh<Point>::Halfedge_index h)
{
  return mesh.has_valid_index(h);
}

// Calls visit(halfedge) for each face of the mesh, with the number of the halfedge that the mesh gives for it. A
// Surface_mesh is checked by its halfedges, which need not be those that its faces have.
template <class FaceListGraph, class Visit>
void for_each_face(const FaceListGraph& mesh, const Flat_mesh<FaceListGraph>& flat_mesh, const Visit& visit)
{
  for(const auto f : CGAL::make_range(faces(mesh)))
  {
    const auto h = halfedge(f, mesh);
    if(face(h, mesh) != f)
    {
      check_faces(mesh);
      throw Non_manifold_vertex_error(
        flat_mesh.numbers.vertices.position(flat_mesh.numbers.number_of(source(h, mesh))));
    }
    visit(find_halfedge(mesh, flat_mesh, h));
  }
}

// A border component of a mesh.
template <class HalfedgeDescriptor>
struct Border_cycle
{
  HalfedgeDescriptor halfedge; // of the border, leads to the first vertex
  std::size_t first_vertex;    // position in vertices(mesh)
};

// Finds the border components, in the order of their first vertices in vertices(mesh).
template <class Mesh>
auto find_border_cycles(const Mesh& mesh)
{
  typedef typename boost::graph_traits<Mesh>::halfedge_descriptor halfedge_descriptor;
  std::vector<Border_cycle<halfedge_descriptor>> cycles;
  const auto is_found = get(dynamic_vertex_property_t<bool>(), mesh);
  for(const auto v : vertices(mesh))
    put(is_found, v, false);
  std::size_t position = 0;
  for(const auto v : vertices(mesh))
  {
    const std::size_t first_vertex = position++;
    if(get(is_found, v) || halfedge(v, mesh) == boost::graph_traits<Mesh>::null_halfedge())
      continue;
    const auto border = is_border(v, mesh);
    if(!border)
      continue;
    cycles.push_back({*border, first_vertex});
    for(const auto u : vertices_around_face(*border, mesh))
      put(is_found, u, true);
  }
  return cycles;
}

} // namespace CGAL::Reeb_graph::internal

#endif // CGAL_REEB_GRAPH_INTERNAL_COMPLEX_FLAT_MESH_H
