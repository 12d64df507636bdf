"""Words and equations from cubes that show symbols."""

from __future__ import annotations

import re
import string
from itertools import permutations, product

from rpg.core.diagnostics import Span
from rpg.ir import goal as g
from rpg.ir import structures as s
from rpg.ir.node import SLOPES
from rpg.language.meaning import Absolute, At, Meaning, Noun, Structure, Traits, Using, parts_of, replace
from rpg.passes.schema.resolve.clauses.spec import Spec
from rpg.passes.schema.resolve.structures.column_words import along_column, in_column
from rpg.passes.schema.resolve.structures.equation_ends import ends_told
from rpg.passes.schema.resolve.structures.extents import plain
from rpg.passes.schema.resolve.structures.letters import cubes_for
from rpg.passes.schema.resolve.things.refer import refer
from rpg.passes.schema.resolve.things.things import create
from rpg.passes.schema.resolve.things.world import Built, Ref, Scene, Scope, refuse

MAX_SEARCHED = 8
DEFAULT_WORD = "CAT"
DEFAULT_EQUATION = "2+3=5"
Made = tuple[list[Built], list[g.Goal]]


def _letters_told(spec: Spec, theme: Ref | None, scene: Scene) -> bool:
    """Whether letters are named of which a word is to be made."""
    shown = any(thing.label for thing in scene.blocks())
    given = any(isinstance(part, Noun) and part.traits.labels for use in spec.usings for part in parts_of(use))
    return shown or given or (theme is not None and any(scene.things[n].label for n in theme.names))


def word(shape: Structure, spec: Spec, theme: Ref | None, scene: Scene, scope: Scope) -> Made:
    """ "the word CAT", in a row or down a tower."""
    text = shape.letter
    if text is None:
        if shape.det != "a" or _letters_told(spec, theme, scene):
            raise refuse("ambiguous", "it is not said which word this is", shape.span, "name it: the word CAT")
        text = DEFAULT_WORD
        scene.assume(f"the word is not said: {DEFAULT_WORD}")
    text = text.replace(" ", "").replace("-", "")
    bad = [c for c in text if c not in string.ascii_uppercase + string.digits + "+-*/="]
    if not bad and len(text) == 1 and any(thing.label not in (None, text) for thing in scene.blocks()):
        raise refuse("ambiguous", "it is not said which word this is", shape.span, "name it: 'spell the word CAT'")
    if bad or len(text) < 2:
        what = f"there is no block that shows {bad[0]!r}" if bad else "a single symbol is no word"
        raise refuse(
            "unknown-symbol" if bad else "too-few", what, shape.span, "use the letters A to Z and the digits 0 to 9"
        )
    names = cubes_for(text, spec, theme, scene, shape.span)
    details = [x for into in spec.intos if isinstance(into.structure, Structure) for x in into.structure.details]
    if in_column(spec):
        return along_column(text, names, spec, shape, scene)
    over = [p for p in spec.places if getattr(p, "rel", "") == "heaped"]
    upright = _along(spec)
    if over and any(b.kind == "word" for b in scene.built):
        raise refuse("ambiguous", "the letters of each word, or one word above the other?", over[0].span,
                     "say 'each in a tower', or 'one behind the other'")  # fmt: skip
    for way in (t for t in spec.toward if t.axis == "x" or t.axis in SLOPES or t.first in ("front", "back")):
        raise refuse("misplaced", "a word is read from left to right, or down a tower", way.span, "leave this out")
    backward = spec.manner("backwards") is not None or spec.first("right", "bottom") is not None
    spec.toward = []
    spec.orders = [o for o in spec.orders if o.by not in ("any", "in_order")]
    if any(o.by == "reverse" for o in spec.orders):
        backward = True
        spec.orders = [o for o in spec.orders if o.by != "reverse"]
    _ends_agree(details, text[::-1] if backward else text)
    node = s.Spells(blocks=names, word=text, along="stack" if upright else "row", reverse=backward, span=shape.span)
    return [scene.add_built("word", names, True, shape.span, "top" if upright else "left")], [node]


def _ends_agree(details: list[Meaning], text: str) -> None:
    """ "..., S on top": what is said of an end of the word has to be so already."""
    ends = {"top": text[0], "left": text[0], "first": text[0], "bottom": text[-1], "right": text[-1]}
    for item in details:
        at_ = item.adjuncts[0] if isinstance(item, Absolute) else None
        label = item.theme.traits.labels if isinstance(item, Absolute) and isinstance(item.theme, Noun) else ()
        if not isinstance(at_, At) or at_.index is not None or len(label) != 1 or at_.side not in ends:
            raise refuse("misplaced", "this does not fit a word", item.span, "leave it out")
        if ends[at_.side] != label[0]:
            raise refuse("contradiction", f"{ends[at_.side]} is there in {text}", item.span, "leave it out")


