"use strict";
// The sparklines of a dashboard (make_dashboard.py). <script type="application/json" id="series-data"> holds:
//   nightly runs [{date, commit}], series [{algorithm, instance, n, measure, aspect, unit, nightly runs, values, steps}], where steps are
//   [{nightly run, before, after, worse}]; series with steps come first.
(() => {
  const FIRST = 48, WIDTH = 300, HEIGHT = 60, EDGE = 5;
  const data = JSON.parse(document.getElementById("series-data").textContent);
  const place = document.getElementById("sparklines");
  const chosen = { algorithm: "", family: "", measure: "", steps: false, lens: "" };
  // A lens shows every series once, by its time or by its count, in the same place under both. The first measure of a list that there is.
  const LENSES = { times: ["relative_time", "wall_time_s"], counts: ["callgrind_instructions", "instructions"] };
  const measureOf = Object.fromEntries(Object.entries(LENSES).map(([lens, measures]) =>
    [lens, measures.find((measure) => data.series.some((series) => series.measure === measure))]));
  const cellOf = (series) => JSON.stringify([series.algorithm, series.instance, series.n]);
  const placeOfCell = new Map();  // those with steps under either lens first, as in data.series
  for (const series of data.series) {
    if (Object.values(measureOf).includes(series.measure) && !placeOfCell.has(cellOf(series))) placeOfCell.set(cellOf(series), placeOfCell.size);
  }
  const seriesOf = new Map(data.series.map((series) => [cellOf(series) + series.measure, series]));
  let limit = FIRST;

  function add(parent, name, properties = {}) {
    const element = Object.assign(document.createElement(name), properties);
    parent.append(element);
    return element;
  }

  function draw(parent, name, attributes) {
    const element = document.createElementNS("http://www.w3.org/2000/svg", name);
    for (const [key, value] of Object.entries(attributes)) element.setAttribute(key, value);
    parent.append(element);
    return element;
  }

  function readable(value, unit, digits = 3) {
    if (unit === "bytes") return (value / 1048576).toFixed(Math.max(1, digits - 2)) + " MiB";
    if (unit !== "s") return Number(value.toPrecision(Math.max(7, digits))).toString();
    for (const [size, name] of [[1, "s"], [1e-3, "ms"], [1e-6, "µs"]]) if (value >= size) return (value / size).toPrecision(digits) + " " + name;
    return (value * 1e9).toPrecision(digits) + " ns";
  }

  // One of the ends of a scale: as many digits as tell it from the other end.
  function scaleText(value, span, unit) {
    const digits = Math.min(12, Math.max(3, Math.ceil(Math.log10(Math.abs(value) / span)) + 2));
    return readable(unit === "s" || unit === "bytes" ? value : Number(value.toPrecision(digits)), unit, digits);
  }

  class Sparkline {
    constructor(series) {
      this.series = series;
      const figure = add(place, "figure", { className: "sparkline" });
      this.name = `${series.algorithm} · ${series.instance} n=${series.n} · ${series.measure}`;
      add(figure, "figcaption", { textContent: this.name });
      this.chart = add(figure, "div", { className: "chart" });
      this.svg = draw(this.chart, "svg", { viewBox: `0 0 ${WIDTH} ${HEIGHT}`, preserveAspectRatio: "none", tabindex: 0, role: "img" });
      this.output = add(figure, "output");
      this.scale();
      this.drawLines();
      this.nameScale();
      this.tell(series.values.length - 1);
      this.svg.addEventListener("pointermove", (event) => this.follow(event));
      this.svg.addEventListener("pointerleave", () => this.tell(series.values.length - 1));
      this.svg.addEventListener("keydown", (event) => this.walk(event));
    }

    scale() {
      const { nightly_runs, values, aspect } = this.series;
      const sorted = [...values].sort((a, b) => a - b), last = sorted.length - 1;
      // Of what has noise, spikes are cut off and less than two percent is not blown up; what is exact is shown whole. Counts are nearly exact.
      const noisy = aspect === "time" || aspect === "memory";
      const low = sorted[noisy ? Math.floor(0.05 * last) : 0], high = sorted[noisy ? Math.ceil(0.95 * last) : last];
      const span = this.span = Math.max(1.5 * (high - low), noisy || aspect === "counts" ? 0.02 * high : 0) || 1;
      this.isConstant = sorted[0] === sorted[last];
      // No scale goes below zero for values that do not.
      const middle = this.middle = this.isConstant || low < 0 ? (low + high) / 2 : Math.max((low + high) / 2, span / 2);
      const first = nightly_runs[0], length = Math.max(1, nightly_runs[nightly_runs.length - 1] - first);
      this.x = (nightly_run) => EDGE + (WIDTH - 2 * EDGE) * (nightly_run - first) / length;
      const inside = (y) => Math.min(HEIGHT - EDGE, Math.max(EDGE, y));
      this.y = (value) => inside(HEIGHT / 2 - (HEIGHT - 2 * EDGE) * (value - middle) / span);
    }

    drawLines() {
      const { nightly_runs, values, steps } = this.series;
      const points = values.map((value, i) => `${this.x(nightly_runs[i]).toFixed(1)},${this.y(value).toFixed(1)}`);
      draw(this.svg, "polyline", { class: "values", points: points.join(" ") });
      steps.forEach((step, i) => {
        const begin = i === 0 ? nightly_runs[0] : steps[i - 1].nightly_run;
        const end = i + 1 < steps.length ? steps[i + 1].nightly_run : nightly_runs[nightly_runs.length - 1];
        this.drawLevel(begin, step.nightly_run, step.before);
        this.drawLevel(step.nightly_run, end, step.after);
        draw(this.svg, "line", { class: step.worse ? "step worse" : "step better", x1: this.x(step.nightly_run), x2: this.x(step.nightly_run), y1: 0, y2: HEIGHT });
      });
      this.here = draw(this.svg, "path", { class: "here" });
    }

    // The values at both ends of the scale, or the only one; the first and the last nightly run.
    nameScale() {
      const { nightly_runs, values, unit } = this.series;
      const name = (className, textContent) => add(this.chart, "span", { className, textContent });
      if (this.isConstant) {
        name("only", readable(values[0], unit));
      } else {
        name("high", scaleText(this.middle + this.span / 2, this.span, unit));
        name("low", scaleText(this.middle - this.span / 2, this.span, unit));
      }
      name("first", data.nightly_runs[nightly_runs[0]].date);
      if (nightly_runs.length > 1) name("last", data.nightly_runs[nightly_runs[nightly_runs.length - 1]].date);
    }

    drawLevel(begin, end, value) {
      draw(this.svg, "line", { class: "level", x1: this.x(begin), x2: this.x(end), y1: this.y(value), y2: this.y(value) });
    }

    tell(position) {
      const { nightly_runs, values, unit, steps } = this.series;
      this.position = position;
      const nightly_run = data.nightly_runs[nightly_runs[position]];
      const before = position > 0 ? values[position - 1] : 0;
      const change = before > 0 ? ` (${values[position] >= before ? "+" : "−"}${Math.abs(100 * (values[position] / before - 1)).toFixed(1)}%)` : "";
      const step = steps.find((one) => one.nightly_run === nightly_runs[position]);
      const other = this.otherLens(nightly_runs[position]);
      const text = `${nightly_run.date}, commit ${nightly_run.commit.slice(0, 10)}: ${readable(values[position], unit)}${change}` +
        (step ? `; step ×${(step.after / step.before).toFixed(3)}` : "") + other;
      this.output.textContent = text;
      this.svg.setAttribute("aria-label", `${this.name}. ${text}`);
      this.here.setAttribute("d", `M${this.x(nightly_runs[position])} ${this.y(values[position])}h0.01`);
    }

    // What the other lens shows of that nightly run: whether a change of time comes with one of the instructions.
    otherLens(nightly_run) {
      const lens = Object.keys(LENSES).find((one) => one !== chosen.lens && chosen.lens);
      const series = lens && seriesOf.get(cellOf(this.series) + measureOf[lens]);
      const position = series ? series.nightly_runs.indexOf(nightly_run) : -1;
      if (position < 0) return "";
      const before = position > 0 ? series.values[position - 1] : 0;
      const change = before > 0 ? ` (${series.values[position] >= before ? "+" : "−"}${Math.abs(100 * (series.values[position] / before - 1)).toFixed(1)}%)` : "";
      return ` | ${series.measure} ${readable(series.values[position], series.unit)}${change}`;
    }

    follow(event) {
      const box = this.svg.getBoundingClientRect();
      const x = WIDTH * (event.clientX - box.left) / box.width;
      let nearest = 0;
      this.series.nightly_runs.forEach((nightly_run, i) => {
        if (Math.abs(this.x(nightly_run) - x) < Math.abs(this.x(this.series.nightly_runs[nearest]) - x)) nearest = i;
      });
      this.tell(nearest);
    }

    walk(event) {
      const move = { ArrowLeft: -1, ArrowRight: 1, Home: -Infinity, End: Infinity }[event.key];
      if (move === undefined) return;
      event.preventDefault();
      this.tell(Math.min(this.series.values.length - 1, Math.max(0, this.position + move)));
    }
  }

  function matching() {
    const found = data.series.filter((series) =>
      (!chosen.lens || series.measure === measureOf[chosen.lens]) &&
      (!chosen.algorithm || series.algorithm === chosen.algorithm) && (!chosen.family || series.instance === chosen.family) &&
      (!chosen.measure || series.measure === chosen.measure) && (!chosen.steps || series.steps.length > 0));
    return chosen.lens ? found.sort((a, b) => placeOfCell.get(cellOf(a)) - placeOfCell.get(cellOf(b))) : found;
  }

  function show() {
    const found = matching();
    place.replaceChildren();
    for (const series of found.slice(0, limit)) new Sparkline(series);
    count.textContent = `${Math.min(limit, found.length)} of ${found.length} series`;
    more.hidden = found.length <= limit;
  }

  function choose(changes) {
    Object.assign(chosen, changes);
    for (const [key, select] of Object.entries(selects)) select.value = chosen[key];
    onlySteps.setAttribute("aria-pressed", String(chosen.steps));
    for (const [lens, button] of Object.entries(lenses)) button.setAttribute("aria-pressed", String(chosen.lens === lens));
    limit = FIRST;
    show();
  }

  const controls = document.getElementById("series-choices");
  const selects = {};
  for (const [key, field] of [["algorithm", "algorithm"], ["family", "instance"], ["measure", "measure"]]) {
    const select = selects[key] = add(add(controls, "label", { textContent: key + " " }), "select");
    add(select, "option", { value: "", textContent: "all" });
    for (const value of [...new Set(data.series.map((series) => series[field]))].sort()) add(select, "option", { value, textContent: value });
    select.addEventListener("change", () => choose({ [key]: select.value, ...(key === "measure" ? { lens: "" } : {}) }));
  }
  const lenses = {};
  if (measureOf.times && measureOf.counts) {
    const group = add(controls, "span", { className: "lenses" });
    group.setAttribute("role", "group");
    group.setAttribute("aria-label", "times or counts");
    for (const lens of Object.keys(LENSES)) {
      lenses[lens] = add(group, "button", { type: "button", textContent: lens, title: measureOf[lens] });
      lenses[lens].addEventListener("click", () => choose({ lens: chosen.lens === lens ? "" : lens, measure: "" }));
    }
  }
  const onlySteps = add(controls, "button", { type: "button", textContent: "only with steps" });
  onlySteps.addEventListener("click", () => choose({ steps: !chosen.steps }));
  const count = add(controls, "span", { className: "soft" });
  count.setAttribute("role", "status");
  const more = add(place.parentElement, "button", { type: "button", textContent: "show more series" });
  more.addEventListener("click", () => { limit *= 4; show(); });
  document.querySelectorAll("a[data-algorithm]").forEach((link) => {
    link.addEventListener("click", () => choose({ algorithm: link.dataset.algorithm, family: "", measure: link.dataset.measure, steps: true, lens: "" }));
  });
  choose({});
})();
