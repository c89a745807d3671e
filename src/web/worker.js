// Runs the program once, with files in memory, and tells the page what it writes: a page makes a worker for each run,
// and ends it to cancel.
/* global createProgram */
"use strict";

// Standard error: lines, and progress, which a terminal would overwrite.
function errorLines(showProgress) {
  let line = "";
  const lines = [];
  return {lines, write(text) {
    for (const character of text) {
      if (character === "\n")
        lines.push(line);
      line = character === "\r" || character === "\n" ? "" : line + character;
    }
    if (line.trim())
      showProgress(line.trim());
  }};
}

// Lets a function have what is written to a file descriptor, which stays a terminal.
function redirect(FS, descriptor, write) {
  const stream = FS.getStream(descriptor), decoder = new TextDecoder();
  stream.stream_ops = Object.assign({}, stream.stream_ops, {write(_, bytes, begin, size) {
    write(decoder.decode(bytes.slice(begin, begin + size), {stream: true}));
    return size;
  }});
}

// All files below a folder but those that were there before, as {name, bytes}.
function newFiles(FS, folder, isOld) {
  return FS.readdir(folder || ".").filter(name => name !== "." && name !== "..").flatMap(name => {
    const path = folder + name, {node} = FS.lookupPath(path);
    if (FS.isDir(node.mode))
      return newFiles(FS, `${path}/`, isOld);
    return isOld(node) ? [] : [{name: path, bytes: FS.readFile(path)}];
  });
}

const outOfMemory = "out of memory: in a browser, a mesh and what is made of it have to fit into 4 GB";

async function run({program, words, files}) {
  const errors = errorLines(progress => postMessage({progress})), output = [], old = new Set();
  const instance = await createProgram({
    thisProgram: "reeb_graph",
    instantiateWasm(imports, done) {
      WebAssembly.instantiate(program, imports).then(done);
      return {};
    },
    stdin: () => null
  });
  const {FS} = instance;
  redirect(FS, 1, text => output.push(text));
  redirect(FS, 2, errors.write);
  FS.mkdir("/work");
  FS.chdir("/work");
  for (const file of files) {
    FS.writeFile(file.name, new Uint8Array(await file.arrayBuffer()), {canOwn: true});
    old.add(FS.lookupPath(file.name).node);
  }
  const code = instance.callMain(words);
  const written = newFiles(FS, "", node => old.has(node));
  const told = errors.lines.join("\n").replace(/out of memory$/, outOfMemory);
  return {code, output: output.join(""), errors: told, files: written};
}

onmessage = ({data}) => run(data).then(
  result => postMessage({result}, result.files.map(file => file.bytes.buffer)),
  error => postMessage({result: {code: -1, output: "", files: [], errors:
    error instanceof RangeError || error.name === "NotReadableError"
      ? outOfMemory
      : `The program has stopped: ${error.message || error}`}}));
