"""Leads of those who wish, dare, announce and tell of themselves: "it would mean the world to me if (...)", "I bet you
can't (...)", "one thing at a time: (...)", "our grandson calls it the sandwich: (...)".

As in `spoken_leads` their words may be any that cannot tell of blocks; they stand in front of all else.
"""

from __future__ import annotations

from collections.abc import Sequence

from rpg.language import harmless, lexicon
from rpg.language.headlines import headline
from rpg.language.smalltalk import is_strange
from rpg.language.spoken_dares import ability, dared
from rpg.language.spoken_leads import BEGINS, DET, LONGEST, TESTS, heading, of_words, sets_off, subject, tells_nothing
from rpg.language.telling import may_tell_how
from rpg.language.tokens import Token
from rpg.language.word_lists import listed


def led_by_form(tokens: Sequence[Token], commanded: bool) -> int:
    """How many of the first words of a text are such a lead. `commanded`: behind what it is comes a command, so that it
    may be like this at the start."""
    ways = (
        heading,
        headline,
        called_by_name,
        asked_of_it,
        purpose,
        dared,
        glad_if,
        favour,
        clause,
        announcement,
        ability,
    )
    return (0 if commanded else subject(tokens) or included(tokens)) or next(
        (led for way in ways if (led := way(tokens))), 0
    )


_LIGHTLY = (
    "not too", "not so", "not very", "not that", "can not reach", "can not wait", "can not manage", "can not do",
    "one thing", "one more", "one last", "one for", "this one", "next one", "easy one", "last one", "quick one",
    "simple one", "and then", "too hard", "too difficult", "too much", "in plain", "only one more", "the same as",
    "the same thing", "same as always", "same as usual", "same as ever", "straight to the point", "to the point",
    "put on a show", "you may begin", "you can begin", "you may start", "you can start",
    "something different", "completely different", "totally different", "a bit different", "to the letter",
    "pay attention",
)  # fmt: skip
"""In an announcement these do not mean blocks, and do not deny it."""
_ASKING = listed("is are does do did was were has have had can could will would should may might whose whom")
_STAYING = listed("keep keeps leave leaves stay stays remain remains kept left")
_PAST = listed("was were had used did been failed")


def announcement(tokens: Sequence[Token]) -> int:
    """How many of the first words announce what is told behind their colon: "one thing at a time:", "I hope this is not
    too hard:"."""
    words = [token.word for token in tokens]
    end = next((n for n in range(min(2 * LONGEST, len(words) - 1)) if sets_off(tokens, n)), 0)
    if not TESTS.isdisjoint(words[:LONGEST]) and words[0] in DET | {"here", "one", "another", "next"}:
        end = next((n for n in range(3, min(2 * LONGEST, len(words) - 1)) if words[n] == ","), end)
    if (
        not end
        or (len(words) < end + 4 and tokens[end + 1].kind != "equation")
        or not _PAST.isdisjoint(words[:end])
        or not _STAYING.isdisjoint(words[:end])
        or words[0] in _ASKING - {"can", "could"}
    ):
        return 0
    light = {
        n + k for n in range(end) for said in _LIGHTLY if words[n : n + len(said.split())] == said.split()
        for k in range(len(said.split()))
    }  # fmt: skip
    spoken = _THEM | {",", "how", "what", "here", "also", "another", "next", "word", "number", "letter"}
    known = all(n in light or word in spoken or tells_nothing(word) for n, word in enumerate(words[:end]))
    return end + 1 if known and of_words([t for t in tokens[:end] if t.word != ","]) else 0


def included(tokens: Sequence[Token]) -> int:
    """How many of the first words wish for a task of which it is told what comes out: "the authors should include a
    task in which (red is on blue)", "how about a scene where (...)", "add an episode with (a row of three)"."""
    words = [token.word for token in tokens]
    for at in range(1, min(2 * LONGEST, len(words) - 3)):
        told = next((len(x) for x in _IN_IT if tuple(words[at : at + len(x)]) == x), 0)
        if words[at - 1] in _INCLUDED and told:
            break
    else:
        return 0
    if ":" in words[at:]:
        return 0  # it is so at the start
    begin = next((n for n in range(at - 2, -1, -1) if words[n] in _SOME), -1)
    ahead, sorts = words[: max(begin, 0)], words[begin + 1 : at - 1]
    wished = not ahead or (not _WISHED_FOR.isdisjoint(ahead) and _SAD.isdisjoint(ahead))
    plain = of_words(tokens[:at]) and all(map(tells_nothing, sorts)) and "had" not in ahead
    plain = plain and all(word in _WISHED_FOR | _THEM | harmless.DOINGS or tells_nothing(word) for word in ahead)
    figure = words[at] != "with" or words[at + 1] in BEGINS
    return at + told if wished and plain and figure and (begin >= 0 or not ahead) else 0


