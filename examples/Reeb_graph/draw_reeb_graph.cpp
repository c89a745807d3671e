#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <CGAL/Reeb_graph/IO/svg.h>
#include <CGAL/Reeb_graph/plane_layout.h>
#include <CGAL/Reeb_graph/scalar_maps.h>
#include <CGAL/Reeb_graph/simplification/simplification_thresholds.h>
#include <CGAL/compute_reeb_graph.h>

#include <cstddef>
#include <cstdlib>
#include <iostream>
#include <string>
#include <type_traits>
#include <vector>

typedef CGAL::Simple_cartesian<double> Kernel;
typedef CGAL::Surface_mesh<Kernel::Point_3> Mesh;
typedef boost::graph_traits<Mesh>::vertex_descriptor vertex_descriptor;
namespace parameters = CGAL::parameters;

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
    CGAL::Reeb_graph::make_scalar_map_from_function(mesh, [&](vertex_descriptor v) { return mesh.point(v).x(); });
  typedef CGAL::Reeb_graph_traits<Mesh, std::remove_const_t<decltype(scalar_map)>>::Graph Graph;
  try
  {
    Graph graph;
    CGAL::compute_reeb_graph(mesh, scalar_map, graph);

    // A picture of the graph, with the indices of the vertices where the pointer rests on a node.
    CGAL::Reeb_graph::write_svg(
      "graph.svg", graph,
      parameters::field_name("x").field_unit("mm").vertex_index_map(get(boost::vertex_index, mesh)));

    // The layout, for drawings of your own.
    const CGAL::Reeb_graph::Plane_layout layout = CGAL::Reeb_graph::lay_out_in_plane(graph);
    for(std::size_t node = 0; node != num_vertices(graph); ++node)
      std::cout << "node " << node << " is drawn at " << layout.node_positions[node] << ", " << graph[node].value
                << std::endl;

    // The threshold up to which simplification keeps each arc, for the width of its line.
    const std::vector<double> persistences = CGAL::Reeb_graph::arc_persistences(graph);
    for(std::size_t arc = 0; arc != persistences.size(); ++arc)
      std::cout << "arc " << arc << " has " << layout.arc_polylines[arc].size() << " points, and the persistence "
                << persistences[arc] << std::endl;
  }
  catch(const CGAL::Reeb_graph::Error& error)
  {
    std::cerr << "Error: " << error.what() << std::endl;
    return EXIT_FAILURE;
  }
  return EXIT_SUCCESS;
}
