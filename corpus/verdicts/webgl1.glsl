//# What GLSL ES 1.00 leaves out
//: refused 1 webgl1-restriction, 100: while
void main() { int i = 0; while (i < 2) { i++; } }
//: refused 1 webgl1-restriction, 100: do
void main() { int i = 0; do { i++; } while (i < 2); }
//: refused 1 webgl1-restriction, 100: a loop without a counter
void main() { for (;;) { break; } }
//: refused 1 webgl1-restriction, 100: a loop whose counter is declared before it
void main() { int i; for (i = 0; i < 2; i++) {} }
//: refused 2 webgl1-restriction, 100: a loop up to a uniform
uniform int n;
void main() { for (int i = 0; i < n; i++) {} }
//: accepted, 100: a loop up to a constant
const int n = 2;
void main() { for (int i = 0; i < n; i++) {} }
//: accepted, 100: a loop that counts by floats
void main() { for (float x = 0.; x < 1.; x += .25) {} }
//: refused 1 webgl1-restriction, 100: a loop that counts by a boolean
void main() { for (bool b = true; b; b = false) {} }
//: accepted, 100: a loop that counts down
void main() { for (int i = 2; i > 0; --i) {} }
//: accepted, 100: a loop that subtracts
void main() { for (int i = 8; i >= 0; i -= 2) {} }
//: refused 1 webgl1-restriction, 100: a loop whose counter is written in its body
void main() { for (int i = 0; i < 2; i++) { i = 1; } }
//: accepted, 100: a loop whose counter is handed over to be read
void f(int a) {}
void main() { for (int i = 0; i < 2; i++) { f(i); } }
//: refused 2 webgl1-restriction, 100: a loop whose counter is handed over to be written
void f(out int a) { a = 1; }
void main() { for (int i = 0; i < 2; i++) { f(i); } }
//: refused 1 webgl1-restriction, 100: a loop with two conditions
void main() { for (int i = 0; i < 2 && i < 3; i++) {} }
//: refused 1 webgl1-restriction, 100: a loop with its constant on the left
void main() { for (int i = 0; 2 > i; i++) {} }
//: refused 2 webgl1-restriction, 100: an array by a variable index in a fragment shader
uniform int n; float a[2];
void main() { a[n] = 1.; }
//: refused 2 webgl1-restriction, 100: a uniform array by a variable index in a fragment shader
uniform int n; uniform float a[2];
void main() { float b = a[n]; }
//: accepted, 100 vertex: a uniform array by a variable index in a vertex shader
uniform int n; uniform float a[2];
void main() { float b = a[n]; }
//: accepted, 100: an array by a loop's counter
float a[2];
void main() { for (int i = 0; i < 2; i++) a[i] = 1.; }
//: accepted, 100: an array by a sum of a loop's counter
float a[4];
void main() { for (int i = 0; i < 2; i++) a[2 * i + 1] = 1.; }
//: refused 2 webgl1-restriction, 100: an array by a local that holds a loop's counter
float a[2];
void main() { for (int i = 0; i < 2; i++) { int j = i; a[j] = 1.; } }
//: refused 2 webgl1-restriction, 100: an array by a function of a loop's counter
float a[2]; int f(int i) { return i; }
void main() { for (int i = 0; i < 2; i++) { a[f(i)] = 1.; } }
//: refused 2 webgl1-restriction, 100: a vector by a variable index
uniform int n; vec4 a;
void main() { a[n] = 1.; }
//: refused 1 unknown-type, 100: unsigned numbers
uint a;
//: refused 1 needs-webgl2, 100: shifts
int a = 1 << 2;
//: refused 1 needs-webgl2, 100: masks
int a = 1 & 2;
//: refused 1 needs-webgl2, 100: the remainder
int a = 5 % 2;
//: refused 1 needs-webgl2, 100: the remainder by an assignment
int a; void f() { a %= 2; }
//: refused 1 invalid-struct, 100: a structure within a structure
struct S { struct T { int a; } t; };
//: refused 1 needs-webgl2, 100: own outputs
out vec4 a;
//: refused 1 reserved-word, 100: switch
void main() { switch (1) { default: ; } }
//: refused 1 reserved-word, 100: a sampler of shadows
uniform sampler2DShadow s;
//: accepted, 100: a function with a parameter of its own array
void f(float a[2]) { a[0] = 1.; }
//: refused 0 recursion, 100: recursion
void f() { f(); }
void main() { f(); }
//: accepted, 100: a global of a uniform's value
uniform float u; float a = u;
//: refused 1 not-constant, 100: a global of a varying's value
varying float v; float a = v;
//: accepted, 100: a struct's constructor at a global
struct S { int a; }; S s = S(1);
//: accepted, 100: names of built-in functions of GLSL ES 3.00
float texelFetch, textureSize, isnan;
//: accepted, 100: precision of a sampler
precision lowp sampler2D;
//: accepted, 100: a comma of constants is constant
const int a = (1, 2);
//: accepted, 100: an array of a constant length by an expression
const int n = 1; float a[n + 1];

