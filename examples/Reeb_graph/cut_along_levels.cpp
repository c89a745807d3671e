#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <CGAL/Reeb_graph/curves/cut_along_levels.h>

#include <cstdlib>
#include <iostream>
#include <iterator>
#include <map>
#include <string>
#include <vector>

typedef CGAL::Simple_cartesian<double> Kernel;
typedef CGAL::Surface_mesh<Kernel::Point_3> Mesh;
typedef boost::graph_traits<Mesh>::vertex_descriptor vertex_descriptor;
typedef boost::graph_traits<Mesh>::halfedge_descriptor halfedge_descriptor;
typedef boost::graph_traits<Mesh>::face_descriptor face_descriptor;

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
  const auto band_map = mesh.add_property_map<face_descriptor, int>("f:band").first;

  const std::vector<double> levels = {-0.5, 0., 0.5};
  std::vector<CGAL::Reeb_graph::Curve<halfedge_descriptor>> curves;
  CGAL::Reeb_graph::Level_cut_report report;
  try
  {
    report = CGAL::Reeb_graph::cut_along_levels(mesh, scalar_map, levels, std::back_inserter(curves),
                                                CGAL::parameters::face_band_map(band_map));
  }
  catch(const CGAL::Reeb_graph::Error& error)
  {
    std::cerr << "Error: " << error.what() << std::endl;
    return EXIT_FAILURE;
  }

  std::map<int, std::size_t> number_of_faces;
  for(face_descriptor f : faces(mesh))
    ++number_of_faces[band_map[f]];
  for(const auto& [band, number] : number_of_faces)
    std::cout << "band " << band << " has " << number << " faces" << std::endl;
  for(const auto& curve : curves)
    std::cout << "a curve of length " << curve.length << " at the level " << curve.value << std::endl;
  std::cout << report.number_of_slivers << " slivers among " << report.number_of_added_faces << " added faces"
            << std::endl;
  return EXIT_SUCCESS;
}
