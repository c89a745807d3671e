# Fields that are computed: written to a file, or used at once.
include(${CMAKE_CURRENT_LIST_DIR}/common.cmake)

file(WRITE ${FOLDER}/tetrahedron.off "${tetrahedron_off}")

# the torus of seven vertices, on a twisted curve
set(torus "OFF\n7 14 0\n")
foreach(i RANGE 6)
  math(EXPR square "${i} * ${i}")
  math(EXPR cube "${i} * ${square}")
  string(APPEND torus "${i} ${square} ${cube}\n")
endforeach()
string(APPEND torus "${torus_faces}")
file(WRITE ${FOLDER}/torus.off "${torus}")

# what `field` writes, `compute` reads
foreach(options "harmonic" "harmonic;--min;2;--max;5" "poisson" "poisson;--source;3" "geodesic" "geodesic;--source;1,4"
                "unit-gradient" "height" "height;--direction;-1,0.5,2")
  list(JOIN options "_" name)
  expect_success(field torus.off --type ${options} --output ${name}.txt)
  expect_match("${output}" "7 values from [^ ]* to ")
  expect_success(compute torus.off --scalars ${name}.txt --graph read.graphml)
  expect_success(compute torus.off --field ${options} --graph used.graphml)
  expect_same_file(read.graphml used.graphml)
endforeach()
expect_success(field torus.off --type unit-gradient --scalars height.txt --output unit.txt)
expect_success(compute torus.off --field unit-gradient --scalars height.txt --graph used.graphml)
expect_success(compute torus.off --scalars unit.txt --graph read.graphml)
expect_same_file(read.graphml used.graphml)
expect_success(contour torus.off --field harmonic --level 0.5 --output level.polylines.txt)

# values
file(READ ${FOLDER}/harmonic_--min_2_--max_5.txt content)
string(REGEX MATCHALL "[^\n]+" values "${content}")
list(GET values 2 lowest)
list(GET values 5 highest)
expect_equal("${lowest};${highest}" "0;1")
file(READ ${FOLDER}/height_--direction_-1,0.5,2.txt content)
expect_match("${content}" "^0\n1.5\n16\n") # -i + i^2 / 2 + 2 i^3

# A harmonic field has two extrema; each handle is a loop, or hidden in a saddle of higher multiplicity.
expect_json(1 minima ARGUMENTS torus.off --field harmonic)
expect_json(1 maxima ARGUMENTS torus.off --field harmonic)
foreach(i RANGE 1 6)
  expect_success(compute torus.off --field harmonic --min 0 --max ${i} --json)
  string(JSON loops GET "${output}" loops)
  string(JSON hidden_handles GET "${output}" hidden_handles)
  math(EXPR sum "${loops} + ${hidden_handles}")
  expect_equal("${sum}" "1")
endforeach()

# two components: a pair of extrema on each, unless they are given
file(WRITE ${FOLDER}/two_components.off
     "OFF\n7 2 0\n0 0 0\n1 0 1\n0 1 2\n5 0 0\n6 0 1\n5 1 2\n9 9 9\n3 0 1 2\n3 3 4 5\n")
expect_json(2 minima ARGUMENTS two_components.off --field harmonic)
expect_json(2 maxima ARGUMENTS two_components.off --field harmonic)
expect_json("" hidden_handles ARGUMENTS two_components.off --field harmonic)
expect_error("component 1, that of vertex 3," compute two_components.off --field harmonic --min 0 --max 1)
expect_error("component 1, that of vertex 3," field two_components.off --type geodesic --source 0 --output out.txt)

# wrong options
expect_error("--type" field torus.off --output out.txt)
expect_error("--output" field torus.off --type harmonic)
expect_error("--type" field torus.off --type x --output out.txt)
expect_error("--scalars" field torus.off --type harmonic --scalars height.txt --output out.txt)
expect_error("--min and --max go together" field torus.off --type harmonic --min 1 --output out.txt)
expect_error("--min and --max go with" field torus.off --type poisson --min 1 --max 2 --output out.txt)
expect_error("--source goes with" field torus.off --type harmonic --source 1 --output out.txt)
expect_error("--direction goes with" field torus.off --type harmonic --direction 1,0,0 --output out.txt)
expect_error("--direction" field torus.off --type height --direction 1,0 --output out.txt)
expect_error("direction is zero" field torus.off --type height --direction 0,0,0 --output out.txt)
expect_error("no vertex 7: the mesh has 7" field torus.off --type harmonic --min 1 --max 7 --output out.txt)
expect_error("no vertex 9: the mesh has 7" compute torus.off --field geodesic --source 9)
expect_error("fixed to two different values" compute torus.off --field harmonic --min 3 --max 3)

# faces without area
file(WRITE ${FOLDER}/flat.off "OFF\n4 2 0\n0 0 0\n1 0 0\n2 0 0\n1 1 0\n3 0 1 2\n3 2 3 0\n")
foreach(options "harmonic" "harmonic;--weights;cotangent" "poisson" "geodesic" "unit-gradient")
  expect_success(field flat.off --type ${options} --output out.txt)
endforeach()
expect_success(field flat.off --type harmonic --weights uniform --min 0 --max 2 --output out.txt)
file(STRINGS ${FOLDER}/out.txt values)
expect_match("${values}" "^0;0[.][0-9]+;1;0[.][0-9]+$")
expect_error("--weights goes with" field flat.off --type poisson --weights uniform --output out.txt)
expect_error("--weights" field flat.off --type harmonic --weights other --output out.txt)
