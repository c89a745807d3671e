#include <CGAL/Polyhedron_3.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <CGAL/Reeb_graph/curves/pants_decomposition.h>
#include <CGAL/Reeb_graph/scalar_maps.h>

#include <cstdlib>
#include <iostream>
#include <iterator>
#include <string>
#include <vector>

typedef CGAL::Simple_cartesian<double> Kernel;
typedef CGAL::Polyhedron_3<Kernel> Mesh;
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

  try
  {
    // the field is a function of the vertices: their distances from the origin
    const auto scalar_map = CGAL::Reeb_graph::make_scalar_map_from_function(
      mesh, [](vertex_descriptor v) { return (v->point() - CGAL::ORIGIN).squared_length(); });

    // cut open, the mesh falls apart into pairs of pants
    std::vector<Curve> curves;
    CGAL::Reeb_graph::pants_decomposition(mesh, scalar_map, std::back_inserter(curves),
                                          CGAL::parameters::cut_open(true));
    for(const Curve& curve : curves)
    {
      const halfedge_descriptor upper = curve.halfedges.front(), lower = curve.lower_halfedges.front();
      std::cout << "a curve of " << curve.halfedges.size() << " edges, with a border on both sides: "
                << (upper->opposite()->is_border() && lower->opposite()->is_border()) << std::endl;
    }
  }
  catch(const CGAL::Reeb_graph::Error& error)
  {
    std::cerr << "Error: " << error.what() << std::endl;
    return EXIT_FAILURE;
  }
  return EXIT_SUCCESS;
}
