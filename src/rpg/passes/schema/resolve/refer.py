"""Which objects a noun phrase speaks of: finds them, or brings them into the task."""

from __future__ import annotations

import string
from dataclasses import replace

from rpg.core.diagnostics import Span
from rpg.passes.schema.lexicon import BIG_EDGE, MEDIUM_EDGE, SMALL_EDGE
from rpg.passes.schema.meaning import Amount, Coord, Meaning, Noun, PartOf, Pronoun, Structure, TableTop, Traits
from rpg.passes.schema.resolve.pronouns import others, pronoun
from rpg.passes.schema.resolve.world import Ref, Scene, Scope, Thing, refuse, said

EDGES = {"big": BIG_EDGE, "medium": MEDIUM_EDGE, "small": SMALL_EDGE}
VOWELS = "AEIOU"


def refer(meaning: Meaning, scene: Scene, scope: Scope) -> Ref:
    """The objects that a noun phrase stands for; remembered for pronouns."""
    match meaning:
        case Noun():
            found = _noun(meaning, scene, scope)
        case Coord():
            found = _coord(meaning, scene, scope)
        case Pronoun():
            found = pronoun(meaning, scene, scope)
        case TableTop():
            return Ref(table=True, span=meaning.span)
        case PartOf():
            found = _part(meaning, scene, scope)
        case Structure():
            from rpg.passes.schema.resolve.structures import refer_structure

            found = refer_structure(meaning, scene, scope)
        case _:
            raise refuse("misplaced", "this is no description of blocks or patches", meaning.span)
    found = replace(found, span=meaning.span)
    if not found.reciprocal:
        scene.mention(found, scope.role)
    if found.names:
        scene.last_landmark_patch = found.patch if scope.role == "landmark" else scene.last_landmark_patch
    return found


def _coord(meaning: Coord, scene: Scene, scope: Scope) -> Ref:
    if meaning.op == "except":
        return _except(meaning, scene, scope)
    parts: list[Ref] = []
    seen: list[Traits] = []
    last = meaning.items[-1]
    if (
        isinstance(last, Noun)
        and last.head == "patch"
        and all(isinstance(x, Noun) and x.head in ("patch", "any") for x in meaning.items)
    ):
        scope = replace(scope, like_patch=True)
    for item in meaning.items:
        if isinstance(item, Noun) and _repeats(item, seen, scene):
            item = replace(item, det="another", amount=item.amount or Amount(1, 1))
        if isinstance(item, Noun):
            seen.append(item.traits)
            if item.det == "each" and item.part_of is not None:
                raise refuse(
                    "ambiguous", "it is not clear what belongs to 'each'", item.span, "say it in two sentences"
                )
        parts.append(refer(item, scene, scope))
        scene.mentions.pop()
        if parts[-1].table:
            raise refuse("misplaced", "the table is no block", parts[-1].span)
    if len({part.patch for part in parts}) > 1:
        raise refuse(
            "misplaced",
            "blocks and patches are listed together here",
            meaning.span,
            "name them in clauses of their own",
        )
    names = tuple(dict.fromkeys(n for part in parts for n in part.names))
    built = tuple(b for part in parts for b in part.built)
    single = all(len(part.names) == 1 or part.listed for part in parts)
    return Ref(
        names=names,
        patch=parts[0].patch,
        built=built,
        op=meaning.op,
        parts=tuple(parts),
        plural=True,
        span=meaning.span,
        listed=single,
    )


def _repeats(item: Noun, seen: list[Traits], scene: Scene) -> bool:
    """ "red, yellow, yellow, red": the second of the same kind in a list is another block."""
    return (
        item.traits in seen
        and not item.plural
        and item.det in ("bare", "a")
        and item.amount in (None, Amount(1, 1))
        and bool(item.traits.colors)
    )


def _except(meaning: Coord, scene: Scene, scope: Scope) -> Ref:
    """ "all blocks except the red one", "the red but not the blue block"."""
    out = refer(meaning.items[-1], scene, scope)
    whole = [refer(item, scene, scope) for item in meaning.items[:-1]]
    del scene.mentions[-len(meaning.items) :]
    names = tuple(dict.fromkeys(n for part in whole for n in part.names if n not in out.names))
    if not names:
        raise refuse("no-referent", "no block is left to speak of", meaning.span)
    return Ref(
        names=names, patch=whole[0].patch, op="except", parts=(Ref(names=names), out), plural=True, span=meaning.span
    )


def _part(meaning: PartOf, scene: Scene, scope: Scope) -> Ref:
    whole = refer(meaning.whole, scene, scope) if meaning.whole else None
    if whole is None:
        raise refuse("no-referent", "it is not clear of what this is a part", meaning.span)
    return replace(whole, part=meaning.part)


