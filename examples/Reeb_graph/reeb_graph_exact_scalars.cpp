#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <CGAL/Reeb_graph_traits.h>
#include <CGAL/compute_reeb_graph.h>

#include <cstdlib>
#include <iostream>
#include <string>
#include <type_traits>

typedef CGAL::Exact_predicates_exact_constructions_kernel Kernel;
typedef Kernel::Point_3 Point;
typedef CGAL::Surface_mesh<Point> Mesh;
typedef boost::graph_traits<Mesh>::vertex_descriptor vertex_descriptor;

int main(int argc, char* argv[])
{
  const std::string filename = (argc > 1) ? argv[1] : "data/double_torus.off";

  Mesh mesh;
  if(!CGAL::IO::read_polygon_mesh(filename, mesh) || is_empty(mesh))
  {
    std::cerr << "Error: cannot read " << filename << std::endl;
    return EXIT_FAILURE;
  }

  // The exact squared distance to the first vertex. Nothing is rounded, so vertices tie only if they really do.
  const Point origin = mesh.point(*vertices(mesh).begin());
  const auto scalar_map = CGAL::Reeb_graph::make_scalar_map_from_function(
    mesh, [&](vertex_descriptor v) { return CGAL::squared_distance(mesh.point(v), origin); });

  typedef CGAL::Reeb_graph_traits<Mesh, std::decay_t<decltype(scalar_map)>> Traits;
  Traits::Graph graph;
  try
  {
    CGAL::compute_reeb_graph(mesh, scalar_map, graph, CGAL::parameters::keep_degree_two_nodes(true));
  }
  catch(const CGAL::Reeb_graph::Error& error)
  {
    std::cerr << "Error: " << error.what() << std::endl;
    return EXIT_FAILURE;
  }

  for(auto node : CGAL::make_range(vertices(graph)))
    std::cout << "node " << node << " at the squared distance " << graph[node].value << std::endl;
  for(auto arc : CGAL::make_range(edges(graph)))
    std::cout << "arc " << source(arc, graph) << " -> " << target(arc, graph) << std::endl;
  return EXIT_SUCCESS;
}
