#include <CGAL/Reeb_graph/internal/complex/falling.h>
#include <CGAL/Reeb_graph/internal/engine/Slab.h>

// What is found.
