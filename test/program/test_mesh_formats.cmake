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

# standard input is a mesh or a field, whose format is named; the mesh is read again where its fields are kept
file(WRITE ${FOLDER}/mesh.ts "GOCAD TSurf 1\nTFACE\nVRTX 1 0 0 0\nVRTX 2 1 0 0\nVRTX 3 0 1 0.25\nVRTX 4 0 0 1\nVRTX 5 3 1 0.5\n\
TRGL 1 2 3\nTRGL 1 4 2\nTRGL 1 3 4\nTRGL 2 5 3\nEND\n")
file(WRITE ${FOLDER}/mesh.mesh "MeshVersionFormatted 2\nDimension 3\nVertices 5\n0 0 0 0\n1 0 0 0\n0 1 0.25 0\n0 0 1 0\n3 1 0.5 0\n\
Triangles 4\n1 2 3 0\n1 4 2 0\n1 3 4 0\n2 5 3 0\nEnd\n")
file(WRITE ${FOLDER}/mesh.vtk "# vtk DataFile Version 3.0\nt\nASCII\nDATASET POLYDATA\nPOINTS 5 float\n0 0 0\n1 0 0\n0 1 0.25\n0 0 1\n\
3 1 0.5\nPOLYGONS 4 16\n3 0 1 2\n3 0 3 1\n3 0 2 3\n3 1 4 2\n")
expect_success(repair mesh.off --output mesh.vtp)
file(WRITE ${FOLDER}/mesh.vtu "<VTKFile type=\"UnstructuredGrid\"><UnstructuredGrid><Piece NumberOfPoints=\"5\" NumberOfCells=\"4\"><Points>\
<DataArray type=\"Float64\" NumberOfComponents=\"3\">0 0 0 1 0 0 0 1 0.25 0 0 1 3 1 0.5</DataArray></Points><Cells>\
<DataArray type=\"Int32\" Name=\"connectivity\">0 1 2 0 3 1 0 2 3 1 4 2</DataArray><DataArray type=\"Int32\" Name=\"offsets\">\
3 6 9 12</DataArray><DataArray type=\"UInt8\" Name=\"types\">5 5 5 5</DataArray></Cells></Piece></UnstructuredGrid></VTKFile>")
foreach(format off obj ply stl ts mesh vtk vtu vtp)
  run_on_input(mesh.${format} compute - --format ${format} --field z --graph piped.graphml)
  expect_equal("${exit_code} ${error}" "0 ")
  expect_same_file(piped.graphml off.graphml)
  run_on_input(mesh.${format} repair - --format .${format} --output piped.off)
  expect_equal("${exit_code} ${error}" "0 ")
  expect_success(repair mesh.${format} --output again.off)
  expect_same_file(piped.off again.off)
endforeach()
run_on_input(mesh.off compute - --format OFF --field z --graph -)
expect_match("${exit_code} ${output}" "^0 .*<graphml")
file(WRITE ${FOLDER}/z.txt "0\n0\n0.25\n1\n0.5\n")
file(WRITE ${FOLDER}/z.csv "height,z\n9,0\n9,0\n9,0.25\n9,1\n9,0.5\n")
foreach(options "txt" "txt;--format;txt" "csv;--format;csv;--column;z")
  list(POP_FRONT options ending)
  run_on_input(z.${ending} compute mesh.off --scalars - ${options} --graph piped.graphml)
  expect_equal("${exit_code} ${error}" "0 ")
  expect_same_file(piped.graphml off.graphml)
endforeach()
expect_success(field mesh.off --type height --output z.npy)
run_on_input(z.npy compute mesh.off --scalars - --format npy --graph piped.graphml)
expect_equal("${exit_code} ${error}" "0 ")
expect_same_file(piped.graphml off.graphml)
foreach(wrong "--format is needed: off, obj, ply, stl, ts, mesh, vtk, vtu, or vtp|-;--field;z" "'glb' is not a format|-;--format;glb;--field;z"
        "cannot both|-;--format;off;--scalars;-" "--format goes with standard input|mesh.off;--format;off;--field;z"
        "standard input:1: the file does not begin as a PLY file|-;--format;ply;--field;z"
        "the extension of a mesh file is|-;--format;csv;--field;z")
  string(REGEX MATCH "^(.*)[|](.*)$" ignored "${wrong}")
  set(pattern "${CMAKE_MATCH_1}")
  set(options ${CMAKE_MATCH_2})
  run_on_input(mesh.off compute ${options})
  expect_match("${exit_code} ${error}" "^1 reeb_graph: error: .*${pattern}")
endforeach()
run_on_input(mesh.off compute - --format off --field z --mesh-out mesh.off)
expect_match("${exit_code} ${error}" "^1 .*this output would replace an input")

# polygons of any form: n - 2 triangles, which use all corners, whatever a diagonal meets
file(WRITE ${FOLDER}/pentagon.obj "v -1 0 1\nv 1 0 1\nv 1 0 -1\nv -1 0 -1\nv 0 1 -1\nf 1 2 3 4 5\n")
file(WRITE ${FOLDER}/bow.obj "v 0 0 0\nv 1 1 0\nv 1 0 0\nv 0 1 0\nv 2 2 1\nf 1 2 3 4\nf 2 1 5\n")
file(WRITE ${FOLDER}/star.obj "v 0 1 0\nv 0.6 -0.8 0\nv -1 0.3 0\nv 1 0.3 0\nv -0.6 -0.8 0\nf 1 2 3 4 5\n")
file(WRITE ${FOLDER}/sides.obj "v 0 0 0\nv 2 0 0\nv 3 1 0\nv 1 2 0\nv 0 1 0\nf 1 2 3 4 5\nf 5 4 3 2 1\n")
foreach(case "pentagon 3 5 1" "bow 3 5 1" "star 3 5 1" "sides 6 5 2")
  separate_arguments(case)
  list(POP_FRONT case name faces vertices euler)
  expect_success(repair ${name}.obj --triangulate --output ${name}.off)
  foreach(mesh "${name}.obj --triangulate" "${name}.off")
    separate_arguments(mesh)
    expect_json(${faces} faces ARGUMENTS ${mesh} --field z)
    expect_json(${vertices} vertices ARGUMENTS ${mesh} --field z)
    expect_json(1 components ARGUMENTS ${mesh} --field z)
    expect_json(${euler} euler_characteristic ARGUMENTS ${mesh} --field z)
    expect_json(0 input isolated_points ARGUMENTS ${mesh} --field z)
  endforeach()
endforeach()
