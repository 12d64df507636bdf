"""Gate 4: what the goal demands of support. No cycles, everything grounded, what is said twice is noted."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import dataclass
from itertools import product

from rpg.blocks.predicates import PREDICATES
from rpg.blocks.state import World
from rpg.core.diagnostics import Diagnostic, Label, Span
from rpg.ir import goal as g
from rpg.ir.artifact import GateReport, Program
from rpg.ir.node import Operand
from rpg.ir.relations import Above
from rpg.passes.validate.bench import Bench
from rpg.passes.validate.findings import failure, note

TABLE = "table"


@dataclass(frozen=True)
class Edge:
    """`top` rests on `under`, as the atom at `span` demands; not `direct`: perhaps with others between."""

    top: str
    under: str
    direct: bool
    span: Span | None


@dataclass(frozen=True)
class ConstraintGate:
    """A digraph of the supports that the goal demands in every case."""

    name: str = "constraint"
    cost: int = 1

    def check(self, program: Program, bench: Bench) -> GateReport:
        """Look for cycles, blocks without a path to the ground, and demands that others imply."""
        groups = list(demands(program.task.goal, bench.world))
        found: list[Diagnostic] = []
        for edges in groups:
            found += self._judge(edges, bench.world)
        edges = [edge for group in groups for edge in group]
        cycles = sum(d.code == "support-cycle" for d in found)
        return GateReport.of(self.name, found, support_edges=len(edges), cycles=cycles)

    def _judge(self, edges: list[Edge], world: World) -> list[Diagnostic]:
        below: dict[str, set[str]] = {}
        for edge in edges:
            below.setdefault(edge.top, set()).add(edge.under)
        cycle = find_cycle(below)
        if cycle:
            return [self._cycle(cycle, edges)]
        floating = [name for name in world.blocks if not grounded(name, below, world)]
        found = [
            failure(
                self.name,
                "unsupported-block",
                "constraint",
                f"{name} rests on nothing that reaches the table",
                span=next((edge.span for edge in edges if edge.top == name), None),
                block=name,
            )
            for name in floating
        ]
        return found + [self._redundant(edge) for edge in redundant(edges)]

    def _cycle(self, cycle: list[str], edges: list[Edge]) -> Diagnostic:
        pairs = list(zip(cycle, [*cycle[1:], cycle[0]], strict=True))
        spans = [edge.span for pair in pairs for edge in edges if (edge.top, edge.under) == pair and edge.span]
        chain = " on ".join([*cycle, cycle[0]])
        labels = tuple(Label(span=span, text="and this") for span in dict.fromkeys(spans[1:]))
        found = failure(
            self.name,
            "support-cycle",
            "constraint",
            f"the goal goes round in a circle: {chain}",
            span=spans[0] if spans else None,
            hint="leave out one of these relations, or turn it round",
            cycle=cycle,
        )
        return found.model_copy(update={"labels": labels})

    def _redundant(self, edge: Edge) -> Diagnostic:
        message = f"{edge.top} above {edge.under} follows from other parts of the goal"
        return note(self.name, "redundant-predicate", message, edge.span, top=edge.top, under=edge.under)


def demands(goal: g.Goal, world: World) -> Iterator[list[Edge]]:
    """The supports that hold together: one group per stage of a sequence, what is demanded anyway in each of them."""
    stages = [part for part in conjuncts(goal) if isinstance(part, g.Sequence)]
    fixed = list(_edges((part for part in conjuncts(goal) if not isinstance(part, g.Sequence)), world))
    moments = [stage.goal for sequence in stages for stage in sequence.stages]
    if not moments:
        yield fixed
    for moment in moments:
        yield [*fixed, *_edges(conjuncts(moment), world)]


def conjuncts(goal: g.Goal) -> Iterator[g.Goal]:
    """The parts that all have to hold."""
    match goal:
        case g.All():
            for part in goal.goals:
                yield from conjuncts(part)
        case g.Always():
            yield from conjuncts(goal.goal)
        case _:
            yield goal


def _edges(parts: Iterable[g.Goal], world: World) -> Iterator[Edge]:
    for part in parts:
        if isinstance(part, Above):
            pairs = product(_names(part.a), _names(part.b))
            yield from (Edge(top, under, False, part.span) for top, under in pairs)
        elif part.kind in PREDICATES:
            yield from (Edge(*pair, True, part.span) for pair in PREDICATES[part.kind].supports(part, world))


def _names(operand: Operand) -> tuple[str, ...]:
    """The blocks an operand is sure to stand for."""
    return operand if isinstance(operand, tuple) else ()


def find_cycle(below: dict[str, set[str]]) -> list[str]:
    """A cycle of the digraph, empty where there is none. Deterministic: nodes in order of their names."""
    done: set[str] = set()
    for root in sorted(below):
        path: list[str] = []
        stack = [(root, iter(sorted(below.get(root, ()))))] if root not in done else []
        path = [root] if stack else []
        while stack:
            node, rest = stack[-1]
            step = next(rest, None)
            if step is None:
                done.add(node)
                stack.pop()
                path.pop()
            elif step in path:
                return path[path.index(step) :]
            elif step not in done:
                path.append(step)
                stack.append((step, iter(sorted(below.get(step, ())))))
    return []


def grounded(name: str, below: dict[str, set[str]], world: World) -> bool:
    """Does a path of supports lead from a block to the table? One of which nothing is demanded lies on the table."""
    frontier, seen = [name], {name}
    while frontier:
        node = frontier.pop()
        if node == TABLE or node in world.patches or (node in world.blocks and not below.get(node)):
            return True
        new = below.get(node, set()) - seen
        seen |= new
        frontier += sorted(new)
    return False


def redundant(edges: list[Edge]) -> list[Edge]:
    """Demands that are made twice, or that a chain of other ones implies."""
    found = []
    for index, edge in enumerate(edges):
        same = any((o.top, o.under, o.direct) == (edge.top, edge.under, edge.direct) for o in edges[:index])
        others = [o for k, o in enumerate(edges) if k != index]
        implied = not edge.direct and edge.under != TABLE and _reaches(edge.top, edge.under, others)
        if same or implied:
            found.append(edge)
    return found


def _reaches(top: str, under: str, edges: list[Edge]) -> bool:
    frontier, seen = [top], {top}
    while frontier:
        node = frontier.pop()
        for edge in edges:
            if edge.top == node and edge.under not in seen:
                if edge.under == under:
                    return True
                seen.add(edge.under)
                frontier.append(edge.under)
    return False
