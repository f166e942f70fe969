// The module under test, and the program that it is compared with.

import { execFileSync } from "node:child_process";
import path from "node:path";
import { fileURLToPath, pathToFileURL } from "node:url";

export const ROOT = path.resolve(path.dirname(fileURLToPath(import.meta.url)), "../..");

const of = (name) => pathToFileURL(path.join(process.env.WASM, name));

export const { Shaderlint, compile } = await import(of("index.js"));
export const { startServer } = await import(of("server.js"));

/** The modules that were built, by their names in `src/wasm/build`. */
export const MODULES = Object.fromEntries(
  [
    ["simd", "shaderlint.wasm"],
    ["plain", "shaderlint-plain.wasm"],
    ["port", "shaderport.wasm"],
  ]
    .filter(([name]) => process.env.MODULES.split(" ").includes(name))
    .map(([name, file]) => [name, of(file)]),
);

/** What the program prints. */
export function native(args, options = {}) {
  try {
    return execFileSync(process.env.SHADERLINT, args, {
      cwd: ROOT,
      encoding: "utf8",
      maxBuffer: 1 << 30,
      ...options,
    });
  } catch (error) {
    // Findings give the exit code 1.
    if (error.status !== 1) throw error;
    return error.stdout;
  }
}
