// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#include <boost/test/unit_test.hpp>

#include "generated_surfaces.h"
#include "handle_samples.h"
#include "linking_oracle.h"
#include "mesh_builders.h"
#include "tube_samples.h"
#include "voxel_solids.h"

#include <CGAL/Reeb_graph/handles/handle_and_tunnel_loops.h>
#include <CGAL/Reeb_graph/internal/base/Progress.h>
#include <CGAL/Reeb_graph/scalar_maps.h>
#include <CGAL/Reeb_graph/skeleton/extract_curve_skeleton.h>
#include <CGAL/Reeb_graph/skeleton/internal/Detour_choice.h>
#include <CGAL/Reeb_graph/skeleton/internal/Loop_group.h>

#include <boost/graph/graph_traits.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <deque>
#include <limits>
#include <map>
#include <numeric>
#include <random>
#include <string>
#include <utility>
#include <vector>

// Loops of curve skeletons are a basis of the loops of the solid: their linking numbers with the handles, whose discs they
// pass, have a determinant that is 1 or -1. They are counted from the points alone, in a fixed view.

BOOST_AUTO_TEST_SUITE(test_skeleton_loops)

using generated_surfaces::Triangle_soup;
using linking_oracle::Polygon;
using mesh_builders::Surface_mesh;
typedef CGAL::Reeb_graph::Curve_skeleton<Surface_mesh> Skeleton;
typedef std::vector<std::vector<double>> Matrix;

