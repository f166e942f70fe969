//! The kinds of all compile errors, in one table: the name of each, and what code has to know of it
//! where it decides something. Each has a page in `rules/errors/`.

/// How sure an error of some kind is in a part of a shader, which a host completes.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Certainty {
    /// It holds between what the part declares.
    Meaning,
    /// It holds where no word that may be a macro stands near.
    Syntax,
    /// A host may repair it: something is missing, stands in the wrong place, or only one version
    /// has it.
    Never,
}

/// What a shader lacks by an error of some kind, and its host may have.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Lack {
    /// A variable, function or type.
    Name,
    /// A precision, or another version of the language.
    Setting,
    /// The declaration of its outputs.
    Output,
}

/// What else decides something about errors of a kind.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Facet {
    /// It is reported where a shader ends too early, wherever it stands.
    EndsEarly,
    /// The parser or the preprocessor reports it, which judge all that they read.
    Reads,
    /// It moves what stands where, to the end of the file.
    Moves,
    /// It is an error of a directive.
    Directive,
    /// The grammar does not fit, which one token may repair.
    Grammar,
    /// It may come of a form of another language.
    ForeignForm,
    /// It is about what is declared, not about what is done with it.
    Declares,
    /// GLSL of desktops takes it.
    Desktop,
}

/// A kind of compile error.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct ErrorKind {
    /// Its name, which is also that of its page.
    pub name: &'static str,
    /// How sure it is in a part of a shader.
    pub certainty: Certainty,
    /// What the shader lacks.
    pub lacks: Option<Lack>,
    /// A bit for each facet.
    facets: u8,
}

impl ErrorKind {
    const fn new(name: &'static str) -> ErrorKind {
        ErrorKind {
            name,
            certainty: Certainty::Never,
            lacks: None,
            facets: 0,
        }
    }

    const fn meaning(mut self) -> ErrorKind {
        self.certainty = Certainty::Meaning;
        self
    }

    const fn syntax(mut self) -> ErrorKind {
        self.certainty = Certainty::Syntax;
        self
    }

    const fn lacks(mut self, lack: Lack) -> ErrorKind {
        self.lacks = Some(lack);
        self
    }

    const fn is(mut self, facet: Facet) -> ErrorKind {
        self.facets |= 1 << facet as u8;
        self
    }

    /// Whether it has a facet.
    pub const fn has(self, facet: Facet) -> bool {
        self.facets & 1 << facet as u8 != 0
    }
}

