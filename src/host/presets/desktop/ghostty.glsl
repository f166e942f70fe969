// Ghostty
//
// A terminal whose `custom-shader` runs ShaderToy code on what it shows. Other terminals have
// adopted its names. It puts its uniforms before a shader and calls `mainImage`; a shader that uses
// only ShaderToy's names is read as one of ShaderToy.
//
// The shader is compiled as desktop GLSL, `#version 430 core`, in which integers convert to floats.
// Only `iChannel0` exists: the terminal's screen. There are no buffers, no mouse and no sound. A
// shader that does not compile is ignored, and the error is only in the log.
//
// The position of a cursor is its upper left corner in pixels, from the lower left corner of the
// screen.
//
// source: src/renderer/shaders/shadertoy_prefix.glsl of ghostty-org/ghostty
// word: iCurrentCursor iPreviousCursor iTimeCursorChange iCurrentCursorColor iPreviousCursorColor iCurrentCursorStyle iPreviousCursorStyle iCurrentCursorVisible iPreviousCursorVisible iTimeFocus iFocus iPalette iBackgroundColor iForegroundColor iCursorColor iCursorText iSelectionBackgroundColor iSelectionForegroundColor
// version: desktop
// names: all
// entry: mainImage
// composes: yes
uniform vec3 iResolution; // = resolution
uniform float iTime; // = time
uniform float iTimeDelta; // = delta
uniform float iFrameRate; // = frame-rate
uniform int iFrame; // = frame
uniform float iChannelTime[4]; // = channel-time
uniform vec3 iChannelResolution[4]; // = channel-resolution
uniform vec4 iMouse; // = nothing
uniform vec4 iDate; // = date
uniform float iSampleRate; // = sample-rate
/// The cursor: x of its left edge, y of its upper edge, width and height, in pixels.
uniform vec4 iCurrentCursor; // = cursor
/// Where the cursor was before it moved.
uniform vec4 iPreviousCursor; // = cursor-before
uniform vec4 iCurrentCursorColor; // = cursor-color
uniform vec4 iPreviousCursorColor; // = cursor-color
/// The shape of the cursor, one of the macros `CURSORSTYLE_*`.
uniform int iCurrentCursorStyle; // = nothing
uniform int iPreviousCursorStyle; // = nothing
uniform int iCurrentCursorVisible; // = ones
uniform int iPreviousCursorVisible; // = ones
/// The value that `iTime` had when the cursor moved.
uniform float iTimeCursorChange; // = cursor-time
/// The value that `iTime` had when the window received the focus.
uniform float iTimeFocus; // = nothing
/// 1 if the window has the focus.
uniform int iFocus; // = ones
/// The 256 colours of the terminal.
uniform vec3 iPalette[256]; // = nothing
uniform vec3 iBackgroundColor; // = nothing
uniform vec3 iForegroundColor; // = ones
uniform vec3 iCursorColor; // = cursor-color
uniform vec3 iCursorText; // = nothing
uniform vec3 iSelectionBackgroundColor; // = cursor-color
uniform vec3 iSelectionForegroundColor; // = nothing
/// What the terminal shows.
uniform sampler2D iChannel0; // = screen
#define CURSORSTYLE_BLOCK 0
#define CURSORSTYLE_BLOCK_HOLLOW 1
#define CURSORSTYLE_BAR 2
#define CURSORSTYLE_UNDERLINE 3
#define CURSORSTYLE_LOCK 4
#ifdef SHADER_TEMPLATE
#pragma code
void mainImage(out vec4 fragColor, in vec2 fragCoord) {
    port_image(fragColor, fragCoord);
    fragColor.a = 1.0;
}
#endif
