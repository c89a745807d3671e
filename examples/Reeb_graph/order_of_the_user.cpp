#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <CGAL/compute_reeb_graph.h>

#include <cstdlib>
#include <functional>
#include <iostream>
#include <string>

typedef CGAL::Simple_cartesian<double> Kernel;
typedef CGAL::Surface_mesh<Kernel::Point_3> Mesh;
typedef boost::graph_traits<Mesh>::vertex_descriptor vertex_descriptor;
typedef Mesh::Property_map<vertex_descriptor, int> Scalar_map;

// Levels in steps of one tenth, the highest first. A negative number says that nothing has been measured.
struct Traits : CGAL::Reeb_graph_traits<Mesh, Scalar_map>
{
  typedef std::greater<int> Less_scalar;
  struct Is_ordered
  {
    bool operator()(int value) const { return value >= 0; }
  };

  Less_scalar less_scalar_object() const { return Less_scalar(); }
  Is_ordered is_ordered_object() const { return Is_ordered(); }
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

  Scalar_map scalar_map = mesh.add_property_map<vertex_descriptor, int>("v:scalar", -1).first;
  for(vertex_descriptor v : vertices(mesh))
    scalar_map[v] = static_cast<int>(10 * (mesh.point(v).x() + 10));

  // Two named parameters of this package, then one of CGAL.
  const auto parameters = CGAL::parameters::ties(CGAL::Reeb_graph::Ties::CONTRACT)
                            .method(CGAL::Reeb_graph::Method::CRITICAL_SETS)
                            .geom_traits(Traits());
  Traits::Graph graph;
  try
  {
    CGAL::compute_reeb_graph(mesh, scalar_map, graph, parameters);

    // Nodes are numbered in this order: the first ones have the largest numbers.
    for(auto arc : CGAL::make_range(edges(graph)))
      std::cout << graph[source(arc, graph)].value << " down to " << graph[target(arc, graph)].value << std::endl;

    scalar_map[*vertices(mesh).first] = -1;
    CGAL::compute_reeb_graph(mesh, scalar_map, graph, parameters);
  }
  catch(const CGAL::Reeb_graph::Unordered_scalar_error& error)
  {
    std::cout << "vertex " << error.vertex() << " has no value" << std::endl;
    return EXIT_SUCCESS;
  }
  catch(const CGAL::Reeb_graph::Error& error)
  {
    std::cerr << "Error: " << error.what() << std::endl;
  }
  return EXIT_FAILURE;
}
