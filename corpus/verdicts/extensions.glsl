//# The extensions of WebGL1
//: refused 3 missing-extension, 100 webgl1: derivatives with the directive
#extension GL_OES_standard_derivatives : enable
varying vec2 u;
void main() { gl_FragColor = vec4(fwidth(u) + dFdx(u) + dFdy(u), 0., 1.); }
//: refused 2 missing-extension, 100 webgl1: derivatives without the directive
varying vec2 u;
void main() { gl_FragColor = vec4(fwidth(u) + dFdx(u) + dFdy(u), 0., 1.); }
//: refused 1 unknown-extension, 100 webgl1: derivatives that are required
#extension GL_OES_standard_derivatives : require
varying vec2 u;
void main() { gl_FragColor = vec4(fwidth(u) + dFdx(u) + dFdy(u), 0., 1.); }
//: accepted, 100 webgl1 extended: derivatives with the directive
#extension GL_OES_standard_derivatives : enable
varying vec2 u;
void main() { gl_FragColor = vec4(fwidth(u) + dFdx(u) + dFdy(u), 0., 1.); }
//: refused 2 missing-extension, 100 webgl1 extended: derivatives without the directive
varying vec2 u;
void main() { gl_FragColor = vec4(fwidth(u) + dFdx(u) + dFdy(u), 0., 1.); }
//: accepted, 100 webgl1 extended: derivatives that are required
#extension GL_OES_standard_derivatives : require
varying vec2 u;
void main() { gl_FragColor = vec4(fwidth(u) + dFdx(u) + dFdy(u), 0., 1.); }
//: refused 3 needs-webgl2, 100 webgl2 extended: derivatives with the directive
#extension GL_OES_standard_derivatives : enable
varying vec2 u;
void main() { gl_FragColor = vec4(fwidth(u) + dFdx(u) + dFdy(u), 0., 1.); }
//: refused 2 needs-webgl2, 100 webgl2 extended: derivatives without the directive
varying vec2 u;
void main() { gl_FragColor = vec4(fwidth(u) + dFdx(u) + dFdy(u), 0., 1.); }
//: refused 1 unknown-extension, 100 webgl2 extended: derivatives that are required
#extension GL_OES_standard_derivatives : require
varying vec2 u;
void main() { gl_FragColor = vec4(fwidth(u) + dFdx(u) + dFdy(u), 0., 1.); }
//: accepted, 100 webgl1 extended: derivatives after `warn`
#extension GL_OES_standard_derivatives : warn
varying vec2 u;
void main() { gl_FragColor = vec4(fwidth(u) + dFdx(u) + dFdy(u), 0., 1.); }
//: refused 4 missing-extension, 100 webgl1 extended: derivatives that are turned off again
#extension GL_OES_standard_derivatives : enable
#extension GL_OES_standard_derivatives : disable
varying vec2 u;
void main() { gl_FragColor = vec4(fwidth(u) + dFdx(u) + dFdy(u), 0., 1.); }
//: accepted, 100 webgl1 extended: derivatives after `all : warn`
#extension all : warn
varying vec2 u;
void main() { gl_FragColor = vec4(fwidth(u) + dFdx(u) + dFdy(u), 0., 1.); }
//: refused 2 int-float-mix, 100 webgl1 extended: a derivative of an integer
#extension GL_OES_standard_derivatives : enable
void main() { gl_FragColor = vec4(dFdx(1)); }
//: accepted, 100 webgl1 extended: derivatives after a macro tells that they exist
#ifdef GL_OES_standard_derivatives
#extension GL_OES_standard_derivatives : enable
#endif
varying vec2 u;
void main() { gl_FragColor = vec4(fwidth(u) + dFdx(u) + dFdy(u), 0., 1.); }
//: refused 5 missing-extension, 100 webgl1: a macro of an extension that is not enabled
#ifdef GL_OES_standard_derivatives
#extension GL_OES_standard_derivatives : enable
#endif
varying vec2 u;
void main() { gl_FragColor = vec4(fwidth(u) + dFdx(u) + dFdy(u), 0., 1.); }
//: refused 2 missing-extension, 100 webgl1 extended vertex: derivatives in a vertex shader
#extension GL_OES_standard_derivatives : enable
void main() { gl_Position = vec4(dFdx(1.)); }
//: accepted, 100 webgl1: a function with the name of a derivative
float fwidth(float x) { return x; }
void main() { gl_FragColor = vec4(fwidth(1.)); }
//: refused 1 builtin-redefinition, 100 webgl1 extended: a function with the name of a derivative
float fwidth(float x) { return x; }
void main() { gl_FragColor = vec4(fwidth(1.)); }
//: accepted, 100 webgl2 extended: a function with the name of a derivative
float fwidth(float x) { return x; }
void main() { gl_FragColor = vec4(fwidth(1.)); }
//: accepted, 100 webgl1 extended: a derivative with other parameters
float fwidth(int x) { return 1.; }
void main() { gl_FragColor = vec4(fwidth(1)); }
//: accepted, 100 webgl1 extended: a directive after code
varying vec2 u;
#extension GL_OES_standard_derivatives : enable
void main() { gl_FragColor = vec4(fwidth(u), 0., 1.); }
//: refused 2 extension-placement, 100 webgl2: a directive after code
varying vec2 u;
#extension GL_OES_standard_derivatives : enable
void main() { gl_FragColor = vec4(u, 0., 1.); }
//: refused 4 missing-extension, 100 webgl1: levels of textures
#extension GL_EXT_shader_texture_lod : enable
uniform sampler2D s;
uniform samplerCube c;
void main() { gl_FragColor = texture2DLodEXT(s, vec2(0.), 1.) + textureCubeLodEXT(c, vec3(1.), 1.) + texture2DProjLodEXT(s, vec3(1.), 1.) + texture2DProjLodEXT(s, vec4(1.), 1.); }
//: accepted, 100 webgl1 extended: levels of textures
#extension GL_EXT_shader_texture_lod : enable
uniform sampler2D s;
uniform samplerCube c;
void main() { gl_FragColor = texture2DLodEXT(s, vec2(0.), 1.) + textureCubeLodEXT(c, vec3(1.), 1.) + texture2DProjLodEXT(s, vec3(1.), 1.) + texture2DProjLodEXT(s, vec4(1.), 1.); }
//: refused 4 missing-extension, 100 webgl2 extended: levels of textures
#extension GL_EXT_shader_texture_lod : enable
uniform sampler2D s;
uniform samplerCube c;
void main() { gl_FragColor = texture2DLodEXT(s, vec2(0.), 1.) + textureCubeLodEXT(c, vec3(1.), 1.) + texture2DProjLodEXT(s, vec3(1.), 1.) + texture2DProjLodEXT(s, vec4(1.), 1.); }
//: refused 3 missing-extension, 100 webgl1 extended vertex: levels of textures in a vertex shader
#extension GL_EXT_shader_texture_lod : enable
uniform sampler2D s;
void main() { gl_Position = texture2DLodEXT(s, vec2(0.), 1.); }
//: accepted, 100 webgl1 extended: gradients of textures
#extension GL_EXT_shader_texture_lod : enable
uniform sampler2D s;
uniform samplerCube c;
void main() { gl_FragColor = texture2DGradEXT(s, vec2(0.), vec2(0.), vec2(1.)) + textureCubeGradEXT(c, vec3(0.), vec3(0.), vec3(1.)) + texture2DProjGradEXT(s, vec3(0.), vec2(0.), vec2(1.)); }
//: accepted, 100 webgl1 extended vertex: gradients of textures
#extension GL_EXT_shader_texture_lod : enable
uniform sampler2D s;
uniform samplerCube c;
void main() { gl_Position = texture2DGradEXT(s, vec2(0.), vec2(0.), vec2(1.)) + textureCubeGradEXT(c, vec3(0.), vec3(0.), vec3(1.)) + texture2DProjGradEXT(s, vec3(0.), vec2(0.), vec2(1.)); }
//: refused 3 vector-size, 100 webgl1 extended: a level with the wrong coordinates
#extension GL_EXT_shader_texture_lod : enable
uniform sampler2D s;
void main() { gl_FragColor = texture2DLodEXT(s, vec3(0.), 1.); }
//: refused 2 missing-extension, 100 webgl1: depth
#extension GL_EXT_frag_depth : enable
void main() { gl_FragColor = vec4(1.); gl_FragDepthEXT = 0.5; }
//: accepted, 100 webgl1 extended: depth
#extension GL_EXT_frag_depth : enable
void main() { gl_FragColor = vec4(1.); gl_FragDepthEXT = 0.5; }
//: refused 2 missing-extension, 100 webgl2 extended: depth
#extension GL_EXT_frag_depth : enable
void main() { gl_FragColor = vec4(1.); gl_FragDepthEXT = 0.5; }
//: refused 1 missing-extension, 100 webgl1 extended: depth without the directive
void main() { gl_FragColor = vec4(1.); gl_FragDepthEXT = 0.5; }
//: refused 2 index-out-of-range, 100 webgl1: several outputs
#extension GL_EXT_draw_buffers : enable
void main() { gl_FragData[0] = vec4(1.); gl_FragData[7] = vec4(0.5); }
//: accepted, 100 webgl1 extended: several outputs
#extension GL_EXT_draw_buffers : enable
void main() { gl_FragData[0] = vec4(1.); gl_FragData[7] = vec4(0.5); }
//: refused 2 index-out-of-range, 100 webgl2 extended: several outputs
#extension GL_EXT_draw_buffers : enable
void main() { gl_FragData[0] = vec4(1.); gl_FragData[7] = vec4(0.5); }
//: refused 1 index-out-of-range, 100 webgl1 extended: several outputs without the directive
void main() { gl_FragData[1] = vec4(0.5); }
//: refused 2 index-out-of-range, 100 webgl1 extended: too many outputs
#extension GL_EXT_draw_buffers : enable
void main() { gl_FragData[8] = vec4(0.5); }
//: accepted, 100 webgl1: one draw buffer
void main() { float a[gl_MaxDrawBuffers == 1 ? 1 : -1]; gl_FragColor = vec4(a[0]); }
//: accepted, 100 webgl1: outputs in a loop
void main() { for (int i = 0; i < 2; i++) gl_FragData[i] = vec4(1.); }
//: refused 1 invalid-array, 100 webgl1 extended: one draw buffer
void main() { float a[gl_MaxDrawBuffers == 1 ? 1 : -1]; gl_FragColor = vec4(a[0]); }
//: accepted, 100 webgl1 extended: outputs in a loop
void main() { for (int i = 0; i < 2; i++) gl_FragData[i] = vec4(1.); }
//: refused 1 invalid-array, 100 webgl2: one draw buffer
void main() { float a[gl_MaxDrawBuffers == 1 ? 1 : -1]; gl_FragColor = vec4(a[0]); }
//: refused 1 index-out-of-range, 100 webgl2: outputs in a loop
void main() { for (int i = 0; i < 2; i++) gl_FragData[i] = vec4(1.); }
//: refused 0 unsupported-version, webgl1: GLSL ES 3.00 in WebGL1
void main() {}
//: refused 1 browser-limit, 100 webgl1: a long name
uniform float aaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaa;
void main() { gl_FragColor = vec4(aaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaa); }
//# The extensions of WebGL2
//: refused 2 missing-extension, 100 vertex webgl1: the number of a draw
#extension GL_ANGLE_multi_draw : enable
void main() { gl_Position = vec4(float(gl_DrawID)); }
//: accepted, 100 vertex webgl1 extended: the number of a draw
#extension GL_ANGLE_multi_draw : enable
void main() { gl_Position = vec4(float(gl_DrawID)); }
//: refused 2 missing-extension, 100 vertex webgl2: the number of a draw
#extension GL_ANGLE_multi_draw : enable
void main() { gl_Position = vec4(float(gl_DrawID)); }
//: accepted, 100 vertex webgl2 extended: the number of a draw
#extension GL_ANGLE_multi_draw : enable
void main() { gl_Position = vec4(float(gl_DrawID)); }
//: refused 2 missing-extension, vertex webgl2: the number of a draw
#extension GL_ANGLE_multi_draw : enable
void main() { gl_Position = vec4(float(gl_DrawID)); }
//: accepted, vertex webgl2 extended: the number of a draw
#extension GL_ANGLE_multi_draw : enable
void main() { gl_Position = vec4(float(gl_DrawID)); }
//: refused 2 not-assignable, vertex webgl2 extended: writing to the number of a draw
#extension GL_ANGLE_multi_draw : enable
void main() { gl_DrawID = 1; }
//: refused 3 missing-extension, webgl2 extended: the number of a draw in a fragment shader
#extension GL_ANGLE_multi_draw : enable
out vec4 o;
void main() { o = vec4(gl_DrawID); }
//: accepted, webgl2 extended: depth_any
#extension GL_EXT_conservative_depth : enable
layout(depth_any) out highp float gl_FragDepth;
void main() { gl_FragDepth = 0.5; }
//: accepted, webgl2 extended: depth_greater
#extension GL_EXT_conservative_depth : enable
layout(depth_greater) out highp float gl_FragDepth;
void main() { gl_FragDepth = 0.5; }
//: accepted, webgl2 extended: depth_less
#extension GL_EXT_conservative_depth : enable
layout(depth_less) out highp float gl_FragDepth;
void main() { gl_FragDepth = 0.5; }
//: refused 2 invalid-layout, webgl2 extended: depth_unchanged
#extension GL_EXT_conservative_depth : enable
layout(depth_unchanged) out highp float gl_FragDepth;
void main() { gl_FragDepth = 0.5; }
//: refused 2 invalid-layout, webgl2: depth without the extension
#extension GL_EXT_conservative_depth : enable
layout(depth_less) out highp float gl_FragDepth;
void main() { gl_FragDepth = 0.5; }
//: accepted, webgl2 extended: depth without a layout
#extension GL_EXT_conservative_depth : enable
out highp float gl_FragDepth;
void main() { gl_FragDepth = 0.5; }
//: refused 2 invalid-layout, webgl2 extended: the layout of another output
#extension GL_EXT_conservative_depth : enable
layout(depth_less) out highp float z;
void main() { z = 0.5; }
//: accepted, webgl2 extended: depth beside a colour
#extension GL_EXT_conservative_depth : enable
out vec4 o;
layout(depth_less) out highp float gl_FragDepth;
void main() { o = vec4(1.); gl_FragDepth = 0.5; }
//: accepted, webgl2 extended: noperspective
#extension GL_NV_shader_noperspective_interpolation : enable
noperspective in vec2 w;
noperspective centroid in vec2 c;
out vec4 o;
void main() { o = vec4(w, c); }
//: accepted, vertex webgl2 extended: noperspective
#extension GL_NV_shader_noperspective_interpolation : enable
noperspective out vec2 w;
void main() { w = vec2(1.); }
//: refused 1 reserved-word, webgl2 extended: noperspective without the directive
noperspective in vec2 w;
void main() {}
//: refused 2 reserved-word, webgl2: noperspective without the extension
#extension GL_NV_shader_noperspective_interpolation : enable
noperspective in vec2 w;
void main() {}
//: refused 2 interface-type, webgl2 extended: noperspective integers
#extension GL_NV_shader_noperspective_interpolation : enable
noperspective in ivec2 w;
void main() {}
//: refused 2 invalid-qualifier, webgl2 extended: flat and noperspective
#extension GL_NV_shader_noperspective_interpolation : enable
noperspective flat in vec2 w;
void main() {}
//: refused 2 reserved-word, webgl2 extended: noperspective as a name
#extension GL_NV_shader_noperspective_interpolation : enable
void main() { float noperspective = 1.; }
//: accepted, webgl2 extended: variables of samples
#extension GL_OES_sample_variables : enable
out vec4 o;
void main() { o = vec4(gl_SamplePosition, gl_SampleID + gl_NumSamples, gl_SampleMaskIn[0]); gl_SampleMask[0] = gl_MaxSamples; }
//: accepted, webgl2 extended: an index of the mask
#extension GL_OES_sample_variables : enable
uniform int i;
void main() { gl_SampleMask[i] = 1; }
//: refused 2 index-out-of-range, webgl2 extended: an index of the mask out of range
#extension GL_OES_sample_variables : enable
void main() { gl_SampleMask[1] = 1; }
//: refused 2 not-assignable, webgl2 extended: writing to a sample
#extension GL_OES_sample_variables : enable
void main() { gl_SampleID = 1; }
//: refused 3 missing-extension, webgl2: variables of samples without the extension
#extension GL_OES_sample_variables : enable
out vec4 o;
void main() { o = vec4(gl_SampleID); }
//: accepted, webgl2 extended: interpolation
#extension GL_OES_shader_multisample_interpolation : enable
sample in vec2 w;
in vec2 v[2];
out vec4 o;
void main() { o = vec4(interpolateAtCentroid(w) + interpolateAtSample(v[1], 0), interpolateAtOffset(w, vec2(0.1))); }
//: refused 4 argument-mismatch, webgl2 extended: interpolation of a component
#extension GL_OES_shader_multisample_interpolation : enable
in vec2 w;
out vec4 o;
void main() { o = vec4(interpolateAtCentroid(w.x)); }
//: refused 4 argument-mismatch, webgl2 extended: interpolation of a local variable
#extension GL_OES_shader_multisample_interpolation : enable
in vec2 w;
out vec4 o;
void main() { vec2 v = w; o = vec4(interpolateAtCentroid(v), 0., 1.); }
//: refused 4 argument-mismatch, webgl2 extended: interpolation of a parameter
#extension GL_OES_shader_multisample_interpolation : enable
in vec2 w;
out vec4 o;
vec2 f(vec2 v) { return interpolateAtSample(v, 0); }
void main() { o = vec4(f(w), 0., 1.); }
//: refused 2 builtin-redefinition, webgl2 extended: a function with the name of an interpolation
#extension GL_OES_shader_multisample_interpolation : enable
float interpolateAtCentroid(mat2 x) { return 1.; }
//: accepted, webgl2: a function with the name of an interpolation
#extension GL_OES_shader_multisample_interpolation : enable
float interpolateAtCentroid(float x) { return 1.; }
//: accepted, vertex webgl2 extended: views
#extension GL_OVR_multiview2 : enable
layout(num_views = 2) in;
void main() { gl_Position = vec4(float(gl_ViewID_OVR)); }
//: accepted, webgl2 extended: a view in a fragment shader
#extension GL_OVR_multiview2 : enable
out vec4 o;
void main() { o = vec4(gl_ViewID_OVR); }
//: refused 2 invalid-layout, webgl2 extended: a layout of views in a fragment shader
#extension GL_OVR_multiview2 : enable
layout(num_views = 2) in;
void main() {}
//: refused 2 invalid-layout, vertex webgl2 extended: no view
#extension GL_OVR_multiview2 : enable
layout(num_views = 0) in;
//: refused 2 invalid-layout, vertex webgl2 extended: too many views
#extension GL_OVR_multiview2 : enable
layout(num_views = 80) in;
//: refused 3 invalid-layout, vertex webgl2 extended: two numbers of views
#extension GL_OVR_multiview2 : enable
layout(num_views = 2) in;
layout(num_views = 3) in;
//: refused 2 invalid-layout, vertex webgl2 extended: the number of views of outputs
#extension GL_OVR_multiview2 : enable
layout(num_views = 2) out;
//: refused 2 int-float-mix, vertex webgl2 extended: a view as an int
#extension GL_OVR_multiview2 : enable
void main() { int i = gl_ViewID_OVR; }
//: accepted, vertex webgl2 extended: distances
#extension GL_ANGLE_clip_cull_distance : enable
void main() { gl_Position = vec4(0.); gl_ClipDistance[7] = 1.; gl_CullDistance[0] = gl_ClipDistance[7]; }
//: accepted, webgl2 extended: distances in a fragment shader
#extension GL_ANGLE_clip_cull_distance : enable
out vec4 o;
void main() { o = vec4(gl_ClipDistance[0], gl_CullDistance[1], 0., 1.); }
//: refused 2 not-assignable, webgl2 extended: writing to a distance in a fragment shader
#extension GL_ANGLE_clip_cull_distance : enable
void main() { gl_ClipDistance[0] = 1.; }
//: refused 2 index-out-of-range, vertex webgl2 extended: a distance out of range
#extension GL_ANGLE_clip_cull_distance : enable
void main() { gl_ClipDistance[8] = 1.; }
//: refused 2 invalid-index, vertex webgl2 extended: distances in a loop
#extension GL_ANGLE_clip_cull_distance : enable
void main() { for (int i = 0; i < 4; i++) gl_ClipDistance[i] = 1.; }
//: accepted, vertex webgl2 extended: distances with a size in a loop
#extension GL_ANGLE_clip_cull_distance : enable
out highp float gl_ClipDistance[4];
void main() { for (int i = 0; i < 4; i++) gl_ClipDistance[i] = 1.; }
//: refused 2 reserved-identifier, vertex webgl2 extended: too many distances
#extension GL_ANGLE_clip_cull_distance : enable
out float gl_ClipDistance[9];
//: refused 2 reserved-identifier, vertex webgl2 extended: distances of another type
#extension GL_ANGLE_clip_cull_distance : enable
out vec4 gl_ClipDistance[2];
//: refused 3 reserved-identifier, vertex webgl2 extended: a size after a use
#extension GL_ANGLE_clip_cull_distance : enable
void main() { gl_ClipDistance[0] = 1.; }
out float gl_ClipDistance[2];
//: refused 2 missing-extension, vertex webgl2: distances without the extension
#extension GL_ANGLE_clip_cull_distance : enable
void main() { gl_ClipDistance[0] = 1.; }
//# The directive
//: accepted, 100 webgl1 extended: requiring OES_standard_derivatives
#extension GL_OES_standard_derivatives : require
void main() { gl_FragColor = vec4(1.); }
//: accepted, 100 webgl1 extended: requiring ANGLE_multi_draw
#extension GL_ANGLE_multi_draw : require
void main() { gl_FragColor = vec4(1.); }
//: refused 1 unknown-extension, 100 webgl1 extended: requiring OES_sample_variables
#extension GL_OES_sample_variables : require
void main() { gl_FragColor = vec4(1.); }
//: refused 1 unknown-extension, 100 webgl1 extended: requiring EXT_nothing
#extension GL_EXT_nothing : require
void main() { gl_FragColor = vec4(1.); }
//: refused 1 unknown-extension, 100 webgl1 extended: requiring OES_EGL_image_external_essl3
#extension GL_OES_EGL_image_external_essl3 : require
void main() { gl_FragColor = vec4(1.); }
//: refused 1 unknown-extension, 100 webgl2 extended: requiring OES_standard_derivatives
#extension GL_OES_standard_derivatives : require
void main() { gl_FragColor = vec4(1.); }
//: accepted, 100 webgl2 extended: requiring ANGLE_multi_draw
#extension GL_ANGLE_multi_draw : require
void main() { gl_FragColor = vec4(1.); }
//: refused 1 unknown-extension, 100 webgl2 extended: requiring OES_sample_variables
#extension GL_OES_sample_variables : require
void main() { gl_FragColor = vec4(1.); }
//: refused 1 unknown-extension, 100 webgl2 extended: requiring EXT_nothing
#extension GL_EXT_nothing : require
void main() { gl_FragColor = vec4(1.); }
//: refused 1 unknown-extension, 100 webgl2 extended: requiring OES_EGL_image_external_essl3
#extension GL_OES_EGL_image_external_essl3 : require
void main() { gl_FragColor = vec4(1.); }
//: refused 1 unknown-extension, webgl2 extended: requiring OES_standard_derivatives
#extension GL_OES_standard_derivatives : require
//: accepted, webgl2 extended: requiring OES_sample_variables
#extension GL_OES_sample_variables : require
//: accepted, webgl2 extended: requiring OVR_multiview
#extension GL_OVR_multiview : require