def _noun(noun: Noun, scene: Scene, scope: Scope) -> Ref:
    if noun.part_of is not None:
        return _partitive(noun, scene, scope)
    if noun.traits.extra:
        return _extras(noun, scene, scope)
    if noun.traits.rank:
        from rpg.passes.schema.resolve.ranks import ranked

        return ranked(noun, scene, scope)
    patch = _is_patch(noun, scene, scope)
    if patch and noun.traits.matching:
        return Ref(patch=True, matching=True, plural=noun.plural, det=noun.det)
    if noun.det in ("other",) or (noun.det == "another" and noun.amount is None):
        return others(noun, scene, scope, patch)
    if len(noun.traits.labels) > 1 or (len(noun.traits.colors) > 1 and not noun.traits.either):
        return _listed(noun, scene, scope, patch)
    if noun.det == "no" and noun.traits == Traits() and noun.head == "block":
        return Ref(
            names=tuple(t.name for t in scene.blocks() if not t.extra),
            quant=Amount(0, 0, True),
            plural=True,
            everything=True,
        )
    if noun.traits.either:
        return _alternatives(noun, scene, scope, patch)
    names = _counted_among(noun, scene, patch) or select(noun, scene, scope, patch)
    found = Ref(names=names, patch=patch, det=noun.det, plural=noun.plural or len(names) > 1, each=noun.det == "each")
    found = _quantified(found, noun)
    _conditions(noun, found, scene)
    return found


def _counted_among(noun: Noun, scene: Scene, patch: bool) -> tuple[str, ...]:
    """ "at most one white block" counts all the white blocks there are."""
    amount = noun.amount
    if amount is None or not amount.strict or noun.det not in ("bare", "some"):
        return ()
    there = [t for t in matching(noun.traits, scene, patch) if t.declared]
    if amount.low == 0 and len(there) <= (amount.high or 0):
        raise refuse(
            "ambiguous",
            "it is not said how many such blocks there are",
            noun.span,
            "say for example 'at most one of the three white blocks'",
        )
    return tuple(t.name for t in there) if len(there) > amount.low else ()


def _is_patch(noun: Noun, scene: Scene, scope: Scope) -> bool:
    if noun.head == "any":
        if scope.like_patch and noun.traits.colors:
            pool = [t for t in scene.things.values() if t.color in noun.traits.colors]
            return all(t.patch for t in pool) if pool else True
        return scope.like_patch
    return noun.head == "patch"


def _quantified(found: Ref, noun: Noun) -> Ref:
    """Which part of the names is meant: none, any, at least two ..."""
    if noun.det == "no":
        return replace(found, quant=Amount(0, 0, True))
    if noun.det == "any":
        return replace(found, quant=Amount(1, None, True))
    if noun.amount is not None and noun.amount.strict and noun.det != "the":
        return replace(found, quant=noun.amount)
    return found


def _partitive(noun: Noun, scene: Scene, scope: Scope) -> Ref:
    """ "two of the four red blocks", "none of them"."""
    whole = refer(noun.part_of, scene, scope) if noun.part_of else Ref()
    scene.mentions.pop()
    amount = noun.amount
    if noun.det in ("all", "each", "both"):
        return replace(whole, each=noun.det == "each", quant=None)
    if noun.det == "no":
        return replace(whole, quant=Amount(0, 0, True))
    if noun.det == "any" and scene.speaks_of_rest and noun.amount == Amount(1, 1):
        return _some_of(whole, 1, noun, scene)
    if noun.det == "any":
        amount = noun.amount or Amount(1, None, True)
        return replace(whole, quant=Amount(amount.low, amount.high, True))
    if amount is None:
        return whole
    high = amount.high
    if high == -1:
        return replace(whole, quant=Amount(amount.low, len(whole.names) - 1, True))
    if high is not None and amount.low > len(whole.names):
        count = len(whole.names)
        raise refuse(
            "too-many-asked",
            f"{amount.low} are asked for, but there are only {count}",
            noun.span,
            f"ask for at most {count}",
            asked=amount.low,
            there=count,
        )
    if scene.speaks_of_rest and not amount.strict and high is not None:
        return _some_of(whole, amount.low, noun, scene)
    if scene.speaks_of_rest and amount.low == high and high is not None and high < len(whole.names):
        return _some_of(whole, amount.low, noun, scene)
    return replace(whole, quant=Amount(amount.low, amount.high, True))


