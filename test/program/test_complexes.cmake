# Meshes that are no oriented manifold surfaces: any triangles, and tetrahedra.
include(${CMAKE_CURRENT_LIST_DIR}/common.cmake)

# three pages at one edge, with a page above and two below: a tree
file(WRITE ${FOLDER}/book.off "OFF\n5 3 0\n0 0 0\n1 0 0.5\n0 1 2\n0 0 -1\n0 -1 -2\n3 0 1 2\n3 0 1 3\n3 0 1 4\n")
set(book ARGUMENTS book.off --field z)
expect_json(4 nodes ${book})
expect_json(3 arcs ${book})
expect_json(0 loops ${book})
expect_json(1 euler_characteristic ${book})
expect_json(1 complex edges_of_many_faces ${book})
expect_json(3 complex first_edge_of_many_faces faces ${book})
expect_json(1 complex first_edge_of_many_faces vertices 1 ${book})
expect_json(0 complex vertices_of_several_fans ${book})
expect_json("" genus ${book})
expect_success(compute book.off --field z)
expect_match("${output}" "1 edge with more than two triangles, the first one, of the vertices 0 and 1, with 3\n")
file(WRITE ${FOLDER}/surface.off "${tetrahedron_off}")
expect_json("" complex ARGUMENTS surface.off --field z)

# two closed fans, and a Moebius strip
file(WRITE ${FOLDER}/two_closed_fans.off "OFF\n7 8 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n-1 0 0\n0 -1 0\n0 0 -1\n"
     "3 0 2 1\n3 0 1 3\n3 1 2 3\n3 0 3 2\n3 0 4 5\n3 0 6 4\n3 4 6 5\n3 0 5 6\n")
file(WRITE ${FOLDER}/two_fans.off "OFF\n5 2 0\n0 0 0\n1 0 0\n1 1 0\n-1 0 0\n-1 -1 0\n3 0 1 2\n3 0 3 4\n")
foreach(name two_closed_fans two_fans)
  expect_json(1 complex vertices_of_several_fans ARGUMENTS ${name}.off --field x)
  expect_json(0 complex first_vertex_of_several_fans vertex ARGUMENTS ${name}.off --field x)
  expect_json(2 complex first_vertex_of_several_fans fans ARGUMENTS ${name}.off --field x)
  expect_json("" complex first_edge_without_orientation ARGUMENTS ${name}.off --field x)
endforeach()
expect_success(compute two_fans.off --field x)
expect_match("${output}" "1 vertex whose triangles form several fans, the first one, vertex 0, with 2\n")
file(WRITE ${FOLDER}/moebius_strip.off "OFF\n5 5 0\n0 0 0\n1 0 0\n1 1 0\n0 1 1\n0 0 2\n"
     "3 0 1 2\n3 1 2 3\n3 2 3 4\n3 3 4 0\n3 4 0 1\n")
expect_success(compute moebius_strip.off --field z --json)
string(JSON value GET "${output}" complex first_edge_without_orientation 0)
expect_match("${value}" "^[0-4]$")
expect_success(compute moebius_strip.off --field z)
expect_match("${output}" "\n         not orientable, which shows at the edge of the vertices [0-4] and [0-4]\n")

