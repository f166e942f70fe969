// Starts a program of the package for this platform.
"use strict";

const { spawn } = require("node:child_process");
const { constants } = require("node:os");
const path = require("node:path");
const { name, optionalDependencies, homepage } = require("../package.json");

/** The packages whose programs run here, best first. */
function candidates() {
  const system = `@${name}/${process.platform}-${process.arch}`;
  if (process.platform !== "linux") return [system];
  // Programs for musl are static, so they run where glibc is too old as well.
  return usesGlibc() ? [`${system}-gnu`, `${system}-musl`] : [`${system}-musl`];
}

/** Whether Node uses glibc, which its own report lists. */
function usesGlibc() {
  // Without this, the report resolves the addresses of open connections.
  process.report.excludeNetwork = true;
  const report = process.report.getReport();
  const { header } = typeof report === "string" ? JSON.parse(report) : report;
  return Boolean(header.glibcVersionRuntime);
}

/** The path of a program, or `undefined` if no installed package has it. */
function find(program) {
  const file = process.platform === "win32" ? `${program}.exe` : program;
  for (const candidate of candidates()) {
    try {
      return path.join(path.dirname(require.resolve(`${candidate}/package.json`)), "bin", file);
    } catch {
      // Not installed.
    }
  }
  return undefined;
}

/** Starts a program and ends as it does: with its exit code, or by its signal. */
function start(file) {
  const child = spawn(file, process.argv.slice(2), { stdio: "inherit", windowsHide: true });
  const signals = ["SIGINT", "SIGTERM", "SIGHUP"];
  const pass = (signal) => child.kill(signal);
  for (const signal of signals) process.on(signal, pass);
  child.on("error", (error) => {
    console.error(`${name}: cannot start ${file}: ${error.message}`);
    process.exitCode = 2;
  });
  child.on("exit", (code, signal) => {
    for (const each of signals) process.off(each, pass);
    if (!signal) {
      process.exitCode = code;
    } else if (process.platform === "win32") {
      process.exitCode = 128 + constants.signals[signal];
    } else {
      process.kill(process.pid, signal);
    }
  });
}

/** Loads the WebAssembly module, or `undefined` if it is not installed. */
async function load() {
  const packages = Object.keys(optionalDependencies).filter((each) => each.startsWith(`@${name}/wasm-`));
  for (const each of packages) {
    try {
      require.resolve(each);
    } catch {
      // Not for this platform.
      continue;
    }
    return require(each)();
  }
  try {
    // Installed by hand.
    return await import("shaderlint-wasm");
  } catch {
    return undefined;
  }
}

/** Runs where no package has programs for this platform. */
async function startWithoutPrograms(program) {
  const found = await load();
  if (!found) throw new Error(`${missing()}. Other ways to install: ${homepage}`);
  if (program !== name) throw new Error(`${program} needs the program, and ${missing()}`);
  const run = require("../module/main.js");
  // The reader of the output closed it.
  process.stdout.on("error", ({ code }) => process.exit(code === "EPIPE" ? 1 : 2));
  try {
    process.exitCode = run(await found.Shaderlint.load(), process.argv.slice(2));
  } catch (error) {
    throw new Error(error.needsProgram ? `${error.message}; ${missing()}` : error.message);
  }
}

/** Why there are no programs. */
function missing() {
  const platforms = Object.keys(optionalDependencies).map((each) => each.replace(/^.*\//, ""));
  const known = platforms.filter((each) => !each.startsWith("wasm-"));
  const here = candidates()[0].replace(/^.*\//, "");
  return known.includes(here)
    ? `the package @${name}/${here} is not installed; install again, with optional dependencies`
    : `there is no package for ${here}, only for ${known.join(", ")}`;
}

/** Runs the program with the arguments of this process. */
module.exports = function launch(program) {
  const file = find(program);
  if (file) start(file);
  else {
    startWithoutPrograms(program).catch((error) => {
      console.error(`${name}: ${error.message}`);
      process.exitCode = 2;
    });
  }
};
