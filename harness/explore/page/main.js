// Puts the page together.
import { Choices } from "./choices.js";
import { Editing } from "./editing.js";
import { compareEdges } from "./edges.js";
import { Hunt } from "./hunt.js";
import { Lesson } from "./lesson.js";
import { linkOf, promiseOf, viewOf } from "./link.js";
import { Picture } from "./picture.js";
import { Player } from "./play.js";
import { LARGEST_UNDO, PointList } from "./point_list.js";
import { ask, askForPoints, catalogue, givenPoints, keepPoints, keptPoints, Refusal } from "./program.js";
import { showResults } from "./results.js";
import { Solving } from "./solving.js";
import { commandsOf, MOST_IN_SVG, pointsText, save, svgText, trianglesText } from "./take.js";

const element = (id) => document.getElementById(id);
const points = new PointList();
const picture = new Picture(element("picture"));
let shown = null; // the answer that is drawn
let layers = [];
let given = null;
let described = 0; // how often describe() was called
let loading = 0; // how many sets of points are being made or read
let choices;
let player;
let editing;

function say(text, failed = false) {
  element("status").textContent = text;
  element("status").classList.toggle("failed", failed);
}

const solving = new Solving(show, (message) => {
  shown = null;
  layers = [];
  draw();
  showResults(null);
  say(message, true);
});

// The two triangulations of an answer that are drawn.
function pair(answer) {
  const first = answer.runs[0];
  const second = answer.algorithms.second.name === "optimum" ? answer.optimum : answer.runs[1];
  return { first, second };
}

function layersOf(answer) {
  const { first, second: own } = pair(answer);
  const second = own ?? (answer.isComplete ? null : answer.earlierSecond);
  if (!first?.edges.length) return second?.edges.length ? [{ edges: second.edges, colour: "--second", dashed: true, width: 1.6 }] : [];
  if (!second?.edges.length) return [{ edges: first.edges, colour: answer.algorithms.second.name === "none" ? "--shared" : "--first", dashed: false, width: 1.2 }];
  if (answer.comparedWith !== second.edges) {
    answer.compared = compareEdges(first.edges, second.edges);
    answer.comparedWith = second.edges;
  }
  const { shared, onlyFirst, onlySecond } = answer.compared;
  return [
    { edges: shared, colour: "--shared", dashed: false, width: 1.2 },
    { edges: onlySecond, colour: "--second", dashed: true, width: 2.4 },
    { edges: onlyFirst, colour: "--first", dashed: false, width: 2.4 },
  ];
}

function draw() {
  if (player?.isOpen) return;
  picture.show(points.coordinates, layers);
}

function show(answer) {
  if (answer.size !== points.size) return picture.drawn();
  // Until its second triangulation is there, the earlier one of as many points stays: its edges move with the points.
  if (shown && shown !== answer && shown.size === answer.size && shown.algorithms.second.name === answer.algorithms.second.name)
    answer.earlierSecond = pair(shown).second ?? shown.earlierSecond;
  shown = answer;
  layers = layersOf(answer);
  draw();
  showResults(answer, pair(answer));
  const removed = answer.instance?.duplicates ? `, ${answer.instance.duplicates} of them repeated` : "";
  const waits = !answer.optimum && !answer.isComplete && answer.seeksOptimum;
  say(`${points.size.toLocaleString("en")} points${removed}, ${answer.instance.hull_size} on the hull${waits ? "; the optimum is sought" : ""}`);
  if (answer.isComplete && !editing?.isDragging) describe();
  return picture.drawn();
}

// Points that do not go into a link are left with the program, and become the base of later changes.
async function describe() {
  const number = ++described;
  element("command").textContent = commandsOf({ points, algorithms: choices.algorithms });
  let link = linkOf({ points, algorithms: choices.algorithms, view: picture.view });
  if (link === null) {
    element("copy-link").disabled = true;
    const kept = points.coordinates.slice();
    const name = await keepPoints(kept).catch(() => null);
    if (number !== described || !points.areAt(kept)) return;
    if (name !== null) {
      points.rebase({ kept: name });
      link = linkOf({ points, algorithms: choices.algorithms, view: picture.view });
    }
  }
  element("copy-link").disabled = link === null;
  element("link-note").textContent = link === null ? "These points are too many for a link; save them." : `${promiseOf(points.source)}.`;
  if (link !== null) history.replaceState(null, "", `#${link}`);
}

