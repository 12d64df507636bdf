"""Lead-ins: what stands in front of a command or a state and says no more than that it is asked for.

"It would be so kind if you could (put ...)", "all you have to do is to (put ...)", "the customer insists that (red is
...)". Each of their words is one of wishing, asking and of who does or wants it, and they end with a word that hands on
to the task. What denies, what is over, and what would be bad has no word here.
"""

from __future__ import annotations

from collections.abc import Sequence

from rpg.language import harmless, lexicon
from rpg.language.smalltalk import is_strange
from rpg.language.telling import may_tell, turns
from rpg.language.word_lists import listed

_WHO = (harmless.PEOPLE - listed("nobody")) | listed(
    "i we you he she they it that this everything robot arm machine computer agent gripper helper policy participant "
    "subject contestant candidate human humans manipulator"
)
_SAID_WITH = listed(
    "would could can may might will shall should must is are am be 's 'd 'll 're 've been has have to need needs do "
    "does so very really most much quite just simply kindly please at all totally extremely also and now then today "
    "tonight here the a an my our your his her their this for of in with if whether as big huge great little small "
    "possible nice good lovely wonderful kind helpful grateful obliged thankful delighted happy glad pleased cool "
    "awesome marvelous marvellous fantastic brilliant perfect super dream relief help favor honor pleasure joy fine "
    "okay ok excited eager goal aim task job mission homework duty assignment turn time point idea plan thing only "
    "what challenge exercise next first order request wish purpose intention objective target ready get go ahead try "
    "attempt manage want wants wish wishes like likes love loves hope hopes ask asks asked asking beg begs begging "
    "invite invites order orders request requests require requires required tell tells told supposed expected expect "
    "meant instructed invited allowed able willing prepared know how see wonder wondering trouble bother feel free "
    "proceed remember sure make going me us him her them somebody someone anybody anyone game lesson class school work "
    "experiment scene demo show test exam up free challenged encouraged chance opportunity idea mind called morning "
    "evening promised promise day what bet dare dared week decided all , basically honestly actually essentially "
    "literally obviously ideally normally usually hopefully certainly definitely absolutely favour honour choose "
    "accept chosen moon from hand world once more glory effort make get take way head over gratitude eternally forever "
    "best appreciate informed reckon believe suppose guess say allow pay one got doubt helping old young dear new much "
    "obliged : trouble supposed been 'd duties demonstration trial experiment lesson meeting course important "
    "necessary essential crucial vital urgent matters need trick level objective episode"
)
_DENYING = listed("not no never nothing without too only nobody none had was were did")
"""Not but in a few turns of speech."""
_TURNS = (("the", "only", "thing"), ("was", "wondering"), ("was", "hoping"), ("was", "thinking"), ("was", "going"),
          ("all", "right"), ("it", "falls", "to"), ("were", "wondering"), ("were", "hoping"), ("only", "thing"),
          ("left", "for"), ("left", "to"))  # fmt: skip
_HANDING_ON = listed("would could can may might will shall should must 'd 'll please to and kindly just")
_IFS = listed("if when whenever once unless until because before after while why who where which")
"""A lead-in that begins with them would be a condition, or a question."""
_TELLERS = listed(
    "spec specification plan plans rule rules manual instructions instruction protocol law recipe custom tradition "
    "book card guideline guidelines exam exercise assignment task test ticket contract brief scenario requirement "
    "requirements design standard policy story score number one agreement drawing blueprint note memo paper"
)
_TELLING = listed(
    "says say said demands demand insists insist requires require states state wants want expects expect asks ask "
    "dictates dictate prescribes specifies specify hopes hope wishes wish tells writes told reads reports thinks "
    "believes begs is are it important required expected essential crucial vital necessary desired demanded agreed "
    "decided wanted prefer prefers would like be will shall must should has to have matters what point verify check "
    "confirm ensure test validate assert assume make sure condition state final end goal success termination pass "
    "passing acceptance criterion target result outcome expected desired i we you that here now please also clearly "
    "always still really so just very"
)
_MOST = 16
"""So many words at most a lead-in has."""
_SOUGHT = listed(
    "goal aim task job mission homework duty assignment challenge thing idea plan point exercise objective trick time"
)
_AT_LARGE = listed("make get order show test take")
"""Done to blocks in front of an "and", but for some turns of speech: "make an effort and put ..."."""
_TURNED_SO = listed("day favor favour sure effort way time ready honor honour")


