//! The order of evaluation, with a table for each kind of expression. The values are those of Chromium
//! (ANGLE's SPIR-V on SwiftShader); `ir::lower::order` describes the rule.

use super::tests::row;

/// Functions with side effects. `log` records in which order numbers were evaluated.
const HEAD: &str = "#version 300 es
    precision highp float; precision highp int; out vec4 color;
    struct S { int m; ivec2 n; int e[3]; };
    int g = 1, log = 0; int a[4]; ivec4 v; S s;
    int f() { g = 7; return 2; }
    float ff() { g = 7; return 2.0; }
    int set(int x) { g = x; return x; }
    int bump() { g += 1; return g; }
    int rec(int d) { log = log * 10 + d; return d; }
    int inc(inout int x) { x += 1; return x; }
    int add(int x, int y) { return x * 10 + y; }
    int both(inout int x, int y) { x += 1; return y * 10 + x; }
    bool yes(int d) { log = log * 10 + d; return true; }
    bool no(int d) { log = log * 10 + d; return false; }\n";

/// Runs each line `statements => value`; the statements assign the value to `r`.
#[track_caller]
fn check(table: &str) {
    for line in table.lines().map(str::trim).filter(|l| !l.is_empty()) {
        let (statements, value) = line.split_once(" => ").unwrap();
        let main =
            format!("void main() {{ int r = 0, i = 1, x = 1; {statements} color = vec4(r); }}");
        let expected: f32 = value.parse().unwrap();
        let found = row(&format!("{HEAD}{main}"), 1)[0][0];
        assert_eq!(found, expected, "{statements}");
    }
}

/// A variable that is itself an operand is read after the other operand; a value computed from it is not.
#[test]
fn variable_operands_are_read_after_the_other_operand() {
    check(
        "r = g * 10 + f(); => 12
        r = f() * 10 + g; => 27
        r = g + f(); => 9
        r = (g) + f(); => 9
        r = g + 0 * f() + g; => 14
        g = 9; r = g - (g = 4); => 0
        r = 1 << (x = 3); r = x << (x = 2); => 8
        g = 2; r = int(g == f()) * 10 + int(g < f()); => 0
        r = 90 + (-g) * 10 + f(); => 82
        v = ivec4(1); r = (v * 10 + (v = ivec4(5))).x; => 15
        v = ivec4(1); r = (v.xy + (v = ivec4(5)).xy).x; => 10
        s.m = 1; r = s.m + (s.m = 4); => 8
        g = 0; r = bump() + bump() * 10 + bump() * 100; => 321",
    );
}

#[test]
fn increments_are_evaluated_in_browser_order() {
    check(
        "r = x++ * 10 + x; => 12
        r = x * 10 + x++; => 11
        r = x + ++x; => 4
        r = x++ + x++ * 10; => 21
        x = 4; r = (x--) * 10 + (++x); => 44
        x = x++; r = x; => 1
        x = (++x) * 10 + x++; r = x; => 22
        a[1] = 4; a[i]++; r = a[1] * 10 + a[i]++; => 55
        a[1] = 1; r = a[rec(1)]++; r = log * 10 + r + a[1]; => 13",
    );
}

/// Arguments are evaluated from left to right; variables are passed with the values that they have then.
#[test]
fn arguments_are_evaluated_from_left_to_right() {
    check(
        "r = add(g, f()); => 72
        r = add(f(), g); => 27
        r = add(g + 0 * x, f()); => 12
        r = add(x, x++); => 21
        r = add(x++, x); => 12
        r = add(x, inc(x)); => 22
        g = 0; r = add(bump(), bump()); => 12
        r = both(x, x); => 12
        r = both(x, x++) + 100 * x; => 313
        r = both(g, f()); => 28
        r = min(g * 10, f() * 10) + max(g, f()); => 17
        r = clamp(f(), g, 9); => 7
        a[1] = 3; r = inc(a[i]) * 10 + a[1]; => 44
        a[1] = 3; a[2] = 7; r = both(a[i], i++) + a[1] * 100; => 414",
    );
}

