// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_HANDLES_INTERNAL_CLOSED_SURFACE_H
#define CGAL_REEB_GRAPH_HANDLES_INTERNAL_CLOSED_SURFACE_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/handles/Handle_loop.h>
#include <CGAL/Reeb_graph/internal/base/Index.h>
#include <CGAL/Reeb_graph/internal/base/Progress.h>
#include <CGAL/Reeb_graph/internal/base/Threads.h>
#include <CGAL/Reeb_graph/internal/base/arrays.h>
#include <CGAL/Reeb_graph/internal/base/lengths.h>
#include <CGAL/Reeb_graph/internal/complex/Flat_mesh.h>
#include <CGAL/Reeb_graph/internal/space/Self_intersections.h>

#include <CGAL/boost/graph/iterator.h>

#include <boost/graph/graph_traits.hpp>

#include <algorithm>
#include <cstddef>
#include <deque>
#include <functional>
#include <memory>
#include <unordered_set>
#include <utility>
#include <vector>

namespace CGAL::Reeb_graph::internal {

// A closed walk: consecutive halfedges.
typedef std::vector<Index> Halfedge_walk;

// The walk in the other direction.
inline Halfedge_walk reversed(const Halfedge_walk& walk)
{
  Halfedge_walk result;
  for(auto h = walk.rbegin(); h != walk.rend(); ++h)
    result.push_back(*h ^ 1);
  return result;
}

// A triangle mesh as arrays, closed: each border cycle is filled by a fan around a new vertex, its apex. Loops never pass
// an apex, so its place does not matter.
struct Closed_surface : Closed_triangles
{
  std::vector<double> lengths; // by edge
  Index number_of_given_vertices = 0, number_of_given_halfedges = 0;
  std::vector<Halfedge_walk> border_cycles; // with the surface on the left

  // Calls visit(halfedge) for those that leave a vertex that has some, counterclockwise.
  template <class Visit>
  void for_each_outgoing(Index v, const Visit& visit) const
  {
    Index h = outgoing[v];
    do
    {
      visit(h);
      h = turned(h);
    } while(h != outgoing[v]);
  }
  bool is_apex(Index v) const { return v >= number_of_given_vertices; }
  bool is_given(Index h) const { return h < number_of_given_halfedges; }

  // Makes the surface of points, targets, and next halfedges, which those along the border have none of.
  void close()
  {
    number_of_given_vertices = checked_index(points.size());
    number_of_given_halfedges = checked_index(target.size());
    std::vector<Index> border(points.size(), no_index); // the halfedge along the border that leaves a vertex
    for(Index h = 0; h != number_of_given_halfedges; ++h)
      if(next[h] == no_index)
        border[source(h)] = h;
    for(Index h = 0; h != number_of_given_halfedges; ++h)
      if(next[h] == no_index)
        fill(h, border);
    number_faces();
    lengths.reserve(next.size() / 2);
    for(Index h = 0; h != next.size(); h += 2)
    {
      const Point p = way(source(h), target[h]);
      lengths.push_back(length_of(p[0], p[1], p[2]));
    }
  }

  double length(Index h) const { return lengths[h / 2]; }
  double length(const Halfedge_walk& walk) const
  {
    double sum = 0;
    for(const Index h : walk)
      sum += length(h);
    return sum;
  }

private:
  // Fills the hole that a border halfedge belongs to.
  void fill(Index first, const std::vector<Index>& border)
  {
    Halfedge_walk cycle = {first};
    for(Index h = border[target[first]]; h != first; h = border[target[h]])
      cycle.push_back(h);
    const Index apex = static_cast<Index>(points.size());
    points.push_back(points[target[first]]);
    const Index first_spoke = static_cast<Index>(next.size()), size = static_cast<Index>(cycle.size());
    for(Index i = 0; i != size; ++i)
    {
      target.push_back(apex);
      target.push_back(source(cycle[i]));
      next.push_back(no_index); // set by the face before
      next.push_back(cycle[i]);
    }
    for(Index i = 0; i != size; ++i)
    {
      const Index next_to_apex = first_spoke + 2 * ((i + 1) % size);
      next[cycle[i]] = next_to_apex;
      next[next_to_apex] = first_spoke + 2 * i + 1;
    }
    border_cycles.push_back(reversed(cycle));
  }
};

// The closed surface of a flat mesh, and the way from its halfedges to those of the mesh and back. Edges are numbered in
// the order of edges(mesh).
template <class Mesh>
class Surface_closing
{
  typedef typename boost::graph_traits<Mesh>::halfedge_descriptor halfedge_descriptor;

public:
  template <class PointMap>
  Surface_closing(const Mesh& mesh, std::shared_ptr<const Flat_mesh<Mesh>> flat_mesh, const PointMap& point_map)
    : mesh_(mesh),
      flat_mesh_(std::move(flat_mesh))
  {
    flat_halfedges_.reserve(2 * num_edges(mesh));
    numbers_.resize(flat_mesh_->complex.number_of_halfedges());
    for(const auto e : CGAL::make_range(edges(mesh)))
    {
      const Halfedge_index first = find_halfedge(mesh, *flat_mesh_, halfedge(e, mesh));
      for(const Halfedge_index h : {first, opposite_of(first)})
      {
        numbers_[h] = static_cast<Index>(flat_halfedges_.size());
        flat_halfedges_.push_back(h);
      }
    }
    checked_index(2 * flat_halfedges_.size());
    surface_.points = read_points<Closed_surface::Point>(mesh, point_map);
    copy_halfedges();
    surface_.close();
  }

