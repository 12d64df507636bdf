"""Casual constructions in the words of plainer ones: "10 cm apart, roughly" is about 10 cm apart."""

from __future__ import annotations

from collections.abc import Callable

from rpg.language import lexicon
from rpg.language.grammar.talk.ahead_of_others import AHEAD, ahead_of_others
from rpg.language.grammar.talk.all_as_before import all_as_before
from rpg.language.grammar.talk.along_with import ALONG, along_with
from rpg.language.grammar.talk.answers_wanted import answers_wanted
from rpg.language.grammar.talk.bare_sides import bare_sides, one_side_each
from rpg.language.grammar.talk.by_again import by_again
from rpg.language.grammar.talk.colored_groups import GROUPS, colored_groups
from rpg.language.grammar.talk.considered import CONSIDERED, considered
from rpg.language.grammar.talk.cube_of_small_ones import SMALL, cube_of_small_ones, four_below
from rpg.language.grammar.talk.dealt_out import dealt_out
from rpg.language.grammar.talk.each_and_same import each_once, each_one, one_of_each, same_ones
from rpg.language.grammar.talk.each_of_its_color import (
    ORGANIZED,
    each_on_its_own,
    for_each_color,
    mats_have,
    organized,
    sorted_onto_mats,
)
from rpg.language.grammar.talk.exactly_so_many import (
    BOUNDS,
    EXACTLY,
    MORE,
    NO_MORE,
    exactly_those,
    no_more_no_fewer,
    none_of_so_many,
    number_there,
    of_so_many_ahead,
    over_so_many,
    so_many_at_most,
)
from rpg.language.grammar.talk.freely import freely
from rpg.language.grammar.talk.heights_told import heights_told
from rpg.language.grammar.talk.numbers_told import NUMBER, TIPS, both_of_so_many, number_is, on_the_tip
from rpg.language.grammar.talk.one_another import ANOTHER, CORNER, one_another, one_in_each_corner, other_half
from rpg.language.grammar.talk.one_color import ONE_COLOR, all_of_color, one_color
from rpg.language.grammar.talk.own_color import own_color, told_in_total
from rpg.language.grammar.talk.respelling import MADE, RESPELT, respelling, word_made
from rpg.language.grammar.talk.said_between import (
    ANYWHERE,
    BETWEEN,
    UTMOST,
    amid_the_verb,
    measured_last,
    not_touching,
    others_anywhere,
)
from rpg.language.grammar.talk.said_loosely import LOOSE, said_loosely
from rpg.language.grammar.talk.set_plainly import (
    SORTED,
    given_when_then,
    got_going,
    heading_of_sorting,
    number_in_brackets,
    of_the_symbols,
)
from rpg.language.grammar.talk.short_turns import (
    LETTING,
    anywhere_but,
    between_them,
    center_of_patch,
    not_stacked,
    number_made,
    turned_in_place,
    without_letting,
    without_stacking,
)
from rpg.language.grammar.talk.sizes_compared import TELLING, sizes_compared, sizes_listed
from rpg.language.grammar.talk.start_last import START_LAST, start_last
from rpg.language.grammar.talk.structures_listed import PLURALS, one_of_each_color, structures_listed
from rpg.language.grammar.talk.told_short import any_other, but_turned, every_other, halves_told, in_pairs, no_two
from rpg.language.grammar.talk.towers_bounded import HIGHER, towers_bounded
from rpg.language.grammar.talk.towers_in_short import (
    FLOORS,
    SPREAD,
    floors_high,
    one_height_for_all,
    one_tower_has,
    pairs_stacked,
    spread_over,
    tidied_into,
)
from rpg.language.grammar.talk.utmost_number import utmost_number
from rpg.language.grammar.talk.verbs_in_other_words import BEGUN, begun_doing
from rpg.language.grammar.talk.verbs_told import OUT_OF, got_done, laid_flat, steps_built, who_builds
from rpg.language.grammar.talk.words_told import SPELT, words_told
from rpg.language.phrases import length_at
from rpg.language.tokens import Token

