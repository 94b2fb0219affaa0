// Lines of constant width on the screen.
import { Color } from "three";
import { LineMaterial } from "three/addons/lines/LineMaterial.js";
import { LineSegments2 } from "three/addons/lines/LineSegments2.js";
import { LineSegmentsGeometry } from "three/addons/lines/LineSegmentsGeometry.js";

/// Segments from end points (x y z after x y z). `color` is one colour, or one per segment.
export function segments(ends, color, { width, opacity = 1 }) {
  const geometry = new LineSegmentsGeometry();
  geometry.setPositions(ends);
  const perSegment = Array.isArray(color);
  const material = new LineMaterial({
    linewidth: width,
    vertexColors: perSegment,
    transparent: opacity < 1,
    opacity,
    depthWrite: opacity === 1,
  });
  if (perSegment) {
    geometry.setColors(color.flatMap((name) => {
      const { r, g, b } = new Color(name);
      return [r, g, b, r, g, b];
    }));
  } else {
    material.color.set(color);
  }
  const lines = new LineSegments2(geometry, material);
  lines.frustumCulled = false;
  return lines;
}

/// The end points of a path's segments.
export function pathEnds(points) {
  const ends = [];
  for (let i = 0; i + 5 < points.length; i += 3) ends.push(...points.subarray(i, i + 6));
  return ends;
}
