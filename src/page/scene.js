// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial

/* global THREE, ColorTable, ViewCamera, buildTubes, dimmed, findPose, lit, loopColors, makeFieldColors,
   makeMaterial, makeSurfaceGeometry, makeSurfaceMaterials, nearestPlace, normalizedValue, partsInJunctions, rangeOf,
   shaders, unlit, waysAlong */
/* exported Scene */

// The view in space: the surface, the graph in it, curves and a contour. It is drawn when something has changed only.

const coloringNumbers = {field: 0, arcs: 1, patches: 2};

// How thick tubes are, relative to few of them: the more there are, the thinner.
function thicknessOf(number, few) {
  return Math.max(0.4, Math.min(1, Math.sqrt(few / number)));
}

class Scene {
  constructor(canvas, data) {
    this.canvas = canvas;
    this.data = data;
    this.renderer = new THREE.WebGLRenderer({canvas, alpha: true, antialias: true, preserveDrawingBuffer: true});
    this.scene = new THREE.Scene();
    this.numberScene = new THREE.Scene();
    this.numberTarget = new THREE.WebGLRenderTarget(1, 1, {
      minFilter: THREE.NearestFilter, magFilter: THREE.NearestFilter, generateMipmaps: false
    });
    this.areNumbersOld = true;
    this.isDrawingRequested = false;
    this.drawings = 0;
    this.pose = findPose(data.posedSurface, data.up);
    this.fieldColors = makeFieldColors();
    this.dimColor = new THREE.Color(0.7, 0.7, 0.7);
    this.outline = new THREE.Color(0.1, 0.1, 0.1);
    this.layers = {surface: true, graph: true, curves: true};
    this.makeSurface();
    this.makeCurves();
    this.makeBall();
    this.eye = this.makeEye();
  }

  makeEye() {
    return new ViewCamera(this.canvas, this.data.surface.seenPositions, this.pose, () => this.requestDrawing());
  }

  // Looks at the surface with this way upwards: x, y, z, -x, -y, -z, or "" for the one that is found.
  setUp(name) {
    this.pose = findPose(this.data.posedSurface, name);
    this.eye.dispose();
    this.eye = this.makeEye();
    this.eye.setAspect(this.widthOfShape / this.height);
    this.requestDrawing();
  }

  makeSurface() {
    const {surface, graph} = this.data, {facePatches} = surface;
    const geometry = makeSurfaceGeometry(this.data, this.pose.center);
    this.placeTable = new ColorTable(graph.arcs.length + graph.nodes.length);
    this.patchTable = new ColorTable(facePatches ? rangeOf(facePatches).high + 1 : 1);
    this.surfaceUniforms = {
      coloring: {value: 0}, opacity: {value: 1}, levelLines: {value: 0}, dimColor: {value: this.dimColor},
      fieldColors: {value: this.fieldColors},
      placeColors: {value: this.placeTable.texture}, placeRows: {value: this.placeTable.rows},
      patchColors: {value: this.patchTable.texture}, patchRows: {value: this.patchTable.rows}
    };
    const materials = makeSurfaceMaterials(this.surfaceUniforms);
    // The depth comes first, so that of a see-through surface the nearest layer is seen only.
    this.surfaceLayers = [materials.depth, materials.color].map((material, i) =>
      this.add(this.scene, geometry, material, 10 + i));
    this.surfaceNumbers = this.add(this.numberScene, geometry, materials.number, 0);
  }

  add(scene, geometry, material, order, Kind = THREE.Mesh) {
    const object = new Kind(geometry, material);
    object.renderOrder = order;
    object.frustumCulled = false;
    scene.add(object);
    return object;
  }

  remove(objects) {
    objects.forEach(({scene, object}) => {
      scene.remove(object);
      object.geometry.dispose();
      object.material.dispose();
    });
  }

  tubeGeometry(polylines, radius, sides, value) {
    const center = this.pose.center;
    const centered = polylines.map(polyline => Object.assign({}, polyline, {
      points: Array.from(polyline.points, (x, i) => x - center[i % 3])
    }));
    const tubes = buildTubes(centered, radius, sides);
    const geometry = new THREE.BufferGeometry();
    geometry.setAttribute("position", new THREE.BufferAttribute(tubes.positions, 3));
    geometry.setAttribute("normal", new THREE.BufferAttribute(tubes.normals, 3));
    geometry.setAttribute("number", new THREE.BufferAttribute(tubes.ids, 1));
    const values = tubes.ids.map((id, i) => normalizedValue(value(id, tubes.places[i]), this.data.range));
    geometry.setAttribute("value", new THREE.BufferAttribute(values, 1));
    geometry.setIndex(new THREE.BufferAttribute(tubes.triangles, 1));
    return geometry;
  }

