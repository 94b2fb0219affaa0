// The colours of style.css for what is not styled by it, and word when they change.

const KINDS = ["direct", "indirect", "lost", "initializing", "paused"];
const NAMES = [...KINDS, "loop", "truth", "scene", "grid", "text", "point-low", "point-high"];

export function readColors() {
  const style = getComputedStyle(document.documentElement);
  return Object.fromEntries(NAMES.map((name) => [name, style.getPropertyValue(`--${name}`).trim()]));
}

export function onThemeChange(listener) {
  matchMedia("(prefers-color-scheme: dark)").addEventListener("change", listener);
}
