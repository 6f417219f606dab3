"use strict";
// A figure that readers choose: every run a mark, x, y, families and algorithms by choice; zoom; a run's command.
//
// <div class="figure-explorer" data-source="ID"> shows the runs of the DataTable of that source, or those of a runs.csv that the
// reader drops onto the page or opens. Its JSON, <script type="application/json" id="explorer-data">:
//   looks    {algorithm: [colour, marker, filled]}: as in the figures, in their order; "" is the colour of text
//   others   [[colour, marker]]: of further algorithms
//   study    the name of the page's study
//   folder   where a study of one's own keeps its files, in commands
// Marks are drawn on a canvas: 100,000 of them take a tenth of a second.

const MANY_RUNS = 20000; // beyond, marks are small squares
const NEAR = 14; // CSS pixels from the pointer to a mark
const MARGIN = { left: 74, right: 14, top: 10, bottom: 44 };
const LANE = 24; // CSS pixels at the end of a logarithmic axis for values that have no logarithm: 0
const MARK = 4.5;

const CORNERS = { "s": [4, 45], "D": [4, 0], "d": [4, 0], "^": [3, -90], "v": [3, 90], "<": [3, 180], ">": [3, 0], "p": [5, -90],
  "h": [6, -90], "H": [6, 0], "8": [8, 22.5] };

function markPath(context, marker, x, y, radius) {
  context.beginPath();
  if (marker in CORNERS) {
    const [count, angle] = CORNERS[marker];
    for (let i = 0; i < count; ++i) {
      const turn = (angle + 360 * i / count) * Math.PI / 180;
      context.lineTo(x + radius * Math.cos(turn) * (marker === "d" ? 0.6 : 1), y + radius * Math.sin(turn));
    }
  } else if (marker === "*") {
    for (let i = 0; i < 10; ++i) {
      const turn = (-90 + 36 * i) * Math.PI / 180, length = radius * (i % 2 ? 0.45 : 1.2);
      context.lineTo(x + length * Math.cos(turn), y + length * Math.sin(turn));
    }
  } else if (marker === "X" || marker === "P") {
    const turned = marker === "X" ? Math.PI / 4 : 0, thin = radius * 0.38;
    for (let i = 0; i < 4; ++i) {
      for (const [along, across] of [[thin, -thin], [radius, -thin], [radius, thin]]) {
        const turn = turned + i * Math.PI / 2;
        context.lineTo(x + along * Math.cos(turn) - across * Math.sin(turn), y + along * Math.sin(turn) + across * Math.cos(turn));
      }
    }
  } else {
    context.arc(x, y, radius * 0.9, 0, 2 * Math.PI);
  }
  context.closePath();
}

// One axis: from values to pixels. `view` is [low, high], logarithms on a logarithmic axis.
class Axis {
  constructor(title, isLog, whole, hasLane) {
    Object.assign(this, { title, isLog, whole, hasLane, view: [...whole] });
  }

  // Pixels from `begin` (low values) to `end`.
  place(begin, end) {
    const lane = this.hasLane ? Math.sign(end - begin) * LANE : 0;
    Object.assign(this, { begin: begin + lane, end, lanePixel: begin + lane / 2.5 });
  }

  isZero(value) {
    return this.isLog && value <= 0;
  }

  pixel(value) {
    if (this.isZero(value)) return this.lanePixel;
    return this.pixelOf(this.isLog ? Math.log10(value) : value);
  }

  pixelOf(position) {
    return this.begin + (position - this.view[0]) / (this.view[1] - this.view[0]) * (this.end - this.begin);
  }

  positionOf(pixel) {
    return this.view[0] + (pixel - this.begin) / (this.end - this.begin) * (this.view[1] - this.view[0]);
  }

  shows(value) {
    if (this.isZero(value)) return true;
    const position = this.isLog ? Math.log10(value) : value;
    return position >= this.view[0] && position <= this.view[1];
  }

