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

/** Goes to the cell so many columns, rows and pages away, if there is one. */
function step(columnsAway, rowsAway, pagesAway) {
  const {column, row, page} = placeOf(view.cell);
  let next = cellAt(column + columnsAway, row + rowsAway, page + pagesAway);
  if (!isTable && !pagesAway) {
    const first = page * rowCount * columnCount;
    const last = Math.min(cells.length, first + rowCount * columnCount) - 1;
    next = view.cell + columnsAway + rowsAway * gridState.perLine;
    if (next < first || next > last) next = -1;
  }
  showCell(next);
}

/* The head. */

function compareButton(which, index) {
  const isShown = !view.difference && (which === "a") === view.showsPinned;
  return make("button", {
    type: "button", class: "side-of", "data-which": which, "aria-pressed": String(isShown), click: () => flip(which === "a"),
  }, make("b", {}, which.toUpperCase()), make("span", {}, `${cellTitle(index)}${cells[index].name ? ` · ${cells[index].name}` : ""}`),
  isShown ? make("em", {}, "shown") : null);
}

function drawCompare() {
  const box = byId("viewer-compare");
  box.hidden = view.pinned < 0;
  if (view.pinned < 0) return;
  box.replaceChildren(compareButton("a", view.pinned), compareButton("b", view.cell));
  if (view.difference) box.append(make("span", {class: "difference"}, "Difference of A and B: black where they are equal"));
}

/** Brings everything around the pictures up to what is shown. */
function describe(options) {
  const index = shownCell();
  const which = view.pinned < 0 ? "" : view.showsPinned ? "a" : "b";
  stage.dataset.shown = view.difference ? "difference" : which;
  stage.classList.toggle("with-reference", view.reference);
  stage.style.setProperty("--opacity", view.opacity);
  byId("viewer-title").textContent = `${which && !view.difference ? `${which.toUpperCase()}: ` : ""}${cellTitle(index)} of ${cells.length}`;
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
  if (viewer.open) keepInHash(options);
}

/* The side. */

/** The present page of the grid as small squares: the shown cell, A, failed ones. */
function makeMap() {
  const {page} = placeOf(view.cell);
  const across = isTable ? columnCount : gridState.perLine;
  const first = page * rowCount * columnCount;
  const last = Math.min(cells.length, first + rowCount * columnCount);
  if (last - first < 2 || last - first > 900 || across > 40) return null;
  const map = make("div", {
    class: "map", style: `--across:${across}`, "aria-hidden": "true",
    click: (event) => event.target.dataset.cell && showCell(Number(event.target.dataset.cell)),
  });
  for (let index = first; index < last; ++index) {
    const marks = [index === view.cell ? (view.pinned < 0 ? "here" : "b") : "", index === view.pinned ? "a" : "", cells[index].error ? "failed" : ""];
    map.append(make("span", {class: marks.join(" "), "data-cell": index, title: `${cellTitle(index)}${cells[index].name ? `: ${cells[index].name}` : ""}`}));
  }
  return map;
}

function change(column, a, b) {
  const difference = column.numbers[b] - column.numbers[a];
  if (!Number.isFinite(difference)) return "";
  const text = shortNumber(Number(difference.toPrecision(3)));
  return difference > 0 ? `+${text}` : text.replace("-", "−");
}

function makeFields(title, kinds) {
  const [a, b] = [view.pinned, view.cell];
  const used = columns.filter((column) => kinds.includes(column.kind) && (column.texts[b] !== "" || (a >= 0 && column.texts[a] !== "")));
  if (!used.length) return null;
  const field = (column, index) => make("td", {class: column.isNumeric ? "numeric" : null, title: column.texts[index]}, column.show(index));
  const rows = used.map((column) => make("tr", {class: a >= 0 && column.texts[a] !== column.texts[b] ? "differs" : null},
    make("th", {scope: "row"}, ...breakable(column.name)), ...(a >= 0 ? [field(column, a)] : []), field(column, b),
    ...(a >= 0 ? [make("td", {class: "numeric change"}, column.isNumeric ? change(column, a, b) : "")] : [])));
  const head = a < 0 ? null : make("thead", {}, make("tr", {}, make("td"), ...[["A", "a"], ["B", "b"]].map(([text, which]) =>
    make("th", {scope: "col", "data-which": which}, text)), make("th", {scope: "col"}, "B − A")));
  return make("section", {}, make("h3", {}, title), make("table", {class: "fields"}, head, make("tbody", {}, ...rows)));
}

function makeLegend() {
  if (!view.reference || !hasOverlays) return null;
  const entries = study.legend.map(([name, colour]) => make("li", {}, make("i", {style: `background:${/^#0{6}$/.test(colour) ? "#ff00a6" : colour}`}), name));
  const slider = make("input", {
    type: "range", min: 0.1, max: 1, step: 0.05, value: view.opacity, "aria-label": "Opacity of the reference lines",
    input: (event) => {
      view.opacity = Number(event.target.value);
      stage.style.setProperty("--opacity", view.opacity);
    },
  });
  return make("section", {}, make("h3", {}, "Reference lines"), entries.length ? make("ul", {class: "legend"}, ...entries) : null,
    make("label", {class: "field"}, make("span", {}, "Opacity"), slider));
}

function makeError() {
  const {error} = cells[shownCell()];
  return error ? make("section", {class: "failures"}, make("h3", {}, "This cell failed"), make("p", {}, error)) : null;
}

function drawSide() {
  const parts = [makeMap(), makeError(), makeFields("Parameters", ["parameter"]), makeFields("Numbers", ["number"]), makeLegend()];
  byId("viewer-side").replaceChildren(...parts.filter(Boolean));
  byId("viewer-side").hidden = !byId("viewer-side").childElementCount;
}
