//! Tests of bounds on fields with known slopes.

use super::{DistanceField, Slope, SlopeObstacle, slope};
use crate::calls::Calls;
use crate::ranges::{Query, Ranges};
use crate::reaching_definitions::ReachingDefinitions;
use crate::test_shader::checked;
use shaderlint_ir::lower;
use shaderlint_semantic::FunctionRef;

/// The slope of `map` in some code.
fn slope_of(code: &str) -> Slope {
    let main = "void mainImage(out vec4 o, vec2 q) { o = vec4(map(vec3(q, iTime))); }";
    slope_in(&format!("{code}\n{main}"))
}

/// The slope of `map` in a shader.
fn slope_in(code: &str) -> Slope {
    let analysis = checked(code);
    let module = lower(&analysis.program);
    let calls = Calls::of(&module);
    let defs = ReachingDefinitions::of(&analysis.program, &module, &calls);
    let query = Query {
        program: &analysis.program,
        module: &module,
        defs: &defs,
        ranges: &Ranges::default(),
    };
    let names = &analysis.program.names;
    let is_map = |f: &shaderlint_semantic::Function| names.text(f.name) == "map";
    let at = analysis.program.functions.iter().position(is_map).unwrap();
    let function = FunctionRef(at as u32);
    let point = module.parameters(module.function(function).unwrap())[0];
    let field = DistanceField {
        function,
        point,
        scalar: 0,
    };
    slope(query, field)
}

/// Asserts a slope of `map`, given by its body.
#[track_caller]
fn check(body: &str, expected: f64) {
    check_code(&format!("float map(vec3 p) {{ {body} }}"), expected);
}

#[track_caller]
fn check_code(code: &str, expected: f64) {
    check_slope(slope_of(code), expected, code);
}

#[track_caller]
fn check_slope(slope: Slope, expected: f64, code: &str) {
    match slope {
        Slope::AtMost(most) => {
            assert!((most - expected).abs() <= expected * 1e-4, "{most}: {code}");
        }
        Slope::Unknown(obstacle) => panic!("{obstacle:?}: {code}"),
    }
}

/// Asserts that nothing is known of the slope of `map`, given by its body.
#[track_caller]
fn check_unknown(body: &str, expected: SlopeObstacle) {
    match slope_of(&format!("float map(vec3 p) {{ {body} }}")) {
        Slope::Unknown(obstacle) => assert_eq!(obstacle.why, expected, "{body}"),
        Slope::AtMost(most) => panic!("{most}: {body}"),
    }
}

const ROTATION: &str = "mat2(cos(iTime), -sin(iTime), sin(iTime), cos(iTime))";
const BOX: &str = "vec3 d = abs(p) - vec3(1.0, 2.0, 3.0);
    return length(max(d, 0.0)) + min(max(d.x, max(d.y, d.z)), 0.0);";

#[test]
fn exact_distances() {
    check("return length(p) - 1.0;", 1.0);
    check("return length(p.xz) - 1.0;", 1.0);
    check("return p.y;", 1.0);
    check("return dot(p, vec3(0.6, 0.8, 0.0)) - 2.0;", 1.0);
    check("return dot(p, normalize(vec3(1.0, 2.0, 3.0)));", 1.0);
    check("return length(vec2(length(p.xz) - 1.0, p.y)) - 0.2;", 1.0);
    check(BOX, 1.0);
    check("return length(max(abs(p) - vec3(1.0), 0.0)) - 0.1;", 1.0);
    // Capped cylinder.
    check(
        "vec2 d = abs(vec2(length(p.xz), p.y)) - vec2(0.5, 1.0);
        return min(max(d.x, d.y), 0.0) + length(max(d, 0.0)) - 0.1;",
        1.0,
    );
    // Link.
    check(
        "vec3 q = vec3(p.x, max(abs(p.y) - 0.5, 0.0), p.z);
        return length(vec2(length(q.xy) - 0.4, q.z)) - 0.1;",
        1.0,
    );
    // Box frame.
    check(
        "float e = 0.1; p = abs(p) - vec3(1.0); vec3 q = abs(p + e) - e; return min(min(
        length(max(vec3(p.x, q.y, q.z), 0.0)) + min(max(p.x, max(q.y, q.z)), 0.0),
        length(max(vec3(q.x, p.y, q.z), 0.0)) + min(max(q.x, max(p.y, q.z)), 0.0)),
        length(max(vec3(q.x, q.y, p.z), 0.0)) + min(max(q.x, max(q.y, p.z)), 0.0));",
        1.0,
    );
    // Extrusion.
    check(
        "float d = length(p.xy) - 0.5; vec2 w = vec2(d, abs(p.z) - 1.0);
        return min(max(w.x, w.y), 0.0) + length(max(w, 0.0));",
        1.0,
    );
}

