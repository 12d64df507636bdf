"""What is so at the beginning and what becomes of it: scenes told in many ways, each with the goals that it admits.

The phrasings stand in starts_told/. `[a|b|]` is a choice, `$name` one of the shared phrasings, `<1>` the first block
("the red cube"), `<1a>` the same as "a red cube", `<1b>` as "red", `<1o>` as "the red one"; `<p>`, `<q>` are patches.
A picture behind ` > ` follows upon the one before it; each trajectory begins with the scene's start.
"""

from __future__ import annotations

import re
from functools import cache
from pathlib import Path
from random import Random
from typing import Any

import yaml

from tests.corpus.composed import Composed

COLORS = ("red", "orange", "yellow", "green", "cyan", "blue", "purple", "pink", "brown", "black", "gray", "white")
SLOTS = "1234pq"
CHOICE = re.compile(r"\[([^\[\]]*)\]")
_TOLD = Path(__file__).parent / "starts_told"
JOINTS = (". ", ". ", ". ", "; ", ": ", " - ", ", ")


@cache
def _data() -> dict[str, Any]:
    files = {path.stem: yaml.safe_load(path.read_text(encoding="utf-8")) for path in sorted(_TOLD.glob("*.yaml"))}
    phrases = files.pop("phrases")
    return {"phrases": phrases, "scenes": {name: scene for scenes in files.values() for name, scene in scenes.items()}}


def composed(rng: Random) -> Composed:
    """A scene, and one of the goals that it admits, told apart or in one sentence."""
    scenes = _data()["scenes"]
    name = rng.choice(sorted(scenes))
    scene = scenes[name]
    aim = rng.choice(sorted(scene["goals"]))
    goal = scene["goals"][aim]
    named = dict(zip(SLOTS, rng.sample(COLORS, len(SLOTS)), strict=True))
    whole = goal.get("whole", [])
    if whole and ("say" not in goal or rng.random() < 0.4):
        frame = template = rng.choice(whole)
    else:
        told, wanted = rng.choice(scene["told"]), rng.choice(goal["say"])
        joint = rng.choice(JOINTS[: goal.get("joints", len(JOINTS))])
        first, second = (told, wanted) if rng.random() < 0.85 or "behind" not in scene else (wanted, told)
        frame, template = f"{told} // {wanted}", f"{first}{joint}{second}"
        if rng.random() < 0.1 and "headed" in scene:
            template = (
                rng.choice(("Start: ", "Initial state: ", "start - "))
                + told
                + rng.choice((". Goal: ", ". End: ", "; goal: "))
                + wanted
            )
    text = _finished(_filled(_chosen(template, rng), named, rng), rng)
    return Composed(f"{name}/{aim}: {frame}", text, _meaning(scene, goal, named))


def _chosen(template: str, rng: Random) -> str:
    """The template with its choices made."""
    phrases = _data()["phrases"]
    while True:
        text = re.sub(r"\$(\w+)", lambda m: f"[{phrases[m[1]]}]", template)
        text = CHOICE.sub(lambda m: rng.choice(m[1].split("|")), text)
        if text == template:
            return text
        template = text


def _filled(template: str, named: dict[str, str], rng: Random) -> str:
    """The template with blocks and patches in place of its slots."""
    noun, mat = rng.choice(("block", "cube", "cube", "block", "brick")), rng.choice(("patch", "mat", "zone", "spot"))
    short = rng.random() < 0.3

    def phrase(match: re.Match[str]) -> str:
        slot, form = match[1], match[2]
        color, what = named[slot], mat if slot in "pq" else noun
        if form == "b" or (form in "o" and short and slot in "1234"):
            return color
        article = ("an" if color[0] in "aeiou" else "a") if form == "a" else "the"
        return f"{article} {color} {'one' if form == 'o' and slot in '1234' else what}"

    text = re.sub(r"<(\w)([abo]?)>", phrase, template)
    return text.replace("@s", noun + "s").replace("@", noun)


def _finished(text: str, rng: Random) -> str:
    """Spaces, capitals and the stop at the end."""
    text = re.sub(r"\s+([.,;:])", r"\1", re.sub(r"\s+", " ", text)).strip()
    if rng.random() < 0.7:
        text = re.sub(r"(^|[.!] )([a-z])", lambda m: m[1] + m[2].upper(), text)
        return text + "."
    return text


def _meaning(scene: dict[str, Any], goal: dict[str, Any], named: dict[str, str]) -> dict[str, Any]:
    """The keys of an entry of the corpus."""
    if "refuse" in goal:
        return {"refuse": True}
    start = goal.get("start", scene["start"])

    def drawn(picture: str) -> str:
        return re.sub(r"<(\w)>", lambda m: named[m[1]], picture)

    def way(picture: str) -> list[str]:
        return [drawn(part) for part in (start, *picture.split(" > "))]

    assets = {drawn(look): count for look, count in {**scene["assets"], **goal.get("assets", {})}.items()}
    meaning: dict[str, Any] = {"assets": assets, "hold": [way(p) for p in goal["hold"]]}
    meaning["miss"] = [way(p) for p in goal["miss"]]
    if scene.get("heap"):
        meaning["heap"] = scene["heap"]
    elif "unsure" not in scene:
        meaning |= {"start": [drawn(start)], "start_miss": [drawn(p) for p in scene.get("not_start", ())]}
    return meaning
