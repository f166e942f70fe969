// The last lines of a check of several files, made of those of each file.
"use strict";

const FIRST = /^(Found .*|No findings in .*\(.*|All checks passed \(.*|No shaders found in )\b1 file\b/;
/** Maximum number of names in a line. */
const MAX_NAMES = 5;

const count = (number, one) => `${number} ${one}${number === 1 ? "" : "s"}`;

/** Names, and how many there are. */
function list(names, total) {
  const more = total > MAX_NAMES ? [`${total - MAX_NAMES} more`] : [];
  return [...names.slice(0, MAX_NAMES), ...more].join(", ");
}

/** Adds up what files have. */
exports.Summary = class {
  errors = 0;
  warnings = 0;
  infos = 0;
  fixed = 0;
  #files = 0;
  #holding = 0;
  /** The last lines of the files, each with the name of its file. */
  #lines = [];

  /** Adds a report; returns its output without the last lines. */
  add({ output, errors, warnings, infos }, name) {
    this.errors += errors;
    this.warnings += warnings;
    this.infos += infos;
    this.#files += 1;
    const lines = output.split("\n");
    const first = lines.findLastIndex((line) => FIRST.test(line));
    if (first < 0) return output;
    this.#holding += /\(\d+ shader/.test(lines[first]) ? 1 : 0;
    this.#lines.push(...lines.splice(first).filter(Boolean).map((line) => [line, name]));
    return lines.length > 0 ? `${lines.join("\n")}\n` : "";
  }

  /** The lines that match, as what the first group matches. */
  #all(pattern) {
    return this.#lines.flatMap(([line, name]) => {
      const match = pattern.exec(line);
      return match ? [{ number: Number(match[1]), line, name }] : [];
    });
  }

  #sum(pattern) {
    return this.#all(pattern).reduce((sum, { number }) => sum + number, 0);
  }

  /** The first line. */
  #first() {
    const shaders = this.#sum(/\((\d+) shaders? in/);
    const files = count(this.#files, "file");
    const part = this.#files === this.#holding || shaders === 0 ? files : `${this.#holding} of ${files}`;
    const scope = `(${shaders === 0 ? "no shader" : count(shaders, "shader")} in ${part})`;
    const kinds = [[this.errors, "error"], [this.warnings, "warning"], [this.infos, "info"]];
    const found = kinds.filter(([number]) => number > 0).map(([number, kind]) => count(number, kind));
    if (found.length > 0) return `Found ${found.join(", ")} ${scope}`;
    if (shaders === 0) return `No shaders found in ${files}`;
    const isIncomplete = this.#all(/^(Rules|1 file is)/).length > 0;
    return `${isIncomplete ? "No findings in what could be checked" : "All checks passed"} ${scope}`;
  }

  #fixes() {
    const fixable = this.#sum(/(\d+) fixable with --fix/);
    const more = this.#sum(/(\d+) (?:fixable|more) with --unsafe-fixes/);
    if (fixable === 0) return more > 0 ? `${more} fixable with --unsafe-fixes` : "";
    return `${fixable} fixable with --fix${more > 0 ? `, ${more} more with --unsafe-fixes` : ""}`;
  }

  /** The lines about functions that rules skipped. */
  #functions(cause) {
    const pattern = new RegExp(`^Rules skipped (\\d+) functions? ${cause}: `);
    const found = this.#all(pattern);
    const total = this.#sum(pattern);
    const place = (name) => (this.#files === 1 ? "" : ` in ${name}`);
    const named = ({ line, name }) => line.match(/`[^`]*`/g).map((each) => each + place(name));
    return total > 0 && `Rules skipped ${count(total, "function")} ${cause}: ${list(found.flatMap(named), total)}`;
  }

  /** All lines. */
  lines() {
    if (this.#files === 0) return "";
    const infos = this.#sum(/(\d+) (?:more )?infos?: --info/);
    const info = this.errors + this.warnings + this.infos > 0 ? "more info" : "info";
    const fixed = this.fixed > 0 && `fixed ${count(this.fixed, "finding")}`;
    const first = [this.#first(), fixed, this.#fixes(), infos > 0 && `${count(infos, info)}: --info`];
    const shaders = this.#sum(/^Rules skipped (\d+) shaders? with errors outside/);
    const excerpts = this.#sum(/^Rules skipped (\d+) incomplete excerpt/);
    const parts = this.#all(/^(1) file is a shader fragment using names/);
    const names = new Set(parts.flatMap(({ line }) => line.replace(/;.*/, "").match(/`[^`]*`/g)));
    // Files name five; further names of two files may be the same.
    const hidden = parts.map(({ line }) => Number(/, (\d+) more;/.exec(line)?.[1] ?? 0));
    const total = names.size + hidden.reduce((sum, number) => sum + number, 0);
    const which = parts.length === 1 ? "1 file is a shader fragment" : `${parts.length} files are shader fragments`;
    const lines = [
      first.filter(Boolean).join("; "),
      this.#functions("with errors"),
      this.#functions("with errors or unknown names"),
      shaders > 0 && `Rules skipped ${count(shaders, "shader")} with errors outside functions`,
      excerpts > 0 && `Rules skipped ${count(excerpts, "incomplete excerpt")}`,
      parts.length > 0 &&
        `${which} using names from a host: ${list([...names].sort(), total)}; ` +
        "set `[host]` in shaderlint.toml to check them",
    ];
    return lines.filter(Boolean).map((line) => `${line}\n`).join("");
  }
};
