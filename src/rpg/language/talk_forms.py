"""Talk by its form: whom it is said to, what is looked forward to, reasons, aims, polite conditions, care.

What stands in such a place can tell of blocks only by a word that the language has. So words that mean nothing here
are let pass where the form says that somebody, or the work as a whole, is spoken of; nowhere else.
"""

from __future__ import annotations

from collections.abc import Sequence

from rpg.language import harmless, lexicon
from rpg.language.lead_ins import set_in
from rpg.language.of_people import of_people
from rpg.language.smalltalk import SAID_OF_SCENES, THING, asks, harmless_word, is_strange, small_talk
from rpg.language.telling import may_tell
from rpg.language.tokens import Token


def _words(text: str) -> frozenset[str]:
    return frozenset(text.split())


_GREETINGS = _words("good morning evening afternoon day greetings now so right")
_CALLED = _words("my our dear little old good sweet mister mr mrs ms miss big young clever smart brave lovely") | (
    harmless.FINE - _words("real ideal fine true best better")
)
_LISTENERS = harmless.PEOPLE | _words(
    "fellow fellows creature sir madam guys ladies robot arm machine computer agent gripper helper gentlemen human humans you one"
)
_AFTER_NAMES = _words("over there up here all again of mine and out arm friend my")
_HELPERS = _words(
    "robot robots arm machine computer agent helper assistant friend friends buddy mate pal dear darling sweetheart "
    "sweetie honey love chap fella lad dude bro genius angel sir madam kids children everyone everybody folks team "
    "class"
)
"""Those that a command is given to with nothing between: "dear robot put ..."."""
_COMING = tuple(
    tuple(f"{ahead} {comes}".split())
    for ahead in ("now", "here", "next", "then", "this", "that", "it", "and now", "and here", "now this", "i have",
    "we have",
                  "i 've got", "there", "let us try", "let me try", "up next", "first")
    for comes in ("", "comes", "is", "'s", "goes", "will be", "is going to be", "follows", "got", "'s got")
)  # fmt: skip
_BEGINNINGS = ("to begin with", "to start with", "for a start", "for starters", "to warm up")
_SORTS_OF_ERRANDS = (harmless.FINE - _words("true real")) | _words(
    "a an the my our your one little small big quick short next new last final first second third another today 's "
    "easier "
    "harder easiest hardest main actual important tiny just only more very really so super pretty quite rather bit "
    "fresh"
)
_ERRANDS = _words(
    "request question task favor job challenge puzzle exercise game assignment mission errand problem riddle quiz "
    "one part "
    "bit round thing order wish idea experiment test demo trick turn lesson warm-up warmup attempt try brainteaser"
)
"""What is announced, of which nothing is told yet."""
_CONDITIONS = (("if",), ("when",), ("whenever",), ("should",), ("once",), ("in", "case"), ("provided",), ("provided",
               "that"),
               ("as", "long", "as"))  # fmt: skip
_OBLIGING = _words(
    "you it that this i we is are would could can will may might do does not no too so very much really at all any a "
    "an "
    "the bit little free spare to for of with me us please mind minding ask asking request be being okay ok fine "
    "alright "
    "all right possible convenient happen have has find get got time minute moment second minutes seconds trouble "
    "bother "
    "work effort hassle problem burden inconvenience kind good nice able ready manage feel like up awake willing "
    "kindly "
    "busy hands your somehow perhaps 's 're 've 'd don't permit allow allows permits may excuse "
    "schedule suits other things else course make wish request suggestion"
)
"""Of what somebody asks who is polite."""
_RESTED = _words(
    "are 're done with taking have 've had finished eaten drunk taken your a the some morning little nice well"
)
_ASKED_OF = _words("you it that this i your time")
_OBLIGED = _words(
    "mind okay ok fine alright right possible convenient time minute moment second minutes seconds trouble bother work "
    "effort hassle problem burden inconvenience kind good nice able ready manage free much busy willing ask permit "
    "permits allow allows suits would wish request suggestion "
    "could can"
)
_EXHORTING = (("let", "me"), ("time", "to"), ("time", "for"), ("let", "us"), ("shall", "we"), ("shall", "i"),
              ("should", "we"),
              ("can", "we"), ("could", "we"), ("may", "we"), ("ready", "to"), ("ready", "for"), ("off", "to"),
              ("get", "ready", "to"), ("get", "ready", "for"), ("who", "wants", "to"), ("who", "is", "ready", "for"),
              ("how", "about"), ("what", "about"), ("we", "want", "to"), ("we", "are", "going", "to"),
              ("are", "you", "ready", "to"), ("are", "you", "ready", "for"), ("i", "am", "going", "to"),
              ("we", "will"), ("we", "are"), ("i", "am"))  # fmt: skip
