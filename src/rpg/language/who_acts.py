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
from rpg.language.telling import may_tell
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
_ASKING = {
    **dict.fromkeys(("insists", "insist", "insisted", "decided", "settled", "agreed"), "on"),
    **dict.fromkeys(("asks", "ask", "asked", "hopes", "hope", "longs", "long", "calls", "wishes", "wish"), "for"),
    **dict.fromkeys(("requests", "requested", "proposes", "propose", "proposed", "demands", "demanded", "ordered",
                     "prefers", "suggests", "suggest", "suggested", "chose", "desires", "accepts", "accept"), ""),
}  # fmt: skip
"""What comes to wanting it, with the word behind it."""
_PAST = frozenset(
    form
    for form, senses in lexicon.VERB.items()
    if any(tense == "past" and sense in ("place", "stack", "build", "arrange") for sense, _, tense in senses)
) | {"put", "set"}
_NOW = _DOING | _DOING_ALSO | _LOOKING | _READING | _WISHING | _ASKING.keys() | {"shown"}
_DONE = _NOW | _PAST
_BINDING = listed("must should shall will would can could may might ought 'll 'd")
_BINDING_TO = listed("has have is are need needs wants want likes like")
"""With a "to" behind them."""
_LINKS = _BINDING | _BINDING_TO | listed(
    "to be able asked told supposed expected required meant instructed invited allowed now then first always also just "
    "please simply finally next going together only not never"
)  # fmt: skip
"""What may stand between who it is and what is done."""
_SO_FAR = listed("has have already just now")
_MERELY = listed("has have would 'd will also really just already only")
_WHEN = listed("then now first finally next")
_LETTING = listed("have let make get ask tell want wants need needs like expect allow invite instruct require for")
_AHEAD = listed(". ! ? ; : , ( - and but so then that please now first finally afterwards today later next")
"""What may stand in front of who it is."""
_DETS = listed("the a an my our your his her their this these those some")
_EACH = listed("every each all any")
_KNOWN = listed("robot arm gripper machine agent user viewer camera")
"""These are read everywhere."""
_ANYBODY = listed("somebody someone anybody anyone")
_PERSONS = PEOPLE | _ANYBODY | listed(
    "worker workers human humans helper helpers subject subjects loader loaders member members observer observers"
)  # fmt: skip
_BEHIND = listed("of at to from in on with by standing sitting seated working")
"""What tells more of them stands behind these."""
_THERE = listed("table desk front")
_LIKE = FINE | PERSONAL | NAMES | OCCASIONS | THINGS | listed("little young younger older old new other whole shift 's")
_OBJECTS = _DETS | _EACH | lexicon.NUMBER.keys() | lexicon.COLOR.keys() | lexicon.SIZE.keys() | lexicon.BLOCK.keys() | {
    "them", "it", "both", "everything", "exactly", "together", "up", "out"}  # fmt: skip
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
    while end and words[end - 1] in _LINKS | _SO_FAR:
        end -= 1
    begin, head = _subject(tokens, words, end, known)
    person = begin < head and (words[head - 1] in _PERSONS or words[begin] == "one")
    if begin == head or (head == begin + 1 and words[begin] in _KNOWN):
        return at, at, ()
    determined = begin > 0 and words[begin - 1] in (_DETS | _EACH)
    each = determined and words[begin - 1] in _EACH
    begin -= determined
    links = words[end:at]
    let = begin > 0 and words[begin - 1] in _LETTING
    several = words[head - 1] not in ("boss", "class") and (words[head - 1].endswith("s") or words[head - 1] in _MANY)
    named = determined or several or tokens[begin].raw[0].isupper() or words[begin] in _ANYBODY | {"one"}
    if not (let or begin == 0 or words[begin - 1] in _AHEAD) or not named:
        return at, at, ()
    if not let and (told := _asked(words, links, at)):
        return begin, told, ("the", "user", "wants")
    if not _done_by(tokens, words, at, person) or (each and words[at + 1] not in ("the", "all")):
        return at, at, ()
    if words[at] in _PAST and links and _SO_FAR.issuperset(links) and (determined or person) and not let:
        return begin, end, ("someone",) if "has" in links else ("people",)
    when = links if len(links) == 1 and links[0] in _WHEN else []
    agreeing = (determined or (person and several)) and (not links or when) and words[at].endswith("s") is not several
    if words[at] not in _NOW:
        return at, at, ()
    wished = words[at] in _WISHING and (words[at] != "like" or bool(links))
    if not (let or wished or agreeing or _bound(links, words[at])):
        return at, at, ()
    if words[at] == "shown" and "not" not in links and "never" not in links:
        return begin, at + 1, ("we", "see")
    if several and not let:
        return begin, end, ("we",)
    who = "user" if words[at] in _LOOKING | _READING | _WISHING | {"shown"} else "robot"
    return begin, at if when else end, (*when, "the", who)