#[test]
fn bounds_of_distances() {
    check(
        "vec3 d = abs(p) - 1.0; return max(d.x, max(d.y, d.z));",
        1.0,
    );
    // Hexagonal and triangular prism.
    check(
        "vec3 q = abs(p); return max(q.z - 0.5, max(q.x * 0.866025 + q.y * 0.5, q.y) - 1.0);",
        1.0,
    );
    check(
        "vec3 q = abs(p);
        return max(q.z - 0.5, max(q.x * 0.866025 + p.y * 0.5, -p.y) - 0.5);",
        1.0,
    );
    // Octahedron, cone.
    check(
        "p = abs(p); return (p.x + p.y + p.z - 1.0) * 0.57735027;",
        1.0,
    );
    check("return dot(vec2(0.8, 0.6), vec2(length(p.xz), p.y));", 1.0);
    // Ellipsoid.
    check(
        "vec3 r = vec3(1.0, 0.5, 0.7); float k0 = length(p / r);
        return (k0 - 1.0) * min(min(r.x, r.y), r.z);",
        1.0,
    );
}

#[test]
fn segments_with_any_ends() {
    let body = "vec3 pa = p - a, ba = b - a;
        float h = clamp(dot(pa, ba) / dot(ba, ba), 0.0, 1.0); return length(pa - ba * h) - 0.1;";
    check(
        &format!("vec3 a = vec3(0.0), b = vec3(1.0, 2.0, 0.5); {body}"),
        1.0,
    );
    check(
        &format!("vec3 a = iMouse.xyz, b = iResolution; {body}"),
        1.0,
    );
    check(
        &format!("vec3 a = vec3(sin(iTime), 0.2, 0.0), b = vec3(1.0); {body}"),
        1.0,
    );
}

#[test]
fn frames_are_rotated() {
    check(&format!("p.xz *= {ROTATION}; {BOX}"), 1.0);
    check(
        &format!(
            "p.xz *= {ROTATION}; p.yz *= mat2(cos(1.0), -sin(1.0), sin(1.0), cos(1.0)); {BOX}"
        ),
        1.0,
    );
    check(
        &format!(
            "for (int i = 0; i < 3; i++) {{ p = abs(p) - 0.5; p.xz *= {ROTATION}; p.xy *= {ROTATION}; }} {BOX}"
        ),
        1.0,
    );
    check(
        "float c = cos(iTime), s = sin(iTime); vec2 r = vec2(c * p.x - s * p.y, s * p.x + c * p.y);
        return max(abs(r.x) - 1.0, abs(r.y) - 0.5);",
        1.0,
    );
    check(
        "for (int i = 0; i < 4; i++) { p = abs(p) - 0.5; p.xz *= mat2(cos(0.7), sin(0.7), -sin(0.7), cos(0.7)); }
        return length(p) - 0.5;",
        1.0,
    );
}

#[test]
fn repetition_is_continuous_if_the_shape_is_mirrored() {
    check("p = mod(p, 4.0) - 2.0; return length(p) - 1.0;", 1.0);
    check(&format!("p.xz = mod(p.xz + 2.0, 4.0) - 2.0; {BOX}"), 1.0);
    check(
        &format!("p.xz = p.xz - 4.0 * round(p.xz / 4.0); {BOX}"),
        1.0,
    );
    check_unknown(
        "p.x = mod(p.x, 4.0) - 1.5; return length(p) - 1.0;",
        SlopeObstacle::Discontinuity,
    );
    check_unknown(
        "float id = floor(p.x); p.x = fract(p.x) - 0.5; return length(p) - 0.1 * sin(id);",
        SlopeObstacle::Discontinuity,
    );
    check_unknown(
        "return p.x < 0.0 ? p.y : p.y + 0.5;",
        SlopeObstacle::Discontinuity,
    );
    check(
        "float d = length(p) - 1.0; if (p.y < d) d = p.y; return d;",
        1.0,
    );
    // Menger sponge.
    check(
        "vec3 q = abs(p) - 1.0; float s = 1.0;
        float d = length(max(q, 0.0)) + min(max(q.x, max(q.y, q.z)), 0.0);
        for (int m = 0; m < 3; m++) {
            vec3 a = mod(p * s, 2.0) - 1.0; s *= 3.0; vec3 r = abs(1.0 - 3.0 * abs(a));
            float da = max(r.x, r.y), db = max(r.y, r.z), dc = max(r.z, r.x);
            d = max(d, (min(da, min(db, dc)) - 1.0) / s); }
        return d;",
        1.0,
    );
}