# faces that repeat earlier ones, in either orientation, are counted once; both sides of a triangle are a surface
set(points "0 0 0\n1 0 1\n0 1 2\n1 1 3\n")
set(faces "3 0 1 2\n3 0 3 1\n3 1 3 2\n3 2 3 0\n")
file(WRITE ${FOLDER}/duplicate.off "OFF\n4 5 0\n${points}${faces}3 2 3 0\n")
expect_json(4 faces ARGUMENTS duplicate.off --field z)
expect_json(1 input repeated_faces ARGUMENTS duplicate.off --field z)
expect_json("" complex ARGUMENTS duplicate.off --field z)
file(WRITE ${FOLDER}/turned_duplicate.off "OFF\n4 5 0\n${points}${faces}3 0 3 2\n")
expect_json(4 faces ARGUMENTS turned_duplicate.off --field z)
expect_json(1 complex duplicate_faces ARGUMENTS turned_duplicate.off --field z)
expect_json(4 complex first_duplicate_face ARGUMENTS turned_duplicate.off --field z)
file(WRITE ${FOLDER}/one_face.off "OFF\n4 5 0\n${points}3 0 1 2\n3 1 2 3\n3 1 2 0\n3 2 0 1\n3 3 2 1\n")
expect_json(2 faces ARGUMENTS one_face.off --field z)
expect_json(2 input repeated_faces ARGUMENTS one_face.off --field z)
expect_json(2 input first_repeated_face ARGUMENTS one_face.off --field z)
expect_json(1 complex duplicate_faces ARGUMENTS one_face.off --field z)
expect_json(2 complex first_duplicate_face ARGUMENTS one_face.off --field z)
expect_success(compute one_face.off --field z)
expect_match("${output}" "\n         1 face that repeats an earlier one, the first one, face 2\n")
file(WRITE ${FOLDER}/twice.off "OFF\n4 2 0\n${points}3 0 1 2\n3 2 0 1\n")
expect_json(1 faces ARGUMENTS twice.off --field z)
expect_json(1 input repeated_faces ARGUMENTS twice.off --field z)
file(WRITE ${FOLDER}/both_sides.off "OFF\n4 2 0\n${points}3 0 1 2\n3 0 2 1\n")
expect_json(2 faces ARGUMENTS both_sides.off --field z)
expect_json("" complex ARGUMENTS both_sides.off --field z)
expect_json(0 complex duplicate_faces ${book})
expect_json("" complex first_duplicate_face ${book})
file(WRITE ${FOLDER}/quads.off "OFF\n4 2 0\n${points}4 0 1 3 2\n4 3 1 0 2\n")
file(WRITE ${FOLDER}/same_quads.off "OFF\n4 2 0\n${points}4 0 1 3 2\n4 3 2 0 1\n")
expect_json("" complex ARGUMENTS quads.off --field z --triangulate)
expect_json(1 input first_repeated_face ARGUMENTS same_quads.off --field z --triangulate)

# faces that are no triangles
file(WRITE ${FOLDER}/polygons.off "OFF\n8 3 0\n0 0 0\n1 0 0.1\n0 1 2\n1 1 2.5\n0 -1 -1\n1 -1 -1.5\n0 0 3\n1 0 3.5\n"
     "4 0 1 3 2\n4 0 1 5 4\n4 0 1 7 6\n")
expect_json(6 faces ARGUMENTS polygons.off --field z --triangulate)
expect_json(1 complex edges_of_many_faces ARGUMENTS polygons.off --field z --triangulate)
expect_json(3 arcs ARGUMENTS polygons.off --field z --triangulate)

# the graph is the same in all files
foreach(file graph.graphml graph.dot graph.svg graph.vtp graph.obj graph.polylines.txt graph.json graph.csv)
  expect_success(compute book.off --field z --graph ${file})
endforeach()
file(READ ${FOLDER}/graph.json content)
string(JSON value GET "${content}" edges 0 chain 0 0)
expect_equal("${value}" 4)
string(JSON value GET "${content}" nodes 0 vertex)
expect_equal("${value}" 4)
file(STRINGS ${FOLDER}/graph.arcs.csv lines)
list(LENGTH lines number)
expect_equal("${number}" 4)
expect_success(compute book.off --field z --pairs pairs.csv --diagram diagram.svg --vertex-arcs arcs.txt)
file(READ ${FOLDER}/arcs.txt content)
expect_equal("${content}" "node 2\narc 2\nnode 3\nnode 1\nnode 0\n")
expect_success(compute book.off --field z --leaves 2 --vertex-arcs arcs.txt)
file(READ ${FOLDER}/arcs.txt content)
expect_match("${content}" "^arc 0\narc 0\nnode 1\n[^\n]*\nnode 0\n$")
foreach(method critical-sets contour-trees)
  expect_success(compute two_closed_fans.off --field x --method ${method} --graph ${method}.graphml)
endforeach()
expect_same_file(critical-sets.graphml contour-trees.graphml)

# arcs in space, in each manner, and their measures
foreach(manner centroids on-surface straight)
  expect_success(compute book.off --field z --graph ${manner}.json --embedding ${manner} --json)
  string(JSON value GET "${output}" embedding)
  expect_equal("${value}" ${manner})
  file(READ ${FOLDER}/${manner}.json content)
  string(JSON number LENGTH "${content}" edges 2 polyline)
  string(JSON values LENGTH "${content}" edges 2 values)
  expect_equal("${number}" "${values}")
  set(length_of_${manner} ${number})
endforeach()
expect_equal(${length_of_centroids} 14)
expect_equal(${length_of_straight} 2)
expect_success(compute book.off --field z --graph book.obj)
expect_success(compute book.off --field z --graph straight.obj --embedding straight)
expect_same_file(book.obj straight.obj)
file(STRINGS ${FOLDER}/graph.arcs.csv header LIMIT_COUNT 1)
expect_equal("${header}" "arc,source,target,lower_value,upper_value")
expect_success(compute book.off --field z --table --graph graph.csv)
file(STRINGS ${FOLDER}/graph.arcs.csv header LIMIT_COUNT 1)
expect_match("${header}" ",persistence,length,area,vertices,mean_value")
expect_match("${output}" "\n  arc   from     to  .* length            area  vertices\n    0 ")
expect_success(compute book.off --field z)
expect_match("${output}" "\n  arc   from     to  ")
expect_json("" arc_table ARGUMENTS book.off --field z --no-table)

