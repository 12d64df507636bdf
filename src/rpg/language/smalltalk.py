"""Talk around an instruction: sentences, and parts of them set off by a comma, of words that ask for nothing of blocks.

Who wants it, what for, how it feels. None of these words is a block, a look, a number, a place, or something done to
blocks; a few that could be ("on", "first", "not") are taken for talk only before what makes them so.
"""

from __future__ import annotations

from collections.abc import Sequence
from itertools import pairwise

from rpg.language import harmless
from rpg.language.spelling import vocabulary
from rpg.language.tokens import Token


def _words(text: str) -> frozenset[str]:
    return frozenset(text.split())


_ERRANDS = harmless.OCCASIONS - _words(
    "everything something way ways while time times bit lot lots stuff sort kind present"
) | _words(
    "assembly catalog chance classroom description geometry goal help instruction instructions picture pictures "
    "procedure robotics session stage trick tricks work"
)
_FELT = _words(
    "thanks thank sorry hello hi hey welcome greetings appreciate appreciates careful complicated enjoy enjoys enjoyed "
    "fancy gentle impressive mind precise accurate quick warm thrill love loves hope hopes hurry rush bother trouble"
)
_FEELINGS = _FELT | harmless.FINE | harmless.PERSONAL
_PERSONS = harmless.PEOPLE | _words("computer examiner gentlemen human humans machine mentor robot robots")
_STRONG = _PERSONS | _ERRANDS | _FEELINGS
_GLUE = _words(
    "i we you he she they it this that these me us them him her my our your his their its mine yours "
    "am is are was were be been being do does did have has had having will would can could may might shall should must "
    "a an the of for to with about and but because since so as too also just now then today tonight here again really "
    "very quite much many lot lots bit little big whole more most enough still already soon later once ever yet only "
    "simply actually always often usually sometimes finally anyway well okay ok alright right yes what how why who "
    "whom where when which there some any every all other another new old young younger older good bad real special "
    "want wants wanted need needs needed like likes liked think thinks thinking thought know knows guess believe say "
    "says said tell tells told ask asks asked asking call called mean means matter teach teaches teaching learn learns "
    "learning study studying practise practising practicing preparing prepare prepares film filming shoot shooting "
    "record recording explain explaining present presenting testing try trying tries "
    "playing plays played working works help helping helps happen happens going gone go come comes coming look looks "
    "looking seeing see watch watching sounds seems feel feels "
    "imagine imagining wonder wondering thinking talk talking gives given doing done writing going decided "
    "planning plans use used using visiting visit tested bring brings wait waiting let listen "
    "please kindly 'm 're 'd 'll 've s open sure long hear heard read reading remember forget welcome organizing "
    "organising control controlling name names "
    "operate operating programmed program understand",
)
_SUBJECTS = _words("colors letters numbers digits shapes blocks cubes towers patterns words equations figures order")
_LIKED = _words("about love loves like likes learn learning study studying teach teaching practise practising "
                "practicing practice enjoy enjoys favorite with")  # fmt: skip
"""What letters, colours and the like as such may come after: "we are learning about colours"."""
_PLACED = _words("in on at from by during after before under through")
_TURN = _words("first second third next last final main only same open")
_NEGATED = _words("not no never nothing")
_CALM = _words("sure much long fair far any") | _FEELINGS
_POLITELY = _words("can could may please would do ok okay fine possible alright")
_VAGUE = _words("you we i it that he she they everyone")


_LEADS = _words("and but so please then also now just , well okay ok")
_ADDRESSED = _words(
    "thank hope guess imagine wish love enjoy trust forgive remember think suppose believe excuse wonder listen wait "
    "care worry mind hurry understand apologize apologise like need want appreciate expect pity please know"
)
_MORE_TO_DO = _words("bring write read use open let present watch look control operate start stop sit stand")
_DOABLE = (harmless.VERBS | _MORE_TO_DO) - _ADDRESSED
"""Commands that would be something else to do."""
_YIELDING = {("let", "me"), ("let", "us"), ("do", "you"), ("do", "not"), ("help", "me"), ("help", "us"),
             ("thank", "you"), ("pardon", "me"), ("watch", "out"), ("look", "here"), ("come", "on")}  # fmt: skip
"""Begun so they ask for nothing of their own."""
_HEADINGS = _words("exercise test practice request quiz challenge")
_SPEAKERS = _words("i we he she my our his her")
_HANDLING = _words(
    "make makes making made take takes taking took give gives giving gave given get gets getting got do does doing did "
    "done show shows buy buys sell sells"
)
_DAILY = harmless.THINGS | harmless.ANIMALS | (harmless.DOINGS - _HANDLING)
"""What people have about them, and do, of whom it is told."""
_DOES = harmless.DOINGS | _words("is am are was were will would can could has have had 's 'm 're 'll")
_THING = _words("it this that they them these those everything")
_BINDING = _words("should must shall may might ought was were has have had")
_WANTED = _words("want wants wanted need needs needed like likes wish wishes hope hopes")
_CHANGED = _words("plan plans idea ideas wish goal task tasks instruction instructions")
_OTHER = _words("old new other another bad real better best different more")
_TWICE = _words("again more twice")
_POLITE = _words("thanks thank sorry hello hi welcome once")


