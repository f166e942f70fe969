// Flutter
//
// A fragment program of Flutter: a `.frag` file in the section `shaders` of `pubspec.yaml`, which
// `FragmentProgram.fromAsset` loads. It includes `<flutter/runtime_effect.glsl>`, reads its position
// from `FlutterFragCoord()`, with y down, and writes to an `out vec4` of any name.
//
// Dart sets the uniforms by index, in the order of their declaration: `setFloat` one number at a
// time, `setImageSampler` for samplers. Their names have no meaning for Flutter.
//
// source: docs.flutter.dev, Writing and using fragment shaders; flutter/runtime_effect.glsl of flutter/engine
// word: FlutterFragCoord
// file: flutter/runtime_effect.glsl
// reads: Flutter fragment program
// version: desktop
// names: some
// entry: main
// composes: yes
// refuses: samplers lookups varyings blocks unsigned numbers
// setters: dart
#ifdef SHADER_DECLARES
uniform vec2 uSize; // = resolution
uniform vec2 size; // = resolution, ending
uniform vec2 resolution; // = resolution, ending
uniform float uTime; // = time
uniform float u_time; // = time
uniform float time; // = time
uniform float iTime; // = time
uniform float uWidth; // = width
uniform float uHeight; // = height
uniform sampler2D uTexture; // = screen, top-first
uniform sampler2D tInput; // = screen, top-first
uniform sampler2D u_texture0; // = screen, top-first, numbered
uniform sampler2D iChannel0; // = file, top-first, numbered
#endif
uniform vec2 flutter_Size; // = resolution
vec2 FlutterFragCoord() { return vec2(gl_FragCoord.x, flutter_Size.y - gl_FragCoord.y); }
#ifdef SHADER_TEMPLATE
#version 460 core
#include <flutter/runtime_effect.glsl>
out vec4 pixelColor;
#pragma screen
#define texture(s, p) texture(s, vec2(0.0, 1.0) + vec2(1.0, -1.0) * (p))
#pragma code
void main() {
    vec2 place = FlutterFragCoord().xy;
    vec4 color = vec4(0.0, 0.0, 0.0, 1.0);
    port_image(color, vec2(place.x, uSize.y - place.y));
    pixelColor = vec4(color.rgb, 1.0);
}
#endif
