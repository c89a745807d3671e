# Lets the program write its pages of man, and what shells complete it with, into FOLDER, made anew.
file(REMOVE_RECURSE ${FOLDER})
file(MAKE_DIRECTORY ${FOLDER}/man1)

# write_from_program(FILE ARGUMENT...): what the program prints.
function(write_from_program file)
  execute_process(COMMAND ${PROGRAM} ${ARGN} OUTPUT_FILE ${FOLDER}/${file} RESULT_VARIABLE result)
  if(NOT result EQUAL 0)
    message(FATAL_ERROR "${PROGRAM} ${ARGN} failed")
  endif()
endfunction()

foreach(shell bash zsh fish)
  write_from_program(reeb_graph.${shell} --completion ${shell})
endforeach()
write_from_program(man1/reeb_graph.1 --manual-page reeb_graph)
file(READ ${FOLDER}/man1/reeb_graph.1 page)
string(REGEX MATCHALL "reeb_graph.-[a-z]+ [(]1[)]" others "${page}")
foreach(other IN LISTS others)
  string(REGEX REPLACE "reeb_graph.-([a-z]+) .*" "\\1" command ${other})
  write_from_program(man1/reeb_graph-${command}.1 --manual-page ${command})
endforeach()
