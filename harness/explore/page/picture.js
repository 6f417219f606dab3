// Draws points and edges on a canvas. While the picture is moved or zoomed, what was drawn last is shown, moved or
// stretched; then it is drawn anew, in slices that fit between two frames.

const SLICE = 12000; // edges drawn at a time
const MOST_EDGES = 400000; // of one colour; of more, every second, third ... is drawn
const MOST_POINTS = 60000; // drawn as dots
const NEAR = 14; // pixels: a point so close is meant

export class Picture {
  frames = []; // milliseconds between frames while moving, for measurements
  chosen = -1;
  diamond = null; // the edge [a, b] whose diamond is drawn
  #canvas;
  #buffer = document.createElement("canvas");
  #bufferView = null;
  #view = { x: 0, y: 0, scale: 1, stretch: 1 }; // heights are `stretch` times as large as widths
  #coordinates = new Float64Array(0);
  #layers = []; // [{edges, colour, dashed, width}]
  #drawing = 0; // the number of the drawing under way
  #pending = false;
  #lastFrame = 0;

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

  // What is drawn: coordinates x0 y0 x1 y1 ..., and layers of edges from below to above.
  show(coordinates, layers) {
    this.#coordinates = coordinates;
    this.#layers = layers;
    this.redraw();
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

  // The point that a click there means, or -1.
  pointAt(x, y) {
    const points = this.#coordinates;
    let nearest = -1;
    let distance = NEAR * NEAR;
    for (let i = 0; i < points.length; i += 2) {
      const [sx, sy] = this.toScreen(points[i], points[i + 1]);
      const d = (sx - x) ** 2 + (sy - y) ** 2;
      if (d < distance) [nearest, distance] = [i / 2, d];
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

  // The view has changed: shows what was drawn last in its new place at once, and draws anew after that.
  #move() {
    ++this.#drawing;
    if (this.#pending) return;
    this.#pending = true;
    requestAnimationFrame((now) => {
      this.#pending = false;
      if (now - this.#lastFrame < 500) this.frames.push(now - this.#lastFrame);
      this.#lastFrame = now;
      this.#showBuffer();
      clearTimeout(this.settle);
      this.settle = setTimeout(() => this.redraw(), this.#count() > 20000 ? 120 : 0);
    });
  }

  #count() {
    return this.#layers.reduce((sum, layer) => sum + layer.edges.length / 2, 0);
  }

  #showBuffer() {
    const context = this.#sized(this.#canvas);
    context.clearRect(0, 0, this.#width, this.#height);
    if (!this.#bufferView) return;
    const stretch = this.#view.scale / this.#bufferView.scale;
    const [x, y] = this.toScreen(this.#bufferView.x, this.#bufferView.y);
    const [width, height] = [this.#width * stretch, this.#height * stretch];
    context.drawImage(this.#buffer, x - width / 2, y - height / 2, width, height);
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

  // Small pictures are drawn within the frame, large ones slice by slice.
  redraw() {
    if (this.#width === 0) return;
    const drawing = ++this.#drawing;
    const context = this.#sized(this.#buffer);
    context.clearRect(0, 0, this.#width, this.#height);
    this.#bufferView = this.view;
    const slices = this.#slices(context);
    const next = () => {
      if (drawing !== this.#drawing) return;
      const begin = performance.now();
      let done = false;
      while (!done && performance.now() - begin < 10) done = slices.next().done;
      this.#showBuffer();
      if (!done) requestAnimationFrame(next);
    };
    next();
  }

  *#slices(context) {
    const colours = getComputedStyle(document.documentElement);
    for (const layer of this.#layers) {
      context.strokeStyle = colours.getPropertyValue(layer.colour);
      context.lineWidth = this.#count() > 20000 ? layer.width * 0.6 : layer.width;
      context.setLineDash(layer.dashed ? [7, 4] : []);
      context.globalAlpha = layer.alpha ?? 1;
      const step = 2 * Math.max(1, Math.ceil(layer.edges.length / 2 / MOST_EDGES));
      for (let begin = 0; begin < layer.edges.length; begin += SLICE * step) {
        this.#strokeEdges(context, layer.edges, begin, Math.min(layer.edges.length, begin + SLICE * step), step);
        yield;
      }
    }
    context.setLineDash([]);
    context.globalAlpha = 1;
    this.#drawDiamond(context, colours);
    yield* this.#drawPoints(context, colours);
    this.#drawChosen(context, colours);
  }

  #strokeEdges(context, edges, begin, end, step) {
    const points = this.#coordinates;
    const { x: cx, y: cy, scale, stretch } = this.#view;
    const up = scale * stretch;
    const [width, height] = [this.#width, this.#height];
    context.beginPath();
    for (let i = begin; i < end; i += step) {
      const a = 2 * edges[i], b = 2 * edges[i + 1];
      const ax = (points[a] - cx) * scale + width / 2, ay = (cy - points[a + 1]) * up + height / 2;
      const bx = (points[b] - cx) * scale + width / 2, by = (cy - points[b + 1]) * up + height / 2;
      if ((ax < 0 && bx < 0) || (ax > width && bx > width) || (ay < 0 && by < 0) || (ay > height && by > height)) continue;
      context.moveTo(ax, ay);
      context.lineTo(bx, by);
    }
    context.stroke();
  }

  *#drawPoints(context, colours) {
    const points = this.#coordinates;
    const visible = [];
    for (let i = 0; i < points.length && visible.length <= 2 * MOST_POINTS; i += 2) {
      const [x, y] = this.toScreen(points[i], points[i + 1]);
      if (x > -9 && y > -9 && x < this.#width + 9 && y < this.#height + 9) visible.push(x, y);
    }
    if (visible.length > 2 * MOST_POINTS && this.#layers.length > 0) return;
    const area = (this.#width * this.#height) / (visible.length / 2 || 1);
    const radius = Math.max(0.6, Math.min(4.2, Math.sqrt(area) / 9));
    context.fillStyle = colours.getPropertyValue("--dot");
    for (let begin = 0; begin < visible.length; begin += 2 * SLICE) {
      context.beginPath();
      for (let i = begin; i < Math.min(visible.length, begin + 2 * SLICE); i += 2) {
        context.moveTo(visible[i] + radius, visible[i + 1]);
        context.arc(visible[i], visible[i + 1], radius, 0, 2 * Math.PI);
      }
      context.fill();
      yield;
    }
  }

  // The two triangles of the diamond test on an edge: base angles pi/4.6.
  #drawDiamond(context, colours) {
    if (!this.diamond) return;
    const [a, b] = this.diamond.map((point) => [this.#coordinates[2 * point], this.#coordinates[2 * point + 1]]);
    const height = Math.tan(Math.PI / 4.6) / 2;
    const apex = (side) => [
      (a[0] + b[0]) / 2 - side * height * (b[1] - a[1]),
      (a[1] + b[1]) / 2 + side * height * (b[0] - a[0]),
    ];
    context.beginPath();
    for (const corner of [a, apex(1), b, apex(-1)]) context.lineTo(...this.toScreen(...corner));
    context.closePath();
    context.fillStyle = colours.getPropertyValue("--chosen");
    context.globalAlpha = 0.18;
    context.fill();
    context.globalAlpha = 1;
  }

  #drawChosen(context, colours) {
    if (this.chosen < 0 || 2 * this.chosen >= this.#coordinates.length) return;
    const [x, y] = this.toScreen(this.#coordinates[2 * this.chosen], this.#coordinates[2 * this.chosen + 1]);
    context.strokeStyle = colours.getPropertyValue("--chosen");
    context.lineWidth = 3;
    context.beginPath();
    context.arc(x, y, 9, 0, 2 * Math.PI);
    context.stroke();
  }

  // What the canvas shows, on paper.
  toBlob(done) {
    const paper = document.createElement("canvas");
    [paper.width, paper.height] = [this.#buffer.width, this.#buffer.height];
    const context = paper.getContext("2d");
    context.fillStyle = getComputedStyle(document.documentElement).getPropertyValue("--paper");
    context.fillRect(0, 0, paper.width, paper.height);
    context.drawImage(this.#buffer, 0, 0);
    paper.toBlob(done, "image/png");
  }
}
