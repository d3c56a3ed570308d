// SPDX-License-Identifier: MIT
// The table: every row of data.csv, sorted by any column. Of many rows only those in sight are in the page.

const tableBox = byId("table-box");
const kRowHeight = 31; // px, as in the style
const kMostRows = 300; // with more, rows are made as they come into sight

const tableState = {
  order: cells.map((cell, index) => index).filter((index) => cells[index].row),
  sorted: -1, // column
  descending: false,
  hidden: new Set(),
  all: false, // for printing
  first: -1,
};

/** Empty and NaN fields come last in both directions; what is equal keeps the grid's order. */
function compareFields(column, a, b) {
  const isEmpty = (index) => (column.isNumeric ? Number.isNaN(column.numbers[index]) : column.texts[index] === "");
  if (isEmpty(a) || isEmpty(b)) return isEmpty(a) - isEmpty(b) || a - b;
  const difference = column.isNumeric
    ? (column.numbers[a] < column.numbers[b] ? -1 : column.numbers[a] > column.numbers[b] ? 1 : 0)
    : column.texts[a].localeCompare(column.texts[b], "en", {numeric: true});
  return (tableState.descending ? -difference : difference) || a - b;
}

function sortTable(columnIndex, descending) {
  tableState.sorted = columnIndex;
  tableState.descending = descending;
  tableState.order.sort((a, b) => (columnIndex < 0 ? a - b : compareFields(columns[columnIndex], a, b)));
}

/** Upwards first, then downwards, then the grid's order. */
function nextSort(columnIndex) {
  const {sorted, descending} = tableState;
  if (sorted !== columnIndex) sortTable(columnIndex, false);
  else if (!descending) sortTable(columnIndex, true);
  else sortTable(-1, false);
  const name = tableState.sorted < 0 ? null : (tableState.descending ? "-" : "") + columns[columnIndex].name;
  setHash({sort: name});
  drawTableHead();
  drawRows(true);
}

/** A name that may break after its dots and underscores. */
function breakable(name) {
  const parts = name.split(/(?<=[._])/);
  return parts.flatMap((part, i) => (i ? [make("wbr"), part] : [part]));
}

const shownColumns = () => columns.map((column, index) => index).filter((index) => !tableState.hidden.has(index));

const ruler = document.createElement("canvas").getContext("2d");

function textWidth(text, font) {
  ruler.font = `${font} ${getComputedStyle(document.body).fontFamily}`;
  return ruler.measureText(text.replace(/[0-9]/g, "0")).width;
}

/** In px: as wide as the widest word of its name and its longest field, errors and long texts cut. */
function columnWidth(column) {
  const head = Math.max(...column.name.split(/(?<=[._])/).map((part) => textWidth(part, "600 12.5px"))) + 12;
  const step = Math.max(1, Math.floor(cells.length / 2000));
  let longest = "";
  for (let i = 0; i < cells.length; i += step) {
    if (column.show(i).length > longest.length) longest = column.show(i);
  }
  return 24 + Math.ceil(Math.max(head, Math.min(textWidth(longest, "13px"), column.kind === "error" ? 420 : 260)));
}

function makeHead(index) {
  const column = columns[index];
  const isSorted = tableState.sorted === index;
  const sort = isSorted ? (tableState.descending ? "descending" : "ascending") : "none";
  const arrows = {ascending: "↑", descending: "↓", none: ""};
  const arrow = make("span", {class: "arrow", "aria-hidden": "true"}, arrows[sort]);
  const attributes = {type: "button", "data-column": index, title: column.help || null, click: () => nextSort(index)};
  const button = make("button", attributes, make("span", {}, ...breakable(column.name)), arrow);
  return make("th", {scope: "col", "aria-sort": sort, class: column.isNumeric ? "numeric" : null}, button);
}

function drawTableHead() {
  const focused = document.activeElement && document.activeElement.dataset.column;
  const head = tableBox.querySelector("thead tr");
  head.replaceChildren(...shownColumns().map(makeHead));
  if (focused !== undefined) {
    const button = head.querySelector(`[data-column="${focused}"]`);
    if (button) button.focus();
  }
}

