"""The page itself."""

from __future__ import annotations

from html import escape
from importlib.resources import files

from rpg.gallery.collect import Album, Card, Gate, albums
from rpg.gallery.lineage import lineage_svg
from rpg.store import Workspace

POLICY = "default-src 'none'; img-src data:; style-src 'unsafe-inline'; script-src 'unsafe-inline'"
"""The page asks the browser itself to load nothing from anywhere."""
CATEGORIES = ("BASE", "TWEAK", "EXTEND", "MODIFY", "PIVOT", "FRESH")


def gallery_page(workspace: Workspace, title: str = "Task gallery") -> tuple[str, tuple[str, ...]]:
    """The gallery of a workspace as HTML, and what was left out of it, with the reasons."""
    found, problems = albums(workspace)
    return render(found, title), problems


def render(found: tuple[Album, ...], title: str) -> str:
    """The page for families; equal families give equal bytes."""
    cards = [card for album in found for card in album.cards]
    sections = "\n".join(_family(album) for album in found) or '<p class="empty">There are no tasks here yet.</p>'
    return f"""<!DOCTYPE html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<meta http-equiv="Content-Security-Policy" content="{POLICY}">
<title>{escape(title)}</title>
<style>{_resource("page.css")}</style>
</head>
<body>
<header>
<h1>{escape(title)}</h1>
{_controls(found, cards)}
</header>
<main>
{sections}
<p class="empty" id="nothing" hidden>Nothing fits. <button type="button" id="reset">Show everything</button></p>
</main>
<script>{_resource("page.js")}</script>
</body>
</html>
"""


def _resource(name: str) -> str:
    return files("rpg.gallery").joinpath(name).read_text(encoding="utf-8")


def _controls(found: tuple[Album, ...], cards: list[Card]) -> str:
    kinds = sorted({kind for card in cards for kind in card.kinds})
    colors = sorted({color for card in cards for color in card.colors})
    present = [c for c in CATEGORIES if any(card.category == c for card in cards)]
    return f"""<div class="controls">
<input type="search" id="search" placeholder="Search instructions, goals, edits" aria-label="Search" autocomplete="off">
{_select("category", "Any class", present)}
{_select("kind", "Any condition", kinds)}
{_select("color", "Any colour", colors)}
<label><input type="checkbox" id="current"> current versions only</label>
<output id="count">{len(cards)} of {len(cards)} versions, {len(found)} famil{"y" if len(found) == 1 else "ies"}</output>
<button type="button" id="theme" aria-label="Light or dark">◐</button>
</div>"""


def _select(name: str, anything: str, values: list[str]) -> str:
    options = "".join(f'<option value="{escape(v)}">{escape(v.lower() if v.isupper() else v)}</option>' for v in values)
    return f'<select id="{name}" aria-label="{anything}"><option value="">{anything}</option>{options}</select>'


def _family(album: Album) -> str:
    graph = f'<div class="graph">{lineage_svg(album)}</div>' if len(album.cards) > 1 else ""
    cards = "\n".join(_card(card) for card in album.cards)
    many = f"{len(album.cards)} version{'s' if len(album.cards) > 1 else ''}"
    return f"""<section class="family" data-family="{escape(album.name)}">
<h2>{escape(album.name)} <small>{many}</small></h2>
{graph}
<div class="cards">
{cards}
</div>
</section>"""


def _card(card: Card) -> str:
    request = card.steering.request if card.steering else ""
    words = " ".join((card.family, card.instruction, card.goal, request)).lower()
    category = f'<span class="badge {card.category.lower()}">{card.category.lower()}</span>'
    current = '<span class="badge head">current</span>' if card.head else ""
    return f"""<article class="card" id="{escape(card.anchor)}" data-words="{escape(words)}"
 data-category="{card.category}" data-kinds="{escape("|".join(card.kinds))}" data-colors="{" ".join(card.colors)}"
 data-current="{int(card.head)}">
{_pictures(card)}
<div class="text">
<h3>v{card.number} <code>{card.short_hash}</code> {category}{current}</h3>
{_edit(card)}
<p class="instruction">{escape(card.instruction)}</p>
<details><summary>Goal in words</summary><p>{escape(card.goal)}</p></details>
{_assumptions(card)}
<p class="gates">{"".join(_gate(gate) for gate in card.gates)}</p>
</div>
</article>"""


def _pictures(card: Card) -> str:
    shown = []
    for name, word in (("initial", "start"), ("goal", "goal")):
        uri = card.pictures.get(name)
        inside = (
            f'<img src="{uri}" alt="{word} of {escape(str(card.anchor))}" loading="lazy">'
            if uri
            else '<span class="none">not drawn</span>'
        )
        shown.append(f"<figure>{inside}<figcaption>{word}</figcaption></figure>")
    return f'<div class="pictures">{"".join(shown)}</div>'


def _edit(card: Card) -> str:
    steering = card.steering
    if steering is None:
        return ""
    kept = [name for name in ("assets", "positions", "goals") if getattr(steering, f"preserve_{name}")]
    goals = steering.proof.get("goals") or {}
    axes = "".join(f'<span class="axis">{escape(axis)}</span>' for axis in steering.proof.get("axes", ()))
    relation = f"new goal {goals['relation']} old, on {goals['states']} states" if goals else ""
    return f"""<p class="edit">“{escape(steering.request)}” <span class="of">from v{card.parent}</span></p>
<p class="proof">preserved: {", ".join(kept) or "nothing"}; {escape(relation)} {axes}</p>"""


def _assumptions(card: Card) -> str:
    if not card.assumptions:
        return ""
    items = "".join(f"<li>{escape(text)}</li>" for text in card.assumptions)
    return f'<ul class="assumptions">{items}</ul>'


def _gate(gate: Gate) -> str:
    sign = "✓" if gate.passed else "✗"
    state = "pass" if gate.passed else "fail"
    return f'<span class="gate {state}" title="{escape(gate.figures)}">{sign} {escape(gate.name)}</span>'
