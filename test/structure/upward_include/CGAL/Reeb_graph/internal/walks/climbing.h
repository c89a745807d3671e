#include <CGAL/Reeb_graph/internal/slabs/Slab.h>
