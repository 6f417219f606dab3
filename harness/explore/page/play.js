// Plays what an algorithm did, step by step, from the trace that the program sends.
import { ask } from "./program.js";

const element = (id) => document.getElementById(id);
const KINDS = ["add", "remove", "flip", "certain", "open"];
const NONE = 0xffffffff;
const SHADES = 4;
const WORDS = 5; // of a step: kind, a, b, c, d

// The steps of a trace, and what they make of the edges.
export class Trace {
  constructor(json, bytes) {
    this.size = json.steps;
    this.stages = json.stages;
    this.values = new Float64Array(bytes, 0, this.size);
    this.words = new Uint32Array(bytes, 8 * this.size, WORDS * this.size);
    this.start = new Uint32Array(bytes, (8 + 4 * WORDS) * this.size, 2 * json.start_edges);
    this.reset();
  }

  reset() {
    this.position = 0;
    this.edges = new Map(); // "a-b" -> {a, b, mark}
    for (let i = 0; i < this.start.length; i += 2) this.#put(this.start[i], this.start[i + 1], "plain");
  }

  step(i) {
    const [kind, a, b, c, d] = this.words.subarray(WORDS * i, WORDS * (i + 1));
    return { kind: KINDS[kind], a, b, c, d, value: this.values[i] };
  }

  stageOf(i) {
    return this.stages.findLast((stage) => stage.begin <= i) ?? this.stages[0];
  }

  #put(a, b, mark, value = 0) {
    this.edges.set(`${a}-${b}`, { a, b, mark, value });
  }

  // Goes to the state after so many steps.
  goTo(position) {
    if (position < this.position) this.reset();
    for (; this.position < position; ++this.position) {
      const { kind, a, b, c, d, value } = this.step(this.position);
      if (kind === "remove" || kind === "flip") this.edges.delete(`${a}-${b}`);
      if (kind === "add") this.#put(a, b, "plain");
      if (kind === "flip") this.#put(c, d, "plain");
      if (kind === "certain" || kind === "open") this.#put(a, b, kind, value);
    }
  }

  // The edges of the state, sorted.
  sortedEdges() {
    const edges = [...this.edges.values()].sort((one, other) => one.a - other.a || one.b - other.b);
    return Uint32Array.from(edges.flatMap(({ a, b }) => [a, b]));
  }

  layers() {
    const groups = { plain: [], certain: [], open: Array.from({ length: SHADES }, () => []) };
    for (const { a, b, mark, value } of this.edges.values()) {
      const group = mark === "open" ? groups.open[Math.min(SHADES - 1, Math.floor(value * SHADES))] : groups[mark];
      group.push(a, b);
    }
    const layer = (edges, colour, width, more = {}) => ({ edges: Uint32Array.from(edges), colour, width, dashed: false, ...more });
    const layers = [layer(groups.plain, "--shared", 1.2)];
    groups.open.forEach((edges, shade) => layers.push(layer(edges, "--second", 1.6, { alpha: 0.25 + (0.75 * shade) / (SHADES - 1) })));
    layers.push(layer(groups.certain, "--certain", 2.2));
    if (this.position > 0) {
      const { kind, a, b, c, d } = this.step(this.position - 1);
      if (kind === "remove" || kind === "flip") layers.push(layer([a, b], "--first", 3, { dashed: true }));
      if (kind === "remove" && c !== NONE) layers.push(layer([c, d], "--second", 3));
      if (kind === "flip") layers.push(layer([c, d], "--chosen", 3));
      if (kind === "add" || kind === "certain" || kind === "open") layers.push(layer([a, b], "--chosen", 3));
    }
    return layers;
  }

  // What the last step did.
  describe() {
    if (this.position === 0) return "the start";
    const { kind, a, b, c, d, value } = this.step(this.position - 1);
    const stage = this.stageOf(this.position - 1);
    const head = `${stage.name}, step ${this.position.toLocaleString("en")} of ${this.size.toLocaleString("en")}: `;
    if (kind === "flip") return `${head}edge ${a}–${b} is replaced by ${c}–${d}, shorter by ${value.toPrecision(4)}`;
    if (kind === "remove" && c !== NONE) return `${head}edge ${a}–${b} leaves; it crosses ${c}–${d}`;
    if (kind === "remove" && stage.name === "optimum") return `${head}edge ${a}–${b} leaves: it is not in the optimum`;
    if (kind === "remove" && stage.name === "insertion") return `${head}edge ${a}–${b} leaves: the inserted point lies on it`;
    if (kind === "open") return `${head}edge ${a}–${b} ${stage.reason}, ${value.toPrecision(2)} of the largest`;
    return `${head}edge ${a}–${b} ${stage.reason}`;
  }

  // All that ever happened to an edge, as texts.
  historyOf(a, b) {
    const lines = [];
    for (let i = 0; i < this.size; ++i) {
      const step = this.step(i);
      const isIt = step.a === a && step.b === b;
      const isAdded = step.kind === "flip" && step.c === a && step.d === b;
      if (!isIt && !isAdded) continue;
      const { name, reason } = this.stageOf(i);
      const witness = step.kind === "remove" && step.c !== NONE ? `: ${step.c}–${step.d}` : "";
      const what = isAdded ? "comes by a flip" : name === "optimum" && step.kind === "remove" ? "leaves: it is not in the optimum" : reason;
      lines.push(`${name} (step ${i + 1}): ${what}${witness}`);
    }
    return lines;
  }
}

function showLegend(trace) {
  const kinds = new Set(Array.from({ length: trace.size }, (_, i) => trace.words[WORDS * i]).map((kind) => KINDS[kind]));
  const items = [["shared", kinds.has("certain") || kinds.has("open") ? "candidate" : "edge"], ["fresh", "new in this step"]];
  if (kinds.has("certain")) items.push(["certain", "certain"]);
  if (kinds.has("open")) items.push(["open", "open, shaded by its dual value"]);
  if (kinds.has("remove") || kinds.has("flip")) items.push(["leaving", "leaves in this step"]);
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
    element("player").hidden = true;
    this.#leave();
  }

  show(position) {
    const { trace } = this;
    trace.goTo(Math.max(0, Math.min(trace.size, position)));
    this.#picture.show(this.#points.coordinates, trace.layers());
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
    for (const edge of this.trace.edges.values()) {
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
    this.#picture.diamond = edge ? [edge.a, edge.b] : null;
    this.#picture.redraw();
    element("play-edge").textContent = edge ? `edge ${edge.a}–${edge.b}. ${this.trace.historyOf(edge.a, edge.b).join("; ") || "from the start"}` : "";
  }
}