def command_behind(words: Sequence[str]) -> int:
    """How many of the first words lead in a command, "would it be possible to (put ...)"; 0 where they do not."""
    begin = set_in(words)
    begin += words[begin : begin + 1] == [","]
    if not words or words[0] in _IFS:
        return 0
    found = 0
    for at in range(begin + 2, min(_MOST, len(words) - 2)):
        handed = words[at - 1] in _HANDING_ON or (
            words[at - 1] in ("is", ":") and not _ALL_SAID.isdisjoint(words[begin:at])
        )
        if words[at] in lexicon.COMMANDS and handed and words[at + 1] not in ("to", "that", "sure"):
            found = at if _leads_in(words[begin:at]) and not _permits(words[begin:at], words[at:]) else found
    return found


def _permits(lead: Sequence[str], told: Sequence[str]) -> bool:
    """ "You may move the blue block": leave, and no command, where nothing is said of where to."""
    given = bool(lead) and lead[0] not in _MODAL and not _LEAVE.isdisjoint(lead)
    return given and told[0] in _MOVING and _WHERE_TO.isdisjoint(told)


_LEAVE = listed("may might can could allowed permitted free")
_MOVING = listed("move touch shift")
_WHERE_TO = listed("to on onto in into over by away back from off up left right next behind under between cm")

_THINGS = listed("it they this that everything")
_AGENTS = listed(
    "you robot arm machine computer agent gripper helper policy participant subject contestant candidate human humans "
    "manipulator operator"
)
_MODAL = listed("would could can may might will shall should must 'd 'll")
_ALL_SAID = listed("what all thing hand")


_OCCASIONS = (
    harmless.OCCASIONS
    | listed(
        "experiments behalf agenda phone manual work handbook trial round run attempt session episode activity event "
        "spirit interest interests tour house instructions recipe demand orders curiosity preparation"
    )
) - (
    harmless.TIMES
    | listed(
        "yesterday tomorrow past future childhood youth everything something way ways bit lot lots sort kind present "
        "rule thing things stuff one"
    )
)
_SADLY = listed(
    "shame regret worry fear panic stress trouble bother problem difficulty crisis emergency accident disaster mess "
    "chaos nightmare headache illness fever cold flu secret gossip pity grief sorrow dream dreams joke trick lie"
)
"""Nobody wishes for what is said to be that."""
_GLADLY = _OCCASIONS - _SADLY


def _leads_in(words: Sequence[str]) -> bool:
    who = [word for word in words if word in _WHO]
    turned = {n + k for n in range(len(words)) for turn in _TURNS if tuple(words[n : n + len(turn)]) == turn
              for k in range(len(turn))}  # fmt: skip
    known = all(
        n in turned or (word not in _DENYING and (word in _SAID_WITH or word in _WHO or word in _GLADLY))
        for n, word in enumerate(words)
    )
    done_by = _AGENTS.isdisjoint(words) or words[-2:-1] == [] or words[-2] in _THINGS
    told = words[-1] in _MODAL and done_by  # "it should (turn left)", "my wife will (take the other one)"
    asked = (
        bool(who)
        or words[:2] in (["what", "a"], ["get", "ready"], ["feel", "free"], ["go", "ahead"])
        or not _SOUGHT.isdisjoint(words)
    )
    begun = words[-1] == "and"
    done = not _AT_LARGE.isdisjoint(words) and _TURNED_SO.isdisjoint(words)
    return (
        known
        and not turns(words)
        and asked
        and not told
        and (not begun or (not done and not (lexicon.COMMANDS | {"do", "be"}).isdisjoint(words[:-1])))
    )


