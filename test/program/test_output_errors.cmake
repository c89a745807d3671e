# Output that cannot be written is an error that names the file and the reason, and what was there before stays as it was.
include(${CMAKE_CURRENT_LIST_DIR}/common.cmake)

file(WRITE ${FOLDER}/tetrahedron.off "${tetrahedron_off}")
file(MAKE_DIRECTORY ${FOLDER}/folder.dot)
expect_error("[.]graphml, [.]dot, .*or [.]csv" compute tetrahedron.off --field z --graph graph.txt)
expect_error("[.]graphml, [.]dot, .*or [.]csv" compute missing.off --field z --graph graph)
expect_error("missing/graph.dot: the file cannot be written: No such file" compute tetrahedron.off --field z
             --graph missing/graph.dot)
expect_error("folder.dot: the file cannot be written: Is a directory" compute tetrahedron.off --field z
             --graph folder.dot)
file(CREATE_LINK circle.dot ${FOLDER}/circle.dot SYMBOLIC)
expect_error("circle.dot: the file cannot be written: Too many levels" compute tetrahedron.off --field z
             --graph circle.dot)

file(WRITE ${FOLDER}/graph.dot "from before")
expect_error("missing.txt" compute tetrahedron.off --scalars missing.txt --graph graph.dot)
file(READ ${FOLDER}/graph.dot content)
expect_equal("${content}" "from before")
expect_success(compute tetrahedron.off --field z --graph graph.dot)
file(READ ${FOLDER}/graph.dot content)
expect_match("${content}" "^digraph")

file(WRITE ${FOLDER}/file "")
expect_error("" demo --out file/folder)

# Each output there is: its command, the options without which there is none, its option, and its endings.
set(outputs
    "compute|--graph|.graphml .dot .svg .vtp .obj .polylines.txt .json" "compute|--mesh-out|.ply .vtp .off .obj .stl"
    "compute|--vertex-arcs|.txt" "compute|--pairs|.csv .pers" "compute|--diagram|.svg"
    "compute --leaves 2|--simplified-scalars|.txt" "contour --level 0.1|--output|.polylines.txt .csv"
    "curves --type pants|--curves|.polylines.txt .csv" "curves --type pants|--cut-mesh|.off .ply .obj .stl .vtp"
    "curves --type pants|--patches|.txt" "curves --type pants|--mesh-out|.ply .vtp .off .obj .stl" "field|--output|.txt")

run(compute missing.off --field z --html page.html)
if(NOT error MATCHES "without the page")
  list(APPEND outputs "compute|--html|.html" "curves --type pants|--html|.html")
endif()

# Calls a command for each output and each of its endings, with the variables `arguments`, `option`, and `ending`.
macro(foreach_output command)
  foreach(output_and_endings IN LISTS outputs)
    string(REPLACE "|" ";" parts "${output_and_endings}")
    list(GET parts 0 arguments)
    list(GET parts 1 option)
    list(GET parts 2 endings)
    string(REPLACE " " ";" arguments "${arguments}")
    string(REPLACE " " ";" endings "${endings}")
    list(POP_FRONT arguments subcommand)
    if(subcommand STREQUAL "field")
      set(field --type height)
    else()
      set(field --field y)
    endif()
    foreach(ending IN LISTS endings)
      cmake_language(CALL ${command})
    endforeach()
  endforeach()
endmacro()

# If a later output cannot be written, the earlier ones are not there either: each but the one in a folder that is missing.
function(expect_all_or_none subcommand arguments)
  foreach(last IN LISTS ARGN)
    set(files)
    foreach(item IN LISTS ARGN)
      string(REPLACE " " ";" item "${item}")
      list(GET item 0 option)
      list(GET item 1 name)
      if("${item}" STREQUAL "${last}" OR "${option} ${name}" STREQUAL "${last}")
        set(name missing/${name})
      endif()
      list(APPEND files ${option} ${name})
    endforeach()
    expect_error("missing/[^ ]*: the file cannot be written: No such file" ${subcommand} ${genus_3} ${arguments} ${files})
  endforeach()
