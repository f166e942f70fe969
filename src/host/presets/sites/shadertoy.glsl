// ShaderToy
//
// The player of shadertoy.com puts its uniforms before each pass and calls `mainImage`, `mainSound`
// or `mainCubemap`.
//
// A file with such an entry point is read as a separate pass. This host is for the accompanying
// files, and for programs that provide the same uniforms to their own shaders.
//
// source: shadertoy.com, effect.js
// word: iResolution iTime iTimeDelta iFrame iFrameRate iMouse iDate iSampleRate iChannelTime iChannelResolution iChannel0 iChannel1 iChannel2 iChannel3
// version: any
// names: some
// entry: mainImage mainSound mainCubemap main
// ending: glsl frag fs shadertoy
/// The size of the output in pixels: `x` is the width, `y` the height. `z` is the pixel aspect
/// ratio, always 1.0 on ShaderToy. It is a `vec3`, so use `iResolution.xy` with a `vec2`. 1024 by
/// 1024 in a Cubemap pass; not set in Sound.
uniform vec3 iResolution; // = resolution, or vec2 ivec2
/// The time in seconds since the start or the last restart, without pauses. Not set in Sound, where
/// `mainSound` gets the time as a parameter. It was named `iGlobalTime` until 2017; that name no
/// longer exists.
uniform float iTime; // = time
/// The seconds since the previous frame. It is 1/60 in the first frame, after a pause and for
/// frames drawn while paused. Not set in Sound.
uniform float iTimeDelta; // = delta
/// The number of frames that this pass has drawn so far: 0 in the first frame and after a restart,
/// which makes it the test for initialising a buffer. Frames drawn while paused count too. Not set
/// in Sound.
uniform int iFrame; // = frame, or uint float
/// The average number of frames per second. Not set in Sound.
uniform float iFrameRate; // = frame-rate, or int uint
/// The mouse in whole pixels from the lower left corner, y up; not set in Sound. `xy` is its last
/// position with the button down and does not change while the button is up. `abs(iMouse.zw)` is
/// the position of the last click: `z` is positive while the button is down, `w` only in the frame
/// of the click, and both are negative otherwise. All are 0 until the first click, so handle that
/// case.
uniform vec4 iMouse; // = mouse, or vec2 vec3
/// The local date and time: `x` is the full year, `y` the month from 0 for January to 11, `z` the
/// day from 1 to 31. `w` is the seconds since midnight, with a fraction except in Sound.
uniform vec4 iDate; // = date
/// The audio sample rate in samples per second: 44100.
uniform float iSampleRate; // = sample-rate, or int uint
/// The playback position of the video or music of each channel, in seconds. 0 for textures,
/// buffers, the keyboard, cube maps and volumes.
uniform float iChannelTime[4]; // = channel-time
/// The size of the input of each channel, in texels: width, height, and the depth of a volume,
/// otherwise 1. A buffer has the size of the output, the keyboard 256 by 3, music 512 by 2. All 0
/// for a cube map that is not a pass, and for an empty channel.
uniform vec3 iChannelResolution[4]; // = channel-resolution
/// The input of channel 0 of the pass: a `sampler2D`, for a cube map a `samplerCube`, for a volume
/// a `sampler3D`. It is declared even if the channel is empty. A pass that reads itself, or a
/// buffer drawn after it, gets the previous frame. The keyboard is 256 by 3 texels: x is the key
/// code, and the rows are held, pressed in this frame, and toggled.
uniform sampler2D iChannel0; // = channel
/// The input of channel 1 of the pass: a `sampler2D`, for a cube map a `samplerCube`, for a volume
/// a `sampler3D`. It is declared even if the channel is empty. A pass that reads itself, or a
/// buffer drawn after it, gets the previous frame. The keyboard is 256 by 3 texels: x is the key
/// code, and the rows are held, pressed in this frame, and toggled.
uniform sampler2D iChannel1; // = channel
/// The input of channel 2 of the pass: a `sampler2D`, for a cube map a `samplerCube`, for a volume
/// a `sampler3D`. It is declared even if the channel is empty. A pass that reads itself, or a
/// buffer drawn after it, gets the previous frame. The keyboard is 256 by 3 texels: x is the key
/// code, and the rows are held, pressed in this frame, and toggled.
uniform sampler2D iChannel2; // = channel
/// The input of channel 3 of the pass: a `sampler2D`, for a cube map a `samplerCube`, for a volume
/// a `sampler3D`. It is declared even if the channel is empty. A pass that reads itself, or a
/// buffer drawn after it, gets the previous frame. The keyboard is 256 by 3 texels: x is the key
/// code, and the rows are held, pressed in this frame, and toggled.
uniform sampler2D iChannel3; // = channel
#ifdef SHADER_DECLARES
// programs that provide the same uniforms to their own shaders, and the name of iTime until 2017
uniform float iGlobalTime; // = time
uniform vec4 iResolution; // = resolution-and-pixel
// Sound and Image only
/// Sound only: the time of the first sample of the current block, in seconds. The time passed to
/// `mainSound` already includes it.
uniform float iTimeOffset;
/// Sound only: the number of the first sample of the current block. The number passed to
/// `mainSound` already includes it.
uniform int iSampleOffset;
/// Image only: channel 0 as a struct. `iCh0.sampler` is `iChannel0`, `iCh0.size` its size in
/// texels, `iCh0.time` its playback position in seconds, and `iCh0.loaded` is 1 when the input is
/// bound and loaded.
uniform Channel iCh0;
/// Image only: channel 1 as a struct. `iCh1.sampler` is `iChannel1`, `iCh1.size` its size in
/// texels, `iCh1.time` its playback position in seconds, and `iCh1.loaded` is 1 when the input is
/// bound and loaded.
uniform Channel iCh1;
/// Image only: channel 2 as a struct. `iCh2.sampler` is `iChannel2`, `iCh2.size` its size in
/// texels, `iCh2.time` its playback position in seconds, and `iCh2.loaded` is 1 when the input is
/// bound and loaded.
uniform Channel iCh2;
/// Image only: channel 3 as a struct. `iCh3.sampler` is `iChannel3`, `iCh3.size` its size in
/// texels, `iCh3.time` its playback position in seconds, and `iCh3.loaded` is 1 when the input is
/// bound and loaded.
uniform Channel iCh3;
#endif
