// The problem matchers in tasks.json parse the program's output.
import assert from "node:assert/strict";
import { spawnSync } from "node:child_process";
import { readFileSync } from "node:fs";
import { test } from "node:test";

const { tasks } = JSON.parse(readFileSync(process.env.TASKS, "utf8"));
for (const task of tasks) {
    test(`VS Code: ${task.label}`, () => {
        const { pattern } = task.problemMatcher;
        const read = (line) => {
            const match = new RegExp(pattern.regexp).exec(line);
            return match && ["file", "line", "column", "severity", "code"].map((key) => match[pattern[key]]);
        };
        const args = task.args.filter((arg) => arg !== "--watch");
        const { stdout } = spawnSync(task.command, args, { encoding: "utf8" });
        const found = stdout.trimEnd().split("\n").map(read);
        assert.deepEqual(found, [
            ["broken.glsl", "2", "24", "error", "int-float-mix"],
            ["warned.glsl", "2", "28", "warning", "pow-negative-base"],
            ["warned.glsl", "3", "11", "info", "unused-variable"],
        ]);
        const inExport = "a b/x.json (Buffer A):12:3: error[syntax]: `)` (or more)";
        assert.deepEqual(read(inExport), ["a b/x.json", "12", "3", "error", "syntax"]);
    });
}
