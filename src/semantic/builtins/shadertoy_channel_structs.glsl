uniform struct { sampler2D sampler; vec3 size; float time; int loaded; } iCh0;
uniform struct { sampler2D sampler; vec3 size; float time; int loaded; } iCh1;
uniform struct { sampler2D sampler; vec3 size; float time; int loaded; } iCh2;
uniform struct { sampler2D sampler; vec3 size; float time; int loaded; } iCh3;
