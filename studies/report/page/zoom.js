// SPDX-License-Identifier: MIT
// Zoom and pan, the same for every picture in the viewer: a scale and the point of the picture in the middle.

const zoom = {
  scale: NaN, // screen pixels for one of the picture; 0: as large as fits, at most 1; NaN: not chosen yet
  x: 0, // px of the picture in the middle of its window
  y: 0,
};
const kScales = [0.125, 0.25, 0.5, 1, 2, 4, 8, 16, 32];
const kPaneHead = 26; // px, as in the style
const kPaneGap = 8;

const pixelRatio = () => window.devicePixelRatio || 1;
const isNarrow = () => matchMedia("(max-width: 720px)").matches;

function pictureSize() {
  const layer = view.panes.length && view.panes[0].layers[view.showsPinned ? "a" : "b"];
  const picture = layer && layer.querySelector(".picture");
  if (!picture) return study.size;
  return [Number(picture.style.getPropertyValue("--width")), Number(picture.style.getPropertyValue("--height"))];
}

/** The number of panes beside each other that shows the pictures largest, and the size of their windows. */
function planPanes() {
  const [width, height] = pictureSize();
  const count = Math.max(1, view.panes.length);
  const style = getComputedStyle(stage);
  const roomX = stage.clientWidth - parseFloat(style.paddingLeft) - parseFloat(style.paddingRight);
  const roomY = stage.clientHeight - parseFloat(style.paddingTop) - parseFloat(style.paddingBottom);
  let best = null;
  for (let across = 1; across <= count; ++across) {
    const down = Math.ceil(count / across);
    const paneX = Math.floor((roomX - kPaneGap * (across - 1)) / across);
    // On a narrow screen the stage grows downwards and the viewer scrolls.
    const share = Math.floor((roomY - kPaneGap * (down - 1)) / down) - kPaneHead;
    const paneY = isNarrow() ? Math.ceil(paneX * height / width) : share;
    const fit = Math.min(paneX / width, paneY / height);
    const gain = best ? Math.min(fit, 1 / pixelRatio()) - Math.min(best.fit, 1 / pixelRatio()) : 1;
    if (isNarrow() && across > (count > 2 ? 2 : 1)) break;
    if (gain >= 0 || isNarrow()) best = {across, paneX, paneY, fit};
  }
  // Small pictures stand close together.
  const scale = cssScale(best);
  const fitted = (room, size) => Math.min(room, Math.ceil(size * scale));
  return {...best, paneX: fitted(best.paneX, width), paneY: fitted(best.paneY, height)};
}

/** CSS pixels for one of the picture. */
function cssScale(plan) {
  return zoom.scale ? zoom.scale / pixelRatio() : Math.min(plan.fit, 1 / pixelRatio());
}

/** Where the picture starts in a window of that size; centred where it is smaller, else without a gap. */
function pictureStart(room, size, scale, middle) {
  const slack = room - size * scale;
  const start = slack >= 0 ? slack / 2 : Math.min(0, Math.max(slack, room / 2 - middle * scale));
  return Math.round(start * pixelRatio()) / pixelRatio();
}

/** The nearest point that can be in the middle of what is seen. */
function clampMiddle(middle, seen, size) {
  return seen >= size ? size / 2 : Math.min(size - seen / 2, Math.max(seen / 2, middle));
}

function placePictures() {
  if (!view.panes.length || Number.isNaN(zoom.scale)) return;
  const [width, height] = pictureSize();
  const plan = planPanes();
  const scale = cssScale(plan);
  if (!zoom.scale) [zoom.x, zoom.y] = [width / 2, height / 2];
  zoom.x = clampMiddle(zoom.x, plan.paneX / scale, width);
  zoom.y = clampMiddle(zoom.y, plan.paneY / scale, height);
  const values = {
    "--across": plan.across,
    "--pane-x": `${plan.paneX}px`,
    "--pane-y": `${plan.paneY}px`,
    "--scale": scale,
    "--left": `${pictureStart(plan.paneX, width, scale, zoom.x)}px`,
    "--top": `${pictureStart(plan.paneY, height, scale, zoom.y)}px`,
  };
  for (const [name, value] of Object.entries(values)) stage.style.setProperty(name, value);
  const canPan = width * scale > plan.paneX + 1 || height * scale > plan.paneY + 1;
  stage.classList.toggle("pannable", canPan);
  stage.classList.toggle("magnified", scale * pixelRatio() > 1.001);
  const percent = scale * pixelRatio() * 100;
  byId("zoom-now").textContent = `${percent < 100 ? Number(percent.toPrecision(2)) : Math.round(percent)} %`;
  byId("zoom-fit").setAttribute("aria-pressed", String(!zoom.scale));
  byId("zoom-one").setAttribute("aria-pressed", String(Math.abs(percent - 100) < 0.01));
}

