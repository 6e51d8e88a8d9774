// Loads the curves of one case when they are first asked for: a classic script per case, since
// browsers block fetch on file://.
window.crossgrain = window.crossgrain || {};
(function (crossgrain) {
  "use strict";
  const pending = new Map(); // file -> promise of its series

  /** A promise of the list of series in `file`, a path below the report's folder. */
  crossgrain.loadSeries = (file) => {
    if (!pending.has(file)) {
      pending.set(
        file,
        new Promise((resolve, reject) => {
          const script = document.createElement("script");
          script.src = file;
          script.onload = () => {
            const found = (window.crossgrainSeries || {})[file];
            if (Array.isArray(found)) resolve(found);
            else reject(new Error(file + " holds no series"));
          };
          script.onerror = () => reject(new Error(file + " is missing beside this page"));
          document.head.append(script);
        }),
      );
    }
    return pending.get(file);
  };
})(window.crossgrain);
