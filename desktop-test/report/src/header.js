// The head of the page: which run, and its most important numbers.
import { el } from "./dom.js";
import { count, metres, milliseconds, percent, plural } from "./format.js";

function describeTracker(stats) {
  const { tracker, direct } = stats.config;
  const where = stats.gpu.renderer ? `${stats.gpu.backend} (${stats.gpu.renderer})` : stats.gpu.backend;
  if (tracker !== "hybrid") return `${tracker} tracker`;
  return `hybrid tracker on ${where}, patch ${direct.patch_size}, ${direct.levels} levels`;
}

function tile(label, value, detail) {
  return el("div", { class: "tile" },
    el("dt", {}, label),
    el("dd", {}, el("span", { class: "value" }, value), detail ? el("span", { class: "detail" }, detail) : null));
}

function timeTile(time) {
  const both = time.direct && time.indirect && time.direct.median > 0;
  const detail = both ? `indirect ${milliseconds(time.indirect.median)}, ${(time.indirect.median / time.direct.median).toFixed(1)}\u00d7`
    : time.update ? `p95 ${milliseconds(time.update.p95)}` : null;
  return tile(both ? "Direct frame, median" : "Frame, median", milliseconds((both ? time.direct : time.update)?.median ?? NaN), detail);
}

function accuracyTile(accuracy) {
  if (!accuracy) return tile("Position error", "\u2013", "no ground truth");
  if (accuracy.ate_rmse_m === null) return tile("Position error", "\u2013", "too few poses to align");
  return tile("Position error, RMS", metres(accuracy.ate_rmse_m), `at most ${metres(accuracy.ate_max_m)}`);
}

function tiles(stats) {
  const { frames, map } = stats;
  const dropped = frames.dropped > 0 ? `, ${count(frames.dropped)} dropped` : "";
  return el("dl", { class: "tiles" },
    tile("Tracked", stats.tracked_ratio === null ? "\u2013" : percent(stats.tracked_ratio), `${count(frames.tracked)} of ${plural(frames.in, "frame")}${dropped}`),
    tile("Direct", stats.direct_share === null ? "\u2013" : percent(stats.direct_share), `${count(frames.direct)} direct, ${count(frames.indirect)} indirect`),
    timeTile(stats.time_ms),
    accuracyTile(stats.accuracy),
    tile("Keyframes", count(map.keyframes), map.resets > 0 ? `map started over ${count(map.resets)}\u00d7` : `${plural(map.loops_closed, "loop")} closed`),
    tile("Landmarks", count(map.landmarks), stats.memory.map_mb === null ? null : `map of ${stats.memory.map_mb.toFixed(1)} MB`));
}

export function createHeader(run) {
  const { source, pace, deterministic, version } = run.stats;
  const facts = [`${source.width}\u00d7${source.height}`, describeTracker(run.stats), deterministic ? "deterministic" : pace];
  return el("header", {},
    el("p", { class: "brand" }, el("strong", {}, "GLidE-SLAM"), ` ${version} \u00b7 replay`),
    el("h1", {}, run.name),
    el("p", { class: "facts" }, el("span", { class: "path" }, source.path), ...facts.map((fact) => el("span", {}, fact))),
    ...run.skips.map((skip) => el("p", { class: "note" }, skip)),
    tiles(run.stats));
}