_STOPS = frozenset({".", "!", "?", ";"})
_BREAKS = _STOPS | {",", ":"}
_HEDGES = (("roughly",), ("approximately",), ("or", "so"), ("more", "or", "less"), ("or", "thereabouts"), ("about",),
           ("give", "or", "take"), ("roughly", "speaking"), ("ish",))  # fmt: skip
_HEDGING = frozenset(hedge[0] for hedge in _HEDGES)
_HEDGED = frozenset({"about", "around", "roughly", "approximately", "nearly"})
_EXACT = frozenset({"exactly", "precisely", "least", "most", "than", "within"})
_LOOKS = frozenset({"the", "that", "this", "those", "these", *lexicon.COLOR, *lexicon.SIZE, *lexicon.SHAPE_ADJECTIVE,
                    "letter", "long", "and", *lexicon.NUMBER}) - {"one"}  # fmt: skip
_NOUNS = {**lexicon.BLOCK, **lexicon.PATCH, "one": False, "ones": True}
_SEEN = (("you", "know"), ("you", "see"), ("do", "you", "see"), ("can", "you", "see"), ("see",), ("remember",),
         ("you", "remember"), ("notice",), ("spot",))  # fmt: skip
_DOING = frozenset({"should", "must", "shall", "have", "need", "are", "go", "swap", "trade", "belong", "touch",
                    "stand"})  # fmt: skip
_PLACES = frozenset({"on", "in", "at", "under", "next", "behind", "beside", "between", "not", "already", "still",
                     "always", "going", "supposed", "meant", "near"})  # fmt: skip
_DONE = frozenset({"after", "once", "when"})
_WHO = frozenset({"you", "we", "i"})


def plainer(tokens: list[Token]) -> list[Token]:
    """The tokens with such constructions in plainer words."""
    words = [token.word for token in tokens]
    for change, telling in _CHANGES:
        if not telling.isdisjoint(words) and (changed := change(tokens, words)) is not None:
            tokens = changed
            words = [token.word for token in tokens]
    return tokens


def _seen(tokens: list[Token], words: list[str]) -> list[Token] | None:
    """ "You know the green block? It goes ...", "see the mat, put ...": there is one, and what follows speaks of it."""
    lead = length_at(words, 0, _SEEN)
    end = lead
    while end < len(words) and words[end] in _LOOKS:
        end += 1
    if end == lead or end + 1 >= len(words) or words[end] not in _NOUNS:
        return None
    if words[lead] not in ("the", "that", "this", "those", "these") or not (lead or "?" in words[end + 1 : end + 4]):
        return None
    stop = end + 1 + (words[end + 1] in ("there", "here"))
    stop += words[stop : stop + 1] == [","] and words[stop + 1 : stop + 3] == ["right", "?"] and 2
    if words[stop : stop + 1] not in ([","], ["?"], ["…"], ["."])[: None if lead else 2] or stop + 1 >= len(words):
        return None
    there = [tokens[0].saying(word) for word in ("there", "are" if _NOUNS[words[end]] else "is", "the")]
    rest = tokens[stop + 1 :]
    rest = rest[1:] if rest[0].word in ("well", ",", "so", "right") and len(rest) > 1 else rest
    return [*there, *tokens[lead + 1 : end + 1], tokens[stop].saying("."), *rest]


def _is(tokens: list[Token], words: list[str]) -> list[Token] | None:
    """ "The red one's sitting on it": is, where no place or part of the block follows."""
    out = list(tokens)
    for at in range(1, len(words) - 1):
        thing = words[at - 1] in lexicon.BLOCK or words[at - 1] in lexicon.COLOR or words[at - 1] in lexicon.PATCH
        after = words[at + 1]
        posture = (after.endswith("ing") and after in lexicon.POSTURE) or after in ("sat", "stood")
        if words[at] == "'s" and (thing or words[at - 1] == "one") and (posture or after in _PLACES):
            out[at] = tokens[at].saying("is")
    return out if out != tokens else None


