#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <CGAL/compute_reeb_graph.h>

#include <chrono>
#include <cstdlib>
#include <functional>
#include <iostream>
#include <string>

typedef CGAL::Simple_cartesian<double> Kernel;
typedef CGAL::Surface_mesh<Kernel::Point_3> Mesh;
typedef boost::graph_traits<Mesh>::vertex_descriptor vertex_descriptor;
typedef Mesh::Property_map<vertex_descriptor, double> Scalar_map;
typedef CGAL::Reeb_graph_traits<Mesh, Scalar_map>::Graph Graph;

// A model of ReebGraphVisitor. Functions that it does not redefine do nothing.
struct Visitor : CGAL::Reeb_graph::Default_visitor
{
  typedef std::chrono::steady_clock Clock;

  void begin_stage(CGAL::Reeb_graph::Stage) { begin = Clock::now(); }
  void end_stage(CGAL::Reeb_graph::Stage stage)
  {
    const std::chrono::duration<double, std::milli> time = Clock::now() - begin;
    std::cout << "stage " << static_cast<int>(stage) << ": " << time.count() << " ms" << std::endl;
  }
  void critical_vertices(const CGAL::Reeb_graph::Critical_vertex_counts& found) { counts = found; }

  Clock::time_point begin;
  CGAL::Reeb_graph::Critical_vertex_counts counts;
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

  // The calling thread alone calls this. Returning false stops the computation.
  double progress = 0;
  const std::function<bool(double)> callback = [&](double fraction) {
    progress = fraction;
    return true;
  };
  Visitor visitor;
  Graph graph;
  try
  {
    // With CGAL::Parallel_tag instead, it does not compile without TBB. One thread works on small meshes in any case.
    CGAL::compute_reeb_graph<CGAL::Parallel_if_available_tag>(
      mesh, scalar_map, graph, CGAL::parameters::callback(callback).visitor(std::ref(visitor)));
  }
  catch(const CGAL::Reeb_graph::Cancelled_error&)
  {
    std::cerr << "Stopped after " << 100 * progress << " percent" << std::endl;
    return EXIT_FAILURE;
  }
  catch(const CGAL::Reeb_graph::Error& error)
  {
    std::cerr << "Error: " << error.what() << std::endl;
    return EXIT_FAILURE;
  }

  std::cout << visitor.counts.minima << " minima, " << visitor.counts.maxima << " maxima" << std::endl;
  for(const auto& [multiplicity, count] : visitor.counts.saddles)
    std::cout << count << " saddles of multiplicity " << multiplicity << std::endl;
  std::cout << num_vertices(graph) << " nodes and " << num_edges(graph) << " arcs" << std::endl;
  return EXIT_SUCCESS;
}