  tubeMaterial(table, options) {
    return makeMaterial(shaders.tubeVertex, shaders.tubeFragment, {
      isValueShown: {value: 0}, fieldColors: {value: this.fieldColors}, colors: {value: table.texture},
      rows: {value: table.rows}, dimColor: {value: this.dimColor}, inflation: {value: 0}, alpha: {value: 1}
    }, options);
  }

  makeCurves() {
    this.curves = [];
    this.polylines = this.data.curves.map((curve, id) => Object.assign({id}, curve));
    this.curveTable = new ColorTable(this.polylines.length);
    if (this.polylines.length > 0) {
      const radius = 0.0032 * thicknessOf(this.polylines.length, 12) * this.pose.size;
      const geometry = this.tubeGeometry(this.polylines, radius, 6, () => 0);
      this.curves.push(this.add(this.scene, geometry, this.tubeMaterial(this.curveTable, {}), 0));
    }
    this.contourTable = new ColorTable(1);
    this.litTable = new ColorTable(1);
    this.contour = [];
    this.graph = [];
    this.litArc = [];
    this.litLoop = [];
  }

  // A sphere of radius 1, which shines through what is before it.
  makeBall() {
    this.ballColor = new THREE.Color();
    const material = makeMaterial(shaders.ballVertex, shaders.ballFragment, {color: {value: this.ballColor}}, {
      side: THREE.FrontSide, depthTest: false, depthWrite: false, transparent: true, extensions: {derivatives: true}
    });
    this.ball = this.add(this.scene, new THREE.SphereGeometry(1, 64, 48), material, 18);
    this.ball.visible = false;
  }

  // Shows the ball at a place of a line of a skeleton, or none.
  setBall(ball) {
    this.ball.visible = ball !== null && ball.inscribedRadius > 0;
    if (this.ball.visible) {
      this.ball.position.set(...ball.point.map((x, i) => x - this.pose.center[i]));
      this.ball.scale.setScalar(ball.inscribedRadius);
    }
    this.requestDrawing(true);
  }

  resize(width, height) {
    this.width = Math.max(1, Math.floor(width));
    this.height = Math.max(1, Math.floor(height));
    this.renderer.setPixelRatio(Math.min(window.devicePixelRatio || 1, 2));
    this.renderer.setSize(this.width, this.height, false);
    this.numberTarget.setSize(this.width, this.height);
    this.eye.setAspect(this.widthOfShape / this.height);
    this.areNumbersOld = true;
    this.draw(); // at once, as the canvas is empty with another size
  }

  // Shows the graph of a view, whose arcs have these colours; nodes are coloured by `nodeColor(node)`.
  setView(view, arcColors, nodeColor) {
    this.remove(this.graph);
    this.view = view;
    this.arcTable = new ColorTable(view.arcs.length);
    this.junctionTable = new ColorTable(view.arcs.length);
    this.arcColors = arcColors;
    this.nodeTable = new ColorTable(view.nodes.length);
    view.nodes.forEach((node, i) => this.nodeTable.setColor(i, nodeColor(node)));
    for (let place = 0; place < this.placeTable.size; ++place) {
      const arc = view.placeOf(place);
      this.placeTable.setColor(place, arc >= 0 ? arcColors[arc] : [0.6, 0.6, 0.6]);
    }
    this.graph = this.makeGraph();
    this.setTubeColors();
    this.setLit(null);
  }