function solve(anew = false) {
  const task = { coordinates: points.coordinates, algorithms: choices.algorithms };
  if (anew) solving.startAnew(task);
  else solving.start(task);
}

function changed(final) {
  player.close();
  if (shown && shown.size !== points.size) layers = [];
  draw();
  solve();
  if (final) describe();
}

function showNewPoints(coordinates, newSource) {
  player.close();
  points.setBase(coordinates, newSource);
  picture.chosen = -1;
  layers = [];
  shown = null;
  draw();
  picture.fit(false);
  element("stretch").setAttribute("aria-pressed", "false");
}

// Points from a promise of coordinates; keeps what is shown if it fails.
async function load(coordinates, newSource, what) {
  say(`${what} …`);
  ++loading;
  try {
    showNewPoints(await coordinates, newSource);
  } catch (error) {
    say(error instanceof Refusal ? error.message : "the program does not answer; does it still run?", true);
    return false;
  } finally {
    setTimeout(() => --loading); // when they are being solved
  }
  return true;
}

const generated = (family) => askForPoints({ job: "generate", ...family, n: Number(family.n) });

async function generate() {
  const family = choices.family;
  if (!/^\d+$/.test(family.n)) return say("n is a whole number", true);
  if (await load(generated(family), { family }, "making points")) solve(true);
}

async function openFile(file) {
  const bytes = new Uint8Array(await file.arrayBuffer());
  if (await load(askForPoints({ job: "open", name: file.name }, bytes), {}, "reading")) solve(true);
}

async function restore(view) {
  if (!choices.knowsAlgorithm(view.algorithms.first.name)) view.algorithms.first.name = "greedy";
  if (!["optimum", "none"].includes(view.algorithms.second.name) && !choices.knowsAlgorithm(view.algorithms.second.name))
    view.algorithms.second.name = "optimum";
  view.algorithms.timeLimit = choices.allowedTime(view.algorithms.timeLimit);
  choices.algorithms = view.algorithms;
  let loaded = true;
  if (view.source.family && choices.knowsFamily(view.source.family.family)) {
    choices.family = view.source.family;
    view.source.family.n = choices.family.n; // of a named instance its only one
    loaded = await load(generated(view.source.family), view.source, "making points");
  } else if (view.source.kept) {
    loaded = await load(keptPoints(view.source.kept), view.source, "looking for points");
  } else if (view.source.given && given?.name === view.source.given) {
    showNewPoints(given.points.slice(), view.source);
  } else if (view.coordinates.length > 0) {
    showNewPoints(view.coordinates, {});
  } else {
    return say("this link is of other points than the program has", true);
  }
  if (!loaded) return;
  points.applyEdits(view.edits);
  draw();
  if (view.view) picture.view = view.view;
  else if (view.isStretched) picture.fit(true);
  element("stretch").setAttribute("aria-pressed", picture.view.stretch !== 1);
  solve(true);
}

const START = { family: "uniform", n: "100", seed: "1", parameters: {} };

function watchButtons(editing) {
  element("fit").addEventListener("click", () => picture.fit());
  element("stretch").addEventListener("click", () => {
    picture.fit(picture.view.stretch === 1);
    element("stretch").setAttribute("aria-pressed", picture.view.stretch !== 1);
    describe();
  });
  element("zoom-in").addEventListener("click", () => picture.zoom(1.25));
  element("zoom-out").addEventListener("click", () => picture.zoom(0.8));
  element("play").addEventListener("click", playFirst);
  element("save-proof").addEventListener("click", saveProof);
  for (const kind of ["pointermove", "pointerdown"]) {
    element("picture").addEventListener(kind, (event) => {
      if (player.isOpen && (kind === "pointerdown" || event.buttons === 0)) player.hover(event.offsetX, event.offsetY);
    });
  }
  element("undo").addEventListener("click", () => {
    if (!editing.undo()) say(`there is nothing to undo; changes are kept of up to ${LARGEST_UNDO.toLocaleString("en")} points`);
  });
  element("clear").addEventListener("click", () => {
    showNewPoints(new Float64Array(0), {});
    showResults(null);
    describe();
    document.querySelector('input[name="mode"][value="add"]').checked = true;
    say("add points: three are a triangle");
  });
  element("open").addEventListener("click", () => element("file").click());
  element("file").addEventListener("change", (event) => {
    if (event.target.files.length > 0) openFile(event.target.files[0]);
    event.target.value = "";
  });
  element("theme").addEventListener("click", () => {
    const dark = getComputedStyle(document.documentElement).colorScheme === "dark";
    document.documentElement.dataset.theme = dark ? "light" : "dark";
    picture.redraw();
  });
  element("copy-link").addEventListener("click", async () => {
    await describe();
    await navigator.clipboard.writeText(location.href);
    element("link-note").textContent = `Copied. ${promiseOf(points.source)}.`;
  });
  element("copy-command").addEventListener("click", () => navigator.clipboard.writeText(element("command").textContent));
  for (const button of document.querySelectorAll("[data-save]")) button.addEventListener("click", () => saveAs(button.dataset.save));
}

