#include <CGAL/Reeb_graph/fields/internal/solve.h>
