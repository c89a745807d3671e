#include <CGAL/Polyhedron_3.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <CGAL/Reeb_graph/Augmentation.h>
#include <CGAL/Reeb_graph/IO.h>
#include <CGAL/Reeb_graph/graph_topology.h>
#include <CGAL/compute_reeb_graph.h>

#include <cstdlib>
#include <iostream>
#include <iterator>
#include <string>
#include <vector>

typedef CGAL::Simple_cartesian<double> Kernel;
typedef CGAL::Polyhedron_3<Kernel> Mesh; // whose vertices have no indices
typedef boost::graph_traits<Mesh>::vertex_descriptor vertex_descriptor;

int main(int argc, char* argv[])
{
  const std::string filename = (argc > 1) ? argv[1] : "data/double_torus.off";

  Mesh mesh;
  if(!CGAL::IO::read_polygon_mesh(filename, mesh))
  {
    std::cerr << "Error: cannot read " << filename << std::endl;
    return EXIT_FAILURE;
  }

  const auto scalar_map =
    CGAL::Reeb_graph::make_scalar_map_from_function(mesh, [](vertex_descriptor v) { return v->point().x(); });
  typedef CGAL::Reeb_graph_traits<Mesh, std::remove_const_t<decltype(scalar_map)>>::Graph Graph;
  typedef boost::graph_traits<Graph>::edge_descriptor arc_descriptor;
  try
  {
    Graph graph, same_graph;
    CGAL::compute_reeb_graph(mesh, scalar_map, graph);

    // Each independent loop, by the numbers of its arcs, and a curve around each handle.
    std::vector<std::vector<arc_descriptor>> loops;
    CGAL::Reeb_graph::cycle_basis(graph, std::back_inserter(loops));
    for(const auto& loop : loops)
    {
      std::cout << "a loop of the arcs";
      for(arc_descriptor arc : loop)
        std::cout << ' ' << get(boost::edge_index, graph, arc);
      std::cout << std::endl;
    }
    const CGAL::Reeb_graph::Augmentation augmentation(mesh, scalar_map, graph);
    std::vector<decltype(augmentation)::Contour> contours;
    CGAL::Reeb_graph::loop_contours(graph, augmentation, std::back_inserter(contours));
    std::vector<std::vector<Kernel::Point_3>> polylines;
    polylines.reserve(contours.size());
    for(const auto& contour : contours)
      polylines.push_back(CGAL::Reeb_graph::polylines_of_contour(augmentation, contour).front());
    CGAL::Reeb_graph::write_polylines("handles.polylines.txt", polylines);

    // The graph, written with its chains and read back.
    CGAL::Reeb_graph::write_graphml("graph.graphml", graph, CGAL::Reeb_graph::make_vertex_index_map(mesh),
                                    CGAL::Reeb_graph::make_halfedge_index_map(mesh));
    CGAL::Reeb_graph::read_graphml("graph.graphml", mesh, same_graph);
    std::cout << num_edges(same_graph) << " arcs have been read" << std::endl;
  }
  catch(const CGAL::Reeb_graph::Error& error)
  {
    std::cerr << "Error: " << error.what() << std::endl;
    return EXIT_FAILURE;
  }
  return EXIT_SUCCESS;
}
