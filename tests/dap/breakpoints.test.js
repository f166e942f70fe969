// Breakpoints with conditions, counts and messages; faults; data breakpoints.
import assert from "node:assert/strict";
import { test } from "node:test";
import { BALL, file, launched } from "./client.js";

const program = file("ball.glsl", BALL);
const small = { program, size: [8, 6] };

test("a breakpoint stops each time, forwards and backwards", async () => {
  const session = await launched(small, { breakpoints: [{ line: 14 }] });
  const [{ id, verified, line }] = session.breakpoints;
  assert.deepEqual([verified, line], [true, 14]);
  for (const i of ["0", "1", "2", "3"]) {
    const { reason, hitBreakpointIds } = await session.move("continue");
    assert.deepEqual([reason, hitBreakpointIds], ["breakpoint", [id]]);
    assert.equal(await session.value("i"), i);
  }
  assert.equal((await session.move("reverseContinue")).reason, "breakpoint");
  assert.equal(await session.value("i"), "2");
});

test("a breakpoint moves to the next statement, and counts its pixels", async () => {
  const session = await launched(small);
  const counted = session.client.waitForEvent("breakpoint");
  const [moved, nowhere] = await session.setBreakpoints([{ line: 2 }, { line: 99 }]);
  assert.deepEqual([moved.verified, moved.line], [true, 4]);
  assert.deepEqual([nowhere.verified, nowhere.line], [false, 99]);
  assert.ok(nowhere.message);
  const { body } = await counted;
  assert.equal(body.breakpoint.id, moved.id);
  assert.equal(body.breakpoint.message, "hit by 48 of 48 pixels, 192 times");
});

test("conditional breakpoints stop where the condition is true", async () => {
  const session = await launched({ ...small, stopOnEntry: false }, { breakpoints: [{ line: 14, condition: "i == 2 && fragCoord.x > 4.0" }] });
  assert.equal(await session.value("i"), "2");
  await session.move("continue");
  assert.equal(await session.stack(), "mainImage:21");
  // The error is known when the condition is compiled.
  const failed = new Promise((resolve) => {
    session.client.on("breakpoint", ({ body }) => body.breakpoint.verified || resolve(body.breakpoint.message));
  });
  await session.setBreakpoints([{ line: 14, condition: "j == 2" }]);
  assert.match(await failed, /j/);
});

test("hit conditions count how often a breakpoint is reached", async () => {
  const at = async (hitCondition) => {
    const session = await launched({ ...small, stopOnEntry: false }, { breakpoints: [{ line: 14, hitCondition }] });
    return session.value("i");
  };
  assert.equal(await at("3"), "2");
  assert.equal(await at(">= 2"), "1");
  assert.equal(await at("% 4"), "3");
  const session = await launched(small, { breakpoints: [{ line: 14, hitCondition: "often" }] });
  assert.equal(session.breakpoints[0].verified, false);
  assert.match(session.breakpoints[0].message, /expected a number of hits/);
});

test("log points print and do not stop", async () => {
  const session = await launched(small, { breakpoints: [{ line: 14, logMessage: "{i}: way {hit.way}" }, { line: 17 }] });
  await session.move("continue");
  assert.equal(await session.stack(), "mainImage:17");
  assert.equal(session.output, "0: way 0.0\n1: way 1.0\n2: way 1.5\n3: way 1.75\n");
});

test("a breakpoint inside a call ends a step over it", async () => {
  const session = await launched(small, { breakpoints: [{ line: 4 }] });
  while (!(await session.stack()).endsWith(":13")) await session.to("next");
  assert.equal(await session.to("next"), "field:4 mainImage:13");
});

