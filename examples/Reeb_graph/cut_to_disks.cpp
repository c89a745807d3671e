#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <CGAL/Reeb_graph/curves/cut_to_disks.h>

#include <cstdlib>
#include <iostream>
#include <iterator>
#include <string>
#include <vector>

typedef CGAL::Simple_cartesian<double> Kernel;
typedef CGAL::Surface_mesh<Kernel::Point_3> Mesh;
typedef boost::graph_traits<Mesh>::vertex_descriptor vertex_descriptor;
typedef boost::graph_traits<Mesh>::halfedge_descriptor halfedge_descriptor;

int main(int argc, char* argv[])
{
  const std::string filename = (argc > 1) ? argv[1] : "data/double_torus.off";
  const std::string output_filename = (argc > 2) ? argv[2] : "disk.off";

  Mesh mesh;
  if(!CGAL::IO::read_polygon_mesh(filename, mesh))
  {
    std::cerr << "Error: cannot read " << filename << std::endl;
    return EXIT_FAILURE;
  }

  // the vertex that each vertex of the disks is a copy of, to carry a flattening back
  const auto original_map = mesh.add_property_map<vertex_descriptor, vertex_descriptor>("v:original").first;
  std::vector<CGAL::Reeb_graph::Curve<halfedge_descriptor>> curves;
  try
  {
    CGAL::Reeb_graph::cut_to_disks(mesh, std::back_inserter(curves),
                                   CGAL::parameters::original_vertex_map(original_map));
  }
  catch(const CGAL::Reeb_graph::Error& error)
  {
    std::cerr << "Error: " << error.what() << std::endl;
    return EXIT_FAILURE;
  }

  double length = 0;
  for(const auto& curve : curves)
    length += curve.length;
  std::size_t number_of_copies = 0;
  for(vertex_descriptor v : vertices(mesh))
    number_of_copies += original_map[v] != v;
  std::cout << "cut along " << length << ", " << number_of_copies << " vertices are copies" << std::endl;
  return CGAL::IO::write_polygon_mesh(output_filename, mesh) ? EXIT_SUCCESS : EXIT_FAILURE;
}
