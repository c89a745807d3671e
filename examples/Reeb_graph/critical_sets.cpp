#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <CGAL/Reeb_graph.h>

#include <cstdlib>
#include <iostream>
#include <string>
#include <variant>

typedef CGAL::Simple_cartesian<double> Kernel;
typedef CGAL::Surface_mesh<Kernel::Point_3> Mesh;
typedef boost::graph_traits<Mesh>::vertex_descriptor vertex_descriptor;
typedef Mesh::Property_map<vertex_descriptor, double> Scalar_map;
typedef CGAL::Reeb_graph_traits<Mesh, Scalar_map>::Graph Graph;
typedef CGAL::Reeb_graph::Augmentation<Mesh, Scalar_map> Augmentation;

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

  try
  {
    Graph graph;
    CGAL::compute_reeb_graph(mesh, scalar_map, graph);
    const Augmentation augmentation(mesh, scalar_map, graph);

    // At each node: the contours that meet there, each with its arc, and the faces around.
    const auto number_of_arc = get(boost::edge_index, graph);
    for(auto node : CGAL::make_range(vertices(graph)))
    {
      const Augmentation::Critical_set critical_set = augmentation.critical_set(node);
      std::cout << "node " << node << ", " << CGAL::Reeb_graph::to_string(graph[node].kind) << ", "
                << critical_set.star.size() << " faces around" << std::endl;
      for(const Augmentation::Contour& contour : critical_set.lower_contours)
        std::cout << "  from arc " << number_of_arc[contour.arc] << ": " << contour.number_of_crossings() << " edges"
                  << std::endl;
      for(const Augmentation::Contour& contour : critical_set.upper_contours)
        std::cout << "  to arc " << number_of_arc[contour.arc] << ": " << contour.number_of_crossings() << " edges"
                  << std::endl;
    }

    // The place of a vertex is a node or an arc: ask which, or take its number, in which arcs come behind the nodes.
    const Augmentation::Vertex_places places = augmentation.locate_vertices();
    const vertex_descriptor v = *vertices(mesh).first;
    const Augmentation::Vertex_places::Place place = places[v];
    if(const auto* arc = std::get_if<Augmentation::arc_descriptor>(&place))
      std::cout << v << " is on arc " << number_of_arc[*arc] << std::endl;
    else
      std::cout << v << " is node " << std::get<Augmentation::node_descriptor>(place) << std::endl;
    std::cout << "number of its place: " << places.index(v) << " of " << num_vertices(graph) + num_edges(graph)
              << std::endl;
  }
  catch(const CGAL::Reeb_graph::Error& error)
  {
    std::cerr << "Error: " << error.what() << std::endl;
    return EXIT_FAILURE;
  }
  return EXIT_SUCCESS;
}
