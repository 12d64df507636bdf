"""Text that is no instruction at all: empty, endless, with control characters, code, another language."""

from __future__ import annotations

import re
import unicodedata

from rpg.language import lexicon
from rpg.passes.schema.resolve.things.world import refuse

LONGEST = 1000
_CODE = re.compile(
    r"\b(?:def|import|lambda|return|SELECT|DROP|print|eval|exec|function|var|const)\b\s*[\w(*]*\s*[({;=]|</?\w+>|[{}]|;\s*$|==|\$\(|&&|\|\|"
)
_FOREIGN = re.compile(
    r"\b(?:der|die|das|und|auf|den|dem|einen|roten|bloque|rojo|sobre|encima|coloca|pon|le|les|sur|mets|rouge|vert|il|lo|sul|metti|rosso|"
    r"stapel|stapele|stelle|lege|mache|empile|empilez|apila|pila|baue|turm|tour|cubo|blok|rode|een|het|coloque|bloco)\b",
    re.IGNORECASE,
)  # fmt: skip

_FLOOR = re.compile(r"\b(?:on|onto|to|off|from) the floor\b(?! of)", re.IGNORECASE)
"""The table, or what lies below it?"""
_TWO_IN_ONE = re.compile(r"(?<![\w#(\[/.-])(?:[A-Z]\d|\d[A-CE-Z])(?![\w:)\]/-])")
"""What would be two symbols on one cube; "3D" is none, and in a heading, "T1: ...", it counts the tasks."""
_THIS = r"(?:it|this|that|these|those|they|things|everything|all)"
_SO = r"(?:true|so|right|correct|the case|a fact)"
_ASKED = re.compile(
    rf"\W*(?:(?:is|are|was|were|has|have|had|does|did) {_THIS}\b[^:.!?]*:|(?:is|was) (?:it|this) {_SO} that\b|"
    rf"(?:can|could|might|would) (?:it|this) be (?:{_SO} )?that\b|(?:can|could|might|would) [^:.!?]*? have been\b|"
    r"(?:do|did|have) (?:you|we|they) (?:see|seen|notice|noticed)\b(?! to it))",
    re.IGNORECASE,
)
"""What asks whether something is so."""
_WAS = re.compile(
    rf"\W*{_THIS} (?:once )?(?:was|were|looked|had been|had looked|used to (?:be|look))\b[^:.!?]*:", re.IGNORECASE
)
"""What tells how something was, which is no goal; nor is it told that it is so at the start."""


def guard(text: str) -> None:
    """Refuse what no grammar need look at."""
    if not text.strip():
        raise refuse(
            "empty",
            "the instruction is empty",
            None,
            "say what should be done, such as 'Put the red block on the blue block'",
        )
    if len(text) > LONGEST:
        raise refuse(
            "too-long",
            f"the instruction has {len(text)} characters; {LONGEST} is the limit",
            (LONGEST, len(text)),
            "shorten it",
            characters=len(text),
            limit=LONGEST,
        )
    for index, char in enumerate(text if not text.isprintable() else ""):
        if char not in "\n\t\r " and unicodedata.category(char) in ("Cc", "Cf", "Cs", "Co", "Cn"):
            raise refuse(
                "control-character",
                f"there is a control character (U+{ord(char):04X}) in the instruction",
                (index, index + 1),
                "leave it out",
            )
    if not any(map(str.isalpha, text)) and not re.search(r"\d", text):
        raise refuse(
            "no-words", "there are no words in this", (0, len(text)), "say what should be done with which blocks"
        )
    beyond = enumerate(text if not text.isascii() else "")
    other = next((i for i, c in beyond if c.isalpha() and not c.isascii()), None)
    if other is not None:
        raise refuse("other-language", "only English is understood here", (other, other + 1), "say it in English")
    if found := _CODE.search(text):
        raise refuse(
            "code",
            "this looks like program code, not an instruction",
            found.span(),
            "say in plain English what should be done",
        )
    foreign = _FOREIGN.findall(text)
    if len({w.lower() for w in foreign}) > 1:
        first = _FOREIGN.search(text)
        raise refuse(
            "other-language", "only English is understood here", first.span() if first else None, "say it in English"
        )
    _wish(text)
    if found := _FLOOR.search(text):
        raise refuse(
            "ambiguous",
            "this could be the table, or the floor below it, which is out of reach",
            found.span(),
            "say 'on the table'",
        )
    if found := _TWO_IN_ONE.search(text):
        raise refuse("ambiguous", f"{found.group()} could be two cubes, or one, which shows one symbol only",
                     found.span(), "name the cubes one by one, as in 'A and 1'")  # fmt: skip


def _wish(text: str) -> None:
    """Refuse "is this so: red on blue", "it was like this: red on blue"; "put ..." behind that is a wish."""
    asked, was = _ASKED.match(text), _WAS.match(text)
    found = asked or was
    told = text[found.end() :].strip() if found else ""
    first = re.match(r"\w+", told)
    if not found or (first and first.group().lower() in lexicon.COMMANDS):
        return
    says = "this is a question" if asked else "this tells how it was"
    raise refuse("no-goal", f"{says}: it asks for nothing to be done", found.span(),
                 "say how it should be, as in 'the red block should be on the blue block'")  # fmt: skip
