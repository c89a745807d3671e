# The page holds the surface, the graph, its simplified graphs and curves, as a reader of its own finds them.
include(${CMAKE_CURRENT_LIST_DIR}/common.cmake)

if(NOT PYTHON)
  message(STATUS "SKIPPED: Python, which reads the page, is not installed")
  return()
endif()

# expect_page(NAME TITLE ...) checks the page NAME.html, and what check_page.py is told besides.
function(expect_page name title)
  execute_process(COMMAND ${PYTHON} ${CMAKE_CURRENT_LIST_DIR}/check_page.py ${name}.html ${title} ${ARGN}
                  WORKING_DIRECTORY ${FOLDER} RESULT_VARIABLE result ERROR_VARIABLE python_error)
  if(NOT result STREQUAL "0")
    message(SEND_ERROR "${name}.html: ${python_error}")
  endif()
endfunction()

file(WRITE ${FOLDER}/tetrahedron.off "${tetrahedron_off}")

# what is wrong is told before any work
run(compute missing.off --field z --html page.html)
if(error MATCHES "without the page")
  expect_error("libjs-three.*CGAL_REEB_GRAPH_THREE_JS_DIR" compute missing.off --field z --html page.html)
  expect_error("libjs-three" curves missing.off --field z --type pants --html page.html)
  message(STATUS "The program is built without the page: nothing else is tested")
  return()
endif()
expect_error("missing.off" compute missing.off --field z --html page.html)
expect_error("page.htm: the file name of a page ends in .html" compute missing.off --field z --html page.htm)
expect_error("page.htm: the file name of a page ends in .html" curves missing.off --field z --type pants
             --html page.htm)
expect_error("--up goes with --html only" compute tetrahedron.off --field z --up x --graph up.svg)
expect_error("--up goes with --html only" curves tetrahedron.off --type pants --up x --graph up.svg)
expect_error("two outputs" compute tetrahedron.off --field z --html page.html --vertex-arcs ./page.html)
expect_error("the file cannot be written" compute tetrahedron.off --field z --html missing/page.html)
file(WRITE ${FOLDER}/far.off "OFF\n3 1 0\n0 0 0\n1e31 0 0\n0 1 0\n3 0 1 2\n")
expect_error("1e30" compute far.off --field x --html page.html)
file(WRITE ${FOLDER}/tiny.off "OFF\n3 1 0\n0 0 0\n1e-40 0 0\n0 1e-40 0\n3 0 1 2\n")
expect_error("1e-30" compute tiny.off --field x --html page.html)

expect_success(compute tetrahedron.off --field z --unit mm --html page.html)
expect_page(page tetrahedron.off mesh=tetrahedron.off coordinate=2 field.name="z" field.unit="mm" graph.arcs.length=1
            graph.is_simplified=false levels.length=1 curves.length=0)

expect_success(skeleton tetrahedron.off --html page.html)
expect_page(page "tetrahedron.off: skeleton with 2 ends, 0 loops" mesh=tetrahedron.off skeleton.ends=2)
foreach(name neuron genus_3)
  configure_file(${CMAKE_CURRENT_LIST_DIR}/../../examples/Reeb_graph/data/${name}.off ${FOLDER}/${name}.off COPYONLY)
  expect_success(skeleton ${name}.off --json --html page.html)
  string(JSON ends GET "${output}" ends)
  string(JSON loops GET "${output}" loops)
  string(JSON arcs LENGTH "${output}" arcs)
  string(REGEX REPLACE "^1 loops" "1 loop" title "${loops} loops")
  expect_page(page "${name}.off: skeleton with ${ends} ends, ${title}" mesh=${name}.off graph.arcs.length=${arcs}
              skeleton.ends=${ends} skeleton.loops=${loops})
endforeach()