#[test]
fn smooth_unions() {
    let blend = |code: &str| {
        let map = "float map(vec3 p) { return smin(length(p) - 1.0, p.y, 0.3); }";
        check_code(
            &format!("float smin(float a, float b, float k) {{ {code} }} {map}"),
            1.0,
        );
        let map = "float map(vec3 p) {
            float d = smin(length(p) - 1.0, length(p - 1.0) - 2.0, 0.2);
            return smin(d, p.y, 0.3); }";
        check_code(
            &format!("float smin(float a, float b, float k) {{ {code} }} {map}"),
            1.0,
        );
    };
    blend(
        "float h = clamp(0.5 + 0.5 * (b - a) / k, 0.0, 1.0); return mix(b, a, h) - k * h * (1.0 - h);",
    );
    blend("float h = max(k - abs(a - b), 0.0) / k; return min(a, b) - h * h * k * 0.25;");
    let exponential = |code: &str| {
        let map = "float map(vec3 p) { return smin(length(p) - 1.0, p.y, 8.0); }";
        check_code(
            &format!("float smin(float a, float b, float k) {{ {code} }} {map}"),
            1.0,
        );
    };
    exponential("return -log(exp(-k * a) + exp(-k * b)) / k;");
    exponential("return -log2(exp2(-k * a) + exp2(-k * b)) / k;");
    check_code(
        "float smin(float a, float b, float k) { float h = max(k - abs(a - b), 0.0) / k;
            return min(a, b) - h * h * h * k / 6.0; }
        float map(vec3 p) { return smin(length(p) - 1.0, p.y, 0.3); }",
        1.0,
    );
}

#[test]
fn steeper_fields() {
    check("p *= 2.0; return length(p) - 1.0;", 2.0);
    check("return (length(p * 2.0) - 1.0) / 2.0;", 1.0);
    check("return length(p) - 1.0 + 0.1 * sin(p.x * 2.0);", 1.2);
    // Twist, bend and an unbounded displacement.
    for body in [
        "float c = cos(p.y), s = sin(p.y); p.xz = mat2(c, -s, s, c) * p.xz; return p.x;",
        "float c = cos(p.x), s = sin(p.x); p.xy = mat2(c, -s, s, c) * p.xy; return p.y;",
        "return length(p) - p.x * p.y;",
    ] {
        check_unknown(body, SlopeObstacle::Unbounded);
    }
    // Julia sets.
    check_unknown(
        "vec3 z = p; float dr = 1.0, r = 0.0;
        for (int i = 0; i < 4; i++) { r = length(z); if (r > 2.0) break;
            dr = pow(r, 7.0) * 8.0 * dr + 1.0; z = z * r + p; }
        return 0.5 * log(r) * r / dr;",
        SlopeObstacle::Unbounded,
    );
    check_unknown(
        "return texture(iChannel0, p.xz).x;",
        SlopeObstacle::Operation,
    );
}

#[test]
fn globals_have_the_value_of_their_only_assignment() {
    let main = "void mainImage(out vec4 o, vec2 q) { turn = mat2(cos(iTime), -sin(iTime), sin(iTime), cos(iTime)); size = q.x;
        o = vec4(map(vec3(q, iTime))); size = 2.0; }";
    let map = "mat2 turn; float size; float map(vec3 p) { p.xy *= turn; return abs(p.x) - 1.0; }";
    let code = format!("{map} {main}");
    check_slope(slope_in(&code), 1.0, &code);
    // Two assignments.
    let map = "mat2 turn; float size; float map(vec3 p) { return size * p.x; }";
    assert!(matches!(
        slope_in(&format!("{map} {main}")),
        Slope::Unknown(_)
    ));
}

#[test]
fn several_results_and_iterations() {
    check_code(
        "vec2 join(vec2 a, vec2 b) { return a.x < b.x ? a : b; }
        vec2 both(vec3 p) { return join(vec2(length(p) - 1.0, 1.0), vec2(p.y, 2.0)); }
        float map(vec3 p) { return both(p).x; }",
        1.0,
    );
    check(
        "float d = 9.0; for (int i = 0; i < 9; i++) { if (float(i) > iTime) break; d = min(d, length(p - float(i))); } return d;",
        1.0,
    );
    check("if (p.y > 1.0) return p.y; return max(p.y, 1.0);", 1.0);
}

