// SPDX-License-Identifier: MIT
// The grid: a table of columns and rows with headers that stay in sight, or named cells in lines. Lines are
// filled when they come near the window, so that thousands of cells cost little.

const gridBox = byId("grid-box");
const kGap = 8; // px between cells
const kWidest = 320; // px of a picture, unless a person asks for more

const gridState = {
  view: -1, // which one is shown; -1: all
  buffer: -1,
  page: 0,
  number: -1, // the column shown below each cell; -1: none
  width: 0, // px of a picture; 0: what fits
  perLine: 1,
  focus: 0,
};
const isTable = columnCount > 1 && rowCount > 1;
const isSingle = cells.length === 1;

function shownSlots() {
  const {view, buffer} = gridState;
  return slots.map((slot, index) => index).filter((index) =>
    (view < 0 || slots[index].view === view) && (buffer < 0 || slots[index].buffer === buffer));
}

/** What stands in the lines below each other: a single cell's pictures, else cells. */
function gridItems() {
  if (isSingle) return shownSlots().map((slot) => ({cell: 0, slots: [slot], caption: slots[slot].label}));
  return cells.map((cell, index) => ({cell: index, slots: shownSlots(), caption: caption(index)}));
}

function caption(index) {
  if (!study.axes.length) return cells[index].name;
  const place = placeOf(index);
  const axis = rowCount > 1 ? rowAxis : columnAxis;
  const value = axis.values[rowCount > 1 ? place.row : place.column];
  return axis.label ? `${axis.label} = ${value}` : value;
}

const aspect = study.size[1] / study.size[0];
const lineHeight = (width) => Math.round(width * aspect) + (gridState.number >= 0 ? 24 : 0) + kGap;

/** The widest pictures with which the items fill their lines well. */
function fitLines(count, room, pictures) {
  const isNarrow = room < 600;
  const smallest = (isNarrow ? 130 : 180) * pictures;
  const fewest = isNarrow && count > 1 && pictures === 1 ? 2 : 1;
  const most = Math.max(1, Math.floor((room + kGap) / (smallest + kGap)));
  let best = {perLine: 1, empty: Infinity, width: 0};
  for (let perLine = fewest; perLine <= most; ++perLine) {
    const width = Math.min(kWidest, Math.floor((room - (perLine - 1) * kGap) / perLine / pictures));
    const empty = (perLine - (count % perLine)) % perLine + (count < perLine ? perLine : 0);
    const filled = perLine * pictures * width / room;
    if (filled < 0.7 && perLine < count) continue; // lines would end far from the edge
    if (empty < best.empty || best.width === 0) best = {perLine, empty, width};
  }
  return best.width ? best : {perLine: 1, width: Math.min(kWidest, Math.floor(room / pictures))};
}

/** A picture's thumbnail; where it would be blurred, its file takes its place once loaded. */
function makePicture(cell, slot, width) {
  const thumb = thumbUrl(cell, slot);
  const file = pictureUrl(cell, slot);
  const image = make("img", {src: thumb || file, alt: "", draggable: "false", decoding: "async"});
  if (!thumb || width < 150) return image;
  image.addEventListener("load", () => {
    const longer = Math.max(image.naturalWidth, image.naturalHeight);
    if (width * Math.max(1, aspect) * devicePixelRatio <= longer * 1.1) return;
    const sharp = new Image();
    sharp.addEventListener("load", () => { image.src = file; }, {once: true});
    sharp.src = file;
  }, {once: true});
  return image;
}

function makeNumber(index) {
  if (gridState.number < 0) return null;
  const column = columns[gridState.number];
  const value = column.numbers[index];
  const {low, high} = column;
  const share = Number.isFinite(value) && high > low ? (value - low) / (high - low) : 0;
  const title = `${column.name} = ${column.texts[index]}, of ${shortNumber(low)} to ${shortNumber(high)}`;
  return make("span", {class: "number", style: `--share:${share.toFixed(3)}`, title}, column.show(index) || "–");
}

