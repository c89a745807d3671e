# Cutting along curves: their number, the files that are written, and what is refused.
include(${CMAKE_CURRENT_LIST_DIR}/common.cmake)

# the surface of the demo has genus 3
expect_success(demo --out .)
set(surface surface.off --scalars scalars.txt)
expect_success(curves ${surface} --type cutting-system)
expect_equal("${output}" "3 curves, 1 patch\n")
expect_success(curves ${surface} --type pants --curves c.polylines.txt --cut-mesh cut.off --patches patches.txt)
expect_equal("${output}" "6 curves, 4 patches\n")

# closed polylines
file(STRINGS ${FOLDER}/c.polylines.txt polylines)
list(LENGTH polylines number_of_polylines)
expect_equal("${number_of_polylines}" "6")
foreach(polyline IN LISTS polylines)
  expect_match("${polyline}" "^[0-9]+ ([^ ]+ [^ ]+ [^ ]+) .* ([^ ]+ [^ ]+ [^ ]+)$")
  string(REGEX REPLACE "^[0-9]+ ([^ ]+ [^ ]+ [^ ]+) .* ([^ ]+ [^ ]+ [^ ]+)$" "\\1;\\2" ends "${polyline}")
  list(GET ends 0 first)
  list(GET ends 1 last)
  expect_equal("${first}" "${last}")
endforeach()

# a number for each face of the cut mesh
file(STRINGS ${FOLDER}/cut.off cut_mesh LIMIT_COUNT 2)
list(GET cut_mesh 1 sizes)
string(REGEX REPLACE "^[0-9]+ ([0-9]+) .*$" "\\1" number_of_faces "${sizes}")
file(STRINGS ${FOLDER}/patches.txt patches)
list(LENGTH patches number_of_patches)
expect_equal("${number_of_patches}" "${number_of_faces}")
list(REMOVE_DUPLICATES patches)
list(SORT patches)
expect_equal("${patches}" "0;1;2;3")
expect_json(1 components ARGUMENTS cut.off --field z)
expect_json(3 genus ARGUMENTS cut.off --field z)

# cut open: four pairs of pants with three borders each, or genus 0
expect_success(curves ${surface} --type pants --cut-open --cut-mesh open.off)
expect_json(4 components ARGUMENTS open.off --field z)
expect_json(12 border_loops ARGUMENTS open.off --field z)
expect_success(curves ${surface} --type cutting-system --cut-open --cut-mesh open.off)
expect_json(0 genus ARGUMENTS open.off --field z)
expect_json(6 border_loops ARGUMENTS open.off --field z)

# PLY has the patches
expect_success(curves ${surface} --type pants --cut-mesh cut.ply)
file(STRINGS ${FOLDER}/cut.ply header LIMIT_COUNT 20)
expect_match("${header}" "element face ${number_of_faces};.*property int patch;.*property uchar red")

# branches
expect_success(curves ${surface} --type branch --persistence 0.1)
expect_match("${output}" "^2 curves, 3 patches\n$")
expect_success(curves ${surface} --type branch --persistence 1000)
expect_equal("${output}" "0 curves, 1 patch\n")
expect_success(curves ${surface} --type branch --area 1000)
expect_equal("${output}" "0 curves, 1 patch\n")

# what has no such curves, and names of files of no format
file(WRITE ${FOLDER}/tetrahedron.off "${tetrahedron_off}")
file(WRITE ${FOLDER}/triangle.off "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 1\n3 0 1 2\n")
set(tetrahedron tetrahedron.off --field z)
expect_error("component of face 0 is a sphere" curves ${tetrahedron} --type pants)
expect_error("border component of vertex 0 does not lie in one level" curves triangle.off --field z
             --type cutting-system --cut-mesh triangle_cut.off)
expect_error("[.]off or [.]ply" curves ${tetrahedron} --type branch --cut-mesh cut.obj)
expect_error("[.]polylines[.]txt" curves ${tetrahedron} --type branch --curves curves.txt)
expect_error("--type" curves ${tetrahedron})
expect_error("--type" curves ${tetrahedron} --type other)

# options that go with nothing, and two outputs in one file
expect_error("--persistence goes with" curves ${surface} --type pants --persistence 0.1)
expect_error("--area goes with" curves ${surface} --type cutting-system --area 0.1)
expect_error("--persistence must not" curves ${surface} --type branch --persistence nan)
expect_error("--persistence must not" curves ${surface} --type branch --persistence=-1)
expect_error("--area must not" curves ${surface} --type branch --area nan)
expect_error("a.off: two outputs" curves ${surface} --type pants --cut-mesh a.off --patches ./a.off)
expect_error("graph.dot: two outputs" compute ${surface} --graph graph.dot --vertex-arcs graph.dot)
