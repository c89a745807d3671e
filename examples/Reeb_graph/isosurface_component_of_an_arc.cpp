#include <CGAL/Simple_cartesian.h>
#include <CGAL/boost/graph/iterator.h>

#include <CGAL/IO/OFF.h>
#include <CGAL/Reeb_graph/Complex_augmentation.h>
#include <CGAL/compute_reeb_graph_of_soup.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <iostream>
#include <iterator>
#include <string>
#include <vector>

typedef CGAL::Simple_cartesian<double>::Point_3 Point;
typedef CGAL::Reeb_graph_soup_traits<double>::Graph Graph;
typedef std::vector<std::array<std::size_t, 4>> Tetrahedra;

// Fills the unit cube with `size` cubes along each side, of six tetrahedra around a diagonal each.
void make_solid(std::size_t size, std::vector<Point>& points, Tetrahedra& tetrahedra)
{
  const std::array<std::size_t, 3> steps = {1, size + 1, (size + 1) * (size + 1)};
  for(std::size_t z = 0; z <= size; ++z)
    for(std::size_t y = 0; y <= size; ++y)
      for(std::size_t x = 0; x <= size; ++x)
      {
        const std::size_t corner = points.size();
        points.emplace_back(double(x) / size, double(y) / size, double(z) / size);
        if(x == size || y == size || z == size)
          continue;
        std::array<std::size_t, 3> axes = {0, 1, 2};
        do
        {
          const std::size_t second = corner + steps[axes[0]], third = second + steps[axes[1]];
          tetrahedra.push_back({corner, second, third, third + steps[axes[2]]});
        } while(std::next_permutation(axes.begin(), axes.end()));
      }
}

int main(int argc, char* argv[])
{
  const int size = (argc > 1) ? std::atoi(argv[1]) : 24;
  if(size <= 0)
  {
    std::cerr << "Error: how many cubes along a side?" << std::endl;
    return EXIT_FAILURE;
  }

  std::vector<Point> points;
  Tetrahedra tetrahedra;
  make_solid(static_cast<std::size_t>(size), points, tetrahedra);

  // the product of the distances to two points: isosurfaces of small values have two components, others one
  const Point a(0.31, 0.35, 0.42), b(0.72, 0.64, 0.55);
  std::vector<double> values;
  values.reserve(points.size());
  for(const Point& p : points)
    values.push_back(std::sqrt(CGAL::squared_distance(p, a) * CGAL::squared_distance(p, b)));

  try
  {
    Graph graph;
    CGAL::compute_reeb_graph_of_tetrahedra(points, tetrahedra, values, graph);

    const CGAL::Reeb_graph::Tetrahedra_augmentation augmentation(points, tetrahedra, values, graph);
    std::size_t number = 0;
    for(auto arc : CGAL::make_range(edges(graph)))
    {
      const auto patch = augmentation.contour(arc, 0.6);
      std::vector<Point> patch_points;
      augmentation.points_of_contour(patch, std::back_inserter(patch_points), points);

      const std::string filename = "isosurface_" + std::to_string(number++) + ".off";
      std::cout << filename << ": a component of the isosurface at " << patch.value << ", " << patch_points.size()
                << " points, " << patch.triangles.size() << " triangles" << std::endl;
      if(!CGAL::IO::write_OFF(filename, patch_points, patch.triangles))
      {
        std::cerr << "Error: cannot write " << filename << std::endl;
        return EXIT_FAILURE;
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
