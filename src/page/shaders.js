// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial

/* exported shaders */

// The shaders, in GLSL ES 1.00. Colours that change are in small textures, so that pointing at an arc changes a few
// texels and no buffer. In them, alpha says whether something is lit: 1, as usual: 0.5, or dimmed: 0.

const shaderParts = {
  texel: `
    vec4 texel(sampler2D table, float number, float rows) {
      float i = floor(number + 0.5);
      float row = floor(i / 256.0);
      return texture2D(table, vec2((i - 256.0 * row + 0.5) / 256.0, (row + 0.5) / rows));
    }
    vec3 numberToColor(float number) {
      float i = floor(number + 0.5);
      float high = floor(i / 65536.0), middle = floor((i - 65536.0 * high) / 256.0);
      return vec3(high, middle, i - 65536.0 * high - 256.0 * middle) / 255.0;
    }`,
  light: `
    float light(vec3 normal, vec3 toEye) {
      vec3 n = normalize(normal);
      n = dot(n, toEye) < 0.0 ? -n : n;
      float shine = pow(max(dot(n, normalize(vec3(0.25, 0.45, 0.86))), 0.0), 40.0);
      return 0.5 + 0.5 * max(dot(n, normalize(vec3(0.3, 0.5, 0.8))), 0.0) + 0.12 * shine;
    }`,
  eye: `
    varying vec3 vNormal;
    varying vec3 vToEye;
    void lookFrom(vec3 point) {
      vec4 eye = modelViewMatrix * vec4(point, 1.0);
      vNormal = normalMatrix * normal;
      vToEye = -eye.xyz;
      gl_Position = projectionMatrix * eye;
    }`,
  place: `
    varying float vValue;
    varying vec3 vBands;
    varying vec2 vEnds;
    float place() { return vValue < vEnds.x ? vBands.x : vValue < vEnds.y ? vBands.y : vBands.z; }`
};

