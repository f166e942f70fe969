// ShaderToy
//
// The player of shadertoy.com puts its uniforms before each pass and calls `mainImage`, `mainSound`
// or `mainCubemap`. A file with such an entry is read as a pass of its own; this is for the files
// that go with it, and for programs that give the same uniforms to their own shaders.
//
// source: shadertoy.com, effect.js
// word: iResolution iTime iTimeDelta iFrame iFrameRate iMouse iDate iSampleRate iChannelTime iChannelResolution iChannel0 iChannel1 iChannel2 iChannel3
// version: any
// names: some
// entry: mainImage mainSound mainCubemap main
// ending: glsl frag fs shadertoy
/// The size of the picture in pixels: `x` is the width, `y` the height. `z` is the ratio of a
/// pixel's sides, and always 1.0 on the site. It is a `vec3`, so write `iResolution.xy` beside a
/// `vec2`. 1024 by 1024 in a Cubemap pass; not in Sound.
uniform vec3 iResolution; // = resolution, or vec2 ivec2
/// The seconds since the start or the last restart, without pauses. Not in Sound, where `mainSound`
/// gets the time as a parameter. Until 2017 its name was `iGlobalTime`, which no longer exists.
uniform float iTime; // = time
/// The seconds since the previous frame. It is 1/60 in the first frame, after a pause and for
/// frames drawn while paused. Not in Sound.
uniform float iTimeDelta; // = delta
/// How many frames this pass has drawn before this one; 0 in the first frame and after a restart,
/// which makes it the test for filling a buffer initially. It counts on for frames that are drawn
/// while paused. Not in Sound.
uniform int iFrame; // = frame, or uint float
/// The average number of frames per second. Not in Sound.
uniform float iFrameRate; // = frame-rate, or int uint
/// The mouse in whole pixels from the lower left corner, y up; not in Sound. `xy` is where it was
/// last with the button down, and stays while the button is up. `abs(iMouse.zw)` is where the last
/// click was: `z` is above 0 while the button is down, `w` only in the one frame of the click, and
/// both are negative otherwise. All are 0 until the first click, so treat that case.
uniform vec4 iMouse; // = mouse, or vec2 vec3
/// The local date and time: `x` is the full year, `y` the month from 0 for January to 11, `z` the
/// day from 1 to 31. `w` is the seconds since midnight, with a fraction except in Sound.
uniform vec4 iDate; // = date
/// The samples of sound per second; 44100.
uniform float iSampleRate; // = sample-rate, or int uint
/// For each of the four channels how far its video or music has played, in seconds. 0 for textures,
/// buffers, the keyboard, cube maps and volumes.
uniform float iChannelTime[4]; // = channel-time
/// For each of the four channels the size of what it is bound to, in texels: width, height, and the
/// depth of a volume, else 1. A buffer is as large as the picture, the keyboard 256 by 3, music 512
/// by 2. All 0 for a cube map that is not a pass, and where nothing is bound.
uniform vec3 iChannelResolution[4]; // = channel-resolution
/// What channel 0 of the pass is bound to: a `sampler2D`, for a cube map a `samplerCube`, for a
/// volume a `sampler3D`. It exists also where nothing is bound. A pass that reads itself, or a
/// buffer drawn after it, gets the previous frame. The keyboard is 256 by 3 texels: the key code is
/// x, and the rows are held, pressed in this frame, toggled.
uniform sampler2D iChannel0; // = channel
/// What channel 1 of the pass is bound to: a `sampler2D`, for a cube map a `samplerCube`, for a
/// volume a `sampler3D`. It exists also where nothing is bound. A pass that reads itself, or a
/// buffer drawn after it, gets the previous frame. The keyboard is 256 by 3 texels: the key code is
/// x, and the rows are held, pressed in this frame, toggled.
uniform sampler2D iChannel1; // = channel
/// What channel 2 of the pass is bound to: a `sampler2D`, for a cube map a `samplerCube`, for a
/// volume a `sampler3D`. It exists also where nothing is bound. A pass that reads itself, or a
/// buffer drawn after it, gets the previous frame. The keyboard is 256 by 3 texels: the key code is
/// x, and the rows are held, pressed in this frame, toggled.
uniform sampler2D iChannel2; // = channel
/// What channel 3 of the pass is bound to: a `sampler2D`, for a cube map a `samplerCube`, for a
/// volume a `sampler3D`. It exists also where nothing is bound. A pass that reads itself, or a
/// buffer drawn after it, gets the previous frame. The keyboard is 256 by 3 texels: the key code is
/// x, and the rows are held, pressed in this frame, toggled.
uniform sampler2D iChannel3; // = channel
#ifdef SHADER_DECLARES
// programs that give the same uniforms to their own shaders, and the name of the time until 2017
uniform float iGlobalTime; // = time
uniform vec4 iResolution; // = resolution-and-pixel
// of Sound and Image alone
/// In Sound only: the time of the first sample of the block that is being computed, in seconds.
/// `mainSound` gets a time that has it added already.
uniform float iTimeOffset;
/// In Sound only: the number of the first sample of the block that is being computed. `mainSound`
/// gets a number that has it added already.
uniform int iSampleOffset;
/// Channel 0 as one thing, in Image only: `iCh0.sampler` is `iChannel0`, `iCh0.size` its size in
/// texels, `iCh0.time` how far it has played in seconds, and `iCh0.loaded` 1 when it is bound and
/// loaded.
uniform Channel iCh0;
/// Channel 1 as one thing, in Image only: `iCh1.sampler` is `iChannel1`, `iCh1.size` its size in
/// texels, `iCh1.time` how far it has played in seconds, and `iCh1.loaded` 1 when it is bound and
/// loaded.
uniform Channel iCh1;
/// Channel 2 as one thing, in Image only: `iCh2.sampler` is `iChannel2`, `iCh2.size` its size in
/// texels, `iCh2.time` how far it has played in seconds, and `iCh2.loaded` 1 when it is bound and
/// loaded.
uniform Channel iCh2;
/// Channel 3 as one thing, in Image only: `iCh3.sampler` is `iChannel3`, `iCh3.size` its size in
/// texels, `iCh3.time` how far it has played in seconds, and `iCh3.loaded` 1 when it is bound and
/// loaded.
uniform Channel iCh3;
#endif