def asked_of_it(tokens: Sequence[Token]) -> int:
    """How many of the first words ask whether who does it can: "can it (stack three blocks)?"."""
    words = [token.word for token in tokens[:4]]
    asked = (
        words[:1] != [] and words[0] in ("can", "could", "will", "would") and words[1:2] in (["it"], ["he"], ["she"])
    )
    at = 2 + (words[2:3] == ["please"])
    commands = at < len(words) and words[at] in lexicon.COMMANDS - (lexicon.POSTURE - {"put"})
    return at if asked and commands else 0


def called_by_name(tokens: Sequence[Token]) -> int:
    """How many of the first words call somebody by a name that is not known: "Alexa, (put ...)"."""
    words = [token.word for token in tokens]
    named = words[1:2] == [","] and is_strange(words[0]) and tells_nothing(words[0]) and not may_tell_how(words[0])
    commanded = len(words) > 3 and words[2] in lexicon.COMMANDS | {"please", "can", "could", "would", "will"}
    return 2 if named and commanded and tokens[0].raw[:1].isupper() else 0


_INCLUDED = listed(
    "task test scene scenario episode trial exercise example case variant problem challenge puzzle level"
)
_IN_IT = (("in", "which"), ("where",), ("in", "that"), ("such", "that"), ("with",), ("which", "asks", "for"),
          ("that", "asks", "for"), ("consisting", "of"))  # fmt: skip
_SOME = listed("a an another one some")
_WISHED_FOR = listed(
    "include includes contain contains add adds have has need needs want wants like consider considers be about "
    "propose suggest recommend see try test design imagine should would could must may can might 'd how what there "
    "think of"
)
"""How a task is wished for, and not told of as one that there was."""


_GLAD = listed(
    "great nice good lovely wonderful perfect cool awesome amazing fantastic brilliant super neat fun happy glad "
    "delighted grateful thankful thrilled pleased proud cookies cakes chocolate love appreciate appreciated world "
    "moon day hug hugs kiss kisses excited helpful kind sweet ideal best dream ecstatic charmed impressed honored "
    "honoured cookie beer thanks"
)
_SAD = listed(
    "sad angry upset cry cries annoyed annoying furious disappointed mad hurt weep scream ashamed die mind kill "
    "quit scold bad terrible awful horrible silly stupid strange odd boring funny weird dangerous unhappy "
    "surprised shame pity"
)


def glad_if(tokens: Sequence[Token]) -> int:
    """How many of the first words say that somebody would be glad: "it would mean the world to me if (...)"."""
    words = [token.word for token in tokens]
    at = next((n for n, word in enumerate(words[: 2 * LONGEST]) if word in ("if", "when", ",", ":")), 0)
    if not at or words[at] in (",", ":") or len(words) < at + 5 or not of_words(tokens[:at]):
        return 0
    ahead = [
        word for n, word in enumerate(words[:at]) if not (word == "not" and words[n - 1 : n] == ["would"] and n < 2)
    ]
    glad = not _GLAD.isdisjoint(ahead) and _SAD.isdisjoint(ahead)
    return at + 1 if glad and all(w in _GLAD | _THEM or tells_nothing(w) for w in ahead) else 0


_THEM = listed("it he she so much over only you me")


def favour(tokens: Sequence[Token]) -> int:
    """How many of the first words only ask to be kind: "can you do me a solid and (line up ...)"."""
    words = [token.word for token in tokens]
    begin = 2 if words[:2] in (["can", "you"], ["could", "you"], ["would", "you"], ["will", "you"]) else 0
    begin += words[begin : begin + 1] == ["please"]
    at = next((n for n in range(begin, min(begin + LONGEST, len(words) - 3)) if words[n] == "and"), 0)
    kind = words[begin : begin + 3]
    asked = (
        (kind[:1] == ["do"] and kind[1:2] in (["me"], ["us"], ["yourself"]) and kind[2:3] in (["a"], ["the"], ["this"]))
        or (kind[:1] == ["make"] and kind[1:2] in (["me"], ["us"], ["my"], ["somebody"], ["someone"], ["mommy"])
            and not (_GLAD | {"smile", "laugh"}).isdisjoint(words[begin + 2 : at]))
        or kind[:2] in (["be", "a"], ["be", "an"], ["be", "my"])
    )  # fmt: skip
    plain = at and asked and all(w in _THEM or tells_nothing(w) for w in words[begin + 1 : at])
    return at + 1 if plain and words[at + 1] in lexicon.COMMANDS else _with_it(words, begin)


