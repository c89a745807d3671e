#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh/IO/PLY.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <CGAL/Reeb_graph/curves/segmentation.h>
#include <CGAL/compute_reeb_graph.h>

#include <cstddef>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <string>

typedef CGAL::Simple_cartesian<double> Kernel;
typedef CGAL::Surface_mesh<Kernel::Point_3> Mesh;
typedef boost::graph_traits<Mesh>::vertex_descriptor vertex_descriptor;
typedef boost::graph_traits<Mesh>::face_descriptor face_descriptor;
typedef Mesh::Property_map<vertex_descriptor, double> Scalar_map;
typedef CGAL::Reeb_graph_traits<Mesh, Scalar_map>::Graph Graph;

// Consecutive patches get colors that lie far from each other.
CGAL::IO::Color color_of_patch(std::size_t i)
{
  const auto channel = [&](std::size_t step) { return static_cast<unsigned char>(40 + step * (i + 1) % 200); };
  return CGAL::IO::Color(channel(97), channel(151), channel(211));
}

int main(int argc, char* argv[])
{
  const std::string filename = (argc > 1) ? argv[1] : "data/double_torus.off";
  const std::string output_filename = (argc > 2) ? argv[2] : "segmented.ply";

  Mesh mesh;
  if(!CGAL::IO::read_polygon_mesh(filename, mesh))
  {
    std::cerr << "Error: cannot read " << filename << std::endl;
    return EXIT_FAILURE;
  }

  Scalar_map scalar_map = mesh.add_property_map<vertex_descriptor, double>("v:scalar").first;
  for(vertex_descriptor v : vertices(mesh))
    scalar_map[v] = mesh.point(v).x();

  const auto patch_map = mesh.add_property_map<face_descriptor, int>("f:patch", 0).first;
  try
  {
    Graph graph;
    CGAL::compute_reeb_graph(mesh, scalar_map, graph);

    // refines the mesh, so that each face belongs to one arc
    const std::size_t number_of_patches = CGAL::Reeb_graph::segment_by_arcs(mesh, scalar_map, graph, patch_map);
    std::cout << num_edges(graph) << " arcs, " << number_of_patches << " patches, " << num_faces(mesh) << " faces"
              << std::endl;
  }
  catch(const CGAL::Reeb_graph::Error& error)
  {
    std::cerr << "Error: " << error.what() << std::endl;
    return EXIT_FAILURE;
  }

  const auto color_map = mesh.add_property_map<face_descriptor, CGAL::IO::Color>("f:color").first;
  for(face_descriptor f : faces(mesh))
    color_map[f] = color_of_patch(patch_map[f]);
  std::ofstream output(output_filename);
  return output && CGAL::IO::write_PLY(output, mesh) ? EXIT_SUCCESS : EXIT_FAILURE;
}
