// Tests the views of the extension: previews by position and of values, channels, refactorings, and costs
// in the gutter.
import assert from 'node:assert/strict';
import { openFile, picture, player, runCommand, until, word } from './workbench.js';

const STAGES = `const vertex = \`#version 300 es
in vec4 position; out vec2 vUv;
void main() { vUv = position.xy; gl_Position = position; }\`;
const water = \`#version 300 es
precision highp float;
in vec2 vUv; uniform float uTime; out vec4 color;
void main() {
    float ripple = 0.5 + 0.5 * sin(40.0 * length(vUv) - uTime);
    color = vec4(0.1, ripple, 0.9, 1.0);
}\`;
const fire = \`#version 300 es
precision highp float;
in vec2 vUv; uniform float uTime; out vec4 color;
void main() {
    float flame = fract(0.375 * uTime + vUv.y);
    color = vec4(1.0, flame, 0.1, 1.0);
}\`;
`;
const IMAGE = `void mainImage(out vec4 fragColor, in vec2 fragCoord) {
    vec2 uv = fragCoord / iResolution.xy;
    vec3 sky = texture(iChannel1, vec3(uv - 0.5, 1.0)).rgb;
    fragColor = vec4(mix(sky, texture(iChannel0, uv).rgb, 0.5), 1.0);
}
`;
const BUFFER = `void mainImage(out vec4 fragColor, in vec2 fragCoord) {
    fragColor = texture(iChannel2, fragCoord / iResolution.xy);
}
`;
const FIELD = `float field(vec3 p) {
    float d = length(p) - 1.0;
    for (int i = 0; i < 4; i++) {
        d += 0.1 * sin(3.0 * p.x + float(i)) * sin(4.0 * p.y);
    }
    return d;
}

void mainImage(out vec4 fragColor, in vec2 fragCoord) {
    vec2 uv = (2.0 * fragCoord - iResolution.xy) / iResolution.y;
    vec3 from = vec3(0.0, 0.0, -3.0);
    vec3 ray = normalize(vec3(uv, 2.0));
    float way = 0.0;
    for (int i = 0; i < 12; i++) {
        way += 0.7 * field(from + ray * way);
    }
    vec3 tint = vec3(0.9, 0.6, 0.3);
    fragColor = vec4(way < 5.0 ? tint * (4.0 - way) : vec3(0.1), 1.0);
}
`;

/** The files that the steps open. */
export const FILES = { 'stages.js': STAGES, 'image.glsl': IMAGE, 'buffer_a.glsl': BUFFER, 'field.glsl': FIELD };

/** The frame of the view around a page. */
const shell = (frame) => frame.parentFrame();

/** The shader under the cursor, in a file that starts with a vertex shader. */
async function position(page) {
  await openFile(page, 'stages.js', 'vertex');
  await page.locator('.view-line', { hasText: 'float flame' }).click();
  await runCommand(page, 'Shaderlint: Open Preview');
  await player(page, 'float flame');
  await picture(page, 'preview-position');
  await page.locator('.view-line', { hasText: 'float ripple' }).click();
  await runCommand(page, 'Shaderlint: Open Preview');
  const other = await player(page, 'float ripple');
  assert(!(await other.evaluate(() => globalThis.shaderport.player.project.files.some((f) => f.text.includes('flame')))));
  await picture(page, 'preview-other');
}

/** Channels that nothing gives an input. */
async function channels(page) {
  await openFile(page, 'image.glsl', 'sky');
  await runCommand(page, 'Shaderlint: Open Preview');
  const frame = await player(page, 'vec3 sky');
  const assumed = shell(frame).locator('#assumed');
  await assumed.filter({ hasText: 'iChannel2 of buffer_a (generated texture)' }).waitFor();
  await picture(page, 'channels');
  await assumed.getByRole('button', { name: 'Write channels.toml' }).click();
  await page.locator('.tab', { hasText: 'channels.toml' }).waitFor();
  await page.locator('.view-line', { hasText: '1 = "stand-in" # cubemap' }).waitFor();
  await assumed.waitFor({ state: 'hidden' });
  await player(page, 'vec3 sky');
  await page.locator('.tab.active', { hasText: 'Preview image.glsl' }).waitFor();
  await picture(page, 'channels-written');
}

