// What is known of the frame at the playhead.
import { el } from "./dom.js";
import { count, metres, milliseconds } from "./format.js";
import { KIND_NAMES } from "./transport.js";

function rows(run, frame) {
  const { frames, kinds, truth } = run;
  const kind = kinds[frame];
  const rmsUnit = kind === "direct" ? "grey levels" : "px";
  const list = [
    ["Tracking call", milliseconds(frames.update_ms[frame])],
    ["Landmarks", `${count(frames.inliers[frame])} of ${count(frames.visible[frame])} agree`],
    [kind === "direct" ? "Patch error" : "Reprojection", `${frames.rms[frame].toFixed(2)} ${rmsUnit}`],
  ];
  if (kind !== "direct" && kind !== "indirect") list.length = 1;
  if (frames.mapping_ms[frame] > 0) list.splice(1, 0, ["Mapping", milliseconds(frames.mapping_ms[frame])]);
  if (truth && Number.isFinite(truth.error[frame])) list.push(["Position error", metres(truth.error[frame])]);
  return list;
}

export function createFramePanel(run, playhead) {
  const { frames, kinds, segments, pictures } = run;
  const { width, height } = run.stats.source;
  const picture = el("img", { alt: "", width, height });
  const caption = el("figcaption", {});
  const chip = el("span", { class: "chip" });
  const keyframe = el("span", { class: "chip outline" }, "Keyframe");
  const reason = el("p", { class: "reason" });
  const list = el("dl", { class: "readout" });
  let shown = null;

  playhead.watch(({ frame }) => {
    const nearest = pictures.nearest(frame);
    if (nearest && nearest.source !== shown) picture.src = shown = nearest.source;
    picture.alt = nearest ? `Camera image of frame ${frames.index[nearest.frame]}` : "";
    const of = nearest && nearest.frame !== frame ? `, picture of ${frames.index[nearest.frame]}` : "";
    caption.textContent = `Frame ${frames.index[frame]}${of}`;
    chip.className = `chip fill-${kinds[frame]}`;
    chip.textContent = KIND_NAMES[kinds[frame]] ?? kinds[frame];
    keyframe.hidden = !frames.keyframe[frame];
    reason.textContent = segments.find(({ last }) => frame <= last).reason;
    list.replaceChildren(...rows(run, frame).flatMap(([name, value]) => [el("dt", {}, name), el("dd", {}, value)]));
  });
  return el("aside", { class: "card frame", "aria-label": "The frame at the slider" },
    el("figure", { hidden: pictures.count === 0 }, picture, caption),
    el("p", { class: "chips" }, chip, keyframe), reason, list);
}
