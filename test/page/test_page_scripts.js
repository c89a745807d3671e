// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial

// What the scripts of the page compute, on pages that the program writes.
// Usage: node test_page_scripts.js PROGRAM FOLDER
"use strict";

const assert = require("assert");
const {execFileSync} = require("child_process");
const fs = require("fs");
const path = require("path");
const page = require("./page_scripts.js");
const meshes = require("./meshes.js");

const [program, folder] = process.argv.slice(2);
fs.mkdirSync(folder, {recursive: true});

function run(...options) {
  return execFileSync(program, options, {cwd: folder, encoding: "utf8"});
}

// The data of the page of the height of a mesh.
function pageOf(name, mesh, ...options) {
  fs.writeFileSync(path.join(folder, name + ".off"), meshes.toOff(mesh));
  run("compute", name + ".off", "--field", "z", "--html", name + ".html", ...options);
  const data = page.readPageData(page.dataOfPage(path.join(folder, name + ".html")));
  return {name, data, view: new page.GraphView(data, 0), trace: page.makeContourTracer(data)};
}

const subjects = [
  pageOf("torus", meshes.torus(48, 24, 0.15)),
  pageOf("smooth_torus", meshes.torus(20, 12, 0)),
  pageOf("sheet", meshes.sheet(14, 17, 5)),
  pageOf("far_away", (mesh => {
    mesh.points.forEach(point => {
      point[0] += 5000;
    });
    return mesh;
  })(meshes.torus(30, 20, 0.1)))
];

