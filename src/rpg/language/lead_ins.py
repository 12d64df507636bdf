"""Lead-ins: what stands in front of a command or a state and says no more than that it is asked for.

"It would be so kind if you could (put ...)", "all you have to do is to (put ...)", "the customer insists that (red is
...)". Each of their words is one of wishing, asking and of who does or wants it, and they end with a word that hands on
to the task. What denies, what is over, and what would be bad has no word here.
"""

from __future__ import annotations

from collections.abc import Sequence

from rpg.language import harmless, lexicon


def _words(text: str) -> frozenset[str]:
    return frozenset(text.split())


_WHO = (harmless.PEOPLE - _words("nobody")) | _words(
    "i we you he she they it that this everything robot arm machine computer agent gripper helper policy participant "
    "subject contestant candidate human humans manipulator"
)
_SAID_WITH = _words(
    "would could can may might will shall should must is are am be 's 'd 'll 're 've been has have to need needs do does "
    "so very really most much quite just simply kindly please at all totally extremely also and now then today tonight "
    "here the a an my our your his her their this for of in with if whether as big huge great little small "
    "possible nice good lovely wonderful kind helpful grateful obliged thankful delighted happy glad pleased cool awesome "
    "marvelous marvellous fantastic brilliant perfect super dream relief help favor honor pleasure joy fine okay ok "
    "excited eager "
    "goal aim task job mission homework duty assignment turn time point idea plan thing only what challenge exercise "
    "next first order request wish purpose intention objective target "
    "ready get go ahead try attempt manage want wants wish wishes like likes love loves hope hopes ask asks asked asking "
    "beg begs begging invite invites order orders request requests require requires required tell tells told supposed "
    "expected expect meant instructed invited allowed able willing prepared know how see wonder wondering trouble bother "
    "feel free proceed remember sure make going me us him her them somebody someone anybody anyone game lesson class "
    "school work experiment scene demo show test exam up free challenged encouraged chance opportunity idea mind "
    "called morning evening promised promise day what bet dare dared week decided "
    "important necessary essential crucial vital urgent matters need "
)
_DENYING = _words("not no never nothing without too only nobody none had was were did")
"""Not but in a few turns of speech."""
_TURNS = (("the", "only", "thing"), ("was", "wondering"), ("was", "hoping"), ("was", "thinking"), ("was", "going"),
          ("were", "wondering"), ("were", "hoping"))  # fmt: skip
_HANDING_ON = _words("would could can may might will shall should must 'd 'll please to and kindly just")
_IFS = _words("if when whenever once unless until because before after while why who where which")
"""A lead-in that begins with them would be a condition, or a question."""
_BASES = frozenset(word for word, forms in lexicon.VERB.items() if any(form == "base" for _, _, form in forms))
_TELLERS = _words(
    "spec specification plan plans rule rules manual instructions instruction protocol law recipe custom tradition book "
    "card guideline guidelines exam exercise assignment task test ticket contract brief scenario requirement requirements "
    "design standard policy story score number one agreement drawing blueprint note memo paper"
)
_TELLING = _words(
    "says say said demands demand insists insist requires require states state wants want expects expect asks ask dictates "
    "dictate prescribes specifies specify hopes hope wishes wish tells writes told reads reports thinks believes begs is "
    "are it important required expected essential crucial vital necessary desired demanded agreed decided wanted prefer "
    "prefers would like be will shall must should has to have matters what point verify check confirm ensure test validate "
    "assert assume make sure condition state final end goal success termination pass passing acceptance criterion target "
    "result outcome expected desired i we you that here now please also clearly always still really so just very"
)
_MOST = 14
"""So many words at most a lead-in has."""


def command_behind(words: Sequence[str]) -> int:
    """How many of the first words lead in a command, "would it be possible to (put ...)"; 0 where they do not."""
    if not words or words[0] in _IFS:
        return 0
    for at in range(2, min(_MOST, len(words) - 2)):
        if words[at] in _BASES and words[at - 1] in _HANDING_ON and words[at + 1] not in ("to", "that", "sure"):
            return at if _leads_in(words[:at]) else 0
    return 0


def _leads_in(words: Sequence[str]) -> bool:
    who = [word for word in words if word in _WHO]
    turned = {n + k for n in range(len(words)) for turn in _TURNS if tuple(words[n : n + len(turn)]) == turn
              for k in range(len(turn))}  # fmt: skip
    known = all(
        n in turned or (word not in _DENYING and (word in _SAID_WITH or word in _WHO)) for n, word in enumerate(words)
    )
    return known and (bool(who) or words[:2] == ["what", "a"]) and (words[-1] != "and" or not _BASES.isdisjoint(words[:-1]))


def state_behind(words: Sequence[str]) -> int:
    """How many of the first words lead in how it has to be, "the customer insists that (red is ...)"."""
    end = next((n for n, word in enumerate(words[: _MOST + 1]) if word in ("that", ":", "=") and n), 0)
    said = words[:end]
    known = all(word in _TELLING | _TELLERS | _WHO | _words("the a an my our your this for of at in") for word in said)
    return end + 1 if end and known and not _TELLING.isdisjoint(said) and end + 3 < len(words) else 0
