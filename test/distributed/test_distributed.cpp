// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

// The Reeb graphs of surfaces on ranks of MPI are those of the whole surfaces, whoever brings what, and what is wrong
// on one rank is told by all. Each rank makes the whole surface, and takes its part of it.

#include "ranks.h"

#include "generated_surfaces.h"
#include "graph_checks.h"
#include "mesh_builders.h"
#include "random_fields.h"

#include <CGAL/Reeb_graph/Augmentation.h>
#include <CGAL/Reeb_graph/distributed/internal/Vertex_numbering.h>
#include <CGAL/Reeb_graph/distributed/internal/distribute_surface.h>
#include <CGAL/Reeb_graph/distributed/internal/solve_slab.h>

#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <new>
#include <numeric>
#include <set>
#include <stdexcept>
#include <string>
#include <tuple>
#include <typeinfo>
#include <utility>
#include <vector>

BOOST_AUTO_TEST_SUITE(test_distributed)

using CGAL::Reeb_graph::Method;
using CGAL::Reeb_graph::Ties;
using random_meshes::Combinatorial_mesh;
using random_meshes::Field_class;
using random_meshes::Mesh_class;
using random_meshes::Random;
using namespace ranks;

namespace internal = CGAL::Reeb_graph::internal;
namespace params = CGAL::parameters;
namespace rg = CGAL::Reeb_graph;

namespace {
// MPI, from before the first test to behind the last one.
struct Mpi
{
  boost::mpi::environment environment;
};
} // namespace
BOOST_TEST_GLOBAL_FIXTURE(Mpi);

namespace {
// Compares the graph of a surface on all ranks with that of the whole.
template <class Scalar, class NamedParameters>
void compare(const Surface<Scalar>& surface, Random& random, const NamedParameters& np)
{
  const Local_input<Scalar> input = random_part(surface, random);
  const auto graph = graph_on_ranks(input, np);
  if(rank() != 0)
    BOOST_TEST(num_vertices(graph) == 0u);
  else
    BOOST_TEST(graph_checks::are_identical(graph, graph_of_whole(surface, np)));
}

// A generated surface, with field(point) as value of each vertex.
template <class Field>
Surface<double> generated_surface(unsigned genus, std::size_t number_of_vertices, const Field& field)
{
  const auto soup = generated_surfaces::closed_surface(genus, number_of_vertices);
  Surface<double> surface = {{soup.points.size(), {}}, {}};
  for(const auto& t : soup.triangles)
    surface.mesh.triangles.push_back({t[0], t[1], t[2]});
  for(const auto& p : soup.points)
    surface.values.push_back(field(p));
  return surface;
}

Surface<double> random_surface(std::size_t seed, Random& random)
{
  const auto mesh = random_meshes::random_mesh(
    static_cast<Mesh_class>(seed % static_cast<std::size_t>(Mesh_class::NUMBER_OF_CLASSES)), random);
  const auto field_class =
    static_cast<Field_class>(random.below(static_cast<std::size_t>(Field_class::NUMBER_OF_CLASSES)));
  return {mesh, random_meshes::random_field(mesh, field_class, random)};
}
} // namespace

BOOST_AUTO_TEST_CASE(random_meshes_have_the_graphs_of_the_whole)
{
  for(std::size_t seed = 0; seed < 80; ++seed)
    BOOST_TEST_CONTEXT("seed " << seed)
    {
      Random random(seed);
      const Surface<double> surface = random_surface(seed, random);
      const auto ties = random.below(2) == 0 ? Ties::PERTURB : Ties::CONTRACT;
      const auto method = random.below(2) == 0 ? Method::CONTOUR_TREES : Method::CRITICAL_SETS;
      const bool keeps = random.below(2) == 0;
      const std::size_t slabs = random.below(3) == 0 ? 1 + random.below(9) : 0;
      compare(surface, random, params::ties(ties).method(method).keep_degree_two_nodes(keeps).number_of_slabs(slabs));
    }
}

// Smooth fields, the height, noise, few values and one value.
BOOST_AUTO_TEST_CASE(surfaces_of_any_genus)
{
  for(const unsigned genus : {0u, 1u, 3u, 25u})
    for(std::size_t kind = 0; kind < 5; ++kind)
      BOOST_TEST_CONTEXT("genus " << genus << ", field " << kind)
      {
        Random random(10 * genus + kind);
        const auto surface = generated_surface(genus, 3000, [&](const auto& p) {
          return kind == 0 ? p[2]
               : kind == 1 ? std::sin(3 * p[0]) + std::cos(2 * p[1]) + 0.1 * p[2]
               : kind == 2 ? static_cast<double>(random.below(1000000))
               : kind == 3 ? static_cast<double>(random.below(3))
                           : 1.;
        });
        compare(surface, random, params::default_values());
      }
}

