// SPDX-License-Identifier: MIT
// Starts the page; links within it; copying; printing.

async function copyCommand() {
  const button = byId("copy");
  const text = byId("command").textContent;
  try {
    await navigator.clipboard.writeText(text);
  } catch (error) {
    getSelection().selectAllChildren(byId("command")); // no clipboard here: one key press is left to do
    document.execCommand("copy");
  }
  button.textContent = "Copied";
  setTimeout(() => { button.textContent = "Copy"; }, 1500);
}

/** Links to cells open them; links to sections scroll and leave the hash to what is shown. */
function followLink(event) {
  const link = event.target.closest('a[href^="#"]');
  if (!link || event.ctrlKey || event.metaKey || event.shiftKey) return;
  const cell = /^#cell=(\d+)$/.exec(link.getAttribute("href"));
  event.preventDefault();
  if (cell) {
    openViewer(Number(cell[1]) - 1, link);
    return;
  }
  const section = document.querySelector(link.getAttribute("href"));
  section.scrollIntoView();
  section.querySelector("h2").tabIndex = -1;
  section.querySelector("h2").focus({preventScroll: true});
}

const kMostPrintedCells = 1000;

function beforePrint() {
  for (const line of [...gridBox.querySelectorAll("tbody tr, .grid-line")].slice(0, kMostPrintedCells)) fillLine(line);
  tableState.all = tableState.order.length <= kMostPrintedCells;
  drawRows(true);
  document.querySelector(".spec").open = true;
}

function afterPrint() {
  tableState.all = false;
  drawRows(true);
  document.querySelector(".spec").open = false;
}

startGrid();
startTable();
startKeys();
byId("copy").addEventListener("click", copyCommand);
document.addEventListener("click", followLink);
addEventListener("popstate", () => { readHash(); applyHash(); });
addEventListener("hashchange", () => { readHash(); applyHash(); });
addEventListener("beforeprint", beforePrint);
addEventListener("afterprint", afterPrint);
if (hashState.has("cell")) applyHash();
