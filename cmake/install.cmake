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
