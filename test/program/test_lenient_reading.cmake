# Files as other programs write them: forms that differ from what formats ask for are read, what is left out is noted, and
# what would be a part of the mesh and is not read is an error that names it.
include(${CMAKE_CURRENT_LIST_DIR}/common.cmake)

# Expects the counts of vertices, faces (or triangles), and components of a file in the report, and its first note.
function(expect_mesh name content vertices faces components note)
  file(WRITE ${FOLDER}/${name} "${content}")
  expect_success(compute ${name} --field z --json)
  string(JSON found_vertices GET "${output}" vertices)
  string(JSON found_faces ERROR_VARIABLE no_faces GET "${output}" faces)
  if(no_faces)
    string(JSON found_faces GET "${output}" triangles)
  endif()
  string(JSON found_components GET "${output}" components)
  string(JSON notes GET "${output}" notes)
  expect_equal("${name}: ${found_vertices} ${found_faces} ${found_components}"
               "${name}: ${vertices} ${faces} ${components}")
  if(note STREQUAL "")
    expect_equal("${notes}" "[]")
  else()
    expect_match("${notes}" "${note}")
    expect_success(compute ${name} --field z)
    expect_match("${output}" "\n         [^\n]*${note}")
  endif()
endfunction()

function(expect_refused name content pattern)
  file(WRITE ${FOLDER}/${name} "${content}")
  expect_error("${name}.*${pattern}" compute ${name} --field z --graph graph.dot)
endfunction()

# STL
set(facet " facet normal 0 0 1\n  outer loop\n   vertex 0 0 0\n   vertex 1 0 1\n   vertex 0 1 2\n  endloop\n endfacet\n")
string(TOUPPER "solid a b\n${facet}endsolid a b\n" upper)
expect_mesh(upper.stl "${upper}" 3 1 1 "")
expect_mesh(end_solid.stl "solid deform-3d\n${facet}end solid deform-3d\n" 3 1 1 "")
string(REPLACE "endloop" "end loop" end_loop "solid\n${facet}End Solid\n")
string(REPLACE "endfacet" "END FACET" end_loop "${end_loop}")
expect_mesh(end_loop.stl "${end_loop}" 3 1 1 "")
string(REPLACE "endloop" "end loops" end_loops "solid\n${facet}endsolid\n")
expect_refused(end_loops.stl "${end_loops}" ":7: 'endloops' instead of 'endloop'")

# binary STL: shell code, as CMake writes no zero byte
function(write_binary_stl name number_of_facets facets bytes_behind)
  string(REPEAT "\\000" 12 normal)
  set(corners "\\000\\000\\000\\000\\000\\000\\000\\000\\000\\000\\000\\000") # 0 0 0, then 1 0 0 and 0 0 1
  string(APPEND corners "\\000\\000\\200\\077\\000\\000\\000\\000\\000\\000\\000\\000")
  string(APPEND corners "\\000\\000\\000\\000\\000\\000\\000\\000\\000\\000\\200\\077\\000\\000")
  string(REPEAT "${normal}${corners}" ${facets} data)
  string(REPEAT "\\001" ${bytes_behind} behind)
  string(REPEAT " " 69 spaces)
  execute_process(COMMAND printf "a STL model${spaces}\\00${number_of_facets}\\000\\000\\000${data}${behind}"
                  OUTPUT_FILE ${FOLDER}/${name})
endfunction()

write_binary_stl(exact.stl 1 1 0)
expect_success(compute exact.stl --field z --json)
string(JSON notes GET "${output}" notes)
expect_equal("${notes}" "[]")
write_binary_stl(trailing.stl 1 1 92)
expect_success(compute trailing.stl --field z --json)
expect_match("${output}" "\"faces\": 1,.*\"notes\": .*92 bytes are left out behind the 1 triangles")
write_binary_stl(short.stl 3 1 7)
expect_error("short.stl: the file ends too early: its header says that there are 3 triangles, and 1 are" compute short.stl
             --field z)
write_binary_stl(none.stl 0 1 0)
expect_error("none.stl: its header says that there are 0 triangles, but 50 bytes follow" compute none.stl --field z)

