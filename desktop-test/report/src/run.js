// The run that the page shows, from the data that glide-replay put into it (docs/report.md).
import { parsePly } from "./ply.js";
import { reasonText } from "./format.js";

export function bytesOf(base64) {
  return Uint8Array.from(atob(base64), (character) => character.charCodeAt(0));
}

function numbers(base64, Type) {
  return new Type(bytesOf(base64).buffer);
}

/// Positions and orientations of the placed frames, from the text of trajectory.tum.
function parseTrajectory(text) {
  const rows = text.split("\n").filter((line) => line && line[0] !== "#");
  return rows.map((line) => {
    const [, x, y, z, ...q] = line.split(" ").map(Number);
    return { position: [x, y, z], q };
  });
}

function decodeFrames(raw) {
  const frames = { count: raw.count };
  for (const key of Object.keys(raw)) {
    if (key.endsWith("_ms") || ["time_s", "visible", "inliers", "rms"].includes(key)) {
      frames[key] = numbers(raw[key], Float32Array);
    }
  }
  frames.index = numbers(raw.index, Uint32Array);
  frames.keyframe = numbers(raw.keyframe, Uint8Array);
  frames.placed = numbers(raw.placed, Uint8Array);
  for (const key of ["state", "tracker", "reason"]) {
    frames[key] = Array.from(numbers(raw[key], Uint8Array), (place) => raw.names[key][place] ?? "?");
  }
  return frames;
}

/// What became of each frame: direct, indirect, lost, initializing or paused.
function kindsOf(frames) {
  return frames.state.map((state, i) => {
    if (state !== "tracking") return state;
    return frames.placed[i] ? frames.tracker[i] : "lost";
  });
}

/// Runs of frames with one fate for one reason: {first, last, kind, reason}.
function segmentsOf(frames, kinds) {
  const segments = [];
  for (let i = 0; i < frames.count; ++i) {
    const last = segments[segments.length - 1];
    const givenUp = frames.state[i] === "tracking" && !frames.placed[i];
    const reason = givenUp ? "tracked in a map that was given up later"
      : kinds[i] === "direct" || kinds[i] === "initializing" ? "" : reasonText(frames.reason[i]);
    if (last && last.kind === kinds[i] && last.reason === reason) last.last = i;
    else segments.push({ first: i, last: i, kind: kinds[i], reason });
  }
  return segments;
}

/// For every frame its pose in the trajectory, or null.
function posesOf(frames, trajectory) {
  let next = 0;
  return Array.from(frames.placed, (placed) => (placed ? trajectory[next++] ?? null : null));
}

function decodeKeyframes(raw) {
  const pose = numbers(raw.pose, Float32Array);
  const id = numbers(raw.id, Uint32Array);
  const frame = numbers(raw.frame, Int32Array);
  return Array.from(id, (_, k) => ({
    id: id[k],
    frame: frame[k],
    position: Array.from(pose.subarray(7 * k, 7 * k + 3)),
    q: Array.from(pose.subarray(7 * k + 3, 7 * k + 7)),
  }));
}

/// The truth's path, and per frame its position and how far off the frame is in metres.
function decodeTruth(raw, poses) {
  if (!raw) return null;
  const matched = numbers(raw.matched, Float32Array);
  let next = 0;
  const position = poses.map((pose) => {
    if (!pose) return null;
    const p = Array.from(matched.subarray(3 * next, 3 * next + 3));
    ++next;
    return Number.isNaN(p[0]) ? null : p;
  });
  const error = position.map((p, i) => {
    if (!p) return NaN;
    return raw.meters_per_unit * Math.hypot(...p.map((x, axis) => x - poses[i].position[axis]));
  });
  return { path: numbers(raw.path, Float32Array), position, error, metersPerUnit: raw.meters_per_unit };
}

/// Pictures by frame; nearest(frame) is the last one at or before the frame, else the first.
function decodePictures(raw) {
  const frame = numbers(raw.frame, Uint32Array);
  const sources = raw.jpeg.map((jpeg) => `data:image/jpeg;base64,${jpeg}`);
  const nearest = (wanted) => {
    if (frame.length === 0) return null;
    let low = 0;
    for (let high = frame.length; high - low > 1;) {
      const middle = (low + high) >> 1;
      if (frame[middle] <= wanted) low = middle;
      else high = middle;
    }
    return { frame: frame[low], source: sources[low] };
  };
  return { count: frame.length, nearest };
}

/// Everything the page needs, decoded once.
export function decodeRun(data) {
  const frames = decodeFrames(data.frames);
  const kinds = kindsOf(frames);
  const poses = posesOf(frames, parseTrajectory(data.trajectory));
  return {
    name: data.name,
    hint: data.hint,
    skips: data.skips,
    stats: data.stats,
    frames,
    kinds,
    segments: segmentsOf(frames, kinds),
    poses,
    truth: decodeTruth(data.truth, poses),
    keyframes: decodeKeyframes(data.keyframes),
    loops: numbers(data.loops, Float32Array),
    landmarks: { ...parsePly(bytesOf(data.map.ply)), total: data.map.landmarks },
    pictures: decodePictures(data.pictures),
    files: { trajectory: data.trajectory, ply: data.map.ply },
  };
}