function cellLabel(index, item) {
  const cell = cells[index];
  const parts = [cellTitle(index) + nameOf(index, ": ")];
  if (isSingle) parts.push(item.caption);
  if (gridState.number >= 0) parts.push(`${columns[gridState.number].name} ${columns[gridState.number].show(index)}`);
  if (!isDrawn(cell)) parts.push(cell.error ? "failed" : "not drawn");
  return parts.join(", ");
}

function makeCell(item, width, position) {
  const cell = cells[item.cell];
  const pictures = make("span", {class: "pictures"});
  if (isDrawn(cell)) {
    pictures.append(...item.slots.map((slot) => makePicture(cell, slot, width)));
  } else {
    pictures.classList.add(cell.error ? "failed" : "missing");
    pictures.append(cell.error ? "failed" : "not drawn");
  }
  return make("button", {
    type: "button",
    class: "cell",
    "data-cell": item.cell,
    "data-position": position,
    tabindex: position === gridState.focus ? "0" : "-1",
    "aria-label": cellLabel(item.cell, item),
    title: cell.error || null,
    click: (event) => openViewer(item.cell, event.currentTarget),
  }, pictures, isSingle ? null : makeNumber(item.cell));
}

const lineObserver = new IntersectionObserver((entries) => {
  for (const entry of entries) {
    if (entry.isIntersecting) fillLine(entry.target);
  }
}, {rootMargin: "600px 600px"});

/** Fills the lines in sight at once, so that a grid drawn again does not flash; leaves the rest to the observer. */
function watchLines(lines) {
  for (const line of lines) {
    const {top, bottom} = line.getBoundingClientRect();
    if (bottom > 0 && top < innerHeight) fillLine(line);
    else lineObserver.observe(line);
  }
}

function fillLine(line) {
  if (!line.fill) return;
  lineObserver.unobserve(line);
  const fill = line.fill;
  line.fill = null;
  fill();
}

/** Variants have names and no label. */
const axisName = (axis) => axis.label || "variant";

/** Sizes of the table in px: as large as fits, at least what can still be told apart. */
function planTable() {
  const isNarrow = gridBox.clientWidth < 600;
  const count = shownSlots().length;
  const corner = [rowAxis, columnAxis].map((axis) => Math.min(10, axisName(axis).length + 2));
  const longest = Math.max(...rowAxis.values.map((value) => value.length), ...corner);
  const head = Math.min(isNarrow ? 88 : 128, Math.max(44, 22 + 8 * longest));
  const room = gridBox.clientWidth - head - 2;
  const fitting = Math.floor((room / columnCount - kGap - 2 * (count - 1)) / count);
  const picture = gridState.width || Math.min(240, Math.max(isNarrow ? 88 : 56, fitting));
  const column = picture * count + 2 * (count - 1) + kGap;
  return {head, picture, column, whole: head + columnCount * column};
}

function makeTableHead() {
  const [down, right] = [[rowAxis, "down"], [columnAxis, "right"]].map(
    ([axis, way]) => make("span", {class: `axis ${way}`}, axisName(axis)));
  const values = columnAxis.values.map((value) => make("th", {scope: "col"}, value));
  return make("thead", {}, make("tr", {}, make("th", {class: "corner", scope: "col"}, down, right), ...values));
}

function makeTableLine(row, plan) {
  const style = `height:${lineHeight(plan.picture)}px`;
  const line = make("tr", {style}, make("th", {scope: "row"}, rowAxis.values[row]));
  line.fill = () => {
    for (let column = 0; column < columnCount; ++column) {
      const index = cellAt(column, row, gridState.page);
      if (index < 0) return;
      const cell = makeCell({cell: index, slots: shownSlots()}, plan.picture, row * columnCount + column);
      line.append(make("td", {}, cell));
    }
  };
  return line;
}