# names that are code, and such that are no UTF-8
set(unit "</script><script>alert(1)</script>&amp<!--")
configure_file(${FOLDER}/tetrahedron.off "${FOLDER}/<script><b>&amp.off" COPYONLY)
expect_success(compute "<script><b>&amp.off" --field z --unit ${unit} --html page.html)
expect_page(page "<script><b>&amp.off" "field.unit=\"</script><script>alert(1)</script>&amp<!--\"")
file(WRITE ${FOLDER}/columns.csv "a,</script>\n0,3\n1,2\n2,1\n3,0\n")
expect_success(compute tetrahedron.off --scalars columns.csv --column </script> --html page.html)
expect_page(page tetrahedron.off field.name="</script>" graph.nodes.0.value=0 graph.nodes.0.vertex=3)

# a torus of seven vertices, less one face: a border and a loop
set(torus "OFF\n7 13 0\n0 0 0\n0 0 1\n0 0 2\n0 0 3\n0 0 4\n0 0 5\n0 0 6\n")
string(REPLACE "3 0 1 3\n" "" torus_faces_but_one "${torus_faces}")
file(WRITE ${FOLDER}/torus.off "${torus}${torus_faces_but_one}")
expect_success(compute torus.off --field z --vertex-arcs arcs.txt --html page.html)
expect_page(page torus.off mesh=torus.off vertex_arcs=arcs.txt)

# contours; those of triangles that are no surface are of a copy that is one, with a number for each vertex of the file
expect_success(contour torus.off --field z --t 0.5 --unit mm --output contours.polylines.txt --html page.html)
expect_page(page torus.off mesh=torus.off curves=contours.polylines.txt field.unit="mm")
expect_success(contour torus.off --field z --level 2.5 --html page.html)
file(WRITE ${FOLDER}/fins.off "OFF\n5 3 0\n0 0 0\n0 0 1\n1 0 0\n0 1 0\n1 1 0\n3 0 1 2\n3 0 1 3\n3 0 1 4\n")
file(WRITE ${FOLDER}/five.txt "0\n1\n2\n3\n4\n")
set(fins contour fins.off --scalars five.txt --t 0.5 --parametrize five.txt)
expect_success(${fins} --output contours.polylines.txt --html page.html)
expect_page(page fins.off curves=contours.polylines.txt)
expect_error("--html needs an oriented manifold surface" ${fins} --strict --html page.html)
expect_error("--up goes with --html only" ${fins} --up x --output contours.polylines.txt)
expect_error("--strict goes with --html only" ${fins} --strict --output contours.polylines.txt)
expect_error("--strict goes with --html only" compute fins.off --scalars five.txt --strict)

# components, one of them a vertex; values that JSON does not have; a mesh far from 0
file(WRITE ${FOLDER}/parts.off
     "OFF\n7 2 0\n1e6 0 0\n1000001 0 1\n1e6 1 1\n1000005 0 0\n1000006 0 0.5\n1000005 1 1\n1e6 5 2\n"
     "3 0 1 2\n3 3 4 5\n")
file(WRITE ${FOLDER}/infinite.txt "-inf\n1\n2\n0.5\n1.5\ninf\n3\n")
expect_success(compute parts.off --scalars infinite.txt --vertex-arcs arcs.txt --html page.html)
expect_page(page parts.off mesh=parts.off vertex_arcs=arcs.txt field.name="infinite" graph.nodes.0.value=-Infinity
            graph.nodes.4.value=Infinity graph.nodes.length=5 graph.arcs.length=2 graph.arcs.0.persistence="Infinity")
file(WRITE ${FOLDER}/constant.txt "7\n7\n7\n7\n7\n7\n7\n")
foreach(ties perturb contract)
  expect_success(compute parts.off --scalars constant.txt --ties ${ties} --vertex-arcs arcs.txt --html page.html)
  expect_page(page parts.off vertex_arcs=arcs.txt field.lowest=7.0 field.highest=7.0)
endforeach()
file(WRITE ${FOLDER}/empty.off "OFF\n0 0 0\n")
expect_success(compute empty.off --field z --html page.html)
expect_page(page empty.off graph.nodes.length=0 levels.length=1)

