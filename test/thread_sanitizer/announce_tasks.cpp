// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

// For the thread sanitizer only. Debian's TBB is not compiled with it, so the sanitizer does not see that a task begins
// after it has been spawned, that a wait ends after the tasks that it waits for, and that memory is handed on: it
// reports a race for nearly each parallel loop. TBB tells profilers of waits by a function that its headers call if
// TBB_USE_PROFILING_TOOLS is 2. This function, and those that spawn tasks and get memory for them, are defined here
// again, in front of those of the library: they tell the sanitizer, and call the library. So nothing has to be
// suppressed, which would hide races of our own as well. They are those of the TBB of Debian 12, 2021.8.
//
// At the end of the program, the threads of TBB free what they share with the main thread, which the sanitizer does not
// see to be in order either. So the program ends before they are told to.

#include <oneapi/tbb/detail/_small_object_pool.h>
#include <oneapi/tbb/detail/_task.h>
#include <tbb/profiling.h>

#include <dlfcn.h>
#include <sanitizer/tsan_interface.h>

#include <stdlib.h>
#include <unistd.h>

#include <cstddef>
#include <cstdint>
#include <cstdio>

#if TBB_USE_PROFILING_TOOLS != 2
#error "TBB_USE_PROFILING_TOOLS has to be 2 for the whole program"
#endif

namespace {
// Handlers run in reverse order: after those of the tests, and before those of libraries that have been loaded earlier.
const int is_handler_set = on_exit(
  [](int status, void*) {
    std::fflush(nullptr);
    _exit(status);
  },
  nullptr);
} // namespace

namespace tbb::detail {
namespace {
// Stands for a task until that begins.
class Announced_task : public d1::task
{
public:
  explicit Announced_task(d1::task& task) : task_(task) { __tsan_release(this); }

  // A task that throws is cancelled afterwards.
  d1::task* execute(d1::execution_data& data) override
  {
    __tsan_acquire(this);
    d1::task* const next = task_.execute(data);
    delete this;
    return next;
  }
  d1::task* cancel(d1::execution_data& data) override
  {
    __tsan_acquire(this);
    d1::task* const next = task_.cancel(data);
    delete this;
    return next;
  }

private:
  d1::task& task_;
};

// The function of the library that is hidden by the one of the same name here.
template <class Function>
Function* function_of_library(const char* mangled_name)
{
  return reinterpret_cast<Function*>(dlsym(RTLD_NEXT, mangled_name));
}
} // namespace

namespace r1 {
void call_itt_notify(int type, void* address)
{
  if(type == d1::releasing || type == d1::destroy)
    __tsan_release(address);
  else if(type == d1::acquired)
  {
    __tsan_acquire(address);
    // what is waited for is a count, which is lowered after telling so: it is the second word of d1::wait_context
    __tsan_acquire(static_cast<std::uint64_t*>(address) + 1);
  }
}

void spawn(d1::task& task, d1::task_group_context& context)
{
  static const auto spawn_of_library = function_of_library<void(d1::task&, d1::task_group_context&)>(
    "_ZN3tbb6detail2r15spawnERNS0_2d14taskERNS2_18task_group_contextE");
  spawn_of_library(*new Announced_task(task), context);
}

void spawn(d1::task& task, d1::task_group_context& context, d1::slot_id slot)
{
  static const auto spawn_of_library = function_of_library<void(d1::task&, d1::task_group_context&, d1::slot_id)>(
    "_ZN3tbb6detail2r15spawnERNS0_2d14taskERNS2_18task_group_contextEt");
  spawn_of_library(*new Announced_task(task), context, slot);
}

void* allocate(d1::small_object_pool*& pool, std::size_t size, const d1::execution_data& data)
{
  static const auto allocate_of_library =
    function_of_library<void*(d1::small_object_pool*&, std::size_t, const d1::execution_data&)>(
      "_ZN3tbb6detail2r18allocateERPNS0_2d117small_object_poolEmRKNS2_14execution_dataE");
  void* memory = allocate_of_library(pool, size, data);
  __tsan_acquire(memory);
  return memory;
}

void* allocate(d1::small_object_pool*& pool, std::size_t size)
{
  static const auto allocate_of_library = function_of_library<void*(d1::small_object_pool*&, std::size_t)>(
    "_ZN3tbb6detail2r18allocateERPNS0_2d117small_object_poolEm");
  void* memory = allocate_of_library(pool, size);
  __tsan_acquire(memory);
  return memory;
}
} // namespace r1
} // namespace tbb::detail
