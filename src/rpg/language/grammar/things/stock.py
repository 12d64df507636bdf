"""What there is, told at length: "you will find ...", "letters in play: ...", "5 cm cubes", "two cubes show A, B"."""

from __future__ import annotations

from rpg.language.grammar.core import Parser, Results, choice, rule
from rpg.language.grammar.talk.people import PEOPLE
from rpg.language.grammar.talk.slots import Patterns
from rpg.language.grammar.things import amounts
from rpg.language.grammar.things.adjectives import color
from rpg.language.grammar.things.amounts import length
from rpg.language.grammar.things.inventory import contents, given
from rpg.language.grammar.things.joined import ARE
from rpg.language.grammar.things.labels import label_list
from rpg.language.grammar.things.nouns import noun_phrase, simple
from rpg.language.grammar.things.ones import begins_with_ones
from rpg.language.grammar.things.theirs import THEIRS
from rpg.language.meaning import Amount, Clause, Coord, Meaning, Noun, Traits, replace

_HEADED = Patterns(
    "the|our|my|your|these|all|the_only|available|the_available|given|the_given|usable? "
    "letter|number|digit|symbol|color? letters|digits|numbers|blocks|cubes|symbols|pieces|bricks|colors|set|"
    "inventory|objects|assets|pool|items|material|materials|available|given|equipment|stock|supply|kit|parts|resources|"
    "things only? "
    "in_play|given|available|provided|to_use|used|here|on_the_table|at_hand|you_have|we_have|i_have|you_get|you_need|"
    "to_be_used|to_work_with|involved|present|in_use|for_this|for_it|in_the_scene|needed? are|is|=? :|,|-?",
    "here_is|this_is|that_is|these_are|here_are? what|all i|we|you|they|the_robot have|have_got|got|get|need|use|"
    "are_given|"
    "can_use|may_use are|is? :|,|-?",
    "here|below is|are|comes|come the|our|a? list|inventory|blocks|cubes|set|colors|letters :|-",
)
"""What stands before a list of what there is."""
_THERE = Patterns(
    "i|we|you|they only|just|also|always? have|use|get|see|find|got|have_got|will_find|will_see|will_get|will_have|"
    "can_use|can_see|are_given|may_use|are_using|shall_use|should_use|must_use|will_use|are_going_to_use "
    "today|here|now|available|before_you|in_front_of_you|at_hand|on_the_table? only|just|exactly?",
    "on_the_table|in_the_scene|in_the_box|in_the_picture|before_you|in_front_of_you|here|lying_on_the_table "
    "there|you|we|i? are|is|lie|lies|have|will_find|find|see|will_see|can_be_found|can_find|stand only|just|exactly?",
    "the|this|your|our task|set|kit|box|puzzle|game|inventory|scene|table|workspace|exercise|heap|pile "
    "also|too|now? contains|has|holds|includes|consists_of|comes_with|offers|uses|needs only|exactly|just|also?",
    "it gives|it_has|there_exist|there_exists only|just?",
    f"my|our|your|the|this|a little|small|younger|older|dear? {PEOPLE}|boy|girl|robot|neighbor "
    "has|have|has_got|have_got|got|owns|own|gets|brought|found|received|is_given|was_given|are_given|picked|took "
    "only|just|exactly|also?",
    "he|she|they|somebody|someone has|have|has_got|got|owns|gets|brought|is_given|was_given only|just|exactly|also?",
)
"""What says that there is what follows."""
_TODAY = ("today", "altogether", "in total", "in all", "here", "now", "on the table", "in the scene", "available")
_IN_ALL = ("in all", "in total", "altogether", "all in all", "overall")
"""Behind a number of blocks these tell that there are no more: "(each on) a gray block, three gray blocks in all"."""
_SET_OFF = frozenset({",", ";", "("})
_SHOW = frozenset({"say", "carry", "carries", "bear", "bears", "show", "shows", "display", "displays", "have", "has"})
_KINDS = {"letters": "letter", "letter": "letter", "numbers": "digit", "number": "digit", "digits": "digit",
          "digit": "digit", "symbols": "symbol", "symbol": "symbol"}  # fmt: skip


