// Camera frusta as wire frames.
import { Quaternion, Vector3 } from "three";

const MAX_SLOPE = 1.2; // of a corner's ray: wide lenses are drawn narrower than they are

/// The corners of the image at distance 1, clockwise from the upper left, from the calibration.
export function imageCorners(camera) {
  const { width, height, fx, fy, cx, cy } = camera;
  const clamp = (slope) => Math.min(MAX_SLOPE, Math.max(-MAX_SLOPE, slope));
  const left = clamp((-0.5 - cx) / fx), right = clamp((width - 0.5 - cx) / fx);
  const top = clamp((-0.5 - cy) / fy), bottom = clamp((height - 0.5 - cy) / fy);
  return [[left, top], [right, top], [right, bottom], [left, bottom]].map(([x, y]) => new Vector3(x, y, 1));
}

/// End points of the lines of one frustum of this depth, x y z after x y z, in the map's world.
export function frustumLines(pose, corners, depth) {
  const rotation = new Quaternion(...pose.q);
  const apex = new Vector3(...pose.position);
  const ends = corners.map((corner) => corner.clone().multiplyScalar(depth).applyQuaternion(rotation).add(apex));
  const lines = [];
  ends.forEach((end, i) => lines.push(...apex.toArray(), ...end.toArray(), ...end.toArray(), ...ends[(i + 1) % 4].toArray()));
  return lines;
}

export const LINES_PER_FRUSTUM = 8;
