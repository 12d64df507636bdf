"""Reasons, aims and results of what people have to do with a task, and what they do meanwhile: "because my back hurts",
"to calibrate the camera", "so that nothing falls down", "while I make tea", "or I will be sad".

A reason asks for nothing; but an aim and a result may, where something would follow for the blocks.
"""

from __future__ import annotations

from collections.abc import Sequence

from rpg.language import harmless, lexicon
from rpg.language.of_people import of_people
from rpg.language.smalltalk import LOOKS_OF_PEOPLE, THING, asks, harmless_word, is_strange, small_talk
from rpg.language.telling import may_tell
from rpg.language.tokens import Token
from rpg.language.word_lists import listed

_REASONS = listed("because since cause cos coz")
_HELD = listed("must should shall ought needs need unless if only without not no never nobody")
_WANTED = listed("want wants need needs")
_OWN_WAY = listed(
    "stands standing sits sitting lies lying looks looking stays where so nicely well prettily there otherwise"
)  # fmt: skip
"""How something is where it is anyway."""
_AIMS = (("to",), ("in", "order", "to"), ("so", "as", "to"), ("just", "to"))
_SOCIAL = listed(
    "please impress cheer surprise amuse entertain help teach celebrate test practise practice pass win save keep make "
    "thank comfort welcome honor congratulate tease annoy delight inspire calm show demonstrate convince persuade "
    "prove"
)
_RESULTS = (("so", "that"), ("so",), ("such", "that"), ("in", "order", "that"))
_WHAT_STANDS = listed("it they nothing none everything this that all of them the whole thing")
_HOLDS = listed(
    "fall falls falling fell tip tips topple topples wobble wobbles collapse collapses crash crashes break breaks "
    "tumble tumbles slip slips drop drops over down off apart stable steady safe secure safely does do not can could "
    "will would is are be stays stay remain remains to get gets in my our your their its his her way bother bothers "
    "disturb disturbs anybody anyone us me each other one another look looks nice pretty lovely good beautiful neat "
    "tidy happens happen anything bad goes go wrong gets lost damaged hurt scratched stands stand well the floor and "
    "nicely better"
)


_HARMED = listed(
    "fall falls falling fell tip tips topple topples wobble wobbles collapse collapses crash crashes break breaks "
    "tumble tumbles slip slips drop drops bother bothers disturb disturbs way bad wrong lost damaged hurt scratched "
    "happens"
)
"""What nobody wants to come of it."""


def length_of_lead(words: Sequence[str], leads: Sequence[tuple[str, ...]]) -> int:
    """How many words the longest of some leads has that they begin with."""
    return max((len(lead) for lead in leads if tuple(words[: len(lead)]) == lead), default=0)


def reason_or_aim(tokens: Sequence[Token]) -> bool:
    """ "Because it looks so pretty", "to make my daughter smile", "so that nothing falls down"."""
    words = [token.word for token in tokens]
    if words[0] == "to" and words[1:2] in (["read"], ["spell"], ["say"], ["write"], ["form"], ["build"]):
        return False  # that is what it is to be
    if words[0] in _REASONS and len(words) > 2:
        return _told_why(tokens[1:])
    if words[0] == "for" and words[1:2] in (["i"], ["we"]) and small_talk(tokens[1:]):
        return True
    if words[0] in ("as", "for", "so") and words[1:2] != ["you"] and of_people(tokens[1:], denied=True):
        return True
    if words[0] == "as" and words[-1] in _WISHED and len(words) > 2 and all(word in _BY_WHOM for word in words[1:-1]):
        return True
    if (lead := length_of_lead(words, _AIMS)) and _done_to_ours(tokens[lead:]):
        return True
    if words[0] == "to" and len(words) > 2 and THING.isdisjoint(words) and small_talk(tokens):
        return True
    if (lead := length_of_lead(words, _AIMS)) and words[lead : lead + 1] and words[lead] in _SOCIAL:
        behind = tokens[lead + 1 :]
        social = any(t.word in harmless.PEOPLE | harmless.OCCASIONS | {"me", "us", "you"} for t in behind)
        made = words[lead] in ("make", "keep", "show")
        return social and all(
            harmless_word(behind, n)
            or (is_strange(t.word) and not made)
            or (n > 1 and not made and not may_tell(t.word))
            for n, t in enumerate(behind)
        )
    if (lead := length_of_lead(words, _RESULTS)) and len(words) > lead + 1:
        behind_words = words[lead:]
        hidden = "not" in words and not THING.isdisjoint(words)  # "so that I can not see it"
        if (not hidden and _of_what_people_can(tokens[lead:])) or (
            words[lead] != "you" and of_people(tokens[lead:], denied=True)
        ):
            return True
        held = behind_words[0] in _WHAT_STANDS and all(w in _HOLDS | _WHAT_STANDS for w in behind_words)
        denied = behind_words[0] in ("nothing", "none") or "not" in behind_words
        denied = denied and not _HARMED.isdisjoint(behind_words)
        return held and (denied or not {"nice", "pretty", "lovely", "good", "beautiful", "stable", "steady", "safe",
                                        "secure", "safely"}.isdisjoint(behind_words))  # fmt: skip
    return False


_WISHED = listed(
    "ordered wished asked wanted said told requested expects expected promised demanded instructed suggested"
)
_BY_WHOM = (
    harmless.PEOPLE | harmless.NAMES | LOOKS_OF_PEOPLE | listed("the my our his her your i we he she has have us me")
)


