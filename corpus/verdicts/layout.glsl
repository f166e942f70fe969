//# Locations
//: accepted, vertex: the location of an attribute
layout(location = 0) in vec4 a;
//: accepted, vertex: a location twice, which linking refuses
layout(location = 0) in vec4 a; layout(location = 0) in vec4 b;
//: accepted, vertex: a matrix uses a location for each column; fails to link
layout(location = 0) in mat2 a; layout(location = 1) in vec4 b;
//: accepted, vertex: after the columns of a matrix
layout(location = 0) in mat2 a; layout(location = 2) in vec4 b;
//: refused 1 syntax-error, vertex: a negative location
layout(location = -1) in vec4 a;
//: refused 1 syntax-error, vertex: a location by an expression
layout(location = 1 + 1) in vec4 a;
//: refused 1 syntax-error, vertex: a location by a constant
const int n = 1; layout(location = n) in vec4 a;
//: accepted, vertex: a location by a macro
#define N 1
layout(location = N) in vec4 a;
//: accepted, vertex: an unsigned location
layout(location = 1u) in vec4 a;
//: accepted, vertex: a hexadecimal location
layout(location = 0x1) in vec4 a;
//: refused 1 invalid-layout, vertex: a location beyond those that there are
layout(location = 99) in vec4 a;
//: refused 1 invalid-layout, vertex: a location without a number
layout(location) in vec4 a;
//: accepted, vertex: a location twice in one layout
layout(location = 0, location = 1) in vec4 a;
//: refused 1 invalid-qualifier, vertex: a layout twice
layout(location = 0) layout(location = 1) in vec4 a;
//: refused 1 syntax-error, vertex: a layout without a word
layout() in vec4 a;
//: refused 1 invalid-layout, vertex: a location of an output of a vertex shader
layout(location = 0) out vec4 a;
//: refused 1 invalid-qualifier, vertex: a layout after the storage qualifier
in layout(location = 0) vec4 a;
//: refused 1 invalid-qualifier, vertex: a precision before the layout
highp layout(location = 0) in vec4 a;
//: refused 1 invalid-layout: a location of an input of a fragment shader
layout(location = 0) in vec4 a;
//: refused 1 invalid-layout: a location of a uniform
layout(location = 0) uniform vec4 a;
//: refused 1 invalid-layout: a location of a global
layout(location = 0) vec4 a;
//: refused 1 invalid-qualifier: a location of a local variable
void main() { layout(location = 0) vec4 a; }
//: refused 1 invalid-parameter: a location of a parameter
void f(layout(location = 0) vec4 a) {}
//: refused 1 invalid-layout: an unknown word in a layout
layout(place = 0) out vec4 a;
//: refused 1 invalid-layout: the offset of a member
uniform B { layout(offset = 0) vec4 a; };
//: refused 1 invalid-layout: early tests of fragments
layout(early_fragment_tests) in;
//: refused 1 syntax-error, 100: a layout in GLSL ES 1.00
layout(location = 0) uniform vec4 a;

//# Outputs of fragment shaders
//: accepted: one output without a location
out vec4 a;
void main() { a = vec4(1.); }
//: refused 1 output-location: two outputs without locations
out vec4 a, b;
//: refused 1 output-location: two outputs of which one has a location
layout(location = 0) out vec4 a; out vec4 b;
//: accepted: two outputs with locations
layout(location = 0) out vec4 a; layout(location = 1) out vec4 b;
//: refused 1 output-location: two outputs at one location
layout(location = 0) out vec4 a; layout(location = 0) out vec4 b;
//: refused 1 output-location: an array of outputs uses a location for each element
layout(location = 0) out vec4 a[2]; layout(location = 1) out vec4 b;
//: refused 1 output-location: an output beyond the buffers that there are
layout(location = 8) out vec4 a;
//: refused 1 output-location: an array of outputs that ends beyond the buffers that there are
layout(location = 7) out vec4 a[2];
//: refused 1 output-location: an array of more outputs than there are buffers
out vec4 a[9];
//: refused 1 invalid-array: an array of arrays of outputs
out vec4 a[2][2];
//: refused 1 legacy-glsl: gl_FragColor in GLSL ES 3.00
void main() { gl_FragColor = vec4(1.); }
//: refused 1 reserved-identifier: an own output called gl_FragColor
out vec4 gl_FragColor;
//: refused 1 legacy-glsl: gl_FragData in GLSL ES 3.00
void main() { gl_FragData[0] = vec4(1.); }
//: accepted: an output is read
out vec4 a;
void main() { a = vec4(1.); a = a * 2.; }
//: refused 0 output-location, 100: gl_FragColor and gl_FragData
void main() { gl_FragColor = vec4(1.); gl_FragData[0] = vec4(1.); }
//: refused 0 output-location, 100: gl_FragColor and gl_FragData in two functions
void f() { gl_FragColor = vec4(1.); }
void main() { gl_FragData[0] = vec4(1.); f(); }
//: refused 1 needs-webgl2, 100: gl_FragData without an index
void main() { gl_FragData = vec4(1.); }
//: accepted, 100: the complete array gl_FragData
void f(vec4 a[1]) {}
void main() { f(gl_FragData); }

