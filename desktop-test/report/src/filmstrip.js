// The keyframes as a row of pictures: pointing at one shows it in the map, choosing it moves the slider.
import { card, el, moveByArrows } from "./dom.js";
import { seconds } from "./format.js";

/// At most so many, evenly chosen: each is an element with a picture.
const MAX_PICTURES = 120;

export function createFilmstrip(run, playhead, scene) {
  const all = run.keyframes.filter(({ frame }) => frame >= 0);
  if (all.length === 0 || run.pictures.count === 0) return null;
  const stride = Math.ceil(all.length / MAX_PICTURES);
  const keyframes = all.filter((_, k) => k % stride === 0);
  let active = 0;
  const { width, height } = run.stats.source;

  const buttons = keyframes.map((keyframe, k) => el("button", {
    type: "button", tabindex: k === 0 ? 0 : -1,
    "aria-label": `Keyframe ${keyframe.id}, ${seconds(run.frames.time_s[keyframe.frame])}`,
    click: () => playhead.seek(keyframe.frame),
    focus: () => mark(k),
    blur: () => scene?.mark(null),
    pointerenter: () => scene?.mark(keyframe),
    pointerleave: () => scene?.mark(null),
  }, el("img", { src: run.pictures.nearest(keyframe.frame).source, alt: "", loading: "lazy", width, height }),
  el("span", { class: `dot fill-${run.kinds[keyframe.frame]}` }), el("span", {}, seconds(run.frames.time_s[keyframe.frame]))));

  function mark(k) {
    buttons[active].tabIndex = -1;
    buttons[active = k].tabIndex = 0;
    scene?.mark(keyframes[k]);
  }
  const row = el("div", {
    class: "filmstrip", role: "toolbar", "aria-label": "Keyframes; arrow keys go through them",
    keydown: (event) => {
      const next = moveByArrows(event, buttons.length, active);
      if (next === null) return;
      event.preventDefault();
      buttons[next].focus();
    },
  }, ...buttons);
  const shown = stride > 1 ? ` (every ${stride}th)` : "";
  return card(`Keyframes${shown}`, { class: "film" }, row);
}
