// Where the eye must be to see some points from a given side, as large as they can be.
import { Vector3 } from "three";

const AIR = 1.08; // around the points
const ROUNDS = 4; // of centring: each changes what is nearest

/// The points in the eye's axes: x to the right, y up, z towards the eye.
function inAxes(points, from, up) {
  const across = new Vector3().crossVectors(up, from).normalize();
  const upward = new Vector3().crossVectors(from, across);
  return { across, upward, seen: points.map((p) => [p.dot(across), p.dot(upward), p.dot(from)]) };
}

/// What to look at and from how far, in the direction `from` of what is looked at.
export function fitView(points, from, camera) {
  const { across, upward, seen } = inAxes(points, from, camera.up);
  const slopeY = Math.tan((camera.fov * Math.PI) / 360), slopeX = slopeY * camera.aspect;
  const z = seen.reduce((sum, p) => sum + p[2], 0) / seen.length;
  let x = 0, y = 0, distance = 1;
  for (let round = 0; round < ROUNDS; ++round) {
    distance = seen.reduce((most, p) =>
      Math.max(most, p[2] - z + AIR * Math.max(Math.abs(p[0] - x) / slopeX, Math.abs(p[1] - y) / slopeY)), 1e-3);
    const range = [Infinity, -Infinity, Infinity, -Infinity];
    for (const p of seen) {
      const depth = distance - (p[2] - z);
      const [left, down] = [(p[0] - x) / depth, (p[1] - y) / depth];
      range[0] = Math.min(range[0], left);
      range[1] = Math.max(range[1], left);
      range[2] = Math.min(range[2], down);
      range[3] = Math.max(range[3], down);
    }
    x += (distance * (range[0] + range[1])) / 2;
    y += (distance * (range[2] + range[3])) / 2;
  }
  const target = new Vector3().addScaledVector(across, x).addScaledVector(upward, y).addScaledVector(from, z);
  return { target, distance };
}
