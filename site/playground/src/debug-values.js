// The values at a moment: which are open, which have changed, and what is watched.

const SPECIAL = '(returned)';

/** The tables of values of the debugger. */
export class DebugValues {
  #ask;
  #openScopes = new Set(['Locals']);
  #openParts = new Set();
  #watched = new Set();
  /** The texts of values when they were last shown, and at this moment, by call and expression. */
  #before = new Map();
  #now = new Map();

  /** @param {(command: string, args: object) => Promise<{ body: any }>} ask */
  constructor(ask) {
    this.#ask = ask;
  }

  toggleScope(name) {
    flip(this.#openScopes, name);
  }

  togglePart(expression) {
    flip(this.#openParts, expression);
  }

  watch(expression) {
    this.#watched.add(expression);
  }

  unwatch(expression) {
    this.#watched.delete(expression);
  }

  /**
   * The tables of a frame.
   * @param {number} frameId
   * @param {string} call what distinguishes calls, so that only values of the same one are compared
   * @param {boolean} isMoved whether this is another moment
   */
  async at(frameId, call, isMoved) {
    if (isMoved) {
      for (const [key, value] of this.#now) this.#before.set(key, value);
      this.#now = new Map();
    }
    const { body } = await this.#ask('scopes', { frameId });
    const scopes = [];
    for (const { name, variablesReference } of body.scopes) {
      const isOpen = this.#openScopes.has(name);
      const rows = isOpen ? await this.#rows(variablesReference, call, 0) : [];
      scopes.push({ name, isOpen, rows });
    }
    const watches = [];
    for (const expression of this.#watched) watches.push(...await this.#watchedRows(expression, frameId, call));
    return { scopes, watches };
  }

  async #watchedRows(expression, frameId, call) {
    try {
      const { body } = await this.#ask('evaluate', { expression, frameId, context: 'watch' });
      const own = { ...body, name: expression, value: body.result, evaluateName: expression };
      return await this.#withParts(own, `watch ${call}`, 0);
    } catch (error) {
      if (error.name === 'AbortError') throw error;
      return [{ name: expression, value: error.message, expression, hasParts: false, isOpen: false, isChanged: false, isError: true, depth: 0 }];
    }
  }

  async #rows(variablesReference, call, depth) {
    const { body } = await this.#ask('variables', { variablesReference });
    const rows = [];
    for (const variable of body.variables) rows.push(...await this.#withParts(variable, call, depth));
    return rows;
  }

  /** The row of a value, and those of its parts if they are shown. */
  async #withParts({ name, value, type, color, evaluateName, variablesReference }, call, depth) {
    const expression = name === SPECIAL ? '' : evaluateName;
    const key = `${call} ${expression || name}`;
    this.#now.set(key, value);
    const before = this.#before.get(key);
    const isOpen = this.#openParts.has(expression);
    const row = {
      name, value, type, color, expression, depth,
      hasParts: variablesReference > 0 && expression !== '',
      isOpen,
      isChanged: before !== undefined && before !== value,
      isWritten: depth === 0 && expression !== '' && !call.startsWith('watch'),
    };
    return [row, ...(row.hasParts && isOpen ? await this.#rows(variablesReference, call, depth + 1) : [])];
  }
}

/** Adds what is missing, and removes what is there. @param {Set<string>} set @param {string} value */
function flip(set, value) {
  if (!set.delete(value)) set.add(value);
}
