"""The objects and structures that an instruction has brought up so far."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator
from dataclasses import dataclass, field
from typing import Any

from rpg.core.diagnostics import Diagnostic, Label, Refusal, Span
from rpg.ir.goal import Goal
from rpg.ir.schema import MAX_BLOCKS
from rpg.ir.walk import names as names_in
from rpg.language.meaning import Amount, Meaning, Noun, Traits, replace

BEYOND = 4 * MAX_BLOCKS
"""How many objects are counted out before an instruction is refused for their number."""


@dataclass
class Thing:
    """A block or a patch while the instruction is read; what is not said yet is None.

    `plain`: it is said to show none. `open`: the symbols that it may show, where which one was left open. `barred`:
    colours that it is said not to have.
    """

    name: str
    patch: bool = False
    color: str | None = None
    label: str | None = None
    kind: str | None = None
    plain: bool = False
    quality: str | None = None
    edge: float | None = None
    size: str | None = None
    shape: str | None = None
    long: bool = False
    extent: tuple[float, float] | None = None
    extra: bool = False
    declared: bool = False
    scheme: str | None = None
    batch: int = 0
    faces: dict[str, str] | None = None
    claims: int = 0
    elastic: str | None = None
    invented: bool = False
    open: str = ""
    barred: frozenset[str] = frozenset()


@dataclass(frozen=True)
class Built:
    """A structure with its members; for ordered stacks from the bottom up, for rows from their first side. `form`: what
    is asked of a figure."""

    kind: str
    members: tuple[str, ...]
    ordered: bool
    span: Span
    key: int
    side: str | None = None
    form: Goal | None = None


@dataclass(frozen=True)
class Exclusive:
    """What holds `there` of no block of the task but of `names`. `traits`: of blocks that look so."""

    names: tuple[str, ...]
    there: Callable[[str], Goal]
    span: Span
    traits: Traits


@dataclass(frozen=True)
class Ref:
    """What a noun phrase stands for.

    `quant`: how many of `names` are meant, where it is not all ("exactly two of"). `op` "or": any of `parts`.
    `beyond`: "nothing else", "no other block": none besides those of which the same was said, if they look so.
    `not_acted_on`: "anything else", "all the others": where these are left alone, so are the landmarks of what is done.
    """

    names: tuple[str, ...] = ()
    patch: bool = False
    table: bool = False
    built: tuple[Built, ...] = ()
    quant: Amount | None = None
    det: str = "the"
    op: str = "and"
    parts: tuple[Ref, ...] = ()
    plural: bool = False
    each: bool = False
    listed: bool = False
    matching: bool = False
    everything: bool = False
    reciprocal: bool = False
    part: str | None = None
    beyond: Traits | None = None
    not_acted_on: tuple[str, ...] = ()
    span: Span = (0, 0)

    @property
    def mixed(self) -> bool:
        """ "one of the red blocks and two of the blue ones", "red and either blue or green": so many of each part."""
        return self.op == "and" and any(part.quant is not None or part.op in ("or", "xor") for part in self.parts)


@dataclass
class Mention:
    """An object spoken of: where, as what. `rel`: the relation that it is the landmark of; `word`: by which pronoun;
    `start`: in what is said of the start."""

    ref: Ref
    role: str
    clause: int
    rel: str = ""
    word: str = ""
    sentence: int = 0
    start: bool = False


@dataclass(frozen=True)
class Scope:
    """Where in the task a phrase stands: the start or the goal; blocks of the structure spoken of; the role.

    `rel`: the relation that it is the landmark of, with "not" in front where that is denied.
    """

    start: bool = False
    pool: tuple[str, ...] = ()
    role: str = "theme"
    need: int | None = None
    like_patch: bool = False
    given: bool = False
    need_each: int = 1
    share: bool = False
    rel: str = ""


@dataclass
class Scene:
    """Everything brought up so far, with the goals and assumptions it led to.

    `sides`: where structures stand that were built together, by key.
    `heights`: of towers that were built together, by their blocks; `lots`: their blocks where they were told apart.
    `vague`: blocks of which neither look nor number was said, though they have been given a colour; `painted`: those of
    which no look was said, so many as they are.
    `lenient`: of two orders for the same blocks the first is taken, to see what the task would be.
    `besides`: what "another" and "the other" stand for, each with its words.
    `surveyed`: all blocks of some look that there were when something was said of whichever there are.
    `later`: whether the sentence or clause is told of a later time than what stands ahead of it.
    `resting`: whether the clause tells of what lies on something, which no patch does.
    `describing`: whether the clause says how something is to be, and nothing of how it comes to be so.
    `excepted`: blocks that are left out of what all others form.
    `left_out`: blocks that are not to be used at all. `dealt`: blocks of which structures take a share each, and what
    is wrong where some are left over.
    `gathered`: blocks that are grouped by a verb alone, which may yet be told group by group.
    `kept`: what the verb "keep" asks for, each with what it says of the start.
    `ignored`: blocks that are said to be distractors, each with the words that say so.
    `stocked`: blocks of which it is said that there are such, so that not all need be used.
    `others_open`: where all others are spoken of, of which it is not said how many they are.
    `untouched`: blocks that are left as they are, which is more than where they are.
    `same_order`: lines that keep the order of the start, each with the side where it begins if that is told.
    `names_blocks`: whether some sentence says how blocks look or how many there are.
    `looks`: how many different looks of blocks are named. `colors`: all colours that are.
    `sized`: the size that is said of all blocks, with its words.
    `verbs`: where the verb of every clause stands, whether it is denied, and its sense.
    `owners`: the clauses that tell what a block has on it, or beside it.
    `topped`: structures on top of which something goes that are not named there.
    `all_but`: blocks of which all but some are spoken of.
    `taken`: the one on top of a tower of look-alikes that is there at first, with those under it.
    `regions`: the part of the table that a clause tells.
    `patch_sides`: patches by the side on which they lie, and where that was said last.
    `ranges`: symbols that are told by the first and the last of them. `in_any_order`: blocks of lines of which it is
    said that any order will do. `one_by_one`: words of which a letter is told apart from others that show the same.
    """

    things: dict[str, Thing] = field(default_factory=dict)
    built: list[Built] = field(default_factory=list)
    mentions: list[Mention] = field(default_factory=list)
    assumptions: dict[str, None] = field(default_factory=dict)
    goals: dict[int, list[Goal]] = field(default_factory=dict)
    start_goals: list[Goal] = field(default_factory=list)
    heaps: list[tuple[str, ...]] = field(default_factory=list)
    gathered: set[frozenset[str]] = field(default_factory=set)
    used: set[str] = field(default_factory=set)
    clause: int = 0
    verbs: dict[int, tuple[Span | None, bool, str]] = field(default_factory=dict)
    owners: set[int] = field(default_factory=set)
    sentence: int = 0
    counter: int = 0
    batch: int = 0
    last_landmark_patch: bool = False
    last_landmark_at: int = 0
    alike: bool = False
    universals: list[tuple[int, tuple[str, ...], Span]] = field(default_factory=list)
    region: str = ""
    region_at: int = -1
    regions: dict[int, str] = field(default_factory=dict)
    told: set[str] = field(default_factory=set)
    on_top: dict[str, str] = field(default_factory=dict)
    begun_on: set[str] = field(default_factory=set)
    on_bare: set[str] = field(default_factory=set)
    placing: bool = False
    later: bool = False
    denying: bool = False
    describing: bool = False
    resting: bool = False
    premises: list[Meaning] = field(default_factory=list)
    picked: Span | None = None
    speaks_of_rest: bool = False
    others_open: Span | None = None
    on_clause: dict[str, int] = field(default_factory=dict)
    parted: set[str] = field(default_factory=set)
    whole: tuple[str, ...] = ()
    closed: list[tuple[Traits, int, Span]] = field(default_factory=list)
    tallied: set[str] = field(default_factory=set)
    stocked: set[str] = field(default_factory=set)
    untouched: set[str] = field(default_factory=set)
    one_by_one: dict[tuple[str, ...], Span] = field(default_factory=dict)
    same_order: list[tuple[tuple[str, ...], str | None, Span]] = field(default_factory=list)
    each: tuple[int, Span] | None = None
    each_in: int = 0
    spare: set[str] = field(default_factory=set)
    vague: set[str] = field(default_factory=set)
    painted: set[str] = field(default_factory=set)
    sides: dict[int, str] = field(default_factory=dict)
    heights: dict[tuple[str, ...], tuple[int, ...]] = field(default_factory=dict)
    lots: dict[tuple[str, ...], tuple[tuple[str, ...], ...]] = field(default_factory=dict)
    free_runs: dict[tuple[tuple[str, ...], ...], tuple[int, ...]] = field(default_factory=dict)
    loose: list[tuple[Ref, Meaning, Span]] = field(default_factory=list)
    untimed: list[tuple[Ref, Meaning, Span]] = field(default_factory=list)
    denied: list[tuple[Ref, Meaning, Span]] = field(default_factory=list)
    only: list[str] = field(default_factory=list)
    held: dict[str, Span] = field(default_factory=dict)
    exclusive: list[Exclusive] = field(default_factory=list)
    topped: list[Built] = field(default_factory=list)
    all_but: list[tuple[str, ...]] = field(default_factory=list)
    taken: dict[str, tuple[str, ...]] = field(default_factory=dict)
    returned: set[str] = field(default_factory=set)
    unstacked: set[str] = field(default_factory=set)
    excepted: set[str] = field(default_factory=set)
    left_out: set[str] = field(default_factory=set)
    dealt: list[tuple[tuple[str, ...], Refusal]] = field(default_factory=list)
    lenient: bool = False
    besides: list[tuple[Traits, Ref, Span]] = field(default_factory=list)
    surveyed: list[tuple[Traits, tuple[str, ...], Span]] = field(default_factory=list)
    kept: list[tuple[Goal, list[Goal]]] = field(default_factory=list)
    names_blocks: bool = False
    opposites: bool = False
    looks: int = 0
    colors: frozenset[str] = frozenset()
    sized: tuple[Traits, Span] | None = None
    ignored: dict[str, Span] = field(default_factory=dict)
    patch_sides: dict[str, str] = field(default_factory=dict)
    patch_sides_at: Span = (0, 0)
    ranges: frozenset[tuple[str, ...]] = frozenset()
    in_any_order: set[frozenset[str]] = field(default_factory=set)

    def assume(self, text: str) -> None:
        """Record a default that was taken."""
        self.assumptions.setdefault(text)

    def fresh(self, **traits: Any) -> Thing:
        """A new object."""
        self.counter += 1
        if self.counter > BEYOND:
            raise refuse(
                "too-many-blocks",
                f"this takes more than {BEYOND} blocks; a task has at most {MAX_BLOCKS}",
                None,
                f"use at most {MAX_BLOCKS} blocks",
                limit=MAX_BLOCKS,
            )
        thing = Thing(name=f"_{self.counter}", batch=self.batch, **traits)
        self.things[thing.name] = thing
        return thing

    def new_batch(self) -> int:
        """Objects introduced by one phrase share a batch, so that "different colours" can be kept among them."""
        self.batch += 1
        return self.batch

    def blocks(self) -> Iterator[Thing]:
        yield from (t for t in self.things.values() if not t.patch)

    def fit(self, names: tuple[str, ...], need: int | None) -> tuple[str, ...]:
        """`names`, with as many blocks as are needed where their number was left open."""
        things = [self.things[n] for n in names]
        if need is None or len(names) == need or not names or any(t.elastic is None for t in things) or need < 1:
            return names
        if any(set(names) & set(names_in(goal)) for goal in self.start_goals):
            raise refuse(
                "count-mismatch",
                f"at the start there are {len(names)} of these blocks, then {need}",
                None,
                "say how many there are from the start on",
            )
        for name in names[need:]:
            del self.things[name]
        kept = list(names[:need])
        while len(kept) < need:
            like = things[0]
            more = self.fresh(
                kind=like.kind,
                color=like.color,
                scheme=like.scheme,
                elastic=like.elastic,
                size=like.size,
                edge=like.edge,
                quality=like.quality,
            )
            more.batch = like.batch
            kept.append(more.name)
        for mention in self.mentions:
            if set(mention.ref.names) == set(names):
                mention.ref = replace(mention.ref, names=tuple(kept))
        self.heaps = [tuple(kept) if set(heap) == set(names) else heap for heap in self.heaps]
        return tuple(kept)

    def mention(self, ref: Ref, role: str, rel: str = "", word: str = "", start: bool = False) -> None:
        """Remember what was spoken of, for pronouns."""
        self.mentions.append(Mention(ref, role, self.clause, rel, word, self.sentence, start))

    def stacked(self, upper: str, lower: str, span: Span) -> None:
        """One block was put on another: together, and with the stack that the lower one tops, they are a tower."""
        self.on_top[upper] = lower
        self.on_clause[upper] = self.clause
        under = next((b for b in self.built if b.kind == "stack" and b.ordered and b.members[-1] == lower), None)
        over = next((b for b in self.built if b.kind == "stack" and b.ordered and b.members[0] == upper), None)
        members = (*(under.members if under else (lower,)), *(over.members if over else (upper,)))
        self.built = [b for b in self.built if b is not under and b is not over]
        self.add_built("stack", members, True, span)

    def named_again(self, said: Meaning, ref: Ref) -> None:
        """What is said of a block that was put on another is said of itself then, not of what carries it."""
        for name in ref.names if isinstance(said, Noun) and not ref.built else ():
            self.on_clause.pop(name, None)

    def add_built(
        self, kind: str, members: Iterable[str], ordered: bool, span: Span, side: str | None = None,
        form: Goal | None = None,
    ) -> Built:  # fmt: skip
        """Remember a structure."""
        built = Built(kind, tuple(members), ordered, span, len(self.built), side, form)
        self.built.append(built)
        return built


def refuse(code: str, message: str, span: Span | None = None, hint: str | None = None, **more: Any) -> Refusal:
    """A refusal with one diagnostic. `labels`: further places as (span, text)."""
    labels = tuple(Label(span=s, text=t) for s, t in more.pop("labels", ()))
    return Refusal(
        [Diagnostic(code=code, message=message, span=span, hint=hint, labels=labels, facts=more, origin="schema")]
    )  # fmt: skip


class WhichOne(Refusal):
    """Which of several things a phrase stands for is not clear by what it says of one of them alone."""


def which_one(message: str, span: Span | None, hint: str) -> WhichOne:
    """A refusal with the question which one is meant."""
    return WhichOne(refuse("ambiguous", message, span, hint).diagnostics)


def said(thing: Thing) -> str:
    """A short description of an object for messages."""
    if thing.patch:
        return f"the {thing.color + ' ' if thing.color else ''}patch"
    if thing.label:
        return f"the block {thing.label}"
    words = [w for w in (thing.size, thing.color, {"letter": "letter", "digit": "number"}.get(thing.kind or "")) if w]
    return " ".join(["the", *words, "block"])