@rule
def stock(p: Parser, i: int) -> Results[Clause]:
    """What there is, and how large all of it is."""
    lead = 0
    for start in _HEADED.matches(p, i):
        if p.words[start - 1] in (":", ",", "-", "are", "is", "="):
            lead = start
            yield from _listed(p, i, start)
    for start in _THERE.matches(p, i):
        lead = start
        for theme, told, j in contents(p, start, True):
            end = p.any_of(j, _TODAY) or j
            yield replace(given(p, i, end, theme, told, 1), lemma="stock"), end
        for listed, j in noun_phrase(p, start):
            whole = (j >= p.end or p.words[j] == ":") and _several(listed) and mere_looks(listed)
            if whole or (isinstance(listed, Noun) and _named(listed) and len(listed.traits.labels) > 1):
                yield replace(given(p, i, j, listed, (), 1), lemma="stock"), j
            if (
                isinstance(listed, Coord)
                and listed.op == "and"
                and not listed.cost
                and (all(map(_counted, listed.items)) or all(map(_named, listed.items)))
            ):
                yield replace(given(p, i, j, listed, (), 1), lemma="stock"), j
    if i == 0 or p.follows(i, (":",)):
        for listed, j in noun_phrase(p, i):
            if j == p.end and _several(listed) and (mere_looks(listed) or all(map(_counted, _items(listed)))):
                yield replace(given(p, i, j, listed, (), 3), lemma="stock"), j
    if i == 0 or p.follows(i, _SET_OFF):
        for listed, j in simple(p, i):
            end = p.any_of(j, _IN_ALL) if _counted(listed) else 0
            again = isinstance(listed, Noun) and not {*listed.traits.colors}.isdisjoint(p.words[:i])
            if end and again and isinstance(listed, Noun) and listed.det in ("bare", "a") and not listed.conditions:
                yield replace(given(p, i, end, listed, (), 0), lemma="stock"), end
    yield from _sized(p, i, lead or p.any_of(i, _USED))
    if lead or i == 0 or p.follows(i, (":",)):
        yield from _with_patches(p, lead or i)
    yield from _patches_listed(p, i)
    yield from _shown(p, i)
    yield from _parted(p, i)


_USED = ("use", "using", "take", "with", "we use", "you use", "there are", "we have", "you have", "i have", "from",
         "only use", "use only", "we work with")  # fmt: skip


def _named(item: Meaning) -> bool:
    """ "red", "the letters N and E", "a green patch"."""
    return (
        isinstance(item, Noun) and bool(item.traits.colors or item.traits.labels) and item.det in ("bare", "the", "a")
    )


def _counted(item: Meaning) -> bool:
    return isinstance(item, Noun) and item.amount is not None and bool(item.traits.colors)


def _items(theme: Meaning) -> tuple[Meaning, ...]:
    return theme.items if isinstance(theme, Coord) and theme.op == "and" else (theme,)


def _several(theme: Meaning) -> bool:
    return isinstance(theme, Coord) or (isinstance(theme, Noun) and len(theme.traits.colors) > 1)


def _listed(p: Parser, i: int, start: int) -> Results[Clause]:
    joined = 2 * p.follows(i, ("and", "or"))  # "group letters and digits: A, B, 1, 2"
    for theme, told, j in contents(p, start):
        yield given(p, i, j, theme, told, 1 + joined), j
    for named, j in noun_phrase(p, start) if p.words[start - 1] in (":", "=", "are") else ():
        if not mere_looks(named):
            continue
        if p.words[start - 1] != "are":
            yield replace(given(p, i, j, named, (), 2), lemma=""), j
        elif j >= p.end and p.words[start - 2] in _ALL_BLOCKS:
            yield given(p, i, j, replace(named, cost=0), (), 0), j


_ALL_BLOCKS = frozenset({"blocks", "cubes", "bricks", "pieces", "colors"})


def mere_looks(theme: Meaning) -> bool:
    """ "red, yellow and black", "red block, blue block": a block of each."""
    if isinstance(theme, Coord):
        return theme.op == "and" and all(map(mere_looks, theme.items))
    plain = isinstance(theme, Noun) and theme.head in ("any", "block") and theme.det == "bare" and theme.amount is None
    if not plain or not isinstance(theme, Noun) or theme.conditions or theme.part_of is not None:
        return False
    marks = theme.traits
    looks = marks.colors or marks.labels
    sized = {"size": marks.size, "edge": marks.edge}
    return bool(looks) and marks == Traits(colors=marks.colors, labels=marks.labels, **sized)  # type: ignore[arg-type]