def _subject(tokens: list[Token], words: list[str], end: int, known: Collection[str]) -> tuple[int, int]:
    """Where those are named who stand in front of there, and the position behind their noun: "the (visitors) to our
    museum", "(player) 1"."""
    head = end
    if end > 1 and _label(tokens[end - 1]) and words[end - 2] in _PERSONS | _KNOWN:
        head = end - 1
    for n in range(end - 1, max(end - _FAR, -1), -1):
        behind = words[n + 1 : end]
        who = words[n] in _PERSONS or (words[n] == "one" and behind[:1] == ["of"] and not _PERSONS.isdisjoint(behind))
        if who and behind and behind[0] in _BEHIND:
            head = n + 1
        if words[n] not in _BEHIND | _THERE | _DETS and (may_tell(words[n]) or not words[n].isalpha()):
            break
    aged = head > 2 and words[head - 1] in ("old", "olds") and words[head - 2] in ("year", "years", "-")
    if aged and (number := next((n for n in range(head - 3, max(head - 6, -1), -1) if tokens[n].many), -1)) >= 0:
        return number, head  # "my 4-year-old"
    begin = head
    while begin and head - begin < _LONGEST and _named(tokens[begin - 1], known, head=begin == head):
        begin -= 1
    return (head - 1, head) if begin == head and words[head - 1 : head] == ["one"] else (begin, head)


def _asked(words: list[str], links: list[str], at: int) -> int:
    """The position of what is asked for, "insists on (a row)"; 0 where nothing is."""
    wanted = _ASKING.get(words[at])
    behind = at + 1 + bool(wanted)
    if wanted is None or (wanted and words[at + 1 : at + 2] != [wanted]) or not _MERELY.issuperset(links):
        return 0
    return behind if words[behind : behind + 1] and words[behind] in _SOME else 0


def _bound(links: list[str], verb: str) -> bool:
    """Whether it has to be so, or will be."""
    shown = verb == "shown" and not {"is", "are", "be"}.isdisjoint(links)
    return shown or not _BINDING.isdisjoint(links) or ("to" in links and not _BINDING_TO.isdisjoint(links))


_SOME = listed("a an") | lexicon.NUMBER.keys()
_FAR = 9
_LONGEST = 4
_MANY = listed("people children men women folk staff public audience team crew")


def _named(token: Token, known: Collection[str], *, head: bool) -> bool:
    """Whether a word may be of those who act: a person, or one that means nothing here."""
    shouted = token.raw.isupper() and len(token.raw) > 1
    strange = token.word not in known and token.word not in HINTS and len(token.word) > 2
    plain = token.kind == "word" and not shouted and (strange or token.word in _PERSONS)
    return plain or (not head and token.word in _LIKE | _KNOWN) or (head and token.word in _KNOWN)


def _label(token: Token) -> bool:
    """ "Player (1)", "team (B)"."""
    return token.kind == "number" or (len(token.raw) == 1 and token.raw.isupper())


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
