//# The version
//: refused 2 version-placement: a comment before the version
/* a comment */
#version 300 es
void main() {}
//: refused 2 version-placement: a declaration before the version
int a;
#version 300 es
void main() {}
//: refused 2 version-placement: a directive before the version
#define A
#version 300 es
void main() {}
//: accepted: spaces around the number sign and between the words
  #   version   300   es
void main() {}
//: refused 2 version-placement: the version twice
#version 300 es
#version 300 es
void main() {}
//: refused 1 unsupported-version: the version without its profile
#version 300
void main() {}
//: refused 1 unsupported-version: a version that there is in desktop GLSL alone
#version 330
void main() {}
//: refused 1 unsupported-version: GLSL ES 3.10
#version 310 es
void main() {}
//: refused 1 unsupported-version: the profile in capitals
#version 300 ES
void main() {}
//: refused 1 unsupported-version: the profile of desktop GLSL
#version 300 core
void main() {}
//: accepted: GLSL ES 1.00 by its number
#version 100
void main() {}
//: refused 1 bad-directive: GLSL ES 1.00 with the profile of the later ones
#version 100 es
void main() {}
//: refused 1 bad-directive: text after the version
#version 300 es 1
void main() {}
//: accepted: a comment after the version
#version 300 es // GLSL ES 3.00
void main() {}

