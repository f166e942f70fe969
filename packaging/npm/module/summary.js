// The last lines of a check of several files, made of those of each file.
"use strict";

const FIRST = /^(Found .*|No findings in .*\(.*|All checks passed \(.*|No shaders found in )\b1 file\b/;
const count = (number, one) => `${number} ${one}${number === 1 ? "" : "s"}`;

/** Adds up what files have. */
exports.Summary = class {
  errors = 0;
  warnings = 0;
  infos = 0;
  fixed = 0;
  #files = 0;
  #holding = 0;
  /** The last lines of the files. */
  #lines = [];

  /** Adds a report; returns its output without the last lines. */
  add({ output, errors, warnings, infos }) {
    this.errors += errors;
    this.warnings += warnings;
    this.infos += infos;
    this.#files += 1;
    const lines = output.split("\n");
    const first = lines.findLastIndex((line) => FIRST.test(line));
    if (first < 0) return output;
    this.#holding += /\(\d+ shader/.test(lines[first]) ? 1 : 0;
    this.#lines.push(...lines.splice(first).filter(Boolean));
    return lines.length > 0 ? `${lines.join("\n")}\n` : "";
  }

  /** The lines that match, as what the first group matches. */
  #all(pattern) {
    return this.#lines.flatMap((line) => {
      const match = pattern.exec(line);
      return match ? [{ number: Number(match[1]), line }] : [];
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
    const isIncomplete = this.#all(/^(Not fully checked)/).length > 0;
    return `${isIncomplete ? "No findings in what could be checked" : "All checks passed"} ${scope}`;
  }

  #fixes() {
    const fixable = this.#sum(/(\d+) fixable with --fix/);
    const more = this.#sum(/(\d+) (?:fixable|more) with --unsafe-fixes/);
    if (fixable === 0) return more > 0 ? `${more} fixable with --unsafe-fixes` : "";
    return `${fixable} fixable with --fix${more > 0 ? `, ${more} more with --unsafe-fixes` : ""}`;
  }

  /** The line about what was not checked. */
  #unchecked() {
    const sum = (one) => this.#sum(new RegExp(`^Not fully checked: .*?\\b(\\d+) ${one}`));
    const kinds = ["function", "shader", "excerpt"].map((one) => [sum(one), one]).filter(([number]) => number > 0);
    const files = sum("file");
    if (kinds.length === 0 && files > 0) kinds.push([files, "file"]);
    if (kinds.length === 0) return "";
    const hosts = this.#all(/^Not fully checked: .*(; set `\[host\]`.*)/);
    const help = hosts.length > 0 ? /; set .*/.exec(hosts[0].line)[0] : "";
    return `Not fully checked: ${kinds.map(([number, one]) => count(number, one)).join(", ")} (-v lists them)${help}`;
  }

  /** All lines. */
  lines() {
    if (this.#files === 0) return "";
    const infos = this.#sum(/(\d+) (?:more )?infos?: --info/);
    const info = this.errors + this.warnings + this.infos > 0 ? "more info" : "info";
    const fixed = this.fixed > 0 && `fixed ${count(this.fixed, "finding")}`;
    const first = [this.#first(), fixed, this.#fixes(), infos > 0 && `${count(infos, info)}: --info`];
    const lines = [first.filter(Boolean).join("; "), this.#unchecked()];
    return lines.filter(Boolean).map((line) => `${line}\n`).join("");
  }
};
