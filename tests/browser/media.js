// Stand-ins for missing ShaderToy media files.
import assert from 'node:assert/strict';
import { bytesOf, colors, differences, frame, open, port, put } from './browser.js';
import { shader } from './cases.js';

const input = (channel, type, id, sampler) => ({
  id, type, channel, filepath: '/media/a/none', sampler: { filter: 'nearest', wrap: 'repeat', vflip: 'false', ...sampler },
});
const image = (code, ...inputs) => shader({ type: 'image', name: 'Image', code, inputs, outputs: [] });

/** Opens a page that shows an input unchanged, one texel per pixel. */
async function show(context, name, width, height, what, sampler, code) {
  const plain = 'void mainImage(out vec4 O, vec2 U) { O = texelFetch(iChannel0, ivec2(U), 0); }';
  const file = put(`${name}.json`, JSON.stringify(image(code ?? plain, input(0, ...what, sampler))));
  const opened = await open(context, await port(file, name), `#size=${width}x${height}&paused`);
  await opened.page.evaluate(() => globalThis.shaderport.ready);
  assert.deepEqual(await opened.page.evaluate(() => globalThis.shaderport.errors), []);
  return opened;
}

/** The bytes of a square region of an input's texture, row by row. */
async function texels(page, side = 256) {
  return bytesOf(await page.evaluate((length) => {
    const { gl, inputs } = globalThis.shaderport.player;
    const { texture } = inputs.flat().find((i) => i.texture);
    gl.bindFramebuffer(gl.FRAMEBUFFER, gl.createFramebuffer());
    gl.framebufferTexture2D(gl.FRAMEBUFFER, gl.COLOR_ATTACHMENT0, gl.TEXTURE_2D, texture, 0);
    const bytes = new Uint8Array(length * length * 4);
    gl.readPixels(0, 0, length, length, gl.RGBA, gl.UNSIGNED_BYTE, bytes);
    return bytes.toBase64();
  }, side));
}

const mean = (numbers) => numbers.reduce((a, b) => a + b, 0) / numbers.length;

/** The standard deviation of numbers. */
function spread(numbers) {
  const middle = mean(numbers);
  return Math.sqrt(mean(numbers.map((v) => (v - middle) ** 2)));
}

/** The correlation of two sequences, from -1 to 1. */
function correlation(a, b) {
  const [ma, mb] = [mean(a), mean(b)];
  return mean(a.map((v, i) => (v - ma) * (b[i] - mb))) / (spread(a) * spread(b));
}

/** A component, shifted by some texels. */
function moved(bytes, side, component, dx = 0, dy = 0) {
  return Array.from({ length: side * side }, (_, i) => {
    const [x, y] = [((i % side) + dx + side) % side, (Math.floor(i / side) + dy + side) % side];
    return bytes[4 * (y * side + x) + component];
  });
}

async function whiteNoise(context) {
  const { page } = await show(context, 'noise', 64, 36, ['texture', 'Xsf3zn']);
  const bytes = await texels(page);
  assert.equal(bytes.length, 256 * 256 * 4);
  for (let component = 0; component < 4; component++) {
    const values = moved(bytes, 256, component);
    assert.ok(Math.abs(mean(values) - 127.5) < 1.5, `the mean is ${mean(values)}`);
    const counts = new Array(256).fill(0);
    values.forEach((v) => counts[v]++);
    // Chi-square with 255 degrees of freedom: 255 on average, above 360 once in 50,000 times.
    const chi = counts.reduce((sum, n) => sum + (n - 256) ** 2 / 256, 0);
    assert.ok(chi < 360, `${chi}`);
    for (const [dx, dy] of [[1, 0], [0, 1], [1, 1], [-1, 1], [2, 0], [0, 16]]) {
      const near = correlation(values, moved(bytes, 256, component, dx, dy));
      assert.ok(Math.abs(near) < 0.02, `neighbours at ${dx}, ${dy}: ${near}`);
    }
  }
  assert.ok(Math.abs(correlation(moved(bytes, 256, 0), moved(bytes, 256, 2))) < 0.02);
  const unlike = (a, b) => differences(moved(bytes, 256, a, 37, 17), moved(bytes, 256, b));
  assert.equal(unlike(1, 0), 0, 'green is red moved');
  assert.equal(unlike(3, 2), 0, 'alpha is blue moved');
}

