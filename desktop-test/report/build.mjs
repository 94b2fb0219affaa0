// node build.mjs CACHE OUTPUT: the page of report.html, all in one file but for the run's data.
// npm's packages are installed into CACHE when package-lock.json has changed.
import { execFileSync } from "node:child_process";
import { copyFileSync, existsSync, mkdirSync, readFileSync, writeFileSync } from "node:fs";
import { createRequire } from "node:module";
import { dirname, join, resolve } from "node:path";
import { fileURLToPath } from "node:url";

const here = dirname(fileURLToPath(import.meta.url));
const cache = resolve(process.argv[2]);
const output = resolve(process.argv[3]);

function installPackages() {
  const lock = readFileSync(join(here, "package-lock.json"), "utf8");
  const stamp = join(cache, "installed.json");
  if (existsSync(stamp) && readFileSync(stamp, "utf8") === lock) return;
  mkdirSync(cache, { recursive: true });
  for (const file of ["package.json", "package-lock.json"]) copyFileSync(join(here, file), join(cache, file));
  const options = ["--ignore-scripts", "--no-audit", "--no-fund", "--cache", join(cache, "npm")];
  execFileSync("npm", ["ci", ...options], { cwd: cache, stdio: "inherit" });
  writeFileSync(stamp, lock);
}

function bundle() {
  const esbuild = createRequire(join(cache, "package.json"))("esbuild");
  const built = esbuild.buildSync({
    entryPoints: [join(here, "src/main.js")],
    bundle: true,
    minify: true,
    write: false,
    format: "iife",
    target: ["es2020"],
    nodePaths: [join(cache, "node_modules")],
    legalComments: "inline",
  });
  return built.outputFiles[0].text;
}

function style() {
  const esbuild = createRequire(join(cache, "package.json"))("esbuild");
  return esbuild.transformSync(readFileSync(join(here, "style.css"), "utf8"), { loader: "css", minify: true }).code;
}

installPackages();
const parts = { STYLE: style(), SCRIPT: bundle() };
const template = readFileSync(join(here, "template.html"), "utf8");
// In one pass: what stands in a part is no mark.
writeFileSync(output, template.replace(/\{\{(STYLE|SCRIPT)\}\}/g, (_, name) => parts[name]));