namespace {
// A cycle for each edge that is in no spanning forest.
std::vector<Polygon> cycles_of(const Skeleton& skeleton)
{
  constexpr std::size_t none = std::size_t(-1);
  std::vector<std::size_t> parents(num_vertices(skeleton), none), depths(parents.size(), 0);
  std::vector<std::pair<std::size_t, std::size_t>> others;
  for(std::size_t root = 0; root != parents.size(); ++root)
  {
    std::deque<std::size_t> queue;
    if(parents[root] == none)
      queue.push_back(parents[root] = root);
    for(; !queue.empty(); queue.pop_front())
      for(const auto e : CGAL::make_range(out_edges(queue.front(), skeleton)))
        if(const std::size_t v = target(e, skeleton); parents[v] == none)
        {
          parents[v] = queue.front();
          depths[v] = depths[queue.front()] + 1;
          queue.push_back(v);
        }
  }
  std::map<std::pair<std::size_t, std::size_t>, bool> is_in_forest; // those of them that were passed
  for(const auto e : CGAL::make_range(edges(skeleton)))
  {
    const std::size_t u = source(e, skeleton), v = target(e, skeleton);
    if(!(parents[u] == v || parents[v] == u) || std::exchange(is_in_forest[std::minmax(u, v)], true))
      others.emplace_back(u, v);
  }
  std::vector<Polygon> cycles;
  const auto point = [&](std::size_t v) {
    return linking_oracle::Vector{skeleton[v].point.x(), skeleton[v].point.y(), skeleton[v].point.z()};
  };
  for(auto [u, v] : others)
  {
    std::deque<std::size_t> way;
    for(std::deque<std::size_t> back;;)
    {
      if(u == v)
      {
        way.push_back(u);
        way.insert(way.end(), back.begin(), back.end());
        break;
      }
      if(depths[u] >= depths[v])
        way.push_back(std::exchange(u, parents[u]));
      else
        back.push_front(std::exchange(v, parents[v]));
    }
    cycles.emplace_back();
    for(const std::size_t w : way)
      cycles.back().push_back(point(w));
  }
  return cycles;
}

// Entries are small whole numbers, so that doubles with pivots of largest size suffice.
double determinant(Matrix matrix)
{
  double result = 1;
  for(std::size_t i = 0; i != matrix.size(); ++i)
  {
    std::size_t pivot = i;
    for(std::size_t row = i; row != matrix.size(); ++row)
      if(std::abs(matrix[row][i]) > std::abs(matrix[pivot][i]))
        pivot = row;
    if(matrix[pivot][i] == 0)
      return 0;
    if(pivot != i)
      result = -result;
    std::swap(matrix[pivot], matrix[i]);
    result *= matrix[i][i];
    for(std::size_t row = i + 1; row != matrix.size(); ++row)
      for(std::size_t column = matrix.size(); column-- != i;)
        matrix[row][column] -= matrix[row][i] / matrix[i][i] * matrix[i][column];
  }
  return result;
}

// Around the axes of z and of x.
Triangle_soup turned(Triangle_soup soup, double around_z, double around_x)
{
  for(auto& p : soup.points)
    for(const auto& [i, angle] : {std::pair(0u, around_z), {1u, around_x}})
    {
      const double x = p[i], y = p[i + 1];
      p[i] = std::cos(angle) * x - std::sin(angle) * y;
      p[i + 1] = std::sin(angle) * x + std::cos(angle) * y;
    }
  return soup;
}

// Returns the number of loops.
std::size_t check_basis(const Triangle_soup& soup)
{
  const auto mesh = generated_surfaces::make_mesh<Surface_mesh>(soup);
  Skeleton skeleton;
  const auto known = extract_curve_skeleton(mesh, skeleton);
  if(known.number_of_crossing_components != 0 || known.number_of_hidden_handles != 0)
    return 0;
  const std::vector<Polygon> cycles = cycles_of(skeleton);
  const auto height = CGAL::Reeb_graph::make_scalar_map_from_function(mesh, [&](auto v) { return mesh.point(v).z(); });
  const auto found = CGAL::Reeb_graph::handle_and_tunnel_loops(mesh, height);
  std::vector<Polygon> handles;
  for(const auto& loop : found.loops())
  {
    if(loop.kind != CGAL::Reeb_graph::Loop_kind::HANDLE)
      continue;
    handles.emplace_back();
    for(const auto h : loop.halfedges)
    {
      const auto& p = mesh.point(source(h, mesh));
      handles.back().push_back({p.x(), p.y(), p.z()});
    }
  }
  BOOST_TEST_REQUIRE(handles.size() == cycles.size());
  Matrix matrix;
  for(const Polygon& cycle : cycles)
  {
    matrix.emplace_back();
    for(const Polygon& handle : handles)
      matrix.back().push_back(linking_oracle::linking_number(cycle, handle));
  }
  BOOST_TEST(std::abs(std::abs(determinant(matrix)) - 1) < 1e-6);
  BOOST_TEST(known.loop_index == 1u);
  return cycles.size();
}

using CGAL::Reeb_graph::internal::skeleton::add_multiple;
using CGAL::Reeb_graph::internal::skeleton::Detour_choice;
using CGAL::Reeb_graph::internal::skeleton::Integer;
using CGAL::Reeb_graph::internal::skeleton::Loop_group;
using CGAL::Reeb_graph::internal::skeleton::Row;
using CGAL::Reeb_graph::internal::skeleton::Tunnel_detour;

std::vector<Row> as_rows(const std::vector<std::vector<long>>& matrix)
{
  std::vector<Row> rows(matrix.size());
  for(std::size_t i = 0; i != matrix.size(); ++i)
    for(std::size_t k = 0; k != matrix[i].size(); ++k)
      if(matrix[i][k] != 0)
        rows[i][k] = matrix[i][k];
  return rows;
}

// The greatest common divisor of the minors of so many rows and columns, chosen in all ways.
long divisor_of_minors(const std::vector<std::vector<long>>& matrix, std::size_t size)
{
  const std::size_t columns = matrix.front().size();
  long result = 0;
  for(std::size_t of_rows = 0; of_rows != std::size_t(1) << matrix.size(); ++of_rows)
    for(std::size_t of_columns = 0; of_columns != std::size_t(1) << columns; ++of_columns)
    {
      Matrix minor;
      for(std::size_t i = 0; i != matrix.size(); ++i)
        if((of_rows >> i) % 2 == 1)
        {
          minor.emplace_back();
          for(std::size_t k = 0; k != columns; ++k)
            if((of_columns >> k) % 2 == 1)
              minor.back().push_back(static_cast<double>(matrix[i][k]));
        }
      if(minor.size() == size && (size == 0 || minor.front().size() == size))
        result = std::gcd(result, std::lround(determinant(minor)));
    }
  return result;
}

// A tube around a knot on a torus, which passes p times around its axis and q times through its hole.
Triangle_soup torus_knot(int p, int q, double radius)
{
  const auto curve = [&](double t) {
    const double rho = 2 + 0.8 * std::cos(q * t);
    return handle_samples::Vector{rho * std::cos(p * t), rho * std::sin(p * t), 0.8 * std::sin(q * t)};
  };
  return handle_samples::tube(curve, 100 * static_cast<std::size_t>(p + q), 14, radius);
}
} // namespace

