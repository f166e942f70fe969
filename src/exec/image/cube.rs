//! Cube maps: the face and position that a direction hits, and texels across the edges of faces.

use super::level::major;

/// The face that a direction hits, and the coordinates on it, from 0 to 1.
pub(super) fn face([x, y, z]: [f32; 3]) -> (u32, [f32; 2]) {
    let [far_x, far_y, far_z] = [x.abs(), y.abs(), z.abs()];
    let (face, s, t) = if far_z >= far_x && far_z >= far_y {
        if z < 0.0 { (5, -x, -y) } else { (4, x, -y) }
    } else if far_y >= far_x {
        if y < 0.0 { (3, x, -z) } else { (2, x, z) }
    } else if x < 0.0 {
        (1, z, -y)
    } else {
        (0, -z, -y)
    };
    let scale = 0.5 / major([x, y, z]);
    (face, [s * scale + 0.5, t * scale + 0.5])
}

/// The direction to a point of a face, with coordinates from -1 to 1; beyond that range it hits
/// another face.
fn direction(face: u32, [s, t]: [f32; 2]) -> [f32; 3] {
    match face {
        0 => [1.0, -t, -s],
        1 => [-1.0, -t, s],
        2 => [s, 1.0, t],
        3 => [s, -1.0, -t],
        4 => [s, -t, 1.0],
        _ => [-s, -t, -1.0],
    }
}

/// The index of a texel of a face, which may be one beyond an edge, on the adjacent face. `None`
/// beyond a corner, where only three faces meet.
pub(super) fn texel(face_number: u32, [column, row]: [i32; 2], side: u32) -> Option<usize> {
    let inside = |at: i32| u32::try_from(at).is_ok_and(|at| at < side);
    let number = |face: u32, column: i32, row: i32| {
        let texel = (row as usize) * side as usize + column as usize;
        face as usize * side as usize * side as usize + texel
    };
    match (inside(column), inside(row)) {
        (true, true) => Some(number(face_number, column, row)),
        (false, false) => None,
        _ => {
            let center = |at: i32| (2 * at + 1) as f32 / side as f32 - 1.0;
            let (next, [s, t]) = face(direction(face_number, [center(column), center(row)]));
            let at = |part: f32| ((part * side as f32) as i32).clamp(0, side as i32 - 1);
            Some(number(next, at(s), at(t)))
        }
    }
}
