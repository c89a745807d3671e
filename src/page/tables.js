// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial

/* global THREE, viridis */
/* exported ColorTable, makeFieldColors, makeMaterial, unlit, lit, dimmed */

// Tables of colours that shaders read, and materials.

// What alpha says of a colour in a table.
const unlit = 127, lit = 255, dimmed = 0;

// A table of colours with an alpha each, 256 to a row.
class ColorTable {
  constructor(size) {
    this.size = size;
    this.rows = Math.max(1, Math.ceil(size / 256));
    this.bytes = new Uint8Array(4 * 256 * this.rows).fill(unlit);
    this.texture = new THREE.DataTexture(this.bytes, 256, this.rows, THREE.RGBAFormat);
    this.texture.magFilter = this.texture.minFilter = THREE.NearestFilter;
    this.texture.needsUpdate = true;
  }

  setColor(i, color) {
    color.forEach((x, channel) => {
      this.bytes[4 * i + channel] = Math.round(255 * x);
    });
    this.texture.needsUpdate = true;
  }

  // light(i) gives what alpha says.
  setLight(light) {
    for (let i = 0; i < this.size; ++i)
      this.bytes[4 * i + 3] = light(i);
    this.texture.needsUpdate = true;
  }
}

function makeFieldColors() {
  const table = new ColorTable(256);
  for (let i = 0; i < 256; ++i)
    table.setColor(i, viridis(i / 255));
  table.texture.magFilter = table.texture.minFilter = THREE.LinearFilter;
  return table.texture;
}

function makeMaterial(vertexShader, fragmentShader, uniforms, options) {
  return new THREE.ShaderMaterial(Object.assign({vertexShader, fragmentShader, uniforms, side: THREE.DoubleSide},
                                                options));
}
