# Wrong input ends in a message that says what is wrong and where.
include(${CMAKE_CURRENT_LIST_DIR}/common.cmake)

set(graph --graph graph.graphml)
file(WRITE ${FOLDER}/tetrahedron.off "${tetrahedron_off}")

# the command line
expect_error("subcommand")
expect_error("" paint tetrahedron.off)
expect_error("MESH" compute)
expect_error("" compute tetrahedron.off)
expect_error("" compute tetrahedron.off --field z --scalars scalars.txt)
expect_error("--field" compute tetrahedron.off --field w)
expect_error("" compute tetrahedron.off --field z --no-such-option)

# files that cannot be read as a mesh
file(WRITE ${FOLDER}/empty.off "")
file(WRITE ${FOLDER}/text.off "This is no mesh.\n")
file(WRITE ${FOLDER}/truncated.off "OFF\n4 4 0\n0 0 0\n1 0 0\n")
file(WRITE ${FOLDER}/no_faces_left.off "OFF\n3 2 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n")
file(WRITE ${FOLDER}/text.ply "ply\nThis is no mesh.\n")
file(WRITE ${FOLDER}/text.obj "This is no mesh.\n")
file(WRITE ${FOLDER}/text.stl "This is no mesh.\n")
file(WRITE ${FOLDER}/mesh.unknown "${tetrahedron_off}")
file(WRITE ${FOLDER}/mesh "${tetrahedron_off}")
file(WRITE ${FOLDER}/truncated.stl "solid\nfacet normal 0 0 0\nouter loop\nvertex 0 0 0\nvertex 1 0 0\n")
foreach(name missing.off empty.off text.off truncated.off no_faces_left.off text.ply text.obj text.stl truncated.stl
             mesh.unknown mesh .)
  expect_error("${name}" compute ${name} --field z ${graph})
endforeach()

# files that the readers take for another mesh
file(WRITE ${FOLDER}/one_face_more.off
     "OFF\n4 3 0\n0 0 0\n4 0 0.25\n0 4 0.5\n0 0 1\n3 0 2 1\n3 0 1 3\n3 1 2 3\n3 0 3 2\n# end\n")
expect_error("one_face_more.off: there are more faces than the 3" compute one_face_more.off --field z ${graph})
set(vertices_obj "v 0 0 0\nv 4 0 0.25\nv 0 4 0.5\n")
foreach(face "1 2 3 junk" "0 1 2" "1 2 3x" "1 2 -4" "1 2 9")
  file(WRITE ${FOLDER}/face.obj "${vertices_obj}f ${face}\nv 0 0 1\n")
  expect_error("face.obj:(4: | not a valid)" compute face.obj --field z ${graph})
endforeach()
file(WRITE ${FOLDER}/face.obj "${vertices_obj}v 0 0 1\nf 1 2 4\t3\n")
expect_error("face.obj:5: the face has been read with another number" compute face.obj --field z --triangulate ${graph})
foreach(face "1 2 3 # the face" "1/7 2/8 3/9" "1//7 2//8 3//9" "-3 -2 -1" "1 2 4")
  file(WRITE ${FOLDER}/face.obj "${vertices_obj}f ${face}\nv 0 0 1\n")
  expect_success(compute face.obj --field z)
endforeach()

# faces that are wrong
file(WRITE ${FOLDER}/out_of_range.off "OFF\n3 2 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n3 0 1 7\n")
expect_error("out_of_range.off" compute out_of_range.off --field z ${graph})
file(WRITE ${FOLDER}/repeated.off "OFF\n3 2 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n3 0 2 2\n")
expect_error("face 1 has vertex 2 at two of its corners" compute repeated.off --field z ${graph})
file(WRITE ${FOLDER}/two_corners.off "OFF\n3 2 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n2 0 1\n")
expect_error("face 1 has fewer than three vertices" compute two_corners.off --field z --triangulate ${graph})
file(WRITE ${FOLDER}/quad.off "OFF\n5 2 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n2 0 0\n3 1 4 2\n4 0 1 2 3\n")
expect_error("face 1 has 4 vertices and is not a triangle; --triangulate" compute quad.off --field x ${graph})

# surfaces that are not manifold, or not orientable
file(WRITE ${FOLDER}/three_faces_at_an_edge.off
     "OFF\n5 3 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n0 -1 0\n3 0 1 2\n3 0 1 3\n3 0 1 4\n")
expect_error("edge between the vertices 0 and 1 has 3 faces" compute three_faces_at_an_edge.off --field z ${graph})
file(WRITE ${FOLDER}/two_fans.off
     "OFF\n5 2 0\n0 0 0\n1 0 0\n1 1 0\n-1 0 0\n-1 -1 0\n3 0 1 2\n3 0 3 4\n")
expect_error("vertex 0 is not manifold" compute two_fans.off --field x ${graph})
file(WRITE ${FOLDER}/two_closed_fans.off "OFF\n7 8 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n-1 0 0\n0 -1 0\n0 0 -1\n"
     "3 0 2 1\n3 0 1 3\n3 1 2 3\n3 0 3 2\n3 0 4 5\n3 0 6 4\n3 4 6 5\n3 0 5 6\n")
expect_error("at vertex 0" compute two_closed_fans.off --field x ${graph})
file(WRITE ${FOLDER}/moebius_strip.off "OFF\n5 5 0\n0 0 0\n1 0 0\n1 1 0\n0 1 1\n0 0 2\n"
     "3 0 1 2\n3 1 2 3\n3 2 3 4\n3 3 4 0\n3 4 0 1\n")
expect_error("not orientable, at vertex [0-4]" compute moebius_strip.off --field z ${graph})

# scalars
foreach(content "0\n1\n2\n" "")
  file(WRITE ${FOLDER}/scalars.txt "${content}")
  expect_error("scalars.txt:[03]: the file ends after [03] values for 4 vertices" compute tetrahedron.off
               --scalars scalars.txt ${graph})
endforeach()
file(WRITE ${FOLDER}/scalars.txt "0\n1\n2\n3\n4\n")
expect_error("scalars.txt:5: more values than the 4 vertices" compute tetrahedron.off --scalars scalars.txt ${graph})
foreach(wrong "two" "2 2" "" "2x" "0x2" "+-2" "1,5")
  file(WRITE ${FOLDER}/scalars.txt "0\n1\n${wrong}\n3\n")
  string(REPLACE "+" "[+]" pattern "${wrong}")
  expect_error("scalars.txt:3: '${pattern}' is not a number" compute tetrahedron.off --scalars scalars.txt ${graph})
endforeach()
file(WRITE ${FOLDER}/scalars.txt "0\n1e999\n2\n3\n")
expect_error("scalars.txt:2: .* too large" compute tetrahedron.off --scalars scalars.txt ${graph})
file(WRITE ${FOLDER}/scalars.txt "0\n1\n2\nnan\n")
expect_error("vertex 3 is not a number" compute tetrahedron.off --scalars scalars.txt ${graph})
expect_error("missing.txt" compute tetrahedron.off --scalars missing.txt ${graph})
expect_error("[.]: the file cannot be read" compute tetrahedron.off --scalars . ${graph})
