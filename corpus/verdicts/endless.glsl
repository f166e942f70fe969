//# Loops that the browser considers infinite
//: accepted
uniform int i;
void main() { while((true,true)){} }
//: accepted
uniform int i;
void main() { while((i>0,true)){} }
//: accepted
uniform int i;
void main() { for(;(true,true);){} }
//: accepted
uniform int i;
void main() { bool b=(true,true); while(b){} }
//: accepted
uniform int i;
void main() { bool b; b=true; while(b){} }
//: refused 2 infinite-loop
uniform int i;
void main() { bool b=true; while((b)){} }
//: accepted
uniform int i;
void main() { bool b=true; while(!b){} }
//: accepted
uniform int i;
void main() { bool b=true; while(b==true){} }
//: accepted
uniform int i;
void main() { bool b=true; while(b&&true){} }
//: accepted
uniform int i;
void main() { bool b=false; while(!b){} }
//: refused 2 infinite-loop
uniform int i;
void main() { const bool b=true; while(b){} }
//: refused 2 infinite-loop
uniform int i;
void main() { const bool b=true; while(b){discard;} }
//: accepted
uniform int i;
void main() { while(true){if(false)break;} }
//: accepted
uniform int i;
void main() { while(true){if(false){break;}} }
//: accepted
uniform int i;
void main() { while(true){if(false){return;}} }
//: accepted
uniform int i;
void main() { while(true){if(i>0){return;}} }
//: refused 2 infinite-loop
uniform int i;
void main() { while(true){while(true){break;}} }
//: accepted
uniform int i;
void main() { while(true){while(i>0){return;}} }
//: refused 2 infinite-loop
uniform int i;
void main() { while(true){switch(i){case 0:break;}} }
//: accepted
uniform int i;
void main() { while(true){switch(i){case 0:return;}} }
//: refused 2 infinite-loop
uniform int i;
void main() { while(true){switch(i){case 0:if(i>0)break;}} }
//: accepted
uniform int i;
void main() { while(true){for(;;){return;}} }
//: refused 2 infinite-loop
uniform int i;
void main() { while(true){do{break;}while(true);} }
//: accepted
uniform int i;
void main() { do{}while(true); }
//: accepted
uniform int i;
void main() { do{continue;}while(true); }
//: accepted
uniform int i;
void main() { while(true){while(false){return;}} }
//: accepted
uniform int i;
void main() { while(true){if(true){}else{return;}} }
//: accepted
uniform int i;
void main() { while(true){if(true){}else return;} }
//: accepted
uniform int i;
void main() { while(true){if(false) return;} }
//: accepted
uniform int i;
void main() { for(;;){if(false){} else break;} }
//: refused 2 infinite-loop
uniform int i;
void main() { for(;1==1;){} }
//: refused 2 infinite-loop
uniform int i;
void main() { for(;1.==1.;){} }
//: refused 2 infinite-loop
uniform int i;
void main() { for(;vec2(1.)==vec2(1.);){} }
//: accepted
uniform int i;
void main() { for(;true||i>0;){} }
//: accepted
uniform int i;
void main() { for(;i>0||true;){} }
//: refused 2 infinite-loop
uniform int i;
void main() { for(;!false;){} }
//: refused 2 infinite-loop
uniform int i;
void main() { for(;bool(1);){} }
//: refused 2 infinite-loop
uniform int i;
void main() { for(;true?true:false;){} }
//: accepted
uniform int i;
void main() { for(;i>0?true:true;){} }
//: refused 2 infinite-loop
uniform int i;
void main() { for(;any(bvec2(true));){} }
//: refused 2 infinite-loop
uniform int i;
void main() { for(bool b=true;b;){} }
//: accepted
uniform int i;
void main() { for(bool b=true;b;b=false){} }
//: accepted
uniform int i;
void main() { for(bool b=true;b;b=b){} }
//: accepted
uniform int i;
void main() { while(bool b=true){} }
//: accepted
uniform int i;
void main() { for(;bool b=true;){} }
//: refused 2 infinite-loop
uniform int i;
void main() { if(false) while(true){} }
//: refused 2 infinite-loop
uniform int i;
void main() { if(false){ while(true){}} }
//: refused 2 infinite-loop
uniform int i;
void main() { return; while(true){} }
//: refused 2 infinite-loop
bool g=true;
void main() { while(g){} }
//: refused 2 infinite-loop
const bool g=true;
void main() { while(g){} }
//: accepted
bool g=true; void f(){g=false;}
void main() { while(g){} }
//: accepted
uniform bool g;
void main() { while(g){} }
//: accepted
struct S{bool b;};
void main() { S s=S(true); while(s.b){} }
//: refused 2 infinite-loop
struct S{bool b;};
void main() { const S s=S(true); while(s.b){} }
//: accepted
void main() { bvec2 s=bvec2(true); while(s.x){} }
//: refused 1 infinite-loop
void main() { const bvec2 s=bvec2(true); while(s.x){} }
//: accepted
void main() { bool s[1]=bool[1](true); while(s[0]){} }
//: refused 1 infinite-loop
void main() { const bool s[1]=bool[1](true); while(s[0]){} }
//: accepted
void f(inout bool b){}
void main() { bool b=true; f(b); while(b){} }
//: refused 2 infinite-loop
void f(bool b){}
void main() { bool b=true; f(b); while(b){} }
//: refused 1 infinite-loop
void main() { bool b=true; while(b){bool b=false; b=true;} }
//: accepted
void main() { bool b=true, c=b; while(c){} }
//: accepted
void main() { bool b=true; {b=true;} while(b){} }
