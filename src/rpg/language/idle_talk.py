"""Whether what is said between two marks asks for nothing and tells nothing of a task.

It is a set phrase, small talk, a reason, whom it is for, or what is thought of it all. A command is none of these, and
so is a wish for something, a condition, or what would take back what was said.
"""

from __future__ import annotations

from collections.abc import Collection, Sequence

from rpg.language import harmless, lexicon
from rpg.language.about_the_task import of_the_task
from rpg.language.idioms import IDIOMS, TIMELY
from rpg.language.lead_ins import on_behalf, set_in
from rpg.language.reasons import meanwhile, reason_or_aim, rewards
from rpg.language.references import refers_or_grades
from rpg.language.smalltalk import is_strange, small_talk
from rpg.language.spoken_wishes import for_what
from rpg.language.talk_forms import by_form, polite_condition, takes_care
from rpg.language.telling import turns
from rpg.language.tokens import Token
from rpg.language.ways_of_working import way_of_working
from rpg.language.word_lists import listed

_OWN = listed("my our his her their your")
_BECAUSE = listed("because since as cause cos coz so")
_ALONE = harmless.INTERJECTIONS | listed(
    "honestly frankly seriously luckily sadly fortunately unfortunately ideally obviously naturally hopefully "
    "apparently evidently clearly surely really thankfully kindly personally anyway anyhow indeed basically actually "
    "literally today tonight normally usually"
)
_DEGREES = listed(
    "very so really super quite pretty totally extremely incredibly simply just too truly absolutely how and"
)
_NOUNS = harmless.PEOPLE | harmless.ANIMALS | harmless.OCCASIONS | harmless.THINGS | harmless.NAMES
_TOLD = harmless.FINE | harmless.PERSONAL
_LINKING = listed("own a an the 's and of with from little old new s all at in open next today tomorrow")
_TIMES = listed(
    "while minute minutes moment moments hour hours day days week weeks month months year years time times night "
    "second seconds century"
)
"""For so long it would be."""
_SHORT, _MOST = 6, 25
"""So many words at most an exclamation and any other talk have."""


_LATER = (
    ("after", "that"),
    ("afterwards",),
    ("after", "this"),
    ("and", "then"),
    ("and", "afterwards"),
    ("then",),
    ("later",),
)
"""What is said behind these comes when the task is done."""


def idle(tokens: Sequence[Token]) -> bool:
    """Whether these words ask for nothing, wherever they stand between marks."""
    if way_of_working(tokens) or of_the_task(tokens) or refers_or_grades(tokens):
        return True
    words = _plain(tokens)
    if words is None or _which(words) or turns(words):
        return False
    begun = len(words) > 1 and words[0] in _BEGUN and IDIOMS.whole(words[1:])
    return begun or (IDIOMS.whole(words) or _aimed(tokens, _BECAUSE) or small_talk(tokens))


_BEGUN = listed("now so well okay ok right and but")


_GOING_ON = listed("and then afterwards finally so also ,")
_MORE = (
    ("another", "one"), ("another",), ("one", "more"), ("a", "further", "one"), ("a", "second", "one"), ("two", "more"),
    ("a", "third", "one"), ("yet", "another", "one"), ("yet", "another"),
)  # fmt: skip
"""These are more of what was spoken of, and no talk."""
_WHICH = frozenset({*lexicon.SIZE, *lexicon.ORDINAL, "last", "next", "other"})


def _which(words: Sequence[str]) -> bool:
    """ "(the big one)", "it is a small one": which of them it is, or what it looks like."""
    told = words[0] in ("it", "they", "a", "an", "this", "that") and not _WHICH.isdisjoint(words)
    return words[-1] in ("one", "ones") and (words[0] == "the" or told)


def idle_at_an_end(tokens: Sequence[Token]) -> bool:
    """Whether they ask for nothing in front of a task or behind it: all of it, or what an "and" or "but" joins."""
    said = [token.word for token in tokens if token.word not in _GOING_ON]
    if said and (tuple(said) in _MORE or _which(said)):
        return False
    joints = [n for n, token in enumerate(tokens) if token.word in ("and", "but") and 0 < n < len(tokens) - 1]
    later = next((len(lead) for lead in _LATER if tuple(t.word for t in tokens[: len(lead)]) == lead), 0)
    if later and len(tokens) > later + 1 and _whole_at_an_end(tokens[later:]):
        return True
    return _whole_at_an_end(tokens) or any(
        _whole_at_an_end(tokens[:n]) and idle_at_an_end(tokens[n + 1 :]) for n in joints
    )


def _whole_at_an_end(tokens: Sequence[Token]) -> bool:
    if idle(tokens):
        return True
    words = _plain(tokens)
    return (
        words is not None
        and not turns(words)
        and (by_form(tokens) or TIMELY.whole(words) or _thought(words) or _for_somebody(words) or _of_own_things(words))
    )


def reason_at(tokens: Sequence[Token], at: int) -> bool:
    """Whether all that stands from here on is a reason, whom it is for or a time of the day, unparted from a task."""
    words = _plain(tokens[at:])
    if at and tokens[at].word in _LIMITS and refers_or_grades(tokens[at:]):
        return True
    if words is None or at == 0:
        return False
    said = words[0] in ("if", "with", "without", "for", "in", "just", "to", "as") and IDIOMS.whole(words)
    timely = words[0] not in ("when", "once", "by") and TIMELY.whole(words)
    settled = words[0] in ("for", "as", "according", "per", "with", "using") or on_behalf(words)
    wanted = bool(settled) and set_in(words) == len(words)
    careful = words[0] in ("with", "without", "in") and takes_care(words)
    wanted = wanted or for_what(tokens, at)
    formed = reason_or_aim(tokens[at:]) or polite_condition(words) or meanwhile(tokens[at:]) or careful or wanted
    formed = formed or rewards(tokens[at:])
    formed = formed or (words[0] in _MEANS and way_of_working(tokens[at:]))
    return said or timely or formed or _aimed(tokens[at:], _BECAUSE) or _for_somebody(words) or _of_own_things(words)