//# Components and elements of the built-in outputs by an index
//: accepted, 100
void main() { gl_FragColor[1]=1.; }
//: accepted, 100
void main() { gl_FragColor[0]=1.; }
//: refused 1 index-out-of-range, 100
void main() { gl_FragColor[4]=1.; }
//: refused 2 webgl1-restriction, 100
uniform int i;
void main() { gl_FragColor[i]=1.; }
//: accepted, 100
void main() { for(int i=0;i<4;i++) gl_FragColor[i]=1.; }
//: refused 1 index-out-of-range, 100
void main() { for(int i=0;i<1;i++) gl_FragData[i]=vec4(1.); }
//: accepted, 100
void main() { gl_FragData[0][1]=1.; }
//: refused 1 index-out-of-range, 100
void main() { gl_FragData[0][5]=1.; }
//: refused 2 webgl1-restriction, 100
uniform int i;
void main() { gl_FragData[0][i]=1.; }
//: refused 1 index-out-of-range, 100
void main() { gl_FragData[1][0]=1.; }
//: accepted, 100 vertex
void main() { gl_Position[1]=1.; }
//: refused 2 webgl1-restriction, 100 vertex
uniform int i;
void main() { gl_Position[i]=1.; }
//: refused 2 webgl1-restriction, 100 vertex
attribute vec4 a; uniform int i;
void main() { gl_Position=vec4(a[i]); }
//: refused 2 webgl1-restriction, 100
varying vec4 a; uniform int i;
void main() { gl_FragColor=vec4(a[i]); }
//: refused 3 unsupported-operation
out vec4 o;
struct S{sampler2D s;float a;}; uniform S x; uniform S y;
void main() { o=vec4(x==y); }
//: refused 3 unsupported-operation
out vec4 o;
struct S{sampler2D s;float a;}; uniform S x; uniform S y;
void main() { o=vec4(x!=y); }

