// Values of a trace as text.

/** @typedef {number | string | boolean} Scalar a number, a truth value, `NaN`, `inf` or `-inf` */

/** How many scalars are shown. */
const MOST = 16;

/** @param {Scalar} scalar */
const short = (scalar) => (typeof scalar === 'number' ? String(Number(scalar.toPrecision(4))) : String(scalar));

/** A value in four digits. @param {Scalar[]} value */
export const inShort = (value) => value.slice(0, MOST).map(short).join(' ') + (value.length > MOST ? ' …' : '');

/** A value with all digits. @param {Scalar[]} value */
export const inFull = (value) => value.join(' ');

/** Whether a scalar is NaN or infinite. @param {Scalar[]} value */
export const isInvalid = (value) => value.some((scalar) => typeof scalar === 'string');
