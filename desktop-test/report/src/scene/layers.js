// What is to be seen of a run: each layer is a three.js object that stands in the map's world.
import { BufferAttribute, BufferGeometry, CanvasTexture, Color, Points, PointsMaterial, Vector3 } from "three";
import { LINES_PER_FRUSTUM, frustumLines } from "./frustum.js";
import { pathEnds, segments } from "./lines.js";

const POINT_PX = 4, SMALL_POINT_PX = 3; // where there are many, each may be smaller
const MANY = 6000;

function disc() {
  const size = 32;
  const canvas = document.createElement("canvas");
  canvas.width = canvas.height = size;
  const context = canvas.getContext("2d");
  context.fillStyle = "#fff";
  context.arc(size / 2, size / 2, size / 2 - 1, 0, 2 * Math.PI);
  context.fill();
  return new CanvasTexture(canvas);
}

/// From the low to the high colour by height, where the map has no colours of its own.
function heightColors(landmarks, world, colors) {
  const low = new Color(colors["point-low"]), high = new Color(colors["point-high"]);
  const values = new Float32Array(3 * landmarks.count);
  for (let i = 0; i < landmarks.count; ++i) {
    const y = new Vector3().fromArray(landmarks.positions, 3 * i).applyQuaternion(world.rotation).y;
    const share = (y - world.heights.low) / (world.heights.high - world.heights.low || 1);
    low.clone().lerp(high, Math.min(1, Math.max(0, share))).toArray(values, 3 * i);
  }
  return values;
}

function linearColors(landmarks) {
  const values = new Float32Array(landmarks.colors);
  const color = new Color();
  for (let i = 0; i < landmarks.count; ++i) {
    color.fromArray(values, 3 * i).convertSRGBToLinear().toArray(values, 3 * i);
  }
  return values;
}

export function landmarkLayer(run, world, colors) {
  const geometry = new BufferGeometry();
  geometry.setAttribute("position", new BufferAttribute(run.landmarks.positions, 3));
  const values = run.landmarks.colors ? linearColors(run.landmarks) : heightColors(run.landmarks, world, colors);
  geometry.setAttribute("color", new BufferAttribute(values, 3));
  const material = new PointsMaterial({
    size: run.landmarks.count > MANY ? SMALL_POINT_PX : POINT_PX, sizeAttenuation: false, vertexColors: true, map: disc(), alphaTest: 0.5,
  });
  const points = new Points(geometry, material);
  points.frustumCulled = false;
  return points;
}

/// Segments between frames that follow each other: {ends, kinds, last} where last[i] is the frame at which segment i ends.
export function trajectorySegments(run) {
  const ends = [], kinds = [], last = [];
  for (let i = 1; i < run.poses.length; ++i) {
    const from = run.poses[i - 1], to = run.poses[i];
    if (!from || !to) continue;
    ends.push(...from.position, ...to.position);
    kinds.push(run.kinds[i]);
    last.push(i);
  }
  return { ends, kinds, last };
}

/// The keyframes' frusta, in the colour of the tracker that placed the frame.
export function keyframeLayer(run, corners, depth, colors) {
  const ends = run.keyframes.flatMap((keyframe) => frustumLines(keyframe, corners, depth));
  const names = run.keyframes.flatMap((keyframe) => {
    const color = colors[run.kinds[keyframe.frame]] ?? colors.indirect;
    return Array(LINES_PER_FRUSTUM).fill(color);
  });
  return segments(ends, names, { width: 1.25, opacity: 0.75 });
}

export function loopLayer(run, colors) {
  return segments(run.loops, colors.loop, { width: 2.5 });
}

export function truthLayer(run, colors) {
  return segments(pathEnds(run.truth.path), colors.truth, { width: 1.75 });
}

/// From each placed frame to where the truth says it was.
export function errorLayer(run, colors) {
  const ends = run.truth.position.flatMap((truth, i) => (truth ? [...run.poses[i].position, ...truth] : []));
  return segments(ends, colors.truth, { width: 1, opacity: 0.7 });
}
