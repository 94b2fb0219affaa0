// Chromium without a window, spoken to in its DevTools protocol over a pipe.
import { spawn } from "node:child_process";
import { existsSync, mkdtempSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";

const PROGRAMS = ["chromium", "chromium-browser", "google-chrome"];
const FLAGS = [
  "--headless", "--no-sandbox", "--remote-debugging-pipe", "--use-angle=swiftshader", "--enable-unsafe-swiftshader",
  "--hide-scrollbars", "--force-color-profile=srgb", "--font-render-hinting=none", "--disable-lcd-text",
  "--disable-background-networking", "--disable-component-update", "--no-first-run", "--mute-audio",
];

/// The program's path, or null.
export function findChromium() {
  const folders = (process.env.PATH ?? "").split(":");
  const paths = PROGRAMS.flatMap((program) => folders.map((folder) => join(folder, program)));
  return paths.find((path) => existsSync(path)) ?? null;
}

/// Messages of JSON with a zero byte behind each, as the protocol has it on a pipe.
function readMessages(stream, onMessage) {
  let rest = Buffer.alloc(0);
  stream.on("data", (data) => {
    rest = Buffer.concat([rest, data]);
    for (let end = rest.indexOf(0); end >= 0; end = rest.indexOf(0)) {
      onMessage(JSON.parse(rest.subarray(0, end).toString("utf8")));
      rest = rest.subarray(end + 1);
    }
  });
}

export async function startChromium(program) {
  const profile = mkdtempSync(join(tmpdir(), "glide-chromium-"));
  const child = spawn(program, [...FLAGS, `--user-data-dir=${profile}`, "about:blank"], {
    stdio: ["ignore", "ignore", "ignore", "pipe", "pipe"],
    env: { ...process.env, HOME: profile },
  });
  const waiting = new Map(), listeners = new Set();
  let next = 1;
  readMessages(child.stdio[4], (message) => {
    const call = waiting.get(message.id);
    if (!call) {
      listeners.forEach((listener) => listener(message));
      return;
    }
    waiting.delete(message.id);
    if (message.error) call.reject(new Error(`${call.method}: ${message.error.message}`));
    else call.resolve(message.result);
  });
  const ended = new Promise((resolve) => child.once("exit", resolve));
  ended.then((code) => waiting.forEach(({ reject }) => reject(new Error(`Chromium ended with ${code}`))));

  const send = (method, params = {}, sessionId = undefined) => new Promise((resolve, reject) => {
    const id = next++;
    waiting.set(id, { method, resolve, reject });
    child.stdio[3].write(`${JSON.stringify({ id, method, params, sessionId })}\0`);
  });
  return {
    send,
    listen: (listener) => listeners.add(listener),
    async stop() {
      await send("Browser.close").catch(() => {});
      await ended;
      rmSync(profile, { recursive: true, force: true, maxRetries: 5 });
    },
  };
}

/// A page of its own, loaded and drawn.
export async function openPage(browser, url, { width, height, dark = false, before = null }) {
  const { targetId } = await browser.send("Target.createTarget", { url: "about:blank" });
  const { sessionId } = await browser.send("Target.attachToTarget", { targetId, flatten: true });
  const send = (method, params) => browser.send(method, params, sessionId);
  const complaints = [], requests = [];
  let loaded;
  const isLoaded = new Promise((resolve) => { loaded = resolve; });
  browser.listen((message) => {
    if (message.sessionId !== sessionId) return;
    const { method, params } = message;
    if (method === "Page.loadEventFired") loaded();
    if (method === "Network.requestWillBeSent") requests.push(params.request.url);
    if (method === "Runtime.exceptionThrown") complaints.push(params.exceptionDetails.exception?.description ?? params.exceptionDetails.text);
    if (method === "Runtime.consoleAPICalled") complaints.push(params.args.map((arg) => arg.value ?? arg.description).join(" "));
    if (method === "Log.entryAdded") complaints.push(params.entry.text);
  });
  for (const domain of ["Page", "Runtime", "Log", "Network"]) await send(`${domain}.enable`);
  const resize = (size) => send("Emulation.setDeviceMetricsOverride", { ...size, deviceScaleFactor: 1, mobile: false });
  const setDark = (is) => send("Emulation.setEmulatedMedia", { features: [{ name: "prefers-color-scheme", value: is ? "dark" : "light" }] });
  await resize({ width, height });
  await setDark(dark);
  if (before) await send("Page.addScriptToEvaluateOnNewDocument", { source: before });
  await send("Page.navigate", { url });
  await isLoaded;

  async function evaluate(expression) {
    const { result, exceptionDetails } = await send("Runtime.evaluate", { expression, awaitPromise: true, returnByValue: true });
    if (exceptionDetails) throw new Error(exceptionDetails.exception?.description ?? exceptionDetails.text);
    return result.value;
  }
  /// Until pictures are decoded and what is due is drawn.
  const settle = () => evaluate(`(async () => {
    await Promise.all([...document.images].filter(({ loading }) => loading !== "lazy").map((image) => image.decode().catch(() => {})));
    for (let i = 0; i < 4; ++i) await new Promise(requestAnimationFrame);
  })()`);
  await settle();
  return {
    send, evaluate, settle, resize, setDark, complaints, requests,
    async screenshot(clip) {
      await settle();
      const { data } = await send("Page.captureScreenshot", clip ? { clip: { ...clip, scale: 1 }, captureBeyondViewport: true } : {});
      return Buffer.from(data, "base64");
    },
    async press(key, code = key, modifiers = 0) {
      const text = key === "Enter" ? "\r" : key.length === 1 ? key : undefined;
      const keyCode = { Tab: 9, Enter: 13, Escape: 27, " ": 32, End: 35, Home: 36, ArrowLeft: 37, ArrowUp: 38, ArrowRight: 39, ArrowDown: 40 }[key];
      await send("Input.dispatchKeyEvent", { type: text ? "keyDown" : "rawKeyDown", key, code, text, modifiers, windowsVirtualKeyCode: keyCode });
      await send("Input.dispatchKeyEvent", { type: "keyUp", key, code, modifiers, windowsVirtualKeyCode: keyCode });
    },
    move: (x, y) => send("Input.dispatchMouseEvent", { type: "mouseMoved", x, y }),
    close: () => browser.send("Target.closeTarget", { targetId }),
  };
}
