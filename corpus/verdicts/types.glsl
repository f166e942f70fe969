//# What a type may be used for
//: refused 1 void-value: a variable of type void
void a;
//: refused 1 void-value: an array of void
void f() { void a[2]; }
//: refused 1 reserved-word: a type of desktop GLSL
double a;
//: refused 1 reserved-word: a sampler of desktop GLSL's rectangles
uniform sampler2DRect s;
//: refused 1 vector-size: mat3x2 is not mat2x3
mat3x2 a = mat2x3(1.);
//: accepted: the square matrices have two names
mat2x2 a = mat2(1.); mat3 b = mat3x3(1.); mat4x4 c = mat4(1.);
//: refused 1 int-float-mix: an int does not become a float
float a = 1;
//: refused 1 int-float-mix: an int does not become an unsigned one
uint a = 1;
//: refused 1 int-float-mix: an unsigned number does not become an int
int a = 1u;
//: refused 1 condition-type: a number as a condition
void main() { if (1) {} }
//: refused 1 condition-type: a boolean vector as a condition
void main() { if (bvec2(true)) {} }
//: refused 1 vector-size: a float does not become a vector
vec2 a = 1.;
//: refused 1 int-float-mix: vectors of different scalar types
vec2 a = ivec2(1);
//: refused 1 unknown-type: a vector with one component
vec1 a;
//: refused 1 redefinition: a variable that is called like its type's struct
struct S { int a; } S;
//: refused 1 unknown-type: a struct that contains itself
struct S { S s; };
//: refused 1 unknown-type: a struct that contains an array of itself
struct S { S s[2]; };
//: refused 1 unknown-type: a struct that is used before it is declared
S a; struct S { int a; };
//: refused 1 invalid-struct: a struct without members
struct S {};
//: refused 1 invalid-struct: a struct of two members with one name
struct S { int a; float a; };
//: refused 1 foreign-syntax: a member with a value
struct S { int a = 1; };
//: refused 1 invalid-struct: a member that is constant
struct S { const int a; };
//: accepted: a member with a precision
struct S { lowp int a; };
//: refused 1 invalid-qualifier: a boolean member with a precision
struct S { lowp bool a; };
//: refused 1 void-value: a member of type void
struct S { void a; };
//: refused 1 invalid-struct: a member that declares a struct
struct S { struct T { int a; } t; };
//: accepted: a member whose struct is declared before
struct T { int a; }; struct S { T t; };
//: refused 1 unclosed-delimiter: a function within a struct
struct S { int f() { return 1; } };
//: refused 1 syntax-error: a member without a name
struct S { int; };
//: refused 1 invalid-array: an array without a length as a member
struct S { int a[]; };
//: refused 2 type-mismatch: two structs of the same members are two types
struct S { int a; }; struct T { int a; }; S s; 
void main() { T t; s = t; }
//: accepted: comparison of complete structs
struct S { int a; vec2 b; };
void main() { S s, t; bool b = s == t; }
//: refused 2 type-mismatch: structs are not ordered
struct S { int a; };
void main() { S s, t; bool b = s < t; }
//: refused 2 type-mismatch: structs are not added
struct S { float a; };
void main() { S s, t; s = s + t; }
//: refused 1 invalid-parameter: a struct without a name as a parameter
void f(struct { int a; } s) {}
//: refused 1 browser-limit: structs in structs five deep
struct A { int i; }; struct B { A i; }; struct C { B i; }; struct D { C i; }; struct E { D i; };

//# Opaque types
//: refused 1 sampler-restriction: a sampler that is not a uniform
sampler2D s;
//: refused 1 sampler-restriction: a sampler as a local variable
void main() { sampler2D s; }
//: refused 1 sampler-restriction: a sampler that is a constant
const sampler2D s;
//: refused 1 sampler-restriction: a sampler as an input
in sampler2D s;
//: accepted: a sampler as a parameter
void f(sampler2D s) {}
//: refused 1 invalid-parameter: a sampler as a parameter to be written
void f(out sampler2D s) {}
//: accepted: a sampler as a parameter that is called constant
void f(const sampler2D s) {}
//: refused 1 sampler-restriction: a function that gives a sampler
sampler2D f();
//: refused 2 not-assignable: a sampler is assigned to
uniform sampler2D s, t;
void main() { s = t; }
//: refused 2 sampler-restriction: two samplers are compared
uniform sampler2D s, t;
void main() { bool b = s == t; }
//: refused 2 unsupported-operation: a choice between samplers
uniform sampler2D s, t;
void main() { texture(true ? s : t, vec2(0.)); }
//: accepted: a struct with a sampler as a uniform
struct S { sampler2D s; }; uniform S s;
//: refused 2 sampler-restriction: a struct with a sampler as a local variable
struct S { sampler2D s; };
void main() { S s; }
//: refused 1 sampler-restriction: a struct with a sampler as a global
struct S { sampler2D s; }; S s;
//: refused 1 missing-precision: a sampler of three dimensions needs its precision
uniform sampler3D s;
//: accepted: a sampler of three dimensions with its precision
uniform highp sampler3D s;
//: accepted: the samplers that have a precision of their own
uniform sampler2D s; uniform samplerCube t;
//: refused 1 missing-precision: a sampler of shadows needs its precision
uniform sampler2DShadow s;
//: refused 1 missing-precision: a sampler of integers needs its precision
uniform isampler2D s;
//: refused 1 missing-precision: an array of two dimensions needs its precision
uniform sampler2DArray s;
//: accepted, vertex: a sampler of two dimensions in a vertex shader
uniform sampler2D s;
//: refused 1 missing-precision, vertex: a sampler of three dimensions in a vertex shader
uniform sampler3D s;
//: refused 1 reserved-word: an external sampler without its extension
uniform samplerExternalOES s;
//: refused 1 reserved-word, 100: a sampler of three dimensions in GLSL ES 1.00
uniform highp sampler3D s;