def _along(spec: Spec) -> bool:
    """Whether the word stands upright, taken from "into a tower", "vertically", "from top to bottom"."""
    spec.manners = [m for m in spec.manners if not (m.kind == "turn" and m.value == 0.0)]
    upright = any(t.axis == "z" for t in spec.toward)
    level = next((t for t in spec.toward if t.axis == "y" or t.first in ("left", "right")), None)
    for into in list(spec.intos):
        kind = getattr(into.structure, "kind", "")
        if upright and kind in ("row", "line"):
            raise refuse("contradiction", "a row does not stand upright", into.span, "say 'in a tower'")
        if getattr(getattr(into.structure, "traits", None), "rank", None) is not None:
            raise refuse("misplaced", "it is not clear of which rows this is one", into.span,
                         "say where one word is relative to the other")  # fmt: skip
        stands, several = getattr(into.structure, "upright", None), getattr(into.structure, "plural", False)
        if several or (kind == "column" and not stands) or (kind in ("row", "line") and stands):
            raise refuse("misplaced", "a word or an equation is read along one row, or down one tower", into.span,
                         "say 'in a row' or 'in a tower'")  # fmt: skip
        if kind in ("stack", "row", "line", "column"):
            if kind in ("stack", "column"):
                upright = True
            spec.intos.remove(into)
    for place in list(spec.places):
        if getattr(place, "negated", False):
            continue
        if getattr(place, "rel", "") in ("side_by_side", "adjacent"):
            spec.places.remove(place)
        elif getattr(place, "rel", "") == "heaped":
            spec.places.remove(place)
            upright = True
    if upright and level is not None:
        raise refuse("contradiction", "what stands in a tower is not read from left to right", level.span,
                     "say 'from top to bottom', or 'in a row'")  # fmt: skip
    return upright


def equation(shape: Structure, spec: Spec, theme: Ref | None, scene: Scene, scope: Scope) -> Made:
    """ "2+3=5", "a correct equation"."""
    plain(shape)
    text = shape.letter if shape.letter and len(shape.letter) > 1 else None
    if text is not None and text[0] in "+-*/":
        return _with_result(text[0], int(text[2:]), theme, spec, shape, scene, scope)
    chosen = text or _default_equation(shape.letter)
    check_equation(chosen, shape.span)
    source = shape.members or (spec.usings.pop(0).members if spec.usings else None)
    if theme is None and source is not None and (text is None and _labelled(source)):
        theme = refer(source, scene, Scope(role="member"))
    elif source is not None:
        spec.usings.insert(0, Using(members=source, span=source.span))
    if theme is None and source is None and text is None:
        theme = _there(scene, shape.letter)
    if theme is not None and text is None and any(scene.things[n].label for n in theme.names):
        theme = with_signs(theme, shape, scene)
        check_solvable(theme.names, scene, shape.span)
        return _equation_node(theme.names, None, spec, shape, scene)
    if theme is None and text is None:
        scene.assume(f"the numbers are not said: cubes for {chosen}, any true equation of them counts")
    return _equation_node(cubes_for(chosen, spec, theme, scene, shape.span), text, spec, shape, scene)


def _with_result(
    sign: str, result: int, theme: Ref | None, spec: Spec, shape: Structure, scene: Scene, scope: Scope
) -> Made:
    """ "An addition with the result 8": of two digits that have it, which are not said. Where the same cubes make an
    equation with another result, too, it is just this one."""
    pairs = sorted(product(range(1, 10), repeat=2), key=lambda pair: (pair[0] == pair[1], abs(pair[0] - pair[1]), pair))
    sides = [f"{a}{sign}{b}" for a, b in pairs if _value(f"{a}{sign}{b}") == result and result not in (a, b)]
    if not sides or shape.members is not None or spec.usings or theme is not None:
        what = "no two digits have this result" if not sides else "it is not said which of these are on which side"
        raise refuse("bad-equation" if not sides else "ambiguous", what, shape.span, "write the whole equation")
    chosen = f"{sides[0]}={result}"
    alone = sign in "+*" and result < 10
    scene.assume(f"the numbers are not said: cubes for {chosen}")
    names = cubes_for(chosen, spec, None, scene, shape.span)
    return _equation_node(names, None if alone else chosen, spec, shape, scene)


def _there(scene: Scene, operator: str | None) -> Ref | None:
    """ "Use 2, 3, 5, + and =. Form an equation.": of the cubes that there are, where one of them shows "=".

    Where it is said what sort of equation it is, its numbers do.
    """
    found = [t for t in scene.blocks() if t.declared and t.kind in ("digit", "symbol")]
    told = any(t.label == "=" for t in found) or (operator is not None and any(t.label for t in found))
    return Ref(names=tuple(t.name for t in found)) if told else None