const tests = {
  "numbers are decoded"() {
    const {surface} = subjects[0].data, mesh = meshes.torus(48, 24, 0.15);
    assert.strictEqual(surface.values.length, mesh.points.length);
    assert.deepStrictEqual(Array.from(surface.triangles), [].concat(...mesh.triangles));
    mesh.points.forEach((point, v) => {
      assert.strictEqual(surface.values[v], point[2]);
      assert.ok(Math.abs(surface.positions[3 * v] - point[0]) < 1e-6);
    });
    assert.throws(() => page.readPageData("{\"version\": 2}"), /version 2/);
  },

  "contours are those of the program"() {
    for (const {name, data, view, trace} of subjects) {
      const step = Math.ceil(view.arcs.length / 6);
      for (let arc = 0; arc < view.arcs.length; arc += step) {
        const t = [0.5, 0.07, 0.93][arc % 3];
        run("contour", name + ".off", "--field", "z", "--arc", arc, "--t", t, "--output", "contour.polylines.txt");
        const text = fs.readFileSync(path.join(folder, "contour.polylines.txt"), "utf8");
        const expected = text.trim().split(/\s+/).map(Number).slice(1);
        const contour = trace(view, arc, t), origin = data.surface.origin;
        const points = contour.points.concat(contour.isClosed ? contour.points.slice(0, 3) : []);
        assert.strictEqual(points.length, expected.length, name + ", arc " + arc);
        points.forEach((x, i) =>
          assert.ok(Math.abs(x + origin[i % 3] - expected[i]) < 1e-5, name + ", arc " + arc + ", " + i));
      }
    }
  },

  "contours of simplified arcs have their values"() {
    const {data, trace} = subjects[0];
    assert.ok(data.levels.length > 2);
    data.levels.forEach((_, number) => {
      const view = new page.GraphView(data, number);
      view.arcs.forEach((arc, i) => {
        const contour = trace(view, i, 0.37);
        assert.ok(contour.isClosed);
        assert.ok(Math.abs(contour.value - view.value(i, 0.37)) < 1e-12);
        for (let j = 2; j < contour.points.length; j += 3)
          assert.ok(Math.abs(contour.points[j] - contour.value) < 1e-5);
      });
    });
  },

  "infinite values are drawn at the ends"() {
    const mesh = {points: [[0, 0, 0], [1, 0, 0], [0, 1, 0], [1, 1, 1]], triangles: [[0, 1, 2], [2, 1, 3]]};
    fs.writeFileSync(path.join(folder, "infinite.off"), meshes.toOff(mesh));
    fs.writeFileSync(path.join(folder, "infinite.txt"), "-inf\n1\n2\ninf\n");
    run("compute", "infinite.off", "--scalars", "infinite.txt", "--html", "infinite.html");
    const data = page.readPageData(page.dataOfPage(path.join(folder, "infinite.html")));
    const view = new page.GraphView(data, 0), {plane} = view.arcs[0];
    assert.strictEqual(view.lower(0).value, -Infinity);
    assert.strictEqual(plane[1], data.range.low);
    assert.strictEqual(plane[plane.length - 1], data.range.high);
    assert.ok(data.range.low < 1 && data.range.high > 2);
    const contour = page.makeContourTracer(data)(view, 0, 0.5);
    assert.ok(contour.points.length >= 6 && contour.points.every(isFinite));
  },

  // By definition: no vertex is in a ball, and one is as near to it as edges are long. Places are found by walking.
  "balls of skeletons are in the surface"() {
    run("skeleton", path.join(__dirname, "../../examples/Reeb_graph/data/neuron.off"), "--html", "skeleton.html");
    const data = page.readPageData(page.dataOfPage(path.join(folder, "skeleton.html")));
    const view = new page.GraphView(data, 0), {positions, triangles} = data.surface;
    const longestEdge = triangles.reduce((longest, v, k) => Math.max(longest, Math.hypot(...[0, 1, 2].map(j =>
      positions[3 * v + j] - positions[3 * triangles[k % 3 === 2 ? k - 2 : k + 1] + j]))), 0);
    let numberInJunctions = 0;
    view.arcs.forEach((arc, number) => {
      const ways = page.waysAlong(arc.polyline), length = ways[ways.length - 1];
      assert.ok(Math.abs(length - arc.length) < 1e-5 * length);
      for (let place = 0; place <= 1; place += 1 / 64) {
        const {point, radius, inscribedRadius, way, value, junction} = view.ballAt(number, place);
        const i = ways.indexOf(way), end = ways.findIndex((w, j) => j > 0 && w >= place * length);
        assert.ok(ways.every(w => Math.abs(w - place * length) > Math.abs(way - place * length) - 1e-9));
        assert.deepStrictEqual(point, arc.polyline.slice(3 * i, 3 * i + 3));
        let nearest = Infinity;
        for (let v = 0; v < positions.length; v += 3)
          nearest = Math.min(nearest, Math.hypot(...point.map((x, j) => x - positions[v + j])));
        assert.ok(inscribedRadius < nearest + 1e-6 && inscribedRadius > nearest - longestEdge, number + " " + place);
        assert.ok(radius >= inscribedRadius);
        assert.ok(value <= view.lower(number).value + way + 1e-9);
        assert.ok(value <= view.upper(number).value + length - way + 1e-9);
        assert.ok(junction === null || [arc.source, arc.target].includes(junction));
        assert.strictEqual(junction !== null, arc.junctions[end - 1] === 1);
      }
      numberInJunctions += page.partsInJunctions(arc).reduce((sum, part) => sum + part.length / 3 - 1, 0);
    });
    const flags = [].concat(...view.arcs.map(arc => arc.junctions)).filter(isInJunction => isInJunction).length;
    assert.ok(flags > 0 && flags === numberInJunctions);
    data.graph.nodes.forEach((node, i) => {
      assert.ok(Math.hypot(...view.ballAtNode(i).point.map((x, j) => x - node.point[j])) < 1e-6);
    });
  },

  "the nearest place of a line"() {
    const random = meshes.randomNumbers(3), points = [...Array(8)].map(() => [random(), random()]);
    const ways = page.waysAlong([].concat(...points.map(([x, y]) => [x, y, 0])));
    for (let k = 0; k < 50; ++k) {
      const pointer = [2 * random() - 0.5, 2 * random() - 0.5];
      const distance = place => {
        const {end, share} = page.locate(ways, place);
        const [a, b] = [points[end - 1], points[end]];
        return Math.hypot(...pointer.map((x, i) => x - a[i] - share * (b[i] - a[i])));
      };
      const least = Math.min(...[...Array(2001)].map((_, i) => distance(i / 2000)));
      assert.ok(distance(page.nearestPlace(points, ways, pointer)) < least + 1e-9);
    }
    assert.strictEqual(page.nearestPlace([[1, 1], [1, 1]], [0, 0], [3, 4]), 0);
  },

  "precomputed contours are used where there is no chain"() {
    const contours = [0.1, 0.2, 0.8].map(value => ({value, isClosed: true, points: []}));
    const graph = {
      nodes: [{value: 0, vertex: 0}, {value: 1, vertex: 1}],
      arcs: [{source: 0, target: 1, plane: [0, 0, 0, 1], chain: null, contours}]
    };
    const data = {graph, levels: [{threshold: 0, arcs: [0]}], surface: null};
    const trace = page.makeContourTracer(data), view = new page.GraphView(data, 0);
    assert.deepStrictEqual([0.05, 0.49, 0.51].map(t => trace(view, 0, t).value), [0.1, 0.2, 0.8]);
  },

  // Each contour of an arc runs through bands of that arc, and all bands at a value are met by contours.
  "bands of triangles are the pieces of arcs"() {
    for (const {name, data, view, trace} of subjects.filter(subject => subject.name !== "sheet")) {
      const {triangles, values} = data.surface, {places, ends} = page.makeBands(data.surface, data.graph);
      const random = meshes.randomNumbers(7), {low, high} = data.range;
      for (let i = 0; i < 20; ++i) {
        const value = low + random() * (high - low);
        const alive = view.arcs.map((_, arc) => arc)
          .filter(arc => view.lower(arc).value <= value && value < view.upper(arc).value);
        const lengths = new Map(alive.map(arc => {
          const t = (value - view.lower(arc).value) / (view.upper(arc).value - view.lower(arc).value);
          return [arc, trace(view, arc, t).points.length / 3];
        }));
        const counts = new Map(alive.map(arc => [arc, 0]));
        for (let f = 0; f < triangles.length / 3; ++f) {
          const below = [0, 1, 2].filter(k => values[triangles[3 * f + k]] <= value).length;
          const band = value < ends[2 * f] ? 0 : value < ends[2 * f + 1] ? 1 : 2;
          if (below === 1 || below === 2)
            counts.set(places[3 * f + band], (counts.get(places[3 * f + band]) || 0) + 1);
        }
        assert.deepStrictEqual(counts, lengths, name + " at " + value);
      }
    }
  },

  "all arcs are reached by keys"() {
    for (const {view} of subjects) {
      const count = view.arcs.length;
      const all = new Set(view.arcs.map((_, i) => view.next(i, 1)));
      assert.strictEqual(all.size, count);
      const reached = new Set([0]);
      reached.forEach(arc => [true, false].forEach(forward => {
        reached.add(view.along(arc, forward));
        reached.add(view.beside(arc, forward));
        const upper = view.along(arc, true);
        assert.ok(upper === arc || view.arcs[upper].source === view.arcs[arc].target);
      }));
      assert.ok(2 * reached.size > count, reached.size + " of " + count);
    }
  },

  "simplification leaves places for all that is given"() {
    const {data} = subjects[0];
    let last = data.graph.arcs.length + 1;
    data.levels.forEach((_, number) => {
      const view = new page.GraphView(data, number);
      assert.ok(view.arcs.length < last);
      last = view.arcs.length;
      for (let place = 0; place < data.graph.arcs.length + data.graph.nodes.length; ++place) {
        const shown = view.placeOf(place);
        assert.ok(shown >= 0 ? shown < view.arcs.length : -1 - shown < view.nodes.length);
      }
    });
  },

  "arcs in the plane go from node to node"() {
    for (const {data, view} of subjects) {
      view.arcs.forEach((arc, i) => {
        if (view.lower(i).value === view.upper(i).value)
          return;
        assert.ok(Math.abs(view.column(i, view.lower(i).value) - view.nodes[arc.source].column) < 1e-9);
        assert.ok(Math.abs(view.column(i, view.upper(i).value) - view.nodes[arc.target].column) < 1e-9);
      });
      const scale = page.makePlaneScale(view, data.range, {width: 300, height: 400});
      view.nodes.forEach(node => {
        assert.ok(scale.x(node.column) >= scale.margin.left - 1e-9 && scale.x(node.column) <= scale.width);
        assert.ok(Math.abs(scale.value(scale.y(node.value)) - node.value) < 1e-9);
      });
    }
  },

  "colours of neighbours differ in lightness"() {
    const {view} = subjects[0], neighbors = view.neighbors();
    const luminance = color => 0.2126 * color[0] + 0.7152 * color[1] + 0.0722 * color[2];
    const colors = page.distinctColors(neighbors).map(luminance);
    let tooNear = 0, pairs = 0;
    neighbors.forEach((around, i) => around.forEach(j => {
      assert.ok(neighbors[j].includes(i));
      ++pairs;
      tooNear += Math.abs(colors[i] - colors[j]) < 0.03 ? 1 : 0;
    }));
    assert.ok(tooNear < 0.05 * pairs, tooNear + " of " + pairs);
    for (let i = 1; i <= 64; ++i)
      assert.ok(luminance(page.viridis(i / 64)) > luminance(page.viridis((i - 1) / 64)));
    assert.strictEqual(page.toHex([1, 0, 0.5]), "#ff0080");
  },

  "tubes are around their lines"() {
    const points = [0, 0, 0, 1, 0, 0, 1, 0, 0, 1, 1, 0, 1, 1, 3];
    const single = {points: [5, 5, 5], isClosed: true, id: 8};
    const tubes = page.buildTubes([{points, isClosed: false, id: 7}, single], 0.1, 6);
    assert.strictEqual(tubes.positions.length, 3 * 6 * 4);
    assert.strictEqual(tubes.triangles.length, 3 * 2 * 6 * 3);
    assert.ok(tubes.ids.every(id => id === 7) && tubes.positions.every(isFinite));
    for (let i = 0; i < 6; ++i) {
      assert.ok(Math.abs(Math.hypot(tubes.positions[3 * i + 1], tubes.positions[3 * i + 2]) - 0.1) < 1e-6);
      assert.ok(Math.abs(tubes.positions[3 * i]) < 1e-6);
    }
    const ring = page.buildTubes([{points: [0, 0, 0, 1, 0, 0, 0, 1, 0], isClosed: true, id: 0}], 0.1, 5);
    assert.strictEqual(ring.triangles.length, 3 * 2 * 5 * 3);
  },

  "the view is upright and shows all"() {
    const {positions, values} = subjects[1].data.surface;
    const pose = page.findPose({positions, values, triangles: []});
    assert.ok(pose.up[2] > 0.9999);
    const tilted = Float64Array.from(values, (_, v) => positions[3 * v] + positions[3 * v + 1]);
    assert.ok(Math.abs(page.findPose({positions, values: tilted, triangles: []}).up[0] - Math.SQRT1_2) < 1e-4);
    const near = page.distanceToSeeAll(positions, pose, 32, 1), far = page.distanceToSeeAll(positions, pose, 32, 0.5);
    assert.ok(near > 0.5 * pose.size && far > near);
    assert.ok(page.findPose({positions: [], values: [], triangles: []}).size > 0);
  },

  "up is what is named, a height, where the surface stands, or y"() {
    const upOf = (mesh, values, name) => page.findPose({
      positions: Float32Array.from([].concat(...mesh.points)), triangles: [].concat(...mesh.triangles), values
    }, name).up.map(x => Math.round(x) + 0);
    const noise = mesh => mesh.points.map((_, v) => Math.sin(37 * v));
    const torus = meshes.torus(48, 24, 0.1), x = torus.points.map(point => point[0]);
    assert.deepStrictEqual(upOf(torus, x), [1, 0, 0]);
    assert.deepStrictEqual(upOf(torus, x, "-y"), [0, -1, 0]);
    assert.deepStrictEqual(upOf(torus, x, "z"), [0, 0, 1]);
    assert.deepStrictEqual(upOf(torus, noise(torus)), [0, 0, 1]);
    const turned = order => ({
      points: torus.points.map(point => order.map(i => point[i])), triangles: torus.triangles
    });
    assert.deepStrictEqual(upOf(turned([0, 2, 1]), noise(torus)), [0, 1, 0]); // as tall in y as it is wide
    for (const [axis, sign] of [[0, 1], [1, 1], [2, 1], [0, -1], [1, -1], [2, -1]]) {
      const standing = meshes.torus(48, 24, 0.1), coordinates = standing.points.map(point => sign * point[axis]);
      const low = Math.min(...coordinates), high = Math.max(...coordinates);
      standing.points.forEach(point => { // cut flat at a fifth of its height
        point[axis] = sign * Math.max(sign * point[axis], low + 0.2 * (high - low));
      });
      const up = [0, 0, 0];
      up[axis] = sign;
      assert.deepStrictEqual(upOf(standing, noise(standing)), up);
    }
  },

  "patches are measured"() {
    // a square of two patches, and a triangle alone
    const positions = [0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0, 5, 0, 0, 8, 0, 0, 5, 4, 0];
    const patches = page.measurePatches({
      positions, triangles: [0, 1, 2, 0, 2, 3, 4, 5, 6], facePatches: [0, 2, 3]
    });
    assert.deepStrictEqual(patches.map(patch => patch.number), [0, 2, 3]);
    [[0.5, 2 + Math.SQRT2], [0.5, 2 + Math.SQRT2], [6, 12]].forEach(([area, borderLength], i) => {
      assert.ok(Math.abs(patches[i].area - area) < 1e-12);
      assert.ok(Math.abs(patches[i].borderLength - borderLength) < 1e-12);
      assert.deepStrictEqual(patches[i].normal, [0, 0, 1]);
    });
    const whole = page.measurePatches({positions, triangles: [0, 1, 2, 0, 2, 3], facePatches: [1, 1]});
    assert.ok(whole.length === 1 && Math.abs(whole[0].borderLength - 4) < 1e-12);
  },

  "ticks are levels whose graphs are those of the thresholds"() {
    for (const {name, data} of subjects) {
      const {ticks, levels} = data;
      assert.ok(ticks.length <= 6 && ticks.filter(tick => tick.is_suggested).length <= 1);
      ticks.forEach(({level, threshold}) => {
        assert.ok(levels[level].threshold <= threshold, name);
        assert.ok(level + 1 === levels.length || levels[level + 1].threshold > threshold, name);
        const report = JSON.parse(run("compute", name + ".off", "--field", "z", "--json", "--simplify",
                                      String(threshold), "--cancel-loops"));
        const graph = level === 0 ? data.graph : levels[level].graph;
        assert.strictEqual(graph.nodes.length, report.simplified.nodes, name);
      });
    }
    assert.ok(subjects[0].data.ticks.length > 0);
  },

  "normals are smooth, except across sharp edges"() {
    const normals = (positions, triangles) => Array.from(page.cornerNormals(positions, triangles), x => x / 127);
    const bent = height => normals([0, 0, 0, 1, 0, 0, 0, 1, 0, 0, -1, height], [0, 1, 2, 0, 3, 1]);
    assert.deepStrictEqual(bent(-1e6).slice(0, 3).map(Math.round), [0, 0, 1]);
    const flat = bent(0);
    for (let corner = 0; corner < 6; ++corner)
      assert.deepStrictEqual(flat.slice(4 * corner, 4 * corner + 3).map(Math.abs), [0, 0, 1]);
    const slightly = bent(-0.3);
    assert.ok(slightly[1] < -0.1 && slightly[2] > 0.9, "the mean of both sides");
    assert.deepStrictEqual(slightly.slice(0, 3), slightly.slice(12, 15));
  },

  "numbers are short"() {
    const written = [0, -2.5, 0.1, 12345678, 123456, 0.00001234, Infinity, null].map(page.formatNumber);
    assert.deepStrictEqual(written, ["0", "−2.5", "0.1", "1.235e7", "123456", "1.234e−5", "∞", "–"]);
    assert.strictEqual(page.formatValue(3, "mm"), "3 mm");
    assert.deepStrictEqual(page.niceTicks(-1, 1, 4), [-1, -0.5, 0, 0.5, 1]);
    assert.deepStrictEqual(page.niceTicks(2, 2, 4), [2]);
  },

  "two shapes are joined"() {
    const [one, other] = subjects;
    run("compare", "torus.off", "smooth_torus.off", "--field", "z", "--simplify", "20%", "--html", "two.html");
    const data = page.readPageData(page.dataOfPage(path.join(folder, "two.html"))), view = new page.GraphView(data, 0);
    const [first, second] = data.shapes, {values, triangles, vertexArcs, positions} = data.surface;
    assert.strictEqual(data.title, "torus.off and smooth_torus.off");
    assert.strictEqual(values.length, one.data.surface.values.length + other.data.surface.values.length);
    assert.strictEqual(Math.max(...triangles), values.length - 1);
    assert.strictEqual(Math.max(...vertexArcs), view.arcs.length - 1);
    assert.ok(positions[positions.length - 3] > 20 * other.data.surface.positions[0], "it is out of sight");
    view.arcs.forEach((arc, i) => {
      const isFirst = i < second.firstArc, partner = data.partners[i];
      assert.strictEqual(arc.source < second.firstNode, isFirst);
      assert.strictEqual(view.nameOf(i, "firstArc"),
                         isFirst ? i + " of " + first.title : i - second.firstArc + " of " + second.title);
      assert.deepStrictEqual(view.litWith(i), partner === null ? [i] : [i, partner]);
      assert.ok(partner === null || (data.partners[partner] === i && (partner < second.firstArc) !== isFirst));
      const contour = page.makeContourTracer(data)(view, i, 0.5);
      assert.ok(contour.points.length > 8 && (contour.points[0] > 20) !== isFirst);
    });
    const colors = page.colorsOfPartners(view);
    data.partners.forEach((partner, i) =>
      assert.deepStrictEqual(colors[i], partner === null ? [0.6, 0.6, 0.6] : colors[partner]));
    assert.strictEqual(data.partners.filter(partner => partner !== null).length, 8);
  },

  "patches that touch are neighbours"() {
    assert.deepStrictEqual(page.findPatchNeighbors([0, 1, 2, 2, 1, 3, 3, 4, 5, 6, 7, 8], [0, 1, 1, 2]), [[1], [0], []]);
  }
};

for (const name of Object.keys(tests)) {
  tests[name]();
  console.log("ok: " + name);
}
