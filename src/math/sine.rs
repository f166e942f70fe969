//! The sine in double precision.

/// The sine of an angle in radians. The precision decreases with the magnitude of the angle.
pub fn sine(angle: f64) -> f64 {
    let cycles = angle / std::f64::consts::TAU;
    let mut x = (cycles - cycles.round()) * std::f64::consts::TAU;
    let quarter = std::f64::consts::FRAC_PI_2;
    if x > quarter {
        x = 2.0 * quarter - x;
    } else if x < -quarter {
        x = -2.0 * quarter - x;
    }
    let square = x * x;
    // The Taylor series, evaluated from the smallest term on.
    let factors = [21.0, 19.0, 17.0, 15.0, 13.0, 11.0, 9.0, 7.0, 5.0, 3.0];
    let sum = factors
        .iter()
        .fold(1.0, |sum, n| 1.0 - square / (n * (n - 1.0)) * sum);
    x * sum
}
