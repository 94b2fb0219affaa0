// The page of report.html.
import { createCharts } from "./charts/charts.js";
import { el } from "./dom.js";
import { createDownloads } from "./downloads.js";
import { createFilmstrip } from "./filmstrip.js";
import { createFramePanel } from "./frame_panel.js";
import { createHeader } from "./header.js";
import { createPlayhead } from "./playhead.js";
import { decodeRun } from "./run.js";
import { createStatsTable } from "./stats_table.js";
import { createTooltip } from "./tooltip.js";
import { createTransport } from "./transport.js";
import { createViewer } from "./viewer.js";

function frameParts(run, playhead, tooltip) {
  const viewer = createViewer(run, playhead, tooltip);
  const parts = [
    el("div", { class: "look" }, viewer.element, createTransport(run, playhead, tooltip), createFramePanel(run, playhead)),
    createFilmstrip(run, playhead, viewer.scene),
    el("div", { class: "charts" }, ...createCharts(run, playhead, tooltip)),
  ];
  return { parts, scene: viewer.scene };
}

function start() {
  const run = decodeRun(JSON.parse(document.getElementById("run").textContent));
  const playhead = createPlayhead(run.frames);
  const tooltip = createTooltip();
  document.title = `${run.name} \u00b7 GLidE-SLAM`;
  const { parts, scene } = run.frames.count > 0 ? frameParts(run, playhead, tooltip)
    : { parts: [el("p", { class: "card message" }, "No frame could be read.")], scene: null };
  document.getElementById("app").append(createHeader(run),
    el("main", {}, ...parts.filter(Boolean), createStatsTable(run.stats), createDownloads(run)));
  document.addEventListener("keydown", (event) => {
    if (event.key === "Escape") tooltip.hide();
  });
  // What the tests look at.
  window.glideReport = { run, playhead, scene };
}

start();
