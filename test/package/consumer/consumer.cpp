#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/generators.h>
#include <CGAL/compute_reeb_graph.h>
#ifdef EXPECT_Eigen3
#include <CGAL/Reeb_graph/fields/harmonic_field.h>
#endif

#include <cstdlib>
#include <fstream>
#include <functional>

typedef CGAL::Simple_cartesian<double>::Point_3 Point;
typedef CGAL::Surface_mesh<Point> Mesh;
#ifdef EXPECT_TBB
typedef CGAL::Parallel_tag Tag;
#else
typedef CGAL::Sequential_tag Tag;
#endif

template <class Scalar>
using Scalar_map = Mesh::Property_map<Mesh::Vertex_index, Scalar>;

struct Descending_traits : CGAL::Reeb_graph_traits<Mesh, Scalar_map<double>>
{
  typedef std::greater<double> Less_scalar;
  Less_scalar less_scalar_object() const { return Less_scalar(); }
};

// Rough, and the same for any type of numbers.
template <class Scalar>
Scalar_map<Scalar> add_field(Mesh& mesh, const char* name)
{
  Scalar_map<Scalar> field = mesh.add_property_map<Mesh::Vertex_index, Scalar>(name).first;
  for(Mesh::Vertex_index v : mesh.vertices())
    field[v] = static_cast<Scalar>(v.idx() * 7919u % 4099u);
  return field;
}

template <class Graph>
void print_graph(std::ostream& out, const Graph& graph)
{
  for(auto node : CGAL::make_range(vertices(graph)))
    out << graph[node].vertex << ' ' << graph[node].value << ' ' << static_cast<int>(graph[node].kind) << '\n';
  for(auto arc : CGAL::make_range(edges(graph)))
  {
    out << source(arc, graph) << ' ' << target(arc, graph);
    for(Mesh::Halfedge_index h : graph[arc].chain)
      out << ' ' << h;
    out << '\n';
  }
}

// Writes graphs into the file that is named: the same, however the package has been found.
int main(int, char** argv)
{
  Mesh mesh;
  const int columns = 110; // enough for threads
  CGAL::make_grid(
    columns, columns, mesh, [](double x, double y) { return Point(x, y, 0); }, true);
  const auto doubles = add_field<double>(mesh, "v:doubles");
  const auto floats = add_field<float>(mesh, "v:floats");
  std::ofstream out(argv[1]);

  CGAL::Reeb_graph_traits<Mesh, Scalar_map<double>>::Graph graph;
  CGAL::compute_reeb_graph<Tag>(mesh, doubles, graph);
  print_graph(out, graph);
  // What no compiled library has: other scalars, and another order.
  CGAL::Reeb_graph_traits<Mesh, Scalar_map<float>>::Graph graph_of_floats;
  CGAL::compute_reeb_graph(mesh, floats, graph_of_floats);
  print_graph(out, graph_of_floats);
  CGAL::compute_reeb_graph(mesh, doubles, graph, CGAL::parameters::geom_traits(Descending_traits()));
  print_graph(out, graph);
#ifdef EXPECT_Eigen3
  Mesh tetrahedron;
  CGAL::make_tetrahedron(Point(0, 0, 0), Point(1, 0, 1), Point(0, 1, 2), Point(0, 0, 3), tetrahedron);
  const auto field = add_field<double>(tetrahedron, "v:field");
  CGAL::Reeb_graph::compute_harmonic_field_between_far_apart_vertices(tetrahedron, field);
  CGAL::compute_reeb_graph(tetrahedron, field, graph);
  return num_vertices(graph) == 2 && num_edges(graph) == 1 ? EXIT_SUCCESS : EXIT_FAILURE;
#endif
}
