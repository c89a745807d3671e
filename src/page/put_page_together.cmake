# Writes a source file with the text of the page: HTML, in which the markers stand for the files STYLE, THREE_SCRIPTS with
# their NOTICE, and SCRIPTS. The markers of the title and of the data stay, for the program.
cmake_minimum_required(VERSION 3.21)

function(replace_marker marker text)
  string(FIND "${page}" "<!-- ${marker} -->" position)
  if(position EQUAL -1)
    message(FATAL_ERROR "${HTML} has no marker <!-- ${marker} -->")
  endif()
  string(REPLACE "<!-- ${marker} -->" "${text}" page "${page}")
  set(page "${page}" PARENT_SCOPE)
endfunction()

# The files one after the other. Refuses text that would end its element within the page.
function(read_texts tag paths result)
  foreach(path IN LISTS paths)
    file(READ "${path}" text)
    string(TOLOWER "${text}" lower_case)
    string(FIND "${lower_case}" "</${tag}" position)
    if(NOT position EQUAL -1)
      message(FATAL_ERROR "${path} has </${tag} in it")
    endif()
    string(APPEND texts "${text}")
  endforeach()
  set(${result} "${texts}" PARENT_SCOPE)
endfunction()

file(READ "${HTML}" page)
file(READ "${NOTICE}" notice)
read_texts(style "${STYLE}" style)
read_texts(script "${THREE_SCRIPTS}" three)
read_texts(script "${SCRIPTS}" scripts)
# What has been put in is not searched for the markers that the program looks for: they come first in the page.
replace_marker(script "${scripts}")
replace_marker(three "/*\n${notice}*/\n${three}")
replace_marker(style "${style}")

file(WRITE "${OUTPUT}" "#include \"page/page_template.h\"

std::string_view reeb_graph_program::page_template()
{
  return R\"reeb_graph_page(${page})reeb_graph_page\";
}
")