def _done_to_ours(tokens: Sequence[Token]) -> bool:
    """ "(To) calibrate the camera", "(to) cheer up my sick friend": what is done to something that no task has."""
    words = [token.word for token in tokens]
    det = next((n for n, word in enumerate(words[1:4], 1) if word in _OF_SOME), 0)
    if not det or len(words) == det + 1:
        return False
    if words[0] in _BEGUN_AND_ENDED and all(word in harmless.OCCASIONS for word in words[det + 1 :]):
        return True
    if words[0] in _TRIED_OUT and all(word in _TOOLS or word in LOOKS_OF_PEOPLE for word in words[det + 1 :]):
        return True
    verb = words[0] not in lexicon.VERB and not words[0].startswith(_LIKENESS)
    if not (verb and THING.isdisjoint(words)) or asks(words[1:]):
        return False
    ours = (
        harmless.PEOPLE | harmless.OCCASIONS | harmless.THINGS | harmless.ANIMALS | listed("camera cameras arm robot")
    )
    known = all(
        word in ours | _OF_SOME | listed("up out for at in with and")
        or harmless_word(tokens, n) or is_strange(word) or word in harmless.EVERYDAY
        for n, word in enumerate(words)
    )  # fmt: skip
    return known and (not ours.isdisjoint(words[det + 1 :]) or (words[0] in _SOCIAL and is_strange(words[-1])))


_BEGUN_AND_ENDED = listed("finish end open close begin start win pass save celebrate mark conclude complete continue")
_TRIED_OUT = listed("warm test check train try exercise practice practise calibrate improve prove show demonstrate use")
_TOOLS = listed(
    "gripper arm arms hand hands fingers skill skills camera cameras precision patience robot software system "
    "controller sensors sensor abilities ability talent talents brain eyes vision motors motor engine engines joints "
    "muscles circuits"
)  # fmt: skip
_OF_SOME = listed("the my our his her their your")
_LIKENESS = ("match", "resembl", "mimic", "imitat", "copy", "mirror", "reflect", "represent", "depict", "replicat",
             "reproduc", "follow", "obey", "fit", "hide", "cover", "block", "obstruct", "protect", "surround",
             "support")  # fmt: skip
"""How words begin of which something would follow for the blocks."""


def meanwhile(tokens: Sequence[Token]) -> bool:
    """ "While I make a cup of tea", "until my wife is home", "during the coffee break"."""
    words = [token.word for token in tokens]
    if words[0] in ("while", "whilst", "until", "till", "before") and len(words) > 2:
        return words[1] != "you" and of_people(tokens[1:], anything=True)
    known = harmless.OCCASIONS | harmless.PEOPLE | harmless.FINE | listed("the our my your a this 's little whole next")
    return words[0] == "during" and words[-1] in harmless.OCCASIONS and all(word in known for word in words[1:])


def rewards(tokens: Sequence[Token]) -> bool:
    """ "If it works I owe you a beer", "or I will be sad"."""
    words = [token.word for token in tokens]
    if words[0] in ("or", "otherwise"):
        at = 2 if words[1:2] == ["else"] else 1
        return not {"will", "'ll"}.isdisjoint(words[at : at + 4]) and of_people(tokens[at:])
    lead = length_of_lead(words, _IF_DONE)
    return bool(lead) and words[lead : lead + 1] in (["i"], ["we"], ["my"], ["everybody"]) and of_people(tokens[lead:])


_IF_DONE = tuple(
    (*when, *done, *mark)
    for when in (("if",), ("when",), ("once",), ("as", "soon", "as"))
    for done in (("it", "works"), ("this", "works"), ("that", "works"), ("you", "manage"), ("you", "do", "it"),
                 ("you", "succeed"), ("you", "can", "do", "it"), ("you", "make", "it"),
                 ("you", "win"), ("it", "is", "done"),
                 ("you", "manage", "that"), ("you", "manage", "it"), ("you", "are", "done"), ("you", "do", "well"),
                 ("you", "do", "this"), ("you", "do", "that"))
    for mark in ((), (",",), ("then",), (",", "then"))
)  # fmt: skip


def _of_what_people_can(tokens: Sequence[Token]) -> bool:
    """ "(So that) the visitors can take photos of it", "(because) I can't do it myself"."""
    words = " ".join(token.word for token in tokens).replace("can not ", "can ").split()
    could = next((n for n, word in enumerate(words[:6]) if word in _COULD), 0)
    whose = {*words[:could]} & (harmless.PEOPLE | listed("i we he she you everybody everyone"))
    plain = (
        _LEGIBLE.isdisjoint(words) and could > 0 and bool(whose) and could + 1 < len(words) and _HELD.isdisjoint(words)
    )
    known = all(
        t.kind == "word" and (t.word == "not" or harmless_word(tokens, n) or not may_tell(t.word))
        for n, t in enumerate(tokens)
    )
    return plain and known and not any(len(t.raw) > 1 and t.raw.isupper() for t in tokens)


_LEGIBLE = listed("read reads reading legible readable")
"""Letters have to be turned for that."""
_COULD = listed("can could may might will would have has is are am was were 'll 'd 're 's 'm")


def _told_why(tokens: Sequence[Token]) -> bool:
    """Whether a reason is one that no block has a part in but by being what it is."""
    words = [token.word for token in tokens]
    if small_talk(tokens) or _of_what_people_can(tokens) or of_people(tokens, denied=True):
        return True
    if words[-1] in ("it", "this", "that") and words[-2] in _WANTED and small_talk(tokens[:-1]):
        return True
    plain = _HELD.isdisjoint(words) and not asks(words)
    return plain and all(
        word in _OWN_WAY or harmless_word(tokens, n) or word in harmless.EVERYDAY or is_strange(word)
        for n, word in enumerate(words)
    )
