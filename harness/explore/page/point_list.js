// The points that are shown, where each of them comes from, and what was changed by hand.

const MOST_UNDO = 50;
export const LARGEST_UNDO = 20000; // points; larger sets are not kept for undoing

export class PointList {
  coordinates = new Float64Array(0);
  origins = []; // the position among the base's points, -1 for added ones, which come last
  source = {}; // where the base is from: {family: {...}}, {given: name}, {kept: name} or {}
  #base = new Float64Array(0);
  #history = [];

  get size() {
    return this.coordinates.length / 2;
  }

  get isEdited() {
    return !this.areAt(this.#base);
  }

  areAt(places) {
    if (this.coordinates.length !== places.length) return false;
    for (let i = 0; i < places.length; ++i) if (this.coordinates[i] !== places[i]) return false;
    return true;
  }

  setBase(coordinates, source) {
    this.coordinates = coordinates;
    this.#history = [];
    this.rebase(source);
  }

  // The points as they are become the base.
  rebase(source) {
    this.source = source;
    this.#base = this.coordinates.slice();
    this.origins = Array.from({ length: this.size }, (_, i) => i);
  }

  // To be called before a change that undo() is to take back.
  remember() {
    if (this.size > LARGEST_UNDO) return;
    this.#history.push([this.coordinates.slice(), this.origins.slice(), this.#base, this.source]);
    if (this.#history.length > MOST_UNDO) this.#history.shift();
  }

  undo() {
    const earlier = this.#history.pop();
    if (earlier) [this.coordinates, this.origins, this.#base, this.source] = earlier;
    return Boolean(earlier);
  }

  move(point, x, y) {
    this.coordinates[2 * point] = x;
    this.coordinates[2 * point + 1] = y;
  }

  add(x, y) {
    const coordinates = new Float64Array(this.coordinates.length + 2);
    coordinates.set(this.coordinates);
    coordinates.set([x, y], this.coordinates.length);
    this.coordinates = coordinates;
    this.origins.push(-1);
    return this.size - 1;
  }

  remove(point) {
    this.coordinates = this.coordinates.filter((_, i) => i >> 1 !== point);
    this.origins.splice(point, 1);
  }

  // "m3,0.5,0.25;d7;a0.1,0.2": point 3 of the base moved, point 7 deleted, one added. Numbers read back exactly.
  edits() {
    const edits = [];
    let next = 0; // the base's point that comes next
    for (let i = 0; i < this.size; ++i) {
      const [x, y] = [this.coordinates[2 * i], this.coordinates[2 * i + 1]];
      const origin = this.origins[i];
      if (origin < 0) {
        edits.push(`a${x},${y}`);
        continue;
      }
      for (; next < origin; ++next) edits.push(`d${next}`);
      next = origin + 1;
      if (x !== this.#base[2 * origin] || y !== this.#base[2 * origin + 1]) edits.push(`m${origin},${x},${y}`);
    }
    const firstAdded = edits.findIndex((edit) => edit[0] === "a");
    const deletedAtEnd = [];
    for (; next < this.#base.length / 2; ++next) deletedAtEnd.push(`d${next}`);
    edits.splice(firstAdded < 0 ? edits.length : firstAdded, 0, ...deletedAtEnd);
    return edits.join(";");
  }

  applyEdits(text) {
    const deleted = new Set();
    const added = [];
    for (const edit of text ? text.split(";") : []) {
      const numbers = edit.slice(1).split(",").map(Number);
      if (edit[0] === "m" && numbers[0] < this.size) this.move(...numbers);
      else if (edit[0] === "d") deleted.add(numbers[0]);
      else if (edit[0] === "a") added.push(numbers);
    }
    if (deleted.size > 0) {
      this.coordinates = this.coordinates.filter((_, i) => !deleted.has(i >> 1));
      this.origins = this.origins.filter((origin) => !deleted.has(origin));
    }
    for (const [x, y] of added) this.add(x, y);
  }
}
