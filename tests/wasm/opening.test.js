// The module opens the same projects as the programs.

import assert from "node:assert/strict";
import fs from "node:fs";
import path from "node:path";
import { test } from "node:test";
import { MODULES, ROOT, Shaderlint } from "./load.js";

const ROWS = JSON.parse(fs.readFileSync(path.join(ROOT, "tests/opening.json"), "utf8"));

/** The files of a row, with the call misspelt or as it is. */
function filesOf({ files, call: [file] }, isBroken) {
  const text = files[file];
  const at = text.lastIndexOf("glow(");
  return isBroken ? { ...files, [file]: `${text.slice(0, at)}glowx${text.slice(at + 4)}` } : files;
}

/** What the module says about a row. */
function answers(shaderlint, { open, call: [file] }, files) {
  const isFolder = !path.extname(open);
  const checked = isFolder ? file : open;
  const { output } = shaderlint.report(files[checked], { name: checked, files, format: "short" });
  const isPass = ([name]) => path.dirname(name) === open;
  const passes = Object.fromEntries(Object.entries(files).filter(isPass));
  const options = { name: open, passes, files };
  const { errors } = shaderlint.port(files[open] ?? "", options);
  let failure = "";
  try {
    shaderlint.run(files[open] ?? "", { ...options, size: [16, 9] });
  } catch (error) {
    failure = error.message;
  }
  return { output, errors, failure };
}

const { port } = MODULES;
test("the module opens the projects of the programs", { skip: !port && "this module does not port" }, async () => {
  const shaderlint = await Shaderlint.load(port);
  const wrong = [];
  // Only the programs read XML.
  for (const row of ROWS.filter(({ open }) => !open.endsWith(".klproj"))) {
    const [file, line] = row.call;
    for (const isBroken of [false, true]) {
      const { output, errors, failure } = answers(shaderlint, row, filesOf(row, isBroken));
      const found = [output.includes(`${file}:${line}:`) && output.includes("glowx"), errors > 0, failure !== ""];
      if (found.some((isFound) => isFound !== isBroken)) {
        wrong.push(`${row.name}, broken: ${isBroken}: ${found} ${output} ${failure}`);
      }
    }
  }
  assert.deepEqual(wrong, []);
});
