// Draws points and edges on a canvas. What is drawn goes to a buffer, in slices that fit between two frames; until it is
// complete, the buffer before is shown, moved or stretched to where it belongs now.

const FRAME_MS = 9; // drawn at a time
const BATCH = 4000; // edges or points between two looks at the clock
const WIDE_BATCH = 20; // numbers of a path of wide lines
const MOST_STROKED = 40000; // visible edges of one colour; more are added up pixel by pixel
const MOST_DOTS = 60000; // visible points drawn as dots
const NEAR = { mouse: 14, touch: 24 }; // pixels: a point so close is meant

const WHOLE = { x: 0, y: 0, scale: 1, stretch: 1 };

// How often something was drawn at each pixel, and the image of that.
class Coverage {
  constructor(width, height) {
    [this.width, this.height] = [width, height];
    this.counts = new Uint8Array(width * height);
  }

  dot(x, y) {
    if (!(x >= 0 && y >= 0 && x < this.width && y < this.height)) return;
    const place = (y | 0) * this.width + (x | 0);
    if (this.counts[place] < 255) ++this.counts[place];
  }

  // One dot per pixel along the longer direction. The ends may lie far outside.
  line(ax, ay, bx, by) {
    const [dx, dy] = [bx - ax, by - ay];
    const steps = Math.max(Math.abs(dx), Math.abs(dy));
    if (steps < 1) return this.dot((ax + bx) / 2, (ay + by) / 2);
    let [from, to] = [0, 1];
    for (const [start, change, size] of [[ax, dx, this.width], [ay, dy, this.height]]) {
      if (change === 0) continue;
      const [one, other] = [-start / change, (size - start) / change];
      from = Math.max(from, Math.min(one, other));
      to = Math.min(to, Math.max(one, other));
    }
    for (let t = from + 0.5 / steps; t < to; t += 1 / steps) this.dot(ax + t * dx, ay + t * dy);
  }

  // Pixels that were drawn at an average number of times are covered to 65%.
  image([red, green, blue]) {
    let [sum, drawn] = [0, 0];
    for (const count of this.counts) {
      sum += count;
      drawn += count > 0 ? 1 : 0;
    }
    const share = Math.min(0.8, 1 - 0.35 ** (drawn / (sum || 1)));
    const image = new ImageData(this.width, this.height);
    const colour = red | (green << 8) | (blue << 16);
    const shades = Uint32Array.from({ length: 256 }, (_, count) => colour | (Math.round(255 * (1 - (1 - share) ** count)) << 24));
    shades[0] = 0;
    const pixels = new Uint32Array(image.data.buffer);
    for (let i = 0; i < pixels.length; ++i) pixels[i] = shades[this.counts[i]];
    return image;
  }
}

export class Picture {
  frames = []; // milliseconds between frames while moving, for measurements
  drawings = []; // milliseconds from the begin to the end of each drawing, for measurements
  chosen = -1;
  boxes = new Float64Array(0); // left, bottom, right, top of each
  #hint = null;
  #canvas;
  #shownBuffer = null; // {canvas, view, width, height}
  #spare = document.createElement("canvas");
  #view = { ...WHOLE }; // heights are `stretch` times as large as widths
  #coordinates = new Float64Array(0);
  #layers = []; // [{edges, colour, dashed, width}]
  #isDrawing = false;
  #isStale = false; // the drawing under way, if any, is not of what is to be shown
  #awaited = []; // to be called after the drawing that begins next
  #awaitedNow = []; // and after the one under way
  #pending = false;
  #lastFrame = 0;
  #settle = 0;

  constructor(canvas) {
    this.#canvas = canvas;
    new ResizeObserver(() => this.redraw()).observe(canvas);
  }

