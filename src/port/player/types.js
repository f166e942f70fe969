// The shapes of what the converter hands to the player.

/**
 * A text that is compiled.
 * @typedef {object} SourceText
 * @property {string} name what the user calls it: "Common", "Image"
 * @property {string} text
 * @property {boolean} hidden whether the player brought it
 */

/**
 * What a channel reads.
 * @typedef {object} InputData
 * @property {string} [uniform] the sampler that reads it; iChannel0 and so on without it
 * @property {string} [sampler] the type of that sampler, where no file can feed it: isampler2D
 * @property {string} kind texture, buffer, cubebuffer, cubemap, volume, keyboard, video, webcam,
 *   music or mic
 * @property {number} [buffer] index of the pass that a buffer is drawn by
 * @property {string} filter nearest, linear or mipmap
 * @property {string} wrap clamp or repeat
 * @property {boolean} vflip
 * @property {string[]} [urls] data: or blob: addresses of the file, six for a cube map
 * @property {string} [name] name of the file
 * @property {boolean} [gray] whether only the red component is kept
 * @property {string} [form] how sound lies in its texture: spectrum, wave, history or sum; both
 *   without it
 * @property {string} [standIn] which of the project's `media` is drawn where no file is at hand
 * @property {string} [title] what the site calls the file that it stands for
 * @property {number[]} [size] width, height and depth of what is drawn
 */

/**
 * What draws stand-ins for files.
 * @typedef {object} MediaData
 * @property {string} name
 * @property {string} text a whole fragment shader
 */

/**
 * A pass.
 * @typedef {object} PassData
 * @property {string} kind image, buffer, cubemap or sound
 * @property {string} name
 * @property {number[]} files indexes of the texts that are compiled, in order
 * @property {(InputData | null)[]} inputs one for each channel
 * @property {string} [vertex] the vertex shader, where the pass has its own
 * @property {OwnUniform[]} [uniforms] what is set in a pass that brings its own uniforms
 * @property {[SizeTerm, SizeTerm]} [size] what it draws into, where that has not the canvas's size
 * @property {string} [into] what it draws into, where other passes do, too
 * @property {boolean} [float] whether it draws into floats
 * @property {boolean} [quad] whether its vertex shader wants the corners of the picture
 * @property {string} [fragment] the fragment shader, where the texts are a vertex shader that is run for
 *   numbered vertices
 */

/**
 * A number, a name (`$WIDTH`, `$HEIGHT` or a control), or a function and what it is given.
 * @typedef {number | string | [string, any[]]} SizeTerm
 */

/**
 * A uniform of a shader that brings its own.
 * @typedef {object} OwnUniform
 * @property {string} name
 * @property {string} type as GLSL writes it
 * @property {string} source what it is given: a key of SOURCES, identity, control or textureSize
 * @property {string} [of] the sampler whose texture it tells of
 */

/**
 * A uniform that the user sets.
 * @typedef {object} ControlData
 * @property {string} name of the uniform
 * @property {string} label
 * @property {string} kind float, int, bool, color, point, vector, choice or event
 * @property {number[]} value as many numbers as it takes
 * @property {number[]} [min]
 * @property {number[]} [max]
 * @property {{label: string, value: number}[]} [choices]
 */

/**
 * A number in the code that its author left to be tuned.
 * @typedef {object} TunableData
 * @property {string} name
 * @property {string} label
 * @property {number} value
 * @property {number} min
 * @property {number} max
 * @property {boolean} integer
 * @property {number} file index of the text
 * @property {number} start offset of the number in it
 * @property {number} end
 */

/**
 * A place in a text, and what is said of it.
 * @typedef {object} LabelData
 * @property {number} file index of the text
 * @property {number} start offset in it
 * @property {number} end
 * @property {string} text
 */

/**
 * What the checker says of code that does not compile.
 * @typedef {object} FindingData
 * @property {string} rule
 * @property {string} message
 * @property {LabelData[]} labels the first is where it is
 * @property {string[]} notes
 */

/**
 * A shader with all its passes.
 * @typedef {object} ProjectData
 * @property {string} title
 * @property {string} author
 * @property {string} link
 * @property {string} license
 * @property {string} description
 * @property {string} vertex
 * @property {SourceText[]} files
 * @property {PassData[]} passes in the order of the export
 * @property {TunableData[]} tunables
 * @property {ControlData[]} controls
 * @property {MediaData[]} [media] those that some channel needs
 * @property {FindingData[]} [findings] errors, where there are any
 */
