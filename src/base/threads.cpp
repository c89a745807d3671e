// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#include "base/threads.h"

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/global_control.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>
#else
#include <stdexcept>
#endif

#include <exception>
#include <vector>

namespace reeb_graph_program {
void run_with_threads(std::size_t number_of_threads, const std::function<void()>& work)
{
  if(number_of_threads == 0)
    return work();
#ifdef CGAL_LINKED_WITH_TBB
  // the arena has its threads even if there are fewer cores, the global control lets it have them
  const tbb::global_control control(tbb::global_control::max_allowed_parallelism, number_of_threads);
  tbb::task_arena(static_cast<int>(number_of_threads)).execute(work);
#else
  if(number_of_threads > 1)
    throw std::runtime_error("the program has been built without TBB: --threads can only be 1");
  work();
#endif
}

std::size_t number_of_threads()
{
#ifdef CGAL_LINKED_WITH_TBB
  return static_cast<std::size_t>(tbb::this_task_arena::max_concurrency());
#else
  return 1;
#endif
}

void run_tasks(std::size_t number_of_tasks, const std::function<void(std::size_t)>& task)
{
#ifdef CGAL_LINKED_WITH_TBB
  std::vector<std::exception_ptr> errors(number_of_tasks);
  tbb::parallel_for(std::size_t(0), number_of_tasks, [&](std::size_t i) {
    try
    {
      task(i);
    }
    catch(...)
    {
      errors[i] = std::current_exception();
    }
  });
  for(const std::exception_ptr& error : errors)
    if(error)
      std::rethrow_exception(error);
#else
  for(std::size_t i = 0; i < number_of_tasks; ++i)
    task(i);
#endif
}

} // namespace reeb_graph_program
