//# Names of loops, parameters, functions and structs
//: accepted, 100
void main() { for(int i=0;i<2;i++){ {int i=0; i++;} } }
//: accepted, 100
void main() { for(int i=0;i<2;i++) for(int i=0;i<2;i++){ } }
//: refused 1 redefinition
void main() { for(int i=0;i<2;i++){ int i=0; i++; } }
//: accepted
void main() { for(int i=0;i<2;i++){ {int i=0; i++;} } }
//: refused 1 redefinition
void main() { for(int i=0;i<2;i++) int i=0; }
//: accepted
void main() { if(true) int i=0; }
//: accepted
void main() { int i=0; {int i=i;} }
//: refused 1 undeclared-name
void main() { int i=i; }
//: accepted
int f; void g(){ f=1; int f=2; }
//: refused 2 not-a-function
void f(){}
void main() { int f=1; f(); }
//: accepted
void f(){}
void main() { int f=1; f++; }
//: refused 1 redefinition
struct f{int a;}; void f(){}
//: accepted
struct S{int a;};
void main() { int S=1; S+1; }
//: accepted
struct S{int a;};
void main() { S S=S(1); S.a; }
//: refused 2 unknown-type
struct S{int a;};
void main() { S S=S(1); S t; }
//: accepted
struct S{int a;}; void f(S S){S.a;}
