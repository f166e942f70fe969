//# Operand types of operators
//: refused 1 type-mismatch: the remainder of floats
float a = 5. % 2.;
//: refused 1 int-float-mix: a remainder of an int and an unsigned number
int a = 5 % 2u;
//: accepted: shifts take an int and an unsigned number
int a = 1 << 2u; uint b = 1u >> 2;
//: accepted: a shift of a vector by a number
ivec2 a = ivec2(1) << 2;
//: refused 1 vector-size: a shift of a number by a vector
ivec2 a = 1 << ivec2(2);
//: refused 1 type-mismatch: a mask of floats
float a = 1. & 2.;
//: refused 1 type-mismatch: a mask of booleans
bool a = true | false;
//: accepted: `^^` of booleans
bool a = true ^^ false;
//: refused 1 type-mismatch: `&&` of numbers
bool a = 1 && 2;
//: refused 1 type-mismatch: `!` of a number
bool a = !1;
//: refused 1 type-mismatch: `~` of a float
float a = ~1.;
//: refused 1 type-mismatch: `-` of a boolean
bool a = -true;
//: refused 1 type-mismatch: `+` before a boolean
bool a = +true;
//: accepted: `-` of an unsigned number
uint a = -1u;
//: refused 1 type-mismatch: two booleans are added
bool a = true + false;
//: refused 1 type-mismatch: vectors are not ordered
bool a = vec2(1.) < vec2(2.);
//: accepted: comparison of complete vectors
bool a = vec2(1.) == vec2(2.);
//: refused 1 vector-size: vectors of different sizes are compared
bool a = vec2(1.) == vec3(2.);
//: refused 1 int-float-mix: an int is compared with a float
bool a = 1 == 1.;
//: refused 1 int-float-mix: an int is compared with an unsigned number
bool a = 1 < 1u;
//: refused 1 type-mismatch: a comparison of a comparison
bool a = 1 < 2 < 3;
//: accepted: equality of a comparison and a boolean
bool a = 1 < 2 == true;
//: refused 1 type-mismatch: `&` binds looser than `==`
bool a = 1 & 1 == 1;
//: accepted: `&` in parentheses
bool a = (1 & 1) == 1;
//: accepted: a vector with a number
vec3 a = 1. + vec3(1.) * 2.;
//: refused 1 int-float-mix: a vector of ints with a float
vec3 a = ivec3(1) * 2.;
//: refused 1 vector-size: vectors of two sizes
vec3 a = vec3(1.) + vec2(1.);
//: accepted: a matrix and a vector of its columns' number
vec3 a = mat2x3(1.) * vec2(1.);
//: refused 1 vector-size: a matrix and a vector of its rows' number
vec3 a = mat2x3(1.) * vec3(1.);
//: accepted: a vector and a matrix of as many rows
vec2 a = vec3(1.) * mat2x3(1.);
//: accepted: matrices whose inner sizes fit
mat4x3 a = mat2x3(1.) * mat4x2(1.);
//: refused 1 vector-size: matrices whose inner sizes do not fit
mat4x3 a = mat4x3(1.) * mat4x3(1.);
//: accepted: a matrix divided by a matrix of its size
mat2x3 a = mat2x3(1.) / mat2x3(2.);
//: refused 1 vector-size: a matrix divided by a vector
mat2 a = mat2(1.) / vec2(1.);
//: accepted: a matrix plus a number
mat2 a = 1. + mat2(1.);
//: refused 1 int-float-mix: a matrix with an int
mat2 a = mat2(1.) * 2;
//: accepted: integers are divided by zero
int a = 1 / 0;
//: accepted: a remainder by zero
int a = 1 % 0;
//: accepted: floats are divided by zero
float a = 1. / 0.;
//: accepted: an int overflows
int a = 2147483647 + 1;
//: accepted: a shift by more than the width
int a = 1 << 33;
//: accepted: a shift by a negative number
int a = 1 << -1;

//# Assignments and counting
//: refused 1 not-assignable: a value is assigned to a number
void main() { 1 = 2; }
//: refused 2 not-assignable: a value is assigned to a sum
int a, b;
void main() { a + b = 2; }
//: accepted: a value is assigned in parentheses
int a;
void main() { (a) = 2; }
//: refused 2 not-assignable: a value is assigned to a call
int f() { return 1; }
void main() { f() = 2; }
//: refused 2 not-a-variable: a value is assigned to a function
int f() { return 1; }
void main() { f = 2; }
//: accepted: assignments go from right to left
int a, b;
void main() { a = b = 2; }
//: accepted: an assignment as a condition
bool a;
void main() { if (a = true) {} }
//: accepted: a compound assignment of a scalar to a vector
vec2 a;
void main() { a += 1.; a *= 2.; }
//: refused 2 vector-size: a compound assignment of a vector to a scalar
float a;
void main() { a += vec2(1.); }
//: refused 2 int-float-mix: a compound assignment of a float to an int
int a;
void main() { a += 1.; }
//: accepted: an int shifted by an unsigned amount
int a;
void main() { a <<= 1u; }
//: accepted: a vector multiplied by a matrix
vec2 a;
void main() { a *= mat2(1.); }
//: refused 2 vector-size: a vector multiplied by a matrix that changes its size
vec2 a;
void main() { a *= mat2x3(1.); }
//: accepted: a swizzle is counted up
vec3 a;
void main() { a.xy++; }
//: refused 2 not-assignable: a swizzle of one component twice is counted up
vec3 a;
void main() { a.xx++; }
//: refused 2 type-mismatch: a boolean is counted up
bool a;
void main() { a++; }
//: refused 2 type-mismatch: a struct is counted up
struct S { int a; }; S s;
void main() { s++; }
//: accepted: a matrix is counted up
mat2 a;
void main() { a++; }
//: refused 2 not-assignable: counting twice
int a;
void main() { a++++; }
//: refused 2 not-assignable: `++` before and after an operand
int a;
void main() { ++a++; }
//: accepted: a minus before counting down
int a;
void main() { int b = - --a; }
//: accepted: three minus signs
int a;
void main() { int b = a---a; }
//: accepted: `=+`
int a;
void main() { a =+ 1; }
//: refused 2 syntax-error: `=>`
int a, b;
void main() { bool c = a => b; }
//: refused 2 foreign-syntax: `<>`
int a, b;
void main() { bool c = a <> b; }
//: refused 1 syntax-error: an operator without its right side
int a = 1 +;
//: refused 1 foreign-syntax: a power by two stars
float a = 2. ** 3.;
//: refused 1 syntax-error: an address
int a; int b = &a;
//: refused 2 foreign-syntax: a member by an arrow
struct S { int a; }; S s;
void main() { int b = s->a; }
//: refused 1 foreign-syntax: a scope by two colons
int a = std::b;
//: refused 1 foreign-syntax: a cast in the way of C
float a = (float) 1;
//: refused 1 foreign-syntax: a cast in the way of C before a name
int a; void main() { float b = (float) a; }

