// The trace of a pixel at a step: what each variable is by then.

/**
 * @typedef {{ at: string, pass: string | null, line: number, column: number, name: string, type: string,
 *   kind: 'written' | 'passed' | 'returned', function: string }} Site
 */

/** @typedef {{ site: Site, value: import('./values.js').Scalar[] }} Step */

/** What a pixel did. */
export class Trace {
  /** @param {any} facts as `shaderlint run --pixel --format json` prints them */
  constructor(facts) {
    this.facts = facts;
    /** @type {Step[]} */
    this.steps = facts.steps.map(([site, value]) => ({ site: facts.sites[site], value }));
  }

  /** The last value at each place up to a step, in the order in which they came. @param {number} step */
  placesAt(step) {
    const places = new Map();
    for (const { site, value } of this.steps.slice(0, step + 1)) {
      places.delete(site);
      places.set(site, value);
    }
    return places;
  }

  /** The variables of the function that a step lies in, each with its last value. @param {number} step */
  variablesAt(step) {
    const { function: own } = this.steps[step].site;
    const variables = new Map();
    for (const { site, value } of this.steps.slice(0, step + 1)) {
      if (site.function === own) variables.set(nameOf(site), { site, value });
    }
    return [...variables.values()];
  }

  /**
   * The next step at the same place, or the one before; the same step if there is none.
   * @param {number} step
   * @param {1 | -1} direction
   */
  again(step, direction) {
    const { site } = this.steps[step];
    for (let at = step + direction; at in this.steps; at += direction) {
      if (this.steps[at].site === site) return at;
    }
    return step;
  }
}

/** What a value is called. @param {Site} site */
export const nameOf = ({ kind, name }) => (kind === 'returned' ? `${name}() returns` : name);
