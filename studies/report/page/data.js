// SPDX-License-Identifier: MIT
// What the page knows, and helpers that every part uses.

const study = JSON.parse(document.getElementById("study").textContent);
const cells = study.cells;

/** What tells a picture from the others of its cell. */
function pictureLabel(view, buffer) {
  if (study.views.length === 1) return buffer;
  return study.buffers.length === 1 ? view : `${view} · ${buffer}`;
}

/** The pictures of every cell, all buffers of the first view first. */
const slots = study.views.flatMap((view, viewIndex) => study.buffers.map((buffer, bufferIndex) => ({
  view: viewIndex,
  buffer: bufferIndex,
  label: pictureLabel(view, buffer),
})));

const byId = (id) => document.getElementById(id);

/** An element with attributes (functions become listeners, null is left out) and children, texts as texts. */
function make(tag, attributes = {}, ...children) {
  const element = document.createElement(tag);
  for (const [name, value] of Object.entries(attributes)) {
    if (value === null || value === false) continue;
    if (typeof value === "function") element.addEventListener(name, value);
    else element.setAttribute(name, value === true ? "" : value);
  }
  element.append(...children.filter((child) => child !== null));
  return element;
}

/** A list of choices of which one is taken; calls `choose` with its index. */
function makeChoice(label, names, chosen, choose) {
  const buttons = names.map((name, index) => make("button", {
    type: "button", class: "button", "aria-pressed": String(index === chosen), click: () => choose(index),
  }, name));
  return make("div", {class: "choice", role: "group", "aria-label": label}, ...buttons);
}

/** The same as a list to choose from. */
function makeSelect(label, names, chosen, choose) {
  const options = names.map((name, index) => make("option", {value: index, selected: index === chosen}, name));
  const select = make("select", {change: (event) => choose(Number(event.target.value))}, ...options);
  return make("label", {class: "field"}, make("span", {}, label), select);
}

/* Cells in the grid. */

const [columnAxis, rowAxis, pageAxis] = study.axes;
const columnCount = columnAxis ? columnAxis.values.length : cells.length;
const rowCount = rowAxis ? rowAxis.values.length : 1;
const pageCount = Math.ceil(cells.length / (columnCount * rowCount));

function placeOf(index) {
  const line = Math.floor(index / columnCount);
  return {column: index % columnCount, row: line % rowCount, page: Math.floor(line / rowCount)};
}

/** The index of the cell at that place, or -1 where there is none. */
function cellAt(column, row, page) {
  if (column < 0 || column >= columnCount || row < 0 || row >= rowCount || page < 0) return -1;
  const index = (page * rowCount + row) * columnCount + column;
  return index < cells.length ? index : -1;
}

const cellTitle = (index) => `Cell ${index + 1}`;
const nameOf = (index, separator) => (cells[index].name ? `${separator}${cells[index].name}` : "");
const isDrawn = (cell) => cell.files !== undefined;

/** The file of a cell's picture, or "". */
function pictureUrl(cell, slot) {
  if (!isDrawn(cell)) return "";
  const [begin, end] = study.files[slot];
  return begin + (Array.isArray(cell.files) ? cell.files[slot] : cell.files) + end;
}

/** The thumbnail inside this page, or "" where there is none. */
function thumbUrl(cell, slot) {
  const text = cell.thumbs && cell.thumbs[slot];
  return text ? `data:image/webp;base64,${text}` : "";
}

/** What lies over a view's pictures: `kind` is "overlays" (reference lines) or "causes"; "" where there is none. */
function overlayUrl(cell, view, kind = "overlays") {
  const index = cell[kind] ? cell[kind][view] : undefined;
  return index === undefined || index < 0 ? "" : study.overlays[index];
}

/* Numbers. */

/** The number that a field of data.csv holds; NaN where it holds none. */
function toNumber(text) {
  if (/^[+-]?inf(inity)?$/i.test(text)) return text[0] === "-" ? -Infinity : Infinity;
  return text === "" ? NaN : Number(text);
}

