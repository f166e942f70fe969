// The package without programs prints what the program prints.
//
//   SHADERLINT    the program
//   LAUNCHER      the installed script

import assert from "node:assert/strict";
import { spawnSync } from "node:child_process";
import fs from "node:fs";
import os from "node:os";
import path from "node:path";
import { test } from "node:test";
import { fileURLToPath } from "node:url";

const ROOT = path.resolve(path.dirname(fileURLToPath(import.meta.url)), "../..");
const MISTAKES = path.join(ROOT, "corpus/mistakes");
const MISTAKE = fs.readFileSync(path.join(MISTAKES, "define_with_semicolon.glsl"), "utf8");

/** What a command prints, and its exit code. */
function run(command, args, cwd, input) {
  const env = { ...process.env, NODE_OPTIONS: `--require ${path.join(ROOT, "tests/package/other-system.cjs")}` };
  const options = { cwd, input: input ?? "", encoding: "utf8", env, maxBuffer: 1 << 28 };
  const { stdout, stderr, status } = spawnSync(command, args, options);
  return { stdout, stderr, status };
}

const native = (args, ...rest) => run(process.env.SHADERLINT, args, ...rest);
const launch = (args, ...rest) => run(process.env.LAUNCHER, args, ...rest);

/** Compares what both print for arguments; returns it. */
function same(args, cwd = MISTAKES, input = undefined) {
  const expected = native(args, cwd, input);
  assert.deepEqual(launch(args, cwd, input), expected, args.join(" "));
  return expected;
}

/** The contents of the files in a folder. */
const contents = (folder) =>
  fs.readdirSync(folder).filter((name) => !name.startsWith(".")).map((name) => [
    name, fs.readFileSync(path.join(folder, name), "utf8"),
  ]);

/** A copy of the mistakes, which is removed after the test. */
function copy(t) {
  const folder = fs.mkdtempSync(path.join(os.tmpdir(), "shaderlint-"));
  t.after(() => fs.rmSync(folder, { recursive: true }));
  for (const name of fs.readdirSync(MISTAKES)) {
    if (/\.(glsl|frag|vert)$/.test(name)) fs.copyFileSync(path.join(MISTAKES, name), path.join(folder, name));
  }
  return folder;
}

test("findings of many files and their summary equal those of the program", () => {
  for (const format of ["human", "short", "agent", "jsonl"]) {
    const { status, stdout } = same(["--no-cache", "--format", format, "."]);
    assert.equal(status, 1);
    assert.ok(stdout.split("\n").length > 50);
  }
  for (const folder of ["corpus/pitfalls", "corpus/templates", "corpus/tests", "tests/fixtures/passes"]) {
    same(["--no-cache", "--no-config", path.join(ROOT, folder)], ROOT);
    same(["--no-cache", "--no-config", folder], ROOT);
  }
});

test("formats, options and exit codes equal those of the program", () => {
  for (const format of ["human", "short", "agent", "json", "jsonl", "sarif"]) {
    same(["--no-cache", "--format", format, "define_with_semicolon.glsl"]);
  }
  const clean = "void mainImage(out vec4 c, in vec2 p) { c = vec4(p / iResolution.xy, 0.0, 1.0); }\n";
  assert.equal(same(["-"], MISTAKES, clean).status, 0);
  for (const options of [
    ["--exit-zero"], ["--ignore", "faulty-macro"], ["--select", "all", "--info", "--no-run"], ["--host", "three"],
    ["-q"], ["-qq"], ["--format", "json", "--stdin-filename", "a.frag"], ["--deny-warnings"], ["--max-warnings", "1"],
  ]) {
    same([...options, "-"], MISTAKES, MISTAKE);
  }
  assert.equal(same(["no.glsl"]).status, 2);
  same(["--no-cache", "page.html.txt"]);
});

test("rule pages and the table of rules equal those of the program", () => {
  same(["explain", "sqrt-negative"]);
  same(["explain", "sqrt-nagative"]);
  same(["rules"]);
  same(["--version"]);
  const json = ["rules", "--format", "json"];
  assert.deepEqual(JSON.parse(launch(json).stdout), JSON.parse(native(json).stdout));
});

for (const args of [["--no-cache", "--fix", "."], ["fmt", "."], ["fmt", "--check", "."]]) {
  test(`${args.join(" ")} changes the same files as the program`, (t) => {
    const [before, expected, actual] = [copy(t), copy(t), copy(t)];
    assert.deepEqual(launch(args, actual), native(args, expected));
    assert.deepEqual(contents(actual), contents(expected));
    assert.equal(args.includes("--check"), JSON.stringify(contents(before)) === JSON.stringify(contents(actual)));
  });
}

test("standard input is fixed and formatted", () => {
  const { stdout } = same(["--fix", "-"], MISTAKES, MISTAKE);
  assert.notEqual(stdout, MISTAKE);
  same(["fmt", "-"], MISTAKES, MISTAKE);
});

test("files that git ignores are not checked", (t) => {
  const folder = copy(t);
  assert.equal(spawnSync("git", ["init", "--quiet"], { cwd: folder }).status, 0);
  fs.writeFileSync(path.join(folder, ".gitignore"), "l*.glsl\n*.frag\n");
  same(["--no-cache", "."], folder);
});

// More than a pipe holds.
test("a reader may close the output early", () => {
  const { stderr } = run("sh", ["-c", '"$LAUNCHER" --format jsonl . | head -1'], MISTAKES);
  assert.equal(stderr, "");
});

test("commands that require the program are refused", (t) => {
  const refused = (args, message, cwd = MISTAKES) => {
    const { status, stderr, stdout } = launch(args, cwd);
    assert.deepEqual([status, stdout], [2, ""], args.join(" "));
    assert.match(stderr, message);
    assert.equal(stderr.split("\n").length, 2, stderr);
  };
  refused(["run", "a.glsl"], /^shaderlint: `run` needs the program; there is no package for freebsd-/);
  refused(["--only", "naming", "."], /the option '--only' needs the program; there is no package/);
  refused(["--format", "github", "."], /--format github needs the program/);
  refused(["--format", "json", "."], /--format json of several files needs the program/);
  refused(["explain", "nan", "compare"], /a search for several words needs the program/);
  refused(["--max-warnings"], /^shaderlint: Option '--max-warnings <value>' argument missing\n/);
  const folder = copy(t);
  fs.writeFileSync(path.join(folder, "shaderlint.toml"), "[rules]\n");
  refused(["."], /^shaderlint: shaderlint\.toml: configuration needs the program; --no-config/, folder);
  same(["--no-cache", "--no-config", "."], folder);
});