# OBJ
set(points "v 0 0 0\nv 1 0 1\nv 0 1 2\nv 0 1 3\n")
expect_mesh(dollar.obj "$ a comment\n${points}f 1 2 3\n  $f 1 2 4\nf 3 2 4\n" 4 2 1 "")
expect_mesh(unknown.obj "${points}f 1 2 3\nxyz 1 2\nabc\nf 3 2 4\n" 4 2 1
            "2 lines of the file begin with no keyword of OBJ, the first one, line 6, with 'xyz'")
expect_mesh(one_unknown.obj "Made by hand\n${points}fo 1 2 3\n" 4 1 2
            "1 line of the file begins with no keyword of OBJ, the first one, line 1, with 'Made'")
expect_success(handles one_unknown.obj)
expect_match("${output}" "1 line of the file begins")
expect_success(field one_unknown.obj --type height --output field.txt)
expect_match("${output}" "1 line of the file begins")
expect_mesh(face_and_line.obj "${points}f 1 2 3\nl 3 4\n" 4 1 1 "")
expect_success(compute face_and_line.obj --field z)
expect_match("${output}" "1 edge on no triangle, the first one, of the vertices 2 and 3")
expect_mesh(polyline.obj "${points}l 1/1 2/2 -2 -1\n" 4 0 1 "")
expect_mesh(side.obj "${points}f 1 2 3\nf 3 2 4\nl 1 2 4\n" 4 2 1 "") # all on faces: a surface
run(curves side.obj --field z --type branch)
expect_equal("${exit_code}" "0")
expect_refused(short_line.obj "${points}f 1 2 3\nl 3\n" ":6: a line has fewer than two vertices")
expect_refused(line.obj "${points}f 1 2 3\nl 3 5\n" ":6: there is no vertex 5")
foreach(keyword surf curv curv2 bzp call)
  expect_refused(${keyword}.obj "${points}f 1 2 3\n${keyword} 0 1 1 2\n" ":6: '${keyword}' is not read")
endforeach()

# PLY: strips of triangles, where -1 ends one, and triangles with a repeated vertex are none
string(JOIN "\n" ply_points "element vertex 5" "property float x" "property float y" "property float z" "")
set(ply_data "0 0 0\n1 0 0\n0 1 1\n1 1 2\n0 2 3\n")
set(strips "element tristrips 1\nproperty list int int vertex_indices\n")
function(expect_strips name type numbers faces components)
  string(REPLACE "int int" "${type}" strips "${strips}")
  expect_mesh(${name} "ply\nformat ascii 1.0\n${ply_points}${strips}end_header\n${ply_data}${numbers}\n" 5 ${faces}
              ${components} "")
endfunction()
expect_strips(strip.ply "int int" "5 0 1 2 3 4" 3 1)
expect_strips(strips.ply "int int" "8 0 1 2 3 -1 3 4 2" 3 1)
expect_strips(closed_strips.ply "int int" "5 0 1 2 3 -1" 2 2)
expect_strips(unsigned_strips.ply "uchar uint" "8 0 1 2 3 4294967295 3 4 2" 3 1)
expect_strips(degenerate_strip.ply "int int" "9 0 1 2 2 3 3 1 2 4" 3 1)
file(WRITE ${FOLDER}/faces.ply "ply\nformat ascii 1.0\n${ply_points}element face 3\n"
     "property list uchar int vertex_indices\nend_header\n${ply_data}3 0 1 2\n3 2 1 3\n3 2 3 4\n")
foreach(name faces strip)
  expect_success(compute ${name}.ply --field z --graph ${name}.graphml --mesh-out ${name}_out.ply)
endforeach()
expect_same_file(strip.graphml faces.graphml)
expect_same_file(strip_out.ply faces_out.ply) # each triangle is oriented as it should be
expect_refused(strip.ply "ply\nformat ascii 1.0\n${ply_points}${strips}end_header\n${ply_data}3 0 1 5\n"
               "face 0 has a vertex that does not exist")
