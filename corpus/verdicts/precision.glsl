//# Default precisions
//: refused 2 missing-precision: a float in a fragment shader without a precision
#version 300 es
float a;
void main() {}
//: refused 2 missing-precision, 100: a float in a fragment shader of GLSL ES 1.00 without a precision
#version 100
float a;
void main() {}
//: accepted, vertex: a float in a vertex shader has a precision
#version 300 es
float a;
void main() {}
//: accepted: an int has a precision in a fragment shader
#version 300 es
int a;
void main() {}
//: accepted: a float with its own precision
#version 300 es
mediump float a;
void main() {}
//: refused 2 missing-precision: a constant without a precision
#version 300 es
const float a = 1.;
void main() {}
//: refused 2 missing-precision: an output without a precision
#version 300 es
out vec4 a;
void main() {}
//: accepted: an output of integers has a precision
#version 300 es
out ivec4 a;
void main() {}
//: accepted: a literal needs no precision
#version 300 es
out mediump vec4 a;
void main() { a = vec4(1. + 2.); }
//: accepted: a constructor needs no precision
#version 300 es
void main() { vec2(1.); }
//: refused 2 missing-precision: a parameter without a precision
#version 300 es
void f(float a) {}
void main() {}
//: refused 2 missing-precision: a return type without a precision
#version 300 es
float f();
void main() {}
//: accepted: a return type with a precision
#version 300 es
mediump float f() { return 1.; }
void main() {}
//: refused 2 missing-precision: a member without a precision
#version 300 es
struct S { vec2 a; };
void main() {}
//: refused 2 missing-precision: a precision that comes too late
#version 300 es
uniform float a;
precision highp float;
void main() {}
//: accepted: a precision within a function holds to its end
#version 300 es
void main() { precision highp float; float a; }
//: refused 3 missing-precision: a precision of one function does not hold in the next
#version 300 es
void f() { precision highp float; float a; }
void main() { float b; }
//: refused 2 missing-precision: a precision of a block ends with it
#version 300 es
void main() { { precision highp float; float a; } float b; }
//: refused 1 invalid-qualifier: the precision of floats is that of vectors and matrices
precision highp vec2;
//: refused 1 invalid-qualifier: the precision of unsigned numbers is that of ints
precision highp uint;
//: refused 1 invalid-qualifier: the precision of booleans
precision highp bool;
//: refused 1 invalid-qualifier: the precision of a struct
struct S { float a; }; precision highp S;
//: accepted: the precision of a sampler
precision lowp sampler2D; precision highp sampler3D;
uniform sampler3D a;
//: refused 1 invalid-qualifier: a precision of an array
precision highp float[2];
//: refused 1 syntax-error: a precision without a type
precision highp;
//: refused 1 syntax-error: a type without a precision
precision float;
//: accepted: a precision twice
precision highp float; precision lowp float;

//# Precisions of declarations
//: refused 1 invalid-qualifier: a boolean with a precision
highp bool a;
//: refused 1 invalid-qualifier: a vector of booleans with a precision
lowp bvec2 a;
//: refused 1 invalid-qualifier: `void` with a precision
highp void f() {}
//: refused 1 invalid-qualifier: a struct with a precision
struct S { float a; }; highp S a;
//: accepted: a parameter with a precision
void f(in lowp float a, highp vec2 b) {}
//: refused 1 syntax-error: a constructor with a precision
void main() { float a = highp float(1); }
//: accepted: a precision in the condition of a loop
void main() { for (highp int i = 0; i < 2; i++) {} }
//: refused 1 syntax-error: a precision after the type
float highp a;
//: accepted: a precision after const
const lowp float a = 1.;
//: refused 1 invalid-qualifier: a precision before const
lowp const float a = 1.;
//: refused 1 redefinition: overloads that differ in precision alone
void f(lowp float a) {} void f(highp float a) {}

//# Precisions of return values
//: refused 1 invalid-qualifier
highp highp int f(){return 1;}
//: refused 1 invalid-qualifier
highp mediump int f();
//: refused 1 invalid-qualifier, 100
highp int f(); highp highp int f(){return 1;}
//: accepted
highp int f(); mediump int f(){return 1;}
//: accepted, 100
highp int f(); int f(){return 1;}