  // The tubes and the nodes of the graph, to be seen and to be pointed at.
  makeGraph() {
    const {view} = this;
    const thickness = thicknessOf(view.arcs.length, 36);
    const radius = this.tubeRadius = 0.006 * thickness * this.pose.size;
    const polylines = view.arcs.map((arc, id) => ({points: arc.polyline, isClosed: false, id}));
    const tubes = this.tubeGeometry(polylines, radius, 8, (arc, t) => this.valueOnTube(arc, t));
    const nodes = this.nodeGeometry(view), size = 5 + 10 * thickness;
    const nodeUniforms = {
      colors: {value: this.nodeTable.texture}, rows: {value: this.nodeTable.rows},
      size: {value: size * this.renderer.getPixelRatio()}, outline: {value: this.outline},
      tubeRadius: {value: radius}
    };
    const firstArc = this.placeTable.size + 1, firstNode = firstArc + view.arcs.length;
    const tubeNumbers = makeMaterial(shaders.tubeVertex, shaders.tubeNumberFragment,
                                     {inflation: {value: 0.6 * radius}, firstNumber: {value: firstArc}}, {});
    const nodeNumbers = makeMaterial(shaders.nodeVertex, shaders.nodeNumberFragment,
                                     Object.assign({}, nodeUniforms, {size: {value: 1.2 * size},
                                                                      tubeRadius: {value: 1.2 * radius},
                                                                      firstNumber: {value: firstNode}}), {});
    const nodeMaterial = makeMaterial(shaders.nodeVertex, shaders.nodeFragment, nodeUniforms, {});
    const sleeves = [].concat(...view.arcs.map((arc, id) => this.junctionLines(arc, id)));
    const parts = [
      [this.scene, tubes, this.tubeMaterial(this.arcTable, {}), 0, THREE.Mesh],
      [this.scene, nodes, nodeMaterial, 1, THREE.Points],
      [this.numberScene, tubes, tubeNumbers, 20, THREE.Mesh],
      [this.numberScene, nodes, nodeNumbers, 21, THREE.Points]
    ].concat(sleeves.length === 0 ? [] : [
      [this.scene, this.tubeGeometry(sleeves, 1.2 * radius, 8, () => 0), this.tubeMaterial(this.junctionTable, {}), 0,
       THREE.Mesh]
    ]).map(([scene, geometry, material, order, Kind]) =>
      ({scene, object: this.add(scene, geometry, material, order, Kind)}));
    // What is pointed at is the graph rather than the surface before it.
    parts[2].object.onBeforeRender = renderer => renderer.clearDepth();
    return parts;
  }

  junctionLines(arc, id) {
    return partsInJunctions(arc).map(points => ({points, isClosed: false, id}));
  }

  // The value of an arc at a share of its points: on a skeleton, the way along the lines.
  valueOnTube(arc, t) {
    const {polyline, junctions} = this.view.arcs[arc];
    if (!junctions)
      return this.view.value(arc, t);
    const ways = waysAlong(polyline), last = ways.length - 1, way = ways[Math.round(t * last)];
    return Math.min(this.view.lower(arc).value + way, this.view.upper(arc).value + ways[last] - way);
  }

  nodeGeometry(view) {
    const geometry = new THREE.BufferGeometry(), center = this.pose.center;
    const points = [].concat(...view.nodes.map(node => node.point.map((x, i) => x - center[i])));
    geometry.setAttribute("position", new THREE.BufferAttribute(new Float32Array(points), 3));
    const numbers = new Float32Array(view.nodes.map((_, i) => i));
    geometry.setAttribute("number", new THREE.BufferAttribute(numbers, 1));
    return geometry;
  }

  setTubeColors() {
    const isByArcs = this.coloring === "arcs";
    this.view.arcs.forEach((_, i) => {
      this.arcTable.setColor(i, isByArcs ? this.arcColors[i] : this.lineColor);
      this.junctionTable.setColor(i, this.junctionColor);
    });
    this.showLayers();
    this.requestDrawing(true);
  }

  setColoring(coloring) {
    this.coloring = coloring;
    this.surfaceUniforms.coloring.value = coloringNumbers[coloring];
    if (this.view)
      this.setTubeColors();
    this.requestDrawing(true);
  }

  setPatchColors(colors) {
    colors.forEach((color, i) => i < this.patchTable.size && this.patchTable.setColor(i, color));
    this.requestDrawing(true);
  }

  // The colours that go with the background of the page.
  setTheme(theme) {
    this.lineColor = theme.line;
    this.junctionColor = theme.junction;
    this.ballColor.setRGB(...theme.contour);
    this.dimColor.setRGB(...theme.dim);
    this.outline.setRGB(...theme.outline);
    this.polylines.forEach(({id}) => {
      const loop = this.data.loops[id];
      this.curveTable.setColor(id, loop ? loopColors[loop.kind] : theme.curve);
    });
    this.contourTable.setColor(0, theme.contour);
    this.litTable.setColor(0, theme.line);
    if (this.view)
      this.setTubeColors();
    this.requestDrawing(true);
  }

