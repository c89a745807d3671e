# The scripts of the page in the order in which they follow each other in it. Those before shaders.js need no browser.
set(reeb_graph_page_scripts
    colors.js
    comparisons.js
    data.js
    contours.js
    bands.js
    tubes.js
    graphs.js
    scales.js
    poses.js
    patches.js
    shaders.js
    tables.js
    surfaces.js
    cameras.js
    scene.js
    drawing.js
    texts.js
    facts.js
    controls.js
    page.js)
# What of three.js goes before them, from its folder.
set(reeb_graph_page_three_scripts build/three.min.js examples/js/controls/OrbitControls.js)