macro_rules! errors {
    ($($(#[$doc:meta])* $constant:ident = $name:literal $(, $facet:ident $(($of:expr))?)*;)*) => {
        /// The kinds of all compile errors.
        pub mod error {
            use crate::code::{ErrorKind, Facet, Lack};
            $($(#[$doc])* pub const $constant: ErrorKind =
                ErrorKind::new($name)$(.$facet($($of)?))*;)*
        }
        /// The names of all compile errors, in the order of the table.
        pub const ERRORS: &[&str] = &[$($name),*];
    };
}

errors! {
    // Characters and tokens.
    /// A character that GLSL does not have.
    INVALID_CHARACTER = "invalid-character", syntax, is(Facet::Reads);
    /// A file that is not UTF-8.
    INVALID_ENCODING = "invalid-encoding";
    /// `1f`, `08`, `1.0.0`, a number over 32 bits.
    INVALID_NUMBER = "invalid-number", syntax;
    /// A word that the language keeps for itself, used as a name.
    RESERVED_WORD = "reserved-word", meaning, is(Facet::ForeignForm), is(Facet::Desktop);
    /// `/*` without `*/`.
    UNTERMINATED_COMMENT = "unterminated-comment", syntax, is(Facet::EndsEarly), is(Facet::Reads), is(Facet::Moves);

    // The preprocessor.
    /// A directive that does not exist or is not well formed.
    BAD_DIRECTIVE = "bad-directive", meaning, is(Facet::Reads), is(Facet::Directive);
    /// Something before `#version`.
    VERSION_PLACEMENT = "version-placement";
    /// A version other than 100 and 300 es.
    UNSUPPORTED_VERSION = "unsupported-version";
    /// `#extension` behind code.
    EXTENSION_PLACEMENT = "extension-placement";
    /// An extension that WebGL2 does not have, required.
    UNKNOWN_EXTENSION = "unknown-extension";
    /// `#error`.
    ERROR_DIRECTIVE = "error-directive";
    /// An `#if` expression without a value.
    PREPROCESSOR_EXPRESSION = "preprocessor-expression", is(Facet::Directive);
    /// `#if` without `#endif`, or the other way round.
    UNBALANCED_CONDITIONAL = "unbalanced-conditional", meaning, is(Facet::EndsEarly), is(Facet::Reads), is(Facet::Moves), is(Facet::Directive);
    /// A macro defined again with another meaning.
    MACRO_REDEFINITION = "macro-redefinition", meaning, is(Facet::Declares);
    /// A macro name that the language keeps for itself.
    RESERVED_MACRO = "reserved-macro";
    /// A macro call with too few or too many arguments, or without its `)`.
    MACRO_ARGUMENTS = "macro-arguments", meaning, is(Facet::Reads);
    /// `#` or `##` in a macro that is used.
    TOKEN_PASTE = "token-paste";
    /// A macro whose definition makes its uses fail.
    FAULTY_MACRO = "faulty-macro", syntax;
    /// Macros that expand to more than the browser takes.
    MACRO_BUDGET = "macro-budget", is(Facet::Moves);

    // Syntax.
    /// A token that cannot stand where it does.
    SYNTAX_ERROR = "syntax-error", syntax, is(Facet::Reads), is(Facet::ForeignForm), is(Facet::Grammar);
    /// A statement without its `;`.
    MISSING_SEMICOLON = "missing-semicolon", syntax, is(Facet::Reads), is(Facet::ForeignForm), is(Facet::Grammar);
    /// `(`, `[` or `{` without its partner.
    UNCLOSED_DELIMITER = "unclosed-delimiter", syntax, is(Facet::EndsEarly), is(Facet::Reads), is(Facet::ForeignForm), is(Facet::Grammar);
    /// `;` at global scope.
    STRAY_SEMICOLON = "stray-semicolon", is(Facet::Reads);
    /// `{1.0, 2.0}` as an initializer.
    INITIALIZER_LIST = "initializer-list", syntax;
    /// A C or C++ habit that GLSL does not have.
    FOREIGN_SYNTAX = "foreign-syntax", syntax, is(Facet::ForeignForm);

    // Names and declarations.
    /// A name that nothing declares.
    UNDECLARED_NAME = "undeclared-name", lacks(Lack::Name);
    /// `fragCoord` where only `gl_FragCoord` exists.
    FRAGCOORD_IN_MAIN = "fragcoord-in-main";
    /// A function used before its declaration.
    USE_BEFORE_DECLARATION = "use-before-declaration";
    /// A type that nothing declares.
    UNKNOWN_TYPE = "unknown-type", lacks(Lack::Name);
    /// A name declared twice in one scope.
    REDEFINITION = "redefinition", meaning, is(Facet::Declares);
    /// A function with the name of a built-in function.
    BUILTIN_REDEFINITION = "builtin-redefinition", meaning, is(Facet::Declares);
    /// `gl_x`, `a__b`, `webgl_x`.
    RESERVED_IDENTIFIER = "reserved-identifier";
    /// A type without a default precision.
    MISSING_PRECISION = "missing-precision", lacks(Lack::Setting);
    /// A fragment shader that writes to an output it does not declare.
    MISSING_OUTPUT = "missing-output", lacks(Lack::Output);
    /// No `main`.
    MISSING_MAIN = "missing-main", is(Facet::EndsEarly);
    /// `mainImage` without a `main` that calls it.
    UNWRAPPED_MAINIMAGE = "unwrapped-mainimage", is(Facet::EndsEarly);
    /// `mainImage` or its kin with other parameters than the player's.
    MAINIMAGE_SIGNATURE = "mainimage-signature";
    /// Code of GLSL ES 1.00 in a shader of 3.00.
    LEGACY_GLSL = "legacy-glsl", is(Facet::Desktop);
    /// A function without a `return`.
    MISSING_RETURN = "missing-return", meaning, is(Facet::Declares);
    /// A function that is called but never defined.
    UNDEFINED_FUNCTION = "undefined-function", is(Facet::EndsEarly);
    /// A function that calls itself.
    RECURSION = "recursion";
    /// A declaration of a function that does not fit another one.
    FUNCTION_MISMATCH = "function-mismatch", meaning, is(Facet::Declares);
    /// A function declared inside a function.
    LOCAL_FUNCTION = "local-function", syntax, is(Facet::Reads), is(Facet::ForeignForm);
    /// A parameter that cannot be declared so.
    INVALID_PARAMETER = "invalid-parameter", meaning, is(Facet::Declares);
    /// Qualifiers that cannot stand together or here.
    INVALID_QUALIFIER = "invalid-qualifier";
    /// A `layout(...)` that cannot stand here.
    INVALID_LAYOUT = "invalid-layout";
    /// Fragment outputs whose locations clash or are missing.
    OUTPUT_LOCATION = "output-location", lacks(Lack::Output);
    /// An input or output of a type that cannot be one.
    INTERFACE_TYPE = "interface-type";
    /// An interface block that cannot be declared so.
    INTERFACE_BLOCK = "interface-block";
    /// A struct that cannot be declared so.
    INVALID_STRUCT = "invalid-struct", meaning, is(Facet::Declares);
    /// An array that cannot be declared so.
    INVALID_ARRAY = "invalid-array", meaning;
    /// `void` as the type of a value.
    VOID_VALUE = "void-value", meaning;
    /// A constant without a value, or with one that is not constant.
    NOT_CONSTANT = "not-constant", is(Facet::Desktop);
    /// A sampler where none may stand.
    SAMPLER_RESTRICTION = "sampler-restriction", meaning;

    // Types.
    /// `int` and `float` mixed.
    INT_FLOAT_MIX = "int-float-mix", meaning, is(Facet::Desktop);
    /// Vectors or matrices of sizes that do not fit.
    VECTOR_SIZE = "vector-size", meaning;
    /// Any other two types that do not fit.
    TYPE_MISMATCH = "type-mismatch", meaning;
    /// A condition that is no `bool`.
    CONDITION_TYPE = "condition-type", meaning;
    /// A constructor with arguments that do not fit.
    CONSTRUCTOR_ARGUMENTS = "constructor-arguments", meaning;
    /// A call that fits no overload.
    ARGUMENT_MISMATCH = "argument-mismatch", meaning;
    /// A call of something that is no function.
    NOT_A_FUNCTION = "not-a-function";
    /// A function or type used as a variable.
    NOT_A_VARIABLE = "not-a-variable", meaning;
    /// `return` of another type than the function's.
    RETURN_TYPE = "return-type", meaning;
    /// A component that the vector does not have.
    SWIZZLE_OUT_OF_RANGE = "swizzle-out-of-range", meaning;
    /// Letters that are no components.
    INVALID_SWIZZLE = "invalid-swizzle", meaning;
    /// A member that the struct does not have.
    NO_SUCH_FIELD = "no-such-field", meaning;
    /// `[...]` that does not fit.
    INVALID_INDEX = "invalid-index", meaning;
    /// An index outside the array, vector or matrix.
    INDEX_OUT_OF_RANGE = "index-out-of-range", meaning;
    /// An assignment to something that cannot be assigned to.
    NOT_ASSIGNABLE = "not-assignable", meaning;
    /// `length`, `mix` and their kin on integers.
    INTEGER_LENGTH = "integer-length", meaning;
    /// An operation that WebGL2 does not have for this type.
    UNSUPPORTED_OPERATION = "unsupported-operation", meaning;

    // Statements.
    /// A `switch` or its labels wrong.
    INVALID_SWITCH = "invalid-switch", meaning;
    /// `break`, `continue`, `discard` or `return` where it cannot stand.
    MISPLACED_JUMP = "misplaced-jump";
    /// A loop that never ends.
    INFINITE_LOOP = "infinite-loop";

    // Both stages together.
    /// Stages of two versions of the language.
    LINK_VERSION = "link-version";
    /// What the fragment shader reads, and the vertex shader does not give, or not so.
    LINK_VARYING = "link-varying";
    /// A uniform that both stages declare differently.
    LINK_UNIFORM = "link-uniform";
    /// A uniform block that both stages declare differently.
    LINK_BLOCK = "link-block";
    /// Attributes without a place, or at one place.
    LINK_ATTRIBUTE = "link-attribute";

    // Limits and versions.
    /// More than the browser takes.
    BROWSER_LIMIT = "browser-limit";
    /// Something that GLSL ES 1.00 does not have.
    NEEDS_WEBGL2 = "needs-webgl2", lacks(Lack::Setting);
    /// A loop or an index that WebGL1 does not allow.
    WEBGL1_RESTRICTION = "webgl1-restriction";
}
