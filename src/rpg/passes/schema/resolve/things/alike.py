"""Objects told by comparison: "a block of the same colour", "blocks of the same colour together"."""

from __future__ import annotations

from rpg.language.meaning import Clause, Loc, Meaning, Noun, OrderBy, Pronoun, Structure, replace
from rpg.passes.schema.resolve.clauses.spec import Spec
from rpg.passes.schema.resolve.goals.logic import Atoms
from rpg.passes.schema.resolve.places.relations import related
from rpg.passes.schema.resolve.things.finish import BLOCK_COLORS
from rpg.passes.schema.resolve.things.refer import refer
from rpg.passes.schema.resolve.things.things import compared, create, matching
from rpg.passes.schema.resolve.things.world import Ref, Scene, Scope, refuse


def counterparts(clause: Clause, spec: Spec, scene: Scene, scope: Scope) -> Atoms | None:
    """ "a block of the same colour on each patch", "red on a block of the same colour"; None where none is compared."""
    pairs = [p for p in spec.places if isinstance(p, Loc) and p.landmark is not None]
    loc = pairs[0] if len(pairs) == 1 == len(spec.places) else None
    theirs = compared(clause.theme) or (loc is not None and _on_each(clause.theme, loc))
    if not theirs and not (loc is not None and compared(loc.landmark) and clause.theme is not None):
        return None
    noun, other = (clause.theme, loc.landmark if loc else None) if theirs else (loc and loc.landmark, clause.theme)
    if loc is None or not isinstance(noun, Noun) or other is None or compared(other) or clause.negated:
        raise refuse("ambiguous", "it is not said of what colour", clause.span, "name the colour")
    mark = refer(other, scene, replace(scope, role="landmark" if theirs else "theme"))
    if mark.quant is not None or mark.op != "and" or mark.table or mark.reciprocal or mark.built:
        raise refuse("ambiguous", "it is not said the same as what", noun.span, "name the colour")
    if theirs and len(mark.names) > 1 and not mark.each and not _all_of(other) and not noun.plural:
        raise refuse("ambiguous", "it is not clear on which of these", loc.span, "say 'each'")
    if mark.each and noun.plural and noun.amount is None:
        raise refuse("ambiguous", "it is not said how many on each", noun.span, "say how many")
    spec.places = []
    goals: Atoms = []
    made: list[str] = []
    for name in mark.names:
        twins = _twins(name, noun, scene)
        made += twins
        one, two = Ref(names=twins, span=noun.span), Ref(names=(name,), patch=mark.patch, span=mark.span)
        goals += related(one, two, loc, scene, clause.span) if theirs else related(two, one, loc, scene, clause.span)
    scene.mention(Ref(names=tuple(made), plural=len(made) > 1, span=noun.span), "theme" if theirs else "landmark")
    return goals


def _on_each(theme: Meaning | None, loc: Loc) -> bool:
    """ "two blocks of the same colour on each patch": the same as the patch, for these are all alike in turn."""
    each = isinstance(loc.landmark, Noun) and loc.landmark.head == "patch" and loc.landmark.det == "each"
    alike = isinstance(theme, Noun) and theme.traits.scheme == "same" and not theme.traits.colors
    alike = alike and isinstance(theme, Noun) and theme.head != "patch"
    return each and alike and isinstance(theme, Noun) and theme.amount is not None


def _all_of(meaning: Meaning) -> bool:
    return isinstance(meaning, Noun) and meaning.det == "all"


def _twins(name: str, noun: Noun, scene: Scene) -> tuple[str, ...]:
    """As many blocks as the phrase says of the colour of an object, those there are before new ones."""
    like = scene.things[name]
    if like.color is None and like.kind is None:
        taken = {t.color for t in scene.things.values() if t.patch == like.patch}
        like.color = next(c for c in BLOCK_COLORS if c not in taken)
        scene.assume("the colours are not said: one of each colour")
    if like.color is None:
        raise refuse("ambiguous", "it is not said of what colour", noun.span, "name the colour")
    plain = replace(noun.traits, colors=(like.color,), scheme=None, matching=False)
    there = [t for t in matching(plain, scene, False) if t.declared and t.name not in scene.used and t.name != name]
    count = noun.amount.low if noun.amount else 1
    scene.new_batch()
    twins = tuple(t.name for t in there[:count])
    twins += tuple(create(plain, scene, False).name for _ in range(count - len(twins)))
    scene.used.update(twins)
    return twins


def by_likeness(clause: Clause, spec: Spec, scene: Scene) -> Clause | None:
    """ "blocks of the same colour together" sorts them all: the clause with what to sort by, or None."""
    theme = clause.theme
    if not (isinstance(theme, Noun) and theme.traits.scheme == "same" and theme.plural and theme.head != "patch"):
        return None
    if theme.amount is not None or theme.det not in ("bare", "the", "all") or theme.traits.colors or clause.negated:
        return None
    if scene.built:
        return None
    close = [p for p in spec.places if _each_other(p)]
    piles = [i for i in spec.intos if isinstance(i.structure, Structure) and i.structure.kind == "pile"]
    gathers = clause.verb == "sort"
    piled = clause.verb == "stack" or any(getattr(p, "rel", "") == "heaped" for p in spec.places)
    if not (close or piles or gathers or piled) and spec.places and not spec.intos:
        raise refuse(
            "misplaced",
            "it is not said which blocks agree in colour",
            theme.span,
            "say how many, or 'sort the blocks by color'",
        )
    if not (close or piles or gathers or piled):
        return None
    spec.places = [p for p in spec.places if p not in close]
    spec.intos = [i for i in spec.intos if i not in piles or getattr(i.structure, "plural", False)]
    told = "label" if theme.traits.kind in ("letter", "digit", "symbol") else "color"
    spec.orders.append(OrderBy(by="attribute", attribute=told, span=theme.span))
    open_ = replace(theme, traits=replace(theme.traits, scheme=None), det="the" if theme.det == "bare" else theme.det)
    verb = "stack" if piled else "sort"
    return replace(clause, verb=verb, lemma=verb, theme=open_)


def _each_other(place: Meaning) -> bool:
    near = isinstance(place, Loc) and place.rel in ("together", "near", "beside", "side_by_side", "adjacent")
    mark = place.landmark if isinstance(place, Loc) else None
    return near and isinstance(mark, Pronoun) and mark.word in ("each other", "one another")
