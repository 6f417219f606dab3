"use strict";
// Runs as columns, for figure_explorer.js: from the page's table of runs, or from any runs.csv of this project.
//
// RunData: `size`; `numbers` {measure: Float64Array, NaN where missing}; `texts` {name: {values, codes}}, where codes[row] is a
// position in values; `name`, for the reader.

const RUN_SCHEMA = "3";
const OPTIMAL_EXCESS = 1e-9; // up to here alpha counts as optimal, as in every figure

// Axes: [measure, title, how it comes from the columns of runs.csv].
const MEASURES = [
  ["n", "points n", (run) => run("n")],
  ["time", "wall time in ms", (run) => 1e3 * run("wall_time_s")],
  ["time_per_point", "wall time per point in µs", (run) => 1e6 * run("wall_time_s") / run("n")],
  ["cpu", "CPU time in ms", (run) => 1e3 * run("cpu_time_s")],
  ["over_delaunay", "time over Delaunay’s", (run) => run("wall_time_s") / run("delaunay_time_s")],
  ["memory", "memory in MiB", (run) => run("peak_rss_bytes") / 2 ** 20],
  ["excess", "excess over the optimum in %", (run) => excessOf(run("alpha_upper"))],
  ["alpha", "α at most", (run) => run("alpha_upper")],
  ["weight", "weight", (run) => run("weight_upper")],
  ["seed", "seed", (run) => run("seed")],
  ["repetition", "repetition", (run) => run("repetition")],
  ["instructions", "instructions", (run) => run("instructions")],
  ["callgrind_instructions", "instructions under callgrind", (run) => run("callgrind_instructions")],
];

function excessOf(alpha) {
  const excess = alpha - 1;
  return excess <= OPTIMAL_EXCESS ? 0 : 100 * excess;
}

class InputMistake extends Error {}

// Texts as codes of the distinct ones.
class TextColumn {
  constructor(size) {
    this.values = [];
    this.codes = new Uint32Array(size);
    this.known = new Map();
  }

  set(row, text) {
    let code = this.known.get(text);
    if (code === undefined) {
      code = this.values.length;
      this.known.set(text, code);
      this.values.push(text);
    }
    this.codes[row] = code;
  }

  at(row) {
    return this.values[this.codes[row]];
  }
}

function emptyRuns(name, size, textNames) {
  const numbers = Object.fromEntries(MEASURES.map(([measure]) => [measure, new Float64Array(size).fill(NaN)]));
  return { name, size, numbers, texts: Object.fromEntries(textNames.map((text) => [text, new TextColumn(size)])) };
}

const RUN_TEXTS = ["algorithm", "params", "generator", "generator_params", "status", "run_id", "variant", "points"];

// `table`: the DataTable of all runs.
function runsOfTable(table, name) {
  const column = Object.fromEntries(table.columns.map(({ title }, position) => [title, position]));
  const runs = emptyRuns(name, table.rows.length, RUN_TEXTS);
  const text = { params: "parameters", generator: "family", generator_params: "family parameters", run_id: "run" };
  const factors = { wall_time_s: ["time in ms", 1e-3], cpu_time_s: ["CPU time in ms", 1e-3],
    peak_rss_bytes: ["memory in MiB", 2 ** 20], alpha_upper: ["alpha at most", 1], weight_upper: ["weight", 1] };
  table.rows.forEach((row, at) => {
    const cell = (title) => column[title] === undefined ? "" : table.cell(row, column[title]);
    const number = (title) => cell(title) === "" ? NaN : Number(cell(title));
    for (const name of RUN_TEXTS) runs.texts[name].set(at, String(cell(text[name] ?? name)));
    const value = (name) => name in factors ? number(factors[name][0]) * factors[name][1] : number(name);
    for (const [measure, , of] of MEASURES) runs.numbers[measure][at] = of(value);
    runs.numbers.over_delaunay[at] = number("time over Delaunay’s");
  });
  return runs;
}

// RFC 4180; no field of the records has a line break.
function csvFields(line) {
  if (!line.includes('"')) return line.split(",");
  const fields = [];
  for (let at = 0; at <= line.length;) {
    let field = "";
    if (line[at] === '"') {
      let end = at + 1;
      while (end < line.length && (line[end] !== '"' || line[end + 1] === '"')) end += line[end] === '"' ? 2 : 1;
      field = line.slice(at + 1, end).replaceAll('""', '"');
      at = end + 1;
    } else {
      const end = line.indexOf(",", at) < 0 ? line.length : line.indexOf(",", at);
      field = line.slice(at, end);
      at = end;
    }
    fields.push(field);
    ++at; // the comma, or one beyond the end
  }
  return fields;
}

