//# Constants and values at the declaration
//: refused 1 not-constant: a constant without a value
const int a;
//: accepted: a constant of a constant
const int a = 1, b = a + 1;
//: refused 1 not-constant: a constant of a variable
int a; const int b = a;
//: refused 1 not-constant: a constant of a uniform
uniform int a; const int b = a;
//: accepted: a constant of a built-in function
const float a = sin(1.) + dot(vec2(1.), vec2(2.));
//: refused 1 not-constant: a constant of an own function
float f() { return 1.; } const float a = f();
//: refused 1 not-constant: a constant of a lookup
uniform sampler2D s; const vec4 a = texture(s, vec2(0.));
//: refused 1 not-constant: a constant of a derivative
const float a = dFdx(1.);
//: accepted: a constant of a component
const vec3 v = vec3(1., 2., 3.); const float a = v.y + v[2];
//: accepted: a constant of an element by a constant index
const int a[2] = int[2](1, 2); const int b = a[1];
//: accepted: a constant of a member
struct S { int a; }; const S s = S(1); const int b = s.a;
//: refused 1 not-constant: a local constant of a variable
void main() { int a = 1; const int b = a; }
//: refused 1 not-constant: a local constant of a parameter
void f(int a) { const int b = a; }
//: refused 1 not-constant: a local constant of a constant parameter
void f(const int a) { const int b = a; }
//: refused 2 not-assignable: a constant is written
const int a = 1;
void main() { a = 2; }
//: refused 2 not-assignable: a component of a constant is written
const vec2 a = vec2(1.);
void main() { a.x = 2.; }
//: refused 2 not-assignable: a constant is counted up
const int a = 1;
void main() { a++; }
//: refused 1 not-constant: a global of a global's value
int a = 1; int b = a;
//: accepted, 100: a global of a global's value in GLSL ES 1.00
int a = 1; int b = a;
//: refused 1 invalid-qualifier: a uniform with a value
uniform int a = 1;
//: refused 1 invalid-qualifier: an input with a value
in float a = 1.;
//: refused 1 initializer-list: a list of values in braces
float a[2] = { 1., 2. };
//: refused 1 initializer-list: a value in braces
void main() { int a = { 1 }; }
//: refused 1 undeclared-name: a variable in its own value
void main() { int a = a; }
//: accepted: the variable before it in the same declaration
void main() { int a = 1, b = a; }
//: refused 1 not-constant: constants beside a variable without a value
const int a = 1, b;

