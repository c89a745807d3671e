#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <CGAL/Reeb_graph/curves/cutting_system.h>

#include <cstdlib>
#include <iostream>
#include <iterator>
#include <string>
#include <vector>

typedef CGAL::Simple_cartesian<double> Kernel;
typedef CGAL::Surface_mesh<Kernel::Point_3> Mesh;
typedef boost::graph_traits<Mesh>::vertex_descriptor vertex_descriptor;
typedef boost::graph_traits<Mesh>::halfedge_descriptor halfedge_descriptor;
typedef CGAL::Reeb_graph::Curve<halfedge_descriptor> Curve;

int main(int argc, char* argv[])
{
  const std::string filename = (argc > 1) ? argv[1] : "data/double_torus.off";

  Mesh mesh;
  if(!CGAL::IO::read_polygon_mesh(filename, mesh))
  {
    std::cerr << "Error: cannot read " << filename << std::endl;
    return EXIT_FAILURE;
  }

  const auto scalar_map = mesh.add_property_map<vertex_descriptor, double>("v:scalar").first;
  for(vertex_descriptor v : vertices(mesh))
    scalar_map[v] = mesh.point(v).x();

  try
  {
    // one closed curve of mesh edges for each handle
    std::vector<Curve> curves;
    CGAL::Reeb_graph::cutting_system(mesh, scalar_map, std::back_inserter(curves));
    for(const Curve& curve : curves)
      std::cout << "a curve of " << curve.halfedges.size() << " edges and length " << curve.length << " at "
                << curve.value << std::endl;
  }
  catch(const CGAL::Reeb_graph::Error& error)
  {
    std::cerr << "Error: " << error.what() << std::endl;
    return EXIT_FAILURE;
  }
  return EXIT_SUCCESS;
}
