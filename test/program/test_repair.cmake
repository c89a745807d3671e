# Meshes as people have them: what is left out on reading, what the report says of it, and what repair makes of them.
include(${CMAKE_CURRENT_LIST_DIR}/common.cmake)

# Expects a value at keys of the report of repair.
function(expect_repair expected)
  cmake_parse_arguments(PARSE_ARGV 1 json "" "" "ARGUMENTS")
  expect_success(repair --json ${json_ARGUMENTS})
  string(JSON value ERROR_VARIABLE json_error GET "${output}" ${json_UNPARSED_ARGUMENTS})
  if(json_error)
    message(SEND_ERROR "'${json_ARGUMENTS}': ${json_error} in '${output}'")
  endif()
  expect_equal("${value}" "${expected}")
endfunction()

# Writes an ASCII STL file of facets, whose corners have commas between them.
function(write_stl name)
  set(content "solid\n")
  foreach(facet IN LISTS ARGN)
    string(REPLACE "," "\nvertex " facet "${facet}")
    string(APPEND content "facet normal 0 0 0\nouter loop\nvertex ${facet}\nendloop\nendfacet\n")
  endforeach()
  file(WRITE ${FOLDER}/${name} "${content}endsolid\n")
endfunction()

# a closed tetrahedron, one corner of which is written in two ways
write_stl(last_bit.stl "0 0 0,0 1 0,1 0 0" "1e-17 0 0,1 0 0,0 0 1" "1 0 0,0 1 0,0 0 1" "0 0 0,0 0 1,0 1 0")
expect_json(1 border_loops ARGUMENTS last_bit.stl --field z)
expect_json(5 vertices ARGUMENTS last_bit.stl --field z)
expect_json(2 input close_border_points ARGUMENTS last_bit.stl --field z)
expect_json("reeb_graph repair --merge-within 1e-16" input suggested_repair ARGUMENTS last_bit.stl --field z)
expect_success(compute last_bit.stl --field z)
expect_match("${output}" "2 along borders are less than [0-9.e-]+ from others: 'reeb_graph repair --merge-within 1e-16' merges them")
foreach(distance 1e-16 1e-12 1e-8)
  expect_repair(2 result euler_characteristic ARGUMENTS last_bit.stl --merge-within ${distance} --output closed.ply)
  expect_json(0 border_loops ARGUMENTS closed.ply --field z)
  expect_json(4 vertices ARGUMENTS closed.ply --field z)
  expect_json(0 genus ARGUMENTS closed.ply --field z)
endforeach()
expect_repair(1 result border_loops ARGUMENTS last_bit.stl --merge --output closed.ply)
expect_error("--merge-within.*--merge|--merge.*--merge-within" repair last_bit.stl --merge --merge-within 1 --output a.off)
foreach(distance 0 -1 nan inf)
  expect_error("must be a positive finite number" repair last_bit.stl --merge-within ${distance} --output a.off)
endforeach()

# a tetrahedron, each face of which has its own points
file(WRITE ${FOLDER}/unwelded.obj
     "v 0 0 0\nv 0 1 0\nv 1 0 0\nv 0 0 -0\nv 1 0 0\nv 0 0 1\nv 1 0 0\nv 0 1 0\nv 0 0 1\nv 0 -0 0\nv 0 0 1\nv 0 1 0\n"
     "f 1 2 3\nf 4 5 6\nf 7 8 9\nf 10 11 12\n")
expect_json(4 components ARGUMENTS unwelded.obj --field z)
expect_json(12 input coinciding_border_points ARGUMENTS unwelded.obj --field z)
expect_json("reeb_graph repair --merge" input suggested_repair ARGUMENTS unwelded.obj --field z)
expect_repair(1 result components ARGUMENTS unwelded.obj --merge --output welded.off --map map.txt)
expect_json(4 vertices ARGUMENTS welded.off --field z)
file(READ ${FOLDER}/map.txt map)
expect_equal("${map}" "0\n1\n2\n0\n2\n3\n2\n1\n3\n0\n3\n1\n")
# repeated, it changes nothing
expect_repair(0 merged_points ARGUMENTS welded.off --merge --orient --split --largest --output again.off)
expect_same_file(welded.off again.off)

