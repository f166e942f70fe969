// The passes of a ShaderToy project as files of a folder, named as the command line names them.

const code = (signature, body) => `${signature} {\n    ${body}\n}\n`;
const DRAWS = code('void mainImage(out vec4 fragColor, in vec2 fragCoord)', 'fragColor = vec4(fragCoord / iResolution.xy, 0.0, 1.0);');

/** All passes in the order of their tabs, with the text of a new one. */
export const PASSES = [
  { file: 'common.glsl', title: 'Common', start: '// Code that all passes can use.\n' },
  { file: 'buffer_a.glsl', title: 'Buffer A', start: DRAWS },
  { file: 'buffer_b.glsl', title: 'Buffer B', start: DRAWS },
  { file: 'buffer_c.glsl', title: 'Buffer C', start: DRAWS },
  { file: 'buffer_d.glsl', title: 'Buffer D', start: DRAWS },
  {
    file: 'cubemap.glsl',
    title: 'Cube A',
    start: code('void mainCubemap(out vec4 fragColor, in vec2 fragCoord, in vec3 rayOri, in vec3 rayDir)', 'fragColor = vec4(0.5 + 0.5 * rayDir, 1.0);'),
  },
  {
    file: 'sound.glsl',
    title: 'Sound',
    start: code('vec2 mainSound(in int samp, float time)', 'return vec2(sin(6.2831 * 440.0 * time) * exp(-3.0 * time));'),
  },
  { file: 'image.glsl', title: 'Image', start: DRAWS },
];

/** The pass that every project has. */
export const IMAGE = 'image.glsl';

/** What the channels of a folder read. */
export const CHANNELS = 'channels.toml';

const known = new Map(PASSES.map((pass) => [pass.file, pass]));

/** The name that a tab shows for a file. @param {string} file */
export const titleOf = (file) => known.get(file)?.title ?? file;

/** The text of a new pass. @param {string} file */
export const startOf = (file) => known.get(file)?.start ?? '';

/** The number of a pass among the tabs. @param {string} file */
export const positionOf = (file) => PASSES.findIndex((pass) => pass.file === file);

/** Whether a file may be a pass, so that others can be added to it. @param {string} file */
export const mayBePass = (file) => file.endsWith('.glsl');

/**
 * What a shader lies in: its only file, or the passes of a folder.
 * @typedef {Record<string, string>} Files texts by name
 */

/** Whether files are a folder of passes. @param {Files} files */
export const isFolder = (files) => Object.keys(files).length > 1;

/** A single text as a file whose name says what it is. @param {string} text @returns {Files} */
export const single = (text) => ({ [/^\s*[{[]/.test(text) ? 'shader.json' : 'shader.glsl']: text });
