//# An index after a comma is not constant in GLSL ES 3.00
//: accepted
uniform int i;
void main() { int a[2]; a[(0,7)]; }
//: accepted
uniform int i;
void main() { int a[2]; a[(i,7)]; }
//: accepted
uniform int i;
void main() { vec2 a; a[(0,7)]; }
//: accepted
uniform int i;
void main() { vec2 a; a[(7,0)]; }
//: accepted
uniform int i;
void main() { int a[2]; a[(0,1)+7]; }
//: refused 2 index-out-of-range, 100
uniform int i;
void main() { int a[2]; a[(0,7)]; }
//: refused 2 webgl1-restriction, 100
uniform int i;
void main() { int a[2]; a[(i,7)]; }
//: refused 2 index-out-of-range
uniform int i;
void main() { int a[2]; a[true?7:0]; }
//: accepted
uniform int i;
void main() { int a[2]; a[true?7:i]; }
//: accepted
uniform int i;
void main() { int a[2]; a[i>0?7:8]; }

//# An index after a comma that is out of range
//: refused 2 index-out-of-range
uniform int i;
void main() { int a[2]; a[(0,-1)]; }
//: refused 2 index-out-of-range
uniform int i;
void main() { int a[2]; a[(i,-1)]; }
//: refused 2 index-out-of-range
uniform int i;
void main() { int a[2]; a[(0,-1)]=1; }
//: accepted
uniform int i;
void main() { int a[2]; a[(0,7)]=1; }
//: refused 2 index-out-of-range
uniform int i;
void main() { vec2 a; a[(0,-1)]; }
//: refused 2 index-out-of-range
uniform int i;
void main() { vec2 a; a[(i++,-1)]; }
//: accepted
uniform int i;
void main() { mat2 a; a[(0,7)]; }
//: accepted
uniform int i;
void main() { mat2 a; a[(i,7)]; }
//: accepted
uniform int i;
void main() { mat2 a; a[0][(i,7)]; }
//: accepted
uniform vec4 u[2]; uniform int i;
void main() { u[(0,7)]; }
//: accepted
uniform vec4 u[2]; uniform int i;
void main() { u[(i,7)]; }
//: accepted
uniform B{vec4 u[2];}; uniform int i;
void main() { u[(i,7)]; }
//: accepted
uniform B{vec4 u[2];} b; uniform int i;
void main() { b.u[(i,7)]; }
//: refused 2 invalid-index
uniform B{vec4 u[2];} b[2]; uniform int i;
void main() { b[(0,7)].u[0]; }
//: refused 2 invalid-index
uniform sampler2D u[2]; uniform int i;
void main() { texture(u[(0,7)],vec2(0.)); }
//: accepted, vertex
in vec4 u; uniform int i;
void main() { u[(0,7)]; }
//: accepted, 100 vertex
uniform vec4 u[2]; uniform int i;
void main() { u[(i,7)]; }
//: accepted, 100 vertex
uniform vec4 u[2]; uniform int i;
void main() { u[(i,1)]; }
//: refused 2 index-out-of-range, 100 vertex
uniform vec4 u[2]; uniform int i;
void main() { u[(0,7)]; }
//: accepted, 100
uniform vec4 u[2];
void main() { for(int i=0;i<2;i++) u[(i,7)]; }
//: accepted, 100
uniform vec4 u[2];
void main() { for(int i=0;i<2;i++) u[(i,1)]; }
//: accepted, 100
void main() { vec4 u; for(int i=0;i<2;i++) u[(i,7)]; }
//: refused 1 index-out-of-range, 100
void main() { vec4 u; for(int i=0;i<2;i++) u[(i,-1)]; }
//: accepted
uniform int i;
void main() { const int c=7; int a[2]; a[(0,c)]; }
//: accepted
uniform int i;
void main() { int a[2]; a[((0,7))]; }
//: accepted
uniform int i;
void main() { int a[2]; a[(0,1,7)]; }
//: accepted
uniform int i;
void main() { int a[2]; a[0,7]; }
//: accepted
uniform int i;
void main() { int a[2]; a[i,7]; }
//: accepted
uniform int i;
void main() { const int a[2]=int[2](1,2); a[(0,7)]; }
//: accepted
uniform int i;
void main() { int[2](1,2)[(0,7)]; }
//: refused 2 index-out-of-range
uniform int i;
void main() { int a[2]; a[7u]; }
//: accepted
uniform int i;
void main() { int a[2]; a[(0u,7u)]; }

