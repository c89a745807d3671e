# Persistence pairs, the diagram, and simplified graphs.
include(${CMAKE_CURRENT_LIST_DIR}/common.cmake)

# A strip of triangles: minima of 0 and 1.5, maxima of 5 and 7, and a saddle of 2.25 where all four meet.
file(WRITE ${FOLDER}/strip.off "OFF\n8 6 0\n0 0 0\n0 1 0\n1 0 0\n1 1 0\n2 0 0\n2 1 0\n3 0 0\n3 1 0\n"
     "3 0 2 1\n3 1 2 3\n3 2 4 3\n3 3 4 5\n3 4 6 5\n3 5 6 7\n")
file(WRITE ${FOLDER}/scalars.txt "0\n5\n2\n2.5\n2.25\n1.5\n3\n7\n")
set(strip strip.off --scalars scalars.txt)

# the pairs of the given graph, whatever is removed
expect_success(compute ${strip} --pairs pairs.csv)
file(READ ${FOLDER}/pairs.csv pairs)
expect_equal("${pairs}" "kind,lower_vertex,upper_vertex,lower_value,upper_value,persistence
minimum-maximum,0,7,0,7,7
minimum-saddle,5,4,1.5,2.25,0.75
saddle-maximum,4,1,2.25,5,2.75
")
expect_success(compute ${strip} --pairs pairs_of_simplified.csv --simplify 1)
expect_same_file(pairs.csv pairs_of_simplified.csv)
expect_success(compute ${strip} --pairs pairs.pers)
file(STRINGS ${FOLDER}/pairs.pers pairs REGEX "^[^#]")
expect_equal("${pairs}" "0 0 7;0 1.5 2.25;1 5 2.25")

# round trip of values
file(WRITE ${FOLDER}/tetrahedron.off "${tetrahedron_off}")
file(WRITE ${FOLDER}/thirds.txt "0.1\n0.30000000000000004\n0.5\n1e-300\n")
expect_success(compute tetrahedron.off --scalars thirds.txt --pairs thirds.csv)
file(STRINGS ${FOLDER}/thirds.csv pairs REGEX "^minimum")
expect_match("${pairs}" "^minimum-maximum,3,2,1[.]?0*e-300,0.5,0.5$")

# a loop, and a node without arcs
set(torus "OFF\n8 14 0\n0 0 0\n1 0 1\n2 1 2\n1 2 3\n3 1 4\n2 3 5\n4 4 6\n9 9 9\n")
string(APPEND torus "${torus_faces}")
file(WRITE ${FOLDER}/torus.off "${torus}")
expect_success(compute torus.off --field z --pairs torus.csv --diagram torus.svg)
file(READ ${FOLDER}/torus.csv pairs)
expect_match("${pairs}" "\nminimum-maximum,0,6,0,6,6\n")
expect_match("${pairs}" "\nloop,[0-9],[0-9],[0-9],[0-9],[0-9]\n")
expect_match("${pairs}" "\nminimum-maximum,7,7,9,9,0\n")
string(REGEX MATCH "\nloop,[0-9]+,[0-9]+,([0-9]+),([0-9]+)," loop "${pairs}")
set(interval_of_loop "1 ${CMAKE_MATCH_2} ${CMAKE_MATCH_1}")
expect_success(compute torus.off --field z --pairs torus.pers)
file(STRINGS ${FOLDER}/torus.pers pairs REGEX "^[^#]")
expect_equal("${pairs}" "0 0 6;${interval_of_loop};0 9 9")

# the diagram: as many points as pairs and kinds in the legend, and a band below a threshold
file(READ ${FOLDER}/torus.svg svg)
expect_match("${svg}" "^<svg .*</svg>\n$")
expect_match("${svg}" "minimum, maximum [(]2[)]")
expect_match("${svg}" "loop [(]1[)]")
string(REGEX MATCHALL "<path d=" points "${svg}")
list(LENGTH points number_of_points)
expect_equal(${number_of_points} 3)
expect_success(compute ${strip} --diagram strip.svg --simplify 20%)
file(READ ${FOLDER}/strip.svg svg)
expect_match("${svg}" "#eeeeee")
file(WRITE ${FOLDER}/point.off "OFF\n0 0 0\n")
expect_success(compute point.off --field z --diagram empty.svg --pairs empty.csv --simplify 5% --json)

# the simplified graph, by a threshold in units of the field, in percent, and by the number of leaves
expect_json(5 nodes ARGUMENTS ${strip} --simplify 1)
foreach(row "0=5" "0.75=5" "0.76=4" "1=4" "20%=4" "2.76=2" "100%=2")
  string(REPLACE "=" ";" row "${row}")
  list(GET row 0 threshold)
  list(GET row 1 nodes)
  expect_json(${nodes} simplified nodes ARGUMENTS ${strip} --simplify ${threshold})
endforeach()
expect_json(4 simplified nodes ARGUMENTS ${strip} --leaves 3)
expect_json(2 simplified nodes ARGUMENTS ${strip} --leaves 2)
expect_json(4 simplified nodes ARGUMENTS ${strip} --leaves 3 --simplify 100%)
expect_json("" simplified ARGUMENTS ${strip})
expect_json(1 simplified arcs ARGUMENTS ${strip} --leaves 2)
expect_json("" simplified threshold ARGUMENTS ${strip} --leaves 2)
expect_json(1 simplified loops ARGUMENTS torus.off --field z --simplify 100%)
expect_json(0 simplified loops ARGUMENTS torus.off --field z --simplify 100% --cancel-loops)

# the thresholds that matter, in the gaps of 0.75, 2.75, and 7: there is no noise, so that all stays
foreach(row "0=5=4" "1=4=3" "2=2=2")
  string(REPLACE "=" ";" row "${row}")
  list(GET row 0 number)
  list(GET row 1 nodes)
  list(GET row 2 leaves)
  expect_json(${nodes} thresholds ${number} nodes ARGUMENTS ${strip})
  expect_json(${leaves} thresholds ${number} leaves ARGUMENTS ${strip})
endforeach()
expect_json(5 simplified nodes ARGUMENTS ${strip} --simplify auto)
expect_json("" suggested_threshold ARGUMENTS tetrahedron.off --field z)
expect_json("0.0" simplified threshold ARGUMENTS tetrahedron.off --field z --simplify auto)
expect_success(compute ${strip})
expect_match("${output}" "\n +--simplify 0[.]0725 gives 5 nodes, 4 leaves, 0 loops, and so does auto\n")
expect_success(contour ${strip} --simplify auto --level 2 --output auto.polylines.txt)
expect_equal("${output}" "2 contours\n")
# the handles stay
expect_json(3 simplified loops ARGUMENTS ${genus_3} --field y --simplify auto)
expect_success(curves ${genus_3} --field y --type pants --simplify auto)
expect_equal("${output}" "6 curves, 4 patches\n")

# files of the simplified graph: each vertex in it, and the numbers of arcs are those of contours
expect_success(compute ${strip} --simplify 1 --graph graph.graphml --vertex-arcs arcs.txt)
expect_match("${output}" "5 nodes, 4 arcs, 0 loops\n +simplified: 4 nodes, 3 arcs, 0 loops")
file(STRINGS ${FOLDER}/arcs.txt places)
list(LENGTH places number_of_places)
expect_equal(${number_of_places} 8)
file(READ ${FOLDER}/graph.graphml graph)
string(REGEX MATCHALL "<edge " edges "${graph}")
list(LENGTH edges number_of_edges)
expect_equal(${number_of_edges} 3)
expect_success(contour ${strip} --simplify 1 --arc 2 --t 0.5 --output contour.polylines.txt)
expect_error("there is no arc 3: the graph has 3" contour ${strip} --simplify 1 --arc 3 --t 0.5
             --output none.polylines.txt)
expect_success(contour ${strip} --level 2 --output level.polylines.txt)
expect_equal("${output}" "2 contours\n")
expect_success(contour ${strip} --level 2 --simplify 1 --output level.polylines.txt)
expect_equal("${output}" "1 contour\n")

# a field that has the simplified graph, also for curves
expect_json("0.75" simplified largest_change ARGUMENTS ${strip} --simplify 1 --simplified-scalars simplified.txt --ties contract)
expect_json(4 nodes ARGUMENTS strip.off --scalars simplified.txt --ties contract)
expect_json("" simplified largest_change ARGUMENTS ${strip} --simplify 1)
expect_success(compute ${genus_3} --field y --leaves 2 --simplified-scalars simplified.txt)
expect_success(curves ${genus_3} --field y --type pants --leaves 2)
expect_equal("${output}" "6 curves, 4 patches\n")
set(figure ${CMAKE_CURRENT_LIST_DIR}/../../examples/Reeb_graph/data/figure.off --field y --type branch)
expect_success(curves ${figure})
expect_equal("${output}" "6 curves, 7 patches\n")
expect_success(curves ${figure} --simplify 30%)
expect_equal("${output}" "0 curves, 1 patch\n")
# a sphere whose field needs contracted ties: what is left of its branch has no height, and gives no curve
file(WRITE ${FOLDER}/sphere.off "OFF\n6 8 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n1 1 1\n-1 0 0\n3 0 5 3\n3 1 4 2\n3 4 1 3\n"
     "3 3 2 4\n3 2 3 5\n3 1 2 5\n3 3 1 0\n3 5 0 1\n")
file(WRITE ${FOLDER}/sphere.txt "0\n3\n3\n3\n1\n3.0000000000000004\n")
set(sphere curves sphere.off --scalars sphere.txt --type branch --simplify 2.5)
run(${sphere})
expect_equal("${exit_code} ${output}" "0 0 curves, 1 patch\n")
expect_match("${error}" "^contracted ties of the simplified field: [^\n]*\n$")
run(${sphere} --json)
expect_match("${output}" "\"curves\": 0,.*\"ties_contracted\": true,")
# vertices tied with a saddle are told apart
file(WRITE ${FOLDER}/tied.txt "3\n4\n3\n4\n0\n3\n1\n5\n")
expect_success(compute strip.off --scalars tied.txt --simplify 2 --simplified-scalars simplified.txt)
expect_json(2 nodes ARGUMENTS strip.off --scalars simplified.txt)
expect_json(OFF simplified ties_contracted ARGUMENTS strip.off --scalars tied.txt --simplify 2 --simplified-scalars
            simplified.txt)
# and contracted if there is no number between them and the next one, as the report says
file(WRITE ${FOLDER}/close.txt "3\n3.0000000000000004\n3\n4\n0\n3\n1\n5\n")
set(close strip.off --scalars close.txt --simplify 2 --simplified-scalars)
expect_json(ON simplified ties_contracted ARGUMENTS ${close} contracted.txt)
expect_success(compute ${close} contracted.txt)
expect_match("${output}" "largest change of the field 1, which needs --ties contract\n")
expect_success(compute ${close} simplified.txt --ties contract)
expect_same_file(contracted.txt simplified.txt)
expect_json("1.0" simplified largest_change ARGUMENTS strip.off --scalars close.txt --simplify 2 --ties contract
            --simplified-scalars simplified.txt)
expect_error("--simplified-scalars goes with" compute ${strip} --simplified-scalars none.txt)
expect_error("--cancel-loops does not go with a field" compute ${strip} --simplify 1 --cancel-loops
             --simplified-scalars none.txt)
expect_error("--cancel-loops does not go with a field" curves ${genus_3} --field y --type pants --simplify 1
             --cancel-loops)
expect_error("two outputs have this name" compute ${strip} --simplify 1 --pairs same.csv --simplified-scalars same.csv)

# what is wrong
foreach(threshold "-1" "-5%" "nan" "nan%" "inf" "5x" "%" "5%%" "100.5%" "1e999")
  expect_error("the threshold '${threshold}'" compute ${strip} --simplify "${threshold}" --graph none.dot)
endforeach()
expect_error("--leaves" compute ${strip} --leaves -1)
expect_error("--cancel-loops goes with --simplify" compute ${strip} --cancel-loops)
expect_error("ends in .csv or .pers" compute ${strip} --pairs none.txt)
expect_error("ends in .svg" compute ${strip} --diagram none.png)
expect_error("two outputs have this name" compute ${strip} --pairs same.csv --graph other.dot --vertex-arcs same.csv)
file(WRITE ${FOLDER}/infinite.txt "-inf\n0\n1\ninf\n")
expect_error("field of finite range" compute tetrahedron.off --scalars infinite.txt --simplify 5%)
expect_success(compute tetrahedron.off --scalars infinite.txt --json --pairs infinite.csv --diagram infinite.svg)