/** 3D noise that is interpolated from two components of one lookup has no steps. */
async function continuous(context) {
  const code = `
float noise(vec3 x) {
  vec3 p = floor(x);
  vec3 f = fract(x);
  f = f * f * (3.0 - 2.0 * f);
  vec2 rg = textureLod(iChannel0, (p.xy + vec2(37.0, 239.0) * p.z + f.xy + 0.5) / 256.0, 0.0).yx;
  return mix(rg.x, rg.y, f.z);
}
void mainImage(out vec4 O, vec2 U) {
  vec2 p = U * 0.37 + 3.0;
  float step = noise(vec3(p, 4.9999)) - noise(vec3(p, 5.0001));
  float most = noise(vec3(p, 4.5)) - noise(vec3(p, 5.5));
  O = vec4(abs(step), abs(most), 0.0, 1.0);
}`;
  const sampler = { filter: 'mipmap', vflip: 'true' };
  const { page } = await show(context, 'continuous', 64, 36, ['texture', 'Xsf3zn'], sampler, code);
  const bytes = await frame(page, 0);
  const largest = (c) => Math.max(...bytes.filter((_, i) => i % 4 === c));
  assert.ok(largest(0) <= 2, `a step of ${largest(0)}`);
  assert.ok(largest(1) > 60);
}

async function oneComponent(context) {
  const { page } = await show(context, 'gray', 64, 64, ['texture', '4sf3Rn']);
  const bytes = await frame(page, 0);
  assert.ok(colors(bytes) > 150);
  assert.ok(bytes.every((v, i) => i % 4 === 0 || v === (i % 4 === 3 ? 255 : 0)), 'green and blue are 0');
}

/** The Bayer matrix for ordered dithering, built by its recurrence. */
function bayer(size) {
  if (size === 1) return [[0]];
  const half = bayer(size / 2);
  const more = [[0, 2], [3, 1]];
  const at = (x, y) => 4 * half[y % (size / 2)][x % (size / 2)] + more[Math.floor((2 * y) / size)][Math.floor((2 * x) / size)];
  return Array.from({ length: size }, (_, y) => Array.from({ length: size }, (_, x) => at(x, y)));
}

async function dithering(context) {
  const { page } = await show(context, 'bayer', 8, 8, ['texture', 'Xdf3zn']);
  const bytes = await frame(page, 0);
  const red = bytes.filter((_, i) => i % 4 === 0);
  assert.deepEqual(red, bayer(8).flat().map((n) => 4 * n));
}

/** The share of low frequencies: the deviation of block means, relative to white noise. */
async function blueNoise(context) {
  const { page } = await show(context, 'blue', 64, 36, ['texture', 'XsBSR3']);
  const bytes = await texels(page, 256);
  const values = moved(bytes, 256, 0);
  const deciles = new Array(8).fill(0);
  values.forEach((v) => deciles[v >> 5]++);
  deciles.forEach((n) => assert.ok(Math.abs(n / values.length - 0.125) < 0.03, `${deciles}`));
  const sums = new Array(32 * 32).fill(0);
  values.forEach((v, i) => (sums[(Math.floor(i / 256) >> 3) * 32 + ((i % 256) >> 3)] += v / 64));
  assert.ok(spread(sums) < 0.5 * (spread(values) / 8), `${spread(sums)} of ${spread(values) / 8}`);
}

/** The characters of the font are at their codes; alpha is the distance to their outline. */
async function font(context) {
  const code = `void mainImage(out vec4 O, vec2 U) {
  int code = int(U.x) / 8 + int(U.y) / 8 * 16;
  O = texture(iChannel0, (U / 8.0 - floor(U / 8.0) + vec2(code % 16, 15 - code / 16)) / 16.0);
  O.z = O.w;
}`;
  const sampler = { filter: 'linear', vflip: 'true' };
  const { page } = await show(context, 'font', 128, 128, ['texture', '4dXGzr'], sampler, code);
  const bytes = await frame(page, 0);
  const cell = (sign, component) => {
    const code = sign.charCodeAt(0);
    return Array.from({ length: 64 }, (_, i) => {
      const [x, y] = [(code % 16) * 8 + (i % 8), Math.floor(code / 16) * 8 + Math.floor(i / 8)];
      return bytes[4 * (y * 128 + x) + component];
    });
  };
  assert.ok(cell(' ', 0).every((v) => v === 0), 'the space is empty');
  for (const sign of 'AZaz09@%') {
    assert.ok(cell(sign, 0).some((v) => v > 128), `${sign} is not empty`);
    assert.ok(cell(sign, 2).some((v) => v < 127) && cell(sign, 2).some((v) => v > 150), `${sign} has an edge`);
  }
  const left = (sign) => mean(cell(sign, 0).filter((_, i) => i % 8 < 4));
  const right = (sign) => mean(cell(sign, 0).filter((_, i) => i % 8 > 3));
  assert.ok(left('[') > right('[') && left(']') < right(']'), 'characters are not mirrored');
  const upper = (sign) => mean(cell(sign, 0).filter((_, i) => i > 31));
  const lower = (sign) => mean(cell(sign, 0).filter((_, i) => i < 32));
  assert.ok(upper('^') > lower('^') && upper('_') < lower('_'), 'characters are not upside down');
}

