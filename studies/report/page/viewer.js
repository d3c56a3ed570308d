// SPDX-License-Identifier: MIT
// The viewer: one cell's pictures at full size, side by side, with its numbers; a second cell (A) to flip to.
// Pictures of both cells lie over each other in every pane, so that a flip only changes which one is on top.

const viewer = byId("viewer");
const stage = byId("stage");

const view = {
  cell: 0, // B where a cell is pinned
  pinned: -1, // A
  showsPinned: false,
  reference: false,
  causes: false,
  opacity: 1,
  difference: false,
  solo: -1, // the only picture shown; -1: all
  opener: null,
  pushed: false, // opening made a step in the browser's history
  panes: [], // {slot, element, layers: {a, b}}
  loading: 0,
};

const shownCell = () => (view.showsPinned ? view.pinned : view.cell);
const hasOverlays = cells.some((cell) => cell.overlays && cell.overlays.some((index) => index >= 0));
const hasCauses = study.causes.length > 0;

/* Loading. */

/** Resolves when the picture can be drawn at once; without its file, its thumbnail stands in. */
async function loadPicture(index, slot) {
  const cell = cells[index];
  const url = pictureUrl(cell, slot);
  const alt = `${slots[slot].label} of cell ${index + 1}`;
  const image = make("img", {class: "picture", alt, draggable: "false", decoding: "sync"});
  try {
    image.src = url;
    await image.decode();
    return image;
  } catch (error) {
    const thumb = thumbUrl(cell, slot);
    if (!thumb) return make("p", {class: "message"}, `${decodeURIComponent(url)} is not beside this page.`);
    image.src = thumb;
    image.dataset.standIn = "";
    await image.decode().catch(() => {});
    return image;
  }
}

async function loadLayer(index, slot) {
  const cell = cells[index];
  const layer = make("div", {class: "layer"});
  if (!isDrawn(cell)) {
    const text = cell.error ? `This cell failed: ${cell.error}` : "This cell was not drawn.";
    layer.append(make("p", {class: "message"}, text));
    return layer;
  }
  const picture = await loadPicture(index, slot);
  if (picture.tagName === "IMG") {
    const isStandIn = "standIn" in picture.dataset;
    picture.style.setProperty("--width", isStandIn ? study.size[0] : picture.naturalWidth);
    picture.style.setProperty("--height", isStandIn ? study.size[1] : picture.naturalHeight);
  }
  layer.append(picture);
  const causes = overlayUrl(cell, slots[slot].view, "causes");
  if (causes) {
    const dots = make("img", {src: causes, alt: "causes of wrong lines", draggable: "false"});
    dots.style.cssText = picture.style.cssText;
    layer.append(make("div", {class: "causes"}, dots));
  }
  const overlay = overlayUrl(cell, slots[slot].view);
  if (overlay) {
    const lines = make("img", {src: overlay, alt: "reference lines", draggable: "false"});
    lines.style.cssText = picture.style.cssText;
    layer.append(make("div", {class: "overlay"}, lines));
  }
  return layer;
}

/** Puts a cell's pictures into the panes once all of them are there; the old ones stay until then. */
async function fillPanes(which, index) {
  const panes = view.panes;
  const layers = await Promise.all(panes.map((pane) => (index < 0 ? null : loadLayer(index, pane.slot))));
  if (panes !== view.panes || index !== (which === "a" ? view.pinned : view.cell)) return; // overtaken
  panes.forEach((pane, i) => {
    if (pane.layers[which]) pane.layers[which].remove();
    pane.layers[which] = layers[i];
    if (!layers[i]) return;
    layers[i].dataset.which = which;
    pane.window.append(layers[i]);
  });
  placePictures();
}

function preloadNeighbours() {
  if (view.panes.length > 4) return;
  for (const index of neighbours(view.cell)) {
    for (const pane of view.panes) {
      if (isDrawn(cells[index])) new Image().src = pictureUrl(cells[index], pane.slot);
    }
  }
}

/* Panes. */