  // Around a position, by a factor above 1 to see more; no more than everything, no less than a millionth of it.
  zoom(position, factor) {
    const all = this.whole[1] - this.whole[0];
    const width = Math.min(all, Math.max(all * 1e-6, (this.view[1] - this.view[0]) * factor));
    const share = (position - this.view[0]) / (this.view[1] - this.view[0]);
    const low = Math.min(Math.max(position - share * width, this.whole[0]), this.whole[1] - width);
    this.view = [low, low + width];
  }

  // [[position, text]], at most about `count` of them.
  ticks(count) {
    const [low, high] = this.view;
    if (!this.isLog || high - low < 1) return this.isLog ? this.linearTicks(10 ** low, 10 ** high, count, Math.log10) : this.linearTicks(low, high, count, (x) => x);
    const step = Math.ceil((high - low) / count);
    const all = [];
    for (let decade = Math.ceil(low / step) * step; decade <= high; decade += step) all.push([decade, tickText(10 ** decade)]);
    return all;
  }

  linearTicks(low, high, count, position) {
    const raw = (high - low) / count, power = 10 ** Math.floor(Math.log10(raw));
    const step = [1, 2, 5, 10].find((factor) => factor * power >= raw) * power;
    const all = [];
    for (let i = Math.ceil(low / step); i * step <= high; ++i) all.push([position(i * step), tickText(i * step)]);
    return all;
  }
}

function tickText(value) {
  const size = Math.abs(value);
  if (size !== 0 && (size < 1e-4 || size >= 1e7)) {
    const [digits, power] = value.toExponential(2).split("e");
    return `${Number(digits) === 1 ? "" : `${Number(digits)}·`}10${[...String(Number(power))].map((sign) => "⁰¹²³⁴⁵⁶⁷⁸⁹"[sign] ?? "⁻").join("")}`;
  }
  return Number(value.toPrecision(6)).toLocaleString("en", { maximumSignificantDigits: 6 });
}

class FigureExplorer {
  constructor(place, table) {
    this.place = place;
    this.table = table;
    Object.assign(this, JSON.parse(document.getElementById("explorer-data").textContent));
    this.own = runsOfTable(table, `study “${this.study}”`);
    this.pinned = false;
    this.build();
    this.use(this.own);
    this.listen();
  }

  add(parent, name, properties) {
    return addElement(parent, name, properties);
  }

  build() {
    const controls = this.add(this.place, "div", { className: "choices" });
    this.axisChoice = {};
    for (const axis of ["x", "y"]) {
      const select = this.add(this.add(controls, "label", { textContent: `${axis} ` }), "select");
      const label = this.add(controls, "label", { className: "inline" });
      const log = this.add(label, "input", { type: "checkbox" });
      label.append(` ${axis} logarithmic`);
      this.axisChoice[axis] = { select, log };
      select.addEventListener("change", () => this.chooseAxis(axis));
      log.addEventListener("change", () => this.refit());
    }
    const lists = this.add(this.place, "div", { className: "explorer-lists" });
    this.lists = { variant: this.addList(lists, "algorithms"), points: this.addList(lists, "families") };
    this.buildPicture();
    this.buildFileChoice();
  }

  addList(parent, title) {
    const set = this.add(parent, "fieldset");
    this.add(set, "legend", { textContent: title });
    const list = { boxes: new Map(), body: this.add(set, "div", { className: "explorer-list" }) };
    for (const [text, checked] of [["all", true], ["none", false]]) {
      this.add(set, "button", { type: "button", textContent: text }).addEventListener("click", () => {
        for (const box of list.boxes.values()) box.checked = checked;
        this.draw();
      });
    }
    return list;
  }