_BEFORE_THEM = _words("it is 's now okay ok and so well right alright high come on then hey today here")
_OTHERWISE = _words("not never again twice more instead another different else other over stop")
_GOING = ("give it a go", "give it a try", "give it a shot", "give it a whirl", "have a go", "have a try",
          "get this show on the road", "get down to business", "get to work", "get this party started", "roll",
          "get it done", "get this done", "get on with it", "get the ball rolling")  # fmt: skip
"""Beginnings in set phrases."""
_WORK = _words(
    "build building play playing count counting learn learning work working tidy tidying clean cleaning begin start "
    "starting stack stacking spell spelling write writing read reading make making do doing try see go going "
    "get practise practice some something things stuff together again up with our blocks towers shapes letters numbers "
    "words colors patterns figures rows stairs pyramids steps cubes fun a bit little while the next one"
)
"""What is done with blocks at large, none of which is told."""
_AT_LARGE = _words("blocks towers shapes letters numbers words colors patterns figures rows stairs pyramids cubes")
_TRIED = _words("do try see start begin play practise practice hear")
_REASONS = _words("because since cause cos coz")
_HELD = _words("must should shall ought needs need unless if only without not no never nobody")
_WANTED = _words("want wants need needs")
_OWN_WAY = _words("stands standing sits sitting lies lying looks looking stays where so nicely well prettily there "
                  "otherwise")  # fmt: skip
"""How something is where it is anyway."""
_AIMS = (("to",), ("in", "order", "to"), ("so", "as", "to"), ("just", "to"))
_SOCIAL = _words(
    "please impress cheer surprise amuse entertain help teach celebrate test practise practice pass win save keep make "
    "thank comfort welcome honor congratulate tease annoy delight inspire calm show demonstrate convince persuade prove"
)
_RESULTS = (("so", "that"), ("so",), ("such", "that"), ("in", "order", "that"))
_WHAT_STANDS = _words("it they nothing none everything this that all of them the whole thing")
_HOLDS = _words(
    "fall falls falling fell tip tips topple topples wobble wobbles collapse collapses crash crashes break breaks "
    "tumble "
    "tumbles slip slips drop drops over down off apart stable steady safe secure safely does do not can could will "
    "would "
    "is are be stays stay remain remains to get gets in my our your their its his her way bother bothers disturb "
    "disturbs "
    "anybody anyone us me each other one another look looks nice pretty lovely good beautiful neat tidy happens happen "
    "anything bad goes go wrong gets lost damaged hurt scratched stands stand well the floor and nicely better"
)
_CARE = _words(
    "slowly slow gently gentle carefully careful softly quietly calmly patiently precisely steady steadily cautiously "
    "kindly easy with great much lots a lot of all some little extra special care caution patience love attention "
    "precision very really nice and as you can so ever please be your the best most utmost bit way in gentlest hurry "
    "no "
    "due usual possible without any own time smoothly tenderly delicately attentively"
)
_CARED = _words("slowly slow gently gentle carefully careful softly quietly calmly patiently cautiously care caution "
                "patience "
                "love precision steady easy gentlest hurry smoothly tenderly delicately")  # fmt: skip


def by_form(tokens: Sequence[Token]) -> bool:
    """Whether what is set off asks for nothing: an address, a call to begin, a condition or a word of care."""
    words = [token.word for token in tokens]
    return (
        _of_the_day(words) or set_in(words) == len(words) or addresses(words) or _announces(tokens)
        or polite_condition(words) or takes_care(words) or _exhorts(tokens)
        or reason_or_aim(tokens) or meanwhile(tokens) or rewards(tokens) or of_people(tokens)
    )  # fmt: skip


