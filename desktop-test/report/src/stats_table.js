// stats.json as tables, one for each of its groups.
import { card, el } from "./dom.js";
import { number } from "./format.js";

const TITLES = {
  run: "Run", source: "Source", frames: "Frames", time_ms: "Time, ms", gpu: "Backend", map: "Map",
  accuracy: "Accuracy", memory: "Memory", config: "Configuration",
};

function text(value) {
  if (value === null) return "\u2013";
  if (typeof value === "number") return number(value);
  if (Array.isArray(value)) return value.length > 0 ? value.map(text).join(", ") : "\u2013";
  return String(value);
}

/// [["stages.pyramid.median", 0.1], ...]
function flatten(value, prefix = "") {
  if (value === null || typeof value !== "object" || Array.isArray(value)) return [[prefix, value]];
  return Object.entries(value).flatMap(([key, inner]) => flatten(inner, prefix ? `${prefix}.${key}` : key));
}

function table(title, rows) {
  return el("table", {}, el("caption", {}, title),
    el("tbody", {}, ...rows.map(([name, value]) => el("tr", {}, el("th", { scope: "row" }, name), el("td", {}, text(value))))));
}

/// The times as a matrix: a row per series, a column per measure.
function timesTable(times) {
  const measures = ["median", "p95", "mean", "max"];
  const { stages, ...series } = times;
  const rows = Object.entries({ ...series, ...stages }).filter(([, spread]) => spread !== null);
  return el("table", {}, el("caption", {}, TITLES.time_ms),
    el("thead", {}, el("tr", {}, el("td", {}), ...measures.map((name) => el("th", { scope: "col" }, name)))),
    el("tbody", {}, ...rows.map(([name, spread]) => el("tr", {}, el("th", { scope: "row" }, name),
      ...measures.map((measure) => el("td", {}, measure in spread ? number(spread[measure]) : ""))))));
}

export function createStatsTable(stats) {
  const groups = Object.entries(stats).filter(([name, value]) => value !== null && typeof value === "object" && !["config", "time_ms"].includes(name));
  const single = Object.entries(stats).filter(([name, value]) => (value === null || typeof value !== "object") && !(name in TITLES));
  const none = stats.accuracy === null ? [table(TITLES.accuracy, [["gt", null]])] : [];
  return card("Statistics", { class: "stats" },
    el("div", { class: "tables" }, timesTable(stats.time_ms), table(TITLES.run, single),
      ...groups.map(([name, value]) => table(TITLES[name] ?? name, flatten(value))), ...none),
    el("details", {}, el("summary", {}, TITLES.config), el("div", { class: "tables" },
      ...Object.entries(stats.config).filter(([, value]) => value !== null && typeof value === "object" && !Array.isArray(value))
        .map(([name, value]) => table(name, flatten(value))),
      table("session", Object.entries(stats.config).filter(([, value]) => value === null || typeof value !== "object" || Array.isArray(value))))));
}
