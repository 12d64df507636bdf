"""All the others, where nothing says how many there are: "red to the right of all the other blocks", "do not move the
blue one, put the rest on the mat". As of "all the blocks", their number is assumed."""

from __future__ import annotations

from rpg.core.diagnostics import Span
from rpg.language.meaning import Chain, Clause, Manner, Meaning, Noun, Pronoun, That, Traits, parts_of
from rpg.passes.schema.resolve.things.things import create, matching
from rpg.passes.schema.resolve.things.world import Ref, Scene, Thing

_ALL = frozenset({"all others", "all the others", "all the rest", "everything else"})
_REST = frozenset({"the others", "the rest", "the other ones", "the remaining ones", "others"})
_LEFT = ("keep", "touch")
_DISTURB = frozenset({"move", "touch"})
OTHERS = 3
"""So many are "all the others"."""


def others_left_open(chains: tuple[Chain, ...]) -> Span | None:
    """Where all others are spoken of, of which no more is said, while all that is named is named one by one."""
    clauses = [clause for chain in chains for clause in chain.clauses]
    parts = parts_of(tuple(clauses))
    found = [part for part in parts if _all_others(part) or _the_rest(part)]
    if len(found) != 1 or not all(isinstance(c, Clause) and c.mode not in ("given", "start") for c in clauses):
        return None
    rest = found[0]
    here = next(n for n, clause in enumerate(clauses) if rest in parts_of(clause))
    named = [part for part in parts if isinstance(part, Noun) and part.head != "patch" and part is not rest]
    first = [part for clause in clauses[: here + 1] for part in parts_of(clause)]
    if not named or not all(_known(noun) and any(noun is part for part in first) for noun in named):
        return None
    before = [part for clause in clauses[:here] for part in parts_of(clause)]
    own = _theme(clauses[here]) is not rest
    if own and any(isinstance(part, Noun) and part in named for part in before):
        return None  # "red, green and blue are on the mat; red is left of all others" is of these
    if any(rest in parts_of(part) for part in getattr(clauses[here], "adjuncts", ()) if isinstance(part, That)):
        return rest.span if _spared(clauses[here], rest) else None
    alone = any(map(_stays, clauses[:here])) or _stays(clauses[here])
    return rest.span if _all_others(rest) or (alone and not own) else None


def made_up(span: Span, left: list[Thing], scene: Scene, patch: bool) -> Ref | None:
    """The blocks that these are; None where no such others are spoken of there, or some of those named are `left`."""
    some = bool(left) and {t.name for t in left} != {t.name for t in scene.blocks()}
    if scene.others_open != span or patch or some or any(t.declared for t in scene.things.values()):
        return None
    scene.new_batch()
    made = [create(Traits(), scene, False) for _ in range(OTHERS)]
    names = tuple(thing.name for thing in made)
    for thing in made:
        thing.claims += 1  # none of them is the red block that is named behind
    scene.assume(f"how many other blocks there are is not said: {OTHERS}")
    scene.used.update(names)
    scene.parted.update(names)
    return Ref(names=names, plural=True)


def not_acted_on(scene: Scene) -> tuple[str, ...]:
    """The blocks that were named as what others are put on, or beside, and of which nothing else is wanted."""
    there = [m for m in scene.mentions if not m.ref.patch and not m.start and m.role != "given"]
    moved = {n for m in there if m.role != "landmark" for n in m.ref.names}
    return tuple(dict.fromkeys(n for m in there for n in m.ref.names if n not in moved))


def of_the_start(noun: Noun, scene: Scene, patch: bool) -> list[Thing]:
    """ "Green is on blue and blue on red. Put green on the table; leave the others": those of which no more was said
    than how they start."""
    if patch or noun.det != "other" or not noun.plural or noun.traits != Traits():
        return []
    begun = {n for m in scene.mentions for n in m.ref.names if m.start}
    said = {n for m in scene.mentions for n in m.ref.names if not m.start} | scene.used
    new = {t.name for t in scene.blocks() if not t.declared and t.name in said - begun}
    left = [t for t in matching(noun.traits, scene, patch) if t.name in begun - said]
    return left if begun & said and not new and len(left) > 1 else []


def _all_others(part: Meaning) -> bool:
    if isinstance(part, Pronoun):
        return part.word in _ALL
    other = isinstance(part, Noun) and part.det == "other" and part.head == "block" and part.plural
    return other and isinstance(part, Noun) and part.traits == Traits() and part.amount is None


def _the_rest(part: Meaning) -> bool:
    return isinstance(part, Pronoun) and part.word in _REST


def _known(noun: Noun) -> bool:
    """ "The red block", "red": of which there is one, and it has a look to know it by."""
    single = not noun.plural and noun.det in ("the", "a", "bare") and noun.part_of is None and not noun.conditions
    return single and bool(noun.traits.colors or noun.traits.labels or noun.traits.size) and not noun.traits.rank


def _theme(clause: Meaning) -> Meaning | None:
    return clause.theme if isinstance(clause, Clause) else None


def _stays(clause: Meaning) -> bool:
    """ "Leave the blue one where it is", "do not touch it"."""
    if not isinstance(clause, Clause):
        return False
    stays = any(isinstance(part, Manner) and part.kind == "stay" for part in clause.adjuncts)
    unmoved = clause.lemma == "move" and clause.negated and not clause.adjuncts
    return stays or unmoved or (clause.verb in _LEFT and clause.negated == (clause.verb == "touch"))


def _spared(clause: Meaning, rest: Meaning) -> bool:
    """ "Put the red one on the mat without touching any other block"."""
    if not isinstance(clause, Clause) or clause.mode != "command":
        return False  # "it should be on the mat without touching any other block": of how it stands there
    behind = [part for part in clause.adjuncts if isinstance(part, That)]
    told = [one for that in behind if that.kind == "without" for one in parts_of(that) if isinstance(one, Clause)]
    return any(one.theme is rest and not one.adjuncts and one.lemma in _DISTURB for one in told)
