// The 3-D scene: layers of the run, the frustum at the playhead, hovering over keyframes. Draws when something changed.
import { Color, GridHelper, Group, Scene, Vector3, WebGLRenderer } from "three";
import { readColors } from "../theme.js";
import { createFrustum } from "./current.js";
import { imageCorners } from "./frustum.js";
import { errorLayer, keyframeLayer, landmarkLayer, loopLayer, trajectorySegments, truthLayer } from "./layers.js";
import { segments } from "./lines.js";
import { createEye } from "./orbit.js";
import { measureWorld } from "./world.js";

const MAX_PIXEL_RATIO = 2;
const KEYFRAME_DEPTH = 0.45; // of the step between keyframes, within
const KEYFRAME_LIMITS = [0.012, 0.03]; // of the scene's radius
const CAMERA_DEPTH = 0.12; // of the scene's
const PICK_PX = 18;

/// How deep keyframes are drawn: side by side they must not hide the path, nor be too small to see.
function keyframeDepth({ radius, step }) {
  const [least, most] = KEYFRAME_LIMITS.map((share) => share * radius);
  return Math.min(most, Math.max(least, KEYFRAME_DEPTH * step));
}

export function hasWebGl() {
  return Boolean(document.createElement("canvas").getContext("webgl2"));
}

/// A grid on the floor with cells of 1, 2 or 5 times a power of ten; {object, cell} with the cell in `unit`s.
function floorGrid(world, unit, colors) {
  const wanted = (world.radius * unit) / 4;
  const power = 10 ** Math.floor(Math.log10(wanted));
  const cell = [1, 2, 5].map((digit) => digit * power).filter((size) => size <= wanted).pop();
  const cells = 2 * Math.ceil((1.5 * world.radius * unit) / cell);
  const object = new GridHelper((cells * cell) / unit, cells, colors.grid, colors.grid);
  object.position.set(world.center.x, world.floor, world.center.z);
  return { object, cell };
}

/// The layers by name; those that the run does not have are left out.
function buildLayers(run, world, corners, colors) {
  const path = trajectorySegments(run);
  const pathColors = path.kinds.map((kind) => colors[kind]);
  const layers = {};
  if (run.landmarks.count > 0) layers.landmarks = landmarkLayer(run, world, colors);
  if (path.last.length > 0) {
    layers.past = segments(path.ends, pathColors, { width: 3.5 });
    layers.whole = segments(path.ends, pathColors, { width: 2, opacity: 0.25 });
  }
  if (run.keyframes.length > 0) layers.keyframes = keyframeLayer(run, corners, keyframeDepth(world), colors);
  if (run.loops.length > 0) layers.loops = loopLayer(run, colors);
  if (run.truth?.path.length > 3) layers.truth = truthLayer(run, colors);
  if (run.truth?.position.some(Boolean)) layers.errors = errorLayer(run, colors);
  return { layers, last: path.last };
}

function dispose(object) {
  object.traverse((part) => {
    part.geometry?.dispose();
    part.material?.map?.dispose();
    part.material?.dispose();
  });
}

export function createScene(canvas, run) {
  const renderer = new WebGLRenderer({ canvas, antialias: true, powerPreference: "low-power" });
  renderer.setPixelRatio(Math.min(MAX_PIXEL_RATIO, devicePixelRatio));
  const world = measureWorld(run);
  const corners = imageCorners(run.stats.config.camera);
  const hidden = new Set();
  const scene = new Scene();
  const eye = createEye(canvas, world, draw);
  let content, colors, frame = 0, isDue = false, isFollowing = false;

  function build() {
    if (content) {
      scene.remove(content.map, content.grid.object);
      dispose(content.map);
      dispose(content.grid.object);
    }
    colors = readColors();
    scene.background = new Color(colors.scene);
    const map = new Group();
    map.quaternion.copy(world.rotation);
    const built = buildLayers(run, world, corners, colors);
    const current = createFrustum(corners, CAMERA_DEPTH * world.radius, 2.5, draw);
    const marked = createFrustum(corners, 2.5 * keyframeDepth(world), 2.5, draw);
    map.add(...Object.values(built.layers), current.object, marked.object);
    const grid = floorGrid(world, run.truth?.metersPerUnit ?? 1, colors);
    scene.add(map, grid.object);
    content = { ...built, map, grid, current, marked };
    applyHidden();
    showFrame(frame);
  }

  function draw() {
    if (isDue) return;
    isDue = true;
    requestAnimationFrame(() => {
      isDue = false;
      renderer.render(scene, eye.camera);
    });
  }

  function applyHidden() {
    for (const [name, layer] of Object.entries(content.layers)) {
      layer.visible = !hidden.has(name === "past" || name === "whole" ? "trajectory" : name);
    }
    draw();
  }

  function upright(position) {
    return new Vector3(...position).applyQuaternion(world.rotation);
  }

  function showFrame(next) {
    frame = next;
    const pose = run.poses[frame] ?? null;
    const { current, layers, last } = content;
    current.show(pose, colors[run.kinds[frame]], run.pictures.nearest(frame));
    if (layers.past) {
      let past = last.findIndex((end) => end > frame);
      if (past < 0) past = last.length;
      layers.past.geometry.instanceCount = past;
      layers.past.visible = past > 0 && !hidden.has("trajectory");
    }
    if (isFollowing && pose) eye.follow(upright(pose.position));
    draw();
  }

  function resize() {
    const { clientWidth, clientHeight } = canvas;
    if (clientWidth === 0 || clientHeight === 0) return;
    renderer.setSize(clientWidth, clientHeight, false);
    eye.camera.aspect = clientWidth / clientHeight;
    eye.camera.updateProjectionMatrix();
    draw();
  }

  resize();
  build();
  eye.look("home");
  new ResizeObserver(resize).observe(canvas);

  return {
    layers: Object.keys(content.layers),
    gridCell: content.grid.cell,
    showFrame,
    rebuild: build,
    look: eye.look,
    setVisible(name, visible) {
      if (visible) hidden.delete(name);
      else hidden.add(name);
      applyHidden();
      showFrame(frame);
    },
    setFollowing(following) {
      isFollowing = following;
      if (!following) eye.follow(null);
      showFrame(frame);
    },
    /// Draws a keyframe larger, with its picture; null for none.
    mark(keyframe) {
      const color = keyframe ? colors[run.kinds[keyframe.frame]] ?? colors.indirect : null;
      content.marked.show(keyframe, color, keyframe && run.pictures.nearest(Math.max(0, keyframe.frame)));
      draw();
    },
    /// The keyframe nearest to a point of the canvas (CSS pixels), or null.
    pick(x, y) {
      if (hidden.has("keyframes")) return null;
      let best = null, bestDistance = PICK_PX;
      for (const keyframe of run.keyframes) {
        const p = upright(keyframe.position).project(eye.camera);
        if (p.z > 1) continue;
        const distance = Math.hypot(((p.x + 1) / 2) * canvas.clientWidth - x, ((1 - p.y) / 2) * canvas.clientHeight - y);
        if (distance < bestDistance) [best, bestDistance] = [keyframe, distance];
      }
      return best;
    },
    /// For tests: the matrices of the frustum at the playhead and of the eye.
    matrices() {
      content.current.object.updateWorldMatrix(true, false);
      eye.camera.updateMatrixWorld();
      return { camera: content.current.object.matrixWorld.toArray(), eye: eye.camera.matrixWorld.toArray() };
    },
  };
}
