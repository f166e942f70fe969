// Phaser
//
// Phaser 4 compiles shaders as they are written, as GLSL ES 1.00 on a WebGL 1 context, without any
// text before them. Lines `#pragma phaserTemplate(NAME)` are places for shader additions; what is
// left of them is removed. The names that Phaser fills itself are shaderName (a macro SHADER_NAME),
// features (macros FEATURE_*), extensions, vertexDefine, vertexHeader, vertexProcess, outVariables,
// fragmentDefine, fragmentHeader, texIdProcess and fragmentProcess. A filter (BaseFilterShader)
// always gets the function boundedSampler() at `#pragma phaserTemplate(fragmentHeader)`. The
// precision of float is not added: a text has `precision mediump float;` itself. A text declares
// uMainSampler, outTexCoord, inPosition, inTexCoord, uProjectionMatrix and uResolution itself. Not
// declared here: what additions bring, such as getTexture(), getTexRes(), applyTint(),
// applyLighting(), getNormalFromMap(), clampTexCoordWithinFrame() and the varyings outTint,
// outTintEffect, outTexDatum, outFrame. The text of an addition for fragmentProcess sees the locals
// `fragColor` and `texCoord`.
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