def _some_of(whole: Ref, count: int, noun: Noun, scene: Scene) -> Ref:
    """So many of several look-alikes, told apart from "the others" that are spoken of elsewhere."""
    free = [n for n in whole.names if n not in scene.parted]
    things = [scene.things[n] for n in free]
    if not _alike(things) and any(t.color or t.label for t in things):
        raise refuse(
            "ambiguous",
            f"it is not said which of {len(free)} different blocks are meant",
            noun.span,
            "name the blocks",
            blocks=len(free),
        )
    if len(free) < count:
        raise refuse(
            "too-many-asked",
            f"{count} are asked for, but only {len(free)} are left",
            noun.span,
            f"ask for at most {len(free)}",
            asked=count,
            there=len(free),
        )
    for thing in things:
        thing.scheme = thing.scheme or "same"
    scene.parted.update(free[:count])
    scene.whole = whole.names
    return Ref(names=tuple(free[:count]), plural=count > 1)


def _extras(noun: Noun, scene: Scene, scope: Scope) -> Ref:
    """Distractors: as many as are said, of the colours or labels listed."""
    labels, colors = noun.traits.labels, noun.traits.colors
    count = noun.amount.low if noun.amount else len(labels) or len(colors) or (2 if noun.plural else 1)
    scene.new_batch()
    names = []
    for index in range(max(count, len(labels), len(colors))):
        color = (colors[index % len(colors)],) if colors else ()
        label = (labels[index % len(labels)],) if labels else ()
        thing = create(replace(noun.traits, labels=label, colors=color), scene, False)
        thing.extra = True
        names.append(thing.name)
    return Ref(names=tuple(names), det=noun.det, plural=len(names) > 1)


def _listed(noun: Noun, scene: Scene, scope: Scope, patch: bool) -> Ref:
    """ "blocks A, B and C"; "red, green and blue blocks": one phrase per member."""
    count = noun.amount.low if noun.amount else None
    labels = noun.traits.labels
    if noun.traits.open_ended:
        labels = continued(labels, count or scope.need)
    key, values = ("labels", labels) if len(labels) > 1 else ("colors", noun.traits.colors)
    shares = _shares(noun, scope, len(values), count)
    names: list[str] = []
    for value, share in zip(values, shares, strict=True):
        traits = replace(noun.traits, **{"colors": (), "labels": (), "open_ended": False, key: (value,)})
        have = matching(replace(traits, scheme=None), scene, patch)
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
    return _quantified(found, replace(noun, amount=None) if noun.det not in ("no", "any") else noun)


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
        each = scope.need_each if scope.need_each > 1 and not noun.traits.labels else None
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


def _alternatives(noun: Noun, scene: Scene, scope: Scope, patch: bool) -> Ref:
    parts = []
    for color in noun.traits.colors:
        one = replace(
            noun, traits=replace(noun.traits, colors=(color,), either=False), plural=noun.plural and noun.head != "any"
        )
        parts.append(Ref(names=select(one, scene, scope, patch), patch=patch, span=noun.span))
    names = tuple(n for part in parts for n in part.names)
    return Ref(names=names, patch=patch, op="or", parts=tuple(parts), plural=True)


def _fits(thing: Thing, traits: Traits) -> bool:
    """Whether everything that `traits` says is known to hold of `thing`."""
    if traits.colors and thing.color not in traits.colors:
        return False
    if traits.labels and thing.label not in traits.labels:
        return False
    if traits.kind and not _kind_fits(thing, traits.kind):
        return False
    if traits.quality and not quality_fits(thing, traits.quality):
        return False
    if traits.size and thing.size != traits.size:
        return False
    if traits.edge and thing.edge != traits.edge:
        return False
    if traits.long and not thing.long:
        return False
    return not (traits.shape and thing.patch and thing.shape != traits.shape)


def _kind_fits(thing: Thing, kind: str) -> bool:
    if kind == "plain":
        return thing.kind is None
    if kind == "symbol":
        return thing.kind is not None
    return thing.kind == kind


def quality_fits(thing: Thing, quality: str) -> bool:
    """Vowel, consonant, even, odd."""
    label = thing.label or ""
    match quality:
        case "vowel":
            return label != "" and label in VOWELS
        case "consonant":
            return label != "" and label in string.ascii_uppercase and label not in VOWELS
        case "even":
            return label in "02468" and label != ""
        case _:
            return label in "13579" and label != ""


def matching(traits: Traits, scene: Scene, patch: bool) -> list[Thing]:
    """The objects that a description fits, distractors left out."""
    return [t for t in scene.things.values() if t.patch == patch and not t.extra and _fits(t, traits)]