# the triangles with the results: the same mesh again
expect_success(compute book.off --field z --mesh-out book.ply --graph book.graphml)
expect_success(compute book.ply --field scalar --graph again.graphml --json)
expect_same_file(book.graphml again.graphml)
string(JSON value GET "${output}" faces)
expect_equal("${value}" 3)
expect_success(compute book.off --field z --mesh-out book.vtp)

# contours with branch points
expect_success(contour book.off --field z --level 0.25 --output contour.polylines.txt)
expect_equal("${output}" "1 contour\n")
file(STRINGS ${FOLDER}/contour.polylines.txt lines)
list(LENGTH lines number)
expect_equal("${number}" 3)
expect_success(contour book.off --field z --arc 2 --t 0.5 --output contour.polylines.txt)

# distances along edges
expect_success(field book.off --type geodesic --source 2 --output distances.txt)
file(STRINGS ${FOLDER}/distances.txt lines)
list(GET lines 2 value)
expect_equal("${value}" 0)
list(GET lines 0 value)
expect_match("${value}" "^2.23606")
expect_success(field book.off --type height --direction 0,0,2 --output heights.txt)
expect_success(compute book.off --field geodesic)
file(WRITE ${FOLDER}/apart.off "OFF\n6 3 0\n0 0 0\n1 0 0.5\n0 1 2\n0 0 -1\n0 -1 -2\n9 9 9\n3 0 1 2\n3 0 1 3\n3 0 1 4\n")
expect_success(compute apart.off --field geodesic)
expect_match("${output}" "\n *geodesic: 0 at vertices [0-9], 5\n")
expect_error("component 1, that of vertex 5, has no vertex whose value is given" compute apart.off --field geodesic --source 0)

# tetrahedra: a ring of three around an edge is a ball; two of them that have an edge in common
set(points "Vertices\n5\n0 0 -1 0\n0 0 1 0\n1 0 0.25 0\n-1 1 0.5 0\n-1 -1 0.125 0\n")
set(begin "MeshVersionFormatted 2\nDimension 3\n${points}")
file(WRITE ${FOLDER}/ball.mesh "${begin}Tetrahedra\n3\n1 2 3 4 0\n1 2 4 5 0\n1 2 5 3 0\nEnd\n")
set(ball ARGUMENTS ball.mesh --field z)
expect_json(3 complex tetrahedra ${ball})
expect_json(9 faces ${ball})
expect_json(1 euler_characteristic ${ball})
expect_json(1 arcs ${ball})
foreach(places edges_of_many_faces vertices_of_several_fans)
  expect_json("" complex ${places} ${ball})
endforeach()
expect_success(compute ball.mesh --field z)
expect_match("${output}" "^complex  5 vertices, 10 edges, 9 triangles, 3 tetrahedra\n         1 component, Euler char")
expect_success(contour ball.mesh --field z --level 0.75 --output isosurface.off)
expect_success(compute isosurface.off --field x)
expect_match("${output}" "^surface  4 vertices, 6 edges, 3 faces\n         1 component, 1 border loop")

# arcs in tetrahedra have volumes: that of the ball is 4/3
expect_success(compute ball.mesh --field z --graph ball.vtp --embedding centroids --table --json)
string(JSON value GET "${output}" arc_table 0 volume)
expect_match("${value}" "^1[.]333333")
string(JSON type ERROR_VARIABLE error TYPE "${output}" arc_table 0 area)
expect_match("${error}" "area")
expect_success(compute ball.mesh --field z --table)
expect_match("${output}" "volume  vertices\n    0 ")
file(READ ${FOLDER}/ball.vtp content)
expect_match("${content}" "Name=\"volume\"")

# a file may end without End
file(WRITE ${FOLDER}/open.mesh "${begin}Tetrahedra\n3\n1 2 3 4 0\n1 2 4 5 0\n1 2 5 3 0")
expect_json(3 complex tetrahedra ARGUMENTS open.mesh --field z)

# faces of tetrahedra that are listed, too, change nothing; other triangles and edges belong to the complex
file(WRITE ${FOLDER}/ball_with_faces.mesh "${begin}Triangles\n1\n2 1 3 7\nEdges\n1\n2 1 7\n"
     "Tetrahedra\n3\n1 2 3 4 0\n1 2 4 5 0\n1 2 5 3 0\nEnd\n")
