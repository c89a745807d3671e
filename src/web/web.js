// The page that runs the program: it makes command lines, hands them to the worker, and shows what comes back.
/* global DecompressionStream */
"use strict";

const element = id => document.getElementById(id);
const fields = ["geodesic", "z", "x", "y", "harmonic", "poisson"];
// A word in braces is a parameter, as its option is called, with the value that it begins with. What is in brackets is
// left out if its parameter is empty. MESH is the mesh. README has the same wishes.
const wishes = {
  "The graph, simplified to its limbs":
    "compute MESH --field {field geodesic} --simplify {simplify auto} --graph graph.svg --html page.html",
  "A page to look at, and to send": "compute MESH --field {field z} --html page.html",
  "Pieces, cut at necks":
    "curves MESH --type branch --field {field geodesic} --simplify {simplify auto} --mesh-out pieces.ply "
    + "--html page.html",
  "Pieces between levels":
    "curves MESH --field {field z} --type levels --levels {levels 8} --curves levels.vtp --html page.html",
  "One contour per arc":
    "contour MESH --field {field geodesic} --simplify auto --t {t 0.5} --output contours.vtp --html page.html",
  "Pairs of pants": "curves MESH[ --field {field}] --type pants --mesh-out pants.ply --html page.html",
  "Lines inside, with radii": "skeleton MESH --output skeleton.swc skeleton.vtp branches.csv --html page.html",
  "Handles and tunnels": "handles MESH --html page.html --output loops.vtp",
  "The mesh without false handles":
    "handles MESH --remove-below {remove-below 5%} --output clean.ply --html page.html",
  "For ParaView": "compute MESH --field {field z} --graph graph.vtp --mesh-out mesh.vtp --html page.html",
  "A field of your own": "compute MESH --scalars {scalars}[ --column {column}] --mesh-out mesh.ply --html page.html"
};
const repaired = "_repaired.ply"; // what the name of a mesh that the program has repaired ends in
const labels = {t: "place", "remove-below": "below", scalars: "file"}; // of parameters with other names
const parameters = /\{([\w-]+)(?: ([^}]*))?\}/g;
const page = {
  files: new Map(), mesh: "", worker: null, addresses: [], result: null, isBusy: () => page.worker !== null,
  waiting: "" // the command that the mesh is missing for
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

const quoted = text => /\s/.test(text) ? `"${text}"` : text;
const labelOf = name => labels[name] || name;

// Runs the command, and shows what the program says by way of `translate`.
async function run(command, translate = text => text) {
  cancel();
  const isMeshMissing = /\bMESH\b/.test(command) && !page.mesh;
  page.waiting = isMeshMissing ? command : "";
  fail(isMeshMissing ? "Drop a mesh first, or take one of the three." : "");
  if (isMeshMissing)
    return;
  hideResult();
  element("work").hidden = false;
  showProgress("Starting");
  const worker = page.worker = new Worker(workerAddress);
  const end = result => {
    if (worker !== page.worker)
      return;
    cancel();
    show(result, translate);
    offerRepair(/\bMESH\b/.test(command) ? `${result.errors}\n${result.output}` : "");
  };
  worker.onmessage = ({data}) => data.result ? end(data.result) : showProgress(data.progress);
  worker.onerror = event => end({code: -1, output: "", files: [], errors: `The program has stopped: ${event.message}`});
  try {
    worker.postMessage({program: await program, words: wordsOf(command), files: [...page.files.values()]});
  } catch (error) {
    end({code: -1, output: "", files: [], errors: `This browser cannot run the program: ${error.message}`});
  }
}

function hideResult() {
  element("result").hidden = element("remedy").hidden = true;
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

function show(result, translate) {
  page.addresses.forEach(URL.revokeObjectURL);
  page.addresses = [];
  page.result = result;
  // Warnings come with results.
  fail(result.code === 0 ? "" : translate(result.errors) || "The program has failed.");
  element("report").textContent =
    translate((result.code === 0 && result.errors ? `${result.errors}\n\n` : "") + result.output);
  const links = result.files.map(({name, bytes}) => linkTo(name, addressOf(name, [bytes])));
  const all = document.createElement("button");
  Object.assign(all, {textContent: "All as a zip", hidden: links.length < 2, onclick() {
    linkTo("reeb_graph.zip", addressOf("reeb_graph.zip", zip(result.files))).click();
  }});
  element("downloads").replaceChildren(...links, all);
  const find = ending => result.files.find(({name}) => name.endsWith(ending));
  const drawing = links.find(({download}) => download.endsWith(".svg"));
  element("drawing_of_graph").hidden = !drawing;
  if (drawing)
    element("drawing_of_graph").src = drawing.href;
  else
    element("drawing_of_graph").removeAttribute("src");
  element("result").hidden = !links.length && !element("report").textContent;
  showFrame(find(".html"));
  if (find(repaired))
    keep(new File([find(repaired).bytes], find(repaired).name));
  element(result.code === 0 ? "result" : "failure").scrollIntoView({block: "nearest"});
}

// The page that the program has written, in a frame as high as it is, so that this page alone scrolls on a phone. As a
// text, and not as a file, it is one that this page may look into.
function showFrame(file) {
  const frame = element("page");
  frame.hidden = element("not_drawn").hidden = !file;
  frame.srcdoc = file ? new TextDecoder().decode(file.bytes) : "";
}

function fitFrame() {
  const frame = element("page"), {body} = frame.contentDocument;
  frame.style.height = `${Math.ceil(body.getBoundingClientRect().height)}px`;
}

// Without a height of its own, the frame has that of the style, of which a wide page takes all.
function fitFrameToWindow() {
  const frame = element("page"), top = scrollY;
  frame.style.height = "";
  frame.contentDocument.documentElement.style.setProperty("--vh", `${frame.clientHeight / 100}px`);
  fitFrame();
  scrollTo(0, top);
}

element("page").onload = () => {
  const {contentWindow} = element("page");
  fitFrameToWindow();
  new contentWindow.ResizeObserver(fitFrame).observe(contentWindow.document.body);
  const atNextFrame = work => contentWindow.requestAnimationFrame(work);
  atNextFrame(() => atNextFrame(() => {
    element("not_drawn").hidden = true;
  }));
};
window.addEventListener("resize", fitFrameToWindow);

// The program speaks of commands and options: here, a button and the parameters of the wish stand for them.
const option = "--(?!output)[a-z-]+(?: [\\d.e+-]+%?)?";
const hints = new RegExp(
  `'?(?:reeb_graph repair(?: .* --output repaired\\.ply|(?: ${option})*)|--triangulate\\b)'?`, "g");

function translateOptions(text, wish) {
  const names = [...wish.matchAll(parameters)].map(([, name]) => name);
  return text.replace(hints, `“${element("repair").textContent}”`)
    .replace(/--([a-z-]+)/g, (word, name) => names.includes(name) ? `“${labelOf(name)}”` : word);
}

function offerRepair(text) {
  const found = text.match(hints) || [];
  const options = new Set(found.flatMap(words => words.match(new RegExp(option, "g")) || []));
  element("remedy").hidden = found.length === 0;
  element("repair").onclick = () => ask(
    ["repair MESH", ...options, "--output", quoted(page.mesh.replace(/\.\w+$/, repaired))].join(" "),
    words => translateOptions(words, ""));
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

function ask(command, translate) {
  element("command").value = command;
  location.hash = encodeURIComponent(command);
  run(command, translate);
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

// A mesh takes the place of the one before; the name of a file of numbers is that of the field in a wish.
function keep(file) {
  if (/\.(txt|csv|npy)$/i.test(file.name)) {
    document.querySelectorAll("[name=scalars]").forEach(input => Object.assign(input, {value: file.name}));
  } else {
    page.files.delete(page.mesh);
    page.mesh = file.name;
  }
  page.files.set(file.name, file);
  element("mesh").textContent = [...page.files.values()].map(({name, size}) =>
    `${name}${name === page.mesh ? ", the mesh" : ""} (${(size / 1e6).toFixed(1)} MB)`).join("; ")
    + (page.mesh ? ". Choose a wish." : ". Choose a mesh, too.");
}

function take(files) {
  const before = page.mesh;
  files.forEach(keep);
  fail("");
  if (files.some(({name}) => name === page.mesh)) {
    cancel();
    hideResult();
  }
  if (page.waiting && !before && page.mesh)
    run(page.waiting);
}

function addWish([title, command]) {
  const form = document.createElement("form"), button = document.createElement("button");
  button.textContent = title;
  form.append(button);
  for (const [, name, value] of command.matchAll(parameters)) {
    const label = document.createElement("label");
    const input = document.createElement(name === "field" ? "select" : "input");
    const required = !command.includes(`{${name}}]`);
    if (name === "field")
      input.append(...required ? [] : [new Option("automatic", "")], ...fields.map(field => new Option(field)));
    Object.assign(input, {name, value: value || "", required});
    if (name === "scalars")
      input.placeholder = "drop a file";
    label.append(labelOf(name), input);
    form.append(label);
  }
  form.onsubmit = event => {
    event.preventDefault();
    const valueOf = name => form.elements[name].value.trim();
    ask(command.replace(/\[(.*?)\{([\w-]+)\}\]/g, (_, before, name) => valueOf(name) && `${before}{${name}}`)
      .replace(parameters, (_, name) => quoted(valueOf(name))), words => translateOptions(words, command));
  };
  element("wishes").append(form);
}

Object.entries(wishes).forEach(addWish);
element("command").value = wishes["A page to look at, and to send"].replace(parameters, (_, name, value) => value);
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
