// SPDX-License-Identifier: Apache-2.0
// Bundles the viewer into one script: node build.mjs OUTPUT. The licences of the packages that went into it stand at its
// head, since every report.html carries them away. OUTPUT.inputs.json lists its files for packaging/papers.py.
import { readFileSync, readdirSync, writeFileSync } from "node:fs";
import { build } from "esbuild";

const output = process.argv[2];
const { metafile, outputFiles } = await build({
  entryPoints: [new URL("src/main.js", import.meta.url).pathname],
  outfile: output,
  bundle: true,
  minify: true,
  format: "iife",
  target: "es2022",
  charset: "ascii",
  loader: { ".css": "text" },
  legalComments: "inline",
  logLevel: "warning",
  metafile: true,
  write: false,
});
const inputs = Object.keys(Object.values(metafile.outputs)[0].inputs);
const packages = new Set(inputs.map((path) => path.match(/node_modules\/((?:@[^/]+\/)?[^/]+)\//)?.[1]).filter(Boolean));
const licences = [...packages].sort().map((name) => {
  const folder = new URL(`node_modules/${name}/`, import.meta.url);
  const file = readdirSync(folder).find((each) => /^licen[cs]e/i.test(each));
  const { version } = JSON.parse(readFileSync(new URL("package.json", folder), "utf8"));
  return `/*! ${name} ${version}\n${readFileSync(new URL(file, folder), "utf8").trim()} */\n`;
});
writeFileSync(output, licences.join("").replaceAll("\u00a9", "(c)") + outputFiles[0].text);
writeFileSync(`${output}.inputs.json`, JSON.stringify(inputs, null, 1));
