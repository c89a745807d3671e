# Wrong input ends in a message that says what is wrong and where.
include(${CMAKE_CURRENT_LIST_DIR}/common.cmake)

set(graph --graph graph.graphml)
file(WRITE ${FOLDER}/tetrahedron.off "${tetrahedron_off}")

# Expects the message for a file of this content, in a field of its mesh.
function(expect_error_of_file name content pattern)
  file(WRITE ${FOLDER}/${name} "${content}")
  expect_error("${pattern}" compute ${name} ${ARGN} ${graph})
endfunction()

# Expects a message for each of several files of this name, given as "MESSAGE|CONTENT", before which there is `begin`.
function(expect_errors_of_files name begin)
  foreach(item IN LISTS ARGN)
    string(FIND "${item}" "|" end)
    string(SUBSTRING "${item}" 0 ${end} pattern)
    math(EXPR end "${end} + 1")
    string(SUBSTRING "${item}" ${end} -1 content)
    expect_error_of_file(${name} "${begin}${content}" "${name}:.*${pattern}" --field z)
  endforeach()
endfunction()

# the command line
expect_error("a command is needed: compute, compare, contour, curves, field, handles, repair, skeleton, demo")
expect_error("there is no command 'paint': compute" paint tetrahedron.off)
expect_error("MESH" compute)
expect_error("" compute tetrahedron.off)
expect_error("" compute tetrahedron.off --field z --scalars scalars.txt)
expect_error("no field 'w'" compute tetrahedron.off --field w)
expect_error("compute has no option '--no-such-option'\nRun" compute tetrahedron.off --field z --no-such-option)
foreach(item "--scalar;--scalars" "--scalars-of=x;--scalars" "--feild;--field" "--longest;--longest-loop")
  list(GET item 0 given)
  list(GET item 1 nearest)
  expect_error("compute has no option '--[a-z-]+'; the nearest one is ${nearest}\n" compute tetrahedron.off ${given} z)
endforeach()
expect_error("missing.off: there is no such file" compute missing.off --field z)
# numbers: each option, what is given, and what the message says
foreach(item "--leaves -1|'-1' is less than 0" "--slabs 0|'0' is less than 1" "--slabs -0|'-0' is less than 1"
             "--leaves 18446744073709551616|'18446744073709551616' is more than 18446744073709551615"
             "--leaves -18446744073709551616|is less than 0" "--leaves 1.5|'1.5' is not a whole number"
             "--leaves 0x10|'0x10' is not a whole number" "--leaves --5|'--5' is not a whole number"
             "--threads 0|'0' is less than 1" "--threads 1025|'1025' is more than 1024" "--threads 2x|'2x' is not"
             "--source -1|'-1' is less than 0" "--source 0,-1|'-1' is less than 0" "--source 1,x|'x' is not"
             "--min -1|'-1' is less than 0" "--max 1e3|'1e3' is not" "--direction 0,0,z|'z' is not a number"
             "--direction 0,0,1e999|'1e999' is too large")
  string(REGEX MATCH "^(--[a-z]*) (.*)[|](.*)$" item "${item}")
  expect_error("${CMAKE_MATCH_1}: .*${CMAKE_MATCH_3}" compute missing.off --field z ${CMAKE_MATCH_1} ${CMAKE_MATCH_2})
endforeach()
foreach(arguments "--arc -1 --t 0.5" "--arc 18446744073709551616 --t 0.5" "--arc 0 --t half" "--level 0.5m" "--level 1e999")
  string(REPLACE " " ";" arguments "${arguments}")
  expect_error("--[a-z]+: '[^ ]*' is " contour missing.off --field z ${arguments} --output contours.polylines.txt)
endforeach()
foreach(option --persistence --area)
  expect_error("${option}: 'small' is not a number" curves missing.off --field z --type branch ${option} small)
endforeach()
expect_success(compute tetrahedron.off --field z --leaves 010) # no octal 8
expect_success(compute tetrahedron.off --field height --direction 0,-0.5,1e-999)
expect_error("a field is needed, such as --field z or --scalars FILE" compute tetrahedron.off)
expect_success(--version)
expect_match("${output}" "^reeb_graph [0-9]+[.][0-9]+[.][0-9]+ .CGAL [5-9][.]")

