//! Typical code of each language, as data.

use super::shader_language::ShaderLanguage::{self, *};

/// Token sequences that few of these languages share.
///
/// `_` matches any word, `x_*` any word that starts with `x_`, `"` any string, and a leading `^` the
/// start of a line. One sequence with a leading `!` is sufficient evidence; any other needs further
/// evidence.
#[rustfmt::skip]
pub const SIGNS: &[(ShaderLanguage, &[&str])] = &[
    (Web, &[
        "attribute _", "varying _", "gl_FragColor", "gl_FragData", "mainImage (", "mainSound (", "mainCubemap (",
        "precision highp", "precision mediump", "precision lowp", "texture2D (", "textureCube (", "iResolution",
    ]),
    (Glsl, &[
        "gl_FragCoord", "gl_Position", "gl_PointSize", "gl_VertexID", "fragCoord", "sampler2D _",
        "uniform vec2", "uniform vec3", "uniform vec4", "uniform mat3", "uniform mat4", "uniform _ vec2", "uniform _ vec3",
        "vec2 (", "vec3 (", "vec4 (", "vec2 _", "vec3 _", "vec4 _", "mat2 (", "mat3 (", "mat4 (", "mat2 _", "mat3 _", "mat4 _",
    ]),
    (Desktop, &[
        "! layout ( set", "! layout ( push_constant", "! layout ( local_size_x", "! layout ( vertices", "! layout ( triangles",
        "! layout ( triangle_strip", "! layout ( quads", "! layout ( line_strip", "! layout ( lines", "! layout ( points",
        "! EmitVertex (", "! gl_GlobalInvocationID", "! gl_LocalInvocationID", "! gl_WorkGroupID", "! gl_TessCoord",
        "! gl_TessLevelOuter", "! gl_LaunchIDEXT", "! rayPayloadEXT _", "! rayPayloadInEXT _",
    ]),
    (Hlsl, &[
        "! : SV_*", "! : register (", "! cbuffer _ :", "! [ numthreads (", "! [ maxvertexcount (", "! [ domain (", "! groupshared _",
        "= compile _ _ (", "StructuredBuffer <", "RWStructuredBuffer <",
        "float2 _", "float3 _", "float4 _", "float2 (", "float3 (", "float4 (", "float4x4 _", "float3x3 _", "half4 _", "half3 _",
        ": POSITION", ": COLOR", ": COLOR0", ": NORMAL", ": TEXCOORD", ": TEXCOORD0", ": TEXCOORD1",
        "cbuffer _ {", "tbuffer _", "Texture2D _", "Texture2D <", "TextureCube _", "SamplerState _",
        "RWTexture2D <", "[ unroll", "lerp (", "mul (", "saturate (", "tex2D (",
        "technique _ {", "pass _ {", "sampler_state {", "compile vs_2_0", "compile ps_2_0", "row_major _", "# pragma fragment", "# pragma vertex",
    ]),
    (Metal, &[
        "! using namespace metal", "! metal_stdlib", "! texture2d <", "! metal : :", "! [ [ _ ] ]", "! [ [ buffer (", "! [ [ texture (",
        "kernel void", "fragment float4", "fragment half4",
        "vertex _ _ (", "constant _ &", "device _ *",
    ]),
    (Wgsl, &[
        "@ vertex", "@ fragment", "@ compute", "! @ binding (", "! @ group (", "! @ location (", "! @ builtin (", "@ workgroup_size", "! var <",
        "! - > vec2 <", "! - > vec3 <", "! - > vec4 <", "! - > vec2f", "! - > vec3f", "! - > vec4f", "! fn _ ( _ : vec2 <", "! fn _ ( _ : vec3 <",
        "! fn _ ( _ : vec4 <", "! fn _ ( _ : vec2f", "! fn _ ( _ : vec3f", "! fn _ ( _ : vec4f", "- > f32", "# import _ : :",
        "fn _ (", "vec2 < f32 >", "vec3 < f32 >", "vec4 < f32 >", "vec2f", "vec3f", "vec4f", "mat4x4 <", "array <", "let _ =", ": f32", ": u32",
    ]),
    (Sksl, &["! uniform shader _", "! half4 main (", "! vec4 main ( vec2 _ )", "! vec4 main ( float2 _ )", "! float4 main ( float2 _ )"]),
    (ShaderLab, &["! CGPROGRAM", "! HLSLPROGRAM", "! GLSLPROGRAM", "Shader \" {", "SubShader {", "Properties {", "Tags {"]),
    (Godot, &[
        "! ^ shader_type _", "! uniform _ _ : hint_*", "! uniform _ _ : source_color", "! uniform _ _ : filter_*", "! uniform _ _ : repeat_*",
        "^ render_mode _", "^ group_uniforms _", "void fragment (", "void light (", "texture ( TEXTURE ,", "SCREEN_UV", "SCREEN_TEXTURE",
        "TEXTURE_PIXEL_SIZE", "ALBEDO =", "COLOR =", "COLOR . _", "= COLOR", "NODE_POSITION_WORLD", "FRAGCOORD .",
    ]),
    (ReShade, &[
        "! uniform _ _ < _ =", "! uniform _ _ [ _ ] < _ =", "! sampler _ { Texture =", "! sampler2D _ { Texture =", "! texture _ { Width =",
        "! texture2D _ { Width =", "! texture _ : COLOR", "! texture2D _ : COLOR", "! texture _ : DEPTH", "! texture2D _ : DEPTH",
        "technique _ {", "technique _ <", "pass {", "pass _ {", "VertexShader = _ ;", "PixelShader = _ ;", "ComputeShader = _",
    ]),
    (RetroArch, &[
        "! ^ # pragma parameter _ \" _", "^ # pragma stage vertex", "^ # pragma stage fragment", "uniform Push", "SourceSize", "OriginalSize",
        "FrameCount", "# if defined ( VERTEX )", "# elif defined ( FRAGMENT )", "COMPAT_TEXTURE (",
    ]),
    (Obs, &[
        "! uniform texture2d _", "! uniform texture3d _", "! uniform texturecube _", "! uniform texture_rect _", "! uniform float4x4 ViewProj",
        "! VertData _ ) : TARGET", "! ) : TARGET {", "technique _ {", "pass {", "pass _ {", "vertex_shader = _ (", "pixel_shader = _ (",
    ]),
    (TouchDesigner, &[
        "! TDOutputSwizzle (", "! TDDither (", "! TDWorldToProj (", "! TDDeform (", "! TDDeformNorm (", "! TDCheckDiscard (", "! TDAlphaTest (",
        "! TDFog (", "! TDCameraIndex (", "! TDInstanceID (", "! TDLighting (", "! sTD2DInputs [", "! sTD3DInputs [", "! sTDCubeInputs [",
        "! sTD2DArrayInputs [", "! uTD2DInfos [", "! uTDOutputInfo .", "! mTDComputeOutputs [",
    ]),
    (MilkDrop, &["! ^ [ preset00 ]"]),
    (C, &[
        "# include <", "# pragma once", "int main (", "! std : :", "using namespace", "template <", "printf (", "^ class _ {", "^ class _ :",
        "^ namespace _", "public _", "private _", "public :", "private :", "nullptr", "- > _ (", "static_cast <", "^ extern \"", "String _",
        "^ package _", "func _ (", "fun _ (", "fmt .", "^ import \"", "System . out", "override", "virtual _", "unsigned char", "size_t",
    ]),
    (Rust, &[
        "fn _ (", "pub fn", "pub struct", "pub use", "let mut", "^ use _ : :", "^ use crate", "^ impl _", "^ mod _", "# [ derive", "& self", "& mut",
        "- > Self", "- > Result", ": : new",
    ]),
    (FSharp, &[
        "! ^ open System", "^ open _", "^ module _", "^ namespace _", "let rec", "let mutable", "let inline", "let _ _ =", "let _ =", "( *", "| >", "[ <",
        "printfn \"", "^ type _ =", "fun _ - >", "with get",
    ]),
    (Python, &[
        "^ import _", "^ from _ import", "^ from _ . _ import", "def _ (", "^ class _ :", "^ class _ (", "self .", "__init__", "__name__", "elif _",
        "print (", "lambda _", "^ if _ :", "^ else :", "^ return _ :", "@ property", "raise _", "^ try :", "^ with _", "^ pass",
    ]),
    (Script, &[
        "! ^ export default", "^ export const", "^ export function", "^ export class", "^ import \"", "^ import {", "^ import _ from", "^ import *",
        "function _ (", "function (", "= >", "require (", "console .", "document .", "window .", "const _ =", "let _ =", "var _ =", "let _ ;", "= = =",
        "async _", "await _", "new _ (", "undefined", "typeof _", "interface _ {", ": string", ": number",
    ]),
    (Diff, &["! ^ diff - - git", "! @ @ -"]),
];

/// Whether a text contains a word of which nearly every shader has one.
pub fn may_be_shader(text: &str) -> bool {
    let words = ["void", "#version", "uniform", "varying", "vec", "float"];
    words.iter().any(|word| text.contains(word))
}
