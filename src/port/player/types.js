// The types of the data for the player.

/**
 * A text that is compiled.
 * @typedef {object} SourceText
 * @property {string} name shown to the user: "Common", "Image"
 * @property {string} text
 * @property {boolean} hidden whether it belongs to the player
 */

/**
 * The input of a channel.
 * @typedef {object} InputData
 * @property {string} [uniform] the sampler that reads it; default iChannel0 and so on
 * @property {string} [sampler] the type of that sampler, if it cannot read a file: isampler2D
 * @property {string} kind texture, buffer, cubebuffer, cubemap, volume, keyboard, video, webcam,
 *   music or mic
 * @property {number} [buffer] index of the pass that draws the buffer
 * @property {string} filter nearest, linear or mipmap
 * @property {string} wrap clamp or repeat
 * @property {boolean} vflip
 * @property {string[]} [urls] data: or blob: URLs of the file, six for a cube map
 * @property {string} [name] name of the file
 * @property {boolean} [gray] whether only the red component is kept
 * @property {string} [form] layout of sound in its texture: spectrum, wave, history or sum;
 *   default is spectrum and wave
 * @property {string} [standIn] the project's `media` that is drawn if there is no file
 * @property {string} [title] the title on ShaderToy of the file that it replaces
 * @property {number[]} [size] width, height and depth of the stand-in
 */

/**
 * A generator of stand-ins.
 * @typedef {object} MediaData
 * @property {string} name
 * @property {string} text a complete fragment shader
 */

/**
 * A pass.
 * @typedef {object} PassData
 * @property {string} kind image, buffer, cubemap or sound
 * @property {string} name
 * @property {number[]} files indexes of the compiled texts, in order
 * @property {(InputData | null)[]} inputs one for each channel
 * @property {string} [vertex] the vertex shader, where the pass has its own
 * @property {OwnUniform[]} [uniforms] values for a pass that declares its own uniforms
 * @property {[SizeTerm, SizeTerm]} [size] size of the target, if it differs from the canvas
 * @property {string} [into] id of a target that several passes share
 * @property {boolean} [float] whether the target has float components
 * @property {boolean} [quad] whether its vertex shader requires the corners of the image
 * @property {string} [fragment] the fragment shader, if the texts are a vertex shader for numbered
 *   vertices
 */

/**
 * A number, a name (`$WIDTH`, `$HEIGHT` or a control), or a function with its arguments.
 * @typedef {number | string | [string, any[]]} SizeTerm
 */

/**
 * A uniform of a shader that declares its own.
 * @typedef {object} OwnUniform
 * @property {string} name
 * @property {string} type the GLSL type
 * @property {string} source of its value: a key of SOURCES, identity, control or textureSize
 * @property {string} [of] for textureSize: the sampler of the texture
 */

/**
 * A uniform set by the user.
 * @typedef {object} ControlData
 * @property {string} name of the uniform
 * @property {string} label shown as its name
 * @property {string} [about] a description
 * @property {string} kind float, int, bool, color, point, vector, choice or event
 * @property {number[]} value one number per component
 * @property {number[]} [min]
 * @property {number[]} [max]
 * @property {{label: string, value: number}[]} [choices]
 */

/**
 * A value in the code that its author made tunable.
 * @typedef {object} TunableData
 * @property {string} name
 * @property {string} label
 * @property {string} kind float, int, bool, vector or color
 * @property {string} scalar the type of its literals: float, int, uint or bool
 * @property {number[]} value one number per component
 * @property {number[]} min
 * @property {number[]} max
 * @property {number} file index of the text
 * @property {number} start offset of the first literal in it
 * @property {number} end
 */

/**
 * A labelled span in a text.
 * @typedef {object} LabelData
 * @property {number} file index of the text
 * @property {number} start offset in it
 * @property {number} end
 * @property {string} text
 */

/**
 * A diagnostic for code that does not compile.
 * @typedef {object} FindingData
 * @property {string} rule
 * @property {string} message
 * @property {LabelData[]} labels the primary label first
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
 * @property {MediaData[]} [media] the generators that channels need
 * @property {FindingData[]} [findings] errors, if any
 * @property {string[]} [keys] names of the keys that it reads
 */
