// The answers of the module are those of the program, byte for byte.

import assert from "node:assert/strict";
import fs from "node:fs";
import path from "node:path";
import { test } from "node:test";
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

for (const [name, address] of Object.entries(MODULES)) {
  test(`${name}: mistakes`, async () => {
    compare(await Shaderlint.load(address), path.join(ROOT, "corpus/mistakes"), [".glsl", ".frag"]);
  });

  test(`${name}: templates`, async () => {
    const folder = path.join(ROOT, "corpus/templates");
    compare(await Shaderlint.load(address), folder, [".glsl", ".json"]);
  });

  const cases = process.env.SHADERLINT_CASES;
  test(`${name}: exports`, { skip: !cases && "SHADERLINT_CASES is not set" }, async () => {
    compare(await Shaderlint.load(address), path.join(cases, "shadertoy"), [".json"]);
  });

  test(`${name}: text for people, fixes, formatting, pages`, async () => {
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

  test(`${name}: images, statistics and traces`, { skip: name !== "port" && "another module does" }, async () => {
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
      const same = shaderlint.run(text, { ...options, compare: { name: "b.glsl", text: `//\n${text}` } });
      assert.equal(same.facts.same, true);
    }
    assert.throws(() => shaderlint.run("void main() {", {}), /shader\.glsl: the shader has errors/);
    const plain = "void mainImage(out vec4 c, in vec2 p) { c = vec4(1.0); }";
    assert.throws(() => shaderlint.run(plain, { size: [1 << 20, 9] }), /at most 4194304 pixels/);
  });

  test(`${name}: texts that nest deeply are answered`, async () => {
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
