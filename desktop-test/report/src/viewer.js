// The 3-D view with its legend, which switches layers, and its buttons.
import { el } from "./dom.js";
import { count, number, plural } from "./format.js";
import { createScene, hasWebGl } from "./scene/scene.js";
import { onThemeChange } from "./theme.js";

function legendEntries(run) {
  const { frames, map } = run.stats;
  return {
    trajectory: [["direct", `Direct ${count(frames.direct)}`], ["indirect", `Indirect ${count(frames.indirect)}`]],
    keyframes: [["frustum", `Keyframes ${count(map.keyframes)}`]],
    landmarks: [["points", run.landmarks.count < run.landmarks.total
      ? `Landmarks ${count(run.landmarks.count)} of ${count(run.landmarks.total)}` : `Landmarks ${count(run.landmarks.total)}`]],
    loops: [["loop", `Loops ${count(run.loops.length / 6)}`]],
    truth: [["truth", "Ground truth"]],
    errors: [["truth thin", "Error"]],
  };
}

function createLegend(run, scene) {
  const entries = legendEntries(run);
  const isThere = (name) => (name === "trajectory" ? scene.layers.includes("past") : scene.layers.includes(name));
  return el("div", { class: "legend", role: "group", "aria-label": "Layers of the view" },
    ...Object.keys(entries).filter(isThere).map((name) => el("label", {},
      el("input", { type: "checkbox", checked: true, change: (event) => scene.setVisible(name, event.target.checked) }),
      ...entries[name].flatMap(([swatch, text]) => [el("span", { class: `swatch ${swatch}`, "aria-hidden": "true" }), el("span", {}, text)]))));
}

function createToolbar(run, scene) {
  const follow = el("button", { type: "button", "aria-pressed": "false" }, "Follow");
  follow.addEventListener("click", () => {
    const following = follow.getAttribute("aria-pressed") !== "true";
    follow.setAttribute("aria-pressed", String(following));
    scene.setFollowing(following);
  });
  return el("div", { class: "toolbar", role: "group", "aria-label": "View" },
    el("button", { type: "button", click: () => scene.look("home") }, "Reset"),
    el("button", { type: "button", click: () => scene.look("top") }, "Top"), follow);
}

/// A keyframe in the tooltip: its picture and its number.
export function keyframeContent(run, keyframe) {
  const picture = keyframe.frame >= 0 ? run.pictures.nearest(keyframe.frame) : null;
  const where = keyframe.frame >= 0 ? `frame ${run.frames.index[keyframe.frame]}` : "from the loaded map";
  return [
    picture ? el("img", { src: picture.source, alt: "", width: run.stats.source.width, height: run.stats.source.height }) : null,
    `Keyframe ${keyframe.id}, ${where}`,
  ];
}

function watchPointer(canvas, run, { scene, playhead, tooltip }) {
  let hovered = null, pressed = null;
  const at = (event) => scene.pick(event.offsetX, event.offsetY);
  function hover(keyframe, event) {
    if (keyframe !== hovered) scene.mark(hovered = keyframe);
    canvas.classList.toggle("pointing", Boolean(keyframe));
    if (keyframe) tooltip.show(event.clientX, event.clientY, ...keyframeContent(run, keyframe));
    else tooltip.hide();
  }
  canvas.addEventListener("pointermove", (event) => { if (event.buttons === 0) hover(at(event), event); });
  canvas.addEventListener("pointerleave", (event) => hover(null, event));
  canvas.addEventListener("pointerdown", (event) => { pressed = [event.clientX, event.clientY]; });
  canvas.addEventListener("pointerup", (event) => {
    const isClick = pressed && Math.hypot(event.clientX - pressed[0], event.clientY - pressed[1]) < 4;
    const keyframe = isClick ? at(event) : null;
    if (event.pointerType !== "mouse") hover(keyframe, event);
    if (keyframe?.frame >= 0) playhead.seek(keyframe.frame);
  });
}

function gridMetres(cell) {
  return cell < 1 ? `${number(100 * cell)} cm` : `${number(cell)} m`;
}

function message(title, text) {
  return el("div", { class: "message" }, el("strong", {}, title), el("p", {}, text));
}

/// {element, scene}; scene is null when there is nothing to see or no WebGL.
export function createViewer(run, playhead, tooltip) {
  const element = el("section", { class: "card viewer", "aria-label": "The map in 3-D" });
  if (run.landmarks.count === 0 && run.keyframes.length === 0) {
    element.append(message("There is no map.", run.hint ? `Never initialised: ${run.hint}.` : "The map was given up."));
    return { element, scene: null };
  }
  if (!hasWebGl()) {
    element.append(message("This browser shows no 3-D view: it has no WebGL 2.", "The charts and numbers below are all there."));
    return { element, scene: null };
  }
  const canvas = el("canvas", {
    tabindex: 0, role: "application", "aria-roledescription": "3-D view",
    "aria-label": `Map of ${plural(run.keyframes.length, "keyframe")} and ${plural(run.landmarks.count, "landmark")}. Arrow keys turn the view, plus and minus zoom, 0 resets.`,
  });
  element.append(el("div", { class: "stage" }, canvas));
  document.body.append(element); // the scene needs its size
  const scene = createScene(canvas, run);
  element.firstChild.append(createToolbar(run, scene), el("p", { class: "scale" }, `Grid ${run.truth ? gridMetres(scene.gridCell) : `${number(scene.gridCell)} map units`}`));
  element.append(createLegend(run, scene));
  watchPointer(canvas, run, { scene, playhead, tooltip });
  onThemeChange(scene.rebuild);
  playhead.watch(({ frame }) => scene.showFrame(frame));
  return { element, scene };
}
