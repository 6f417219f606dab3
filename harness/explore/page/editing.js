// Mouse, touch and keys on the picture.

const KEY_STEP = 4; // pixels

export class Editing {
  player = null; // its keys work on the picture, too
  #canvas;
  #picture;
  #points;
  #changed;
  #pointers = new Map(); // those that are down: id -> {x, y}
  #dragged = -1;
  #moved = false;

  // `changed(final)` is called after each change of the points; final is false while one is being dragged.
  constructor(canvas, picture, points, changed) {
    this.#canvas = canvas;
    this.#picture = picture;
    this.#points = points;
    this.#changed = changed;
    canvas.addEventListener("pointerdown", (event) => this.#down(event));
    canvas.addEventListener("pointermove", (event) => this.#move(event));
    for (const end of ["pointerup", "pointercancel"]) canvas.addEventListener(end, (event) => this.#up(event));
    canvas.addEventListener("dblclick", (event) => {
      if (this.#mode === "move" && this.#picture.pointAt(event.offsetX, event.offsetY) < 0) this.#addAt(event.offsetX, event.offsetY);
    });
    canvas.addEventListener(
      "wheel",
      (event) => {
        event.preventDefault();
        picture.zoom(Math.exp(-event.deltaY / 400), event.offsetX, event.offsetY);
      },
      { passive: false },
    );
    canvas.addEventListener("keydown", (event) => this.#key(event));
  }

  get isDragging() {
    return this.#dragged >= 0;
  }

  get #mode() {
    return document.querySelector('input[name="mode"]:checked').value;
  }

  undo() {
    if (!this.#points.undo()) return false;
    this.choose(-1);
    this.#changed(true);
    return true;
  }

  choose(point) {
    this.#picture.chosen = point;
    this.#picture.redraw();
  }

  #addAt(x, y) {
    this.#points.remember();
    const point = this.#points.add(...this.#picture.toWorld(x, y));
    this.#picture.chosen = point;
    this.#changed(true);
  }

  #remove(point) {
    this.#points.remember();
    this.#points.remove(point);
    this.#picture.chosen = -1;
    this.#changed(true);
  }

  #down(event) {
    this.#canvas.setPointerCapture(event.pointerId);
    this.#pointers.set(event.pointerId, { x: event.offsetX, y: event.offsetY });
    this.#moved = false;
    if (this.#pointers.size > 1) {
      this.#dragged = -1;
      return;
    }
    const point = this.#picture.pointAt(event.offsetX, event.offsetY, event.pointerType);
    if (this.#mode === "add") return;
    if (this.#mode === "delete") {
      if (point >= 0) this.#remove(point);
      return;
    }
    this.#dragged = point;
    this.choose(point);
    if (point >= 0) this.#points.remember();
  }

  #move(event) {
    const before = this.#pointers.get(event.pointerId);
    if (!before) {
      this.#canvas.style.cursor = this.#mode !== "add" && this.#picture.pointAt(event.offsetX, event.offsetY) >= 0 ? "pointer" : "crosshair";
      return;
    }
    const now = { x: event.offsetX, y: event.offsetY };
    const others = [...this.#pointers.entries()].filter(([id]) => id !== event.pointerId).map(([, other]) => other);
    this.#pointers.set(event.pointerId, now);
    if (others.length > 0) {
      this.#pinch(before, now, others[0]);
    } else if (this.#dragged >= 0) {
      this.#points.move(this.#dragged, ...this.#picture.toWorld(now.x, now.y));
      this.#changed(false);
    } else {
      this.#picture.pan(now.x - before.x, now.y - before.y);
    }
    this.#moved ||= Math.hypot(now.x - before.x, now.y - before.y) > 1;
  }

  #pinch(before, now, other) {
    const distance = (point) => Math.hypot(point.x - other.x, point.y - other.y) || 1;
    this.#picture.pan((now.x - before.x) / 2, (now.y - before.y) / 2);
    this.#picture.zoom(distance(now) / distance(before), (now.x + other.x) / 2, (now.y + other.y) / 2);
  }

  #up(event) {
    const wasDown = this.#pointers.delete(event.pointerId);
    if (!wasDown || this.#pointers.size > 0) return;
    if (this.#mode === "add" && !this.#moved && event.type === "pointerup") this.#addAt(event.offsetX, event.offsetY);
    if (this.#dragged >= 0 && this.#moved) this.#changed(true);
    this.#dragged = -1;
  }

  #key(event) {
    if (event.ctrlKey || event.altKey || event.metaKey) return;
    const done = this.#doKey(event.key, event.shiftKey ? 10 * KEY_STEP : KEY_STEP);
    if (done) event.preventDefault();
  }

  // Whether the key means something here.
  #doKey(key, step) {
    const chosen = this.#picture.chosen;
    const arrows = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1] };
    if (key in arrows) {
      this.#push(chosen, arrows[key][0] * step, arrows[key][1] * step);
      return true;
    }
    const n = this.#points.size;
    const actions = {
      n: () => n && this.choose((chosen + 1) % n),
      p: () => n && this.choose((chosen + n - (chosen < 0 ? 0 : 1)) % n),
      a: () => this.#addAt(this.#canvas.clientWidth / 2, this.#canvas.clientHeight / 2),
      u: () => this.undo(),
      Delete: () => chosen >= 0 && this.#remove(chosen),
      Backspace: () => chosen >= 0 && this.#remove(chosen),
      Escape: () => this.choose(-1),
      "+": () => this.#picture.zoom(1.25),
      "-": () => this.#picture.zoom(0.8),
      0: () => this.#picture.fit(),
      ...this.player?.isOpen && { " ": () => this.player.toggle(), ",": () => this.player.step(-1), ".": () => this.player.step(1) },
    };
    const action = actions[key.length === 1 ? key.toLowerCase() : key];
    if (action) action();
    return Boolean(action);
  }

  // Moves the chosen point, or the picture if none is chosen.
  #push(chosen, dx, dy) {
    if (chosen < 0) return this.#picture.pan(-dx, -dy);
    const { coordinates } = this.#points;
    const [x, y] = this.#picture.toScreen(coordinates[2 * chosen], coordinates[2 * chosen + 1]);
    this.#points.remember();
    this.#points.move(chosen, ...this.#picture.toWorld(x + dx, y + dy));
    this.#changed(true);
  }
}
