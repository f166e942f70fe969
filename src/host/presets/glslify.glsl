// glslify
//
// glslify puts modules into a text and adds nothing else, so the version and the precision are the
// text's own. `#pragma glslify: name = require(module)` (the module's name may stand in quotes, and
// after it `, a=b`) declares `name`, which may be a function, a structure or a variable and whose
// type stands in the module; `#pragma glslify: require(module)` without a name puts the module's
// text there. A module ends with `#pragma glslify: export(name)`, and what it does not export is
// renamed, so it does not collide. With `, a=b` the module's undeclared name `a` becomes `b` of the
// text that requires it. Not declared here: the names of all these pragmas. A module is a part of a
// shader: it has no main(), and macros or constants that it uses may come from `a=b` or from the
// shader.
//
// source: glslify 7.1.1, README.md; glslify-deps and glslify-bundle, index.js
// package: glslify glslify-loader rollup-plugin-glslify vite-plugin-glslify
// version: own
// names: some
// entry: main
