// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial

/* exported viridis, distinctColors, kindColors, loopColors, toHex */

// Colours. All are arrays [red, green, blue] between 0 and 1.

// The colours of nodes by kind: from the palette of Okabe and Ito, which people with colour-blindness can tell apart.
const kindColors = {
  minimum: [0, 0.447, 0.698],
  saddle: [0.941, 0.894, 0.259],
  maximum: [0.835, 0.369, 0],
  "degree-two": [0, 0.62, 0.451],
  isolated: [0.8, 0.475, 0.655],
  // those of a skeleton
  end: [0.835, 0.369, 0],
  junction: [0.941, 0.894, 0.259],
  loop: [0.8, 0.475, 0.655]
};

// The colours of loops by kind.
const loopColors = {
  handle: [0.835, 0.369, 0],
  tunnel: [0, 0.447, 0.698],
  hole: [0, 0.62, 0.451],
  loop: [0.8, 0.475, 0.655]
};

// A polynomial close to matplotlib's viridis, by M. Zucker; t is between 0 and 1.
const viridisCoefficients = [
  [0.2777273272234177, 0.005407344544966578, 0.3340998053353061],
  [0.1050930431085774, 1.404613529898575, 1.384590162594685],
  [-0.3308618287255563, 0.214847559468213, 0.09509516302823659],
  [-4.634230498983486, -5.799100973351585, -19.33244095627987],
  [6.228269936347081, 14.17993336680509, 56.69055260068105],
  [4.776384997670288, -13.74514537774601, -65.35303263337234],
  [-5.435455855934631, 4.645852612178535, 26.3124352495832]
];

function clampToUnit(x) {
  return Math.min(Math.max(x, 0), 1);
}

function viridis(t) {
  return [0, 1, 2].map(channel =>
    clampToUnit(viridisCoefficients.reduceRight((sum, coefficients) => sum * t + coefficients[channel], 0)));
}

// From the perceptual space OKLCH of B. Ottosson: lightness and chroma between 0 and 1, hue in turns.
function fromLightnessChromaHue(lightness, chroma, hue) {
  const a = chroma * Math.cos(2 * Math.PI * hue), b = chroma * Math.sin(2 * Math.PI * hue);
  const l = Math.pow(lightness + 0.3963377774 * a + 0.2158037573 * b, 3);
  const m = Math.pow(lightness - 0.1055613458 * a - 0.0638541728 * b, 3);
  const s = Math.pow(lightness - 0.0894841775 * a - 1.291485548 * b, 3);
  return [
    4.0767416621 * l - 3.3077115913 * m + 0.2309699292 * s,
    -1.2684380046 * l + 2.6097574011 * m - 0.3413193965 * s,
    -0.0041960863 * l - 0.7034186147 * m + 1.707614701 * s
  ].map(x => clampToUnit(x <= 0.0031308 ? 12.92 * x : 1.055 * Math.pow(x, 1 / 2.4) - 0.055));
}

const lightnesses = [0.78, 0.56, 0.88, 0.67, 0.46];

// As many colours as there are elements of `neighbors`, in which those of neighbours differ in lightness where five
// lightnesses are enough, so that nobody has to tell hues apart. neighbors[i] has the numbers of the neighbours of i.
function distinctColors(neighbors) {
  const tiers = [];
  return neighbors.map((around, i) => {
    const used = around.filter(j => j < i).map(j => tiers[j]);
    const uses = lightnesses.map((_, tier) => used.filter(u => u === tier).length);
    const preferred = i % 2;
    tiers[i] = uses[preferred] === 0 ? preferred : uses.indexOf(Math.min(...uses));
    return fromLightnessChromaHue(lightnesses[tiers[i]], 0.13, i * 0.381966 + 0.08);
  });
}

function toHex(color) {
  return "#" + color.map(x => Math.round(255 * x).toString(16).padStart(2, "0")).join("");
}
