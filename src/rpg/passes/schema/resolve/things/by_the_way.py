"""What a relative clause names in passing, for a pronoun that finds nothing else: "the red block that is behind the
blue one should be in front of it"."""

from __future__ import annotations

from rpg.language.meaning import Loc, Noun, Pronoun, replace
from rpg.passes.schema.resolve.things.refer import refer
from rpg.passes.schema.resolve.things.things import Premise
from rpg.passes.schema.resolve.things.world import Ref, Scene, Scope


def named_by_the_way(scene: Scene, scope: Scope) -> Ref | None:
    """The one thing that the relative clauses up to here name, of the start alone; None if there are more, or none.

    What is to be so at the end, "which is behind the blue one", would have to be so beside what is said of "it".
    """
    told = [(n, x, x.condition) for n, x in enumerate(scene.premises) if isinstance(x, Premise)]
    index, premise, condition = told[0] if len(told) == 1 else (0, None, None)
    if premise is None or not isinstance(condition, Loc) or premise.when != "start" or "asserted" in condition.mods:
        return None
    mark = condition.landmark
    if not isinstance(mark, Noun) or mark.plural or mark.det not in ("the", "a", "bare") or condition.second:
        return None
    found = refer(mark, scene, Scope(role="landmark", rel=condition.rel, start=scope.start))
    if len(found.names) != 1 or found.quant is not None:
        return None
    known = replace(condition, landmark=Pronoun(word=f"={found.names[0]}", span=mark.span))
    scene.premises[index] = replace(premise, condition=known)
    return found
