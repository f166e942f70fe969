// The programs of all passes, recompiled when their text changes.

class Programs {
  #isStale = false;
  /** @type {Promise<void> | null} */
  #compiling = null;

  /**
   * @param {WebGL2RenderingContext} gl
   * @param {ProjectData} project
   */
  constructor(gl, project) {
    this.gl = gl;
    this.project = project;
    this.parallel = gl.getExtension('KHR_parallel_shader_compile');
    /** @type {(PassProgram | null)[]} by pass; null until one has compiled */
    this.list = project.passes.map(() => null);
    /** @type {string[]} the last compiled source, by pass */
    this.sources = project.passes.map(() => '');
    /** @type {ShaderError[][]} its compile errors, by pass */
    this.failures = project.passes.map(() => []);
    this.isDisposed = false;
  }

  /** All errors without duplicates: errors in Common occur in every pass. */
  get errors() {
    const known = new Map(this.failures.flat().map((e) => [`${e.pass}\n${e.line}\n${e.text}`, e]));
    return [...known.values()];
  }

  /**
   * Compiles the passes with changed text, in parallel if the browser supports it. A pass that fails keeps
   * its last program.
   */
  compile() {
    this.#isStale = true;
    this.#compiling ??= this.#compileStale();
    return this.#compiling;
  }

  /** Texts that change during compilation are compiled next. */
  async #compileStale() {
    while (this.#isStale && !this.isDisposed) {
      this.#isStale = false;
      await this.#compileChanged();
    }
    this.#compiling = null;
  }

  async #compileChanged() {
    const { gl, project, parallel } = this;
    const started = project.passes.flatMap((pass, index) => {
      const source = passSource(project, pass);
      if (source === this.sources[index]) return [];
      this.sources[index] = source;
      return [{ index, program: startProgram(gl, project, pass) }];
    });
    for (const { index, program } of started) {
      while (parallel && !isCompiled(gl, parallel, program.program)) {
        await new Promise((resolve) => setTimeout(resolve, 4));
      }
      if (this.isDisposed) return;
      this.#finish(index, program);
    }
  }

  /** @param {number} index of the pass @param {StartedProgram} started */
  #finish(index, started) {
    const pass = this.project.passes[index];
    try {
      const program = new PassProgram(this.gl, finishProgram(this.gl, started), pass);
      this.list[index]?.dispose();
      this.list[index] = program;
      this.failures[index] = [];
    } catch (error) {
      if (!(error instanceof CompileError)) throw error;
      const files = pass.files.map((f) => this.project.files[f]);
      this.failures[index] = mapErrors(error.log, files, pass.name);
    }
  }

  dispose() {
    this.isDisposed = true;
    this.list.forEach((program) => program?.dispose());
  }
}

/**
 * Replaces a text.
 * @param {ProjectData} project @param {number} index of the file @param {string} text
 */
function changeText(project, index, text) {
  parts.moveNumbers?.(project, index, text);
  project.files[index].text = text;
}

/** Start and end of the part of a text that differs from another. @param {string} before @param {string} after */
function changed(before, after) {
  const most = Math.min(before.length, after.length);
  let start = 0;
  while (start < most && before[start] === after[start]) start++;
  let tail = 0;
  while (tail < most - start && before[before.length - 1 - tail] === after[after.length - 1 - tail]) tail++;
  return [start, before.length - tail];
}
