"""What must not be, in the words of a plain denial: "is forbidden to touch" is must not touch, "touching is forbidden"
no two touch."""

from __future__ import annotations

from rpg.language import lexicon
from rpg.language.tokens import Token

_MUST = ("must", "should", "shall", "has to", "have to", "needs to", "need to")
_BARRED = ("forbidden", "prohibited", "banned", "barred")
_CONTACT = ("make contact with", "come into contact with", "be in contact with", "be in touch with", "contact")
_COLLIDE = ("collide with", "bump into", "crash into", "hit", "graze")

DENIED = {
    **{f"{must} {avoid} touching": "must not touch" for must in _MUST
       for avoid in ("avoid", "refrain from", "be kept from", "be prevented from")},
    **{f"{is_} {barred} from touching": "must not touch" for is_ in ("is", "are") for barred in _BARRED},
    **{f"{not_} {contact}": f"{not_} touch" for not_ in ("not", "never") for contact in _CONTACT},
    **{f"{not_} {collide}": "never touch" for not_ in ("not", "never") for collide in _COLLIDE},
    **{f"{must} {avoid} contact with": "must not touch" for must in _MUST for avoid in ("avoid", "have no")},
    **{f"{must} in no {way}": f"{must} not" for must in ("must", "should", "shall", "may", "can")
       for way in ("way", "case", "circumstances")},
    "had better not": "must not",
    **{f"{must} keep off": f"{must} stay off" for must in _MUST},
    **{f"{without} contact between them": "so that no two of them touch" for without in (
        "with no", "without", "without any", "and avoid", "avoiding")},
    **{f"{contact} is {barred}": "no two blocks touch" for contact in ("touching", "contact", "contact between them")
       for barred in ("not allowed", *_BARRED)},
    **{f"{not_} contact between them": "no two blocks touch" for not_ in ("avoid", "avoid any", "no")},
    **{f"do not let any two{of_them} touch": "no two blocks touch" for of_them in ("", " of them")},
    **{f"{block} is {off}": f"{block} must not be moved" for block in ("block", "cube", "one", "tower", "stack")
       for off in ("off limits", "fixed", "to be left untouched")},
    **{f"{refrain} {moving}": f"do not {move}" for refrain in ("refrain from", "abstain from")
       for moving, move in (("moving", "move"), ("touching", "touch"), ("using", "use"))},
    "budge": "move",
}  # fmt: skip
"""What people write, and what it is read as."""

BARRED = frozenset({*_BARRED, "allowed", "permitted"})
_DONE = {form: verb for form, senses in lexicon.VERB.items() for _, verb, tense in senses if tense == "ing"}
_ENDS = frozenset({".", "!", "?", ";"})


_DONE_TO = {
    "touching": "touch",
    "being": "be",
    "lying": "lie",
    "standing": "stand",
    "sitting": "sit",
    "resting": "rest",
}
HOLD_OFF = frozenset({"keep", "prevent", "stop"})
_APART = _ENDS | {",", ":", "from"}


def held_off(tokens: list[Token]) -> list[Token]:
    """ "Keep the blue ones from touching it", "prevent red from being on green": it must not."""
    words = [token.word for token in tokens]
    for at in range(len(words) - 2, 0, -1):
        if words[at] != "from" or words[at + 1] not in _DONE_TO:
            continue
        begin = next((n for n in range(at - 1, -1, -1) if words[n] in HOLD_OFF | _APART), None)
        if begin is not None and words[begin] in HOLD_OFF and begin + 1 < at and words[begin - 1] != "not":
            must = [tokens[at].saying(word) for word in ("must", "not", _DONE_TO[words[at + 1]])]
            return held_off([*tokens[:begin], *tokens[begin + 1 : at], *must, *tokens[at + 2 :]])
    return tokens


def forbidden(tokens: list[Token]) -> list[Token]:
    """ "Red is forbidden to touch it": it must not; "moving that is forbidden": do not move it."""
    words = [token.word for token in tokens]
    for at in range(len(words) - 1, 0, -1):
        if words[at] not in BARRED:
            continue
        no = words[at - 1] == "not"
        verb = at - 1 - no
        begin = max((n + 1 for n in range(verb) if words[n] in _ENDS), default=0)
        if words[verb] not in ("is", "are") or (words[at] in ("allowed", "permitted")) != no:
            continue
        ends = at + 1 == len(words) or words[at + 1] in _ENDS
        if ends and words[begin] in _DONE and words[begin + 1 : begin + 2] in (["the"], ["any"], ["a"]):
            dont = [tokens[begin].saying(word) for word in ("do", "not", _DONE[words[begin]])]
            return forbidden([*tokens[:begin], *dont, *tokens[begin + 1 : verb], *tokens[at + 1 :]])
        if words[at + 1 : at + 2] == ["to"] and words[verb - 1] != "it" and not no:
            must = [tokens[verb].saying(word) for word in ("must", "not")]
            return forbidden([*tokens[:verb], *must, *tokens[at + 2 :]])
    return tokens
