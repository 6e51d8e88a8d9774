// The pictures a case's runs left: a grid with captions, each a link to the picture in full size.
window.crossgrain = window.crossgrain || {};
(function (crossgrain) {
  "use strict";
  const { el, missing } = crossgrain.dom;
  const { list } = crossgrain.data;

  const wide = 360; // CSS pixels a small picture is enlarged to, by whole factors

  /**
   * Whole factors for width and height. They are equal where both are lengths; a map of space against
   * time is stretched when it would be too slender to be seen.
   */
  function factors({ name, width, height }) {
    const common = Math.max(1, Math.floor(wide / Math.max(width, height)));
    if (!/space-time/.test(name)) return [common, common];
    const stretch = (ratio) => Math.max(1, Math.floor(ratio / 1.25));
    return [common * stretch(height / width), common * stretch(width / height)];
  }

  /** Pixels of an enlarged picture stay areas of one colour. */
  function image(picture) {
    const size = { name: picture.name, width: picture.width || 1, height: picture.height || 1 };
    const [across, down] = factors(size);
    return el("img", {
      src: picture.file,
      alt: picture.title || picture.name,
      width: size.width * across,
      height: size.height * down,
      style: "aspect-ratio: " + size.width * across + " / " + size.height * down + "; height: auto",
      loading: "lazy",
      decoding: "async",
      class: across > 1 || down > 1 ? "pixelated" : null,
    });
  }

  function stretched(picture) {
    const [across, down] = factors(picture);
    if (across === down) return null;
    return el(
      "span",
      { class: "note" },
      "Shown " + (across > down ? "wider" : "taller") + " than it is.",
    );
  }

  function caption(picture, several) {
    const who = [
      picture.variant,
      picture.name,
      several ? picture.code : "",
      picture.rung ? "time step " + (picture.rung + 1) : "",
    ];
    return el(
      "figcaption",
      {},
      el("strong", {}, who.filter(Boolean).join(", ")),
      picture.title ? el("span", { class: "note" }, picture.title) : null,
      picture.file ? stretched(picture) : null,
    );
  }

  function figure(picture, several) {
    const shown = picture.file
      ? el(
          "a",
          { href: picture.file, target: "_blank", title: picture.title || null },
          image(picture),
        )
      : missing(
          "This picture could not be written: " + (picture.problem || "it has no file") + ".",
        );
    return el("figure", { class: "picture" }, shown, caption(picture, several));
  }

  crossgrain.pictures = (item) => {
    const all = list(item.pictures);
    if (all.length === 0) return [];
    const several = new Set(all.map((picture) => picture.code)).size > 1;
    return [
      el("h4", {}, "Pictures"),
      el(
        "div",
        { class: "pictures" },
        all.map((picture) => figure(picture, several)),
      ),
    ];
  };
})(window.crossgrain);
