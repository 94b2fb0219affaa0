// Numbers and names as people read them.

const REASONS = {
  none: "",
  no_reference: "no reference to track against",
  solve_failed: "the alignment could not be solved",
  too_few_visible: "too few reference points in view",
  photometric_error: "photometric error above its threshold",
  baseline: "moved too far from the reference",
  rotation: "turned too far from the reference",
  max_direct_frames: "the reference had served its number of frames",
  disabled: "the direct tracker is switched off",
};

/// Why the direct tracker did not place a frame.
export function reasonText(name) {
  return REASONS[name] ?? name.replaceAll("_", " ");
}

export function count(value) {
  return Math.round(value).toString().replace(/\B(?=(\d{3})+$)/g, "\u202f");
}

/// Three significant digits, as far as they are decimals.
export function number(value) {
  if (!Number.isFinite(value)) return "\u2013";
  if (Math.abs(value - Math.round(value)) <= 1e-9 * Math.abs(value)) return count(value);
  const size = Math.abs(value);
  if (size >= 100) return value.toFixed(0);
  if (size >= 10) return value.toFixed(1);
  if (size >= 0.001 || size === 0) return value.toFixed(size >= 1 ? 2 : 3);
  return value.toExponential(2);
}

export function milliseconds(value) {
  return Number.isFinite(value) ? `${value >= 100 ? value.toFixed(0) : value.toFixed(value >= 10 ? 1 : 2)} ms` : "\u2013";
}

/// Metres in the unit that leaves a number of one to three digits.
export function metres(value) {
  if (!Number.isFinite(value)) return "\u2013";
  if (value < 0.01) return `${(1000 * value).toFixed(1)} mm`;
  if (value < 1) return `${(100 * value).toFixed(1)} cm`;
  return `${value.toFixed(2)} m`;
}

export function percent(share) {
  return Number.isFinite(share) ? `${(100 * share).toFixed(share >= 1 ? 0 : 1)}\u202f%` : "\u2013";
}

export function seconds(value) {
  return `${value.toFixed(2)} s`;
}

export function plural(value, noun) {
  return `${count(value)} ${noun}${value === 1 ? "" : "s"}`;
}
