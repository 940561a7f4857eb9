// SPDX-License-Identifier: Apache-2.0
// Bundles the viewer into one script: node build.mjs OUTPUT. OUTPUT.inputs.json lists the files that went into it, from which
// packaging/papers.py knows whose licences go with the program.
import { writeFileSync } from "node:fs";
import { build } from "esbuild";

const { metafile } = await build({
  entryPoints: [new URL("src/main.js", import.meta.url).pathname],
  outfile: process.argv[2],
  bundle: true,
  minify: true,
  format: "iife",
  target: "es2022",
  charset: "ascii",
  loader: { ".css": "text" },
  legalComments: "inline",
  logLevel: "warning",
  metafile: true,
});
const [{ inputs }] = Object.values(metafile.outputs);
writeFileSync(`${process.argv[2]}.inputs.json`, JSON.stringify(Object.keys(inputs), null, 1));
