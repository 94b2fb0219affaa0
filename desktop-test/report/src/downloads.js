// The files that are in the page.
import { card, el } from "./dom.js";
import { count, plural } from "./format.js";
import { bytesOf } from "./run.js";

function save(name, bytes, type) {
  const url = URL.createObjectURL(new Blob([bytes], { type }));
  const link = el("a", { href: url, download: name });
  link.click();
  setTimeout(() => URL.revokeObjectURL(url), 1000);
}

export function createDownloads(run) {
  const poses = run.poses.filter(Boolean).length;
  const { total } = run.landmarks;
  const shown = run.landmarks.count;
  const points = shown < total ? `${count(shown)} of ${count(total)} landmarks` : plural(total, "landmark");
  const button = (title, detail, click) => el("button", { type: "button", class: "download", click }, el("strong", {}, title), el("span", {}, detail));
  return card("Download", { class: "downloads" },
    el("div", { class: "buttons" },
      button("Trajectory", `TUM text, ${plural(poses, "pose")}`, () => save("trajectory.tum", run.files.trajectory, "text/plain")),
      button("Map", `PLY, ${points}`, () => save("map.ply", bytesOf(run.files.ply), "application/octet-stream")),
      button("Statistics", "JSON", () => save("stats.json", JSON.stringify(run.stats, null, 2), "application/json"))));
}
