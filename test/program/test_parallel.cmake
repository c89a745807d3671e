# Threads and slabs: the same files for any number of them.
include(${CMAKE_CURRENT_LIST_DIR}/common.cmake)

# a mesh that is large enough for several threads, and its graph
expect_success(demo --out demo)
set(surface demo/surface.off --scalars demo/scalars.txt)
expect_success(compute ${surface} --graph graph.dot --vertex-arcs arcs.txt)
expect_success(contour ${surface} --level 0.1 --output level.polylines.txt)
foreach(options "--threads 1" "--threads 2" "--threads 4 --slabs 1" "--threads 2 --slabs 3" "--slabs 64"
                "--threads 4 --slabs 8 --method critical-sets" "--threads 1 --slabs 100000")
  separate_arguments(options)
  expect_success(compute ${surface} ${options} --graph graph.graphml --vertex-arcs other_arcs.txt)
  expect_same_file(demo/graph.graphml graph.graphml)
  expect_same_file(arcs.txt other_arcs.txt)
  expect_success(compute ${surface} ${options} --graph other_graph.dot)
  expect_same_file(graph.dot other_graph.dot)
  expect_success(contour ${surface} ${options} --level 0.1 --output other_level.polylines.txt)
  expect_same_file(level.polylines.txt other_level.polylines.txt)
endforeach()

# ascii PLY in blocks, where one line has two points as well, and what is wrong in the last one
file(READ ${FOLDER}/demo/surface.off off)
set(properties "property double x\nproperty double y\nproperty double z\n")
string(REGEX REPLACE "^OFF\n([0-9]+) ([0-9]+) 0\n+"
       "ply\nformat ascii 1.0\nelement vertex \\1\n${properties}element face \\2\nproperty list uchar int vertex_index\nend_header\n"
       ply "${off}")
string(REGEX REPLACE "(end_header\n[^\n]+)\n" "\\1 " with_long_line "${ply}")
file(WRITE ${FOLDER}/surface.ply "${ply}")
file(WRITE ${FOLDER}/with_long_line.ply "${with_long_line}")
file(WRITE ${FOLDER}/with_more.ply "${ply}more\n")
foreach(threads 1 4)
  foreach(mesh surface with_long_line)
    expect_success(compute ${mesh}.ply --scalars demo/scalars.txt --threads ${threads} --graph other_graph.dot)
    expect_same_file(graph.dot other_graph.dot)
  endforeach()
  expect_error("with_more.ply:63293: there is more in the file" compute with_more.ply --field z --threads
               ${threads})
endforeach()

# small meshes
file(WRITE ${FOLDER}/tetrahedron.off "${tetrahedron_off}")
expect_json(1 arcs ARGUMENTS tetrahedron.off --field z --threads 4 --slabs 5)

# the number of a vertex that is in the way is the same as well
file(STRINGS ${FOLDER}/demo/scalars.txt scalars)
list(LENGTH scalars size)
math(EXPR last "${size} - 1")
list(REMOVE_AT scalars ${last} 5000)
list(INSERT scalars 5000 nan)
list(APPEND scalars nan)
list(JOIN scalars "\n" content)
file(WRITE ${FOLDER}/with_nan.txt "${content}\n")
foreach(threads 1 4)
  expect_error("vertex 5000 is not a number" compute demo/surface.off --scalars with_nan.txt --threads ${threads}
               --graph other.graphml)
endforeach()

foreach(wrong 0 -1 2000 two 1.5)
  expect_error("--threads.*${wrong}" compute ${surface} --threads ${wrong})
endforeach()
foreach(wrong 0 -1 two 1.5)
  expect_error("--slabs.*${wrong}" compute ${surface} --slabs ${wrong})
endforeach()
