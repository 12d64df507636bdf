"""Who acts, looks on and wishes: "participants should see a row", "have the interns stack two cubes".

Nothing hangs on who it is. So the robot, or the user where something is seen or wished for, stands in the place of any
person, and of a noun that means nothing here, in front of what a block does not do by itself.
"""

from __future__ import annotations

from collections.abc import Collection
from dataclasses import replace

from rpg.language import lexicon
from rpg.language.harmless import FINE, NAMES, OCCASIONS, PEOPLE, PERSONAL, THINGS
from rpg.language.not_here import HINTS
from rpg.language.tokens import Token
from rpg.language.word_lists import listed


def _forms(verbs: Collection[str]) -> frozenset[str]:
    return frozenset(form for verb in verbs for form in (verb, lexicon.plural_of(verb)))


_DOING = _forms(listed(
    "put place stack pile heap build rebuild create construct assemble arrange rearrange order organize organise sort "
    "spell write set position lay move transfer relocate deliver produce design craft fashion classify"
))  # fmt: skip
"""What nothing does to a thing but somebody."""
_DOING_ALSO = _forms(lexicon.COMMANDS - listed("touch bump knock jostle ignore use get find")) - _DOING
"""What people do as well, and blocks may do by themselves: "they should form a row"."""
_LOOKING = _forms(listed("see observe view find"))
_READING = _forms(listed("read"))
_WISHING = listed("wants want expects expect like")
_DONE = _DOING | _DOING_ALSO | _LOOKING | _READING | _WISHING
_BINDING = listed("must should shall will would can could may might ought 'll 'd")
_BINDING_TO = listed("has have is are need needs wants want likes like")
"""With a "to" behind them."""
_SEVERAL, _ONE = listed("are have need want like"), listed("is has needs wants likes")
_LINKS = _BINDING | _BINDING_TO | listed(
    "to be able asked told supposed expected required meant instructed invited allowed now then first always also just "
    "please simply finally next going together only not never"
)  # fmt: skip
"""What may stand between who it is and what is done."""
_LETTING = listed("have let make get ask tell want wants need needs like expect allow invite instruct require for")
_AHEAD = listed(". ! ? ; : , ( - and but so then that please now first finally afterwards today later next")
"""What may stand in front of who it is."""
_DETS = listed("the a an my our your his her their this these those some")
_EACH = listed("every each all any")
_KNOWN = listed("robot arm gripper machine agent user viewer camera")
"""These are read everywhere."""
_PERSONS = PEOPLE | listed("worker workers human humans helper helpers subject subjects loader loaders")
_LIKE = FINE | PERSONAL | NAMES | OCCASIONS | THINGS | listed("little young younger older old new other whole 's")
_OBJECTS = _DETS | _EACH | lexicon.NUMBER.keys() | lexicon.COLOR.keys() | lexicon.SIZE.keys() | lexicon.BLOCK.keys() | {
    "them", "it", "both", "everything", "exactly", "together", "up"}  # fmt: skip
_OUT_OF = listed("of from with out using")


def as_robot(tokens: list[Token], known: Collection[str]) -> list[Token]:
    """The tokens with the robot or the user for whoever acts or looks on. `known`: the words that mean something."""
    words = [token.word for token in tokens]
    out: list[Token] = []
    done = 0
    for at in (n for n, word in enumerate(words) if word in _DONE):
        begin, end, said = _who(tokens, words, at, known)
        if said and begin >= done:
            out += [*tokens[done:begin], *(replace(tokens[end - 1], word=word, raw=word) for word in said)]
            done = end
    return [*out, *tokens[done:]] if done else tokens


def _who(tokens: list[Token], words: list[str], at: int, known: Collection[str]) -> tuple[int, int, tuple[str, ...]]:
    """Where those stand who do what is told there, and what to say for them; nothing where it is nobody."""
    end = at
    while end and words[end - 1] in _LINKS:
        end -= 1
    begin = end
    while begin and end - begin < _LONGEST and _named(tokens[begin - 1], known, head=begin == end):
        begin -= 1
    person = begin < end and words[end - 1] in _PERSONS
    if begin == end or words[end - 1] in _KNOWN or not _done_by(tokens, words, at, person):
        return at, at, ()
    determined = begin > 0 and words[begin - 1] in (_DETS | _EACH)
    each = determined and words[begin - 1] in _EACH
    begin -= determined
    links = words[end:at]
    let = begin > 0 and words[begin - 1] in _LETTING
    bound = not _BINDING.isdisjoint(links) or ("to" in links and not _BINDING_TO.isdisjoint(links))
    wished = words[at] in _WISHING and (words[at] != "like" or bool(links))
    several = words[end - 1] not in ("boss", "class") and (words[end - 1].endswith("s") or words[end - 1] in _MANY)
    agreeing = (determined or (person and several)) and not links and words[at].endswith("s") is not several
    if not (let or begin == 0 or words[begin - 1] in _AHEAD) or not (let or bound or wished or agreeing):
        return at, at, ()
    if (each and words[at + 1] not in ("the", "all")) or not (determined or several or tokens[begin].raw[0].isupper()):
        return at, at, ()
    if several and not let:
        return begin, end, ("we",)
    return begin, end, ("the", "user" if words[at] in _LOOKING | _READING | _WISHING else "robot")


_LONGEST = 4
_MANY = listed("people children men women folk staff public audience team crew")


def _named(token: Token, known: Collection[str], *, head: bool) -> bool:
    """Whether a word may be of those who act: a person, or one that means nothing here."""
    shouted = token.raw.isupper() and len(token.raw) > 1
    strange = token.word not in known and token.word not in HINTS and len(token.word) > 2
    plain = token.kind == "word" and not shouted and (strange or token.word in _PERSONS)
    return plain or (not head and token.word in _LIKE)


def _done_by(tokens: list[Token], words: list[str], at: int, person: bool) -> bool:
    """Whether what is told there is what only somebody does."""
    if at + 1 == len(words):
        return False
    behind = tokens[at + 1]
    named = words[at + 1] in _OBJECTS or behind.kind in ("literal", "quote", "number")
    shown = behind.raw.isupper() and len(behind.raw) > 1
    if words[at] in _READING or words[at] == "spell":
        return person and (shown or words[at + 1] in ("the", "a"))
    if words[at] in _DOING_ALSO:
        formed = words[at] in _FORMED and _OUT_OF.isdisjoint(words[at + 1 : at + 7])
        return person and named and not formed
    return named or shown


_FORMED = _forms(listed("form make"))