expect_refused(strip.ply "ply\nformat ascii 1.0\n${ply_points}${strips}end_header\n${ply_data}3 0 -2 1\n"
               "a strip of triangles has a vertex that does not exist")

# edges
foreach(names "vertex1 vertex2" "v0 v1")
  string(REPLACE " " "\nproperty int " names "${names}")
  expect_mesh(edges.ply "ply\nformat ascii 1.0\n${ply_points}element face 1\nproperty list uchar int vertex_indices\n\
element edge 2\nproperty int ${names}\nproperty uchar red\nend_header\n${ply_data}3 0 1 2\n2 3 0\n3 4 9\n" 5 1 1 "")
endforeach()
expect_refused(no_edges.ply "ply\nformat ascii 1.0\n${ply_points}element edge 1\nproperty int a\nproperty int b\nend_header\n\
${ply_data}0 1\n" "the edges have no vertex1 and vertex2")
expect_refused(wrong_edge.ply "ply\nformat ascii 1.0\n${ply_points}element edge 1\nproperty int vertex1\n\
property int vertex2\nend_header\n${ply_data}0 7\n" "edge 0 has a vertex that does not exist")

# elements that may be a part of the mesh, and those that cannot
expect_refused(cells.ply "ply\nformat ascii 1.0\n${ply_points}element cell 1\nproperty list uchar int vertices\nend_header\n\
${ply_data}4 0 1 2 3\n" "the element 'cell' has lists, and is not read: a mesh is one of the elements vertex, face, tristrips")
expect_refused(triangles.ply "ply\nformat ascii 1.0\n${ply_points}element triangle 1\nproperty int v1\nproperty int v2\n\
property int v3\nend_header\n${ply_data}0 1 2\n" "the element 'triangle' has vertices, and is not read")
expect_mesh(camera.ply "ply\nformat ascii 1.0\n${ply_points}element face 1\nproperty list uchar int vertex_indices\n\
element camera 1\nproperty float view_px\nproperty list uchar float matrix\nelement cell 0\n\
property list uchar int vertices\nend_header\n${ply_data}3 0 1 2\n0.5 2 1 2\n" 5 1 3 "")

# TS and VTK
set(ts "GOCAD TSurf 1\nHEADER {\nname: a\n}\nTFACE\nVRTX 1 0 0 0\nVRTX 2 1 0 1\nVRTX 3 0 1 2\nTRGL 1 2 3\n")
expect_mesh(mesh.ts "${ts}END\n" 3 1 1 "")
foreach(keyword SEG TETRA)
  expect_refused(mesh.ts "${ts}${keyword} 1 2 3 3\nEND\n" ":10: '${keyword}' is not read")
endforeach()
string(JOIN "\n" vtk "# vtk DataFile Version 3.0" "a strip" "ASCII" "DATASET POLYDATA" "POINTS 5 float" "${ply_data}")
expect_mesh(strip.vtk "${vtk}TRIANGLE_STRIPS 1 7\n6 0 1 2 2 1 3\n" 5 2 2 "")
foreach(type 11 12 13 14 21 22 24 42)
  expect_refused(cell.vtk "# vtk DataFile Version 3.0\na cell\nASCII\nDATASET UNSTRUCTURED_GRID\nPOINTS 5 float\n${ply_data}\
CELLS 1 6\n5 0 1 2 3 4\nCELL_TYPES 1\n${type}\n" "cells of type ${type} .*of VTK are not read")
endforeach()

