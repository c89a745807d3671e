# Cutting along levels and to disks: files, columns, notes, and what is refused. check_cuts.py compares with the input.
include(${CMAKE_CURRENT_LIST_DIR}/common.cmake)

configure_file(${genus_3} ${FOLDER}/surface.off COPYONLY)
expect_success(curves surface.off --field z --type levels --level 0.1 --level -0.05 --level 0.1 --level 9
               --curves curves.json --mesh-out bands.ply --patches pieces.txt --cut-mesh cut.off)
expect_match("${output}" "^[0-9]+ curves, [0-9]+ patches\n.*the level 9 meets nothing: the field is from .* to .*\n")
expect_match("${output}" " 3 levels, [0-9]+ triangles added, [0-9]+ slivers?\n")
foreach(format vtp obj polylines.txt)
  expect_success(curves surface.off --field z --type levels --levels 4 --curves curves.${format} --cut-open --json)
  expect_match("${output}" "\"levels\": 4,")
endforeach()
expect_success(curves surface.off --field z --type levels --spacing 0.125 --curves spaced.json --mesh-out spaced.vtp)

expect_success(curves surface.off --type disks --vertex-map map.txt --cut-mesh disks.off --curves c.polylines.txt
               --patches p.txt)
expect_match("${output}" "^[0-9]+ curves, 1 patch\n$")
expect_success(curves surface.off --type disks --cut-mesh disks.ply)
expect_success(curves surface.off --type disks --cut-mesh disks.obj)
expect_success(curves surface.off --type disks --field x --mesh-out disks_with_field.ply --graph g.graphml)
expect_json(1 euler_characteristic ARGUMENTS disks.off --field z)
expect_json(1 border_loops ARGUMENTS disks.off --field z)
expect_json(1 border_loops ARGUMENTS disks.obj --field z)

expect_error("one of --level, --levels, and --spacing is needed" curves surface.off --field z --type levels)
expect_error("one of --level, --levels, and --spacing is needed" curves surface.off --field z --type levels --level 0
             --levels 3)
expect_error("go with the type levels only" curves surface.off --field z --type pants --level 0)
expect_error("--borders does not go with" curves surface.off --field z --type levels --level 0 --borders level)
expect_error("--borders does not go with" curves surface.off --type disks --borders make-level)
expect_error("--vertex-map goes with" curves surface.off --field z --type levels --level 0 --vertex-map map2.txt)
expect_error("has to be a positive number" curves surface.off --field z --type levels --spacing 0)
expect_error("more than ten million levels" curves surface.off --field z --type levels --spacing 1e-9)

if(NOT PYTHON)
  message("SKIPPED: without Python, the files are not checked")
  return()
endif()
execute_process(COMMAND ${PYTHON} ${CMAKE_CURRENT_LIST_DIR}/check_cuts.py ${FOLDER}
                RESULT_VARIABLE result ERROR_VARIABLE faults)
if(NOT result EQUAL 0)
  message(FATAL_ERROR "${faults}")
endif()
