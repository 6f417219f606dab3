// Plays what an algorithm did, step by step, from the trace that the program sends.
import { ask } from "./program.js";

const element = (id) => document.getElementById(id);
const KINDS = ["add", "remove", "flip", "certain", "open", "group", "cell", "cut", "pass", "refute"];
const NONE = 0xffffffff;
const SHADES = 4;
const WORDS = 5; // of a step: kind, a, b, c, d

const plural = (count, word) => `${count.toLocaleString("en")} ${word}${count === 1 ? "" : "s"}`;

// The steps of a trace, and what they make of the edges. Steps of the program that are one to a reader (all edges of an
// inserted point, of a patch, of a cell) are one step here.
export class Trace {
  #count; // of the program's steps
  #values;
  #words;
  #boxes;
  #begins = []; // of each step: the first of the program's

  constructor(json, bytes) {
    this.#count = json.steps;
    this.#values = new Float64Array(bytes, 0, json.steps);
    this.#boxes = new Float64Array(bytes, 8 * json.steps, 4 * json.boxes);
    const head = 8 * (json.steps + 4 * json.boxes);
    this.#words = new Uint32Array(bytes, head, WORDS * json.steps);
    this.start = new Uint32Array(bytes, head + 4 * WORDS * json.steps, 2 * json.start_edges);
    this.stages = json.stages.map((stage) => ({ ...stage }));
    this.#findSteps();
    this.kinds = new Set(Array.from({ length: json.steps }, (_, i) => KINDS[this.#words[WORDS * i]]));
    this.reset();
  }

  #findSteps() {
    let stage = 0;
    for (let i = 0; i < this.#count; i += 1 + this.#followers(i)) {
      for (; stage < this.stages.length && this.stages[stage].begin <= i; ++stage) this.stages[stage].begin = this.#begins.length;
      this.#begins.push(i);
    }
    this.size = this.#begins.length;
    this.#begins.push(this.#count);
    for (; stage < this.stages.length; ++stage) this.stages[stage].begin = this.size;
  }

  // How many of the program's steps go with one.
  #followers(i) {
    const kind = KINDS[this.#words[WORDS * i]];
    return kind === "group" ? this.#words[WORDS * i + 1] : kind === "cell" ? this.#words[WORDS * i + 2] : 0;
  }

  reset() {
    this.position = 0;
    this.cells = 0;
    this.edges = new Map(); // "a-b" -> {a, b, mark}
    for (let i = 0; i < this.start.length; i += 2) this.#put(this.start[i], this.start[i + 1], "plain");
  }

  #step(i) {
    const [kind, a, b, c, d] = this.#words.subarray(WORDS * i, WORDS * (i + 1));
    return { kind: KINDS[kind], a, b, c, d, value: this.#values[i] };
  }

  // The program's steps that are this one.
  #stepsOf(position) {
    const steps = [];
    for (let i = this.#begins[position]; i < this.#begins[position + 1]; ++i) steps.push(this.#step(i));
    return steps;
  }

  stageOf(position) {
    return this.stages.findLast((stage) => stage.begin <= position) ?? this.stages[0];
  }

  #put(a, b, mark, value = 0) {
    this.edges.set(`${a}-${b}`, { a, b, mark, value });
  }

  // Goes to the state after so many steps.
  goTo(position) {
    if (position < this.position) this.reset();
    for (; this.position < position; ++this.position) {
      const steps = this.#stepsOf(this.position);
      const mark = steps[0].kind === "cell" ? "leaf" : "plain";
      for (const { kind, a, b, c, d, value } of steps) {
        if (kind === "remove" || kind === "flip" || kind === "refute") this.edges.delete(`${a}-${b}`);
        if (kind === "add" || kind === "pass") this.#put(a, b, mark);
        if (kind === "flip") this.#put(c, d, "plain");
        if (kind === "certain" || kind === "open" || kind === "cut") this.#put(a, b, kind, value);
        if (kind === "cell") this.cells = a + 1;
      }
    }
  }

  // Those of the cells so far.
  get boxes() {
    return this.#boxes.subarray(0, 4 * this.cells);
  }

  // The edges of the state, sorted.
  sortedEdges() {
    const edges = [...this.edges.values()].sort((one, other) => one.a - other.a || one.b - other.b);
    return Uint32Array.from(edges.flatMap(({ a, b }) => [a, b]));
  }

  layers() {
    const groups = { plain: [], certain: [], leaf: [], cut: [], open: Array.from({ length: SHADES }, () => []) };
    for (const { a, b, mark, value } of this.edges.values()) {
      const group = mark === "open" ? groups.open[Math.min(SHADES - 1, Math.floor(Math.sqrt(value) * SHADES))] : groups[mark];
      group.push(a, b);
    }
    const layer = (edges, colour, width, more = {}) => ({ edges: Uint32Array.from(edges), colour, width, dashed: false, ...more });
    const layers = [layer(groups.plain, "--shared", 1.2)];
    groups.open.forEach((edges, shade) => layers.push(layer(edges, "--second", 1.6, { alpha: 0.4 + (0.6 * shade) / (SHADES - 1) })));
    layers.push(layer([...groups.certain, ...groups.leaf], "--certain", 2.2), layer(groups.cut, "--first", 2.6));
    return this.position > 0 ? [...layers, ...this.#lastStep(layer)] : layers;
  }

  // What the last step changed.
  #lastStep(layer) {
    const [gone, come, crossed] = [[], [], []];
    for (const { kind, a, b, c, d } of this.#stepsOf(this.position - 1)) {
      if (kind === "remove" || kind === "flip" || kind === "refute") gone.push(a, b);
      if (kind === "remove" && c !== NONE) crossed.push(c, d);
      if (kind === "flip") come.push(c, d);
      if (["add", "certain", "open", "cut", "pass"].includes(kind)) come.push(a, b);
    }
    return [layer(gone, "--first", 3, { dashed: true }), layer(crossed, "--second", 3), layer(come, "--chosen", 3)];
  }

  // What the last step did.
  describe() {
    if (this.position === 0) return "the start";
    const position = this.position - 1;
    const { name } = this.stageOf(position);
    const head = `${name}, step ${this.position.toLocaleString("en")} of ${this.size.toLocaleString("en")}: `;
    const [first, ...others] = this.#stepsOf(position);
    if (first.kind === "group") return head + this.#describeGroup(first, others);
    if (first.kind === "cell") return head + (first.c === NONE ? "a cell that is split" : `a leaf and its ${plural(others.length, "edge")}`);
    return `${head}edge ${first.a}–${first.b} ${this.#reason(first, position)}`;
  }

  #describeGroup({ b, value }, steps) {
    if (b !== NONE) return `point ${b} is inserted, with ${plural(steps.filter(({ kind }) => kind === "add").length, "edge")}`;
    const removed = steps.filter(({ kind }) => kind === "remove").length;
    return `${plural(removed, "edge")} of a patch ${removed === 1 ? "is" : "are"} replaced, shorter by ${value.toPrecision(4)}`;
  }

