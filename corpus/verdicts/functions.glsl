//# Declarations
//: refused 1 use-before-declaration: a call before the function
void main() { f(); } void f() {}
//: accepted: a prototype before the call
void f(); void main() { f(); } void f() {}
//: accepted: a prototype without its function, never called
void f(); 
//: refused 0 undefined-function: a prototype without its function, called
void f(); void main() { f(); }
//: refused 0 undefined-function: a prototype without its function, called by what nobody calls
void f(); void g() { f(); }
//: refused 1 local-function: a function within a function
void main() { void f() {} }
//: refused 1 local-function: a prototype within a function
void main() { void f(); }
//: refused 1 local-function, 100: a prototype within a function of GLSL ES 1.00
void main() { void f(); }
//: refused 0 recursion: a function that calls itself
int f(int a) { return a > 0 ? f(a - 1) : 0; }
void main() { f(1); }
//: refused 0 recursion: a function that calls itself and is never called
int f(int a) { return f(a); }
//: refused 0 recursion: two functions that call each other
void g(); void f() { g(); } void g() { f(); }
void main() { f(); }
//: accepted: overloads that call each other are not recursive
float f(vec2 a) { return a.x; } float f(vec3 a) { return f(a.xy); }
void main() { f(vec3(1.)); }
//: refused 1 function-mismatch: overloads that differ in their result alone
int f() { return 1; } float f() { return 1.; }
//: refused 1 function-mismatch: overloads that differ in `out` alone
void f(int a) {} void f(out int a) {}
//: refused 1 function-mismatch: a prototype that differs in `const` alone
void f(const int a); void f(int a) {}
//: refused 1 redefinition: two parameters of one name
void f(int a, float a) {}
//: refused 1 foreign-syntax: a parameter with a value
void f(int a = 1) {}
//: accepted: a parameter without a name
int f(int, float) { return 1; }
//: refused 1 invalid-parameter: a parameter that is const and out
void f(const out int a) {}
//: refused 1 invalid-parameter: a parameter that is in and out
void f(in out int a) {}
//: refused 1 invalid-parameter: a parameter that is uniform
void f(uniform int a) {}
//: refused 1 not-assignable: a parameter that is constant is written
void f(const int a) { a = 1; }
//: accepted: a parameter that is not constant is written
void f(int a) { a = 1; }
//: refused 1 syntax-error: a trailing comma in a list of parameters
void f(int a,) {}
//: refused 1 syntax-error: a parameter without a type
void f(a) {}
//: refused 1 syntax-error: a function without a result's type
f() {}
//: refused 1 invalid-qualifier: a function that gives a constant
const int f() { return 1; }
//: refused 1 redefinition: a function called like a variable
int f; void f() {}
//: refused 1 redefinition: a variable called like a function
void f() {} int f;
//: refused 1 redefinition: a function called like a struct
struct f { int a; }; void f(int a) {}
//: accepted: a local variable called like a function that it calls
float f() { return 1.; }
void main() { float f = f(); }
//: refused 0 missing-main: main is declared but not defined
void main();
//: accepted: main with `void` for its parameters
void main(void) {}
//: refused 1 function-mismatch: main with a parameter
void main(int a) {}
//: refused 1 function-mismatch: main with a result
int main() { return 1; }
//: refused 1 redefinition: main twice
void main() {} void main() {}
//: accepted: main is called
void f();
void main() {} void f() { main(); }
//: refused 0 missing-main: a variable called main
int main;
//: refused 1 stray-semicolon: a semicolon after a function
void f() {};
//: refused 1 stray-semicolon: a semicolon alone between declarations
int a;; int b;

//# Results
//: refused 1 missing-return: a function that ends without returning a value
int f() {}
//: accepted: a result in one branch alone
int f(bool a) { if (a) return 1; }
//: refused 1 int-float-mix: a result of another type
float f() { return 1; }
//: refused 1 return-type: a value returned from a void function
void f() { return 1; }
//: refused 1 return-type: a void value returned from a void function
void g() {} void f() { return g(); }
//: refused 1 return-type: `return` without a value
int f() { return; }
//: refused 1 missing-return: `discard` instead of a value
int f() { discard; }
//: refused 1 misplaced-jump, vertex: discard in a vertex shader
void main() { discard; }
//: accepted: statements after `return`
int f() { return 1; int a; }
//: accepted: return within a loop
int f() { for (int i = 0; i < 2; i++) { return i; } }

