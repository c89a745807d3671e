#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <CGAL/Reeb_graph/simplification/persistence_pairs.h>
#include <CGAL/Reeb_graph_traits.h>
#include <CGAL/compute_reeb_graph.h>

#include <algorithm>
#include <cstdlib>
#include <iostream>
#include <iterator>
#include <string>
#include <vector>

typedef CGAL::Simple_cartesian<double> Kernel;
typedef CGAL::Surface_mesh<Kernel::Point_3> Mesh;
typedef boost::graph_traits<Mesh>::vertex_descriptor vertex_descriptor;
typedef Mesh::Property_map<vertex_descriptor, double> Scalar_map;
typedef CGAL::Reeb_graph_traits<Mesh, Scalar_map>::Graph Graph;
typedef boost::graph_traits<Graph>::vertex_descriptor node_descriptor;
typedef CGAL::Reeb_graph::Persistence_pair<node_descriptor> Pair;

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

  try
  {
    Graph graph;
    CGAL::compute_reeb_graph(mesh, scalar_map, graph);

    std::vector<Pair> pairs;
    CGAL::Reeb_graph::persistence_pairs(graph, std::back_inserter(pairs));
    std::stable_sort(pairs.begin(), pairs.end(), [&](const Pair& a, const Pair& b) {
      return CGAL::Reeb_graph::persistence(graph, a) > CGAL::Reeb_graph::persistence(graph, b);
    });
    for(const Pair& pair : pairs)
      std::cout << to_string(pair.kind) << ": from " << graph[pair.lower_node].value << " to "
                << graph[pair.upper_node].value << std::endl;
  }
  catch(const CGAL::Reeb_graph::Error& error)
  {
    std::cerr << "Error: " << error.what() << std::endl;
    return EXIT_FAILURE;
  }
  return EXIT_SUCCESS;
}