  // What happened to an edge at that position, and why.
  #reason({ kind, a, b, c, d, value }, position) {
    const { name, reason } = this.stageOf(position);
    if (kind === "flip") return `is replaced by ${c}–${d}, ${value < 0 ? "longer" : "shorter"} by ${Math.abs(value).toPrecision(4)}`;
    if (kind === "remove" && c !== NONE) return `leaves: it crosses ${c}–${d}`;
    if (kind === "remove" && name === "crossing edges") return "leaves: it passes through a point";
    if (kind === "remove" && name === "optimum") return "leaves: it is not in the optimum";
    if (kind === "remove" && name === "result") return "leaves: it is not in what the algorithm returns";
    if (kind === "remove" && name === "insertion") return "leaves: the inserted point lies on it";
    if (kind === "remove" && name === "patches") return "leaves: a lighter triangulation of its patch does without it";
    if (kind === "open") return `${reason}, ${value.toPrecision(2)} of the largest`;
    if (kind === "pass") return `passes the diamond test: ${this.#halves(c, d)}`;
    if (kind === "refute") return this.#refutation(c, d);
    return reason;
  }

  #halves(left, right) {
    if (left === NONE && right === NONE) return "both triangles of its diamond are empty";
    return `the triangle ${left === NONE ? "left" : "right"} of it is empty, the other one holds point ${left === NONE ? right : left}`;
  }

  #refutation(left, right) {
    if (left === NONE || right === NONE) return `leaves: ${left === NONE ? "left" : "right"} of it there is no empty triangle of candidates`;
    return `leaves: the empty triangles with ${left} and ${right} have the shorter diagonal ${left}–${right}, and so have all others`;
  }

  // All that ever happened to an edge, as texts.
  historyOf(a, b) {
    const lines = [];
    for (let position = 0; position < this.size; ++position) {
      for (let i = this.#begins[position]; i < this.#begins[position + 1]; ++i) {
        const at = WORDS * i;
        const isIt = this.#words[at + 1] === a && this.#words[at + 2] === b && !this.#isHead(i);
        const isAdded = this.#words[at] === KINDS.indexOf("flip") && this.#words[at + 3] === a && this.#words[at + 4] === b;
        if (!isIt && !isAdded) continue;
        lines.push(`${this.stageOf(position).name} (step ${position + 1}): ${isAdded ? "comes by a flip" : this.#reason(this.#step(i), position)}`);
      }
    }
    return lines;
  }

  #isHead(i) {
    const kind = KINDS[this.#words[WORDS * i]];
    return kind === "group" || kind === "cell";
  }

  // What to draw about an edge (Picture.hint): its diamond with the points inside, the triangles by which it leaves.
  hintOf(a, b) {
    const hint = { edge: [a, b] };
    const points = (...all) => all.map((point) => (point === NONE ? -1 : point));
    for (let i = 0; i < this.#count; ++i) {
      const at = WORDS * i;
      if (this.#words[at + 1] !== a || this.#words[at + 2] !== b || this.#isHead(i)) continue;
      const { kind, c, d } = this.#step(i);
      if (kind === "pass") hint.inside = points(c, d);
      if (kind === "refute" || kind === "flip") hint.apexes = points(c, d);
      if (kind === "remove" && c !== NONE) hint.crossed = [c, d];
    }
    return hint;
  }
}