# files that cannot be read as a mesh
file(WRITE ${FOLDER}/empty.off "")
file(WRITE ${FOLDER}/text.off "This is no mesh.\n")
file(WRITE ${FOLDER}/truncated.off "OFF\n4 4 0\n0 0 0\n1 0 0\n")
file(WRITE ${FOLDER}/no_faces_left.off "OFF\n3 2 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n")
file(WRITE ${FOLDER}/text.ply "ply\nThis is no mesh.\n")
file(WRITE ${FOLDER}/text.obj "This is no mesh.\n")
foreach(format stl mesh vtk vtu)
  file(WRITE ${FOLDER}/text.${format} "This is no mesh.\n")
endforeach()
file(WRITE ${FOLDER}/mesh.unknown "${tetrahedron_off}")
file(WRITE ${FOLDER}/mesh "${tetrahedron_off}")
file(WRITE ${FOLDER}/truncated.stl "solid\nfacet normal 0 0 0\nouter loop\nvertex 0 0 0\nvertex 1 0 0\n")
foreach(name missing.off empty.off text.off truncated.off no_faces_left.off text.ply text.obj text.stl truncated.stl
             text.mesh text.vtk text.vtu mesh.unknown mesh .)
  expect_error("${name}" compute ${name} --field z ${graph})
endforeach()

# files that are a mesh up to some place
expect_error_of_file(
  one_face_more.off "OFF\n4 3 0\n0 0 0\n4 0 0.25\n0 4 0.5\n0 0 1\n3 0 2 1\n3 0 1 3\n3 1 2 3\n3 0 3 2\n# end\n"
  "one_face_more.off:10: there are more faces than the 3" --field z)
set(vertices_obj "v 0 0 0\nv 4 0 0.25\nv 0 4 0.5\n")
foreach(face "1 2 3 junk" "0 1 2" "1 2 3x" "1 2 -4" "1 2 9")
  file(WRITE ${FOLDER}/face.obj "${vertices_obj}f ${face}\nv 0 0 1\n")
  expect_error("face.obj:4: " compute face.obj --field z ${graph})
endforeach()
foreach(face "1 2 3 # the face" "1/7 2/8 3/9" "1//7 2//8 3//9" "-3 -2 -1" "1 2 4" "1 2\t3" "1 2 \\\n 3")
  file(WRITE ${FOLDER}/face.obj "${vertices_obj}f ${face}\nv 0 0 1\n")
  expect_success(compute face.obj --field z)
endforeach()

set(ply_begin "ply\nformat ascii 1.0\n")
set(ply_vertices "element vertex 3\nproperty float x\nproperty float y\nproperty float z\n")
set(ply_faces "element face 1\nproperty list uchar int vertex_indices\n")
set(ply_data "end_header\n0 0 0\n1 0 0\n0 1 1\n3 0 1 2\n")
file(WRITE ${FOLDER}/header.ply "${ply_begin}${ply_vertices}${ply_faces}${ply_data}")
expect_success(compute header.ply --field z)
string(REPLACE "float x" "int64 x" ply_other_type "${ply_vertices}")
string(REPLACE "float x" "float u" ply_no_x "${ply_vertices}")
string(REPLACE "element" "elemnt" ply_misspelt "${ply_vertices}")
expect_errors_of_files(
  header.ply "${ply_begin}"
  "3: 'property' has no place|property float x\n${ply_vertices}${ply_faces}${ply_data}"
  "4: 'int64' is not a type|${ply_other_type}${ply_faces}${ply_data}"
  "no x, y and z|${ply_no_x}${ply_faces}${ply_data}"
  "3: 'elemnt' has no place|${ply_misspelt}${ply_faces}${ply_data}"
  "no list of vertices|${ply_vertices}element face 1\nproperty int vertex_indices\n${ply_data}"
  "8: the header does not end|${ply_vertices}${ply_faces}"
  "14: there is more|${ply_vertices}${ply_faces}${ply_data}3 0 1 2\n"
  "a number is missing|element vertex 4000000000\nproperty float x\nproperty float y\nproperty float z\n${ply_faces}${ply_data}"
  "'2147483648' is not a number that is possible|${ply_vertices}${ply_faces}end_header\n0 0 0\n1 0 0\n0 1 1\n3 0 1 2147483648\n")
file(WRITE ${FOLDER}/colours.off "COFF\n3 1 0\n0 0 0 255 0 0 255\n1 0 0 255\n0 1 1\n3 0 1 2 -7\n")
expect_success(compute colours.off --field z)
expect_error_of_file(corners.off "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 1\n1000000000000 0 1 2\n"
                     "corners.off:6: a number is missing" --field z)
