"""A family as a drawing: versions from left to right, an edge for each change."""

from __future__ import annotations

from html import escape

from rpg.gallery.collect import Album, Card

STEP, LANE, RADIUS, MARGIN = 250, 68, 15, 28
LONGEST = 32
"""Signs of an edit that its edge has room for; the rest is in its title and on the card."""


def lineage_svg(album: Album) -> str:
    """The lineage graph of a family; nodes lead to their cards, edges tell the edit, its class and its proof."""
    places = _places(album)
    width = MARGIN * 2 + STEP * max(x for x, _ in places.values())
    height = MARGIN * 2 + LANE * max(y for _, y in places.values())
    cards = {card.number: card for card in album.cards}
    edges = "".join(_edge(cards[n], places) for n in cards if cards[n].parent is not None)
    nodes = "".join(_node(card, places[card.number]) for card in album.cards)
    return (
        f'<svg class="lineage" viewBox="0 0 {width} {height}" width="{width}" height="{height}" role="img" '
        f'aria-label="versions of {escape(album.name)}">{edges}{nodes}</svg>'
    )


def _places(album: Album) -> dict[int, tuple[int, int]]:
    """Column (how far from the base) and lane of every version; the first child stays in its parent's lane."""
    places: dict[int, tuple[int, int]] = {}
    children: dict[int | None, list[int]] = {}
    for card in album.cards:
        children.setdefault(card.parent, []).append(card.number)
    lanes = 0

    def put(number: int, column: int, lane: int) -> None:
        nonlocal lanes
        places[number] = (column, lane)
        for index, child in enumerate(children.get(number, ())):
            if index:
                lanes += 1
            put(child, column + 1, lanes if index else lane)

    for index, root in enumerate(children.get(None, ())):
        lanes += bool(index)
        put(root, 0, lanes)
    return places


def _point(place: tuple[int, int]) -> tuple[int, int]:
    return MARGIN + STEP * place[0], MARGIN + LANE * place[1]


def _edge(card: Card, places: dict[int, tuple[int, int]]) -> str:
    assert card.parent is not None and card.steering is not None
    (x1, y1), (x2, y2) = _point(places[card.parent]), _point(places[card.number])
    middle = (x1 + x2 + RADIUS) / 2
    out = f"M{x1 + RADIUS},{y1}" if y1 == y2 else f"M{x1},{y1 + RADIUS} V{y2 - RADIUS} Q{x1},{y2} {x1 + RADIUS},{y2}"
    category = card.category.lower()
    goals = card.steering.proof.get("goals")
    kind = f"{category}: {goals['relation']}" if goals else category
    return (
        f'<g class="edge {category}"><title>{escape(told(card))}</title>'
        f'<path d="{out} H{x2 - RADIUS}"/>'
        f'<text x="{middle}" y="{y2 - 6}">{escape(kind)}</text>'
        f'<text x="{middle}" y="{y2 + 16}" class="said">{escape(_short(card.steering.request))}</text></g>'
    )


def _short(request: str) -> str:
    return request if len(request) <= LONGEST else f"{request[: LONGEST - 1].rstrip()}…"


def _node(card: Card, place: tuple[int, int]) -> str:
    x, y = _point(place)
    current = " current" if card.head else ""
    return (
        f'<a href="#{escape(card.anchor)}"><g class="node{current}"><title>{escape(card.goal)}</title>'
        f'<circle cx="{x}" cy="{y}" r="{RADIUS}"/><text x="{x}" y="{y + 4}">{card.number}</text></g></a>'
    )


def told(card: Card) -> str:
    """An edit with its class and its proof, in a few words."""
    steering = card.steering
    if steering is None:
        return ""
    lines = [f"“{steering.request}”", f"{steering.intent} of version {card.parent}"]
    kept = [name for name in ("assets", "positions", "goals") if getattr(steering, f"preserve_{name}")]
    lines.append(f"preserved: {', '.join(kept) or 'nothing'}")
    goals = steering.proof.get("goals")
    if goals:
        lines.append(f"goals: {goals['relation']} ({goals['states']} states)")
    axes = steering.proof.get("axes")
    if axes:
        lines.append(f"axes: {', '.join(axes)}")
    return "\n".join(lines)