//# Inputs, outputs and uniforms
//: refused 1 invalid-qualifier: a local uniform
void main() { uniform int a; }
//: refused 1 invalid-qualifier: a local input
void main() { in int a; }
//: refused 1 invalid-qualifier: a local variable that is const and in
void main() { const in int a = 1; }
//: refused 2 not-assignable: a uniform is written
uniform vec4 a;
void main() { a.x = 1.; }
//: refused 2 not-assignable: an input is written
in vec4 a;
void main() { a = vec4(1.); }
//: refused 2 not-assignable: an input is handed over to be written
in vec4 a; void f(out vec4 b) { b = vec4(1.); }
void main() { f(a); }
//: refused 1 invalid-qualifier: an input that is inout
inout vec4 a;
//: refused 1 interface-type: an input of integers that is not flat
in ivec2 a;
//: accepted: an input of integers that is flat
flat in ivec2 a;
//: refused 1 interface-type, vertex: an output of integers that is not flat
out ivec2 a;
//: accepted, vertex: an output of integers that is flat
flat out ivec2 a;
//: accepted, vertex: an attribute of integers
in ivec2 a;
//: refused 1 interface-type: an input of booleans
flat in bvec2 a;
//: refused 1 interface-type, vertex: an attribute of booleans
in bool a;
//: accepted: a uniform of booleans
uniform bvec2 a;
//: accepted: an input of a struct
struct S { vec2 a; }; in S s;
//: refused 1 interface-type: an input of a struct with integers, not flat
struct S { int a; }; in S s;
//: accepted: an input of a struct with integers, flat
struct S { int a; }; flat in S s;
//: refused 1 interface-type: an input of a struct that holds an array
struct S { vec2 a[2]; }; in S s;
//: refused 1 interface-type: an input of a struct that holds a struct
struct T { vec2 a; }; struct S { T t; }; in S s;
//: refused 1 interface-type: an input of a struct that holds booleans
struct S { bool a; }; flat in S s;
//: accepted: an input of an array
in vec2 a[2];
//: refused 1 invalid-array: an input of an array of structs
struct S { vec2 a; }; in S s[2];
//: refused 1 invalid-array, vertex: an attribute of an array
in vec2 a[2];
//: refused 1 interface-type, vertex: an attribute of a struct
struct S { vec2 a; }; in S s;
//: accepted, vertex: an attribute of a matrix
in mat3 a;
//: refused 1 invalid-qualifier, vertex: an attribute that is flat
flat in vec2 a;
//: refused 1 invalid-qualifier, vertex: an attribute that is smooth
smooth in vec2 a;
//: refused 1 invalid-qualifier: an output that is flat
flat out vec4 a;
//: accepted: a smooth input of floats
smooth in vec2 a;
//: refused 1 invalid-qualifier: an input that is smooth and flat
smooth flat in vec2 a;
//: refused 1 invalid-qualifier: the words of an input in the other order
in smooth vec2 a;
//: accepted: centroid before in
centroid in vec2 a;
//: refused 1 invalid-qualifier: centroid after in
in centroid vec2 a;
//: accepted: flat and centroid
flat centroid in vec2 a;
//: refused 1 invalid-qualifier: centroid before flat
centroid flat in vec2 a;
//: refused 1 invalid-qualifier: centroid at a uniform
centroid uniform vec2 a;
//: refused 1 invalid-qualifier: centroid alone
centroid vec2 a;
//: refused 1 invalid-qualifier: flat alone
flat vec2 a;
//: refused 1 invalid-qualifier, vertex: an attribute with centroid
centroid in vec2 a;
//: refused 1 reserved-word: noperspective
noperspective in vec2 a;
//: refused 1 invalid-qualifier: in twice
in in vec2 a;
//: refused 1 invalid-qualifier: in and uniform
in uniform vec2 a;
//: refused 1 invalid-qualifier: const and uniform
const uniform int a = 1;
//: refused 1 invalid-qualifier: a precision before the storage
highp in vec2 a;
//: refused 1 invalid-qualifier: two precisions
in highp lowp vec2 a;
//: refused 1 legacy-glsl: varying in GLSL ES 3.00
varying vec2 a;
//: refused 1 legacy-glsl, vertex: attribute in GLSL ES 3.00
attribute vec2 a;
//: refused 1 needs-webgl2, 100: in in GLSL ES 1.00
in vec2 a;
//: refused 1 interface-type, 100: varying of integers
varying ivec2 a;
//: refused 2 not-assignable, 100: a varying is written by a fragment shader
varying vec2 a;
void main() { a = vec2(1.); }
//: accepted, 100 vertex: a varying is written by a vertex shader
varying vec2 a;
void main() { a = vec2(1.); }
//: refused 1 invalid-qualifier, 100: attribute in a fragment shader
attribute vec2 a;
//: refused 1 interface-type, 100 vertex: an attribute of integers
attribute ivec2 a;
//: refused 1 invalid-array, 100 vertex: an attribute of an array
attribute vec2 a[2];
//: refused 2 not-assignable, 100 vertex: an attribute is written
attribute vec2 a;
void main() { a = vec2(1.); }
//: refused 1 interface-type, 100: a varying of a struct
struct S { vec2 a; }; varying S s;
//: refused 1 redefinition: a uniform twice
uniform int a; uniform int a;
//: refused 1 interface-type: an output that is a matrix
out mat2 a;
//: refused 1 interface-type: an output of booleans
out bvec4 a;
//: accepted: an output of unsigned numbers
out highp uvec3 a;
//: refused 1 interface-type: an output of a struct
struct S { vec4 a; }; out S s;
//: accepted, vertex: an output of a struct
struct S { vec4 a; }; out S s;

//# Invariance
//: accepted, vertex: invariant at an output
invariant out vec4 a;
//: accepted, vertex: invariant of an output that is declared
out vec4 a; invariant a;
//: accepted, vertex: invariant of gl_Position
invariant gl_Position;
//: refused 1 invalid-qualifier, vertex: invariant of two names
invariant gl_Position, gl_PointSize;
//: refused 1 invalid-qualifier, vertex: invariant of an attribute
in vec4 a; invariant a;
//: refused 1 invalid-qualifier, vertex: invariant after out
out invariant vec4 a;
//: accepted, vertex: invariant before flat
invariant flat out vec4 a;
//: refused 1 invalid-qualifier, vertex: flat before invariant
flat invariant out vec4 a;
//: refused 1 invalid-qualifier, vertex: invariant of a global
vec4 a; invariant a;
//: refused 1 undeclared-name, vertex: invariant of what is not declared
invariant a;
//: refused 2 invalid-qualifier, vertex: invariant within a function
out vec4 a;
void main() { invariant a; }
//: refused 1 invalid-qualifier: invariant at an input
invariant in vec4 a;
//: accepted: invariant at an output of a fragment shader
invariant out vec4 a;
//: accepted, 100: invariant at a varying
invariant varying vec4 a;
//: accepted, 100: invariant of gl_FragCoord
invariant gl_FragCoord;
//: refused 1 invalid-qualifier: invariant of gl_FragCoord in GLSL ES 3.00
invariant gl_FragCoord;
//: refused 1 syntax-error, vertex: invariant with a number
invariant 1;
