"""Groups that are told by their sides alone: "sort the blocks by color: red to the left, blue to the right"."""

from __future__ import annotations

from rpg.ir.schema import SYMBOLS_UNSAID
from rpg.language.meaning import Absolute, At, Noun, OrderBy, Traits
from rpg.passes.schema.resolve.clauses.spec import Spec
from rpg.passes.schema.resolve.things.world import Ref, Scene, Thing

EACH, SOME = 2, 6
"""Blocks of each kind at least, and together, where their number is open."""
_EXAMPLES = {"even": "2468", "odd": "1357", "vowel": "AEIOU", "consonant": "BCDFG", "letter": "ABCD", "digit": "1234"}
_ATTRIBUTES = {
    **dict.fromkeys(("even", "odd"), "parity"),
    **dict.fromkeys(("vowel", "consonant"), "vowel"),
    **dict.fromkeys(("letter", "digit"), "kind"),
}


def of_told_kinds(theme: Ref, attribute: str | None, spec: Spec, scene: Scene) -> tuple[Ref, str | None]:
    """Blocks of which nothing is said, as ones of the kinds that are said to lie somewhere, and what tells these apart.

    All that is sorted is of one of these kinds: of a block of another it would not be said where it belongs.
    """
    told = [_kind(item) for item in spec.absolutes if isinstance(item.adjuncts[0], At)]
    things = [scene.things[name] for name in theme.names]
    open_ = all(thing.color is None and thing.label is None and thing.quality is None for thing in things)
    own = {_ATTRIBUTES.get(kind or "", "color") for kind in told}
    if not open_ or None in told or len({*told}) < max(2, len(told)) or len(own) > 1 or not _fit_for(told, things):
        return theme, attribute
    if attribute not in (None, *own):
        return theme, attribute
    each, left = divmod(len(things), len(told))
    if all(thing.elastic for thing in things):
        each, left = max(EACH, SOME // len(told)), 0
        theme = Ref(names=scene.fit(theme.names, each * len(told)), plural=True, span=theme.span)
        things = [scene.things[name] for name in theme.names]
    if left or not each:
        return theme, attribute
    for index, thing in enumerate(things):
        _let_be(thing, told[index // each] or "", index % each)
    if any(kind in _EXAMPLES for kind in told):
        scene.assume(f"{SYMBOLS_UNSAID}: chosen to fit")
    if attribute is None:
        spec.orders.append(OrderBy(by="attribute", attribute=next(iter(own)), span=theme.span))
    return theme, next(iter(own))


def _let_be(thing: Thing, kind: str, place: int) -> None:
    """Let a block be one of such a kind, or of such a colour."""
    if kind in _EXAMPLES:
        thing.label = _EXAMPLES[kind][place % len(_EXAMPLES[kind])]
        thing.kind = "letter" if thing.label.isalpha() else "digit"
    else:
        thing.color = kind


def _fit_for(told: list[str | None], things: list[Thing]) -> bool:
    """Letters are neither even nor odd, and digits no vowels; of a letter that is red it is not said what it shows."""
    sorts = {thing.kind for thing in things} - {None}
    return all(sorts <= ({"digit"} if kind in ("even", "odd") else _LETTERS.get(kind or "", set())) for kind in told)


_LETTERS = {"vowel": {"letter"}, "consonant": {"letter"}}


def _kind(item: Absolute) -> str | None:
    """The one colour, or the kind of symbol, by which the blocks that lie there are told."""
    noun = item.theme
    if not isinstance(noun, Noun) or noun.head == "patch" or noun.amount is not None or noun.part_of is not None:
        return None
    look = noun.traits
    if look == Traits(colors=look.colors) and len(look.colors) == 1:
        return look.colors[0]
    sign = look.quality or look.kind
    return sign if look in (Traits(kind=look.kind, quality=look.quality), Traits(quality=look.quality)) else None