const shaders = {
  surfaceVertex: `
    attribute float value;
    attribute vec3 bands;
    attribute vec2 ends;
    attribute float patchNumber;
    varying float vValue;
    varying vec3 vBands;
    varying vec2 vEnds;
    varying float vPatch;
    ${shaderParts.eye}
    void main() {
      vValue = value;
      vBands = bands;
      vEnds = ends;
      vPatch = patchNumber;
      lookFrom(position);
    }`,
  surfaceFragment: `
    uniform int coloring;
    uniform float opacity;
    uniform float levelLines;
    uniform vec3 dimColor;
    uniform sampler2D fieldColors;
    uniform sampler2D placeColors;
    uniform float placeRows;
    uniform sampler2D patchColors;
    uniform float patchRows;
    varying float vPatch;
    varying vec3 vNormal;
    varying vec3 vToEye;
    ${shaderParts.place}
    ${shaderParts.texel}
    ${shaderParts.light}
    void main() {
      vec4 here = texel(placeColors, place(), placeRows);
      vec3 color = coloring == 0 ? texture2D(fieldColors, vec2(vValue, 0.5)).rgb
        : coloring == 1 ? here.rgb : texel(patchColors, vPatch, patchRows).rgb;
      if (levelLines > 0.0) {
        float x = vValue * levelLines;
        float distanceToLine = abs(fract(x - 0.5) - 0.5) / max(fwidth(x), 1e-6);
        color *= 0.45 + 0.55 * smoothstep(0.3, 1.3, distanceToLine);
      }
      vec3 toEye = normalize(vToEye);
      float facing = abs(dot(normalize(vNormal), toEye));
      // Glass: it shows more of the inside where one looks straight at it.
      float alpha = opacity + (1.0 - opacity) * 0.75 * pow(1.0 - facing, 2.0) * step(0.001, opacity);
      if (here.a > 0.75) {
        color = mix(color, vec3(1.0), 0.08);
        alpha = min(1.0, alpha + 0.25);
      } else if (here.a < 0.25) {
        color = mix(color, dimColor, 0.8);
        alpha *= 0.65;
      }
      gl_FragColor = vec4(color * light(vNormal, toEye), alpha);
    }`,
  surfaceNumberFragment: `
    ${shaderParts.place}
    ${shaderParts.texel}
    void main() { gl_FragColor = vec4(numberToColor(place() + 1.0), 1.0); }`,
  tubeVertex: `
    attribute float number;
    attribute float value;
    uniform float inflation;
    varying float vNumber;
    varying float vValue;
    ${shaderParts.eye}
    void main() {
      vNumber = number;
      vValue = value;
      lookFrom(position + inflation * normal);
    }`,
  tubeFragment: `
    uniform float isValueShown;
    uniform sampler2D fieldColors;
    uniform sampler2D colors;
    uniform float rows;
    uniform vec3 dimColor;
    uniform float alpha;
    varying float vNumber;
    varying float vValue;
    varying vec3 vNormal;
    varying vec3 vToEye;
    ${shaderParts.texel}
    ${shaderParts.light}
    void main() {
      vec4 here = texel(colors, vNumber, rows);
      vec3 color = mix(here.rgb, texture2D(fieldColors, vec2(vValue, 0.5)).rgb, isValueShown);
      color = here.a < 0.25 ? mix(color, dimColor, 0.7) : color;
      gl_FragColor = vec4(color * light(vNormal, normalize(vToEye)), alpha);
    }`,
  tubeNumberFragment: `
    uniform float firstNumber;
    varying float vNumber;
    ${shaderParts.texel}
    void main() { gl_FragColor = vec4(numberToColor(vNumber + firstNumber), 1.0); }`,
  ballVertex: `
    ${shaderParts.eye}
    void main() { lookFrom(position); }`,
  ballFragment: `
    uniform vec3 color;
    varying vec3 vNormal;
    varying vec3 vToEye;
    void main() {
      float facing = dot(normalize(vNormal), normalize(vToEye));
      float r = sqrt(max(0.0, 1.0 - facing * facing));
      float pixelsToOutline = (1.0 - r) / max(fwidth(r), 1e-6);
      gl_FragColor = vec4(color, mix(0.9, 0.16, smoothstep(0.8, 2.2, pixelsToOutline)));
    }`,
  nodeVertex: `
    attribute float number;
    uniform sampler2D colors;
    uniform float rows;
    uniform float size;
    uniform float tubeRadius;
    varying float vNumber;
    varying vec4 vColor;
    ${shaderParts.texel}
    void main() {
      vNumber = number;
      vColor = texel(colors, number, rows);
      vec4 eye = modelViewMatrix * vec4(position, 1.0);
      // Nodes are before the tubes that end at them.
      eye.xyz *= max(0.1, 1.0 - 1.5 * tubeRadius / length(eye.xyz));
      gl_Position = projectionMatrix * eye;
      gl_PointSize = size * (vColor.a > 0.75 ? 1.45 : 1.0);
    }`,
  nodeFragment: `
    uniform vec3 outline;
    varying vec4 vColor;
    void main() {
      vec2 p = 2.0 * gl_PointCoord - 1.0;
      float r = length(p);
      if (r > 1.0) discard;
      vec3 normal = vec3(p.x, -p.y, sqrt(max(0.0, 1.0 - r * r)));
      float lit = 0.62 + 0.38 * max(dot(normal, normalize(vec3(0.3, 0.5, 0.8))), 0.0);
      gl_FragColor = vec4(mix(vColor.rgb * lit, outline, smoothstep(0.7, 0.82, r)), 1.0);
    }`,
  nodeNumberFragment: `
    uniform float firstNumber;
    varying float vNumber;
    ${shaderParts.texel}
    void main() {
      if (length(2.0 * gl_PointCoord - 1.0) > 1.0) discard;
      gl_FragColor = vec4(numberToColor(vNumber + firstNumber), 1.0);
    }`
};
