#include <CGAL/Polyhedron_3.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <CGAL/Reeb_graph_traits.h>
#include <CGAL/compute_reeb_graph.h>

#include <cstdlib>
#include <iostream>
#include <string>
#include <type_traits>
#include <vector>

typedef CGAL::Simple_cartesian<double> Kernel;
typedef CGAL::Polyhedron_3<Kernel> Mesh;
typedef boost::graph_traits<Mesh>::vertex_descriptor vertex_descriptor;

int main(int argc, char* argv[])
{
  const std::string filename = (argc > 1) ? argv[1] : "data/double_torus.off";

  Mesh mesh;
  if(!CGAL::IO::read_polygon_mesh(filename, mesh))
  {
    std::cerr << "Error: cannot read " << filename << std::endl;
    return EXIT_FAILURE;
  }

  // A polyhedron has no property maps of its own: the values are a range, one per vertex.
  std::vector<double> values;
  for(vertex_descriptor v : vertices(mesh))
    values.push_back(v->point().x());
  const auto scalar_map = CGAL::Reeb_graph::make_scalar_map(mesh, values);

  typedef CGAL::Reeb_graph_traits<Mesh, std::decay_t<decltype(scalar_map)>> Traits;
  typedef Traits::Arc Arc;
  Traits::Graph graph;
  try
  {
    CGAL::compute_reeb_graph(mesh, scalar_map, graph);
  }
  catch(const CGAL::Reeb_graph::Error& error)
  {
    std::cerr << "Error: " << error.what() << std::endl;
    return EXIT_FAILURE;
  }

  std::cout << num_vertices(graph) << " nodes" << std::endl;
  for(auto node : CGAL::make_range(vertices(graph)))
    std::cout << "  " << node << ": at " << graph[node].vertex->point() << std::endl;

  const auto chains = get(&Arc::chain, graph);
  std::cout << num_edges(graph) << " arcs" << std::endl;
  for(auto arc : CGAL::make_range(edges(graph)))
    std::cout << "  " << source(arc, graph) << " -> " << target(arc, graph) << ": " << get(chains, arc).size()
              << " halfedges" << std::endl;
  return EXIT_SUCCESS;
}
