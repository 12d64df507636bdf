"""Who "the other", "the others" and "it" are where more are left: those of the ones spoken of last."""

from __future__ import annotations

from rpg.language.meaning import Noun, Pronoun, Traits
from rpg.passes.schema.resolve.things.things import create, matching
from rpg.passes.schema.resolve.things.world import Ref, Scene, Thing, refuse

_TWO = 2


def of_the_last(noun: Noun, scene: Scene, patch: bool) -> list[Thing]:
    """ "Red, green and blue in a row, yellow on green, nothing on the others": those not named by themselves."""
    if patch or noun.det != "other" or not noun.plural or noun.traits.colors or noun.traits.labels or noun.amount:
        return []
    told = [m for m in scene.mentions if m.ref.names and not m.ref.patch and m.ref.quant is None]
    at = max((n for n, m in enumerate(told) if len(m.ref.names) > 2), default=-1)
    if at < 0:
        return []
    since = {n for m in told[at + 1 :] for n in m.ref.names if len(m.ref.names) == 1}
    whole = told[at].ref.names
    return [scene.things[n] for n in whole if n not in since] if since & set(whole) else []


def the_like_of_it(noun: Noun, left: list[Thing], scene: Scene, patch: bool) -> list[Thing]:
    """ "(Two black and two white blocks.) One black block is on the mat, the other is not": the second of the two that
    look like the one that the clause before told of."""
    if patch or noun.det != "other" or noun.plural or noun.traits != Traits() or noun.amount or len(left) < _TWO:
        return []
    told = [m for m in scene.mentions if m.role == "theme" and m.ref.names]
    if not told or told[-1].clause != scene.clause - 1 or told[-1].ref.patch or len(told[-1].ref.names) != 1:
        return []
    it = scene.things[told[-1].ref.names[0]]
    like = matching(Traits(colors=(it.color,) if it.color else ()), scene, patch)
    rest = [thing for thing in like if thing.name != it.name]
    return rest if len(rest) == 1 and rest[0] in left else []


def more_like_it(noun: Noun, count: int | None, scene: Scene, patch: bool) -> list[Thing]:
    """ "One red block is on the left, the other (two) on the right": so many more like those told before, where
    nobody said what blocks there are."""
    told = [m for m in scene.mentions if m.role == "theme" and m.ref.names and not m.ref.patch]
    open_ = noun.det != "other" or noun.traits != Traits() or (noun.plural and count is None)
    if patch or open_ or not told or scene.sentence:
        return []
    lot = [scene.things[name] for name in told[-1].ref.names]
    looks = {(t.color, t.label, t.kind, t.size, t.edge) for t in lot}
    others = {n for m in scene.mentions if m.ref.det != "the" for n in m.ref.names if not m.ref.patch}
    known = any(t.declared for t in scene.blocks()) or told[-1].ref.det == "the" or others - {t.name for t in lot}
    if known or looks != {(lot[0].color, None, None, None, None)} or told[-1].clause != scene.clause - 1:
        return []
    scene.new_batch()
    return [create(Traits(colors=(lot[0].color,) if lot[0].color else ()), scene, patch) for _ in range(count or 1)]


def check_no_extra_since(word: Pronoun, found: Ref, scene: Scene) -> None:
    """Refuse "Put A on B. C is a distractor. Put it on the mat.": C was spoken of last, and is not to be used."""
    since = (m.ref for m in scene.mentions if found.span < m.ref.span < word.span and len(m.ref.names) == 1)
    if any(scene.things[ref.names[0]].extra for ref in since):
        raise refuse("ambiguous", f"{word.word!r} would be the distractor, which is not to be used", word.span,
                     "name the block that is meant")  # fmt: skip
