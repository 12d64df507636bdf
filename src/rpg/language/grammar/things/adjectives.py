"""What describes a block or a patch: colours, sizes, labels, kinds; before the noun or after it."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from rpg.language import lexicon
from rpg.language.grammar.core import Parser, Results, choice, rule
from rpg.language.grammar.talk.slots import Patterns
from rpg.language.grammar.things.amounts import length, of_more
from rpg.language.grammar.things.bare_labels import borne
from rpg.language.grammar.things.edges import STANDARD, USUAL, each_long, edge_told
from rpg.language.grammar.things.labels import COUNTED_NOUNS, from_to, label_list, look_at, symbol_at
from rpg.language.grammar.things.nth_largest import NTH_LARGEST
from rpg.language.grammar.things.patch_sides import patch_side
from rpg.language.meaning import Traits


class Marks(dict[str, Any]):
    """Traits by name; hashable, so that rules can be memoised on them."""

    def __hash__(self) -> int:  # type: ignore[override]
        return hash(tuple(sorted(self.items(), key=lambda item: item[0])))


EMPTY = Marks()

_PLAIN = {
    "empty": ("empty", True), "free": ("empty", True), "vacant": ("empty", True), "unoccupied": ("empty", True),
    "long": ("long", True), "elongated": ("long", True), "semantic": ("kind", "symbol"), "symbol": ("kind", "symbol"),
    **dict.fromkeys(("plain", "ordinary", "blank", "unmarked"), ("kind", "plain")), "symbols": ("kind", "symbol"),
    "extra": ("extra", True), "distractor": ("extra", True),
    "additional": ("extra", True), "unused": ("extra", True), "superfluous": ("extra", True),
    "irrelevant": ("extra", True), "spare": ("extra", True), "unneeded": ("extra", True),
    "matching": ("matching", True),
    "corresponding": ("matching", True), "respective": ("matching", True),
    "even": ("quality", "even"), "odd": ("quality", "odd"), "vowel": ("quality", "vowel"),
    "consonant": ("quality", "consonant"),
    "alphabet": ("kind", "letter"), "alphabetic": ("kind", "letter"), "lettered": ("kind", "letter"),
    "numbered": ("kind", "digit"), "letter": ("kind", "letter"), "letters": ("kind", "letter"),
    "number": ("kind", "digit"), "digit": ("kind", "digit"), "numeric": ("kind", "digit"),
    "circular": ("shape", "circle"), "round": ("shape", "circle"), "square": ("shape", "square"),
    "rectangular": ("shape", "rectangle"), "target": ("target", True), "goal": ("target", True),
    "designated": ("target", True), "identical": ("scheme", "same"), "mixed": ("scheme", "mixed"),
    "assorted": ("scheme", "mixed"), "multicolored": ("scheme", "different"), "multicoloured": ("scheme", "different"),
    "colorful": ("scheme", "different"), "colourful": ("scheme", "different"), "colored": ("scheme", "some"),
    "coloured": ("scheme", "some"), "color": ("scheme", "some"), "colour": ("scheme", "some"),
    "top": ("rank", "top"), "topmost": ("rank", "top"), "uppermost": ("rank", "top"), "highest": ("rank", "top"),
    "bottom": ("rank", "bottom"), "lowest": ("rank", "bottom"), "lowermost": ("rank", "bottom"),
    "bottommost": ("rank", "bottom"), "middle": ("rank", "middle"), "central": ("rank", "middle"),
    "center": ("rank", "middle"), "outer": ("rank", "outer"), "outermost": ("rank", "outer"),
    "leftmost": ("rank", "left"), "rightmost": ("rank", "right"), "frontmost": ("rank", "front"),
    "nearest": ("rank", "front"), "rearmost": ("rank", "back"), "farthest": ("rank", "back"),
    "base": ("rank", "bottom"), "largest": ("rank", "largest"), "biggest": ("rank", "largest"),
    "smallest": ("rank", "smallest"), "larger": ("rank", "larger"), "bigger": ("rank", "larger"),
    "smaller": ("rank", "smaller"), "cubic": ("target", True), "new": ("target", True),
    "individual": ("target", True),
    "loose": ("target", True), "single": ("target", True), "lone": ("target", True),
    "same": ("scheme", "same"), "different": ("scheme", "different"), "unique": ("scheme", "different"),
}  # fmt: skip
"""Single words. "target" here only says "the one meant"; it selects nothing."""

_PHRASES = NTH_LARGEST | {
    "circle shaped": ("shape", "circle"), "square shaped": ("shape", "square"), "same color": ("scheme", "same"),
    "rectangle shaped": ("shape", "rectangle"), "same colored": ("scheme", "same"), "same coloured": ("scheme", "same"),
    "single colored": ("scheme", "same"), "differently colored": ("scheme", "different"),
    "differently coloured": ("scheme", "different"), "different colored": ("scheme", "different"),
    "different coloured": ("scheme", "different"), "different color": ("scheme", "different"),
    "multi colored": ("scheme", "different"), "multi coloured": ("scheme", "different"),
    "randomly colored": ("scheme", "mixed"), "mixed color": ("scheme", "mixed"), "assorted color": ("scheme", "mixed"),
    "assorted colored": ("scheme", "mixed"), "color specific": ("matching", True), "color matched": ("matching", True),
    "color coded": ("matching", True), "colour coded": ("matching", True), "matching color": ("matching", True),
    "matching colored": ("matching", True), "matching colour": ("matching", True), "color matching": ("matching", True),
    "corresponding colored": ("matching", True), "corresponding color": ("matching", True),
    "colored matching": ("matching", True), "same colour": ("scheme", "same"),
    "rainbow colored": ("scheme", "different"), "uniquely colored": ("scheme", "different"),
}  # fmt: skip


def merge(marks: Mapping[str, Any], update: Mapping[str, Any]) -> Marks | None:
    """Both, unless they contradict each other."""
    merged = Marks(marks)
    for key, value in update.items():
        had = merged.get(key)
        if had and had != value:
            if key == "scheme" and "some" in (had, value):
                value = had if value == "some" else value
            elif key == "kind" and {had, value} == {"letter", "symbol"}:
                value = "letter"
            elif key == "kind" and {had, value} == {"digit", "symbol"}:
                value = "digit"
            else:
                return None
        merged[key] = value
    return merged


def clash(traits: Traits, update: Mapping[str, Any]) -> bool:
    """Whether `update` contradicts what `traits` says already."""
    for key, value in update.items():
        had = getattr(traits, key)
        if had and value and had != value and not (key == "kind" and "symbol" in (had, value)) and key != "scheme":
            return True
    return False


@rule
def adjectives(p: Parser, i: int) -> Results[Marks]:
    """Every run of adjectives from i on, the empty one included, longest first."""
    for update, j in adjective(p, i):
        comma = p.opt(j, ",")
        runs = [(rest, k) for rest, k in adjectives(p, comma) if rest] if comma > j else list(adjectives(p, j))
        runs += [(EMPTY, j)] if comma > j else []
        for rest, k in runs:
            after = rest.keys() & ({"colors", "rank", "scheme"} if update.get("colors") else ())
            both = merge(update, rest) if not after else None
            if both is not None:
                yield both, k
    yield EMPTY, i


@rule
def color(p: Parser, i: int) -> Results[str]:
    """A colour, with a shade that the palette does not tell apart ("navy blue", "bright red")."""
    if p.lex(i, lexicon.COLOR):
        first = lexicon.COLOR[p.words[i]]
        second = lexicon.COLOR.get(p.words[i + 1]) if i + 1 < p.end else None
        if second is not None and (first == second) and p.words[i] != second:
            yield first, p.reach(i + 2)
        yield first, i + 1
    elif p.stands(i, lexicon.SHADE) and p.stands(i + 1, lexicon.COLOR):
        yield lexicon.COLOR[p.words[i + 1]], p.reach(i + 2)


@rule
def colors(p: Parser, i: int) -> Results[tuple[tuple[str, ...], bool]]:
    """A colour or a list of them, longest first; True for alternatives ("red or blue")."""
    for first, j in color(p, i):
        listed, at, either, mixed = [first], j, False, ""
        readings: list[tuple[tuple[tuple[str, ...], bool], int]] = [(((first,), False), j)]
        while True:
            k = p.opt(at, ",", "/")
            joined = p.one(k, ("and", "or", "&"))
            if k == at and not joined:
                break
            more = list(color(p, joined or k))
            word = p.words[k] if joined else ""
            if not more or (word and mixed and (word == "or") != (mixed == "or")):
                break
            # "red is above blue and blue above green"; "red, green and blue, green at the left end"
            if more[0][0] in listed and (mixed if not word else len(listed) == 1):
                break
            mixed = word or mixed
            either = either or word == "or"
            listed.append(more[0][0])
            at = more[0][1]
            readings.append(((tuple(listed), either), at))
        yield from reversed(readings)
        return


@rule
def adjective(p: Parser, i: int) -> Results[Marks]:
    """One adjective."""
    for phrase, j in p.standing(i, _PHRASES):
        key, value = _PHRASES[phrase]
        yield Marks({key: value}), j
    for (listed, either), j in colors(p, i):
        yield (
            Marks({"colors": listed, **({"either": True} if either else {})}),
            p.opt(j, "colored", "coloured", "color", "bodied", "painted", "hued", "ish"),
        )
    if plain := p.peek(i, _PLAIN):
        key, value = plain
        yield Marks({key: value}), p.reach(i + 1)
    if p.stands(i, USUAL) and (j := p.any_of(i + 1, ("sized", "size", "edged"))):
        yield EMPTY, j
    size = p.lex(i, lexicon.SIZE)
    if size:
        yield Marks({"size": size}), i + 1
    for metres, j in length(p, i):
        j = p.any_of(j, ("in size", "in width", "on each side", "a side")) or p.opt(
            j, "wide", "large", "big", "sized", "long"
        )
        yield Marks({"edge": metres}), j
    ordinal = p.lex(i, lexicon.ORDINAL)
    if ordinal:
        yield Marks({"rank": str(ordinal)}), i + 1
    if p.words[i : i + 1] == ["last"]:
        yield Marks({"rank": "last"}), p.reach(i + 1)
    yield from ((Marks(told), j) for told, j in patch_side(p, i))
    for (labels, more), j in label_list(p, i):
        sign = labels[0] in "+-*/="
        plural = lexicon.BLOCK.get(p.words[j], lexicon.SYMBOL.get(p.words[j]) if sign else None)
        several = plural and (labels[0].isalpha() or sign) and _counted(p, i)
        if len(labels) == 1 and (
            (plural is not False and not several)
            or (labels[0].isdigit() and not (i and _introduces_a_digit(p.words[i - 1])))
        ):
            continue
        if len(labels) > 1 and plural is not True:
            continue
        yield Marks({"labels": labels, **({"open_ended": True} if more else {})}), j


def _counted(p: Parser, i: int) -> bool:
    """ "two A blocks", "both A blocks": so many with the same letter."""
    told = i > 0 and (p.words[i - 1] in ("both", "all", "the") or p.number(i - 1) is not None)
    return told and (p.tokens[i].raw.isupper() or not p.tokens[i].raw[0].isalpha() or len(p.tokens[i].raw) > 1)


def _introduces_a_digit(word: str) -> bool:
    """ "the 3 block", "a digit 3 block": a number there is on the block, it does not count blocks."""
    return word in ("the", "a", "an", "digit", "number", "numeral") or word in lexicon.COLOR


_LABELLED = ("labelled", "labeled", "marked", "showing", "named", "called", "bearing", "reading", "saying", "carrying",
             "with", "numbered", "displaying", "lettered")  # fmt: skip
_SHOWING = ("marked", "labelled", "labeled", "numbered", "lettered",
            *(f"{at} the {sign}" for at in ("with", "showing") for sign in ("letter", "digit", "number")))  # fmt: skip
"""Behind a mere number, what tells the blocks: "two cubes marked X and three marked O"."""
_WITH_A = ("with a", "with an")
_CALLED = frozenset({"number", "letter", "digit", "numbers", "letters"})
"""What stands between a block and the symbol by which it is called: "the block number 3"."""
_LABEL_NOUNS = _CALLED | {"label", "labels", "digits", "symbol", "symbols", "sign"}
_LABEL_PLURALS = frozenset(word for word in _LABEL_NOUNS if word.endswith("s"))
_KINDS = {"letter": "letter", "letters": "letter", "number": "digit", "numbers": "digit", "digit": "digit",
          "digits": "digit", "symbols": "symbol", "symbol": "symbol"}  # fmt: skip


_SCHEMES = {
    "of the same color": "same", "of one color": "same", "of a single color": "same", "of identical color": "same",
    "in the same color": "same", "in a single color": "same", "of just one color": "same",
    "of different colors": "different", "in different colors": "different", "of a different color": "different",
    "each of a different color": "different", "with different colors": "different", "of distinct colors": "different",
    "of various colors": "different", "of all different colors": "different", "all of different colors": "different",
    "of multiple colors": "different", "of varying colors": "different", "in various colors": "different",
    "of assorted colors": "mixed", "of mixed colors": "mixed", "of any color": "mixed", "in assorted colors": "mixed",
    **{f"{of} {which} {hue}": "mixed" for of in ("of", "in", "with")
       for which in ("any", "whatever", "whichever", "arbitrary", "random") for hue in ("color", "colors")},
    **{f"{all_}{alike}": "different" for all_ in (", all ", ", ", ", each ", ", all of them ")
       for alike in ("different colors", "of different colors", "in different colors", "differently colored",
                     "of a different color", "in a different color", "in another color", "of another color",
                     "different in color", "with different colors", "distinct colors", "a different color",
                     "another color", "in a color of its own")},
}  # fmt: skip
"""What is said of the colours of several blocks or patches."""
_ALIKE = ("with the same color", "that have the same color", "which have the same color", "having the same color",
          "with equal colors", "with the same colors", "that share a color", "sharing a color", "of like color",
          "that share the same color", "of equal color")  # fmt: skip
"""What is said of blocks that agree in colour."""
_MATCHING = tuple(
    dict.fromkeys(
        phrase.replace("color", word)
        for phrase in (
            "with the same color", "of its color", "of its own color", "of the same color", "of matching color",
            "of that color", "of the corresponding color", "of their color", "in its color", "of their own color",
            "of the matching color", "with matching color", "that matches its color", "matching its color",
            "that matches their color", "matching their color", "matching in color", "with its color",
            "that match its color", "that match their color", "with the matching color", "that has the same color",
            "that have the same color", "which have the same color", "which has the same color", "that has its color",
            "that has its own color", "which has its own color", "that have their own color", "that shows its color",
            "that have their color", "in the same color", "in its own color", "of equal color",
            "in the matching color", "in matching color", "with its own color", "that matches it in color",
            "that matches in color", "that match in color", "with that color", "in that color", "in their color",
            *(f"{of} the same color as {it}" for of in ("of", "with", "in", "that has", "which has", "that have")
              for it in ("it", "the block", "the cube", "itself", "them", "the blocks", "the cubes")),
        )
        for word in ("color", "colors")
    )
)  # fmt: skip
"""What is said of a patch that has the colour of what goes on it."""
_LIKE_THE_BLOCK = Patterns(
    "of|with|in|having|that_has|which_has|that_have|that_is|that_is_of the|a? same|matching|corresponding "
    "color|colors as|like the|that|each|its? block|cube|it|them|blocks|cubes|itself|themselves|brick|box",
    "that|which matches|match it|them|the_block|the_cube|the_blocks|the_cubes in? color?",
    "whose color matches|equals it|them|the_block|the_cube|the_block_'s|the_cube_'s|that_of_the_block",
    "colored|painted like|the_same_as it|them|the_block|the_cube|the_blocks",
)
"""What is said of a patch that has the colour of what goes on it, naming that."""
_EDGE_OF = (
    "of size", "of edge", "with edges of", "with sides of", "of edge length", "of", "measuring",
    *(
        f"{lead}{edge}{of}"
        for lead in ("with ", "with an ", "with a ", "has an ", "has a ", "has ", "have ", "have an ", "have a ",
                     "of an ")
        for edge in ("edge", "edges", "edge length", "side", "sides", "side length", "size")
        for of in ("", " of")
    ),
)  # fmt: skip
"""What stands before the length of a block's edge."""
_OWN = ("of its own", "of their own", "to itself", "to themselves")
_BESIDE = frozenset({"next", "beside", "behind", "front", "near", "left", "right"})
_MARKED = tuple(f"{how}on the table" for how in ("", "designated ", "marked ", "painted ", "drawn "))
_EDGES = ("edges", "edge", "sides", "side", "edge length", "side length", "edge lengths", "side lengths")