async function saveProof() {
  const { seed, timeLimit } = choices.algorithms;
  const algorithm = { name: "exact", parameters: {} };
  say("asking for the proof …");
  try {
    const bytes = new Uint8Array(points.coordinates.slice().buffer);
    await ask({ job: "prove", algorithm, seed, time_limit_s: Number(timeLimit) }, bytes, (json, proof) => {
      save("points.mwtproof", new Blob([proof]));
    });
    say("the proof is saved; with points.csv, check it by: mwt_verify points.csv points.mwtproof");
  } catch (error) {
    say(error instanceof Refusal ? error.message : "the program does not answer; does it still run?", true);
  }
}

async function playFirst() {
  const { first, seed, timeLimit } = choices.algorithms;
  say("asking for the steps …");
  try {
    await player.open(first, seed, timeLimit);
    say(`${first.name}: ${player.trace.size.toLocaleString("en")} steps`);
  } catch (error) {
    say(error instanceof Refusal ? error.message : "the program does not answer; does it still run?", true);
  }
}

function saveAs(what) {
  if (what === "svg" && points.size > MOST_IN_SVG) say(`an SVG is for at most ${MOST_IN_SVG.toLocaleString("en")} points; take the PNG`, true);
  else if (what === "svg") save("triangulations.svg", svgText(points.coordinates, layers), "image/svg+xml");
  if (what === "png") picture.toBlob((blob) => save("triangulations.png", blob));
  if (what === "points") save("points.csv", pointsText(points.coordinates), "text/csv");
  if (what !== "first" && what !== "second") return;
  const solution = shown && pair(shown)[what];
  if (solution?.triangles.length) save(`${what}.csv`, trianglesText(solution.triangles), "text/csv");
  else say("there is no such triangulation", true);
}

async function begin() {
  player = new Player(picture, points, () => {
    draw();
    showResults(shown, shown && pair(shown));
  });
  choices = new Choices(await catalogue(), generate, () => {
    player.close();
    describe();
    if (points.size > 0) solve(true);
  });
  given = await givenPoints();
  editing = new Editing(element("picture"), picture, points, changed);
  editing.player = player;
  watchButtons(editing);
  new Hunt(
    () => choices.algorithms,
    (coordinates) => {
      showNewPoints(coordinates, {});
      solve(true);
    },
  );
  new Lesson((view) => restore(viewOf(view)));
  window.matchMedia("(prefers-color-scheme: dark)").addEventListener("change", () => picture.redraw());
  window.addEventListener("hashchange", () => {
    const view = viewOf(location.hash.slice(1));
    if (view) restore(view);
  });
  const view = viewOf(location.hash.slice(1));
  choices.family = START;
  choices.algorithms = { first: { name: "greedy", parameters: {} }, second: { name: "optimum", parameters: {} }, seed: "1", timeLimit: choices.allowedTime(10), optimum: true };
  if (view) return restore(view);
  if (!given) return generate();
  showNewPoints(given.points.slice(), { given: given.name });
  solve(true);
}

// For measurements and tests.
window.explorer = { points, picture, solving, get player() { return player; }, get isLoading() { return loading > 0; }, get shown() { return shown; } };
begin().catch(() => say("the program does not answer; does it still run?", true));
