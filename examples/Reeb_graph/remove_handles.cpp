#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <CGAL/Reeb_graph/handles/remove_handles.h>

#include <cstdlib>
#include <iostream>
#include <string>

typedef CGAL::Simple_cartesian<double> Kernel;
typedef CGAL::Surface_mesh<Kernel::Point_3> Mesh;

int main(int argc, char* argv[])
{
  const std::string filename = (argc > 1) ? argv[1] : "data/double_torus.off";
  const double size = (argc > 2) ? std::stod(argv[2]) : 100;

  Mesh mesh;
  if(!CGAL::IO::read_polygon_mesh(filename, mesh))
  {
    std::cerr << "Error: cannot read " << filename << std::endl;
    return EXIT_FAILURE;
  }

  try
  {
    // all handles and tunnels with a loop that is shorter
    for(const auto& handle : CGAL::Reeb_graph::remove_handles(mesh, size))
      std::cout << "a " << to_string(handle.kind) << " of length " << handle.length << ": " << to_string(handle.result)
                << std::endl;
    CGAL::IO::write_polygon_mesh("without_handles.off", mesh, CGAL::parameters::stream_precision(17));
  }
  catch(const CGAL::Reeb_graph::Error& error)
  {
    std::cerr << "Error: " << error.what() << std::endl;
    return EXIT_FAILURE;
  }
  return EXIT_SUCCESS;
}
