""" "Replace the red block with a blue one": what holds of the one at the start holds of the other at the end."""

from __future__ import annotations

from rpg.core.diagnostics import Span
from rpg.ir import goal as g
from rpg.ir import relations as r
from rpg.ir import structures as s
from rpg.ir.order import Order
from rpg.ir.schema import REPLACED
from rpg.ir.walk import names as names_in
from rpg.ir.walk import rename
from rpg.language.meaning import Clause
from rpg.passes.schema.resolve.clauses.spec import Spec
from rpg.passes.schema.resolve.things.refer import refer
from rpg.passes.schema.resolve.things.world import Ref, Scene, Scope, refuse, which_one


def replace_there(clause: Clause, spec: Spec, scene: Scene, scope: Scope) -> list[g.Goal]:
    """The goals of a clause that puts one block in the place of another, which is not there any more."""
    if clause.theme is None or len(spec.usings) != 1 or clause.negated:
        raise refuse("misplaced", "it is not said what is replaced by what", clause.span, "name both blocks")
    old = _single(refer(clause.theme, scene, scope), clause.span)
    new = _single(refer(spec.usings.pop(0).members, scene, scope), clause.span)
    there = [start for start in scene.start_goals if old in names_in(start)]
    if not there or any(old in heap for heap in scene.heaps):
        raise refuse("no-referent", "it is not said where the block that is replaced is at the start", clause.span,
                     "say first where it is")  # fmt: skip
    if any(new in names_in(start) for start in there):
        raise refuse("ambiguous", "both of these blocks are there at the start", clause.span,
                     "say 'swap', or where each of them should be")  # fmt: skip
    if any(_anywhere(start, scene) for start in there):
        raise refuse("ambiguous", "it is not said where in the line the block that is replaced stands", clause.span,
                     "say the order of the line, 'from left to right' or 'from bottom to top'")  # fmt: skip
    scene.assume(REPLACED)
    return [goal for start in there for goal in _in_its_place(start, old, new, scene, clause.span)]


def _anywhere(start: g.Goal, scene: Scene) -> bool:
    """Whether the blocks of a line look different and are in no order, so that none of them has a place."""
    if not isinstance(start, s.Stack | s.Row) or start.order.by != "any":
        return False
    return len({(scene.things[n].color, scene.things[n].label) for n in start.blocks}) > 1


def _single(ref: Ref, span: Span) -> str:
    if len(ref.names) != 1 or ref.patch or ref.quant is not None or ref.op != "and":
        raise which_one("it is not clear which block is replaced by which", span, "name one block for one")
    return ref.names[0]


def _in_its_place(start: g.Goal, old: str, new: str, scene: Scene, span: Span) -> list[g.Goal]:
    """What the start says, of the new block; and that the old one is not on what it was on."""
    told = rename(start, {old: new}).model_copy(update={"span": span})
    gone: list[g.Goal] = []
    if isinstance(told, s.Stack):
        told = told.model_copy(update={"exact": True})
        if told.order.by == "any":  # of blocks that look alike: the new one may look different
            order = Order(by="given", ranks=tuple((name,) for name in told.blocks), first="bottom")
            told = told.model_copy(update={"order": order})
    if isinstance(told, s.Spells):
        told = told.model_copy(update={"word": _respelled(told.word, old, new, scene, span)})
    if isinstance(told, s.Equation):
        raise refuse("ambiguous", "another symbol in it makes it another equation", span, "write it as it should be")
    if isinstance(start, r.OnPatch) and start.a == (old,):
        gone = [g.Not(goal=start.model_copy(update={"span": span}), span=span)]
    if isinstance(start, r.On | r.Above) and (old,) in (start.a, start.b):
        gone = [g.Not(goal=r.Above(a=start.a, b=start.b, span=span), span=span)]
    return [told, *gone]


def _respelled(word: str, old: str, new: str, scene: Scene, span: Span) -> str:
    """The word with one letter in the place of another."""
    before, after = scene.things[old].label, scene.things[new].label
    if before is None or after is None or word.count(before) != 1:
        raise refuse("ambiguous", "it is not clear what the word is then", span, "write the word as it should be")
    return word.replace(before, after)
