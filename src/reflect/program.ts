/** A shader's text; what the shader declares is part of its type. */
export type ShaderText<Shader extends ShaderTypes = ShaderTypes> = string & { readonly "~shader"?: Shader };

/** What a shader declares. */
export interface ShaderTypes {
  stage: "vertex" | "fragment" | "none";
  version: 100 | 300;
  uniforms: object;
  blocks: object;
  attributes: object;
  outputs: object;
  defines: object;
  /** What both stages must declare alike. */
  shared: { uniforms: object; blocks: object; varyings: object };
}

type Of<Text> = Text extends { readonly "~shader"?: infer Shader } ? NonNullable<Shader> & ShaderTypes : never;
type Differing<V, F> = { [Name in keyof V & keyof F]: V[Name] extends F[Name] ? never : Name }[keyof V & keyof F] & string;
type Missing<V, F> = Exclude<keyof F, keyof V> & string;

type Mistakes<V extends ShaderTypes["shared"], F extends ShaderTypes["shared"]> =
  | `the vertex shader has no output ${Missing<V["varyings"], F["varyings"]>}`
  | `the stages declare the varying ${Differing<V["varyings"], F["varyings"]>} differently`
  | `the stages declare the uniform ${Differing<V["uniforms"], F["uniforms"]>} differently`
  | `the stages declare the block ${Differing<V["blocks"], F["blocks"]>} differently`;

/** Why two stages cannot be linked; `never` if they can, or if texts that they include are not known. */
export type LinkErrors<Vertex, Fragment> =
  | (Of<Vertex>["stage"] extends "fragment" ? "the first shader is no vertex shader" : never)
  | (Of<Fragment>["stage"] extends "vertex" ? "the second shader is no fragment shader" : never)
  | ([Of<Vertex>["version"] & Of<Fragment>["version"]] extends [never] ? "the shaders have different versions of GLSL" : never)
  | ([Of<Vertex>["stage"], Of<Fragment>["stage"]] extends ["vertex", "fragment"]
      ? Mistakes<Of<Vertex>["shared"], Of<Fragment>["shared"]>
      : never);

/** A program of two stages. The type is an error if the browser would not link them. */
export type Program<
  Vertex extends ShaderText,
  Fragment extends ShaderText & { readonly [Message in LinkErrors<Vertex, Fragment>]: never },
> = WebGLProgram & { readonly "~program"?: readonly [Vertex, Fragment] };

type Both<P, Kind extends "uniforms" | "blocks" | "attributes"> = P extends { readonly "~program"?: readonly [infer V, infer F] }
  ? Of<V>[Kind] & Of<F>[Kind]
  : never;
/** The values of the uniforms of a program. */
export type Uniforms<P> = Both<P, "uniforms">;
/** The values of the uniform blocks of a program. */
export type Blocks<P> = Both<P, "blocks">;
/** The attributes of a program. */
export type Attributes<P> = Both<P, "attributes">;

/** Compiles and links a program. Throws the browser's message if it cannot. */
export function createProgram<
  Vertex extends ShaderText,
  Fragment extends ShaderText & { readonly [Message in LinkErrors<Vertex, Fragment>]: never },
>(gl: WebGL2RenderingContext, vertex: Vertex, fragment: Fragment): Program<Vertex, Fragment> {
  const program = gl.createProgram()!;
  const stages: [number, string][] = [[gl.VERTEX_SHADER, vertex], [gl.FRAGMENT_SHADER, fragment]];
  for (const [stage, text] of stages) {
    const shader = gl.createShader(stage)!;
    gl.shaderSource(shader, text);
    gl.compileShader(shader);
    if (!gl.getShaderParameter(shader, gl.COMPILE_STATUS)) throw new Error(gl.getShaderInfoLog(shader) ?? "not compiled");
    gl.attachShader(program, shader);
    gl.deleteShader(shader);
  }
  gl.linkProgram(program);
  if (!gl.getProgramParameter(program, gl.LINK_STATUS)) throw new Error(gl.getProgramInfoLog(program) ?? "not linked");
  return program as Program<Vertex, Fragment>;
}

type Numbers = ArrayLike<number> & Iterable<number>;

/** Values by the names that WebGL has for them, such as `lights[0].color`. */
function* flat(name: string, value: unknown): Generator<[string, Numbers]> {
  const items = (Array.isArray(value) ? value : [value]) as unknown[];
  const isStruct = typeof items[0] === "object" && !Array.isArray(items[0]) && !ArrayBuffer.isView(items[0]);
  if (isStruct) {
    for (const [index, item] of items.entries())
      for (const [member, inner] of Object.entries(item as object))
        yield* flat(`${name}${items === value ? `[${index}]` : ""}.${member}`, inner);
  } else {
    const numbers = (item: unknown) => (typeof item === "object" ? [...(item as Iterable<number>)] : [item]);
    yield [name, (ArrayBuffer.isView(value) ? value : items.flatMap(numbers).map(Number)) as Numbers];
  }
}