//# `,` and `?:` with a side without effects
//: accepted
struct S{float a[2];}; uniform S s;
void main() { float y[s.a.length()]; }
//: accepted
void main() { vec3 a,b; (1,a)=b; }
//: accepted
void main() { vec3 a,b; (b,a)=b; }
//: refused 1 not-assignable
void main() { vec3 a,b; (b++,a)=b; }
//: refused 1 not-assignable
void main() { vec3 a,b; (b=a,a)=b; }
//: refused 2 not-assignable
void f(){} int g(){return 1;}
void main() { vec3 a,b; (g(),a)=b; }
//: accepted
void main() { vec3 a,b; (b,a,b)=b; }
//: accepted
void main() { vec3 a,b; (b,a).x=1.; }
//: accepted
void main() { vec3 a,b; (b,a)[1]=1.; }
//: accepted
void main() { vec3 a,b; (b,a)++; }
//: accepted
void main() { vec3 a,b; (b,a)+=1.; }
//: refused 1 not-assignable
void main() { vec3 a,b; (b,a+b)+=1.; }
//: refused 2 not-assignable
uniform vec3 u;
void main() { vec3 a,b; (b,u)=a; }
//: accepted
uniform vec3 u;
void main() { vec3 a,b; (u,b)=a; }
//: accepted
void f(out vec3 x){x=vec3(1.);}
void main() { vec3 a,b; f((a,b)); }
//: accepted
void f(out vec3 x){x=vec3(1.);}
void main() { vec3 a,b; f(true?a:b); }
//: refused 2 not-assignable
uniform bool u;
void main() { vec3 a,b; (u?a:b)=a; }
//: accepted
void main() { vec3 a,b; (false?a:b)=a; }
//: accepted
const bool c=true;
void main() { vec3 a,b; (c?a:b)=a; }
//: refused 1 not-assignable
void main() { bool c=true; vec3 a,b; (c?a:b)=a; }
//: accepted
void main() { vec3 a,b; (true?a:b).x=1.; }
//: accepted
void main() { vec3 a,b; (true?a:b)++; }
//: refused 2 not-assignable
uniform vec3 u;
void main() { vec3 a,b; (true?u:b)=a; }
//: accepted
uniform vec3 u;
void main() { vec3 a,b; (false?u:b)=a; }
//: refused 1 not-assignable
void main() { vec3 a,b; (true?a+b:b)=a; }
//: accepted
void main() { vec3 a,b; (true?a:a+b)=a; }
//: accepted
void main() { int i; (true?i:i++)=1; }
//: refused 1 not-assignable
void main() { int i; (true?i++:i)=1; }
//: accepted
void main() { int i; (false?i++:i)=1; }
//: accepted
void main() { float a[3]; int i; a[true?5:i]; }
//: accepted
void main() { float a[3]; int i; a[true?5:i++]; }
//: refused 1 index-out-of-range
void main() { float a[3]; int i; a[(true?5:4)]; }
//: refused 1 not-constant
void main() { int i; float a[true?5:i]; }
//: refused 1 not-constant
void main() { int i; const int n=true?5:i; }
//: refused 1 not-constant
void main() { int i; switch(i){case true?5:i:break;} }
//: accepted
void main() { int i; bool b=true; while(true?true:b){} }
//: refused 1 infinite-loop
void main() { int i; bool b=true; while(true?b:false){} }
//: refused 1 infinite-loop
void main() { int i; bool b=true; while((1,b)){} }
//: accepted
void main() { int i; bool b=true; while((i++,b)){} }
//: accepted
void main() { int i; while((i,true)){} }
//: accepted
void main() { int i; for(;(i,true);){} }
//: accepted
void main() { bool b=(1,true); while(b){} }
//: refused 1 infinite-loop
void main() { bool b=true?true:false; while(b){} }
//: accepted
void main() { bool c; bool b=true?true:c; while(b){} }
//: refused 1 infinite-loop
void main() { int i; bool b=true; while(false?b:b){} }
//: accepted
void main() { bool b=true; while(true&&b){} }
//: accepted
void main() { bool b=true; while((b)){(1,b)=false;} }
//: accepted
void main() { bool b=true; while(b){(true?b:b)=false;} }
//: accepted, 100
void main() { vec3 a,b; (a,b)=a; }
//: accepted, 100
void main() { vec3 a,b; (true?a:b)=a; }
//: accepted, 100
void f(out vec3 x){x=vec3(1.);}
void main() { vec3 a,b; f((a,b)); }
//: accepted, 100
void main() { for(int i=0;(1,i)<2;i++){} }
//: accepted, 100
void main() { for(int i=0;i<2;(1,i)++){} }
//: accepted, 100
void main() { for(int i=0;(true?i:i)<2;i++){} }
//: refused 2 webgl1-restriction, 100
uniform int u;
void main() { for(int i=(u,0);i<2;i++){} }
//: accepted, 100
uniform int u;
void main() { for(int i=(1,0);i<2;i++){} }
//: refused 2 webgl1-restriction, 100
uniform int u;
void main() { for(int i=0;i<(u,2);i++){} }
//: refused 2 webgl1-restriction, 100
uniform int u;
void main() { for(int i=0;i<(true?2:u);i++){} }
//: refused 2 webgl1-restriction, 100
uniform int u;
void main() { for(int i=0;i<2;i+=(u,1)){} }
//: refused 2 not-constant, 100
uniform int u;
void main() { const int x=(u,1); }
//: refused 2 not-constant, 100
uniform int u;
void main() { const int x=true?1:u; }
//: refused 2 webgl1-restriction, 100
uniform int u;
void main() { float a[2]; a[(u,1)]; }
//: refused 2 webgl1-restriction, 100
uniform int u;
void main() { float a[2]; a[true?1:u]; }
//: refused 1 not-assignable
void main() { vec3 a; a.xx.x=1.; }
//: refused 1 not-assignable
void main() { vec3 a; a.xy.xx=vec2(1.); }
//: refused 1 not-assignable
void main() { vec3 a; a.xx.xy=vec2(1.); }
//: refused 1 not-assignable
void main() { vec3 a; a.xxy.z=1.; }
//: refused 1 not-assignable
void main() { vec3 a; a.xxy.yz=vec2(1.); }
//: accepted
void main() { vec3 a; a.xx[0]++; }
//: refused 1 not-assignable
void main() { vec3 a; a.xx++; }
//: accepted
void main() { vec3 a; a.xyx.xy[0]=1.; }
//: accepted
void f(out float x){x=1.;}
void main() { vec3 a; f(a.xx[0]); }
//: refused 2 not-assignable
void f(out float x){x=1.;}
void main() { vec3 a; f(a.xx.x); }
//: accepted, 100
void main() { vec3 a; a.xx[0]=1.; }
//: accepted
void main() { mat3 a; a[0].xx[1]=1.; }
//: refused 2 not-assignable
uniform vec3 u;
void main() { u.xx[0]=1.; }
//: accepted
struct S{vec2 v;};
void main() { S s; s.v.xx[0]=1.; }
//: refused 2 not-assignable
out vec4 o;
void main() { (o,o)[1]=1.; }
//: refused 3 invalid-index
out vec4 o;
uniform int i;
void main() { (1,o)[i]=1.; }
//: refused 3 not-assignable
out vec4 o;
uniform int i;
void main() { (true?o:o)[i]=1.; }
//: refused 2 unsupported-operation
struct S{float a[2];};
void main() { S s,t; (s,t); }
//: accepted
struct S{float a;};
void main() { S s,t; (s,t)=s; }
//: accepted
struct S{float a;};
void main() { S s,t; (s,t).a=1.; }
//: refused 2 unsupported-operation
struct S{float a;};
void main() { S s,t; (true?s:t).a=1.; }
//: accepted
uniform sampler2D s;
void main() { texture((1,s),vec2(0.)); }
//: accepted
uniform sampler2D s[2];
void main() { texture((1,s[1]),vec2(0.)); }
//: refused 2 unsupported-operation
uniform int i; uniform sampler2D s[2];
void main() { texture((1,s)[1],vec2(0.)); }
//: refused 2 unsupported-operation
uniform B{vec4 m;} b;
void main() { (1,b.m); (1,b).m; }
//: refused 2 not-assignable
in vec4 v;
void main() { (1,v)=v; }
//: refused 1 not-assignable
void main() { (1,gl_FragCoord)=vec4(1.); }
//: refused 1 not-assignable
void main() { const int c=1; int d; (d,c)=1; }
//: refused 1 not-assignable
void f(const int c){int d; (d,c)=1;}
//: refused 1 not-assignable
void f(sampler2D c){(1,c)=c;}

