"""Turns of phrase that say the same as a plainer one: "an other" is another, "consists out of" is consists of."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace

from rpg.language import lexicon
from rpg.language.grammar.rows.formal import formal
from rpg.language.grammar.talk.everyday import EVERYDAY
from rpg.language.grammar.talk.in_other_words import IN_OTHER_WORDS
from rpg.language.grammar.talk.in_the_end import IN_THE_END
from rpg.language.grammar.talk.quantities import QUANTITIES
from rpg.language.grammar.talk.verbs_in_other_words import VERBS_IN_OTHER_WORDS
from rpg.language.phrases import tree_of
from rpg.language.tokens import Token

_MESSY = (
    "messy", "mixed", "random", "untidy", "disordered", "disorderly", "jumbled", "unsorted", "chaotic", "mixed up",
    "loose", "wild", "confused", "scrambled", "unordered", "settled",
)  # fmt: skip
_TOGETHER = ("mixed up", "jumbled up", "mixed", "jumbled", "thrown together", "lumped together", "mixed together",
             "thrown", "heaped up", "heaped", "piled up", "piled", "dumped")  # fmt: skip
_SPECTRUM = "red , orange , yellow , green , cyan , blue , purple and pink"
"""All the colours of the rainbow."""
_PHRASES = {
    **{f"{how} {what}": what for how in ("scattered", "strewn")
       for what in ("blocks", "cubes", "bricks", "boxes", "letters", "numbers", "digits", "letter")},
    **{f"{just} in the {middle}": f"in the {middle}" for just in ("exactly", "precisely")
       for middle in ("middle", "center")},
    **{f"{be} separate from": f"{be} separated from" for be in ("be", "is", "are", "stay", "remain", "stand", "lie")},
    "share a color": "have the same color", "share the same color": "have the same color",
    **{f"{on} the {floor}": f"{on} the table" for on in ("on", "onto", "to") for floor in ("floor", "ground")},
    **{f"{how} {heap}": heap for how in _MESSY for heap in ("heap", "pile", "jumble", "bunch")},
    **{f"{how} {at}": at for how in _TOGETHER for at in ("in one heap", "in a heap", "in one pile", "in a pile")},
    **{f"{which} course": f"{which} layer" for which in (
        "a", "one", "each", "every", "top", "bottom", "upper", "lower", "middle", "first", "second", "third", "last",
        "lowest", "highest", "topmost", "uppermost", "next", "single", "per")},
    **{f"{far} from": "away from" for far in ("far enough", "far enough away", "sufficiently far",
                                            "a safe distance", "at a safe distance")},
    "far enough apart": "far apart", "a safe distance apart": "far apart", "not too close together": "far apart",
    "not too close to": "away from", "not too near": "away from",
    "with the exception of": "except for", "with exception of": "except for", "prior to": "before",
    "not a single": "no", "not even one": "no", "not even a single": "no",
    **{f"{one} and {the}{two} {what}": f"{one} {what} and {the}{two} {what}" for the in ("", "the ")
       for one, two in (("odd", "even"), ("even", "odd")) for what in ("digits", "numbers")},
    **{f"{on} the {top} of the table": f"{on} the table" for on in ("on", "onto", "to")
       for top in ("floor", "top", "surface")},
    "seen from left to right": "from left to right", "capped by": "topped by", "capped with": "topped with",
    **{f"{heap} made of": f"{heap} of" for heap in ("heap", "pile")}, "in such a way that": "so that",
    **QUANTITIES, **IN_THE_END, **VERBS_IN_OTHER_WORDS, **EVERYDAY,
    "an other": "another", "the both": "both", "both the two": "both",
    **{f"{near} of": near for near in ("behind", "beside", "above", "below", "under", "beneath", "underneath", "near")},
    **{f"upright {to} {who}": "upright" for to in ("for", "to") for who in ("the viewer", "the camera", "me")},
    **{f"readable {by} {who}": "readable" for by in ("for", "by", "from", "to")
       for who in ("the viewer", "the camera", "me", "the robot 's camera")},
    **{f"read it {of} the camera": "read it" for of in ("from", "with", "through", "in")},
    **{f"read them {of} the camera": "read them" for of in ("from", "with", "through", "in")},
    "each other at all": "each other", "one another at all": "one another", "touch at all": "touch",
    **{f"over there {on}": on for on in ("on", "in", "at", "next", "behind")},
    **{f"{verb} like the": f"{verb} the" for verb in ("put", "place", "move", "take", "stack", "set", "get")},
    "just not": "but not", "only not": "but not", "only do not": "but do not", "please to": "please",
    "twice in a row": "twice running", "two times in a row": "twice running",
    **{f"{read} {down} from the {top}": f"reading from {top} to {bottom}" for read in ("reading", "read")
       for top, bottom, downs in (("top", "bottom", ("down", "downwards")), ("bottom", "top", ("up", "upwards")))
       for down in downs},
    **{f"{take} {it} off again": f"{take} {it} off" for take in ("take", "lift", "pick") for it in ("it", "them")},
    **{f"{keep} {its} {place}": f"{stay} where {are}"
       for keep, stay, its, are in (("keep", "stay", "its", "it is"), ("keeps", "stays", "its", "it is"),
                                    ("keep", "stay", "their", "they are"))
       for place in ("place", "places", "position", "positions", "spot", "spots")},
    "around by half": "by half", "around by 90": "by 90", "around by 180": "by 180", "around by a": "by a",
    "somewhere in between there": "in between there", "something that is true": "a true equation",
    "something that is correct": "a true equation",
    "something which is true": "a true equation", "something true": "a true equation",
    "something that works out": "a true equation",
    **{f"the {all_}": "all of them" for all_ in ("whole lot", "whole thing", "whole bunch")},
    **{f"{lies} about": f"{lies} around" for lies in ("lying", "sitting", "standing")},
    "fill a": "build a filled", "fill the": "build the filled", "fill one": "build one filled",
    **{f"{kind} together": f"{kind} numbers together" for kind in ("odd", "even")},
    "in rainbow colors": "in the colors of the rainbow",
    "outline a": "draw the outline of a", "outline one": "draw the outline of one",
    "in front from": "in front of", "behind from": "behind", "in behind": "behind",
    "consists out of": "consists of", "consist out of": "consist of", "consisting out of": "consisting of",
    "consists out": "consists of", "consist out": "consist of", "composed out of": "composed of",
    **{
        f"{must} {looks} {way}": f"{must} be {way}"
        for must in ("should", "must", "shall", "has to", "is to", "needs to", "will", "ought to")
        for looks in ("read", "look", "appear", "be read", "be seen", "show")
        for way in ("upside down", "upright", "sideways")
    },
    **{f"upside down {to} {who}": "upside down" for to in ("for", "to") for who in ("the viewer", "the camera", "me")},
    **{f"{to} the {above}": "up" for to in ("to", "at", "towards", "toward") for above in ("ceiling", "sky")},
    "faces the ceiling": "faces up", "face the ceiling": "face up", "facing the ceiling": "facing up",
    **{
        f"{looks} {way}": f"{be} {way}"
        for be, verbs in (("is", ("reads", "looks", "appears")), ("are", ("look", "appear")))
        for looks in verbs
        for way in ("upside down", "upright", "sideways")
    },
    **{
        f"none {touch} {other}": f"none of them {touch} {other}"
        for touch in ("touches", "touch", "may touch", "is touching", "must touch", "should touch", "is next to")
        for other in ("another", "any other", "the other", "each other", "another one", "any of the others")
    },
    **{f"{every}{rainbow}": _SPECTRUM
       for every in ("all ", "all eight ", "all of ", "all the ", "all of the ", "the ", "the eight ", "all the eight ",
                     "one of each of the ")
       for rainbow in ("rainbow colors", "colors of the rainbow", "colors of a rainbow", "color of the rainbow")
       if every != "the " or rainbow == "rainbow colors"},
    **{f"{draw} a{n} {shape}": f"{form} a {shape} outline"
       for draw, form in (("outline", "form"), ("outlines", "forms"), ("outlining", "forming"), ("trace", "form"),
                          ("trace out", "form"), ("traces", "forms"), ("tracing", "forming"))
       for n in ("", "n") for shape in ("triangle", "square", "rectangle", "circle", "ring")},
    **{f"{inside} {left}empty": "the inside empty" for inside in ("the inside", "the interior", "its inside")
       for left in ("left ", "kept ", "stays ", "remains ", "is left ", "is kept ", "staying ", "remaining ", "is ")},
    **{f"{rest} {free}": f"{rest} in any order" for rest in ("the rest", "the others", "the other blocks")
       for free in ("as you like", "however you like", "as you please", "as you wish", "any way you like")},
    **{f"{makes} {n}{what}": f"{n}{what} in all" for makes in ("that makes", "which makes")
       for n in lexicon.NUMBER for what in ("", " blocks", " cubes")},
    **{f"{has}{crept} into": f"{be} in" for has, be in (("has ", "is"), ("have ", "are"))
       for crept in ("crept", "slipped", "sneaked", "strayed", "wandered")},
}  # fmt: skip
"""What people write, and what it is read as."""


def rephrased(tokens: list[Token]) -> list[Token]:
    """The tokens with such turns of phrase in plain words; each of these stands for all that it replaces."""
    tokens = formal(tokens)
    said = {token.word for token in tokens}
    for words, plainly in _TURNS:
        if not said.isdisjoint(words):
            tokens = plainly(tokens)
    out: list[Token] = []
    at = 0
    while at < len(tokens):
        if tokens[at].word == "otherwise":
            out += _otherwise(tokens, at)
            at += 1
            continue
        if tokens[at].word in ("empty", "outline") and (shape := _hollow(tokens, at, out)) is not None:
            out += shape[0]
            at = shape[1]
            continue
        if tokens[at].word == "plus" and _goes_on(tokens, at):
            out.append(replace(tokens[at], word="and"))
            at += 1
            continue
        phrase, end = _longest(tokens, at)
        if not end:
            out.append(tokens[at])
            at += 1
            continue
        span = (tokens[at].span[0], tokens[end - 1].span[1])
        out += [Token("punct" if word == "," else "word", word, word, span) for word in _PHRASES[phrase].split()]
        at = end
    return out


def _longest(tokens: list[Token], at: int) -> tuple[str, int]:
    """The longest of the phrases that stands there and the position after it, or 0."""
    found, branch = ("", 0), tree_of(_PHRASES)
    for n in range(at, len(tokens)):
        if tokens[n].kind != "word" or tokens[n].word not in branch:
            break
        branch = branch[tokens[n].word]
        if None in branch:
            found = (branch[None][1], n + 1)
    return found


def _once_more(tokens: list[Token]) -> list[Token]:
    """ "A row of one red, one white and one red again": that red was listed before, the list shows."""
    words = [token.word for token in tokens]
    at = next((n for n, word in enumerate(words) if n > 3 and word == "again" and words[n - 1] in lexicon.COLOR), 0)
    begun = next((n for n in range(at - 1) if words[n] in _ROWS and words[n + 1] in ("of", ":", "with")), at)
    if not at or words[at - 1] not in words[begun : at - 1] or not {"and", "then", ","} & {*words[at - 3 : at - 1]}:
        return tokens
    return [*tokens[:at], *tokens[at + 1 :]]


_ROWS = frozenset({"row", "line", "column", "tower", "stack"})
_SPACED = (("touching",), ("evenly", "spaced"), ("equally", "spaced"), ("tightly", "packed"))
_LINED = frozenset({"row", "line", "column"})


def _spaced_behind(tokens: list[Token]) -> list[Token]:
    """ "Six evenly spaced red blocks in a row", "a row of six touching blocks": how they stand, said behind them."""
    words = [token.word for token in tokens]
    at = next((n for n, word in enumerate(words) if n and word in ("touching", "spaced", "packed")), 0)
    said = next((x for x in _SPACED if at and tuple(words[at + 1 - len(x) : at + 1]) == x), ())
    if not said:
        return tokens
    begin = at + 1 - len(said)
    noun = next((n for n in range(at + 1, min(at + 4, len(words))) if words[n] in lexicon.BLOCK), 0)
    counted = bool(said) and begin > 0 and (tokens[begin - 1].kind == "number" or words[begin - 1] in lexicon.NUMBER)
    if not noun or not counted or any(tokens[n].kind != "word" for n in range(at, noun)):
        return tokens
    lined = words[noun + 1 : noun + 3] in (["in", "a"], ["in", "one"]) and {*words[noun + 3 : noun + 4]} & _LINED
    end = noun + 4 if lined else noun + 1
    if not lined and not (words[begin - 2] == "of" and _LINED & {*words[max(0, begin - 4) : begin - 2]}):
        return tokens
    return [*tokens[:begin], *tokens[at + 1 : end], *tokens[begin : at + 1], *tokens[end:]]


_SHARES = frozenset({"half", "third", "row", "column", "layer", "rest", "others"})
_BY_TURNS = frozenset({"alternating", "alternate", "alternately", "checkerboard"})
_IN = frozenset({",", "in", "with", "of", "-", "has"})


def _so_many_colors(tokens: list[Token]) -> list[Token]:
    """ "A tower of four, two colours: the bottom two gray, the top two orange": that there are two is told by them,
    where it is also told how many blocks have each."""
    words = [token.word for token in tokens]
    for at in range(len(words) - 3, 1, -1):
        many = lexicon.NUMBER.get(words[at - 1]) or (int(words[at - 1]) if words[at - 1].isdigit() else 0)
        if words[at] != "colors" or words[at + 1] not in (":", ",") or words[at - 2] not in _IN or many < 2:
            continue
        end = next((n for n in range(at, len(words)) if words[n] in _ENDS), len(words))
        named = len({lexicon.COLOR[word] for word in words[at:end] if word in lexicon.COLOR}) == many
        told = sum(word in lexicon.NUMBER or word in _SHARES or word.isdigit() for word in words[at:end]) >= many
        if named and (told or not _BY_TURNS.isdisjoint(words[at:end])):
            tokens = [*tokens[: at - 2], *tokens[at + 1 :]]
    return tokens


def _in_the_corners(tokens: list[Token]) -> list[Token]:
    """ "Red takes the corners": the corners are red."""
    words = [token.word for token in tokens]
    for at in range(len(words) - 3):
        took = words[at + 1] in ("takes", "gets", "occupies") and words[at + 2 : at + 4] == ["the", "corners"]
        if took and words[at] in lexicon.COLOR and (at + 4 == len(words) or words[at + 4] in (*_ENDS, ",")):
            are = replace(tokens[at + 1], word="are")
            return [*tokens[:at], *tokens[at + 2 : at + 4], are, tokens[at], *_in_the_corners(tokens[at + 4 :])]
    return tokens


_OPPOSITE = {"left": "right", "right": "left", "top": "bottom", "bottom": "top", "front": "back", "back": "front"}
_EXTREMES = frozenset({"smallest", "largest", "biggest", "lowest", "highest", "greatest"})


def _from_end_to_end(tokens: list[Token]) -> list[Token]:
    """ "from the smallest on the left to the biggest on the right": from the smallest to the biggest, from left to
    right."""
    words = [token.word for token in tokens]
    for at in range(len(words) - 9):
        first = _extreme_at(words, at + 1) if words[at] == "from" else None
        second = (
            _extreme_at(words, first[1] + 1) if first is not None and words[first[1] : first[1] + 1] == ["to"] else None
        )
        if first is not None and second is not None and words[second[0]] == _OPPOSITE[words[first[0]]]:
            kept = [*range(at, at + 3), *range(first[1], first[1] + 3), at, first[0], first[1], second[0]]
            return [*tokens[:at], *(tokens[n] for n in kept), *tokens[second[1] :]]
    return tokens


def _extreme_at(words: list[str], at: int) -> tuple[int, int] | None:
    """Where the side is, and the end, of "the smallest (one) on the left (end)"."""
    if words[at : at + 1] != ["the"] or words[at + 1 : at + 2] == [] or words[at + 1] not in _EXTREMES:
        return None
    on = at + 2 + (words[at + 2 : at + 3] in (["one"], ["number"], ["digit"], ["block"], ["cube"]))
    side = on + 2
    if words[on:side] not in (["on", "the"], ["at", "the"]) or side >= len(words) or words[side] not in _OPPOSITE:
        return None
    end = side + 1 + (words[side + 1 : side + 2] == ["end"])
    return (side, end)


_LINES = frozenset({"tower", "stack", "row", "line", "column", "pile"})
_ENDS = frozenset({".", "!", "?", ";"})


def _was_so(tokens: list[Token]) -> list[Token]:
    """ "The tower was red, blue, white from bottom to top.": it is so at the start."""
    words = [token.word for token in tokens]
    for at in range(len(words) - 3, 0, -1):
        told = words[at - 1] == "the" and words[at] in _LINES and words[at + 1] == "was"
        listed = words[at + 2] in lexicon.COLOR or tokens[at + 2].kind in ("number", "literal")
        if not told or not (listed or (len(words[at + 2]) == 1 and words[at + 3 : at + 4] == [","])):
            continue
        begin = next((n + 1 for n in range(at - 1, -1, -1) if words[n] in _ENDS), 0)
        end = next((n for n in range(at, len(words)) if words[n] in _ENDS), len(words))
        said = bool({"start", "initially", "beginning", "first"} & {*words[begin:end]})
        begun = [Token("word", word, word, tokens[at + 1].span) for word in ("at", "the", "start")]
        begun = [] if said else [*begun, replace(begun[0], kind="punct", word=",", raw=",")]
        so = replace(tokens[at + 1], word="is")
        tokens = [*tokens[:begin], *begun, *tokens[begin : at + 1], so, *tokens[at + 2 :]]
    return tokens


_FURTHER_VERBS = frozenset({"show", "display", "make", "have", "let", "do", "leave", "see"})
_DETERMINERS = frozenset({"a", "the", "one", "big", "small", "large", "little"})


def _goes_on(tokens: list[Token], at: int) -> bool:
    """ "Spell CAT, plus put red on blue": no figure, but one more thing to do."""
    after = tokens[at + 1 : at + 3]
    if after and after[0].word in ("please", "also", "then"):
        after = after[1:]
    command = bool(after) and after[0].word in lexicon.COMMANDS
    command = command or (bool(after) and after[0].word in _FURTHER_VERBS)
    return command and at > 0 and tokens[at - 1].word not in _DETERMINERS


_HOLLOW = frozenset({"square", "rectangle", "circle", "triangle", "ring"})


def _hollow(tokens: list[Token], at: int, out: list[Token]) -> tuple[list[Token], int] | None:
    """ "an empty 3x3 square": a hollow one; "the outline of a 4x4 square": a 4x4 square outline."""
    words = [t.word if t.kind == "word" else "" for t in tokens[at : at + 8]]
    of = words[0] == "outline" and words[1:3] in (["of", "a"], ["of", "an"], ["of", "one"])
    begin = 3 if of else 1
    if (words[0] != "empty" and not of) or at + begin >= len(tokens):
        return None
    sized = 1 if tokens[at + begin].kind == "dims" else 3 if words[begin + 1 : begin + 2] == ["by"] else 0
    shape = begin + sized
    if words[shape : shape + 1] == [""] or not words[shape:] or words[shape] not in _HOLLOW or (of and not sized):
        return None
    if not of:
        return [replace(tokens[at], word="hollow"), *tokens[at + 1 : at + shape + 1]], at + shape + 1
    if out and out[-1].word == "the":
        out[-1] = replace(out[-1], word="a")
    return [*tokens[at + begin : at + shape + 1], tokens[at]], at + shape + 1


_SPOTS = frozenset({"spot", "place", "location"})
_FURTHER = frozenset({"another", "other", "second", "different"})


def _grouped(tokens: list[Token]) -> list[Token]:
    """ "the red ones in one spot and the blue ones in another": in one group and in another, for these are no patches
    of which it would have to be said where they are."""
    words = [token.word for token in tokens]
    one = next((n for n in range(len(words) - 2) if words[n : n + 2] == ["in", "one"] and words[n + 2] in _SPOTS), -1)
    rest = words[one + 3 :] if one >= 0 else []
    again = next((n for n, word in enumerate(rest) if word == "in" and {*rest[n + 1 : n + 3]} & _FURTHER), -1)
    if again < 0:
        return tokens
    at = one + 3 + again
    last = next(n for n in range(at + 1, at + 3) if words[n] in _FURTHER)
    spot = words[last + 1 : last + 2]
    out = list(tokens)
    out[one + 2] = replace(tokens[one + 2], word="group", raw="group")
    if spot and spot[0] in _SPOTS:
        out[last + 1] = replace(tokens[last + 1], word="group", raw="group")
    return out


def _otherwise(tokens: list[Token], at: int) -> list[Token]:
    """ "otherwise white": everything else is; "white otherwise": it is so elsewhere."""
    token = tokens[at]
    after = tokens[at + 1].word if at + 1 < len(tokens) else ""
    if after in lexicon.COLOR:
        return [Token("word", word, word, token.span) for word in ("everything", "else")]
    closed = after in ("", ",", ".", ";", "!", "?", ")")
    if at and tokens[at - 1].word in lexicon.COLOR and closed:
        return [Token("word", "elsewhere", "elsewhere", token.span)]
    return [token]


def _they_start(tokens: list[Token]) -> list[Token]:
    """ "They start as two towers.": where a text begins with it, the blocks that it goes on to speak of."""
    if [t.word for t in tokens[:1]] != ["they"] or tokens[1].word not in ("start", "begin"):
        return tokens
    return [replace(tokens[0], word="the"), replace(tokens[0], word="blocks"), *tokens[1:]]


_ON = frozenset({",", "then", "and", "next", "to", "it", "after", "that", "finally", "last"})
"""What goes on with a list that begins with "first"."""


def _one_by_one(tokens: list[Token]) -> list[Token]:
    """ "A row: first A, next to it 1, then B, 2 and C": the list of these."""
    words = [t.word for t in tokens]
    colon = next((n for n in range(len(words) - 1) if words[n : n + 2] == [":", "first"]), 0)
    end = next((n for n in range(colon, len(words)) if words[n] in _ENDS), len(words))
    rest = range(colon + 2, end)
    kept = [n for n in rest if words[n] not in _ON]
    looks = all(len(words[n]) == 1 or words[n] in lexicon.COLOR for n in kept)
    single = looks and all(words[n - 1] in (*_ON, "first") for n in kept)
    if not colon or len(kept) < 3 or not single or not _LINED & {*words[:colon]} or "," not in words[kept[0] : end]:
        return tokens
    comma = replace(tokens[colon], word=",", raw=",")
    listed = [x for n in kept for x in (comma, tokens[n])][1:]
    return [*tokens[: colon + 1], *listed, *tokens[end:]]


_TURNS: tuple[tuple[frozenset[str], Callable[[list[Token]], list[Token]]], ...] = (
    (frozenset({"again"}), _once_more),
    (frozenset({"takes", "gets", "occupies"}), _in_the_corners),
    (_EXTREMES, _from_end_to_end),
    (frozenset({"touching", "spaced", "packed"}), _spaced_behind),
    (frozenset({"colors"}), _so_many_colors),
    (_SPOTS, _grouped),
    (frozenset({"was"}), _was_so),
    (frozenset({"start", "begin"}), _they_start),
    (frozenset({"first"}), _one_by_one),
    *IN_OTHER_WORDS,
)
"""Turns of phrase that are told by whole sentences, with words one of which they have."""
