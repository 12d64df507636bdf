"""Words that mean nothing wherever they stand: hesitation, thanks, emphasis. They are left out before the reading."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace

from rpg.language import lexicon
from rpg.language.grammar.core import Parser
from rpg.language.grammar.structures.repeating import repeated
from rpg.language.grammar.talk.arrows import in_words
from rpg.language.grammar.talk.corrected import corrected
from rpg.language.grammar.talk.framing import VIEW, told_down
from rpg.language.grammar.talk.in_short import begins_thing, meant
from rpg.language.grammar.talk.left_open import ANY_OF_THEM, ANYPLACE, FOREIGN, FREE, LOOSE, left_to_choose
from rpg.language.grammar.talk.list_marks import lists_in_one
from rpg.language.grammar.talk.people import TITLES
from rpg.language.grammar.talk.plainer import plainer
from rpg.language.grammar.talk.rephrased import rephrased
from rpg.language.grammar.talk.tastes import taste_told
from rpg.language.grammar.things.all_but import exceptions_first
from rpg.language.grammar.things.remainder import reckoned
from rpg.language.tokens import Token

_ANYWHERE = (
    "once upon a time", "as a result", "long story short", "in short", "as discussed", "as agreed", "as requested",
    "to sum up", "in summary", "pretty please", "as promised", "as usual", "as mentioned", "as planned",
    "all in all", "um", "umm", "uh", "uhm", "er", "erm", "ehm", "eh", "hmm", "hmmm", "hm", "ah", "oh",
    "let me think", "let me see", "yeah", "yep", "yup", "yo", "lol", "haha", "mind you",
    "cheers", "thx", "ty", "tx", "thanks", "thanks a lot", "thanks so much", "thanks in advance", "many thanks",
    "thank you", "thank you very much", "thank you so much", "please", "pls", "plz", "please and thank you",
    "idk", "tbh", "btw", "by the way", "imo", "fyi", "i guess", "i suppose", "you know", "dunno", "i do not know",
    "i would say", "basically",
    "essentially", "literally", "honestly", "obviously", "of course", "kindly", "so to speak",
    "if possible", "if at all possible", "if you can", "if you could", "if you please", "if you do not mind",
    "if it is possible", "if it is not too much trouble", "if that is not too much trouble",
    "if it is not too much to ask", "if that is not too much to ask", "if that is okay", "if that is ok",
    "good morning", "good evening", "good afternoon", "be so kind and", "be so kind as to", "be so good as to",
    "be kind enough to", "be a dear and", "be an angel and", "be so nice and",
    *(f"{when} you have a {while_}" for when in ("if", "when") for while_ in ("minute", "moment", "second", "sec")),
    "dear machine", "dear robot", "dear computer", "nothing fancy", "nothing special", "no rush", "no hurry",
    "kinda", "possibly", "while you are at it", "good luck", "maybe", "perhaps",
    "my dear", "dear", "sweetheart", "darling", "honey", "hereby", "by contrast", "in contrast",
    "grazie", "merci", "danke", "gracias", "bitte", "por favor", "nah", "nope", "asap", "idc",
    "thanks a million", "thanks a bunch", "thanks a ton",
    "bro", "gg", "gl", "hf", "noob", "if you would", "sorry about the mess", "easy one", "tada",
    "sir", "madam", "as seen from the camera", "as seen by the camera", "seen from the camera",
    "when seen from the camera", "as seen from the viewer", "as the camera sees it", "as the camera sees them",
    "as seen in the camera image", "in the camera image", "from the camera 's point of view",
)  # fmt: skip
"""Phrases that carry nothing in any place."""
_ADDRESSED_AS = ("mate", "buddy", "dude", "my friend", "pal", "guys", "folks")
"""Whom it is said to; who wants something is spoken of."""
_WANTS = frozenset({"wants", "likes", "would", "needs", "asks", "asked", "wanted", "prefers", "says", "said", "wishes"})
SOFT = "(soft)"
"""The value of a comma that may have set off nothing but an aside; no number or quotation has it."""
_HESITATIONS = frozenset({"um", "umm", "uh", "uhm", "er", "erm", "ehm", "eh", "hmm", "hmmm", "hm", "ah", "oh"})
_EMPHASIS = ("really", "very", "super", "quite", "pretty", "nice", "neat", "tidy", "lovely", "beautiful", "cool",
             "nice and neat", "nice and tidy", "good", "proper", "dead", "smack", "bang", "slap bang",
             "smack bang", "plumb", "right smack")  # fmt: skip
"""What carries nothing in front of a description; by itself it would be what is asked for."""
_LINES = frozenset({"row", "line", "tower", "stack", "towers", "stacks", "column", "rows", "columns", "layers"})
_STOPS, _ENDED = frozenset({"…", ";", ".", "!", "?", ":"}), frozenset({".", "!"})
_BREAKS, _PAUSES = _STOPS | {","}, _STOPS | {",", *_HESITATIONS}
_DEGREE_WORDS = "if as that when of for enough and but to near close far long small big large tiny up away out"
_DEGREES = frozenset(_DEGREE_WORDS.split())
"""What an emphasis in front of them would change."""
_BEGUN = frozenset({"and", "but", "so", "the", "a", "an", "on", "onto", "in", "to", "of", "with"})
"""Words that are said again when what they begin is begun again."""


def without_asides(tokens: list[Token]) -> list[Token]:
    """The tokens without words that mean nothing, and without the commas that set them off."""
    tokens = lists_in_one(corrected(tokens[_answering(tokens) or taste_told(tokens) :]))
    tokens = [(_side(tokens, n) or _between(tokens, n)) if t.word in _SHORT else t for n, t in enumerate(tokens)]
    tokens = [token for n in range(len(tokens)) for token in _left_open(tokens, n)]
    words = ["" if t.kind not in ("word", "punct") or _shouted(t) else t.word for t in tokens]
    p = Parser(tokens)
    out: list[Token] = []
    waiting: list[Token] = []
    upright = _letter(words)
    at = 0
    while at < len(tokens):
        end = _standing(words, at)
        if upright and (words[at] in VIEW.firsts or "seen" in words[at:end]):
            seen = max((j for j in VIEW.matches(p, at)), default=end if "camera" in words[at:end] else at)
            if seen > at:
                out, at = out + tokens[at:seen], seen
                continue
        if words[at] in VIEW.firsts and not told_down(words, at):
            end = max((j for j in VIEW.matches(p, at) if j > end and _same_view(words, at, j)), default=end)
        if (chosen := left_to_choose(p, at)) > end and _set_off(words, at, chosen):
            end = chosen
        if words[at] in ("left", "right") and at and words[at - 1] in _ENDED and words[at] in _before(words, at - 1):
            views = (j for j in VIEW.matches(p, at + 1) if j == len(words) or words[j] in _ENDED)
            end = max(views, default=end)  # "Left as I see it.", where something was said to be left
        if end == at:
            if waiting and words[at] in _STOPS:
                out, waiting = out + waiting, []
            again = out and (raw := tokens[at].raw) == words[at] in _BEGUN and out[-1].raw in (raw, raw.capitalize())
            if not again or (out[-1].raw == "A" and len(out) > 1):  # "turn block A a quarter turn"
                out.append(tokens[at])
            at += 1
        elif "order" in words[at:end] and not _LINES.isdisjoint(words):
            # A list tells an order unless this is said, behind it or in a sentence of its own.
            said = tokens[at + words[at:end].index("order")]
            free = [replace(said, value=SOFT, word=word) for word in ("in", "any", "order")]
            opened = not out or (out[-1].word in _STOPS and (end == len(tokens) or words[end] in _STOPS))
            if opened and _LINES.isdisjoint(words[:at]):
                waiting, at = free, end + 1
                continue
            if out and out[-1].word in _BREAKS:
                out[-1] = replace(out[-1], kind="punct", word=",", value=SOFT)
            out, at = out + free, end
        else:
            at = _closed(tokens, out, end, words[at] in _HESITATIONS)
    out += waiting
    plain = rephrased(plainer(in_words(repeated([token for n in range(len(out)) for token in meant(out, n)]))))
    return reckoned(exceptions_first(plain))


_WAYS = frozenset({
    "left", "right", "front", "back", "far", "near", "up", "down", "upright", "upside", "towards", "toward", "away",
    "pointing", "points", "turned", "rotated", "facing", "direction", "orientation", "open", "opening", "next",
    "beside",
})  # fmt: skip


def _letter(words: list[str]) -> bool:
    """Whether blocks are to form a letter, and no way is told in which it points: who looks at it makes it upright."""
    shaped = any(
        word in ("t", "l", "u", "v") and words[n - 1 : n] in (["a"], ["an"], ["letter"], ["capital"], ["big"])
        for n, word in enumerate(words)
    )
    return shaped and _WAYS.isdisjoint(words) and "block" not in words


def _before(words: list[str], end: int) -> list[str]:
    """The words of the sentence that ends there."""
    return words[max((n for n in range(end) if words[n] in _ENDED), default=0) : end]


def _between(tokens: list[Token], at: int) -> Token:
    """ "white btw red and black": "btw" between things, with an "and" to come, is "between"; else it is by the way."""
    token = tokens[at]
    if token.word != "btw" or not 0 < at < len(tokens) - 1 or tokens[at - 1].word in _BREAKS:
        return token
    joined = any(t.word in ("and", "&", "n", "2", "two", "both") for t in tokens[at + 1 : at + 8])
    return replace(token, word="between") if joined and begins_thing(tokens[at + 1]) else token


_SIDE = {"l": "left", "r": "right"}
_SHORT = frozenset({*_SIDE, "btw"})
_LETTERS = frozenset({"letters", "letter", "blocks", "cubes", "from", "spell", "symbols", "labels", "characters"})


def _side(tokens: list[Token], at: int) -> Token | None:
    """ "row (l to r): ...": from left to right, where no letters are spoken of."""
    if tokens[at].word not in _SIDE:
        return None
    for first in (at, at - 2):
        way = [t.word for t in tokens[max(first, 0) : first + 3]]
        if way not in (["l", "to", "r"], ["r", "to", "l"]):
            continue
        behind = [t.word for t in tokens[first + 3 : first + 5] if t.word != ")"]
        small = tokens[first].raw.islower() and tokens[first + 2].raw.islower()
        if (small or behind[:1] == [":"]) and not (first and tokens[first - 1].word in _LETTERS):
            side = _SIDE[tokens[at].word]
            return replace(tokens[at], word=side, raw=side)
    return None


def _shouted(token: Token) -> bool:
    return token.kind == "word" and len(token.raw) > 1 and token.raw.isupper()


def _standing(words: list[str], at: int) -> int:
    """The position after the longest aside that stands and fits here, or `at`."""
    longest = at
    begun = _ASIDES.get(words[at])
    for phrase, fits in [x for y in {"", *words[at + 1 : at + 2]} for x in begun.get(y, ())] if begun else ():
        end = at + len(phrase)
        if end > longest and words[at:end] == phrase and fits(words, at, end):
            longest = end
    return longest


_NO = frozenset({"nah", "nope", "naw"})


def _answering(tokens: list[Token]) -> int:
    """ "Nah, red goes on blue": where an instruction that begins with an answer to nothing goes on."""
    begun = [token.word for token in tokens[:2]]
    if len(tokens) < 3 or not (begun[0] in _NO or begun == ["no", ","]):
        return 0
    return 2 if begun[1] == "," else 1


_CHOSEN = tuple(
    f"{you} {like}" for you in ("you", "u") for like in ("like", "want", "please", "prefer", "fancy", "choose", "wish")
)
"""What carries nothing behind "any two blocks"."""
_ANY = frozenset({"any", "whichever", "whatever"})


def _chosen(words: list[str], at: int, end: int) -> bool:
    """ "any two blocks you like": whichever these are."""
    begin = max((n + 1 for n in range(at) if words[n] in _BREAKS), default=0)
    named = at > 0 and any(words[at - 1] in table for table in (lexicon.BLOCK, lexicon.COLOR_PLURAL, _NAMES))
    return named and not _ANY.isdisjoint(words[begin:at]) and words[end : end + 1] != ["to"]


_TAGS = tuple(
    f"{may} you{dear}" for may in ("would", "will", "could", "can")
    for dear in ("", " dear", " love", " please", " mate"))  # fmt: skip
"""What carries nothing behind a command, set off by commas: ", would you, "."""


def _tag(words: list[str], at: int, end: int) -> bool:
    return at > 1 and words[at - 1] == "," and (end == len(words) or words[end] in _BREAKS)


_NAMES = frozenset({"letter", "letters", "digit", "digits", "number", "numbers", "vowel", "consonant"})


def _some_day(words: list[str], at: int, end: int) -> bool:
    """ "in two rows today": of no block; but "today's goal", "for today"."""
    return words[end : end + 1] != ["'s"] and (not at or words[at - 1] not in ("for", "until", "from", "by", "since"))


def _emphatic(words: list[str], end: int) -> bool:
    """Whether a description follows."""
    after = words[end] if end < len(words) else ""
    tidied = words[end - 1] == "tidy" and after in ("the", "this", "up", "your", "my", "our", "it", "them", "these")
    edge = words[end - 1] == "very" and after in ("front", "back", "left", "right")  # "the very front of the table"
    return bool(after) and after not in _BREAKS | _DEGREES and not (tidied or edge)


def _left_open(tokens: list[Token], at: int) -> list[Token]:
    """A token; a comma for the "but" of "(next to it) but it does not matter on which side"."""
    told = [t.word for t in tokens[at + 1 : at + 5]]
    if tokens[at].word not in ("but", "and") or told != ["it", "does", "not", "matter"]:
        return [tokens[at]]
    return [tokens[at].saying(",")] if at and tokens[at - 1].word != "," else []


def _set_off(words: list[str], at: int, end: int) -> bool:
    before = at == 0 or words[at - 1] in _PAUSES or words[at] in ("in", "regardless", "with", "using", "of")
    before = before and not (at and words[at - 1] in ("rest", "others"))
    lines, others = _LINED & {*words[at:end]}, _LINED & {*words[:at], *words[end:]}
    if lines and others and not lines & others:  # "the order of the rows" of a grid of which the columns are told
        return False
    return before and (end == len(words) or words[end] in _BREAKS)


_LINED = frozenset({"rows", "columns", "layers"})


def _same_view(words: list[str], at: int, end: int) -> bool:
    """ "when I look at it" in front of no "from behind"; "from top to bottom" is of no place to look from."""
    after = words[end : end + 6]
    if not after or after[0] in ("behind", "from"):
        return not after or not {"to", "down", "up"}.isdisjoint(after)
    opened = at == 0 or words[at - 1] in _BREAKS
    return after[0] in _GOING_ON | _DOWNWARDS or (opened and words[at] not in ("when", "if"))


_FIXED = frozenset({"row", "line", "column", "word", "beside", "next", "near", "close", "cm", "spell", "facing"})
_ALL_OVER = ("all through", "throughout", "all over", "through and through", "all the way through")
"""What carries nothing behind a colour that was set off: of it all."""


def _anyplace(words: list[str], at: int, end: int) -> bool:
    """ "a row of three red blocks anywhere": behind what is built or put there, at the end of what is said of it."""
    behind = at > 0 and (words[at - 1] in lexicon.STRUCTURE or words[at - 1] in lexicon.BLOCK)
    after = words[end] if end < len(words) else "."
    return _set_off(words, at, end) or (behind and after in _STOPS and _OTHERS.isdisjoint(words[:at]))


_ANY_CASE = ("in any case", "in either case", "in both cases", "in all cases", "either way")
_IF = frozenset({"if", "unless", "when", "whenever", "otherwise", "else", "provided"})


def _in_any_case(words: list[str], at: int, end: int) -> bool:
    """ "(green on red or on blue,) but in any case yellow on the table": not where a condition would go on for it."""
    before = words[at - 1] if at else ""
    goes_on = before in ("and", "but") or (before in (".", "!", ";") and "or" in words[:at])
    return goes_on and end < len(words) and _IF.isdisjoint(words)


_SINGLE = ("block", "cube", "tower", "stack", "row")
_OTHERS = frozenset({"other", "others", "rest", "remaining", "not", "no", "never", "without"})


def _all_over(words: list[str], at: int, end: int) -> bool:
    """ "a wall, brown all through"; but "stays on the red throughout" says when."""
    apart = at > 1 and words[at - 1] in lexicon.COLOR and words[at - 2] in (",", ":", "all", "one", *_SINGLE)
    return apart and (end == len(words) or words[end] in _BREAKS)


_DOWNWARDS = frozenset({"downwards", "upwards", "downward", "upward"})
_ALTOGETHER = ("entirely", "wholly", "completely", "fully", "purely")
"""What carries nothing in front of a colour."""
_BUILT = ("finished", "completed", "resulting", "finalized", "low")
"""What carries nothing in front of what is built."""
_AT_ONCE = ("at the same time", "in the same time", "at same time", "in same time", "simultaneously")
"""What carries nothing where nothing is denied: all that is asked for holds in the end."""
_DO_THIS = tuple(
    f"{who} {want} you to do {this} :" for who in ("i", "we") for want in ("want", "need", "would like", "ask")
    for this in ("this", "the following"))  # fmt: skip
"""What carries nothing in front of a command."""
_AT_ALL = ("at all", "whatsoever", "though")
_FILLERS = ("like", "sort of", "kind of", "i think", "i believe")
_COUNTING = frozenset({"with", "of", "and", "then", "have", "make", "use", "be", "is", "are"})
_DENYING = frozenset({"no", "not", "none", "nothing", "never", "without", "neither", "nor", "nobody"})
_GOING_ON = _BREAKS | {
    "", "and", "but", "between", "on", "in", "or", "that", "which", "touching", "left", "is", "are", "may", "must",
    "should",
}  # fmt: skip


def _the_only(words: list[str], at: int, end: int) -> bool:
    """ "the only yellow block": there is one, as "the" says."""
    named = words[end : end + 2]
    one = len(named) == 2 and named[0] in lexicon.COLOR and lexicon.BLOCK.get(named[1], named[1] != "one") is False
    return one and at > 0 and words[at - 1] == "the"


def _filling(words: list[str], at: int, end: int) -> bool:
    """ "it should be, like, behind the red one", "with like three of them"."""
    before, after = words[at - 1] if at else ",", words[end] if end < len(words) else ","
    if words[at] == "i" and end == len(words):
        return True
    return before == "," == after or (before in _COUNTING and after in lexicon.NUMBER)


def _denying(words: list[str], at: int, end: int) -> bool:
    """ "no gaps at all": what only underlines a denial."""
    after = words[end] if end < len(words) else ""
    return after in _GOING_ON and not _DENYING.isdisjoint(words[max(0, at - 8) : at])


def _closed(tokens: list[Token], out: list[Token], end: int, whole: bool) -> int:
    """Where to go on after an aside that ends at `end`; its commas (one of two unless `whole`), and what was begun
    twice, are gone from `out`."""
    opened = not out or out[-1].word in _BREAKS
    last = end == len(tokens) or tokens[end].word in _BREAKS - {","}
    if out and out[-1].word == "," and (last or (whole and tokens[end].word == ",")):
        out.pop()
    if end < len(tokens) and tokens[end].word == "," and opened:
        end += 1
        if out and out[-1].word == ",":
            out[-1] = replace(out[-1], value=SOFT)
    if not out and end < len(tokens) and tokens[end].word in ("but", "though", "however"):
        end += 1
    for size in (3, 2, 1):
        said = [t.word for t in out[-size:]]
        if len(said) == size and said[0] in _BEGUN and said == [t.word for t in tokens[end : end + size]]:
            del out[-size:]
            break
    return end


def _of_so_many(words: list[str], first: int, last: int) -> bool:
    """ "A tower of three on the patch, any cubes": at the end, where it was said how many there are."""
    ends = last == len(words) or words[last] in _STOPS
    counted = any(not word or lexicon.NUMBER.get(word, 0) > 1 for word in words[:first])  # digits are no words
    return ends and first > 0 and words[first - 1] == "," and counted


_Fits = Callable[[list[str], int, int], bool]
_FITTING: tuple[tuple[tuple[str, ...], _Fits], ...] = (
    (_ANYWHERE, lambda words, first, last: True),
    (_ADDRESSED_AS, lambda words, first, last: words[last : last + 1] == [] or words[last] not in _WANTS),
    (TITLES, _set_off),
    (_EMPHASIS, lambda words, first, last: _emphatic(words, last)),
    (FREE, _set_off),
    (ANY_OF_THEM, _of_so_many),
    (FOREIGN, lambda words, first, last: True),
    (LOOSE, lambda words, first, last: _FIXED.isdisjoint(words) and _set_off(words, first, last)),
    (ANYPLACE, _anyplace),
    (_ANY_CASE, _in_any_case),
    (_ALL_OVER, _all_over),
    (_AT_ONCE, lambda words, first, last: _DENYING.isdisjoint(words) and words[last : last + 1] != ["as"]),
    (_DO_THIS, lambda words, first, last: last < len(words) and words[last] in lexicon.COMMANDS),
    (_ALTOGETHER, lambda words, first, last: last < len(words) and words[last] in lexicon.COLOR),
    (_BUILT, lambda words, first, last: last < len(words) and words[last] in lexicon.STRUCTURE),
    (("only", "single", "sole"), _the_only),
    (_FILLERS, _filling),
    (_AT_ALL, _denying),
    (_CHOSEN, _chosen),
    (_TAGS, _tag),
    (("today", "tonight"), _some_day),
    (("right",), lambda words, first, last: _tag(words, first, last) and words[last : last + 1] == ["?"]),
)
"""Asides, and where they are ones."""
_ASIDES: dict[str, dict[str, list[tuple[list[str], _Fits]]]] = {}
"""The asides by their first and second word, the latter empty where there is none."""
for _said, _fits in ((_x.split(), _fits) for _phrases, _fits in _FITTING for _x in _phrases):
    _ASIDES.setdefault(_said[0], {}).setdefault("".join(_said[1:2]), []).append((_said, _fits))