def _with_patches(p: Parser, i: int) -> Results[Clause]:
    """ "red, green and blue blocks with red, green and blue patches", "one red block and a red patch"."""
    for blocks, j in noun_phrase(p, i):
        joint = p.any_of(j, (", with", "with", "and", ", and", "plus", ","))
        for patches, k in noun_phrase(p, joint) if joint and _told(blocks, "block") else ():
            if begins_with_ones(p, patches):
                continue
            if _head(patches) == "patch" and _told(patches, "patch") and (k >= p.end or p.words[k] in (",", ";", ":")):
                whole = Coord(op="and", items=(blocks, patches), span=p.span(i, k))
                yield replace(given(p, i, k, whole, (), 1), lemma=""), k


@choice
def _patches_listed(p: Parser, i: int) -> Results[Clause]:
    """ "patches: red and blue", "a mat for each of them in the same colour"."""
    for start in _PATCHES.matches(p, i):
        for listed, j in noun_phrase(p, start) if p.words[start - 1] in (":", ",", "-", "are", "is") else ():
            if mere_looks(listed) and (j >= p.end or p.words[j] in (";", ".")):
                yield replace(given(p, i, j, _as_patches(listed), (), 1), lemma=""), j
    for theme, j in simple(p, i) if i == 0 else ():
        if isinstance(theme, Noun) and theme.head == "patch" and theme.traits.scheme == THEIRS and j >= p.end:
            yield replace(given(p, i, j, theme, (), 1), lemma=""), j


_PATCHES = Patterns("the|our|my? patches|mats|zones|targets|spots|areas|pads available|given|colors? are|is? :|,|-?")


def _as_patches(theme: Meaning) -> Meaning:
    """The same looks, of patches."""
    if isinstance(theme, Coord):
        return replace(theme, items=tuple(map(_as_patches, theme.items)))
    return replace(theme, head="patch") if isinstance(theme, Noun) else theme


def _told(theme: Meaning, head: str) -> bool:
    """Whether it is said what these look like, or how many they are."""
    if isinstance(theme, Coord):
        return theme.op == "and" and all(_told(x, head) for x in theme.items) and _head(theme.items[-1]) == head
    plain = isinstance(theme, Noun) and theme.head in (head, "any") and theme.det in ("bare", "a")
    theirs = isinstance(theme, Noun) and head == "patch" and (theme.traits.scheme == THEIRS or theme.traits.matching)
    told = isinstance(theme, Noun) and (bool(theme.traits.colors or theme.amount) or theirs)
    return plain and told and isinstance(theme, Noun) and not theme.conditions


def _head(item: Meaning) -> str:
    if isinstance(item, Coord):
        return _head(item.items[-1])
    return item.head if isinstance(item, Noun) else ""


def _shown(p: Parser, i: int) -> Results[Clause]:
    """ "five cubes carry the letters A to E", "two red cubes show letters, X and Y": which blocks these are."""
    for theme, j in noun_phrase(p, i):
        k = p.one(j, _SHOW)
        if not k or not isinstance(theme, Noun) or theme.head != "block" or theme.part_of or theme.conditions:
            continue
        k = p.opt(k, "the")
        kind, colors = _KINDS.get(p.words[k]) if k < p.end else None, theme.traits.colors[:1]
        start = p.any_of(k + 1, _NAMELY) or k + 1 if kind else k
        for (labels, more), end in label_list(p, start, True) if kind or k > j + 1 else ():
            many = theme.amount
            if theme.traits != Traits(colors=colors) or more:
                continue
            if many is None or many == Amount(len(labels), len(labels), many.strict):
                marks = Traits(labels=labels, kind=kind if kind != "symbol" else None, colors=colors)
                them = Noun(head="block", plural=len(labels) > 1, traits=marks, span=p.span(i, end))
                yield replace(given(p, i, end, them, (), 0), lemma="stock"), end


