"use strict";
// Tables that sort and filter, for any page made with html_page.py.
//
// <div class="data-table" data-source="ID"> shows the JSON of <script type="application/json" id="ID">:
//   columns  [{title, number, filter, values}]: `values`, if there, are the texts that the rows' integers stand for;
//            `filter` gives the column a list of its values to choose from
//   rows     arrays of cells; null is an empty cell
//   sets     {name: [[first, last], ...]}: named selections of rows, offered under `sets_title`
//   templates {text: command with {title} for the row's cells}, shown on demand; `template_column` says by which
//            column's text to choose one, "" is for all other texts
const FIRST_ROWS = 50;

class DataTable {
  constructor(place) {
    this.place = place;
    Object.assign(this, JSON.parse(document.getElementById(place.dataset.source).textContent));
    this.chosen = new Map();
    this.words = [];
    this.set = "";
    this.order = null;
    this.limit = FIRST_ROWS;
    this.build();
    this.show();
  }

  cell(row, column) {
    const value = row[column];
    if (value === null || value === undefined) return "";
    const values = this.columns[column].values;
    return values ? values[value] : value;
  }

  build() {
    const controls = this.add(this.place, "div", { className: "choices" });
    this.columns.forEach((column, position) => {
      if (!column.filter) return;
      this.addChoice(controls, column.title, this.valuesOf(position), (value) => this.choose(position, value));
    });
    if (this.sets) {
      this.setChoice = this.addChoice(controls, this.sets_title, Object.keys(this.sets), (value) => this.chooseSet(value));
    }
    const label = this.add(controls, "label", { textContent: "search " });
    const search = this.add(label, "input", { type: "search", size: 14 });
    search.addEventListener("input", () => {
      this.words = search.value.toLowerCase().split(/\s+/).filter(Boolean);
      this.refresh();
    });
    this.count = this.add(controls, "span", { className: "soft" });
    this.count.setAttribute("role", "status");
    const scroll = this.add(this.place, "div", { className: "table-scroll", tabIndex: 0 });
    scroll.setAttribute("role", "region");
    scroll.setAttribute("aria-label", this.place.dataset.label);
    const table = this.add(scroll, "table");
    this.heads = this.columns.map(() => null);
    const head = this.add(this.add(table, "thead"), "tr");
    this.columns.forEach((column, position) => this.addHead(head, column, position));
    if (this.templates) this.add(head, "th", { textContent: "command" });
    this.body = this.add(table, "tbody");
    this.more = this.add(this.place, "button", { type: "button", textContent: "show more rows" });
    this.more.addEventListener("click", () => { this.limit *= 4; this.show(); });
  }

  addHead(row, column, position) {
    const head = this.heads[position] = this.add(row, "th", { className: column.number ? "number" : "" });
    head.scope = "col";
    const button = this.add(head, "button", { type: "button", textContent: column.title });
    button.addEventListener("click", () => this.sortBy(position));
  }

  addChoice(controls, title, values, choose) {
    const select = this.add(this.add(controls, "label", { textContent: title + " " }), "select");
    this.add(select, "option", { value: "", textContent: "all" });
    for (const value of values) this.add(select, "option", { value, textContent: value });
    select.addEventListener("change", () => choose(select.value));
    return select;
  }

  add(parent, name, properties = {}) {
    const element = Object.assign(document.createElement(name), properties);
    parent.append(element);
    return element;
  }

  valuesOf(position) {
    const values = [...new Set(this.rows.map((row) => this.cell(row, position)))];
    return this.columns[position].number ? values.sort((a, b) => a - b) : values.sort();
  }

  choose(position, value) {
    if (value === "") this.chosen.delete(position); else this.chosen.set(position, value);
    this.refresh();
  }

  chooseSet(name) {
    this.setChoice.value = this.set = name;
    this.refresh();
  }

  sortBy(position) {
    const descending = this.order && this.order.position === position ? !this.order.descending : false;
    this.order = { position, descending };
    this.heads.forEach((head, at) => {
      if (at !== position) head.removeAttribute("aria-sort");
      else head.setAttribute("aria-sort", descending ? "descending" : "ascending");
    });
    this.refresh();
  }

  refresh() {
    this.limit = FIRST_ROWS;
    this.show();
  }

  matching() {
    const inSet = () => this.sets[this.set].flatMap(([first, last]) => this.rows.slice(first, last + 1));
    const rows = this.set ? inSet() : this.rows;
    const found = rows.filter((row) => {
      for (const [position, value] of this.chosen) if (String(this.cell(row, position)) !== value) return false;
      if (!this.words.length) return true;
      const text = row.map((_, position) => this.cell(row, position)).join(" ").toLowerCase();
      return this.words.every((word) => text.includes(word));
    });
    return this.order ? found.sort((a, b) => this.compare(a, b)) : found;
  }

