// SPDX-License-Identifier: MIT
// Buttons and keys of the viewer, and the list of keys.

const kKeys = [
  [["←", "→", "↑", "↓"], "to the neighbouring cell"],
  [["PageUp", "PageDown"], "to the same cell of another page of the grid"],
  [["Enter"], "opens the cell in focus"],
  [["a"], "pins the shown cell as A, or takes the pin away"],
  [["Space", "x"], "flips between A and B"],
  [["d"], "difference of A and B"],
  [["r"], "reference lines over the pictures"],
  [["c"], "causes of false and missed lines over the pictures"],
  [["f"], "all of the picture, or its pixels one to one"],
  [["+", "−"], "zoom; also Ctrl and the wheel, and a double click"],
  [["drag", "wheel"], "move all pictures together"],
  [["1 … 9", "0"], "only that picture, or all of them"],
  [["?"], "this list"],
  [["Esc"], "closes"],
];

const isMany = cells.length > 1;
const kTools = [
  {id: "left", text: "←", title: "Cell to the left (←)", way: [-1, 0, 0], shown: isMany},
  {id: "right", text: "→", title: "Cell to the right (→)", way: [1, 0, 0], shown: isMany},
  {id: "up", text: "↑", title: "Cell above (↑)", way: [0, -1, 0], shown: isTable},
  {id: "down", text: "↓", title: "Cell below (↓)", way: [0, 1, 0], shown: isTable},
  {id: "page-up", text: "⇞", title: "Page before (PageUp)", way: [0, 0, -1], shown: pageCount > 1},
  {id: "page-down", text: "⇟", title: "Page after (PageDown)", way: [0, 0, 1], shown: pageCount > 1},
  {id: "zoom-out", text: "−", title: "Smaller (−)", run: () => zoomBy(-1), group: true, shown: true},
  {id: "zoom-now", shown: true},
  {id: "zoom-in", text: "+", title: "Larger (+)", run: () => zoomBy(1), shown: true},
  {id: "zoom-fit", text: "Fit", title: "All of the picture (f)", run: zoomToFit, shown: true},
  {id: "zoom-one", text: "1:1", title: "One pixel to one (f)", run: () => zoomTo(1), shown: true},
  {id: "pin", text: "Pin as A", key: "a", title: "Keep the shown cell as A (a)", run: pin, group: true, shown: isMany},
  {id: "flip", text: "Flip", key: "space", title: "Flip between A and B (Space, x)", run: () => flip(), shown: isMany},
  {id: "difference", text: "Difference", key: "d", title: "B against A (d)", run: toggleDifference, shown: isMany},
  {id: "reference", text: "Reference", key: "r", title: "Reference lines (r)", run: toggleReference, shown: hasOverlays},
  {id: "causes", text: "Causes", key: "c", title: "Causes of false and missed lines (c)", run: toggleCauses, shown: hasCauses},
  {id: "help", text: "?", title: "Keys (?)", run: () => byId("keys").showModal(), group: true, shown: true},
];

function makeTool(tool) {
  if (!tool.title) return make("output", {id: tool.id});
  return make("button", {
    type: "button",
    id: tool.id,
    class: "button",
    title: tool.title,
    "aria-label": tool.title,
    "data-group": Boolean(tool.group),
    click: tool.way ? () => step(...tool.way) : tool.run,
    mousedown: (event) => event.preventDefault(), // the focus stays with the pictures, so that Space still flips
  }, tool.text, tool.key ? make("kbd", {"aria-hidden": "true"}, tool.key) : null);
}

function drawToolStates() {
  const set = (id, name, value) => byId(id) && byId(id).setAttribute(name, String(value));
  const isPinned = view.pinned >= 0;
  set("pin", "aria-pressed", view.pinned === shownCell());
  set("difference", "aria-pressed", view.difference);
  set("reference", "aria-pressed", view.reference);
  set("causes", "aria-pressed", view.causes);
  for (const id of ["flip", "difference"]) {
    if (byId(id)) byId(id).disabled = !isPinned;
  }
  for (const tool of kTools) {
    if (tool.way && byId(tool.id)) byId(tool.id).disabled = cellAway(...tool.way) < 0;
  }
}

const kViewerKeys = {
  ArrowLeft: () => step(-1, 0, 0),
  ArrowRight: () => step(1, 0, 0),
  ArrowUp: () => step(0, -1, 0),
  ArrowDown: () => step(0, 1, 0),
  PageUp: () => step(0, 0, -1),
  PageDown: () => step(0, 0, 1),
  a: pin,
  x: () => flip(),
  " ": () => flip(),
  d: toggleDifference,
  r: toggleReference,
  c: toggleCauses,
  f: () => toggleFit(),
  "+": () => zoomBy(1),
  "=": () => zoomBy(1),
  "-": () => zoomBy(-1),
  0: () => setSolo(-1),
};

document.addEventListener("keydown", (event) => {
  if (!viewer.open || byId("keys").open) return;
  if (event.ctrlKey || event.metaKey || event.altKey || event.target.matches("input, select")) return;
  if (event.key === " " && event.target.closest("button, a")) return; // presses it
  const digit = /^[1-9]$/.test(event.key) ? Number(event.key) : 0;
  const run = digit ? () => digit <= slots.length && slots.length > 1 && setSolo(digit - 1) : kViewerKeys[event.key];
  if (!run) return;
  event.preventDefault();
  run();
});

function startKeys() {
  byId("viewer-tools").append(...kTools.filter((tool) => tool.shown).map(makeTool));
  byId("viewer-close").addEventListener("click", () => viewer.close());
  const rows = kKeys.map(([keys, what]) => make("div", {},
    make("dt", {}, ...keys.map((key) => make("kbd", {}, key))), make("dd", {}, what)));
  byId("keys-list").append(make("dl", {}, ...rows));
  byId("keys-open").addEventListener("click", () => byId("keys").showModal());
  document.addEventListener("keydown", (event) => {
    if (event.key !== "?" || event.target.matches("input, select") || byId("keys").open) return;
    event.preventDefault();
    byId("keys").showModal();
  });
}
