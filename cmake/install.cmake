# Installs the headers, the compiled library, and the files that find_package(CGAL_Reeb_graph) reads.
include(CMakePackageConfigHelpers)

set(package_dir ${CMAKE_INSTALL_DATADIR}/cmake/CGAL_Reeb_graph)
set(to_develop COMPONENT Reeb_graph_development) # The program is no part of it.

install(DIRECTORY ${PROJECT_SOURCE_DIR}/include/ DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} ${to_develop})
install(FILES ${PROJECT_SOURCE_DIR}/LICENSE DESTINATION ${CMAKE_INSTALL_DOCDIR} ${to_develop})

install(TARGETS CGAL_Reeb_graph EXPORT CGAL_Reeb_graph_targets)
install(EXPORT CGAL_Reeb_graph_targets NAMESPACE CGAL:: DESTINATION ${package_dir} ${to_develop})
if(CGAL_REEB_GRAPH_BUILD_COMPILED)
  # Headers alone can be installed without building anything: then the component is missing.
  install(TARGETS CGAL_Reeb_graph_compiled EXPORT CGAL_Reeb_graph_compiled_targets
          ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR} ${to_develop} OPTIONAL)
  install(EXPORT CGAL_Reeb_graph_compiled_targets NAMESPACE CGAL:: DESTINATION ${package_dir} ${to_develop})
endif()
configure_package_config_file(${CMAKE_CURRENT_LIST_DIR}/CGAL_Reeb_graphConfig.cmake.in
                              ${PROJECT_BINARY_DIR}/CGAL_Reeb_graphConfig.cmake INSTALL_DESTINATION ${package_dir}
                              PATH_VARS CMAKE_INSTALL_LIBDIR)
write_basic_package_version_file(${PROJECT_BINARY_DIR}/CGAL_Reeb_graphConfigVersion.cmake
                                 COMPATIBILITY SameMinorVersion ARCH_INDEPENDENT)
install(FILES ${PROJECT_BINARY_DIR}/CGAL_Reeb_graphConfig.cmake
              ${PROJECT_BINARY_DIR}/CGAL_Reeb_graphConfigVersion.cmake DESTINATION ${package_dir} ${to_develop})

# For who builds without CMake: the headers, and with the compiled library.
set(macros -DCGAL_REEB_GRAPH_COMPILED)
set(required CGAL_Reeb_graph)
if(TARGET CGAL::TBB_support)
  string(APPEND macros " -DCGAL_LINKED_WITH_TBB")
  string(APPEND required " tbb")
endif()
if(TARGET CGAL::Eigen3_support)
  string(APPEND macros " -DCGAL_REEB_GRAPH_COMPILED_SOLVERS -DCGAL_EIGEN3_ENABLED")
  string(APPEND required " eigen3")
endif()
file(RELATIVE_PATH to_prefix /${CMAKE_INSTALL_LIBDIR}/pkgconfig /) # so that what is installed can be moved
foreach(name CGAL_Reeb_graph CGAL_Reeb_graph_compiled)
  if(name STREQUAL "CGAL_Reeb_graph" OR CGAL_REEB_GRAPH_BUILD_COMPILED)
    configure_file(${CMAKE_CURRENT_LIST_DIR}/${name}.pc.in ${PROJECT_BINARY_DIR}/${name}.pc @ONLY)
    install(FILES ${PROJECT_BINARY_DIR}/${name}.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig ${to_develop})
  endif()
endforeach()
