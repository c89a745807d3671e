# The report as JSON, on surfaces whose counts are known.
include(${CMAKE_CURRENT_LIST_DIR}/common.cmake)

file(WRITE ${FOLDER}/tetrahedron.off "${tetrahedron_off}")
set(tetrahedron ARGUMENTS tetrahedron.off --field z)
foreach(row "vertices=4" "edges=6" "faces=4" "components=1" "border_loops=0" "euler_characteristic=2" "genus=0"
            "minima=1" "saddles={}" "maxima=1" "isolated=0" "border_saddles=0" "nodes=2" "arcs=1" "loops=0"
            "hidden_handles=0")
  string(REPLACE "=" ";" row "${row}")
  list(GET row 0 key)
  list(GET row 1 value)
  expect_json("${value}" ${key} ${tetrahedron})
endforeach()

# the table of the arcs, by default of a graph of few: the tetrahedron has the height 1
foreach(row "arc=0" "from=0" "to=1" "lower_value=0.0" "upper_value=1.0" "persistence=1.0" "length=1.0" "vertices=2")
  string(REPLACE "=" ";" row "${row}")
  list(GET row 0 key)
  list(GET row 1 value)
  expect_json("${value}" arc_table 0 ${key} ${tetrahedron})
endforeach()
expect_success(compute tetrahedron.off --field z --json) # the mean over the faces, of the middle of three corners each
string(JSON mean GET "${output}" arc_table 0 mean_value)
expect_match("${mean}" "^0[.]425895")
expect_success(compute tetrahedron.off --field z)
expect_match("${output}" "\n +arc +from +to +from value +to value +persistence +length +area +vertices\n +0 +0 +1 +0 +1 +1 +1 +[0-9.]+ +2\n$")
expect_success(compute tetrahedron.off --field z --no-table)
if(output MATCHES "from value")
  message(SEND_ERROR "'${output}' has a table")
endif()
expect_json("" arc_table ARGUMENTS tetrahedron.off --field z --no-table)

# the times and the memory
expect_success(compute tetrahedron.off --field z --json --graph graph.dot)
foreach(key read compute flatten classify arcs write output)
  string(JSON seconds GET "${output}" seconds ${key})
  expect_match("${seconds}" "^[0-9]")
endforeach()
string(JSON memory GET "${output}" peak_memory_bytes)
if(memory LESS 1000000)
  message(SEND_ERROR "a peak memory of ${memory} bytes")
endif()

# the torus of seven vertices, which has a loop
set(torus "OFF\n7 14 0\n0 0 0\n1 0 1\n2 1 2\n1 2 3\n3 1 4\n2 3 5\n4 4 6\n")
string(APPEND torus "${torus_faces}")
file(WRITE ${FOLDER}/torus.off "${torus}")
expect_json(1 genus ARGUMENTS torus.off --field z)
expect_json(1 loops ARGUMENTS torus.off --field z)

# saddles are counted by multiplicity: a monkey saddle in the middle of a disk
file(WRITE ${FOLDER}/monkey_saddle.off "OFF\n7 6 0\n0 0 0\n2 0 1\n1 2 -1\n-1 2 2\n-2 0 -2\n-1 -2 3\n1 -2 -3\n"
     "3 0 1 2\n3 0 2 3\n3 0 3 4\n3 0 4 5\n3 0 5 6\n3 0 6 1\n")
expect_json(1 saddles 2 ARGUMENTS monkey_saddle.off --field z)
expect_json(3 minima ARGUMENTS monkey_saddle.off --field z)
expect_json(3 maxima ARGUMENTS monkey_saddle.off --field z)
expect_json(1 border_loops ARGUMENTS monkey_saddle.off --field z)
expect_json(0 genus ARGUMENTS monkey_saddle.off --field z)

# several components have no genus
file(WRITE ${FOLDER}/two_components.off
     "OFF\n7 2 0\n0 0 0\n1 0 1\n0 1 2\n5 0 0\n6 0 1\n5 1 2\n9 9 9\n3 0 1 2\n3 3 4 5\n")
expect_json("" genus ARGUMENTS two_components.off --field z)
expect_json(3 components ARGUMENTS two_components.off --field z)
expect_json(0 loops ARGUMENTS two_components.off --field z)
expect_json(5 nodes ARGUMENTS two_components.off --field z)

# the same for a person
expect_success(compute monkey_saddle.off --field z)
expect_match("${output}" "7 vertices, 12 edges, 6 faces")
expect_match("${output}" "3 minima, 1 saddle [(]1 of multiplicity 2[)], 3 maxima")
expect_match("${output}" "7 nodes, 6 arcs, 0 loops")

# The help fits into a window, has its options in groups, and ends with an example; shells complete the same options.
foreach(command "" compute compare contour curves field handles repair skeleton demo)
  expect_success(${command} --help)
  string(REPLACE ";" "," lines "${output}")
  string(REPLACE "\n" ";" lines "${lines}")
  foreach(line IN LISTS lines)
    string(LENGTH "${line}" length)
    if(length GREATER 100)
      message(SEND_ERROR "the help of ${command} has ${length} characters in the line '${line}'")
    endif()
  endforeach()
  if(command MATCHES "compute|contour|curves")
    expect_match("${output}" "Input:.*Field:.*Graph:.*Simplification:.*Output:.*Fields, for --field:.*Example:\n  reeb_graph ")
  endif()
  string(REGEX MATCHALL "Example:" examples "${output}")
  expect_equal("${examples}" "Example:")
  expect_match("${output}" "Example:\n  reeb_graph ${command}")
  string(REGEX MATCHALL "\n  [-a-z,]*--[a-z0-9-]+" options_of_${command} "${output}")
