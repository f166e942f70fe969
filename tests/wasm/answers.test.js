// The answers of the module are those of the program, byte for byte.

import assert from "node:assert/strict";
import fs from "node:fs";
import path from "node:path";
import { test } from "node:test";
import zlib from "node:zlib";
import { MODULES, native, ROOT, Shaderlint } from "./load.js";

/** The lines of findings by file. */
function byFile(lines) {
  const files = new Map();
  for (const line of lines.split("\n").filter(Boolean)) {
    const { file } = JSON.parse(line);
    files.set(file, `${files.get(file) ?? ""}${line}\n`);
  }
  return files;
}

/** Compares the findings of all files in a folder, none of which refers to another. */
function compare(shaderlint, folder, extensions) {
  const args = ["--format", "jsonl", "--no-cache", "--no-config", "--exit-zero", "."];
  const expected = byFile(native(args, { cwd: folder }));
  const all = fs.readdirSync(folder);
  // The two stages of a program are linked.
  const isLinked = (name) => all.includes(name.replace(/\.frag$/, ".vert")) && name.endsWith(".frag");
  const names = all.filter((name) => extensions.includes(path.extname(name)) && !isLinked(name));
  assert.ok(names.length > 2, folder);
  const wrong = names.filter((name) => {
    const text = fs.readFileSync(path.join(folder, name), "utf8");
    const { output } = shaderlint.report(text, { name, format: "jsonl" });
    return output !== (expected.get(name) ?? "");
  });
  assert.deepEqual(wrong, []);
}

test("the package has the version of the program", () => {
  const { version } = JSON.parse(fs.readFileSync(path.join(process.env.WASM, "package.json"), "utf8"));
  assert.equal(native(["--version"]).trim(), `shaderlint ${version}`);
});

/** A client of the debugger of a module. */
function client(shaderlint) {
  let seq = 0;
  return (command, args) => {
    const [response, ...events] = shaderlint.debug({ seq: ++seq, type: "request", command, arguments: args });
    assert.ok(response.success, `${command}: ${response.message}`);
    return { body: response.body, events };
  };
}