const CUBES = ['XsfGzn', '4sfGzn', 'XdX3zn', '4dX3zn', 'XsX3zn', '4sX3zn', ''];
const TEXTURES = [
  'XdX3Rn', '4dX3Rn', 'XdXGzr', '4dXGzr', '4sfGRn', '4dfGRn', 'Xsf3Rn', 'XsXGRn', 'XsX3Rn', 'Xsf3Rr', '4df3Rr', '4sf3Rr',
  'XdXGzn', '4dXGRn', '4sXGRn', 'XdfGRn', 'XsfGRn', '',
];
const ALL = [
  ...TEXTURES.map((id) => ['texture', id]),
  ...CUBES.map((id) => ['cubemap', id]),
  ...['4sfGRr', 'XdX3Rr', ''].map((id) => ['volume', id]),
  ['video', '4sX3Rn'],
];
/** The lookup at `p`, in 0..1 from left to right and from bottom to top. */
const LOOKUP = {
  texture: 'p',
  video: 'p',
  volume: 'vec3(p, 0.3)',
  cubemap: 'vec3(sin(6.28 * p.x) * sin(3.14 * p.y), -cos(3.14 * p.y), cos(6.28 * p.x) * sin(3.14 * p.y))',
};

/** Four inputs at a time, one in each corner of the image. */
function corners(four) {
  const reads = four.map(([type], i) => `  if (corner == ${i}) O = texture(iChannel${i}, ${LOOKUP[type]});`);
  const code = `void mainImage(out vec4 O, vec2 U) {
  vec2 p = fract(2.0 * U / iResolution.xy);
  int corner = int(2.0 * U.x / iResolution.x) + 2 * int(2.0 * U.y / iResolution.y);
${reads.join('\n')}
}`;
  return image(code, ...four.map(([type, id], i) => input(i, type, id, { filter: 'mipmap', vflip: 'true' })));
}

/** Each of four inputs draws something, and the same on another page. */
async function drawnAlike(context, four) {
  const name = `every_${four.map(([, id]) => id).join('_')}`;
  const address = await port(put(`${name}.json`, JSON.stringify(corners(four))), name);
  const pages = [await open(context, address, '#size=80x60&paused'), await open(context, address, '#size=80x60&paused')];
  const drawn = [];
  for (const { page } of pages) {
    await page.evaluate(() => globalThis.shaderport.ready);
    drawn.push(await frame(page, 2));
    await page.close();
  }
  assert.equal(differences(...drawn), 0, `${four} differ between pages`);
  four.forEach(([type, id], corner) => {
    const isIn = (i) => (i % 80 < 40 ? 0 : 1) + (Math.floor(i / 80) < 30 ? 0 : 2) === corner;
    const own = drawn[0].filter((_, i) => isIn(i >> 2));
    assert.ok(colors(own) > 25, `${type} ${id} has ${colors(own)} colours`);
  });
}

/** A test for every four stand-ins; one of each kind is always drawn. */
function everyStandIn() {
  const kinds = ['texture', 'cubemap', 'volume', 'video'].map((kind) => ALL.find(([type]) => type === kind));
  const others = ALL.filter((one) => !kinds.includes(one));
  const fours = Array.from({ length: Math.ceil(others.length / 4) }, (_, i) => others.slice(4 * i, 4 * i + 4));
  return [kinds, ...fours].map((four) => ({
    name: `media: stand-ins ${four.map(([type, id]) => `${type} ${id}`).join(', ')}, twice`,
    only: four === kinds ? undefined : 'a sweep; compilation is always tested',
    run: (context) => drawnAlike(context, four),
  }));
}

/** Exports that read all stand-ins. */
export const readers = () => Array.from({ length: Math.ceil(ALL.length / 4) }, (_, i) => corners(ALL.slice(4 * i, 4 * i + 4)));