//# Of which variables
//: refused 2 not-assignable
vec3 g;
void main() { (1,g)=vec3(1.); }
//: refused 2 not-assignable
vec3 g;
void main() { (g,g)=vec3(1.); }
//: refused 2 not-assignable
vec3 g;
void main() { (true?g:g)=vec3(1.); }
//: refused 2 not-assignable
vec3 g;
void main() { vec3 a; (true?g:a)=vec3(1.); }
//: accepted
vec3 g;
void main() { vec3 a; (true?a:g)=vec3(1.); }
//: refused 1 not-assignable
void f(vec3 p){(1,p)=vec3(1.);}
//: refused 1 not-assignable
void f(out vec3 p){(1,p)=vec3(1.);}
//: refused 1 not-assignable
void f(inout vec3 p){(1,p)=vec3(1.);}
//: refused 1 not-assignable
void f(vec3 p){(true?p:p)=vec3(1.);}
//: refused 1 not-assignable
void f(out vec3 p){(true?p:p)=vec3(1.);}
//: refused 1 not-assignable, vertex
void main() { (1,gl_Position)=vec4(1.); }
//: refused 1 not-assignable, vertex
void main() { (true?gl_Position:gl_Position)=vec4(1.); }
//: refused 2 not-assignable, vertex
out vec4 v;
void main() { (1,v)=vec4(1.); }
//: refused 2 not-assignable, vertex
out vec4 v;
void main() { (true?v:v)=vec4(1.); }
//: refused 2 not-assignable
out vec4 o;
void main() { (1,o)=vec4(1.); }
//: refused 2 not-assignable
out vec4 o;
void main() { (true?o:o)=vec4(1.); }
//: refused 2 not-assignable
out vec4 o;
void main() { (1,o).x=1.; }
//: refused 2 not-assignable
vec3 g;
void main() { (1,g).x=1.; }
//: refused 2 not-assignable
vec3 g;
void main() { (1,g)[0]=1.; }
//: accepted
vec3 g[2];
void main() { (1,g[0])=vec3(1.); }
//: accepted
vec3 g[2];
void main() { (1,g[0].xy)=vec2(1.); }
//: accepted
void main() { vec3 a[2]; (1,a[0])=vec3(1.); }
//: accepted
void main() { vec3 a; (1,a.xy)=vec2(1.); }
//: refused 1 not-assignable
void main() { vec3 a; (1,a.xx)=vec2(1.); }
//: accepted
void main() { vec3 a; (true?a.xy:a.xy)=vec2(1.); }
//: accepted
vec3 g;
void main() { (true?g.xy:g.xy)=vec2(1.); }
//: accepted
struct S{vec3 a;};
void main() { S s; (1,s.a)=vec3(1.); }
//: accepted
struct S{vec3 a;}; S g;
void main() { (1,g.a)=vec3(1.); }
//: accepted
bool g=true;
void main() { while((1,g)){} }
//: accepted
bool g=true;
void main() { while(true?g:g){} }
//: refused 2 infinite-loop
bool g=true;
void main() { while(g){(1,g)=false;} }
//: accepted
uniform float u;
void main() { vec3 a; (sin(u),a)=vec3(1.); }
//: accepted
uniform sampler2D u;
void main() { vec3 a; (texture(u,vec2(0.)),a)=vec3(1.); }
//: accepted
void main() { vec3 a; (a+a,a)=vec3(1.); }
//: accepted
void main() { vec3 a; (vec3(a.x),a)=vec3(1.); }
//: accepted
void main() { vec3 a; ((1,a),a)=vec3(1.); }
//: accepted
void main() { vec3 a; (1,(1,a))=vec3(1.); }
//: accepted
void main() { vec3 a; (1,(true?a:a))=vec3(1.); }
//: accepted
void main() { vec3 a; (true?(1,a):a)=vec3(1.); }
//: refused 1 not-assignable
void main() { vec3 a; float m; (modf(1.,m),a)=vec3(1.); }
//: accepted
void main() { vec3 a; int i; (a[i],a)=vec3(1.); }
//: refused 1 not-assignable
void main() { vec3 a; int i; (a[i++],a)=vec3(1.); }
//: accepted
void main() { vec3 a; bool c; (c?a:a,a)=vec3(1.); }
//: accepted
void main() { vec3 a; bool c; (-a,a)=vec3(1.); }
//: accepted
void main() { vec3 a; bool c; (!c,a)=vec3(1.); }
//: accepted
void main() { vec3 a; float b[2]; (b.length(),a)=vec3(1.); }
//: accepted
void main() { vec3 a; float b[2]; (b[1],a)=vec3(1.); }
//: accepted
void main() { vec3 a; (1,2,a)=vec3(1.); }
//: refused 2 not-assignable
float f(){return 1.;}
void main() { vec3 a; (vec3(f()),a)=vec3(1.); }
//: refused 2 not-assignable, 100
vec3 g;
void main() { (1,g)=vec3(1.); }
//: refused 1 not-assignable, 100
void main() { (1,gl_FragColor)=vec4(1.); }
//: refused 2 not-assignable, 100 vertex
varying vec4 v;
void main() { (1,v)=vec4(1.); }