  buildPicture() {
    const zoom = this.add(this.place, "div", { className: "choices zoom" });
    const button = (text, act) => this.add(zoom, "button", { type: "button", textContent: text }).addEventListener("click", act);
    button("zoom in", () => this.zoom(0.5));
    button("zoom out", () => this.zoom(2));
    button("show everything", () => this.refit());
    this.status = this.add(zoom, "span", { className: "soft" });
    this.status.setAttribute("role", "status");
    const frame = this.add(this.place, "div", { className: "explorer-frame" });
    this.canvas = this.add(frame, "canvas", { tabIndex: 0 });
    this.canvas.setAttribute("role", "application");
    this.canvas.setAttribute("aria-label", "Figure of all chosen runs. Arrow keys go from run to run; plus, minus and 0 zoom.");
    this.hint = this.add(frame, "div", { className: "explorer-hint", hidden: true });
    this.box = this.add(frame, "div", { className: "explorer-box", hidden: true });
    this.details = this.add(this.place, "div", { className: "explorer-details" });
    this.details.setAttribute("aria-live", "polite");
  }

  buildFileChoice() {
    const line = this.add(this.place, "div", { className: "choices" });
    const label = this.add(line, "label", { textContent: "other runs: open a runs.csv, or drop it onto this page " });
    this.file = this.add(label, "input", { type: "file", accept: ".csv,text/csv" });
    this.file.addEventListener("change", () => this.file.files.length && this.open(this.file.files[0]));
    this.back = this.add(line, "button", { type: "button", textContent: "back to this page’s runs", hidden: true });
    this.back.addEventListener("click", () => { this.file.value = ""; this.say(""); this.use(this.own); });
    this.message = this.add(this.place, "p", { className: "explorer-message" });
    this.message.setAttribute("role", "alert");
  }

  listen() {
    const canvas = this.canvas;
    canvas.addEventListener("pointermove", (event) => this.onMove(event));
    canvas.addEventListener("pointerleave", () => { if (!this.drag) this.point(-1); });
    canvas.addEventListener("pointerdown", (event) => this.onDown(event));
    canvas.addEventListener("pointerup", (event) => this.onUp(event));
    canvas.addEventListener("pointercancel", () => this.endDrag());
    canvas.addEventListener("dblclick", () => this.refit());
    canvas.addEventListener("keydown", (event) => this.onKey(event));
    canvas.addEventListener("wheel", (event) => this.onWheel(event), { passive: false });
    canvas.addEventListener("focus", () => { if (this.current < 0 && canvas.matches(":focus-visible")) this.step(0, true); });
    new ResizeObserver(() => this.draw()).observe(canvas.parentElement);
    new MutationObserver(() => this.draw()).observe(document.documentElement, { attributes: true });
    matchMedia("(prefers-color-scheme: dark)").addEventListener("change", () => this.draw());
    for (const name of ["dragover", "drop"]) document.addEventListener(name, (event) => this.onDrop(event));
    document.addEventListener("dragleave", () => this.place.classList.remove("dropping"));
  }

  // Files.

  onDrop(event) {
    if (!event.dataTransfer || ![...event.dataTransfer.types].includes("Files")) return;
    event.preventDefault();
    this.place.classList.toggle("dropping", event.type === "dragover");
    if (event.type !== "drop") return;
    this.place.scrollIntoView({ block: "nearest" });
    this.open(event.dataTransfer.files[0]);
  }

  async open(file) {
    const turn = this.turn = (this.turn ?? 0) + 1;
    this.say(`Reading ${file.name} …`, true);
    try {
      const text = await file.text();
      const runs = await runsOfCsv(text, file.name,
        (share) => { if (turn === this.turn) this.say(`Reading ${file.name}: ${Math.round(100 * share)} %`, true); });
      if (turn !== this.turn) return;
      this.say("");
      this.use(runs);
    } catch (mistake) {
      if (turn !== this.turn) return;
      const isKnown = mistake instanceof InputMistake;
      this.say(isKnown ? mistake.message : `${file.name}: cannot be read (${mistake.message})`);
    }
  }

  say(text, isProgress = false) {
    this.message.textContent = text;
    this.message.classList.toggle("soft", isProgress);
  }

  // What is shown.