BOOST_AUTO_TEST_CASE(few_vertices_or_none)
{
  for(const std::size_t size : {0, 1, 2, 7})
    for(const double step : {0., 1.})
      BOOST_TEST_CONTEXT(size << " vertices, step " << step)
      {
        Random random(size);
        Surface<double> surface = {{size, {}}, {}};
        for(std::size_t v = 0; v < size; ++v)
          surface.values.push_back(step * static_cast<double>(v * 3 % 7));
        compare(surface, random, params::default_values());
        if(size == 7)
        {
          surface.mesh = random_meshes::seven_vertex_torus();
          compare(surface, random, params::default_values());
        }
      }
}

// Vertices of two long cylinders are at their ends, and slabs in between have none of them.
BOOST_AUTO_TEST_CASE(cylinders_through_slabs)
{
  Random random(0);
  const auto cylinders = disjoint_union(random_meshes::cylinder(5, 2), random_meshes::cylinder(4, 2));
  Surface<double> surface = {disjoint_union(cylinders, random_meshes::bipyramid(40)), {}};
  surface.values = {0, 0, 0, 0, 0, 99, 99, 99, 99, 99, 1, 1, 1, 1, 98, 98, 98, 98};
  for(std::size_t v = surface.values.size(); v < surface.mesh.number_of_vertices; ++v)
    surface.values.push_back(static_cast<double>(v));
  compare(surface, random, params::default_values());
  compare(surface, random, params::method(Method::CRITICAL_SETS));
}

BOOST_AUTO_TEST_CASE(other_numbers)
{
  for(std::size_t seed = 0; seed < 12; ++seed)
    BOOST_TEST_CONTEXT("seed " << seed)
    {
      Random random(1000 + seed);
      const Surface<double> surface = random_surface(seed, random);
      compare(Surface<float>{surface.mesh, {surface.values.begin(), surface.values.end()}}, random,
              params::default_values());
      compare(Surface<int>{surface.mesh, {surface.values.begin(), surface.values.end()}}, random,
              params::default_values());
    }
}

// A noisy triangle meets so many slabs that fewer are used, but on small surfaces.
BOOST_AUTO_TEST_CASE(noise_is_not_sliced_in_vain)
{
  Random random(0);
  const auto surface =
    generated_surface(1, 17000, [&](const auto&) { return static_cast<double>(random.below(1000000)); });
  rg::Distributed_slab<double> slab;
  const auto input = random_part(surface, random);
  const auto graph = graph_on_ranks(input, params::slab(std::ref(slab)));
  if(rank() == 0)
    BOOST_TEST(graph_checks::are_identical(graph, graph_of_whole(surface, params::default_values())));
  const int size = world().size();
  BOOST_TEST(slab.number_of_slabs == static_cast<std::size_t>((std::min)(size, 2)));
  // Each level in the middle of its slabs is crossed by 3 x (1 - x) of the triangles that have x of the vertices below.
  double crossings = 1;
  for(int level = 1; level < size; ++level)
    crossings += 3. * level * (size - level) / size / size;
  BOOST_TEST(std::abs(slab.crossings_per_triangle - crossings) < 0.05 * crossings);

  const auto height = generated_surface(1, 17000, [](const auto& p) { return p[2]; });
  graph_on_ranks(random_part(height, random), params::slab(std::ref(slab)));
  BOOST_TEST(slab.number_of_slabs == static_cast<std::size_t>(size));
}

