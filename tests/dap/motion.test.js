// Steps in both directions, to breakpoints, and to other pixels.
import assert from "node:assert/strict";
import fs from "node:fs";
import { test } from "node:test";
import { BALL, file, launched } from "./client.js";

const program = file("ball.glsl", BALL);

test("stepping goes in, over, out and back", async () => {
  const session = await launched({ program, size: [8, 8], pixel: [4, 4] });
  assert.equal(session.first.reason, "entry");
  assert.equal(await session.stack(), "mainImage:9");
  assert.equal(await session.to("next"), "mainImage:10");
  assert.equal(await session.to("next"), "mainImage:11");
  assert.equal(await session.to("next"), "mainImage:12");
  while (!(await session.stack()).endsWith(":13")) await session.to("next");
  assert.equal(await session.to("stepIn"), "field:4 mainImage:13");
  assert.equal(await session.to("next"), "field:5 mainImage:13");
  assert.equal(await session.value("d"), "2.0");
  assert.equal(await session.to("stepOut"), "mainImage:13");
  assert.equal((await session.variables())["(returned)"].value, "2.0");
  assert.equal(await session.to("next"), "mainImage:14");
  assert.equal(await session.to("stepBack"), "mainImage:13");
  assert.equal(await session.to("next"), "mainImage:14");
  assert.equal(await session.to("shaderlint/stepBackIn"), "field:5 mainImage:13");
  assert.equal(await session.to("stepBack", { granularity: "instruction" }), "field:4 mainImage:13");
  assert.equal(await session.to("shaderlint/stepBackOut"), "mainImage:13");
});

test("execution continues to the next iteration and back to the last write of a value", async () => {
  const session = await launched({ program, size: [8, 8] }, { breakpoints: [{ line: 14 }] });
  assert.equal((await session.move("continue")).reason, "breakpoint");
  assert.equal(await session.value("i"), "0");
  await session.setBreakpoints([]);
  await session.move("shaderlint/nextIteration");
  assert.match(await session.stack(), /^mainImage:12$/);
  assert.equal(await session.value("hit.way"), "1.0");
  await session.move("shaderlint/nextIteration");
  assert.equal(await session.value("hit.way"), "1.5");
  await session.move("shaderlint/written", { expression: "hit.way" });
  assert.equal(await session.stack(), "mainImage:14");
  assert.equal(await session.value("hit.way"), "1.0");
  await session.move("shaderlint/written", { expression: "hit.steps" });
  assert.equal(await session.stack(), "mainImage:15");
  assert.match(await session.refused("shaderlint/written", { expression: "nothing" }), /unknown variable `nothing`/);
});

test("each step back restores every value", async () => {
  const session = await launched({ program, size: [8, 8] });
  const state = async () => {
    const values = Object.entries(await session.variables()).map(([name, { value }]) => `${name}=${value}`);
    return `${await session.stack()} ${values.join(" ")}`;
  };
  const seen = [await state()];
  while (!seen.at(-1).startsWith("mainImage:20")) {
    await session.move("stepIn");
    seen.push(await state());
  }
  assert.ok(seen.length > 20, `${seen.length} steps`);
  for (const expected of seen.slice(0, -1).reverse()) {
    // A return is a stop of its own on the way there.
    if (expected.includes("(returned)")) continue;
    await session.move("shaderlint/stepBackIn");
    assert.equal(await state(), expected);
  }
});

test("execution ends after the last statement and reverses to the first", async () => {
  const session = await launched({ program, size: [8, 8] });
  await session.move("continue");
  assert.equal(await session.stack(), "mainImage:21");
  assert.equal((await session.move("reverseContinue")).reason, "entry");
  assert.equal(await session.stack(), "mainImage:9");
  await session.move("continue");
  const ended = session.client.waitForEvent("terminated");
  await session.ask("continue");
  await ended;
});