# a byte order mark before any text
string(ASCII 239 187 191 mark)
expect_mesh(mark.obj "${mark}# a comment\n${points}f 1 2 3\n" 4 1 2 "")
expect_mesh(mark_first.obj "${mark}${points}f 1 2 3\n" 4 1 2 "")
expect_mesh(mark.off "${mark}${tetrahedron_off}" 4 4 1 "")
expect_mesh(mark.ply "${mark}ply\nformat ascii 1.0\n${ply_points}${strips}end_header\n${ply_data}3 0 1 2\n" 5 1 3 "")
expect_mesh(mark.stl "${mark}solid\n${facet}endsolid\n" 3 1 1 "")
expect_mesh(mark.ts "${mark}${ts}END\n" 3 1 1 "")
expect_mesh(mark.vtk "${mark}${vtk}TRIANGLE_STRIPS 1 4\n3 0 1 2\n" 5 1 3 "")
expect_mesh(mark.mesh "${mark}MeshVersionFormatted 2\nDimension 3\nVertices\n3\n0 0 0 0\n1 0 1 0\n0 1 2 0\nTriangles\n1\n\
1 2 3 0\nEnd\n" 3 1 1 "")
expect_mesh(mark.vtu "${mark}<?xml version=\"1.0\"?>\n<VTKFile type=\"UnstructuredGrid\"><UnstructuredGrid>\
<Piece NumberOfPoints=\"3\" NumberOfCells=\"1\"><Points><DataArray type=\"Float64\" NumberOfComponents=\"3\">\
0 0 0 1 0 1 0 1 2</DataArray></Points><Cells><DataArray type=\"Int32\" Name=\"connectivity\">0 1 2</DataArray>\
<DataArray type=\"Int32\" Name=\"offsets\">3</DataArray><DataArray type=\"UInt8\" Name=\"types\">5</DataArray></Cells>\
</Piece></UnstructuredGrid></VTKFile>\n" 3 1 1 "")
file(WRITE ${FOLDER}/mesh.off "${tetrahedron_off}")
file(WRITE ${FOLDER}/mark.txt "${mark}0\n1\n2\n3\n")
expect_success(compute mesh.off --scalars mark.txt)

# quotation marks within cells that are not quoted
file(WRITE ${FOLDER}/quoted.csv "5\" pipe,\"a \"\"b\"\", c\", \"d\" ,e\n1,2,0,0\n2,\"3\",1,0\n3,4,2,0\n4,5,3,0\n")
foreach(column "5\" pipe" "a \"b\", c" "d" 0 1)
  expect_success(compute mesh.off --scalars quoted.csv --column "${column}")
endforeach()
expect_error("there is no column '5 pipe' among '5\" pipe, a \"b\", c, d, e'" compute mesh.off --scalars quoted.csv --column
             "5 pipe")

# one level out of the range of the field, which is no matter as long as another one is in it
expect_success(contour mesh.off --field z --level 0.5 --output one.polylines.txt)
expect_success(contour mesh.off --field z --level 0.5 --level 2 --level -7.5 --output two.polylines.txt)
expect_equal("${output}" "1 contour\n         there is no contour at the level 2\n         there is no contour at the level -7.5\n")
expect_same_file(one.polylines.txt two.polylines.txt)
expect_success(contour mesh.off --field z --level 2 --level 0.5 --output two.polylines.txt --json)
string(JSON notes GET "${output}" notes)
expect_equal("${notes}" "[ \"there is no contour at the level 2\" ]")
expect_error("there is no contour at these levels" contour mesh.off --field z --level 2 --level 3 --output none.vtp)

# faces that cannot be cut into triangles have the number that they have in the file, on a surface and on a complex
set(line_points "0 0 0\n1 0 0\n0 1 0\n2 0 1\n3 0 1\n4 0 1\n5 0 1\n6 0 1\n0 -1 0\n1 -1 0\n0 0 5\n")
set(faces "3 0 1 2\n4 0 8 9 1\n3 10 0 2\n5 3 4 5 6 7\n")
foreach(more "" "3 0 1 4\n3 0 1 5\n")
  string(REGEX MATCHALL "\n" ends "${faces}${more}")
  list(LENGTH ends number)
  file(WRITE ${FOLDER}/flat.off "OFF\n11 ${number} 0\n${line_points}${faces}${more}")
  expect_error("face 3 cannot be cut into triangles" compute flat.off --field z --triangulate)
endforeach()

# the fields that a file has, for its vertices and for its cells
file(WRITE ${FOLDER}/fields.ply "ply\nformat ascii 1.0\n${ply_points}property float heat\nelement face 1\n\
property list uchar int vertex_indices\nproperty float area\nend_header\n0 0 0 1\n1 0 0 1\n0 1 0 2\n0 0 1 3\n2 2 2 4\n\
3 0 1 2 7\n")
expect_error("there is no field 'cold': the vertices have x, y, z, heat; the faces have area" compute fields.ply --field cold)
expect_error("the field 'area' is one of the faces: the vertices have x, y, z, heat; the faces have area" compute fields.ply
             --field area)
