//# How much there may be; what linking counts is accepted here
//: accepted: 16 inputs
in vec4 a[16];
//: accepted: more inputs than any browser has, which linking refuses
in vec4 a[100];
//: accepted, vertex: 16 attributes
in mat4 a, b, c, d;
//: accepted, vertex: more attributes than there are, which linking refuses
in mat4 a, b, c, d, e;
//: accepted: uniforms of a thousand vectors
uniform vec4 a[1000];
//: accepted: uniforms of more vectors than there are, which linking refuses
uniform vec4 a[5000];
//: accepted: sixteen samplers
uniform sampler2D a[16];
//: accepted: more samplers than there are, which linking refuses
uniform sampler2D a[100];
//: accepted: parentheses 50 deep
int a = ((((((((((((((((((((((((((((((((((((((((((((((((((1))))))))))))))))))))))))))))))))))))))))))))))))));
//: accepted: parentheses 300 deep
int a = ((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((1))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))));
//: accepted: blocks 50 deep
void main() { {{{{{{{{{{{{{{{{{{{{{{{{{{{{{{{{{{{{{{{{{{{{{{{{{{}}}}}}}}}}}}}}}}}}}}}}}}}}}}}}}}}}}}}}}}}}}}}}}}}} }
//: refused 0 browser-limit: blocks 300 deep
void main() { {{{{{{{{{{{{{{{{{{{{{{{{{{{{{{{{{{{{{{{{{{{{{{{{{{{{{{{{{{{{{{{{{{{{{{{{{{{{{{{{{{{{{{{{{{{{{{{{{{{{{{{{{{{{{{{{{{{{{{{{{{{{{{{{{{{{{{{{{{{{{{{{{{{{{{{{{{{{{{{{{{{{{{{{{{{{{{{{{{{{{{{{{{{{{{{{{{{{{{{{{{{{{{{{{{{{{{{{{{{{{{{{{{{{{{{{{{{{{{{{{{{{{{{{{{{{{{{{{{{{{{{{{{{{{{{{{{{{{{{{{{{{{{{{{{{{{{{{{{{{}}}}}}}}}}}}}}}}}}}}}}}}}}}}}}}}}}}}}}}}}}}}}}}}}}}}}}}}}}}}}}}}}}}}}}}}}}}}}}}}}}}}}}}}}}}}}}}}}}}}}}}}}}}}}}}}}}}}}}}}}}}}}}}}}}}}}}}}}}}}}}}}}}}}}}}}}}}}}}}}}}}}}}}}}}}}}}}}}}}}}}}}}}}}}}}}}}}}}}}}}}}}}}}}}}}}}}}}}}}}}}}}}}}}}}}}}}}}}}}}}}}}}}}}}}}}}}}}}}}}}}}}}}}}}}}}}}}}}}}}}}}}}}}}}}}}}}}}}}}} }
//: accepted: a sum of 200 terms
int a = 1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1;
//: accepted: minus signs 200 deep
int b; int f() { return - - - - - - - - - - - - - - - - - - - - - - - - - - - - - - - - - - - - - - - - - - - - - - - - - - - - - - - - - - - - - - - - - - - - - - - - - - - - - - - - - - - - - - - - - - - - - - - - - - - - - - - - - - - - - - - - - - - - - - - - - - - - - - - - - - - - - - - - - - - - - - - - - - - - - - - - - - - - - - - - - - - - - - - - - - - - - - - - - - - - - - - - - - - - - - - - - - - - - - - - b; }
//: accepted: a choice 100 deep
uniform bool b; int f() { return b ? 1 : b ? 1 : b ? 1 : b ? 1 : b ? 1 : b ? 1 : b ? 1 : b ? 1 : b ? 1 : b ? 1 : b ? 1 : b ? 1 : b ? 1 : b ? 1 : b ? 1 : b ? 1 : b ? 1 : b ? 1 : b ? 1 : b ? 1 : b ? 1 : b ? 1 : b ? 1 : b ? 1 : b ? 1 : b ? 1 : b ? 1 : b ? 1 : b ? 1 : b ? 1 : b ? 1 : b ? 1 : b ? 1 : b ? 1 : b ? 1 : b ? 1 : b ? 1 : b ? 1 : b ? 1 : b ? 1 : b ? 1 : b ? 1 : b ? 1 : b ? 1 : b ? 1 : b ? 1 : b ? 1 : b ? 1 : b ? 1 : b ? 1 : b ? 1 : b ? 1 : b ? 1 : b ? 1 : b ? 1 : b ? 1 : b ? 1 : b ? 1 : b ? 1 : b ? 1 : b ? 1 : b ? 1 : b ? 1 : b ? 1 : b ? 1 : b ? 1 : b ? 1 : b ? 1 : b ? 1 : b ? 1 : b ? 1 : b ? 1 : b ? 1 : b ? 1 : b ? 1 : b ? 1 : b ? 1 : b ? 1 : b ? 1 : b ? 1 : b ? 1 : b ? 1 : b ? 1 : b ? 1 : b ? 1 : b ? 1 : b ? 1 : b ? 1 : b ? 1 : b ? 1 : b ? 1 : b ? 1 : b ? 1 : b ? 1 : b ? 1 : b ? 1 : b ? 1 : b ? 1 : b ? 1 : b ? 1 : 2; }
//: accepted: a struct with 300 members
struct S { float m0, m1, m2, m3, m4, m5, m6, m7, m8, m9, m10, m11, m12, m13, m14, m15, m16, m17, m18, m19, m20, m21, m22, m23, m24, m25, m26, m27, m28, m29, m30, m31, m32, m33, m34, m35, m36, m37, m38, m39, m40, m41, m42, m43, m44, m45, m46, m47, m48, m49, m50, m51, m52, m53, m54, m55, m56, m57, m58, m59, m60, m61, m62, m63, m64, m65, m66, m67, m68, m69, m70, m71, m72, m73, m74, m75, m76, m77, m78, m79, m80, m81, m82, m83, m84, m85, m86, m87, m88, m89, m90, m91, m92, m93, m94, m95, m96, m97, m98, m99, m100, m101, m102, m103, m104, m105, m106, m107, m108, m109, m110, m111, m112, m113, m114, m115, m116, m117, m118, m119, m120, m121, m122, m123, m124, m125, m126, m127, m128, m129, m130, m131, m132, m133, m134, m135, m136, m137, m138, m139, m140, m141, m142, m143, m144, m145, m146, m147, m148, m149, m150, m151, m152, m153, m154, m155, m156, m157, m158, m159, m160, m161, m162, m163, m164, m165, m166, m167, m168, m169, m170, m171, m172, m173, m174, m175, m176, m177, m178, m179, m180, m181, m182, m183, m184, m185, m186, m187, m188, m189, m190, m191, m192, m193, m194, m195, m196, m197, m198, m199, m200, m201, m202, m203, m204, m205, m206, m207, m208, m209, m210, m211, m212, m213, m214, m215, m216, m217, m218, m219, m220, m221, m222, m223, m224, m225, m226, m227, m228, m229, m230, m231, m232, m233, m234, m235, m236, m237, m238, m239, m240, m241, m242, m243, m244, m245, m246, m247, m248, m249, m250, m251, m252, m253, m254, m255, m256, m257, m258, m259, m260, m261, m262, m263, m264, m265, m266, m267, m268, m269, m270, m271, m272, m273, m274, m275, m276, m277, m278, m279, m280, m281, m282, m283, m284, m285, m286, m287, m288, m289, m290, m291, m292, m293, m294, m295, m296, m297, m298, m299; };

