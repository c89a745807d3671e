# Fails if a named parameter of the package has the name of one of CGAL's: then a function of CGAL would be given another
# tag. LIST is the header with our names, CGAL_LIST that with those of the CGAL that is installed, and NAMES a file with
# those that later versions, up to 6.1, have besides.
cmake_minimum_required(VERSION 3.21)

file(STRINGS ${LIST} lines REGEX "^CGAL_REEB_GRAPH_NAMED_PARAMETER")
string(REGEX REPLACE "CGAL_REEB_GRAPH_NAMED_PARAMETER[A-Z_]*\\(([A-Za-z_0-9]+),[^;]*" "\\1" own_names "${lines}")
file(STRINGS ${CGAL_LIST} lines REGEX "^CGAL_add_")
string(REGEX REPLACE "CGAL_add_[a-z_]*\\([^;]*,[ ]*([A-Za-z_0-9]+)[ ]*\\)[^;]*" "\\1" cgal_names "${lines}")
file(STRINGS ${NAMES} later_names)
foreach(list own_names cgal_names later_names)
  list(LENGTH ${list} size)
  if(size LESS 30)
    message(SEND_ERROR "Too few names have been found for ${list}: ${${list}}")
  endif()
endforeach()
if(NOT "vertex_point_map" IN_LIST cgal_names OR NOT "ties" IN_LIST own_names)
  message(SEND_ERROR "The lists of named parameters are not read as they are written")
endif()
foreach(name IN LISTS own_names)
  if(name IN_LIST cgal_names OR name IN_LIST later_names)
    message(SEND_ERROR "The named parameter ${name} has the name of one of CGAL's")
  endif()
endforeach()