/// Asserts that the body of a function of `p3` is proved to be a distance.
#[track_caller]
fn check_distance(name: &str, body: &str) {
    let slope = slope_of(&format!("float map(vec3 p3) {{ {body} }}"));
    assert!(slope.is_distance(), "{name}: {slope:?}");
}

/// The exact distances of shapes whose distance is put together from parts: where the choice between
/// parts changes, they are equal.
#[test]
fn exact_distances_by_parts() {
    check_distance(
        "cone",
        "vec3 p = p3;
        vec2 c = vec2(0.5, 0.8660254); float h = 1.3;
        vec2 q = h * vec2(c.x / c.y, -1.0);
        vec2 w = vec2(length(p.xz), p.y);
        vec2 a = w - q * clamp(dot(w, q) / dot(q, q), 0.0, 1.0);
        vec2 b = w - q * vec2(clamp(w.x / q.x, 0.0, 1.0), 1.0);
        float k = sign(q.y);
        float d = min(dot(a, a), dot(b, b));
        float s = max(k * (w.x * q.y - w.y * q.x), k * (w.y - q.y));
        return sqrt(d) * sign(s);",
    );
    check_distance(
        "cone without end",
        "vec3 p = p3;
        vec2 c = vec2(0.6, 0.8);
        vec2 q = vec2(length(p.xz), -p.y);
        float d = length(q - c * max(dot(q, c), 0.0));
        return d * ((q.x * c.y - q.y * c.x < 0.0) ? -1.0 : 1.0);",
    );
    check_distance(
        "cone with round ends",
        "vec3 p = p3;
        float r1 = 0.7, r2 = 0.3, h = 1.2;
        float b = (r1 - r2) / h;
        float a = sqrt(1.0 - b * b);
        vec2 q = vec2(length(p.xz), p.y);
        float k = dot(q, vec2(-b, a));
        if (k < 0.0) return length(q) - r1;
        if (k > a * h) return length(q - vec2(0.0, h)) - r2;
        return dot(q, vec2(a, b)) - r1;",
    );
    check_distance(
        "octahedron",
        "vec3 p = p3;
        float s = 1.1;
        p = abs(p);
        float m = p.x + p.y + p.z - s;
        vec3 q;
        if (3.0 * p.x < m) q = p.xyz;
        else if (3.0 * p.y < m) q = p.yzx;
        else if (3.0 * p.z < m) q = p.zxy;
        else return m * 0.57735027;
        float k = clamp(0.5 * (q.z - q.y + s), 0.0, s);
        return length(vec3(q.x, q.y - s + k, q.z - k));",
    );
}

