// How the map stands upright, and where it is. Cameras have x right, y down, z forward; the world
// is the first keyframe's camera, which may be held at any angle: up is what was up on average.
import { Box3, Quaternion, Vector3 } from "three";

// Far landmarks are few, uncertain and without end: the nearest to where the cameras were make the extent.
const NEAR_SHARE = 0.7;
const UP = new Vector3(0, 1, 0);

function meanAxis(poses, x, y, z) {
  const sum = new Vector3();
  for (const pose of poses) sum.add(new Vector3(x, y, z).applyQuaternion(new Quaternion(...pose.q)));
  return sum;
}

/// The landmarks that are nearest to the middle of the path.
function nearest(landmarks, path) {
  const middle = path.reduce((sum, p) => sum.addScaledVector(p, 1 / path.length), new Vector3());
  const byDistance = landmarks.map((p) => [p.distanceTo(middle), p]).sort(([a], [b]) => a - b);
  return byDistance.slice(0, Math.ceil(NEAR_SHARE * byDistance.length)).map(([, p]) => p);
}

/// The rotation that puts the map upright.
function uprightRotation(poses) {
  const up = meanAxis(poses, 0, -1, 0);
  if (up.length() < 0.1 * poses.length || up.length() === 0) up.set(0, -1, 0);
  return new Quaternion().setFromUnitVectors(up.normalize(), UP);
}

/// Half of the keyframes are nearer than this to the one before.
function medianStep(keyframes) {
  const steps = keyframes.slice(1).map(({ position }, k) =>
    Math.hypot(...position.map((x, axis) => x - keyframes[k].position[axis])));
  return steps.sort((a, b) => a - b)[Math.floor(steps.length / 2)] ?? Infinity;
}

/// Of the upright map: rotation, what is to be seen at first (extent, center, radius, floor), step between keyframes,
/// forward (where the cameras look).
export function measureWorld(run) {
  const placed = run.poses.filter(Boolean);
  const poses = placed.length > 0 ? placed : run.keyframes;
  const rotation = uprightRotation(poses);
  const path = poses.map((pose) => new Vector3(...pose.position).applyQuaternion(rotation));
  const landmarks = [];
  for (let i = 0; i < run.landmarks.count; ++i) {
    landmarks.push(new Vector3().fromArray(run.landmarks.positions, 3 * i).applyQuaternion(rotation));
  }
  const extent = [...path, ...nearest(landmarks, path)];
  const box = new Box3().setFromPoints(extent);
  const halfDiagonal = (of) => Math.max(1e-3, 0.5 * of.min.distanceTo(of.max));
  const forward = meanAxis(poses, 0, 0, 1).applyQuaternion(rotation).setY(0);
  if (forward.length() < 1e-6) forward.set(0, 0, -1);
  return {
    rotation,
    extent,
    center: box.getCenter(new Vector3()),
    radius: halfDiagonal(box),
    step: medianStep(run.keyframes),
    floor: box.min.y,
    heights: { low: box.min.y, high: box.max.y },
    forward: forward.normalize(),
  };
}
