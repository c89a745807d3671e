#include <CGAL/Reeb_graph/distributed/compute_reeb_graph_distributed.h>
#include <CGAL/boost/graph/iterator.h>

#include <boost/mpi/communicator.hpp>
#include <boost/mpi/environment.hpp>
#include <boost/range/irange.hpp>

#include <array>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <functional>
#include <iostream>
#include <vector>

typedef CGAL::Reeb_graph_soup_traits<double>::Graph Graph;

int main(int argc, char* argv[])
{
  boost::mpi::environment environment(argc, argv);
  const boost::mpi::communicator ranks;

  // a torus of n rings of n vertices: each rank makes some rings, and the triangles up to the next ones
  const std::uint64_t n = (argc > 1) ? std::strtoull(argv[1], nullptr, 10) : 60;
  if(n < 3)
  {
    if(ranks.rank() == 0)
      std::cerr << "Error: a torus has at least 3 rings" << std::endl;
    return EXIT_FAILURE;
  }
  const std::uint64_t rank = ranks.rank(), number_of_ranks = ranks.size();
  const std::uint64_t first_ring = n * rank / number_of_ranks, end_of_rings = n * (rank + 1) / number_of_ranks;

  std::vector<double> heights;
  std::vector<std::array<std::uint64_t, 3>> triangles;
  for(std::uint64_t i = first_ring; i < end_of_rings; ++i)
    for(std::uint64_t j = 0; j < n; ++j)
    {
      const double turn = 8 * std::atan(1.) / static_cast<double>(n);
      heights.push_back((2 + std::cos(turn * static_cast<double>(j))) * std::sin(turn * static_cast<double>(i)));
      const std::uint64_t a = i * n, b = (i + 1) % n * n, next = (j + 1) % n;
      triangles.push_back({a + j, b + j, b + next});
      triangles.push_back({a + j, b + next, a + next});
    }

  try
  {
    Graph graph;
    CGAL::Reeb_graph::Distributed_slab<double> slab;
    CGAL::compute_reeb_graph_distributed(ranks, boost::irange(first_ring * n, end_of_rings * n), triangles, heights,
                                         graph, CGAL::parameters::slab(std::ref(slab)));

    if(rank == 0) // which has the graph
    {
      std::cout << slab.number_of_slabs << " slabs on " << number_of_ranks << " ranks" << std::endl;
      for(const auto arc : CGAL::make_range(edges(graph)))
        std::cout << "arc from vertex " << graph[source(arc, graph)].vertex << " to vertex "
                  << graph[target(arc, graph)].vertex << " with a chain of " << graph[arc].chain.size() << " steps"
                  << std::endl;
    }
  }
  catch(const CGAL::Reeb_graph::Error& error) // on all ranks the same
  {
    if(rank == 0)
      std::cerr << "Error: " << error.what() << std::endl;
    return EXIT_FAILURE;
  }
  return EXIT_SUCCESS;
}
