"""The verbs of spelling and reading."""

from __future__ import annotations

from collections import Counter

from rpg.ir import structures as s
from rpg.ir.order import Order
from rpg.language.meaning import Clause, Into, Meaning, Noun, Pronoun, Structure, Toward, Traits, replace
from rpg.passes.schema.resolve.clauses.shaped import shaped
from rpg.passes.schema.resolve.clauses.spec import Spec
from rpg.passes.schema.resolve.places.placing import Goals, places
from rpg.passes.schema.resolve.structures.structures import make, row_node
from rpg.passes.schema.resolve.things.listing import continued
from rpg.passes.schema.resolve.things.refer import refer
from rpg.passes.schema.resolve.things.spoken import known_ones
from rpg.passes.schema.resolve.things.things import create, give, of_no_look
from rpg.passes.schema.resolve.things.world import Ref, Scene, Scope, refuse


def spell(clause: Clause, spec: Spec, scene: Scene, scope: Scope) -> Goals:
    """ "spell CAT with ...", "the cubes read A, B, C"."""
    theme = None
    if spec.usings and isinstance(line := spec.usings[0].members, Structure) and line.kind in _LINES:
        theme = _of_line(line, spec, scene, scope)
    if spec.usings and getattr(spec.usings[0].members, "word", "") == "it" and not any(True for _ in scene.blocks()):
        spec.usings.pop(0)
    if spec.usings and _of_its_own(clause.theme, spec.usings[0].members, scene):
        spec.usings.pop(0)
    if spec.usings and _mentioned(spec.usings[0].members):
        theme = refer(spec.usings.pop(0).members, scene, scope)
        stands = any(b.kind == "stack" and set(theme.names) <= set(b.members) for b in scene.built)
        if stands and not (spec.toward or spec.intos):
            _in_a_tower_still(clause, theme, scene)
            spec.toward.append(Toward(axis="z", span=clause.span))
    if clause.verb == "read" and isinstance(clause.theme, Noun):
        return _read_row(clause, clause.theme, theme, spec, scene, scope)
    if theme is not None and isinstance(clause.theme, Structure):
        theme = _with_further_letters(clause.theme, theme, scene)
        built, goals = make(clause.theme, spec, theme, scene, scope)
        if not set(built[0].members) & set(theme.names):
            raise refuse("order-misfit", "these blocks do not show these letters", clause.span, "use letter blocks")
        ref = Ref(names=built[0].members, built=tuple(built))
        return [*goals, *places(ref, spec, scene, scope, clause.span)]
    return shaped(clause, spec, scene, scope)


def _in_a_tower_still(clause: Clause, theme: Ref, scene: Scene) -> None:
    """Refuse "the letters are in a tower at first; afterwards they spell POT": in the tower, or in a row?"""
    begun = {n for x in scene.start_goals if isinstance(x, s.Stack) for n in x.blocks}
    piled = any(sense in ("stack", "build", "rebuild") for _, _, sense in scene.verbs.values())
    if {*theme.names} <= begun and not piled and clause.verb == "spell":
        raise refuse("ambiguous", "from top to bottom of the tower, or in a row?", clause.span, "say which")


def _with_further_letters(word: Structure, theme: Ref, scene: Scene) -> Ref:
    """ "The blocks spell CAT. Make them spell CUT": those of its letters that the other word has, and further ones."""
    begun = any(isinstance(x, s.Spells) and {*x.blocks} == {*theme.names} for x in scene.start_goals)
    wanted, free = Counter(word.letter or ""), list(theme.names)
    lacking = wanted - Counter(scene.things[n].label or "" for n in free)
    if not begun or not lacking or lacking.total() == wanted.total():
        return theme
    kept = [n for n in free if wanted[scene.things[n].label or ""] > 0]
    if len(kept) + lacking.total() != wanted.total():
        return theme  # a letter that there are several of
    more = [create(Traits(labels=(letter,)), scene, False).name for letter in lacking.elements()]
    return replace(theme, names=(*kept, *more), built=())


_LINES = ("stack", "row", "line", "column")


def _of_line(line: Structure, spec: Spec, scene: Scene, scope: Scope) -> Ref | None:
    """ "the tower spells DOG": the tower that was spoken of, or the letters that it is to be made of, if any."""
    known = known_ones(line, scene) if line.det in ("the", "its") else []
    using = spec.usings.pop(0)
    if not known and _as_many_as_it_takes(line):
        spec.intos.insert(0, Into(structure=replace(line, det="a", members=None), span=using.span))
        spec.usings.insert(0, replace(using, members=line.members))
        return None
    if known or line.members is not None or line.sizes:
        if line.kind == "stack":
            spec.toward.append(Toward(axis="z", span=using.span))
        return refer(line, scene, scope)
    spec.intos.insert(0, Into(structure=replace(line, det="a"), span=using.span))
    letters = [m.ref for m in scene.mentions if m.role == "theme" and m.ref.names][-1:]
    return next((ref for ref in letters if all(scene.things[n].elastic for n in ref.names)), None)


def _as_many_as_it_takes(line: Structure) -> bool:
    """ "a tower of letter cubes (spells BOOK)": of so many as the word has letters."""
    of = line.members
    plain = isinstance(of, Noun) and of.plural and of.det == "bare" and of.amount is None and of.part_of is None
    return plain and not line.sizes and isinstance(of, Noun) and not of.traits.labels


def _of_its_own(word: Meaning | None, source: Meaning, scene: Scene) -> bool:
    """ "Spell DOG. Spell HELP with the letters evenly spaced": not those of another word, which do not spell it."""
    if not isinstance(word, Structure) or word.letter is None or not of_no_look(source):
        return False
    built = (*scene.built, *(b for m in scene.mentions for b in m.ref.built))
    of_words = {n for b in built if b.kind == "word" for n in b.members}
    shown = [t for t in scene.blocks() if t.label]
    lacking = Counter(word.letter) - Counter(t.label for t in shown if t.label)
    return bool(lacking) and all(t.name in of_words for t in shown)


def _mentioned(meaning: Meaning) -> bool:
    return isinstance(meaning, Pronoun) or (
        isinstance(meaning, Noun) and meaning.det in ("the", "all", "both", "these")
    )


def _read_row(clause: Clause, said: Noun, theme: Ref | None, spec: Spec, scene: Scene, scope: Scope) -> Goals:
    """ "their up-faces read A, B, C ...": a row in reading order."""
    labels = continued(said.traits.labels, None) if said.traits.open_ended else said.traits.labels
    if theme is not None and all(scene.things[n].elastic for n in theme.names):
        names = scene.fit(theme.names, len(labels))
        for name, label in zip(names, labels, strict=True):
            give(scene.things[name], Traits(labels=(label,)))
    else:
        names = refer(said, scene, scope).names
    spec.orders = [o for o in spec.orders if o.by not in ("label", "number", "ascending", "in_order")]
    spec.listed = True
    node = row_node(names, "line", spec, scene, scope, clause.span)
    order = node.order if node.order.by != "any" else Order(by="given", ranks=tuple((n,) for n in names), first="left")
    scene.assume("read from left to right")
    return [node.model_copy(update={"order": order, "readable": True, "axis": "y"})]
