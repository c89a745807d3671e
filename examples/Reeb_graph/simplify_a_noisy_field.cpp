#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <CGAL/Reeb_graph/Augmentation.h>
#include <CGAL/Reeb_graph/simplification/simplify.h>
#include <CGAL/Reeb_graph/simplification/simplify_field.h>
#include <CGAL/Reeb_graph_traits.h>
#include <CGAL/compute_reeb_graph.h>

#include <algorithm>
#include <cstdlib>
#include <iostream>
#include <random>
#include <string>

typedef CGAL::Simple_cartesian<double> Kernel;
typedef CGAL::Surface_mesh<Kernel::Point_3> Mesh;
typedef boost::graph_traits<Mesh>::vertex_descriptor vertex_descriptor;
typedef Mesh::Property_map<vertex_descriptor, double> Scalar_map;
typedef CGAL::Reeb_graph_traits<Mesh, Scalar_map>::Graph Graph;
typedef CGAL::Reeb_graph::Simplification<Graph> Simplification;
typedef CGAL::Reeb_graph::Augmentation<Mesh, Scalar_map> Augmentation;

int main(int argc, char* argv[])
{
  const std::string filename = (argc > 1) ? argv[1] : "data/genus_3.off";

  Mesh mesh;
  if(!CGAL::IO::read_polygon_mesh(filename, mesh) || mesh.is_empty())
  {
    std::cerr << "Error: cannot read " << filename << std::endl;
    return EXIT_FAILURE;
  }

  // a smooth field, and noise of 5 percent of its range
  Scalar_map scalar_map = mesh.add_property_map<vertex_descriptor, double>("v:scalar").first;
  for(vertex_descriptor v : vertices(mesh))
    scalar_map[v] = mesh.point(v).x();
  const auto range = std::minmax_element(scalar_map.begin(), scalar_map.end());
  const double width = *range.second - *range.first;
  std::mt19937 random;
  for(vertex_descriptor v : vertices(mesh))
    scalar_map[v] += 0.05 * width * (2. * random() / random.max() - 1);

  try
  {
    Graph graph, simplified;
    CGAL::compute_reeb_graph(mesh, scalar_map, graph);
    const Simplification simplification = CGAL::Reeb_graph::simplify(graph, 0.11 * width, simplified);
    std::cout << num_vertices(graph) << " nodes, " << num_vertices(simplified) << " of them without noise" << std::endl;

    // The vertices of each arc of the simplified graph
    const Augmentation augmentation(mesh, scalar_map, simplified, CGAL::parameters::simplification(simplification));
    const Augmentation::Vertex_places places = augmentation.locate_vertices();
    for(std::size_t i = 0; i != num_edges(simplified); ++i)
      std::cout << "arc " << i << ": " << places.vertices_of_arc(i).size() << " vertices" << std::endl;

    // A field that has this graph
    const double change = CGAL::Reeb_graph::simplify_field(mesh, scalar_map, 0.11 * width, scalar_map);
    CGAL::compute_reeb_graph(mesh, scalar_map, graph);
    std::cout << num_vertices(graph) << " nodes of the simplified field, which is changed by at most "
              << 100 * change / width << " percent of the range" << std::endl;
  }
  catch(const CGAL::Reeb_graph::Error& error)
  {
    std::cerr << "Error: " << error.what() << std::endl;
    return EXIT_FAILURE;
  }
  return EXIT_SUCCESS;
}
