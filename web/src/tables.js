// SPDX-License-Identifier: Apache-2.0
import { csv, element, save } from "./format.js";

const value = (row, column) => row.cells[column]?.dataset.value ?? row.cells[column]?.textContent.trim() ?? "";

/** Numbers by size, words by letters; what is empty last. */
function compare(a, b) {
  const x = parseFloat(a), y = parseFloat(b);
  if (a === "" || b === "") return (a === "") - (b === "");
  if (!Number.isNaN(x) && !Number.isNaN(y)) return x - y;
  return a.localeCompare(b);
}

/** Makes a table of the page sortable by a click on its headings, gives it a filter and a button that saves it as CSV. */
export function enhance(table, name) {
  const head = table.rows[0], rows = () => [...table.rows].slice(1), body = head.parentElement;
  const columns = [...head.cells];
  columns.forEach((cell, column) => {
    cell.tabIndex = 0;
    cell.setAttribute("role", "columnheader");
    cell.setAttribute("aria-sort", "none");
    const sort = () => {
      const order = cell.getAttribute("aria-sort") === "ascending" ? "descending" : "ascending";
      columns.forEach((c) => c.setAttribute("aria-sort", c === cell ? order : "none"));
      const sorted = rows().sort((a, b) => compare(value(a, column), value(b, column)) * (order === "ascending" ? 1 : -1));
      body.append(...sorted);
    };
    cell.addEventListener("click", sort);
    cell.addEventListener("keydown", (event) => event.key === "Enter" && sort());
  });
  const filter = element("input", { type: "search", placeholder: "filter", "aria-label": `filter ${name}` });
  const count = element("span", { class: "quiet" });
  filter.addEventListener("input", () => {
    const wanted = filter.value.toLowerCase().split(/\s+/).filter(Boolean);
    let shown = 0;
    for (const row of rows()) {
      const text = row.textContent.toLowerCase();
      row.hidden = !wanted.every((word) => text.includes(word));
      shown += !row.hidden;
    }
    count.textContent = wanted.length ? `${shown} of ${rows().length}` : "";
  });
  const lines = () => [head, ...rows().filter((row) => !row.hidden)].map((row) => [...row.cells].map((_, c) => value(row, c)));
  table.before(element("div", { class: "tools" }, filter, count,
    element("button", { onclick: () => save(`${name}.csv`, csv(lines())) }, "save as CSV")));
}
