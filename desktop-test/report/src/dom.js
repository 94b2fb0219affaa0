// Elements, built from data only through text nodes and attributes: no text ever becomes markup.

function fill(node, attributes, children) {
  for (const [name, value] of Object.entries(attributes)) {
    if (value === null || value === undefined || value === false) continue;
    if (typeof value === "function") node.addEventListener(name, value);
    else node.setAttribute(name, value === true ? "" : value);
  }
  node.append(...children.flat().filter((child) => child !== null && child !== undefined));
  return node;
}

/// An HTML element. A function among the attributes listens to the event of that name.
export function el(tag, attributes = {}, ...children) {
  return fill(document.createElement(tag), attributes, children);
}

/// An SVG element.
export function svg(tag, attributes = {}, ...children) {
  return fill(document.createElementNS("http://www.w3.org/2000/svg", tag), attributes, children);
}

/// A card of the page: a section with a heading.
export function card(title, attributes, ...children) {
  return el("section", { ...attributes, class: `card ${attributes.class ?? ""}`, "aria-label": title },
    el("h2", {}, title), ...children);
}

/// Moves `focus` among a group's items by arrow keys; only one of them is a tab stop.
export function moveByArrows(event, count, current) {
  const steps = { ArrowLeft: -1, ArrowUp: -1, ArrowRight: 1, ArrowDown: 1 };
  if (event.key in steps) return Math.min(count - 1, Math.max(0, current + steps[event.key]));
  if (event.key === "Home") return 0;
  if (event.key === "End") return count - 1;
  return null;
}
