"""What the noun phrases of a text stand for."""

from __future__ import annotations

from dataclasses import replace
from itertools import combinations

from rpg.language.compose.chosen import chosen
from rpg.language.compose.figures import figures_of, is_farthest
from rpg.language.compose.items import FIGURES, PARTS, SYMBOL_KINDS
from rpg.language.compose.lined import feet
from rpg.language.compose.listed import by_worth, counted_alike, symbols
from rpg.language.compose.others import one_more_block, others, take
from rpg.language.compose.parts import has_first, part, within
from rpg.language.compose.patches import patches
from rpg.language.compose.pronouns import pronoun, so_many
from rpg.language.compose.scene import TOWARD, Ref, Scene, Unclear
from rpg.language.compose.sized import is_of_blocks, of_heights, sized
from rpg.language.compose.syntax import ALL, OWN, Both, Chain, Label, Listing, Noun, Phrase, Pronoun

_HIGH = {"top": "tall", "bottom": "short"}
"""The highest of several towers is the one with the most blocks."""


def resolve(scene: Scene, phrase: Phrase) -> Ref:
    """What a phrase stands for; what it tells of for the first time is put into the scene."""
    if isinstance(phrase, Pronoun):
        return scene.mention(pronoun(scene, phrase.word))
    if isinstance(phrase, Label):
        return scene.mention(Ref("block", [_labelled(scene, phrase.label, phrase.color)]))
    if isinstance(phrase, Both):
        return _both(scene, phrase)
    if isinstance(phrase, Chain | Listing) or phrase.color == OWN:
        raise Unclear  # of whose colour is it?
    ref = pronoun(scene, "each") if phrase == Noun(det="each", noun="one") else _noun(scene, replace(phrase, but=None))
    if phrase.but is not None:
        if isinstance(phrase.but, Noun) and phrase.but.count:
            raise Unclear
        without = resolve(scene, phrase.but)
        if ref.kind != without.kind or not set(without.ids) < set(ref.ids) or ref.bound or ref.fresh:
            raise Unclear
        ref = replace(ref, ids=[n for n in ref.ids if n not in without.ids])
    return scene.mention(ref)


def _labelled(scene: Scene, label: str, color: str) -> int:
    found = [n for n, block in enumerate(scene.blocks) if block.label == label]
    if len(found) > 1:
        raise Unclear
    if not found and any(not block.color and not block.label for block in scene.blocks):
        raise Unclear  # it may be one of those of which nothing is said
    if not found and any(figure.kind == label for figure in scene.figures):
        raise Unclear  # "the T" is the one that is built
    return found[0] if found else scene.new_blocks(1, color, label)[0]


def _both(scene: Scene, phrase: Both) -> Ref:
    """Several: all of one kind, or told of one by one."""
    if phrase.either:
        return _one_of(scene, phrase)
    refs = [resolve(scene, part) for part in counted_alike(phrase.parts)]
    mixed = {ref.kind for ref in refs} == {"block", "figure"} and all(ref.fresh for ref in refs)
    if mixed and not any(ref.bound or ref.no or ref.each or ref.rest for ref in refs):
        if any(ref.kind == "block" and len(ref.ids) > 1 for ref in refs):
            raise Unclear
        scene.here = [ref for ref in scene.here if ref not in refs]
        return scene.mention(Ref("mixed", [n for ref in refs for n in feet(scene, ref)], fresh=True))
    if len({ref.kind for ref in refs}) > 1 or any(ref.bound or ref.no or ref.each for ref in refs):
        raise Unclear
    if any(isinstance(part, Label) and part.label.isdigit() for part in phrase.parts) and not all(
        isinstance(part, Label) for part in phrase.parts
    ):
        raise Unclear  # numbers of blocks, or on them
    nouns = [part for part in phrase.parts if isinstance(part, Noun) and part.noun in {"", "block"}]
    if any(part.color and not part.noun for part in nouns) and any(part.count and not part.color for part in nouns):
        raise Unclear  # "red and 3 blocks"
    if len({isinstance(part, Noun) and part.of is not None and bool(part.count) for part in phrase.parts}) > 1:
        raise Unclear  # "one of the red block and the blue block"
    ids = [n for ref in refs for n in ref.ids]
    if len(set(ids)) < len(ids):
        raise Unclear
    rest = [n for ref in refs for n in ref.rest]
    scene.here = [ref for ref in scene.here if ref not in refs]  # "it" is none of several that are told together
    fresh = all(ref.fresh for ref in refs)
    return scene.mention(Ref(refs[0].kind, ids, rest, each=phrase.no, fresh=fresh, no=phrase.no))