/** At most four significant digits; whole numbers whole, with their thousands apart. */
function shortNumber(value) {
  if (!Number.isFinite(value)) return String(value);
  if (Number.isInteger(value) && Math.abs(value) < 1e15) return value.toLocaleString("en-US");
  return String(Number(value.toPrecision(4)));
}

/** How the numbers of one column are written: aligned decimals where their sizes are alike. */
function numberFormat(values) {
  const sizes = values.filter((value) => Number.isFinite(value) && value !== 0).map(Math.abs);
  if (values.every((value) => !Number.isFinite(value) || Number.isInteger(value))) return shortNumber;
  const largest = sizes.reduce((a, b) => Math.max(a, b), 0);
  const smallest = sizes.reduce((a, b) => Math.min(a, b), Infinity);
  if (largest / smallest > 1000 || largest >= 1e6 || largest < 1e-4) return shortNumber;
  const decimals = Math.max(0, 4 - Math.ceil(Math.log10(largest)));
  return (value) => (Number.isFinite(value) ? value.toFixed(decimals) : String(value));
}

/** Columns of the table with what their fields are worth. */
const columns = study.columns.map((column, index) => {
  const texts = cells.map((cell) => (cell.row ? cell.row[index] : ""));
  const numbers = texts.map(toNumber);
  const isNumeric = texts.some((text) => text !== "") && column.kind !== "name" && column.kind !== "error" &&
    texts.every((text, i) => text === "" || /^[+-]?nan$/i.test(text) || !Number.isNaN(numbers[i]));
  const format = column.kind === "number" ? numberFormat(numbers) : shortNumber;
  const finite = numbers.filter(Number.isFinite);
  const low = finite.reduce((a, b) => Math.min(a, b), Infinity);
  const high = finite.reduce((a, b) => Math.max(a, b), -Infinity);
  const isPlain = !isNumeric || column.kind === "cell";
  const show = (i) => (isPlain || Number.isNaN(numbers[i]) ? texts[i] : format(numbers[i]));
  return {name: column.name, kind: column.kind, help: column.help, texts, numbers, isNumeric, low, high, show};
});

/** In wide tables: whether a parameter says only what the variant's name says. */
function isSetByVariant(column) {
  const names = columns.find((other) => other.kind === "name");
  if (!names || column.kind !== "parameter" || columns.length <= 12) return false;
  const values = new Map();
  return cells.every((cell, i) => {
    if (!cell.row) return true;
    if (!values.has(names.texts[i])) values.set(names.texts[i], column.texts[i]);
    return values.get(names.texts[i]) === column.texts[i];
  });
}
const variantColumns = new Set(columns.filter(isSetByVariant));

/* The address's hash holds what is shown, so that a link can be sent. */

const hashState = new URLSearchParams(location.hash.includes("=") ? location.hash.slice(1) : "");
let hashTimer = 0;

/** Changes entries; null removes one. A pushed change is a step that the browser's Back undoes. */
function setHash(changes, {push = false} = {}) {
  for (const [name, value] of Object.entries(changes)) {
    if (value === null) hashState.delete(name);
    else hashState.set(name, value);
  }
  clearTimeout(hashTimer);
  const write = () => {
    const text = hashState.toString();
    const url = text ? `#${text}` : location.href.split("#")[0];
    try {
      history[push ? "pushState" : "replaceState"](null, "", url);
    } catch (error) {
      // Some browsers forbid it for files; the page works without.
    }
  };
  if (push) write();
  else hashTimer = setTimeout(write, 150); // browsers refuse too many changes in a short time
}

function readHash() {
  clearTimeout(hashTimer);
  for (const name of [...hashState.keys()]) hashState.delete(name);
  const text = location.hash.includes("=") ? location.hash.slice(1) : "";
  for (const [name, value] of new URLSearchParams(text)) hashState.set(name, value);
}

/** An entry as a whole number from `first` to `last`, else `fallback`. */
function hashNumber(name, first, last, fallback) {
  const text = hashState.get(name);
  const value = Number(text);
  return text !== null && /^\d+$/.test(text) && value >= first && value <= last ? value : fallback;
}
