<?xml version="1.0" encoding="UTF-8"?>
<!-- What the manual refers to in CGAL's: labels and their pages, for a doxygen that does not read CGAL's own. -->
<tagfile>
  <compound kind="page">
    <name>packages</name>
    <title>Packages of CGAL</title>
    <filename>Manual/packages.html</filename>
    <docanchor file="Manual/packages.html" title="CGAL and the Boost Graph Library">PkgBGL</docanchor>
    <docanchor file="Manual/packages.html" title="Surface Mesh">PkgSurfaceMesh</docanchor>
    <docanchor file="Manual/packages.html" title="3D Polyhedral Surface">PkgPolyhedron</docanchor>
    <docanchor file="Manual/packages.html" title="CGAL and Boost Property Maps">PkgPropertyMap</docanchor>
    <docanchor file="Manual/packages.html" title="CGAL and Solvers">PkgSolverInterface</docanchor>
    <docanchor file="Manual/packages.html" title="Weights">PkgWeights</docanchor>
    <docanchor file="Manual/packages.html" title="Polygon Mesh Processing">PkgPolygonMeshProcessing</docanchor>
  </compound>
  <compound kind="page">
    <name>license</name>
    <title>License</title>
    <filename>Manual/license.html</filename>
    <docanchor file="Manual/license.html" title="GPL">licensesGPL</docanchor>
  </compound>
  <compound kind="page">
    <name>thirdparty</name>
    <title>Essential and Optional Third Party Dependencies</title>
    <filename>Manual/thirdparty.html</filename>
    <docanchor file="Manual/thirdparty.html" title="Eigen">thirdpartyEigen</docanchor>
    <docanchor file="Manual/thirdparty.html" title="Intel TBB">thirdpartyTBB</docanchor>
  </compound>
</tagfile>
