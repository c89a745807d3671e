# The toolchain of scripts/web: compiles the program into WebAssembly by Debian's emscripten. What other libraries have for
# any machine is in the folder REEB_GRAPH_WEB_ROOT, which that script fills, so that nothing of this machine's is found.
set(CMAKE_TRY_COMPILE_PLATFORM_VARIABLES REEB_GRAPH_WEB_ROOT)
include(/usr/share/emscripten/cmake/Modules/Platform/Emscripten.cmake)
list(APPEND CMAKE_FIND_ROOT_PATH ${REEB_GRAPH_WEB_ROOT})
list(APPEND CMAKE_PREFIX_PATH ${REEB_GRAPH_WEB_ROOT})
foreach(kind PACKAGE INCLUDE LIBRARY)
  set(CMAKE_FIND_ROOT_PATH_MODE_${kind} BOTH)
endforeach()
file(GLOB CGAL_DIR ${REEB_GRAPH_WEB_ROOT}/lib/*/cmake/CGAL)
file(GLOB Boost_DIR ${REEB_GRAPH_WEB_ROOT}/lib/*/cmake/Boost-*)
set(CMAKE_DISABLE_FIND_PACKAGE_TBB ON)

# Exact numbers are those of Boost. WebAssembly rounds to the nearest number only: without the second, intervals would be
# too narrow, and predicates wrong.
set(CGAL_DISABLE_GMP ON)
add_compile_definitions(CGAL_DISABLE_GMP CGAL_ALWAYS_ROUND_TO_NEAREST CGAL_DISABLE_ROUNDING_MATH_CHECK)
add_compile_options(-fwasm-exceptions)
add_link_options(-fwasm-exceptions)