/** The numbers in a value as GLSL, as bits. */
const numbers = (value) => [...value.replace(/[a-z]+\d(x\d)?\(/g, "").matchAll(/-?[\d.]+(e-?\d+)?/g)].map(([n]) => Math.fround(Number(n)));

/** The bytes of a PNG with three bytes per pixel, top row first. */
function decoded(png) {
  const width = png.readUInt32BE(16);
  const height = png.readUInt32BE(20);
  const parts = [];
  for (let at = 8; at < png.length; at += 12 + png.readUInt32BE(at)) {
    if (png.toString("latin1", at + 4, at + 8) === "IDAT") parts.push(png.subarray(at + 8, at + 8 + png.readUInt32BE(at)));
  }
  const raw = zlib.inflateSync(Buffer.concat(parts));
  const bytes = Buffer.alloc(width * height * 3);
  const row = width * 3;
  for (let y = 0; y < height; y++) {
    const filter = raw[y * (row + 1)];
    for (let x = 0; x < row; x++) {
      const left = x < 3 ? 0 : bytes[y * row + x - 3];
      const above = y === 0 ? 0 : bytes[(y - 1) * row + x];
      const corner = x < 3 || y === 0 ? 0 : bytes[(y - 1) * row + x - 3];
      const near = [left, above, corner].sort((p, q) => Math.abs(left + above - corner - p) - Math.abs(left + above - corner - q))[0];
      const by = [0, left, above, (left + above) >> 1, near][filter];
      bytes[y * row + x] = raw[y * (row + 1) + 1 + x] + by;
    }
  }
  return bytes;
}

/** A step over in `mainImage` shows what `run` traces for the pixel, and draws over the screen. */
function stepped(ask, shaderlint, [file, text, options]) {
  const { facts } = shaderlint.run(text, { name: file, ...options });
  const written = facts.steps.map(([site, value]) => ({ ...facts.sites[site], value }));
  const drawn = new Set();
  let count = 0;
  let last;
  for (;;) {
    const [{ id, line, name }] = ask("stackTrace", { threadId: 0 }).body.stackFrames;
    assert.equal(name, "mainImage");
    const wrote = written.find((site) => site.function === "mainImage" && site.kind === "written" && site.line === last);
    if (wrote) {
      const { result } = ask("evaluate", { expression: wrote.name, frameId: id }).body;
      assert.deepEqual(numbers(result), wrote.value.map(Math.fround), `${wrote.name} on line ${last}`);
      count++;
    }
    // These are written once, by all pixels.
    if (wrote && ["uv", "ro", "rd", "t", "q"].includes(wrote.name)) {
      const image = ask("shaderlint/image", { expression: wrote.name, frameId: id }).body;
      assert.equal(image.pixels, options.size[0] * options.size[1]);
      const shown = shaderlint.run(text, { name: file, ...options, pixel: undefined, show: { name: wrote.name, line: last } });
      assert.ok(decoded(Buffer.from(image.png, "base64")).equals(Buffer.from(shown.image.rgb, "base64")), wrote.name);
      drawn.add(wrote.name);
    }
    last = line;
    if (ask("next").events.some(({ event }) => event === "terminated")) break;
  }
  assert.ok(count > 8 && drawn.size === 5, `${count} values, ${[...drawn]}`);
}

for (const [name, address] of Object.entries(MODULES)) {
  test(`${name}: findings in shaders with mistakes equal those of the program`, async () => {
    compare(await Shaderlint.load(address), path.join(ROOT, "corpus/mistakes"), [".glsl", ".frag"]);
  });

  test(`${name}: findings in templates equal those of the program`, async () => {
    const folder = path.join(ROOT, "corpus/templates");
    compare(await Shaderlint.load(address), folder, [".glsl", ".json"]);
  });

  const cases = process.env.SHADERLINT_CASES;
  test(`${name}: findings in exports equal those of the program`, { skip: !cases && "SHADERLINT_CASES is not set" }, async () => {
    compare(await Shaderlint.load(address), path.join(cases, "shadertoy"), [".json"]);
  });

  test(`${name}: reports, fixes, formatting and rule pages equal those of the program`, async () => {
    const shaderlint = await Shaderlint.load(address);
    const file = "corpus/mistakes/define_with_semicolon.glsl";
    const text = fs.readFileSync(path.join(ROOT, file), "utf8");
    assert.equal(shaderlint.report(text, { name: file }).output, native(["--no-cache", file]));
    const stdin = (...args) => native([...args, "--stdin-filename", "a.glsl", "-"], { input: text });
    assert.equal(shaderlint.fix(text, { name: "a.glsl" }).text, stdin("--fix", "--quiet", "--quiet"));
    assert.equal(shaderlint.format(text, { name: "a.glsl" }).text, stdin("fmt", "--quiet"));
    assert.equal(shaderlint.explain("sqrt-negative"), native(["explain", "sqrt-negative"]));
    assert.deepEqual(shaderlint.rules(), JSON.parse(native(["rules", "--format", "json"])));
    assert.throws(() => shaderlint.explain("sqrt-nagative"), /did you mean `sqrt-negative`/);
  });

  test(`${name}: images, statistics and traces equal those of the program`, { skip: name !== "port" && "another module does" }, async () => {
    const shaderlint = await Shaderlint.load(address);
    const folder = path.join(ROOT, "corpus/templates");
    const names = fs.readdirSync(folder).filter((file) => file.endsWith(".glsl"));
    const size = ["--size", "64x36", "--time", "1.5"];
    for (const file of names) {
      const text = fs.readFileSync(path.join(folder, file), "utf8");
      const options = { name: file, size: [64, 36], time: 1.5 };
      const run = (...args) => native(["run", file, ...size, ...args], { cwd: folder });
      const drawn = shaderlint.run(text, { ...options, report: true });
      assert.equal(drawn.text, run("--report"));
      assert.deepEqual(drawn.facts, JSON.parse(run("--report", "--format", "json")));
      assert.equal(atob(drawn.image.rgb).length, 64 * 36 * 3);
      const traced = shaderlint.run(text, { ...options, pixel: [33, 17] });
      assert.equal(traced.text, run("--pixel", "33,17"));
      assert.deepEqual(traced.facts, JSON.parse(run("--pixel", "33,17", "--format", "json")));
      assert.equal(traced.image, null);
      const sheet = shaderlint.run(text, { ...options, sheet: 2 });
      assert.equal(sheet.text, run("--sheet", "2"));
      const same = shaderlint.run(text, { ...options, compare: { name: "b.glsl", text: `//\n${text}` } });
      assert.equal(same.facts.same, true);
    }
    assert.throws(() => shaderlint.run("void main() {", {}), /shader\.glsl: the shader has errors/);
    const plain = "void mainImage(out vec4 c, in vec2 p) { c = vec4(1.0); }";
    assert.throws(() => shaderlint.run(plain, { size: [1 << 20, 9] }), /at most 4194304 pixels/);
    assert.deepEqual(shaderlint.check(plain, { only: ["int-float-mix"] }).diagnostics, []);
    const [three] = shaderlint.port(plain, { output: "a.js", target: "three" }).files;
    assert.match(three.text, /RawShaderMaterial/);
    assert.throws(() => shaderlint.port(plain, { target: "cobol" }), /expected one of `html`, /);
  });

  test(`${name}: the debugger steps through a shader`, { skip: name !== "port" && "another module does" }, async () => {
    const shaderlint = await Shaderlint.load(address);
    const file = "raymarching.glsl";
    const text = fs.readFileSync(path.join(ROOT, "corpus/templates", file), "utf8");
    const options = { size: [64, 36], time: 1.5, pixel: [33, 17] };
    const ask = client(shaderlint);
    ask("initialize", { adapterID: "shaderlint" });
    ask("launch", { program: file, text, ...options });
    const [{ event }] = ask("configurationDone").events;
    assert.equal(event, "stopped");
    stepped(ask, shaderlint, [file, text, options]);
    const source = { path: file };
    assert.deepEqual(ask("loadedSources").body.sources, [{ name: file, ...source }]);
    // A line that few pixels reach, and one that each reaches several times.
    const surface = text.split("\n").findIndex((line) => line.includes("mix(shade(")) + 1;
    const [{ line, verified }] = ask("setBreakpoints", { source, breakpoints: [{ line: surface }] }).body.breakpoints;
    assert.deepEqual([line, verified], [surface, true]);
    const [{ body }] = shaderlint.debugIdle();
    assert.match(body.breakpoint.message, /^hit by [\d,]+ of 2,304 pixels$/);
    assert.equal(ask("reverseContinue").events[0].body.reason, "breakpoint");
    // Another text at the same line.
    assert.equal(ask("stackTrace").body.stackFrames[0].line, surface);
    ask("shaderlint/reload", { text: `\n${text}` });
    assert.equal(ask("stackTrace").body.stackFrames[0].line, surface + 1);
    ask("setBreakpoints", { source, breakpoints: [] });
    assert.throws(() => ask("shaderlint/reload", { text: "void main() {" }), /raymarching\.glsl: the shader has errors/);
    ask("disconnect");
    assert.throws(() => ask("threads"), /no program is running/);
  });

  test(`${name}: the debugger draws the passes that a channel reads`, { skip: name !== "port" && "another module does" }, async () => {
    const ask = client(await Shaderlint.load(address));
    const passes = {
      "buffer_a.glsl": "void mainImage(out vec4 c, in vec2 p) {\n    c = vec4(0.25);\n}\n",
      "image.glsl": "void mainImage(out vec4 c, in vec2 p) {\n    float x = texelFetch(iChannel0, ivec2(p), 0).x;\n    c = vec4(x);\n}\n",
    };
    ask("initialize", { adapterID: "shaderlint" });
    ask("launch", { program: "folder", passes, channels: ["image.0=buffer_a"], size: [64, 36], pixel: [3, 4] });
    ask("configurationDone");
    ask("next");
    const [{ id, source }] = ask("stackTrace").body.stackFrames;
    assert.equal(source.path, "image.glsl");
    assert.equal(ask("evaluate", { expression: "x", frameId: id }).body.result, "0.25");
    ask("shaderlint/pixel", { pass: "buffer_a" });
    assert.equal(ask("stackTrace").body.stackFrames[0].source.path, "buffer_a.glsl");
  });

  test(`${name}: deeply nested texts do not crash the module`, async () => {
    const shaderlint = await Shaderlint.load(address);
    const of = (open, close) => {
      const nested = `${open.repeat(20_000)}1.0${close.repeat(20_000)}`;
      return `void mainImage(out vec4 c, in vec2 p) { c = vec4(${nested}); }\n`;
    };
    const texts = [of("(", ")"), of("-", ""), of("abs(", ")"), of("1.0 + (", ")"), "{".repeat(50_000)];
    for (const text of texts) {
      assert.ok(shaderlint.check(text).diagnostics.length > 0, text.slice(0, 60));
    }
  });
}
