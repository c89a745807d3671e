//! [includes]
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh/IO/PLY.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <CGAL/Reeb_graph.h>
#include <CGAL/Reeb_graph/curves/segmentation.h>
#include <CGAL/Reeb_graph/fields/field_constraints.h>
#include <CGAL/Reeb_graph/fields/geodesic_field.h>

#include <cstdint>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <iterator>
#include <string>
#include <utility>
#include <vector>
//! [includes]

//! [types]
typedef CGAL::Simple_cartesian<double> Kernel;
typedef CGAL::Surface_mesh<Kernel::Point_3> Mesh;
typedef Mesh::Vertex_index Vertex;
typedef Mesh::Property_map<Vertex, double> Scalar_map;
typedef CGAL::Reeb_graph_traits<Mesh, Scalar_map>::Graph Graph; // a boost::adjacency_list
//! [types]

void run(Mesh& mesh)
{
  //! [field]
  // The distance from a tip of the shape, one in each component.
  std::vector<std::pair<Vertex, Vertex>> far_apart;
  CGAL::Reeb_graph::find_far_apart_vertices(mesh, std::back_inserter(far_apart));
  std::vector<Vertex> tips;
  for(const auto& pair : far_apart)
    tips.push_back(pair.first);
  Scalar_map distance = mesh.add_property_map<Vertex, double>("v:distance").first;
  CGAL::Reeb_graph::compute_geodesic_field(mesh, distance, tips);
  //! [field]

  //! [graph]
  Graph graph;
  CGAL::compute_reeb_graph(mesh, distance, graph);
  for(const auto arc : CGAL::make_range(edges(graph)))
    std::cout << graph[source(arc, graph)].value << " to " << graph[target(arc, graph)].value << '\n';
  std::cout << "nodes: " << num_vertices(graph) << ", loops: " << CGAL::Reeb_graph::number_of_loops(graph) << '\n';
  //! [graph]

  //! [simplify]
  std::vector<CGAL::Reeb_graph::Simplification_threshold> choices;
  CGAL::Reeb_graph::simplification_thresholds(graph, std::back_inserter(choices));
  double threshold = 0;
  for(const auto& choice : choices)
    if(choice.is_suggested)
      threshold = choice.threshold;
  Graph limbs;
  const auto simplification = CGAL::Reeb_graph::simplify(graph, threshold, limbs);
  std::cout << num_vertices(limbs) << " nodes are left\n";
  //! [simplify]

  //! [draw]
  CGAL::Reeb_graph::write_svg("limbs.svg", limbs, CGAL::parameters::field_name("distance"));
  //! [draw]

  //! [segment]
  const CGAL::Reeb_graph::Augmentation augmentation(mesh, distance, limbs,
                                                    CGAL::parameters::simplification(simplification));
  const auto places = augmentation.locate_vertices();
  for(std::size_t arc = 0; arc != num_edges(limbs); ++arc)
    std::cout << "arc " << arc << " has " << places.vertices_of_arc(arc).size() << " vertices\n";
  std::vector<std::int64_t> numbers; // of nodes, then of arcs
  for(const Vertex v : vertices(mesh))
    numbers.push_back(static_cast<std::int64_t>(places.index(v)));
  CGAL::Reeb_graph::write_mesh_vtp("segments.vtp", mesh, CGAL::parameters::vertex_attributes({{"place", numbers}}));
  //! [segment]

  //! [cut]
  const auto piece = mesh.add_property_map<Mesh::Face_index, int>("f:piece").first;
  const std::size_t number_of_pieces =
    CGAL::Reeb_graph::segment_by_branches(mesh, distance, piece, CGAL::parameters::persistence_threshold(threshold));
  std::cout << number_of_pieces << " pieces\n";
  std::ofstream output("pieces.ply");
  CGAL::IO::write_PLY(output, mesh);
  //! [cut]
}

int main(int argc, char* argv[])
{
  //! [read]
  const std::string filename = (argc > 1) ? argv[1] : "demo/surface.off";
  Mesh mesh;
  if(!CGAL::IO::read_polygon_mesh(filename, mesh))
  {
    std::cerr << "Error: cannot read " << filename << std::endl;
    return EXIT_FAILURE;
  }
  //! [read]
  try
  {
    run(mesh);
  }
  catch(const CGAL::Reeb_graph::Error& error)
  {
    std::cerr << "Error: " << error.what() << std::endl;
    return EXIT_FAILURE;
  }
  return EXIT_SUCCESS;
}
