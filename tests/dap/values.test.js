// Variables, expressions and images.
import assert from "node:assert/strict";
import { test } from "node:test";
import { BALL, file, launched } from "./client.js";

const program = file("ball.glsl", BALL);
const atEnd = () => launched({ program, size: [8, 6], stopOnEntry: false }, { breakpoints: [{ line: 20 }] });

test("variables of every type are shown with their parts", async () => {
  const session = await atEnd();
  const { tint, hit, turn, list, fragCoord } = await session.variables();
  assert.equal(fragCoord.value, "vec2(4.5, 3.5)");
  assert.equal(tint.type, "vec3");
  assert.equal(tint.value, "vec3(0.8, 0.6, 0.4)");
  assert.equal(tint.color, "#cc9966");
  assert.equal(hit.value, "Hit(1.875, 4)");
  assert.equal(turn.value, "mat2(1.0, 2.0, 3.0, 4.0)");
  assert.equal(list.value, "float[3](1.0, 2.0, 1.875)");
  const members = await session.parts(hit.variablesReference);
  assert.equal(members.steps.value, "4");
  assert.equal(members.way.evaluateName, "hit.way");
  const columns = await session.parts(turn.variablesReference);
  assert.equal(columns["[1]"].value, "vec2(3.0, 4.0)");
  assert.equal((await session.parts(columns["[1]"].variablesReference)).y.evaluateName, "turn[1].y");
  const some = await session.parts(list.variablesReference, { filter: "indexed", start: 1, count: 1 });
  assert.deepEqual(Object.keys(some), ["[1]"]);
});

test("a variable appears after its declaration", async () => {
  const session = await launched({ program, size: [8, 6] });
  assert.ok(!("uv" in (await session.variables())));
  await session.move("next");
  assert.equal((await session.variables()).uv.type, "vec2");
});

test("scopes show uniforms and the variables of callers", async () => {
  const session = await launched({ program, size: [8, 6], stopOnEntry: false, uniforms: {} }, { breakpoints: [{ line: 5 }] });
  const [inner, outer] = await session.frames();
  assert.deepEqual([inner.name, outer.name], ["field", "mainImage"]);
  assert.deepEqual(Object.keys(await session.variables("Locals", inner.id)), ["p", "d"]);
  assert.ok("ray" in (await session.variables("Locals", outer.id)));
  assert.equal(await session.value("ray", outer.id), "vec3(0.0, 0.0, 1.0)");
  assert.equal((await session.variables("Uniforms")).iResolution.value, "vec3(8.0, 6.0, 1.0)");
  // A level at a time, as clients ask.
  const one = await session.ask("stackTrace", { threadId: session.first.threadId, startFrame: 1, levels: 1 });
  assert.deepEqual(one.stackFrames.map(({ name }) => name), ["mainImage"]);
  assert.equal(one.totalFrames, 2);
});

test("any expression can be evaluated", async () => {
  const session = await atEnd();
  assert.equal(await session.value("hit.way * 2.0"), "3.75");
  assert.equal(await session.value("tint.bgr"), "vec3(0.4, 0.6, 0.8)");
  assert.equal(await session.value("field(vec3(0.0, 3.0, 4.0))"), "4.0");
  assert.equal(await session.value("hit.steps > 3 && turn[0].x == 1.0"), "true");
  assert.equal(await session.value("list.length()"), "3");
  const shown = await session.ask("evaluate", { expression: "tint * 0.5", context: "hover" });
  assert.equal(shown.color, "#664d33");
  assert.equal((await session.parts(shown.variablesReference)).z.value, "0.2");
  assert.match(await session.refused("evaluate", { expression: "nothing" }), /nothing/);
  assert.notEqual(await session.refused("evaluate", { expression: "tint +" }), "");
  assert.notEqual(await session.refused("evaluate", { expression: "" }), "");
});

test("an expression can be drawn for all pixels", async () => {
  const session = await atEnd();
  const image = await session.ask("shaderlint/image", { expression: "uv" });
  assert.deepEqual([image.width, image.height, image.pixels], [8, 6, 48]);
  const png = Buffer.from(image.png, "base64");
  assert.equal(png.toString("latin1", 1, 4), "PNG");
  assert.deepEqual([png.readUInt32BE(16), png.readUInt32BE(20)], [8, 6]);
  assert.match(await session.refused("shaderlint/image", { expression: "nothing" }), /nothing/);
});

test("references to values are invalid after a step", async () => {
  const session = await atEnd();
  const { hit } = await session.variables();
  await session.move("stepBack");
  assert.match(await session.refused("variables", { variablesReference: hit.variablesReference }), /no longer shown/);
  assert.match(await session.refused("scopes", { frameId: 999 }), /no such frame/);
});
