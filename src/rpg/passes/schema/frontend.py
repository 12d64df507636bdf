"""The built-in front end: English instruction -> TaskSchema, or what is wrong with it. No network, no chance."""

from __future__ import annotations

import gc
from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager, suppress
from itertools import chain, islice
from typing import Protocol

from rpg.core.diagnostics import Diagnostic, Refusal
from rpg.ir.schema import TaskSchema
from rpg.language.begun_ahead import begun_ahead, stands_first
from rpg.language.body_widths import in_centimetres
from rpg.language.called import without_names
from rpg.language.chat import as_typed
from rpg.language.clauses_apart import MOST, clauses_apart
from rpg.language.clauses_left_out import clauses_left_out
from rpg.language.code_lists import with_lists
from rpg.language.color_classes import with_color_classes
from rpg.language.compose import composed_ways
from rpg.language.feelings import without_feelings
from rpg.language.figures_called import with_figures
from rpg.language.formulas import formulas_told
from rpg.language.frames import retold
from rpg.language.glosses import without_glosses
from rpg.language.grammar.talk.asides import without_asides
from rpg.language.grammar.talk.begun_with import with_beginnings
from rpg.language.grammar.talk.line_told_behind import line_told_behind
from rpg.language.grammar.talk.numbers_told import digits_named
from rpg.language.grammar.talk.one_by_one import one_by_one
from rpg.language.grammar.talk.one_of_each_color import one_of_each_color
from rpg.language.grammar.talk.one_or_other import one_or_the_other
from rpg.language.grammar.talk.shape_last import shape_ahead
from rpg.language.grammar.talk.that_is import that_is
from rpg.language.grammar.talk.written_rows import rows_in_words
from rpg.language.introduced import with_names
from rpg.language.inventories import stocks_ahead, told_behind, told_plainly
from rpg.language.inventories.symbols_behind import symbols_behind
from rpg.language.kinds_counted import with_kinds
from rpg.language.materials import without_materials
from rpg.language.mats_chosen import mats_chosen
from rpg.language.open_colors import with_colors
from rpg.language.pictured import without_pictures
from rpg.language.praise import without_praise
from rpg.language.remarks import without_remarks
from rpg.language.said_once import said_of_each
from rpg.language.singled_out import singled_out
from rpg.language.spelling import read_words
from rpg.language.spliced import in_one_sentence, in_sentences, ordered_behind, run_together, stock_last
from rpg.language.stories.told import as_a_story
from rpg.language.titles import title, untitled
from rpg.language.tokens import Stray, Token, tokenize
from rpg.passes.schema.ambiguity import TwoReadings, same
from rpg.passes.schema.build import build
from rpg.passes.schema.either_task import either_task
from rpg.passes.schema.feasibility import Repairable, suggestions
from rpg.passes.schema.guard import guard
from rpg.passes.schema.hints import explained
from rpg.passes.schema.misspelt import ways_meant
from rpg.passes.schema.namings_had import check_namings
from rpg.passes.schema.nothing_more import MOST as MOST_MORE
from rpg.passes.schema.nothing_more import without_more
from rpg.passes.schema.order_told import check_one_order, check_order
from rpg.passes.schema.resolve.things.world import WhichOne
from rpg.passes.schema.respelt import Respelt
from rpg.passes.schema.said_behind import check_behind
from rpg.passes.schema.second_opinion import check_guess
from rpg.passes.schema.told_there import check_none_added, check_numbers, check_told, check_wanted

Reading = tuple[TaskSchema | None, tuple[Diagnostic, ...]]


class FrontEnd(Protocol):
    """Reads an instruction. `name`: the family's, from the goal if None."""

    def read(self, text: str, *, name: str | None = None, seed: int = 0, author: str | None = None) -> Reading:
        """The task, or None with the diagnostics that say why not."""


_Shorter = tuple[tuple[list[Token], list[Stray]], list[str], Callable[[TaskSchema], bool]]
"""A text without a clause of it, notes of that, and whether a task says what was said in the clause."""


