"""Talk by its form: whom it is said to, what is looked forward to, polite conditions, care; and `reasons`.

What stands in such a place can tell of blocks only by a word that the language has. So words that mean nothing here
are let pass where the form says that somebody, or the work as a whole, is spoken of; nowhere else.
"""

from __future__ import annotations

from collections.abc import Sequence

from rpg.language import harmless
from rpg.language.lead_ins import set_in
from rpg.language.of_people import fits, of_people, subject_of
from rpg.language.reasons import length_of_lead, meanwhile, reason_or_aim, rewards
from rpg.language.smalltalk import SAID_OF_SCENES, THING, harmless_word, is_strange
from rpg.language.tokens import Token
from rpg.language.word_lists import listed

_GREETINGS = listed("good morning evening afternoon day greetings now so right")
_CALLED = listed("my our dear little old good sweet mister mr mrs ms miss big young clever smart brave lovely") | (
    harmless.FINE - listed("real ideal fine true best better")
)
_LISTENERS = harmless.PEOPLE | listed(
    "fellow fellows creature sir madam guys ladies robot arm machine computer agent gripper helper gentlemen human "
    "humans you one"
)
_AFTER_NAMES = listed("over there up here all again of mine and out arm friend my")
_HELPERS = listed(
    "robot robots arm machine computer agent helper assistant friend friends buddy mate pal dear darling sweetheart "
    "sweetie honey love chap fella lad dude bro genius angel sir madam kids children everyone everybody folks team "
    "class"
)
"""Those that a command is given to with nothing between: "dear robot put ..."."""
_COMING = tuple(
    tuple(f"{ahead} {comes}".split())
    for ahead in ("now", "here", "next", "then", "this", "that", "it", "and now", "and here", "now this", "i have",
                  "we have", "i 've got", "there", "let us try", "let me try", "up next", "first")
    for comes in ("", "comes", "is", "'s", "goes", "will be", "is going to be", "follows", "got", "'s got")
)  # fmt: skip
_BEGINNINGS = ("to begin with", "to start with", "for a start", "for starters", "to warm up")
_SORTS_OF_ERRANDS = (harmless.FINE - listed("true real")) | listed(
    "practice practise bonus a an the my our your one little small big quick short next new last final first second "
    "third another today 's easier harder easiest hardest main actual important tiny just only more very really so "
    "super pretty quite rather bit fresh"
)
_ERRANDS = listed(
    "request question task favor job challenge puzzle exercise game assignment mission errand problem riddle quiz one "
    "part bit round thing order wish idea experiment test demo trick turn lesson warm-up warmup attempt try "
    "brainteaser"
)
"""What is announced, of which nothing is told yet."""
_CONDITIONS = (("if",), ("when",), ("whenever",), ("should",), ("once",), ("in", "case"), ("provided",),
               ("provided", "that"),
               ("as", "long", "as"))  # fmt: skip
_OBLIGING = listed(
    "you it that this i we is are would could can will may might do does not no too so very much really at all any a "
    "an the bit little free spare to for of with me us please mind minding ask asking request be being okay ok fine "
    "alright all right possible convenient happen have has find get got time minute moment second minutes seconds "
    "trouble bother work effort hassle problem burden inconvenience kind good nice able ready manage feel like up "
    "awake willing kindly busy hands your somehow perhaps 's 're 've 'd don't permit allow allows permits may excuse "
    "schedule suits other things else course make wish request suggestion chance my asking"
)
"""Of what somebody asks who is polite."""
_RESTED = listed(
    "are 're done with taking have 've had finished eaten drunk taken your a the some morning little nice well"
)
_ASKED_OF = listed("you it that this i your time")
_OBLIGED = listed(
    "mind okay ok fine alright right possible convenient time minute moment second minutes seconds trouble bother work "
    "effort hassle problem burden inconvenience kind good nice able ready manage free much busy willing ask permit "
    "permits allow allows suits would wish request suggestion chance could can"
)
_EXHORTING = (("let", "me"), ("time", "to"), ("time", "for"), ("let", "us"), ("shall", "we"), ("shall", "i"),
              ("should", "we"), ("can", "we"), ("could", "we"), ("may", "we"), ("ready", "to"), ("ready", "for"),
              ("off", "to"),
              ("get", "ready", "to"), ("get", "ready", "for"), ("who", "wants", "to"), ("who", "is", "ready", "for"),
              ("how", "about"), ("what", "about"), ("we", "want", "to"), ("we", "are", "going", "to"),
              ("are", "you", "ready", "to"), ("are", "you", "ready", "for"), ("i", "am", "going", "to"),
              ("we", "will"), ("we", "are"), ("i", "am"))  # fmt: skip
