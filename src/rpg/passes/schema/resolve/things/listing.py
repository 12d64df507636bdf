"""Descriptions that list colours or labels: one phrase for each of them."""

from __future__ import annotations

import string

from rpg.language.meaning import Amount, Coord, Meaning, Noun, Traits, replace
from rpg.passes.schema.resolve.things.select import select
from rpg.passes.schema.resolve.things.things import create, matching
from rpg.passes.schema.resolve.things.world import Ref, Scene, Scope, refuse


def listed(noun: Noun, scene: Scene, scope: Scope, patch: bool) -> Ref:
    """ "blocks A, B and C"; "red, green and blue blocks": one phrase per member."""
    count = noun.amount.low if noun.amount else None
    labels = noun.traits.labels
    if noun.traits.open_ended:
        labels = continued(labels, count or scope.need)
    key, values = ("labels", labels) if len(labels) > 1 else ("colors", noun.traits.colors)
    if key == "labels" and len(noun.traits.colors) > 1:
        raise refuse("ambiguous", "it is not said which of these has which colour", noun.span, "name them one by one")
    if count is None and scene.each is not None and key == "colors" and noun.plural and not patch:
        count = scene.each[0] * len(values)
    shares = _shares(noun, scope, len(values), count)
    names: list[str] = []
    for value, share in zip(values, shares, strict=True):
        bare = replace(noun.traits, labels=(), open_ended=False)
        traits = replace(bare, labels=(value,)) if key == "labels" else replace(bare, colors=(value,))
        have = matching(replace(traits, scheme=None), scene, patch)
        if count is None and any(t.declared for t in have):
            share = None
        if share is not None and share > 1:
            one = replace(noun, traits=traits, amount=Amount(share, share), plural=True, det="the" if have else "bare")
        else:
            one = replace(
                noun,
                traits=traits,
                amount=None,
                plural=noun.det == "all" and len(have) > 1,
                det="a" if noun.det == "a" else "the",
            )
        if (key == "labels" and value in [scene.things[n].label for n in names]) or (
            key == "colors" and value in [scene.things[n].color for n in names]
        ):
            names.append(create(traits, scene, patch).name)
        elif key == "colors" and noun.plural and len(have) > 1 and share in (None, 1):
            names += [t.name for t in have]
        else:
            names += [n for n in select(one, scene, scope, patch) if n not in names]
    found = Ref(
        names=tuple(names),
        patch=patch,
        det=noun.det,
        plural=True,
        each=noun.det == "each",
        listed=len(names) == len(values),
    )
    return quantified(found, replace(noun, amount=None) if noun.det not in ("no", "any") else noun)


def lot(item: Meaning, found: Ref) -> bool:
    """ "two red blocks": so many of one look, which stand side by side where the list gives the order."""
    if not isinstance(item, Noun) or item.amount is None or item.amount.low != item.amount.high or item.amount.strict:
        return False
    one = len(item.traits.colors) + len(item.traits.labels) == 1 and item.det == "bare" and item.part_of is None
    return one and found.quant is None and len(found.names) == item.amount.low


