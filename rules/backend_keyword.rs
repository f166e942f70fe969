//! Names that other shading languages reserve.

use rustc_hash::FxHashMap;
use shaderlint_lint::{Context, DeclaredName, Setting};
use shaderlint_syntax::ast::Extent;
use std::sync::LazyLock;

rule! { backend_keyword, Portability, Info, Strict, [Switch(&WGSL)], Name(check) }

static WGSL: Setting<bool> =
    Setting::new("wgsl", false, "Also report names that only WGSL reserves");

/// Languages that shaders are ported to, and the words that each reserves although WebGL does not.
#[rustfmt::skip]
const LANGUAGES: [(&str, &[&str]); 5] = [
    ("desktop GLSL", &[
        "packed", "buffer", "shared", "precise", "dmat2", "dmat3", "dmat4", "samplerCubeArray",
        "imageCubeArray",
    ]),
    ("Vulkan GLSL", &[
        "sampler", "samplerShadow", "texture1D", "texture2D", "texture3D", "textureCube",
        "texture2DArray", "textureBuffer", "subpassInput", "subpassInputMS",
    ]),
    ("HLSL", &[
        "auto", "bool2", "bool3", "bool4", "cbuffer", "tbuffer", "char", "compile", "const_cast",
        "delete", "dynamic_cast", "explicit", "export", "float2", "float3", "float4", "friend",
        "groupshared", "image", "int2", "int3", "int4", "line", "lineadj", "linear", "matrix",
        "mutable", "new", "nointerpolation", "operator", "packoffset", "pass", "pixelfragment",
        "point", "precise", "private", "protected", "register", "row_major", "column_major",
        "sampler", "shared", "signed", "snorm", "stateblock", "string", "technique", "texture",
        "throw", "triangle", "triangleadj", "try", "catch", "typename", "uniform", "unorm", "vector",
        "vertexfragment", "virtual", "dword", "float16_t", "min16float",
    ]),
    ("Metal", &[
        "access", "alignas", "alignof", "and", "array", "as_type", "atomic", "auto", "bitand",
        "bitor", "catch", "char", "compl", "constant", "constexpr", "decltype", "delete", "device",
        "explicit", "export", "final", "fragment", "friend", "kernel", "metal", "mutable", "new",
        "noexcept", "not", "nullptr", "operator", "or", "packed", "private", "protected", "ptrdiff_t",
        "register", "sampler", "signed", "size_t", "thread", "threadgroup", "throw", "try",
        "typename", "uchar", "uint2", "uint3", "uint4", "float2", "float3", "float4", "int2", "int3",
        "int4", "half2", "half3", "half4", "ushort", "ulong", "vec", "vertex", "virtual", "xor",
    ]),
    ("WGSL", &[
        "abstract", "alias", "as", "async", "await", "auto", "become", "binding_array", "catch",
        "const_assert", "continuing", "crate", "debugger", "delete", "demote", "diagnostic",
        "enable", "export", "extends", "final", "finally", "fn", "from", "get", "impl", "implements",
        "import", "instanceof", "let", "loop", "macro", "match", "meta", "module", "move", "mut",
        "mutable", "new", "nil", "null", "NULL", "nullptr", "of", "operator", "override", "package",
        "pass", "precise", "private", "protected", "ptr", "pub", "quat", "ref", "regardless",
        "register", "requires", "require", "self", "set", "shared", "signed", "snorm", "super",
        "target", "throw", "trait", "try", "type", "typeof", "unless", "unorm", "unsafe", "unsized",
        "use", "var", "virtual", "wgsl", "where", "with", "yield",
    ]),
];

/// By word: a bit set; bit `i` means that `LANGUAGES[i]` reserves it.
static REFUSED_BY: LazyLock<FxHashMap<&str, u8>> = LazyLock::new(|| {
    let mut refused_by: FxHashMap<&str, u8> = FxHashMap::default();
    for (i, (_, words)) in LANGUAGES.iter().enumerate() {
        for word in *words {
            *refused_by.entry(word).or_default() |= 1 << i;
        }
    }
    refused_by
});

fn check(cx: &mut Context, name: &DeclaredName) {
    let Some(languages) = REFUSED_BY.get(name.text) else {
        return;
    };
    let refusing: Vec<&str> = LANGUAGES
        .iter()
        .enumerate()
        .filter(|(i, _)| languages >> i & 1 == 1)
        .map(|(_, (language, _))| *language)
        .collect();
    if refusing == ["WGSL"] && !cx.option(&WGSL) {
        return;
    }
    cx.report(
        Extent::token(name.token),
        format!("`{}` is reserved in {}", name.text, listed(&refusing)),
    )
    .note("WebGL accepts this name, but ports of the shader and some drivers do not")
    .help(format!("rename `{}`", name.text));
}

/// `a`, `a and b`, `a, b and c`.
fn listed(words: &[&str]) -> String {
    match words {
        [] => String::new(),
        [one] => one.to_string(),
        [first @ .., last] => format!("{} and {last}", first.join(", ")),
    }
}