const NEEDED_COLUMNS = ["schema_version", "run_id", "study", "algorithm", "params", "generator", "generator_params", "n", "seed",
  "repetition", "status", "wall_time_s", "cpu_time_s", "peak_rss_bytes", "weight_upper", "alpha_upper", "delaunay_time_s"];
const OPTIONAL_NUMBERS = ["instructions", "callgrind_instructions"];
const ROWS_AT_ONCE = 4000;

// The runs of the text of a runs.csv. `progress` is called with a share from time to time. Throws InputMistake with one line for
// the reader.
async function runsOfCsv(text, name, progress) {
  const refuse = (what) => { throw new InputMistake(`${name}: ${what}`); };
  const isCut = text.length > 0 && !text.endsWith("\n");
  const lines = text.replace(/^\ufeff/, "").split(/\r?\n/);
  if (lines.at(-1) === "") lines.pop();
  const header = lines.length ? csvFields(lines[0]) : [];
  const missing = NEEDED_COLUMNS.filter((column) => !header.includes(column));
  if (missing.length) refuse(`not a runs.csv of mwt: its first line has no column ${missing[0]}; choose the file that mwt run writes`);
  if (lines.length === 1) refuse("no runs are recorded in it yet");
  const place = Object.fromEntries(header.map((column, position) => [column, position]));
  const runs = emptyRuns(name, lines.length - 1, RUN_TEXTS);
  for (let line = 1; line < lines.length; ++line) {
    const fields = csvFields(lines[line]);
    const isLast = line === lines.length - 1;
    if (isLast && isCut) fields[fields.length - 1] = "";
    while (isLast && isCut && fields.length < header.length) fields.push("");
    if (fields.length !== header.length)
      refuse(`line ${line + 1} has ${fields.length} fields, and the first line ${header.length}; copy the file anew`);
    if (fields[place.schema_version] !== RUN_SCHEMA)
      refuse(`line ${line + 1} has schema version ${fields[place.schema_version].slice(0, 20)}; this page reads version ${RUN_SCHEMA}`);
    addCsvRun(runs, line - 1, fields, place, (column, value) =>
      refuse(`line ${line + 1}: ${column} is “${value.slice(0, 20)}”, which is no number`));
    if (line % ROWS_AT_ONCE === 0) {
      progress(line / lines.length);
      await new Promise((resolve) => setTimeout(resolve));
    }
  }
  runs.note = isCut ? "Its last line is cut off." : "";
  nameVariants(runs, "algorithm", "params", "variant");
  nameVariants(runs, "generator", "generator_params", "points");
  return runs;
}

function addCsvRun(runs, at, fields, place, refuseNumber) {
  for (const name of RUN_TEXTS) if (name in place) runs.texts[name].set(at, fields[place[name]]);
  const value = (column) => {
    const field = column in place ? fields[place[column]] : "";
    if (field === "") return NaN;
    const number = Number(field);
    if (Number.isNaN(number)) refuseNumber(column, field);
    return number;
  };
  for (const [measure, , of] of MEASURES) runs.numbers[measure][at] = of(value);
}

// Names with the parameters in which the runs differ, as mwt report makes its labels: "patch k=14"; files by their names.
function nameVariants(runs, nameColumn, parameterColumn, labelColumn) {
  const names = runs.texts[nameColumn], parameters = runs.texts[parameterColumn];
  const counts = new Map(); // name: {parameters: number of runs}
  for (let row = 0; row < runs.size; ++row) {
    const of = counts.get(names.at(row)) ?? counts.set(names.at(row), new Map()).get(names.at(row));
    of.set(parameters.at(row), (of.get(parameters.at(row)) ?? 0) + 1);
  }
  const labels = new Map([...counts].map(([name, of]) => [name, labelsOf(name, of)]));
  for (let row = 0; row < runs.size; ++row) {
    const isFile = names.at(row) === "file" && parameters.at(row).startsWith("file=");
    runs.texts[labelColumn].set(row, isFile ? parameters.at(row).slice(5) : labels.get(names.at(row)).get(parameters.at(row)));
  }
}

function labelsOf(name, counts) {
  const variants = [...counts.keys()].map((text) => text.split(" ").filter(Boolean));
  const isShared = (assignment) => variants.every((variant) => variant.includes(assignment));
  const most = Math.max(...counts.values());
  const usual = [...counts].filter(([, count]) => count === most);
  const bare = usual.length === 1 ? usual[0][0].split(" ") : [];
  return new Map([...counts.keys()].map((text) =>
    [text, [name, ...text.split(" ").filter((one) => one && !isShared(one) && !bare.includes(one))].join(" ")]));
}