def _shares(noun: Noun, scope: Scope, values: int, count: int | None) -> list[int | None]:
    """How many blocks each listed value has."""
    total = count
    if (
        count is None
        and scope.share
        and scope.need is not None
        and scope.need > values
        and noun.plural
        and noun.traits.colors
    ):
        total = scope.need
    if total is None or total == values:
        open_ = count is None and scope.need_each > 1 and not noun.traits.labels
        each = scope.need_each if open_ else None
        return [each] * values
    if total < values or (total % values and values != 2) or noun.traits.labels:
        raise refuse(
            "count-mismatch", f"{total} are asked for, but {values} are listed", noun.span,
            f"say {values}, or say how many of each",
            asked=total, listed=values,
        )  # fmt: skip
    if total % values and count is not None:
        raise refuse(
            "count-mismatch",
            f"{total} blocks cannot be shared evenly by {values} colours",
            noun.span,
            "say how many of each",
            asked=total,
            listed=values,
        )
    return [total // values + (1 if index < total % values else 0) for index in range(values)]


def continued(labels: tuple[str, ...], count: int | None) -> tuple[str, ...]:
    """ "A, B, C..." goes on for one or two more, or to `count`."""
    row = string.ascii_uppercase if labels[0] in string.ascii_uppercase else string.digits
    start = row.find(labels[0])
    total = count or len(labels) + 1
    return tuple(row[start : start + max(total, len(labels))])


def fewer_than(amount: Amount | None) -> Amount:
    """ "no red block", "neither": none; "no two of the red blocks": one at most."""
    some = amount is not None and amount.low > 1 and (amount.high is None or not amount.strict)
    return Amount(0, amount.low - 1 if some and amount is not None else 0, True)


def quantified(found: Ref, noun: Noun) -> Ref:
    """Which part of the names is meant: none, any, at least two ..."""
    if noun.det == "no":
        return replace(found, quant=fewer_than(noun.amount))
    if noun.det == "any":
        return replace(found, quant=Amount(1, None, True))
    if noun.amount is not None and noun.amount.strict and noun.det != "the":
        return replace(found, quant=noun.amount)
    return found


def bounded(whole: Coord) -> tuple[Meaning, ...]:
    """ "exactly two red and one blue": exactly one blue; "at most" and "at least" are said of all that follow, too."""
    first = whole.items[0]
    bounds = first.amount if isinstance(first, Noun) else None
    if bounds is None or not bounds.strict or whole.op != "and":
        return whole.items
    return tuple(_bounded(item, bounds) for item in whole.items)


def _bounded(item: Meaning, bounds: Amount) -> Meaning:
    if not isinstance(item, Noun) or item.amount is None or item.amount.strict or item.det != "bare":
        return item
    low = item.amount.low if bounds.low else 0
    high = None if bounds.high is None else item.amount.high
    return replace(item, amount=Amount(low, high, strict=True))


def repeats(item: Noun, seen: list[Traits], members: bool = False) -> bool:
    """ "red, yellow, yellow, red", "the A and the other A": the second of a kind in a list is another block; and so it
    is of symbols where the list tells the members of a structure, "a row: O X O"."""
    looks = bool(item.traits.colors) or (members and item.det == "bare" and bool(item.traits.labels))
    return (
        item.traits in seen
        and not item.plural
        and item.amount in (None, Amount(1, 1))
        and ((item.det in ("bare", "a") and looks) or item.det in ("other", "another"))
        and item.traits != Traits()
    )


def one_more(noun: Noun, scene: Scene) -> Noun:
    """ "a second red block": another one, where one is there already; "the third red block" behind two of them."""
    if noun.det not in ("a", "the") or noun.part_of is not None or not (noun.traits.rank or "").isdigit():
        return noun
    if noun.det == "the" and not _next_of_its_look(noun, scene):
        return noun
    marks = replace(noun.traits, rank=None)
    if noun.head == "any" and marks == Traits():
        raise refuse("ambiguous", "it is not said what this block looks like", noun.span, "say 'a second red one'")
    if (there := len(matching(marks, scene, noun.head == "patch"))) < int(noun.traits.rank or 0) - 1:
        told = f"only {there} of these were named before"
        raise refuse("count-mismatch", told, noun.span, "say 'another'", there=there)
    return replace(noun, det="another", amount=Amount(1, 1), traits=marks)


def _next_of_its_look(noun: Noun, scene: Scene) -> bool:
    """Whether one fewer of such blocks are there, and none of them in a structure in which they could be counted."""
    marks = replace(noun.traits, rank=None)
    there = matching(marks, scene, patch=False) if marks.colors and noun.head != "patch" else []
    inside = {name for built in scene.built for name in built.members}
    free = all(not thing.declared and thing.name not in inside for thing in there)
    return len(there) == int(noun.traits.rank or 0) - 1 > 0 and free


def check_unmixed(meaning: Coord) -> None:
    """Refuse "red and blue or green", where nothing says which belong together."""
    for item in meaning.items:
        looks = item.traits if isinstance(item, Noun) and item.det == "bare" else Traits()
        other_way = len(looks.colors) > 1 and looks.either is (meaning.op == "and") and meaning.op in _BOTH_WAYS
        at_once = meaning.span[0] == meaning.items[0].span[0]  # with no "either" in front
        if other_way or (len(looks.labels) > 1 and meaning.op == "or" and at_once):
            raise refuse("ambiguous", "it is not clear what 'and' joins here, and what 'or'", meaning.span,
                         "say 'either ... or ...', or use two sentences")  # fmt: skip


_BOTH_WAYS = ("and", "or")


def all_such(item: Meaning) -> bool:
    return isinstance(item, Noun) and item.head == "any" and item.det == "all" and item.amount is None


def all_colored(item: Meaning) -> bool:
    """ "All the red ones (and all the blue ones)": told in the same way, so that neither describes the other."""
    return isinstance(item, Noun) and item.traits == Traits(colors=item.traits.colors) and bool(item.traits.colors)