namespace {
// The slab of each vertex by definition.
std::vector<std::size_t> slabs_of_vertices(const Surface<double>& surface, const internal::Splitters& splitters)
{
  std::vector<std::size_t> slabs;
  for(std::size_t v = 0; v < surface.values.size(); ++v)
  {
    slabs.push_back(0);
    for(const auto& splitter : splitters)
      if(std::tie(splitter.key, splitter.name) < std::forward_as_tuple(surface.values[v], std::uint64_t(v)))
        ++slabs.back();
  }
  return slabs;
}

// Compares what the rank holds with what it should.
void check_part(const internal::Slab_surface& part,
                const Surface<double>& surface,
                const std::vector<std::size_t>& slabs,
                const internal::Distribution_counts& counts)
{
  const std::size_t slab = part.slab;
  std::set<std::uint64_t> vertices;
  std::multiset<Triangle> triangles;
  std::size_t number_of_copies = 0;
  for(std::size_t v = 0; v < slabs.size(); ++v)
    if(slabs[v] == slab)
      vertices.insert(v);
  BOOST_TEST(counts.vertices == vertices.size());
  for(const auto& t : surface.mesh.triangles)
  {
    const auto ends = std::minmax({slabs[t[0]], slabs[t[1]], slabs[t[2]]});
    if(slab < ends.first || ends.second < slab)
      continue;
    triangles.insert({t[0], t[1], t[2]});
    vertices.insert(t.begin(), t.end());
    number_of_copies += ends.first < slab ? 1 : 0;
  }
  BOOST_TEST(counts.copies == number_of_copies);
  BOOST_TEST(std::vector<std::uint64_t>(vertices.begin(), vertices.end())
               == std::vector<std::uint64_t>(part.global_vertices.begin(), part.global_vertices.end()),
             boost::test_tools::per_element());
  std::multiset<Triangle> found;
  for(const auto& t : part.triangles)
    found.insert({part.global_vertices[t[0]], part.global_vertices[t[1]], part.global_vertices[t[2]]});
  BOOST_TEST((found == triangles));
  for(const auto v : part.global_vertices.keys())
  {
    const auto global = static_cast<std::size_t>(part.global_vertices[v]);
    BOOST_TEST(part.keys[v] == surface.values[global]);
    const auto side = slabs[global] < slab ? part.below() : (slabs[global] > slab ? part.above() : part.inside());
    BOOST_TEST((part.slabs_of_vertices[v] == side));
  }
}

// Exchanges a surface with levels just above some of its vertices, which need not be different.
template <class Vertex>
void check_exchange(const Surface<double>& surface, const internal::Splitters& splitters, Random& random)
{
  const auto input = random_part(surface, random);
  internal::Exchange exchange(world());
  const internal::Local_part<std::vector<Triangle>, std::vector<double>> local(exchange, input.vertices,
                                                                               input.triangles, input.scalars);
  internal::Vertex_numbering vertices(local.number_of_vertices());
  local.check_triangles([&](std::uint64_t v) { vertices.add(v); });
  vertices.number();
  internal::Distribution_counts counts;
  const auto part = internal::exchange_surface<Vertex>(exchange, local, std::move(vertices), splitters, counts);
  BOOST_TEST(part.slab == rank());
  BOOST_TEST(part.number_of_slabs == splitters.size() + 1);
  BOOST_TEST(part.has_slab() == (part.slab <= splitters.size()));
  if(part.has_slab())
    check_part(part, surface, slabs_of_vertices(surface, splitters), counts);
  else
    BOOST_TEST(part.triangles.size() + part.global_vertices.size() == 0u);
}
} // namespace

BOOST_AUTO_TEST_CASE(ranks_hold_what_meets_their_slabs)
{
  for(std::size_t seed = 0; seed < 30; ++seed)
    BOOST_TEST_CONTEXT("seed " << seed)
    {
      Random random(2000 + seed);
      Surface<double> surface = random_surface(seed, random);
      if(seed % 20 == 0) // more than one page of vertices, most of them isolated
      {
        surface.mesh.number_of_vertices += 10000;
        surface.values.resize(surface.mesh.number_of_vertices, 5);
      }
      internal::Splitters splitters;
      for(std::size_t slab = 1 + random.below(2); slab < number_of_ranks() && !surface.values.empty(); ++slab)
      {
        const std::size_t v = random.below(surface.values.size());
        splitters.push_back({surface.values[v], v});
      }
      std::sort(splitters.begin(), splitters.end());
      check_exchange<internal::Vertex_index>(surface, splitters, random);
      check_exchange<internal::Long_index>(surface, splitters, random);
    }
}

namespace {
// What a function throws, as text.
template <class Function>
std::string thrown_by(const Function& function)
{
  try
  {
    function();
  }
  catch(const std::exception& error)
  {
    return std::string(typeid(error).name()) + ": " + error.what();
  }
  return "nothing";
}

// Whether all ranks throw the same as `expected`, which stands for the one fault of the input. The ranks go on
// together.
template <class Scalar, class Exception>
void check_thrown(const Local_input<Scalar>& input, const Exception& expected)
{
  const std::string expected_text = thrown_by([&] { throw expected; });
  BOOST_TEST(thrown_by([&] { graph_on_ranks(input, params::default_values()); }) == expected_text);
}

std::vector<double> shuffled_values(std::size_t size)
{
  std::vector<double> values(size);
  for(std::size_t v = 0; v < size; ++v)
    values[v] = static_cast<double>(v * 7 % size);
  return values;
}
} // namespace

