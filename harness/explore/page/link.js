// The view as the part of an address behind '#', and back.

const MOST_POINTS = 400; // of points that no family makes; more do not go into a link
const LONGEST = 16000; // characters

function putParameters(into, prefix, parameters) {
  for (const [name, value] of Object.entries(parameters)) into.set(`${prefix}.${name}`, value);
}

function takeParameters(from, prefix) {
  const names = [...from.keys()].filter((key) => key.startsWith(`${prefix}.`));
  return Object.fromEntries(names.map((key) => [key.slice(prefix.length + 1), from.get(key)]));
}

// The text, or null if the points do not go into a link. Without a source (PointList) all points are in the link.
export function linkOf({ points, algorithms, view }) {
  const link = new URLSearchParams();
  const { source } = points;
  if (source.family) {
    const { family, n, seed, parameters } = source.family;
    link.set("family", family);
    link.set("n", n);
    link.set("seed", seed);
    putParameters(link, "p", parameters);
  } else if (source.given) {
    link.set("given", source.given);
  } else if (source.kept) {
    link.set("kept", source.kept);
  } else {
    if (points.size > MOST_POINTS) return null;
    link.set("points", [...points.coordinates].join(","));
  }
  if (source.family || source.given || source.kept) {
    const edits = points.edits();
    if (edits) link.set("edits", edits);
  }
  for (const slot of ["first", "second"]) {
    link.set(slot, algorithms[slot].name);
    putParameters(link, slot, algorithms[slot].parameters);
  }
  if (algorithms.seed !== "1") link.set("algorithm_seed", algorithms.seed);
  link.set("time_limit", algorithms.timeLimit);
  if (!algorithms.optimum) link.set("optimum", "no");
  if (view) link.set("view", [view.x, view.y, view.scale, view.stretch].join(","));
  const text = link.toString().replaceAll("%2C", ",").replaceAll("%3B", ";");
  return text.length > LONGEST ? null : text;
}

// {source, edits, coordinates, algorithms, view}; null for an empty text.
export function viewOf(text) {
  const link = new URLSearchParams(text);
  if (![...link.keys()].length) return null;
  const numbers = (key) => (link.get(key) ?? "").split(",").filter(Boolean).map(Number);
  let source = {};
  if (link.has("family")) {
    source = { family: { family: link.get("family"), n: link.get("n") ?? "100", seed: link.get("seed") ?? "1", parameters: takeParameters(link, "p") } };
  } else if (link.has("given")) {
    source = { given: link.get("given") };
  } else if (link.has("kept")) {
    source = { kept: link.get("kept") };
  }
  const slot = (name, otherwise) => ({ name: link.get(name) ?? otherwise, parameters: takeParameters(link, name) });
  const [x, y, scale, stretch = 1] = numbers("view");
  return {
    source,
    edits: link.get("edits") ?? "",
    coordinates: Float64Array.from(numbers("points")),
    algorithms: {
      first: slot("first", "greedy"),
      second: slot("second", "optimum"),
      seed: link.get("algorithm_seed") ?? "1",
      timeLimit: link.get("time_limit") ?? "10",
      optimum: link.get("optimum") !== "no",
    },
    isStretched: link.has("stretch"),
    view: [x, y, scale, stretch].every(Number.isFinite) && scale > 0 && stretch > 0 ? { x, y, scale, stretch } : null,
  };
}

// What a link restores, and where.
export function promiseOf(source) {
  const what = "It restores the points, what was changed by hand, the algorithms and the view";
  if (source.kept) return `${what}, while this program runs: it names the points, so save them, too`;
  if (source.given) return `${what}, also in another mwt explore ${source.given} --view TEXT, with the text behind #`;
  return `${what}, also in another mwt explore --view TEXT, with the text behind #`;
}