endforeach()
# Each shell completes all options of each command; how it says what it offers, for $0, the program, and $1, the command.
set(offered_by_bash "source <(\"$0\" --completion bash); COMP_WORDS=(reeb_graph $1 --); COMP_CWORD=2
                     _reeb_graph reeb_graph -- $1; printf '%s\\n' \"\${COMPREPLY[@]}\"")
set(offered_by_zsh "compinit() { }; compdef() { }; compadd() { shift; print -l -- $@ }
                    source <(\"$0\" --completion zsh); words=(reeb_graph $1 --); CURRENT=3; PREFIX=--; _reeb_graph")
set(offered_by_fish "$argv[1] --completion fish | source; complete -C \"reeb_graph $argv[2] --\" | string replace -r '\\t.*' ''")
# The same of the values of an option, $2, and how it says them.
set(values_of_bash "source <(\"$0\" --completion bash); COMP_WORDS=(reeb_graph $1 $2 ''); COMP_CWORD=3
                    _reeb_graph reeb_graph '' $2; printf '%s\\n' \"\${COMPREPLY[@]}\"")
set(values_of_zsh "compinit() { }; compdef() { }; compadd() { shift; print -l -- $@ }; _files() { print files }
                   source <(\"$0\" --completion zsh); words=(reeb_graph $1 $2 ''); CURRENT=4; PREFIX=; _reeb_graph")
set(values_of_fish "$argv[1] --completion fish | source
                    complete -C \"reeb_graph $argv[2] $argv[3] \" | string replace -r '\\t.*' ''")
foreach(shell bash zsh fish)
  expect_success(--completion ${shell})
  expect_match("${output}" "longest-loop")
  find_program(SHELL_${shell} ${shell})
  if(NOT SHELL_${shell})
    message(STATUS "SKIPPED: ${shell}, whose completion is tested, is not installed")
    continue()
  endif()
  foreach(command compute compare contour curves field handles repair skeleton demo)
    # fish writes into HOME, and says where it cannot.
    execute_process(COMMAND ${CMAKE_COMMAND} -E env HOME=${CMAKE_CURRENT_BINARY_DIR}
                            ${SHELL_${shell}} -c "${offered_by_${shell}}" ${PROGRAM} ${command}
                    OUTPUT_VARIABLE words ERROR_VARIABLE error)
    if(NOT shell STREQUAL "fish")
      expect_equal("${error}" "")
    endif()
    foreach(option IN LISTS options_of_${command})
      string(REGEX REPLACE ".*(--[a-z0-9-]+)$" "\\1" option "${option}")
      if(NOT "\n${words}" MATCHES "\n${option}\n")
        message(SEND_ERROR "${shell} does not complete ${command} ${option}: '${words}'")
      endif()
    endforeach()
  endforeach()
  foreach(item "compute --ties perturb contract" "compute --field x harmonic-between-borders" "compute --up -z"
               "skeleton --from thickest tips" "skeleton --root tip" "handles --format vtu" "curves --type pants levels")
    string(REPLACE " " ";" item "${item}")
    list(POP_FRONT item command option)
    execute_process(COMMAND ${CMAKE_COMMAND} -E env HOME=${CMAKE_CURRENT_BINARY_DIR}
                            ${SHELL_${shell}} -c "${values_of_${shell}}" ${PROGRAM} ${command} ${option}
                    OUTPUT_VARIABLE words ERROR_VARIABLE error)
    foreach(value IN LISTS item)
      if(NOT "\n${words}" MATCHES "\n${value}\n")
        message(SEND_ERROR "${shell} does not complete ${command} ${option} ${value}: '${words}' ${error}")
      endif()
    endforeach()
  endforeach()
endforeach()

# The pages of man have all that --help has, and troff has nothing to complain about.
find_program(GROFF groff)
execute_process(COMMAND ${CMAKE_COMMAND} -D PROGRAM=${PROGRAM} -D FOLDER=${CMAKE_CURRENT_BINARY_DIR}/pages
                        -P ${CMAKE_CURRENT_LIST_DIR}/../../cmake/write_manual_pages.cmake COMMAND_ERROR_IS_FATAL ANY)
foreach(command compute compare contour curves field handles repair skeleton demo)
  set(file ${CMAKE_CURRENT_BINARY_DIR}/pages/man1/reeb_graph-${command}.1)
  file(READ ${file} page)
  string(REPLACE "\\-" "-" page "${page}")
  expect_match("${page}" "\\.SH NAME\nreeb_graph-${command} - [A-Z][^\n]*\n\\.SH DESCRIPTION\n.*Example:\n  reeb_graph ${command}")
  foreach(option IN LISTS options_of_${command})
    expect_match("${page}" "${option}[ \n]")
  endforeach()
  if(GROFF)
    execute_process(COMMAND ${GROFF} -man -Tutf8 -ww ${file} OUTPUT_QUIET ERROR_VARIABLE error)
    expect_equal("${error}" "")
  endif()
endforeach()
file(READ ${CMAKE_CURRENT_BINARY_DIR}/pages/man1/reeb_graph.1 page)
expect_match("${page}" "SH NAME\nreeb_graph .*Subcommands:.*skeleton ")
expect_success(--version)
expect_match("${output}" "^reeb_graph [0-9]+\\.[0-9]+\\.[0-9]+ \\(CGAL [0-9.]+.*, [A-Za-z]+ [0-9.]+\\)\n$")
