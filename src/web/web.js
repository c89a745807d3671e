// The page that runs the program: it makes command lines, hands them to the worker, and shows what comes back.
/* global DecompressionStream */
"use strict";

const element = id => document.getElementById(id);
const fields = ["z", "x", "y", "geodesic", "harmonic", "poisson"];
const numbers = {simplify: "auto", levels: "8", place: "0.5", below: "5%", file: "field.txt"};
// A word in braces is a parameter, and MESH the mesh. README has the same wishes.
const wishes = {
  "The graph, simplified to its limbs":
    "compute MESH --field {field} --simplify {simplify} --graph graph.svg --html page.html",
  "A page to look at, and to send": "compute MESH --field {field} --html page.html",
  "Pieces, cut at necks":
    "curves MESH --field {field} --type branch --simplify {simplify} --mesh-out pieces.ply --html page.html",
  "Pieces between levels":
    "curves MESH --field {field} --type levels --levels {levels} --curves levels.vtp --html page.html",
  "One contour per arc": "contour MESH --field {field} --simplify auto --t {place} --output contours.vtp",
  "Pairs of pants": "curves MESH --type pants --mesh-out pants.ply --html page.html",
  "Lines inside, with radii": "skeleton MESH --output skeleton.swc skeleton.vtp --html page.html",
  "Handles and tunnels": "handles MESH --html page.html --output loops.vtp",
  "The mesh without false handles": "handles MESH --remove-below {below} --output clean.ply --html page.html",
  "For ParaView": "compute MESH --field {field} --graph graph.vtp --mesh-out mesh.vtp --html page.html",
  "A field of your own": "compute MESH --scalars {file} --mesh-out mesh.ply --html page.html"
};
const page = {
  files: new Map(), mesh: "", worker: null, addresses: [], result: null, isBusy: () => page.worker !== null
};
window.reebGraphWeb = page;

// What is packed, and the program

async function unpack(name) {
  const code = atob(JSON.parse(element("packed").textContent)[name]);
  const bytes = Uint8Array.from(code, character => character.charCodeAt(0));
  return new Response(new Blob([bytes]).stream().pipeThrough(new DecompressionStream("gzip"))).arrayBuffer();
}

const program = unpack("reeb_graph.wasm").then(bytes => WebAssembly.compile(bytes));
const workerAddress = URL.createObjectURL(new Blob([element("worker").textContent], {type: "text/javascript"}));

