"use strict";
// Tables that sort and filter, for any page made with html_page.py.
//
// <div class="data-table" data-source="ID"> shows the JSON of <script type="application/json" id="ID">:
//   columns  [{title, number, interval, filter, hidden, values}]: `values`, if there, are the texts that the rows' integers stand
//            for; `interval` texts are "LOW – HIGH"; `filter` gives the column a list of its values to choose from; `hidden` ones
//            are shown when the reader asks for them
//   rows     arrays of cells; null is an empty cell
//   sets     {name: [[first, last], ...]}: named selections of rows, offered under `sets_title`
//   templates {text: command with {title} for the row's cells}, shown on demand; `template_column` says by which
//            column's text to choose one, "" is for all other texts; `algorithm_options` {name: options that follow it}
const FIRST_ROWS = 50;
const NOTHING = "–";

function addElement(parent, name, properties = {}) {
  const element = Object.assign(document.createElement(name), properties);
  parent.append(element);
  return element;
}

function download(name, text) {
  const link = Object.assign(document.createElement("a"), { download: name });
  link.href = URL.createObjectURL(new Blob([text], { type: "text/csv" }));
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 10000);
}

// RFC 4180.
function csvText(rows) {
  const field = (value) => (/[",\n\r]/.test(value) ? `"${String(value).replaceAll('"', '""')}"` : String(value));
  return rows.map((row) => row.map(field).join(",") + "\n").join("");
}

// `made`: an object with `templates` and `template_column`; `cells`: {title: text}.
function commandOf(made, cells) {
  const quoted = (text) => (/^[\w.,:=/+-]*$/.test(text) ? text : `'${text.replaceAll("'", "'\\''")}'`);
  const options = (text) => text.split(" ").filter(Boolean)
    .map((pair) => ` --param ${quoted(decodeURIComponent(pair.replace(/%(?![0-7][0-9A-F])/g, "%25")))}`).join("");
  const value = (name) => String(cells[name] ?? "") + (name === "algorithm" ? made.algorithm_options?.[cells[name]] ?? "" : "");
  const template = made.templates[cells[made.template_column]] || made.templates[""];
  return template.replace(/\{([^{}]+?)( options)?\}/g, (_, name, asOptions) => asOptions ? options(cells[name] ?? "") : value(name));
}

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

  isShown(position) {
    return !this.columns[position].hidden;
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
    this.addSearch(controls);
    this.addColumnChoice(controls);
    this.add(controls, "button", { type: "button", textContent: "download as CSV" })
      .addEventListener("click", () => download(this.place.dataset.source.replace("-data", "_table.csv"), this.csv()));
    this.count = this.add(controls, "span", { className: "soft" });
    this.count.setAttribute("role", "status");
    const scroll = this.add(this.place, "div", { className: "table-scroll", tabIndex: 0 });
    scroll.setAttribute("role", "region");
    scroll.setAttribute("aria-label", this.place.dataset.label);
    const table = this.add(scroll, "table");
    this.head = this.add(this.add(table, "thead"), "tr");
    this.body = this.add(table, "tbody");
    this.more = this.add(this.place, "button", { type: "button", textContent: "show more rows" });
    this.more.addEventListener("click", () => { this.limit *= 4; this.show(); });
    this.showHead();
  }

  addSearch(controls) {
    const search = this.add(this.add(controls, "label", { textContent: "search " }), "input", { type: "search", size: 14 });
    search.addEventListener("input", () => {
      this.words = search.value.toLowerCase().split(/\s+/).filter(Boolean);
      this.refresh();
    });
  }

  addColumnChoice(controls) {
    const choice = this.add(controls, "details", { className: "columns" });
    this.add(choice, "summary", { textContent: "columns" });
    const list = this.add(choice, "div", { className: "column-list" });
    for (const column of this.columns) {
      const label = this.add(list, "label");
      const box = this.add(label, "input", { type: "checkbox", checked: !column.hidden });
      label.append(` ${column.title}`);
      box.addEventListener("change", () => {
        column.hidden = !box.checked;
        this.showHead();
        this.show();
      });
    }
  }

  showHead() {
    this.head.replaceChildren();
    this.heads = this.columns.map((column, position) => this.isShown(position) ? this.addHead(column, position) : null);
    if (this.templates) this.add(this.head, "th", { textContent: "command", scope: "col" });
    this.markOrder();
  }

  addHead(column, position) {
    const head = this.add(this.head, "th", { className: column.number ? "number" : "", scope: "col" });
    const button = this.add(head, "button", { type: "button", textContent: column.title });
    button.addEventListener("click", () => this.sortBy(position));
    return head;
  }

  addChoice(controls, title, values, choose) {
    const select = this.add(this.add(controls, "label", { textContent: title + " " }), "select");
    this.add(select, "option", { value: "", textContent: "all" });
    for (const value of values) this.add(select, "option", { value, textContent: value });
    select.addEventListener("change", () => choose(select.value));
    return select;
  }

  add(parent, name, properties = {}) {
    return addElement(parent, name, properties);
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

  // Ascending, then descending, then as the table came.
  sortBy(position) {
    const isSame = this.order && this.order.position === position;
    if (isSame && this.order.descending) this.order = null;
    else this.order = { position, descending: Boolean(isSame) };
    this.markOrder();
    this.refresh();
  }

  markOrder() {
    this.heads.forEach((head, at) => {
      if (!head) return;
      if (!this.order || at !== this.order.position) head.removeAttribute("aria-sort");
      else head.setAttribute("aria-sort", this.order.descending ? "descending" : "ascending");
    });
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
    const { number, interval } = this.columns[position];
    const order = number ? x - y : interval ? parseFloat(x) - parseFloat(y)
      : String(x).localeCompare(String(y), "en", { numeric: true });
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
      if (!this.isShown(position)) return;
      const value = this.cell(row, position);
      const isMissing = value === "" && (column.number || column.interval);
      this.add(element, "td", { textContent: isMissing ? NOTHING : value, className: column.number ? "number" : "" });
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
    const cell = this.add(line, "td", { colSpan: this.heads.filter(Boolean).length + 1 });
    this.add(this.add(cell, "pre"), "code", { textContent: this.command(row) });
    element.after(line);
  }

  command(row) {
    return commandOf(this, this.cells(row));
  }

  // {title: text} of all columns.
  cells(row) {
    return Object.fromEntries(this.columns.map((column, position) => [column.title, String(this.cell(row, position))]));
  }

  // What the table shows, all rows of it; an interval becomes two columns.
  csv() {
    const shown = this.columns.map((_, position) => position).filter((position) => this.isShown(position));
    const ends = ["lower", "upper"];
    const title = ({ title, interval }) => interval ? ends.map((end) => `${title}, ${end}`) : [title];
    const fields = (row, position) => {
      const value = this.cell(row, position);
      return !this.columns[position].interval ? [value] : value === "" ? ["", ""] : value.split(" – ");
    };
    const rows = this.matching().map((row) => shown.flatMap((position) => fields(row, position)));
    return csvText([shown.flatMap((position) => title(this.columns[position])), ...rows]);
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
    document.querySelectorAll("iframe").forEach(follow);
  });
  // A page within this one (<iframe data-page="HTML"> in <details>) is loaded when it is first seen, and has the same colours.
  const follow = (frame) => { frame.contentDocument.documentElement.dataset.theme = document.documentElement.dataset.theme ?? ""; };
  for (const frame of document.querySelectorAll("iframe[data-page]")) {
    frame.addEventListener("load", () => follow(frame));
    frame.closest("details").addEventListener("toggle", () => { if (!frame.srcdoc) frame.srcdoc = frame.dataset.page; });
  }
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
