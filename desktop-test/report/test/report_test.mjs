// node --test report_test.mjs: the samples' reports in headless Chromium. Set by CMake:
// GLIDE_REPORT_SAMPLES (a folder with the samples), GLIDE_GOLDENS, GLIDE_DIFFS.
import assert from "node:assert/strict";
import { mkdtempSync, readFileSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { after, before, test } from "node:test";
import { pathToFileURL } from "node:url";
import { findChromium, openPage, startChromium } from "./chromium.mjs";
import { compareWithGolden, golden } from "./golden.mjs";
import { foreignElements, lowContrasts, namelessControls, overflow } from "./page_checks.mjs";

const samples = process.env.GLIDE_REPORT_SAMPLES;
const folders = { goldens: process.env.GLIDE_GOLDENS, diffs: process.env.GLIDE_DIFFS };
const DESKTOP = { width: 1280, height: 800 }, PHONE = { width: 390, height: 844 };
const NAMES = ["tour", "without_map", "given_up", "without_frames"];
const FRAME = 195; // of the tour: in a stretch of indirect frames
let browser;
let shared; // the tour at the desktop's size, for tests that need no fresh page

before(async () => {
  browser = await startChromium(findChromium());
  shared = await open("tour", DESKTOP);
});
after(() => browser.stop());

async function open(name, options) {
  const before_ = `window.alert = () => { window.alerted = (window.alerted ?? 0) + 1; };\n${options.before ?? ""}`;
  const page = await openPage(browser, pathToFileURL(join(samples, `${name}.html`)).href, { ...options, before: before_ });
  return page;
}

async function finish(page) {
  assert.deepEqual(page.complaints, []);
  const foreign = page.requests.filter((url) => !/^(data|blob):/.test(url) && !url.startsWith(pathToFileURL(samples).href));
  assert.deepEqual(foreign, [], "the page asks the network for something");
  await page.close();
}

const ask = (page, check) => page.evaluate(`(${check})()`);
const seek = (page, frame) => page.evaluate(`glideReport.playhead.seek(${frame})`);
const frameOf = (page) => page.evaluate("glideReport.playhead.state.frame");
const matrices = (page) => page.evaluate("glideReport.scene.matrices()");
const textOf = (page, selector) => page.evaluate(`document.querySelector(${JSON.stringify(selector)}).textContent`);
/// Presses Tab until an element that matches has the focus.
async function tabTo(page, selector) {
  for (let i = 0; i < 40; ++i) {
    await page.press("Tab");
    if (await page.evaluate(`document.activeElement.matches(${JSON.stringify(selector)})`)) return;
  }
  assert.fail(`no Tab reaches ${selector}`);
}
async function looksAsGolden(page, name, clip) {
  assert.equal(await golden(page, name, await page.screenshot(clip), folders), null);
}
const boxOf = (page, selector) => page.evaluate(`(() => {
  const { x, y, width, height } = document.querySelector(${JSON.stringify(selector)}).getBoundingClientRect();
  return { x: x + scrollX, y: y + scrollY, width, height };
})()`);

test("every sample opens without a complaint, legible, named and no wider than the window", async () => {
  for (const name of NAMES) {
    const page = await open(name, DESKTOP);
    for (const dark of [false, true]) {
      await page.setDark(dark);
      assert.deepEqual(await ask(page, lowContrasts), [], name);
    }
    assert.deepEqual(await ask(page, namelessControls), [], name);
    for (const size of [DESKTOP, PHONE]) {
      await page.resize(size);
      assert.equal(await ask(page, overflow), 0, name);
    }
    await finish(page);
  }
});

test("names from outside stay text", async () => {
  const page = shared;
  assert.equal(await textOf(page, "h1"), '</script><script>alert("tour")</script>');
  assert.deepEqual(await ask(page, foreignElements), { alerts: 0, bold: 0, scripts: 2 });
});

test("looks as it did when it was looked at", async () => {
  for (const [suffix, options] of [["1280", DESKTOP], ["1280_dark", { ...DESKTOP, dark: true }], ["390", PHONE]]) {
    const page = await open("tour", options);
    await seek(page, FRAME);
    await looksAsGolden(page, `report_${suffix}`);
    if (!options.dark) await looksAsGolden(page, `report_charts_${suffix}`, await boxOf(page, ".charts"));
    await finish(page);
  }
});

test("a screenshot without the trajectory, or of another frame, is told from the golden", async () => {
  const page = shared;
  await seek(page, FRAME);
  await page.evaluate("glideReport.scene.setVisible('trajectory', false)");
  const apart = { ...folders, diffs: join(folders.diffs, "report_must_differ") };
  assert.match(await compareWithGolden(page, "report_1280", await page.screenshot(), apart), /differ/);
  await page.evaluate("glideReport.scene.setVisible('trajectory', true)");
  await seek(page, FRAME - 60);
  assert.match(await compareWithGolden(page, "report_1280", await page.screenshot(), apart), /differ/);
});

test("the slider moves the camera in the scene, the picture and the readout", async () => {
  const page = await open("tour", DESKTOP);
  const stage = await boxOf(page, ".stage");
  await tabTo(page, ".slider");
  const last = await frameOf(page);
  const [there, image, picture] = [await matrices(page), await page.screenshot(stage), await page.evaluate("document.querySelector('.frame img').src")];
  await page.press("Home");
  await page.press("ArrowRight");
  assert.equal(await frameOf(page), 1);
  await seek(page, FRAME);
  const here = await matrices(page);
  assert.notDeepEqual(here.camera, there.camera);
  assert.deepEqual(here.eye, there.eye);
  assert.notDeepEqual(await page.screenshot(stage), image);
  assert.notEqual(await page.evaluate("document.querySelector('.frame img').src"), picture);
  assert.match(await textOf(page, ".frame"), /Indirect.*Too few reference points in view.*238 of 292 agree/i);
  await page.press("End");
  assert.equal(await frameOf(page), last);
  assert.deepEqual((await matrices(page)).camera, there.camera);
  await finish(page);
});

test("keys go through the strip, the keyframes and around the map", async () => {
  const page = await open("tour", DESKTOP);
  await tabTo(page, "canvas");
  const before_ = await matrices(page);
  await page.press("ArrowLeft");
  assert.notDeepEqual((await matrices(page)).eye, before_.eye);
  await page.press("0");
  await tabTo(page, ".strip");
  await page.press("Home");
  assert.match(await textOf(page, "#segment-text"), /Initialising/);
  await page.press("ArrowRight");
  assert.match(await textOf(page, "#segment-text"), /Indirect, too few reference points in view, frame 14, /);
  await page.press("Enter");
  assert.equal(await frameOf(page), 14);
  assert.match(await textOf(page, ".tooltip"), /too few reference points/);
  await tabTo(page, ".filmstrip button");
  await page.press("ArrowRight");
  await page.press("Enter");
  assert.equal(await frameOf(page), 18);
  await finish(page);
});

test("pointing at a keyframe shows its picture", async () => {
  const page = shared;
  await page.evaluate("scrollTo(0, 0)");
  const [x, y] = await page.evaluate(`(() => {
    const { left, top, width, height } = document.querySelector("canvas").getBoundingClientRect();
    for (let v = 0; v < height; v += 5) for (let u = 0; u < width; u += 5) {
      if (glideReport.scene.pick(u, v)) return [left + u, top + v];
    }
  })()`);
  await page.move(x, y);
  await page.settle();
  assert.match(await textOf(page, ".tooltip"), /^Keyframe \d+, frame \d+$/);
  assert.ok(await page.evaluate("document.querySelector('.tooltip img').naturalWidth") > 100);
});

test("playing goes on by the timestamps and ends at the last frame", async () => {
  const page = shared;
  const last = await page.evaluate("glideReport.run.frames.count - 1");
  await seek(page, last - 6);
  await page.evaluate("document.querySelector('.play').click()");
  const ended = await page.evaluate(`(async () => {
    const { state } = glideReport.playhead;
    const begin = performance.now();
    while (state.playing && performance.now() - begin < 5000) await new Promise(requestAnimationFrame);
    return { frame: state.frame, playing: state.playing, ms: performance.now() - begin };
  })()`);
  assert.deepEqual([ended.frame, ended.playing], [last, false]);
  assert.ok(ended.ms > 200, `six frames of 50 ms took ${ended.ms} ms`);
});

test("the downloads are the files", async () => {
  const folder = mkdtempSync(join(tmpdir(), "glide-downloads-"));
  const page = shared;
  await browser.send("Browser.setDownloadBehavior", { behavior: "allow", downloadPath: folder, eventsEnabled: true });
  for (const [button, name, original] of [[1, "trajectory.tum", "tour.tum"], [2, "map.ply", "tour.ply"], [3, "stats.json", null]]) {
    const done = new Promise((resolve) => browser.listen(({ method, params }) => {
      if (method === "Browser.downloadProgress" && params.state !== "inProgress") resolve(params.state);
    }));
    await page.evaluate(`document.querySelector(".download:nth-child(${button})").click()`);
    assert.equal(await done, "completed");
    const bytes = readFileSync(join(folder, name));
    if (original) assert.ok(bytes.equals(readFileSync(join(samples, original))), `${name} is not as it was written`);
    else assert.equal(JSON.parse(bytes).frames.dropped, 6);
  }
  rmSync(folder, { recursive: true });
});

test("a run without a map says why, one without frames that there are none", async () => {
  const never = await open("without_map", DESKTOP);
  assert.match(await textOf(never, ".viewer"), /Never initialised: the camera turned but did not move/);
  await finish(never);
  const givenUp = await open("given_up", DESKTOP);
  assert.match(await textOf(givenUp, ".viewer"), /The map was given up/);
  await finish(givenUp);
  const empty = await open("without_frames", DESKTOP);
  assert.match(await textOf(empty, "main"), /No frame could be read/);
  await finish(empty);
});

test("without WebGL the page says so and shows the rest", async () => {
  const page = await open("tour", {
    ...DESKTOP,
    before: `const get = HTMLCanvasElement.prototype.getContext;
      HTMLCanvasElement.prototype.getContext = function (kind, ...rest) { return /webgl/.test(kind) ? null : get.call(this, kind, ...rest); };`,
  });
  assert.match(await textOf(page, ".viewer"), /no WebGL 2/);
  assert.equal(await page.evaluate("document.querySelectorAll('.chart path').length > 8"), true);
  await seek(page, FRAME);
  assert.match(await textOf(page, ".frame"), /Indirect/);
  await finish(page);
});

test("the colours change with the system's", async () => {
  const page = shared;
  const stage = await boxOf(page, ".stage");
  const light = await page.screenshot(stage);
  await page.setDark(true);
  const dark = await page.screenshot(stage);
  await page.setDark(false);
  assert.notDeepEqual(light, dark);
});

test("nothing of this made the shared page complain", () => finish(shared));