  use(runs) {
    this.runs = runs;
    this.back.hidden = runs === this.own;
    this.measures = MEASURES.filter(([measure]) => {
      const values = runs.numbers[measure];
      const first = values.find((value) => !Number.isNaN(value));
      return first !== undefined && (measure === "n" || values.some((value) => !Number.isNaN(value) && value !== first));
    });
    this.fillLists();
    const has = (measure) => this.measures.some(([name]) => name === measure);
    const wanted = { x: "n", y: has("excess") ? "excess" : has("time") ? "time" : this.measures.at(-1)[0] };
    for (const axis of ["x", "y"]) {
      const { select } = this.axisChoice[axis];
      select.replaceChildren();
      for (const [value, textContent] of this.measures) this.add(select, "option", { value, textContent });
      select.value = wanted[axis];
      this.chooseAxis(axis, false);
    }
    this.refit();
  }

  fillLists() {
    const order = Object.keys(this.looks);
    const rank = (label) => (order.includes(label.split(" ")[0]) ? order.indexOf(label.split(" ")[0]) : order.length);
    for (const [name, list] of Object.entries(this.lists)) {
      const column = this.runs.texts[name];
      const counts = new Float64Array(column.values.length);
      for (const code of column.codes) ++counts[code];
      const codes = [...column.values.keys()];
      if (name === "variant") codes.sort((a, b) => rank(column.values[a]) - rank(column.values[b]));
      list.boxes.clear();
      list.body.replaceChildren(...codes.map((code) => this.listEntry(list, name, code, column.values[code], counts[code])));
    }
    this.styleLabels();
  }

  listEntry(list, name, code, text, count) {
    const label = document.createElement("label");
    const box = this.add(label, "input", { type: "checkbox", checked: true });
    box.addEventListener("change", () => this.draw());
    list.boxes.set(code, box);
    if (name === "variant") this.add(label, "canvas", { width: 32, height: 32, className: "swatch" }).dataset.code = code;
    this.add(label, "span", { textContent: ` ${text} ` });
    this.add(label, "span", { textContent: `(${count.toLocaleString("en")})`, className: "soft" });
    return label;
  }

  // A look per label: [colour, marker, kind of filling].
  styleLabels() {
    const variants = new Map(), others = new Map();
    this.labelLooks = this.runs.texts.variant.values.map((label) => {
      const name = label.split(" ")[0];
      const variant = variants.get(name) ?? 0;
      variants.set(name, variant + 1);
      if (name in this.looks) {
        const [colour, marker, filled] = this.looks[name];
        return [colour, marker, variant === 0 ? (filled ? 0 : 1) : 1 + variant % 3];
      }
      if (!others.has(name)) others.set(name, this.others[others.size % this.others.length]);
      return [...others.get(name), variant % 4];
    });
  }

  chooseAxis(axis, isFitted = true) {
    const { select, log } = this.axisChoice[axis];
    let low = Infinity, high = 0;
    for (const value of this.runs.numbers[select.value]) {
      if (value > 0 && value < low) low = value;
      if (value > high) high = value;
    }
    log.checked = high > 10 * low;
    if (isFitted) this.refit();
  }

  axis(which) {
    const { select, log } = this.axisChoice[which];
    const values = this.runs.numbers[select.value];
    let low = Infinity, high = -Infinity, hasZero = false;
    for (const value of values) {
      if (!Number.isFinite(value)) continue;
      if (log.checked && value <= 0) { hasZero = true; continue; }
      if (value < low) low = value;
      if (value > high) high = value;
    }
    if (low > high) [low, high] = [1, 1];
    if (log.checked) [low, high] = [Math.log10(low), Math.log10(high)];
    const air = 0.04 * (high - low) || Math.abs(low) * 0.05 || 0.5;
    return new Axis(this.measures.find(([name]) => name === select.value)[1], log.checked, [low - air, high + air], hasZero);
  }

  refit() {
    this.x = this.axis("x");
    this.y = this.axis("y");
    this.current = -1;
    this.pinned = false;
    this.draw();
    this.tell(-1);
  }