class BuiltinFrontEnd:
    """Words, grammar, resolution, feasibility: deterministic, bounded, and silent about nothing."""

    def read(self, text: str, *, name: str | None = None, seed: int = 0, author: str | None = None) -> Reading:
        """The task with notes of how it was adapted, or None with the diagnostics that say why not."""
        try:
            with _undisturbed():
                return self._read(text, name, seed, author)
        except Repairable as refusal:
            return None, suggestions(refusal, lambda other: self._again(other, name, seed, author))
        except TwoReadings as refusal:
            return None, refusal.reworded(lambda other: self._again(other, name, seed, author))
        except Refusal as refusal:
            return None, explained(text, refusal.diagnostics)
        except RecursionError:
            message, hint = "this is too tangled to be read", "use several short sentences"
            return None, (
                Diagnostic(code="too-complex", message=message, span=(0, len(text)), hint=hint, origin="schema"),
            )

    def _read(
        self, text: str, name: str | None, seed: int, author: str | None, mended: list[str] | None = None
    ) -> Reading:
        """`mended`: notes of the misspelt words that were mended in the text.

        A text that is not understood is read without the remarks in it, if that is.
        """
        guard(text)
        tokens, strays = tokenize(text)
        told = formulas_told(as_typed(tokens), strays)
        try:
            found = self._read_tokens(told, text, name, seed, author, mended)
            refusal = None
        except Refusal as raised:
            found, refusal = (None, raised.diagnostics), raised
        plain = without_remarks(told[0]) if found[0] is None else None
        if plain is not None:
            rest, remarks = plain
            with suppress(Refusal):
                kept = (rest, _strays_of(rest, *told))
                task, notes = self._read_tokens(kept, text, name, seed, author, mended, remarks)
                if task is not None:
                    return task, notes
        if found[0] is None:
            found = self._either_way(told, text, name, seed, author, mended) or found
        chosen = isinstance(refusal, Repairable | TwoReadings)
        code = refusal.diagnostics[0].code if refusal is not None else found[1][0].code if found[1] else ""
        ways = [*(() if chosen else _SPLICED), *((begun_ahead,) if code in _CANNOT_BOTH_BE else ())]
        for parted in (way(told[0]) for way in ways if found[0] is None):
            if parted is None:
                continue
            with suppress(Refusal):
                task, notes = self._read_tokens((parted, told[1]), text, name, seed, author, mended)
                if task is not None:
                    return task, notes
        if found[0] is None and not chosen and code in _NOT_UNDERSTOOD:
            found = self._apart(told, text, name, seed, author, mended) or found
        if found[0] is None and not chosen and code in _NOT_UNDERSTOOD | _NOT_KNOWN:
            found = self._shorter(_without_talk(told, plain), text, name, seed, author, mended) or found
        if found[0] is None and refusal is not None:
            found = self._shorter(_without_more(told), text, name, seed, author, mended) or found
        if found[0] is None and mended is None and not chosen:
            why = refusal.diagnostics if refusal is not None else found[1]
            found = self._misspelt(text, told[0], why, name, seed, author) or found
        if found[0] is None and refusal is not None:
            raise refusal
        return found

    def _either_way(
        self, told: tuple[list[Token], list[Stray]], text: str, name: str | None, seed: int, author: str | None,
        mended: list[str] | None,
    ) -> Reading | None:  # fmt: skip
        """The reading of a text in which one of two patches is chosen: what is told of the one, or of the other."""
        ways = []
        for way in mats_chosen(told[0]):
            try:
                ways.append(self._read_tokens((way, told[1]), text, name, seed, author, mended))
            except Refusal:
                return None
        task = either_task([task for task, _ in ways]) if ways else None
        return (task, ways[0][1]) if task is not None else None

    def _apart(
        self, told: tuple[list[Token], list[Stray]], text: str, name: str | None, seed: int, author: str | None,
        mended: list[str] | None,
    ) -> Reading | None:  # fmt: skip
        """The reading of a text of which a clause is told in a sentence of its own, if all such come to one task."""
        found: list[Reading] = []
        for parted in islice(clauses_apart(told[0]), MOST):
            with suppress(Refusal):
                found.append(self._read_tokens((parted, told[1]), text, name, seed, author, mended, again=False))
        return _one_task(found)

    def _shorter(
        self, ways: Iterator[_Shorter], text: str, name: str | None, seed: int, author: str | None,
        mended: list[str] | None,
    ) -> Reading | None:  # fmt: skip
        """The first reading of a text without a clause of it, if the task is then as that clause says."""
        for told, remarks, holds in ways:
            with suppress(Refusal):
                task, notes = self._read_tokens(told, text, name, seed, author, mended, remarks)
                if task is not None and holds(task):
                    return task, notes
        return None

    def _read_tokens(
        self,
        written: tuple[list[Token], list[Stray]],
        text: str,
        name: str | None,
        seed: int,
        author: str | None,
        mended: list[str] | None,
        remarks: Sequence[str] = (),
        again: bool = True,
    ) -> Reading:
        """`remarks`: notes of what was left out; `again`: what makes no sense is told again in plain sentences."""
        tokens, strays = written
        if over := title(tokens):
            strays = [s for s in strays if s.text != "#" or s.span[0] > tokens[over].span[0]]
        tokens, named = untitled(tokens[over:]), [*remarks]
        for plainer in _PLAINER:
            tokens, said = plainer(tokens)
            named += said
        words, notes, wrong = read_words(tokens)
        if wrong or strays:
            return None, explained(text, (*wrong, *(_stray(s.text, s.span) for s in strays)))
        if notes and mended is None:
            return self._as_meant(Respelt.of(text, words, tokens), name, seed, author, notes)
        notes = [*(mended or notes), *named]
        check_one_order(words)
        typed, spoken = words, with_beginnings(words)
        words, told = told_plainly(without_asides(rows_in_words(spoken)))
        try:
            found = build(words, text, notes, name=name, seed=seed, author=author)
            check_order(words)
            check_told(told or told_behind(words), found.task)
            check_numbers(spoken, words, found)
            check_behind(typed, found.task)
            check_namings(found.task)
        except Refusal as refusal:
            otherwise = ((way(words), "") for way in _OTHERWISE)
            for ahead, wanted in (*otherwise, *stocks_ahead(words)):
                if ahead is None:
                    continue
                ahead, told = told_plainly(ahead)
                with suppress(Refusal):
                    found = build(ahead, text, notes, name=name, seed=seed, author=author)
                    check_told(told, found.task)
                    check_numbers(spoken, ahead, found)
                    check_wanted(words if wanted else [], found.task, each_block=wanted == "block")
                    check_behind(typed, found.task)
                    return found.task, found.notes
            again = again and not isinstance(refusal, TwoReadings)  # people are asked which one they mean
            parsed = refusal.diagnostics[0].code in _PARSED or isinstance(refusal, WhichOne)
            found_again = self._retold(typed, text, name, seed, author, notes, parsed=parsed) if again else (None, ())
            if found_again[0] is not None:
                return found_again
            raise
        if again:
            check_guess(found.task, typed, lambda: self._retold(typed, text, name, seed, author, notes)[0], text)
        return found.task, found.notes

    def _retold(
        self, words: list[Token], text: str, name: str | None, seed: int, author: str | None, notes: list[str],
        parsed: bool = False,
    ) -> Reading:  # fmt: skip
        """The reading of a text that tells of a figure part by part, with a note of how it was understood; no task and
        no diagnostics if there is none. `parsed`: or of one that is put together in any other way."""
        begun = stands_first(words)
        retellings = (([tokens], said) for tokens, said in retold(without_asides(with_beginnings(words))))
        for ways, said in chain(retellings, composed_ways(words)) if parsed else retellings:
            if begun and "t the start" not in said:
                continue
            notes_told = [f"understood as: {said}"]
            with suppress(Refusal):
                read = [
                    self._read_tokens((way, []), text, name, seed, author, notes, notes_told, again=False)
                    for way in ways
                ]
                task = either_task([task for task, _ in read]) if len(read) > 1 else read[0][0]
                if task is not None:
                    check_behind(words, task)
                    check_none_added(words, task)
                    return task, read[0][1]
        return None, ()

    def _as_meant(self, respelt: Respelt, name: str | None, seed: int, author: str | None, notes: list[str]) -> Reading:
        """The reading of a text with misspelt words: that of the text without them."""
        try:
            task, found = self._read(respelt.text, name, seed, author, notes)
        except Refusal as refusal:
            refusal.diagnostics = respelt.diagnosed(refusal.diagnostics)
            raise
        return task and respelt.task(task), respelt.diagnosed(found)

    def _misspelt(
        self, text: str, tokens: list[Token], why: tuple[Diagnostic, ...], name: str | None, seed: int,
        author: str | None,
    ) -> Reading | None:  # fmt: skip
        """The reading of a text of which a word could be typed for several, if all that make sense come to one task."""
        for ways in ways_meant(text, tokens, why):
            found: list[Reading] = []
            for respelt, notes in ways:
                with suppress(Refusal):
                    found.append(self._as_meant(respelt, name, seed, author, notes))
            if any(task is not None for task, _ in found):
                return _one_task(found)
        return None

    def _again(self, text: str, name: str | None, seed: int, author: str | None) -> TaskSchema | None:
        """How a text that was made up here is read, if it is."""
        try:
            return self._read(text, name, seed, author)[0]
        except Refusal:
            return None