//# Calls
//: refused 2 argument-mismatch: too few arguments
void f(int a) {}
void main() { f(); }
//: refused 2 argument-mismatch: too many arguments
void f(int a) {}
void main() { f(1, 2); }
//: refused 2 int-float-mix: an argument that would have to be converted
void f(float a) {}
void main() { f(1); }
//: accepted: an overload for each of two arguments
void f(float a, int b) {} void f(int a, float b) {}
void main() { f(1, 1.); f(1., 1); }
//: refused 2 not-assignable: an expression where a variable is written
void f(out int a) { a = 1; } int b;
void main() { f(b + 1); }
//: refused 2 not-assignable: a constant where a variable is written
void f(out int a) { a = 1; }
void main() { f(1); }
//: refused 2 not-assignable: a uniform where a variable is written
void f(inout float a) {} uniform float b;
void main() { f(b); }
//: refused 2 not-assignable: a constant variable where a variable is written
void f(inout float a) {} const float b = 1.;
void main() { f(b); }
//: accepted: an element where a variable is written
void f(out int a) { a = 1; } int b[2]; uniform int i;
void main() { f(b[i]); }
//: refused 1 undeclared-name: a call of what is not declared
void main() { f(1); }
//: refused 2 not-a-function: a call of a variable
int f;
void main() { f(); }
//: refused 2 void-value: a void value as an argument
void f(int a) {} void g() {}
void main() { f(g()); }
//: refused 2 void-value: a void value as a value
void f() {} int a;
void main() { a = f(); }
//: refused 2 not-a-variable: a statement of a function's name
void f() {}
void main() { f; }
//: refused 2 syntax-error: a trailing comma in a list of arguments
void f(int a) {}
void main() { f(1,); }
//: accepted: `void` as an argument
void f() {}
void main() { f(void); }
//: refused 1 builtin-redefinition: an own function with a built-in one's name and other parameters
float sin(vec2 a, int b) { return 1.; }
//: refused 1 builtin-redefinition: an own function in the place of a built-in one
float abs(float a) { return a; }
//: accepted, 100: an own overload of a built-in function in GLSL ES 1.00
float sin(vec2 a, int b) { return 1.; }
//: refused 1 builtin-redefinition, 100: an own function in the place of a built-in one in GLSL ES 1.00
float abs(float a) { return a; }
//: accepted: a local variable hides a built-in function
void main() { float sin = sin(1.); }
//: accepted: the function of a built-in name that GLSL ES 1.00 had
vec4 texture2D(sampler2D s, vec2 p) { return texture(s, p); }

//# Parameters, prototypes, `main`, returns and overloads
//: accepted
void f(int){}
void main() { f(1); }
//: accepted
void f(void){}
void main() { f(); }
//: accepted
void f(void){}
void main() { f(void); }
//: refused 1 void-value
void f(void v){}
//: refused 1 void-value
void f(int,void){}
//: accepted
void f(const in int x){}
void main() { f(1); }
//: refused 1 invalid-parameter
void f(in const int x){}
void main() { f(1); }
//: accepted
void f(in highp int x){}
void main() { f(1); }
//: refused 1 invalid-qualifier
void f(highp in int x){}
void main() { f(1); }
//: refused 1 function-mismatch
void f(inout int x,int y); void f(int x,int y){}
//: accepted
void f(in int x); void f(int x){}
//: refused 1 function-mismatch
void f(const int x); void f(int x){}
//: refused 1 function-mismatch
int f(int x); float f(int x){return 1.;}
//: accepted
highp int f(int x); lowp int f(int x){return 1;}
void main() { f(1); }
//: accepted
void f(highp int x); void f(lowp int x){}
void main() { f(1); }
//: accepted
void f(int x); void f(int x); void f(int x){}
void main() { f(1); }
//: accepted
void f(int x){} void f(int x);
void main() { f(1); }
//: refused 1 function-mismatch
void main(int x){}
//: refused 1 function-mismatch
void main(){} void main(int x){}
//: refused 1 not-a-variable
void main(){ main; }
//: refused 2 not-a-variable
void f(){}
void main() { f+1; }
//: refused 2 syntax-error
void f(){}
void main() { (f)(); }
//: refused 2 syntax-error
void f(){}
void main() { f()(); }
//: refused 2 unsupported-operation
void f(){}
void main() { f(),f(); }
//: refused 2 void-value
void f(){}
void main() { f()==f(); }
//: refused 2 return-type
void f(){}
void main() { return f(); }
//: refused 1 return-type
void f(){return;} void g(){return f();}
//: refused 1 int-float-mix
float f(){return 1.; return 2;}
//: refused 1 return-type
float f(){return;}
//: refused 1 missing-return
float f(){discard;}
//: refused 1 missing-return
float f(){while(true){}}
//: accepted
float f(){for(;;){return 1.;}}
//: accepted
float f(){if(false)return 1.;}
//: refused 2 int-float-mix
float f(float x){return x;} float f(int x){return 1.;}
void main() { f(1u); }
//: accepted
float f(float x){return x;} float f(vec2 x){return 1.;}
void main() { f(vec2(1.)); f(1.); }
//: refused 1 builtin-redefinition
float sin(float x){return x;}
//: accepted
float mix(float x){return x;}
void main() { mix(1.); mix(1.,2.,3.); }
//: accepted
int sin;
void main() { sin=1; }
//: refused 1 not-a-function
void main() { int sin=1; sin(1.); }
//: accepted
struct sin{int a;};
//: accepted
struct mix{int a;};
//: accepted
uniform sin{int a;};
//: accepted
void main() { struct sin{int a;}; }
//: accepted
void main() { struct sin{int a;}; sin(1); }
//: accepted
void f(int sin){sin+1;}
//: refused 1 not-a-function
void f(int sin){sin(1.);}
//: accepted, 100
struct sin{int a;};
//: accepted, 100
float sin(int x){return 1.;}
void main() { sin(1); sin(1.); }
//: refused 1 builtin-redefinition, 100
float sin(float x){return 1.;}
//: accepted, 100
int sin;
void main() { sin=1; }
//: accepted, 100
void main() { int sin; }
//: refused 1 function-mismatch, 100
void f(int x); void f(int x);
//: accepted, 100
void f(int x){} void f(int x);
void main() { f(1); }
//: refused 1 redefinition, 100
void f(){ } void f(){ }
//# Arrays without a size that are returned
//: accepted: a prototype
mat3[] f();
//: refused 1 invalid-array: a definition
float[] f() { return float[](1.); }
//: refused 0 undefined-function: a prototype that a function calls
float[] f();
void main() { f(); }
