//# The selector of a switch
//: refused 1 invalid-switch: a switch over a float
void main() { switch (1.) { case 1.: break; } }
//: refused 1 invalid-switch: a switch over a boolean
void main() { switch (true) { default: break; } }
//: refused 1 invalid-switch: a switch over a vector
void main() { switch (ivec2(1)) { default: break; } }
//: refused 2 invalid-switch: a switch over an unsigned number with an int for a label
uniform uint a;
void main() { switch (a) { case 1: break; } }
//: refused 2 invalid-switch: a label twice
uniform int a;
void main() { switch (a) { case 1: break; case 1: break; } }
//: refused 2 invalid-switch: a label twice by a constant
uniform int a; const int n = 1;
void main() { switch (a) { case 1: break; case n: break; } }
//: refused 2 invalid-switch: `default` twice
uniform int a;
void main() { switch (a) { default: break; default: break; } }
//: accepted: `default` before the other labels
uniform int a;
void main() { switch (a) { default: break; case 1: break; } }
//: refused 2 not-constant: a label by a variable
uniform int a, b;
void main() { switch (a) { case b: break; } }
//: refused 2 invalid-switch: a statement before the first label
uniform int a;
void main() { switch (a) { int b; case 1: break; } }
//: refused 2 invalid-switch: no statement after the last label
uniform int a;
void main() { switch (a) { case 1: break; case 2: } }
//: accepted: no label at all
uniform int a;
void main() { switch (a) {} }
//: accepted: one branch falls into the next
uniform int a; int b;
void main() { switch (a) { case 1: b = 1; case 2: b = 2; } }
//: accepted: a variable of one branch in the next
uniform int a;
void main() { switch (a) { case 1: int b = 1; break; case 2: b = 2; } }
//: refused 2 redefinition: a variable twice in two branches
uniform int a;
void main() { switch (a) { case 1: int b; break; case 2: int b; break; } }
//: refused 1 invalid-switch: a label outside of a switch
void main() { case 1: ; }
//: refused 1 invalid-switch: `default` outside of a switch
void main() { default: ; }
//: refused 2 invalid-switch: a label in a block of the switch
uniform int a;
void main() { switch (a) { case 1: { case 2: break; } } }
//: refused 2 invalid-switch: a label of a range
uniform int a;
void main() { switch (a) { case 1 ... 3: break; } }
//: refused 2 syntax-error: a switch without braces
uniform int a;
void main() { switch (a) case 1: break; }
//: accepted: a function that gives its result in every branch of a switch
int f(int a) { switch (a) { case 1: return 1; default: return 2; } }

