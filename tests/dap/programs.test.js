// What can be launched: exports, folders of passes, files with includes; lines from 0; what cannot.
import assert from "node:assert/strict";
import { spawn } from "node:child_process";
import path from "node:path";
import { test } from "node:test";
import { BALL, connected, file, launched } from "./client.js";

const BUFFER = `void mainImage(out vec4 fragColor, in vec2 fragCoord) {
    vec4 old = texelFetch(iChannel0, ivec2(fragCoord), 0);
    fragColor = old + 1.0;
}
`;
const IMAGE = `void mainImage(out vec4 fragColor, in vec2 fragCoord) {
    vec4 count = texelFetch(iChannel0, ivec2(fragCoord), 0);
    fragColor = count / 10.0;
}
`;

test("passes of an export are sources without files", async () => {
  const input = { id: 257, src: "", ctype: "buffer", channel: 0, sampler: {} };
  const passes = [
    { inputs: [input], outputs: [{ id: 257, channel: 0 }], code: BUFFER, name: "Buffer A", type: "buffer" },
    { inputs: [input], outputs: [{ id: 37, channel: 0 }], code: IMAGE, name: "Image", type: "image" },
  ];
  const shader = { ver: "0.1", info: { id: "abcdef", name: "Counter" }, renderpass: passes };
  const program = file("counter.json", JSON.stringify({ Shader: shader }));
  const session = await launched({ program, size: [8, 6], frame: 3 });
  const [{ source, line }] = await session.frames();
  assert.equal(line, 2);
  assert.equal(source.path, undefined);
  assert.ok(source.sourceReference > 0);
  const { content } = await session.ask("source", { source, sourceReference: source.sourceReference });
  assert.equal(content.trim(), IMAGE.trim());
  assert.match(await session.refused("source", { sourceReference: 99 }), /no such source/);
  const [{ verified }] = await session.setBreakpoints([{ line: 3 }], { name: source.name, sourceReference: source.sourceReference });
  assert.ok(verified);
  await session.move("continue");
  assert.equal(await session.value("count"), "vec4(4.0, 4.0, 4.0, 4.0)");
  await session.move("shaderlint/pixel", { pass: "buffer_a", frame: 5 });
  await session.move("next");
  assert.equal(await session.value("old"), "vec4(5.0, 5.0, 5.0, 5.0)");
  assert.notEqual(await session.refused("shaderlint/pixel", { pass: "buffer_z" }), "");
});

test("a pass of a folder is debugged in the requested frame", async () => {
  const image = file("passes/image.glsl", IMAGE);
  file("passes/buffer_a.glsl", BUFFER);
  file("passes/channels.toml", "0 = \"buffer_a\"\n\n[buffer_a]\n0 = \"buffer_a\"\n");
  const program = path.dirname(image);
  const session = await launched({ program, pass: "buffer_a", size: [8, 6], frame: 7 });
  const [{ source }] = await session.frames();
  assert.match(source.path, /passes\/buffer_a\.glsl$/);
  await session.move("next");
  assert.equal(await session.value("old"), "vec4(7.0, 7.0, 7.0, 7.0)");
  const { sources } = await session.ask("loadedSources");
  assert.ok(sources.some((known) => known.path?.endsWith("buffer_a.glsl")));
});

/** A folder with a pass that takes a loop of so many iterations in each pixel. */
function slow(folder, iterations) {
  const image = file(`${folder}/image.glsl`, IMAGE);
  file(`${folder}/buffer_a.glsl`, `void mainImage(out vec4 fragColor, in vec2 fragCoord) {
    float sum = 0.0;
    for (int i = 0; i < ${iterations}; i++) sum += 1.0;
    fragColor = vec4(sum);
}
`);
  file(`${folder}/channels.toml`, "0 = \"buffer_a\"\n");
  return path.dirname(image);
}

test("the first stop does not wait for other passes", async () => {
  const start = { supportsProgressReporting: true };
  // The pass would be drawn for many minutes.
  const session = await launched({ program: slow("endless", 1000000000), size: [8, 6] }, { start });
  assert.equal(await session.value("fragCoord"), "vec2(4.5, 3.5)");
  const [[begun, id]] = session.progress;
  assert.equal(begun, "progressStart");
  assert.equal(session.progress.length, 1);
  const ended = session.client.waitForEvent("progressEnd");
  await session.move("shaderlint/pixel", { pass: "buffer_a" });
  assert.equal((await ended).body.progressId, id);
});

test("the first statement that reads another pass waits for it", async () => {
  const session = await launched({ program: slow("slow", 100000), size: [8, 6] });
  await session.move("next");
  assert.equal(await session.value("count.x"), "100000.0");
});

