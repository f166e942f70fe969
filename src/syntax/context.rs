//! The contexts of WebGL that compile shaders, and their extensions.
//!
//! Measured in Chromium with each extension on and off. Browsers without an extension: MDN.

use super::names::Version;

/// A version of WebGL.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub enum WebGl {
    /// `getContext('webgl')`, which compiles GLSL ES 1.00.
    One,
    /// `getContext('webgl2')`, which compiles GLSL ES 3.00 and 1.00.
    Two,
}

/// An extension of WebGL that adds to the language.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
#[expect(missing_docs, reason = "each is described by its row")]
pub enum GlExtension {
    StandardDerivatives,
    ShaderTextureLod,
    FragDepth,
    DrawBuffers,
    MultiDraw,
    ConservativeDepth,
    Noperspective,
    SampleVariables,
    MultisampleInterpolation,
    Multiview,
    ClipCullDistance,
}

/// What is known about an extension.
#[derive(Debug)]
pub struct ExtensionFacts {
    /// The extension.
    pub extension: GlExtension,
    /// The argument of `getExtension`.
    pub name: &'static str,
    /// The names that `#extension` knows.
    pub directives: &'static [&'static str],
    /// The functions and variables that it adds.
    pub adds: &'static [&'static str],
    /// The version of the language that it extends; `None` for both.
    pub version: Option<Version>,
    /// What replaces it in GLSL ES 3.00, with a verb; empty if nothing does.
    pub built_in: &'static str,
    /// Browsers that do not have it.
    pub lacking: &'static [&'static str],
}

/// All extensions, in the order of [`Extension`].
pub static EXTENSIONS: [ExtensionFacts; 11] = {
    use GlExtension::*;
    const fn row(
        extension: GlExtension,
        name: &'static str,
        directives: &'static [&'static str],
        adds: &'static [&'static str],
    ) -> ExtensionFacts {
        let built_in = match extension {
            StandardDerivatives => "`dFdx`, `dFdy` and `fwidth` are",
            ShaderTextureLod => "`textureLod` and `textureGrad` are",
            FragDepth => "`gl_FragDepth` is",
            DrawBuffers => "several `out` variables are",
            _ => "",
        };
        let (version, lacking): (_, &[&str]) = match extension {
            _ if !built_in.is_empty() => (Some(Version::Es100), &[]),
            MultiDraw => (None, &["Firefox"]),
            Multiview => (Some(Version::Es300), &["Safari"]),
            _ => (Some(Version::Es300), &["Firefox"]),
        };
        ExtensionFacts {
            extension,
            name,
            directives,
            adds,
            version,
            built_in,
            lacking,
        }
    }
    #[rustfmt::skip]
    let all = [
        row(StandardDerivatives, "OES_standard_derivatives", &["GL_OES_standard_derivatives"],
            &["dFdx", "dFdy", "fwidth"]),
        row(ShaderTextureLod, "EXT_shader_texture_lod", &["GL_EXT_shader_texture_lod"],
            &["texture2DLodEXT", "texture2DProjLodEXT", "textureCubeLodEXT", "texture2DGradEXT",
              "texture2DProjGradEXT", "textureCubeGradEXT"]),
        row(FragDepth, "EXT_frag_depth", &["GL_EXT_frag_depth"], &["gl_FragDepthEXT"]),
        row(DrawBuffers, "WEBGL_draw_buffers", &["GL_EXT_draw_buffers"], &[]),
        row(MultiDraw, "WEBGL_multi_draw", &["GL_ANGLE_multi_draw"], &["gl_DrawID"]),
        row(ConservativeDepth, "EXT_conservative_depth", &["GL_EXT_conservative_depth"], &[]),
        row(Noperspective, "NV_shader_noperspective_interpolation",
            &["GL_NV_shader_noperspective_interpolation"], &[]),
        row(SampleVariables, "OES_sample_variables", &["GL_OES_sample_variables"],
            &["gl_SampleID", "gl_SamplePosition", "gl_SampleMaskIn", "gl_SampleMask", "gl_MaxSamples",
              "gl_NumSamples"]),
        row(MultisampleInterpolation, "OES_shader_multisample_interpolation",
            &["GL_OES_shader_multisample_interpolation"],
            &["interpolateAtCentroid", "interpolateAtOffset", "interpolateAtSample"]),
        row(Multiview, "OVR_multiview2", &["GL_OVR_multiview2", "GL_OVR_multiview"],
            &["gl_ViewID_OVR"]),
        row(ClipCullDistance, "WEBGL_clip_cull_distance", &["GL_ANGLE_clip_cull_distance"],
            &["gl_ClipDistance", "gl_CullDistance", "gl_MaxClipDistances", "gl_MaxCullDistances",
              "gl_MaxCombinedClipAndCullDistances"]),
    ];
    all
};

impl ExtensionFacts {
    /// Whether it extends this version of the language.
    pub fn extends(&self, version: Version) -> bool {
        self.version.is_none_or(|own| own == version)
    }

    /// Whether contexts of this version of WebGL may have it.
    pub fn exists_in(&self, webgl: WebGl) -> bool {
        match webgl {
            WebGl::One => self.version != Some(Version::Es300),
            WebGl::Two => self.version != Some(Version::Es100),
        }
    }
}