//# Blocks
//: accepted: a block and its members by their own names
uniform B { vec4 a; };
void main() { vec4 b = a; }
//: refused 2 undeclared-name: a member by its own name though the block has an instance
uniform B { vec4 a; } b;
void main() { vec4 c = a; }
//: refused 2 not-a-variable: a member by the name of the block
uniform B { vec4 a; } b;
void main() { vec4 c = B.a; }
//: refused 2 invalid-index: an array of blocks by an index that is not constant
uniform B { vec4 a; } b[2]; uniform int i;
void main() { vec4 c = b[i].a; }
//: refused 1 interface-block: an array of blocks without a size
uniform B { vec4 a; } b[];
//: refused 1 invalid-array: an array of arrays of blocks
uniform B { vec4 a; } b[2][2];
//: refused 1 interface-block: a block without members
uniform B {};
//: refused 1 invalid-qualifier: a block within a function
void main() { uniform B { vec4 a; }; }
//: refused 1 interface-block: a block of inputs
in B { vec4 a; } b;
//: refused 1 syntax-error: a block without uniform
B { vec4 a; };
//: refused 1 interface-block: a block with a sampler
uniform B { sampler2D s; };
//: accepted: a block with a struct
struct S { vec4 a; }; uniform B { S s[2]; };
//: refused 1 invalid-struct: a block that declares a struct
uniform B { struct S { vec4 a; } s; };
//: accepted: members of a block with their own uniform
uniform B { uniform vec4 a; };
//: refused 1 foreign-syntax: a member with a value
uniform B { vec4 a = vec4(1.); };
//: refused 1 invalid-layout: std430
layout(std430) uniform B { vec4 a; };
//: refused 1 invalid-layout: packed and shared
layout(packed) uniform B { vec4 a; }; layout(shared) uniform C { vec4 b; };
//: refused 1 interface-block: std140 of a member
uniform B { layout(std140) vec4 a; };
//: accepted: rows of a member that is a matrix
uniform B { layout(row_major) mat4 a; };
//: accepted: a layout for all following blocks
layout(std140, column_major) uniform; uniform B { mat4 a; };
//: refused 1 invalid-layout: a layout for all uniforms, with a location
layout(location = 0) uniform;
//: refused 1 invalid-layout: a layout for all inputs
layout(std140) in;
//: refused 1 invalid-layout: std140 on a uniform that is not a block
layout(std140) uniform vec4 a;
//: refused 1 invalid-layout: the binding of a block
layout(binding = 0) uniform B { vec4 a; };
//: refused 1 redefinition: a block called like a function
void B() {} uniform B { vec4 a; };
//: refused 1 redefinition: a member of a block called like a global
int a; uniform B { vec4 a; };
//: accepted: two blocks of the same members, one with an instance
uniform B { vec4 a; }; uniform C { vec4 a; } c;
//: refused 1 redefinition: a block called like its instance
uniform B { vec4 a; } B;
//: refused 1 interface-block: a block with a precision
highp uniform B { vec4 a; };
//: accepted: a member of a block with a precision
uniform B { mediump vec4 a; };
//: refused 1 foreign-syntax: a buffer
buffer B { vec4 a; };
//: refused 1 needs-webgl2, 100: a block in GLSL ES 1.00
uniform B { vec4 a; };
