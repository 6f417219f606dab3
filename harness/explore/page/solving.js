// Keeps the shown triangulations up to date while points change: one job at a time, for the newest points.
import { ask, Refusal } from "./program.js";

const PATIENCE_MS = 60; // so long a job may go on for older points, so that small sets get their optimum while dragged

// One triangulation as shown.
export function solutionOf(json, bytes) {
  const edges = new Uint32Array(bytes, 0, bytes.byteLength ? 2 * json.edges : 0);
  const triangles = new Uint32Array(bytes, 4 * edges.length, bytes.byteLength ? 3 * json.triangles : 0);
  return { edges, triangles };
}

export class Solving {
  latency = []; // milliseconds from a change of the points until its first triangulation is drawn, for measurements
  completeLatency = []; // and until all of its answer is
  #task = null; // what is to be solved, newest only
  #changedAt = 0;
  #abort = null;
  #isFirstDone = false;
  #beganAt = 0;
  #timer = 0;

  // `show(answer)` gets what is known so far and returns a promise that it is drawn; `fail(message)` the program's refusal.
  constructor(show, fail) {
    this.show = show;
    this.fail = fail;
  }

  get isIdle() {
    return !this.#abort && !this.#task;
  }

  // Solves `task` = {coordinates, algorithms} as soon as the first triangulation of the one under way is there, and that
  // has had a little time for the others.
  start(task) {
    if (!this.#task) this.#changedAt = performance.now();
    this.#task = task;
    if (!this.#abort) this.#run();
    else this.#giveUpLater();
  }

  // Does not wait for the one under way.
  startAnew(task) {
    this.start(task);
    if (this.#task) this.#abort.abort();
  }

  #giveUpLater() {
    if (!this.#isFirstDone || this.#timer) return;
    const abort = this.#abort;
    this.#timer = setTimeout(() => abort.abort(), Math.max(0, this.#beganAt + PATIENCE_MS - performance.now()));
  }

  async #run() {
    while (this.#task) {
      const task = this.#task;
      const changedAt = this.#changedAt;
      this.#task = null;
      this.#isFirstDone = false;
      this.#beganAt = performance.now();
      this.#abort = new AbortController();
      try {
        await this.#solve(task, changedAt, this.#abort.signal);
      } catch (error) {
        if (error.name !== "AbortError") {
          if (!this.#task) this.fail(error instanceof Refusal ? error.message : "the program does not answer; does it still run?");
        }
      }
      clearTimeout(this.#timer);
      this.#timer = 0;
      this.#abort = null;
    }
  }

  async #solve({ coordinates, algorithms }, changedAt, signal) {
    const seeksOptimum = algorithms.optimum || algorithms.second.name === "optimum";
    const answer = { algorithms, seeksOptimum, instance: null, runs: [], optimum: null, size: coordinates.length / 2, isComplete: false };
    const asked = [algorithms.first, algorithms.second].filter(({ name }) => name !== "none" && name !== "optimum");
    const request = {
      job: "solve",
      algorithms: asked,
      seed: algorithms.seed,
      optimum: seeksOptimum,
      time_limit_s: Number(algorithms.timeLimit),
    };
    const bytes = new Uint8Array(coordinates.buffer, coordinates.byteOffset, coordinates.byteLength);
    const onFrame = (json, answered) => {
      if (json.type === "instance") answer.instance = json;
      if (json.type === "run") answer.runs[json.slot] = { ...asked[json.slot], run: json.run, ...solutionOf(json, answered) };
      if (json.type === "optimum") answer.optimum = { ...json, ...solutionOf(json, answered) };
      if (json.type === "rating") answer.runs[json.slot].run = json.run;
      if (json.type !== "run") return; // the ratings follow the optimum, and the end them
      const drawn = this.show(answer);
      if (json.slot > 0) return;
      this.#isFirstDone = true;
      drawn.then(() => this.latency.push(performance.now() - changedAt));
      if (this.#task) this.#giveUpLater();
    };
    await ask(request, bytes, onFrame, signal);
    answer.isComplete = true;
    this.show(answer).then(() => this.completeLatency.push(performance.now() - changedAt));
  }
}