  // The numbers of the runs that are on the picture.
  collect() {
    const { runs } = this, xs = runs.numbers[this.axisChoice.x.select.value], ys = runs.numbers[this.axisChoice.y.select.value];
    const chosen = {};
    for (const [name, list] of Object.entries(this.lists)) {
      chosen[name] = new Uint8Array(runs.texts[name].values.length);
      for (const [code, box] of list.boxes) chosen[name][code] = box.checked ? 1 : 0;
    }
    const variant = runs.texts.variant.codes, points = runs.texts.points.codes;
    this.missing = this.elsewhere = 0;
    this.shown = [];
    this.byLabel = this.labelLooks.map(() => []);
    this.px = new Float32Array(runs.size);
    this.py = new Float32Array(runs.size);
    for (let row = 0; row < runs.size; ++row) {
      if (!chosen.variant[variant[row]] || !chosen.points[points[row]]) continue;
      if (!Number.isFinite(xs[row]) || !Number.isFinite(ys[row])) { ++this.missing; continue; }
      if (!this.x.shows(xs[row]) || !this.y.shows(ys[row])) { ++this.elsewhere; continue; }
      this.px[row] = this.x.pixel(xs[row]);
      this.py[row] = this.y.pixel(ys[row]);
      this.shown.push(row);
      this.byLabel[variant[row]].push(row);
    }
  }

  draw() {
    const width = this.canvas.parentElement.clientWidth, height = Math.min(460, Math.max(300, 0.62 * width));
    if (!width || !this.x) return;
    this.scale = devicePixelRatio || 1;
    this.canvas.width = Math.round(width * this.scale);
    this.canvas.height = Math.round(height * this.scale);
    this.canvas.style.height = `${height}px`;
    Object.assign(this, { width, height });
    this.x.place(MARGIN.left, width - MARGIN.right);
    this.y.place(height - MARGIN.bottom, MARGIN.top);
    this.collect();
    const style = getComputedStyle(document.documentElement);
    this.colours = Object.fromEntries(["ink", "soft", "faint", "paper", "link"].map((name) => [name, style.getPropertyValue(`--${name}`).trim()]));
    this.picture = document.createElement("canvas");
    this.picture.width = this.canvas.width;
    this.picture.height = this.canvas.height;
    const context = this.picture.getContext("2d");
    context.scale(this.scale, this.scale);
    this.drawAxes(context);
    this.drawMarks(context);
    this.drawSwatches();
    this.showCurrent();
    this.status.textContent = this.statusText();
  }

  // The picture with a ring around the current run.
  showCurrent() {
    const context = this.canvas.getContext("2d"), row = this.current;
    context.setTransform(1, 0, 0, 1, 0, 0);
    context.clearRect(0, 0, this.canvas.width, this.canvas.height);
    context.drawImage(this.picture, 0, 0);
    if (row < 0 || !this.shown.includes(row)) return;
    context.scale(this.scale, this.scale);
    context.strokeStyle = this.colours.link;
    context.lineWidth = this.pinned ? 3 : 2;
    context.beginPath();
    context.arc(this.px[row], this.py[row], 9, 0, 2 * Math.PI);
    context.stroke();
  }

  statusText() {
    const count = (number) => number.toLocaleString("en");
    const parts = [`${this.runs.name}: ${count(this.shown.length)} of ${count(this.runs.size)} runs shown`];
    if (this.missing) parts.push(`${count(this.missing)} lack one of the two values`);
    if (this.elsewhere) parts.push(`${count(this.elsewhere)} outside of the part shown`);
    return `${parts.join("; ")}. ${this.runs.note ?? ""}`;
  }

