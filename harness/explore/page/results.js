// The table of results. Numbers are the program's; cells keep the exact bounds as data.

const element = (id) => document.getElementById(id);

function cell(text, className = "", data = {}) {
  const made = document.createElement("td");
  made.textContent = text;
  made.className = className;
  Object.assign(made.dataset, data);
  return made;
}

// The digits on which both bounds agree, at most `most` of them.
export function intervalText(lower, upper, most = 10) {
  if (lower == null || upper == null) return "–";
  for (let digits = most; digits >= 3; --digits) {
    const text = lower.toPrecision(digits);
    if (text === upper.toPrecision(digits)) return text;
  }
  return `${lower.toPrecision(4)} to ${upper.toPrecision(4)}`;
}

export function durationText(seconds) {
  if (seconds == null) return "–";
  if (seconds < 1e-3) return `${Math.round(1e6 * seconds)} µs`;
  if (seconds < 1) return `${(1e3 * seconds).toPrecision(3)} ms`;
  return `${seconds.toPrecision(3)} s`;
}

const label = ({ name, parameters }) => [name, ...Object.entries(parameters).map(([key, value]) => `${key}=${value}`)].join(" ");

function statusOf(run) {
  if (run.status !== "ok") return `${run.status.replaceAll("_", " ")}: ${run.message}`;
  const notes = ["checked"];
  if (run.optimal === "yes") notes.push("optimal");
  if (run.stop_reason) notes.push(`stopped early: ${run.stop_reason}`);
  return notes.join(", ");
}

function weightCell(run) {
  const made = cell(intervalText(run.weight_lower, run.weight_upper), "number", { lower: run.weight_lower, upper: run.weight_upper });
  if (run.perimeter_sum != null) made.title = `the triangles’ perimeters add up to ${run.perimeter_sum.toPrecision(10)}`;
  return made;
}

function rowOf({ name, parameters, run }, isComplete) {
  const row = document.createElement("tr");
  const title = document.createElement("th");
  title.scope = "row";
  title.textContent = label({ name, parameters });
  const alpha = run.alpha_lower == null ? (isComplete ? "no bound" : "…") : intervalText(run.alpha_lower, run.alpha_upper, 7);
  row.append(
    title,
    weightCell(run),
    cell(run.status === "ok" ? alpha : "–", "number alpha", { lower: run.alpha_lower, upper: run.alpha_upper }),
    cell(durationText(run.wall_time_s), "number"),
    cell(statusOf(run), run.status === "ok" ? "" : "failed"),
  );
  return row;
}

function optimumRow(optimum) {
  const row = document.createElement("tr");
  const title = document.createElement("th");
  title.scope = "row";
  title.textContent = optimum.status === "proved" ? "optimum" : "bounds on the optimum";
  const status = { proved: `proved by ${optimum.source}`, bounded: `bounded by ${optimum.source}`, none: "no bound" }[optimum.status];
  const trouble = [...optimum.contradictions, optimum.note].filter(Boolean).join("; ");
  row.append(
    title,
    cell(intervalText(optimum.optimum_lower, optimum.optimum_upper), "number", { lower: optimum.optimum_lower, upper: optimum.optimum_upper }),
    cell(optimum.status === "proved" ? "1" : "–", "number"),
    cell(durationText(optimum.wall_time_s), "number"),
    cell(trouble ? `${status}: ${trouble}` : status, optimum.contradictions.length ? "failed" : ""),
  );
  return row;
}

// Keeps the place of the optimum while it is sought.
function soughtRow() {
  const row = document.createElement("tr");
  const title = document.createElement("th");
  title.scope = "row";
  title.textContent = "optimum";
  row.append(title, cell("…", "number"), cell("", "number"), cell("", "number"), cell("is sought"));
  return row;
}

const plural = (count, word) => `${count.toLocaleString("en")} ${word}${count === 1 ? "" : "s"}`;

function summaryOf(answer, { first, second }) {
  if (!first?.edges.length || !second?.edges.length) return "";
  const differing = answer.compared.onlyFirst.length / 2;
  if (differing === 0) return `All ${plural(first.edges.length / 2, "edge")} are the same.`;
  return `${plural(differing, "edge")} of ${(first.edges.length / 2).toLocaleString("en")} differ.`;
}

function showLegend(answer, { first, second }) {
  const items = [];
  const add = (className, text) => {
    const item = document.createElement("li");
    item.className = className;
    item.textContent = text;
    items.push(item);
  };
  const nameOfSecond = answer.algorithms.second.name === "optimum" ? "the optimum" : answer.algorithms.second.name;
  if (first && second) {
    add("shared", "in both");
    add("first", `only in ${first.name}`);
    add("second", `only in ${nameOfSecond}`);
  } else if (first) {
    add(answer.algorithms.second.name === "none" ? "shared" : "first", first.name);
  }
  element("legend").replaceChildren(...items);
}

export function showResults(answer, shownPair) {
  if (!answer) {
    element("rows").replaceChildren();
    element("legend").replaceChildren();
    element("summary").textContent = "";
    return;
  }
  const rows = answer.runs.filter(Boolean).map((run) => rowOf(run, answer.isComplete));
  if (answer.optimum) rows.push(optimumRow(answer.optimum));
  else if (answer.seeksOptimum && !answer.isComplete) rows.push(soughtRow());
  element("rows").replaceChildren(...rows);
  showLegend(answer, shownPair);
  if (answer.isComplete) element("summary").textContent = summaryOf(answer, shownPair);
}