//# Labels, and the text after the last one
//: refused 2 invalid-switch
uniform int i;
void main() { switch(i){default: if(false){}} }
//: refused 3 invalid-switch
out vec4 o;
uniform int i;
void main() { switch(i){default: if(false){o=vec4(1.);}} }
//: accepted
uniform int i;
void main() { switch(i){default: if(true){}} }
//: accepted
out vec4 o;
uniform int i;
void main() { switch(i){default: if(true){o=vec4(1.);}} }
//: accepted
out vec4 o;
uniform int i;
void main() { switch(i){default: if(true){} else {o=vec4(1.);}} }
//: accepted
out vec4 o;
uniform int i;
void main() { switch(i){default: if(false){} else {o=vec4(1.);}} }
//: accepted
out vec4 o;
uniform int i;
void main() { switch(i){default: if(false){o=vec4(1.);} else {}} }
//: accepted
out vec4 o;
uniform int i;
void main() { switch(i){default: if(false){o=vec4(1.);} else ;} }
//: accepted
uniform int i;
void main() { switch(i){default: if(i==0){}} }
//: accepted
uniform int i;
void main() { switch(i){default: if(i==0);} }
//: accepted
uniform int i;
void main() { switch(i){default: ;} }
//: accepted
uniform int i;
void main() { switch(i){default: ;;} }
//: accepted
uniform int i;
void main() { switch(i){default: {}} }
//: accepted
uniform int i;
void main() { switch(i){default: {;}} }
//: accepted
uniform int i;
void main() { switch(i){default: {{}}} }
//: accepted
uniform int i;
void main() { switch(i){default: 1;} }
//: accepted
uniform int i;
void main() { switch(i){default: i;} }
//: accepted
uniform int i;
void main() { switch(i){default: 1+1;} }
//: accepted
uniform int i;
void main() { switch(i){default: i+1;} }
//: accepted
uniform int i;
void main() { switch(i){default: (1,2);} }
//: accepted
uniform int i;
void main() { switch(i){default: while(false){}} }
//: accepted
uniform int i;
void main() { switch(i){default: for(;false;){}} }
//: accepted
uniform int i;
void main() { switch(i){default: for(int k=0;false;){}} }
//: accepted
out vec4 o;
uniform int i;
void main() { switch(i){default: while(false){o=vec4(1.);}} }
//: accepted
uniform int i;
void main() { switch(i){default: do{}while(false);} }
//: accepted
uniform int i;
void main() { switch(i){default: int a;} }
//: accepted
uniform int i;
void main() { switch(i){default: int a=1;} }
//: accepted
uniform int i;
void main() { switch(i){default: const int a=1;} }
//: accepted
uniform int i;
void main() { switch(i){default: const int a[1]=int[1](1);} }
//: accepted
uniform int i;
void main() { switch(i){default: struct S{int a;};} }
//: accepted
uniform int i;
void main() { switch(i){default: struct S{int a;} s;} }
//: accepted
uniform int i; struct S{int a;};
void main() { switch(i){default: S;} }
//: accepted
uniform int i;
void main() { switch(i){default: int;} }
//: accepted
uniform int i;
void main() { switch(i){default: float[2];} }
//: refused 2 invalid-switch
uniform int i;
void main() { switch(i){default: precision highp float;} }
//: accepted
uniform int i;
void main() { switch(i){default: switch(1){}} }
//: accepted
uniform int i;
void main() { switch(i){default: switch(i){}} }
//: accepted
uniform int i;
void main() { switch(i){default: switch(i){default:;}} }
//: accepted
uniform int i;
void main() { switch(i){default: switch(i){default:break;}} }
//: accepted
uniform int i;
void main() { switch(i){} }
//: refused 2 invalid-switch
uniform int i;
void main() { switch(i){case 0:} }
//: refused 2 invalid-switch
uniform int i;
void main() { switch(i){case 0: break; default:} }
//: refused 2 invalid-switch
uniform int i;
void main() { switch(i){case 0: default:} }
//: accepted
uniform int i;
void main() { switch(i){case 0: default: ;} }
//: accepted
uniform int i;
void main() { switch(i){case 0: ; default: ;} }
//: accepted
uniform int i;
void main() { switch(i){case 0: if(false){} default: break;} }
//: accepted
uniform int i;
void main() { switch(i){default: if(false){} ;} }
//: refused 2 invalid-switch
uniform int i;
void main() { switch(i){default: if(false){} if(false);} }
//: refused 2 invalid-switch
uniform int i;
void main() { switch(i){default: if(1>2){}} }
//: refused 2 invalid-switch
uniform int i; const bool c=false;
void main() { switch(i){default: if(c){}} }
//: accepted
uniform int i;
void main() { switch(i){default: if((true,false)){}} }
//: accepted
uniform int i;
void main() { switch(i){default: if(false&&i>0){}} }
//: accepted
uniform int i;
void main() { switch(i){default: if(true||i>0){}} }
//: refused 2 invalid-switch
uniform int i;
void main() { switch(i){default: if(false) int a;} }
//: refused 2 invalid-switch
uniform int i;
void main() { switch(i){default: if(false){break;}} }
//: accepted
uniform int i;
void main() { switch(i){default: if(false){} break;} }
//: accepted
uniform int i;
void main() { switch(i){default: break; ;} }
//: accepted
uniform int i;
void main() { switch(i){default: break; if(false){}} }
//: accepted
uniform int i;
void main() { switch(i){default: {if(false){}}} }
//: refused 2 invalid-switch
uniform int i;
void main() { switch(i){default: if(true) if(false){} } }
//: accepted
uniform int i;
void main() { switch(i){default: if(true) {if(false){}} } }
//: accepted
uniform int i;
void main() { switch(i){default: if(true) ; } }
//: accepted
uniform int i;
void main() { switch(i){default: if(true) {;} } }
//: accepted
uniform int i;
void main() { switch(i){default: if(true) 1; } }
//: accepted
uniform int i;
void main() { switch(i){default: if(true) {1;} } }
//: accepted
uniform int i;
void main() { switch(i){default: if(true) {} } }
//: accepted
uniform int i;
void main() { switch(i){default: if(true) i; } }
//: accepted
uniform int i;
void main() { switch(i){default: if(false) i; else 1; } }
//: accepted
uniform int i;
void main() { switch(i){default: if(false) i; else {1;} } }
//: accepted
uniform int i;
void main() { switch(i){default: if(true) int a; } }
//: accepted
uniform int i;
void main() { switch(i){default: if(true) {int a;} } }
//: refused 2 invalid-switch
uniform int i;
void main() { if(false) {case 0:} }
//: refused 2 invalid-switch
uniform int i;
void main() { switch(i){case 0: break; case 1: if(false){}} }
//: accepted
uniform int i;
void main() { switch(i){ if(false){} case 0: break;} }
//: refused 2 invalid-switch
uniform int i;
void main() { switch(i){ ; case 0: break;} }
//: refused 2 invalid-switch
uniform int i;
void main() { switch(i){ 1; case 0: break;} }
//: refused 2 invalid-switch
uniform int i;
void main() { switch(i){ {} case 0: break;} }
//: refused 2 invalid-switch
uniform int i;
void main() { switch(i){ int a; case 0: break;} }
//: refused 2 invalid-switch
uniform int i;
void main() { switch(i){ struct S{int a;}; case 0: break;} }
//: refused 2 invalid-switch
uniform int i;
void main() { switch(i){ const int a=1; case a: break;} }
//: accepted
uniform int i;
void main() { switch(i){ precision highp int; case 0: break;} }
//: refused 2 invalid-switch
uniform int i;
void main() { switch(i){ while(false){} case 0: break;} }
//: accepted
uniform int i;
void main() { switch(i){case 0: const int a=1; case a: break;} }
//: refused 2 invalid-switch
uniform int i;
void main() { switch(i){case 0: for(;;){case 1: break;}} }
//: refused 2 invalid-switch
uniform int i;
void main() { switch(i){case 0: {case 1: break;}} }
//: refused 2 invalid-switch
uniform int i;
void main() { switch(i){case 0: if(true) case 1: break;} }
//: accepted
uniform int i;
void main() { switch(i){case 0: switch(i){case 0: break;} case 1: break;} }
//: refused 2 syntax-error
uniform int i;
void main() { switch(i) case 0: break; }
//: refused 2 syntax-error
uniform int i;
void main() { switch(i) default: break; }
//: refused 2 syntax-error
uniform int i;
void main() { switch(i) ; }
//: refused 2 invalid-switch
uniform int i;
void main() { switch(i) {case 0u: break;} }
//: accepted
uniform int i;
void main() { switch(1) {case 1: break;} }
//: accepted
uniform int i;
void main() { switch(1) {default: ;} }
//: refused 2 invalid-switch
uniform int i;
void main() { switch(1) {default:} }
//: accepted
uniform int i;
void main() { switch(1) {} }
//: refused 2 invalid-switch
uniform int i;
void main() { switch(i==1) {case true: break;} }
//: refused 2 not-constant
uniform int i;
void main() { switch(i) {case i: break;} }
//: refused 2 invalid-switch
uniform uint i;
void main() { switch(i) {case 0u: case 4294967295u: case -1: break;} }
//: accepted
uniform uint i;
void main() { switch(i) {case 0u: case 4294967295u: break;} }
//: accepted
uniform int i;
void main() { switch(i) {case 0: case 4294967295: break;} }
//: refused 2 invalid-switch
uniform int i;
void main() { switch(i) {case -1: case 4294967295: break;} }
//: refused 2 invalid-switch
uniform int i;
void main() { switch(i) {default: break; default: break;} }
//: accepted
uniform int i;
void main() { switch(i) {default: return;} }
//: accepted
uniform int i;
void main() { switch(i) {default: discard;} }
//: accepted
int f(int i) {switch(i) {default: return 1;}}
//: accepted
uniform int i;
void main() { for(int k=0;k<2;k++) switch(i) {default: continue;} }
//: refused 2 misplaced-jump
uniform int i;
void main() { switch(i) {default: continue;} }