_BEFORE_THEM = listed("it is 's now okay ok and so well right alright high come on then hey today here")
_OTHERWISE = listed("not never again twice more instead another different else other over stop")
_GOING = ("give it a go", "give it a try", "give it a shot", "give it a whirl", "have a go", "have a try",
          "get this show on the road", "get down to business", "get to work", "get this party started", "roll",
          "get it done", "get this done", "get on with it", "get the ball rolling")  # fmt: skip
"""Beginnings in set phrases."""
_WORK = listed(
    "build building play playing count counting learn learning work working tidy tidying clean cleaning begin start "
    "starting stack stacking spell spelling write writing read reading make making do doing try see go going get "
    "practise practice some something things stuff together again up with our blocks towers shapes letters numbers "
    "words colors patterns figures rows stairs pyramids steps cubes fun a bit little while the next one"
)
"""What is done with blocks at large, none of which is told."""
_AT_LARGE = listed("blocks towers shapes letters numbers words colors patterns figures rows stairs pyramids cubes")
_TRIED = listed("do try see start begin play practise practice hear")
_CARE = listed(
    "slowly slow gently gentle carefully careful softly quietly calmly patiently precisely steady steadily cautiously "
    "manner calm fashion kindly easy with great much lots a lot of all some little extra special care caution patience "
    "love attention precision very really nice and as you can so ever please be your the best most utmost bit way in "
    "gentlest hurry no due usual possible without any own time smoothly tenderly delicately attentively"
)
_CARED = listed(
    "slowly slow gently gentle carefully careful softly quietly calmly calm patiently cautiously care caution patience "
    "love precision steady easy gentlest hurry smoothly tenderly delicately"
)  # fmt: skip


def by_form(tokens: Sequence[Token]) -> bool:
    """Whether what is set off asks for nothing: an address, a call to begin, a condition or a word of care."""
    words = [token.word for token in tokens]
    return (
        _of_the_day(words) or set_in(words) == len(words) or addresses(words) or _announces(tokens)
        or polite_condition(words) or takes_care(words) or _exhorts(tokens)
        or _regards(tokens) or _asks_of_people(tokens)
        or reason_or_aim(tokens) or meanwhile(tokens) or rewards(tokens) or of_people(tokens)
    )  # fmt: skip


def _of_the_day(words: Sequence[str]) -> bool:
    """ "It is raining outside", "it's Friday already"."""
    said = words[3:] if words[:3] == ["and", "it", "is"] else words[2:]
    known = harmless.OCCASIONS | harmless.ADVERBS | listed(
        "raining snowing sunny rainy stormy foggy freezing late early outside inside already getting still almost "
        "nearly time for again here the in pouring"
    )  # fmt: skip
    led = words[:2] in (["it", "is"], ["it", "'s"]) or words[:3] == ["and", "it", "is"]
    return led and bool(said) and all(word in known - _SAID_OF_WORK for word in said)


_SAID_OF_WORK = SAID_OF_SCENES | listed("mess chaos once later only")


def _regards(tokens: Sequence[Token]) -> bool:
    """ "Sorry for waking you so early", "best wishes from Oslo"."""
    words = [token.word for token in tokens]
    at = next((n for n, word in enumerate(words) if word not in _KINDLY), len(words))
    begun = 0 < at < len(words) - 1 and not _REGARDS.isdisjoint(words[:at]) and words[at] in ("for", "from", "about")
    return begun and THING.isdisjoint(words[at + 1 :]) and all(fits(tokens, n) for n in range(at + 1, len(words)))


_REGARDS = listed(
    "sorry thanks thank apologies excuse love greetings regards wishes cheers hugs kisses congratulations"
)
_KINDLY = _REGARDS | listed(
    "i am we are 'm 're so very many best kind warm warmest again and you me please my our much all"
)


def _asks_of_people(tokens: Sequence[Token]) -> bool:
    """ "Are we recording", "is my wife at home"."""
    asked = tokens[0].word in _ASKED_WITH and len(tokens) > 2
    behind = tokens[1 : 1 + subject_of([token.word for token in tokens[1:]])] if asked else ()
    return bool(behind) and behind[0].word != "you" and of_people([*behind, tokens[0], *tokens[1 + len(behind) :]])


_ASKED_WITH = listed("are is am was were has have did")


