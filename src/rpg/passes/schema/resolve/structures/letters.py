"""The cubes that a word or an equation is made of: those that are there, and new ones for what is on none of them."""

from __future__ import annotations

import string

from rpg.core.diagnostics import Span
from rpg.ir.walk import names as names_in
from rpg.language.meaning import Noun, Traits, replace
from rpg.passes.schema.resolve.clauses.spec import Spec
from rpg.passes.schema.resolve.things.refer import refer
from rpg.passes.schema.resolve.things.things import create
from rpg.passes.schema.resolve.things.world import Ref, Scene, Scope, Thing, refuse


def cubes_for(text: str, spec: Spec, theme: Ref | None, scene: Scene, span: Span) -> tuple[str, ...]:
    """One cube for every symbol of the text, those that are there already first; all that are named if one lacks."""
    source = spec.usings.pop(0).members if spec.usings else None
    traits = Traits()
    if theme is None and isinstance(source, Noun):
        open_ended = (
            source.amount is None and not source.traits.labels and source.det not in ("the", "all", "both", "other")
        )
        if source.amount is not None and source.amount.low != len(text):
            raise refuse(
                "count-mismatch",
                f"{text} has {len(text)} letters, but {source.amount.low} blocks are named",
                source.span,
                f"say {len(text)} blocks",
                letters=len(text),
            )
        unnamed = open_ended or source.amount is not None or not _has_symbols(scene)
        if unnamed and not source.traits.labels:
            traits = source.traits
            if traits.quality or len(traits.colors) > 1:
                raise refuse(
                    "ambiguous", "it is not clear which letters look like this", source.span, "name each by its letter"
                )
        else:
            theme = refer(source, scene, Scope(role="member"))
    elif theme is None and source is not None:
        theme = refer(source, scene, Scope(role="member"))
    if theme is not None:
        theme = replace(theme, names=scene.fit(theme.names, len(text)))
    begun = {n for goal in scene.start_goals for n in names_in(goal)}
    there = [t for t in scene.blocks() if (t.declared or t.name in begun) and not t.extra]
    pool = [scene.things[n] for n in theme.names] if theme is not None else there
    names: list[str] = []
    for symbol in text:
        found = _among(symbol, pool, names, scene)
        if found is None and theme is not None and any(t.label for t in pool):
            return theme.names
        if found is None and theme is None:
            found = _asked_for(symbol, names, traits, scene, span)
        names.append((found or _made(symbol, traits, scene, span)).name)
    if isinstance(source, Noun) and source.part_of is not None and not {*names} <= {t.name for t in pool}:
        raise refuse("order-misfit", f"these blocks do not show {text}", source.span, "use letter blocks")
    if len(pool) > len(names):
        scene.used.update(names)
    if theme is not None:
        _none_left(pool, names, text, span)
    return tuple(names)


def _among(symbol: str, pool: list[Thing], names: list[str], scene: Scene) -> Thing | None:
    """One that shows this: in "spell NO on the red mat and ON on the blue one" none of another word, if there are more;
    or one that shows nothing yet."""
    shown = [t for t in pool if t.label == symbol and t.name not in names]
    taken = set[str]() if scene.later else _taken(scene)
    if shown:
        return next((t for t in shown if t.name not in taken), shown[0])
    found = next((t for t in pool if t.label is None and t.color is None and t.name not in names), None)
    if found is not None:
        _label(found, symbol)
    return found


def _made(symbol: str, traits: Traits, scene: Scene, span: Span) -> Thing:
    """A new cube that shows this and looks so."""
    if traits.kind == ("digit" if symbol in string.ascii_uppercase else "letter"):
        raise refuse("order-misfit", f"{symbol} is on none of these blocks", span, "use letter blocks")
    if traits.kind == "plain":
        raise refuse("order-misfit", "plain blocks spell nothing", span, "use letter blocks")
    looks = Traits(labels=(symbol,), colors=traits.colors[:1], edge=traits.edge, size=traits.size)
    return create(looks, scene, False)


def _asked_for(symbol: str, names: list[str], traits: Traits, scene: Scene, span: Span) -> Thing | None:
    """ "Put the A on the mat. Spell CAT": the cube of which something is asked already, unless that takes it away.

    One of a word or an equation is in that; whether one that lies on a block is to be taken for this is asked.
    """
    named = {n for m in scene.mentions if not any(b.kind in _READ for b in m.ref.built) for n in m.ref.names}
    taken = _taken(scene)
    for thing in scene.blocks():
        if thing.label != symbol or thing.name in {*names, *taken} or thing.name not in named or thing.extra:
            continue
        if traits.colors and thing.color not in (None, *traits.colors):
            continue
        towers = [b for b in scene.built if b.kind in ("stack", "towers") and thing.name in b.members]
        if any(not b.ordered or b.members[0] != thing.name for b in towers) or thing.name in scene.on_top:
            hint = f"say 'with another {symbol}', or say what happens to the one in the tower first"
            raise refuse("ambiguous", f"this could be the {symbol} that is in a tower, or a further one", span, hint)
        return thing
    return None


def _taken(scene: Scene) -> set[str]:
    """The cubes of the words and equations that were told of before."""
    return {n for b in scene.built if b.kind in _READ for n in b.members}


_READ = ("word", "equation", "column")


def _none_left(pool: list[Thing], names: list[str], text: str, span: Span) -> None:
    """Refuse blocks that were named for a word and are not in it."""
    left = [t for t in pool if t.name not in names and t.label is None and t.color is None]
    if left:
        raise refuse(
            "count-mismatch",
            f"{text} has {len(text)} letters, but {len(pool)} blocks are named",
            span,
            f"say {len(text)} blocks",
            letters=len(text),
        )


def _has_symbols(scene: Scene) -> bool:
    return any(t.label for t in scene.blocks())


def _label(thing: Thing, symbol: str) -> None:
    letter = symbol in string.ascii_uppercase
    if thing.kind == ("digit" if letter else "letter"):
        what = "number" if letter else "letter"
        raise refuse("order-misfit", f"no {what} block shows {symbol}", None, "name the blocks by what they show")
    thing.label = symbol
    thing.kind = "letter" if symbol in string.ascii_uppercase else "digit" if symbol in string.digits else "symbol"