def _one_task(found: list[Reading]) -> Reading | None:
    """The first of the readings with a task, if all these come to one."""
    read = [(task, notes) for task, notes in found if task is not None]
    return read[0] if read and all(same(read[0][0], task) for task, _ in read[1:]) else None


@contextmanager
def _undisturbed() -> Iterator[None]:
    """Without the garbage collector, which would look again and again through all that a sentence is for a moment made
    of, and find nothing: it is let go as soon as it has been read."""
    collecting = gc.isenabled()
    gc.disable()
    try:
        yield
    finally:
        if collecting:
            gc.enable()


def _without_talk(
    told: tuple[list[Token], list[Stray]], plain: tuple[list[Token], list[str]] | None
) -> Iterator[_Shorter]:
    """A text, or what its remarks leave of it, without a clause that can only be talk, or without all such clauses."""
    tokens, remarks = plain or (told[0], [])
    ways = [([rest], [note]) for rest, note in islice(clauses_left_out(tokens), MOST)]
    if ways:
        found = list(_one_by_one(tokens))
        ways.append(([rest for rest, _ in found], [note for _, note in found]))
    for rests, notes in ways:
        yield (rests[-1], _strays_of(rests[-1], *told)), [*remarks, *notes], lambda task: True


def _one_by_one(tokens: list[Token]) -> Iterator[tuple[list[Token], str]]:
    """A text with one clause after the other left out that can only be talk."""
    while (shorter := next(clauses_left_out(tokens), None)) is not None:
        yield shorter
        tokens = shorter[0]