# a surface with handles: the given graph, the simplified one, and curves with patches
expect_success(compute ${genus_3} --field x --vertex-arcs arcs.txt --html page.html)
expect_page(page genus_3.off mesh=${genus_3} vertex_arcs=arcs.txt graph.arcs.length=10 levels.length=2
            levels.1.graph.arcs.length=1)
expect_success(compute ${genus_3} --field z --ties contract --vertex-arcs arcs.txt --html page.html)
expect_page(page genus_3.off vertex_arcs=arcs.txt)
expect_success(compute ${genus_3} --field y --leaves 3 --keep-degree-2 --vertex-arcs arcs.txt --html page.html)
expect_page(page genus_3.off mesh=${genus_3} vertex_arcs=arcs.txt)
foreach(open "" --cut-open)
  expect_success(curves ${genus_3} --field x --type pants ${open} --curves curves.polylines.txt --cut-mesh cut.off
                 --patches patches.txt --html page.html)
  expect_page(page genus_3.off mesh=cut.off patches=patches.txt curves=curves.polylines.txt curves.length=6)
endforeach()

# levels with their patches, and disks on the mesh as it was
expect_success(curves ${genus_3} --field x --type levels --levels 3 --curves curves.polylines.txt --cut-mesh cut.off
               --patches patches.txt --html page.html)
expect_page(page genus_3.off mesh=cut.off patches=patches.txt curves=curves.polylines.txt)
expect_success(curves ${genus_3} --field x --type disks --curves curves.polylines.txt --html page.html)
expect_page(page genus_3.off mesh=${genus_3} curves=curves.polylines.txt graph.arcs.length=10)

# handles and tunnels
expect_success(handles ${genus_3} --field x --loops loops.polylines.txt --html page.html)
expect_page(page genus_3.off mesh=${genus_3} curves=loops.polylines.txt curves.length=6 loops.length=6
            "loops.0.kind=\"handle\"" "loops.5.kind=\"tunnel\"" "field.name=\"x\"")

# a graph of more arcs than a page shows
set(noisy_plane "import random
random.seed(1)
n = 100
print('OFF', (n + 1) ** 2, 2 * n * n, 0)
for i in range((n + 1) ** 2):
    print(i // (n + 1), i % (n + 1), random.random())
for i in range(n * n):
    a = i // n * (n + 1) + i % n
    print(3, a, a + n + 1, a + 1)
    print(3, a + 1, a + n + 1, a + n + 2)
")
execute_process(COMMAND ${PYTHON} -c "${noisy_plane}" OUTPUT_FILE ${FOLDER}/noise.off COMMAND_ERROR_IS_FATAL ANY)
expect_success(compute noise.off --field z --json --html page.html)
string(JSON number_of_arcs GET "${output}" arcs)
expect_page(page noise.off mesh=noise.off graph.is_simplified=true graph.arcs_of_input=${number_of_arcs})

# a surface of more faces than a page shows
set(wavy_plane "n = 330
print('OFF', (n + 1) ** 2, 2 * n * n, 0)
for i in range((n + 1) ** 2):
    x, y = divmod(i, n + 1)
    print(x, y, (x - 100) * (x - 200) * (y - 50) * (y - 280) / 1e5)
for i in range(n * n):
    a = i // n * (n + 1) + i % n
    print(3, a, a + n + 1, a + 1)
    print(3, a + 1, a + n + 1, a + n + 2)
")
execute_process(COMMAND ${PYTHON} -c "${wavy_plane}" OUTPUT_FILE ${FOLDER}/plane.off COMMAND_ERROR_IS_FATAL ANY)
expect_success(compute plane.off --field z --vertex-arcs arcs.txt --html page.html)
expect_page(page plane.off mesh=plane.off coordinate=2 vertex_arcs=arcs.txt surface.faces_of_input=217800
            surface.is_decimated=true graph.arcs.0.contours.length=16)
