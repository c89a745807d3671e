#include <CGAL/Simple_cartesian.h>
#include <CGAL/boost/graph/iterator.h>

#include <CGAL/IO/polygon_soup_io.h>
#include <CGAL/Reeb_graph/Complex_augmentation.h>
#include <CGAL/compute_reeb_graph_of_soup.h>

#include <cstddef>
#include <cstdlib>
#include <iostream>
#include <iterator>
#include <string>
#include <vector>

typedef CGAL::Simple_cartesian<double>::Point_3 Point;
typedef CGAL::Reeb_graph_soup_traits<double>::Graph Graph;

int main(int argc, char* argv[])
{
  // two soap bubbles and the wall between them: not a manifold, as three faces meet at the edges of a circle
  const std::string filename = (argc > 1) ? argv[1] : "data/two_bubbles.off";

  std::vector<Point> points;
  std::vector<std::vector<std::size_t>> triangles;
  if(!CGAL::IO::read_polygon_soup(filename, points, triangles))
  {
    std::cerr << "Error: cannot read " << filename << std::endl;
    return EXIT_FAILURE;
  }

  std::vector<double> heights;
  heights.reserve(points.size());
  for(const Point& point : points)
    heights.push_back(point.z());

  try
  {
    Graph graph;
    CGAL::compute_reeb_graph_of_soup(points, triangles, heights, graph);

    const CGAL::Reeb_graph::Soup_augmentation augmentation(points, triangles, heights, graph);
    for(auto arc : CGAL::make_range(edges(graph)))
    {
      const auto contour = augmentation.contour(arc, 0.5);
      std::vector<Point> contour_points;
      augmentation.points_of_contour(contour, std::back_inserter(contour_points), points);
      std::cout << "arc from vertex " << graph[source(arc, graph)].vertex << " to vertex "
                << graph[target(arc, graph)].vertex << ": at " << contour.value << " a contour of "
                << contour.polylines.size() << " polylines and " << contour.branch_points.size() << " branch points";
      for(std::size_t i : contour.branch_points)
        std::cout << ", (" << contour_points[i] << ")";
      std::cout << std::endl;
    }
  }
  catch(const CGAL::Reeb_graph::Error& error)
  {
    std::cerr << "Error: " << error.what() << std::endl;
    return EXIT_FAILURE;
  }
  return EXIT_SUCCESS;
}
