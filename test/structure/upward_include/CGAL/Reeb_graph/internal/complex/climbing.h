#include <CGAL/Reeb_graph/internal/engine/Slab.h>
