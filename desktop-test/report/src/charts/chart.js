// A chart over the frames: axes, a cursor at the playhead, values under the pointer. What is drawn is the caller's.
import { card, el, svg } from "../dom.js";
import { seconds } from "../format.js";

const MARGIN = { top: 8, right: 8, bottom: 22, left: 46 };
const HEIGHT = 168;
const Y_TICKS = 4, X_TICK_PX = 90;

/// Round numbers from 0 (or the first multiple above low) to high, about so many.
function ticks(low, high, wanted) {
  const rough = (high - low) / Math.max(1, wanted);
  if (!(rough > 0)) return [low];
  const power = 10 ** Math.floor(Math.log10(rough));
  const step = [1, 2, 5, 10].map((digit) => digit * power).find((size) => size >= rough);
  const values = [];
  for (let k = Math.ceil(low / step - 1e-9); k * step <= high * (1 + 1e-9); ++k) values.push(k * step);
  return values;
}

/// Multiples of a round step, without what their sums have too much.
function tickText(value) {
  return String(Number(value.toPrecision(6)));
}

/// The first frame at or after a time.
function frameAt(times, time) {
  let low = 0;
  for (let high = times.length; low < high;) {
    const middle = (low + high) >> 1;
    if (times[middle] < time) low = middle + 1;
    else high = middle;
  }
  return low;
}

function axes(frames, { x, y, high, width }) {
  const last = frames.time_s[frames.count - 1];
  const xs = ticks(0, last, width / X_TICK_PX).map((time) => [x(frameAt(frames.time_s, time) + 0.5), `${tickText(time)} s`]);
  return svg("g", { class: "axes" },
    ...ticks(0, high, Y_TICKS).flatMap((value) => [
      svg("line", { x1: MARGIN.left, x2: width - MARGIN.right, y1: y(value), y2: y(value) }),
      svg("text", { x: MARGIN.left - 6, y: y(value), dy: "0.32em", "text-anchor": "end" }, tickText(value)),
    ]),
    ...xs.map(([at, label]) => svg("text", { x: at, y: HEIGHT - 5, "text-anchor": "middle" }, label)));
}

function createLegend(entries) {
  return el("ul", { class: "chart-legend" }, ...entries.map(({ swatch, name }) =>
    el("li", {}, el("span", { class: `swatch ${swatch}`, "aria-hidden": "true" }), name)));
}

/// chart: {title, unit, summary, legend, high, draw(scales) -> SVG nodes, values(frame) -> lines of the tooltip}
export function createChart(run, playhead, tooltip, chart) {
  const { frames } = run;
  const image = svg("svg", { role: "img", "aria-label": `${chart.title}. ${chart.summary}`, height: HEIGHT });
  const cursor = svg("line", { class: "cursor", y1: MARGIN.top, y2: HEIGHT - MARGIN.bottom });
  let x = () => 0, width = 0;

  function placeCursor() {
    const at = x(playhead.state.frame + 0.5);
    cursor.setAttribute("x1", at);
    cursor.setAttribute("x2", at);
  }
  function draw() {
    if (image.clientWidth === width || image.clientWidth === 0) return;
    width = image.clientWidth;
    const plot = width - MARGIN.left - MARGIN.right;
    x = (frame) => MARGIN.left + (plot * frame) / frames.count;
    const y = (value) => HEIGHT - MARGIN.bottom - (HEIGHT - MARGIN.top - MARGIN.bottom) * (Math.min(value, chart.high) / chart.high);
    image.setAttribute("viewBox", `0 0 ${width} ${HEIGHT}`);
    image.replaceChildren(axes(frames, { x, y, high: chart.high, width }), ...chart.draw({ x, y }), cursor);
    placeCursor();
  }
  const frameUnder = (event) => {
    const inside = event.clientX - image.getBoundingClientRect().left - MARGIN.left;
    const frame = Math.floor((frames.count * inside) / (width - MARGIN.left - MARGIN.right));
    return Math.min(frames.count - 1, Math.max(0, frame));
  };
  image.addEventListener("pointermove", (event) => {
    const frame = frameUnder(event);
    if (event.buttons === 1) playhead.seek(frame);
    tooltip.show(event.clientX, event.clientY, `Frame ${frames.index[frame]}, ${seconds(frames.time_s[frame])}`, ...chart.values(frame));
  });
  image.addEventListener("pointerdown", (event) => playhead.seek(frameUnder(event)));
  image.addEventListener("pointerleave", () => tooltip.hide());
  new ResizeObserver(draw).observe(image);
  playhead.watch(placeCursor);
  return card(chart.title, { class: "chart" }, el("p", { class: "summary" }, chart.summary), createLegend(chart.legend), image);
}

/// A line through the frames that have a number; NaN breaks it, null is passed over.
export function linePath(values, { x, y }) {
  let path = "", isDown = false;
  values.forEach((value, i) => {
    if (value === null) return;
    if (Number.isFinite(value)) path += `${isDown ? "L" : "M"}${x(i + 0.5).toFixed(1)} ${y(value).toFixed(1)}`;
    isDown = Number.isFinite(value);
  });
  return path;
}

/// The area between two series, as steps one frame wide.
export function stepArea(low, high, { x, y }) {
  let up = "", down = "";
  for (let i = 0; i < high.length; ++i) {
    const left = x(i).toFixed(1), right = x(i + 1).toFixed(1);
    up += `${i === 0 ? "M" : "L"}${left} ${y(high[i]).toFixed(1)}H${right}`;
    down = `L${right} ${y(low[i]).toFixed(1)}H${left}${down}`;
  }
  return `${up}${down}Z`;
}

export function quantile(values, share) {
  const sorted = Array.from(values).filter(Number.isFinite).sort((a, b) => a - b);
  return sorted.length > 0 ? sorted[Math.min(sorted.length - 1, Math.floor(share * sorted.length))] : NaN;
}
