// SPDX-License-Identifier: Apache-2.0
// Bundles the viewer into one script: node build.mjs OUTPUT
import { build } from "esbuild";

await build({
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
});
