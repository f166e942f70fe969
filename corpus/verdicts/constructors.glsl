//# Vectors and matrices
//: accepted: a vector of a number
vec4 a = vec4(1);
//: accepted: a vector of numbers of several kinds
vec4 a = vec4(1, 2u, true, 4.);
//: refused 1 constructor-arguments: a vector of too few components
vec4 a = vec4(1., 2.);
//: accepted: a vector of a component too many in its last argument
vec4 a = vec4(vec3(1.), vec2(1.));
//: refused 1 constructor-arguments: a vector with an argument that is not used
vec2 a = vec2(vec2(1.), 1.);
//: accepted: a vector of a longer one
vec2 a = vec2(vec4(1.));
//: refused 1 constructor-arguments: a vector of a shorter one
vec4 a = vec4(vec2(1.));
//: refused 1 constructor-arguments: a vector without arguments
vec2 a = vec2();
//: accepted: a number of a vector
float a = float(vec3(1.));
//: accepted: a boolean of a float
bool a = bool(.5);
//: accepted: an unsigned number of a negative one
uint a = uint(-1);
//: accepted: an int of a matrix
int a = int(mat2(1.));
//: accepted: a matrix of a number
mat3 a = mat3(2);
//: accepted: a matrix of its columns
mat3 a = mat3(vec3(1.), vec3(2.), vec3(3.));
//: accepted: a matrix of pieces that cross its columns
mat2 a = mat2(1., vec2(2.), 3.);
//: accepted: a matrix of a larger one
mat2 a = mat2(mat4(1.));
//: refused 1 constructor-arguments: a matrix of a matrix and more
mat3 a = mat3(mat2(1.), vec3(1.), vec2(1.));
//: refused 1 constructor-arguments: a matrix of too few components
mat2 a = mat2(1., 2., 3.);
//: accepted: a matrix of too many components
mat2 a = mat2(vec3(1.), vec3(1.));
//: refused 1 constructor-arguments: a matrix of a component too many
mat2 a = mat2(1., 2., 3., 4., 5.);
//: accepted, 100: a matrix of a matrix in GLSL ES 1.00
mat2 a = mat2(mat3(1.));
//: refused 1 undeclared-name, 100: a matrix that is not square in GLSL ES 1.00
void main() { mat2x3(1.); }
//: refused 1 constructor-arguments: a vector of an array
float a[2]; vec2 f() { return vec2(a); }
//: refused 1 constructor-arguments: a vector of a struct
struct S { float a; }; S s; vec2 f() { return vec2(s); }
//: refused 2 void-value: a scalar of a void value
void f() {}
void main() { float a = float(f()); }
//: refused 2 not-a-variable: a number of a function
float f() { return 1.; }
void main() { float a = float(f); }

//# Structs and arrays
//: accepted: a struct of its members
struct S { int a; vec2 b; }; S s = S(1, vec2(2.));
//: refused 1 constructor-arguments: a struct of too few members
struct S { int a; vec2 b; }; S s = S(1);
//: refused 1 constructor-arguments: a struct of too many members
struct S { int a; }; S s = S(1, 2);
//: refused 1 int-float-mix: a struct whose members are not converted
struct S { float a; }; S s = S(1);
//: refused 1 constructor-arguments: a struct of the components of its vector
struct S { vec2 a; }; S s = S(1., 2.);
//: refused 1 constructor-arguments: a struct constructed from itself
struct S { int a; }; S s = S(1); S t = S(s);
//: accepted: a struct of an array
struct S { int a[2]; }; S s = S(int[2](1, 2));
//: refused 1 constructor-arguments: a struct without arguments
struct S { int a; }; S s = S();
//: refused 2 syntax-error: a struct without a name has no constructor
struct { int a; } s;
void main() { s = struct { int a; }(1); }
//: refused 1 int-float-mix: an array of what is not converted
float a[2] = float[2](1, 2);
//: refused 1 constructor-arguments: an array of the components of a vector
float a[2] = float[2](vec2(1.));
//: accepted: an array of structs
struct S { int a; }; S s[2] = S[2](S(1), S(2));
//: accepted: an array whose length is an expression
float a[2] = float[1 + 1](1., 2.);
//: refused 2 not-constant: an array whose length is a variable
int n = 2; 
void main() { float a[2] = float[n](1., 2.); }
//: refused 2 constructor-arguments: a constructor of samplers
uniform sampler2D s;
void main() { sampler2D(s); }
//: refused 1 syntax-error: a constructor without arguments
void main() { void(); }

//# The number of components that a constructor accepts
//: refused 1 constructor-arguments
void main() { vec2(vec3(1.)); vec3(vec2(1.),1); vec2(1.,2.,3.); }
//: refused 1 constructor-arguments
void main() { vec2(vec2(1.),1.); }
//: accepted
void main() { vec3(vec2(1.),vec2(1.)); }
//: accepted
void main() { vec3(1.,vec3(1.)); }
//: accepted
void main() { vec4(mat2(1.)); vec3(mat2(1.)); vec2(mat2(1.)); float(mat2(1.)); vec4(1.,mat2(1.)); }
//: refused 1 constructor-arguments
void main() { vec4(mat2(1.),1.); }
//: accepted
void main() { mat2(1.,2.,3.,4.); mat2(vec4(1.)); mat2(vec2(1.),vec2(1.)); mat2(vec3(1.),1.); }
//: refused 1 constructor-arguments
void main() { mat2(1.,2.,3.); }
//: refused 1 constructor-arguments
void main() { mat2(1.,2.,3.,4.,5.); }
//: accepted
void main() { mat2(mat3(1.)); mat3(mat2(1.)); mat2x3(mat3x2(1.)); }
//: refused 1 constructor-arguments
void main() { mat2(mat2(1.),1.); }
//: refused 1 constructor-arguments
void main() { mat2(1.,mat2(1.)); }
//: accepted
void main() { mat2(vec3(1.),vec3(1.)); }
//: accepted
void main() { mat2(true,1,2u,3.); mat2(ivec2(1),bvec2(true)); }
//: accepted
void main() { int(true); bool(1.); float(ivec2(1)); int(mat2(1.)); bool(vec2(1.)); uint(-1); }
//: refused 1 constructor-arguments
void main() { float(); }
//: refused 1 constructor-arguments
void main() { float(1.,2.); }
//: refused 1 constructor-arguments
void main() { int(float[1](1.)); }
//: refused 2 sampler-restriction
uniform sampler2D s;
void main() { int(s); }
//: refused 1 syntax-error
void main() { void(1); }
//: refused 1 constructor-arguments
void main() { float[2](1.); }
//: refused 1 int-float-mix
void main() { float[2](1.,2); }
//: refused 1 constructor-arguments
void main() { float[](); }
//: refused 1 constructor-arguments
void main() { float[0](); }
//: refused 1 constructor-arguments
void main() { float[2](vec2(1.)); }
//: refused 1 vector-size
void main() { vec2[2](vec2(1.),1.); }