function makePane(slot, position) {
  const label = slots[slot].label;
  const isSolo = view.solo === slot;
  const name = slots.length > 1
    ? make("button", {
      type: "button", class: "pane-name", "aria-pressed": String(isSolo),
      title: isSolo ? "Show all pictures (0)" : `Show only this picture${position < 9 ? ` (${position + 1})` : ""}`,
      click: () => setSolo(isSolo ? -1 : slot),
    }, label)
    : make("span", {class: "pane-name"}, label);
  const file = make("a", {class: "pane-file", target: "_blank", rel: "noopener"}, "PNG");
  const windowBox = make("div", {class: "window"});
  const element = make("div", {class: "pane"}, make("div", {class: "pane-head"}, name, file), windowBox);
  return {slot, element, window: windowBox, file, layers: {a: null, b: null}};
}

function buildPanes() {
  const shown = slots.map((slot, index) => index).filter((index) => view.solo < 0 || view.solo === index);
  view.panes = shown.map((slot) => makePane(slot, slot));
  stage.replaceChildren(...view.panes.map((pane) => pane.element));
  return Promise.all([fillPanes("a", view.pinned), fillPanes("b", view.cell)]);
}

function setSolo(slot) {
  view.solo = slot < slots.length ? slot : -1;
  buildPanes();
  describe();
}

/* What is shown. */

function showCell(index) {
  if (index < 0) return;
  view.cell = index;
  view.showsPinned = false;
  fillPanes("b", index).then(preloadNeighbours);
  describe();
}

function pin() {
  const isSame = view.pinned === shownCell();
  view.pinned = isSame ? -1 : shownCell();
  view.showsPinned = false;
  view.difference = view.difference && !isSame;
  fillPanes("a", view.pinned);
  describe();
}

/** Shows A in place of B, or B in place of A. */
function flip(showsPinned = !view.showsPinned) {
  if (view.pinned < 0) {
    announce("Pin a cell as A first: a");
    return;
  }
  view.showsPinned = showsPinned;
  view.difference = false;
  describe();
}

function toggleDifference() {
  if (view.pinned < 0) {
    announce("Pin a cell as A first: a");
    return;
  }
  view.difference = !view.difference;
  describe();
}

function toggleReference() {
  if (!hasOverlays) return;
  view.reference = !view.reference;
  describe();
}

function toggleCauses() {
  if (!hasCauses) return;
  view.causes = !view.causes;
  describe();
}

/* Opening and closing. */

function openViewer(index, opener = null) {
  view.opener = opener;
  view.cell = index;
  view.showsPinned = false;
  view.pushed = !hashState.has("cell");
  showViewer();
  describe({push: view.pushed});
}

function showViewer() {
  if (!viewer.open) viewer.showModal();
  stage.focus();
  const filled = buildPanes();
  if (Number.isNaN(zoom.scale)) chooseScale();
  filled.then(preloadNeighbours);
}

const kViewerEntries = ["cell", "a", "show", "difference", "reference", "causes", "zoom", "x", "y", "picture"];

viewer.addEventListener("close", () => {
  const last = view.cell;
  stage.replaceChildren();
  view.panes = [];
  for (const name of kViewerEntries) hashState.delete(name);
  if (view.pushed && location.hash.includes("cell=")) history.back();
  else setHash({});
  view.pushed = false;
  const isInTable = view.opener && tableBox.contains(view.opener);
  if (isInTable && view.opener.isConnected) view.opener.focus();
  else focusCell(last);
});

/** Shows what the address says; closes where it names no cell. */
function applyHash() {
  const index = hashNumber("cell", 1, cells.length, 0) - 1;
  if (index < 0) {
    view.pushed = false;
    if (viewer.open) viewer.close();
    else setHash({page: gridState.page ? gridState.page + 1 : null});
    return;
  }
  view.cell = index;
  view.pinned = hashNumber("a", 1, cells.length, 0) - 1;
  view.showsPinned = view.pinned >= 0 && hashState.get("show") === "a";
  view.difference = view.pinned >= 0 && hashState.get("difference") === "1";
  view.reference = hasOverlays && hashState.get("reference") === "1";
  view.causes = hasCauses && hashState.get("causes") === "1";
  view.solo = hashNumber("picture", 1, slots.length, 0) - 1;
  readZoom();
  showViewer();
  describe();
}

function keepInHash(options) {
  setHash({
    cell: view.cell + 1,
    a: view.pinned < 0 ? null : view.pinned + 1,
    show: view.showsPinned ? "a" : null,
    difference: view.difference ? 1 : null,
    reference: view.reference ? 1 : null,
    causes: view.causes ? 1 : null,
    picture: view.solo < 0 ? null : view.solo + 1,
    ...zoomEntries(),
  }, options);
}
