// glslify
//
// glslify inserts modules into a shader and adds nothing else, so the shader has its own version
// and precision.
//
// `#pragma glslify: name = require(module)` declares `name`, which may be a function, a structure
// or a variable and has its type in the module. The module name may be quoted, and `, a=b` may
// follow it. `#pragma glslify: require(module)` without a name inserts the module's text. With `,
// a=b`, the undeclared name `a` in the module becomes `b` of the requiring shader. A module ends
// with `#pragma glslify: export(name)`; names that it does not export are renamed to avoid
// collisions.
//
// Not declared here: the names of all these pragmas. A module is a shader fragment: it has no
// main(), and macros or constants that it uses may come from `a=b` or from the shader.
//
// source: glslify 7.1.1, README.md; glslify-deps and glslify-bundle, index.js
// package: glslify glslify-loader rollup-plugin-glslify vite-plugin-glslify
// version: own
// names: some
// entry: main