//# Sizes that the browser refuses
//: refused 1 browser-limit
void f(float x[16384]){}
//: refused 1 browser-limit
void f(float x[16385]){}
//: accepted
void f(float x[16385]);
//: accepted
void f(in float x[16385]);
//: refused 1 browser-limit
void f(const float x[16385]){}
//: refused 1 browser-limit
void f(inout float x[16385]){}
//: refused 1 browser-limit
void f(out float x[16385]){}
//: refused 1 browser-limit
void f(float [16385]){}
//: refused 1 browser-limit, vertex
void f(float x[16385]){}
//: refused 1 browser-limit, 100
void f(float x[16385]){}
//: refused 1 browser-limit, 100
void f(float x[16384]){}
//: refused 1 browser-limit
struct S{float x[16385];}; void f(S s){}
//: accepted
struct S{float x[16385];}; S f();
//: accepted
float[16385] f();
//: refused 1 constructor-arguments
float[16385] f(){ return float[16385](1.);}
//: accepted
uniform B{float x[16385];};
//: refused 1 browser-limit
uniform B{float x[536870911];};
//: refused 1 browser-limit
uniform B{float x[134217728];};
//: accepted
uniform B{float x[134217727];};
//: refused 1 browser-limit
uniform B{float x[134217729];};
//: refused 1 browser-limit
uniform B{float x[268435456];};
//: refused 1 browser-limit
uniform B{vec4 x[134217728];};
//: accepted
uniform B{vec4 x[134217727];};
//: refused 1 browser-limit
uniform B{float x[67108864];} b[2];
//: refused 1 browser-limit
uniform B{float x[2];} b[67108864];
//: refused 1 browser-limit
uniform B{float x[~1U];};
//: refused 1 browser-limit
uniform B{int x[~1U];};
//: refused 1 browser-limit
uniform B{mat4 x[~1U];};
//: refused 1 browser-limit
uniform int x[~1U];
//: refused 1 browser-limit
int x[~1U];
//: refused 1 browser-limit
void main() { int x[~1U]; }
//: refused 1 browser-limit
void f(int x[~1U]){}
//: refused 1 browser-limit
uniform vec4 x[134217728];
//: accepted
uniform vec4 x[134217727];
//: accepted
uniform float x[134217727];
//: refused 1 browser-limit
uniform float x[134217728];
//: refused 1 browser-limit
uniform mat4 x[134217727];
//: refused 1 browser-limit
uniform mat4 x[33554432];
//: accepted
uniform mat4 x[33554431];
