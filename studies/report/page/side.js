// SPDX-License-Identifier: MIT
// Around the pictures in the viewer: title, which of A and B is shown, place in the grid, parameters, numbers.

function announce(text) {
  byId("viewer-title").textContent = text;
}

function neighbours(index) {
  const {column, row, page} = placeOf(index);
  const steps = isTable ? [[1, 0, 0], [-1, 0, 0], [0, 1, 0], [0, -1, 0]] : [];
  const found = isTable ? steps.map(([x, y, z]) => cellAt(column + x, row + y, page + z)) : [index + 1, index - 1];
  return found.filter((other) => other >= 0 && other < cells.length);
}

/** The first cell of the shown one's page and the one behind its last. */
function pageRange() {
  const first = placeOf(view.cell).page * rowCount * columnCount;
  return [first, Math.min(cells.length, first + rowCount * columnCount)];
}

/** The cell so many columns, rows and pages away, or -1; lines of named cells go on in the next one. */
function cellAway(columnsAway, rowsAway, pagesAway) {
  const {column, row, page} = placeOf(view.cell);
  if (isTable || pagesAway) return cellAt(column + columnsAway, row + rowsAway, page + pagesAway);
  const [first, end] = pageRange();
  const next = view.cell + columnsAway + rowsAway * gridState.perLine;
  return next >= first && next < end ? next : -1;
}

const step = (...way) => showCell(cellAway(...way));

/* The head. */

function compareButton(which, index) {
  const isShown = !view.difference && (which === "a") === view.showsPinned;
  const attributes = {
    type: "button",
    class: "side-of",
    "data-which": which,
    "aria-pressed": String(isShown),
    click: () => flip(which === "a"),
  };
  const name = make("span", {}, cellTitle(index) + nameOf(index, " · "));
  return make("button", attributes, make("b", {}, which.toUpperCase()), name, isShown ? make("em", {}, "shown") : null);
}

function drawCompare() {
  const box = byId("viewer-compare");
  box.hidden = view.pinned < 0;
  if (view.pinned < 0) return;
  box.replaceChildren(compareButton("a", view.pinned), compareButton("b", view.cell));
  const text = "Difference of A and B: black where they are equal";
  if (view.difference) box.append(make("span", {class: "difference"}, text));
}

/** Brings everything around the pictures up to what is shown. */
function describe(options) {
  const index = shownCell();
  const which = view.pinned < 0 ? "" : view.showsPinned ? "a" : "b";
  stage.dataset.shown = view.difference ? "difference" : which;
  stage.classList.toggle("with-reference", view.reference);
  stage.classList.toggle("with-causes", view.causes);
  stage.style.setProperty("--opacity", view.opacity);
  const letter = which && !view.difference ? `${which.toUpperCase()}: ` : "";
  byId("viewer-title").textContent = `${letter}${cellTitle(index)} of ${shortNumber(cells.length)}`;
  byId("viewer-name").textContent = cells[index].name;
  for (const pane of view.panes) {
    const url = pictureUrl(cells[index], pane.slot);
    if (url) pane.file.href = url;
    pane.file.hidden = !url;
  }
  drawCompare();
  drawSide();
  drawToolStates();
  placePictures();
  if (!viewer.open) return;
  keepInHash(options);
  if (document.activeElement === document.body) stage.focus(); // what had the focus was drawn again
}

/* The side. */

/** The present page of the grid as small squares: the shown cell, A, failed ones. */
function makeMap() {
  const across = isTable ? columnCount : gridState.perLine;
  const [first, end] = pageRange();
  if (end - first < 2 || end - first > 900 || across > 40) return null;
  const choose = (event) => event.target.dataset.cell && showCell(Number(event.target.dataset.cell));
  const map = make("div", {class: "map", style: `--across:${across}`, "aria-hidden": "true", click: choose});
  for (let index = first; index < end; ++index) {
    const square = make("span", {"data-cell": index, title: cellTitle(index) + nameOf(index, ": ")});
    square.classList.toggle("failed", Boolean(cells[index].error));
    square.classList.toggle("a", index === view.pinned);
    if (index === view.cell) square.classList.add(view.pinned < 0 ? "here" : "b");
    map.append(square);
  }
  return map;
}