//# Choices and commas
//: refused 1 condition-type: a choice by a number
int a = 1 ? 2 : 3;
//: refused 1 int-float-mix: a choice between two types
float a = true ? 1. : 2;
//: refused 1 unsupported-operation: a choice between arrays
float[2] f(bool c) { return c ? float[2](1., 2.) : float[2](3., 4.); }
//: refused 2 unsupported-operation: a choice between structs
struct S { int a; };
S f(bool c) { return c ? S(1) : S(2); }
//: refused 2 unsupported-operation: `?:` with void operands
void f() {}
void main() { true ? f() : f(); }
//: refused 1 condition-type: a choice by a vector
vec2 a = bvec2(true) ? vec2(1.) : vec2(2.);
//: refused 1 syntax-error: a choice without its second side
int a = true ? 1;
//: accepted: chained `?:`
int f(int a) { return a < 0 ? -1 : a > 0 ? 1 : 0; }
//: accepted: an assignment in both sides of a choice
int a, b;
void main() { true ? a = 1 : b = 1; }
//: accepted: an assignment in parentheses in both sides of a choice
int a, b;
void main() { true ? (a = 1) : (b = 1); }
//: accepted: a comma gives its right side
float f() { return (1, 2.); }
//: refused 1 int-float-mix: a comma gives its right side alone
int f() { return (1, 2.); }
//: refused 2 unsupported-operation: a comma with void operands
void f() {}
void main() { f(), 1; }
//: accepted: a comma at a global's value
int a = (1, 2);
//: refused 2 unsupported-operation: a comma of arrays
float a[2], b[2];
void main() { a, b; }

//# Operands that each operator accepts
//: refused 1 type-mismatch
void main() { bool a; a++; }
//: refused 1 type-mismatch
void main() { bvec2 a; !a; not(a); a==a; }
//: refused 1 type-mismatch
void main() { bvec2 a; a&&a; }
//: accepted
void main() { mat2 a; a++; ++a; -a; a--; }
//: refused 1 type-mismatch
void main() { mat2 a; a%a; }
//: accepted
void main() { mat2 a; a==a; a/a; a/1.; 1./a; a+1.; 1.-a; }
//: refused 1 vector-size
void main() { mat2 a; a+vec2(1.); }
//: accepted
void main() { mat2x3 a; a*=mat2(1.); }
//: refused 1 vector-size
void main() { mat2x3 a; a*=mat3(1.); }
//: accepted
void main() { mat2x3 a; vec3 b=a*vec2(1.); vec2 c=vec3(1.)*a; }
//: accepted
void main() { vec2 v; v*=mat2(1.); }
//: refused 1 vector-size
void main() { vec2 v; v*=mat2x3(1.); }
//: refused 1 vector-size
void main() { float v; v*=vec2(1.); }
//: accepted
void main() { vec2 v; v+=1.; v-=vec2(1.); v/=2.; }
//: accepted
void main() { mat2 v; v+=1.; v*=2.; v*=v; v/=v; }
//: refused 1 vector-size
void main() { mat2 v; v*=vec2(1.); }
//: accepted
void main() { int v; v<<=1u; v>>=1; v&=1; v|=1; v^=1; v%=2; }
//: refused 1 int-float-mix
void main() { int v; v&=1u; }
//: accepted
void main() { ivec2 v; v<<=1; v<<=ivec2(1); v<<=uvec2(1); }
//: refused 1 vector-size
void main() { ivec2 v; v<<=ivec3(1); }
//: refused 1 vector-size
void main() { int v; v<<ivec2(1); }
//: accepted
void main() { uint v=1u; v<<1; v<<1u; v&1u; ~v; -v; }
//: refused 1 int-float-mix
void main() { 1<<1u; 1u<<1; 1&1u; }
//: accepted
void main() { ivec2(1)&1; 1|ivec2(1); ivec2(1)%2; 2%ivec2(1); }
//: refused 1 vector-size
void main() { ivec2(1)&ivec3(1); }
//: refused 1 type-mismatch
void main() { true^^false; true&&1; }
//: refused 1 type-mismatch
void main() { true&true; }
//: accepted
void main() { 1<2==true; }
//: refused 1 type-mismatch
void main() { 1==1==1; }
//: refused 1 type-mismatch
void main() { vec2(1.)<vec2(2.); }
