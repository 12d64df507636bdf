"""Clauses told again in other words, and what each of several is: "..., that is, all green ones are left of it"."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace

from rpg.language import lexicon
from rpg.language.grammar.talk.as_it_is import TELLING, as_it_is
from rpg.language.grammar.talk.denied import BARRED, HOLD_OFF, forbidden, held_off
from rpg.language.tokens import Token

_STOPS = frozenset({".", ";", "!", "?"})
_STATES = frozenset({"is", "are", "should", "must", "stand", "stands", "lie", "lies", "has", "have", "may", "can"})
_WANTED = frozenset({"should", "must", "shall", "are", "is", "have", "need"})


def that_is(tokens: list[Token]) -> list[Token]:
    """ "None of the brown ones is left of a green one, that is, all the greens are left of the browns": both hold."""
    words = [token.word for token in tokens]
    for at in range(1, len(words) - 4):
        if words[at : at + 4] != [",", "that", "is", ","]:
            continue
        begin = next((n + 1 for n in range(at - 1, -1, -1) if words[n] in _STOPS), 0)
        end = next((n for n in range(at, len(words)) if words[n] in _STOPS), len(words))
        rest = words[at + 4 : end]
        verb = next((n for n, word in enumerate(rest) if word in _STATES), 0)
        if verb and "," not in rest[:verb] and not _STATES.isdisjoint(words[begin:at]):
            return [*tokens[: at + 1], replace(tokens[at + 1], word="and", raw="and"), *tokens[at + 4 :]]
    return tokens


def so_do_others(tokens: list[Token]) -> list[Token]:
    """ "The green ones should be stacked, the purple ones too": these should be stacked as well."""
    words = [token.word for token in tokens]
    for at in range(3, len(words) - 3):
        begun = at + 1 + (words[at + 1] == "and")
        too = begun + 3
        named = words[begun] == "the" and words[begun + 1] in lexicon.COLOR and too < len(words)
        if words[at] != "," or not named or not (words[begun + 2] == "ones" or words[begun + 2] in lexicon.BLOCK):
            continue
        first = next((n + 1 for n in range(at - 1, -1, -1) if words[n] in _STOPS), 0)
        verb = next((n for n in range(first, at) if words[n] in _WANTED), 0)
        if words[too] == "too" and verb and "," not in words[first:at] and words[first] == "the":
            joint = replace(tokens[at], kind="word", word="and", raw="and")
            after = too + 1 + (words[too + 1 : too + 2] == [","])
            return [*tokens[: at + 1], joint, *tokens[begun:too], *tokens[verb:at], *tokens[after:]]
    return tokens


def of_one_color_each(tokens: list[Token]) -> list[Token]:
    """ "Into four towers of one colour each": each of one colour."""
    words = [token.word for token in tokens]
    for at in range(1, len(words) - 3):
        one = words[at : at + 2] in (["of", "one"], ["of", "a"]) and words[at + 2] in ("color", "single")
        each = at + 3 + (words[at + 2] == "single")
        if one and words[each - 1] == "color" and words[each : each + 1] == ["each"] and words[at - 1] in _BUILT:
            comma = tokens[each].saying(",")
            return [*tokens[:at], comma, tokens[each], *tokens[at:each], *tokens[each + 1 :]]
    return tokens


def sorted_there(tokens: list[Token]) -> list[Token]:
    """ "Sort them: green into the left half, purple into the right half": each colour is put where it is told."""
    words = [token.word for token in tokens]
    at = next((n for n in range(len(words)) if words[n] == "sort" and (not n or words[n - 1] in _STOPS)), -1)
    colon = next((n for n in range(at, min(at + 6, len(words))) if words[n] == ":"), 0) if at >= 0 else 0
    end = next((n for n in range(colon, len(words)) if words[n] in _STOPS), len(words))
    if not colon or {*words[at + 1 : colon]} - _THEM:
        return tokens
    begun = [n for n in range(colon, end - 3) if words[n] in (":", ",", "and") and words[n + 1] in _LOOKS]
    if len(begun) < _SEVERAL:
        return tokens
    lots: list[Token] = []
    for n, stop in zip(begun, [*begun[1:], end], strict=True):
        color = n + 1 + (words[n + 1] == "the")
        place = color + 1 + (words[color + 1] in ("ones", *lexicon.BLOCK))
        if words[color] not in lexicon.COLOR or words[place] not in _INTO or _REGIONS.isdisjoint(words[place:stop]):
            return tokens
        named = [tokens[color].saying("the"), tokens[color], tokens[color].saying("ones")]
        last = stop - (words[stop - 1] == ",")
        lots += [*([tokens[n].saying("and")] if lots else []), *named, *tokens[place:last]]
    return [*tokens[:at], tokens[at].saying("put"), *lots, *tokens[end:]]


_SEVERAL = 2
_THEM = frozenset({"them", "it", "these", "those", "all", "of", "the", "blocks", "cubes", "by", "color"})
_LOOKS = frozenset({"the", *lexicon.COLOR})
_INTO = frozenset({"into", "to", "in", "on", "onto"})
_REGIONS = frozenset({"half", "corner", "third", *lexicon.PATCH})


_BUILT = frozenset(word for word, (_, plural) in lexicon.STRUCTURE.items() if plural)


def unequal(tokens: list[Token]) -> list[Token]:
    """ "Three towers: one of three blocks and two of two": a tower of three blocks and two towers of two blocks."""
    words = [token.word for token in tokens]
    for at in range(len(words) - 6):
        many = lexicon.NUMBER.get(words[at], 0)
        if many < 2 or words[at + 1] not in _BUILT or words[at + 2] not in (",", ":"):
            continue
        lots: list[tuple[int, int, int]] = []
        k = at + 3
        while words[k + 1 : k + 2] == ["of"] and words[k] in lexicon.NUMBER:
            stop = next(
                (n for n in range(k + 2, len(words)) if words[n] in (",", "and") or words[n] in _STOPS), len(words)
            )
            lots.append((lexicon.NUMBER[words[k]], k, stop))
            k = stop + (words[stop : stop + 1] == [","])
            k += words[k : k + 1] == ["and"]
        if sum(n for n, _, _ in lots) == many and any(n > 1 for n, _, _ in lots) and len(lots) > 1:
            return [*tokens[:at], *_one_by_one(tokens, tokens[at + 1], lots), *tokens[lots[-1][2] :]]
    return tokens


def _one_by_one(tokens: list[Token], built: Token, lots: list[tuple[int, int, int]]) -> list[Token]:
    kind = lexicon.STRUCTURE[built.word][0]
    alike = [x for x, (other, plural) in lexicon.STRUCTURE.items() if other == kind and not plural]
    single = next(x for x in alike if built.word.startswith(x[:3]))
    told = [[t for t in tokens[k + 3 : stop] if t.word not in ("one", "ones")] for _, k, stop in lots]
    looks = next((x for x in told if {t.word for t in x} & {*lexicon.COLOR}), next(filter(None, told), []))
    noun = next((t for x in told for t in x if t.word in lexicon.BLOCK), built.saying("blocks"))
    out: list[Token] = []
    for n, (many, k, _) in enumerate(lots):
        if n:
            out.append(tokens[k].saying("and" if n == len(lots) - 1 else ","))
        own = told[n] if {t.word for t in told[n]} & {*lexicon.COLOR} else looks
        own = own if own and own[-1].word in lexicon.BLOCK else [*own, noun]
        out += [tokens[k], built if many > 1 else built.saying(single), *tokens[k + 1 : k + 3], *own]
    return out


def one_each(tokens: list[Token]) -> list[Token]:
    """ "(Distribute the blocks) so that every mat gets one": one block; behind a single one, it could be like it."""
    words = [token.word for token in tokens]
    for at in range(3, len(words)):
        begin = next((n for n in range(max(0, at - 4), at) if words[n] in ("every", "each")), None)
        if words[at] != "one" or words[at - 1] not in _GET or begin is None or words[begin + 1] not in lexicon.PATCH:
            continue
        ended = at + 1 == len(words) or words[at + 1] in _STOPS | {","}
        if ended and not any(lexicon.BLOCK.get(word) is False for word in words[:at]):
            return [*tokens[: at + 1], tokens[at].saying("block"), *tokens[at + 1 :]]
    return tokens


_GET = frozenset({"gets", "get", "has", "have", "receives", "receive", "holds", "hold", "carries", "carry"})


_LINED = frozenset({"row", "line", "in", "order", "read", "reads", "listed", "going", "is"})


def left_to_right(tokens: list[Token]) -> list[Token]:
    """ "A row, L to R: A, B and C": from left to right; but "the letters L to R"."""
    for at in (n for n in range(len(tokens) - 2) if [t.word for t in tokens[n : n + 3]] == ["l", "to", "r"]):
        begin = at - (at > 0 and tokens[at - 1].word == "from")
        before = tokens[begin - 1] if begin else None
        ends = at + 3 == len(tokens) or tokens[at + 3].word in (":", ",", ".", ")", "!")
        led = before is None or before.kind == "punct" or before.word in _LINED or _shown(before)
        if led and ends and not (before and before.word == "(" and begin > 1 and tokens[begin - 2].word == "letters"):
            plain = [tokens[at].saying(word) for word in ("from", "left", "to", "right")]
            return [*tokens[:begin], *plain, *tokens[at + 3 :]]
    return tokens


def _shown(token: Token) -> bool:
    return token.kind == "number" or len(token.raw) == 1 or token.word in lexicon.COLOR


_KINDS_OF_BLOCK = frozenset({"building", "play", "toy"})
_LED = frozenset({"the", "a", "an", "of", "all", "these", "those", "letter", "number", "wooden", "plastic", "plain",
                  "other", "another", "with", "using", "from", *lexicon.COLOR, *lexicon.SIZE})  # fmt: skip


def building_blocks(tokens: list[Token]) -> list[Token]:
    """ "Four red building blocks": blocks; but "building blocks into a tower"."""
    return [
        token
        for n, token in enumerate(tokens)
        if not (
            token.word in _KINDS_OF_BLOCK
            and n
            and n + 1 < len(tokens)
            and tokens[n + 1].word in lexicon.BLOCK
            and (tokens[n - 1].many or tokens[n - 1].word in _LED)
        )
    ]


IN_OTHER_WORDS: tuple[tuple[frozenset[str], Callable[[list[Token]], list[Token]]], ...] = (
    (frozenset({"that"}), that_is),
    (frozenset({"each"}), of_one_color_each),
    (frozenset({"too"}), so_do_others),
    (frozenset({"sort"}), sorted_there),
    (_BUILT, unequal),
    (_GET, one_each),
    (frozenset({"l"}), left_to_right),
    (_KINDS_OF_BLOCK, building_blocks),
    (TELLING, as_it_is),
    (BARRED, forbidden),
    (HOLD_OFF, held_off),
)
"""Turns of phrase, with words one of which they have."""
