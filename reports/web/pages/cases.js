// Per case, folded: what its runs were found to be, their pictures, and the viewer of their series.
// A case is built when it is first opened: most readers look at few of them.
window.crossgrain = window.crossgrain || {};
(function (crossgrain) {
  "use strict";
  const { el, missing } = crossgrain.dom;
  const { list } = crossgrain.data;
  const format = crossgrain.format;

  const seriesCount = (item) => Object.keys(item.series_names || {}).length;

  const idOf = (item) => "case-" + item.case;

  function contents(item) {
    return [
      list(item.findings).length ? "findings" : "",
      list(item.pictures).length ? format.plural(list(item.pictures).length, "picture") : "",
      seriesCount(item) ? "series: " + Object.keys(item.series_names).join(", ") : "",
    ].filter(Boolean);
  }

  function fill(place, item) {
    const parts = [crossgrain.findings, crossgrain.pictures, crossgrain.seriesViewer];
    for (const part of parts) {
      try {
        place.append(...part(item).flat(Infinity).filter(Boolean));
      } catch (error) {
        place.append(missing("This part could not be drawn: " + error.message));
        console.error(error);
      }
    }
  }

  function caseDetails(item) {
    const place = el("div", {});
    const details = el(
      "details",
      { class: "case-part", "data-case": item.case, id: idOf(item) },
      el(
        "summary",
        {},
        el("span", { class: "case-name" }, item.case),
        " ",
        item.title ? el("span", { class: "case-title" }, item.title) : null,
        el("span", { class: "soft" }, " · " + contents(item).join(" · ")),
      ),
      place,
    );
    const open = () => {
      if (!details.open || place.childElementCount > 0) return;
      fill(place, item);
    };
    details.addEventListener("toggle", open);
    return details;
  }

  /** From anywhere on the page to a case's pictures and curves, or nothing if it has none. */
  crossgrain.caseLink = (item) => {
    if (contents(item).length === 0) return null;
    const link = el("a", { href: "#" + encodeURIComponent(idOf(item)) }, "pictures and curves");
    link.addEventListener("click", () => (document.getElementById(idOf(item)).open = true));
    return link;
  };

  crossgrain.cases = (report) => {
    const shown = list(report.cases).filter((item) => contents(item).length > 0);
    if (shown.length === 0)
      return [missing("No case in this report left pictures, findings or other series.")];
    return [el("div", { class: "case-parts" }, shown.map(caseDetails))];
  };
})(window.crossgrain);
