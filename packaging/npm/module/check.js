// `shaderlint FILE`, file by file.
"use strict";

const fs = require("node:fs");
const path = require("node:path");
const { Refusal, SHADER, collect, search } = require("./files.js");
const { Summary } = require("./summary.js");

const FORMATS = ["human", "short", "agent", "json", "jsonl", "sarif"];
/** The formats that end with a summary. */
const SUMMED = ["human", "agent"];
/** The formats whose output is one document. */
const DOCUMENTS = ["json", "sarif"];

const complain = (message) => process.stderr.write(`shaderlint: ${message}\n`);

/** The texts of shaders by folder and name. */
const known = new Map();
function shaders(folder, isDeep) {
  const key = `${isDeep} ${folder}`;
  if (!known.has(key)) {
    const texts = new Map();
    for (const name of search(folder, SHADER, isDeep)) {
      try {
        texts.set(name, fs.readFileSync(name, "utf8"));
      } catch {
        // As if it did not exist: nobody asked to check it.
      }
    }
    known.set(key, texts);
  }
  return known.get(key);
}

/** What a file may refer to: the other passes, stages and parts in its folder, and all that it may include. */
function others({ name, text, file }, inputs) {
  if (!file) return {};
  const folder = path.dirname(file);
  const isInside = !path.relative("", folder).startsWith("..");
  const includes = /#\s*(include|pragma)|\bimport\b/.test(text);
  const found = new Map(shaders(includes && isInside ? "." : folder, includes));
  // Errors between stages are those of the fragment shader, if both are checked.
  const isVertex = /(^|[^a-z])(vert|vertex|vs|vsh)\b/i.test(path.basename(name));
  if (isVertex) for (const each of inputs) if (each !== name) found.delete(each);
  return Object.fromEntries(found);
}

/** The options of the module. */
function optionsOf(args) {
  const names = (values = []) => values.flatMap((value) => value.split(","));
  const { host, info } = args;
  const samples = args["no-run"] ? 0 : args["run-samples"] && Number(args["run-samples"]);
  return { host, info, select: names(args.select), ignore: names(args.ignore), runSamples: samples };
}

/** Fixes an input; returns the number of fixes. */
function fix(module, input, options) {
  const { text, fixed } = module.fix(input.text, options);
  if (input.file && text !== input.text) {
    fs.writeFileSync(input.file, text);
    // Other files may include it.
    known.clear();
  }
  if (!input.file) process.stdout.write(text);
  input.text = text;
  return input.file ? fixed : 0;
}

/** Checks the inputs and returns the exit code. */
module.exports = function check(module, args) {
  const format = args.format ?? "human";
  if (!FORMATS.includes(format)) throw new Refusal(`--format ${format} needs the program`);
  const inputs = collect(args, ["shaderlint.toml"]);
  if (DOCUMENTS.includes(format) && inputs.length > 1) {
    throw new Refusal(`--format ${format} of several files needs the program`);
  }
  const say = args.quiet > 1 ? () => {} : complain;
  if (inputs.length === 0 && args.quiet === 0) say("warning: no shaders found in the given paths");
  const isFixing = args.fix || args["unsafe-fixes"];
  const isPassed = isFixing && inputs.some(({ file, isMissing }) => !file && !isMissing);
  const texts = new Set(inputs.map(({ name }) => name));
  const options = optionsOf(args);
  const summary = new Summary();
  let hasFailed = false;

  /** Passes an input to a method of the module; says why if that fails. */
  const ask = (input, method) => {
    try {
      if (input.error) throw new Error(`${input.name}: ${input.error}`);
      return method({ ...options, name: input.name, files: others(input, texts) });
    } catch (error) {
      const isSkipped = error.message.startsWith(`${input.name}: skipped: `);
      // Whoever names a file expects a shader in it.
      const isLacking = isSkipped && input.isNamed && input.file;
      hasFailed ||= !isSkipped || isLacking;
      const message = isLacking ? error.message.replace(": skipped: ", ": not checked: ") : error.message;
      if (!isSkipped || isLacking || (input.isNamed && args.quiet === 0)) say(message);
      input.isDone = true;
      return undefined;
    }
  };
  const out = isPassed ? process.stderr : process.stdout;
  const print = (text) => args.quiet < 2 && out.write(text);

  // All files first: they include each other.
  for (const input of isFixing ? inputs : []) {
    const unsafe = args["unsafe-fixes"];
    summary.fixed += ask(input, (all) => fix(module, input, { ...all, unsafe })) ?? 0;
  }
  const shape = isPassed ? "short" : format;
  for (const input of inputs.filter(({ isDone }) => !isDone)) {
    const report = ask(input, (all) => module.report(input.text, { ...all, format: shape }));
    if (report) print(summary.add(report));
  }
  if (SUMMED.includes(shape) && args.quiet === 0) print(summary.lines());
  const limit = args["deny-warnings"] ? 0 : Number(args["max-warnings"] ?? Infinity);
  if (hasFailed) return 2;
  return (summary.errors > 0 || summary.warnings > limit) && !args["exit-zero"] ? 1 : 0;
};
