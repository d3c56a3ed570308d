// What stands above the grid: pages as tabs, which pictures, which number, how large.

function drawTabs() {
  const box = byId("grid-pages");
  box.hidden = pageCount < 2;
  if (pageCount < 2) return;
  const choice = makeChoice(pageAxis.label, pageAxis.values.slice(0, pageCount), gridState.page, showPage);
  box.replaceChildren(make("span", {class: "label"}, pageAxis.label), choice);
}

/** Buttons for `names`, "all" last; -1 stands for all. */
function makePicker(label, names, entry) {
  if (names.length < 2) return null;
  const chosen = gridState[entry] < 0 ? names.length : gridState[entry];
  const choose = (index) => {
    gridState[entry] = index === names.length ? -1 : index;
    setHash({[entry]: index === names.length ? "all" : index + 1});
    drawGridTools();
    drawGrid();
  };
  const select = names.length > 4;
  if (!select) return makeChoice(label, [...names, "all"], chosen, choose);
  const options = [...names, "all"].map((name, index) => make("option", {value: index, selected: index === chosen}, name));
  return make("label", {class: "field"}, make("span", {}, label), make("select", {change: (event) => choose(Number(event.target.value))}, ...options));
}

function makeNumberPicker() {
  const numeric = columns.map((column, index) => index).filter((index) => columns[index].kind === "number" && columns[index].isNumeric);
  if (!numeric.length || isSingle) return null;
  const options = [make("option", {value: -1, selected: gridState.number < 0}, "none"),
    ...numeric.map((index) => make("option", {value: index, selected: index === gridState.number}, columns[index].name))];
  return make("label", {class: "field"}, make("span", {}, "Number"), make("select", {
    change: (event) => {
      gridState.number = Number(event.target.value);
      setHash({number: gridState.number < 0 ? "none" : columns[gridState.number].name});
      drawGrid();
    },
  }, ...options));
}

function makeSizeSlider() {
  const shown = gridBox.querySelector("img");
  const value = gridState.width || (shown ? Math.round(shown.getBoundingClientRect().width) : 160);
  return make("label", {class: "field size"}, make("span", {}, "Size"), make("input", {
    type: "range", min: 40, max: 480, step: 8, value, "aria-label": "Size of the pictures in the grid",
    input: (event) => {
      gridState.width = Number(event.target.value);
      drawGrid();
    },
  }));
}

function drawGridTools() {
  const tools = [makePicker("View", study.views, "view"), makePicker("Buffer", study.buffers, "buffer"), makeNumberPicker(), makeSizeSlider()];
  byId("grid-tools").replaceChildren(...tools.filter((tool) => tool !== null));
}

/** One or two pictures, or the pictures of a single cell, are shown all; of more, those of the first buffer. */
function chooseAtStart() {
  const picked = (entry, names) => (hashState.get(entry) === "all" ? -1 : hashNumber(entry, 1, names.length, 0) - 1);
  gridState.view = picked("view", study.views);
  gridState.buffer = picked("buffer", study.buffers);
  if (!isSingle && slots.length > 2) {
    if (!hashState.has("buffer") && study.buffers.length > 1) gridState.buffer = 0;
    if (!hashState.has("view") && study.views.length > 2) gridState.view = 0;
  }
  const named = columns.findIndex((column) => column.kind === "number" && column.name === hashState.get("number"));
  const measured = columns.findIndex((column) => column.kind === "number" && column.isNumeric && !column.name.startsWith("ink"));
  gridState.number = hashState.get("number") === "none" ? -1 : named >= 0 ? named : measured;
  gridState.page = hashNumber("page", 1, pageCount, 1) - 1;
}

function startGrid() {
  chooseAtStart();
  drawTabs();
  drawGrid();
  for (const line of gridBox.querySelectorAll("tbody tr, .grid-line")) {
    fillLine(line); // the first one, which the slider measures
    break;
  }
  drawGridTools();
  let room = gridBox.clientWidth;
  new ResizeObserver(() => {
    if (gridBox.clientWidth === room) return;
    room = gridBox.clientWidth;
    drawGrid();
  }).observe(gridBox.parentElement);
}
