# Configures, builds, and runs the project in consumer/, which finds the package in the way that USAGE says.
cmake_minimum_required(VERSION 3.21)

file(REMOVE_RECURSE ${FOLDER})
# not optimized: it is enough that the program is built
set(options -D CMAKE_BUILD_TYPE=Release "-D CMAKE_CXX_FLAGS_RELEASE=-O0 -DNDEBUG" -D CGAL_DIR=${CGAL_DIR}
            -D CMAKE_CXX_COMPILER=${COMPILER} -D CMAKE_CXX_COMPILER_LAUNCHER=${LAUNCHER})
if(USAGE STREQUAL "installed")
  execute_process(COMMAND ${CMAKE_COMMAND} --install ${BINARY_FOLDER} --prefix ${FOLDER}/prefix
                          --component Reeb_graph_development
                  COMMAND_ERROR_IS_FATAL ANY)
  list(APPEND options -D CMAKE_PREFIX_PATH=${FOLDER}/prefix)
else()
  list(APPEND options -D REEB_GRAPH_SOURCE_FOLDER=${SOURCE_FOLDER})
endif()
if(USAGE STREQUAL "installed")
  # Whoever asks for a component that is missing is told which one, and why. Headers are installed without the library if
  # nothing has been built.
  file(GLOB_RECURSE libraries ${FOLDER}/prefix/*.a)
  foreach(library IN LISTS libraries)
    file(RENAME ${library} ${library}.hidden)
  endforeach()
  execute_process(COMMAND ${CMAKE_COMMAND} -S ${CMAKE_CURRENT_LIST_DIR}/consumer -B ${FOLDER}/missing ${options}
                          "-D COMPONENTS=TBB;Eigen3;Qt5;Compiled" -D CMAKE_DISABLE_FIND_PACKAGE_TBB=ON
                          -D CMAKE_DISABLE_FIND_PACKAGE_Eigen3=ON
                  OUTPUT_QUIET ERROR_VARIABLE errors RESULT_VARIABLE result)
  string(REGEX REPLACE "[ \n]+" " " errors "${errors}")
  foreach(message "The component TBB is missing: oneTBB has not been found"
                  "The component Eigen3 is missing: Eigen 3.1 or later has not been found"
                  "The component Qt5 is missing: there is no such component"
                  "The component Compiled is missing: it was not built when the package was installed")
    string(FIND "${errors}" "${message}" place)
    if(result EQUAL 0 OR place EQUAL -1)
      message(FATAL_ERROR "Nothing says \"${message}\", but:\n${errors}")
    endif()
  endforeach()
  foreach(library IN LISTS libraries)
    file(RENAME ${library}.hidden ${library})
  endforeach()
endif()
execute_process(COMMAND ${CMAKE_COMMAND} -S ${CMAKE_CURRENT_LIST_DIR}/consumer -B ${FOLDER}/build ${options}
                        "-D COMPONENTS=${COMPONENTS}"
                COMMAND_ERROR_IS_FATAL ANY)
execute_process(COMMAND ${CMAKE_COMMAND} --build ${FOLDER}/build COMMAND_ERROR_IS_FATAL ANY)
execute_process(COMMAND ${FOLDER}/build/consumer ${FOLDER}/graphs COMMAND_ERROR_IS_FATAL ANY)
