//# Scopes
//: refused 1 redefinition: a variable twice in one scope
void main() { int a; float a; }
//: accepted: a variable again in an inner scope
void main() { int a; { float a; } }
//: refused 1 undeclared-name: a variable used after its scope
void main() { { int a; } a = 1; }
//: refused 1 redefinition: a global twice
int a; int a;
//: refused 1 redefinition: a parameter's name within the function
void f(int a) { int a; }
//: accepted: a parameter's name in an inner scope of the function
void f(int a) { { int a; } }
//: refused 1 redefinition, 100: a parameter's name within a function of GLSL ES 1.00
void f(int a) { int a; }
//: refused 1 redefinition: a loop's counter in its body
void main() { for (int i = 0; i < 2; i++) { int i; } }
//: refused 1 undeclared-name: a loop counter used after the loop
void main() { for (int i = 0; i < 2; i++) {} i = 1; }
//: accepted: the counters of two loops
void main() { for (int i = 0; i < 2; i++) {} for (int i = 0; i < 2; i++) {} }
//: refused 1 undeclared-name: a variable of a condition used after its loop
void main() { while (bool a = false) {} a = true; }
//: refused 1 syntax-error: a variable in the condition of an `if`
void main() { if (bool a = true) {} }
//: refused 1 undeclared-name: a variable of a branch without braces in the other one
void main() { if (true) int a = 1; else a = 2; }
//: refused 1 undeclared-name: a variable of a branch without braces, used after it
void main() { if (true) int a; a = 1; }
//: accepted: a struct of an inner scope hides the outer one
struct S { int a; };
void main() { struct S { float b; }; S s; s.b = 1.; }
//: refused 1 undeclared-name: a global before its declaration
void main() { a = 1; } int a;
//: refused 1 undeclared-name: a name that is not declared
void main() { a = 1; }
//: accepted: a local variable hides a uniform
uniform float a;
void main() { float a = a; }
//: refused 1 reserved-identifier: a global called like a built-in variable
vec4 gl_FragCoord;

//# Branches and loops
//: refused 1 syntax-error: an `else` without its `if`
void main() { else {} }
//: refused 1 foreign-syntax: an `if` without parentheses
void main() { if true {} }
//: refused 1 syntax-error: an `if` without a condition
void main() { if () {} }
//: accepted: an `if` with a semicolon for its statement
void main() { if (true); else; }
//: refused 1 missing-semicolon: an `if` without a statement
void main() { if (true) }
//: refused 1 foreign-syntax: `elif`
void main() { if (true) {} elif (false) {} }
//: refused 1 condition-type: a condition that is an int
void main() { while (1) { break; } }
//: refused 1 syntax-error: a condition of a `do` that is declared
void main() { do {} while (bool a = false); }
//: refused 1 missing-semicolon: a `do` without its semicolon
void main() { do {} while (false) }
//: accepted: a `do` without braces
void main() { int a; do a++; while (a < 2); }
//: accepted: an empty `for` header, exited by `break`
void main() { for (;;) { break; } }
//: refused 1 missing-semicolon: a `for` of one semicolon
void main() { for (int i = 0; i < 2) {} }
//: refused 1 foreign-syntax: a `for` with commas
void main() { for (int i = 0, i < 2, i++) {} }
//: accepted: a `for` that counts two
void main() { for (int i = 0, j = 2; i < j; i++, j--) {} }
//: refused 1 syntax-error: a `for` with a declaration of two types
void main() { for (int i = 0, float j = 2.; i < 2; i++) {} }
//: accepted: a `for` over a struct that it declares
void main() { for (struct { int a; } s; s.a < 2; s.a++) {} }
//: refused 1 syntax-error: a `for` whose last part is a declaration
void main() { for (int i = 0; i < 2; int j = 1) {} }
//: accepted: a `for` with an expression for its first part
void main() { int i; for (i = 0; i < 2; i++) {} }
//: refused 1 condition-type: a condition that is a vector
void main() { for (; bvec2(true);) {} }
//: refused 1 misplaced-jump: `break` outside of loops
void main() { break; }
//: refused 1 misplaced-jump: `break` in an `if` outside of loops
void main() { if (true) break; }
//: refused 1 misplaced-jump: `continue` outside of loops
void main() { continue; }
//: accepted: `continue` in a `switch` within a loop
void main() { for (int i = 0; i < 2; i++) switch (i) { case 0: continue; } }
//: refused 1 foreign-syntax: `goto`
void main() { goto end; end: ; }
//: refused 1 syntax-error: a label of its own
void main() { here: ; }
//: accepted: `return` in a loop of main
void main() { for (;;) { return; } }
//: accepted: an empty statement
void main() { ;;; }
//: accepted: a block alone
void main() { {} }
//: refused 1 missing-semicolon: a statement without its semicolon
void main() { int a = 1 }
//: refused 2 unclosed-delimiter: a missing brace
void main() { int a;
//: refused 1 unclosed-delimiter: a brace too many
void main() { } }
//: refused 1 syntax-error: a statement outside of functions
int a; a = 1;
//: refused 1 syntax-error: a call outside of functions
void f() {} f();
//: accepted: an expression without effects
void main() { 1 + 2; }
//: accepted: a declaration without a name
void main() { float; }
//: refused 1 missing-semicolon: two declarations without a comma
void main() { int a int b; }
//: refused 1 unknown-type: a variable of an unknown type
void main() { thing a; }
