"""What a sentence names of the task at hand: "the red block", "the tower", "the letters"."""

from __future__ import annotations

from collections.abc import Iterable, Iterator

from rpg.core.diagnostics import Diagnostic, Refusal
from rpg.ir.schema import TaskSchema
from rpg.steer.draft import Draft
from rpg.steer.matching import matches
from rpg.steer.refer import exists, resolve
from rpg.steer.requests.language import Parser, m, noun_phrase, tokenize
from rpg.steer.view import View


def only_known(draft: Draft, request: str, begin: int) -> None:
    """Refuse "the ..." of what the task does not have: as one more sentence of a text it would bring it in."""
    for named in _definite(request, begin):
        if not any(_there(draft, noun) for noun in named):
            resolve(draft.view, named[0])


def only_new(draft: Draft, request: str, begin: int, schema: TaskSchema) -> None:
    """Refuse "a red block" where the longer text took it for a red block that is there: an edit adds one so."""
    p = Parser(tokenize(request)[0])
    new = View(schema)
    for i in range(p.end):
        if p.tokens[i].span[0] < begin or p.words[i] not in ("a", "an", "another"):
            continue
        named = [noun for noun, _ in noun_phrase(p, i) if isinstance(noun, m.Noun) and noun.traits != m.Traits()]
        named = [noun for noun in named if noun.det in ("a", "another")]
        if named and not any(_number(new, noun) > _number(draft.view, noun) for noun in named):
            told, hint = "the task has one like this already", "say 'the ...' for that one, or 'add ...' for one more"
            found = Diagnostic(code="edit-unclear", message=told, span=named[0].span, hint=hint, origin="steer")
            raise Refusal([found])


def _number(view: View, noun: m.Noun) -> int:
    """How many objects a task has that look as a phrase says."""
    return sum(matches(view, name, noun.traits) for name in view.world.assets)


def _there(draft: Draft, noun: m.Noun) -> bool:
    """Whether the task has what a phrase could speak of, be it one or several."""
    return bool(_kinds(draft.view, noun))


def _kinds(view: View, noun: m.Noun) -> set[str]:
    """The types of the objects of a task that a phrase could speak of: blocks, patches, or both."""
    world = view.world
    there: Iterable[str] = world.assets
    if noun.head in ("patch", "block"):
        there = world.patches if noun.head == "patch" else world.blocks
    return {world.assets[name].type for name in there if matches(view, name, noun.traits)}


def of_another_kind(draft: Draft, request: str, task: TaskSchema) -> bool:
    """Whether a request says "the blue" of a patch of the task at hand, and would bring a blue block as a text."""
    new = View(task)
    pairs = ((_kinds(draft.view, noun), _kinds(new, noun)) for named in _definite(request, 0) for noun in named)
    return any(here and there and not here & there for here, there in pairs)


def names_structure(draft: Draft, request: str) -> bool:
    """Whether a sentence says "the tower", "the circle" of one that the task builds."""
    return any(exists(draft.view, structure) for structure in _structures(request))


def mentions_known(draft: Draft, request: str) -> bool:
    """Whether a sentence says "the ..." of anything that the task has."""
    known = any(exists(draft.view, noun) for named in _definite(request, 0) for noun in named)
    return known or names_structure(draft, request)


def names_look(draft: Draft, request: str) -> bool:
    """Whether a sentence says "the red block" of one or several that the task has."""
    return any(_there(draft, noun) for named in _definite(request, 0) for noun in named)


def speaks_of_kinds(draft: Draft, request: str) -> bool:
    """Whether a sentence says "the letters", "all digits", "the vowels" of some that the task has."""
    p = Parser(tokenize(request)[0])
    for i in range(p.end):
        if p.words[i] in ("the", "all", "every", "each", "both", "these"):
            named = [noun for noun, _ in noun_phrase(p, i) if isinstance(noun, m.Noun) and _of_a_kind(noun.traits)]
            if any(_there(draft, noun) for noun in named):
                return True
    return False


def _of_a_kind(traits: m.Traits) -> bool:
    return bool(traits.kind or traits.quality) and not traits.labels and not traits.colors


_EVERY = frozenset({"per", "each", "every", "of"})


def _structures(request: str) -> Iterator[m.Structure]:
    """Every phrase such as "the tower", "the circle", and "make one tower ..." of several."""
    p = Parser(tokenize(request)[0])
    for i in range(p.end):
        one = p.words[i] == "one" and p.words[i - 1] in ("make", "paint", "color", "turn")
        one = one and _EVERY.isdisjoint(p.words[i : p.end])
        if one or p.words[i] in ("the", "each", "every"):
            yield from (found for found, _ in noun_phrase(p, i) if isinstance(found, m.Structure))


def _definite(request: str, begin: int) -> Iterator[list[m.Noun]]:
    """The readings of every phrase with "the" that says a colour or a symbol."""
    p = Parser(tokenize(request)[0])
    for i in range(p.end):
        if p.tokens[i].span[0] >= begin and p.words[i] == "the":
            named = [noun for noun, _ in noun_phrase(p, i) if isinstance(noun, m.Noun)]
            told = [noun for noun in named if noun.traits.colors or noun.traits.labels]
            if told:
                yield told
