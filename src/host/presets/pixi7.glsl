// PixiJS 7
//
// Program of PixiJS 5 to 7 compiles filters and meshes as they are written, GLSL ES 1.00 without a
// `#version` in the text. It adds only SHADER_NAME and, where the text does not begin with
// `precision`, a precision for float: highp for vertex shaders, mediump for fragment shaders; a
// text whose vertex stage begins with `#version` gets neither. Nothing else is declared: a filter
// declares `varying vec2 vTextureCoord`, `uniform sampler2D uSampler`, `uniform vec4 inputSize`,
// `inputPixel`, `inputClamp`, `outputFrame`, `filterArea`, `filterClamp` itself, and a mesh
// `aVertexPosition`, `aTextureCoord`, `projectionMatrix` and `translationMatrix`. The name
// %forloop% and the like are places of the package's own texts for batches (%count%, %forloop%) and
// blurs (%size%, %blur%).
//
// source: @pixi/core 7.4.3, lib/shader/Program.mjs, lib/filters/defaultFilter.vert.mjs
// package: @pixi/core @pixi/mesh @pixi/app @pixi/sprite @pixi/filter-alpha @pixi/filter-blur @pixi/filter-color-matrix @pixi/filter-displacement @pixi/filter-fxaa @pixi/filter-noise @pixi/canvas-renderer
// version: any
// names: all
// entry: main
// hole: %...%
#define SHADER_NAME pixi-shader
#ifdef VERTEX_SHADER
precision highp float;
#endif
#ifdef FRAGMENT_SHADER
precision mediump float;
#endif
