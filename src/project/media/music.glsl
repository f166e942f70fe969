// Eight bars at 120 beats a minute: drums, a bass, chords and a small tune over A minor, F, C and G.
const float TURN = 6.2831853;
float hertz(int key) {
    return 440.0 * exp2(float(key - 69) / 12.0);
}
// A note that starts at 0 and ends after an eighth; a brighter note has more overtones.
float pluck(float t, int key, float decay, float bright) {
    float turn = TURN * fract(hertz(key) * t);
    float tone = sin(turn) + bright * (0.5 * sin(2.0 * turn) + 0.33 * sin(3.0 * turn) + 0.25 * sin(4.0 * turn));
    return tone * exp(-decay * t) * smoothstep(0.0, 0.004, t) * (1.0 - smoothstep(0.23, 0.25, t));
}
float hiss(int n) {
    return float(hash(ivec2(n, 0), 1u) >> 16u) / 32768.0 - 1.0;
}
vec2 drums(int n, float t, int beat) {
    float kick = sin(TURN * (46.0 * t + 2.4 * (1.0 - exp(-26.0 * t)))) * exp(-7.0 * t) * (1.0 - smoothstep(0.45, 0.5, t));
    float snare = (beat & 1) == 1 ? (0.7 * hiss(n) + 0.5 * sin(TURN * 190.0 * t)) * exp(-16.0 * t) : 0.0;
    float quarter = mod(t, 0.125);
    float open = t >= 0.25 && t < 0.375 ? 22.0 : 70.0;
    float hat = (hiss(n) - hiss(n - 1)) * exp(-open * quarter);
    return vec2(0.75 * kick + 0.32 * snare) + hat * vec2(0.09, 0.12);
}
vec2 wave(int n) {
    int beat = n / 22050;
    int bar = beat / 4;
    float t = float(n - beat * 22050) / 44100.0;
    float inChord = float(n - bar / 2 * 176400) / 44100.0;
    int root = int[](45, 41, 48, 43)[bar / 2];
    int third = bar < 2 ? 3 : 4;
    vec2 sum = drums(n, t, beat);
    int eighth = t < 0.25 ? 0 : 1;
    float inEighth = t - 0.25 * float(eighth);
    int low = root - 12 + (eighth == 1 && (beat & 3) == 3 ? 12 : 0);
    sum += 0.34 * pluck(inEighth, low, 5.0, 0.8) * (eighth == 0 ? min(1.0, 0.3 + 4.0 * t) : 1.0);
    float swell = smoothstep(0.0, 0.5, inChord) * (1.0 - smoothstep(3.6, 4.0, inChord));
    for (int i = 0; i < 3; i++) {
        int key = root + 12 + (i == 0 ? 0 : i == 1 ? third : 7);
        vec2 turn = TURN * fract(hertz(key) * inChord * vec2(1.0, 1.003));
        sum += 0.055 * swell * (sin(turn) + 0.4 * sin(2.0 * turn));
    }
    // The melody uses one note of the chord, selected by the position in the bar.
    int note = beat * 2 + eighth;
    uint choice = hash(ivec2(note & 15, bar / 4), 5u);
    if ((choice & 3u) != 0u) {
        int key = root + 24 + int[](0, third, 7, 12)[int(choice >> 4u & 3u)];
        sum += 0.16 * pluck(inEighth, key, 7.0, 0.35) * ((note & 1) == 0 ? vec2(1.0, 0.6) : vec2(0.6, 1.0));
    }
    return 0.8 * sum / (1.0 + 0.35 * abs(sum));
}