BOOST_AUTO_TEST_CASE(values_that_no_double_holds_are_told_by_all)
{
  typedef std::numeric_limits<std::int64_t> Limits;
  Random random(1);
  const std::int64_t largest = std::int64_t(1) << 53;
  Surface<std::int64_t> surface = {random_meshes::cylinder(6, 10), {}};
  for(std::int64_t v = 0; v != 60; ++v)
    surface.values.push_back(v % 2 == 0 ? largest - v / 2 : v / 2 - largest);
  BOOST_TEST(num_vertices(graph_on_ranks(random_part(surface, random), params::default_values()))
             == (rank() == 0 ? num_vertices(graph_of_whole(surface, params::default_values())) : 0));
  for(const std::int64_t wrong : {largest + 1, -largest - 1, (Limits::max)(), (Limits::min)()})
  {
    surface.values[17] = wrong;
    check_thrown(random_part(surface, random), rg::Inexact_scalar_error(17));
  }
}

BOOST_AUTO_TEST_CASE(what_is_wrong_with_vertices_is_told_by_all)
{
  Random random(0);
  const Surface<double> surface = {random_meshes::cylinder(6, 10), shuffled_values(60)};
  const std::size_t last = number_of_ranks() - 1, begin_of_last = begin_of_rank(60, last);
  Surface<double> wrong = surface;
  wrong.values[50] = wrong.values[13] = std::numeric_limits<double>::quiet_NaN();
  check_thrown(random_part(wrong, random), rg::Unordered_scalar_error(13));

  auto input = part_in_order(surface);
  if(rank() == last) // one is missing
    input.vertices = boost::irange<std::uint64_t>(begin_of_last + 1, 61);
  check_thrown(input, rg::Vertex_ranges_error(begin_of_last));
  if(last != 0)
  {
    input = part_in_order(surface);
    if(rank() == last) // two are there twice
      input.bring_vertices(surface, begin_of_last - 2, 60);
    check_thrown(input, rg::Vertex_ranges_error(begin_of_last - 2));
  }
  input = part_in_order(surface);
  if(rank() == last)
    input.scalars.pop_back();
  check_thrown(input, rg::Scalar_count_error(59 - begin_of_last, 60 - begin_of_last));
  compare(surface, random, params::default_values());
}

BOOST_AUTO_TEST_CASE(what_is_wrong_with_triangles_is_told_by_all)
{
  Random random(0);
  const Surface<double> surface = {random_meshes::cylinder(6, 10), shuffled_values(60)};
  Surface<double> wrong = surface;
  wrong.mesh.triangles.push_back({3, 60, 4});
  wrong.mesh.triangles.push_back({3, 3, 4});
  check_thrown(part_in_order(wrong), rg::Vertex_out_of_range_error("face", surface.mesh.triangles.size()));
  wrong.mesh.triangles[7][2] = wrong.mesh.triangles[7][1];
  check_thrown(part_in_order(wrong), rg::Degenerate_face_error(7));

  for(std::size_t seed = 0; seed < 4; ++seed)
    BOOST_TEST_CONTEXT("seed " << seed)
    {
      wrong = surface;
      wrong.mesh.number_of_vertices = 62;
      wrong.values = shuffled_values(62);
      wrong.mesh.triangles.push_back({31, 30, 60});
      wrong.mesh.triangles.push_back({20, 21, 61});
      check_thrown(random_part(wrong, random), rg::Non_manifold_edge_error({20, 21}));

      wrong = surface;
      std::swap(wrong.mesh.triangles[54][0], wrong.mesh.triangles[54][1]); // 27, 28, 34
      check_thrown(random_part(wrong, random), rg::Inconsistent_orientation_error({27, 28}));

      wrong = {disjoint_union(surface.mesh, random_meshes::tetrahedron()), shuffled_values(64)};
      for(auto& triangle : wrong.mesh.triangles)
        std::replace(triangle.begin(), triangle.end(), std::size_t(63), std::size_t(20));
      check_thrown(random_part(wrong, random), rg::Non_manifold_vertex_error(20));
    }
  compare(surface, random, params::default_values());
}

