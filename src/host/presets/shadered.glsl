// SHADERed
//
// An editor of shader projects: an XML file lists passes, whose shaders are files beside it, and
// says what each uniform holds. `shaderport` gives a uniform that holds a value of the system the
// names below. The texts declare all that they use.
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