  // Empty cells come last either way.
  compare(a, b) {
    const { position, descending } = this.order;
    const x = this.cell(a, position), y = this.cell(b, position);
    if (x === "" || y === "") return (x === "") - (y === "");
    const order = this.columns[position].number ? x - y : String(x).localeCompare(String(y), "en", { numeric: true });
    return descending ? -order : order;
  }

  show() {
    const rows = this.matching();
    const shown = rows.slice(0, this.limit);
    this.body.replaceChildren(...shown.map((row) => this.rowElement(row)));
    this.count.textContent = `${shown.length.toLocaleString("en")} of ${rows.length.toLocaleString("en")} rows shown`;
    this.more.hidden = shown.length === rows.length;
  }

  rowElement(row) {
    const element = document.createElement("tr");
    this.columns.forEach((column, position) => {
      const value = this.cell(row, position);
      this.add(element, "td", { textContent: value, className: column.number ? "number" : "" });
    });
    if (this.templates) {
      const button = this.add(this.add(element, "td"), "button", { type: "button", textContent: "show" });
      button.setAttribute("aria-expanded", "false");
      button.addEventListener("click", () => this.toggleCommand(element, row, button));
    }
    return element;
  }

  toggleCommand(element, row, button) {
    const open = button.getAttribute("aria-expanded") === "true";
    button.setAttribute("aria-expanded", String(!open));
    button.textContent = open ? "show" : "hide";
    if (open) { element.nextElementSibling.remove(); return; }
    const line = document.createElement("tr");
    line.className = "command";
    const cell = this.add(line, "td", { colSpan: this.columns.length + 1 });
    this.add(this.add(cell, "pre"), "code", { textContent: this.command(row) });
    element.after(line);
  }

  command(row) {
    const cells = Object.fromEntries(
      this.columns.map((column, position) => [column.title, String(this.cell(row, position))]));
    const quoted = (text) => (/^[\w.,:=/+-]*$/.test(text) ? text : `'${text.replaceAll("'", "'\\''")}'`);
    const options = (text) => text.split(" ").filter(Boolean)
      .map((pair) => ` --param ${quoted(decodeURIComponent(pair.replace(/%(?![0-7][0-9A-F])/g, "%25")))}`).join("");
    const template = this.templates[cells[this.template_column]] || this.templates[""];
    return template.replace(/\{([^{}]+?)( options)?\}/g,
      (_, name, asOptions) => asOptions ? options(cells[name] ?? "") : cells[name]);
  }
}

function addCopyButtons() {
  for (const block of document.querySelectorAll("pre.copy")) {
    const button = Object.assign(document.createElement("button"), { type: "button", textContent: "copy" });
    button.addEventListener("click", async () => {
      try {
        await navigator.clipboard.writeText(block.textContent);
        button.textContent = "copied";
      } catch {
        getSelection().selectAllChildren(block);
      }
    });
    block.after(button);
  }
}

function addThemeButton() {
  const button = document.getElementById("theme");
  button.addEventListener("click", () => {
    const root = document.documentElement;
    const shown = root.dataset.theme || (matchMedia("(prefers-color-scheme: dark)").matches ? "dark" : "light");
    root.dataset.theme = shown === "dark" ? "light" : "dark";
  });
}

// A link to a claim opens it.
function openTarget() {
  const target = location.hash.length > 1 && document.getElementById(decodeURIComponent(location.hash.slice(1)));
  if (target && target.tagName === "DETAILS") target.open = true;
}

function addVerdictButtons() {
  const buttons = [...document.querySelectorAll("button[data-verdict]")];
  const claims = [...document.querySelectorAll("details.claim")];
  buttons.forEach((button) => button.addEventListener("click", () => {
    const pressed = button.getAttribute("aria-pressed") !== "true";
    buttons.forEach((other) => other.setAttribute("aria-pressed", String(other === button && pressed)));
    claims.forEach((claim) => { claim.hidden = pressed && claim.dataset.verdict !== button.dataset.verdict; });
  }));
}

const tables = new Map();
document.querySelectorAll(".data-table").forEach((place) => tables.set(place.dataset.source, new DataTable(place)));
// <a href="#TABLE-SECTION" data-table="ID" data-set="NAME"> shows that selection of the table's rows.
document.querySelectorAll("a[data-set]").forEach((link) => {
  link.addEventListener("click", () => tables.get(link.dataset.table).chooseSet(link.dataset.set));
});
addCopyButtons();
addThemeButton();
addVerdictButtons();
addEventListener("hashchange", openTarget);
openTarget();