test("execution stops at the selected faults", async () => {
  const faulty = file("faulty.glsl", `void mainImage(out vec4 fragColor, in vec2 fragCoord) {
    float zero = fragCoord.x - 4.5;
    float up = 1.0 / zero;
    float list[4] = float[4](1.0, 2.0, 3.0, 4.0);
    int at = int(fragCoord.x);
    float found = list[at];
    float root = sqrt(-1.0 - zero * zero);
    fragColor = vec4(up, found, root, 1.0);
}
`);
  const given = { program: faulty, size: [8, 6], pixel: [4, 3] };
  const session = await launched(given, { filters: ["infinite", "index"] });
  const filters = session.capabilities.exceptionBreakpointFilters.map(({ filter }) => filter);
  assert.deepEqual(filters, ["nan", "infinite", "division", "index", "undefined", "uninitialized", "exhausted"]);
  assert.equal((await session.move("continue")).reason, "exception");
  assert.equal(await session.stack(), "mainImage:3");
  const { exceptionId, description, breakMode } = await session.ask("exceptionInfo", { threadId: 1 });
  assert.equal(exceptionId, "infinite");
  assert.equal(description, "`1.0 / zero` is infinite");
  assert.equal(breakMode, "always");
  await session.move("continue");
  assert.equal(await session.stack(), "mainImage:6");
  await session.move("reverseContinue");
  assert.equal(await session.stack(), "mainImage:3");
  // Without filters nothing stops.
  await session.ask("setExceptionBreakpoints", { filters: [] });
  await session.move("continue");
  assert.equal(await session.stack(), "mainImage:9");
});

test("each fault is found by its own filter", async () => {
  const faulty = file("faults.glsl", `void mainImage(out vec4 fragColor, in vec2 fragCoord) {
    float zero = fragCoord.x - 4.5;
    float up = 1.0 / zero;
    float sum = 0.0;
    for (int i = 0; i < 3; i++) sum += up;
    for (int i = 0; i < 5; i++) {
        if (sum < 0.0) break;
        sum += 1.0;
    }
    vec2 later;
    later.x = sum;
    float both = later.x + later.y;
    fragColor = vec4(both);
}
`);
  const places = { division: 3, exhausted: 6, uninitialized: 12 };
  for (const [filter, line] of Object.entries(places)) {
    const given = { program: faulty, size: [8, 6], pixel: [4, 3] };
    const session = await launched(given, { filters: [filter] });
    assert.equal((await session.move("continue")).reason, "exception");
    assert.equal(await session.stack(), `mainImage:${line}`, filter);
    const { exceptionId } = await session.ask("exceptionInfo", { threadId: 1 });
    assert.equal(exceptionId, filter);
  }
});

test("a data breakpoint stops after each write", async () => {
  const session = await launched(small);
  while (!(await session.stack()).endsWith(":12")) await session.to("next");
  const { dataId, accessTypes } = await session.ask("dataBreakpointInfo", { name: "hit" });
  assert.deepEqual(accessTypes, ["write"]);
  const { breakpoints } = await session.ask("setDataBreakpoints", { breakpoints: [{ dataId }] });
  assert.equal(breakpoints[0].verified, true);
  assert.equal((await session.move("continue")).reason, "data breakpoint");
  assert.equal(await session.stack(), "mainImage:15");
  assert.equal(await session.value("hit.way"), "1.0");
  await session.move("continue");
  assert.equal(await session.value("hit.steps"), "1");
  assert.equal((await session.ask("dataBreakpointInfo", { name: "nothing" })).dataId, null);
});

test("function breakpoints are accepted and ignored", async () => {
  const session = await launched(small);
  assert.deepEqual(await session.ask("setFunctionBreakpoints", { breakpoints: [] }), { breakpoints: [] });
});

test("possible breakpoints of a range are listed", async () => {
  const session = await launched(small);
  const { breakpoints } = await session.ask("breakpointLocations", { source: { path: program }, line: 9, endLine: 11 });
  assert.deepEqual(breakpoints.map(({ line, column }) => `${line}:${column}`), ["9:5", "10:5", "11:5"]);
});
