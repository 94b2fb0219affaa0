// How the map stands upright, and where it is. Cameras have x right, y down, z forward; the world
// is the first keyframe's camera, which may be held at any angle: up is what was up on average.
import { Quaternion, Vector3 } from "three";

const OUTLIERS = 0.02; // share of landmarks beyond either end that do not count for the extent
const UP = new Vector3(0, 1, 0);

function meanAxis(poses, x, y, z) {
  const sum = new Vector3();
  for (const pose of poses) sum.add(new Vector3(x, y, z).applyQuaternion(new Quaternion(...pose.q)));
  return sum;
}

function quantiles(values) {
  if (values.length === 0) return null;
  values.sort((a, b) => a - b);
  const at = (share) => values[Math.floor(share * (values.length - 1))];
  return { low: at(OUTLIERS), high: at(1 - OUTLIERS) };
}

/// The rotation that puts the map upright.
function uprightRotation(poses) {
  const up = meanAxis(poses, 0, -1, 0);
  if (up.length() < 0.1 * poses.length || up.length() === 0) up.set(0, -1, 0);
  return new Quaternion().setFromUnitVectors(up.normalize(), UP);
}

/// {rotation, center, radius, floor, forward} of the upright map; forward is where the cameras look.
export function measureWorld(run) {
  const placed = run.poses.filter(Boolean);
  const poses = placed.length > 0 ? placed : run.keyframes;
  const rotation = uprightRotation(poses);
  const points = poses.map((pose) => new Vector3(...pose.position).applyQuaternion(rotation));
  const landmarks = [];
  for (let i = 0; i < run.landmarks.count; ++i) {
    landmarks.push(new Vector3().fromArray(run.landmarks.positions, 3 * i).applyQuaternion(rotation));
  }
  const low = new Vector3(), high = new Vector3();
  for (const axis of ["x", "y", "z"]) {
    const path = points.map((p) => p[axis]);
    const spread = quantiles(landmarks.map((p) => p[axis])) ?? { low: Infinity, high: -Infinity };
    low[axis] = Math.min(spread.low, ...path);
    high[axis] = Math.max(spread.high, ...path);
    if (!(low[axis] <= high[axis])) [low[axis], high[axis]] = [-1, 1];
  }
  const forward = meanAxis(poses, 0, 0, 1).applyQuaternion(rotation).setY(0);
  if (forward.length() < 1e-6) forward.set(0, 0, -1);
  return {
    rotation,
    center: low.clone().add(high).multiplyScalar(0.5),
    radius: Math.max(1e-3, 0.5 * low.distanceTo(high)),
    floor: low.y,
    forward: forward.normalize(),
    heights: { low: low.y, high: high.y },
  };
}
