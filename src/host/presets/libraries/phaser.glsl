// Phaser
//
// Phaser 4 compiles shaders unchanged, as GLSL ES 1.00 on a WebGL 1 context. No float precision is
// added: a shader has its own `precision mediump float;`. It declares uMainSampler, outTexCoord,
// inPosition, inTexCoord, uProjectionMatrix and uResolution itself.
//
// `#pragma phaserTemplate(NAME)` lines are insertion points for shader additions; unused ones are
// removed. Phaser itself fills shaderName (a macro SHADER_NAME), features (macros FEATURE_*),
// extensions, vertexDefine, vertexHeader, vertexProcess, outVariables, fragmentDefine,
// fragmentHeader, texIdProcess and fragmentProcess. A filter (BaseFilterShader) always gets the
// function boundedSampler() at `#pragma phaserTemplate(fragmentHeader)`. An addition for
// fragmentProcess can use the locals `fragColor` and `texCoord`.
//
// Not declared here: names that additions provide, such as getTexture(), getTexRes(), applyTint(),
// applyLighting(), getNormalFromMap(), clampTexCoordWithinFrame() and the varyings outTint,
// outTintEffect, outTexDatum, outFrame.
//
// source: phaser 4.2.1, src/renderer/webgl/ShaderProgramFactory.js, src/renderer/webgl/renderNodes/filters/BaseFilterShader.js, src/renderer/webgl/shaders/src
// package: phaser
// word: boundedSampler clampTexCoordWithinFrame outTintEffect outTexDatum
// global: Phaser
// version: 100
// names: some
// entry: main
#define SHADER_NAME phaser
#ifdef FRAGMENT_SHADER
mediump vec4 boundedSampler(sampler2D sampler, mediump vec2 uv);
#endif
