/** Options of a check. */
export interface InputOptions {
  /** Name of the file; its extension selects the kind of file. Default: `shader.glsl`. */
  name?: string;
  /** Other files by path, for includes. */
  files?: Record<string, string>;
  /** The site or library that completes the shader, as `--host`. */
  host?: string;
  /** The dialect, if it cannot be detected. */
  dialect?: "auto" | "shadertoy" | "webgl2" | "webgl1";
  /** Rules and groups to enable. */
  select?: string[];
  /** Rules and groups to disable. */
  ignore?: string[];
  /** The only rules, groups and compile errors to report. */
  only?: string[];
  /** Static analysis only, as `runSamples: 0`. */
  noRun?: boolean;
  /** Number of pixels to sample per shader; 0 for static analysis only. */
  runSamples?: number;
  /** Whether formats for people show infos too. */
  info?: boolean;
}

/** What a check prints, as after `--format`. */
export type OutputFormat =
  | "human" | "short" | "agent" | "json" | "jsonl" | "sarif" | "github" | "gitlab" | "junit" | "checkstyle";

/** A position: `line` and `column` start at 1, in characters; `utf16` counts UTF-16 units, `byte` bytes from 0. */
export interface Position {
  line: number;
  column: number;
  utf16: number;
  byte: number;
}

/** A finding, as in the JSON of the command line. */
export interface Diagnostic {
  file: string;
  rule: string;
  severity: "error" | "warning" | "info";
  message: string;
  start: Position;
  end: Position;
  labels: { start: Position; end: Position; message: string }[];
  notes: string[];
  fix?: {
    title: string;
    applicability: "safe" | "unsafe" | "display";
    edits: { start: Position; end: Position; text: string }[];
  };
  page: string;
  [field: string]: unknown;
}

/** What `shaderlint --format json` prints. */
export interface Report {
  schema: number;
  diagnostics: Diagnostic[];
  readings: { file: string; hosts: string[]; read_as: string }[];
  summary: Record<string, unknown>;
}

/** A part of a text that was not formatted. */
export interface Unformatted {
  line: number;
  column: number;
  message: string;
}

/** What is ported or drawn. */
export interface ShaderOptions {
  /** Name of the file, or of the project. Default: `shader.glsl`. */
  name?: string;
  /** The passes of a ShaderToy project by file name, such as `buffer_a.glsl`, instead of the text. */
  passes?: Record<string, string>;
  /** Other files by path, for includes. */
  files?: Record<string, string>;
  /** The site or library that the shader is written for; detected by default. */
  host?: string;
  /** What channels read, as after `--channel`: `image.0=buffer_a`. */
  channels?: string[];
}

/** What a shader is ported to, as after `shaderport`. */
export interface PortOptions extends ShaderOptions {
  /** Path of the output; its extension selects the target. Default: `shader.html`. */
  output?: string;
  /** The output format, or the host that the shader is written for. */
  target?: string;
  /** How plain shaders get a `main` function. */
  main?: "wrap" | "rewrite";
  /** Which values in the code get sliders. */
  sliders?: "marked" | "auto" | "none";
  /** Whether the script and the style of a page are files beside it. */
  split?: boolean;
  /** Address of the playground whose debugger a page offers. */
  playground?: string;
  /** Whether the resource interface of each shader is written to a JSON file. */
  interface?: boolean;
  /** Which row of the image shaders in other languages draw first. */
  firstRow?: "top" | "bottom";
}

/** A file that a shader was ported to; `text` is null for binary files. */
export interface PortedFile {
  path: string;
  text: string | null;
}

/** What is drawn of a shader, as after `shaderlint run`. */
export interface RunOptions extends ShaderOptions {
  /** Width and height in pixels; default: 320 and 180. */
  size?: [number, number];
  /** Time in seconds. */
  time?: number;
  /** Frame number. */
  frame?: number;
  /** Position in pixels from the lower left corner. */
  mouse?: { x: number; y: number; down?: boolean };
  /** The pass to show. */
  pass?: string;
  /** Values of uniforms by name. */
  uniforms?: Record<string, unknown>;
  /** A heat map instead of the image. */
  heatmap?: "steps" | "cost" | "divergence" | "nan" | "slope";
  /** A variable on a line instead of the image. */
  show?: { name: string; line: number };
  /** Whether loops, functions and invalid numbers are reported. */
  report?: boolean;
  /** The pixel to trace, from the lower left corner. */
  pixel?: [number, number];
  /** The number of frames of a contact sheet, from `time` on. */
  sheet?: number;
  /** Seconds between these frames; default: 1. */
  every?: number;
  /** Another version of the shader, to compare with. */
  compare?: ShaderOptions & { name: string; text?: string };
}

/** The arguments of `launch` for `Shaderlint.debug`. */
export interface DebugLaunch extends Omit<ShaderOptions, "name"> {
  /** Name of the file, or of the project. */
  program: string;
  /** Contents of the file. */
  text?: string;
  /** Width and height in pixels; default: 320 and 180. */
  size?: [number, number];
  /** The pixel, from the lower left corner; default: the centre. */
  pixel?: [number, number];
  time?: number;
  frame?: number;
  mouse?: { x: number; y: number; down?: boolean };
  pass?: string;
  uniforms?: Record<string, unknown>;
  /** Whether to stop before the first statement; default: true. */
  stopOnEntry?: boolean;
}

/** What `shaderlint run` prints, and the image: three bytes per pixel in base64, top row first. */
export interface RunResult {
  facts: Record<string, unknown>;
  text: string;
  image: { size: [number, number]; rgb: string } | null;
}

export type Source = URL | string | Response | BufferSource | WebAssembly.Module;

/** Compiles a module; by default the one of this package, with SIMD where the machine has it. */
export function compile(source?: Source): Promise<WebAssembly.Module>;

/** The address of the module that ports shaders. */
export function portAddress(): URL;

/** An instance of the module. Methods throw an `Error` with a message for the user. */
export class Shaderlint {
  constructor(module: WebAssembly.Module);
  static load(source?: Source): Promise<Shaderlint>;
  check(text: string, options?: InputOptions): Report;
  report(
    text: string,
    options?: InputOptions & { format?: OutputFormat },
  ): { output: string; errors: number; warnings: number; infos: number };
  fix(text: string, options?: InputOptions & { unsafe?: boolean }): { text: string; fixed: number };
  format(
    text: string,
    options?: { name?: string; indent?: number; lineLength?: number },
  ): { text: string; unformatted: Unformatted[] };
  explain(name: string): string;
  rules(): { schema: number; rules: Record<string, unknown>[] };
  port(
    text: string,
    options?: PortOptions,
  ): { files: PortedFile[]; errors: number; remarks: string[] };
  run(text: string, options?: RunOptions): RunResult;
  debug(message: object): object[];
  debugIdle(): object[];
  playerData(
    text: string,
    options?: ShaderOptions,
  ): { project: string; errors: number; operations: number; isMore: boolean };
  playerPage(): string;
  lsp(message: object): object[];
  runChanged(): object[];
  request(method: string, params?: object): unknown;
}
