#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <CGAL/Reeb_graph/handles/area_of_filling_disc.h>
#include <CGAL/Reeb_graph/handles/handle_and_tunnel_loops.h>

#include <cstddef>
#include <cstdlib>
#include <iostream>
#include <string>
#include <vector>

typedef CGAL::Simple_cartesian<double> Kernel;
typedef CGAL::Surface_mesh<Kernel::Point_3> Mesh;
typedef boost::graph_traits<Mesh>::vertex_descriptor vertex_descriptor;
typedef boost::graph_traits<Mesh>::halfedge_descriptor halfedge_descriptor;

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
    // for each handle, a loop that bounds inside, and one that bounds outside
    const auto found = CGAL::Reeb_graph::handle_and_tunnel_loops(mesh, scalar_map);

    // the areas of discs that fill them
    std::vector<std::vector<halfedge_descriptor>> simple_loops;
    for(const auto& loop : found.loops())
      simple_loops.push_back(loop.is_simple ? loop.halfedges : std::vector<halfedge_descriptor>());
    const auto areas = CGAL::Reeb_graph::areas_of_filling_discs(mesh, simple_loops);

    for(std::size_t i = 0; i < areas.size(); ++i)
    {
      const auto& loop = found.loops()[i];
      std::cout << "a " << to_string(loop.kind) << " of " << loop.halfedges.size() << " edges and length "
                << loop.length << ", partner " << loop.partner << ", persistence " << loop.persistence << ", ";
      if(areas[i])
        std::cout << "filled by a disc of area " << *areas[i] << std::endl;
      else
        std::cout << "without a disc" << std::endl;
    }
  }
  catch(const CGAL::Reeb_graph::Error& error)
  {
    std::cerr << "Error: " << error.what() << std::endl;
    return EXIT_FAILURE;
  }
  return EXIT_SUCCESS;
}