BOOST_AUTO_TEST_CASE(indices_of_groups_are_those_by_minors)
{
  std::mt19937 random(1);
  for(int turn = 0; turn != 400; ++turn)
  {
    std::vector<std::vector<long>> matrix(1 + random() % 4, std::vector<long>(1 + random() % 4));
    for(auto& row : matrix)
      for(long& number : row)
        number = random() % 3 == 0 ? 0 : static_cast<long>(random() % 9) - 4;
    std::size_t rank = (std::min)(matrix.size(), matrix.front().size());
    while(rank != 0 && divisor_of_minors(matrix, rank) == 0)
      --rank;
    const Loop_group group(as_rows(matrix));
    BOOST_TEST(group.number_of_dependent == matrix.size() - rank);
    BOOST_TEST((group.index == (rank == 0 ? 1 : divisor_of_minors(matrix, rank))));
  }
}

// By Euclid's algorithm alone, numbers grow without end there.
BOOST_AUTO_TEST_CASE(indices_of_dense_groups_are_found)
{
  std::mt19937 random(2);
  const std::size_t size = 40, columns = 60;
  std::vector<std::vector<long>> matrix(size + 1, std::vector<long>(columns));
  for(std::size_t i = 0; i != size; ++i)
    for(long& number : matrix[i])
      number = (i == 7 ? 6 : 1) * (static_cast<long>(random() % 19) - 9);
  for(std::size_t k = 0; k != columns; ++k)
    matrix[size][k] = matrix[3][k] - matrix[5][k];
  const Loop_group group(as_rows(matrix));
  BOOST_TEST(group.number_of_dependent == 1u);
  BOOST_TEST((group.index == 6));
  BOOST_TEST(group.index_or_most() == 6u);
  BOOST_TEST(Loop_group({{{3, Integer(1) << 100}}}).index_or_most() == (std::numeric_limits<std::size_t>::max)());
}

// Numbers of tunnels of loops, cycles of chains, and detours are drawn: with the detours that are chosen, loops are independent, and
// mostly a basis. Then what one more multiplies the determinant with is told.
BOOST_AUTO_TEST_CASE(detours_make_a_basis)
{
  std::mt19937 random(3);
  const CGAL::Reeb_graph::internal::Progress progress(CGAL::parameters::default_values());
  int number_of_bases = 0;
  for(int turn = 0; turn != 300; ++turn)
  {
    BOOST_TEST_CONTEXT("turn " << turn)
    {
      const std::size_t size = 2 + random() % 6, number_of_chains = 2 * size;
      std::vector<std::vector<long>> matrix(size, std::vector<long>(size));
      for(auto& row : matrix)
        for(long& number : row)
          number = random() % 3 == 0 ? static_cast<long>(random() % 7) - 3 : 0;
      matrix[1] = matrix[0];
      std::vector<Detour_choice::Cycles> cycles(number_of_chains);
      std::vector<Tunnel_detour> offers;
      for(std::size_t chain = 0; chain != number_of_chains; ++chain)
      {
        for(unsigned cycle = 0; cycle != size; ++cycle)
          if(chain < size ? cycle == chain : random() % 2 == 0)
            cycles[chain].push_back({cycle, random() % 2 == 0 ? 1 : -1});
        for(std::size_t tunnel = 0; tunnel != size; ++tunnel)
          offers.push_back({chain, tunnel, 1});
      }
      std::shuffle(offers.begin(), offers.end(), random);
      Detour_choice choice(as_rows(matrix), {}, cycles, offers, {progress, 0, 1});
      const auto pass = [&](const Tunnel_detour& detour) {
        for(const auto& [cycle, direction] : cycles[detour.chain])
          matrix[cycle][detour.tunnel] += direction * detour.times;
      };
      const auto index = [&] {
        Matrix numbers;
        for(const auto& row : matrix)
          numbers.emplace_back(row.begin(), row.end());
        return std::lround(determinant(numbers));
      };
      for(const Tunnel_detour& detour : choice.detours())
        pass(detour);
      long before = index();
      BOOST_TEST(before != 0);
      number_of_bases += std::abs(before) == 1 ? 1 : 0;
      for(int times = 1; std::abs(before) == 1 && times != 4; ++times) // else shares are no whole numbers
      {
        const Tunnel_detour more = {random() % number_of_chains, random() % size, times};
        const auto share = static_cast<long>(choice.shares_of(more.chain)[more.tunnel]);
        if(1 + times * share == 0)
          continue;
        pass(more);
        BOOST_TEST(index() == before * (1 + times * share));
        choice.change(more.chain, {{more.tunnel, times}});
        before = index();
      }
    }
  }
  BOOST_TEST(number_of_bases > 250);
}

