// SPDX-License-Identifier: Apache-2.0

/** Rows of welds.csv as objects with what the view needs. */
export function readWelds(table, shape) {
  const partIndex = new Map(shape?.parts.map((part, i) => [String(part.id), i]) ?? []);
  return (table?.rows ?? []).map((row) => {
    const cells = Object.fromEntries(table.columns.map((name, i) => [name, row[i] ?? ""]));
    const nodeColumns = table.columns.filter((name) => /^node\d+$/.test(name));
    const nodes = (ids) => ids.map((id) => shape?.indexOfNode.get(Number(id))).filter((i) => i !== undefined);
    const failed = cells.failed === "yes";
    return {
      id: cells.id, cells, failed, entity: `weld ${cells.id}`, part: partIndex.get(cells.part),
      diameter: Number(cells.diameter), length: Number(cells.length), failureTime: failed ? Number(cells.failure_time) : Infinity,
      peak: Number(cells.peak_failure) || 0, damage: cells.damage ? Number(cells.damage) : null, // at the end, 0 to 1
      nodes: nodes(nodeColumns.map((name) => cells[name]).filter(Boolean)),
      segment: nodes((cells.segment1 ?? "").split(" ").filter(Boolean)),
      verdict: verdictOf(cells), kindOfVerdict: failed ? "failed" : cells.tied !== "yes" ? "untied" : cells.peak_failure >= 0.8 ? "near" : "holds",
    };
  });
}

function verdictOf(cells) {
  if (cells.failed === "yes") return `failed at ${Number(cells.failure_time).toPrecision(4)} by ${cells.failure_mode}`;
  if (cells.tied !== "yes") return "not tied";
  return Number(cells.peak_failure) > 0 ? "holds" : "no failure value";
}