  setOpacity(opacity) {
    this.surfaceUniforms.opacity.value = opacity;
    this.setLayers(this.layers);
  }

  setLevelLines(count) {
    this.surfaceUniforms.levelLines.value = count;
    this.requestDrawing(true);
  }

  setLayers(layers) {
    this.layers = layers;
    this.showLayers();
    this.requestDrawing();
  }

  get isSurfaceSeen() {
    return this.layers.surface && this.surfaceUniforms.opacity.value > 0;
  }

  // Lines without a surface have the colors that it would have.
  showLayers() {
    this.surfaceLayers.concat(this.surfaceNumbers).forEach(layer => {
      layer.visible = this.isSurfaceSeen;
    });
    this.graph.slice(0, 1).forEach(({object}) => {
      object.material.uniforms.isValueShown.value = !this.layers.surface && this.coloring === "field" ? 1 : 0;
    });
    this.graph.concat(this.litArc).forEach(({object}) => {
      object.visible = this.layers.graph;
    });
    this.curves.forEach(object => {
      object.visible = this.layers.curves;
    });
  }

  // Lights an arc {arc} or a node {node} and dims the rest, or nothing.
  setLit(target) {
    const isArcLit = target !== null && target.arc !== undefined, arcs = isArcLit ? this.view.litWith(target.arc) : [];
    const light = arc => isArcLit ? (arcs.includes(arc) ? lit : dimmed) : unlit;
    this.placeTable.setLight(place => light(this.view.placeOf(place)));
    this.arcTable.setLight(light);
    this.junctionTable.setLight(light);
    const ends = [].concat(...arcs.map(arc => [this.view.arcs[arc].source, this.view.arcs[arc].target]));
    this.remove(this.litArc);
    const lines = arcs.map(arc => ({points: this.view.arcs[arc].polyline, isClosed: false, id: 0}));
    const sleeves = [].concat(...arcs.map(arc => this.junctionLines(this.view.arcs[arc], arc)));
    this.litArc = this.makeShiningTubes(lines, 1.3 * this.tubeRadius, this.litTable, 14).concat(
      this.makeShiningTubes(sleeves, 1.5 * this.tubeRadius, this.junctionTable, 16));
    this.showLayers();
    this.nodeTable.setLight(node => ends.includes(node) || (target && target.node === node) ? lit : unlit);
    this.requestDrawing(true);
  }

  // Lights a patch and dims the other ones, or none.
  setLitPatch(number) {
    this.patchTable.setLight(patch => number === null ? unlit : patch === number ? lit : dimmed);
    this.requestDrawing(true);
  }

  // The mean of the points of a curve, in the frame of the view.
  centerOfCurve(number) {
    const {points} = this.polylines[number], sums = [0, 0, 0];
    points.forEach((x, i) => {
      sums[i % 3] += 3 * x / points.length;
    });
    return sums.map((x, i) => x - this.pose.center[i]);
  }

  // Lights one of the loops and dims the other ones, or none.
  setLitLoop(number) {
    this.remove(this.litLoop);
    const lines = number === null ? [] : [this.polylines[number]];
    this.litLoop = this.makeShiningTubes(lines, 0.006 * this.pose.size, this.curveTable, 16);
    this.curveTable.setLight(loop => number === null ? unlit : loop === number ? lit : dimmed);
    this.requestDrawing(true);
  }

  setContour(contour) {
    this.remove(this.contour);
    const lines = contour ? [Object.assign({id: 0}, contour)] : [];
    this.contour = this.makeShiningTubes(lines, 0.0042 * this.pose.size, this.contourTable, 12);
    this.requestDrawing(true);
  }

  // Tubes that shine through what is before them.
  makeShiningTubes(polylines, radius, table, order) {
    if (polylines.length === 0)
      return [];
    const geometry = this.tubeGeometry(polylines, radius, 8, () => 0);
    const hidden = this.tubeMaterial(table, {depthTest: false, depthWrite: false, transparent: true});
    hidden.uniforms.alpha.value = 0.4;
    return [hidden, this.tubeMaterial(table, {transparent: true})].map((material, i) =>
      ({scene: this.scene, object: this.add(this.scene, geometry, material, order + i)}));
  }

