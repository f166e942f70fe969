//# Which of its outputs an index may choose
//: refused 1 output-location
out vec4 o;
out vec4 q[2];
//: refused 2 invalid-index
out vec4 q[2]; uniform int i;
void main() { q[i]=vec4(1.); }
//: accepted
out vec4 q[2]; uniform int i;
void main() { q[1][i]=1.; }
//: refused 2 invalid-index
out vec4 q[2]; uniform int i;
void main() { q[i].x=1.; }
//: refused 3 invalid-index
out vec4 o;
uniform int i;
void main() { o[i]=1.; }
//: refused 3 invalid-index
out vec4 o;
uniform int i;
void main() { o[(0,1)]=1.; }
//: accepted
out vec4 o;
uniform int i;
void main() { o[1]=1.; }
//: refused 3 invalid-index
out vec4 o;
uniform int i;
void main() { float f=o[i]; }
//: accepted
out vec4 o;
uniform int i;
void main() { o.xy[i]=1.; }
//: refused 3 invalid-index
out vec4 o;
uniform int i;
void main() { (o)[i]=1.; }
//: refused 3 invalid-index
out vec4 o;
uniform int i;
void main() { for(int k=0;k<4;k++) o[k]=1.; }
//: refused 3 invalid-index
out vec4 o;
uniform int i;
void main() { o[i]++; }
//: refused 3 invalid-index
out vec4 o;
uniform int i; void f(out float x){x=1.;}
void main() { f(o[i]); }
//: accepted
out vec4 o;
uniform int i; void f(inout vec4 x){x[i]=1.;}
void main() { f(o); }
//: refused 2 invalid-index
out highp ivec4 o; uniform int i;
void main() { o[i]=1; }
//: refused 2 invalid-index
layout(location=0) out vec4 o; uniform int i;
void main() { o[i]=1.; }
//: refused 2 invalid-index
layout(location=0) out vec4 o; layout(location=1) out vec4 p[2]; uniform int i;
void main() { p[1]=o;p[i]=o; }
//: accepted
out vec4 q[2];
void main() { q.length(); q[0]=q[1]; }
//: refused 2 invalid-index
out vec4 q[2];
void main() { for(int k=0;k<2;k++) q[k]=vec4(1.); }
//: accepted
uniform int i;
void main() { gl_FragDepth=1.; }
//: accepted, vertex
out vec4 v[2]; uniform int i;
void main() { v[i]=vec4(1.); }
//: accepted, vertex
out vec4 v; uniform int i;
void main() { v[i]=1.; gl_Position[i]=1.; }
//: accepted, vertex
out mat4 v; uniform int i;
void main() { v[i]=vec4(1.); v[i][i]=1.; }
//: accepted
in vec4 v[2]; uniform int i;
void main() { v[i]; }
//: accepted
in vec4 v; uniform int i;
void main() { v[i]; }
//: accepted
in mat4 v; uniform int i;
void main() { v[i][i]; }
//: accepted, vertex
in mat4 v; uniform int i;
void main() { v[i][i]; }
