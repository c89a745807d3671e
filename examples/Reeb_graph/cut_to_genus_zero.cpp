#include <CGAL/Polygon_mesh_processing/border.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>
#include <CGAL/boost/graph/copy_face_graph.h>
#include <CGAL/iterator.h>

#include <CGAL/Reeb_graph/curves/cutting_system.h>

#include <cstdlib>
#include <iostream>
#include <string>

typedef CGAL::Simple_cartesian<double> Kernel;
typedef CGAL::Surface_mesh<Kernel::Point_3> Mesh;
typedef boost::graph_traits<Mesh>::vertex_descriptor vertex_descriptor;

int main(int argc, char* argv[])
{
  const std::string filename = (argc > 1) ? argv[1] : "data/double_torus.off";
  const std::string output_filename = (argc > 2) ? argv[2] : "genus_zero.off";

  Mesh mesh;
  if(!CGAL::IO::read_polygon_mesh(filename, mesh))
  {
    std::cerr << "Error: cannot read " << filename << std::endl;
    return EXIT_FAILURE;
  }

  // cuts a copy, to keep the input
  Mesh cut_mesh;
  CGAL::copy_face_graph(mesh, cut_mesh);
  const auto scalar_map = cut_mesh.add_property_map<vertex_descriptor, double>("v:scalar").first;
  for(vertex_descriptor v : vertices(cut_mesh))
    scalar_map[v] = cut_mesh.point(v).x();
  try
  {
    CGAL::Reeb_graph::cutting_system(cut_mesh, scalar_map, CGAL::Emptyset_iterator(), CGAL::parameters::cut_open(true));
  }
  catch(const CGAL::Reeb_graph::Error& error)
  {
    std::cerr << "Error: " << error.what() << std::endl;
    return EXIT_FAILURE;
  }

  // twice as many border cycles as handles
  const long number_of_borders = CGAL::Polygon_mesh_processing::number_of_borders(cut_mesh);
  const long euler_characteristic =
    long(num_vertices(cut_mesh)) - long(num_edges(cut_mesh)) + long(num_faces(cut_mesh));
  std::cout << number_of_borders << " border cycles, genus " << (2 - euler_characteristic - number_of_borders) / 2
            << std::endl;
  return CGAL::IO::write_polygon_mesh(output_filename, cut_mesh) ? EXIT_SUCCESS : EXIT_FAILURE;
}