def _one_of(scene: Scene, phrase: Both) -> Ref:
    """One or another: "the other one" is one that is not meant."""
    figures = len(scene.figures)
    refs = [resolve(scene, part) for part in phrase.parts]
    ids = [n for ref in refs for n in ref.ids]
    new = len(scene.figures) > figures and not all(isinstance(p, Noun) and p.det == "the" for p in phrase.parts)
    unlike = len({ref.kind for ref in refs}) > 1 or len(set(ids)) < len(ids) or new
    if unlike or any(ref.bound or ref.no or ref.each for ref in refs):
        raise Unclear
    one = refs[scene.choose(len(refs))]
    scene.instead = [ref for ref in refs if ref is not one]
    if one.kind == "block":
        scene.whole, scene.taken = ids, list(one.ids)
    scene.here = [ref for ref in scene.here if ref not in refs]
    return scene.mention(replace(one, fresh=False, either=True))


def _noun(scene: Scene, noun: Noun) -> Ref:
    if {"big", "small"} & set(noun.ranks):
        if is_of_blocks(scene, noun):
            return sized(scene, noun)
        noun = of_heights(noun)
    if noun.that:
        return chosen(scene, noun, resolve)
    if noun.noun not in FIGURES | {"one", "sign"} and (
        noun.content is not None or noun.size or (noun.word and noun.noun != "patch" and noun.word != "else")
    ):
        raise Unclear
    if noun.det == "other" and noun.noun not in PARTS:
        return others(scene, noun)
    of_figure = noun.noun in PARTS or noun.ranks or noun.nth
    if by_worth(scene, noun):
        return symbols(scene, noun, resolve)
    if noun.of is None and noun.noun in SYMBOL_KINDS and of_figure:
        return part(scene, noun, resolve)
    if noun.of == Pronoun("both") and noun.ranks and noun.noun in {"one", "block"}:
        return of_two(scene, noun)
    if noun.noun == "one" and noun.det == "the" and isinstance(noun.of, Noun) and noun.ranks and noun.of.count == 2 \
            and noun.of.noun in FIGURES and not noun.many:  # fmt: skip
        return _of_figures(scene, noun, resolve(scene, noun.of).ids)
    if noun.of is not None and of_figure and noun.noun not in FIGURES - {"row", "column"}:
        return part(scene, noun, resolve)
    if noun.of is not None and noun.noun in SYMBOL_KINDS | {"sign"}:
        return symbols(scene, noun, resolve)
    if noun == Noun(noun="one") and scene.whole:
        return _some_of(scene, Noun(count=1))
    if _is_so_many(noun):
        return so_many(scene, noun)
    if noun.of is not None or noun.det == "but" or noun == Noun(count=noun.count, bound=noun.bound):
        return _some_of(scene, noun)
    if noun.noun in {"row", "layer", "column"} and noun.ranks and within(scene):
        return part(scene, noun, resolve)
    if noun.noun == "one" and noun.det in {"a", "another"} and not noun.color and scene.figures:
        return figures_of(scene, noun, resolve)
    if noun == Noun(det="another", noun="one"):
        return one_more_block(scene)
    if noun.noun == "one" and noun.color and noun.det == "the" and not noun.ranks:
        own = [n for n, f in enumerate(scene.figures) if {scene.blocks[b].color for b in f.blocks} == {noun.color}]
        like = [n for n, block in enumerate(scene.blocks) if block.color == noun.color]
        if len(own) == 1 and len(like) == len(scene.figures[own[0]].blocks):
            return Ref("figure", own)
    if noun.noun == "one" and noun.color and noun.many and not (scene.blocks or scene.patches):
        noun = replace(noun, noun="block")  # "three yellow ones in a row"
    if noun.noun == "table":
        return Ref("table", [])
    if noun.noun == "patch":
        return patches(scene, noun)
    if noun.noun in FIGURES:
        return figures_of(scene, noun, resolve)
    if noun.noun in SYMBOL_KINDS | {"sign"}:
        return symbols(scene, noun, resolve)
    if noun.noun in PARTS or (noun.ranks and noun.noun in {"block", "one"}) or (noun.nth and noun.noun == "one"):
        return _by_rank(scene, noun)
    return _blocks(scene, noun)