// Where tunnels are told by crossings only, and not all of these are independent, no detour more makes a loop independent.
BOOST_AUTO_TEST_CASE(detours_along_any_tunnels_make_loops_independent)
{
  std::mt19937 random(4);
  const CGAL::Reeb_graph::internal::Progress progress(CGAL::parameters::default_values());
  std::size_t sum_before = 0, sum_after = 0;
  for(int turn = 0; turn != 300; ++turn)
  {
    BOOST_TEST_CONTEXT("turn " << turn)
    {
      const std::size_t size = 1 + random() % 5, columns = 1 + random() % 7;
      const auto drawn = [&](std::size_t height) {
        std::vector<std::vector<long>> matrix(height, std::vector<long>(columns));
        for(auto& row : matrix)
          for(long& number : row)
            number = random() % 3 == 0 ? static_cast<long>(random() % 5) - 2 : 0;
        matrix.back() = matrix.front();
        return as_rows(matrix);
      };
      std::vector<Row> loops = drawn(size);
      const std::vector<Row> tunnels = drawn(columns);
      std::vector<Detour_choice::Cycles> cycles(2 * size);
      std::vector<Tunnel_detour> offers;
      for(std::size_t chain = 0; chain != cycles.size(); ++chain)
      {
        for(unsigned cycle = 0; cycle != size; ++cycle)
          if(random() % 3 == 0)
            cycles[chain].push_back({cycle, random() % 2 == 0 ? 1 : -1});
        for(std::size_t tunnel = 0; tunnel != columns; ++tunnel)
          if(random() % 2 == 0)
            offers.push_back({chain, tunnel, 1});
      }
      const auto pass = [&](const Tunnel_detour& detour, std::vector<Row> rows) {
        for(const auto& [cycle, direction] : cycles[detour.chain])
          add_multiple(rows[cycle], tunnels[detour.tunnel], direction * detour.times);
        return rows;
      };
      sum_before += Loop_group(loops).number_of_dependent;
      const Detour_choice choice(loops, tunnels, cycles, offers, {progress, 0, 1});
      for(const Tunnel_detour& detour : choice.detours())
        loops = pass(detour, loops);
      const std::size_t left = Loop_group(loops).number_of_dependent;
      for(const Tunnel_detour& offer : offers)
        BOOST_TEST(Loop_group(pass(offer, loops)).number_of_dependent >= left);
      sum_after += left;
    }
  }
  BOOST_TEST(3 * sum_after < 2 * sum_before);
}

BOOST_AUTO_TEST_CASE(loops_of_knots_and_links_are_a_basis)
{
  BOOST_TEST(check_basis(handle_samples::knotted_torus()) == 1u);
  BOOST_TEST(check_basis(handle_samples::linked_tori()) == 2u);
  for(const double radius : {0.05, 0.2, 0.3})
    for(const auto& [p, q] : {std::pair(1, 0), {1, 3}, {2, 3}, {3, 2}, {2, 5}, {3, 4}})
      if(radius == 0.2 || (p < 3 && q != 5))
        BOOST_TEST_CONTEXT("knot " << p << ", " << q << ", radius " << radius)
  BOOST_TEST(check_basis(torus_knot(p, q, radius)) == 1u);
}

BOOST_AUTO_TEST_CASE(loops_of_ladders_and_of_higher_genus_are_a_basis)
{
  for(const std::size_t loops : {1, 2, 3, 6})
    BOOST_TEST_CONTEXT("loops " << loops)
  BOOST_TEST(check_basis(tube_samples::surface(tube_samples::ladder(loops), loops % 2 == 0 ? 0.03 : 0, loops))
             == loops);
  for(const unsigned genus : {1u, 2u, 3u, 5u, 8u, 13u, 20u})
    BOOST_TEST_CONTEXT("genus " << genus)
  BOOST_TEST(check_basis(generated_surfaces::closed_surface(genus, 3000)) == genus);
  for(const double radius : {4., 6.})
    BOOST_TEST(check_basis(handle_samples::gyroid(radius, 0.5)) > 1u);
}

BOOST_AUTO_TEST_CASE(loops_of_sponges_are_a_basis)
{
  std::size_t sum = 0;
  for(std::size_t seed = 0; seed != 5; ++seed)
    BOOST_TEST_CONTEXT("seed " << seed)
  sum += check_basis(handle_samples::sponge(12, 12, seed));
  BOOST_TEST(sum > 15u);
  BOOST_TEST(check_basis(handle_samples::sponge(100, 16, 7, 2.2)) == 41u); // Ways along arcs of the graph had index 2.
}