_SETTINGS = tuple(
    tuple(lead.split())
    for lead in ("as part of", "according to", "per", "as per", "following", "at the request of", "on behalf of",
                 "in the name of", "for", "in", "during", "at", "on", "out of", "by order of", "by request of",
                 "at the wish of", "in line with", "in accordance with", "in honor of", "in honour of",
                 "on the occasion of",
                 *(f"as {said} {by}" for said in ("agreed", "discussed", "requested", "promised", "planned",
                   "announced", "ordered", "mentioned", "explained", "instructed", "described", "specified", "stated",
                   "wished", "desired", "told", "asked", "usual", "is usual", "is tradition", "is custom")
                   for by in ("in", "on", "by", "at", "with", "during", "for", "from")))
)  # fmt: skip
"""What a setting begins with."""
_TOOLS = listed(
    "arm gripper hand hands fingers claw skills permission leave precision care strength charm talent grace expertise"
)
_SET = (
    _OCCASIONS
    | harmless.PEOPLE
    | harmless.NAMES
    | harmless.FINE
    | listed(
        "the a an my our your his her their this that these today tonight 's of for on in with by from next whole "
        "little new open house usual own great live annual famous"
    )
)


_FOR_WHOM = tuple(
    tuple(lead.split())
    for lead in ("as part of", "on behalf of", "in the name of", "in line with", "in honor of", "in honour of",
                 "in memory of", "on the occasion of", "in preparation for", "in preparation of", "in view of",
                 "in the context of", "in the course of", "in the framework of", "for the purpose of",
                 "for the sake of", "for purposes of", "with a view to", "at the request of", "by order of",
                 "by request of")
)  # fmt: skip
"""Behind these no place is told, so that they may be called as one likes."""
_SPOKEN_OF = listed("it them that this these those each other")
"""By themselves these stand for blocks: "in line with it"."""


def _for_them(word: str) -> bool:
    return word in ("'s", "display", "exhibit") or (word.isalpha() and not may_tell(word))


def on_behalf(words: Sequence[str]) -> int:
    """How many of the first words lead to whom or what it is done for: "in honor of (the queen)"."""
    return max((len(lead) for lead in _FOR_WHOM if tuple(words[: len(lead)]) == lead), default=0)


def set_in(words: Sequence[str]) -> int:
    """How many of the first words are a setting that nothing hangs on: "as part of the demonstration", "according to
    the manual", "using your arm", "on behalf of the whole class"."""
    whom = on_behalf(words)
    behind = next((n for n in range(whom, len(words)) if words[n] in (",", ":")), len(words)) if whom else 0
    if not _SPOKEN_OF.issuperset(words[whom:behind]) and all(map(_for_them, words[whom:behind])):
        return behind
    if words[:1] in (["with"], ["using"]):
        at = 1
        while at < len(words) and words[at] in listed(
            "your the my usual robot robotic one own mechanical great strong magic clever nimble skilled skilful "
            "steady two"
        ):
            at += 1
        return at + 1 if at > 1 and at < len(words) and words[at] in _TOOLS else 0
    at = max((len(lead) for lead in _SETTINGS if tuple(words[: len(lead)]) == lead), default=0)
    named = end = at
    while at and end < len(words) and words[end] in _SET:
        end += 1
        named = end if words[end - 1] in _OCCASIONS | harmless.PEOPLE | harmless.NAMES else named
    return named if named > at else 0


_TOLD = _TELLING | listed(
    "requested asked stipulates stipulate mandates mandate calls call dictated declared decreed ruled instructs "
    "instruct directs commands command orders ordered announced announces explains explained told has have had been "
    "see let known noted heard it'd essential vital necessary done pass win finished complete completed fulfilled "
    "passed won"
)
_IN_WHICH = listed("the a an my our your this for of at in 's its by")
_SUCCESS = listed(
    "pass passes passed succeed succeeds succeeded success successful win wins won victory accomplished complete "
    "completed completes finished fulfilled solved accepted approved points point score reward rewarded credit happy "
    "satisfied correct valid right met achieved granted good okay ok marks awarded prize given"
)
_SUCCEEDING = (
    _SUCCESS
    | _WHO
    | _IN_WHICH
    | listed(
        "we you it this that result solution attempt run trial test task mission game episode round experiment check "
        "exercise challenge condition criterion criteria goal is are be will get gets got receive receives earn earns "
        "full only considered counted count counts as deemed called regarded judged marked rated exactly just then job "
        "picture scene would all so very really more"
    )
)
_WHENEVER = (("if", "and", "only", "if"), ("as", "soon", "as"), ("provided", "that"), ("when",), ("if",), ("once",),
             ("provided",), ("as", "long", "as"), ("whenever",), ("iff",))  # fmt: skip