  get view() {
    return { ...this.#view };
  }

  set view(view) {
    this.#view = { stretch: 1, ...view };
    this.redraw();
  }

  // Whether everything is drawn.
  get isSettled() {
    return !this.#isDrawing && !this.#settle && !this.#pending;
  }

  // What is drawn: coordinates x0 y0 x1 y1 ..., and layers of edges from below to above.
  show(coordinates, layers, boxes = new Float64Array(0)) {
    if (coordinates !== this.#coordinates && coordinates.length !== this.#coordinates.length) this.#shownBuffer = null;
    this.#coordinates = coordinates;
    this.#layers = layers;
    this.boxes = boxes;
    this.redraw();
  }

  // What is drawn over it about one edge: {edge: [a, b], inside: [c, d], apexes: [c, d], crossed: [c, d]}, or null.
  // `inside` holds the points in the triangles left and right of the edge that its diamond consists of, -1 where there is
  // none; `apexes` the third corners of triangles on it. Only the edge must be there.
  set hint(hint) {
    this.#hint = hint;
    this.#refresh();
  }

  get #width() {
    return this.#canvas.clientWidth;
  }

  get #height() {
    return this.#canvas.clientHeight;
  }

  // Shows all points; `stretched`: flat sets fill the picture, too.
  fit(stretched = this.#view.stretch !== 1) {
    let [left, right, bottom, top] = [Infinity, -Infinity, Infinity, -Infinity];
    const points = this.#coordinates;
    for (let i = 0; i < points.length; i += 2) {
      left = Math.min(left, points[i]);
      right = Math.max(right, points[i]);
      bottom = Math.min(bottom, points[i + 1]);
      top = Math.max(top, points[i + 1]);
    }
    if (points.length === 0) [left, right, bottom, top] = [0, 1, 0, 1];
    const margin = 24;
    const across = (this.#width - 2 * margin) / (right - left || 1);
    const up = (this.#height - 2 * margin) / (top - bottom || 1);
    const scale = stretched ? across : Math.min(across, up);
    this.view = { x: left / 2 + right / 2, y: bottom / 2 + top / 2, scale, stretch: stretched ? up / across : 1 };
  }

  toWorld(x, y) {
    const { x: cx, y: cy, scale, stretch } = this.#view;
    return [cx + (x - this.#width / 2) / scale, cy - (y - this.#height / 2) / (scale * stretch)];
  }

  toScreen(x, y, view = this.#view) {
    return [(x - view.x) * view.scale + this.#width / 2, (view.y - y) * view.scale * view.stretch + this.#height / 2];
  }

  // The point that a click or a finger there means, or -1.
  pointAt(x, y, device = "mouse") {
    const points = this.#coordinates;
    const { x: cx, y: cy, scale, stretch } = this.#view;
    const [middleX, middleY, up] = [this.#width / 2 - x, this.#height / 2 - y, scale * stretch];
    let nearest = -1;
    let distance = (NEAR[device] ?? NEAR.mouse) ** 2;
    for (let i = 0; i < points.length; i += 2) {
      const dx = (points[i] - cx) * scale + middleX;
      const dy = (cy - points[i + 1]) * up + middleY;
      const d = dx * dx + dy * dy;
      if (d < distance) {
        nearest = i / 2;
        distance = d;
      }
    }
    return nearest;
  }

  pan(dx, dy) {
    this.#view.x -= dx / this.#view.scale;
    this.#view.y += dy / (this.#view.scale * this.#view.stretch);
    this.#move();
  }

  zoom(factor, x = this.#width / 2, y = this.#height / 2) {
    const [wx, wy] = this.toWorld(x, y);
    this.#view.scale *= factor;
    const [nx, ny] = this.toWorld(x, y);
    this.#view.x += wx - nx;
    this.#view.y += wy - ny;
    this.#move();
  }

  // The view has changed: shows what was drawn last in its new place at once, and draws anew when it rests.
  #move() {
    clearTimeout(this.#settle);
    this.#settle = setTimeout(() => {
      this.#settle = 0;
      this.redraw();
    }, this.#count() > 20000 || this.#coordinates.length > 40000 ? 120 : 0);
    this.#refresh(true);
  }

  // Shows the buffer in the next frame.
  #refresh(moves = false) {
    if (this.#pending) return;
    this.#pending = true;
    requestAnimationFrame((now) => {
      this.#pending = false;
      if (moves && now - this.#lastFrame < 500) this.frames.push(now - this.#lastFrame);
      this.#lastFrame = now;
      this.#showBuffer();
    });
  }

  #count() {
    return this.#layers.reduce((sum, layer) => sum + layer.edges.length / 2, 0);
  }

  #showBuffer() {
    const context = this.#sized(this.#canvas);
    context.clearRect(0, 0, this.#width, this.#height);
    if (this.#shownBuffer) {
      const { canvas, view, width, height } = this.#shownBuffer;
      const across = this.#view.scale / view.scale;
      const up = (across * this.#view.stretch) / view.stretch;
      const [x, y] = this.toScreen(view.x, view.y);
      context.drawImage(canvas, x - (width * across) / 2, y - (height * up) / 2, width * across, height * up);
    }
    this.#drawHint(context);
    this.#drawChosen(context);
  }

  // The context of a canvas, in CSS pixels; the canvas gets the size of the picture if it has another.
  #sized(canvas) {
    const ratio = window.devicePixelRatio || 1;
    const [width, height] = [Math.round(this.#width * ratio), Math.round(this.#height * ratio)];
    if (canvas.width !== width || canvas.height !== height) [canvas.width, canvas.height] = [width, height];
    const context = canvas.getContext("2d");
    context.setTransform(ratio, 0, 0, ratio, 0, 0);
    return context;
  }

  // Draws all anew in the next frame, slice by slice if it takes longer than one. A drawing under way is finished before
  // the next begins, so that there is always something newer to see, however often this is called.
  redraw() {
    this.#isStale = true;
    if (this.#isDrawing || this.#width === 0) return;
    this.#isDrawing = true;
    requestAnimationFrame(() => this.#draw());
  }

  // Resolves when everything up to now has been drawn.
  drawn() {
    if (!this.#isStale && !this.#isDrawing) return Promise.resolve();
    return new Promise((resolve) => (this.#isStale ? this.#awaited : this.#awaitedNow).push(resolve));
  }

  #draw() {
    this.#isStale = false;
    this.#awaitedNow.push(...this.#awaited.splice(0));
    const begin = performance.now();
    const buffer = { canvas: this.#spare, view: this.view, width: this.#width, height: this.#height };
    const context = this.#sized(buffer.canvas);
    context.clearRect(0, 0, buffer.width, buffer.height);
    const slices = this.#slices(context, buffer);
    const next = () => {
      const until = performance.now() + FRAME_MS;
      let done = false;
      while (!done && performance.now() < until) done = slices.next().done;
      if (!done) {
        if (!this.#shownBuffer) this.#canvas.getContext("2d").drawImage(buffer.canvas, 0, 0, buffer.width, buffer.height);
        return requestAnimationFrame(next);
      }
      this.drawings.push(performance.now() - begin);
      this.#spare = this.#shownBuffer?.canvas ?? document.createElement("canvas");
      this.#shownBuffer = buffer;
      this.#isDrawing = false;
      this.#showBuffer();
      for (const resolve of this.#awaitedNow.splice(0)) resolve();
      if (this.#isStale) this.redraw();
    };
    next();
  }

  *#slices(context, buffer) {
    const layers = this.#layers;
    const places = yield* this.#places(buffer);
    const all = [];
    for (const { edges } of layers) all.push(yield* this.#visibleEdges(edges, places, buffer));
    const count = all.reduce((sum, visible) => sum + visible.length / 2, 0);
    const thinner = count > 20000 ? 0.6 : count > 400 ? 0.8 : 1;
    for (const [position, layer] of layers.entries()) {
      context.strokeStyle = this.#colour(layer.colour);
      context.lineWidth = thinner < 1 && layer.width < 2 ? Math.min(1, layer.width * thinner) : layer.width * thinner;
      context.setLineDash(layer.dashed ? [7, 4] : []);
      context.globalAlpha = layer.alpha ?? 1;
      const visible = all[position];
      if (visible.length > 2 * MOST_STROKED) yield* this.#coverEdges(context, layer, visible, places);
      else yield* this.#strokeEdges(context, visible, places);
    }
    context.setLineDash([]);
    context.globalAlpha = 1;
    this.#drawBoxes(context, buffer.view);
    yield* this.#drawPoints(context, places, buffer, layers.some(({ edges }) => edges.length > 0));
  }

  // Where all points are on the screen.
  *#places({ view, width, height }) {
    const points = this.#coordinates;
    const places = new Float32Array(points.length);
    const up = view.scale * view.stretch;
    for (let begin = 0; begin < points.length; begin += 16 * BATCH) {
      const end = Math.min(points.length, begin + 16 * BATCH);
      for (let i = begin; i < end; i += 2) {
        places[i] = (points[i] - view.x) * view.scale + width / 2;
        places[i + 1] = (view.y - points[i + 1]) * up + height / 2;
      }
      if (end < points.length) yield;
    }
    return places;
  }

  *#visibleEdges(edges, places, { width, height }) {
    const visible = new Uint32Array(edges.length);
    let size = 0;
    for (let begin = 0; begin < edges.length; begin += 8 * BATCH) {
      const end = Math.min(edges.length, begin + 8 * BATCH);
      for (let i = begin; i < end; i += 2) {
        const a = 2 * edges[i], b = 2 * edges[i + 1];
        const ax = places[a], ay = places[a + 1], bx = places[b], by = places[b + 1];
        if ((ax < 0 && bx < 0) || (ax > width && bx > width) || (ay < 0 && by < 0) || (ay > height && by > height)) continue;
        visible[size++] = a;
        visible[size++] = b;
      }
      if (end < edges.length) yield;
    }
    return visible.subarray(0, size);
  }

  *#strokeEdges(context, visible, places) {
    // Browsers draw long paths much faster if lines are one pixel wide, and much slower if they are wider.
    const batch = context.lineWidth * (window.devicePixelRatio || 1) <= 1 ? BATCH : WIDE_BATCH;
    for (let begin = 0; begin < visible.length; begin += batch) {
      const end = Math.min(visible.length, begin + batch);
      context.beginPath();
      for (let i = begin; i < end; i += 2) {
        context.moveTo(places[visible[i]], places[visible[i] + 1]);
        context.lineTo(places[visible[i + 1]], places[visible[i + 1] + 1]);
      }
      context.stroke();
      if (end < visible.length) yield;
    }
  }

  // So many edges that a pixel has several.
  *#coverEdges(context, layer, visible, places) {
    const ratio = window.devicePixelRatio || 1;
    const coverage = new Coverage(context.canvas.width, context.canvas.height);
    for (let begin = 0; begin < visible.length; begin += BATCH) {
      const end = Math.min(visible.length, begin + BATCH);
      for (let i = begin; i < end; i += 2) {
        const a = visible[i], b = visible[i + 1];
        coverage.line(ratio * places[a], ratio * places[a + 1], ratio * places[b], ratio * places[b + 1]);
      }
      yield;
    }
    this.#drawCoverage(context, coverage, layer.colour);
  }

  #drawCoverage(context, coverage, colour) {
    const canvas = document.createElement("canvas");
    [canvas.width, canvas.height] = [coverage.width, coverage.height];
    canvas.getContext("2d").putImageData(coverage.image(this.#channels(colour)), 0, 0);
    context.save();
    context.setTransform(1, 0, 0, 1, 0, 0);
    context.drawImage(canvas, 0, 0);
    context.restore();
  }

  #colour(name) {
    return getComputedStyle(document.documentElement).getPropertyValue(name).trim();
  }

  // Of "#rrggbb", as the style sheets write colours.
  #channels(name) {
    const colour = this.#colour(name);
    return [1, 3, 5].map((at) => Number.parseInt(colour.slice(at, at + 2), 16));
  }

  *#drawPoints(context, places, { width, height }, hasEdges) {
    const visible = [];
    for (let i = 0; i < places.length && visible.length <= MOST_DOTS; i += 2) {
      const [x, y] = [places[i], places[i + 1]];
      if (x > -9 && y > -9 && x < width + 9 && y < height + 9) visible.push(i);
    }
    if (visible.length > MOST_DOTS) {
      if (!hasEdges) yield* this.#coverPoints(context, places);
      return;
    }
    const radius = Math.max(0.6, Math.min(4.2, Math.sqrt((width * height) / (visible.length || 1)) / 9));
    context.fillStyle = this.#colour("--dot");
    for (let begin = 0; begin < visible.length; begin += BATCH) {
      context.beginPath();
      for (const i of visible.slice(begin, begin + BATCH)) {
        context.moveTo(places[i] + radius, places[i + 1]);
        context.arc(places[i], places[i + 1], radius, 0, 2 * Math.PI);
      }
      context.fill();
      if (begin + BATCH < visible.length) yield;
    }
  }

  *#coverPoints(context, places) {
    const ratio = window.devicePixelRatio || 1;
    const coverage = new Coverage(context.canvas.width, context.canvas.height);
    for (let begin = 0; begin < places.length; begin += 16 * BATCH) {
      const end = Math.min(places.length, begin + 16 * BATCH);
      for (let i = begin; i < end; i += 2) coverage.dot(ratio * places[i], ratio * places[i + 1]);
      yield;
    }
    this.#drawCoverage(context, coverage, "--dot");
  }

  #drawBoxes(context, view) {
    context.strokeStyle = this.#colour("--second");
    context.lineWidth = 0.8;
    context.beginPath();
    for (let i = 0; i < this.boxes.length; i += 4) {
      const [left, bottom] = this.toScreen(this.boxes[i], this.boxes[i + 1], view);
      const [right, top] = this.toScreen(this.boxes[i + 2], this.boxes[i + 3], view);
      context.rect(left, top, right - left, bottom - top);
    }
    context.stroke();
    if (this.boxes.length === 0) return;
    const [left, bottom] = this.toScreen(...this.boxes.slice(-4, -2), view);
    const [right, top] = this.toScreen(...this.boxes.slice(-2), view);
    context.fillStyle = this.#colour("--second");
    context.globalAlpha = 0.12;
    context.fillRect(left, top, right - left, bottom - top);
    context.globalAlpha = 1;
  }

  #place(point) {
    return this.toScreen(this.#coordinates[2 * point], this.#coordinates[2 * point + 1]);
  }

  #path(context, places) {
    context.beginPath();
    for (const place of places) context.lineTo(...place);
    context.closePath();
  }

  // The triangles of the diamond test on an edge, base angles pi/4.6, shaded where they are empty, the points inside them,
  // and triangles on the edge.
  #drawHint(context) {
    if (!this.#hint) return;
    const { edge, inside, apexes, crossed } = this.#hint;
    const [a, b] = edge.map((point) => [this.#coordinates[2 * point], this.#coordinates[2 * point + 1]]);
    const height = Math.tan(Math.PI / 4.6) / 2;
    const apex = (side) => this.toScreen((a[0] + b[0]) / 2 - side * height * (b[1] - a[1]), (a[1] + b[1]) / 2 + side * height * (b[0] - a[0]));
    const ends = edge.map((point) => this.#place(point));
    context.strokeStyle = context.fillStyle = this.#colour("--chosen");
    context.lineWidth = 1;
    for (const [position, side] of [1, -1].entries()) {
      this.#path(context, [ends[0], ends[1], apex(side)]);
      context.globalAlpha = inside && inside[position] >= 0 ? 0.05 : 0.22;
      context.fill();
      context.globalAlpha = 0.5;
      context.stroke();
    }
    context.globalAlpha = 1;
    context.lineWidth = 2;
    for (const point of inside ?? []) if (point >= 0) this.#drawRing(context, point, 6);
    context.setLineDash([3, 3]);
    for (const corner of apexes ?? []) {
      if (corner < 0) continue;
      this.#path(context, [...ends, this.#place(corner)]);
      context.stroke();
    }
    context.setLineDash([]);
    context.strokeStyle = this.#colour("--second");
    context.lineWidth = 3;
    if (crossed) {
      this.#path(context, crossed.map((point) => this.#place(point)));
      context.stroke();
    }
    context.strokeStyle = this.#colour("--chosen");
    this.#path(context, ends);
    context.stroke();
  }

  #drawRing(context, point, radius) {
    context.beginPath();
    context.arc(...this.#place(point), radius, 0, 2 * Math.PI);
    context.stroke();
  }

  #drawChosen(context) {
    if (this.chosen < 0 || 2 * this.chosen >= this.#coordinates.length) return;
    context.strokeStyle = this.#colour("--chosen");
    context.lineWidth = 3;
    this.#drawRing(context, this.chosen, 9);
  }

  // What the canvas shows, on paper.
  toBlob(done) {
    const paper = document.createElement("canvas");
    [paper.width, paper.height] = [this.#canvas.width, this.#canvas.height];
    const context = paper.getContext("2d");
    context.fillStyle = this.#colour("--paper");
    context.fillRect(0, 0, paper.width, paper.height);
    context.drawImage(this.#canvas, 0, 0);
    paper.toBlob(done, "image/png");
  }
}
