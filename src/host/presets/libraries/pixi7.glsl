// PixiJS 7
//
// Program of PixiJS 5 to 7 compiles filters and meshes unchanged, as GLSL ES 1.00 if the shader has
// no `#version`. It adds only SHADER_NAME and, if the shader does not start with `precision`, a
// float precision: highp for vertex shaders, mediump for fragment shaders. If the vertex shader
// starts with `#version`, neither is added.
//
// Nothing else is declared. A filter declares `varying vec2 vTextureCoord`, `uniform sampler2D
// uSampler`, `uniform vec4 inputSize`, `inputPixel`, `inputClamp`, `outputFrame`, `filterArea`,
// `filterClamp` itself, and a mesh `aVertexPosition`, `aTextureCoord`, `projectionMatrix` and
// `translationMatrix`. %forloop% and similar are placeholders in the package's own shaders for
// batches (%count%, %forloop%) and blurs (%size%, %blur%).
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