#[test]
fn exact_flat_distances_by_parts() {
    check_distance(
        "equilateral triangle",
        "vec2 p = p3.xy; float r = 1.0; const float k = 1.7320508;
        p.x = abs(p.x) - r;
        p.y = p.y + r / k;
        if (p.x + k * p.y > 0.0) p = vec2(p.x - k * p.y, -k * p.x - p.y) / 2.0;
        p.x -= clamp(p.x, -2.0 * r, 0.0);
        return -length(p) * sign(p.y);",
    );
    check_distance(
        "triangle",
        "vec2 p = p3.xy, p0 = vec2(-0.5, -0.6), p1 = vec2(0.9, -0.2), p2 = vec2(0.1, 0.8);
        vec2 e0 = p1 - p0, e1 = p2 - p1, e2 = p0 - p2;
        vec2 v0 = p - p0, v1 = p - p1, v2 = p - p2;
        vec2 pq0 = v0 - e0 * clamp(dot(v0, e0) / dot(e0, e0), 0.0, 1.0);
        vec2 pq1 = v1 - e1 * clamp(dot(v1, e1) / dot(e1, e1), 0.0, 1.0);
        vec2 pq2 = v2 - e2 * clamp(dot(v2, e2) / dot(e2, e2), 0.0, 1.0);
        float s = sign(e0.x * e2.y - e0.y * e2.x);
        vec2 d = min(min(vec2(dot(pq0, pq0), s * (v0.x * e0.y - v0.y * e0.x)),
        vec2(dot(pq1, pq1), s * (v1.x * e1.y - v1.y * e1.x))),
        vec2(dot(pq2, pq2), s * (v2.x * e2.y - v2.y * e2.x)));
        return -sqrt(d.x) * sign(d.y);",
    );
    check_distance(
        "arc",
        "vec2 p = p3.xy, sc = vec2(0.8, 0.6); float ra = 0.8, rb = 0.1;
        p.x = abs(p.x);
        return ((sc.y * p.x > sc.x * p.y) ? length(p - sc * ra) : abs(length(p) - ra)) - rb;",
    );
    check_distance(
        "pie",
        "vec2 p = p3.xy, c = vec2(0.8, 0.6); float r = 0.9;
        p.x = abs(p.x);
        float l = length(p) - r;
        float m = length(p - c * clamp(dot(p, c), 0.0, r));
        return max(l, m * sign(c.y * p.x - c.x * p.y));",
    );
    check_distance(
        "hollow sphere, cut",
        "vec3 p = p3;
        float r = 1.0, h = 0.3, t = 0.1; float w = sqrt(r * r - h * h);
        vec2 q = vec2(length(p.xz), p.y);
        return ((h * q.x < w * q.y) ? length(q - vec2(w, h)) : abs(length(q) - r)) - t;",
    );
    check_distance(
        "solid angle",
        "vec3 p = p3;
        vec2 c = vec2(0.6, 0.8); float ra = 1.0;
        vec2 q = vec2(length(p.xz), p.y);
        float l = length(q) - ra;
        float m = length(q - c * clamp(dot(q, c), 0.0, ra));
        return max(l, m * sign(c.y * q.x - c.x * q.y));",
    );
    check_distance(
        "rhombus",
        "vec2 p = abs(p3.xy), b = vec2(0.9, 0.5);
        float h = clamp((b.x * (b.x - 2.0 * p.x) - b.y * (b.y - 2.0 * p.y)) / dot(b, b), -1.0, 1.0);
        float d = length(p - 0.5 * b * vec2(1.0 - h, 1.0 + h));
        return d * sign(p.x * b.y + p.y * b.x - b.x * b.y);",
    );
    check_distance(
        "vesica",
        "vec2 p = abs(p3.xy); float r = 1.0, d = 0.5; float b = sqrt(r * r - d * d);
        return ((p.y - b) * d > p.x * b) ? length(p - vec2(0.0, b)) : length(p - vec2(-d, 0.0)) - r;",
    );
}

#[test]
fn parts_that_are_not_equal_are_found() {
    for body in [
        // The axis of a cone, of which one side was forgotten; an arc with a direction of another length.
        "vec2 q = vec2(length(p.xz), -p.y), c = vec2(0.6, 0.8);
        return length(q - c * max(dot(q, c), 0.0)) * sign(q.x * c.y - q.y * c.x + 0.1);",
        "p.x = abs(p.x); vec2 c = vec2(0.8, 0.7);
        return c.y * p.x > c.x * p.y ? length(p.xy - c) : abs(length(p.xy) - 1.0);",
        // Two conditions that change on the same surface.
        "float s = p.x < 0.0 ? 1.0 : 0.0, t = p.x * 2.0 + p.x < 0.0 ? s : 0.0; return p.y + t;",
        "float s = p.x < 0.0 ? 1.0 : 0.0, t = -p.x > 0.0 ? s : 0.0; return p.y + t;",
        "return p.y + sign(p.x) * 0.1;",
        // A hexagon that is cut off too early.
        "p.xy = abs(p.xy); vec2 k = vec2(-0.8660254, 0.5); p.xy -= 2.0 * min(dot(k, p.xy), 0.0) * k;
        p.xy -= vec2(clamp(p.x, -0.4, 0.4), 1.0); return length(p.xy) * sign(p.y);",
    ] {
        check_unknown(body, SlopeObstacle::Discontinuity);
    }
}

#[test]
fn repetition_with_limits() {
    check(
        "p -= 2.0 * clamp(round(p / 2.0), vec3(-3.0, -1.0, 0.0), vec3(3.0, 1.0, 0.0)); return length(p) - 0.5;",
        1.0,
    );
    check(
        &format!("p.xz -= 2.0 * clamp(floor(p.xz / 2.0 + 0.5), -2.0, 2.0); {BOX}"),
        1.0,
    );
    // Not mirrored, or with a limit between two cells.
    check_unknown(
        "p -= 2.0 * clamp(round(p / 2.0), -3.0, 3.0); return length(p - 0.1) - 0.5;",
        SlopeObstacle::Discontinuity,
    );
    check_unknown(
        "p -= 2.0 * clamp(round(p / 2.0), -2.5, 2.5); return length(p) - 0.5;",
        SlopeObstacle::Discontinuity,
    );
}
