# Installs the package where nothing has been built, and imports its Python package from there.
cmake_minimum_required(VERSION 3.21)

file(REMOVE_RECURSE ${FOLDER})
execute_process(COMMAND ${CMAKE_COMMAND} -S ${SOURCE_FOLDER} -B ${FOLDER}/build -D CGAL_DIR=${CGAL_DIR}
                        -D CMAKE_CXX_COMPILER=${COMPILER} -D CGAL_REEB_GRAPH_BUILD_PYTHON=${IS_PYTHON_BUILT}
                        -D Python_EXECUTABLE=${PYTHON} -D CGAL_REEB_GRAPH_BUILD_EXAMPLES=OFF -D CGAL_REEB_GRAPH_BUILD_TESTS=OFF
                OUTPUT_QUIET COMMAND_ERROR_IS_FATAL ANY)
execute_process(COMMAND ${CMAKE_COMMAND} --install ${FOLDER}/build --prefix ${FOLDER}/prefix
                OUTPUT_VARIABLE output COMMAND_ERROR_IS_FATAL ANY)
file(GLOB_RECURSE installed RELATIVE ${FOLDER}/prefix ${FOLDER}/prefix/*)
foreach(file include/CGAL/Reeb_graph.h share/cmake/CGAL_Reeb_graph/CGAL_Reeb_graphConfig.cmake)
  if(NOT file IN_LIST installed)
    message(FATAL_ERROR "${file} is not installed")
  endif()
endforeach()
if(NOT output MATCHES "The program has not been built: it is not installed" OR "bin/reeb_graph" IN_LIST installed)
  message(FATAL_ERROR "Nothing says that the program is not there:\n${output}")
endif()
if(IS_PYTHON_BUILT)
  execute_process(COMMAND ${CMAKE_COMMAND} -E env PYTHONPATH=${FOLDER}/build/python ${PYTHON} -B -c "import reeb_graph"
                  ERROR_VARIABLE errors)
  if(NOT errors MATCHES "cmake --build build --target reeb_graph_python")
    message(FATAL_ERROR "Python does not say what is to be built, but:\n${errors}")
  endif()
endif()