expect_error_of_file(fraction.off "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 1\n3 0 1 1.5\n"
                     "fraction.off:6: '1.5' is not" --field z)
expect_error_of_file(binary.off "OFF BINARY\n" "binary OFF files are not read" --field z)
expect_error_of_file(infinite.off "OFF\n3 1 0\n0 0 0\n1 0 inf\n0 1 1\n3 0 1 2\n"
                     "vertex 1 has a coordinate that is not a finite number" --field x)
file(WRITE ${FOLDER}/four_corners.stl "solid\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 1 1 0\n"
     "vertex 0 1 0\nendloop\nendfacet\nendsolid\n")
expect_error("four_corners.stl:7: 'vertex' instead of 'endloop'" compute four_corners.stl --field x ${graph})
set(facets "solid\n")
foreach(facet "0 0 0;0 1 0;1 0 0" "0 0 0;1 0 0;0 0 1" "1 0 0;0 1 0;0 0 1" "0 1 0;nan 0 0;0 0 1")
  list(JOIN facet "\nvertex " corners)
  string(APPEND facets "facet normal 0 0 0\nouter loop\nvertex ${corners}\nendloop\nendfacet\n")
endforeach()
expect_error_of_file(nan.stl "${facets}endsolid\n" "vertex 4 has a coordinate that is not a finite number" --field x)

# faces that are wrong
expect_error_of_file(out_of_range.off "OFF\n3 2 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n3 0 1 7\n"
                     "out_of_range.off" --field z)
expect_error_of_file(quad.off "OFF\n5 2 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n2 0 0\n3 1 4 2\n4 0 1 2 3\n"
                     "face 1 has 4 vertices and is not a triangle; --triangulate" --field x)

# curves need a surface that is manifold, and orientable
function(expect_error_of_curves name content pattern)
  file(WRITE ${FOLDER}/${name} "${content}")
  expect_error("${pattern}" curves ${name} ${ARGN} --type pants --curves curves.polylines.txt)
endfunction()

expect_error_of_curves(
  three_faces_at_an_edge.off "OFF\n5 3 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n0 -1 0\n3 0 1 2\n3 0 1 3\n3 0 1 4\n"
  "edge between the vertices 0 and 1 has 3 faces; .*reeb_graph repair --all" --field z)
expect_error_of_curves(
  two_fans.off "OFF\n5 2 0\n0 0 0\n1 0 0\n1 1 0\n-1 0 0\n-1 -1 0\n3 0 1 2\n3 0 3 4\n"
  "the faces at vertex 0 form 2 fans" --field x)
expect_error_of_curves(
  two_closed_fans.off "OFF\n7 8 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n-1 0 0\n0 -1 0\n0 0 -1\n\
3 0 2 1\n3 0 1 3\n3 1 2 3\n3 0 3 2\n3 0 4 5\n3 0 6 4\n3 4 6 5\n3 0 5 6\n"
  "the faces at vertex 0 form 2 fans" --field x)
expect_error_of_curves(
  moebius_strip.off "OFF\n5 5 0\n0 0 0\n1 0 0\n1 1 0\n0 1 1\n0 0 2\n\
3 0 1 2\n3 1 2 3\n3 2 3 4\n3 3 4 0\n3 4 0 1\n"
  "cannot be oriented, which shows at the edge of the vertices [0-4] and [0-4]" --field z)
expect_error_of_curves(
  duplicate.off "OFF\n4 5 0\n0 0 0\n1 0 1\n0 1 2\n1 1 3\n\
3 0 1 2\n3 0 3 1\n3 1 3 2\n3 2 3 0\n3 0 3 2\n"
  "1 face repeats an earlier one, the first one, face 4" --field z)
expect_error_of_curves(
  free_edges.mesh "MeshVersionFormatted 2\nDimension 3\nVertices\n5\n0 0 0 0\n1 0 1 0\n0 1 2 0\n\
0 0 3 0\n0 0 4 0\nTriangles\n1\n1 2 3 0\nEdges\n3\n1 2 0\n5 4 0\n4 2 0\nEnd\n"
  "2 edges are on no face, the first one, of the vertices 1 and 3; reeb_graph repair leaves edges of no face out" --field z)

