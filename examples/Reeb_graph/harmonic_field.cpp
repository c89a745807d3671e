#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <CGAL/Reeb_graph/fields/field_constraints.h>
#include <CGAL/Reeb_graph/fields/harmonic_field.h>
#include <CGAL/compute_reeb_graph.h>

#include <cstdlib>
#include <iostream>
#include <iterator>
#include <string>
#include <utility>
#include <vector>

typedef CGAL::Simple_cartesian<double> Kernel;
typedef CGAL::Surface_mesh<Kernel::Point_3> Mesh;
typedef boost::graph_traits<Mesh>::vertex_descriptor vertex_descriptor;
typedef Mesh::Property_map<vertex_descriptor, double> Scalar_map;
typedef CGAL::Reeb_graph_traits<Mesh, Scalar_map>::Graph Graph;

void print_graph(const Mesh& mesh, Scalar_map scalar_map)
{
  Graph graph;
  CGAL::compute_reeb_graph(mesh, scalar_map, graph);
  std::cout << num_vertices(graph) << " nodes, " << num_edges(graph) << " arcs" << std::endl;
  for(auto arc : CGAL::make_range(edges(graph)))
    std::cout << "  " << graph[source(arc, graph)].value << " -> " << graph[target(arc, graph)].value << std::endl;
}

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
  try
  {
    std::cout << "between two vertices that are far apart: ";
    CGAL::Reeb_graph::compute_harmonic_field_between_far_apart_vertices(mesh, scalar_map);
    print_graph(mesh, scalar_map);

    std::cout << "with given values: ";
    std::vector<std::pair<vertex_descriptor, vertex_descriptor>> far_apart;
    CGAL::Reeb_graph::find_far_apart_vertices(mesh, std::back_inserter(far_apart));
    std::vector<std::pair<vertex_descriptor, double>> constraints;
    for(const auto& pair : far_apart) // one pair for each component
    {
      constraints.emplace_back(pair.first, -1);
      if(pair.second != pair.first) // as in a component of a single vertex
        constraints.emplace_back(pair.second, 3);
    }
    CGAL::Reeb_graph::compute_harmonic_field(
      mesh, scalar_map, constraints,
      CGAL::parameters::laplacian_weights(CGAL::Reeb_graph::Laplacian_weights::COTANGENT));
    print_graph(mesh, scalar_map);
  }
  catch(const CGAL::Reeb_graph::Error& error)
  {
    std::cerr << "Error: " << error.what() << std::endl;
    return EXIT_FAILURE;
  }
  return EXIT_SUCCESS;
}