def _of_the_day(words: Sequence[str]) -> bool:
    """ "It is raining outside", "it's Friday already"."""
    said = words[3:] if words[:3] == ["and", "it", "is"] else words[2:]
    known = harmless.OCCASIONS | harmless.ADVERBS | _words(
        "raining snowing sunny rainy stormy foggy freezing late early outside inside already getting still almost "
        "nearly time for "
        "again here the in pouring"
    )  # fmt: skip
    led = words[:2] in (["it", "is"], ["it", "'s"]) or words[:3] == ["and", "it", "is"]
    return led and bool(said) and all(word in known - _SAID_OF_WORK for word in said)


_SAID_OF_WORK = SAID_OF_SCENES | _words("mess chaos once later only")


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
    at = begin + _led(words[begin:], _COMING)
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
    lead = _led(words, _CONDITIONS)
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
    lead = _led(words[at:], _EXHORTING)
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


def reason_or_aim(tokens: Sequence[Token]) -> bool:
    """ "Because it looks so pretty", "to make my daughter smile", "so that nothing falls down"."""
    words = [token.word for token in tokens]
    if words[0] in _REASONS and len(words) > 2:
        return _told_why(tokens[1:])
    if words[0] == "for" and words[1:2] in (["i"], ["we"]) and small_talk(tokens[1:]):
        return True
    if words[0] in ("as", "for", "so") and words[1:2] != ["you"] and of_people(tokens[1:], denied=True):
        return True
    if (lead := _led(words, _AIMS)) and _done_to_ours(tokens[lead:]):
        return True
    if (lead := _led(words, _AIMS)) and words[lead : lead + 1] and words[lead] in _SOCIAL:
        behind = tokens[lead + 1 :]
        social = any(t.word in harmless.PEOPLE | harmless.OCCASIONS | {"me", "us", "you"} for t in behind)
        made = words[lead] in ("make", "keep", "show")
        return social and all(
            harmless_word(behind, n)
            or (is_strange(t.word) and not made)
            or (n > 1 and not made and not may_tell(t.word))
            for n, t in enumerate(behind)
        )
    if (lead := _led(words, _RESULTS)) and len(words) > lead + 1:
        behind_words = words[lead:]
        hidden = "not" in words and not THING.isdisjoint(words)  # "so that I can not see it"
        if (not hidden and _of_what_people_can(tokens[lead:])) or (
            words[lead] != "you" and of_people(tokens[lead:], denied=True)
        ):
            return True
        held = behind_words[0] in _WHAT_STANDS and all(w in _HOLDS | _WHAT_STANDS for w in behind_words)
        denied = behind_words[0] in ("nothing", "none") or "not" in behind_words
        return held and (denied or not {"nice", "pretty", "lovely", "good", "beautiful", "stable", "steady", "safe",
                                        "secure", "safely"}.isdisjoint(behind_words))  # fmt: skip
    return False


def _done_to_ours(tokens: Sequence[Token]) -> bool:
    """ "(To) calibrate the camera", "(to) cheer up my sick friend": what is done to something that no task has."""
    words = [token.word for token in tokens]
    det = next((n for n, word in enumerate(words[1:4], 1) if word in _OF_SOME), 0)
    if not det or len(words) == det + 1:
        return False
    if words[0] in _TRIED_OUT and all(word in _TOOLS or word in _CALLED for word in words[det + 1 :]):
        return True
    verb = words[0] not in lexicon.VERB and not words[0].startswith(_LIKENESS)
    if not (verb and THING.isdisjoint(words)) or asks(words[1:]):
        return False
    ours = (
        harmless.PEOPLE | harmless.OCCASIONS | harmless.THINGS | harmless.ANIMALS | _words("camera cameras arm robot")
    )
    known = all(
        word in ours | _OF_SOME | _words("up out for at in with and")
        or harmless_word(tokens, n) or is_strange(word) or word in harmless.EVERYDAY
        for n, word in enumerate(words)
    )  # fmt: skip
    return known and (not ours.isdisjoint(words[det + 1 :]) or (words[0] in _SOCIAL and is_strange(words[-1])))


