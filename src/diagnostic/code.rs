//! Table of all compile errors: the name of each kind and the properties that code depends on. Each
//! kind has a page in `rules/errors/`.

/// How reliable an error of this kind is in a shader fragment, which a host completes.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Certainty {
    /// Certain if everything involved is declared in the fragment itself.
    Meaning,
    /// Certain unless an identifier nearby may be a macro of the host.
    Syntax,
    /// Not certain: the host may resolve it, because something is missing or misplaced, or because
    /// only one version has it.
    Never,
}

/// What the shader lacks if this error occurs, and a host may provide.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Lack {
    /// A variable, function or type.
    Name,
    /// A default precision, or another version of the language.
    Setting,
    /// A declaration of the fragment outputs.
    Output,
}

/// Further properties of error kinds.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Facet {
    /// Also reported where a shader ends too early, whatever its position.
    EndsEarly,
    /// Reported by the parser or preprocessor, which check all code that they read.
    Reads,
    /// Invalidates what follows, up to the end of the file.
    Moves,
    /// An error in a preprocessor directive.
    Directive,
    /// A grammar error that a one-token correction may fix.
    Grammar,
    /// May be caused by a construct of another language.
    ForeignForm,
    /// Concerns a declaration rather than a use.
    Declares,
    /// Valid in desktop GLSL.
    Desktop,
    /// Each stage compiles; both together do not.
    Links,
}

/// A kind of compile error.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct ErrorKind {
    /// Name of the error, also the name of its page.
    pub name: &'static str,
    /// How reliable it is in a shader fragment.
    pub certainty: Certainty,
    /// What the shader lacks, if anything.
    pub lacks: Option<Lack>,
    /// One bit per [`Facet`].
    facets: u16,
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

    /// Whether it has this property.
    pub const fn has(self, facet: Facet) -> bool {
        self.facets & 1 << facet as u8 != 0
    }
}

