"""Leads of those who want to find out whether it can be done, or dare: "the purpose is to check whether the arm can
(build ...)", "I bet you can't (...)"."""

from __future__ import annotations

from collections.abc import Sequence

from rpg.language import lexicon
from rpg.language.spoken_leads import LONGEST, of_words, tells_nothing
from rpg.language.tokens import Token
from rpg.language.word_lists import listed

_AGENTS = (
    *((det, who) for det in ("the", "a", "your", "our", "this")
      for who in ("robot", "arm", "agent", "policy", "model", "gripper", "system", "machine")),
    ("you",), ("we",), ("it",), ("he",), ("she",),
)  # fmt: skip
_CAN = (("can",), ("could",), ("is", "able", "to"), ("are", "able", "to"), ("manages", "to"), ("manage", "to"),
        ("knows", "how", "to"), ("know", "how", "to"))  # fmt: skip
_TRIED = listed("check test tests see find show verify evaluate examine demonstrate prove probe probes checks assess")
_EAGER = (
    "i bet you can not", "i bet you can 't", "i bet you could not", "bet you can not", "i dare you to",
    "we dare you to",
    "dare you to", "if i were you i 'd", "if i were you i would", "i 'd say we go for", "i only care that",
    "all i care about is that", "i just care that", "the main thing is that", "what matters is that",
    "whatever happens", "whatever you do", "come what may", "no need to hurry but", "no need to rush but",
    "no rush but",
    "no hurry but", "no pressure but", *(f"{may} i {ask} that" for may in ("may", "can", "could", "might")
      for ask in ("request", "ask", "suggest", "propose")), "i suggest that", "i propose that", "i would suggest that",
    *(f"{lead} the {what}" for lead in ("ignore", "never mind", "do not mind", "excuse", "forget")
      for what in ("noise", "mess", "music", "dog", "kids", "camera", "clutter", "people", "smell", "weather")),
    "i 'd rather have", "i would rather have", "i 'd rather see", "i 'd prefer to have", "i would prefer to have",
    "would it kill you to", "would it hurt to", "would it hurt you to",
    *(f"it does not {have} to be {fine} , just" for have in ("have", "need")
      for fine in ("pretty", "perfect", "fancy", "beautiful", "nice")), "so much for small talk", "enough talk",
      "enough chatter",
    "it 's about time for", "it is about time for", "it 's time for", "it is time for", "time for",
    "hear me out", "tell you what", "i tell you what", "put simply", "simply put", "not to be picky but",
    "behold the goal",
    "not to be fussy but", "not to be difficult but", "as far as i 'm concerned", "as far as i am concerned", "behold",
    "this time around", "this time round", "this time", "truth be told", "honest to god", "i challenge you to",
    *(f"i {am} no {who} but" for am in ("'m", "am") for who in ("expert", "robot", "roboticist", "engineer", "pro")),
    "correct me if i 'm wrong but", "correct me if i am wrong but",
    "hand on heart", "ideally", "hopefully", "honestly", "frankly", "seriously", "in an ideal world",
    "in a perfect world",
    "for what it 's worth", "for what it is worth", "here 's what i 'm thinking", "here is what i am thinking",
    "here 's what i want", "here is what i want", "here 's the plan", "here is the plan", "here 's the thing",
    *(f"{just}do something {easy}{like}" for just in ("just ", "so just ", "please ", "")
      for easy in ("easy ", "simple ", "nice ", "fun ", "quick ", "") for like in ("like", "such as")),
)  # fmt: skip
_DARES = tuple(tuple(said.split()) for said in _EAGER)
_SORTED = listed(
    "i we you just want need would like love wish can could please let us get have 'd the this that all it "
    "everything things stuff mess chaos sorted tidied organized organised arranged tidy cleaned neat up out done "
    "fixed set laid properly nicely neatly honestly really now today so to be a bit little here well ok okay "
    "simply only"
)


def ability(tokens: Sequence[Token]) -> int:
    """How many of the first words ask to find out whether it can be done: "the purpose is to check whether the arm can
    (build ...)"."""
    words = [token.word for token in tokens]
    for at in range(1, min(2 * LONGEST, len(words) - 4)):
        who = next((len(x) for x in _AGENTS if tuple(words[at + 1 : at + 1 + len(x)]) == x), 0)
        can = next((len(x) for x in _CAN if tuple(words[at + 1 + who : at + 1 + who + len(x)]) == x), 0)
        if words[at] in ("if", "whether", "that", "how") and who and can:
            end = at + 1 + who + can
            known = all(word == "it" or tells_nothing(word) for word in words[:at])
            tried = not _TRIED.isdisjoint(words[:at]) and known
            return end if tried and of_words(tokens[:at]) and words[end] in lexicon.COMMANDS else 0
    return 0


def dared(tokens: Sequence[Token]) -> int:
    """How many of the first words only dare to do it, or say that all should be in order: "I bet you can't (build
    ...)", "I just want the mess sorted: (...)"."""
    words = [token.word for token in tokens]
    bet = max((len(said) for said in _DARES if tuple(words[: len(said)]) == said), default=0)
    if words[bet : bet + 1] in (["'"], ["'s"]):
        return 0
    bet += bool(bet) and words[bet : bet + 1] in ([","], [":"])
    colon = words.index(":") if ":" in words else 0
    wished = colon > 3 and _SORTED.issuperset(words[:colon]) and not {"i", "we", "let"}.isdisjoint(words[:colon])
    return colon + 1 if wished and len(words) > colon + 3 else bet
