#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/Euler_operations.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <CGAL/Reeb_graph/curves/pants_decomposition.h>
#include <CGAL/Reeb_graph/fields/make_borders_level.h>

#include <algorithm>
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

// A hole as a scanner leaves it where it does not see the surface: all faces at a vertex are missing.
void make_hole(Mesh& mesh, vertex_descriptor v)
{
  CGAL::Euler::remove_face(CGAL::Euler::remove_center_vertex(halfedge(v, mesh), mesh), mesh);
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
  const auto [lowest, highest] =
    std::minmax_element(vertices(mesh).begin(), vertices(mesh).end(),
                        [&](vertex_descriptor u, vertex_descriptor v) { return mesh.point(u) < mesh.point(v); });
  for(const vertex_descriptor v : {*lowest, *highest})
    make_hole(mesh, v);
  mesh.collect_garbage();

  const auto scalar_map = mesh.add_property_map<vertex_descriptor, double>("v:scalar").first;
  for(vertex_descriptor v : vertices(mesh))
    scalar_map[v] = mesh.point(v).y();

  std::vector<Curve> curves;
  try
  {
    const auto changes = CGAL::Reeb_graph::make_borders_level(mesh, scalar_map);
    std::cout << changes.number_of_changed_borders << " of " << changes.number_of_borders
              << " borders made level, by changes of at most " << changes.largest_change << std::endl;
    CGAL::Reeb_graph::pants_decomposition(mesh, scalar_map, std::back_inserter(curves));
  }
  catch(const CGAL::Reeb_graph::Error& error)
  {
    std::cerr << "Error: " << error.what() << std::endl;
    return EXIT_FAILURE;
  }
  for(const Curve& curve : curves)
    std::cout << "a curve of length " << curve.length << std::endl;
  return EXIT_SUCCESS;
}
