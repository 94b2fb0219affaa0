// Screenshots beside those that were looked at and kept (desktop-test/golden), compared in Chromium itself: by blocks, since
// another version draws edges and letters a little differently.
import { existsSync, mkdirSync, readFileSync, writeFileSync } from "node:fs";
import { join } from "node:path";

const TOLERANCE = {
  block: 4, // px
  step: 28, // of 255, between the mean colours of a block
  shareOff: 0.0012, // of the blocks may differ by more
};

/// Runs in the page: the share of blocks that differ, and a picture in which they are red.
async function compareInPage(actual, expected, { block, step }) {
  const load = async (base64) => {
    const image = new Image();
    image.src = `data:image/png;base64,${base64}`;
    await image.decode();
    return image;
  };
  const images = [await load(actual), await load(expected)];
  if (images[0].width !== images[1].width || images[0].height !== images[1].height) return { share: 1, diff: null };
  const [width, height] = [Math.ceil(images[0].width / block), Math.ceil(images[0].height / block)];
  const canvas = Object.assign(document.createElement("canvas"), { width: images[0].width, height: images[0].height });
  const context = canvas.getContext("2d", { willReadFrequently: true });
  const means = images.map((image) => {
    context.drawImage(image, 0, 0);
    const { data } = context.getImageData(0, 0, image.width, image.height);
    const sums = new Float64Array(3 * width * height);
    for (let i = 0; i < data.length; i += 4) {
      const x = (i / 4) % image.width, y = Math.floor(i / 4 / image.width);
      const at = 3 * (Math.floor(y / block) * width + Math.floor(x / block));
      for (let c = 0; c < 3; ++c) sums[at + c] += data[i + c] / (block * block);
    }
    return sums;
  });
  let off = 0;
  context.fillStyle = "#f00";
  for (let i = 0; i < width * height; ++i) {
    if ([0, 1, 2].every((c) => Math.abs(means[0][3 * i + c] - means[1][3 * i + c]) <= step)) continue;
    ++off;
    context.fillRect((i % width) * block, Math.floor(i / width) * block, block, block);
  }
  return { share: off / (width * height), diff: canvas.toDataURL().split(",")[1] };
}

/// Nothing, or why the screenshot is not as the golden.
export async function compareWithGolden(page, name, screenshot, { goldens, diffs }) {
  const file = join(goldens, `${name}.png`);
  mkdirSync(diffs, { recursive: true });
  writeFileSync(join(diffs, `${name}.actual.png`), screenshot);
  if (!existsSync(file)) return `there is no ${file}; GLIDE_UPDATE_GOLDENS=1 makes it`;
  const expected = readFileSync(file);
  const texts = [screenshot, expected].map((png) => JSON.stringify(png.toString("base64")));
  const { share, diff } = await page.evaluate(`(${compareInPage})(${texts.join(",")}, ${JSON.stringify(TOLERANCE)})`);
  if (share <= TOLERANCE.shareOff) return null;
  writeFileSync(join(diffs, `${name}.expected.png`), expected);
  if (diff) writeFileSync(join(diffs, `${name}.diff.png`), Buffer.from(diff, "base64"));
  return `${(100 * share).toFixed(2)} % of the picture differ: see ${join(diffs, name)}.*.png`;
}

/// The same; with GLIDE_UPDATE_GOLDENS=1 the screenshot becomes the golden.
export async function golden(page, name, screenshot, folders) {
  if (process.env.GLIDE_UPDATE_GOLDENS !== "1") return compareWithGolden(page, name, screenshot, folders);
  writeFileSync(join(folders.goldens, `${name}.png`), screenshot);
  return null;
}