# lines alone, of which nothing is said as if they had a surface
file(WRITE ${FOLDER}/lines.vtk "# vtk DataFile Version 3.0\nx\nASCII\nDATASET POLYDATA\nPOINTS 3 float\n"
     "0 0 0 1 0 0 2 1 0\nLINES 1 4\n3 0 1 2\n")
foreach(arguments "handles" "skeleton" "curves;--type;pants;--field;x" "compute;--field;harmonic" "repair;--output;a.off"
                  "field;--type;poisson;--output;a.txt")
  list(POP_FRONT arguments command)
  expect_error("lines.vtk: .* needs faces, and the mesh has lines alone" ${command} lines.vtk ${arguments})
  run(${command} lines.vtk ${arguments})
  if(error MATCHES "surface")
    message(SEND_ERROR "${command} speaks of a surface of lines: ${error}")
  endif()
endforeach()

# what else needs one
foreach(option "--html page.html --strict" "--simplified-scalars scalars.txt;--leaves 2")
  string(REPLACE " " ";" option "${option}")
  list(GET option 0 name)
  expect_error("${name}.* needs an oriented manifold surface; the edge between" compute three_faces_at_an_edge.off
               --field z ${option})
endforeach()
foreach(field harmonic poisson unit-gradient)
  expect_error("the field ${field} needs an oriented manifold surface; the edge" compute three_faces_at_an_edge.off
               --field ${field} ${graph})
endforeach()
expect_error("there is no vertex 5: the mesh has 5" compute three_faces_at_an_edge.off --field geodesic --source 5 ${graph})

# cells that are wrong
set(medit_points "MeshVersionFormatted 1\nDimension 3\nVertices\n4\n0 0 0 0\n1 0 0 0\n0 1 0 0\n0 0 1 0\n")
expect_errors_of_files(
  wrong.mesh "${medit_points}"
  "tetrahedron 0 has a vertex that does not exist|Tetrahedra 1\n1 2 3 5 0\nEnd\n"
  "tetrahedron 1 has vertex 2 at two of its corners|Tetrahedra 2\n1 2 3 4 0\n1 3 2 3 0\nEnd\n"
  "face 0 has a vertex that does not exist|Triangles 1\n1 2 9 0\nEnd\n"
  "edge 0 has vertex 1 at two of its corners|Edges 1\n2 2 0\nEnd\n"
  "10: there is no vertex 0|Tetrahedra 1\n0 2 3 4 0\nEnd\n"
  "9: 'Hexahedra' is not a section|Hexahedra 1\n1 2 3 4 1 2 3 4 0\nEnd\n"
  "a number is missing|Tetrahedra 2\n1 2 3 4 0\n")
set(vtk_points "# vtk DataFile Version 3.0\nwrong\nASCII\nDATASET UNSTRUCTURED_GRID\nPOINTS 4 float\n"
               "0 0 0 1 0 0 0 1 0 0 0 1\n")
string(JOIN "" vtk_points ${vtk_points})
expect_errors_of_files(
  wrong.vtk "${vtk_points}"
  "cells of type 12 .hexahedron. of VTK are not read: the types are 1 to 10.*vtkDataSetTriangleFilter|CELLS 1 9\n8 0 1 2 3 0 1 2 3\nCELL_TYPES 1\n12\n"
  "a cell of type 10 of VTK cannot have 3 vertices|CELLS 1 4\n3 0 1 2\nCELL_TYPES 1\n10\n"
  "there are 1 cells, and types of 0|CELLS 1 5\n4 0 1 2 3\n"
  "tetrahedron 0 has a vertex that does not exist|CELLS 1 5\n4 0 1 2 4\nCELL_TYPES 1\n10\n"
  "the cells have 5 numbers instead of 6|CELLS 1 6\n4 0 1 2 3\nCELL_TYPES 1\n10\n")
expect_error_of_file(field.vtk "${vtk_points}CELLS 1 5\n4 0 1 2 3\nCELL_TYPES 1\n10\n"
                     "there is no field 'mass'" --field mass)
expect_error_of_file(binary.vtk "# vtk DataFile Version 3.0\nwrong\nBINARY\nDATASET POLYDATA\nPOINTS 4 float\n0123456789"
                     "the file ends too early" --field z)
expect_error_of_file(bits.vtk "# vtk DataFile Version 3.0\nwrong\nBINARY\nDATASET POLYDATA\nPOINTS 1 variant\n0123456789"
                     "'variant' is not a type of numbers that is read" --field z)