  drawAxes(context) {
    const { x, y, colours } = this, right = this.width - MARGIN.right, bottom = this.height - MARGIN.bottom;
    context.font = "12px system-ui, sans-serif";
    context.lineWidth = 1;
    const line = (x1, y1, x2, y2, colour) => {
      context.strokeStyle = colour;
      context.beginPath();
      context.moveTo(x1, y1);
      context.lineTo(x2, y2);
      context.stroke();
    };
    context.fillStyle = colours.ink;
    context.textAlign = "center";
    context.textBaseline = "top";
    const xTicks = x.ticks(Math.max(2, Math.floor((right - MARGIN.left) / 70))).map(([at, text]) => [x.pixelOf(at), text]);
    for (const [at, text] of x.hasLane ? [[x.lanePixel, "0"], ...xTicks] : xTicks) {
      line(at, MARGIN.top, at, bottom, colours.faint);
      context.fillText(text, at, bottom + 6);
    }
    context.textAlign = "right";
    context.textBaseline = "middle";
    const yTicks = y.ticks(Math.max(2, Math.floor(bottom / 45))).map(([at, text]) => [y.pixelOf(at), text]);
    for (const [at, text] of y.hasLane ? [[y.lanePixel, "0"], ...yTicks] : yTicks) {
      line(MARGIN.left, at, right, at, colours.faint);
      context.fillText(text, MARGIN.left - 6, at);
    }
    line(MARGIN.left, bottom, right, bottom, colours.ink);
    line(MARGIN.left, MARGIN.top, MARGIN.left, bottom, colours.ink);
    context.textAlign = "right";
    context.textBaseline = "bottom";
    context.fillText(x.title, right, this.height - 4);
    context.save();
    context.translate(12, MARGIN.top);
    context.rotate(-Math.PI / 2);
    context.textBaseline = "middle";
    context.fillText(y.title, 0, 0);
    context.restore();
  }

  colour(look) {
    return look[0] || this.colours.ink;
  }

  // A mark as a picture of its own, which is quick to repeat.
  sprite(look, size = 16) {
    const canvas = document.createElement("canvas");
    canvas.width = canvas.height = Math.ceil(size * this.scale);
    const context = canvas.getContext("2d");
    context.scale(this.scale, this.scale);
    this.drawMark(context, look, size / 2, size / 2);
    return canvas;
  }

  drawMark(context, look, x, y) {
    const [, marker, filling] = look;
    context.strokeStyle = context.fillStyle = this.colour(look);
    context.lineWidth = 1.3;
    markPath(context, marker, x, y, MARK);
    context.globalAlpha = 0.7;
    if (filling === 0) context.fill();
    context.globalAlpha = 1;
    context.stroke();
    if (filling > 1) {
      context.beginPath();
      context.arc(x, y, filling === 2 ? 1.3 : 2.4, 0, 2 * Math.PI);
      context.fill();
    }
  }

  drawMarks(context) {
    const areMany = this.shown.length > MANY_RUNS;
    this.byLabel.forEach((rows, code) => {
      const look = this.labelLooks[code];
      context.fillStyle = this.colour(look);
      context.globalAlpha = areMany ? 0.6 : 1;
      const sprite = areMany ? null : this.sprite(look);
      for (const row of rows) {
        if (areMany) context.fillRect(this.px[row] - 1, this.py[row] - 1, 2, 2);
        else context.drawImage(sprite, this.px[row] - 8, this.py[row] - 8, 16, 16);
      }
    });
    context.globalAlpha = 1;
  }

  drawSwatches() {
    for (const swatch of this.lists.variant.body.querySelectorAll("canvas")) {
      const context = swatch.getContext("2d");
      context.setTransform(2, 0, 0, 2, 0, 0);
      context.clearRect(0, 0, 16, 16);
      this.drawMark(context, this.labelLooks[swatch.dataset.code], 8, 8);
    }
  }

  // One run.

  // The runs whose marks are at this place, the nearest first; those at one place in their order.
  near(x, y, distance = NEAR) {
    const found = [];
    for (const row of this.shown) {
      const square = (this.px[row] - x) ** 2 + (this.py[row] - y) ** 2;
      if (square <= distance ** 2) found.push([square, row]);
    }
    return found.sort((a, b) => a[0] - b[0] || a[1] - b[1]).map(([, row]) => row);
  }

  point(row) {
    if (this.pinned || row === this.current) return;
    this.current = row;
    this.showCurrent();
    this.tell(row);
  }