def _resumed(tokens: list[Token], words: list[str]) -> list[Token] | None:
    """ "Red and blue, those two should trade places": the two that were just named."""
    for at in range(3, len(words) - 2):
        if words[at] != "," or words[at + 1] not in ("those", "these", "they"):
            continue
        begin = max((n + 1 for n in range(at) if words[n] in _STOPS), default=0)
        named = sum(word in lexicon.COLOR for word in words[begin:at])
        plain = all(w in lexicon.COLOR or w in _NOUNS or w in ("the", ",", "and", "a") for w in words[begin:at])
        many = 2 if words[at + 2] == "both" else lexicon.NUMBER.get(words[at + 2], 0)
        listed = plain and "and" in words[begin:at] and named == many > 1
        if listed and at + 3 < len(words) and words[at + 3] in _DOING:
            return [*tokens[:at], *tokens[at + 3 :]]
    return None


def _have_done(tokens: list[Token], words: list[str]) -> list[Token] | None:
    """ "After you've put white on black": after you put it there."""
    for at in range(len(words) - 3):
        if words[at] in _DONE and words[at + 1] in _WHO and words[at + 2] == "have":
            forms = lexicon.VERB.get(words[at + 3], ())
            lemma = next((x for _, x, form in forms if form == "past" or lexicon.PAST.get(x) == words[at + 3]), "")
            if lemma:
                return [*tokens[: at + 2], tokens[at + 3].saying(lemma), *tokens[at + 4 :]]
    return None


def _hedged(tokens: list[Token], words: list[str]) -> list[Token] | None:
    """ "10 cm apart, roughly", "10 cm or so apart": about 10 cm."""
    for at in range(1, len(words)):
        comma = words[at] == ","
        begun = at + comma
        hedge = begun < len(words) and words[begun] in _HEDGING
        said = length_at(words, begun, _HEDGES) if hedge else 0
        end = begun + said
        if not said or words[begun : begun + 1] == words[end : end + 1]:
            continue
        last = end >= len(words) or words[end] in _BREAKS
        unit = max((n for n in range(max(1, at - 3), at) if words[n] in lexicon.UNIT), default=0)
        figure = unit - 1
        if not unit or tokens[figure].kind != "number" or not (last or (unit == at - 1 and words[begun] == "or")):
            continue
        if words[begun] == "about" and not (comma and last):
            continue
        if not _EXACT.isdisjoint(words[max(0, figure - 2) : figure]):
            continue
        about = [] if words[figure - 1] in _HEDGED else [tokens[begun].saying("about")]
        return [*tokens[:figure], *about, *tokens[figure:at], *tokens[end:]]
    return None


_ALIKE = frozenset({"same", "alike", "like", "each", "every"})
_TIDIED = frozenset({"tidy", "clean", "straighten", "neaten"})


def _tidied(tokens: list[Token], words: list[str]) -> list[Token] | None:
    """ "Tidy up two reds and two blues so that the same colours are together": sort them."""
    for at in range(len(words) - 2):
        if words[at] not in _TIDIED or words[at + 1] != "up":
            continue
        end = next((n for n in range(at, len(words)) if words[n] in _STOPS), len(words))
        so = words.index("so", at) if "so" in words[at + 3 : end] else end
        if "together" in words[so:end] and not _ALIKE.isdisjoint(words[so:end]):
            return [*tokens[:at], tokens[at].saying("sort"), *tokens[at + 2 :]]
    return None


_FAR = frozenset({"furthest", "farthest"})


def _furthest(tokens: list[Token], words: list[str]) -> list[Token] | None:
    """ "(In a row,) gray furthest left", "the furthest left block": leftmost."""
    at = next((n for n, word in enumerate(words) if word in _FAR), -1)
    side = at + 1 + 2 * (words[at + 1 : at + 3] == ["to", "the"])
    if at < 1 or side >= len(words) or words[side] not in ("left", "right"):
        return None
    end = side + 1 + 2 * (words[side + 1 : side + 3] == ["of", "all"])
    after = words[end] if end < len(words) else "."
    named = after in lexicon.BLOCK or after == "one"
    lined = "row" in words or "line" in words
    if not lined or (words[at - 1] == "the" and not named) or not (named or after in _BREAKS or after == "and"):
        return None
    return [*tokens[:at], tokens[at].saying(f"{words[side]}most"), *tokens[end:]]