_MEANS = listed("with using without in by")
_LIMITS = listed("in within with using as per like")
"""What a way of working, and a limit or a reference, begins with that nothing parts from the task."""


def _plain(tokens: Sequence[Token]) -> list[str] | None:
    """The words, if each of them could be harmless; none that ask for a word that can be read."""
    if not 0 < len(tokens) <= _MOST or any(not _could_be(token, n == 0) for n, token in enumerate(tokens)):
        return None
    words = [token.word for token in tokens]
    asked = words[0] == "so" and "read" in words and words[-1] in _WHAT_IS_READ
    return None if asked else words


_WHAT_IS_READ = listed("it them word words that")


def _could_be(token: Token, first: bool) -> bool:
    if token.kind == "punct":
        return token.word in ("'s", ",", "…")
    shouted = token.raw.isupper() and len(token.raw) > 1 and token.word not in harmless.INTERJECTIONS
    letter = len(token.raw) == 1 and token.raw.isupper() and token.word != "i" and not (token.word == "a" and first)
    return token.kind == "word" and not shouted and not letter


def _aimed(tokens: Sequence[Token], leads: Collection[str]) -> bool:
    """ "Because my wife is waiting", "so that the kids can play"."""
    if tokens[0].word not in leads or len(tokens) < 3:
        return False
    at = 1 + (tokens[0].word == "so" and tokens[1].word == "that")
    pointed = tokens[0].word == "so" and tokens[at].word in ("it", "this", "that", "they", "these", "those", "you")
    return not pointed and small_talk(tokens[at:])


def _thought(words: list[str]) -> bool:
    """ "Lovely", "very important", "honestly", "wow"."""
    if all(word in _ALONE or word == "," or harmless.exclaimed(word) for word in words):
        return True
    behind = words[words.index("to") :] if "to" in words else []
    ahead = words[: len(words) - len(behind)]
    to_whom = not behind or (len(behind) > 1 and _for_somebody(["for", *behind[1:]]))
    fine = not harmless.FINE.isdisjoint(words) and all(word in harmless.FINE | _DEGREES for word in ahead)
    return fine and to_whom and len(words) <= _SHORT


def _for_somebody(words: list[str]) -> bool:
    """ "For my daughter's birthday", "for the kids"."""
    said = [word for word in words[1:] if word not in ("please", "thanks", ",")]
    if words[0] in ("just", "only", "all") and words[1:2] == ["for"]:
        return _for_somebody(words[1:])
    if words[0] != "for" or not said or len(said) > _SHORT + 2:
        return False
    if len(said) == 1 and said[0] in ("me", "us", "him", "her", "them", "you"):
        return said[0] in ("me", "us", "her", "him")
    if not _PURPOSES.isdisjoint(said) and all(
        w in _NOUNS | _TOLD | _OWN | _LINKING | _PURPOSES or is_strange(w) for w in said
    ):
        return True
    if _NOUNS & set(said) <= _TIMES or (said[0] not in _OWN and not harmless.THINGS.isdisjoint(said)):
        return False
    whose = not (_OWN | harmless.PEOPLE).isdisjoint(said)
    known = all(word in _NOUNS | _TOLD | _OWN | _LINKING or (whose and is_strange(word)) for word in said)
    return known and (said[-1] in _NOUNS or (whose and is_strange(said[-1])))


_PURPOSES = listed("purpose purposes benefit sake reasons amusement enjoyment entertainment pleasure fun joy use of it")


def _of_own_things(words: list[str]) -> bool:
    """ "So I can drive my toy car in", "I want to put my pen there": what somebody does with a thing of his own, of
    which tasks have none."""
    at = next((n for n, word in enumerate(words) if word not in _LEADING), len(words))
    if at == len(words) or words[at] not in _WHO | _OWN or len(words) > 2 * _SHORT:
        return False
    own = any(word in _OWN and not _HAD.isdisjoint(words[n + 1 : n + 4]) for n, word in enumerate(words))
    return own and all(word in _DONE_WITH_THEM | harmless.DOINGS | _HAD | _OWN | _WHO for word in words[at:])


_HAD = harmless.THINGS | harmless.ANIMALS
_LEADING = listed("so that because since as and for")
_WHO = listed("i we he she")
_DONE_WITH_THEM = listed(
    "can could will would may might shall want wants need needs like to be able then later put puts place park keep "
    "store set fit fits drive ride roll slide pass walk a an the little old new favorite toy there in into through "
    "inside under on it between them is am are going"
)


def of_their_doings(tokens: Sequence[Token]) -> bool:
    """ "They're fighting", "it is a bit lazy", "they do not like each other": what only somebody alive is or does."""
    words = _plain(tokens)
    if words is None or words[0] not in ("they", "it", "these", "those", "both") or len(words) > _SHORT:
        return False
    rest = words[1:]
    alive = [word for word in rest if word in _ALIVE]
    return bool(alive) and all(word in _ALIVE | _DEGREES | _AROUND for word in rest)


_AROUND = listed(
    "is are was were 'm 're 's a an the do does not always never still best good old each other one another"
)
_ALIVE = (
    frozenset(word for word in harmless.DOINGS if word.endswith("ing"))
    | harmless.PERSONAL
    | harmless.ANIMALS
    | harmless.PEOPLE
    | listed("enemies friends quarrel fight like hate love")
) - listed("going making having giving taking getting doing coming showing needing calling well early late ready open")