_TRIED_OUT = _words("test check train try exercise practice practise calibrate improve prove show demonstrate use")
_TOOLS = _words("gripper arm arms hand hands fingers skill skills camera cameras precision patience robot software "
                "system "
                "controller sensors sensor abilities ability talent talents brain eyes vision")  # fmt: skip
_OF_SOME = _words("the my our his her their your")
_LIKENESS = ("match", "resembl", "mimic", "imitat", "copy", "mirror", "reflect", "represent", "depict", "replicat",
             "reproduc", "follow", "obey", "fit", "hide", "cover", "block", "obstruct", "protect", "surround",
             "support")  # fmt: skip
"""How words begin of which something would follow for the blocks."""


def meanwhile(tokens: Sequence[Token]) -> bool:
    """ "While I make a cup of tea", "until my wife is home", "during the coffee break"."""
    words = [token.word for token in tokens]
    if words[0] in ("while", "whilst", "until", "till", "before") and len(words) > 2:
        return words[1] != "you" and of_people(tokens[1:], anything=True)
    known = harmless.OCCASIONS | harmless.PEOPLE | harmless.FINE | _words("the our my your a this 's little whole next")
    return words[0] == "during" and words[-1] in harmless.OCCASIONS and all(word in known for word in words[1:])


def rewards(tokens: Sequence[Token]) -> bool:
    """ "If it works I owe you a beer", "or I will be sad"."""
    words = [token.word for token in tokens]
    if words[0] in ("or", "otherwise"):
        at = 2 if words[1:2] == ["else"] else 1
        return not {"will", "'ll"}.isdisjoint(words[at : at + 4]) and of_people(tokens[at:])
    lead = _led(words, _IF_DONE)
    return bool(lead) and words[lead : lead + 1] in (["i"], ["we"], ["my"], ["everybody"]) and of_people(tokens[lead:])


_IF_DONE = tuple(
    (*when, *done, *mark)
    for when in (("if",), ("when",), ("once",), ("as", "soon", "as"))
    for done in (("it", "works"), ("this", "works"), ("that", "works"), ("you", "manage"), ("you", "do", "it"),
                 ("you", "succeed"), ("you", "can", "do", "it"), ("you", "make", "it"), ("you", "win"), ("it", "is",
                 "done"),
                 ("you", "manage", "that"), ("you", "manage", "it"), ("you", "are", "done"), ("you", "do", "well"),
                 ("you", "do", "this"), ("you", "do", "that"))
    for mark in ((), (",",), ("then",), (",", "then"))
)  # fmt: skip


def _of_what_people_can(tokens: Sequence[Token]) -> bool:
    """ "(So that) the visitors can take photos of it", "(because) I can't do it myself"."""
    words = " ".join(token.word for token in tokens).replace("can not ", "can ").split()
    could = next((n for n, word in enumerate(words[:6]) if word in _COULD), 0)
    whose = {*words[:could]} & (harmless.PEOPLE | _words("i we he she you everybody everyone"))
    plain = (
        _LEGIBLE.isdisjoint(words) and could > 0 and bool(whose) and could + 1 < len(words) and _HELD.isdisjoint(words)
    )
    known = all(
        t.kind == "word" and (t.word == "not" or harmless_word(tokens, n) or not may_tell(t.word))
        for n, t in enumerate(tokens)
    )
    return plain and known and not any(len(t.raw) > 1 and t.raw.isupper() for t in tokens)


_LEGIBLE = _words("read reads reading legible readable")
"""Letters have to be turned for that."""
_COULD = _words("can could may might will would have has is are am was were 'll 'd 're 's 'm")


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


def takes_care(words: Sequence[str]) -> bool:
    """ "Nice and slow", "with great care"."""
    return all(word in _CARE for word in words) and not _CARED.isdisjoint(words)


def _led(words: Sequence[str], leads: Sequence[tuple[str, ...]]) -> int:
    """How many words the longest of some leads has that they begin with."""
    return max((len(lead) for lead in leads if tuple(words[: len(lead)]) == lead), default=0)