/** The sky is at the top, whatever the orientation of the faces. */
async function upright(context) {
  const code = 'void mainImage(out vec4 O, vec2 U) { O = texture(iChannel0, vec3(0.3, U.y > 2.0 ? 0.9 : -0.9, 0.2)); }';
  for (const [vflip, row] of [['false', 3], ['true', 0]]) {
    const { page } = await show(context, `upright_${vflip}`, 4, 4, ['cubemap', ''], { vflip, filter: 'linear' }, code);
    const bytes = await frame(page, 0);
    const blue = (y) => bytes[16 * y + 2] - bytes[16 * y];
    assert.ok(blue(row) > 40 && blue(3 - row) < 10, `${vflip}: ${blue(3)} above ${blue(0)}`);
  }
}

async function film(context) {
  const code = 'void mainImage(out vec4 O, vec2 U) { O = vec4(texture(iChannel0, U / iResolution.xy).rgb * step(0.0, iChannelTime[0]), 1.0); }';
  const { page } = await show(context, 'film', 48, 32, ['video', '4sX3Rn'], { filter: 'linear' }, code);
  const first = await frame(page, 0);
  assert.ok(differences(first, await frame(page, 30)) > 1000, 'the video moves');
  assert.equal(differences(first, await frame(page, 0)), 0, 'the video repeats');
  const read = await page.evaluate(() => {
    globalThis.shaderport.seek(2.5);
    const found = globalThis.shaderport.player.inputs.flat().find((i) => i.texture);
    return [found.time, ...found.size];
  });
  assert.deepEqual(read, [2.5, 512, 396, 1]);
}

async function music(context) {
  const code = 'void mainImage(out vec4 O, vec2 U) { O = vec4(texture(iChannel0, vec2(U.x / iResolution.x, U.y < 16.0 ? 0.25 : 0.75)).x, iChannelTime[0] / 20.0, 0.0, 1.0); }';
  const { page } = await show(context, 'music', 64, 32, ['music', '4df3Rn'], {}, code);
  // Longer than any track.
  await page.evaluate(() => globalThis.shaderport.seek(1e6));
  const silent = await page.evaluate(() => globalThis.shaderport.player.inputs[0][0].time);
  assert.equal(silent, 1e6 + 10, 'without sound the channel time is that of ShaderToy');
  await page.evaluate(() => {
    globalThis.shaderport.player.play();
    globalThis.shaderport.player.setSound(true);
  });
  // The track plays.
  const isNot = (moment) => page.waitForFunction((other) => {
    const { time } = globalThis.shaderport.player.inputs[0][0];
    return time !== other && time < 1e6;
  }, moment);
  await isNot(0);
  await isNot(await page.evaluate(() => globalThis.shaderport.player.inputs[0][0].time));
  // It has a spectrum.
  await page.waitForFunction(() => {
    const { gl, inputs } = globalThis.shaderport.player;
    const bytes = new Uint8Array(1024 * 4);
    gl.bindFramebuffer(gl.FRAMEBUFFER, gl.createFramebuffer());
    gl.framebufferTexture2D(gl.FRAMEBUFFER, gl.COLOR_ATTACHMENT0, gl.TEXTURE_2D, inputs[0][0].texture, 0);
    gl.readPixels(0, 0, 512, 2, gl.RGBA, gl.UNSIGNED_BYTE, bytes);
    return new Set(bytes.filter((_, i) => i % 4 === 0).subarray(0, 512)).size > 10;
  });
}

/** A file given by the user has priority; `--no-stand-ins` leaves the channel black. */
async function without(context) {
  const code = 'void mainImage(out vec4 O, vec2 U) { O = texture(iChannel0, U / iResolution.xy); }';
  const file = put('without.json', JSON.stringify(image(code, input(0, 'texture', 'XsfGRn'))));
  const { page } = await open(context, await port(file, 'without', '--no-stand-ins'), '#size=32x18&paused');
  await page.evaluate(() => globalThis.shaderport.ready);
  assert.equal(colors(await frame(page, 0)), 1);
  assert.equal(await page.evaluate(() => document.documentElement.outerHTML.includes('Boards of')), false);
}

export const mediaTests = [
  { name: 'media: white noise is uniform', run: whiteNoise },
  { name: 'media: noise in three dimensions is continuous', run: continuous },
  { name: 'media: noise of one component is in red', run: oneComponent },
  { name: 'media: the dithering matrix is an 8x8 Bayer matrix', run: dithering },
  { name: 'media: blue noise lacks low frequencies', run: blueNoise },
  { name: 'media: the font has its characters at their codes', run: font },
  ...everyStandIn(),
  { name: 'media: cube maps are upright', run: upright },
  { name: 'media: the video moves and repeats', run: film },
  { name: 'media: music plays', run: music },
  { name: 'media: without stand-ins the channel is black', run: without },
];
