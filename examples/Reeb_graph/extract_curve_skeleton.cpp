#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <CGAL/Reeb_graph/skeleton/extract_curve_skeleton.h>

#include <cstdlib>
#include <iostream>
#include <string>

typedef CGAL::Simple_cartesian<double> Kernel;
typedef CGAL::Surface_mesh<Kernel::Point_3> Mesh;
typedef CGAL::Reeb_graph::Curve_skeleton<Mesh> Skeleton; // a boost::adjacency_list

int main(int argc, char* argv[])
{
  const std::string filename = (argc > 1) ? argv[1] : "data/neuron.off";

  Mesh mesh;
  if(!CGAL::IO::read_polygon_mesh(filename, mesh))
  {
    std::cerr << "Error: cannot read " << filename << std::endl;
    return EXIT_FAILURE;
  }

  try
  {
    Skeleton skeleton;
    const auto known = CGAL::Reeb_graph::extract_curve_skeleton(mesh, skeleton);
    std::cout << known.number_of_ends << " ends, " << known.number_of_loops << " loops, "
              << (known.is_inside() ? "all inside" : "not all inside") << std::endl;
    for(const auto& arc : skeleton_arcs(skeleton))
    {
      const auto& middle = skeleton[arc[arc.size() / 2]];
      std::cout << "an arc of " << arc.size() << " points through " << middle.point << ", where the radius is "
                << middle.radius << std::endl;
    }
  }
  catch(const CGAL::Reeb_graph::Error& error)
  {
    std::cerr << "Error: " << error.what() << std::endl;
    return EXIT_FAILURE;
  }
  return EXIT_SUCCESS;
}