_ALL_OF_THEM = (
    ", all of them", ", all in", ", all", ", all are", ", which are all", "which are all", "that are all", ", each",
    ", both", ", every one of them",
)  # fmt: skip
_ONE_THING = frozenset(w for t in (lexicon.BLOCK, lexicon.PATCH) for w, plural in t.items() if not plural) | {"one"}
"""Behind these "all" and "both" speak of something else: "three blocks on the mat, all yellow"."""


@rule
def of_quality(p: Parser, i: int, head: str) -> Results[Marks]:
    """What follows a noun directly: "A", "labelled A", "with letters", "of the same colour", "of 5 cm", "in red"."""
    if head == "block":
        yield from _symbols_after(p, i)
    elif head == "any" and (p.any_of(i, _SHOWING) or (p.any_of(i, _WITH_A) and p.follows(i, ("one",)))):
        yield from _labelled(p, i)
    for phrase, j in p.standing(i, _SCHEMES):
        scheme = Marks({"scheme": _SCHEMES[phrase]})
        yield from ((scheme, k) for k in ({j, p.opt(j, ",")} if phrase[0] == "," else (j,)))
    for _, j in p.standing(i, _ALL_OF_THEM) if not p.follows(i, _ONE_THING) else ():
        for (listed, _either), k in colors(p, j):
            if len(listed) == 1 and not of_more(p, i + 1):
                yield Marks({"colors": listed}), k
    if head != "patch" and (j := p.any_of(i, _ALIKE)):
        yield Marks({"scheme": "same"}), j
    if head in ("patch", "block") and (j := p.any_of(i, _OWN)):
        yield Marks({"scheme": "different"}), j
    beside = p.stands(i, ("on",)) and not _BESIDE.isdisjoint(p.words[max(0, i - 6) : i])
    if head == "patch" and not beside and (j := p.any_of(i, _MARKED)):
        yield Marks({"target": True}), j
    yield from ((Marks({"matching": True}), j) for j in _LIKE_THE_BLOCK.matches(p, i) if head == "patch")
    for phrase, j in p.standing(i, _MATCHING):
        if head == "patch" or "same" not in phrase:
            yield Marks({"matching": True}), j
    if j := p.any_of(i, _EDGE_OF):
        yield from ((Marks({"edge": metres}), p.any_of(k, _EDGES) or k) for metres, k in length(p, j))
    yield from ((Marks({"edge": metres}), j) for metres, j in each_long(p, i))
    if j := p.any_of(i, STANDARD):
        yield EMPTY, j
    if head == "block":
        yield from ((Marks({"edge": metres}), j) for metres, j in edge_told(p, i))
    if j := p.any_of(
        i, ("with", "having", "that has", "which has", "with a", "have", "has", "that have", "which have")
    ):
        for metres, k in length(p, j):
            if end := p.any_of(k, _EDGES):
                yield Marks({"edge": metres}), end
    if j := p.any_of(i, _HUED):
        for (listed, either), k in colors(p, j):
            body = p.one(k, _BODY)  # "the cube of green color"
            goes_on = p.words[i] in ("colored", "painted", "of", "in") and _goes_on(p, k)
            if body or not (goes_on or p.words[j - 1] in ("with", "a", "the", "of", "having")):
                yield Marks({"colors": listed, "either": either}), body or k