def create(traits: Traits, scene: Scene, patch: bool) -> Thing:
    """Bring an object into the task."""
    label = traits.labels[0] if traits.labels else None
    kind = _kind_of(label) if label else (traits.kind if traits.kind != "plain" else None)
    if traits.quality and not kind:
        kind = "digit" if traits.quality in ("even", "odd") else "letter"
    return scene.fresh(
        patch=patch, color=traits.colors[0] if traits.colors else None, label=label, kind=kind, quality=traits.quality,
        edge=traits.edge if not patch else None, size=traits.size, shape=traits.shape if patch else None,
        long=traits.long,
        extent=(traits.edge, traits.edge) if patch and traits.edge else None, scheme=traits.scheme,
    )  # fmt: skip


def _kind_of(label: str) -> str:
    if label in string.ascii_uppercase:
        return "letter"
    return "digit" if label in string.digits else "symbol"


def select(noun: Noun, scene: Scene, scope: Scope, patch: bool) -> tuple[str, ...]:
    """The names that a plain description (one colour, at most one label) stands for."""
    found = matching(noun.traits, scene, patch)
    if scope.pool and not patch:
        inside = [t for t in found if t.name in scope.pool]
        found = inside or found
    if (
        noun.traits.scheme in ("same", "different")
        and found
        and noun.det in ("the", "bare", "all")
        and noun.amount is None
    ):
        colors = {t.color for t in found}
        if None in colors or len(colors) != (1 if noun.traits.scheme == "same" else len(found)):
            raise refuse("ambiguous", "it is not clear which of the blocks are meant", noun.span, "name their colours")
    amount = noun.amount
    indefinite = noun.det in ("a", "some", "another") or (noun.det == "bare" and amount is not None)
    if noun.det in ("any", "no", "bare", "some") and amount is None and (noun.plural or noun.det in ("any", "no")):
        indefinite = not found
    if scope.given and not scope.start:
        indefinite = indefinite or noun.det == "bare"
    if indefinite:
        return _indefinite(noun, found, scene, scope, patch)
    return _definite(noun, found, scene, scope, patch)


def _indefinite(noun: Noun, found: list[Thing], scene: Scene, scope: Scope, patch: bool) -> tuple[str, ...]:
    count = wanted(noun, scene, scope, patch)
    free = [t for t in found if t.name not in scene.used and (t.declared or t.name in scope.pool)]
    if (
        noun.det == "another"
        and scene.parted
        and (left := [t for t in found if t.declared and t.name not in scene.parted | scene.used])
    ):
        scene.parted.add(left[0].name)
        return (left[0].name,)
    if noun.det != "another" and not scope.given and len(free) >= count:
        chosen = free[:count]
        if len(free) > count and not _alike(free):
            raise refuse(
                "ambiguous",
                f"{count} of {len(free)} different blocks are meant, but not which",
                noun.span,
                "name their colours, or say 'any'",
            )
    elif claimed := _claim(noun, scene, scope, patch, count):
        chosen = claimed
    else:
        scene.new_batch()
        chosen = elastic([create(noun.traits, scene, patch) for _ in range(count)], noun, patch)
        for thing in chosen:
            thing.declared = scope.given
    if not scope.given:
        scene.used.update(t.name for t in chosen)
    return tuple(t.name for t in chosen)


def _alike(things: list[Thing]) -> bool:
    looks = {(t.color, t.label, t.kind, t.size, t.edge, t.shape) for t in things}
    return len(looks) == 1 and (things[0].color is not None or things[0].label is not None)


def _claim(noun: Noun, scene: Scene, scope: Scope, patch: bool, count: int) -> list[Thing]:
    """Members of the structure spoken of whose looks are open take on the description."""
    if patch or not scope.pool:
        return []
    open_ = [scene.things[n] for n in scope.pool if open_to(scene.things[n], noun.traits)]
    if len(open_) < count:
        return []
    for thing in open_[:count]:
        give(thing, noun.traits)
    return open_[:count]


def open_to(thing: Thing, traits: Traits) -> bool:
    """Whether an object's looks are still open to what `traits` says."""
    if thing.claims:
        return False
    if traits.colors and (thing.color is not None or thing.label is not None):
        return False
    if traits.labels and (thing.label is not None or (thing.color is not None and thing.kind is None)):
        return False
    return bool(traits.colors or traits.labels or traits.size)


def give(thing: Thing, traits: Traits) -> None:
    """Let `thing` have what `traits` says."""
    thing.claims += 1
    if traits.colors:
        thing.color = traits.colors[0]
    if traits.labels:
        thing.label = traits.labels[0]
        thing.kind = _kind_of(traits.labels[0])
    if traits.size:
        thing.size = traits.size
    if traits.edge:
        thing.edge = traits.edge
        if thing.patch:
            thing.extent = (traits.edge, traits.edge)
    if traits.long:
        thing.long = True
    if traits.shape and thing.patch:
        thing.shape = traits.shape


