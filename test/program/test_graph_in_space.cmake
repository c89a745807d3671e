# The files of graphs in space, and meshes with results.
include(${CMAKE_CURRENT_LIST_DIR}/common.cmake)

file(WRITE ${FOLDER}/tetrahedron.off "${tetrahedron_off}")

function(expect_file name content)
  file(READ ${FOLDER}/${name} actual)
  if(NOT actual STREQUAL content)
    message(SEND_ERROR "${name} is '${actual}' instead of '${content}'")
  endif()
endfunction()

# a single arc, from vertex to vertex
set(z tetrahedron.off --field z --no-table)
expect_success(compute ${z} --graph straight.polylines.txt --embedding straight)
expect_file(straight.polylines.txt "2 0 0 0 0 0 1\n")
expect_success(compute ${z} --graph straight.obj --embedding straight)
expect_file(straight.obj "v 0 0 0\nv 0 0 1\ng node_0\np 1\ng node_1\np 2\ng arc_0\nl 1 2\n")
# The steepest way up is the edge from the lowest to the highest vertex.
expect_success(compute ${z} --graph chain.polylines.txt --embedding on-surface)
expect_file(chain.polylines.txt "2 0 0 0 0 0 1\n")
expect_success(compute ${z} --graph centroids.polylines.txt)
file(READ ${FOLDER}/centroids.polylines.txt content)
expect_match("${content}" "^14 0 0 0 [^\n]* 0 0 1\n$")

# The report tells the manner.
expect_success(compute ${z} --graph centroids.obj)
expect_match("${output}" "in space: centroids")
expect_success(compute ${z} --graph straight.obj --embedding straight --json)
expect_match("${output}" "\"embedding\": ?\"straight\"")

