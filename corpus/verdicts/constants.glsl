//# Constant expressions and lengths
//: refused 1 not-constant
void main() { const float x=(1.,2.); }
//: accepted
const float x=1.; const float y=x; float z=y+x;
//: refused 1 not-constant
float x=1.; float z=x;
//: accepted
const int n=2; uniform vec4 u[n*2];
void main() { u[3]; u[n]; }
//: refused 2 index-out-of-range
const int n=2; uniform vec4 u[n*2];
void main() { u[n+2]; }
//: accepted
uniform vec4 u[int(2.5)];
void main() { u[1]; }
//: accepted
void main() { const int a[3]=int[](1,2,3); float b[a[2]]; b[2]; }
//: refused 1 index-out-of-range
void main() { const int a[3]=int[](1,2,3); float b[a[2]]; b[3]; }
//: refused 2 index-out-of-range
struct S{int n;}; const S s=S(3);
void main() { float b[s.n]; b[3]; }
//: refused 1 index-out-of-range
void main() { const ivec2 v=ivec2(2,3); float b[v.y]; b[3]; }
//: refused 1 index-out-of-range
void main() { const mat2 v=mat2(2); float b[int(v[0][0])]; b[2]; }
//: refused 1 index-out-of-range
void main() { float b[3]; const int n=b.length(); float c[n]; c[3]; }
//: refused 2 index-out-of-range
uniform vec4 u[5];
void main() { float c[u.length()]; c[5]; }
//: refused 1 index-out-of-range
void f(float x[3]){ float c[x.length()]; c[3]; }
//: accepted
float[3] f(){return float[3](1.,2.,3.);}
void main() { f().length(); }
//: refused 2 not-constant
float[3] f(){return float[3](1.,2.,3.);}
void main() { float y[f().length()]; }
//: accepted
void main() { float a[2]; float y[(a).length()]; }
//: refused 1 not-constant
void main() { float a[2], b[2]; float y[(a=b).length()]; }
//: accepted
struct S{float a[2];};
void main() { S s; float y[s.a.length()]; }
//: refused 2 not-constant
struct S{float a[2];}; S f(){S s;return s;}
void main() { float y[f().a.length()]; }
//: accepted
struct S{float a[2];};
void main() { S s[2]; int i=1; float y[s[i].a.length()]; }
//: refused 2 not-constant
struct S{float a[2];};
void main() { S s[2]; int i=1; float y[s[i++].a.length()]; }
//: accepted
void main() { float y[float[2](1.,2.).length()]; }
//: accepted
uniform float u;
void main() { float y[float[2](1.,u).length()]; }
//: refused 1 not-constant
void main() { switch(1){case (1,2): break;} }
//: refused 1 invalid-switch
void main() { switch(1){case 1+1: case 2: break;} }
//: accepted
void main() { const int n=1; switch(1){case n: break;} }
//: refused 1 not-constant
void f(const int n){switch(1){case n: break;}}
//: accepted
void main() { for(const int i=0;i<1;){float a[i+1];break;} }

//# Lengths of what has effects
//: refused 2 not-constant
float[3] f(){return float[3](1.,2.,3.);}
void main() { const int n=f().length(); float y[n]; }
//: refused 2 not-constant
float[3] f(){return float[3](1.,2.,3.);}
void main() { switch(1){case f().length():break;} }
//: refused 1 not-constant
float[3] f(){return float[3](1.,2.,3.);} const int n=f().length();
//: refused 1 not-constant
float[3] f(){return float[3](1.,2.,3.);} int n=f().length();
//: accepted
float[3] f(){return float[3](1.,2.,3.);}
void main() { while(f().length()==3){} }
//: refused 2 invalid-index
float[3] f(){return float[3](1.,2.,3.);} uniform sampler2D t[2];
void main() { texture(t[f().length()-3],vec2(0.)); }
//: refused 1 undeclared-name
void main() { float a[2],b[2]; const int n=(i,a).length(); }
//: refused 1 not-constant
void main() { int i; float a[2]; float y[float[2](1.,float(i++)).length()]; }
//: accepted
out vec4 o;
void main() { float y[float[2](1.,sin(o.x)).length()]; }
//: refused 2 not-constant
float f(){return 1.;}
void main() { float y[float[2](1.,f()).length()]; }
//: refused 1 not-constant
void main() { int i; float y[float[2](1.,float(i=2)).length()]; }
//: accepted
uniform sampler2D t;
void main() { float y[float[2](1.,texture(t,vec2(0.)).x).length()]; }
//: refused 2 not-constant
struct S{float a[2];};
void main() { S s[2]; int i; float y[s[i++].a.length()]; }
//: accepted
struct S{float a[2];};
void main() { S s[2]; int i; float y[s[i+1].a.length()]; }
//: accepted
struct S{float a[2];};
void main() { S s[2]; int i; float y[S(float[2](1.,float(i))).a.length()]; }
//: accepted
out vec4 o;
void main() { float y[float[2](1.,-o.x).length()]; }
//: accepted
out vec4 o;
void main() { float y[float[2](1.,o.x+o.y).length()]; }
//: accepted
out vec4 o;
void main() { float y[float[2](1.,o.x>1.?o.y:o.z).length()]; }
//: accepted
out vec4 o;
void main() { float y[float[2](1.,(o.x,o.y)).length()]; }
//: refused 2 not-constant
out vec4 o;
void main() { float m; float y[float[2](1.,modf(o.x,m)).length()]; }
