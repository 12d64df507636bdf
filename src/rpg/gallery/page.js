"use strict";
(() => {
  const get = (id) => document.getElementById(id);
  const cards = [...document.querySelectorAll(".card")];
  const families = [...document.querySelectorAll(".family")];
  const fields = ["search", "category", "kind", "color", "current"].map(get);
  const [search, category, kind, color, current] = fields;

  const fits = (card) =>
    search.value.toLowerCase().split(/\s+/).every((word) => card.dataset.words.includes(word)) &&
    (!category.value || card.dataset.category === category.value) &&
    (!kind.value || card.dataset.kinds.split("|").includes(kind.value)) &&
    (!color.value || card.dataset.colors.split(" ").includes(color.value)) &&
    (!current.checked || card.dataset.current === "1");

  const show = () => {
    let shown = 0;
    for (const card of cards) {
      card.hidden = !fits(card);
      shown += card.hidden ? 0 : 1;
    }
    let left = 0;
    for (const family of families) {
      family.hidden = !family.querySelector(".card:not([hidden])");
      left += family.hidden ? 0 : 1;
    }
    get("count").value = `${shown} of ${cards.length} versions, ${left} ${left === 1 ? "family" : "families"}`;
    get("nothing").hidden = shown > 0 || cards.length === 0;
  };

  for (const field of fields) field.addEventListener("input", show);
  get("reset").addEventListener("click", () => {
    search.value = category.value = kind.value = color.value = "";
    current.checked = false;
    show();
  });
  get("theme").addEventListener("click", () => {
    const root = document.documentElement;
    const dark = root.dataset.theme ? root.dataset.theme === "dark" : matchMedia("(prefers-color-scheme: dark)").matches;
    root.dataset.theme = dark ? "light" : "dark";
  });
  if (location.hash.startsWith("#q=")) {
    search.value = decodeURIComponent(location.hash.slice(3));
    show();
  }
})();