impl GlExtension {
    /// What is known about it.
    pub fn facts(self) -> &'static ExtensionFacts {
        let [first, ..] = &EXTENSIONS;
        EXTENSIONS.get(self as usize).unwrap_or(first)
    }

    /// The extension that an `#extension` directive names.
    pub fn of_directive(name: &str) -> Option<GlExtension> {
        let mut all = EXTENSIONS.iter();
        let found = all.find(|facts| facts.directives.contains(&name));
        found.map(|facts| facts.extension)
    }

    /// The extension of this name, as in `getExtension` or in `#extension`.
    pub fn named(name: &str) -> Option<GlExtension> {
        // `getExtension` ignores case.
        let mut all = EXTENSIONS.iter();
        let found = all.find(|facts| facts.name.eq_ignore_ascii_case(name));
        GlExtension::of_directive(name).or(found.map(|facts| facts.extension))
    }

    /// The extension that adds a function or variable to a version of the language.
    pub fn that_adds(name: &str, version: Version) -> Option<GlExtension> {
        let mut all = EXTENSIONS.iter();
        let found = all.find(|facts| facts.adds.contains(&name) && facts.extends(version));
        found.map(|facts| facts.extension)
    }
}

/// A set of extensions.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Default, Debug)]
pub struct Extensions(u16);

impl Extensions {
    /// No extension.
    pub const NONE: Extensions = Extensions(0);

    /// Adds one.
    pub fn insert(&mut self, extension: GlExtension) {
        self.0 |= 1 << extension as u16;
    }

    /// Removes one.
    pub fn remove(&mut self, extension: GlExtension) {
        self.0 &= !(1 << extension as u16);
    }

    /// Whether it contains one.
    pub fn contains(self, extension: GlExtension) -> bool {
        self.0 & 1 << extension as u16 != 0
    }

    /// Those that are not in another set.
    pub fn without(self, others: Extensions) -> Extensions {
        Extensions(self.0 & !others.0)
    }

    /// Those of both sets.
    pub fn and(self, others: Extensions) -> Extensions {
        Extensions(self.0 | others.0)
    }
}

impl Extend<GlExtension> for Extensions {
    fn extend<T: IntoIterator<Item = GlExtension>>(&mut self, all: T) {
        all.into_iter().for_each(|extension| self.insert(extension));
    }
}

impl FromIterator<GlExtension> for Extensions {
    fn from_iter<T: IntoIterator<Item = GlExtension>>(all: T) -> Extensions {
        let mut set = Extensions::NONE;
        set.extend(all);
        set
    }
}

/// A context that compiles a shader.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub struct GlContext {
    /// Its version.
    pub webgl: WebGl,
    /// Whether the program around the shader, its host or the configuration shows the version.
    pub is_known: bool,
    /// The extensions that are enabled, before the shader is compiled.
    pub enabled: Extensions,
    /// Those of them that are presumed to be enabled because the shader asks for them.
    pub presumed: Extensions,
}

impl GlContext {
    /// WebGL2 without extensions.
    pub const WEBGL2: GlContext = GlContext {
        webgl: WebGl::Two,
        is_known: false,
        enabled: Extensions::NONE,
        presumed: Extensions::NONE,
    };

    /// Whether a shader in a version of the language can use an extension here.
    pub fn has(&self, extension: GlExtension, version: Version) -> bool {
        let facts = extension.facts();
        facts.extends(version) && facts.exists_in(self.webgl) && self.enabled.contains(extension)
    }

    /// The longest identifier in bytes.
    pub fn longest_name(&self) -> usize {
        match self.webgl {
            WebGl::One => 256,
            WebGl::Two => 1_024,
        }
    }
}

/// Extensions that every context has, by version of the language, measured in Chromium.
pub(crate) const KNOWN_EXTENSIONS: [&str; 2] = [
    "GL_OES_EGL_image_external",
    "GL_OES_EGL_image_external_essl3",
];

/// What an `#extension` directive may ask for.
pub const EXTENSION_BEHAVIORS: [&str; 4] = ["enable", "require", "warn", "disable"];

/// The extensions that a shader of a version can enable.
pub fn extensions(version: Version) -> impl Iterator<Item = &'static str> {
    let [both, only_300] = KNOWN_EXTENSIONS;
    let own = match version {
        Version::Es100 => both,
        Version::Es300 => only_300,
    };
    let fitting = EXTENSIONS
        .iter()
        .filter(move |facts| facts.extends(version));
    fitting
        .flat_map(|facts| facts.directives.iter().copied())
        .chain([own])
}

impl GlContext {
    /// Those of its extensions that a shader in this version can use.
    pub(crate) fn usable(self, version: Version) -> impl Iterator<Item = &'static ExtensionFacts> {
        let all = EXTENSIONS.iter();
        all.filter(move |facts| self.has(facts.extension, version))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rows_are_in_the_order_of_the_extensions() {
        for facts in &EXTENSIONS {
            assert_eq!(facts.extension.facts().name, facts.name);
        }
    }
}
