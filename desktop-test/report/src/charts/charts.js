// The three charts of a run.
import { svg } from "../dom.js";
import { count, metres, milliseconds, plural } from "../format.js";
import { createChart, linePath, quantile, stepArea } from "./chart.js";

const STAGES = [
  ["pyramid_ms", "Pyramid"], ["precompute_ms", "Precompute"], ["align_ms", "Align"],
  ["features_ms", "Features"], ["match_ms", "Match"], ["pose_ms", "Pose"],
];
const SHOWN = 0.99; // share of the frames that fit under the top of the chart of times
const HEADROOM = 1.15;

function largest(values) {
  return values.reduce((most, value) => Math.max(most, value), 0);
}

/// [{key, name, values}], lowest first: the stages, what the call took beside them, mapping.
function timeSeries(frames) {
  const stages = STAGES.map(([key, name]) => ({ key: key.replace("_ms", ""), name, values: frames[key] }));
  const rest = Float32Array.from(frames.update_ms, (all, i) =>
    Math.max(0, all - stages.reduce((sum, { values }) => sum + values[i], 0)));
  const series = [...stages, { key: "rest", name: "Other", values: rest }];
  if (frames.mapping_ms.some((value) => value > 0)) series.push({ key: "mapping", name: "Mapping", values: frames.mapping_ms });
  return series.filter(({ values }) => values.some((value) => value > 0));
}

function stack(series, length) {
  let low = new Float32Array(length);
  return series.map((layer) => {
    const high = low.map((value, i) => value + layer.values[i]);
    const area = { ...layer, low, high };
    low = high;
    return area;
  });
}

function timesChart(run) {
  const { frames } = run;
  const areas = stack(timeSeries(frames), frames.count);
  const total = areas.length > 0 ? areas[areas.length - 1].high : new Float32Array(frames.count);
  const high = Math.max(0.1, HEADROOM * Math.min(quantile(total, SHOWN), largest(total)) || 0);
  const above = total.filter((value) => value > high).length;
  const { update } = run.stats.time_ms;
  const median = update ? `Median ${milliseconds(update.median)}, 95th percentile ${milliseconds(update.p95)}` : "No frame";
  return {
    title: "Time per frame, ms",
    summary: above > 0 ? `${median}; ${plural(above, "frame")} above the chart.` : `${median}.`,
    legend: areas.map(({ key, name }) => ({ swatch: `stage-${key}`, name })),
    high,
    draw: (scales) => areas.map(({ key, low, high: top }) => svg("path", { class: `stage-${key}`, d: stepArea(low, top, scales) })),
    values: (frame) => areas.filter(({ values }) => values[frame] > 0).reverse()
      .map(({ name, values }) => `${name} ${milliseconds(values[frame])}`),
  };
}

function inliersChart(run) {
  const { frames } = run;
  const tracked = (i) => run.kinds[i] === "direct" || run.kinds[i] === "indirect";
  const inliers = Array.from(frames.inliers, (value, i) => (tracked(i) ? value : NaN));
  const visible = Array.from(frames.visible, (value, i) => (tracked(i) ? value : 0));
  return {
    title: "Landmarks per frame",
    summary: inliers.some(Number.isFinite) ? `Median of ${count(quantile(inliers, 0.5))} agree with the pose.` : "No frame was tracked.",
    legend: [{ swatch: "visible", name: "In view" }, { swatch: "inliers", name: "Agree with the pose" }],
    high: Math.max(1, HEADROOM * largest(visible)),
    draw: (scales) => [
      svg("path", { class: "visible", d: stepArea(new Float32Array(frames.count), visible, scales) }),
      svg("path", { class: "inliers line", d: linePath(inliers, scales) }),
    ],
    values: (frame) => (tracked(frame) ? [`${count(frames.inliers[frame])} of ${count(frames.visible[frame])} agree`] : ["Not tracked"]),
  };
}

function errorChart(run) {
  const { error } = run.truth;
  // A truth may be known every few frames only: the line goes on to the next, unless the pose is lost.
  const line = Array.from(error, (value, i) => (Number.isFinite(value) ? value : run.poses[i] ? null : NaN));
  const known = error.filter(Number.isFinite);
  const rms = Math.sqrt(known.reduce((sum, value) => sum + value * value, 0) / known.length);
  const most = largest(known);
  const scale = most < 0.01 ? 1000 : most < 1 ? 100 : 1;
  const unit = { 1000: "mm", 100: "cm", 1: "m" }[scale];
  return {
    title: `Position error, ${unit}`,
    summary: `RMS ${metres(rms)}, at most ${metres(most)}, after aligning the trajectory to the truth by a similarity.`,
    legend: [{ swatch: "error", name: "Error" }, { swatch: "rms", name: "RMS" }],
    high: Math.max(1e-6, HEADROOM * most * scale),
    draw: (scales) => [
      svg("path", { class: "rms line", d: linePath(error.map(() => rms * scale), scales) }),
      svg("path", { class: "error line", d: linePath(line.map((value) => (value === null ? null : value * scale)), scales) }),
    ],
    values: (frame) => [Number.isFinite(error[frame]) ? metres(error[frame]) : "No truth or no pose"],
  };
}

export function createCharts(run, playhead, tooltip) {
  const charts = [timesChart(run), inliersChart(run)];
  if (run.truth?.error.some(Number.isFinite)) charts.push(errorChart(run));
  return charts.map((chart) => createChart(run, playhead, tooltip, chart));
}