# The tables are two files.
expect_success(compute ${z} --graph table.csv --embedding straight)
file(GLOB tables RELATIVE ${FOLDER} ${FOLDER}/table*)
expect_equal("${tables}" "table.arcs.csv;table.nodes.csv")
expect_file(table.nodes.csv "node,vertex,value,kind,x,y,z,arcs_below,arcs_above
0,0,0,minimum,0,0,0,0,1
1,3,1,maximum,0,0,1,1,0
")
file(READ ${FOLDER}/table.arcs.csv content)
expect_match("${content}" "^arc,source,target,lower_value,upper_value,persistence,length,area,vertices,mean_value\n0,0,1,0,1,1,1,[0-9.]+,2,0[.]425895[0-9]+\n$")

# By default their nodes are at the vertices, as they have no lines.
expect_success(compute ${z} --graph vertices.csv)
expect_same_file(table.nodes.csv vertices.nodes.csv)

# Arcs are measured, and nodes and arcs placed, before files are written.
expect_success(compute ${z} --graph vertices.csv --json)
foreach(step measure embed output)
  string(JSON seconds GET "${output}" seconds ${step})
  expect_match("${seconds}" "^[0-9]")
endforeach()

file(WRITE ${FOLDER}/infinite.txt "-inf\n0\n0.5\ninf\n")
expect_success(compute tetrahedron.off --scalars infinite.txt --graph infinite.json)
file(READ ${FOLDER}/infinite.json json)
string(JSON kind GET "${json}" nodes 1 kind)
expect_equal("${kind}" "maximum")
string(JSON type TYPE "${json}" nodes 1 value)
expect_equal("${type}" "NULL")
string(JSON chain GET "${json}" edges 0 chain)
string(REGEX REPLACE "[ \n]" "" chain "${chain}")
expect_equal("${chain}" "[[0,3]]")

# a vertex without a face is a node in space, too
file(WRITE ${FOLDER}/isolated.off "OFF\n4 1 0\n0 0 0\n1 0 0\n0 1 1\n5 5 5\n3 0 1 2\n")
foreach(manner centroids on-surface straight)
  expect_success(compute isolated.off --field z --graph isolated.csv --embedding ${manner})
  file(READ ${FOLDER}/isolated.nodes.csv content)
  expect_match("${content}" "\n2,3,5,isolated,5,5,5,0,0\n$")
endforeach()

# a mesh with results keeps the order of its vertices, and its field
file(WRITE ${FOLDER}/torus.off "OFF\n7 14 0\n0 0 0\n1 0 1\n0 1 2\n1 1 3\n0 2 4\n2 0 5\n2 2 6\n${torus_faces}")
expect_success(compute torus.off --field z --graph torus.graphml --mesh-out torus.ply)
expect_success(compute torus.ply --field scalar --graph again.graphml)
expect_same_file(torus.graphml again.graphml)
file(STRINGS ${FOLDER}/torus.ply header LIMIT_COUNT 20)
expect_match("${header}" "property int arc;property int node")
expect_match("${header}" "property uchar red")
# simplified: the arcs of the vertices are those of the simplified graph
expect_success(compute torus.off --field z --simplify 10 --cancel-loops --graph simple.json --mesh-out simple.vtp)
file(READ ${FOLDER}/simple.json json)
string(JSON number_of_arcs LENGTH "${json}" edges)
expect_equal("${number_of_arcs}" "1")
expect_success(curves torus.off --field z --type cutting-system --mesh-out cut.ply)
file(STRINGS ${FOLDER}/cut.ply header LIMIT_COUNT 30)
expect_match("${header}" "property int patch")
expect_success(curves torus.off --field z --type cutting-system --cut-open --mesh-out cut.vtp)

# All formats are named before any work; the tables are both there, or neither.
expect_error("[.]graphml, [.]dot, [.]svg, [.]vtp, [.]obj, [.]polylines[.]txt, [.]json, or [.]csv" compute missing.off
             --field z --graph graph.txt)
expect_error("--embedding goes with" compute missing.off --field z --graph graph.dot --embedding straight)
expect_error("--embedding" compute missing.off --field z --graph graph.vtp --embedding sideways)
expect_error("[.]off, [.]ply, [.]obj, [.]stl, or [.]vtp" compute missing.off --field z --mesh-out mesh.txt)
expect_error("[.]off, [.]ply, [.]obj, [.]stl, or [.]vtp" curves missing.off --field z --type pants --mesh-out mesh.txt)
expect_error("two outputs have this name" compute missing.off --field z --graph a.csv --vertex-arcs a.nodes.csv)
expect_error("two outputs have this name" compute missing.off --field z --graph a.vtp --mesh-out a.vtp)
file(MAKE_DIRECTORY ${FOLDER}/half.arcs.csv)
expect_error("half.arcs.csv: the file cannot be written" compute tetrahedron.off --field z --graph half.csv)

# The most persistent loop is a closed curve on the surface, from the lower value of its pair to the upper one.
expect_error("the graph has no loop" compute ${z} --longest-loop loop.obj --graph no.svg)
expect_error("the file name of loops ends in" compute ${z} --longest-loop loop.svg)
expect_error("two outputs" compute ${genus_3} --field x --longest-loop loop.obj --graph loop.obj)
expect_success(compute ${genus_3} --field x --simplify 100% --longest-loop loop.vtp --json)
string(JSON length GET "${output}" longest_loop length)
expect_match("${length}" "^[0-9]")
expect_success(compute ${genus_3} --field x --longest-loop loop.obj)
expect_match("${output}" "\n +most persistent loop: persistence [0-9.]+, length [0-9.]+\n")
if(NOT PYTHON)
  message(STATUS "SKIPPED: Python, which checks loops, is not installed")
  return()
endif()
set(check_loop "import csv, json, math, random, subprocess, sys
program, mesh = sys.argv[1:]
lines = open(mesh).read().split('\\n')
number = int(lines[1].split()[0])
for seed in range(-1, 6):
    if seed >= 0:  # values of the field with fewer and fewer ties
        random.seed(seed)
        values = [random.randrange(10 ** (1 + seed)) for _ in range(number)]
        lines[2:2 + number] = [' '.join(line.split()[:2] + [str(z)])
                               for line, z in zip(lines[2:2 + number], values)]
    open('noise.off', 'w').write('\\n'.join(lines))
    ties = ['perturb', 'contract'][seed % 2]
    subprocess.run([program, 'compute', 'noise.off', '--field', 'z', '--ties', ties, '--pairs', 'pairs.csv', '--longest-loop',
                    'loop.polylines.txt'], check=True, stdout=subprocess.DEVNULL)
    loops = [row for row in csv.DictReader(open('pairs.csv')) if row['kind'] == 'loop']
    size = max(float(row['persistence']) for row in loops)
    numbers = [float(x) for x in open('loop.polylines.txt').read().split()]
    points = list(zip(numbers[1::3], numbers[2::3], numbers[3::3]))
    assert len(points) == numbers[0] > 3 and points[0] == points[-1], seed
    heights = [z for _, _, z in points]
    assert any(abs(min(heights) - float(row['lower_value'])) + abs(max(heights) - float(row['upper_value'])) < 1e-9 * size
               for row in loops if float(row['persistence']) == size), seed

# On a torus with noise, each arc leads anywhere around the tube, so a curve along all of them is 193 long. Each of the two
# nodes is at most half of a ring away from a meridian.
n, m = 100, 50
turn = lambda i, count: 2 * math.pi * i / count
points = [((3 + math.cos(turn(j, m))) * math.cos(turn(i, n)), (3 + math.cos(turn(j, m))) * math.sin(turn(i, n)),
           math.sin(turn(j, m))) for i in range(n) for j in range(m)]
at = lambda i, j: i % n * m + j % m
faces = [f for i in range(n) for j in range(m)
         for f in ((at(i, j), at(i + 1, j), at(i + 1, j + 1)), (at(i, j), at(i + 1, j + 1), at(i, j + 1)))]
open('ring.off', 'w').write('\\n'.join(['OFF', f'{n * m} {2 * n * m} 0'] + ['%r %r %r' % p for p in points]
                                      + ['3 %d %d %d' % f for f in faces]))
random.seed(8)
open('ring.txt', 'w').write('\\n'.join(repr(p[2] + random.gauss(0, 0.02)) for p in points))
run = subprocess.run([program, 'compute', 'ring.off', '--scalars', 'ring.txt', '--longest-loop', 'loop.obj', '--json'],
                     check=True, capture_output=True)
assert 2 * math.pi < json.loads(run.stdout)['longest_loop']['length'] < 2 * math.pi + 4 * math.pi * 4
")
execute_process(COMMAND ${PYTHON} -c "${check_loop}" ${PROGRAM} ${genus_3} WORKING_DIRECTORY ${FOLDER}
                RESULT_VARIABLE result ERROR_VARIABLE python_error)
if(NOT result STREQUAL "0")
  message(SEND_ERROR "the longest loop: ${python_error}")
endif()