file(WRITE ${FOLDER}/fields.vtk "${vtk}TRIANGLE_STRIPS 1 4\n3 0 1 2\nCELL_DATA 1\nSCALARS area float\nLOOKUP_TABLE default\n7\n\
POINT_DATA 5\nSCALARS heat float\nLOOKUP_TABLE default\n1 2 3 4 5\nVECTORS wind float\n1 2 3 1 2 3 1 2 3 1 2 3 1 2 3\n\
FIELD more 1\ncold 1 5 float\n1 2 3 4 5\n")
expect_error("there is no field 'rain': the vertices have heat, wind [(]3 numbers[)], cold; the cells have area" compute
             fields.vtk --field rain)
expect_error("the field 'area' is one of the cells: the vertices have heat" compute fields.vtk --field area)
expect_success(compute fields.vtk --field cold)
# colors of one number are a field of bytes, as VTK reads them: in text, they are parts of 255
file(WRITE ${FOLDER}/colors.vtk "${vtk}TRIANGLE_STRIPS 1 4\n3 0 1 2\nPOINT_DATA 5\nCOLOR_SCALARS gray 1\n0 0.5 0.25 1 0.1\n\
COLOR_SCALARS rgb%203 3\n0 0 0 0 0 0 0 0 0 0 0 0 0 0 0\n")
expect_success(repair colors.vtk --output colors.vtp)
expect_match("${output}" "rgb 3 [(]3 numbers[)] is lost")
foreach(name colors.vtk colors.vtp)
  expect_success(compute ${name} --field gray --graph colors.csv)
  file(READ ${FOLDER}/colors.nodes.csv content)
  expect_match("${content}" "^[^\n]*\n0,0,0,[^\n]*\n1,4,26,[^\n]*\n2,1,128,[^\n]*\n3,3,255,[^\n]*\n$")
endforeach()
expect_error("there is no field 'rain': the vertices have gray, rgb 3 [(]3 numbers[)]" compute colors.vtk --field rain)
file(READ ${FOLDER}/mark.vtu vtu)
foreach(section "PointData;heat" "CellData;area")
  list(GET section 0 name)
  list(GET section 1 array)
  string(REPLACE "<Points>" "<${name}><DataArray type=\"Float64\" Name=\"${array}\">1 2 3</DataArray></${name}><Points>" vtu
         "${vtu}")
endforeach()
file(WRITE ${FOLDER}/fields.vtu "${vtu}")
expect_error("the field 'area' is one of the cells: the vertices have heat; the cells have area" compute fields.vtu --field
             area)
expect_error("there is no field 'w': the vertices have none" compute mark.vtu --field w)

# messages say causes, and name no functions of C++
file(WRITE ${FOLDER}/duplicate_face.obj "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 1 4 3\nf 1 3 2\n")
file(WRITE ${FOLDER}/last_bit.off "OFF\n5 4 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n1e-17 0 0\n3 0 2 1\n3 0 1 3\n3 1 2 3\n3 4 3 2\n")
file(WRITE ${FOLDER}/unwelded.obj "v 0 0 0\nv 0 1 0\nv 1 0 0\nv 0 0 0\nv 1 0 0\nv 0 0 1\nf 1 2 3\nf 4 5 6\nf 2 1 6\nf 5 4 2\n")
file(WRITE ${FOLDER}/book.off "OFF\n5 3 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n0 -1 0\n3 0 1 2\n3 0 1 3\n3 0 1 4\n")
foreach(name duplicate_face.obj last_bit.off unwelded.obj book.off)
  foreach(command "handles" "curves;--type;pants;--borders;level" "compute;--html;page.html;--field;z")
    run(${command} ${name})
    if(error MATCHES "[(][)]|::|_soup|named parameter")
      message(SEND_ERROR "'${command} ${name}' names functions: '${error}'")
    endif()
  endforeach()
endforeach()
