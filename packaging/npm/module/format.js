// `shaderlint fmt FILE`.
"use strict";

const fs = require("node:fs");
const { collect } = require("./files.js");

const complain = (message) => process.stderr.write(`shaderlint fmt: ${message}\n`);
const files = (number) => `${number} file${number === 1 ? "" : "s"}`;

/** What was done, in a line; empty if nothing was. */
function summary(changed, unchanged, would) {
  const parts = [changed > 0 && `${files(changed)} ${would}`];
  parts.push(unchanged > 0 && `${changed > 0 ? unchanged : files(unchanged)} already formatted`);
  return parts.filter(Boolean).join(", ");
}

/** The number of the first line that differs. */
function difference(old, text) {
  const lines = text.split("\n");
  return old.split("\n").findIndex((line, at) => line !== lines[at]) + 1;
}

/** Formats the inputs and returns the exit code. */
module.exports = function format(module, args) {
  let [changed, unchanged, hasFailed] = [0, 0, false];
  for (const { name, file, text: old, error, isNamed } of collect(args, ["shaderlint.toml", ".editorconfig"])) {
    try {
      if (error) throw new Error(`${name}: ${error}`);
      const { text, unformatted } = module.format(old, { name });
      for (const { line, column, message } of unformatted) {
        complain(`${name}:${line}:${column}: not formatted: ${message}`);
      }
      hasFailed ||= unformatted.length > 0;
      if (text !== old) changed += 1;
      else if (unformatted.length === 0) unchanged += 1;
      if (args.check && text !== old) process.stdout.write(`${name}:${difference(old, text)}: not formatted\n`);
      if (args.check) continue;
      if (!file) process.stdout.write(text);
      else if (text !== old) fs.writeFileSync(file, text);
    } catch ({ message }) {
      const isSkipped = message.startsWith(`${name}: skipped: `);
      hasFailed ||= !isSkipped;
      if (!isSkipped || (isNamed && args.quiet === 0)) complain(message);
      if (isSkipped && !file && !args.check) process.stdout.write(old);
    }
  }
  const done = summary(changed, unchanged, args.check ? "would be reformatted" : "reformatted");
  if (done && args.quiet === 0) complain(done);
  if (hasFailed) return 2;
  return args.check && changed > 0 ? 1 : 0;
};
