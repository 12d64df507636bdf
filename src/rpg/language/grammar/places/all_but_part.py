"""A structure of one colour but for a part of it: "all blue except the tip, which is red", "in blue with red ends"."""

from __future__ import annotations

from rpg.language.grammar.core import Parser, Results, rule
from rpg.language.grammar.places.sides import at
from rpg.language.grammar.structures.parts import part, part_statement
from rpg.language.grammar.talk.slots import Patterns
from rpg.language.grammar.things.nouns import simple
from rpg.language.lexicon import COLOR
from rpg.language.meaning import Absolute, At, Coord, Meaning, Noun, Places, Traits

_BE = "is|are|should_be|must_be|has_to_be|have_to_be|shall_be|is_to_be|are_to_be|will_be"
_WHOLE = Patterns(
    f"all of_it|of_them? {_BE}? in?",
    f"everything|every_block|every_cube|every_brick|each_block|all_blocks|all_the_blocks|all_of_the_blocks {_BE}? in?",
    f"it|they|the_blocks {_BE} all? in?",
    "in", "painted", "colored",
)  # fmt: skip
_BUT = Patterns("but|except|except_for|but_for|apart_from|save_for|other_than|except_only|aside_from|besides")
_LOOKS = Patterns(
    f",? which|that {_BE} in?", ",? which|that i|we want|would_like|need to_be|in?", ",? which|that should all be",
    ", a|an|the", "in", "being", "made of",
)  # fmt: skip
_WITH = (", with", "with", ", but with", "but with", ", and with", "and with", ", where", "where", ", but")
_CERTAIN = frozenset({"the", "its", "both", "all"})
"""What a part begins with that is surely one of the structure's: a red block on top would be one more."""


def _painted(p: Parser, i: int) -> Results[Noun]:
    """A colour that the whole is told to have."""
    for theme, k in simple(p, i) if p.lex(i, COLOR) is not None else ():
        plain = isinstance(theme, Noun) and theme.head != "patch" and theme.amount is None and not theme.conditions
        one = isinstance(theme, Noun) and theme.traits == Traits(colors=theme.traits.colors[:1])
        if plain and one and isinstance(theme, Noun):
            yield theme, k


@rule
def all_but_part(p: Parser, i: int) -> Results[Meaning]:
    """The part and its colour, and the rest with the other one."""
    start = p.opt(i, ",", ":", ";", "-")
    for begin in dict.fromkeys((start, *_WHOLE.matches(p, start))):
        if begin == i:
            continue
        for whole, j in _painted(p, begin):
            for said, k in (*_excepted(p, j), *_with_part(p, j)):
                if said.theme.traits.colors != whole.traits.colors:  # type: ignore[attr-defined]
                    rest = Absolute(theme=whole, adjuncts=(Places(side="rest", unit="block", span=whole.span),),
                                    span=whole.span)  # fmt: skip
                    yield Coord(op="absolutes", items=(said, rest), span=p.span(i, k)), k


def _excepted(p: Parser, j: int) -> Results[Absolute]:
    """ "except the tip, which is red", "but for the corners, in red"."""
    for but in _BUT.matches(p, p.opt(j, ",")):
        for place, k in (*part(p, but), *at(p, but)):
            if not isinstance(place, At | Places) or getattr(place, "side", "") == "rest":
                continue
            for look in _LOOKS.matches(p, k):
                for theme, end in _painted(p, look):
                    yield Absolute(theme=theme, adjuncts=(place,), span=p.span(but, end)), end
        for said, k in part_statement(p, p.opt(but, "a", "an", "for")):
            if p.lex(p.opt(but, "a", "an"), COLOR) is not None and not p.stands(k, (",",)):
                yield said, k


def _with_part(p: Parser, j: int) -> Results[Absolute]:
    """ "(in blue) with the tip red", "(all blue,) with the corners in red"."""
    start = p.any_of(j, _WITH)
    if start and p.stands(start, _CERTAIN):
        for said, k in part_statement(p, start):
            place = said.adjuncts[0]
            if (
                isinstance(said.theme, Noun)
                and len(said.theme.traits.colors) == 1
                and getattr(place, "side", "") != "rest"
            ):
                yield said, k
