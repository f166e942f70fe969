//# Names of components
//: accepted: colours and coordinates
vec4 a; vec3 f() { return a.rgb + a.xyz + a.stp; }
//: refused 1 invalid-swizzle: names of two sets
vec4 a; vec2 f() { return a.xg; }
//: refused 1 invalid-swizzle: `r` of a texture's coordinate is `p`
vec4 a; vec3 f() { return a.str; }
//: refused 1 invalid-swizzle: five components
vec4 a; void f() { a.xyzwx; }
//: accepted: components in any order and twice
vec4 a; vec4 f() { return a.wzxx; }
//: refused 1 swizzle-out-of-range: a component that there is not
vec2 a; float f() { return a.z; }
//: accepted: a swizzle of a swizzle has its own components
vec4 a; float f() { return a.zw.y; }
//: refused 1 swizzle-out-of-range: a component that a swizzle no longer has
vec4 a; float f() { return a.zw.z; }
//: refused 1 invalid-swizzle: a component in capitals
vec4 a; float f() { return a.X; }
//: refused 1 invalid-swizzle: a component of a number
float a; float f() { return a.x; }
//: refused 1 invalid-swizzle: a component of a matrix
mat2 a; float f() { return a.x; }
//: accepted: a component of a column
mat2 a; float f() { return a[0].x; }
//: accepted: a component of a call
vec2 g() { return vec2(1.); } float f() { return g().x; }
//: accepted: a component of a constructor
float a = vec2(1., 2.).y;
//: refused 1 vector-size: a component of a sum without parentheses
vec2 a; float f() { return a + a.x; }
//: accepted: a component of a sum in parentheses
vec2 a; float f() { return (a + a).x; }
//: refused 1 no-such-field: an unknown member
struct S { int a; }; S s; int f() { return s.b; }
//: refused 1 no-such-field: a component of a struct
struct S { vec2 a; }; S s; float f() { return s.x; }
//: refused 1 not-a-function: a method of a vector
vec2 a; float f() { return a.x(); }
//: refused 1 syntax-error: a number as a member
vec2 a; float f() { return a.0; }
//: refused 1 invalid-swizzle: a component of a component
vec2 a; float f() { return a.x.x; }

//# Components that are written
//: accepted: components in any order
vec4 a;
void main() { a.wx = vec2(1.); }
//: refused 2 not-assignable: a component twice
vec4 a;
void main() { a.xx = vec2(1.); }
//: accepted: a swizzle of a swizzle, by names of both sets
vec4 a;
void main() { a.xyzw.rgba = vec4(1.); }
//: refused 2 vector-size: fewer values than components
vec4 a;
void main() { a.xyz = vec2(1.); }
//: refused 2 vector-size: one value for two components
vec4 a;
void main() { a.xy = 1.; }
//: refused 2 not-assignable: a component of a call is written
vec2 f() { return vec2(1.); }
void main() { f().x = 1.; }
//: accepted: components are handed over to be written
void f(out vec2 a) { a = vec2(1.); } vec4 b;
void main() { f(b.zx); }
//: refused 2 not-assignable: a component twice is handed over to be written
void f(inout vec2 a) {} vec4 b;
void main() { f(b.zz); }
//: accepted: a component of an element of a member
struct S { vec4 a[2]; }; S s;
void main() { s.a[1].yz = vec2(1.); }

//# What may be picked and written
//: refused 1 not-assignable
void main() { vec3 a; a.xx=vec2(1.); }
//: accepted
void main() { vec3 a; a.xy.x=1.; }
//: accepted
void main() { vec3 a; a.xy.yx=vec2(1.); }
//: accepted
void main() { vec3 a; a.yx.xx; }
//: refused 1 invalid-swizzle
void main() { vec3 a; a.xxxxx; }
//: refused 1 invalid-swizzle
void main() { vec3 a; a.xg; }
//: refused 1 swizzle-out-of-range
void main() { vec3 a; a.w; }
//: accepted
void main() { vec3 a; (a.xy)[1]=1.; }
//: accepted
void main() { vec3 a; a.xy[1]=1.; }
//: accepted
void main() { vec3 a; a.xx[1]=1.; }
//: refused 1 index-out-of-range
void main() { vec3 a; a.xy[2]; }
//: accepted
void main() { vec3 a; (a)=vec3(1.); }
//: accepted
void main() { vec3 a; (a,a)=vec3(1.); }
//: accepted
void main() { vec3 a; (true?a:a)=vec3(1.); }
//: refused 1 not-assignable
void main() { vec3 a; a+a=vec3(1.); }
//: refused 1 not-assignable
void main() { vec3 a; ++a=vec3(1.); }
//: accepted
void main() { vec3 a; a=a=a; }
//: refused 1 not-assignable
void main() { vec3 a; (a=a)=a; }
//: accepted
void main() { vec3 a; (a=a).x; }
//: refused 1 not-assignable
void main() { vec3 a; (a=a).x=1.; }
//: refused 1 not-assignable
void main() { int a; a++ ++; }
//: refused 1 not-assignable
void main() { int a; ++ ++a; }
//: accepted
void main() { int a; -a++; }
//: accepted
void main() { int a; - - a; -(-a); + +a; }
