// Small test shaders, as exports. Each one draws a different image if a certain rule of the player is
// violated.

const A = '4dXGR8';
const B = 'XsXGR8';
const C = '4sXGR8';
const CUBE = '4dX3Rr';

const buffer = (id, code, inputs = [], name = '') => ({ type: 'buffer', name, code, inputs, outputs: [{ id, channel: 0 }] });
const image = (code, inputs = []) => ({ type: 'image', name: 'Image', code, inputs, outputs: [{ id: '4dfGRr', channel: 0 }] });
const common = (code) => ({ type: 'common', name: 'Common', code, inputs: [], outputs: [] });
const input = (channel, type, id, filter = 'linear', wrap = 'clamp') => ({
  id, type, channel, filepath: '', sampler: { filter, wrap, vflip: 'true', srgb: 'false', internal: 'byte' },
});

export const shader = (...renderpass) => ({
  ver: '0.1',
  info: { id: 'abcdef', name: 'a case', username: 'tests', description: '', tags: [] },
  renderpass,
});

/** Each with the frames that are compared, and `later` ones; `mouse` and `keys` are pressed from frame 0 on. */
export const CASES = [
  {
    name: 'single pass: time, resolution, frame, dates and unbound channels',
    frames: [0, 1, 45],
    shader: shader(image(`
void mainImage(out vec4 O, in vec2 U) {
  vec2 p = U / iResolution.xy;
  O = vec4(fract(p + iTime), fract(float(iFrame) * 0.37), iTimeDelta * 20.0);
  O.rgb += texture(iChannel0, p).rgb + iChannelResolution[1] + iChannelTime[2] + iSampleRate / 44100.0 * 0.1;
  if (p.x > 0.5) O.a = 0.0;
}`)),
  },
  {
    name: 'single pass: macros with the names of wrappers',
    frames: [0],
    shader: shader(image(`
#define main mainly
#define color vec3(0.2, 0.5, 0.9)
#define t iTime
#define fragColor paint
void mainly(out vec4 fragColor, vec2 p) { fragColor = vec4(color * p.x, 1.0) + t; }
void mainImage(out vec4 fragColor, in vec2 U) { mainly(fragColor, U / iResolution.xy); }`)),
  },
  {
    name: 'single pass: an output that is read before it is written',
    frames: [0],
    shader: shader(image('void mainImage(out vec4 O, vec2 U) { O += U.xyxy / iResolution.xyxy; O.r *= 0.5; }')),
  },
  {
    name: 'buffer: reads its own previous frame',
    frames: [0, 1, 7],
    shader: shader(
      image('void mainImage(out vec4 O, vec2 U) { O = fract(texelFetch(iChannel0, ivec2(U), 0) * 0.1); }', [input(0, 'buffer', A)]),
      buffer(A, `
void mainImage(out vec4 O, vec2 U) {
  vec4 last = texelFetch(iChannel3, ivec2(U), 0);
  O = iFrame == 0 ? vec4(U, last.x, 1.0) : last * 1.25 + vec4(-3.0, 1.0, 0.5, 0.0);
}`, [input(3, 'buffer', A)]),
    ),
  },
  {
    name: 'buffers: drawn in the order of the export, not of their letters',
    frames: [0, 1, 2, 5],
    shader: shader(
      image(`void mainImage(out vec4 O, vec2 U) {
  vec2 p = U / iResolution.xy;
  O = fract(texture(iChannel0, p) + texture(iChannel1, p) * 0.5 + texture(iChannel2, p * 3.0) * 0.25);
}`, [input(1, 'buffer', A), input(0, 'buffer', B), input(2, 'buffer', C, 'nearest', 'repeat')]),
      buffer(C, 'void mainImage(out vec4 O, vec2 U) { O = shade(texture(iChannel0, U / iResolution.xy), U); }', [input(0, 'buffer', B)]),
      buffer(B, 'void mainImage(out vec4 O, vec2 U) { O = shade(texture(iChannel0, U / iResolution.xy), U.yx); }', [input(0, 'buffer', A)], 'Buffer A'),
      buffer(A, 'void mainImage(out vec4 O, vec2 U) { O = shade(texture(iChannel1, U / iResolution.xy), U + iTime); }', [input(1, 'buffer', C)], ''),
      common('vec4 shade(vec4 last, vec2 p) { return last * 0.5 + vec4(sin(p * 0.2), float(iFrame) * 0.1, 1.0); }'),
    ),
  },
  {
    name: 'buffer: mipmaps, wraps and filters',
    frames: [0, 3],
    shader: shader(
      image(`void mainImage(out vec4 O, vec2 U) {
  vec2 p = U / iResolution.xy * 2.3 - 0.4;
  O = mix(textureLod(iChannel0, p, 3.0), texture(iChannel0, p * 7.0), 0.5);
}`, [input(0, 'buffer', A, 'mipmap', 'repeat')]),
      buffer(A, 'void mainImage(out vec4 O, vec2 U) { O = vec4(step(0.5, fract(U * 0.17 + iTime)), sin(U.x), 1.0); }'),
    ),
  },
  {
    name: 'buffer: discarded pixels are two frames old',
    frames: [0, 1, 2, 3],
    shader: shader(
      image('void mainImage(out vec4 O, vec2 U) { O = texelFetch(iChannel0, ivec2(U), 0); }', [input(0, 'buffer', A)]),
      buffer(A, `void mainImage(out vec4 O, vec2 U) {
  if (int(U.x + U.y) % 4 != iFrame % 4) discard;
  O = vec4(float(iFrame + 1) * 0.2, U / iResolution.xy, 1.0);
}`),
    ),
  },
  {
    name: 'buffer: an undrawn buffer is empty and has the common size',
    frames: [0],
    shader: shader(image(`
void mainImage(out vec4 O, vec2 U) {
  O = vec4(texture(iChannel0, U).a, U / iChannelResolution[0].xy, 1.0);
  O.g += 0.01 * float(textureSize(iChannel0, 0).x);
}`, [input(0, 'buffer', A)])),
  },
  {
    name: 'cube map: all faces, and buffers that read its previous frame',
    frames: [0, 1],
    later: [3],
    shader: shader(
      image(`void mainImage(out vec4 O, vec2 U) {
  vec2 p = U / iResolution.xy;
  float a = 6.2831853 * p.x, b = 3.14159265 * (p.y - 0.5);
  O = texture(iChannel0, vec3(cos(a) * cos(b), sin(b), sin(a) * cos(b)));
  O.b += texelFetch(iChannel1, ivec2(U), 0).x + iChannelResolution[0].x / 8192.0;
}`, [input(0, 'cubemap', CUBE), input(1, 'buffer', A)]),
      buffer(A, 'void mainImage(out vec4 O, vec2 U) { O = texture(iChannel0, vec3(0.3, U / iResolution.xy - 0.5)); }', [input(0, 'cubemap', CUBE, 'nearest')]),
      {
        type: 'cubemap', name: 'Cube A', inputs: [], outputs: [{ id: CUBE, channel: 0 }],
        code: `void mainCubemap(out vec4 O, in vec2 U, in vec3 ro, in vec3 rd) {
  O = vec4(0.5 + 0.5 * rd.xy, fract(float(iFrame) * 0.3 + 0.25 * step(0.0, rd.z)), 1.0) + vec4(ro, 0.0);
}`,
      },
    ),
  },
  {
    name: 'keyboard: down, pressed and toggled',
    frames: [0, 1, 4],
    keys: [65, 37],
    shader: shader(image(`
void mainImage(out vec4 O, vec2 U) {
  int key = U.x < 0.5 * iResolution.x ? 65 : 37;
  if (U.y < 5.0) key = 66;
  O = vec4(texelFetch(iChannel1, ivec2(key, 0), 0).x, texelFetch(iChannel1, ivec2(key, 1), 0).x,
    texture(iChannel1, vec2((float(key) + 0.5) / 256.0, 2.5 / 3.0)).x, 1.0);
  O.rg *= 0.5 + iChannelResolution[1].xy / vec2(1024.0, 12.0);
}`, [input(1, 'keyboard', '4dXGRr', 'nearest')])),
  },
  {
    name: 'mouse: position, click and signs',
    frames: [0, 1, 2],
    mouse: { x: 20.7, y: 9.2 },
    shader: shader(image(`
void mainImage(out vec4 O, vec2 U) {
  O = vec4(step(distance(U, iMouse.xy), 6.0), sign(iMouse.zw) * 0.25 + 0.5, 1.0) + iMouse.x / 255.0 / 4.0;
}`)),
  },
  {
    name: 'mouse: untouched',
    flat: true,
    frames: [0],
    shader: shader(image('void mainImage(out vec4 O, vec2 U) { O = 0.5 + 0.25 * sign(iMouse) + abs(iMouse); }')),
  },
  {
    name: 'every kind of pass: line numbers',
    frames: [0],
    shader: shader(
      image(`
#define HERE __LINE__
void mainImage(out vec4 O, vec2 U) {
  O = vec4(COMMON, HERE, __LINE__, 255) / 255.0 + texelFetch(iChannel0, ivec2(U), 0) + texture(iChannel1, vec3(U, 1.0));
  if (U.x < 9.0) O = vec4(hash(0), hash(1), hash(2), 1.0);
}`, [input(0, 'buffer', A), input(1, 'cubemap', CUBE)]),
      common('// The first line\n#define COMMON __LINE__\nfloat hash(int n) { return fract(sin(float(__LINE__ + n)) * 437.5); }'),
      buffer(A, 'void mainImage(out vec4 O, vec2 U) {\n O = vec4(__LINE__, COMMON, hash(0) * 255.0, 0) / 255.0; }'),
      common('\r\nint unused() { return __LINE__; }\r\n'),
      {
        type: 'cubemap', name: 'Cube A', inputs: [], outputs: [{ id: CUBE, channel: 0 }],
        code: 'void mainCubemap(out vec4 O, in vec2 U, in vec3 ro, in vec3 rd) { O = vec4(__LINE__, 0, COMMON, 0) / 255.0; }',
      },
    ),
  },
];