_LEFT_OUT = frozenset({"ignore", "disregard", "forget"})
_LYING = frozenset({"lying", "sitting", "standing", "hanging"})


def _around(tokens: list[Token], words: list[str]) -> list[Token] | None:
    """ "Ignore the two white blocks that are lying around": where they lie is nowhere in particular."""
    for at in (n for n, word in enumerate(words) if word in _LEFT_OUT):
        end = next((n for n in range(at, len(words)) if words[n] in _BREAKS), len(words))
        if words[end - 1] in ("around", "about", "there") and words[end - 2] in _LYING and end - 2 > at:
            relative = 2 if words[end - 4] in ("that", "which") and words[end - 3] in ("are", "is") else 0
            return [*tokens[: end - 2 - relative], *tokens[end:]]
    return None


def _like_a_grid(tokens: list[Token], words: list[str]) -> list[Token] | None:
    """ "Two rows of three blocks, like a little grid": a grid of them."""
    for at in range(len(words) - 4):
        if words[at + 1 : at + 3] != ["rows", "of"] or not _counts(tokens[at]) or not _counts(tokens[at + 3]):
            continue
        end = next((n for n in range(at, len(words)) if words[n] in _BREAKS), len(words))
        like = end + 1
        if words[like : like + 2] not in (["like", "a"], ["as", "a"], ["in", "a"], ["forming", "a"], ["so", "a"]):
            continue
        noun = like + 2 + (words[like + 2 : like + 3] in (["little"], ["small"], ["neat"], ["tiny"]))
        if words[noun : noun + 1] == ["grid"] and (noun + 1 == len(words) or words[noun + 1] in _BREAKS):
            grid = [tokens[noun].saying(word) for word in ("a", "grid", "of")]
            return [*tokens[:at], *grid, *tokens[at:end], *tokens[noun + 1 :]]
    return None


def _counts(token: Token) -> bool:
    return token.kind == "number" or token.word in lexicon.NUMBER


_TOPPED = frozenset({"finish", "top", "cap", "crown"})
_PILES = frozenset({"stack", "tower", "pile", "skyscraper", "column"})


def _finished_off(tokens: list[Token], words: list[str]) -> list[Token] | None:
    """ "(Build a tower of two) and finish it off with a red one on top": and put a red one on top."""
    for at in range(2, len(words) - 4):
        led = words[at] in _TOPPED and words[at - 1] in ("and", "then")
        if not led or words[at + 1] not in ("it", "them", "that"):
            continue
        off = words[at + 2] == "off"
        if words[at + 2 + off] != "with" or _PILES.isdisjoint(words[:at]):
            continue
        end = next((n for n in range(at, len(words)) if words[n] in _BREAKS), len(words))
        thing = tokens[at + 3 + off : end]
        if words[end - 2 : end] == ["on", "top"]:
            thing = thing[:-2]
        if not thing or any(t.word in ("and", "on", "in", "at", "with") for t in thing):
            continue
        top = [tokens[at].saying(word) for word in ("on", "top")]
        return [*tokens[:at], tokens[at].saying("put"), *thing, *top, *tokens[end:]]
    return None