def _with_it(words: Sequence[str], begin: int) -> int:
    """ "Surprise me with (any tower ...)", "let us try (a circle ...)"."""
    tried = max((len(said) for said in _TRIES if tuple(words[begin : begin + len(said)]) == said), default=0)
    if tried and words[begin + tried : begin + tried + 1] and words[begin + tried] in BEGINS - {"the"}:
        return begin + tried
    at = next((n for n in range(begin + 1, min(begin + LONGEST, len(words) - 3)) if words[n] == "with"), 0)
    said = words[begin:at]
    pleasing = said[:1] and (said[0] in _PLEASING or said[:2] in (["show", "off"], ["warm", "up"], ["kick", "off"],
    ["get", "the"], ["get", "us"])
                             or (said[0] == "make" and said[-1] in _GLAD | {"smile"}))  # fmt: skip
    plain = pleasing and all(word in _THEM | {"off", "up"} or tells_nothing(word) for word in said[1:])
    return at + 1 if plain and words[at + 1] in BEGINS else 0


_PLEASING = listed("surprise impress delight wow dazzle amaze treat spoil cheer entertain honor honour astonish reward")
_TRIES = tuple(
    (*lead, *said)
    for lead in (
        (),
        ("maybe",),
        ("let", "us"),
        ("please",),
        ("just",),
        ("perhaps",),
        ("so", "let", "us"),
        *((who, "could", *also) for who in ("you", "we", "they") for also in ((), ("also",))),
    )
    for said in (("try",), ("go", "with"), ("go", "for"), ("do",), ("attempt",), ("test",), ("try", "out"))
)

_SPEAKERS = listed("i we he she my our his her the")
_ASKED = listed(
    "want wants wanted need needs needed like likes wish wishes wished prefer prefers require requires order "
    "orders ordered request requests requested demand demands build builds make makes must should shall have has "
    "you ask asks would will love loves get gets expect expects put place"
)
"""With these more is asked for in front than what stands behind."""
_ABOUT_PEOPLE = listed(
    "it he she so much over me table desk order neat tidy untidy messy mess cluttered clutter chaos all together "
    "away once blind color reach room shop place too not can yet still also then patterns colors letters shapes "
    "numbers rainbows puzzles stairs patience bad problem problems trouble worried fear fears joke jokes hate "
    "hates kitchen hands back"
) - {"not"}
"""Of these nothing hangs on for blocks where people are told of in front of a command."""
_AROUND_VERBS = listed("up out over down through off")
_GOING = listed("please can could would will let i we you need want kindly now just lets")


def clause(tokens: Sequence[Token]) -> int:
    """How many of the first words tell of people: "I am decorating a shop window and (need ...)", "our grandson calls
    it the sandwich: (...)"."""
    words = [token.word for token in tokens]
    if words[:1] == [] or words[0] not in _SPEAKERS:
        return 0
    for at in range(3, min(2 * LONGEST, len(words) - 3)):
        joined = words[at] in ("and", "so", "but") and words[at + 1] in _GOING | lexicon.COMMANDS
        if words[at] in (",", ":") or joined:
            break
    else:
        return 0
    said = words[1:at]
    known = all(
        word in _ABOUT_PEOPLE or tells_nothing(word)
        or (word in _AROUND_VERBS and said[n - 1].endswith(("ing", "ed")))
        for n, word in enumerate(said)
    )  # fmt: skip
    acting = words[0] in ("i", "we", "he", "she") or not (harmless.PEOPLE | harmless.ANIMALS).isdisjoint(words[1:5])
    told = known and acting and of_words(tokens[:at]) and _ASKED.isdisjoint(said)
    return at + 1 + (words[at] == "," and words[at + 1] in ("and", "so", "but")) if told else 0