  tell(row) {
    this.hint.hidden = row < 0;
    this.details.replaceChildren();
    if (row < 0) {
      this.add(this.details, "p", { className: "soft", textContent: "Point at a mark to see its run and the command that repeats it; click to keep it. Drag to zoom." });
      return;
    }
    const together = this.near(this.px[row], this.py[row], 2);
    const more = together.length - 1;
    const name = `${this.text("variant", row)} on ${this.text("points", row)}, n = ${tickText(this.runs.numbers.n[row])}, seed ${this.runs.numbers.seed[row]}`;
    const values = ["x", "y"].filter((axis) => !["n", "seed"].includes(this.axisChoice[axis].select.value)).map((axis) => this.valueText(axis, row));
    this.hint.textContent = `${[name, ...values].join("; ")}${more ? ` and ${more.toLocaleString("en")} more here` : ""}`;
    this.hint.style.left = `${Math.min(Math.max(4, this.px[row] - 60), Math.max(4, this.width - this.hint.offsetWidth - 4))}px`;
    this.hint.style.top = `${this.py[row] > this.height / 2 ? this.py[row] - this.hint.offsetHeight - 14 : this.py[row] + 14}px`;
    const state = this.text("status", row) === "ok" ? "" : ` (${this.text("status", row)})`;
    const others = more ? `. ${together.indexOf(row) + 1} of ${together.length.toLocaleString("en")} at this place: click again for the next` : "";
    this.add(this.details, "p", { textContent: `${name}${state}; ${this.allValues(row)}. Run ${this.text("run_id", row)}${others}.` });
    this.add(this.add(this.details, "pre", { tabIndex: 0 }), "code", { textContent: this.command(row) });
  }

  text(column, row) {
    return this.runs.texts[column].at(row);
  }

  valueText(axis, row) {
    const { select } = this.axisChoice[axis];
    return `${this[axis].title}: ${numberText(this.runs.numbers[select.value][row])}`;
  }

  allValues(row) {
    return this.measures.filter(([measure]) => !["n", "seed"].includes(measure) && !Number.isNaN(this.runs.numbers[measure][row]))
      .map(([measure, title]) => `${title}: ${numberText(this.runs.numbers[measure][row])}`).join("; ");
  }

  command(row) {
    if (this.runs === this.own) return this.table.command(this.table.rows[row]);
    const isFile = this.text("generator", row) === "file";
    const parameters = this.text("generator_params", row);
    return commandOf(this.table, {
      algorithm: this.text("algorithm", row), n: this.runs.numbers.n[row], seed: this.runs.numbers.seed[row],
      parameters: this.text("params", row).replace(/start=(\S+\.csv)/, `start=${this.folder}/$1`),
      family: this.text("generator", row),
      "family parameters": isFile ? `'${this.folder}/${decodeURIComponent(parameters.replace(/^file=/, "")).replaceAll("'", "'\\''")}'` : parameters,
    });
  }

  // Mouse, fingers, keys.

  positionOf(event) {
    const box = this.canvas.getBoundingClientRect();
    return [event.clientX - box.left, event.clientY - box.top];
  }

  onMove(event) {
    const [x, y] = this.positionOf(event);
    if (this.drag) return this.showBox(x, y);
    if (event.pointerType === "mouse") this.point(this.near(x, y)[0] ?? -1);
  }

  onDown(event) {
    if (event.button !== 0) return;
    const [x, y] = this.positionOf(event);
    this.down = [x, y];
    if (event.pointerType !== "mouse") return; // fingers scroll the page
    this.drag = [x, y];
    this.canvas.setPointerCapture(event.pointerId);
  }

  showBox(x, y) {
    const [x0, y0] = this.drag;
    this.box.hidden = Math.hypot(x - x0, y - y0) < 6;
    Object.assign(this.box.style, { left: `${Math.min(x, x0)}px`, top: `${Math.min(y, y0)}px`,
      width: `${Math.abs(x - x0)}px`, height: `${Math.abs(y - y0)}px` });
  }

