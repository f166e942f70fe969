// The ratio of the circumference of a circle to its diameter.
const float PI = 3.14159265359;
// A full turn, in radians.
const float TAU = 6.28318530718;
// A full turn, in radians.
const float TWO_PI = 6.28318530718;
// A quarter of a turn, in radians.
const float HALF_PI = 1.57079632679;
// The golden ratio.
const float PHI = 1.61803398875;
// The golden ratio.
const float GOLDEN_RATIO = 1.61803398875;
// The square root of 2.
const float SQRT2 = 1.41421356237;
// The square root of 3.
const float SQRT3 = 1.73205080757;
// Radians per degree.
const float DEG2RAD = 0.01745329252;
// Degrees per radian.
const float RAD2DEG = 57.2957795131;
// A distance that counts as none.
const float EPSILON = 0.001;
// A distance that counts as none.
const float EPS = 0.001;
// The distance at which a ray has hit a surface.
const float SURF_DIST = 0.001;
// The distance at which a ray has hit a surface.
const float SURFACE_DIST = 0.001;
// The distance at which a ray starts.
const float MIN_DIST = 0.0;
// The distance at which a ray is given up.
const float MAX_DIST = 100.0;
// The distance at which a ray is given up.
const float MAX_DISTANCE = 100.0;
// The most steps of a ray.
const int MAX_STEPS = 100;
// The most steps of a ray.
const int MAX_MARCHING_STEPS = 100;
// The most iterations of a loop.
const int MAX_ITERATIONS = 100;
// The most iterations of a loop.
const int MAX_ITER = 100;
// The number of octaves of noise.
const int OCTAVES = 5;
// The number of octaves of noise.
const int NUM_OCTAVES = 5;
