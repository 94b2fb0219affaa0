// The slider through the frames, the strip of trackers above it, playing.
import { el, moveByArrows, svg } from "./dom.js";
import { plural, seconds } from "./format.js";

export const KIND_NAMES = {
  direct: "Direct", indirect: "Indirect", lost: "Lost", initializing: "Initialising", paused: "Paused",
};
const ICONS = { play: "M5 3.5v13l11-6.5z", pause: "M5 3.5h3.6v13H5zM11.4 3.5H15v13h-3.6z" };
const SPEEDS = [0.25, 0.5, 1, 2, 4];

function describe(segment, frames) {
  const range = segment.first === segment.last ? `frame ${frames.index[segment.first]}`
    : `frames ${frames.index[segment.first]} to ${frames.index[segment.last]}`;
  return [KIND_NAMES[segment.kind] ?? segment.kind, segment.reason, `${range}, ${seconds(frames.time_s[segment.first])}`];
}

/// Frames before which others were dropped or skipped by the source.
function gaps(frames) {
  const found = [];
  for (let i = 1; i < frames.count; ++i) {
    const missing = frames.index[i] - frames.index[i - 1] - 1;
    if (missing > 0) found.push({ at: i, missing });
  }
  return found;
}

function stripImage(run) {
  const { frames, segments } = run;
  return svg("svg", { viewBox: `0 0 ${frames.count} 1`, preserveAspectRatio: "none", "aria-hidden": "true" },
    ...segments.map(({ first, last, kind }) =>
      svg("rect", { x: first, y: 0, width: last - first + 1, height: 1, class: `fill-${kind}` })),
    ...gaps(frames).map(({ at }) =>
      svg("line", { x1: at, x2: at, y1: 0, y2: 1, class: "gap", "vector-effect": "non-scaling-stroke" })));
}

/// One segment after the other by arrow keys, each told by a screen reader and the tooltip.
function createStrip(run, playhead, tooltip) {
  const { frames, segments } = run;
  let active = 0;
  const marker = el("span", { class: "segment-marker", hidden: true });
  const options = el("span", { id: "segment-text", class: "visually-hidden", role: "status" });
  const strip = el("div", {
    class: "strip", tabindex: 0, role: "group", "aria-describedby": "segment-text",
    "aria-label": `Which tracker placed the frames: ${plural(segments.length, "section")}. Arrow keys go through them, Enter moves the slider there.`,
  }, stripImage(run), marker, options);

  function showSegment(index, x, y) {
    const segment = segments[index];
    tooltip.show(x, y, ...describe(segment, frames));
    marker.hidden = false;
    marker.style.left = `${(100 * segment.first) / frames.count}%`;
    marker.style.width = `${(100 * (segment.last - segment.first + 1)) / frames.count}%`;
  }
  function focusSegment(index) {
    active = index;
    const { left, top, width } = strip.getBoundingClientRect();
    showSegment(active, left + (width * segments[active].first) / frames.count, top);
    options.textContent = describe(segments[active], frames).filter(Boolean).join(", ");
  }
  function hide() {
    marker.hidden = true;
    tooltip.hide();
  }
  const frameAt = (event) => {
    const { left, width } = strip.getBoundingClientRect();
    return Math.min(frames.count - 1, Math.max(0, Math.floor((frames.count * (event.clientX - left)) / width)));
  };

  strip.addEventListener("pointermove", (event) => {
    const frame = frameAt(event);
    showSegment(segments.findIndex(({ last }) => frame <= last), event.clientX, strip.getBoundingClientRect().top);
  });
  strip.addEventListener("pointerleave", hide);
  strip.addEventListener("pointerdown", (event) => playhead.seek(frameAt(event)));
  strip.addEventListener("focus", () => {
    if (!strip.matches(":focus-visible")) return;
    focusSegment(segments.findIndex(({ last }) => playhead.state.frame <= last));
  });
  strip.addEventListener("blur", hide);
  strip.addEventListener("keydown", (event) => {
    const next = moveByArrows(event, segments.length, active);
    if (event.key === "Enter") playhead.seek(segments[active].first);
    else if (next !== null) focusSegment(next);
    else return;
    event.preventDefault();
  });
  return strip;
}

function playButton(playhead) {
  const path = svg("path", { d: ICONS.play });
  const button = el("button", { class: "play", type: "button", click: playhead.toggle, "aria-label": "Play" },
    svg("svg", { viewBox: "0 0 20 20", "aria-hidden": "true" }, path));
  playhead.watch(({ playing }) => {
    path.setAttribute("d", playing ? ICONS.pause : ICONS.play);
    button.setAttribute("aria-label", playing ? "Pause" : "Play");
  });
  return button;
}

function speedChoice(playhead) {
  return el("select", { class: "speed", "aria-label": "Speed of playing", change: (event) => playhead.setSpeed(Number(event.target.value)) },
    ...SPEEDS.map((speed) => el("option", { value: speed, selected: speed === 1 }, `${speed}\u00d7`)));
}

function createSlider(run, playhead) {
  const { frames, kinds, segments } = run;
  const slider = el("input", {
    type: "range", min: 0, max: frames.count - 1, step: 1, class: "slider", "aria-label": "Frame",
    input: () => playhead.seek(Number(slider.value)),
    keydown: (event) => {
      if (event.key !== " ") return;
      event.preventDefault();
      playhead.toggle();
    },
  });
  playhead.watch(({ frame }) => {
    slider.value = frame;
    const { reason } = segments.find(({ last }) => frame <= last);
    const words = [`frame ${frames.index[frame]}`, seconds(frames.time_s[frame]), KIND_NAMES[kinds[frame]] ?? kinds[frame], reason];
    slider.setAttribute("aria-valuetext", words.filter(Boolean).join(", "));
  });
  return slider;
}

export function createTransport(run, playhead, tooltip) {
  const clock = el("output", { class: "clock" });
  playhead.watch(({ frame }) => { clock.textContent = seconds(run.frames.time_s[frame]); });
  return el("div", { class: "transport", role: "group", "aria-label": "Playing" },
    playButton(playhead),
    el("div", { class: "track" }, createStrip(run, playhead, tooltip), createSlider(run, playhead)),
    clock, speedChoice(playhead));
}
