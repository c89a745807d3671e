// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial

// The scripts of the page that need no browser, put together as the program does.
"use strict";

const fs = require("fs");
const path = require("path");

const folder = path.join(__dirname, "../../src/page");
const list = fs.readFileSync(path.join(folder, "scripts.cmake"), "utf8");
const names = /reeb_graph_page_scripts([^)]*)\)/.exec(list)[1].match(/\w+\.js/g);
const scripts = names.slice(0, names.indexOf("shaders.js"));
const text = scripts.map(name => fs.readFileSync(path.join(folder, name), "utf8")).join("\n");
const exported = Array.from(text.matchAll(/\/\* exported ([^*]*)\*\//g), match => match[1].trim()).join(", ");

module.exports = new Function("\"use strict\";\n" + text + "\nreturn {" + exported + "};")();

// The data in a page that the program has written.
module.exports.dataOfPage = function (file) {
  const html = fs.readFileSync(file, "utf8");
  return /id="reeb-graph-data">([^]*?)<\/script>/.exec(html)[1];
};