namespace {
typedef rg::Distributed_slab<double>::Contour Contour;
typedef std::vector<std::pair<std::uint64_t, std::uint64_t>> Edges;

std::pair<std::uint64_t, std::uint64_t> sorted_edge(const std::pair<std::uint64_t, std::uint64_t>& edge)
{
  return std::minmax(edge.first, edge.second);
}

// The contours of one process, as those of ranks should be.
std::vector<Contour> contours_of_whole(const Surface<double>& surface, double value)
{
  typedef mesh_builders::Surface_mesh Mesh;
  const auto mesh = mesh_builders::make_mesh<Mesh>(surface.mesh);
  const mesh_builders::Mesh_numbers<Mesh> numbers(mesh);
  const auto scalar_map = rg::make_scalar_map(mesh, surface.values);
  const auto graph = graph_checks::compute(mesh, surface.values);
  const rg::Augmentation augmentation(mesh, scalar_map, graph);
  std::vector<Contour> contours;
  for(const auto& contour : augmentation.contours_at_value(value))
  {
    Edges edges;
    for(const auto h : contour.edges)
      edges.emplace_back(numbers.vertex(source(h, mesh)), numbers.vertex(target(h, mesh)));
    if(contour.is_closed())
      std::rotate(edges.begin(),
                  std::min_element(edges.begin(), edges.end(),
                                   [](const auto& a, const auto& b) { return sorted_edge(a) < sorted_edge(b); }),
                  edges.end());
    contours.push_back({contour.is_closed(), edges});
  }
  const auto least_edge = [](const Contour& contour) {
    std::pair<std::uint64_t, std::uint64_t> least = sorted_edge(contour.edges.front());
    for(const auto& edge : contour.edges)
      least = (std::min)(least, sorted_edge(edge));
    return least;
  };
  std::sort(contours.begin(), contours.end(),
            [&](const Contour& a, const Contour& b) { return least_edge(a) < least_edge(b); });
  return contours;
}
} // namespace

BOOST_AUTO_TEST_CASE(contours_are_those_of_the_whole)
{
  for(std::size_t seed = 0; seed < 20; ++seed)
  {
    Random random(3000 + seed);
    const Surface<double> surface = random_surface(seed, random);
    rg::Distributed_slab<double> slab;
    slab.is_surface_kept = seed != 0;
    graph_on_ranks(random_part(surface, random), params::slab(std::ref(slab)));
    for(int i = 0; i < 4; ++i)
      BOOST_TEST_CONTEXT("seed " << seed << ", value " << i)
      {
        const std::size_t size = surface.values.size();
        const double value = (size == 0 ? 0 : surface.values[random.below(size)]) + (i == 3 ? 0.5 : 0);
        const int number_of_ranks_with_level =
          boost::mpi::all_reduce(world(), slab.has_level(value) ? 1 : 0, std::plus<int>());
        BOOST_TEST(number_of_ranks_with_level == 1);
        const auto contours = slab.contours_at_value(value);
        const bool has_any = slab.is_surface_kept && slab.has_level(value);
        const auto expected = has_any ? contours_of_whole(surface, value) : std::vector<Contour>();
        BOOST_REQUIRE(contours.size() == expected.size());
        for(std::size_t c = 0; c < contours.size(); ++c)
        {
          BOOST_TEST(contours[c].is_closed == expected[c].is_closed);
          BOOST_TEST((contours[c].edges == expected[c].edges));
        }
      }
  }
}

// The callback of rank 0 cancels the work of all, or throws.
BOOST_AUTO_TEST_CASE(callbacks_stop_all_ranks)
{
  Random random(0);
  const Surface<double> surface = {random_meshes::cylinder(6, 10), shuffled_values(60)};
  const auto input = part_in_order(surface);
  std::vector<double> fractions;
  const auto note = [&](double fraction) {
    fractions.push_back(fraction);
    return true;
  };
  graph_on_ranks(input, params::callback(note));
  BOOST_TEST(fractions.empty() == (rank() != 0));
  BOOST_TEST(std::is_sorted(fractions.begin(), fractions.end()));
  std::size_t number_of_calls = fractions.size();
  boost::mpi::broadcast(world(), number_of_calls, 0);
  for(std::size_t call = 0; call + 1 < number_of_calls; ++call)
  {
    std::size_t calls_left = call;
    const auto cancel = [&](double) { return calls_left-- != 0; };
    BOOST_CHECK_THROW(graph_on_ranks(input, params::callback(cancel)), rg::Cancelled_error);
    calls_left = call;
    const auto fail = [&](double) { return calls_left-- != 0 ? true : throw std::domain_error("enough"); };
    BOOST_TEST(thrown_by([&] { graph_on_ranks(input, params::callback(fail)); })
               == (rank() == 0 ? thrown_by([] { throw std::domain_error("enough"); })
                               : thrown_by([] { throw rg::Other_rank_error(0, "enough"); })));
  }
  compare(surface, random, params::default_values());
}

