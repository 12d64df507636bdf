"""What people say who tell of a picture: "like in my photo", "its a tower", "nothing else is there", "use any blocks",
"between them there is a gap as wide as a block".

It says that what is asked for looks as the text tells, and that no more is wanted than that, or tells it in other
words.
"""

from __future__ import annotations

import re

from rpg.language import lexicon
from rpg.language.tokens import Token

_PICTURE = "(?:picture|pic|photo|drawing|image|sketch|screenshot|painting)"
_OWN = f"(?:the|my|this|that|our|your|her|his) {_PICTURE}"
_SEEN = "(?: (?:here|below|above|i see|i saw|i drew|i have|i sent(?: you)?|you see))?"
_SUCH = (
    f"(?:just |exactly )?like (?:(?:in |on |the one (?:in |on )?|it is (?:in|on) |what is (?:in|on) )?{_OWN}{_SEEN}"
    "|(?:the one|what|the thing) (?:i|we|you) (?:can )?(?:see|saw|drew|have here)(?: here| there)?)"
)
_MAKE = (
    "(?:(?:can|could|will|would) you )?(?:please )?(?:make|build|do|put|lay|set|arrange) "
    "(?:it|this|that|them|the blocks)"
)
_END = "[.!?:;,]"
_ANY = (
    "(?:(?:use|take|with) )?(?:whatever|any|whichever) (?:blocks|cubes|bricks|ones)"
    "(?: (?:you (?:like|want|have|please|can find)|are there|there are))?"
)
_NO_MORE = "(?:and )?(?:there is )?nothing else(?: (?:is|stands|lies))?(?: (?:there|around|in it|to see|visible))"
_SYMBOLS = r"\w(?: ,? ?\w)+"
_COLOR = f"(?:{'|'.join(lexicon.COLOR)})"
_LEFT_OUT = (
    rf"(?P<out>(?:^|(?<=[.!?] )){_MAKE} {_SUCH}(?: (?:ok|okay|please))?(?: {_END})+ )(?=\S)",
    rf"(?P<out> (?:, )?{_SUCH})(?= {_END}|$)",
    rf"(?P<out>(?:^|(?<=[.!?;] )){_ANY} [.!?;] )|(?P<last> [.!?;] {_ANY})(?: [.!])?$",
    rf"(?:\b(?:then|and)|,) {_COLOR}(?P<out> again)(?= [,.]| and|$)",
)
_AT_THE_END = rf"(?P<out> [.!?;,] {_NO_MORE})(?: [.!])?$"
"""Where there are patches, "there" may be on one of them."""
_BLOCK = "(?:block|cube|brick)"
_OF_WHAT = f"(?:the |all |each |any )?(?:two )?(?:neighbors|neighboring {_BLOCK}s|{_BLOCK}s|them)"
_WIDE = f"(?:as (?:wide|big|large) as|of)(?: exactly)? (?:one|a) {_BLOCK}"
_IS = "(?:is|are|must be|should be)"
_SO = "(?:[,.;] )?(?:(?:and|with) )*"
_GAP = "with a gap of one block between {of}"
_IN_OTHER_WORDS: tuple[tuple[str, str], ...] = (
    (rf"{_SO}between (?P<of>{_OF_WHAT})(?: there)?(?: {_IS})?(?: always)?(?: an?| one)? gaps? {_WIDE}", _GAP),
    (rf"{_SO}(?:the |each |every )?gaps? between (?P<of>{_OF_WHAT}) {_IS} {_WIDE}", _GAP),
    (rf"(?:(?:a|one) )?gaps? between (?P<of>{_OF_WHAT})(?: (?:that|which) (?:is|are))? as wide as (?:one|a) {_BLOCK}",
     _GAP.removeprefix("with ")),
    (r"^my (?:little |young |own )?(?:girl|boy|daughter|son|kid|child|one) (?:made|built|drew|laid) "
     r"(?:this|the following) (?:pattern|picture)(?: on the table)? [,:]", ""),
    (r"[,.;](?: and| but)?(?: i think)? (?:you|one|we) can read it(?: normal\w*| as usual)? from left to right",
     ", from left to right"),
    (r"(?P<of>at least \w+ of the \w+ [^.;]*?) [,.;] (?:and |but )?i do not (?:really )?care about "
     r"(?:the (?:last|third|fourth|fifth|other|others|rest|remaining)(?: ones?| two)?)(?= [.!]|$)", "{of}"),
    (rf"^(?P<of>{_SYMBOLS}) are (?P<far>in the (?:back|far) row) and (?P<more>{_SYMBOLS})(?: are)? "
     r"(?P<near>in the (?:front|near) row)", "{of} {far} and {more} {near}"),
    (rf"all (?:of them |of )?(?:the |in the |of the )?same colou?r(?: ,| :)? (?P<of>{_COLOR})(?= [.,;]|$)", "all {of}"),
    ("(?<= )be able to (?=read|see)", ""),
    (r"(?<![^ ])(?P<of>is|are|do|does|should|must)'nt", "{of} not"),
    (r"(?<![^ ])(?P<of>is|are|do|does|should|must)nt(?![^ ])", "{of} not"),
    (r"(?:(?<=^)|(?<=[.,!?;:] )|(?<=\band )|(?<=\bbut )|(?<=\bthink )|(?<=\bso ))its(?= (?:an?|the|on|in|not|just|all|"
     r"next to|behind|made|called|one (?!end|side|arm|half|tip|corner)\w+) )", "it is"),
)  # fmt: skip


def without_pictures(tokens: list[Token]) -> tuple[list[Token], list[str]]:
    """The tokens in plain words, and a note of what was left out."""
    for way, words in _OTHERWISE:
        tokens = _in_other_words(tokens, way, words)
    text = _text(tokens)
    ways = _OUT if lexicon.PATCH.keys() & set(text.split()) else (*_OUT, re.compile(_AT_THE_END))
    left_out: set[int] = set()
    for found in (found for way in ways for found in way.finditer(text)):
        part = next(name for name, said in found.groupdict().items() if said)
        left_out.update(_spot(text, found, part))
    said = " ".join(tokens[n].raw for n in sorted(left_out)).strip(" .,:;!?")
    if not said or len(left_out) == len(tokens):
        return tokens, []
    return [token for n, token in enumerate(tokens) if n not in left_out], [f"left out: {said}"]


def _text(tokens: list[Token]) -> str:
    return " ".join(token.word.replace(" ", "_") for token in tokens)


def _spot(text: str, found: re.Match[str], part: str | int = 0) -> range:
    """The numbers of the words that are found."""
    first = text[: found.start(part)].count(" ") + text[found.start(part) :].startswith(" ")
    return range(first, first + len(found[part].split()))


def _in_other_words(tokens: list[Token], way: re.Pattern[str], words: str) -> list[Token]:
    """The tokens with other words in the place of all that is found."""
    text = _text(tokens)
    for found in reversed([*way.finditer(text)]):
        spot = _spot(text, found)
        said = words.format(**found.groupdict()).split()
        tokens = [*tokens[: spot.start], *(tokens[spot.start].saying(word) for word in said), *tokens[spot.stop :]]
    return tokens


_OUT = tuple(map(re.compile, _LEFT_OUT))
_OTHERWISE = tuple((re.compile(way), words) for way, words in _IN_OTHER_WORDS)
