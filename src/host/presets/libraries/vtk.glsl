// vtk.js
//
// The shaders of vtk.js are templates: comment lines such as //VTK::System::Dec and
// //VTK::Color::Impl are replaced by generated code. //VTK::System::Dec, the first line, becomes
// `#version 300 es`, macros and the precisions. `varying` is replaced by `out` in the vertex shader
// and `in` in the fragment shader. gl_FragData[N] is replaced by the output fragOutputN, declared
// at //VTK::Output::Dec (the array below stands for these outputs). All this applies only to
// shaders with these placeholders.
//
// Not declared here: the names that the other placeholders provide, for example vertexVCVSOutput,
// normalVCVSOutput, tcoordVCVSOutput, MCPCMatrix, MCVCMatrix, ambientColor, diffuseColor, opacity.
// User-defined replacements (ShaderReplacements) may use these names.
//
// source: vtk.js 37.3.1, Sources/Rendering/OpenGL/ShaderCache/index.js, Sources/Rendering/OpenGL/glsl
// package: vtk.js @kitware/vtk.js
// word: vertexVCVSOutput normalVCVSOutput tcoordVCVSOutput vertexColorVSOutput fragOutput0 MCPCMatrix MCVCMatrix
// hole: //VTK::...::Dec //VTK::...::Impl
// version: 300 es
// names: some
// entry: main
precision highp float;
precision highp int;
#define attribute in
#define textureCube texture
#define texture2D texture
#define textureCubeLod textureLod
#define texture2DLod textureLod
#ifdef VERTEX_SHADER
#define varying out
#endif
#ifdef FRAGMENT_SHADER
#define varying in
layout(location = 0) out vec4 fragOutput[4];
#define gl_FragData fragOutput
#define fragOutput0 fragOutput[0]
#define fragOutput1 fragOutput[1]
#define fragOutput2 fragOutput[2]
#define fragOutput3 fragOutput[3]
#endif
