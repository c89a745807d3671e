# Where output goes: into files, which keep their mode and their links, to standard output, and into pipes.
include(${CMAKE_CURRENT_LIST_DIR}/common.cmake)

file(WRITE ${FOLDER}/tetrahedron.off "${tetrahedron_off}")
set(mesh tetrahedron.off --field z)

function(expect_file_of_graph name)
  file(READ ${FOLDER}/${name} content)
  expect_match("${content}" "^digraph")
endfunction()

# the mode: that of the file that is replaced, and of a new one what the user has chosen
function(expect_mode name mode)
  execute_process(COMMAND stat -c %a ${FOLDER}/${name} OUTPUT_VARIABLE output OUTPUT_STRIP_TRAILING_WHITESPACE)
  expect_equal("${output}" "${mode}")
endfunction()

foreach(mode 600 640 755 444)
  file(WRITE ${FOLDER}/${mode}.dot "")
  execute_process(COMMAND chmod ${mode} ${FOLDER}/${mode}.dot)
  expect_success(compute ${mesh} --graph ${mode}.dot)
  expect_file_of_graph(${mode}.dot)
  expect_mode(${mode}.dot ${mode})
endforeach()
set(program ${PROGRAM})
set(PROGRAM sh -c "umask 027 && exec \"$@\"" sh ${program})
expect_success(compute ${mesh} --graph umask.dot)
expect_mode(umask.dot 640)
set(PROGRAM ${program})

# links: to a file, to none yet, and to another link, from other folders
file(MAKE_DIRECTORY ${FOLDER}/folder)
file(WRITE ${FOLDER}/folder/old.dot "")
foreach(link "link.dot;folder/old.dot" "dangling.dot;folder/new.dot" "folder/chain.dot;../second.dot"
             "second.dot;folder/newer.dot" "absolute.dot;${FOLDER}/folder/newest.dot")
  list(GET link 0 name)
  list(GET link 1 target)
  file(CREATE_LINK ${target} ${FOLDER}/${name} SYMBOLIC)
endforeach()
foreach(name link.dot dangling.dot folder/chain.dot absolute.dot)
  expect_success(compute ${mesh} --graph ${name})
  if(NOT IS_SYMLINK ${FOLDER}/${name})
    message(SEND_ERROR "${name} is no link any more")
  endif()
endforeach()
foreach(name old.dot new.dot newer.dot newest.dot)
  expect_file_of_graph(folder/${name})
  if(IS_SYMLINK ${FOLDER}/folder/${name})
    message(SEND_ERROR "${name} is a link")
  endif()
endforeach()

# as long a name as there can be
string(REPEAT "long" 62 name)
set(name "${name}_of.dot")
string(LENGTH "${name}" length)
expect_equal("${length}" "255")
expect_success(compute ${mesh} --graph ${name})
expect_file_of_graph(${name})

# standard output, and the report on standard error
function(expect_on_standard_output pattern pattern_of_report)
  run(${ARGN})
  expect_equal("${exit_code}" "0")
  expect_match("${output}" "${pattern}")
  expect_match("${error}" "${pattern_of_report}")
endfunction()

file(CREATE_LINK /dev/stdout ${FOLDER}/stdout.vtp SYMBOLIC)
expect_on_standard_output("^<.xml.*<graphml.*</graphml>\n$" "^surface  4 .*graph    2 nodes" compute ${mesh} --graph -)
expect_on_standard_output("^<.xml.*<VTKFile.*</VTKFile>\n$" "^surface  4 " compute ${mesh} --graph stdout.vtp)
expect_on_standard_output("^node 0\narc 0\narc 0\nnode 1\n$" "^{\n.*}\n$" compute ${mesh} --vertex-arcs /dev/stdout
                          --json)
expect_on_standard_output("^kind,.*minimum-maximum,0,3,0,1,1\n$" "^surface  4 " compute ${mesh} --pairs -)
expect_on_standard_output("^4 [-0-9. e]+\n$" "^1 contour\n$" contour ${mesh} --level 0.75 --output -)
expect_on_standard_output("^0\n0.25\n0.5\n1\n$" "^4 values from 0 to 1\n$" field tetrahedron.off --type height
                          --output -)
expect_on_standard_output("^OFF\n" "curves, .* patches\n" curves ${genus_3} --field y --type pants --cut-mesh -)
expect_error("two outputs" compute ${mesh} --graph - --pairs /dev/stdout)
execute_process(COMMAND sh -c "echo before; \"$@\" 2>&1 >/dev/null; echo; \"$@\" --vertex-arcs -; echo behind" sh
                        ${PROGRAM} compute ${mesh} --no-table
                WORKING_DIRECTORY ${FOLDER} OUTPUT_FILE ${FOLDER}/output.txt ERROR_VARIABLE error)
file(READ ${FOLDER}/output.txt content)
expect_equal("${content}" "before\n\nnode 0\narc 0\narc 0\nnode 1\nbehind\n")
expect_match("${error}" "^surface  4 ")

# a pipe, which stays one
execute_process(COMMAND sh -c "mkfifo pipe.dot && (cat pipe.dot >copy.dot & \"$@\"; wait; test -p pipe.dot)" sh
                        ${PROGRAM} compute ${mesh} --graph pipe.dot
                WORKING_DIRECTORY ${FOLDER} RESULT_VARIABLE exit_code OUTPUT_VARIABLE output)
expect_equal("${exit_code}" "0")
expect_match("${output}" "^surface  4 ")
expect_file_of_graph(copy.dot)

# names that are no UTF-8, in a drawing of which all is: the unit and the name of the file of the field
string(ASCII 181 micro)
file(WRITE ${FOLDER}/${micro}.txt "0\n1\n2\n3\n")
expect_success(compute tetrahedron.off --scalars ${micro}.txt --unit ${micro}m --graph unit.svg)
file(READ ${FOLDER}/unit.svg content HEX)
string(REGEX REPLACE "(..)" "\\1 " content "${content}")
expect_match("${content}" "ef bf bd 20 5b ef bf bd 6d 5d ") # � [�m]
if(content MATCHES "b5 ")
  message(SEND_ERROR "unit.svg is no UTF-8")
endif()

file(GLOB files ${FOLDER}/*.partial ${FOLDER}/folder/*.partial)
expect_equal("${files}" "")
