""" "Put the red blocks on the left, the blue ones on the right and the green ones in between": between two lots."""

from __future__ import annotations

from rpg.language.meaning import At, Loc, Pronoun
from rpg.passes.schema.resolve.things.world import Ref, Scene, refuse

_OPPOSITE = ({"left", "right"}, {"front", "back"})
_BESIDE = frozenset({"left", "right", "front", "behind", "beside", "adjacent", "near", "apart", "distance"})
"""Relations that leave room between a block and its landmark."""


def two_lots(last: int, scene: Scene) -> Ref | None:
    """The two lots that were put on opposite sides, or each in a place of one kind, by the `last` clause and those
    before it."""
    told: dict[int, Ref] = {}
    for mention in scene.mentions:
        if mention.role == "theme" and mention.clause <= last and mention.ref.names and not mention.ref.patch:
            told.setdefault(mention.clause, mention.ref)
    both = sorted(told)[-2:]
    if len(both) < 2 or both[1] != last:
        return None
    sided = {ref.names: (ref, at_.side) for ref, at_, _ in scene.loose if isinstance(at_, At) and _on_a_side(at_)}
    sides = [side for _, side in sided.values()]
    if len(sided) == 2 and set(sides) in _OPPOSITE and told[last].names in sided:
        ends = tuple(ref for ref, _ in sided.values())
    elif both[0] == last - 1 and _each_in_its_place(both, scene):
        ends = tuple(told[clause] for clause in both)
    else:
        return None
    names = tuple(n for ref in ends for n in ref.names)
    if len(set(names)) < len(names) or any(ref.op != "and" or ref.quant for ref in ends):
        return None
    return Ref(names=names, parts=ends, plural=True)


def _on_a_side(at_: At) -> bool:
    return at_.index is None and not at_.whole and at_.side != "middle"


def _each_in_its_place(clauses: list[int], scene: Scene) -> bool:
    """Whether each of two clauses tells the patch, or the part of the table, that its blocks are on."""
    patches = [
        {m.ref.names for m in scene.mentions if m.clause == clause and m.ref.patch and m.rel == "on"}
        for clause in clauses
    ]
    regions = [{scene.regions[clause]} if clause in scene.regions else set() for clause in clauses]
    return any(len(one) == len(two) == 1 and one != two for one, two in (patches, regions))


def two_told(ref: Ref, last: Ref | None, word: Pronoun, place: Loc, scene: Scene) -> Ref | None:
    """ "The red blocks are left of the blue blocks, with a green one in between": between these and those. `last`: what
    the clause told a place of before, if anything."""
    here = [m for m in scene.mentions if m.clause == scene.clause and m.role == "landmark" and not m.ref.patch]
    others = [last] if last is not None else [m.ref for m in here if m.rel in _BESIDE]
    if place.rel == "between" and not others and (ends := two_lots(scene.clause, scene)) is not None:
        return ends
    if place.rel != "between" or len(others) != 1 or not ref.names or {*ref.names} & {*others[0].names}:
        return None
    told = (ref, others[0])
    several = [len(end.names) > 1 and [b.kind for b in end.built] != ["stack"] for end in told]
    if not any(several):
        return None
    if not all(several) or any(end.op != "and" or end.quant for end in told):
        raise refuse("ambiguous", f"it is not clear between which blocks this is: {word.word!r} could be all of them",
                     place.span, "name both ends: 'between the red blocks and the blue block'")  # fmt: skip
    return Ref(names=tuple(n for end in told for n in end.names), parts=told, plural=True)