//# The left side of a comma is removed if it has no effects
//: refused 3 invalid-index
out vec4 o;
uniform int i;
void main() { float f=(1,o)[i]; }
//: accepted
out vec4 o;
uniform int i;
void main() { float f=(true?o:o)[i]; }
//: accepted
out vec4 o;
uniform int i;
void main() { float f=(false?o:o)[i]; }
//: refused 3 invalid-index
out vec4 o;
uniform int i;
void main() { float f=(1,1,o)[i]; }
//: refused 3 invalid-index
out vec4 o;
uniform int i;
void main() { float f=(i,(1,o))[i]; }
//: accepted
out vec4 o;
uniform int i;
void main() { float f=(i,o)[0]; }
//: accepted
const bool v=true;
void main() { while((1,v)){} }
//: accepted
const bool v=true;
void main() { while(v,v){} }
//: accepted
uniform vec2 u;
void main() { for(const bool v=bvec3(1.3)[1];(u,v);){} }
//: refused 2 infinite-loop
uniform vec2 u;
void main() { bool v=true; while((u,v)){} }
//: refused 1 infinite-loop
void main() { const bool v=true; while((v)){} }
//: accepted, 100 vertex
attribute vec2 a; vec2 g; vec2 h=(a,vec2(g));
//: accepted, 100 vertex
attribute vec2 a; uniform vec2 u; vec2 h=(a,u.xy);
//: accepted, 100 vertex
vec2 g; vec2 h=(mat2(gl_Position)[1],g+g);
//: refused 1 not-constant, 100 vertex
attribute vec2 a; vec2 g; vec2 h=(a,g);
//: refused 1 not-constant, 100 vertex
attribute vec2 a; vec2 h=(a,vec2(1.)+1.);
//: refused 1 not-constant, 100 vertex
attribute vec2 a; vec2 g; vec2 h=(g,vec2(a));
//: refused 1 not-constant, 100 vertex
attribute vec2 a; vec2 g; vec2 h=vec2((a,g));