function makeField(columnIndex, index) {
  const column = columns[columnIndex];
  const text = column.show(index);
  if (column.kind === "cell") {
    const link = make("a", {href: `#cell=${index + 1}`, "aria-label": cellTitle(index)}, text);
    return make("td", {class: "numeric"}, link);
  }
  const title = column.texts[index] !== text || text.length > 28 ? column.texts[index] : null;
  return make("td", {class: column.isNumeric ? "numeric" : null, title}, text);
}

function makeRow(position) {
  const index = tableState.order[position];
  return make("tr", {"data-cell": index, "aria-rowindex": position + 2, class: cells[index].error ? "failed" : null},
    ...shownColumns().map((column) => makeField(column, index)));
}

function makeSpace(rows) {
  return make("tr", {class: "space", "aria-hidden": "true", style: `height:${rows * kRowHeight}px`}, make("td"));
}

/** The rows in sight, or all where they are few. */
function drawRows(force = false) {
  const count = tableState.order.length;
  const isWindowed = count > kMostRows && !tableState.all;
  const inSight = Math.ceil((tableBox.clientHeight || 600) / kRowHeight);
  const first = isWindowed ? Math.max(0, Math.floor(tableBox.scrollTop / kRowHeight / 20) * 20 - 20) : 0;
  if (!force && first === tableState.first) return;
  tableState.first = first;
  const end = isWindowed ? Math.min(count, first + inSight + 60) : count;
  const rows = [];
  for (let position = first; position < end; ++position) rows.push(makeRow(position));
  if (first > 0) rows.unshift(makeSpace(first));
  if (end < count) rows.push(makeSpace(count - end));
  tableBox.querySelector("tbody").replaceChildren(...rows);
}

function nameChooser() {
  const chooser = document.querySelector(".chooser summary");
  const hidden = tableState.hidden.size;
  if (chooser) chooser.textContent = hidden ? `Columns (${hidden} hidden)` : "Columns";
}

function drawWholeTable() {
  nameChooser();
  const widths = shownColumns().map((index) => columnWidth(columns[index]));
  const total = widths.reduce((a, b) => a + b, 0);
  const table = make("table", {class: "data", "aria-rowcount": tableState.order.length + 1, style: `width:${total}px`},
    make("colgroup", {}, ...widths.map((width) => make("col", {style: `width:${width}px`}))),
    make("thead", {}, make("tr")), make("tbody"));
  tableBox.replaceChildren(table);
  drawTableHead();
  drawRows(true);
}

function makeColumnChooser() {
  const boxes = columns.map((column, index) => (column.kind === "cell" ? null : make("label", {}, make("input", {
    type: "checkbox", checked: !tableState.hidden.has(index),
    change: (event) => {
      if (event.target.checked) tableState.hidden.delete(index);
      else tableState.hidden.add(index);
      drawWholeTable();
    },
  }), column.name)));
  const list = make("div", {class: "chooser-list"}, ...boxes.filter(Boolean));
  return make("details", {class: "chooser"}, make("summary", {class: "button"}, "Columns"), list);
}

function startTable() {
  columns.forEach((column, index) => {
    const isEmpty = column.kind === "error" && column.texts.every((text) => text === "");
    if (isEmpty || variantColumns.has(column)) tableState.hidden.add(index);
  });
  const name = hashState.get("sort") || "";
  const sorted = columns.findIndex((column) => column.name === name.replace(/^-/, ""));
  if (name && sorted >= 0) sortTable(sorted, name.startsWith("-"));
  if (columns.length > 4) byId("table-tools").prepend(makeColumnChooser());
  drawWholeTable();
  tableBox.addEventListener("scroll", () => drawRows(), {passive: true});
  tableBox.addEventListener("click", (event) => {
    const row = event.target.closest("tbody tr[data-cell]");
    if (!row || event.target.closest("a") || String(getSelection())) return;
    openViewer(Number(row.dataset.cell), row.querySelector("a"));
  });
}
