//# Structs that hold samplers are neither compared nor constructed
//: refused 2 unsupported-operation, vertex
struct S{sampler2D s;float a;}; uniform S x; uniform S y;
void main() { gl_Position=vec4(x!=y); }
//: refused 2 unsupported-operation, 100
struct S{sampler2D s;float a;}; uniform S x; uniform S y;
void main() { gl_FragColor=vec4(x!=y); }
//: refused 3 unsupported-operation
out vec4 o;
struct S{sampler2D s;float a;}; struct T{S s;}; uniform T x; uniform T y;
void main() { o=vec4(x==y); }
//: refused 3 unsupported-operation
out vec4 o;
struct S{sampler2D s;float a;}; uniform S x[2]; uniform S y[2];
void main() { o=vec4(x==y); }
//: refused 2 sampler-restriction
struct S{sampler2D s;float a;}; uniform S x;
void main() { S[1](x); }
//: refused 2 sampler-restriction
struct S{sampler2D s;float a;}; uniform S x;
void main() { S[1](x).length(); }
//: refused 2 sampler-restriction
struct S{sampler2D s;float a;}; uniform S x;
void main() { S[](x,x)[0].a; }
//: refused 2 sampler-restriction
struct S{sampler2D s;float a;}; struct T{S s; float b;}; uniform S x;
void main() { T(x,1.); }
//: refused 2 sampler-restriction
struct S{sampler2D s;float a;}; uniform S x; uniform sampler2D t;
void main() { S(t,1.); }
//: refused 2 sampler-restriction
struct S{sampler2D s;float a;}; uniform S x; uniform sampler2D t;
void main() { S(t,1.).a; }
//: refused 2 sampler-restriction, 100
struct S{sampler2D s;float a;}; uniform S x; uniform sampler2D t;
void main() { S(t,1.); }
//: refused 2 sampler-restriction, 100
struct S{sampler2D s;float a;}; struct T{S s; float b;}; uniform S x;
void main() { T(x,1.); }
//: refused 2 unsupported-operation
struct S{sampler2D s;float a;}; uniform S x;
void main() { (1,x).a; }
//: refused 2 unsupported-operation
struct S{sampler2D s;float a;}; uniform S x;
void main() { float f = (x,x).a; }
//: accepted
struct S{sampler2D s;float a;}; uniform S x;
void main() { x,1; }
//: accepted
struct S{sampler2D s;float a;}; uniform S x;
void main() { 1,x; }
//: accepted
struct S{sampler2D s;float a;}; uniform S x;
void main() { x; }
//: accepted
struct S{sampler2D s;float a;}; uniform S x;
void main() { x.s; }
//: accepted
struct S{sampler2D s;float a;}; uniform S x;
void main() { x.s,1; }

//# Samplers and structs with samplers as statements, and after a comma
//: accepted
struct S{sampler2D s;float a;}; uniform S x;
void main() { 1,x.s; }
//: accepted
struct S{sampler2D s;float a;}; uniform S x;
void main() { texture((1,x.s),vec2(0.)); }
//: refused 2 unsupported-operation
struct S{sampler2D s;float a;}; uniform S x;
void main() { texture((1,x).s,vec2(0.)); }
//: accepted
uniform sampler2D x;
void main() { x; }
//: accepted
uniform sampler2D x;
void main() { x,1; }
//: accepted
uniform sampler2D x;
void main() { 1,x; }
//: accepted
uniform sampler2D x;
void main() { (1,x); }
//: accepted
uniform sampler2D x;
void main() { texture((1,x),vec2(0.)); }
//: accepted
uniform sampler2D x;
void main() { texture((x),vec2(0.)); }
//: accepted
uniform sampler2D x[2];
void main() { x; }
//: accepted
uniform sampler2D x[2];
void main() { x[0]; }
//: accepted
uniform sampler2D x[2];
void main() { x[0],1; }
//: refused 2 unsupported-operation, 100
struct S{sampler2D s;float a;}; uniform S x;
void main() { (1,x).a; }
//: accepted, 100
struct S{sampler2D s;float a;}; uniform S x;
void main() { texture2D((1,x.s),vec2(0.)); }
//: accepted, 100
struct S{sampler2D s;float a;}; uniform S x;
void main() { x; }
//: accepted, 100
uniform sampler2D x;
void main() { texture2D((1,x),vec2(0.)); }
//: accepted, 100
uniform sampler2D x;
void main() { x; }
//: refused 1 not-assignable
struct S{sampler2D s;float a;}; uniform S x; void f(S p){p.a=1.;}
//: refused 1 not-assignable
struct S{sampler2D s;float a;}; uniform S x; void f(S p){p=p;}

