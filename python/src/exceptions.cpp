// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#include "functions.h"

#include "run.h"

#include "output/output_file.h"

#include <CGAL/Reeb_graph/curves/exceptions.h>
#include <CGAL/Reeb_graph/exceptions.h>
#include <CGAL/Reeb_graph/fields/exceptions.h>

#include <exception>
#include <stdexcept>
#include <string>
#include <system_error>

namespace reeb_graph_python {
namespace {
namespace errors = CGAL::Reeb_graph;

// Sets the error of Python: MeshError, with the number of an item as an attribute.
void set_mesh_error(const char* message, const std::string& item, std::size_t number)
{
  const py::object type = py::module_::import("reeb_graph._errors").attr("MeshError");
  PyErr_SetObject(type.ptr(), type(message, item, number).ptr());
}

void set_stopped(const char* message)
{
  const py::object type = py::module_::import("reeb_graph._errors").attr("StoppedError");
  PyErr_SetObject(type.ptr(), type(message).ptr());
}

// The more special ones first.
void translate(std::exception_ptr error)
{
  try
  {
    if(error)
      std::rethrow_exception(error);
  }
  catch(const Stopped_error& e)
  {
    set_stopped(e.what());
  }
  catch(const errors::Cancelled_error& e)
  {
    set_stopped(e.what());
  }
  catch(const Item_error& e)
  {
    set_mesh_error(e.what(), e.item(), e.number());
  }
  catch(const errors::Vertex_error& e)
  {
    set_mesh_error(e.what(), "vertex", e.vertex());
  }
  catch(const errors::Face_error& e)
  {
    set_mesh_error(e.what(), "triangle", e.face());
  }
  catch(const errors::Degenerate_edge_error& e)
  {
    set_mesh_error(e.what(), "edge", e.edge());
  }
  catch(const std::system_error& e)
  {
    PyErr_SetString(PyExc_OSError, e.what());
  }
  catch(const reeb_graph_program::Output_error& e)
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