def _without_more(told: tuple[list[Token], list[Stray]]) -> Iterator[_Shorter]:
    """A text without a clause that follows from the rest."""
    for rest, holds in islice(without_more(told[0]), MOST_MORE):
        yield (rest, told[1]), [], holds


_SPLICED: tuple[Callable[[list[Token]], list[Token] | None], ...] = (
    in_sentences, run_together, ordered_behind, in_one_sentence,
)  # fmt: skip
"""How a text that is not understood is punctuated otherwise."""
_NOT_UNDERSTOOD = frozenset({"misplaced-word", "incomplete"})
"""Why a text is refused that may be understood with its clauses told apart."""
_PARSED = frozenset({
    "misplaced-word", "incomplete", "misplaced", "no-referent", "unused-block", "no-goal", "self-reference",
    "count-mismatch", "too-many-asked", "order-conflict", "fixed-patch", "contradiction", "support-cycle",
    "too-many-namings",
})  # fmt: skip
"""Why a text is refused that may be parsed otherwise, as it may where it is asked which one of several is meant."""
_NOT_KNOWN = frozenset({"unknown-word", "misplaced"})
"""Why a text is refused that may be understood without a clause of it, too."""
_CANNOT_BOTH_BE = frozenset({"contradiction", "support-cycle", "self-reference"})
"""Why a text is refused of which the first part may be so at the start alone."""
_PLAINER: tuple[Callable[[list[Token]], tuple[list[Token], list[str]]], ...] = (
    without_pictures, with_lists, with_names, without_names, with_figures, with_color_classes, without_glosses,
    without_feelings, in_centimetres, with_colors, with_kinds, without_materials, without_praise, as_a_story,
    singled_out, said_of_each,
)  # fmt: skip
"""What is put in plain words before the words are looked up, each with notes of what it meant."""
_OTHERWISE: tuple[Callable[[list[Token]], list[Token] | None], ...] = (
    shape_ahead, one_by_one, one_or_the_other, one_of_each_color, digits_named, stock_last, symbols_behind,
    line_told_behind, that_is,
)  # fmt: skip
"""How what makes no sense as it stands is told again, if it is of such a kind."""
_STRAY_HINTS = {
    "<": "say in words what is meant, as in 'red is to the left of green' or 'smaller than'",
    ">": "say in words what is meant, as in 'red is to the right of green' or 'larger than'",
    "≠": "say in words what is meant, as in 'not two of them'",
    "_": "leave it out; a number that is to be found is a question mark, as in 'complete 3 + ? = 7'",
}
"""What to say for a character that is typed with a meaning."""


def _strays_of(rest: Sequence[Token], tokens: Sequence[Token], strays: Sequence[Stray]) -> list[Stray]:
    """The strays in what is left without the remarks, and what is typed with a meaning right in front of it."""
    first, last = rest[0].span[0], rest[-1].span[1]
    ahead = max((token.span[1] for token in tokens if token.span[0] < first), default=0)
    return [s for s in strays if (ahead if s.text in _STRAY_HINTS else first) <= s.span[0] <= last]


def _stray(text: str, span: tuple[int, int]) -> Diagnostic:
    return Diagnostic(
        code="stray-character",
        message=f"the character {text!r} means nothing here",
        span=span,
        hint=_STRAY_HINTS.get(text, "leave it out"),
        origin="schema",
    )