/** Costs in the gutter. */
async function gutter(page) {
  await openFile(page, 'field.glsl', 'float field');
  const images = () => page.evaluate(() => {
    const all = [...globalThis.document.querySelectorAll('.glyph-margin-widgets > *')];
    return all.map((node) => globalThis.getComputedStyle(node).backgroundImage).filter((url) => url.includes('svg'));
  });
  await until(page, 'costs in the gutter', async () => (await images()).length > 0);
  const percents = (await images()).map((url) => Number(/>(\d+)</.exec(decodeURIComponent(url))?.[1]));
  console.log(`shares in the gutter: ${percents.join(', ')} %`);
  assert(percents.every((percent) => percent >= 5) && Math.max(...percents) > 50);
  await picture(page, 'gutter');
  await runCommand(page, 'Shaderlint: Toggle Costs of Lines');
  await until(page, 'an empty gutter', async () => (await images()).length === 0);
  await runCommand(page, 'Shaderlint: Toggle Costs of Lines');
  await until(page, 'costs in the gutter again', async () => (await images()).length > 0);
}

/** The actions for a selected word. */
async function actions(page, line, text) {
  await word(page, line, text).dblclick();
  await page.keyboard.press('Control+Shift+KeyR');
  await page.locator('.action-widget .monaco-list-row').first().waitFor();
}

/** Chooses an action of the open menu by the keyboard: a block around the menu takes clicks. */
async function pick(page, title) {
  const rows = page.locator('.action-widget .monaco-list-row');
  await rows.filter({ hasText: title }).waitFor();
  await until(page, `the action ${title}`, async () => {
    if (await rows.and(page.locator('.focused')).filter({ hasText: title }).count() > 0) return true;
    await page.keyboard.press('ArrowDown');
    return false;
  });
  await page.keyboard.press('Enter');
}

/** The value of a variable over the frame. */
async function value(page) {
  await openFile(page, 'field.glsl', 'float field');
  await actions(page, 'way += 0.7', 'way');
  await picture(page, 'value-menu');
  await pick(page, 'Preview this value');
  const frame = await player(page, 'showValue(');
  const shown = shell(frame).locator('#value');
  await shown.filter({ hasText: 'Value of way' }).waitFor();
  await picture(page, 'value');
  // It follows the code.
  await page.locator('.view-line', { hasText: 'float field' }).click();
  await page.keyboard.press('Home');
  await page.keyboard.type('// Above.\n');
  await player(page, '// Above.');
  await shown.filter({ hasText: 'Value of way' }).waitFor();
  await shown.getByRole('button').click();
  await shown.waitFor({ state: 'hidden' });
  const draws = () => {
    const player = globalThis.shaderport?.player;
    return player?.isPlaying && player.clock.time > 0.3 && globalThis.frameElement?.className === ''
      && !player.project.files.some((file) => file.text.includes('showValue('));
  };
  await until(page, 'the image instead of the value', async () => {
    for (const frame of page.frames()) if (await frame.evaluate(draws).catch(() => false)) return true;
    return false;
  });
  await picture(page, 'value-left');
}

/** A refactoring, and the name that it asks for. */
async function refactoring(page) {
  await openFile(page, 'field.glsl', 'float field');
  await page.locator('.view-line', { hasText: 'way += 0.7' }).click();
  await page.keyboard.press('Home');
  for (let i = 0; i < 'way += 0.7 * '.length; i++) await page.keyboard.press('ArrowRight');
  for (let i = 0; i < 'field(from + ray * way)'.length; i++) await page.keyboard.press('Shift+ArrowRight');
  await page.keyboard.press('Control+Shift+KeyR');
  await page.locator('.action-widget .monaco-list-row').first().waitFor();
  await picture(page, 'refactor-menu');
  await pick(page, 'Extract to variable');
  await page.locator('.rename-box input').fill('distance_here');
  await picture(page, 'refactor-name');
  await page.keyboard.press('Enter');
  await page.locator('.view-line', { hasText: 'way += 0.7 * distance_here;' }).waitFor();
  await page.locator('.view-line', { hasText: 'float distance_here = field(from + ray * way);' }).waitFor();
  await picture(page, 'refactored');
}

/** The steps, in their order. */
export const views = {
  'costs are shown in the gutter': gutter,
  'an expression is extracted to a variable': refactoring,
  'the preview shows the shader at the cursor': position,
  'channels without an input are assumed, and written': channels,
  'the preview shows the value of a variable': value,
};
