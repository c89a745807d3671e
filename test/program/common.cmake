# What the tests of the program share. PROGRAM is the program, FOLDER an empty folder for this test.
cmake_minimum_required(VERSION 3.21)

file(REMOVE_RECURSE ${FOLDER})
file(MAKE_DIRECTORY ${FOLDER})

# A tetrahedron of height 1, whose vertices are numbered in the order in which its faces name them.
set(tetrahedron_off "OFF\n4 4 0\n0 0 0\n4 0 0.25\n0 4 0.5\n0 0 1\n3 0 2 1\n3 0 1 3\n3 1 2 3\n3 0 3 2\n")

# The faces of the torus of seven vertices in OFF, two in each row.
foreach(i RANGE 6)
  math(EXPR a "(${i} + 1) % 7")
  math(EXPR b "(${i} + 2) % 7")
  math(EXPR c "(${i} + 3) % 7")
  string(APPEND torus_faces "3 ${i} ${a} ${c}\n3 ${i} ${c} ${b}\n")
endforeach()

# A surface of genus 3.
set(genus_3 ${CMAKE_CURRENT_LIST_DIR}/../../examples/Reeb_graph/data/genus_3.off)

# Runs the program in FOLDER; sets exit_code, output, and error.
function(run)
  execute_process(COMMAND ${PROGRAM} ${ARGN} WORKING_DIRECTORY ${FOLDER}
                  RESULT_VARIABLE exit_code OUTPUT_VARIABLE output ERROR_VARIABLE error)
  set(exit_code ${exit_code} PARENT_SCOPE)
  set(output "${output}" PARENT_SCOPE)
  set(error "${error}" PARENT_SCOPE)
endfunction()

# The same with a file as standard input.
function(run_on_input file)
  execute_process(COMMAND ${PROGRAM} ${ARGN} WORKING_DIRECTORY ${FOLDER} INPUT_FILE ${FOLDER}/${file}
                  RESULT_VARIABLE exit_code OUTPUT_VARIABLE output ERROR_VARIABLE error)
  set(exit_code ${exit_code} PARENT_SCOPE)
  set(output "${output}" PARENT_SCOPE)
  set(error "${error}" PARENT_SCOPE)
endfunction()

macro(expect_success)
  run(${ARGN})
  if(NOT exit_code STREQUAL "0" OR NOT error STREQUAL "")
    message(SEND_ERROR "'${ARGN}' ended with '${exit_code}' and the message '${error}'")
  endif()
endmacro()

# Expects a message that matches the pattern, nothing printed, and not one file more than before.
function(expect_error pattern)
  file(GLOB files_before ${FOLDER}/* ${FOLDER}/.*)
  run(${ARGN})
  file(GLOB files_after ${FOLDER}/* ${FOLDER}/.*)
  if(NOT exit_code STREQUAL "1")
    message(SEND_ERROR "'${ARGN}' ended with '${exit_code}' instead of 1")
  endif()
  if(NOT error MATCHES "(^|\n)reeb_graph: error: .*${pattern}")
    message(SEND_ERROR "'${ARGN}' gave the message '${error}' instead of one that matches '${pattern}'")
  endif()
  if(NOT output STREQUAL "")
    message(SEND_ERROR "'${ARGN}' failed, and printed '${output}'")
  endif()
  if(NOT files_before STREQUAL files_after)
    message(SEND_ERROR "'${ARGN}' failed, and left a file: '${files_after}'")
  endif()
endfunction()

function(expect_equal actual expected)
  if(NOT actual STREQUAL expected)
    message(SEND_ERROR "'${actual}' instead of '${expected}'")
  endif()
endfunction()

function(expect_match text pattern)
  if(NOT text MATCHES "${pattern}")
    message(SEND_ERROR "'${text}' does not match '${pattern}'")
  endif()
endfunction()

function(expect_same_file a b)
  file(READ ${FOLDER}/${a} content_a)
  file(READ ${FOLDER}/${b} content_b)
  if(content_a STREQUAL "" OR NOT content_a STREQUAL content_b)
    message(SEND_ERROR "${a} and ${b} differ, or are empty")
  endif()
endfunction()

# Expects that the program prints one JSON object with the value at the keys: expect_json(value keys... ARGUMENTS ...)
function(expect_json expected)
  cmake_parse_arguments(PARSE_ARGV 1 json "" "" "ARGUMENTS")
  expect_success(compute --json ${json_ARGUMENTS})
  string(JSON value ERROR_VARIABLE json_error GET "${output}" ${json_UNPARSED_ARGUMENTS})
  if(json_error)
    message(SEND_ERROR "'${json_ARGUMENTS}': ${json_error} in '${output}'")
  endif()
  expect_equal("${value}" "${expected}")
endfunction()
