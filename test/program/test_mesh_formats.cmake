# Meshes of the same vertices and faces give the same files, whatever their format; and what is mended on reading.
include(${CMAKE_CURRENT_LIST_DIR}/common.cmake)

file(WRITE ${FOLDER}/mesh.off
     "OFF\n5 4 0\n0 0 0\n1 0 0\n0 1 0.25\n0 0 1\n3 1 0.5\n3 0 1 2\n3 0 3 1\n3 0 2 3\n3 1 4 2\n")
file(WRITE ${FOLDER}/mesh.obj
     "v 0 0 0\nv 1 0 0\nv 0 1 0.25\nv 0 0 1\nv 3 1 0.5\nf 1 2 3\nf 1 4 2\nf 1 3 4\nf 2 5 3\n")
set(ply_data "end_header\n0 0 0\n1 0 0\n0 1 0.25\n0 0 1\n3 1 0.5\n3 0 1 2\n3 0 3 1\n3 0 2 3\n3 1 4 2\n")
file(WRITE ${FOLDER}/mesh.ply
     "ply\nformat ascii 1.0\nelement vertex 5\nproperty double x\nproperty double y\nproperty double z\n"
     "element face 4\nproperty list uchar int vertex_indices\n${ply_data}")
file(WRITE ${FOLDER}/mesh.stl "solid\n")
foreach(facet "0 0 0,1 0 0,0 1 0.25" "0 0 0,0 0 1,1 0 0" "0 0 0,0 1 0.25,0 0 1" "1 0 0,3 1 0.5,0 1 0.25")
  string(REPLACE "," "\nvertex " facet "${facet}")
  file(APPEND ${FOLDER}/mesh.stl "facet normal 0 0 0\nouter loop\nvertex ${facet}\nendloop\nendfacet\n")
endforeach()
file(APPEND ${FOLDER}/mesh.stl "endsolid\n")

foreach(format off obj ply stl)
  expect_success(compute mesh.${format} --field z --graph ${format}.graphml)
  expect_success(compute mesh.${format} --field z --graph ${format}.dot)
  expect_same_file(${format}.graphml off.graphml)
  expect_same_file(${format}.dot off.dot)
endforeach()

# faces that are not oriented consistently
file(WRITE ${FOLDER}/disoriented.off
     "OFF\n5 4 0\n0 0 0\n1 0 0\n0 1 0.25\n0 0 1\n3 1 0.5\n3 0 1 2\n3 1 3 0\n3 0 3 2\n3 1 2 4\n")
expect_success(compute disoriented.off --field z --graph disoriented.graphml)
expect_same_file(disoriented.graphml off.graphml)

# isolated vertices keep their numbers, also if faces have to be oriented
set(isolated_header "OFF\n6 2 0\n9 9 9\n0 0 0\n1 0 1\n8 8 8\n0 1 2\n1 1 3\n")
file(WRITE ${FOLDER}/isolated.off "${isolated_header}3 1 2 4\n3 2 5 4\n")
file(WRITE ${FOLDER}/isolated_disoriented.off "${isolated_header}3 1 2 4\n3 2 4 5\n")
foreach(name isolated isolated_disoriented)
  expect_success(compute ${name}.off --field z --graph ${name}.graphml)
  file(READ ${FOLDER}/${name}.graphml content)
  string(REGEX MATCHALL "\"key3\">[0-9]+<" vertices "${content}")
  expect_equal("${vertices}" "\"key3\">1<;\"key3\">5<;\"key3\">3<;\"key3\">0<")
endforeach()
expect_same_file(isolated.graphml isolated_disoriented.graphml)
expect_json(2 isolated ARGUMENTS isolated.off --field z)
expect_json(3 components ARGUMENTS isolated.off --field z)

# faces of more than three vertices, one of them not convex
file(WRITE ${FOLDER}/polygons.off
     "OFF\n7 2 0\n0 0 0\n2 0 0\n2 2 0\n1 0.5 0\n0 2 0\n2 -1 0\n0 -1 0\n5 0 1 2 3 4\n4 0 6 5 1\n")
expect_json(5 faces ARGUMENTS polygons.off --field x --triangulate)
expect_json(7 vertices ARGUMENTS polygons.off --field x --triangulate)
expect_json(1 euler_characteristic ARGUMENTS polygons.off --field x --triangulate)
expect_success(compute mesh.off --field z --triangulate --graph triangulated.graphml)
expect_same_file(triangulated.graphml off.graphml)

# points extremely far from the origin, or close to it, are no end of the program
foreach(scale 1e232 1e-232 1e300 1e-300)
  file(WRITE ${FOLDER}/scale.off "OFF\n5 2 0\n0 0 0\n${scale} 0 ${scale}\n${scale} ${scale} 0\n0 ${scale} 0\n1 1 5\n4 0 1 2 3\n"
       "4 0 4 2 1\n")
  run(compute scale.off --field z --triangulate)
  expect_match("${exit_code}" "^[01]$")
  file(WRITE ${FOLDER}/scale.off "OFF\n4 1 0\n0 0 0\n${scale} 0 ${scale}\n${scale} ${scale} 0\n0 ${scale} 0\n4 0 1 2 3\n")
  expect_json(2 faces ARGUMENTS scale.off --field z --triangulate)
endforeach()
