// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial

/* exported niceTicks, formatNumber, formatValue, makePlaneScale */

// Numbers as they are shown, and the scale of the plane drawing.

// Round values between two, about `count` of them.
function niceTicks(low, high, count) {
  const step = (high - low) / Math.max(count, 1);
  if (!(step > 0) || !isFinite(step))
    return [low];
  const power = Math.pow(10, Math.floor(Math.log10(step)));
  const nice = [1, 2, 5, 10].map(factor => factor * power).find(candidate => candidate >= 0.99 * step);
  const ticks = [];
  for (let i = Math.ceil(low / nice - 1e-9); i * nice <= high + 1e-9 * nice; ++i)
    ticks.push(i * nice);
  return ticks;
}

// A number with about four digits.
function formatNumber(x) {
  if (x === null || x === undefined || isNaN(x))
    return "–";
  if (!isFinite(x))
    return x < 0 ? "−∞" : "∞";
  const magnitude = Math.abs(x);
  const text = magnitude !== 0 && (magnitude < 1e-3 || magnitude >= 1e7) ? x.toExponential(3)
    : magnitude >= 1000 ? x.toFixed(0) : x.toPrecision(4);
  const short = text.includes(".") ? text.replace(/\.?0+(?=e|$)/, "") : text;
  return short.replace("e+", "e").replace("-", "−");
}

function formatValue(x, unit) {
  return formatNumber(x) + (unit ? " " + unit : "");
}

// From columns and values to the pixels of a drawing that is at least as large as its frame.
function makePlaneScale(view, range, frame) {
  const margin = {left: 70, right: 22, top: 18, bottom: 18};
  let low = Infinity, high = -Infinity;
  const add = column => {
    low = Math.min(low, column);
    high = Math.max(high, column);
  };
  view.nodes.forEach(node => add(node.column));
  view.arcs.forEach(arc => arc.plane.forEach((x, i) => i % 2 === 0 && add(x)));
  const columns = Math.max(high - low, 0);
  const inner = frame.width - margin.left - margin.right;
  const columnWidth = columns > 0 ? Math.max(Math.min(inner / columns, 110), 13) : 0;
  const width = Math.max(frame.width, margin.left + margin.right + columns * columnWidth);
  const height = Math.max(frame.height, 180);
  const free = width - margin.left - margin.right - columns * columnWidth;
  const valueHeight = (height - margin.top - margin.bottom) / (range.high > range.low ? range.high - range.low : 1);
  return {
    width, height, margin,
    x: column => margin.left + free / 2 + (column - low) * columnWidth,
    y: value => height - margin.bottom - (value - range.low) * valueHeight,
    value: y => range.low + (height - margin.bottom - y) / valueHeight,
    nodeRadius: Math.max(3, Math.min(7, columnWidth > 0 ? columnWidth / 4 : 7))
  };
}