function change(column, a, b) {
  const difference = column.numbers[b] - column.numbers[a];
  if (!Number.isFinite(difference)) return "";
  const text = shortNumber(Number.isInteger(difference) ? difference : Number(difference.toPrecision(3)));
  return difference > 0 ? `+${text}` : text.replace("-", "−");
}

function makeValue(column, index) {
  const attributes = {class: column.isNumeric ? "numeric" : null, title: column.texts[index]};
  return make("td", attributes, column.show(index));
}

/** A column's name with the shown cell's field; with A pinned, those of A and B and what changes. */
function makeFieldRow(column) {
  const row = make("tr", {}, make("th", {scope: "row"}, ...breakable(column.name)));
  if (view.pinned >= 0) row.append(makeValue(column, view.pinned));
  row.append(makeValue(column, view.cell));
  if (view.pinned < 0) return row;
  const text = column.isNumeric ? change(column, view.pinned, view.cell) : "";
  row.append(make("td", {class: "numeric change"}, text));
  return row;
}

function makeFieldsHead() {
  if (view.pinned < 0) return null;
  const head = (text, which) => make("th", {scope: "col", "data-which": which}, text);
  return make("thead", {}, make("tr", {}, make("td"), head("A", "a"), head("B", "b"), head("B − A", null)));
}

function makeFields(title, isMeant) {
  const shown = view.pinned < 0 ? [view.cell] : [view.pinned, view.cell];
  const isUsed = (column) => shown.some((index) => column.texts[index] !== "");
  const rows = columns.filter((column) => isMeant(column) && isUsed(column)).map(makeFieldRow);
  if (!rows.length) return null;
  const table = make("table", {class: "fields"}, makeFieldsHead(), make("tbody", {}, ...rows));
  return make("section", {}, make("h3", {}, title), table);
}

function makeLegend() {
  if (!view.reference || !hasOverlays) return null;
  const seen = (colour) => (colour === "#000000" ? "#ff00a6" : colour); // as the page's filter has it
  const entries = study.legend.map(([name, colour]) =>
    make("li", {}, make("i", {style: `background:${seen(colour)}`}), name));
  const slider = make("input", {
    type: "range", min: 0.1, max: 1, step: 0.05, value: view.opacity, "aria-label": "Opacity of the reference lines",
    input: (event) => {
      view.opacity = Number(event.target.value);
      stage.style.setProperty("--opacity", view.opacity);
    },
  });
  const field = make("label", {class: "field"}, make("span", {}, "Opacity"), slider);
  return make("section", {}, make("h3", {}, "Reference lines"), make("ul", {class: "legend"}, ...entries), field);
}

function makeCauses() {
  if (!view.causes || !hasCauses) return null;
  const entries = study.causes.map(([name, colour, help]) =>
    make("li", {title: help}, make("i", {style: `background:${colour}`}), name));
  return make("section", {}, make("h3", {}, "Causes of wrong lines"), make("ul", {class: "legend"}, ...entries));
}

function makeError() {
  const {error} = cells[shownCell()];
  return error ? make("section", {class: "failures"}, make("h3", {}, "This cell failed"), make("p", {}, error)) : null;
}

function drawSide() {
  const fields = [
    makeFields("Parameters", (column) => column.kind === "parameter" && !variantColumns.has(column)),
    makeFields("Numbers", (column) => column.kind === "number"),
    makeFields("Set by the variant", (column) => variantColumns.has(column)),
  ];
  const parts = [makeMap(), makeError(), ...fields, makeLegend(), makeCauses()];
  byId("viewer-side").replaceChildren(...parts.filter(Boolean));
  byId("viewer-side").hidden = !byId("viewer-side").childElementCount;
}
