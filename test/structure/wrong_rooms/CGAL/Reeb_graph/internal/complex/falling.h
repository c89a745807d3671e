#include <CGAL/Reeb_graph/internal/complex/climbing.h>
