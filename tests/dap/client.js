// A session of the debugger, driven by the client of `@vscode/debugadapter-testsupport`.
import { DebugClient } from "@vscode/debugadapter-testsupport";
import fs from "node:fs";
import os from "node:os";
import path from "node:path";
import { after } from "node:test";

/** The lines that tests name are counted from 1. */
export const BALL = `struct Hit { float way; int steps; };

float field(vec3 p) {
    float d = length(p) - 1.0;
    return d;
}

void mainImage(out vec4 fragColor, in vec2 fragCoord) {
    vec2 uv = (2.0 * fragCoord - iResolution.xy) / iResolution.y;
    vec3 ray = vec3(0.0, 0.0, 1.0);
    Hit hit = Hit(0.0, 0);
    for (int i = 0; i < 4; i++) {
        float d = field(ray * hit.way - vec3(0.0, 0.0, 3.0));
        hit.way += 0.5 * d;
        hit.steps++;
    }
    vec3 tint = vec3(0.8, 0.6, 0.4);
    mat2 turn = mat2(1.0, 2.0, 3.0, 4.0);
    float list[3] = float[3](1.0, 2.0, hit.way);
    fragColor = vec4(tint * 0.5, 1.0);
}
`;

const folder = fs.mkdtempSync(path.join(os.tmpdir(), "shaderlint-dap-"));
const clients = [];
after(async () => {
  await Promise.all(clients.map((client) => client.stop()));
  fs.rmSync(folder, { recursive: true });
});

/** Writes a file; returns its path. */
export function file(name, text) {
  const full = path.join(folder, name);
  fs.mkdirSync(path.dirname(full), { recursive: true });
  fs.writeFileSync(full, text);
  return full;
}

/** A client of a new debugger. */
export async function connected() {
  const client = new DebugClient(process.env.SHADERLINT, "dap", "shaderlint");
  client.defaultTimeout = 120_000;
  clients.push(client);
  await client.start();
  return client;
}

/**
 * A session at its first stop.
 * @param {object} launch the arguments of `launch`
 * @param {{ breakpoints?: object[], filters?: string[], start?: object }} given what is set before the start,
 *     and the arguments of `initialize`
 */
export async function launched(launch, { breakpoints = [], filters = [], start = {} } = {}) {
  const client = await connected();
  const session = new Session(client, launch.program);
  session.capabilities = (await client.initializeRequest({ adapterID: "shaderlint", ...start })).body;
  await client.launchRequest(launch);
  if (breakpoints.length > 0) session.breakpoints = await session.setBreakpoints(breakpoints);
  await client.setExceptionBreakpointsRequest({ filters });
  session.first = await session.move("configurationDone");
  return session;
}

export class Session {
  constructor(client, program) {
    this.client = client;
    this.program = program;
    this.output = "";
    client.on("output", ({ body }) => {
      this.output += body.output;
    });
    this.progress = [];
    for (const kind of ["progressStart", "progressEnd"]) {
      client.on(kind, ({ body }) => this.progress.push([kind, body.progressId]));
    }
  }

  /** The body of the answer to a request. */
  async ask(command, args = {}) {
    return (await this.client.customRequest(command, args)).body;
  }

  /** The message of a request that fails. */
  refused(command, args = {}) {
    return this.ask(command, args).then(
      () => "",
      (error) => error.message,
    );
  }

  async setBreakpoints(breakpoints, source = { path: this.program }) {
    return (await this.ask("setBreakpoints", { source, breakpoints })).breakpoints;
  }

  /** A request that goes to another moment; returns the body of the event. */
  async move(command, args = {}) {
    const stopped = this.client.waitForEvent("stopped");
    await this.ask(command, args);
    return (await stopped).body;
  }

  /** The functions that run, innermost first, with the lines: `field:4 mainImage:13`. */
  async stack(threadId = 0) {
    const { stackFrames } = await this.ask("stackTrace", { threadId });
    return stackFrames.map(({ name, line }) => `${name}:${line}`).join(" ");
  }

  /** Moves; returns the new stack. */
  async to(command, args = {}) {
    await this.move(command, args);
    return this.stack();
  }

  async frames(threadId = 0) {
    return (await this.ask("stackTrace", { threadId })).stackFrames;
  }

  /** The value of an expression in the innermost frame, or in another. */
  async value(expression, frameId = undefined) {
    return (await this.ask("evaluate", { expression, frameId })).result;
  }

  /** The variables of a scope by name. */
  async variables(scope = "Locals", frameId = undefined) {
    const { scopes } = await this.ask("scopes", { frameId });
    const { variablesReference } = scopes.find(({ name }) => name === scope);
    return this.parts(variablesReference);
  }

  async parts(variablesReference, more = {}) {
    const { variables } = await this.ask("variables", { variablesReference, ...more });
    return Object.fromEntries(variables.map((variable) => [variable.name, variable]));
  }
}
