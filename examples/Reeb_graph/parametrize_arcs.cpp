#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>
#include <CGAL/centroid.h>

#include <CGAL/Reeb_graph/Augmentation.h>
#include <CGAL/Reeb_graph/fields/harmonic_field.h>
#include <CGAL/Reeb_graph/fields/poisson_field.h>
#include <CGAL/compute_reeb_graph.h>

#include <algorithm>
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
typedef Augmentation::Contour Contour;

Point center(const Augmentation& augmentation, const Contour& contour)
{
  std::vector<Point> points;
  augmentation.points_of_contour(contour, std::back_inserter(points));
  return CGAL::centroid(points.begin(), points.end(), CGAL::Dimension_tag<0>());
}

// The longest of the distances between the centers of successive contours, divided by the shortest one.
template <class ContourAt>
double irregularity(const Augmentation& augmentation, const ContourAt& contour_at)
{
  std::vector<double> steps;
  for(int i = 1; i < 9; ++i)
    steps.push_back(std::sqrt(CGAL::squared_distance(center(augmentation, contour_at(i / 10.)),
                                                     center(augmentation, contour_at((i + 1) / 10.)))));
  return *std::max_element(steps.begin(), steps.end()) / *std::min_element(steps.begin(), steps.end());
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
  Scalar_map unit_map = mesh.add_property_map<vertex_descriptor, double>("v:unit").first;
  try
  {
    CGAL::Reeb_graph::compute_harmonic_field_between_far_apart_vertices(mesh, scalar_map);
    CGAL::Reeb_graph::compute_unit_gradient_field(mesh, scalar_map, unit_map);
    Graph graph;
    CGAL::compute_reeb_graph(mesh, scalar_map, graph);

    const Augmentation augmentation(mesh, scalar_map, graph);
    std::cout << "longest / shortest of 8 equal steps along each arc" << std::endl;
    for(auto arc : CGAL::make_range(edges(graph)))
      std::cout << "arc " << source(arc, graph) << " -> " << target(arc, graph) << ": by the field "
                << irregularity(augmentation, [&](double t) { return augmentation.contour(arc, t); })
                << ", by its unit gradient field "
                << irregularity(augmentation, [&](double t) { return augmentation.contour(arc, t, unit_map); })
                << std::endl;
  }
  catch(const CGAL::Reeb_graph::Error& error)
  {
    std::cerr << "Error: " << error.what() << std::endl;
    return EXIT_FAILURE;
  }
  return EXIT_SUCCESS;
}