namespace {
// Fails at some call on one rank.
struct Failing_visitor : rg::Default_visitor
{
  std::size_t calls_left;
  explicit Failing_visitor(std::size_t call) : calls_left(call) {}
  void begin_stage(rg::Stage) { count(); }
  void critical_vertices(const rg::Critical_vertex_counts&) { count(); }
  void count()
  {
    if(calls_left-- == 0)
      throw std::bad_alloc();
  }
};
} // namespace

BOOST_AUTO_TEST_CASE(lack_of_memory_on_a_rank_is_told_by_all)
{
  Random random(0);
  const Surface<double> surface = {random_meshes::cylinder(6, 10), shuffled_values(60)};
  constexpr std::size_t number_of_calls = 5, never = 100;
  for(std::size_t call = 0; call < number_of_calls; ++call)
  {
    Failing_visitor visitor(rank() == number_of_ranks() / 2 ? call : never);
    BOOST_CHECK_THROW(graph_on_ranks(random_part(surface, random), params::visitor(std::ref(visitor))), std::bad_alloc);
  }
  compare(surface, random, params::default_values());
}

// Indices of more than 32 bits, where there are many of a page or few.
BOOST_AUTO_TEST_CASE(large_indices_are_numbered)
{
  constexpr std::uint64_t end = std::uint64_t(1) << 34, middle = (std::uint64_t(1) << 32) - 5000;
  internal::Vertex_numbering numbering(end);
  std::vector<std::uint64_t> vertices = {0, 1, 64, middle - 4096 * 1000, end - 64, end - 1};
  for(std::uint64_t v = middle; v < middle + 10000; v += 2)
    vertices.push_back(v);
  for(const std::uint64_t v : vertices)
    numbering.add(v);
  numbering.add(internal::Vertex_word{end / 64 - 1, ~std::uint64_t(0)});
  for(std::uint64_t v = end - 63; v < end - 1; ++v)
    vertices.push_back(v);
  std::sort(vertices.begin(), vertices.end());
  numbering.number();
  BOOST_TEST(numbering.size() == vertices.size());
  std::vector<std::uint64_t> found;
  numbering.for_each_word(0, [&](const internal::Vertex_word& word) {
    word.for_each([&](std::uint64_t v) { found.push_back(v); });
    return true;
  });
  BOOST_TEST((found == vertices));
  for(std::size_t i = 0; i < vertices.size(); ++i)
    BOOST_REQUIRE(numbering[vertices[i]].number() == i);
}

// A rank that asks one other rank only, as where the file is in the order of the field, does so in one round, however
// many ranks there are; if all ask one, each of them gets a part.
BOOST_AUTO_TEST_CASE(questions_take_few_rounds)
{
  constexpr std::size_t ranks = 1000, owner = 7;
  constexpr std::uint64_t size = std::uint64_t(1) << 20;
  internal::Vertex_numbering vertices(size);
  for(std::uint64_t word = 0; word < size / 64; ++word)
    vertices.add(internal::Vertex_word{word, ~std::uint64_t(0)});
  vertices.number();
  internal::Questions questions(internal::Vertex_ranges({{0, size, owner}}), vertices, ranks);
  std::vector<std::uint64_t> left(ranks, 0);
  left[owner] = size;
  BOOST_TEST((questions.left() == left));
  BOOST_TEST((internal::share_answers(left) == left));
  BOOST_TEST(questions.next_round(left).items.size() == size / 64);
  BOOST_TEST(questions.left()[owner] == 0u);

  const std::vector<std::uint64_t> shares = internal::share_answers(std::vector<std::uint64_t>(ranks, size));
  BOOST_TEST(*std::min_element(shares.begin(), shares.end()) > 0u);
  BOOST_TEST(std::accumulate(shares.begin(), shares.end(), std::uint64_t(0)) <= internal::most_answers + ranks);
}

BOOST_AUTO_TEST_SUITE_END()