def with_signs(theme: Ref, shape: Structure, scene: Scene) -> Ref:
    """ "a true subtraction with 9, 4 and 5": the cubes with the signs that such an equation of these numbers takes."""
    labels = [scene.things[n].label or "" for n in theme.names]
    numbers = [label for label in labels if label.isdigit()]
    if len(numbers) < 3 or not set(labels) <= {*numbers, "=", shape.letter}:
        return theme
    said = shape.letter
    lacking: list[str] = [] if said is None or said in labels else [said] * (len(numbers) - 2)
    if said is None:
        fits = [sign for sign in "+-*/" if solvable([*numbers, *[sign] * (len(numbers) - 2), "="])]
        if len(fits) > 1:
            raise refuse("ambiguous", "it is not said with which signs", shape.span, "name them, as in 'with + and ='")
        lacking = fits * (len(numbers) - 2)
    lacking += [] if "=" in labels else ["="]
    if lacking:
        scene.assume(f"cubes for the signs: {' '.join(lacking)}")
    made = [create(Traits(labels=(sign,)), scene, False).name for sign in lacking]
    return replace(theme, names=(*theme.names, *made))


def _labelled(source: Meaning) -> bool:
    """Whether a phrase names the symbols of its cubes."""
    return any(isinstance(part, Noun) and bool(part.traits.labels) for part in parts_of(source))


def _equation_node(names: tuple[str, ...], text: str | None, spec: Spec, shape: Structure, scene: Scene) -> Made:
    upright = _along(spec)
    for way in (t for t in spec.toward if t.first == "right" or t.axis in SLOPES):
        raise refuse("misplaced", "an equation is read from left to right", way.span, "leave the direction out")
    spec.toward = []
    longer = text is not None and bool(re.search(r"\d\d", text))
    node = s.Equation(blocks=names, along="stack" if upright else "row", longer=longer, text=text, span=shape.span)
    ends = ends_told(node, spec, scene, lambda said: _same(said, text) if text else _is_true(said))
    return [scene.add_built("equation", names, True, shape.span, "left")], [node, *ends]


def _same(said: str, text: str) -> bool:
    """Whether this is the equation, with either side first."""
    return said in (text, "=".join(reversed(text.split("="))))


def _default_equation(operator: str | None) -> str:
    return {"-": "5-3=2", "*": "2*3=6", "/": "6/3=2"}.get(operator or "+", DEFAULT_EQUATION)


def check_equation(text: str, span: Span) -> None:
    """Refuse equations that are not true or not well formed."""
    sides = text.split("=")
    if len(sides) != 2 or not all(re.fullmatch(r"\d+([-+*/]\d+)*", side) for side in sides):
        raise refuse(
            "bad-equation", "this is no equation of numbers with + − × ÷ and one =", span, "say for example 2+3=5"
        )
    values = [_value(side) for side in sides]
    if values[0] is None or values[0] != values[1]:
        left = "nothing" if values[0] is None else f"{values[0]:g}"
        raise refuse(
            "false-equation",
            f"{sides[0]} is {left}, not {sides[1]}",
            span,
            f"say {sides[0]}={left}",
            left=left,
            right=sides[1],
        )


def check_solvable(names: tuple[str, ...], scene: Scene, span: Span) -> None:
    """Refuse cubes of which no true equation can be made."""
    labels = [scene.things[n].label or "" for n in names]
    if len(labels) > MAX_SEARCHED:
        return
    if len(labels) < 2:
        raise refuse("too-few", "an equation takes at least five cubes, one of them =", span, "name all its cubes")
    if solvable(labels):
        return
    raise refuse(
        "false-equation",
        f"no true equation can be made of {' '.join(labels)}",
        span,
        "choose numbers such as 2, 3 and 5 with + and =",
    )


def solvable(labels: list[str]) -> bool:
    """Whether some order of these symbols is a true equation."""
    orders = sorted(set(permutations(labels))) if len(labels) <= MAX_SEARCHED else ()
    return any(_is_true("".join(order)) for order in orders)


def _is_true(said: str) -> bool:
    sides = said.split("=")
    plain = len(sides) == 2 and all(re.fullmatch(r"\d([-+*/]\d)*", side) for side in sides)
    return plain and _value(sides[0]) == _value(sides[1]) is not None


def _value(side: str) -> float | None:
    """The value of a chain of operations, products first."""
    terms: list[float] = []
    sign = 1.0
    for piece in re.split(r"([-+])", side):
        if piece in "+-":
            sign = -1.0 if piece == "-" else 1.0
            continue
        value = None
        operator = "*"
        for part in re.split(r"([*/])", piece):
            if part in "*/":
                operator = part
            elif value is None:
                value = float(part)
            elif operator == "*":
                value *= float(part)
            elif float(part) == 0:
                return None
            else:
                value /= float(part)
        terms.append(sign * (value or 0.0))
    return sum(terms)
