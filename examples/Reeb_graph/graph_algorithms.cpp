#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <CGAL/Reeb_graph.h>

#include <boost/graph/adjacency_list.hpp>
#include <boost/graph/connected_components.hpp>
#include <boost/graph/dijkstra_shortest_paths.hpp>

#include <cstdlib>
#include <fstream>
#include <iostream>
#include <string>
#include <vector>

typedef CGAL::Simple_cartesian<double> Kernel;
typedef CGAL::Surface_mesh<Kernel::Point_3> Mesh;
typedef boost::graph_traits<Mesh>::vertex_descriptor vertex_descriptor;
typedef Mesh::Property_map<vertex_descriptor, double> Scalar_map;
typedef CGAL::Reeb_graph_traits<Mesh, Scalar_map>::Graph Graph;
// Nodes have the same numbers as those of the Reeb graph.
typedef boost::adjacency_list<boost::vecS,
                              boost::vecS,
                              boost::undirectedS,
                              boost::no_property,
                              boost::property<boost::edge_weight_t, double>>
  Undirected_graph;

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

  Graph graph;
  try
  {
    CGAL::compute_reeb_graph(mesh, scalar_map, graph);
  }
  catch(const CGAL::Reeb_graph::Error& error)
  {
    std::cerr << "Error: " << error.what() << std::endl;
    return EXIT_FAILURE;
  }

  // The lengths of the arcs on the surface are in the order of edges(graph), which is that of their numbers.
  const std::vector<double> lengths = CGAL::Reeb_graph::arc_lengths(mesh, scalar_map, graph);
  const auto number_of_arc = get(boost::edge_index, graph);
  Undirected_graph undirected(num_vertices(graph));
  for(auto arc : CGAL::make_range(edges(graph)))
    add_edge(source(arc, graph), target(arc, graph), lengths[number_of_arc[arc]], undirected);

  std::vector<std::size_t> component(num_vertices(graph));
  const auto component_map = boost::make_iterator_property_map(component.begin(), get(boost::vertex_index, undirected));
  std::cout << boost::connected_components(undirected, component_map) << " component(s)" << std::endl;

  // From the lowest node, up and down.
  std::vector<double> distance(num_vertices(graph));
  boost::dijkstra_shortest_paths(
    undirected, 0,
    boost::distance_map(boost::make_iterator_property_map(distance.begin(), get(boost::vertex_index, undirected))));
  for(auto node : CGAL::make_range(vertices(graph)))
    std::cout << "node " << node << " (" << CGAL::Reeb_graph::to_string(graph[node].kind) << "): " << distance[node]
              << std::endl;

  // For other programs, and to be drawn by dot -Tsvg. Boost has functions of these names.
  std::ofstream graphml("reeb_graph.graphml"), dot("reeb_graph.dot");
  CGAL::Reeb_graph::write_graphml(graphml, graph, get(boost::vertex_index, mesh));
  CGAL::Reeb_graph::write_graphviz(dot, graph, get(boost::vertex_index, mesh));
  return graphml && dot ? EXIT_SUCCESS : EXIT_FAILURE;
}