def _is_so_many(noun: Noun) -> bool:
    """ "The four", "those three blocks"."""
    bare = noun.count > 1 and noun == Noun(det="the", count=noun.count, near=noun.near)
    return bare or (noun.near and noun.noun == "block" and noun.of is None and not (noun.ranks or noun.nth))


def _by_rank(scene: Scene, noun: Noun) -> Ref:
    """ "the middle one", "the left end", "the taller one", "the third": a part, a figure, or the one that is left."""
    if set(noun.ranks) & {"tall", "short", "former", "latter"} or (noun.noun == "one" and noun.det == "another"):
        return figures_of(scene, noun, resolve)
    if (noun.nth or noun.ranks == ("last",)) and scene.figures and not scene.whole and has_first(scene.figures[-1]):
        return part(scene, noun, resolve)
    if noun.nth and not noun.ranks:
        if (counted := _in_turn(scene, noun)) is not None:
            return counted
        left = [n for n in scene.whole if n not in scene.taken]
        if scene.whole and noun.nth == len(scene.whole) and len(left) == 1:
            return take(scene, left)
        raise Unclear
    if noun.ranks == ("last",):
        left = [n for n in scene.whole if n not in scene.taken]
        if len(left) == 1:
            return take(scene, left)
        raise Unclear
    if not scene.figures:
        return of_two(scene, noun)
    built = [figure for figure in scene.figures if not figure.implied]
    sides = TOWARD.keys() | _HIGH.keys() if built[:1] and built[0].kind == "tower" else {"near", "far"}
    same = 1 < len(built) == len(scene.figures) and len({figure.kind for figure in built}) == 1
    if noun.noun == "one" and same and (scene.lines or noun.ranks[0] in sides):
        return _of_figures(scene, noun, [n for n, figure in enumerate(scene.figures) if figure in built])
    return part(scene, noun, resolve)


def _in_turn(scene: Scene, noun: Noun) -> Ref | None:
    """ "(Three towers of two;) the first one is on the red patch, the second on the blue one": of what looks alike."""
    towers = [figure for figure in scene.figures if figure.kind == "tower" and not figure.implied]
    looks = {tuple(scene.blocks[n].look[:2] for n in figure.blocks) for figure in towers}
    bare = replace(noun, nth=0, det="") == Noun(noun="one") and noun.det in {"the", ""}
    if bare and 1 < len(towers) == len(scene.figures) >= noun.nth and len(looks) == 1 and not scene.lines:
        return None if scene.whole or scene.facing else Ref("figure", [noun.nth - 1])
    left = [n for n in scene.whole if n not in scene.taken]
    if bare and not scene.figures and left and noun.nth == len(scene.taken) + 1 and scene.alike(scene.whole):
        return take(scene, left[:1])
    return None


def _of_figures(scene: Scene, noun: Noun, ids: list[int]) -> Ref:
    """ "the left one" of several figures that were spoken of, "the lower one of the two towers"."""
    kind = scene.figures[ids[0]].kind
    if {n for n, figure in enumerate(scene.figures) if figure.kind == kind} != set(ids):
        raise Unclear
    ranks = tuple(_HIGH.get(rank, rank) if kind == "tower" else rank for rank in noun.ranks)
    return figures_of(scene, replace(noun, noun=kind, of=None, ranks=ranks), resolve)