// A tenth of the points are where others beside them are, so that faces are folded. Tunnels lead through such faces: with these
// alone, 18 loops were contractible.
BOOST_AUTO_TEST_CASE(loops_of_sponges_with_edges_without_length_pass_tunnels)
{
  std::size_t number = 0, number_of_contractible = 0;
  for(std::size_t seed = 0; seed != 10; ++seed)
  {
    Triangle_soup soup = handle_samples::sponge(12, 12, seed);
    std::mt19937 random(static_cast<unsigned>(seed));
    for(const auto& triangle : soup.triangles)
      if(random() % 20 == 0)
        soup.points[triangle[0]] = soup.points[triangle[1]];
    Skeleton skeleton;
    const auto known = extract_curve_skeleton(generated_surfaces::make_mesh<Surface_mesh>(soup), skeleton);
    number += known.number_of_loops;
    number_of_contractible += known.number_of_contractible_loops;
  }
  BOOST_TEST(number > 40u);
  BOOST_TEST(number_of_contractible < number / 10);
}

// Each stage reports, and ends where the callback wants it to.
BOOST_AUTO_TEST_CASE(skeletons_of_many_loops_can_be_cancelled_at_any_time)
{
  const auto mesh = generated_surfaces::make_mesh<Surface_mesh>(handle_samples::gyroid(4, 0.5));
  double last = 0, greatest_step = 0;
  Skeleton skeleton;
  extract_curve_skeleton(mesh, skeleton, CGAL::parameters::callback([&](double fraction) {
                           greatest_step = (std::max)(greatest_step, fraction - last);
                           last = fraction;
                           return true;
                         }));
  BOOST_TEST(greatest_step < 0.12);
  for(const double limit : {0.02, 0.1, 0.2, 0.3, 0.5, 0.6, 0.7, 0.8, 0.9, 0.98})
  {
    std::size_t number_after = 0;
    BOOST_CHECK_THROW(extract_curve_skeleton(mesh, skeleton, CGAL::parameters::callback([&](double fraction) {
                                               number_after += fraction >= limit ? 1 : 0;
                                               return fraction < limit;
                                             })),
                      CGAL::Reeb_graph::Cancelled_error);
    BOOST_TEST(number_after == 1u);
  }
}

// Turned ones, too: there what is straight beneath the middle of an edge can be one that rays miss by rounding.
BOOST_AUTO_TEST_CASE(loops_of_solids_of_cubes_are_a_basis)
{
  std::size_t sum = 0;
  for(std::size_t seed = 0; seed != 100; ++seed)
    BOOST_TEST_CONTEXT("seed " << seed)
    {
      const Triangle_soup soup = Voxel_solid(3 + static_cast<int>(seed % 3), seed).surface();
      const std::size_t number = check_basis(soup);
      BOOST_TEST(check_basis(turned(soup, 0.7 + static_cast<double>(seed), 0.4)) == number);
      sum += number;
    }
  BOOST_TEST(sum > 100u);
}

// Junctions that are near to each other, joined along a line that goes around a handle, would take all other lines with them.
BOOST_AUTO_TEST_CASE(moved_lines_are_no_longer)
{
  for(std::size_t seed = 1; seed <= 40; ++seed)
    for(const int size : {5, 6})
      BOOST_TEST_CONTEXT("size " << size << ", seed " << seed)
      {
        const auto mesh = generated_surfaces::make_mesh<Surface_mesh>(Voxel_solid(size, seed).surface());
        std::array<double, 2> lengths = {};
        for(const int smooth : {0, 1})
        {
          Skeleton skeleton;
          CGAL::Reeb_graph::extract_curve_skeleton(mesh, skeleton, CGAL::parameters::smooth(double(smooth)));
          for(const auto e : CGAL::make_range(edges(skeleton)))
            lengths[smooth] += std::sqrt(
              CGAL::squared_distance(skeleton[source(e, skeleton)].point, skeleton[target(e, skeleton)].point));
        }
        BOOST_TEST(lengths[1] <= lengths[0]);
      }
}

// Channels lead through a cube, two by two in each direction.
BOOST_AUTO_TEST_CASE(loops_of_turned_sponges_are_a_basis)
{
  const auto is_solid = [](const auto& cell) { return cell[0] % 2 + cell[1] % 2 + cell[2] % 2 < 2; };
  const Triangle_soup soup = Voxel_solid::of_cells(5, is_solid).surface();
  for(const double angle : {0., 0.3, 1.2, 2.5})
    BOOST_TEST(check_basis(turned(soup, angle, 2 * angle)) == 28u);
}

BOOST_AUTO_TEST_SUITE_END()
