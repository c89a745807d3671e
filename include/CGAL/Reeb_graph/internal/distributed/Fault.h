// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors
#ifndef CGAL_REEB_GRAPH_INTERNAL_DISTRIBUTED_FAULT_H
#define CGAL_REEB_GRAPH_INTERNAL_DISTRIBUTED_FAULT_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/distributed/exceptions.h>
#include <CGAL/Reeb_graph/exceptions.h>
#include <CGAL/Reeb_graph/soup_exceptions.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <new>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL {
namespace Reeb_graph {
namespace internal {

// What can be told to other ranks of an exception, from which they make their own copy.
class Fault
{
public:
  // Its place among all faults of all ranks, lexicographically: the stage that finds it, indices, and its kind.
  typedef std::array<std::uint64_t, 4> Numbers;

  Fault() = default;

  const Numbers& numbers() const { return numbers_; }
  const std::string& text() const { return text_; }

  // Called in a handler.
  static Fault of_current_exception()
  {
    try
    {
      throw;
    }
    catch(const std::bad_alloc&)
    {
      return Fault(Kind::BAD_ALLOC);
    }
    catch(const Cancelled_error&)
    {
      return Fault(Kind::CANCELLED);
    }
    catch(const Mesh_size_error&)
    {
      return Fault(Kind::MESH_SIZE);
    }
    catch(const Vertex_ranges_error& error)
    {
      return Fault(Kind::VERTEX_RANGES, error.vertex());
    }
    catch(const Unordered_scalar_error& error)
    {
      return Fault(Kind::UNORDERED_SCALAR, error.vertex());
    }
    catch(const Vertex_out_of_range_error& error)
    {
      return Fault(Kind::VERTEX_OUT_OF_RANGE, error.position());
    }
    catch(const Non_triangular_face_error& error)
    {
      return Fault(Kind::NON_TRIANGULAR_FACE, error.face());
    }
    catch(const Degenerate_face_error& error)
    {
      return Fault(Kind::DEGENERATE_FACE, error.face());
    }
    catch(const Non_manifold_edge_error& error)
    {
      return Fault(Kind::NON_MANIFOLD_EDGE, error.edge().first, error.edge().second);
    }
    catch(const Inconsistent_orientation_error& error)
    {
      return Fault(Kind::INCONSISTENT_ORIENTATION, error.edge().first, error.edge().second);
    }
    catch(const Non_manifold_vertex_error& error)
    {
      return Fault(Kind::NON_MANIFOLD_VERTEX, error.vertex());
    }
    catch(const std::exception& error)
    {
      return Fault(Kind::OTHER, 0, 0, error.what());
    }
    catch(...)
    {
      return Fault(Kind::OTHER, 0, 0, "an exception that is no std::exception");
    }
  }

  // The rank with the first fault, if each has given its numbers; the lowest one if several have the same.
  static int rank_of_first(const std::vector<std::uint64_t>& numbers_of_ranks)
  {
    int first = 0;
    for(std::size_t rank = 1; rank != numbers_of_ranks.size() / size; ++rank)
      if(numbers_at(static_cast<int>(rank), numbers_of_ranks) < numbers_at(first, numbers_of_ranks))
        first = static_cast<int>(rank);
    return first;
  }

  // Throws a copy of the exception of a rank.
  [[noreturn]] static void rethrow(int rank,
                                   const std::vector<std::uint64_t>& numbers_of_ranks,
                                   const std::string& text)
  {
    const Numbers numbers = numbers_at(rank, numbers_of_ranks);
    const std::size_t first = static_cast<std::size_t>(numbers[1]), second = static_cast<std::size_t>(numbers[2]);
    switch(static_cast<Kind>(numbers[3]))
    {
    case Kind::BAD_ALLOC: throw std::bad_alloc();
    case Kind::CANCELLED: throw Cancelled_error();
    case Kind::MESH_SIZE: throw Mesh_size_error();
    case Kind::VERTEX_RANGES: throw Vertex_ranges_error(first);
    case Kind::UNORDERED_SCALAR: throw Unordered_scalar_error(first);
    case Kind::VERTEX_OUT_OF_RANGE: throw Vertex_out_of_range_error("face", first);
    case Kind::NON_TRIANGULAR_FACE: throw Non_triangular_face_error(first);
    case Kind::DEGENERATE_FACE: throw Degenerate_face_error(first);
    case Kind::NON_MANIFOLD_EDGE: throw Non_manifold_edge_error({first, second});
    case Kind::INCONSISTENT_ORIENTATION: throw Inconsistent_orientation_error({first, second});
    case Kind::NON_MANIFOLD_VERTEX: throw Non_manifold_vertex_error(first);
    case Kind::OTHER: break;
    }
    throw Other_rank_error(rank, text);
  }

private:
  static constexpr std::size_t size = std::tuple_size<Numbers>::value;

  // The kinds, in the order of the stages that find them.
  enum class Kind : std::uint64_t
  {
    BAD_ALLOC,
    OTHER,
    CANCELLED,
    MESH_SIZE,
    VERTEX_RANGES,
    UNORDERED_SCALAR,
    VERTEX_OUT_OF_RANGE,
    NON_TRIANGULAR_FACE,
    DEGENERATE_FACE,
    NON_MANIFOLD_EDGE,
    INCONSISTENT_ORIENTATION,
    NON_MANIFOLD_VERTEX
  };

  explicit Fault(Kind kind, std::uint64_t first = 0, std::uint64_t second = 0, const std::string& text = {})
    : numbers_{static_cast<std::uint64_t>(stage_of(kind)), first, second, static_cast<std::uint64_t>(kind)},
      text_(text)
  {}

  // What is wrong with a triangle is all found in one stage, so that the first triangle is named.
  static Kind stage_of(Kind kind)
  {
    return kind == Kind::NON_TRIANGULAR_FACE || kind == Kind::DEGENERATE_FACE ? Kind::VERTEX_OUT_OF_RANGE : kind;
  }

  static Numbers numbers_at(int rank, const std::vector<std::uint64_t>& numbers_of_ranks)
  {
    Numbers numbers;
    std::copy_n(numbers_of_ranks.begin() + rank * static_cast<std::ptrdiff_t>(size), size, numbers.begin());
    return numbers;
  }

  Numbers numbers_ = {~std::uint64_t(0), 0, 0, 0}; // no fault comes behind all others
  std::string text_;
};

} // namespace internal
} // namespace Reeb_graph
} // namespace CGAL

#endif // CGAL_REEB_GRAPH_INTERNAL_DISTRIBUTED_FAULT_H