def of_two(scene: Scene, noun: Noun) -> Ref:
    """ "the right-hand one of the two", "the middle one": by where they are told to be."""
    if noun == Noun(det="the", noun="one", ranks=("middle",)):
        between = [fact.a for fact in scene.facts if fact.said == "between" and not fact.no]
        if len(between) != 1:
            raise Unclear
        return between[0]
    both = pronoun(scene, "both")
    if both.kind == "figure" and len(both.ids) == 2:
        if len({scene.figures[n].kind for n in both.ids}) > 1:  # "a tower and a row of two": of the blocks of the row
            rows = [n for n in both.ids if scene.figures[n].kind in {"row", "line"}]
            if len(rows) != 1 or len(scene.figures[rows[0]].blocks) != 2:
                raise Unclear
            scene.mention(Ref("figure", rows))
            return part(scene, replace(noun, of=Pronoun("it")), resolve)
        return _of_figures(scene, noun, both.ids)
    if len(both.ids) == 1:
        return part(scene, replace(noun, of=None), resolve)
    found = [n for n in both.ids if len(noun.ranks) == 1 and is_farthest(scene, n, both, noun.ranks[0])]
    if len(found) != 1 or noun.color or noun.many or noun.count or noun.nth or noun.det != "the":
        raise Unclear
    return Ref(both.kind, found)


def _some_of(scene: Scene, noun: Noun) -> Ref:
    """So many of a lot: any of those that look alike, of which nothing was said yet."""
    here = list(scene.here)
    if noun.color or noun.ranks or noun.nth or noun.content is not None:
        raise Unclear
    if noun.det == "any" and not noun.count and not noun.noun:  # "on either of them"
        noun = replace(noun, det="", count=1)
    if noun.of is None and not scene.whole:
        raise Unclear
    them = Pronoun("both") if noun.det == "both" and noun.of == Pronoun("them") else noun.of
    whole = resolve(scene, them) if them is not None else Ref("block", list(scene.whole))
    scene.here = here  # those that are meant are spoken of, not those that they are some of
    of_one = noun.of == Pronoun("them") and len(whole.ids) == 1
    if whole.kind == "figure" and (noun.noun in {"block", "one"} or of_one):
        whole = Ref("block", [n for at in whole.ids for n in scene.figures[at].blocks])
    if whole.fresh and whole.kind == "block" and scene.figures and isinstance(noun.of, Noun) and noun.of.det != "the":
        raise Unclear  # "one of two blocks" may be a figure
    ids = whole.ids
    if noun.of is None and not noun.bound and not any(scene.blocks[n].look[:2] != ("", "") for n in ids):
        raise Unclear  # "put one on the mat" of blocks of which nothing is said
    if noun.det == "all" and noun.of == Pronoun("them") and len(ids) < len(scene.blocks):
        raise Unclear
    if noun.of == Pronoun("them") and whole.kind == "block" and set(ids) < set(scene.whole):
        raise Unclear  # of these, or of those that they are some of
    if noun.det in ALL:
        if (2 if noun.det == "both" else noun.count or len(ids)) != len(ids):
            raise Unclear
        return Ref(whole.kind, ids, each=noun.det == "each", every=True)
    if noun.det == "no":
        return Ref(whole.kind, ids, no=True, each=True)
    count = len(ids) // 2 if noun.det == "half" else len(ids) - noun.count if noun.det == "but" else noun.count
    if whole.kind == "figure" and 0 < count < len(ids) and noun.bound in {"", "exactly"} and noun.det != "half":
        return _some_figures(scene, ids, count, "exactly" if noun.det == "but" else noun.bound)
    if whole.kind != "block" or count < 1 or count > len(ids) or (noun.det == "half" and len(ids) % 2):
        raise Unclear
    if noun.bound == "most" or (not scene.alike(ids) and (noun.bound == "least" or noun.det)):
        raise Unclear
    if scene.whole != ids:
        if any(n in scene.used for n in ids):
            raise Unclear  # which ones would not be clear
        scene.whole, scene.taken = list(ids), []
    left = [n for n in ids if n not in scene.taken]
    if len(left) < count or (noun.bound and scene.taken):
        raise Unclear
    chosen = left[:count]
    if not scene.alike(ids) and count < len(ids):
        if left != ids or len({scene.blocks[n].look for n in ids}) < len(ids):
            raise Unclear
        some = list(combinations(ids, count))
        chosen = list(some[scene.choose(len(some))])  # whichever of them
    if (figure := scene.figure_of(ids[0])) is not None and figure.told and not figure.implied and count < len(left):
        if count > 1:
            raise Unclear
        chosen = [left[scene.choose(len(left))]]  # each is at another place
    rest = [n for n in ids if n not in chosen] if noun.bound != "least" else []
    return replace(take(scene, chosen), rest=rest, bound=noun.bound)