# a face that has a corner twice: points of STL files are merged on reading
write_stl(degenerate.stl "0 0 0,1 0 1,0 1 2" "1 0 1,1 1 3,0 1 2" "1 0 1,0 1 2,0 1 2")
file(WRITE ${FOLDER}/degenerate.obj "v 0 0 0\nv 1 0 1\nv 0 1 2\nv 1 1 3\nf 1 2 3\nf 2 4 3\nf 2 3 3\n")
foreach(name degenerate.stl degenerate.obj)
  expect_json(2 faces ARGUMENTS ${name} --field z)
  expect_json(3 input faces ARGUMENTS ${name} --field z)
  expect_json(2 input first_face_with_repeated_corner ARGUMENTS ${name} --field z)
  expect_success(compute ${name} --field z)
  expect_match("${output}" "file     3 faces, of which 2 are kept: 1 with a repeated corner, the first one, face 2\n")
  expect_success(handles ${name} --loops loops.vtp)
endforeach()
# small area is none
file(WRITE ${FOLDER}/flat.obj "v 0 0 0\nv 1 0 1\nv 2 0 2\nf 1 2 3\n")
expect_json(1 faces ARGUMENTS flat.obj --field z)

# a face that is listed twice, behind a degenerate one; the two sides of a face stay
file(WRITE ${FOLDER}/duplicate.obj
     "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 1 2\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 1 4 3\nf 2 1 3\n")
expect_json(4 faces ARGUMENTS duplicate.obj --field z)
expect_json(1 input repeated_faces ARGUMENTS duplicate.obj --field z)
expect_json(5 input first_repeated_face ARGUMENTS duplicate.obj --field z)
expect_json(0 genus ARGUMENTS duplicate.obj --field z)
expect_success(handles duplicate.obj)
expect_match("${output}" "6 faces, of which 4 are kept: 1 with a repeated corner, .*, and 1 that repeat earlier ones")
file(WRITE ${FOLDER}/pillow.off "OFF\n3 2 0\n0 0 0\n1 0 0\n0 1 1\n3 0 1 2\n3 0 2 1\n")
expect_json(2 faces ARGUMENTS pillow.off --field z)
expect_repair(2 result faces ARGUMENTS pillow.off --merge --orient --split --output pillow.ply)
expect_json(2 euler_characteristic ARGUMENTS pillow.ply --field z)

# fields of vertices: a merged one has the value of the lowest number
file(WRITE ${FOLDER}/fields.ply
     "ply\nformat ascii 1.0\nelement vertex 6\nproperty double x\nproperty double y\nproperty double z\n"
     "property float mass\nproperty int scalar\nelement face 2\nproperty list uchar int vertex_indices\nend_header\n"
     "0 0 0 1 10\n1 0 0 2 20\n0 1 1 3 30\n1 0 0 2.5 20\n1 1 0 5 50\n0 1 1 3 31\n3 0 1 2\n3 3 4 5\n")
foreach(ending ply vtp)
  expect_repair(1 fields 0 differing_points ARGUMENTS fields.ply --merge --output merged.${ending})
  expect_repair(0.5 fields 0 largest_difference ARGUMENTS fields.ply --merge --output merged.${ending})
  expect_repair(scalar fields 1 name ARGUMENTS fields.ply --merge --output merged.${ending})
  expect_success(compute merged.${ending} --field mass --vertex-arcs arcs.txt)
  expect_json(4 vertices ARGUMENTS merged.${ending} --field scalar)
  # and from there, the numbers are read and written again
  expect_repair(mass fields 0 name ARGUMENTS merged.${ending} --output again.${ending})
  expect_same_file(merged.${ending} again.${ending})
endforeach()
expect_repair(mass lost_fields 0 ARGUMENTS fields.ply --merge --output merged.obj)
expect_success(repair fields.ply --merge --output merged.obj)
expect_match("${output}" "mass is lost")

# merging that makes an edge of three faces says so, and splitting undoes it
file(WRITE ${FOLDER}/book.off
     "OFF\n9 3 0\n0 0 0\n1 0 0\n0 1 0\n0 0 0\n1 0 0\n0 0 1\n0 0 0\n1 0 0\n0 -1 0\n3 0 1 2\n3 3 4 5\n3 6 7 8\n")