file(WRITE ${FOLDER}/mixed.mesh "${begin}Tetrahedra\n1\n1 2 3 4 0\nTriangles\n1\n1 2 5 0\nEnd\n")
file(WRITE ${FOLDER}/edges.mesh "${begin}Edges\n4\n1 3 0\n3 2 0\n2 4 0\n4 1 0\nEnd\n")
foreach(name ball ball_with_faces)
  expect_success(compute ${name}.mesh --field z --graph ${name}.graphml)
  expect_success(contour ${name}.mesh --field z --level 0.75 --output ${name}.off)
endforeach()
expect_same_file(ball.graphml ball_with_faces.graphml)
expect_same_file(ball.off ball_with_faces.off)
expect_json(5 faces ARGUMENTS mixed.mesh --field z)
expect_json(1 arcs ARGUMENTS mixed.mesh --field z)
foreach(file mixed.off mixed.polylines.txt)
  expect_error("faces of no tetrahedron" contour mixed.mesh --field z --level 0 --output ${file})
endforeach()
expect_json(1 loops ARGUMENTS edges.mesh --field z)
expect_json(4 complex edges_without_faces ARGUMENTS edges.mesh --field z)
expect_json(2 components ARGUMENTS edges.mesh --field z)
expect_json(0 complex first_edge_without_faces 0 ARGUMENTS edges.mesh --field z)
expect_json(2 complex first_edge_without_faces 1 ARGUMENTS edges.mesh --field z)
expect_success(compute edges.mesh --field z)
expect_match("${output}" "\n         4 edges on no triangle, the first one, of the vertices 0 and 2\n")

# fields of the points of VTK files
file(WRITE ${FOLDER}/field.vtk "# vtk DataFile Version 3.0\na field\nASCII\nDATASET UNSTRUCTURED_GRID\nPOINTS 4 float\n"
     "0 0 0 1 0 0 0 1 0 0 0 1\nCELLS 2 8\n4 0 1 2 3\n2 0 1\nCELL_TYPES 2\n10\n3\nPOINT_DATA 4\n"
     "SCALARS mass double\nLOOKUP_TABLE default\n4 7 5 6\n")
expect_success(field field.vtk --type height --output heights.txt)
expect_success(compute field.vtk --field mass --vertex-arcs arcs.txt)
file(READ ${FOLDER}/arcs.txt content)
expect_equal("${content}" "node 0\nnode 1\narc 0\narc 0\n")

# raw bytes of a VTU file that look like a tag are none
file(WRITE ${FOLDER}/raw.vtu "<VTKFile type=\"UnstructuredGrid\"><UnstructuredGrid>"
     "<Piece NumberOfPoints=\"3\" NumberOfCells=\"1\"><Points><DataArray type=\"Float64\" NumberOfComponents=\"3\">"
     "0 0 0 1 0 1 0 1 2</DataArray></Points><Cells><DataArray Name=\"connectivity\" type=\"Int32\">0 1 2</DataArray>"
     "<DataArray Name=\"offsets\" type=\"Int32\">3</DataArray><DataArray Name=\"types\" type=\"Int32\">5</DataArray>"
     "</Cells></Piece></UnstructuredGrid><AppendedData encoding=\"raw\">_<a b=c>d</AppendedData></VTKFile>")
expect_json(1 arcs ARGUMENTS raw.vtu --field z)

# brackets in attributes of XML end no tag
file(WRITE ${FOLDER}/brackets.vtu "<VTKFile type=\"UnstructuredGrid\" title='1 > \"0\"'>\n"
     "<Piece NumberOfPoints=\"4\" NumberOfCells=\"1\">\n<PointData>\n"
     "<DataArray type=\"Float64\" Name=\"mass > 1\" format=\"ascii\">4 7 5 6</DataArray>\n</PointData>\n<Points>\n"
     "<DataArray type=\"Float32\" NumberOfComponents=\"3\">0 0 0 1 0 0 0 1 0 0 0 1</DataArray>\n</Points>\n<Cells>\n"
     "<DataArray type=\"Int32\" Name=\"connectivity\">0 1 2 3</DataArray>\n"
     "<DataArray type=\"Int32\" Name=\"offsets\">4</DataArray>\n"
     "<DataArray type=\"UInt8\" Name=\"types\">10</DataArray>\n</Cells>\n</Piece>\n</VTKFile>\n")
expect_success(compute brackets.vtu --field "mass > 1" --vertex-arcs arcs.txt)
file(READ ${FOLDER}/arcs.txt content)
expect_equal("${content}" "node 0\nnode 1\narc 0\narc 0\n")