//# Parameters that hold a sampler are not written
//: refused 1 not-assignable
struct S{sampler2D s;float a;}; uniform S x; void f(S p){p.a++;}
//: refused 1 not-assignable
struct S{sampler2D s;float a;}; uniform S x; void g(out float q){q=1.;} void f(S p){g(p.a);}
//: accepted
struct S{sampler2D s;float a;}; uniform S x; void f(out S p){}
//: refused 1 not-assignable
struct S{sampler2D s;float a;}; uniform S x; void f(inout S p){p.a=1.;}
//: accepted
struct S{sampler2D s;float a;}; uniform S x; void f(inout S p){}
//: accepted
struct S{sampler2D s;float a;}; uniform S x; void f(const S p){}
void main() { f(x); }
//: refused 1 not-assignable, 100
struct S{sampler2D s;float a;}; uniform S x; void f(S p){p.a=1.;}
//: accepted, 100
struct S{sampler2D s;float a;}; uniform S x; void f(out S p){}
//: refused 1 not-assignable, 100
struct S{sampler2D s;float a;}; uniform S x; void f(inout S p){p.a=1.;}
//: refused 1 not-assignable
struct S{sampler2D s;float a;}; void f(S p[2]){p[0].a=1.;}
//: refused 1 not-assignable
struct S{sampler2D s;float a;}; struct T{S s[2];}; void f(T p){p.s[0].a=1.;}
//: accepted
struct S{sampler2D s;float a;}; void f(S p[2]){}

//# Which samplers of an array an index may choose
//: accepted
struct S{sampler2D s;float a;}; uniform S x[2]; uniform int i;
void main() { x[i].a; }
//: accepted
struct S{sampler2D s;float a;}; uniform S x[2]; uniform int i;
void main() { texture(x[i].s,vec2(0.)); }
//: refused 2 invalid-index
struct S{sampler2D s[2];float a;}; uniform S x; uniform int i;
void main() { texture(x.s[i],vec2(0.)); }
//: accepted
struct S{sampler2D s[2];float a;}; uniform S x; uniform int i;
void main() { texture(x.s[1],vec2(0.)); }
//: accepted
struct S{sampler2D s[2];float a;}; uniform S x[2]; uniform int i;
void main() { texture(x[i].s[1],vec2(0.)); }
//: accepted, 100
struct S{sampler2D s;float a;}; uniform S x[2];
void main() { for(int i=0;i<2;i++) gl_FragColor=texture2D(x[i].s,vec2(0.)); }
//: accepted, 100 vertex
struct S{sampler2D s;float a;}; uniform S x[2]; uniform int i;
void main() { gl_Position=texture2D(x[i].s,vec2(0.)); }
//: accepted, 100 vertex
uniform sampler2D x[2]; uniform int i;
void main() { gl_Position=texture2D(x[i],vec2(0.)); }
//: refused 2 webgl1-restriction, 100
uniform sampler2D x[2]; uniform int i;
void main() { gl_FragColor=texture2D(x[i],vec2(0.)); }
//: accepted, 100
uniform sampler2D x[2];
void main() { for(int i=0;i<2;i++) gl_FragColor=texture2D(x[i],vec2(0.)); }

//# Parameters that hold a sampler are not passed on to be written
//: refused 1 not-assignable
struct S{sampler2D s;float a;}; void h(inout S q){} void f(S p){h(p);}
//: refused 1 not-assignable
struct S{sampler2D s;float a;}; void h(inout float q){} void f(S p){h(p.a);}
//: refused 1 not-assignable
struct S{sampler2D s;vec2 a;}; void f(S p){p.a.x=1.;}
//: refused 1 not-assignable
struct S{sampler2D s;vec2 a;}; struct T{S s;vec2 b;}; void f(T p){p.b.x=1.;}
//: accepted
struct S{sampler2D s;vec2 a;}; struct T{S s;vec2 b;}; void f(T p){float b=p.b.x;}
//: refused 1 not-assignable
struct S{sampler2D s;vec2 a;}; void f(out S p){p.a=vec2(1.);}
