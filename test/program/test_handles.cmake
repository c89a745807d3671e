# Handles and tunnels: their list, the files that are written, and what has no inside.
include(${CMAKE_CURRENT_LIST_DIR}/common.cmake)

configure_file(${genus_3} ${FOLDER}/surface.off COPYONLY)
expect_success(handles surface.off --json --loops loops.polylines.txt)
string(JSON number LENGTH "${output}" loops)
expect_equal("${number}" "6")
set(kinds)
foreach(i RANGE 5)
  string(JSON kind GET "${output}" loops ${i} kind)
  string(JSON partner GET "${output}" loops ${i} partner)
  string(JSON partner_of_partner GET "${output}" loops ${partner} partner)
  expect_equal("${partner_of_partner}" "${i}")
  foreach(key length persistence area component)
    string(JSON type TYPE "${output}" loops ${i} ${key})
    expect_match("${type}" "NUMBER|NULL")
  endforeach()
  list(APPEND kinds ${kind})
endforeach()
expect_equal("${kinds}" "handle;tunnel;handle;tunnel;handle;tunnel")

# closed polylines, one for each loop
file(STRINGS ${FOLDER}/loops.polylines.txt polylines)
list(LENGTH polylines number_of_polylines)
expect_equal("${number_of_polylines}" "6")
foreach(polyline IN LISTS polylines)
  expect_match("${polyline}" "^[0-9]+ ([^ ]+ [^ ]+ [^ ]+) .* ([^ ]+ [^ ]+ [^ ]+)$")
  string(REGEX REPLACE "^[0-9]+ ([^ ]+ [^ ]+ [^ ]+) .* ([^ ]+ [^ ]+ [^ ]+)$" "\\1;\\2" ends "${polyline}")
  list(GET ends 0 first)
  list(GET ends 1 last)
  expect_equal("${first}" "${last}")
endforeach()

expect_success(handles surface.off --field x --no-shortening --loops loops.obj)
expect_match("${output}" "surface  3 handles, 3 tunnels, 0 holes, 0 loops without inside")
file(STRINGS ${FOLDER}/loops.obj groups REGEX "^g ")
expect_equal("${groups}" "g handle_0;g tunnel_1;g handle_2;g tunnel_3;g handle_4;g tunnel_5")
expect_success(handles surface.off --loops loops.vtp)
file(STRINGS ${FOLDER}/loops.vtp piece REGEX "^<Piece ")
expect_match("${piece}" "NumberOfLines=\"6\"")
expect_error("loops" handles surface.off --loops loops.csv)

# a triangle, which has a hole
file(WRITE ${FOLDER}/triangle.off "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n")
expect_success(handles triangle.off --json)
string(JSON kind GET "${output}" loops 0 kind)
expect_equal("${kind}" "hole")
string(JSON type TYPE "${output}" loops 0 partner)
expect_equal("${type}" "NULL")

# a tetrahedron has no handle
file(WRITE ${FOLDER}/tetrahedron.off "OFF\n4 4 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 3\n3 1 2 3\n3 2 0 3\n")
expect_success(handles tetrahedron.off)
expect_match("${output}" "0 handles, 0 tunnels, 0 holes, 0 loops")

# three triangles at one edge
file(WRITE ${FOLDER}/book.off "OFF\n5 3 0\n0 0 0\n0 0 1\n1 0 0\n0 1 0\n-1 0 0\n3 0 1 2\n3 0 1 3\n3 0 1 4\n")
expect_error("no oriented manifold surface" handles book.off)