//# Conditions
//: refused 1 preprocessor-expression: an unknown name in a condition
#if A
#endif
//: refused 1 preprocessor-expression, 100: an unknown name in a condition of GLSL ES 1.00
#if A
#endif
//: accepted: an unknown name after a true operand
#if 1 || A
#endif
//: accepted: an unknown name after a false operand
#if 0 && A
#endif
//: accepted: an unknown name that a closed branch asks for
#if 0
#if A
#endif
#endif
//: accepted: `defined` with and without parentheses
#define A
#if defined A && defined(A) && !defined B
const int a = 1;
#endif
int b = a;
//: refused 1 bad-directive: `defined` without a name
#if defined
#endif
//: refused 2 preprocessor-expression: `defined` that a macro expands to
#define D defined(A)
#if D
#endif
//: refused 1 preprocessor-expression: a condition without an expression
#if
#endif
//: refused 2 bad-directive: text after #endif
#if 1
#endif A
//: refused 2 bad-directive: text after #else
#if 1
#else A
#endif
//: accepted: a comment after #endif
#if 1
#endif // A
//: refused 1 bad-directive: text after the name of #ifdef
#ifdef A B
#endif
//: refused 1 bad-directive: #ifdef without a name
#ifdef
#endif
//: refused 1 bad-directive: #ifndef of a number
#ifndef 1
#endif
//: refused 1 preprocessor-expression: a number with a point in a condition
#if 1.0
#endif
//: accepted: an unsigned number in a condition
#if 1u
#endif
//: refused 1 preprocessor-expression: a division by zero in a condition
#if 1 / 0
#endif
//: accepted: a division by zero after a false operand
#if 0 && 1 / 0
#endif
//: accepted: a remainder by zero in a condition that is not asked for
#if 1
#elif 1 % 0
#endif
//: refused 1 preprocessor-expression: a choice in a condition
#if 1 ? 1 : 0
#endif
//: refused 1 preprocessor-expression: a comma in a condition
#if 1, 1
#endif
//: refused 1 preprocessor-expression: an assignment in a condition
#if A = 1
#endif
//: accepted: shifts, masks and comparisons in a condition
#if ((1 << 4) | 3) == 19 && (~0 ^ -1) == 0 && 7 % 4 >= 3
const int a = 1;
#endif
int b = a;
//: refused 3 unbalanced-conditional: #else twice
#if 1
#else
#else
#endif
//: refused 3 unbalanced-conditional: #elif after #else
#if 1
#else
#elif 1
#endif
//: refused 1 unbalanced-conditional: #endif without #if
#endif
//: refused 1 unbalanced-conditional: #if without #endif
#if 1
//: accepted: a closed branch may hold anything
#if 0
int 1 @ ' 08
#unknown
#endif
//: accepted: #endif in a comment
#if 0
/* #endif */
#endif
//: refused 5 unterminated-comment: an unclosed comment in a closed branch
#if 0
/*
#endif
//: accepted: #error in a closed branch
#if 0
#error no
#endif
//: refused 1 error-directive: #error in an open branch
#error no
//: accepted: GL_ES is 1
#if GL_ES != 1
#error no
#endif
//: accepted: __VERSION__ is 300
#if __VERSION__ != 300
#error no
#endif
//: accepted, 100: __VERSION__ is 100
#if __VERSION__ != 100
#error no
#endif
//: accepted: __LINE__ counts from the first line
int a[__LINE__ - 2];
//: accepted: __FILE__ is 0
int a[__FILE__ + 1];
//: accepted: GL_FRAGMENT_PRECISION_HIGH is 1
#if GL_FRAGMENT_PRECISION_HIGH != 1
#error no
#endif
//: accepted, vertex: GL_FRAGMENT_PRECISION_HIGH in the other stage
#if GL_FRAGMENT_PRECISION_HIGH != 1
#error no
#endif

//# Macros
//: accepted: a macro defined twice alike
#define A 1
#define A 1
//: accepted: a macro defined twice with other spaces between its words
#define A 1 + 2
#define A 1  +   2
//: refused 2 macro-redefinition: a macro defined twice, once without spaces
#define A 1 + 2
#define A 1+2
//: refused 2 macro-redefinition: a macro defined twice with another value
#define A 1
#define A 2
//: refused 2 macro-redefinition: a macro defined twice with another parameter
#define A(x) x
#define A(y) y
//: refused 2 macro-redefinition: a macro with and without parameters
#define A 1
#define A() 1
//: accepted: #undef of what is not defined
#undef A
//: refused 1 bad-directive: #undef without a name
#undef
//: refused 2 bad-directive: text after the name of #undef
#define A
#undef A B
//: accepted: a macro named like a keyword
#define float int
float a = 1;
//: refused 1 reserved-macro: a macro that begins with GL_
#define GL_A 1
//: accepted: a macro that begins with gl_
#define gl_a 1
//: accepted: two underscores in a macro's name
#define A__B 1
//: refused 1 reserved-macro: a macro named `defined`
#define defined 1
//: refused 1 reserved-macro: #undef of __LINE__
#undef __LINE__
//: refused 1 reserved-macro: #undef of GL_ES
#undef GL_ES
//: refused 1 reserved-macro: a definition of GL_ES
#define GL_ES 1
//: refused 1 reserved-macro: a definition of __VERSION__
#define __VERSION__ 300
//: refused 2 macro-arguments: too few arguments of a macro
#define A(x, y) x + y
int a = A(1);
//: refused 2 macro-arguments: too many arguments of a macro
#define A(x) x
int a = A(1, 2);
//: accepted: an empty argument
#define A(x) 1 x
int a = A();
//: accepted: a macro without parameters, called without arguments
#define A() 1
int a = A();
//: refused 2 macro-arguments: an argument of a macro without parameters
#define A() 1
int a = A(1);
//: accepted: a comma in parentheses does not end an argument
#define A(x) x
int a = A((1, 2));
//: refused 3 macro-arguments: a comma in brackets ends an argument
#define A(x) x
int a[2];
void main() { A(a[0, 1]); }
//: refused 2 unclosed-delimiter: a call without its closing parenthesis
#define A(x) x
int a = A(1;
//: accepted: a call goes on over lines
#define A(x) x
int a = A(
1
);
//: accepted: a directive within a call
#define A(x) x
int a = A(
#define B
1);
//: accepted: a macro with parameters without a call is a name
#define A(x) x
int A = 1;
//: accepted: a space between the name and the parenthesis makes a value of it
#define A (x)
int x = 1;
void main() { int b = A; }
//: accepted: a macro is not expanded within itself
#define a a
int a = 1;
//: refused 4 undeclared-name: two macros that expand to each other
#define a b
#define b a
int a = 1;
void main() { b = a; }
//: accepted: an argument is expanded before it is put in
#define A(x) x
int a = A(A(A(1)));
//: refused 2 syntax-error: a function called like a macro with parameters
#define f(x) (x + f(x))
int f(int x) { return x; }
//: refused 1 bad-directive: two parameters of one name
#define A(x, x) x
//: refused 1 bad-directive: a parameter that is not a name
#define A(1) 1
//: refused 1 bad-directive: a list of parameters that does not end
#define A(x
//: refused 1 bad-directive: a definition of a number
#define 1 2
//: refused 1 bad-directive: a definition without a name
#define
//: refused 2 token-paste: `##` is not supported
#define A(x) x ## 1
int A(a) = 1;
//: refused 2 token-paste: `#` is not supported
#define A(x) #x
int a = A(b);
//: refused 2 faulty-macro: an operator is not put together from two macros
#define LESS <
bool a = 1 LESS= 2;
//: accepted: a minus before a macro that begins with one
#define A -1
int a = -A;
//: accepted: a definition in the midst of a function
void f() {
#define A 1
  int a = A;
}
//: accepted: a definition with parameters that spans lines
#define A(x) \
  (x \
  + 1)
int a = A(1);
//: refused 1 bad-directive: a macro of variable arguments
#define A(...) 1
int a = A(1, 2);

//# Other directives
//: accepted: the number sign alone
#
int a;
//: refused 1 bad-directive: an unknown directive
#unknown
//: refused 1 bad-directive: `#` after code
int a; #define A
//: accepted: #pragma of whatever
#pragma whatever at all
//: accepted: #pragma in GLSL's own name
#pragma STDGL whatever
//: refused 1 bad-directive: #pragma STDGL invariant(all) in a fragment shader
#pragma STDGL invariant(all)
//: accepted, vertex: #pragma STDGL invariant(all) in a vertex shader
#pragma STDGL invariant(all)
//: accepted, 100: #pragma STDGL invariant(all) in GLSL ES 1.00
#pragma STDGL invariant(all)
//: refused 1 bad-directive: #pragma optimize with neither of its values
#pragma optimize(maybe)
//: accepted: #pragma debug(on)
#pragma debug(on)
//: accepted: #line with a number
#line 5
int a;
//: accepted: #line with a number and a file
#line 5 1
int a;
//: refused 1 bad-directive: #line with a name in quotes
#line 5 "a"
//: refused 1 bad-directive: #line without a number
#line
//: accepted: #line with an expression
#line 2 + 3
//: refused 1 preprocessor-expression: #line with three numbers
#line 1 2 3
//: accepted: #line with a macro
#define A 5
#line A
//: accepted: an extension that there is not, enabled
#version 300 es
#extension GL_XX_nothing : enable
void main() {}
//: refused 2 unknown-extension: an extension that there is not, required
#version 300 es
#extension GL_XX_nothing : require
void main() {}
//: accepted: all extensions are warned of
#version 300 es
#extension all : warn
void main() {}
//: refused 2 unknown-extension: all extensions cannot be enabled
#version 300 es
#extension all : enable
void main() {}
//: refused 2 unknown-extension: an extension with a behaviour that there is not
#version 300 es
#extension GL_XX_nothing : maybe
void main() {}
//: refused 2 bad-directive: an extension without its colon
#version 300 es
#extension GL_XX_nothing enable
void main() {}
//: accepted: an extension that GLSL ES 3.00 has built in, enabled
#version 300 es
#extension GL_OES_standard_derivatives : enable
void main() {}
//: refused 3 extension-placement: an extension after the first declaration
#version 300 es
precision highp float;
#extension GL_XX_nothing : warn
void main() {}
//: refused 3 extension-placement: an extension after the first declaration of GLSL ES 1.00
#version 100
precision highp float;
#extension GL_OES_standard_derivatives : enable
void main() {}
//# Shifts, and words after the directives of skipped groups
//: accepted: `>>` of a negative number shifts zeros in
#if (-1 >> 1) != 2147483647
#error
#endif
//: accepted: a negative number that is shifted is not negative
#if (-8 >> 1) == -4
#error
#endif
//: refused 3 bad-directive: a word after `#endif` in a skipped group
#if 0
#if 1
#endif X
#endif
//: accepted: a word after `#else` in a skipped group
#if 0
#if 1
#else X
#endif
#endif
//: refused 4 bad-directive: a word after the `#endif` of a group in a branch that is not taken
#if 1
#else
#ifdef A
#endif X
#endif
