//# Numbers
//: accepted: an octal number of digits below 8
int a = 0777;
//: refused 1 invalid-number: the digit 8 in an octal number
int a = 08;
//: accepted: an octal number with a suffix
uint a = 017u;
//: refused 1 invalid-number: nine in an octal number with a suffix
uint a = 09u;
//: accepted: nine before a point: a float is decimal, zeros before it or not
float a = 09.5;
//: accepted: an exponent after digits that would be octal
float a = 08e1;
//: accepted: a hexadecimal number of both cases, and a suffix in capitals
uint a = 0xAbCdU;
//: refused 1 invalid-number: a hexadecimal prefix without a digit
int a = 0x;
//: refused 1 invalid-number: a letter that is not a hexadecimal digit
int a = 0xg;
//: accepted: the largest hexadecimal number is the int of its bits, -1
int a[0xFFFFFFFF + 3];
//: refused 1 invalid-number: nine hexadecimal digits
uint a = 0x1FFFFFFFFu;
//: accepted: the largest decimal number of 32 bits without a suffix
int a = 4294967295;
//: refused 1 invalid-number: one more than 32 bits hold
int a = 4294967296;
//: refused 1 invalid-number: one more than 32 bits hold, with a suffix
uint a = 4294967296u;
//: accepted: the least int, written as minus 2 to the 31st
int a = -2147483648;
//: accepted: a float without digits before the point
float a = .5;
//: accepted: a float without digits after the point
float a = 5.;
//: refused 1 syntax-error: a point alone
float a = .;
//: accepted: an exponent without a point
float a = 1e3;
//: accepted: an exponent with a sign, in capitals
float a = 1.E-3;
//: refused 1 invalid-number: an exponent without digits
float a = 1.0e;
//: refused 1 invalid-number: an exponent of a sign alone
float a = 1.0e+;
//: accepted: the suffix of a float in either case
float a = 1.0f, b = 1.0F, c = 1e2f;
//: refused 1 invalid-number: a float suffix after an integer
float a = 1f;
//: refused 1 needs-webgl2, 100: GLSL ES 1.00 has no float suffix
float a = 1.0f;
//: refused 1 needs-webgl2, 100: GLSL ES 1.00 has no unsigned suffix
int a = 1u;
//: refused 1 invalid-number: the suffix of a double
float a = 1.0lf;
//: refused 1 invalid-number: two suffixes
uint a = 1uu;
//: accepted: a float too large is infinite
float a = 1e39;
//: accepted: a float too small is zero
float a = 1e-60;
//: accepted: an exponent out of range
float a = 1e99999999999;
//: refused 1 invalid-number: two points in a number
float a = 1.2.3;
//: refused 1 invalid-number: a number that ends in a name
float a = 1.0x;
//: refused 1 invalid-number: a component of a float literal
float a = 1.0.x;
//: refused 1 invalid-number, 100: the digit 9 in an octal number
int a = 09;
//: accepted, 100: an integer of more than 31 bits
int a = 4294967295;

//# Characters, comments and continued lines
//: accepted: a letter beyond ASCII in a comment
int a; // é
//: refused 1 invalid-character: a letter beyond ASCII outside of comments
int é;
//: accepted: a backslash in a comment
int a; // \ inside
//: accepted: a line continued after a backslash
int a\
b = 1;
//: accepted: a continued comment hides the next line
// comment \
int a = b;
//: accepted, 100: a line continued after a backslash in GLSL ES 1.00
int a = \
1;
//: refused 3 unterminated-comment: a comment that never ends
int a; /* no end
//: refused 1 syntax-error: comments do not nest
/* a /* b */ int c; */
//: accepted: a comment is a space between two words
int/**/a;
//: refused 1 foreign-syntax: a comment does not join two words
i/**/nt a;
//: refused 1 syntax-error: `*/` without a beginning
int a; */
//: accepted: `//` in a comment has no effect
/* // */ int a;
//: refused 1 invalid-character: a character outside of the GLSL character set
int a = 1 @ 2;
//: refused 1 invalid-character: a dollar in a name
int $a;
//: refused 1 invalid-character: a string
int a = "1";
//: refused 1 invalid-character: a character in quotes
int a = 'a';
//: refused 1 invalid-character: a backquote
int a = `1`;

//# Names
//: refused 1 invalid-number: a name that begins with a digit
int 1a;
//: accepted: a name that begins with an underscore
int _a;
//: refused 1 reserved-identifier: two underscores in a name
int a__b;
//: refused 1 reserved-identifier: two underscores at the beginning of a name
int __a;
//: refused 1 reserved-identifier: a name that begins with gl_
int gl_a;
//: refused 1 reserved-identifier: a name that begins with webgl_
int webgl_a;
//: refused 1 reserved-identifier: a name that begins with _webgl_
int _webgl_a;
//: accepted: gl_ within a name
int a_gl_b;
//: refused 1 reserved-identifier: a function whose name begins with gl_
void gl_f() {}
//: refused 1 reserved-identifier: a parameter whose name begins with gl_
void f(int gl_a) {}
//: refused 1 reserved-identifier: a struct whose name begins with webgl_
struct webgl_S { int a; };
//: refused 1 reserved-identifier: a member whose name begins with gl_
struct S { int gl_a; };
//: accepted: GL_ in capitals is free for names
int GL_a;
//: refused 1 reserved-identifier, 100: two underscores in a name of GLSL ES 1.00
int a__b;
//: refused 1 reserved-word: a keyword as a name
int lowp;
//: refused 1 reserved-word: a name that is reserved for later
int half;
//: refused 1 reserved-word: a word of desktop GLSL that is reserved
float input;
//: refused 1 reserved-word: `output` is reserved as well
float output;
//: accepted: `texture2D` is a name like any other in GLSL ES 3.00
float texture2D;
//: accepted, 100: `texture` is a name like any other in GLSL ES 1.00
float texture;
//: accepted, 100: `layout` is not a keyword in GLSL ES 1.00
float layout;
//: refused 1 reserved-word, 100: `switch` is reserved in GLSL ES 1.00
float switch;
//: refused 1 reserved-word, 100: `flat` is reserved in GLSL ES 1.00
float flat;
//: accepted, 100: `uint` is a name in GLSL ES 1.00
float uint;
//: accepted, 100: `smooth` is a name in GLSL ES 1.00
float smooth;
//: accepted, 100: `mat2x3` is a name in GLSL ES 1.00
float mat2x3;
//: refused 1 reserved-word: `attribute` is reserved in GLSL ES 3.00
float attribute;
//: refused 1 reserved-word: `sampler1D` is reserved
float sampler1D;
//: refused 1 reserved-word: `sizeof` is reserved
float sizeof;
//: refused 1 reserved-word: `class` is reserved
struct class { int a; };
//: refused 1 reserved-word: `this` is reserved, as a member too
struct S { int this; };
//: refused 1 reserved-word: `patch` is reserved
int patch;
//: refused 1 reserved-word: `sample` is reserved
int sample;
//: accepted: `precise` is not a keyword of GLSL ES 3.00
int precise;
//: accepted: `buffer` is not a keyword of GLSL ES 3.00
int buffer;
//: accepted: `shared` is not a keyword of GLSL ES 3.00
int shared;
//: refused 1 reserved-word: `atomic_uint` is reserved
int atomic_uint;
//: refused 1 reserved-word: a type's name as a variable's
int vec3;
//: accepted: a name of 1024 characters
int aaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaa;
//: refused 1 browser-limit: a name of 1025 characters
int aaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaa;
//: accepted, 100: a name of 257 characters in GLSL ES 1.00
int aaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaa;
