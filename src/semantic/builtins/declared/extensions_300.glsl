// What extensions of WebGL2 add to shaders of both stages, with the values of Chromium on SwiftShader.
in highp uint gl_ViewID_OVR;
const mediump int gl_MaxSamples = 4;
uniform lowp int gl_NumSamples;
const mediump int gl_MaxClipDistances = 8;
const mediump int gl_MaxCullDistances = 8;
const mediump int gl_MaxCombinedClipAndCullDistances = 16;
