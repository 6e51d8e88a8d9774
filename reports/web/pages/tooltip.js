// One tooltip for the page: on hover and on keyboard focus; a click or tap pins it; Escape closes.
window.crossgrain = window.crossgrain || {};
(function (crossgrain) {
  "use strict";
  const { el } = crossgrain.dom;

  const box = el("div", { id: "tooltip", role: "tooltip", hidden: true });
  let current = null;
  let pinned = false;

  function place(target) {
    const cell = target.getBoundingClientRect();
    const width = Math.min(box.offsetWidth, window.innerWidth - 16);
    const left = Math.min(Math.max(8, cell.left), window.innerWidth - width - 8);
    const below = cell.bottom + 6;
    const above = cell.top - box.offsetHeight - 6;
    box.style.left = left + "px";
    box.style.top =
      (below + box.offsetHeight > window.innerHeight && above > 0 ? above : below) + "px";
  }

  function show(target, build) {
    box.replaceChildren(build());
    box.hidden = false;
    current = target;
    pinned = false;
    target.setAttribute("aria-describedby", "tooltip");
    place(target);
  }

  function hide() {
    if (current) current.removeAttribute("aria-describedby");
    box.hidden = true;
    current = null;
    pinned = false;
  }

  /** Gives `target` a tooltip whose content is built when it is first needed. */
  function attach(target, build) {
    target.tabIndex = 0;
    target.addEventListener("mouseenter", () => !pinned && show(target, build));
    target.addEventListener("mouseleave", () => !pinned && hide());
    target.addEventListener("focus", () => show(target, build));
    target.addEventListener("blur", hide);
    target.addEventListener("click", () => {
      show(target, build);
      pinned = true;
    });
    return target;
  }

  document.addEventListener("keydown", (event) => event.key === "Escape" && hide());
  document.addEventListener("DOMContentLoaded", () => document.body.append(box));
  window.addEventListener("scroll", () => current && place(current), { passive: true });

  crossgrain.tooltip = { attach };
})(window.crossgrain);
