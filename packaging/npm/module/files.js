// The files that arguments name.
"use strict";

const { spawnSync } = require("node:child_process");
const fs = require("node:fs");
const path = require("node:path");

/** A message for the user about what needs the program. */
class Refusal extends Error {
  needsProgram = true;
}

const SHADER = /\.(glsl|frag|vert|fsh|vsh|glslf|glslv|fs|vs)$/i;
/** Exports, and files with shaders in them. */
const HOLDING = /\.(json|shadertoy|x?html|htm|[mc]?[jt]s|[jt]sx|vue|svelte|astro|md|markdown|mdx)$/;
/** The files that a search of folders finds; others are checked if they are named. */
const SEARCHED = new RegExp(`${SHADER.source}|${HOLDING.source}`, "i");
const LEFT_OUT = /\.(d\.[mc]?ts|min\.[mc]?js)$/;
const BUILT = ["node_modules", "dist"];

/** A path as messages show it. */
const shown = (file) => file.replaceAll("\\", "/").replace(/^\.\//, "");

/** The files in a folder and, if `isDeep`, those below. */
function* search(folder, extensions, isDeep = true) {
  for (const entry of fs.readdirSync(folder, { withFileTypes: true })) {
    const inside = path.join(folder, entry.name);
    if (entry.name.startsWith(".")) continue;
    const isSearched = isDeep && entry.isDirectory() && !BUILT.includes(entry.name);
    if (isSearched) yield* search(inside, extensions);
    else if (entry.isFile() && extensions.test(entry.name)) yield shown(inside);
  }
}

/** The files that the program finds in a folder: those that git does not ignore. */
function found(folder) {
  const all = [...search(folder, SEARCHED)].filter((name) => !LEFT_OUT.test(name)).sort();
  // Without git, or outside of a repository, all are checked.
  const { stdout } = spawnSync("git", ["check-ignore", "--no-index", "-z", "--stdin"], { input: all.join("\0") });
  const ignored = new Set(stdout?.toString().split("\0"));
  return all.filter((name) => !ignored.has(name));
}

/** The contents of a file as text. */
function read(file) {
  // Keeps a byte order mark, whose bytes count in positions.
  const decoder = new TextDecoder("utf-8", { fatal: true, ignoreBOM: true });
  try {
    return decoder.decode(fs.readFileSync(file));
  } catch (error) {
    const isEncoding = error.code === "ERR_ENCODING_INVALID_ENCODED_DATA";
    throw new Error(isEncoding ? "the file is not valid UTF-8" : error.message);
  }
}

/** Fails where the program would use a configuration, which the module cannot read. */
function refuseConfiguration(file, names) {
  let folder = path.dirname(path.resolve(file));
  for (let above; folder !== above; above = folder, folder = path.dirname(folder)) {
    const found = names.map((name) => path.join(folder, name)).find((name) => fs.existsSync(name));
    if (found) {
      const name = shown(path.relative("", found));
      throw new Refusal(`${name}: configuration needs the program; --no-config ignores the file`);
    }
  }
}

/** The inputs that arguments name: their names and texts, or an error for those that cannot be read. */
function collect(args, configurations) {
  const inputs = new Map();
  const add = (name, file, isNamed) => {
    if (inputs.has(name)) return;
    if (!args["no-config"]) refuseConfiguration(name, configurations);
    const input = { name, file, isNamed };
    try {
      input.text = read(file ?? 0);
    } catch (error) {
      input.error = error.message;
    }
    inputs.set(name, input);
  };
  for (const named of args.paths.length > 0 ? args.paths : ["."]) {
    const stats = fs.statSync(named, { throwIfNoEntry: false });
    if (named === "-") add(args["stdin-filename"] ?? "stdin.glsl", undefined, true);
    else if (stats?.isDirectory()) found(named).forEach((file) => add(file, file, false));
    else if (stats) add(shown(named), named, true);
    else inputs.set(named, { name: shown(named), error: "no such file or folder", isMissing: true });
  }
  return [...inputs.values()];
}

module.exports = { Refusal, SHADER, collect, search };