_NAMELY = (",", ":", "namely", ", namely", "on them ,", "on them :", "on them , namely")
"""What may stand between "letters" and which these are."""
_OF_BLOCKS = ("of the blocks", "of the cubes", "of our blocks", "of these blocks", "of my blocks", "of them",
              "of these", "of the bricks", "blocks", "cubes")  # fmt: skip
_REST = ("the other", "the others", "the remaining", "the rest", "the other ones", "and", "another")


def _parted(p: Parser, i: int) -> Results[Clause]:
    """ "two of the blocks are red, the other three are white": how many there are of each look."""
    items: list[Noun] = []
    at = i
    while True:
        found = _part(p, at, bool(items))
        if found is None:
            break
        item, at = found
        items.append(item)
        if len(items) > 1:
            whole = Coord(op="and", items=tuple(items), span=p.span(i, at))
            yield replace(given(p, i, at, whole, (), int("of" not in p.words[i : i + 3])), lemma="stock"), at
        at = p.any_of(p.opt(at, ",", ";"), ("and", "while", "whereas")) or p.opt(at, ",", ";")


def _part(p: Parser, i: int, later: bool) -> tuple[Noun, int] | None:
    j = (p.any_of(i, _REST) or i) if later else i
    for many, k in amounts.count(p, j):
        of = p.any_of(k, _OF_BLOCKS) or _of_so_many(p, k)
        if not of and not later:
            return None
        are = p.any_of(of or k, ARE) or (of or k if later else 0)
        for named, end in color(p, are) if are else ():
            amount, span = Amount(many, many), p.span(i, end)
            marks = Traits(colors=(named,))
            return Noun(head="block", amount=amount, plural=many > 1, traits=marks, span=span), end
    return None


def _of_so_many(p: Parser, i: int) -> int:
    """The position after "of the eight blocks"."""
    the = p.any_of(i, ("of the", "of these", "of my", "of our"))
    for _, j in amounts.count(p, the) if the else ():
        return p.one(j, ("blocks", "cubes", "bricks"))
    return 0


_SIZE_OF = (
    "block size", "cube size", "the block size", "the cube size", "edge length", "the edge length", "size",
    "the size", "blocks", "cubes", "all blocks", "all cubes", "all of them", "the size of the blocks",
    "the size of the cubes", "the edge length of the blocks", "the edge length of the cubes",
)  # fmt: skip


_HAVING = Patterns(
    "all|all_the|the|our|these|all_of_the? blocks|cubes|bricks all? have|are|measure|should_be|must_be|with|being "
    "all? a|an|the? edge|side|edge_length|side_length|size|length|sides|edges? of?",
)
_EDGES = ("edges", "edge", "sides", "wide", "long", "large", "big", "on each side", "in size", "edge length",
          "side length", "a side", "each", "in width", "tall", "high")  # fmt: skip


def _sized(p: Parser, i: int, lead: int) -> Results[Clause]:
    """ "use 5 cm cubes", "block size: 5 cm": how large all the blocks are."""
    if lead or i == 0 or p.follows(i, (",", ":", ";", "(")):
        for theme, j in simple(p, lead or i):
            marks = theme.traits if isinstance(theme, Noun) else Traits()
            sized = marks == Traits(edge=marks.edge, size=marks.size) and (marks.edge or (marks.size and lead))
            plain = isinstance(theme, Noun) and theme.head == "block" and theme.plural and theme.det == "bare"
            if isinstance(theme, Noun) and plain and sized and theme.amount is None:
                yield _size(p, i, j, theme.traits, 0 if lead else 2), p.opt(j, "only", "throughout")
    of = p.any_of(i, _SIZE_OF)
    told = {p.opt(of, ":", "=", "is", "are", ",", "measure", "measures")} if of else set()
    for start in {*told, *_HAVING.matches(p, i)}:
        for edge, j in length(p, start):
            end = p.any_of(j, _EDGES) or p.opt(j, "each")
            yield _size(p, i, end, Traits(edge=edge), int(p.words[end] != ":")), end


def _size(p: Parser, i: int, j: int, traits: Traits, cost: int) -> Clause:
    blocks = Noun(head="block", det="all", plural=True, traits=traits, span=p.span(i, j))
    return replace(given(p, i, j, blocks, (), cost), lemma="size")
