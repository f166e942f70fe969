//# Lengths
//: refused 1 invalid-array: an array without elements
float a[0];
//: refused 1 invalid-array: an array of a negative length
float a[-1];
//: refused 1 invalid-array: a length that is a float
float a[2.];
//: accepted: an unsigned length
float a[2u];
//: refused 1 invalid-array: a length that is a boolean
float a[true];
//: refused 1 not-constant: a length by a variable
int n = 2; float a[n];
//: accepted: a length by a constant
const int n = 2; float a[n];
//: refused 1 not-constant: a length by a uniform
uniform int n; float a[n];
//: accepted: a length by a built-in constant
float a[gl_MaxDrawBuffers];
//: accepted: a length by a built-in function of constants
float a[int(max(2., 3.))];
//: refused 1 not-constant: a length by a constant parameter
void f(const int n) { float a[n]; }
//: accepted: a length by another array's length
float a[2]; float b[a.length() + 1];
//: refused 1 invalid-array: neither a size nor an initial value
float a[];
//: accepted: no size, but an initial value
float a[] = float[](1., 2.);
//: refused 1 invalid-array, 100: no size in GLSL ES 1.00
float a[];
//: refused 1 needs-webgl2, 100: an array with a value in GLSL ES 1.00
float a[2] = float[2](1., 2.);
//: refused 1 type-mismatch: a value of another length
float a[2] = float[3](1., 2., 3.);
//: refused 1 constructor-arguments: a constructor of another length than its arguments
float a[2] = float[2](1., 2., 3.);
//: refused 1 type-mismatch: a constructor with the brackets after the name
float a[2] = float(1., 2.);
//: refused 1 invalid-array: arrays of arrays
float a[2][3];
//: refused 1 invalid-array: arrays of arrays by both notations
float[2] a[3];
//: accepted: arrays of arrays by a struct
struct S { float a[3]; }; S s[2];
//: accepted: an array of functions' results
float[2] f() { return float[2](1., 2.); }
void main() { float a = f()[1]; }
//: refused 1 invalid-array, 100: a function that gives an array in GLSL ES 1.00
float[2] f();
//: refused 1 syntax-error: brackets after a function name
float f()[2];
//: refused 2 no-such-field: length as a member, not as a method
float a[2];
void main() { int n = a.length; }
//: refused 2 not-a-function: the length of a vector
vec3 a;
void main() { int n = a.length(); }
//: refused 2 not-a-function: the length of a matrix
mat3 a;
void main() { int n = a.length(); }
//: refused 2 not-a-function: a method with another name
float a[2];
void main() { int n = a.size(); }
//: refused 2 needs-webgl2, 100: the length of an array in GLSL ES 1.00
float a[2];
void main() { int n = a.length(); }

