//# A struct that the head of a function declares
//: accepted
out vec4 o;
struct S{float a;} f(){return S(1.);}
void main() { S s=f(); o=vec4(s.a); }
//: accepted, vertex
struct S{float a;} f(){return S(1.);}
void main() { S s=f(); gl_Position=vec4(s.a); }
//: accepted, 100
struct S{float a;} f(){return S(1.);}
void main() { S s=f(); gl_FragColor=vec4(s.a); }
//: accepted, 100 vertex
struct S{float a;} f(){return S(1.);}
void main() { S s=f(); gl_Position=vec4(s.a); }
//: accepted
out vec4 o;
struct S{float a;} f(); S f(){return S(1.);}
void main() { S s=f(); o=vec4(s.a); }
//: refused 1 function-mismatch
struct S{float a;} f(); struct S{float a;} f(){return S(1.);}
void main() { f(); }
//: accepted
struct S{float a;} f(S x){return x;}
//: refused 1 missing-return
struct {float a;} f(){}
//: accepted
struct {float a;} f();
//: refused 1 invalid-parameter
float g(struct S{float a;} x){return x.a;}
//: accepted
struct S{float a;} f();
void main() { S s; struct S{int b;} t; }
//: refused 1 invalid-qualifier
const struct S{float a;} f(){return S(1.);}
//: refused 1 invalid-qualifier
highp struct S{float a;} f(){return S(1.);}

//# Declarations of types only, structs in declarations
//: accepted
void main() { highp float; }
//: accepted
void main() { const float; }
//: accepted
void main() { float, a; }
//: refused 1 syntax-error
void main() { float a,; }
//: accepted
void main() { const struct S{int a;} s=S(1); float x[s.a]; }
//: accepted
struct S{int a;} s=S(1);
void main() { s.a; }
//: accepted
const struct S{int a;} s=S(1), t=S(2);
void main() { float x[t.a]; }
//: accepted
uniform struct S{int a;} s;
void main() { s.a; }
//: accepted
uniform struct S{int a;} s[2];
void main() { s[1].a; }
//: accepted
uniform struct {int a;} s;
void main() { s.a; }
//: accepted
struct {int a;} s;
void main() { s.a; }
//: accepted
struct {int a;} s,t;
void main() { s=t; }
//: accepted
void main() { struct {int a;} s,t; s=t; s==t; }
//: accepted
struct S{int a;};
void main() { {struct S{float a;}; S s=S(1.);} S t=S(1); }
//: refused 2 unknown-type
struct S{int a;};
void main() { {struct T{float a;}; } T t; }
//: refused 1 redefinition
struct S{int a;}; struct S{int a;};
//: refused 1 unknown-type
struct S{S a;};
//: accepted
struct S{int a;};
void main() { S S; }
//: accepted
struct S{int a, b[2], c;};
void main() { S s=S(1,int[2](1,2),3); }
//: accepted
struct S{int[2] a, b;};
void main() { S s=S(int[2](1,2),int[2](1,2)); }
//: refused 1 invalid-array
struct S{int[2] a[2];};

//# Qualifiers of an empty declaration
//: accepted
struct S{float a;}; uniform S;
//: accepted
struct S{float a;}; const S;
//: accepted
struct S{float a;}; in S;
//: accepted
out vec4 o;
struct S{float a;}; out S;
//: refused 1 invalid-qualifier
struct S{float a;}; highp S;
//: refused 1 invalid-qualifier
struct S{float a;}; flat S;
//: refused 1 undeclared-name
struct S{float a;}; invariant S;
//: accepted
struct S{float a;}; S;
//: accepted
struct S{float a;};
void main() { const S; }
//: refused 1 invalid-layout
struct S{float a;}; layout(location=0) uniform S;
//: accepted, vertex
struct S{float a;}; in S;
//: accepted, vertex
struct S{float a;}; flat out S;
//: refused 1 syntax-error
float g; uniform g;
//: accepted, 100
struct S{float a;}; uniform S;
//: accepted, 100
struct S{float a;}; varying S;