endfunction()

set(html)
run(compute missing.off --field z --html page.html)
if(NOT error MATCHES "without the page")
  set(html "--html a.html")
endif()
expect_all_or_none(compute "--field;y;--leaves;2" "--graph a.csv" "--mesh-out a.vtp" "--vertex-arcs b.txt" "--pairs b.csv"
                   "--diagram a.svg" "--longest-loop b.vtp" "--simplified-scalars c.txt" ${html})
expect_all_or_none(curves "--field;y;--type;pants" "--curves a.polylines.txt" "--cut-mesh a.off" "--patches p.txt"
                   "--graph a.csv" "--mesh-out a.ply" ${html})
expect_all_or_none(handles "--remove;1" "--output a.off" "--loops a.vtp" ${html})
file(MAKE_DIRECTORY ${FOLDER}/demo/graph.dot)
expect_error("graph.dot: the file cannot be written: Is a directory" demo --out demo)
file(GLOB files RELATIVE ${FOLDER}/demo ${FOLDER}/demo/*)
expect_equal("${files}" "graph.dot")

# a full disk
function(expect_full_disk)
  file(CREATE_LINK /dev/full ${FOLDER}/full${ending} SYMBOLIC)
  expect_error("full${ending}: the file cannot be written: No space left on device" ${subcommand} ${genus_3} ${field}
               ${arguments} ${option} full${ending})
endfunction()

if(EXISTS /dev/full)
  foreach_output(expect_full_disk)
  foreach(arguments "compute ${FOLDER}/tetrahedron.off --field z" "--help" "compute --help" "--version")
    string(REPLACE " " ";" arguments "${arguments}")
    execute_process(COMMAND ${PROGRAM} ${arguments} OUTPUT_FILE /dev/full RESULT_VARIABLE exit_code
                    ERROR_VARIABLE error)
    expect_equal("${exit_code}" "1")
    expect_match("${error}" "^reeb_graph: error: standard output cannot be written")
  endforeach()
endif()

# a limit of the size of files
function(expect_limit)
  set(PROGRAM sh -c "ulimit -f 0 && exec \"$@\"" sh ${PROGRAM})
  expect_error("new${ending}: the file cannot be written: File too large" ${subcommand} ${genus_3} ${field}
               ${arguments} ${option} new${ending})
endfunction()

foreach_output(expect_limit)

# an output that is an input, also by another name
function(expect_replaced_input)
  foreach(name mesh hard_link symbolic_link)
    expect_error("${name}${ending}: this output would replace an input" ${subcommand} mesh${ending} ${field}
                 ${arguments} ${option} ${name}${ending})
  endforeach()
endfunction()

foreach(ending .graphml .dot .svg .vtp .obj .polylines.txt .json .ply .txt .csv .pers .off .stl .html)
  file(WRITE ${FOLDER}/mesh${ending} "from before")
  file(CREATE_LINK ${FOLDER}/mesh${ending} ${FOLDER}/hard_link${ending})
  file(CREATE_LINK mesh${ending} ${FOLDER}/symbolic_link${ending} SYMBOLIC)
endforeach()
foreach_output(expect_replaced_input)
file(WRITE ${FOLDER}/scalars.arcs.csv "0\n1\n2\n3\n")
expect_error("scalars.arcs.csv: this output would replace an input" compute tetrahedron.off --scalars scalars.arcs.csv
             --graph scalars.csv)
expect_error("hard_link.txt: two outputs" compute tetrahedron.off --field z --vertex-arcs mesh.txt --leaves 2
             --simplified-scalars hard_link.txt)

# a name that is empty, which a list in CMake cannot have
set(PROGRAM sh -c "exec \"$@\" ''" sh ${PROGRAM})
function(expect_empty_name)
  expect_error("${option}: it is empty" ${subcommand} tetrahedron.off ${field} ${arguments} ${option})
endfunction()

foreach_output(expect_empty_name)
expect_error("MESH: it is empty" compute --field z)
expect_error("--scalars: it is empty" compute tetrahedron.off --scalars)
expect_error("--out: it is empty" demo --out)
