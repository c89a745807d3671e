# Shapes compared: distances, arcs that are partners, the matrix, the page, and what cannot be compared.
include(${CMAKE_CURRENT_LIST_DIR}/common.cmake)

set(data ${CMAKE_CURRENT_LIST_DIR}/../../examples/Reeb_graph/data)
file(WRITE ${FOLDER}/tetrahedron.off "${tetrahedron_off}")
configure_file(${data}/double_torus.off ${FOLDER}/double_torus.off COPYONLY)
configure_file(${genus_3} ${FOLDER}/genus_3.off COPYONLY)

function(expect_json expected)
  string(JSON value GET "${output}" ${ARGN})
  expect_equal("${value}" "${expected}")
endfunction()

# A shape and itself.
expect_success(compare double_torus.off double_torus.off --field x --json)
expect_json(0.0 distance)
expect_json(double_torus.off shapes 1 name)
string(JSON arcs GET "${output}" shapes 0 arcs)
string(JSON pairs LENGTH "${output}" pairs)
expect_equal("${pairs}" "${arcs}")
expect_json("[]" without_partner 0)

# Shapes of another genus, both ways round, in any unit.
expect_success(compare double_torus.off genus_3.off --field x --simplify auto --json --output two.csv)
string(JSON distance GET "${output}" distance)
string(JSON loops GET "${output}" distance_by_kind loop)
if(NOT loops GREATER 0.05)
  message(SEND_ERROR "genus 2 and 3 are told apart by ${loops} only")
endif()
string(JSON pairs GET "${output}" pairs)
string(JSON number LENGTH "${output}" pairs)
file(STRINGS ${FOLDER}/two.csv lines)
list(GET lines 0 header)
expect_equal("${header}" "shape,double_torus.off,genus_3.off")
expect_match("${lines}" ";double_torus.off,0,[0-9.e+-]+;genus_3.off,[0-9.e+-]+,0$")
expect_success(compare genus_3.off double_torus.off --field x --simplify auto --json)
expect_json("${distance}" distance)
string(JSON turned LENGTH "${output}" pairs)
expect_equal("${turned}" "${number}")

# Distances from tips that are chosen: of two, it is said whether they lie on partners.
expect_success(compare double_torus.off genus_3.off --field geodesic --simplify auto --json)
expect_json(ON sources_on_partners)
expect_match("${output}" "sources are the tips that are most alike")
string(JSON first GET "${output}" shapes 0 fixed_values vertices 0 vertex)
string(JSON second GET "${output}" shapes 1 fixed_values vertices 0 vertex)
expect_success(compare double_torus.off genus_3.off --field geodesic --simplify auto --json --source ${first}
               --source ${second})
string(REGEX REPLACE ".*\"matrix\": ([^a-z]*).*" "\\1" matrix "${output}")
expect_success(compare double_torus.off genus_3.off --field geodesic --source 0,5)
expect_match("${output}" "shape    double_torus.off: .*geodesic: 0 at vertices 0, 5\nshape    genus_3.off: .*distance ")

# Two fields on one mesh, from a file for each: they differ by 0.5 at most.
file(WRITE ${FOLDER}/f.txt "0\n0\n0\n1\n")
file(WRITE ${FOLDER}/g.txt "0\n0\n0\n1.5\n")
expect_success(compare tetrahedron.off tetrahedron.off --scalars f.txt --scalars g.txt --json)
expect_json(0.5 distance)
expect_json(0.5 distance_by_kind minimum-maximum)

# Several shapes: a matrix, and no arcs.
file(MAKE_DIRECTORY ${FOLDER}/other)
configure_file(${data}/double_torus.off ${FOLDER}/other/double_torus.off COPYONLY)
expect_success(compare double_torus.off genus_3.off other/double_torus.off --field x --output many.csv --json)
expect_json("" distance)
expect_json("" pairs)
expect_json(0.0 matrix 0 2)
file(STRINGS ${FOLDER}/many.csv lines)
list(LENGTH lines number)
expect_equal("${number}" "4")
list(GET lines 0 header)
expect_equal("${header}" "shape,double_torus.off,genus_3.off,other/double_torus.off")
expect_success(compare double_torus.off genus_3.off tetrahedron.off --field z)
expect_match("${output}" "distances\n         double_torus.off: 0 ")