// `$dollar` is a dollar sign, for the macro inside.
macro_rules! errors {
    ($dollar:tt $($(#[$doc:meta])* $constant:ident = $name:tt $(, $facet:ident $(($of:expr))?)*;)*) => {
        /// The kinds of all compile errors.
        pub mod error {
            use crate::code::{ErrorKind, Facet, Lack};
            $($(#[$doc])* pub const $constant: ErrorKind =
                ErrorKind::new($name)$(.$facet($($of)?))*;)*
        }
        /// The names of all compile errors, in the order of the table.
        pub const ERRORS: &[&str] = &[$($name),*];
        /// Calls a macro with the names of all compile errors.
        #[macro_export]
        macro_rules! for_error_names {
            ($dollar called:ident) => {
                $dollar called! { $($name,)* }
            };
        }
    };
}

errors! { $
    // Characters and tokens.
    /// A character that GLSL does not have.
    INVALID_CHARACTER = "invalid-character", syntax, is(Facet::Reads);
    /// A file that is not UTF-8.
    INVALID_ENCODING = "invalid-encoding";
    /// `1f`, `08`, `1.0.0`, a number over 32 bits.
    INVALID_NUMBER = "invalid-number", syntax;
    /// A reserved word or keyword used as a name.
    RESERVED_WORD = "reserved-word", meaning, is(Facet::ForeignForm), is(Facet::Desktop);
    /// `/*` without `*/`.
    UNTERMINATED_COMMENT = "unterminated-comment", syntax, is(Facet::EndsEarly), is(Facet::Reads), is(Facet::Moves);

    // The preprocessor.
    /// An unknown or malformed directive.
    BAD_DIRECTIVE = "bad-directive", meaning, is(Facet::Reads), is(Facet::Directive);
    /// Something before `#version`.
    VERSION_PLACEMENT = "version-placement";
    /// A version other than `100` and `300 es`.
    UNSUPPORTED_VERSION = "unsupported-version";
    /// What the host of a shader does not accept, although WebGL2 does.
    HOST_LIMIT = "host-limit";
    /// `#extension` after code.
    EXTENSION_PLACEMENT = "extension-placement";
    /// `require` of an extension that WebGL2 does not have.
    UNKNOWN_EXTENSION = "unknown-extension";
    /// `#error`.
    ERROR_DIRECTIVE = "error-directive";
    /// An `#if` expression that cannot be evaluated.
    PREPROCESSOR_EXPRESSION = "preprocessor-expression", is(Facet::Directive);
    /// `#if` without `#endif`, or the reverse.
    UNBALANCED_CONDITIONAL = "unbalanced-conditional", meaning, is(Facet::EndsEarly), is(Facet::Reads), is(Facet::Moves), is(Facet::Directive);
    /// A macro redefined with a different definition.
    MACRO_REDEFINITION = "macro-redefinition", meaning, is(Facet::Declares);
    /// A reserved macro name.
    RESERVED_MACRO = "reserved-macro";
    /// A macro call with too few or too many arguments, or without its `)`.
    MACRO_ARGUMENTS = "macro-arguments", meaning, is(Facet::Reads);
    /// `#` or `##` in a macro that is used.
    TOKEN_PASTE = "token-paste";
    /// A macro definition that causes errors at its uses.
    FAULTY_MACRO = "faulty-macro", syntax;
    /// Macros that expand to more than the browser accepts.
    MACRO_BUDGET = "macro-budget", is(Facet::Moves);

    // Syntax.
    /// An unexpected token.
    SYNTAX_ERROR = "syntax-error", syntax, is(Facet::Reads), is(Facet::ForeignForm), is(Facet::Grammar);
    /// A statement without its `;`.
    MISSING_SEMICOLON = "missing-semicolon", syntax, is(Facet::Reads), is(Facet::ForeignForm), is(Facet::Grammar);
    /// `(`, `[` or `{` without its counterpart, or the reverse.
    UNCLOSED_DELIMITER = "unclosed-delimiter", syntax, is(Facet::EndsEarly), is(Facet::Reads), is(Facet::ForeignForm), is(Facet::Grammar);
    /// `;` at global scope.
    STRAY_SEMICOLON = "stray-semicolon", is(Facet::Reads), is(Facet::Desktop);
    /// `{1.0, 2.0}` as an initializer.
    INITIALIZER_LIST = "initializer-list", syntax, is(Facet::Desktop);
    /// A construct of another language.
    FOREIGN_SYNTAX = "foreign-syntax", syntax, is(Facet::ForeignForm);

    // Names and declarations.
    /// An undeclared name.
    UNDECLARED_NAME = "undeclared-name", lacks(Lack::Name);
    /// `fragCoord` where only `gl_FragCoord` exists.
    FRAGCOORD_IN_MAIN = "fragcoord-in-main";
    /// A function used before its declaration.
    USE_BEFORE_DECLARATION = "use-before-declaration";
    /// An undeclared type.
    UNKNOWN_TYPE = "unknown-type", lacks(Lack::Name);
    /// A name declared twice in one scope.
    REDEFINITION = "redefinition", meaning, is(Facet::Declares);
    /// A function with the name of a built-in function.
    BUILTIN_REDEFINITION = "builtin-redefinition", meaning, is(Facet::Declares), is(Facet::Desktop);
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
    /// `mainImage` or another ShaderToy entry function with the wrong signature.
    MAINIMAGE_SIGNATURE = "mainimage-signature";
    /// GLSL ES 1.00 code in a GLSL ES 3.00 shader.
    LEGACY_GLSL = "legacy-glsl", is(Facet::Desktop);
    /// A function without a `return`.
    MISSING_RETURN = "missing-return", meaning, is(Facet::Declares);
    /// A function that is called but never defined.
    UNDEFINED_FUNCTION = "undefined-function", is(Facet::EndsEarly);
    /// A function that calls itself.
    RECURSION = "recursion";
    /// A function declaration that does not match an earlier one.
    FUNCTION_MISMATCH = "function-mismatch", meaning, is(Facet::Declares);
    /// A function declared inside a function.
    LOCAL_FUNCTION = "local-function", syntax, is(Facet::Reads), is(Facet::ForeignForm);
    /// An invalid parameter declaration.
    INVALID_PARAMETER = "invalid-parameter", meaning, is(Facet::Declares);
    /// A qualifier that is not allowed here or conflicts with another.
    INVALID_QUALIFIER = "invalid-qualifier";
    /// A `layout(...)` that is not allowed here.
    INVALID_LAYOUT = "invalid-layout", is(Facet::Desktop);
    /// Fragment outputs with missing or conflicting locations.
    OUTPUT_LOCATION = "output-location", meaning;
    /// An input or output of a type that is not allowed.
    INTERFACE_TYPE = "interface-type";
    /// An invalid interface block.
    INTERFACE_BLOCK = "interface-block";
    /// An invalid struct declaration.
    INVALID_STRUCT = "invalid-struct", meaning, is(Facet::Declares);
    /// An invalid array declaration.
    INVALID_ARRAY = "invalid-array", meaning;
    /// `void` as the type of a value.
    VOID_VALUE = "void-value", meaning;
    /// A constant without a value, or with one that is not constant.
    NOT_CONSTANT = "not-constant", is(Facet::Desktop);
    /// A constant without an initializer or with one that is not constant.
    SAMPLER_RESTRICTION = "sampler-restriction", meaning;

    // Types.
    /// `int` and `float` mixed.
    INT_FLOAT_MIX = "int-float-mix", meaning, is(Facet::Desktop);
    /// Vectors or matrices with incompatible sizes.
    VECTOR_SIZE = "vector-size", meaning;
    /// Any other incompatible types.
    TYPE_MISMATCH = "type-mismatch", meaning;
    /// A condition that is not a `bool`.
    CONDITION_TYPE = "condition-type", meaning;
    /// A constructor with invalid arguments.
    CONSTRUCTOR_ARGUMENTS = "constructor-arguments", meaning;
    /// A call that matches no overload.
    ARGUMENT_MISMATCH = "argument-mismatch", meaning;
    /// A call of something that is not a function.
    NOT_A_FUNCTION = "not-a-function";
    /// A function or type used as a variable.
    NOT_A_VARIABLE = "not-a-variable", meaning;
    /// `return` of a value of the wrong type.
    RETURN_TYPE = "return-type", meaning;
    /// A component that the vector does not have.
    SWIZZLE_OUT_OF_RANGE = "swizzle-out-of-range", meaning;
    /// A swizzle with letters that are not components.
    INVALID_SWIZZLE = "invalid-swizzle", meaning;
    /// A member that the struct does not have.
    NO_SUCH_FIELD = "no-such-field", meaning;
    /// An index that is not an integer, or on a type without elements.
    INVALID_INDEX = "invalid-index", meaning;
    /// An index outside the array, vector or matrix.
    INDEX_OUT_OF_RANGE = "index-out-of-range", meaning;
    /// An assignment to something that cannot be assigned to.
    NOT_ASSIGNABLE = "not-assignable", meaning;
    /// `length`, `mix` and other float functions on integers.
    INTEGER_LENGTH = "integer-length", meaning;
    /// An operation that WebGL2 does not have for this type.
    UNSUPPORTED_OPERATION = "unsupported-operation", meaning;

    // Statements.
    /// An invalid `switch` statement or label.
    INVALID_SWITCH = "invalid-switch", meaning;
    /// `break`, `continue` or `discard` where it is not allowed.
    MISPLACED_JUMP = "misplaced-jump";
    /// A loop that never ends.
    INFINITE_LOOP = "infinite-loop";

    // Both stages together.
    /// Stages with different versions of the language.
    LINK_VERSION = "link-version", is(Facet::Links);
    /// A fragment input without a matching vertex output.
    LINK_VARYING = "link-varying", is(Facet::Links);
    /// A uniform with different declarations in the two stages.
    LINK_UNIFORM = "link-uniform", is(Facet::Links);
    /// A uniform block with different declarations in the two stages.
    LINK_BLOCK = "link-block", is(Facet::Links);
    /// Attributes without a free location, or with the same one.
    LINK_ATTRIBUTE = "link-attribute", is(Facet::Links);

    // Limits and versions.
    /// A limit of the browser's compiler is exceeded.
    BROWSER_LIMIT = "browser-limit";
    /// Something that GLSL ES 1.00 does not have.
    NEEDS_WEBGL2 = "needs-webgl2", lacks(Lack::Setting);
    /// A function or variable of an extension that is not enabled.
    MISSING_EXTENSION = "missing-extension", lacks(Lack::Setting);
    /// A loop or an index that WebGL1 does not allow.
    WEBGL1_RESTRICTION = "webgl1-restriction";
}
