// The live search for bad inputs: the worst instance so far becomes the points of the page.
import { ask, Refusal } from "./program.js";

const element = (id) => document.getElementById(id);

export class Hunt {
  #abort = null;
  #show;
  #algorithms;

  // `algorithms()` gives what is chosen, `show(coordinates)` shows points.
  constructor(algorithms, show) {
    this.#algorithms = algorithms;
    this.#show = show;
    element("hunt-form").addEventListener("submit", (event) => {
      event.preventDefault();
      if (this.#abort) this.stop();
      else this.#run();
    });
  }

  stop() {
    this.#abort?.abort();
  }

  async #run() {
    const { first } = this.#algorithms();
    const [n, seed, budget] = ["hunt-n", "hunt-seed", "hunt-budget"].map((id) => element(id).value.trim());
    this.#abort = new AbortController();
    element("hunt-start").textContent = "stop";
    let worst = 0;
    let foundAt = 0;
    const say = (text) => {
      element("hunt-text").textContent = text;
    };
    const onFrame = ({ type, alpha, evaluations }, bytes) => {
      if (type !== "hunted") return;
      if (bytes.byteLength > 0) {
        [worst, foundAt] = [alpha, evaluations];
        this.#show(new Float64Array(bytes));
      }
      say(`${evaluations.toLocaleString("en")} sets tried; worst α ${worst.toPrecision(7)}`);
    };
    try {
      say("hunting …");
      const request = { job: "hunt", algorithm: first, n: Number(n), seed, time_limit_s: Number(budget) };
      await ask(request, new Uint8Array(0), onFrame, this.#abort.signal);
    } catch (error) {
      if (error.name !== "AbortError") say(error instanceof Refusal ? error.message : "the program does not answer; does it still run?");
    }
    this.#abort = null;
    element("hunt-start").textContent = "hunt";
    if (worst === 0) return;
    const parameters = Object.entries(first.parameters).map(([name, value]) => ` --param ${name}=${value}`).join("");
    element("hunt-command").textContent =
      `mwt hunt --algorithm ${first.name}${parameters} --n ${n} --seed ${seed} --evaluations ${foundAt} --budget 3600 -o bad.txt`;
  }
}
