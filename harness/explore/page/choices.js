// The forms: which points, which algorithms. Filled from the program's catalogue.

const element = (id) => document.getElementById(id);

function option(value, text = value) {
  const made = document.createElement("option");
  made.value = value;
  made.textContent = text;
  return made;
}

// An input per declared parameter, with its default.
function showParameters(place, declared, values = {}) {
  place.replaceChildren(
    ...declared.map((parameter) => {
      const label = document.createElement("label");
      label.textContent = `${parameter.name} `;
      label.title = parameter.summary;
      let input;
      if (parameter.type === "choice" || (parameter.type === "text" && parameter.choices.length > 0)) {
        input = document.createElement("select");
        input.append(...parameter.choices.map((choice) => option(choice)));
      } else {
        input = document.createElement("input");
      }
      input.name = parameter.name;
      input.value = values[parameter.name] ?? parameter.default;
      input.dataset.default = parameter.default;
      label.append(input);
      return label;
    }),
  );
}

// The values that are not the defaults.
function parametersIn(place) {
  const inputs = [...place.querySelectorAll("input, select")];
  return Object.fromEntries(inputs.filter((input) => input.value !== input.dataset.default).map((input) => [input.name, input.value]));
}

export class Choices {
  #catalogue;

  // `onPoints()` is called when other points are asked for, `onAlgorithms()` when other algorithms are.
  constructor(catalogue, onPoints, onAlgorithms) {
    this.#catalogue = catalogue;
    element("family").append(...catalogue.generators.map((family) => option(family.name)));
    element("first").append(...catalogue.algorithms.map((algorithm) => option(algorithm.name)));
    element("second").append(option("optimum", "the proved optimum"), option("none", "none"));
    element("second").append(...catalogue.algorithms.map((algorithm) => option(algorithm.name)));
    element("family").addEventListener("change", () => {
      this.#showFamily();
      const family = this.#family();
      const n = Number(element("n").value);
      if (n < family.min_n) element("n").value = family.min_n;
      onPoints();
    });
    element("points-form").addEventListener("submit", (event) => {
      event.preventDefault();
      onPoints();
    });
    for (const slot of ["first", "second"])
      element(slot).addEventListener("change", () => this.#showAlgorithm(slot));
    element("algorithms-form").addEventListener("change", onAlgorithms);
    element("algorithms-form").addEventListener("submit", (event) => event.preventDefault());
  }

  #family() {
    return this.#catalogue.generators.find((family) => family.name === element("family").value);
  }

  #showFamily(values) {
    const family = this.#family();
    element("family-about").textContent = family.summary;
    showParameters(element("family-parameters"), family.parameters, values);
    element("n").disabled = family.fixed_n > 0;
    if (family.fixed_n > 0) element("n").value = family.fixed_n;
    element("seed").disabled = family.seeded === false;
  }

  #showAlgorithm(slot, values) {
    const algorithm = this.#catalogue.algorithms.find(({ name }) => name === element(slot).value);
    showParameters(element(`${slot}-parameters`), algorithm ? algorithm.parameters : [], values);
  }

  get family() {
    return {
      family: element("family").value,
      n: element("n").value.trim(),
      seed: element("seed").value.trim(),
      parameters: parametersIn(element("family-parameters")),
    };
  }

  set family({ family, n, seed, parameters }) {
    element("family").value = family;
    element("n").value = n;
    element("seed").value = seed;
    this.#showFamily(parameters);
  }

  get algorithms() {
    return {
      first: { name: element("first").value, parameters: parametersIn(element("first-parameters")) },
      second: { name: element("second").value, parameters: parametersIn(element("second-parameters")) },
      seed: element("algorithm-seed").value.trim(),
      timeLimit: element("time-limit").value.trim(),
      optimum: element("optimum").checked,
    };
  }

  set algorithms({ first, second, seed, timeLimit, optimum }) {
    for (const [slot, chosen] of [["first", first], ["second", second]]) {
      element(slot).value = chosen.name;
      this.#showAlgorithm(slot, chosen.parameters);
    }
    element("algorithm-seed").value = seed;
    element("time-limit").value = timeLimit;
    element("optimum").checked = optimum;
  }

  // A time limit that the program takes: this one, or its longest.
  allowedTime(timeLimit) {
    return String(Math.min(Number(timeLimit) || 10, this.#catalogue.max_time_s));
  }

  knowsFamily(name) {
    return this.#catalogue.generators.some((family) => family.name === name);
  }

  knowsAlgorithm(name) {
    return this.#catalogue.algorithms.some((algorithm) => algorithm.name === name);
  }
}