// Words of a command line, of which some are in quotation marks
function wordsOf(command) {
  const words = command.match(/"[^"]*"|'[^']*'|\S+/g) || [];
  return words.map(word => word.replace(/^(["'])(.*)\1$/s, "$2")).map(word => word === "MESH" ? page.mesh : word);
}

async function run(command) {
  cancel();
  const isMeshMissing = /\bMESH\b/.test(command) && !page.mesh;
  fail(isMeshMissing ? "Drop a mesh first, or take one of the three." : "");
  if (isMeshMissing)
    return;
  element("result").hidden = true;
  element("work").hidden = false;
  showProgress("Starting");
  const worker = page.worker = new Worker(workerAddress);
  const end = result => {
    if (worker !== page.worker)
      return;
    cancel();
    show(result);
  };
  worker.onmessage = ({data}) => data.result ? end(data.result) : showProgress(data.progress);
  worker.onerror = event => end({code: -1, output: "", files: [], errors: `The program has stopped: ${event.message}`});
  try {
    worker.postMessage({program: await program, words: wordsOf(command), files: [...page.files.values()]});
  } catch (error) {
    end({code: -1, output: "", files: [], errors: `This browser cannot run the program: ${error.message}`});
  }
}

function cancel() {
  if (page.worker)
    page.worker.terminate();
  page.worker = null;
  element("work").hidden = true;
}

function showProgress(line) {
  const percentage = line.match(/(\d+) %$/);
  element("stage").textContent = line.replace(/ \[.*| \.\.\.$/, "");
  if (percentage)
    element("progress").value = Number(percentage[1]);
  else
    element("progress").removeAttribute("value");
}

// The result

function fail(message) {
  element("failure").textContent = message;
  element("failure").hidden = !message;
}

const types = {html: "text/html", svg: "image/svg+xml"};
function addressOf(name, parts) {
  const type = types[name.split(".").pop()] || "application/octet-stream";
  const address = URL.createObjectURL(new Blob(parts, {type}));
  page.addresses.push(address);
  return address;
}

function linkTo(name, address) {
  const link = document.createElement("a");
  return Object.assign(link, {href: address, download: name.replace(/.*\//, ""), textContent: name});
}

function show(result) {
  page.addresses.forEach(URL.revokeObjectURL);
  page.addresses = [];
  page.result = result;
  // Warnings come with results.
  fail(result.code === 0 ? "" : result.errors || "The program has failed.");
  element("report").textContent = (result.code === 0 && result.errors ? `${result.errors}\n\n` : "") + result.output;
  const links = result.files.map(({name, bytes}) => linkTo(name, addressOf(name, [bytes])));
  const all = document.createElement("button");
  Object.assign(all, {textContent: "All as a zip", hidden: links.length < 2, onclick() {
    linkTo("reeb_graph.zip", addressOf("reeb_graph.zip", zip(result.files))).click();
  }});
  element("downloads").replaceChildren(...links, all);
  for (const [id, ending] of [["page", ".html"], ["drawing_of_graph", ".svg"]]) {
    const link = links.find(({download}) => download.endsWith(ending));
    element(id).hidden = !link;
    if (link)
      element(id).src = link.href;
    else
      element(id).removeAttribute("src");
  }
  element("result").hidden = false;
  element(result.code === 0 ? "result" : "failure").scrollIntoView({block: "nearest"});
}

// An archive of files as they are: their headers, their bytes, and the list of headers at its end

function crc32(bytes) {
  let crc = -1;
  for (const byte of bytes) {
    crc ^= byte;
    for (let i = 0; i < 8; ++i)
      crc = crc & 1 ? crc >>> 1 ^ 0xEDB88320 : crc >>> 1;
  }
  return ~crc >>> 0;
}

// Numbers of two bytes each, or of four if they are in a list
function littleEndian(...given) {
  return Uint8Array.from(given.flatMap(number => Array.isArray(number)
    ? [0, 8, 16, 24].map(shift => number[0] >>> shift & 255) : [number & 255, number >>> 8]));
}

function zip(files) {
  const parts = [], list = [];
  let position = 0;
  for (const {name, bytes} of files) {
    const coded = new TextEncoder().encode(name);
    const facts = [20, 0x800, 0, 0, 0x21, [crc32(bytes)], [bytes.length], [bytes.length], coded.length, 0];
    const header = littleEndian([0x04034B50], ...facts);
    list.push(littleEndian([0x02014B50], 20, ...facts, 0, 0, 0, [0], [position]), coded);
    parts.push(header, coded, bytes);
    position += header.length + coded.length + bytes.length;
  }
  const size = list.reduce((sum, part) => sum + part.length, 0);
  return [...parts, ...list, littleEndian([0x06054B50], 0, 0, files.length, files.length, [size], [position], 0)];
}

// What is asked

function ask(command) {
  element("command").value = command;
  location.hash = encodeURIComponent(command);
  run(command);
}

function askByAddress() {
  let command;
  try {
    command = decodeURIComponent(location.hash.slice(1));
  } catch (error) {
    return;
  }
  if (!command || command === element("command").value)
    return;
  element("command").value = command;
  run(command);
}

function take(files) {
  for (const file of files) {
    if (!/\.(txt|csv|npy)$/i.test(file.name)) {
      page.files.delete(page.mesh);
      page.mesh = file.name;
    }
    page.files.set(file.name, file);
  }
  element("mesh").textContent = [...page.files.values()].map(({name, size}) =>
    `${name}${name === page.mesh ? ", the mesh" : ""} (${(size / 1e6).toFixed(1)} MB)`).join("; ");
  if (files.length && page.mesh)
    run(element("command").value);
}

function addWish([title, command]) {
  const form = document.createElement("form"), button = document.createElement("button");
  button.textContent = title;
  form.append(button);
  for (const [, name] of command.matchAll(/\{(\w+)\}/g)) {
    const label = document.createElement("label");
    const input = document.createElement(name === "field" ? "select" : "input");
    if (name === "field")
      input.append(...fields.map(field => new Option(field)));
    else
      input.value = numbers[name];
    input.name = name;
    label.append(name, input);
    form.append(label);
  }
  form.onsubmit = event => {
    event.preventDefault();
    const quoted = text => /\s/.test(text) ? `"${text}"` : text;
    ask(command.replace(/\{(\w+)\}/g, (_, name) => quoted(form.elements[name].value)));
  };
  element("wishes").append(form);
}

Object.entries(wishes).forEach(addWish);
element("command").value = wishes["A page to look at, and to send"].replace("{field}", fields[0]);
element("files").onchange = event => take([...event.target.files]);
element("cancel").onclick = cancel;
element("help").onclick = () => {
  const command = element("command").value.match(/^\s*([a-z]+)/);
  run(command ? `${command[1]} --help` : "--help");
};
element("command_form").onsubmit = event => {
  event.preventDefault();
  ask(element("command").value);
};
for (const button of document.querySelectorAll("[data-example]"))
  button.onclick = async () => take([new File([await unpack(button.dataset.example)], button.dataset.example)]);
for (const kind of ["dragover", "dragleave", "drop"]) {
  document.addEventListener(kind, event => {
    event.preventDefault();
    element("meshes").classList.toggle("over", kind === "dragover");
    if (kind === "drop")
      take([...event.dataTransfer.files]);
  });
}
window.addEventListener("hashchange", askByAddress);
askByAddress();