_Change = Callable[[list[Token], list[str]], list[Token] | None]
_CHANGES: tuple[tuple[_Change, frozenset[str]], ...] = (
    (along_with, ALONG),
    (start_last, START_LAST),
    (all_as_before, frozenset({"everything", "all"})),
    (answers_wanted, frozenset({"?", "=", "answer", "result", "solution", "missing"})),
    (respelling, RESPELT),
    (word_made, MADE),
    (begun_doing, BEGUN),
    (sizes_listed, frozenset(lexicon.SIZE)),
    (given_when_then, frozenset({"given"})),
    (number_in_brackets, frozenset({"("})),
    (heading_of_sorting, SORTED),
    (got_going, frozenset({"going"})),
    (of_the_symbols, frozenset({"for"})),
    (bare_sides, frozenset({"right"})),
    (one_side_each, frozenset({"side"})),
    (own_color, frozenset({"match", "each", "every"})),
    (told_in_total, frozenset({"total", "altogether", "all"})),
    (halves_told, frozenset({"half"})),
    (no_two, frozenset({"no"})),
    (no_more_no_fewer, NO_MORE),
    (none_of_so_many, frozenset({"no"})),
    (so_many_at_most, BOUNDS),
    (exactly_those, EXACTLY),
    (over_so_many, frozenset(MORE)),
    (one_another, ANOTHER),
    (other_half, frozenset({"other"})),
    (one_in_each_corner, CORNER),
    (towers_bounded, HIGHER),
    (cube_of_small_ones, SMALL),
    (four_below, frozenset({"four"})),
    (colored_groups, GROUPS),
    (each_on_its_own, frozenset({"stack", "stacked", "pile", "piled"})),
    (for_each_color, frozenset({"color", "colors"})),
    (mats_have, frozenset({"color"})),
    (organized, ORGANIZED),
    (spread_over, SPREAD),
    (number_there, frozenset({"number"})),
    (of_so_many_ahead, frozenset({"of"})),
    (sorted_onto_mats, frozenset({"color", "colors"})),
    (floors_high, FLOORS),
    (structures_listed, PLURALS),
    (one_of_each_color, frozenset({"colors", "color"})),
    (one_height_for_all, frozenset({"each", "both", "all"})),
    (one_tower_has, frozenset({"tower", "stack"})),
    (tidied_into, frozenset({"into"})),
    (but_turned, frozenset({"but"})),
    (any_other, frozenset({"any"})),
    (every_other, frozenset({"every"})),
    (pairs_stacked, frozenset({"pairs"})),
    (in_pairs, frozenset({"pairs", "twos", "couples"})),
    (utmost_number, frozenset({"number"})),
    (_furthest, _FAR),
    (_seen, frozenset({"?", *(word for lead in _SEEN for word in lead)})),
    (_is, frozenset({"'s"})),
    (_resumed, frozenset({"those", "these", "they"})),
    (_have_done, frozenset({"have"})),
    (_hedged, _HEDGING),
    (_tidied, _TIDIED),
    (freely, frozenset({"as", "but", "provided", "only", "just"})),
    (_around, _LEFT_OUT),
    (_like_a_grid, frozenset({"rows"})),
    (_finished_off, _TOPPED),
    (by_again, frozenset({"by"})),
    (heights_told, frozenset({"towers", "stacks", "columns"})),
    (sizes_compared, TELLING),
    (dealt_out, frozenset({"half", "towers", "stacks", "each", "equation", "sum", "of"})),
    (between_them, frozenset({"between"})),
    (without_stacking, frozenset({"stacking"})),
    (without_letting, LETTING),
    (not_stacked, frozenset({"stacked", "stacking", "stack", "stacks", "piling", "flat"})),
    (anywhere_but, frozenset({"anywhere", "somewhere"})),
    (number_is, NUMBER),
    (both_of_so_many, frozenset({"both"})),
    (on_the_tip, TIPS),
    (others_anywhere, ANYWHERE),
    (amid_the_verb, BETWEEN),
    (measured_last, UTMOST),
    (not_touching, frozenset({"touching"})),
    (turned_in_place, frozenset({"spot"})),
    (number_made, frozenset({"digit", "digits", "number", "numbers"})),
    (who_builds, OUT_OF),
    (got_done, frozenset({"get", "have"})),
    (steps_built, frozenset({"steps"})),
    (laid_flat, frozenset({"flat"})),
    (one_color, ONE_COLOR),
    (all_of_color, frozenset({"all", "both", "each", "everything"})),
    (each_once, frozenset({"once"})),
    (each_one, frozenset({"different"})),
    (same_ones, frozenset({"same"})),
    (one_of_each, frozenset({"each", "every"})),
    (center_of_patch, frozenset({"'s"})),
    (said_loosely, LOOSE),
    (ahead_of_others, AHEAD),
    (words_told, SPELT),
    (considered, CONSIDERED),
)
"""The changes, in their order, and words without one of which there is nothing for each to change."""