_HUED = ("in", "in color", "colored", "coloured", "painted", "of color", "with color", "with a", "with", "with the",
         "of", "of the", "in the", "having", "colored in", "painted in", "that looks", "which looks")  # fmt: skip
_BODY = frozenset({"body", "bodies", "color"})


def _goes_on(p: Parser, k: int) -> bool:
    """ "coloured red, white and blue": the first colours alone are not what is said."""
    j = p.opt(p.opt(k, ","), "and")
    after = p.words[j + 1]
    return j > k and p.words[j] in lexicon.COLOR and after not in lexicon.BLOCK and after not in ("one", "ones")


@choice
def _symbols_after(p: Parser, i: int) -> Results[Marks]:
    """ "(blocks) A, B and C", "(letters) from A to D", "(blocks) labelled A", "(blocks) red and blue"."""
    told = label_list(p, i, p.follows(i, _LABEL_NOUNS))
    several = len(told) > 1 and p.follows(i, _LABEL_PLURALS)
    for (labels, more), j in told:
        if several and len(labels) == 1:
            continue
        yield Marks({"labels": labels, **({"open_ended": True} if more else {})}), j
    yield from ((Marks({"labels": labels}), k) for labels, k in from_to(p, i))
    yield from _labelled(p, i)
    yield from ((Marks({"labels": labels}), k) for labels, k in borne(p, i))
    if (j := p.one(i, _CALLED)) and p.follows(i, lexicon.BLOCK) and not look_at(p, i - 2):
        yield from ((Marks({"labels": labels}), k) for (labels, more), k in label_list(p, j, True) if not more)
    if p.follows(i, ("blocks", "cubes", "bricks")):
        for (listed, either), k in colors(p, p.opt(i, ":")):
            if len(listed) > 1 and not either and not _goes_on(p, k):
                yield Marks({"colors": listed}), k


@choice
def _labelled(p: Parser, i: int) -> Results[Marks]:
    j = p.any_of(i, _LABELLED)
    if not j:
        return
    j = p.opt(j, "with", "as", "by")
    j = p.opt(j, "the", "an") if j < p.end and p.tokens[j].raw == "A" else p.opt(j, "the", "a", "an")
    noun = p.one(j, _LABEL_NOUNS)
    if noun or p.words[i] not in ("with", "carrying") or (j > p.any_of(i, ("with",)) and not symbol_at(p, i - 1)):
        read = not noun and p.words[i] in ("reading", "saying") and "of" in p.words[max(0, i - 3) : i]
        for (labels, more), k in label_list(p, noun or j, True):
            counts = k < p.end and p.words[k] in COUNTED_NOUNS  # "with the two colours alternating" names no 2
            if not counts and (len(labels) < 2 or not read):  # "a row of cubes reading C, A, B" is read from the left
                yield Marks({"labels": labels, **({"open_ended": True} if more else {})}), k
    if noun and p.words[j] in _KINDS:
        yield Marks({"kind": _KINDS[p.words[j]]}), p.any_of(noun, ("on them", "on it", "on top")) or noun
