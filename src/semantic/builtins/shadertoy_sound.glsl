uniform float iChannelTime[4]; uniform float iTimeOffset; uniform int iSampleOffset;
uniform vec4 iDate; uniform float iSampleRate; uniform vec3 iChannelResolution[4];
