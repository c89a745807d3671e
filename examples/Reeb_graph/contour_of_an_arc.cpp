#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <CGAL/Reeb_graph/Augmentation.h>
#include <CGAL/compute_reeb_graph.h>

#include <cmath>
#include <cstdlib>
#include <iostream>
#include <iterator>
#include <string>
#include <vector>

typedef CGAL::Simple_cartesian<double> Kernel;
typedef Kernel::Point_3 Point;
typedef CGAL::Surface_mesh<Point> Mesh;
typedef boost::graph_traits<Mesh>::vertex_descriptor vertex_descriptor;
typedef Mesh::Property_map<vertex_descriptor, double> Scalar_map;
typedef CGAL::Reeb_graph_traits<Mesh, Scalar_map>::Graph Graph;
typedef CGAL::Reeb_graph::Augmentation<Mesh, Scalar_map> Augmentation;

double length(const std::vector<Point>& points, bool is_closed)
{
  double sum = is_closed ? std::sqrt(CGAL::squared_distance(points.back(), points.front())) : 0;
  for(std::size_t i = 1; i < points.size(); ++i)
    sum += std::sqrt(CGAL::squared_distance(points[i - 1], points[i]));
  return sum;
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

  Scalar_map scalar_map = mesh.add_property_map<vertex_descriptor, double>("v:scalar").first;
  for(vertex_descriptor v : vertices(mesh))
    scalar_map[v] = mesh.point(v).x();

  try
  {
    Graph graph;
    CGAL::compute_reeb_graph(mesh, scalar_map, graph);

    const Augmentation augmentation(mesh, scalar_map, graph);
    for(auto arc : CGAL::make_range(edges(graph)))
    {
      std::cout << "arc " << source(arc, graph) << " -> " << target(arc, graph) << std::endl;
      for(double t : {0.25, 0.5, 0.75})
      {
        const Augmentation::Contour contour = augmentation.contour(arc, t);
        std::vector<Point> points;
        augmentation.points_of_contour(contour, std::back_inserter(points));
        std::cout << "  t = " << t << ", value " << contour.value << ": " << points.size() << " points, length "
                  << length(points, contour.is_closed()) << std::endl;
      }
    }
  }
  catch(const CGAL::Reeb_graph::Error& error)
  {
    std::cerr << "Error: " << error.what() << std::endl;
    return EXIT_FAILURE;
  }
  return EXIT_SUCCESS;
}