/** By type in WebGL: the end of the name of the function that sets it. */
const SETTERS: Record<number, string> = {
  0x1406: "1fv", 0x8b50: "2fv", 0x8b51: "3fv", 0x8b52: "4fv", 0x1405: "1uiv", 0x8dc6: "2uiv", 0x8dc7: "3uiv", 0x8dc8: "4uiv",
  0x8b53: "2iv", 0x8b54: "3iv", 0x8b55: "4iv", 0x8b57: "2iv", 0x8b58: "3iv", 0x8b59: "4iv",
  0x8b5a: "Matrix2fv", 0x8b5b: "Matrix3fv", 0x8b5c: "Matrix4fv", 0x8b65: "Matrix2x3fv", 0x8b66: "Matrix2x4fv",
  0x8b67: "Matrix3x2fv", 0x8b68: "Matrix3x4fv", 0x8b69: "Matrix4x2fv", 0x8b6a: "Matrix4x3fv",
};
const found = new WeakMap<WebGLProgram, Map<string, (value: Numbers) => void>>();

function setters(gl: WebGL2RenderingContext, program: WebGLProgram) {
  let all = found.get(program);
  if (all) return all;
  found.set(program, (all = new Map()));
  for (let index = 0; index < gl.getProgramParameter(program, gl.ACTIVE_UNIFORMS); index++) {
    const { name, type } = gl.getActiveUniform(program, index)!;
    const place = gl.getUniformLocation(program, name);
    const call = `uniform${SETTERS[type] ?? "1iv"}`;
    const gives = (gl as unknown as Record<string, (...values: unknown[]) => void>)[call]!.bind(gl);
    const set = (value: Numbers) => (call.includes("M") ? gives(place, false, value) : gives(place, value));
    all.set(name.replace(/\[0\]$/, ""), set);
  }
  return all;
}

/** Sets uniforms of the current program. Those that the shaders do not use are skipped. */
export function setUniforms<P extends WebGLProgram>(gl: WebGL2RenderingContext, program: P, values: Partial<Uniforms<P>>): void {
  const all = setters(gl, program);
  for (const [name, value] of Object.entries(values))
    for (const [part, numbers] of flat(name, value)) all.get(part)?.(numbers);
}

/** The bytes of a uniform block with these values, for `gl.bufferData`. */
export function writeBlock<P extends WebGLProgram, Name extends keyof Blocks<P> & string>(
  gl: WebGL2RenderingContext, program: P, name: Name, values: Blocks<P>[Name],
): ArrayBuffer {
  const block = gl.getUniformBlockIndex(program, name);
  const uniforms: Uint32Array = gl.getActiveUniformBlockParameter(program, block, gl.UNIFORM_BLOCK_ACTIVE_UNIFORM_INDICES);
  const bytes = new DataView(new ArrayBuffer(gl.getActiveUniformBlockParameter(program, block, gl.UNIFORM_BLOCK_DATA_SIZE)));
  const given = new Map([...flat("", values)].map(([part, numbers]) => [part.slice(1), [...numbers]]));
  for (const uniform of uniforms) {
    const { name: full, type, size } = gl.getActiveUniform(program, uniform)!;
    const member = full.replace(/\[0\]$/, "");
    const numbers = given.get(member) ?? given.get(member.slice(member.indexOf(".") + 1));
    if (!numbers) continue;
    const [offset, stride, column, byRows] = [
      gl.UNIFORM_OFFSET, gl.UNIFORM_ARRAY_STRIDE, gl.UNIFORM_MATRIX_STRIDE, gl.UNIFORM_IS_ROW_MAJOR,
    ].map((what) => Number(gl.getActiveUniforms(program, [uniform], what)[0])) as [number, number, number, number];
    const setter = SETTERS[type] ?? "1iv";
    const [columns, rows] = (/Matrix(\d)(?:x(\d))?/.exec(setter)?.slice(1) ?? [1, setter[0]]).map(Number) as [number, number];
    const height = rows || columns;
    for (const [index, value] of numbers.slice(0, size * columns * height).entries()) {
      const [element, at] = [Math.floor(index / (columns * height)), index % (columns * height)];
      const [x, y] = [Math.floor(at / height), at % height];
      const place = offset + element * stride + (byRows ? y * column + x * 4 : x * column + y * 4);
      if (setter.endsWith("fv")) bytes.setFloat32(place, value, true);
      else bytes.setInt32(place, value, true);
    }
  }
  return bytes.buffer as ArrayBuffer;
}