//# What the value of a global may be computed from
//: refused 1 not-constant, 100
uniform sampler2D s; vec4 c=texture2D(s,vec2(0.));
void main() { gl_FragColor=c; }
//: refused 1 not-constant, 100 vertex
uniform sampler2D s; vec4 c=texture2D(s,vec2(0.));
void main() { gl_Position=c; }
//: accepted, 100
uniform float u; float c=sin(u);
void main() { gl_FragColor=vec4(c); }
//: accepted, 100
uniform float u; float c=u; float d=c;
void main() { gl_FragColor=vec4(c); }
//: refused 1 not-constant, 100
varying float u; float c=u;
void main() { gl_FragColor=vec4(c); }
//: refused 1 not-constant, 100
float f(){return 1.;} float c=f();
void main() { gl_FragColor=vec4(c); }
//: accepted, 100
uniform float u; float c=(u,1.);
void main() { gl_FragColor=vec4(c); }
//: accepted, 100
uniform float u; float c=u>1.?1.:2.;
void main() { gl_FragColor=vec4(c); }
//: refused 1 not-constant, 100
float u; float c=(u=1.);
void main() { gl_FragColor=vec4(c); }
//: refused 1 not-constant, 100
float u; float c=u++;
void main() { gl_FragColor=vec4(c); }
//: refused 1 not-constant, 100
vec4 c=gl_FragCoord;
void main() { gl_FragColor=vec4(c); }
//: accepted, 100
uniform vec4 u; float c=u[0];
void main() { gl_FragColor=vec4(c); }
//: refused 1 webgl1-restriction, 100
uniform vec4 u; uniform int i; float c=u[i];
void main() { gl_FragColor=vec4(c); }
//: accepted, 100
uniform vec4 u[2]; float c=u[0].x;
void main() { gl_FragColor=vec4(c); }
//: refused 1 not-constant, 100
float c=gl_DepthRange.near;
void main() { gl_FragColor=vec4(c); }
//: refused 1 not-constant, 100 vertex
attribute float u; float c=u;
//: accepted, 100
int c=gl_MaxDrawBuffers;
//: refused 1 not-constant, 100
uniform float u; const float c=u;
//: accepted, 100
uniform float u; vec2 c=vec2(u);
//: accepted, 100
uniform vec2 u; float c=dot(u,u);
//: accepted, 100
struct S{float a;}; uniform S s; float c=s.a;
//: accepted, 100
struct S{float a;}; uniform S s; S c=s;

//# Which loops GLSL ES 1.00 has
//: refused 1 infinite-loop, 100
void main() { for(int i=0;true;i++){} }
//: refused 1 webgl1-restriction, 100
void main() { for(int i=0;i<2;i++){ for(int j=0;j<i;j++){} } }
//: refused 1 webgl1-restriction, 100
void main() { for(int i=0;i<2;i++){ i+=1; } }
//: refused 2 webgl1-restriction, 100
void f(inout int x){}
void main() { for(int i=0;i<2;i++){ f(i); } }
//: accepted, 100
void f(int x){}
void main() { for(int i=0;i<2;i++){ f(i); } }
//: accepted, 100
void main() { for(int i=0;i<2;i--){ } }
//: accepted, 100
void main() { for(int i=0;i!=2;i++){ } }
//: accepted, 100
void main() { for(int i=0;i==2;i++){ } }
//: accepted, 100
void main() { for(int i=0;(i)<2;i++){ } }
//: accepted, 100
void main() { for(int i=0;i<2;(i)++){ } }
//: refused 1 webgl1-restriction, 100
void main() { for(int i=0;i<2;i++,i++){ } }
//: refused 1 webgl1-restriction, 100
void main() { for(const int i=0;i<2;){ } }
//: accepted, 100
void main() { for(int i=0;(i<2);(i++)){ } }
//: refused 1 webgl1-restriction, 100
void main() { for(int i=0,j=0;i<2;i++){ } }
//: refused 1 webgl1-restriction, 100
void main() { for(int i=0;i<2;i=i+1){ } }
//: refused 1 webgl1-restriction, 100
void main() { for(int i=0;i<2;i*=2){ } }
//: accepted, 100
void main() { for(int i=0;i<2;++i){ continue; } }
//: accepted, 100
void main() { for(float i=0.;i<2.;i+=.1){ break; } }
//: refused 1 redefinition, 100
void main() { for(int i=0;i<2;i++){ int i=0; i++; } }
//# Commas in sizes of arrays
//: refused 1 syntax-error, 100: of a global
float a[1, 2];
//: refused 1 syntax-error, 100: of a local
void main() { float a[1, 2]; }
//: refused 1 syntax-error, 100: of a parameter
void f(float a[1, 2]) { }
//: accepted, 100: in parentheses
void main() { float a[(1, 2)]; }
