#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <CGAL/compute_reeb_graph.h>

#include <cstdlib>
#include <iostream>
#include <string>
#include <vector>

typedef CGAL::Simple_cartesian<double> Kernel;
typedef CGAL::Surface_mesh<Kernel::Point_3> Mesh;
typedef boost::graph_traits<Mesh>::vertex_descriptor vertex_descriptor;
typedef Mesh::Property_map<vertex_descriptor, double> Scalar_map;
typedef Mesh::Property_map<vertex_descriptor, std::size_t> Place_map;
typedef CGAL::Reeb_graph_traits<Mesh, Scalar_map>::Graph Graph;

int main(int argc, char* argv[])
{
  const std::string filename = (argc > 1) ? argv[1] : "data/double_torus.off";

  Mesh mesh;
  if(!CGAL::IO::read_polygon_mesh(filename, mesh))
  {
    std::cerr << "Error: cannot read " << filename << std::endl;
    return EXIT_FAILURE;
  }

  Scalar_map scalar_map = mesh.add_property_map<vertex_descriptor, double>("v:scalar").first;
  for(vertex_descriptor v : vertices(mesh))
    scalar_map[v] = mesh.point(v).x();

  const Place_map place_map = mesh.add_property_map<vertex_descriptor, std::size_t>("v:place").first;
  Graph graph;
  try
  {
    CGAL::compute_reeb_graph(mesh, scalar_map, graph, CGAL::parameters::vertex_place_map(place_map));
  }
  catch(const CGAL::Reeb_graph::Error& error)
  {
    std::cerr << "Error: " << error.what() << std::endl;
    return EXIT_FAILURE;
  }

  std::vector<std::size_t> counts(num_vertices(graph) + num_edges(graph), 0);
  for(vertex_descriptor v : vertices(mesh))
    ++counts[place_map[v]];
  for(std::size_t i = 0; i != num_edges(graph); ++i)
    std::cout << "arc " << i << ": " << counts[num_vertices(graph) + i] << " vertices" << std::endl;
  return EXIT_SUCCESS;
}
