// What only some projects need. Each of the files for it adds itself here, and is left out of the pages and
// modules of other projects.

/**
 * @type {{
 *   Buffer?: typeof Buffer, CubeBuffer?: typeof CubeBuffer, Keyboard?: typeof Keyboard,
 *   Sound?: typeof Sound, Devices?: typeof Devices, standIns?: typeof standInCache,
 *   setOwnUniforms?: typeof setOwnUniforms, setOwnSizes?: typeof setOwnSizes, ownSize?: typeof ownSize,
 *   numberVertices?: typeof numberVertices, drawVertices?: typeof drawVertices,
 *   plainTexture?: typeof plainTexture, samplerTarget?: typeof targetOf,
 *   setTunables?: typeof setTunables, moveNumbers?: typeof moveNumbers,
 * }}
 */
const parts = {};

/**
 * Opens the input of a channel, by its kind.
 * @type {Record<string, (gl: WebGL2RenderingContext, data: InputData, around: Surroundings) => Input>}
 */
const openers = {};

/**
 * What inputs may use.
 * @typedef {object} Surroundings
 * @property {Devices | null} devices
 * @property {ReturnType<typeof standInCache> | null} standIns
 */
