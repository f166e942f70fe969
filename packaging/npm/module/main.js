// The commands of shaderlint that the WebAssembly module has.
"use strict";

const { parseArgs } = require("node:util");
const check = require("./check.js");
const format = require("./format.js");
const { Refusal } = require("./files.js");
const { name, version } = require("../package.json");

const flag = { type: "boolean" };
const text = { type: "string" };
const list = { type: "string", multiple: true };
/** The options of both commands about files. */
const FILES = { "no-config": flag, "stdin-filename": text, quiet: { ...flag, short: "q", multiple: true } };
const FORMAT = { ...FILES, check: flag };
const CHECK = {
  ...FILES, host: text, select: list, ignore: list, info: flag, "no-run": flag, "run-samples": text,
  fix: flag, "unsafe-fixes": flag, format: text, "no-cache": flag, "deny-warnings": flag,
  "max-warnings": text, "exit-zero": flag,
};
/** The commands that only programs have. */
const OTHERS = ["completions", "help", "init", "ir", "lsp", "man", "mcp", "port", "reduce", "run", "schema", "test"];

/** The groups of rules in the order of the table. */
const GROUPS = ["webgl2", "numeric", "portability", "budget", "look", "tidy", "runtime"];

/** The options and the paths in arguments. */
function parse(args, options) {
  try {
    const { values, positionals: paths } = parseArgs({ args, options, allowPositionals: true });
    return { ...values, quiet: values.quiet?.length ?? 0, paths };
  } catch (error) {
    const [message] = error.message.split(/\. |\n/);
    if (error.code !== "ERR_PARSE_ARGS_UNKNOWN_OPTION") throw new Error(message);
    throw new Refusal(`${message.replace("Unknown option", "the option")} needs the program`);
  }
}

/** All rules as a table. */
function table({ rules }) {
  const place = ({ group, name: rule }) => `${GROUPS.indexOf(group)} ${rule}`;
  const sorted = rules.filter(({ kind }) => kind === "rule").sort((a, b) => (place(a) < place(b) ? -1 : 1));
  const width = Math.max(...sorted.map((rule) => rule.name.length));
  const line = (rule) => {
    const level = (rule.default ? rule.severity : "off").padEnd(7);
    return `${rule.name.padEnd(width)}  ${rule.group.padEnd(11)}  ${level}  ${rule.summary}\n`;
  };
  return sorted.map(line).join("");
}

/** What a command about rules prints. */
function page(module, command, rest) {
  if (command !== "rules") {
    if (rest.length === 1 && !rest[0].startsWith("-")) return module.explain(rest[0]);
    throw new Refusal("`explain` needs one name here; a search for several words needs the program");
  }
  const asked = parse(rest, { format: text });
  return asked.format === "json" ? `${JSON.stringify(module.rules(), null, 2)}\n` : table(module.rules());
}

/** Runs a command and returns its exit code. */
module.exports = function main(module, args) {
  if (!parseArgs) throw new Error("Node 18.3 or newer is required where there is no program");
  const [command, ...rest] = args;
  if (OTHERS.includes(command)) throw new Refusal(`\`${command}\` needs the program`);
  if (command === "fmt") return format(module, parse(rest, FORMAT));
  if (command === "check") return check(module, parse(rest, CHECK));
  if (command !== "explain" && command !== "rules" && command !== "--version") {
    return check(module, parse(args, CHECK));
  }
  process.stdout.write(command === "--version" ? `${name} ${version}\n` : page(module, command, rest));
  return 0;
};