expect_repair(1 merged edges_of_many_faces ARGUMENTS book.off --merge --output page.ply)
expect_repair(0 given edges_of_many_faces ARGUMENTS book.off --merge --output page.ply)
expect_success(repair book.off --merge --output page.ply)
expect_match("${output}" "1 edge got more than two faces by merging")
expect_repair(0 result edges_of_many_faces ARGUMENTS page.ply --split --output pages.ply)
expect_json(3 components ARGUMENTS pages.ply --field z)
expect_json(9 vertices ARGUMENTS pages.ply --field z)
# for what needs a surface, the message names the repair
expect_error("reeb_graph repair --split" handles page.ply)
expect_repair(3 result vertices ARGUMENTS pages.ply --largest --output largest.ply)

# what is no matter of faces
file(WRITE ${FOLDER}/tetrahedra.vtk "# vtk DataFile Version 3.0\nx\nASCII\nDATASET UNSTRUCTURED_GRID\nPOINTS 4 float\n"
     "0 0 0 1 0 0 0 1 0 0 0 1\nCELLS 1 5\n4 0 1 2 3\nCELL_TYPES 1\n10\n")
expect_error("repair is for faces" repair tetrahedra.vtk --output a.ply)
file(WRITE ${FOLDER}/nan.off "OFF\n3 1 0\nnan 0 0\n1 0 0\n0 1 1\n3 0 1 2\n")
expect_error("vertex 0 has a coordinate that is not a finite number" repair nan.off --output a.ply)
expect_error("the file name of a mesh ends in .off, .ply, .obj, .stl, or .vtp" repair book.off --output a.vtk)
expect_error("two outputs have this name" repair book.off --output a.ply --map a.ply)
expect_error("would replace an input" repair book.off --output book.off)

# meshes in each format that is written have the same graph
foreach(ending off ply obj stl vtp)
  expect_success(repair ${genus_3} --output written.${ending})
  expect_success(compute written.${ending} --field z --graph written_${ending}.graphml)
  if(NOT ending STREQUAL "stl") # its vertices are in the order of faces
    expect_same_file(written_${ending}.graphml written_off.graphml)
  endif()
  expect_json(3 genus ARGUMENTS written.${ending} --field z)
  expect_success(compute ${genus_3} --field z --mesh-out result.${ending})
  expect_json(3 genus ARGUMENTS result.${ending} --field z)
  expect_success(curves ${genus_3} --type pants --field z --cut-mesh cut.${ending} --curves curves.csv --cut-open)
  if(NOT ending STREQUAL "stl") # which has the points on both sides of a cut once
    expect_json(4 components ARGUMENTS cut.${ending} --field z)
  endif()
  expect_success(handles ${genus_3} --remove 1 --output fewer.${ending})
  expect_json(2 genus ARGUMENTS fewer.${ending} --field z)
endforeach()
file(WRITE ${FOLDER}/square.off "OFF\n4 1 0\n0 0 0\n1 0 0\n1 1 1\n0 1 1\n4 0 1 2 3\n")
expect_error("STL has triangles only" repair square.off --output square.stl)
expect_repair(2 result faces ARGUMENTS square.off --triangulate --output square.stl)
expect_repair(1 result faces ARGUMENTS square.off --output square.vtp)

# points of contours and curves as rows
expect_success(contour written.off --field z --levels 3 --output contours.csv)
file(STRINGS ${FOLDER}/contours.csv rows)
list(GET rows 0 header)
expect_equal("${header}" "contour,arc,value,length,closed,x,y,z")
expect_success(contour written.off --field z --levels 3 --output contours.polylines.txt)
file(STRINGS ${FOLDER}/contours.polylines.txt lines)
set(points 0)
foreach(line IN LISTS lines)
  string(REGEX MATCH "^[0-9]+" number "${line}")
  math(EXPR points "${points} + ${number}")
endforeach()
list(LENGTH rows number_of_rows)
math(EXPR points "${points} + 1")
expect_equal("${number_of_rows}" "${points}")
file(STRINGS ${FOLDER}/curves.csv rows)
list(GET rows 0 header)
expect_equal("${header}" "curve,x,y,z")

# formats of others are refused by name, with what converts them
foreach(item "glb|trimesh" "gltf|trimesh" "3mf|trimesh" "gii|mris_convert" "msh|meshio convert" "vti|ImageData.*Tetrahedralize"
             "vtr|RectilinearGrid" "vtm|Merge Blocks")
  string(REPLACE "|" ";" item "${item}")
  list(GET item 0 ending)
  list(GET item 1 pattern)
  file(WRITE ${FOLDER}/other.${ending} "x")
  expect_error("${pattern}" compute other.${ending} --field z)
endforeach()
