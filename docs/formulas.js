// SPDX-License-Identifier: Apache-2.0
// Sets the formulas that pymdownx.arithmatex has marked.
document.addEventListener("DOMContentLoaded", function () {
  document.querySelectorAll(".arithmatex").forEach(function (element) {
    const text = element.textContent;
    katex.render(text.slice(2, -2), element, {displayMode: text.startsWith("\\["), throwOnError: false});
  });
});