#[test]
fn constructor_arguments_are_evaluated_from_left_to_right() {
    check(
        "ivec2 q = ivec2(g, f()); r = q.x * 10 + q.y; => 72
        ivec3 q = ivec3(g, f(), g); r = q.x * 100 + q.y * 10 + q.z; => 727
        vec2 q = vec2(g, f()); r = int(q.x) * 10 + int(q.y); => 72
        S q = S(g, ivec2(f(), g), int[3](0, 0, 0)); r = q.m * 100 + q.n.x * 10 + q.n.y; => 727
        int q[3] = int[3](g, f(), g); r = q[0] * 100 + q[1] * 10 + q[2]; => 727
        mat2 q = mat2(float(g), ff(), float(g), 0.0); r = int(q[0].x) * 100 + int(q[0].y) * 10 + int(q[1].x); => 127
        v = ivec4(1, 2, 3, 4); ivec4 q = ivec4(v.xy, (v = ivec4(5)).xy); r = q.x * 10 + q.z; => 55",
    );
}

/// The place on the left is determined before the right side is evaluated, and written after it.
#[test]
fn the_left_side_is_determined_before_the_right_side() {
    check(
        "a[g] = f(); r = a[1] * 10 + g; => 27
        a[i++] = i; r = a[1] * 10 + a[2]; => 20
        a[i] = i++ + 4; r = a[0] * 100 + a[1] * 10 + a[2]; => 50
        a[rec(1)] = rec(2); r = log; => 12
        v[rec(1)] = rec(2); r = log; => 12
        s.e[rec(1)] = rec(2); r = log; => 12
        a[set(2)] = g + 1; r = a[2]; => 3
        a[x] = x = 2; r = a[1] * 10 + a[2]; => 20
        i = 0; s.e[i] = (i = 2, 5); r = s.e[0] * 10 + s.e[2]; => 50
        v = ivec4(1, 2, 3, 4); v.yx = v.xy; r = v.x * 10 + v.y; => 21",
    );
}

/// The value on the left is read after the right side is evaluated.
#[test]
fn compound_assignments_read_the_left_side_last() {
    check(
        "g += f(); r = g; => 9
        g = 3; g *= f(); r = g; => 14
        x += x++; r = x; => 3
        x += inc(x); r = x; => 4
        a[1] = 5; a[rec(1)] += rec(2); r = log * 10 + a[1]; => 127
        a[0] = 1; a[1] = 2; a[2] = 3; a[i] += i++; r = a[0] * 100 + a[1] * 10 + a[2]; => 133
        a[1] = 3; a[set(1)] += g; r = a[1]; => 4
        i = 0; v = ivec4(1, 2, 3, 4); v[i] += (i = 2, 5); r = v.x * 10 + v.z; => 63",
    );
}

#[test]
fn commas_and_conditionals_are_evaluated_in_order() {
    check(
        "r = (x = 3, x++, x * 2); => 8
        r = (rec(1), rec(2), rec(3)); r = log; => 123
        r = (f(), g) * 10 + (g = 4, g); => 74
        r = f() == 2 ? g : 0; => 7
        r = g * 10 + (x == 1 ? f() : 0); => 12
        r = (x == 1 ? g : 0) * 10 + f(); => 12
        r = (x == 1 ? 5 : f()) * 10 + g; => 51
        r = g + (g == 1 ? (g = 2) : (g = 3)); => 4",
    );
}

#[test]
fn logical_operators_short_circuit() {
    check(
        "bool b = no(1) && yes(2); r = log; => 1
        bool b = yes(1) && yes(2); r = log; => 12
        bool b = yes(1) || no(2); r = log; => 1
        bool b = yes(1) ^^ no(2); r = log; => 12
        r = int(g == 1 && f() == 2) * 10 + g; => 17
        r = g * 10 + int(g == 1 || f() == 2); => 11",
    );
}

#[test]
fn indices_are_evaluated_in_browser_order() {
    check(
        "a[1] = 3; a[3] = 4; r = a[g] * 10 + (g = 3); => 33
        a[1] = 3; a[2] = 4; r = a[i] * 10 + i++; => 31
        r = a[rec(1)] + a[rec(2)] + a[rec(3)]; r = log; => 123
        v = ivec4(1, 2, 3, 4); r = v[i] * 10 + v[i++ + 1]; => 23
        a[1] = 2; a[2] = 3; x = a[x] + a[x = 2]; r = x; => 5",
    );
}
