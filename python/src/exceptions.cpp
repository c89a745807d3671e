// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#include "arrays.h"
#include "run.h"

#include "output/output_file.h"

#include <CGAL/Reeb_graph/curves/exceptions.h>
#include <CGAL/Reeb_graph/exceptions.h>
#include <CGAL/Reeb_graph/fields/exceptions.h>

#include <exception>
#include <system_error>

namespace reeb_graph_python {
namespace {
// Sets an error of Python of the package's own: MeshError has the number of an item as an attribute.
template <class... Arguments>
void set_error(const char* name, const Arguments&... arguments)
{
  const py::object type = py::module_::import("reeb_graph._errors").attr(name);
  PyErr_SetObject(type.ptr(), type(arguments...).ptr());
}

// The more special ones first.
void translate(std::exception_ptr error)
{
  namespace errors = CGAL::Reeb_graph;
  try
  {
    if(error)
      std::rethrow_exception(error);
  }
  catch(const Stopped_error& e)
  {
    set_error("StoppedError", e.what());
  }
  catch(const errors::Cancelled_error& e)
  {
    set_error("StoppedError", e.what());
  }
  catch(const Item_error& e)
  {
    set_error("MeshError", e.what(), e.item, e.number);
  }
  catch(const errors::Vertex_error& e)
  {
    set_error("MeshError", e.what(), "vertex", e.vertex());
  }
  catch(const errors::Face_error& e)
  {
    set_error("MeshError", e.what(), "triangle", e.face());
  }
  catch(const errors::Degenerate_edge_error& e)
  {
    set_error("MeshError", e.what(), "edge", e.edge());
  }
  catch(const std::system_error& e)
  {
    PyErr_SetString(PyExc_OSError, e.what());
  }
  catch(const Output_error& e)
  {
    PyErr_SetString(PyExc_OSError, e.what());
  }
  catch(const std::runtime_error& e) // those of the library and of the program
  {
    PyErr_SetString(PyExc_ValueError, e.what());
  }
}

} // namespace

void translate_exceptions() { py::register_exception_translator(&translate); }

} // namespace reeb_graph_python