  onUp(event) {
    if (!this.down) return;
    const [x, y] = this.positionOf(event), [x0, y0] = this.down;
    const isBox = this.drag && Math.hypot(x - x0, y - y0) >= 6;
    this.endDrag();
    if (isBox) this.zoomTo([x0, x], [y0, y]); else this.pin(x, y);
  }

  endDrag() {
    this.drag = this.down = null;
    this.box.hidden = true;
  }

  // A click keeps a run; another one at the same place goes on to the next one there.
  pin(x, y) {
    const rows = this.near(x, y);
    const wasPinned = this.pinned ? this.current : -1;
    this.pinned = false;
    if (!rows.length) return this.point(-1);
    const here = this.near(this.px[rows[0]], this.py[rows[0]], 2);
    const next = here.includes(wasPinned) ? here[(here.indexOf(wasPinned) + 1) % here.length] : rows[0];
    this.keep(next);
  }

  keep(row) {
    this.pinned = false;
    this.current = -1;
    this.point(row);
    this.pinned = true;
    this.showCurrent();
  }

  zoomTo(xs, ys) {
    for (const [axis, pixels] of [[this.x, xs], [this.y, ys]]) {
      const ends = pixels.map((pixel) => axis.positionOf(pixel)).sort((a, b) => a - b);
      const low = Math.max(ends[0], axis.whole[0]), high = Math.min(ends[1], axis.whole[1]);
      if (high - low > 1e-6 * (axis.whole[1] - axis.whole[0])) axis.view = [low, high];
    }
    this.afterZoom();
  }

  // Around the current run, else the middle.
  zoom(factor, place = null) {
    const isOnPicture = this.current >= 0 && this.shown.includes(this.current);
    const [x, y] = place ?? (isOnPicture ? [this.px[this.current], this.py[this.current]]
      : [(this.x.begin + this.x.end) / 2, (this.y.begin + this.y.end) / 2]);
    this.x.zoom(this.x.positionOf(x), factor);
    this.y.zoom(this.y.positionOf(y), factor);
    this.afterZoom();
  }

  afterZoom() {
    this.draw();
    const row = this.shown.includes(this.current) ? this.current : -1;
    if (row < 0) this.pinned = false;
    this.current = row;
    this.tell(row);
  }

  onWheel(event) {
    if (!event.ctrlKey) return; // the wheel alone scrolls the page
    event.preventDefault();
    this.zoom(Math.exp(0.002 * event.deltaY), this.positionOf(event));
  }

  onKey(event) {
    const act = { ArrowRight: () => this.step(1, true), ArrowLeft: () => this.step(-1, true), ArrowUp: () => this.step(1, false),
      ArrowDown: () => this.step(-1, false), "+": () => this.zoom(0.5), "-": () => this.zoom(2), "0": () => this.refit(),
      Escape: () => { this.pinned = false; this.point(-1); } }[event.key];
    if (!act || event.ctrlKey || event.altKey || event.metaKey) return;
    event.preventDefault();
    act();
  }

  // To the next run from left to right, or upwards.
  step(direction, isAcross) {
    if (!this.shown.length) return;
    const [first, second, sign] = isAcross ? [this.px, this.py, 1] : [this.py, this.px, -1];
    const before = (a, b) => sign * (first[a] - first[b]) || second[a] - second[b] || a - b;
    let next = -1;
    for (const row of this.shown) {
      const isBeyond = this.current < 0 || !direction ? true : direction * before(row, this.current) > 0;
      if (isBeyond && (next < 0 || (direction || 1) * before(row, next) < 0)) next = row;
    }
    if (next >= 0) this.keep(next);
  }
}

function numberText(value) {
  return Number(value.toPrecision(7)).toLocaleString("en", { maximumSignificantDigits: 7 });
}

document.querySelectorAll(".figure-explorer").forEach((place) => {
  place.explorer = new FigureExplorer(place, tables.get(place.dataset.source));
});
