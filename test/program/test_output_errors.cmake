# Output that cannot be written is an error, and what was there before stays as it was.
include(${CMAKE_CURRENT_LIST_DIR}/common.cmake)

file(WRITE ${FOLDER}/tetrahedron.off "${tetrahedron_off}")
file(MAKE_DIRECTORY ${FOLDER}/folder.dot)
expect_error("[.]graphml, [.]dot, .*or [.]csv" compute tetrahedron.off --field z --graph graph.txt)
expect_error("[.]graphml, [.]dot, .*or [.]csv" compute missing.off --field z --graph graph)
expect_error("missing/graph.dot: the file cannot be written" compute tetrahedron.off --field z
             --graph missing/graph.dot)
expect_error("folder.dot: the file cannot be written" compute tetrahedron.off --field z --graph folder.dot)

file(WRITE ${FOLDER}/graph.dot "from before")
expect_error("missing.txt" compute tetrahedron.off --scalars missing.txt --graph graph.dot)
file(READ ${FOLDER}/graph.dot content)
expect_equal("${content}" "from before")
expect_success(compute tetrahedron.off --field z --graph graph.dot)
file(READ ${FOLDER}/graph.dot content)
expect_match("${content}" "^digraph")

file(WRITE ${FOLDER}/file "")
expect_error("" demo --out file/folder)

if(EXISTS /dev/full)
  execute_process(COMMAND ${PROGRAM} compute ${FOLDER}/tetrahedron.off --field z OUTPUT_FILE /dev/full
                  RESULT_VARIABLE exit_code ERROR_VARIABLE error)
  expect_equal("${exit_code}" "1")
  expect_match("${error}" "^reeb_graph: error: standard output cannot be written")
endif()