function showLegend(trace) {
  const { kinds } = trace;
  const items = [["shared", kinds.has("certain") || kinds.has("open") ? "candidate" : "edge"], ["fresh", "new in this step"]];
  if (kinds.has("certain")) items.push(["certain", "certain"]);
  if (kinds.has("cell")) items.push(["certain", "of a leaf"]);
  if (kinds.has("open")) items.push(["open", "open, shaded by its dual value"]);
  if (kinds.has("cut")) items.push(["first", "cut"]);
  if (kinds.has("remove") || kinds.has("flip") || kinds.has("refute")) items.push(["leaving", "leaves in this step"]);
  element("legend").replaceChildren(
    ...items.map(([className, text]) => {
      const item = document.createElement("li");
      item.className = className;
      item.textContent = text;
      return item;
    }),
  );
}

export class Player {
  trace = null;
  #picture;
  #points;
  #leave;
  #timer = 0;

  // `leave()` draws what was there before.
  constructor(picture, points, leave) {
    this.#picture = picture;
    this.#points = points;
    this.#leave = leave;
    element("play-slider").addEventListener("input", (event) => {
      this.pause();
      this.show(Number(event.target.value));
    });
    element("play-toggle").addEventListener("click", () => this.toggle());
    element("play-back").addEventListener("click", () => this.step(-1));
    element("play-next").addEventListener("click", () => this.step(1));
    element("play-stage").addEventListener("change", (event) => {
      this.pause();
      const stage = this.trace.stages[event.target.selectedIndex + 1];
      this.show(stage ? stage.begin : this.trace.size);
    });
    element("play-close").addEventListener("click", () => this.close());
  }

  get isOpen() {
    return this.trace !== null;
  }