def purpose(tokens: Sequence[Token]) -> int:
    """How many of the first words say what for, up to a comma, to who wishes it or to the command: "for the big finish
    (I'd like ...)", "as a little warm-up exercise, (put ...)", "to celebrate our win, (...)", "in condition B, ..."."""
    words = [token.word for token in tokens]
    if words[:1] not in (["for"], ["as"], ["to"], ["in"], ["during"]) or len(words) < 5:
        return 0
    if (comma := next((n for n in range(2, LONGEST) if words[n : n + 1] in ([","], [":"])), 0)) and words[0] != "to":
        labelled = tokens[comma - 1].kind == "number" or len(tokens[comma - 1].raw) == 1
        head = comma - 1 - labelled
        plain = of_words(tokens[:head]) and all(word in _TRIED_SO or tells_nothing(word) for word in words[1:head])
        if words[head] in _TRIALS and plain and len(words) > comma + 3:
            return comma + 1
    if words[0] in ("in", "during"):
        return 0
    end = next((n for n in range(2, min(LONGEST + 1, len(words) - 1)) if _goes_on(words, n)), 0)
    begun = words[0] == "for" or words[1] in DET | {"someone", "somebody"}
    kept = words[1] in ("keep", "make", "get") and not _GLAD.isdisjoint(words[:end])
    aimed = words[0] == "to" and (kept or words[1] not in lexicon.VERB) and words[end] in (",", ":")
    known = (begun or aimed) and of_words(tokens[:end]) and all(_of_an_aim(words, n) for n in range(1, end))
    return end + (words[end] in (",", ":")) if end and known and len(words) > end + 3 else 0


_TRIALS = TESTS - listed("building stacking sorting spelling counting arranging ordering grouping placing") | listed(
    "condition study session round lecture version stimulus item"
)
"""What a task is one of: its number or letter is no block."""
_TRIED_SO = listed("background warm up odd one out control first second third last next fourth fifth")
"""Which of them it is."""


def for_what(tokens: Sequence[Token], at: int) -> bool:
    """Whether all that stands from here on says what it is for: "(stack them) for quality control", "as a warm-up
    exercise"; but not what has to be found, kept free or given for what is named behind "for"."""
    words = [token.word for token in tokens]
    named = words[-1] in _TRIALS | harmless.PEOPLE or _as_token(words[at + 2 :])
    if words[at] == "as" and words[at + 1] in DET and named:
        return of_words(tokens[at:]) and all(word in _TRIED_SO or tells_nothing(word) for word in words[at + 1 :])
    if words[at] != "for" or len(words) < at + 2 or words[at + 1] in _SINGLY or not _FOR_IT.isdisjoint(words[:at]):
        return False
    lasting = words[-1] in harmless.TIMES and words[-1] not in ("day", "night", "today", "tonight", "tomorrow")
    plain = of_words(tokens[at:]) and all(_of_an_aim(words, n) for n in range(at + 1, len(words)))
    plain = plain and not lasting
    return plain and len(words) <= at + LONGEST


def _as_token(words: Sequence[str]) -> bool:
    """ "(As a) small token of (gratitude)", "(as a) proof of (concept)"; "as a ring of" would be a shape."""
    at = next((n for n, word in enumerate(words) if word in _TOKENS), len(words))
    return at < 2 and words[at + 1 : at + 2] in (["of"], ["to"], ["for"]) and len(words) > at + 2


_TOKENS = listed(
    "gesture token sign proof tribute favor gift reward present backup joke treat surprise precaution reminder "
    "demonstration courtesy matter means act show test measure nod homage farewell welcome"
)
_SINGLY = listed("each every all both any some it them that this these those")
_FOR_IT = listed(
    "room space place gap spot slot use using used take find look search choose pick swap exchange trade substitute "
    "switch replace wait reserve save keep leave mistake account stand stands"
)
_NO_PARTS = listed("later next transport display shipping shift loading safety inventory stock background setup window")
"""Of an aim, and of nothing that there is."""


def _of_an_aim(words: Sequence[str], n: int) -> bool:
    """Whether a word of an aim carries nothing; "(for my) first (graders)" are people."""
    counted = words[n] in lexicon.ORDINAL and words[n + 1 : n + 2] != [] and words[n - 1] in DET
    of_ours = counted and words[n + 1] in harmless.PEOPLE | harmless.OCCASIONS - {"task"}
    return of_ours or words[n] in _NO_PARTS or tells_nothing(words[n])


def _goes_on(words: Sequence[str], n: int) -> bool:
    commanded = words[n] in lexicon.COMMANDS and words[n + 1] in _DONE_TO
    thing = words[n] in _OF_ALL and any(word in table for word in words[n + 1 : n + 4] for table in _THINGS)
    return words[n] in _GOES_ON or commanded or (thing and not _BOUND.isdisjoint(words[n + 2 :]))


_OF_ALL = listed("the both all")
_THINGS = (lexicon.COLOR, lexicon.BLOCK, lexicon.LETTER, lexicon.DIGIT, lexicon.STRUCTURE)
_BOUND = listed("must should shall has have needs need ought")
"""What stands behind a thing of which it is said how it has to be: "for traceability the blocks (must stand ...)"."""


_DONE_TO = BEGINS | listed("all both every each me us my your these some two exactly at only just any")
_GOES_ON = listed(", : i we you please let could can would there")