  Closed_surface& surface() { return surface_; }
  std::size_t number_of_halfedges() const { return flat_halfedges_.size(); } // those given

  halfedge_descriptor halfedge_of(Index h) const { return flat_mesh_->numbers.halfedges(mesh_, flat_halfedges_[h]); }

  // no_index if the mesh has no such halfedge.
  Index number(halfedge_descriptor h) const
  {
    const Halfedge_index found = find_halfedge(mesh_, *flat_mesh_, h);
    return numbers_.contains(found) ? numbers_[found] : Index(no_index);
  }

private:
  void copy_halfedges()
  {
    const auto& complex = flat_mesh_->complex;
    const auto positions = list_positions(*flat_mesh_);
    surface_.target.reserve(flat_halfedges_.size());
    surface_.next.reserve(flat_halfedges_.size());
    for(const Halfedge_index h : flat_halfedges_)
    {
      surface_.target.push_back(positions[complex.target(h)]);
      surface_.next.push_back(complex.has_triangle(h) ? numbers_[complex.next(h)] : Index(no_index));
    }
  }

  const Mesh& mesh_;
  std::shared_ptr<const Flat_mesh<Mesh>> flat_mesh_;
  std::vector<Halfedge_index> flat_halfedges_;
  Indexed_vector<Halfedge_index, Index> numbers_;
  Closed_surface surface_;
};

// A spanning forest of the vertices, and one of the faces across edges that are not in the first. In each component of
// genus g, 2g edges are in none of them. Each of these closes a loop with the tree, b_k, and a loop of faces with the
// cotree, c_k. As b_j crosses c_k if and only if j = k, both are bases of the homology, and dual to one another: the
// coordinates of a loop in the basis b are its intersection numbers with the loops c.
class Tree_and_cotree
{
public:
  struct Component
  {
    Index root = no_index;
    std::vector<Index>
      left_over; // b_k passes this halfedge from its source to its target, c_k from its right to its left
    bool has_border = false;
    Index genus() const { return static_cast<Index>(left_over.size() / 2); }
  };

  explicit Tree_and_cotree(const Closed_surface& surface)
    : surface_(surface),
      to_vertex_(surface.points.size(), no_index),
      parents_(surface.points.size(), no_index),
      component_of_(surface.points.size(), no_index),
      distances_(surface.points.size(), 0),
      to_parent_(surface.halfedge.size(), no_index),
      is_in_tree_(surface.next.size() / 2, false),
      is_in_cotree_(surface.next.size() / 2, false)
  {
    find_tree();
    find_cotree();
    for(Index h = 0; h != surface.next.size(); h += 2)
    {
      if(!is_in_tree(h) && !is_in_cotree(h))
        components_[component_of_[surface.target[h]]].left_over.push_back(h);
    }
    for(const Halfedge_walk& cycle : surface.border_cycles)
      components_[component_of_[surface.target[cycle.front()]]].has_border = true;
  }

