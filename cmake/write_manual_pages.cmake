# Writes pages of man, of what the program prints for --help, and what shells complete it with, into FOLDER, made anew.
file(REMOVE_RECURSE ${FOLDER})
file(MAKE_DIRECTORY ${FOLDER}/man1)

foreach(shell bash zsh fish)
  execute_process(COMMAND ${PROGRAM} --completion ${shell} OUTPUT_FILE ${FOLDER}/reeb_graph.${shell}
                  COMMAND_ERROR_IS_FATAL ANY)
endforeach()

# write_page(NAME ARGUMENT...): the first line of the help says what NAME is, and what follows stays as it is.
function(write_page name)
  execute_process(COMMAND ${PROGRAM} ${ARGN} --help OUTPUT_VARIABLE help COMMAND_ERROR_IS_FATAL ANY)
  string(REPLACE "\\" "\\e" help "${help}")
  string(REGEX REPLACE "^([^\n]*)\n(.*)$" ".TH ${name} 1\n.SH NAME\n${name} - \\1\n.SH DESCRIPTION\n.nf\n\\2.fi\n" page
                       "${help}")
  string(REPLACE "-" "\\-" page "${page}")
  file(WRITE ${FOLDER}/man1/${name}.1 "${page}")
endfunction()

write_page(reeb_graph)
execute_process(COMMAND ${PROGRAM} --help OUTPUT_VARIABLE help)
string(REGEX REPLACE ".*Subcommands:(.*)\n\nOptions of.*" "\\1" commands "${help}")
string(REGEX MATCHALL "\n  [a-z]+" commands "${commands}")
foreach(command IN LISTS commands)
  string(STRIP "${command}" command)
  write_page(reeb_graph-${command} ${command})
endforeach()
