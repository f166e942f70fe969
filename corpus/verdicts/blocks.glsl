//# The instance of a block is not a value
//: refused 2 interface-block
uniform B{float a;} b;
void main() { b; }
//: refused 2 unsupported-operation
uniform B{float a;} b;
void main() { b,1; }
//: refused 2 unsupported-operation
uniform B{float a;} b;
void main() { 1,b; }
//: refused 2 interface-block
uniform B{float a;} b[2];
void main() { b[0]; }
//: refused 2 interface-block
uniform B{float a;} b[2];
void main() { b; }
//: accepted
uniform B{float a;} b[2];
void main() { b.length(); }
//: refused 2 unsupported-operation
uniform B{float a;} b[2];
void main() { b[0],1; }
//: refused 2 interface-block
uniform B{float a;} b[2];
void main() { (b[0]); }
//: accepted
uniform B{float a;} b;
void main() { (b).a; }
//: refused 2 interface-block
uniform B{float a;} b;
void main() { for(b;true;){break;} }
//: accepted
uniform B{float a;} b;
void main() { for(;true;b){break;} }
//: refused 2 type-mismatch
uniform B{float a;} b;
void main() { b==b; }
//: refused 2 unsupported-operation
uniform B{float a;} b;
void main() { true?b:b; }
//: refused 2 unsupported-operation
uniform B{float a;} b;
void main() { (b,1); }
//: refused 2 interface-block, vertex
uniform B{float a;} b;
void main() { b; }
//: refused 2 invalid-index, vertex
uniform B{float a;} b[2]; uniform int i;
void main() { b[i].a; }
//: accepted, vertex
uniform B{float a;} b[2];
void main() { b[1].a; }
//: refused 2 index-out-of-range, vertex
uniform B{float a;} b[2];
void main() { b[2].a; }
//: refused 2 argument-mismatch
uniform B{float a;} b; void f(int x){}
void main() { f(b); }

//# Names and members of blocks, and their layout
//: refused 1 redefinition
uniform B{int a;}; int B;
//: refused 2 unknown-type
uniform B{int a;} b;
void main() { B x; }
//: accepted
uniform B{int a;} b;
void main() { int B; }
//: accepted
uniform B{int a;};
void main() { int a=a; }
//: refused 1 redefinition
uniform B{int a;}; uniform B{int c;};
//: refused 1 redefinition
uniform B{int a;}; uniform C{int a;};
//: accepted
uniform B{int a;} x; uniform C{int a;};
//: refused 2 not-assignable
uniform B{int a;};
void main() { a=1; }
//: refused 2 not-assignable
uniform B{int a;} x;
void main() { x.a=1; }
//: refused 1 invalid-array
uniform B{int a[];} x;
//: refused 1 invalid-struct
uniform B{struct S{int a;} s;} x;
//: refused 1 interface-block
uniform B{sampler2D s;} x;
//: accepted
uniform B{bool s;} x;
void main() { x.s; }
//: accepted
layout(std140) uniform B{layout(row_major) mat4 m; layout(column_major) mat3 n;};
//: accepted
layout(std140,row_major) uniform; uniform B{mat4 m;};
//: refused 1 invalid-layout
layout(row_major) uniform mat4 m;
//: refused 1 invalid-layout
layout(std140) uniform float m;
//: refused 1 invalid-layout
layout(binding=1) uniform B{mat4 m;};
//: refused 1 interface-block
layout(location=1) uniform B{mat4 m;};
//: refused 1 interface-block
uniform B{layout(std140) mat4 m;};
//: accepted
uniform B{layout(row_major) float m;};
//: refused 1 interface-block
uniform B{highp float m; uniform float n; const float k;};
//: refused 1 interface-block
uniform B{in float m;};
//: refused 1 interface-block
in B{float m;};
//: refused 1 interface-block, vertex
out B{float m;};
//: refused 1 syntax-error
B{float m;};
