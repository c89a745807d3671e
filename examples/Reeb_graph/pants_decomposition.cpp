#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh/IO/PLY.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <CGAL/Reeb_graph/curves/Refinement_visitor.h>
#include <CGAL/Reeb_graph/curves/pants_decomposition.h>
#include <CGAL/compute_reeb_graph.h>

#include <cstdlib>
#include <fstream>
#include <iostream>
#include <iterator>
#include <string>
#include <vector>

typedef CGAL::Simple_cartesian<double> Kernel;
typedef CGAL::Surface_mesh<Kernel::Point_3> Mesh;
typedef boost::graph_traits<Mesh>::vertex_descriptor vertex_descriptor;
typedef boost::graph_traits<Mesh>::halfedge_descriptor halfedge_descriptor;
typedef boost::graph_traits<Mesh>::face_descriptor face_descriptor;
typedef CGAL::Reeb_graph::Curve<halfedge_descriptor> Curve;
typedef Mesh::Property_map<vertex_descriptor, double> Scalar_map;

// Consecutive patches get colors that lie far from each other.
CGAL::IO::Color color_of_patch(std::size_t i)
{
  const auto channel = [&](std::size_t step) { return static_cast<unsigned char>(40 + step * (i + 1) % 200); };
  return CGAL::IO::Color(channel(97), channel(151), channel(211));
}

std::size_t count_nodes(const Mesh& mesh, Scalar_map scalar_map)
{
  CGAL::Reeb_graph_traits<Mesh, Scalar_map>::Graph graph;
  CGAL::compute_reeb_graph(mesh, scalar_map, graph);
  return num_vertices(graph);
}

int main(int argc, char* argv[])
{
  const std::string filename = (argc > 1) ? argv[1] : "data/double_torus.off";
  const std::string output_filename = (argc > 2) ? argv[2] : "pants.ply";

  Mesh mesh;
  if(!CGAL::IO::read_polygon_mesh(filename, mesh))
  {
    std::cerr << "Error: cannot read " << filename << std::endl;
    return EXIT_FAILURE;
  }

  const Scalar_map scalar_map = mesh.add_property_map<vertex_descriptor, double>("v:scalar").first;
  for(vertex_descriptor v : vertices(mesh))
    scalar_map[v] = mesh.point(v).x();

  // An attribute of the vertices, which is interpolated at those that are added. The field itself needs no visitor.
  const auto vertex_color_map = mesh.add_property_map<vertex_descriptor, CGAL::IO::Color>("v:color").first;
  for(vertex_descriptor v : vertices(mesh))
    vertex_color_map[v] = CGAL::IO::Color(static_cast<unsigned char>(mesh.point(v).y() > 0 ? 200 : 50), 120, 120);
  CGAL::Reeb_graph::Interpolating_visitor<Mesh> visitor;
  visitor.add_vertex_map(vertex_color_map);

  const auto patch_map = mesh.add_property_map<face_descriptor, int>("f:patch", 0).first;
  std::vector<Curve> curves;
  try
  {
    std::cout << count_nodes(mesh, scalar_map) << " nodes of the Reeb graph before";
    CGAL::Reeb_graph::pants_decomposition(mesh, scalar_map, std::back_inserter(curves),
                                          CGAL::parameters::face_patch_map(patch_map).visitor(visitor));
    std::cout << " and " << count_nodes(mesh, scalar_map) << " after cutting" << std::endl;
  }
  catch(const CGAL::Reeb_graph::Error& error)
  {
    std::cerr << "Error: " << error.what() << std::endl;
    return EXIT_FAILURE;
  }
  for(const Curve& curve : curves)
    std::cout << "a curve of length " << curve.length << std::endl;

  const auto color_map = mesh.add_property_map<face_descriptor, CGAL::IO::Color>("f:color").first;
  for(face_descriptor f : faces(mesh))
    color_map[f] = color_of_patch(patch_map[f]);
  std::ofstream output(output_filename);
  return output && CGAL::IO::write_PLY(output, mesh) ? EXIT_SUCCESS : EXIT_FAILURE;
}