function drawTable() {
  const plan = planTable();
  gridBox.classList.toggle("scroller", plan.whole > gridBox.clientWidth);
  gridState.perLine = columnCount;
  const lines = [];
  for (let row = 0; row < rowCount && cellAt(0, row, gridState.page) >= 0; ++row) lines.push(makeTableLine(row, plan));
  const widths = make("colgroup", {}, make("col", {style: `width:${plan.head}px`}),
    make("col", {span: columnCount, style: `width:${plan.column}px`}));
  const attributes = {
    class: "grid-table",
    "aria-label": `${axisName(columnAxis)} from left to right, ${axisName(rowAxis)} from top to bottom`,
    style: `--picture:${plan.picture}px;--aspect:${aspect};width:${plan.whole}px`,
  };
  gridBox.replaceChildren(make("table", attributes, widths, makeTableHead(), make("tbody", {}, ...lines)));
  watchLines(lines);
}

/** How many items stand in a line, and the width of their pictures. */
function planLines(itemCount, pictureCount) {
  const room = gridBox.clientWidth;
  if (!gridState.width) return fitLines(itemCount, room, pictureCount);
  const width = Math.min(gridState.width, Math.floor(room / pictureCount));
  return {width, perLine: Math.max(1, Math.floor((room + kGap) / (width * pictureCount + kGap)))};
}

function makeLine(items, first, width) {
  const line = make("div", {class: "grid-line", style: `min-height:${lineHeight(width) + 28}px`});
  line.fill = () => line.append(...items.map((item, i) =>
    make("figure", {}, makeCell(item, width, first + i), make("figcaption", {}, item.caption))));
  return line;
}

function drawLines() {
  const items = gridItems().filter((item) => isSingle || placeOf(item.cell).page === gridState.page);
  const count = isSingle ? 1 : shownSlots().length;
  const {width, perLine} = planLines(items.length, count);
  gridState.perLine = perLine;
  gridBox.classList.remove("scroller");
  const lines = [];
  for (let first = 0; first < items.length; first += perLine) {
    lines.push(makeLine(items.slice(first, first + perLine), first, width));
  }
  const style = `--picture:${width}px;--count:${count};--aspect:${aspect}`;
  gridBox.replaceChildren(make("div", {class: "grid-lines", style}, ...lines));
  watchLines(lines);
}

function drawGrid() {
  lineObserver.disconnect();
  if (isTable) drawTable();
  else drawLines();
}

/** The button of a cell on the present page, its line filled first; null where it is on none. */
function cellButton(position) {
  const lines = isTable ? gridBox.querySelectorAll("tbody tr") : gridBox.querySelectorAll(".grid-line");
  const line = lines[Math.floor(position / gridState.perLine)];
  if (!line) return null;
  fillLine(line);
  return line.querySelector(`[data-position="${position}"]`);
}

function focusPosition(position) {
  const button = cellButton(position);
  if (!button) return false;
  const old = gridBox.querySelector('.cell[tabindex="0"]');
  if (old) old.tabIndex = -1;
  gridState.focus = position;
  button.tabIndex = 0;
  button.focus();
  return true;
}

/** Focuses a cell wherever it is, on another page too. */
function focusCell(index) {
  if (isSingle) return focusPosition(gridState.focus);
  const {page} = placeOf(index);
  if (page !== gridState.page) showPage(page);
  return focusPosition(index - page * rowCount * columnCount);
}

function showPage(page) {
  gridState.page = page;
  setHash({page: page ? page + 1 : null});
  drawTabs();
  drawGrid();
}

gridBox.addEventListener("keydown", (event) => {
  const button = event.target.closest(".cell");
  if (!button || event.ctrlKey || event.metaKey || event.altKey) return;
  const position = Number(button.dataset.position);
  const line = position - (position % gridState.perLine);
  const {perLine} = gridState;
  const targets = {
    ArrowLeft: position - 1,
    ArrowRight: position + 1,
    ArrowUp: position - perLine,
    ArrowDown: position + perLine,
    Home: line,
    End: line + perLine - 1,
  };
  if (event.key === "PageDown" || event.key === "PageUp") {
    const page = gridState.page + (event.key === "PageDown" ? 1 : -1);
    if (pageCount < 2 || page < 0 || page >= pageCount) return;
    showPage(page);
    focusPosition(position);
  } else if (event.key in targets) {
    focusPosition(targets[event.key]);
  } else {
    return;
  }
  event.preventDefault();
});