def state_behind(words: Sequence[str]) -> int:
    """How many of the first words lead in how it has to be, "the customer insists that (red is ...)", "we pass if"."""
    for at in range(1, min(_MOST, len(words) - 3)):
        long = max((len(when) for when in _WHENEVER if tuple(words[at : at + len(when)]) == when), default=0)
        if long and all(word in _SUCCEEDING for word in words[:at]) and not _SUCCESS.isdisjoint(words[:at]):
            return at + long
    end = next((n for n, word in enumerate(words[: _MOST + 1]) if word in ("that", ":", "=") and n), 0)
    said = words[:end]
    whose = _TELLERS | _WHO | _IN_WHICH | _GLADLY
    known = all(word in _TOLD or word in whose or _strange_noun(said, n) for n, word in enumerate(said))
    return end + 1 if end and known and not _TOLD.isdisjoint(said) and end + 3 < len(words) else 0


def _strange_noun(words: Sequence[str], n: int) -> bool:
    """ "The (contract) says": who or what says it may be called as one likes."""
    return n == 1 and words[0] in _IN_WHICH and is_strange(words[n]) and len(words) > 2


_MEDIA = listed(
    "photo photograph picture image drawing painting sketch postcard poster brochure catalog catalogue book cover page "
    "card screen slide video film shot scene plan sheet worksheet flyer leaflet magazine website exhibit "
    "illustration design poster arrangement diagram cartoon snapshot blueprint logo painting mind head vision"
)
_WISHING = listed(
    "want wants wanted need needs needed like dream dreams dreaming dreamt dreamed imagine imagining think thinking "
    "hope hoping wish wishes wishing ask asks asking calls order orders ordered request requests requested require "
    "requires demand demands love crave waiting mood longing eager keen"
)
_SHOWING = _MEDIA | _WISHING | _WHO | _IN_WHICH | _GLADLY | listed(
    "show shows showing shown depicts depict displays see sees looks there on to has have had what all will would 'd "
    "must should shall is be are i'd next final closing last desk wall fridge today now here winning always really so "
    "much am been 'm 've 's us me them him her get something build out front with make small little nice quick"
)  # fmt: skip
_SHOWN = listed(
    "shows show showing depicts displays of is are see sees has want wants need needs like love for imagine : with "
    "wanted needed ordered requested requests orders asks requires demands have"
)  # fmt: skip
_ARTICLES = listed("a an one") | frozenset(lexicon.NUMBER)


_TOGETHER = listed("i we waiting see")
"""With these all people are not told to have one each."""


def _place_of_it(words: Sequence[str], n: int) -> bool:
    """ "(The poster in the) hall", "(our) mascot (needs)"."""
    if not n or not is_strange(words[n]) or words[n - 1] not in _IN_WHICH:
        return False
    named = n == 1 and (words[2:3] == ["i"] or not (_MEDIA | _WISHING).isdisjoint(words[2:3]))
    return named or (n > 2 and not _MEDIA.isdisjoint(words[:n]))


def thing_behind(words: Sequence[str]) -> int:
    """How many of the first words lead in what is to be there: "the brochure has a photo of (a tower ...)"."""
    found = 0
    for at in range(2, min(_MOST, len(words) - 2)):
        ahead = words[:at]
        if any(word not in _SHOWING and not _place_of_it(words, n) for n, word in enumerate(ahead)):
            break
        medium, wished = not _MEDIA.isdisjoint(ahead), not _WISHING.isdisjoint(ahead)
        last = "last" not in ahead or words[ahead.index("last") + 1] in _MEDIA
        each = "all" in ahead[1:] or (ahead[0] in ("all", "everybody", "everyone") and _TOGETHER.isdisjoint(ahead))
        if words[at] in _ARTICLES and words[at - 1] in _SHOWN and (medium or wished) and last and not each:
            found = at if words[at + 1] not in _MEDIA else found
    return found
