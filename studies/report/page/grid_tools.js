// SPDX-License-Identifier: MIT
// What stands above the grid: pages as tabs, which pictures, which number, how large.

function drawTabs() {
  const box = byId("grid-pages");
  box.hidden = pageCount < 2;
  if (pageCount < 2) return;
  const choice = makeChoice(pageAxis.label, pageAxis.values.slice(0, pageCount), gridState.page, showPage);
  box.replaceChildren(...(pageAxis.label ? [make("span", {class: "label"}, pageAxis.label)] : []), choice);
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
  const all = [...names, "all"];
  return names.length > 4 ? makeSelect(label, all, chosen, choose) : makeChoice(label, all, chosen, choose);
}

const isShowable = (index) => columns[index].kind === "number" && columns[index].isNumeric;

function makeNumberPicker() {
  const numeric = columns.map((column, index) => index).filter(isShowable);
  if (!numeric.length || isSingle) return null;
  const names = ["none", ...numeric.map((index) => columns[index].name)];
  return makeSelect("Number", names, numeric.indexOf(gridState.number) + 1, (chosen) => {
    gridState.number = chosen ? numeric[chosen - 1] : -1;
    setHash({number: names[chosen]});
    drawGrid();
  });
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
  const pickers = [makePicker("View", study.views, "view"), makePicker("Buffer", study.buffers, "buffer")];
  const tools = [...pickers, makeNumberPicker(), makeSizeSlider()];
  byId("grid-tools").replaceChildren(...tools.filter((tool) => tool !== null));
}

/** Whether a grid can show that many pictures in each cell so that one can tell them apart. */
function hasRoomFor(count) {
  return isTable && (gridBox.clientWidth - 128) / columnCount / count >= 110;
}

/**
 * One or two pictures, those of a single cell and those that have room are shown all; of more, those of the first
 * buffer, and of many views the first.
 */
function chooseAtStart() {
  const picked = (entry, names) => (hashState.get(entry) === "all" ? -1 : hashNumber(entry, 1, names.length, 0) - 1);
  gridState.view = picked("view", study.views);
  gridState.buffer = picked("buffer", study.buffers);
  if (!isSingle && slots.length > 2 && !hasRoomFor(slots.length)) {
    if (!hashState.has("buffer") && study.buffers.length > 1) gridState.buffer = 0;
    if (!hashState.has("view") && study.views.length > 2 && !hasRoomFor(study.views.length)) gridState.view = 0;
  }
  const named = columns.findIndex((column) => column.kind === "number" && column.name === hashState.get("number"));
  const shown = columns.map((column) => column.name).filter((name, index) => isShowable(index));
  const telling = shown.find((name) => name.startsWith("f1")) || shown.find((name) => !/^(ink|faces|empty)/.test(name));
  const measured = columns.findIndex((column) => column.name === telling);
  gridState.number = hashState.get("number") === "none" ? -1 : named >= 0 ? named : measured;
  gridState.page = hashNumber("page", 1, pageCount, 1) - 1;
}

function startGrid() {
  chooseAtStart();
  drawTabs();
  drawGrid();
  const first = gridBox.querySelector("tbody tr, .grid-line");
  if (first) fillLine(first); // the slider measures its pictures
  drawGridTools();
  let room = gridBox.clientWidth;
  new ResizeObserver(() => {
    if (gridBox.clientWidth === room) return;
    room = gridBox.clientWidth;
    drawGrid();
  }).observe(gridBox.parentElement);
}
