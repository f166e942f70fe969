// Tests the problem matchers in tasks.json on the program's output.
"use strict";

const assert = require("node:assert");
const { spawnSync } = require("node:child_process");
const { readFileSync } = require("node:fs");

const { tasks } = JSON.parse(readFileSync(process.argv[2], "utf8"));
for (const task of tasks) {
    const { pattern } = task.problemMatcher;
    const read = (line) => {
        const match = new RegExp(pattern.regexp).exec(line);
        return match && ["file", "line", "column", "severity", "code"].map((key) => match[pattern[key]]);
    };
    const args = task.args.filter((arg) => arg !== "--watch");
    const { stdout } = spawnSync(task.command, args, { encoding: "utf8" });
    const found = stdout.trimEnd().split("\n").map(read);
    assert.deepStrictEqual(found, [
        ["broken.glsl", "2", "24", "error", "int-float-mix"],
        ["warned.glsl", "2", "28", "warning", "pow-negative-base"],
        ["warned.glsl", "3", "11", "info", "unused-variable"],
    ]);
    const inExport = "a b/x.json (Buffer A):12:3: error[syntax]: `)` (or more)";
    assert.deepStrictEqual(read(inExport), ["a b/x.json", "12", "3", "error", "syntax"]);
}
console.log("VS Code: ok");
