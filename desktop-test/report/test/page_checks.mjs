// What is asked of every page, run in it.

/// Texts whose contrast with what is behind them is too low for WCAG 2.1 AA, as "text: ratio".
export function lowContrasts() {
  const LARGE_PX = 24, LARGE = 3, NORMAL = 4.5;
  const channels = (color) => /rgba?\(([^)]*)\)/.exec(color)?.[1].split(/[ ,/]+/).map(Number) ?? [0, 0, 0, 0];
  const luminance = (rgb) => rgb.slice(0, 3)
    .map((c) => (c / 255 <= 0.03928 ? c / 255 / 12.92 : ((c / 255 + 0.055) / 1.055) ** 2.4))
    .reduce((sum, c, i) => sum + c * [0.2126, 0.7152, 0.0722][i], 0);
  const behind = (element) => {
    for (let node = element; node; node = node.parentElement) {
      const rgb = channels(getComputedStyle(node).backgroundColor);
      if (rgb[3] === undefined || rgb[3] > 0.99) return rgb;
    }
    return channels(getComputedStyle(document.documentElement).backgroundColor);
  };
  const faults = new Set();
  const texts = document.createTreeWalker(document.body, NodeFilter.SHOW_TEXT);
  for (let text = texts.nextNode(); text; text = texts.nextNode()) {
    const element = text.parentElement;
    if (!text.data.trim() || !element.checkVisibility() || ["SCRIPT", "STYLE", "NOSCRIPT"].includes(element.tagName)) continue;
    const style = getComputedStyle(element);
    const ink = channels(element instanceof SVGElement ? style.fill : style.color);
    const [high, low] = [luminance(ink), luminance(behind(element))].sort((a, b) => b - a);
    const ratio = (high + 0.05) / (low + 0.05);
    if (ratio < (parseFloat(style.fontSize) >= LARGE_PX ? LARGE : NORMAL)) faults.add(`${text.data.trim().slice(0, 30)}: ${ratio.toFixed(2)}`);
  }
  return [...faults];
}

/// Controls without a name for those who do not see them.
export function namelessControls() {
  const nameOf = (node) => node.getAttribute("aria-label") ?? node.closest("label")?.textContent ?? node.textContent;
  return [...document.querySelectorAll("button, input, select, [tabindex='0'], svg[role=img]")]
    .filter((node) => !nameOf(node).trim()).map((node) => node.outerHTML.slice(0, 80));
}

/// The same text in the page and in the data: what was markup in a name is none in the page.
export function foreignElements() {
  return { alerts: window.alerted ?? 0, bold: document.querySelectorAll("b").length, scripts: document.scripts.length };
}

/// CSS pixels by which the page is wider than the window.
export function overflow() {
  return document.documentElement.scrollWidth - innerWidth;
}
