vec2 mainSound(in int samp, float time);
out vec4 outColor;
void main(void) {
    float t = iTimeOffset + ((gl_FragCoord.x - 0.5) + (gl_FragCoord.y - 0.5) * 512.0) / iSampleRate;
    int s = iSampleOffset + int(gl_FragCoord.y - 0.2) * 512 + int(gl_FragCoord.x - 0.2);
    vec2 v = floor((0.5 + 0.5 * mainSound(s, t)) * 65536.0), vl = mod(v, 256.0) / 255.0, vh = floor(v / 256.0) / 255.0;
    outColor = vec4(vl.x, vh.x, vl.y, vh.y); }
