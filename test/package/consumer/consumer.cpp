#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/generators.h>
#include <CGAL/compute_reeb_graph.h>
#ifdef EXPECT_Eigen3
#include <CGAL/Reeb_graph/fields/harmonic_field.h>
#endif

#include <cstdlib>

typedef CGAL::Simple_cartesian<double>::Point_3 Point;
typedef CGAL::Surface_mesh<Point> Mesh;
typedef Mesh::Property_map<Mesh::Vertex_index, double> Scalar_map;

int main()
{
  Mesh mesh;
  CGAL::make_tetrahedron(Point(0, 0, 0), Point(1, 0, 1), Point(0, 1, 2), Point(0, 0, 3), mesh);
  Scalar_map height = mesh.add_property_map<Mesh::Vertex_index, double>("v:height").first;
  for(Mesh::Vertex_index v : mesh.vertices())
    height[v] = mesh.point(v).z();

  CGAL::Reeb_graph_traits<Mesh, Scalar_map>::Graph graph;
#ifdef EXPECT_TBB
  CGAL::compute_reeb_graph<CGAL::Parallel_tag>(mesh, height, graph);
#else
  CGAL::compute_reeb_graph(mesh, height, graph);
#endif
#ifdef EXPECT_Eigen3
  CGAL::Reeb_graph::compute_harmonic_field_between_far_apart_vertices(mesh, height);
  CGAL::compute_reeb_graph(mesh, height, graph);
#endif
  return num_vertices(graph) == 2 && num_edges(graph) == 1 ? EXIT_SUCCESS : EXIT_FAILURE;
}
