// SHADERed
//
// An editor for shader projects. An XML file lists the passes, whose shaders are separate files,
// and defines the value of each uniform. The shaders declare everything that they use. `shaderport`
// renames uniforms with a system value to the names below.
//
// source: files of the ShaderToy import (dfranx/PluginShadertoy); Names.cpp and SystemVariableManager.cpp of dfranx/SHADERed
// version: own
// names: some
// entry: main
uniform float port_sys_Time; // = time
uniform float port_sys_TimeDelta; // = delta
uniform int port_sys_FrameIndex; // = frame, or uint
uniform vec2 port_sys_ViewportSize; // = resolution
uniform vec2 port_sys_MousePosition; // = pointer-unit-zero
uniform vec4 port_sys_Mouse; // = pointer-unit-zero
uniform vec4 port_sys_MouseButton; // = mouse
uniform vec4 port_sys_CameraPosition; // = camera
uniform vec3 port_sys_CameraPosition3; // = camera