  // The numbers of what is pointed at are drawn again when they are asked for, if they may have changed.
  requestDrawing(areNumbersTheSame = false) {
    this.areNumbersOld = this.areNumbersOld || !areNumbersTheSame;
    if (this.isDrawingRequested)
      return;
    this.isDrawingRequested = true;
    requestAnimationFrame(() => {
      this.isDrawingRequested = false;
      this.draw();
    });
  }

  get widthOfShape() {
    return Math.max(1, Math.floor(this.width / this.data.shapes.length));
  }

  draw() {
    if (!this.width)
      return;
    ++this.drawings;
    this.render(this.scene, null);
  }

  // Draws the shapes side by side, on the canvas or another target, each as the eye sees it.
  render(scene, target) {
    const {renderer, widthOfShape, height} = this;
    this.data.shapes.forEach(({shift}, i) => {
      scene.position.x = -shift;
      const rectangle = [i * widthOfShape, 0, widthOfShape, height];
      if (target) {
        target.viewport.set(...rectangle);
        target.scissor.set(...rectangle);
        target.scissorTest = true;
      } else {
        renderer.setViewport(...rectangle);
        renderer.setScissor(...rectangle);
        renderer.setScissorTest(true);
      }
      renderer.setRenderTarget(target);
      renderer.clear();
      renderer.render(scene, this.eye.camera);
    });
  }

  // What is at a place of the canvas, in pixels of the page: {arc}, {node}, or null. Lines alone are thin: near is
  // enough.
  pick(x, y) {
    if (!this.width || x < 0 || y < 0 || x >= this.width || y >= this.height)
      return null;
    const isGraphSeen = this.layers.graph && !(this.isSurfaceSeen && this.surfaceUniforms.opacity.value >= 0.97);
    if (this.areNumbersOld) {
      this.graph.filter(({scene}) => scene === this.numberScene).forEach(({object}) => {
        object.visible = isGraphSeen;
      });
      const color = this.renderer.getClearColor(new THREE.Color()).clone(), alpha = this.renderer.getClearAlpha();
      this.renderer.setClearColor(0, 0);
      this.render(this.numberScene, this.numberTarget);
      this.renderer.setRenderTarget(null);
      this.renderer.setClearColor(color, alpha);
      this.areNumbersOld = false;
    }
    const reach = this.isSurfaceSeen ? 0 : 8, width = 2 * reach + 1, pixels = new Uint8Array(4 * width * width);
    const row = this.height - 1 - Math.floor(y);
    this.renderer.readRenderTargetPixels(this.numberTarget, Math.floor(x) - reach, row - reach, width, width, pixels);
    let number = 0, least = Infinity;
    for (let i = 0; i < width * width; ++i) {
      const found = 65536 * pixels[4 * i] + 256 * pixels[4 * i + 1] + pixels[4 * i + 2];
      const distance = Math.hypot(i % width - reach, Math.floor(i / width) - reach);
      if (found > 0 && distance < least) {
        least = distance;
        number = found;
      }
    }
    return this.targetOfNumber(number);
  }

  // The place of a line of a skeleton that is seen nearest to a place of the canvas.
  placeNear(number, x, y) {
    const {polyline} = this.view.arcs[number], points = [];
    for (let i = 0; i < polyline.length; i += 3)
      points.push(this.project(polyline.slice(i, i + 3)));
    return nearestPlace(points, waysAlong(polyline), [x, y]);
  }

  targetOfNumber(number) {
    if (number === 0)
      return null;
    let place = number - 1;
    if (place < this.placeTable.size) {
      place = this.view.placeOf(place);
      return place >= 0 ? {arc: place} : {node: -1 - place};
    }
    place -= this.placeTable.size;
    return place < this.view.arcs.length ? {arc: place} : {node: place - this.view.arcs.length};
  }

  // Where a point of the data is on the canvas, in pixels of the page.
  project(point) {
    const {shapes} = this.data, {shift, i} = shapes.map((shape, number) => ({shift: shape.shift, i: number}))
      .reduce((best, shape) => point[0] - this.pose.center[0] > shape.shift / 2 ? shape : best);
    const seen = point.map((x, axis) => x - this.pose.center[axis] - (axis === 0 ? shift : 0));
    const [x, y] = this.eye.project(seen, this.widthOfShape, this.height);
    return [x + i * this.widthOfShape, y];
  }
}