# The page has both shapes, and the pairs.
run(compare double_torus.off genus_3.off --field x --simplify auto --html page.html)
if(exit_code STREQUAL "0")
  file(READ ${FOLDER}/page.html page)
  expect_match("${page}" "<title>double_torus.off</title>")
  expect_match("${page}" "\"other\":{.*\"title\":\"genus_3.off\".*\"partners\":\\[\\[0,")
else()
  expect_match("${error}" "without the page")
endif()

# What is a copy, a mesh with borders, and components.
file(WRITE ${FOLDER}/fin.off
     "OFF\n5 5 0\n0 0 0\n4 0 0.25\n0 4 0.5\n0 0 1\n9 9 0.4\n3 0 2 1\n3 0 1 3\n3 1 2 3\n3 0 3 2\n3 1 2 4\n")
expect_success(compare fin.off tetrahedron.off --field z --json)
expect_json(0.0 distance) # the fin has no persistence
expect_match("${output}" "\"command\": \"reeb_graph repair fin.off --all")
expect_error("fin.off.*oriented manifold surface" compare fin.off tetrahedron.off --field z --strict)
file(WRITE ${FOLDER}/sheet.off "OFF\n4 2 0\n0 0 0\n1 0 1\n0 1 2\n1 1 3\n3 0 1 2\n3 1 3 2\n")
file(WRITE ${FOLDER}/sheets.off
     "OFF\n8 4 0\n0 0 0\n1 0 1\n0 1 2\n1 1 3\n5 0 0\n6 0 1\n5 1 2\n6 1 3\n3 0 1 2\n3 1 3 2\n3 4 5 6\n3 5 7 6\n")
expect_success(compare sheet.off sheets.off --field z --json)
expect_json(1.5 distance) # half of the height of the second one
string(JSON pairs LENGTH "${output}" pairs)
expect_equal("${pairs}" "1")
string(JSON alone LENGTH "${output}" without_partner 1)
expect_equal("${alone}" "1")
expect_success(compare sheet.off sheets.off --field geodesic --json)
expect_match("${output}" "may stand for different places")

# Errors leave no file.
expect_error("two meshes or more" compare double_torus.off --field x)
expect_error("missing.off" compare double_torus.off missing.off --field x --output out.csv)
expect_error("a field is needed" compare double_torus.off genus_3.off)
expect_error("--source is given once.*there are 3 meshes, and it is given 2 times" compare tetrahedron.off tetrahedron.off
             tetrahedron.off --field geodesic --source 1 --source 2)
expect_error("not a whole number" compare tetrahedron.off tetrahedron.off --field geodesic --source x)
expect_error("no vertex 99" compare tetrahedron.off double_torus.off --field geodesic --source 99)
expect_error("must not be negative" compare tetrahedron.off tetrahedron.off --field x --price-alone -1)
expect_error("--html shows two meshes, not 3" compare tetrahedron.off tetrahedron.off tetrahedron.off --field x --html
             page3.html)
expect_error("ends in .csv" compare tetrahedron.off tetrahedron.off --field x --output out.txt)
configure_file(${FOLDER}/f.txt ${FOLDER}/f.csv COPYONLY)
expect_error("replace an input" compare tetrahedron.off tetrahedron.off --scalars f.csv --output f.csv)
file(WRITE ${FOLDER}/empty.off "OFF\n0 0 0\n")
expect_error("empty.off.*no faces" compare tetrahedron.off empty.off --field x)
expect_error("only one input" compare - - --format off --field x)

# Noise on a grid: more than 300 arcs.
set(points)
set(faces)
foreach(i RANGE 49)
  foreach(j RANGE 49)
    math(EXPR noise "(${i} * 7919 + ${j} * 104729 + ${i} * ${j} * 31) % 1009")
    string(APPEND points "${i} ${j} ${noise}\n")
    if(i LESS 49 AND j LESS 49)
      math(EXPR a "50 * ${i} + ${j}")
      math(EXPR b "${a} + 50")
      math(EXPR c "${a} + 51")
      math(EXPR d "${a} + 1")
      string(APPEND faces "3 ${a} ${b} ${c}\n3 ${a} ${c} ${d}\n")
    endif()
  endforeach()
endforeach()
file(WRITE ${FOLDER}/noise.off "OFF\n2500 4802 0\n${points}${faces}")
expect_error("300 at most: simplify it first, as by --simplify auto" compare noise.off noise.off --field z)
expect_success(compare noise.off noise.off --field z --leaves 4 --json)
expect_json(0.0 distance)
expect_success(compare noise.off noise.off noise.off --field z --json) # without arcs that are matched
expect_json(0.0 matrix 1 2)