def _some_figures(scene: Scene, ids: list[int], count: int, bound: str) -> Ref:
    """So many of figures that look alike, and of which nothing was said yet."""
    figures = [scene.figures[n] for n in ids]
    looks = [(block.color, block.label, block.size) for block in scene.blocks]
    kinds = {(f.kind, f.size, tuple(looks[n] for n in f.blocks)) for f in figures}
    blocks = scene.told_of("block")
    if len(kinds) > 1 or scene.told_of("figure") & set(ids) or any(blocks & set(figure.blocks) for figure in figures):
        raise Unclear
    return Ref("figure", ids[:count], ids[count:], bound=bound)


def _blocks(scene: Scene, noun: Noun) -> Ref:
    """Blocks by their colour: those that are there, or further ones."""
    like = [n for n, block in enumerate(scene.blocks) if not noun.color or block.color == noun.color]
    definite = noun.det in {"the", *ALL} or (not noun.det and not noun.count and bool(noun.color))
    many = noun.many or noun.det in ALL or noun.count > 1
    if (
        noun.content is not None
        or noun.size
        or noun.bound
        or noun.det in {"any", "no"}
        or (noun.noun == "one" and not noun.color)
        or noun.nth
        or noun.ranks
    ):
        raise Unclear
    if not like and definite and noun.det and not noun.noun:
        raise Unclear  # "the red" may be a patch
    if not like and definite and noun.noun == "one" and (scene.patches or not _told_as_block(scene)):
        raise Unclear  # the red one of what?
    if noun.noun == "one" and not definite and ((like and noun.det != "another") or not _told_as_block(scene)):
        raise Unclear
    if (
        (definite or noun.noun in {"", "one"})
        and not like
        and any(not block.color and not block.label for block in scene.blocks)
    ):
        raise Unclear  # this could be one of those of which no colour was said
    if definite and like:
        if (noun.count and noun.count != len(like)) or (not many and len(like) > 1):
            raise Unclear
        return Ref("block", like, each=noun.det == "each", every=noun.det in ALL)
    if not noun.color and (definite or (not noun.count and noun.det != "another")):
        raise Unclear
    count = noun.count or (2 if noun.det == "both" else 1)
    if many and not noun.count and noun.det != "both":
        raise Unclear
    if noun.det in {"a", ""} and (stock := _in_stock(scene, noun.color)):
        left = [n for n in stock if n not in scene.taken]
        if len(left) < count:
            raise Unclear
        if scene.whole != stock:
            scene.whole, scene.taken = list(stock), []
        return replace(take(scene, left[:count]), fresh=True)
    stocked = any(set(lot) & set(like) for lot in (*scene.stock, scene.whole))
    if noun.det == "another" and like and (stocked or not noun.color):
        left = [n for n in scene.whole if n not in scene.taken]
        if not scene.taken or not left or left[0] not in like:
            raise Unclear
        return replace(take(scene, left[:count]), fresh=True)
    if not noun.color and any(not block.color and not block.label for block in scene.blocks):
        raise Unclear
    ids = scene.new_blocks(count, noun.color)
    return Ref("block", ids, fresh=True, each=noun.det == "each", every=noun.det in ALL)


def _told_as_block(scene: Scene) -> bool:
    """Whether "a green one" is a block: what was told of last is one, not a figure."""
    told = scene.here or [ref for ref in scene.before if ref.fresh]
    lots = [set(ref.ids) for ref in told if ref.kind == "block"]
    blocks = [ref.kind == "block" or (ref.kind == "figure" and _has_no_color(scene, ref, lots)) for ref in told]
    return bool(told) and blocks[-1] and (bool(scene.here) or all(blocks))


def _has_no_color(scene: Scene, ref: Ref, lots: list[set[int]]) -> bool:
    """Whether a figure is formed by blocks that were told by themselves, or shows symbols alone."""
    own = [n for at in ref.ids for n in scene.figures[at].blocks]
    return set(own) in lots or all(scene.blocks[n].label for n in own)


def _in_stock(scene: Scene, color: str) -> list[int]:
    """The lot of such blocks that the text said there is."""
    found = [lot for lot in scene.stock if not color or scene.blocks[lot[0]].color == color]
    if len(found) > 1:
        raise Unclear
    return found[0] if found else []
