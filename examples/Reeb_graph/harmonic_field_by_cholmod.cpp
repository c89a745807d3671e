// Harmonic fields by CHOLMOD, a solver of SuiteSparse, in place of multigrid. Eigen has an interface to it.

#include <CGAL/Eigen_solver_traits.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <CGAL/Reeb_graph/fields/harmonic_field.h>

#include <Eigen/CholmodSupport>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <iostream>
#include <string>

typedef CGAL::Simple_cartesian<double> Kernel;
typedef CGAL::Surface_mesh<Kernel::Point_3> Mesh;
typedef boost::graph_traits<Mesh>::vertex_descriptor vertex_descriptor;
typedef Mesh::Property_map<vertex_descriptor, double> Scalar_map;

typedef CGAL::Eigen_sparse_matrix<double>::EigenType Eigen_matrix;
typedef CGAL::Eigen_solver_traits<Eigen::CholmodSupernodalLLT<Eigen_matrix>> Solver;

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
  Scalar_map default_map = mesh.add_property_map<vertex_descriptor, double>("v:default").first;
  try
  {
    namespace fields = CGAL::Reeb_graph;
    fields::compute_harmonic_field_between_far_apart_vertices(mesh, scalar_map,
                                                              CGAL::parameters::sparse_linear_solver(Solver()));

    // the default: multigrid on large meshes, and a factorization by Eigen itself on small ones
    const fields::Field_report report = fields::compute_harmonic_field_between_far_apart_vertices(mesh, default_map);
    std::cout << "steps of multigrid: " << report.number_of_iterations << std::endl;
  }
  catch(const CGAL::Reeb_graph::Error& error)
  {
    std::cerr << "Error: " << error.what() << std::endl;
    return EXIT_FAILURE;
  }

  double difference = 0;
  for(const vertex_descriptor v : mesh.vertices())
    difference = (std::max)(difference, std::abs(scalar_map[v] - default_map[v]));
  std::cout << "largest difference: " << difference << std::endl;
  return difference < 1e-9 ? EXIT_SUCCESS : EXIT_FAILURE;
}
