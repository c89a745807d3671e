#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <CGAL/Reeb_graph_traits.h>
#include <CGAL/compute_reeb_graph.h>

#include <cstdlib>
#include <iostream>
#include <string>

typedef CGAL::Simple_cartesian<double> Kernel;
typedef CGAL::Surface_mesh<Kernel::Point_3> Mesh;
typedef boost::graph_traits<Mesh>::vertex_descriptor vertex_descriptor;
typedef Mesh::Property_map<vertex_descriptor, double> Scalar_map;
typedef CGAL::Reeb_graph_traits<Mesh, Scalar_map> Traits;
typedef Traits::Graph Graph;
typedef Traits::Arc Arc;

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

  std::cout << num_vertices(graph) << " nodes" << std::endl;
  for(auto node : CGAL::make_range(vertices(graph)))
    std::cout << "  " << node << ": vertex " << graph[node].vertex << " at " << graph[node].value << std::endl;

  // The augmentation: a property map from the arcs to chains of ascending halfedges.
  const auto chains = get(&Arc::chain, graph);
  std::cout << num_edges(graph) << " arcs" << std::endl;
  for(auto arc : CGAL::make_range(edges(graph)))
  {
    const auto& chain = get(chains, arc);
    std::cout << "  " << source(arc, graph) << " -> " << target(arc, graph) << ": " << chain.size()
              << " halfedges, from vertex " << source(chain.front(), mesh) << " to " << target(chain.back(), mesh)
              << std::endl;
  }
  return EXIT_SUCCESS;
}
