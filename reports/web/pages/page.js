// Fills the sections of a page. A part that cannot be drawn says so in its place and leaves the
// others alone.
window.crossgrain = window.crossgrain || {};
(function (crossgrain) {
  "use strict";
  const { missing } = crossgrain.dom;

  /** parts: {id of the section's content: function of the report that returns nodes}. */
  crossgrain.fillPage = (parts) => {
    const report = window.crossgrainReport;
    for (const [id, build] of Object.entries(parts)) {
      const place = document.getElementById(id);
      if (!report) {
        place.replaceChildren(
          missing("There is no data.js beside this page: write it with “crossgrain report”."),
        );
        continue;
      }
      try {
        place.replaceChildren(...build(report).flat(Infinity).filter(Boolean));
      } catch (error) {
        place.replaceChildren(missing("This part could not be drawn: " + error.message));
        console.error(error);
      }
    }
    document.documentElement.dataset.ready = "true";
  };
})(window.crossgrain);
