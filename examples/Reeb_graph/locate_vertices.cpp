#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh/IO/PLY.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <CGAL/Reeb_graph/Augmentation.h>
#include <CGAL/compute_reeb_graph.h>

#include <array>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <string>

typedef CGAL::Simple_cartesian<double> Kernel;
typedef CGAL::Surface_mesh<Kernel::Point_3> Mesh;
typedef boost::graph_traits<Mesh>::vertex_descriptor vertex_descriptor;
typedef Mesh::Property_map<vertex_descriptor, double> Scalar_map;
typedef CGAL::Reeb_graph_traits<Mesh, Scalar_map>::Graph Graph;
typedef CGAL::Reeb_graph::Augmentation<Mesh, Scalar_map> Augmentation;

// Consecutive arcs get colors that lie far from each other.
CGAL::IO::Color color_of_arc(std::size_t i)
{
  const std::array<unsigned, 3> steps = {97, 151, 211};
  std::array<unsigned char, 3> channels;
  for(std::size_t k = 0; k != 3; ++k)
    channels[k] = static_cast<unsigned char>(40 + (steps[k] * (i + 1)) % 200);
  return CGAL::IO::Color(channels[0], channels[1], channels[2]);
}

int main(int argc, char* argv[])
{
  const std::string filename = (argc > 1) ? argv[1] : "data/double_torus.off";
  const std::string output_filename = (argc > 2) ? argv[2] : "located.ply";

  Mesh mesh;
  if(!CGAL::IO::read_polygon_mesh(filename, mesh))
  {
    std::cerr << "Error: cannot read " << filename << std::endl;
    return EXIT_FAILURE;
  }

  Scalar_map scalar_map = mesh.add_property_map<vertex_descriptor, double>("v:scalar").first;
  for(vertex_descriptor v : vertices(mesh))
    scalar_map[v] = mesh.point(v).x();

  const auto color_map =
    mesh.add_property_map<vertex_descriptor, CGAL::IO::Color>("v:color", CGAL::IO::Color(0, 0, 0)).first;
  try
  {
    Graph graph;
    CGAL::compute_reeb_graph(mesh, scalar_map, graph);

    const Augmentation augmentation(mesh, scalar_map, graph);
    const Augmentation::Vertex_places places = augmentation.locate_vertices();
    for(std::size_t i = 0; i != num_edges(graph); ++i)
    {
      for(vertex_descriptor v : places.vertices_of_arc(i))
        color_map[v] = color_of_arc(i);
      std::cout << "arc " << i << ": " << places.vertices_of_arc(i).size() << " vertices" << std::endl;
    }
  }
  catch(const CGAL::Reeb_graph::Error& error)
  {
    std::cerr << "Error: " << error.what() << std::endl;
    return EXIT_FAILURE;
  }

  std::ofstream output(output_filename);
  return output && CGAL::IO::write_PLY(output, mesh) ? EXIT_SUCCESS : EXIT_FAILURE;
}