  async open(algorithm, seed, timeLimit) {
    let trace = null;
    const request = { job: "play", algorithm, seed, time_limit_s: Number(timeLimit) };
    await ask(request, new Uint8Array(this.#points.coordinates.slice().buffer), (json, bytes) => {
      if (json.type === "trace") trace = new Trace(json, bytes);
    });
    this.present(trace);
  }

  // Begins to play a trace of the points that are shown.
  present(trace) {
    this.trace = trace;
    element("player").hidden = false;
    element("play-slider").max = trace.size;
    element("play-stage").replaceChildren(
      ...trace.stages.map(({ name }, i) => {
        const option = document.createElement("option");
        option.textContent = `${i + 1} ${name}`;
        return option;
      }),
    );
    showLegend(trace);
    this.show(0);
    element("play-toggle").focus();
  }

  close() {
    if (!this.trace) return;
    this.pause();
    this.trace = null;
    this.#picture.hint = null;
    element("player").hidden = true;
    this.#leave();
  }

  show(position) {
    const { trace } = this;
    trace.goTo(Math.max(0, Math.min(trace.size, position)));
    this.#picture.show(this.#points.coordinates, trace.layers(), trace.boxes);
    element("play-slider").value = trace.position;
    element("play-stage").selectedIndex = trace.stages.indexOf(trace.stageOf(Math.max(0, trace.position - 1)));
    element("play-text").textContent = trace.describe();
    element("play-slider").setAttribute("aria-valuetext", trace.describe());
  }

  step(by) {
    this.pause();
    this.show(this.trace.position + by);
  }

  pause() {
    cancelAnimationFrame(this.#timer);
    this.#timer = 0;
    element("play-toggle").textContent = "play";
  }

  toggle() {
    if (this.#timer) return this.pause();
    if (this.trace.position === this.trace.size) this.show(0);
    element("play-toggle").textContent = "pause";
    let due = 0;
    let before = performance.now();
    const advance = (now) => {
      due += ((now - before) / 1000) * Number(element("play-speed").value);
      before = now;
      const steps = Math.floor(due);
      if (steps > 0) {
        due -= steps;
        this.show(this.trace.position + steps);
      }
      if (this.trace.position === this.trace.size) return this.pause();
      this.#timer = requestAnimationFrame(advance);
    };
    this.#timer = requestAnimationFrame(advance);
  }

  // The edge of the state nearest to a place on the screen, with its history; null if none is near.
  edgeAt(x, y) {
    const near = 8;
    let best = null;
    let least = near * near;
    const c = this.#points.coordinates;
    const [left, top] = this.#picture.toWorld(x - near, y - near);
    const [right, bottom] = this.#picture.toWorld(x + near, y + near);
    for (const edge of this.trace.edges.values()) {
      const [a, b] = [2 * edge.a, 2 * edge.b];
      if ((c[a] < left && c[b] < left) || (c[a] > right && c[b] > right)) continue;
      if ((c[a + 1] < bottom && c[b + 1] < bottom) || (c[a + 1] > top && c[b + 1] > top)) continue;
      const [ax, ay] = this.#picture.toScreen(c[2 * edge.a], c[2 * edge.a + 1]);
      const [bx, by] = this.#picture.toScreen(c[2 * edge.b], c[2 * edge.b + 1]);
      const length = (bx - ax) ** 2 + (by - ay) ** 2 || 1;
      const t = Math.max(0, Math.min(1, ((x - ax) * (bx - ax) + (y - ay) * (by - ay)) / length));
      const distance = (ax + t * (bx - ax) - x) ** 2 + (ay + t * (by - ay) - y) ** 2;
      if (distance < least) [best, least] = [edge, distance];
    }
    return best;
  }

  hover(x, y) {
    const edge = this.edgeAt(x, y);
    this.#picture.hint = edge && this.trace.hintOf(edge.a, edge.b);
    element("play-edge").textContent = edge ? `edge ${edge.a}–${edge.b}. ${this.trace.historyOf(edge.a, edge.b).join("; ") || "from the start"}` : "";
  }
}