def _definite(noun: Noun, found: list[Thing], scene: Scene, scope: Scope, patch: bool) -> tuple[str, ...]:
    if not found and noun.head == "any" and noun.traits == Traits() and not scope.pool:
        raise refuse("no-referent", "it is not clear what this refers to", noun.span, "name the block")
    amount = noun.amount.low if noun.amount and noun.det != "a" else (2 if noun.det == "both" else None)
    single = not noun.plural and amount in (None, 1) and noun.det not in ("all", "each")
    if single:
        if len(found) == 1:
            return (found[0].name,)
        if len(found) > 1:
            return (_pick(noun, found, scene, scope).name,)
        if claimed := _claim(noun, scene, scope, patch, 1):
            return (claimed[0].name,)
        scene.new_batch()
        return (create(noun.traits, scene, patch).name,)
    if amount is not None:
        if len(found) > amount:
            raise refuse(
                "ambiguous",
                f"{amount} are spoken of, but there are {len(found)} such blocks",
                noun.span,
                "say which, or 'any'",
                asked=amount,
                there=len(found),
            )
        if len(found) < amount:
            if not found or not scope.given:
                scene.new_batch()
            found = found + [create(noun.traits, scene, patch) for _ in range(amount - len(found))]
        return tuple(t.name for t in found)
    if len(found) >= (2 if noun.plural and noun.traits.colors else 1) or (found and noun.det in ("all", "each")):
        return tuple(t.name for t in found)
    if found and not noun.plural:
        return tuple(t.name for t in found)
    count = wanted(noun, scene, scope, patch)
    scene.new_batch()
    found = found + elastic([create(noun.traits, scene, patch) for _ in range(max(0, count - len(found)))], noun, patch)
    return tuple(t.name for t in found)


def wanted(noun: Noun, scene: Scene, scope: Scope, patch: bool) -> int:
    """How many objects a phrase brings in; a default where it does not say."""
    if noun.amount is not None:
        return noun.amount.low if noun.amount.low else noun.amount.high or 1
    if not noun.plural and noun.det in ("a", "the", "bare", "another", "its"):
        return 1
    return scope.need or (3 if noun.det in ("all", "each", "any", "no", "some") else 2)


def is_open(noun: Noun) -> bool:
    """Whether a phrase leaves the number of its objects open."""
    return (
        noun.amount is None
        and not (not noun.plural and noun.det in ("a", "the", "bare", "another", "its"))
        and noun.det != "both"
    )


def elastic(things: list[Thing], noun: Noun, patch: bool) -> list[Thing]:
    """Mark new objects whose number is open."""
    if is_open(noun):
        for thing in things:
            thing.elastic = _words(noun.traits) + ("patches" if patch else "blocks")
    return things


def _words(traits: Traits) -> str:
    words = [*traits.colors, {"letter": "letter", "digit": "number"}.get(traits.kind or "", "")]
    return "".join(w + " " for w in words if w)


def _pick(noun: Noun, found: list[Thing], scene: Scene, scope: Scope) -> Thing:
    """The one of several that was spoken of last, if just one was; else the phrase is ambiguous."""
    singles = {m.ref.names[0] for m in scene.mentions if len(m.ref.names) == 1}
    recent = [t for t in found if t.name in singles]
    if len(recent) == 1 and (len(found) == 1 or not any(t.declared for t in found)):
        return recent[0]
    what = said(found[0])[4:]
    if len({(t.color, t.label, t.size) for t in found}) > 1:
        names = ", ".join(dict.fromkeys(said(t) for t in found))
        raise refuse("ambiguous", f"this could be {names}", noun.span, "name its colour or its label")
    raise refuse(
        "ambiguous",
        f"there are {len(found)} of them: it could be any {what}",
        noun.span,
        f"say 'one of the {what}s' or 'a {what}'",
    )


def _conditions(noun: Noun, found: Ref, scene: Scene) -> None:
    """ "that is on the patch": a premise about where the block stands, kept for the clause resolver."""
    for condition in noun.conditions:
        scene.premises.append(Premise(span=condition.span, names=found.names, condition=condition))


from dataclasses import dataclass  # noqa: E402


@dataclass(frozen=True, slots=True, kw_only=True)
class Premise(Meaning):
    """What a relative clause takes for granted of some objects."""

    names: tuple[str, ...]
    condition: Meaning


__all__ = ["EDGES", "Premise", "Span", "continued", "create", "give", "matching", "refer", "select"]
