void mainImage(out vec4 c, in vec2 f);
void st_assert(bool cond);
void st_assert(bool cond, int v);
out vec4 shadertoy_out_color;
void st_assert(bool cond, int v) {
    if (!cond) {
        if (v == 0) shadertoy_out_color.x = -1.0;
        else if (v == 1) shadertoy_out_color.y = -1.0;
        else if (v == 2) shadertoy_out_color.z = -1.0;
        else shadertoy_out_color.w = -1.0;
    }
}
void st_assert(bool cond) {
    if (!cond) shadertoy_out_color.x = -1.0;
}
void main(void) {
    shadertoy_out_color = vec4(1.0, 1.0, 1.0, 1.0);
    vec4 color = vec4(0.0, 0.0, 0.0, 1.0);
    mainImage(color, gl_FragCoord.xy);
    if (shadertoy_out_color.x < 0.0) color = vec4(1.0, 0.0, 0.0, 1.0);
    if (shadertoy_out_color.y < 0.0) color = vec4(0.0, 1.0, 0.0, 1.0);
    if (shadertoy_out_color.z < 0.0) color = vec4(0.0, 0.0, 1.0, 1.0);
    if (shadertoy_out_color.w < 0.0) color = vec4(1.0, 1.0, 0.0, 1.0);
    shadertoy_out_color = vec4(color.xyz, 1.0);
}