  const std::vector<Component>& components() const { return components_; } // those with faces
  Index component_of(Index v) const { return component_of_[v]; }
  // By vertex: no_index where a component has no inside, or no handles.
  std::vector<Index> closed_components_with_handles() const
  {
    std::vector<Index> result = component_of_;
    for(Index& number : result)
      if(number != no_index && (components_[number].genus() == 0 || components_[number].has_border))
        number = no_index;
    return result;
  }

  // The halfedge that leads to a vertex in the tree, and the one of a face with the parent in the cotree on its other
  // side; no_index for roots.
  Index to_vertex(Index v) const { return to_vertex_[v]; }
  Index to_parent(Index face) const { return to_parent_[face]; }
  Index parent(Index v) const { return parents_[v]; }
  Index parent_face(Index f) const
  {
    return to_parent_[f] == no_index ? Index(no_index) : surface_.face[surface_.opposite(to_parent_[f])];
  }
  double distance(Index v) const { return distances_[v]; }             // from the root
  const std::vector<Index>& face_order() const { return face_order_; } // parents first

  bool is_in_tree(Index h) const { return is_in_tree_[h / 2]; }
  bool is_in_cotree(Index h) const { return is_in_cotree_[h / 2]; }

  // The closed walk from the root to a halfedge, along it, and back.
  Halfedge_walk walk_through(Index h) const
  {
    Halfedge_walk walk;
    for(Index v = surface_.source(h); to_vertex_[v] != no_index; v = parent(v))
      walk.push_back(to_vertex_[v]);
    std::reverse(walk.begin(), walk.end());
    walk.push_back(h);
    for(Index v = surface_.target[h]; to_vertex_[v] != no_index; v = parent(v))
      walk.push_back(surface_.opposite(to_vertex_[v]));
    return walk;
  }

private:
  // Breadth first. Apexes are leaves, so that the tree leads around holes.
  void find_tree()
  {
    std::vector<Index> queue;
    for(Index root = 0; root != surface_.number_of_given_vertices; ++root)
    {
      if(component_of_[root] != no_index || surface_.outgoing[root] == no_index)
        continue;
      component_of_[root] = static_cast<Index>(components_.size());
      components_.push_back({root, {}, false});
      queue.assign(1, root);
      for(std::size_t i = 0; i != queue.size(); ++i)
        if(!surface_.is_apex(queue[i]))
          add_neighbors(queue[i], queue);
    }
  }

  void add_neighbors(Index v, std::vector<Index>& queue)
  {
    surface_.for_each_outgoing(v, [&](Index h) {
      const Index w = surface_.target[h];
      if(component_of_[w] != no_index)
        return;
      component_of_[w] = component_of_[v];
      to_vertex_[w] = h;
      parents_[w] = v;
      is_in_tree_[h / 2] = true;
      distances_[w] = distances_[v] + surface_.length(h);
      queue.push_back(w);
    });
  }

  // Breadth first, but the faces that fill a hole come one right after the other, so that all their edges that are not
  // in the tree are in the cotree.
  void find_cotree()
  {
    struct Step
    {
      Index face, to_parent;
    };
    std::vector<bool> is_visited(surface_.halfedge.size(), false);
    std::deque<Step> queue;
    for(const Component& component : components_)
    {
      queue.push_back({surface_.face[surface_.outgoing[component.root]], no_index});
      while(!queue.empty())
      {
        const Step step = queue.front();
        queue.pop_front();
        if(is_visited[step.face])
          continue;
        is_visited[step.face] = true;
        to_parent_[step.face] = step.to_parent;
        if(step.to_parent != no_index)
          is_in_cotree_[step.to_parent / 2] = true;
        face_order_.push_back(step.face);
        Index h = surface_.halfedge[step.face];
        for(int i = 0; i != 3; ++i, h = surface_.next[h])
        {
          const Index g = surface_.opposite(h);
          if(is_visited[surface_.face[g]] || is_in_tree(h))
            continue;
          if(surface_.is_given(h))
            queue.push_back({surface_.face[g], g});
          else
            queue.push_front({surface_.face[g], g});
        }
      }
    }
  }

