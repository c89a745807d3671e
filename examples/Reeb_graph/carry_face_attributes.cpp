#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <CGAL/Reeb_graph/curves/cutting_system.h>

#include <cstdlib>
#include <functional>
#include <iostream>
#include <iterator>
#include <string>
#include <vector>

typedef CGAL::Simple_cartesian<double> Kernel;
typedef CGAL::Surface_mesh<Kernel::Point_3> Mesh;
typedef boost::graph_traits<Mesh>::vertex_descriptor vertex_descriptor;
typedef boost::graph_traits<Mesh>::halfedge_descriptor halfedge_descriptor;
typedef boost::graph_traits<Mesh>::face_descriptor face_descriptor;
typedef Mesh::Property_map<vertex_descriptor, double> Scalar_map;
typedef Mesh::Property_map<face_descriptor, std::size_t> Number_map;

// Each part of a face keeps the number of the face. A model of ReebGraphRefinementVisitor.
struct Visitor : CGAL::Reeb_graph::Default_refinement_visitor<Mesh>
{
  explicit Visitor(Number_map numbers) : numbers(numbers) {}

  void face_split(face_descriptor old, face_descriptor created) { numbers[created] = numbers[old]; }
  void vertex_added(vertex_descriptor, vertex_descriptor, vertex_descriptor, double) { ++number_of_new_vertices; }

  Number_map numbers;
  std::size_t number_of_new_vertices = 0;
};

int main(int argc, char* argv[])
{
  const std::string filename = (argc > 1) ? argv[1] : "data/double_torus.off";

  Mesh mesh;
  if(!CGAL::IO::read_polygon_mesh(filename, mesh))
  {
    std::cerr << "Error: cannot read " << filename << std::endl;
    return EXIT_FAILURE;
  }

  Scalar_map scalar_map = mesh.add_property_map<vertex_descriptor, double>("v:scalar").first;
  for(vertex_descriptor v : vertices(mesh))
    scalar_map[v] = mesh.point(v).x();
  Number_map numbers = mesh.add_property_map<face_descriptor, std::size_t>("f:number").first;
  std::size_t number_of_faces = 0;
  for(face_descriptor f : faces(mesh))
    numbers[f] = number_of_faces++;

  Visitor visitor(numbers);
  try
  {
    std::vector<CGAL::Reeb_graph::Curve<halfedge_descriptor>> curves;
    CGAL::Reeb_graph::cutting_system(mesh, scalar_map, std::back_inserter(curves),
                                     CGAL::parameters::visitor(std::ref(visitor)));
    std::cout << curves.size() << " curves" << std::endl;
  }
  catch(const CGAL::Reeb_graph::Error& error)
  {
    std::cerr << "Error: " << error.what() << std::endl;
    return EXIT_FAILURE;
  }

  std::vector<std::size_t> number_of_parts(number_of_faces, 0);
  for(face_descriptor f : faces(mesh))
    ++number_of_parts[numbers[f]];
  std::size_t number_of_cut_faces = 0;
  for(const std::size_t parts : number_of_parts)
    number_of_cut_faces += parts > 1 ? 1 : 0;
  std::cout << number_of_cut_faces << " of " << number_of_faces << " faces have been cut, at "
            << visitor.number_of_new_vertices << " new vertices" << std::endl;
  return EXIT_SUCCESS;
}
