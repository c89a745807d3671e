#include <CGAL/Reeb_graph/internal/complex/falling.h>
#include <CGAL/Reeb_graph/internal/engine/slabs.h>

// What is found.