  const Closed_surface& surface_;
  std::vector<Index> to_vertex_, parents_, component_of_; // a parent beside its halfedge, as walks to roots are many
  std::vector<double> distances_;
  std::vector<Index> to_parent_, face_order_;
  std::vector<bool> is_in_tree_, is_in_cotree_; // by edge
  std::vector<Component> components_;
};

// The part of a forest that joins some of its nodes to their roots, as pieces: paths whose inner nodes have one child.
// A piece belongs to the node at its lower end and to those above, up to where the next one begins.
class Forest_pieces
{
public:
  // `parent(node)` is no_index for a root. Pieces are numbered from the roots downwards.
  template <class Parent>
  Forest_pieces(const std::vector<Index>& ends, std::vector<Index>& piece_of, const Parent& parent)
    : piece_of_(piece_of)
  {
    const Index marked = no_index - 1;
    std::vector<std::vector<Index>> paths;
    for(const Index end : ends)
    {
      paths.emplace_back();
      for(Index node = end; parent(node) != no_index && piece_of[node] == no_index; node = parent(node))
      {
        piece_of[node] = marked;
        paths.back().push_back(node);
      }
    }
    // A node whose parent is an end, or joins paths, begins a piece.
    for(const Index end : ends)
      is_joint_.insert(end);
    for(const auto& path : paths)
      if(!path.empty())
        is_joint_.insert(parent(path.back()));
    for(auto& path : paths)
    {
      for(auto node = path.rbegin(); node != path.rend(); ++node)
      {
        const Index above = parent(*node);
        const Index piece_above = piece_of[above];
        if(is_joint_.count(above) != 0 || piece_above == no_index)
        {
          piece_of[*node] = static_cast<Index>(parents_.size());
          parents_.push_back(piece_above);
        }
        else
          piece_of[*node] = piece_above;
        nodes_.push_back(*node);
      }
    }
  }

  Index size() const { return static_cast<Index>(parents_.size()); }
  Index parent(Index piece) const { return parents_[piece]; }  // no_index at the root
  Index piece_of(Index node) const { return piece_of_[node]; } // no_index for a root
  const std::vector<Index>& nodes() const { return nodes_; }   // all that belong to a piece

  // Adds the numbers of pieces up, from the roots downwards. There can be other numbers behind them.
  void add_up(std::vector<long long>& sums) const
  {
    for(Index piece = 0; piece != size(); ++piece)
    {
      if(parents_[piece] != no_index)
        sums[piece] += sums[parents_[piece]];
    }
  }

  // The number of the piece of a node, 0 for a root.
  long long at(const std::vector<long long>& sums, Index node) const
  {
    return piece_of_[node] == no_index ? 0 : sums[piece_of_[node]];
  }

private:
  std::vector<Index>& piece_of_;
  std::unordered_set<Index> is_joint_;
  std::vector<Index> parents_, nodes_;
};

// A loop as that of the public interface, with numbers of halfedges.
typedef Handle_loop<Index> Surface_loop;

// A finder of the loops of a surface, which answers questions about them. The library has it.
class Loop_finder
{
public:
  virtual ~Loop_finder() = default;
  virtual const Closed_surface& surface() const = 0;
  virtual std::size_t number_of_components() const = 0;
  virtual Index component_of(Index v) const = 0;
  // The number of pairs of faces of each component that intersect, or another number than 0 if they are not counted.
  virtual std::vector<std::size_t> self_intersections(bool are_counted) const = 0;
  // A component that intersects itself has no inside.
  virtual void refuse_self_intersections(const std::vector<std::size_t>& self_intersections) = 0;
  // Loops are made shorter than `bound`, and than the `number`-th size of a pair, where that can be. At the same time,
  // find_crossed() tells which components have no inside.
  virtual std::vector<Surface_loop> make_loops(double bound,
                                               std::size_t number,
                                               const std::function<void()>& find_crossed,
                                               const Threads& threads,
                                               const Stage_progress& progress) = 0;
  // Whether a loop of the surface bounds inside, or outside, but not on the surface.
  virtual bool is_bounding(const Halfedge_walk& walk, bool is_inside) const = 0;
  virtual long long intersection_number(const Halfedge_walk& a, const Halfedge_walk& b) const = 0;
  // The linking number of a, and b pushed outside.
  virtual long long linking_number(const Halfedge_walk& a, const Halfedge_walk& b) const = 0;
};

// The one for a surface. It is a template so that the library can have it, and defined in Found_loops.h.
template <class Surface>
std::unique_ptr<Loop_finder> make_loop_finder(Surface surface, const Stage_progress& progress);

} // namespace CGAL::Reeb_graph::internal

#endif // CGAL_REEB_GRAPH_HANDLES_INTERNAL_CLOSED_SURFACE_H