expect_error_of_file(grid.vtk "# vtk DataFile Version 3.0\nwrong\nASCII\nDATASET STRUCTURED_POINTS\n"
                     "'STRUCTURED_POINTS' are not read, .*vtkDataSetTriangleFilter" --field z)
expect_error_of_file(image.vtu "<VTKFile type=\"ImageData\"></VTKFile>" "'ImageData' are not read, .*Tetrahedralize" --field z)
expect_error_of_file(parts.vtp "<VTKFile type=\"PPolyData\"></VTKFile>" "'PPolyData' are not read, .*Merge Blocks" --field z)
expect_error_of_file(lz4.vtu "<VTKFile type=\"UnstructuredGrid\" compressor=\"vtkLZ4DataCompressor\"></VTKFile>"
                     "compressed by 'vtkLZ4DataCompressor' are not read, .*ParaView" --field z)
expect_error_of_file(lzma.vtp "<VTKFile type=\"PolyData\" compressor=\"vtkLZMADataCompressor\"></VTKFile>"
                     "compressed by 'vtkLZMADataCompressor' are not read, .*meshio decompress" --field z)
set(compressed_vtp "<VTKFile type=\"PolyData\" compressor=\"vtkZLibDataCompressor\"><PolyData><Piece NumberOfPoints=\"1\">"
                   "<Points><DataArray type=\"Float32\" NumberOfComponents=\"3\" format=\"binary\">")
string(JOIN "" compressed_vtp ${compressed_vtp})
expect_errors_of_files(
  zlib.vtp "${compressed_vtp}"
  "the array of points ends too early|AQAAAACA</DataArray></Points></Piece></PolyData></VTKFile>"
  "the array of points is damaged: zlib|AQAAAACAAAAMAAAACAAAAA==AAAAAAAAAAA=</DataArray></Points></Piece></PolyData></VTKFile>"
  "the array of points is damaged|AQAAAP///38AAAAACAAAAA==AAAAAAAAAAA=</DataArray></Points></Piece></PolyData></VTKFile>")
expect_error("--mesh-out writes triangles, and the mesh has tetrahedra" compute field.vtk --field z --mesh-out mesh.ply)
expect_error("contours in tetrahedra, which are surfaces, ends in .off" contour field.vtk --field z
             --level 0.5 --output contour.polylines.txt)
expect_error("contours ends in .polylines.txt, .vtp, .obj, .json, or .csv" contour three_faces_at_an_edge.off --field z --level 0.5
             --output contour.off)

# scalars
function(expect_error_of_scalars content pattern)
  file(WRITE ${FOLDER}/scalars.txt "${content}")
  expect_error("${pattern}" compute tetrahedron.off --scalars scalars.txt ${graph})
endfunction()

foreach(content "0\n1\n2\n" "")
  expect_error_of_scalars("${content}" "scalars.txt:[03]: the file ends after [03] values for 4 vertices")
endforeach()
expect_error_of_scalars("0\n1\n2\n3\n4\n" "scalars.txt:5: more values than the 4 vertices")
foreach(wrong "two" "2 2" "" "2x" "0x2" "+-2" "1,5")
  string(REPLACE "+" "[+]" pattern "${wrong}")
  expect_error_of_scalars("0\n1\n${wrong}\n3\n" "scalars.txt:3: '${pattern}' is not a number")
endforeach()
expect_error_of_scalars("0\n1e999\n2\n3\n" "scalars.txt:2: .* too large")
expect_error_of_scalars("0\n1\n2\nnan\n" "vertex 3 is not a number")
string(REPEAT "0123456789" 10 long_word)
string(SUBSTRING "${long_word}" 0 56 begin)
expect_error_of_scalars("0\nx${long_word}\n2\n3\n" "scalars.txt:2: 'x${begin}[.][.][.]' is not a number")
expect_error_of_file(long.off "OFF\n3 1 0\nx${long_word} 0 0\n1 0 0\n0 1 1\n3 0 1 2\n"
                     "long.off:3: 'x${begin}[.][.][.]' is not a number" --field z)
string(ASCII 27 escape)
expect_error_of_scalars("0\n${escape}c\n2\n3\n" "scalars.txt:2: '[?]c' is not a number")
expect_error("missing.txt: there is no such file" compute tetrahedron.off --scalars missing.txt ${graph})
expect_error("[.]: this is a folder" compute tetrahedron.off --scalars . ${graph})