def addresses(words: Sequence[str]) -> bool:
    """ "Good morning mister robot", "my dear helper", "hey you over there"."""
    at = 0
    while at < len(words) and (words[at] in _GREETINGS | _CALLED | {",", "there"} or harmless.exclaimed(words[at])):
        at += 1
    named = at
    while at and named < len(words) and is_strange(words[named]) and words[named] not in _LISTENERS:
        named += 1
    if (
        len(words) == 3
        and words[0] in harmless.INTERJECTIONS | {"greetings"}
        and words[1] == ","
        and is_strange(words[2])
    ):
        return True
    at = named
    while named < len(words) and words[named] in _LISTENERS | harmless.NAMES:
        named += 1
    return at > 0 and named > at and all(word in _AFTER_NAMES for word in words[named:])


def addressed_at(words: Sequence[str]) -> int:
    """How many of the first words say whom a command is for, with nothing behind them: "dear robot put ..."."""
    return next(
        (n for n in range(4, 0, -1) if words[n - 1 : n] and words[n - 1] in _HELPERS and addresses(words[:n])), 0
    )


def _announces(tokens: Sequence[Token]) -> bool:
    """ "Small request from the kitchen team", "next one for you", "now comes the tricky part"."""
    words = [token.word for token in tokens]
    begin = 1 if words[0] in ("and", "but", "so") else 0
    at = begin + length_of_lead(words[begin:], _COMING)
    while at < len(words) and words[at] in _SORTS_OF_ERRANDS - _ERRANDS:
        at += 1
    if words[at : at + 1] == ["something"] and words[at + 1 : at + 2] and words[at + 1] in harmless.FINE:
        return not words[at + 2 :] or " ".join(words[at + 2 :]) in _BEGINNINGS or words[at + 2] == "for"
    if at >= len(words) or words[at] not in _ERRANDS or not THING.isdisjoint(words[at:]):
        return False
    if words[at] == "one" and (at == begin or words[at + 1 : at + 2] in (["of"], ["to"])):
        return False  # "one of them", "one to its right"
    behind = tokens[at + 1 :]
    whose = not behind or behind[0].word in ("for", "from", "of", "by", "to", "today", "now", "please", ",", "before")
    return whose and all(
        harmless_word(behind, n) or t.word in harmless.THINGS | {"from"} or is_strange(t.word)
        for n, t in enumerate(behind)
    )


def polite_condition(words: Sequence[str]) -> bool:
    """ "If that is not too much to ask", "when you have a free minute"."""
    if words[:2] == ["unless", "you"]:
        return all(word in _OBLIGING for word in words[1:]) and not {"busy", "mind"}.isdisjoint(words)
    if words[:2] in (["after", "you"], ["once", "you"], ["when", "you"]):
        return words[-1] in harmless.OCCASIONS and all(word in _RESTED | harmless.OCCASIONS for word in words[2:])
    lead = length_of_lead(words, _CONDITIONS)
    behind = words[lead:]
    return (
        bool(lead)
        and len(behind) > 1
        and behind[0] in _ASKED_OF
        and (behind[0] in ("you", "i", "we", "your") or "free" not in behind)
        and all(word in _OBLIGING for word in behind)
        and not _OBLIGED.isdisjoint(behind[1:])
        and not ("not" in behind and {"mind", "too", "bother", "trouble", "busy", "problem", "much"}.isdisjoint(behind))
    )  # fmt: skip


def _exhorts(tokens: Sequence[Token]) -> bool:
    """ "Time to play", "shall we try something together", "let us do stairs"."""
    words = [token.word for token in tokens]
    at = next((n for n, word in enumerate(words) if word not in _BEFORE_THEM), 0)
    lead = length_of_lead(words[at:], _EXHORTING)
    behind = words[at + lead :]
    if not lead or not behind or not _OTHERWISE.isdisjoint(behind):
        return False
    if " ".join(behind) in _GOING:
        return True
    pointed = [n for n, word in enumerate(behind) if word in ("it", "this", "that", "them", "these", "those")]
    if any(n != 1 or behind[0] not in _TRIED for n in pointed) or behind[-1] in ("it", "them"):
        return False
    named = [n for n, word in enumerate(behind) if word in _AT_LARGE]
    if any(n and behind[n - 1] not in _WORK | {"the", "some", "our", "with", "for"} for n in named) or len(named) > 1:
        return False
    used = not {"build", "make", "write", "spell", "stack", "sort"}.isdisjoint(behind)
    return all(
        word in _WORK
        or harmless_word(tokens, at + lead + n)
        or (not used and is_strange(word) and word.endswith("ing"))
        for n, word in enumerate(behind)
    )


def takes_care(words: Sequence[str]) -> bool:
    """ "Nice and slow", "with great care"."""
    return all(word in _CARE for word in words) and not _CARED.isdisjoint(words)
