// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_LICENSE_REEB_GRAPH_H
#define CGAL_LICENSE_REEB_GRAPH_H

#include <CGAL/config.h>

#ifdef CGAL_REEB_GRAPH_COMMERCIAL_LICENSE

#if CGAL_REEB_GRAPH_COMMERCIAL_LICENSE < CGAL_RELEASE_DATE
#if defined(CGAL_LICENSE_WARNING)
CGAL_pragma_warning("Your commercial license does not cover this release of the Reeb_graph package.")
#endif
#ifdef CGAL_LICENSE_ERROR
#error "Your commercial license does not cover this release of the Reeb_graph package."
#endif
#endif

#else // the package is used under the terms of the GPL

#if defined(CGAL_LICENSE_WARNING)
CGAL_pragma_warning("You use the Reeb_graph package under the terms of the GPLv3+.")
#endif
#ifdef CGAL_LICENSE_ERROR
#error "You use the Reeb_graph package under the terms of the GPLv3+, and CGAL_LICENSE_ERROR is defined."
#endif

#endif // CGAL_REEB_GRAPH_COMMERCIAL_LICENSE

#endif // CGAL_LICENSE_REEB_GRAPH_H
