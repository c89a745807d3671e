#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <CGAL/Reeb_graph/Augmentation.h>
#include <CGAL/Reeb_graph/comparison/bottleneck_distance.h>
#include <CGAL/Reeb_graph/comparison/match_arcs.h>
#include <CGAL/Reeb_graph/comparison/match_tips.h>
#include <CGAL/Reeb_graph_traits.h>
#include <CGAL/compute_reeb_graph.h>

#include <cstdlib>
#include <iostream>
#include <iterator>
#include <string>
#include <utility>
#include <vector>

typedef CGAL::Simple_cartesian<double> Kernel;
typedef CGAL::Surface_mesh<Kernel::Point_3> Mesh;
typedef boost::graph_traits<Mesh>::vertex_descriptor vertex_descriptor;
typedef Mesh::Property_map<vertex_descriptor, double> Scalar_map;
typedef CGAL::Reeb_graph_traits<Mesh, Scalar_map>::Graph Graph;
typedef boost::graph_traits<Graph>::edge_descriptor arc_descriptor;
typedef CGAL::Reeb_graph::Augmentation<Mesh, Scalar_map> Augmentation;

// The pairs of the graph with their values.
std::vector<CGAL::Reeb_graph::Persistence_values> pairs_of(const Graph& graph)
{
  std::vector<CGAL::Reeb_graph::Persistence_values> pairs;
  CGAL::Reeb_graph::persistence_values(graph, std::back_inserter(pairs));
  return pairs;
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

  // the same surface, seen by two fields: the coordinate x, and the same of a surface that is one percent wider
  Scalar_map width = mesh.add_property_map<vertex_descriptor, double>("v:width").first;
  Scalar_map wider = mesh.add_property_map<vertex_descriptor, double>("v:wider").first;
  for(vertex_descriptor v : vertices(mesh))
  {
    width[v] = mesh.point(v).x();
    wider[v] = 1.01 * mesh.point(v).x();
  }

  try
  {
    Graph graph, wider_graph;
    CGAL::compute_reeb_graph(mesh, width, graph);
    CGAL::compute_reeb_graph(mesh, wider, wider_graph);
    std::cout << "distance " << CGAL::Reeb_graph::bottleneck_distance(pairs_of(graph), pairs_of(wider_graph))
              << std::endl;

    std::vector<std::pair<arc_descriptor, arc_descriptor>> partners;
    CGAL::Reeb_graph::match_arcs(graph, Augmentation(mesh, width, graph), wider_graph,
                                 Augmentation(mesh, wider, wider_graph), std::back_inserter(partners));
    std::cout << partners.size() << " of " << num_edges(graph) << " arcs have partners" << std::endl;

    // vertices that stand for the same place, as sources of distances
    std::vector<CGAL::Reeb_graph::Tip_pair<vertex_descriptor, vertex_descriptor>> tips;
    CGAL::Reeb_graph::match_tips(mesh, mesh, std::back_inserter(tips));
    std::cout << tips.size() << " pairs of tips are alike" << std::endl;
  }
  catch(const CGAL::Reeb_graph::Error& error)
  {
    std::cerr << "Error: " << error.what() << std::endl;
    return EXIT_FAILURE;
  }
  return EXIT_SUCCESS;
}
