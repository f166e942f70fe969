//! The names of all compile errors. Each has a page in `rules/errors/`.

macro_rules! errors {
    ($($(#[$doc:meta])* $constant:ident = $name:literal;)*) => {
        /// The names of all compile errors.
        pub mod error {
            $($(#[$doc])* pub const $constant: &str = $name;)*
        }
        /// The names of all compile errors, in the order of the table.
        pub const ERRORS: &[&str] = &[$($name),*];
    };
}

errors! {
    // Characters and tokens.
    /// A character that GLSL does not have.
    INVALID_CHARACTER = "invalid-character";
    /// A file that is not UTF-8.
    INVALID_ENCODING = "invalid-encoding";
    /// `1f`, `08`, `1.0.0`, a number over 32 bits.
    INVALID_NUMBER = "invalid-number";
    /// A word that the language keeps for itself, used as a name.
    RESERVED_WORD = "reserved-word";
    /// `/*` without `*/`.
    UNTERMINATED_COMMENT = "unterminated-comment";

    // The preprocessor.
    /// A directive that does not exist or is not well formed.
    BAD_DIRECTIVE = "bad-directive";
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
    PREPROCESSOR_EXPRESSION = "preprocessor-expression";
    /// `#if` without `#endif`, or the other way round.
    UNBALANCED_CONDITIONAL = "unbalanced-conditional";
    /// A macro defined again with another meaning.
    MACRO_REDEFINITION = "macro-redefinition";
    /// A macro name that the language keeps for itself.
    RESERVED_MACRO = "reserved-macro";
    /// A macro call with too few or too many arguments, or without its `)`.
    MACRO_ARGUMENTS = "macro-arguments";
    /// `#` or `##` in a macro that is used.
    TOKEN_PASTE = "token-paste";
    /// A macro whose definition makes its uses fail.
    FAULTY_MACRO = "faulty-macro";
    /// Macros that expand to more than the browser takes.
    MACRO_BUDGET = "macro-budget";

    // Syntax.
    /// A token that cannot stand where it does.
    SYNTAX_ERROR = "syntax-error";
    /// A statement without its `;`.
    MISSING_SEMICOLON = "missing-semicolon";
    /// `(`, `[` or `{` without its partner.
    UNCLOSED_DELIMITER = "unclosed-delimiter";
    /// `;` at global scope.
    STRAY_SEMICOLON = "stray-semicolon";
    /// `{1.0, 2.0}` as an initializer.
    INITIALIZER_LIST = "initializer-list";
    /// A C or C++ habit that GLSL does not have.
    FOREIGN_SYNTAX = "foreign-syntax";

    // Names and declarations.
    /// A name that nothing declares.
    UNDECLARED_NAME = "undeclared-name";
    /// `fragCoord` where only `gl_FragCoord` exists.
    FRAGCOORD_IN_MAIN = "fragcoord-in-main";
    /// A function used before its declaration.
    USE_BEFORE_DECLARATION = "use-before-declaration";
    /// A type that nothing declares.
    UNKNOWN_TYPE = "unknown-type";
    /// A name declared twice in one scope.
    REDEFINITION = "redefinition";
    /// A function with the name of a built-in function.
    BUILTIN_REDEFINITION = "builtin-redefinition";
    /// `gl_x`, `a__b`, `webgl_x`.
    RESERVED_IDENTIFIER = "reserved-identifier";
    /// A type without a default precision.
    MISSING_PRECISION = "missing-precision";
    /// A fragment shader that writes to an output it does not declare.
    MISSING_OUTPUT = "missing-output";
    /// No `main`.
    MISSING_MAIN = "missing-main";
    /// `mainImage` without a `main` that calls it.
    UNWRAPPED_MAINIMAGE = "unwrapped-mainimage";
    /// `mainImage` or its kin with other parameters than the player's.
    MAINIMAGE_SIGNATURE = "mainimage-signature";
    /// Code of GLSL ES 1.00 in a shader of 3.00.
    LEGACY_GLSL = "legacy-glsl";
    /// A function without a `return`.
    MISSING_RETURN = "missing-return";
    /// A function that is called but never defined.
    UNDEFINED_FUNCTION = "undefined-function";
    /// A function that calls itself.
    RECURSION = "recursion";
    /// A declaration of a function that does not fit another one.
    FUNCTION_MISMATCH = "function-mismatch";
    /// A function declared inside a function.
    LOCAL_FUNCTION = "local-function";
    /// A parameter that cannot be declared so.
    INVALID_PARAMETER = "invalid-parameter";
    /// Qualifiers that cannot stand together or here.
    INVALID_QUALIFIER = "invalid-qualifier";
    /// A `layout(...)` that cannot stand here.
    INVALID_LAYOUT = "invalid-layout";
    /// Fragment outputs whose locations clash or are missing.
    OUTPUT_LOCATION = "output-location";
    /// An input or output of a type that cannot be one.
    INTERFACE_TYPE = "interface-type";
    /// An interface block that cannot be declared so.
    INTERFACE_BLOCK = "interface-block";
    /// A struct that cannot be declared so.
    INVALID_STRUCT = "invalid-struct";
    /// An array that cannot be declared so.
    INVALID_ARRAY = "invalid-array";
    /// `void` as the type of a value.
    VOID_VALUE = "void-value";
    /// A constant without a value, or with one that is not constant.
    NOT_CONSTANT = "not-constant";
    /// A sampler where none may stand.
    SAMPLER_RESTRICTION = "sampler-restriction";

    // Types.
    /// `int` and `float` mixed.
    INT_FLOAT_MIX = "int-float-mix";
    /// Vectors or matrices of sizes that do not fit.
    VECTOR_SIZE = "vector-size";
    /// Any other two types that do not fit.
    TYPE_MISMATCH = "type-mismatch";
    /// A condition that is no `bool`.
    CONDITION_TYPE = "condition-type";
    /// A constructor with arguments that do not fit.
    CONSTRUCTOR_ARGUMENTS = "constructor-arguments";
    /// A call that fits no overload.
    ARGUMENT_MISMATCH = "argument-mismatch";
    /// A call of something that is no function.
    NOT_A_FUNCTION = "not-a-function";
    /// A function or type used as a variable.
    NOT_A_VARIABLE = "not-a-variable";
    /// `return` of another type than the function's.
    RETURN_TYPE = "return-type";
    /// A component that the vector does not have.
    SWIZZLE_OUT_OF_RANGE = "swizzle-out-of-range";
    /// Letters that are no components.
    INVALID_SWIZZLE = "invalid-swizzle";
    /// A member that the struct does not have.
    NO_SUCH_FIELD = "no-such-field";
    /// `[...]` that does not fit.
    INVALID_INDEX = "invalid-index";
    /// An index outside the array, vector or matrix.
    INDEX_OUT_OF_RANGE = "index-out-of-range";
    /// An assignment to something that cannot be assigned to.
    NOT_ASSIGNABLE = "not-assignable";
    /// `length`, `mix` and their kin on integers.
    INTEGER_LENGTH = "integer-length";
    /// An operation that WebGL2 does not have for this type.
    UNSUPPORTED_OPERATION = "unsupported-operation";

    // Statements.
    /// A `switch` or its labels wrong.
    INVALID_SWITCH = "invalid-switch";
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
    NEEDS_WEBGL2 = "needs-webgl2";
    /// A loop or an index that WebGL1 does not allow.
    WEBGL1_RESTRICTION = "webgl1-restriction";
}