test("the pixel, time and frame can be changed", async () => {
  const moving = file("moving.glsl", `void mainImage(out vec4 fragColor, in vec2 fragCoord) {
    float x = fragCoord.x;
    fragColor = vec4(x, iTime, float(iFrame), 1.0);
}
`);
  const session = await launched({ program: moving, size: [8, 8], pixel: [2, 3], time: 0.5, stopOnEntry: false }, { breakpoints: [{ line: 3 }] });
  assert.equal(await session.value("fragCoord"), "vec2(2.5, 3.5)");
  assert.equal(await session.value("iTime"), "0.5");
  await session.move("shaderlint/pixel", { pixel: [7, 0] });
  assert.equal(await session.stack(), "mainImage:3");
  assert.equal(await session.value("x"), "7.5");
  await session.move("shaderlint/pixel", { time: 2 });
  assert.equal(await session.value("iTime"), "2.0");
  assert.equal(await session.value("x"), "7.5");
  await session.move("shaderlint/pixel", { frame: 3 });
  assert.equal(await session.value("iFrame"), "3");
  assert.match(await session.refused("shaderlint/pixel", { pixel: [8, 0] }), /the pixel 8,0 is outside the image of 8x8/);
  assert.equal(await session.value("x"), "7.5");
});

test("the pixels of the quad are threads", async () => {
  const session = await launched({ program, size: [8, 8], pixel: [5, 4] });
  const { threads } = await session.ask("threads");
  assert.deepEqual(threads.map(({ name }) => name), ["pixel 4,4", "pixel 5,4", "pixel 4,5", "pixel 5,5"]);
  assert.equal(session.first.threadId, 2);
  assert.equal(session.first.allThreadsStopped, true);
  const at = await Promise.all(threads.map(async ({ id }) => session.value("fragCoord", (await session.frames(id))[0].id)));
  assert.deepEqual(at, ["vec2(4.5, 4.5)", "vec2(5.5, 4.5)", "vec2(4.5, 5.5)", "vec2(5.5, 5.5)"]);
  const stopped = await session.move("next", { threadId: 3 });
  assert.equal(stopped.threadId, 3);
  assert.equal(await session.stack(3), "mainImage:10");
});

test("a failed step does not change the position", async () => {
  const session = await launched({ program: file("still.glsl", BALL), size: [8, 8] });
  const stopped = session.client.waitForEvent("stopped");
  assert.ok(await session.refused("next", { threadId: 9 }));
  assert.deepEqual([(await stopped).body.reason, (await stopped).body.threadId], ["pause", session.first.threadId]);
  assert.equal(await session.stack(), "mainImage:9");
});

test("reloading keeps the position in the header of a loop", async () => {
  const session = await launched({ program: file("head.glsl", BALL), size: [8, 8] });
  const column = async () => (await session.frames())[0].column;
  while ((await session.stack()) !== "mainImage:12") await session.move("next");
  for (const at of [10, 21, 28, 21]) {
    assert.equal(await column(), at);
    await session.move("shaderlint/reload");
    assert.equal(await column(), at);
    await session.move("shaderlint/nextIteration");
    if (at === 21) await session.move("shaderlint/stepBackIn");
  }
});

test("reloading an edited program keeps the position", async () => {
  const edited = file("edited.glsl", BALL);
  const session = await launched({ program: edited, size: [8, 8] }, { breakpoints: [{ line: 14 }] });
  await session.move("continue");
  await session.move("continue");
  assert.equal(await session.value("i"), "1");
  fs.writeFileSync(edited, BALL.replace("- 1.0;", "- 2.0;"));
  await session.move("shaderlint/reload");
  assert.equal(await session.stack(), "mainImage:14");
  assert.equal(await session.value("i"), "1");
  assert.equal(await session.value("hit.way"), "0.5");
  // Broken code leaves the session as it is.
  fs.writeFileSync(edited, BALL.replace("- 1.0;", "- ;"));
  assert.match(await session.refused("shaderlint/reload"), /edited\.glsl:4/);
  assert.equal(await session.value("hit.way"), "0.5");
  fs.writeFileSync(edited, BALL);
  await session.move("restart");
  assert.equal(await session.value("hit.way"), "1.0");
});
