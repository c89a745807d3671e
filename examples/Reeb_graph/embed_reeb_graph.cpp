#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <CGAL/Reeb_graph/Augmentation.h>
#include <CGAL/Reeb_graph/IO.h>
#include <CGAL/Reeb_graph/arc_measures.h>
#include <CGAL/Reeb_graph/embed.h>
#include <CGAL/Reeb_graph/simplification/simplification_thresholds.h>
#include <CGAL/compute_reeb_graph.h>

#include <cstdint>
#include <cstdlib>
#include <iostream>
#include <string>
#include <vector>

typedef CGAL::Simple_cartesian<double>::Point_3 Point;
typedef CGAL::Surface_mesh<Point> Mesh;
typedef Mesh::Property_map<Mesh::Vertex_index, double> Scalar_map;
typedef CGAL::Reeb_graph_traits<Mesh, Scalar_map>::Graph Graph;

int main(int argc, char* argv[])
{
  const std::string filename = (argc > 1) ? argv[1] : "data/double_torus.off";

  Mesh mesh;
  if(!CGAL::IO::read_polygon_mesh(filename, mesh))
  {
    std::cerr << "Error: cannot read " << filename << std::endl;
    return EXIT_FAILURE;
  }
  Scalar_map scalar_map = mesh.add_property_map<Mesh::Vertex_index, double>("v:height").first;
  for(Mesh::Vertex_index v : vertices(mesh))
    scalar_map[v] = mesh.point(v).x();

  try
  {
    Graph graph;
    CGAL::compute_reeb_graph(mesh, scalar_map, graph);
    const CGAL::Reeb_graph::Augmentation augmentation(mesh, scalar_map, graph);

    // The skeleton of the surface: through the centroids of 20 contours of each arc, smoothed a little.
    const auto skeleton =
      CGAL::Reeb_graph::embed(augmentation, CGAL::parameters::number_of_contours(20).number_of_smoothing_steps(2));
    for(Graph::vertex_descriptor node : CGAL::make_range(vertices(graph)))
      std::cout << graph[node].kind << " at " << skeleton.node_points[node] << std::endl;

    // For ParaView: the skeleton with numbers of its arcs, and the mesh with its field and the arcs of its vertices.
    const auto vertex_places = augmentation.locate_vertices();
    const std::vector<CGAL::Reeb_graph::Attribute> arc_attributes = {
      {"persistence", CGAL::Reeb_graph::arc_persistences(graph)},
      {"length", CGAL::Reeb_graph::arc_lengths(mesh, scalar_map, graph)},
      {"area", CGAL::Reeb_graph::arc_areas(mesh, graph, vertex_places)}};
    CGAL::Reeb_graph::write_vtp("skeleton.vtp", graph, skeleton, get(boost::vertex_index, mesh),
                                CGAL::parameters::arc_attributes(arc_attributes));
    std::vector<double> values;
    std::vector<std::int64_t> places;
    for(Mesh::Vertex_index v : vertices(mesh))
    {
      values.push_back(scalar_map[v]);
      places.push_back(static_cast<std::int64_t>(vertex_places.index(v)));
    }
    CGAL::Reeb_graph::write_mesh_vtp("mesh.vtp", mesh,
                                     CGAL::parameters::vertex_attributes({{"height", values}, {"place", places}}));

    // The graph on the surface, ascending.
    const auto lines = CGAL::Reeb_graph::embed(
      augmentation, CGAL::parameters::embedding_manner(CGAL::Reeb_graph::Embedding_manner::ON_SURFACE));
    CGAL::Reeb_graph::write_polylines("lines.polylines.txt", lines.arc_polylines);
  }
  catch(const CGAL::Reeb_graph::Error& error)
  {
    std::cerr << "Error: " << error.what() << std::endl;
    return EXIT_FAILURE;
  }
  return EXIT_SUCCESS;
}
