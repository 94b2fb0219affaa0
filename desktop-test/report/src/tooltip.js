// One tooltip for the page. Its text is told to screen readers by what it belongs to, not here.
import { el } from "./dom.js";

const MARGIN = 12;

export function createTooltip() {
  const box = el("div", { class: "tooltip", role: "tooltip", hidden: true });
  document.body.append(box);
  return {
    box,
    /// Lines of text (or elements), beside a point of the window.
    show(x, y, ...content) {
      box.replaceChildren(...content.filter(Boolean).map((line) =>
        (typeof line === "string" ? el("div", {}, line) : line)));
      box.hidden = false;
      const { width, height } = box.getBoundingClientRect();
      const left = Math.min(x + MARGIN, innerWidth - width - MARGIN);
      const above = y - height - MARGIN;
      box.style.left = `${Math.max(MARGIN, left)}px`;
      box.style.top = `${above > 0 ? above : y + MARGIN}px`;
    },
    hide() { box.hidden = true; },
  };
}