test("breakpoints in included files are hit", async () => {
  const tint = file("tint.glsl", "vec3 tint(float x) {\n    vec3 c = vec3(x);\n    return c;\n}\n");
  const program = file("tinted.glsl", `#include "tint.glsl"
void mainImage(out vec4 fragColor, in vec2 fragCoord) {
    fragColor = vec4(tint(0.5), 1.0);
}
`);
  const session = await launched({ program, size: [8, 6] });
  const [{ verified, line }] = await session.setBreakpoints([{ line: 2 }], { path: tint });
  assert.deepEqual([verified, line], [true, 2]);
  await session.move("continue");
  assert.equal(await session.stack(), "tint:2 mainImage:3");
  const [{ source }] = await session.frames();
  assert.equal(path.basename(source.path), "tint.glsl");
});

test("clients may count lines and columns from 0", async () => {
  const program = file("ball.glsl", BALL);
  const start = { linesStartAt1: false, columnsStartAt1: false };
  const session = await launched({ program, size: [8, 6] }, { breakpoints: [{ line: 13 }], start });
  assert.equal(session.breakpoints[0].line, 13);
  const [{ line, column }] = await session.frames();
  assert.deepEqual([line, column], [8, 4]);
  await session.move("continue");
  assert.equal(await session.stack(), "mainImage:13");
  const { breakpoints } = await session.ask("breakpointLocations", { source: { path: program }, line: 8 });
  assert.deepEqual(breakpoints, [{ line: 8, column: 4 }]);
});

test("programs that cannot be launched are reported", async () => {
  const client = await connected();
  await client.initializeRequest();
  const launch = (args) => client.launchRequest(args).then(() => "", (error) => error.message);
  const program = file("ball.glsl", BALL);
  assert.match(await launch({}), /`program` is missing/);
  assert.match(await launch({ program: path.join(path.dirname(program), "none.glsl") }), /none\.glsl/);
  const broken = file("broken.glsl", BALL.replace("- 1.0;", "- one;"));
  assert.match(await launch({ program: broken }), /broken\.glsl:4:\d+: .*`one`/);
  assert.match(await launch({ program, size: [8, 8], pixel: [8, 0] }), /the pixel 8,0 is outside the image of 8x8/);
  assert.match(await launch({ program, size: [0, 8] }), /at least 1/);
  assert.match(await launch({ program, size: "large" }), /wrong arguments/);
  assert.notEqual(await launch({ program, pass: "buffer_z" }), "");
  assert.notEqual(await launch({ program, host: "nobody" }), "");
  assert.match(await client.attachRequest({}).catch((error) => error.message), /use `launch`/);
  // The next one can be.
  assert.equal(await launch({ program }), "");
});

test("requests without a program, unknown requests and requests after the end are errors", async () => {
  const client = await connected();
  await client.initializeRequest();
  const refused = (command, args = {}) => client.customRequest(command, args).then(() => "", (error) => error.message);
  assert.match(await refused("threads"), /no program is running/);
  assert.match(await refused("shaderlint/image", { expression: "1.0" }), /no program is running/);
  assert.match(await refused("shaderlint/reload"), /no program is running/);
  const stopped = client.waitForEvent("stopped");
  await client.launchRequest({ program: file("ball.glsl", BALL), size: [8, 6] });
  await client.configurationDoneRequest();
  await stopped;
  assert.match(await refused("shaderlint/nonsense"), /unknown request `shaderlint\/nonsense`/);
  assert.match(await refused("stackTrace", { threadId: "one" }), /wrong arguments/);
  assert.equal(await refused("pause", { threadId: 1 }), "");
  const ended = client.waitForEvent("terminated");
  await client.terminateRequest({});
  await ended;
  assert.match(await refused("next", { threadId: 1 }), /no program is running/);
  await client.disconnectRequest();
});

/** Sends bytes to a debugger; returns its exit code and everything that it prints. */
function sent(...parts) {
  const child = spawn(process.env.SHADERLINT, ["dap"]);
  let [output, error] = ["", ""];
  child.stdout.on("data", (data) => (output += data));
  child.stderr.on("data", (data) => (error += data));
  child.stdin.on("error", () => {});
  child.stdin.end(parts.join(""));
  return new Promise((resolve) => {
    child.on("close", (code) => resolve({ code, output, error }));
  });
}

const framed = (text) => `Content-Length: ${Buffer.byteLength(text)}\r\n\r\n${text}`;
const request = (command, fields = {}) => framed(JSON.stringify({ seq: 1, type: "request", command, ...fields }));

test("invalid messages end the session with an error", async () => {
  const end = await sent(request("initialize"));
  assert.equal(end.code, 0);
  assert.match(end.output, /"initialized"/);
  const disconnected = await sent(request("disconnect"), request("threads"));
  assert.equal(disconnected.code, 0);
  assert.doesNotMatch(disconnected.output, /"threads"/);
  const broken = await sent(framed("{oops"));
  assert.notEqual(broken.code, 0);
  assert.match(broken.error, /not JSON/);
  assert.doesNotMatch(broken.error, /panicked/);
  for (const body of ["[]", "1", "null", "{}", '{"type":"response"}', '{"type":"request"}', '{"type":"request","seq":-1}']) {
    const { code, error } = await sent(framed(body), request("initialize"));
    assert.equal(code, 0, `${body}: ${error}`);
  }
});