//# Elements
//: accepted: the last element
float a[2];
void main() { a[1] = 1.; }
//: refused 2 index-out-of-range: one past the end
float a[2];
void main() { a[2] = 1.; }
//: refused 2 index-out-of-range: one before the first
float a[2];
void main() { a[-1] = 1.; }
//: refused 2 invalid-index: an index that is a float
float a[2];
void main() { a[1.] = 1.; }
//: refused 2 invalid-index: an index that is a boolean
float a[2];
void main() { a[true] = 1.; }
//: accepted: an unsigned index
float a[2];
void main() { a[1u] = 1.; }
//: refused 2 index-out-of-range: an index by an expression of constants, out of range
const int n = 1; float a[2];
void main() { a[n * 2] = 1.; }
//: accepted: an index by a variable, out of range
float a[2];
void main() { int n = 2; a[n] = 1.; }
//: refused 2 index-out-of-range: a component of a vector out of range
vec2 a;
void main() { a[2] = 1.; }
//: refused 2 index-out-of-range: a column of a matrix out of range
mat2x4 a;
void main() { a[2] = vec4(1.); }
//: accepted: a row of a column
mat2x4 a;
void main() { a[1][3] = 1.; }
//: accepted: an element of an expression
void main() { float a = float[2](1., 2.)[1]; }
//: refused 2 syntax-error: no index
float a[2];
void main() { a[] = 1.; }
//: refused 1 invalid-index: an element of a number
void main() { float a = 1.; a[0] = 1.; }
//: accepted: assignment of complete arrays
float a[2], b[2];
void main() { a = b; }
//: refused 2 type-mismatch: arrays of different lengths are not assigned
float a[2], b[3];
void main() { a = b; }
//: refused 2 needs-webgl2, 100: arrays are not assigned in GLSL ES 1.00
float a[2], b[2];
void main() { a = b; }
//: refused 2 needs-webgl2, 100: arrays are not compared in GLSL ES 1.00
float a[2], b[2];
void main() { bool c = a == b; }
//: refused 2 unsupported-operation, 100: structs that hold arrays are not assigned in GLSL ES 1.00
struct S { float a[2]; }; S s, t;
void main() { s = t; }
//: accepted: structs that hold arrays are assigned
struct S { float a[2]; }; S s, t;
void main() { s = t; }
//: refused 2 argument-mismatch: an array as a parameter of another length
void f(float a[2]) {} float b[3];
void main() { f(b); }
//: accepted: arrays choose overloads by their length
void f(float a[2]) {} void f(float a[3]) {} float b[3];
void main() { f(b); }
//: accepted: arrays of samplers by a constant expression
uniform sampler2D s[2]; const int n = 1;
void main() { texture(s[n], vec2(0.)); }
//: refused 2 invalid-index: arrays of samplers by a loop's counter
uniform sampler2D s[2];
void main() { for (int i = 0; i < 2; i++) texture(s[i], vec2(0.)); }
//: accepted, 100: arrays of samplers by a loop's counter in GLSL ES 1.00
uniform sampler2D s[2];
void main() { for (int i = 0; i < 2; i++) texture2D(s[i], vec2(0.)); }

//# Brackets on either side of the name
//: refused 1 invalid-array
void main() { int[2] a,b[2]; }
//: accepted
void main() { int[2] a,b; a=b; }
//: accepted
void main() { int a[2],b; b=a[0]; }
//: accepted
void main() { int[] a=int[](1,2), b=int[](1); b.length(); }
//: refused 1 invalid-array
void main() { int[] a=int[](1,2), b; }
//: accepted
void main() { int a[]=int[](1,2), b; b=1; }
//: accepted
const int[] a=int[](1,2);
void main() { float x[a.length()]; }
//: accepted
int[2] f(int[2] x){return x;}
void main() { f(int[](1,2)); }
//: accepted
int[2] f(int x[2]){return x;} int[2] f(int[2] x);
void main() { f(int[](1,2)); }
//: refused 1 invalid-array
int[] f(){return int[](1,2);}
//: refused 1 invalid-parameter
void f(int[] x){}
//: refused 1 invalid-parameter
void f(int x[]){}

//# What an array can do
//: accepted
void main() { float a[3]=float[3](1.,2.,3.); a=a; a==a; a!=a; }
//: refused 1 type-mismatch
void main() { float a[3]; a+a; }
//: refused 1 type-mismatch
void main() { float a[3]; a<a; }
//: refused 1 type-mismatch
void main() { float a[3]; -a; }
//: refused 1 type-mismatch
void main() { float a[3]; a++; }
//: refused 1 type-mismatch
void main() { float a[3]; !a; }
//: refused 1 no-such-field
void main() { float a[3]; a.x; }
//: refused 1 no-such-field
void main() { float a[3]; a.length; }
//: refused 1 not-a-function
void main() { float a[3]; a.length(1); }
//: refused 1 not-a-function
void main() { vec3 a; a.length(); }
//: refused 1 invalid-swizzle
void main() { float a; a.x; }
//: refused 1 invalid-index
void main() { float a; a[0]; }