def small_talk(tokens: Sequence[Token]) -> bool:
    """Whether these words ask for nothing."""
    words = [token.word for token in tokens]
    offered = words[:1] == ["here"] and words[-2:] == ["for", "you"]  # "here's a scale for you"
    of_people = offered or _of_people(words)
    strong = _STRONG | _DAILY if of_people else _STRONG
    if not words or (strong.isdisjoint(words) and not offered) or _asks(words):
        return False
    return all(
        token.kind in ("word", "punct") and (_talk(token, words, n) or (of_people and _daily(token, words)))
        for n, token in enumerate(tokens)
    )


def _of_people(words: Sequence[str]) -> bool:
    """Whether somebody is told of, "my wife is waiting", and nothing that is pointed at."""
    said = [word for word in words if word not in _LEADS | harmless.ADVERBS | harmless.INTERJECTIONS]
    somebody = said[:1] and (said[0] in _SPEAKERS or not _PERSONS.isdisjoint(said[:2]))
    return bool(somebody) and _THING.isdisjoint(words) and not _DOES.isdisjoint(said[1:])


def _daily(token: Token, words: Sequence[str]) -> bool:
    """Whether a word is of daily life; or means nothing here, and is nothing that is wished for."""
    if token.kind != "word" or (len(token.raw) > 1 and token.raw.isupper()):
        return False
    strange = len(token.word) > 2 and token.word not in vocabulary() and (_WANTED | {"would", "'d"}).isdisjoint(words)
    return token.word in _DAILY or strange


def _asks(words: Sequence[str]) -> bool:
    """Whether they are a further command, tell what the blocks have to be like, or take back what was said."""
    starts = [0, *(n + 1 for n, word in enumerate(words[:-1]) if word in _LEADS)]
    if any(words[n] in _DOABLE and not _yields(words[n : n + 3]) for n in starts):
        return True
    if takes_back(words) or (not _TWICE.isdisjoint(words) and _POLITE.isdisjoint(words)):
        return True
    pairs = list(pairwise(words))
    told = any(word in _THING and behind in _BINDING for word, behind in pairs)
    return told or any(word in _WANTED | {"do", "does"} and behind in _THING for word, behind in pairs)


def takes_back(words: Sequence[str]) -> bool:
    """Whether the mind was changed, "that was the old plan", "we had better not", or there should be "some more"."""
    if words[-1] in ("more", "another", "too"):
        return True
    other = not _OTHER.isdisjoint(words)
    return other and not (_CHANGED | {"not", "never", "without"}).isdisjoint(words)


def _yields(words: Sequence[str]) -> bool:
    """ "Help me", "tell him:", and "exercise one", "test for today"."""
    errand = words[0] in _HEADINGS or not _ERRANDS.isdisjoint(words[2:])
    named = words[1:2] in (["one"], ["time"], ["of"]) or (words[1:2] == ["for"] and errand)
    return named or tuple(words[:2]) in _YIELDING or tuple(words) == ("tell", "it")  # "tell him:"


def _talk(token: Token, words: list[str], n: int) -> bool:
    """Whether a word among others is one that asks for nothing."""
    if token.kind == "punct" or (len(token.raw) > 1 and token.raw.isupper()):
        return token.word in (",", "'s", "…")
    after = words[n + 1 : n + 5]
    match token.word:
        case word if word in _NEGATED:
            return not _CALM.isdisjoint(after[:3])
        case word if word in _TURN:
            return not _ERRANDS.isdisjoint(after[:2])
        case word if word in _PLACED:
            named = next((k for k, x in enumerate(after) if x in _PERSONS | _ERRANDS | harmless.NAMES), None)
            return named is not None and all(x in _GLUE | _FEELINGS | _TURN for x in after[:named])
        case "if":
            return bool(after) and after[0] in _VAGUE and not _POLITELY.isdisjoint(after[1:3])
        case "one":
            return n > 0 and words[n - 1] in ("this", "that", "quick", "easy", "simple", "last", "next")
        case word if word in _SUBJECTS:
            return not _LIKED.isdisjoint(words[max(0, n - 3) : n])
    named = token.word in harmless.NAMES and n > 0 and words[n - 1] in _PLACED
    return named or token.word in _GLUE or token.word in _STRONG