/** One to one where at least half of the picture's sides can be seen so, else all of it. */
function chooseScale() {
  zoom.scale = 0;
  const seen = planPanes().fit * pixelRatio();
  [zoom.x, zoom.y] = pictureSize().map((side) => side / 2);
  zoom.scale = !isNarrow() && seen >= 0.5 ? 1 : 0;
}

function zoomToFit() {
  zoom.scale = 0;
  placePictures();
  keepInHash();
}

/** Zooms so that the picture's point under (x, y), CSS px from the window's middle, stays where it is. */
function zoomTo(scale, x = 0, y = 0) {
  const old = cssScale(planPanes());
  zoom.scale = scale;
  const now = scale / pixelRatio();
  zoom.x += x / old - x / now;
  zoom.y += y / old - y / now;
  placePictures();
  keepInHash();
}

function zoomBy(direction, x = 0, y = 0) {
  const now = cssScale(planPanes()) * pixelRatio();
  const larger = kScales.filter((scale) => scale > now * 1.001);
  const smaller = kScales.filter((scale) => scale < now * 0.999);
  const next = direction > 0 ? larger[0] : smaller.at(-1);
  if (next) zoomTo(next, x, y);
}

/** Between all of the picture and its pixels one to one. */
function toggleFit(x = 0, y = 0) {
  if (zoom.scale === 0) {
    zoomTo(1, x, y);
    return;
  }
  zoomToFit();
}

function panBy(x, y) {
  const scale = cssScale(planPanes());
  if (!zoom.scale) zoom.scale = scale * pixelRatio();
  zoom.x -= x / scale;
  zoom.y -= y / scale;
  placePictures();
  keepInHash();
}

function zoomEntries() {
  return zoom.scale
    ? {zoom: zoom.scale, x: Math.round(zoom.x), y: Math.round(zoom.y)}
    : {zoom: "fit", x: null, y: null};
}

function readZoom() {
  const scale = Number(hashState.get("zoom"));
  zoom.scale = hashState.get("zoom") === "fit" ? 0 : scale > 0.01 && scale <= 64 ? scale : NaN;
  zoom.x = Number(hashState.get("x")) || 0;
  zoom.y = Number(hashState.get("y")) || 0;
}

/** From the middle of the window under the pointer, in CSS px. */
function fromMiddle(event) {
  const box = event.target.closest(".window");
  if (!box) return [0, 0];
  const area = box.getBoundingClientRect();
  return [event.clientX - area.left - area.width / 2, event.clientY - area.top - area.height / 2];
}

stage.addEventListener("wheel", (event) => {
  if (event.ctrlKey) {
    event.preventDefault();
    zoomBy(-event.deltaY, ...fromMiddle(event));
  } else if (stage.classList.contains("pannable")) {
    event.preventDefault();
    panBy(event.shiftKey ? -event.deltaY : -event.deltaX, event.shiftKey ? 0 : -event.deltaY);
  }
}, {passive: false});

stage.addEventListener("dblclick", (event) => {
  if (event.target.closest(".window")) toggleFit(...fromMiddle(event));
});

stage.addEventListener("pointerdown", (event) => {
  if (event.button !== 0 || !event.target.closest(".window") || !stage.classList.contains("pannable")) return;
  const drag = {x: event.clientX, y: event.clientY};
  stage.setPointerCapture(event.pointerId);
  stage.classList.add("dragged");
  const move = (now) => {
    panBy(now.clientX - drag.x, now.clientY - drag.y);
    [drag.x, drag.y] = [now.clientX, now.clientY];
  };
  const end = () => {
    stage.classList.remove("dragged");
    stage.removeEventListener("pointermove", move);
    for (const name of ["pointerup", "pointercancel"]) stage.removeEventListener(name, end);
  };
  stage.addEventListener("pointermove", move);
  for (const name of ["pointerup", "pointercancel"]) stage.addEventListener(name, end);
});

new ResizeObserver(placePictures).observe(stage);
