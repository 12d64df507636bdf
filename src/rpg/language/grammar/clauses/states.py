"""States: "the red block is on ...", "both blocks are blue", "the blocks form a circle"."""

from __future__ import annotations

from collections.abc import Collection

from rpg.language import lexicon
from rpg.language.grammar.clauses.absent import nothing_at_all
from rpg.language.grammar.clauses.adjuncts import adjuncts, throughout
from rpg.language.grammar.clauses.becoming import becoming, staying, touches
from rpg.language.grammar.clauses.denials import BARRED, leave, needless, stays
from rpg.language.grammar.clauses.denied_of_all import denied_of_all
from rpg.language.grammar.clauses.just_moved import just_moved
from rpg.language.grammar.clauses.keeping_away import keeps_away
from rpg.language.grammar.clauses.made import MADE, drawn, made, under
from rpg.language.grammar.clauses.manners import manner
from rpg.language.grammar.clauses.nowhere import nowhere
from rpg.language.grammar.clauses.pointing import direction
from rpg.language.grammar.clauses.put_back import lifted_off
from rpg.language.grammar.clauses.reads import reads
from rpg.language.grammar.clauses.sole import sole
from rpg.language.grammar.clauses.spelt import spell
from rpg.language.grammar.clauses.starts import STARTS, first_of_all, perhaps_first, starts_as
from rpg.language.grammar.clauses.to_be_done import to_be_done
from rpg.language.grammar.clauses.verbs import PARTICLES, ever, with_theme
from rpg.language.grammar.core import Parser, Results, rule
from rpg.language.grammar.places.sides import UTMOST
from rpg.language.grammar.structures.sizes import AS_HIGH
from rpg.language.grammar.talk.framing import past
from rpg.language.grammar.talk.slots import Patterns
from rpg.language.grammar.things.adjectives import adjectives, of_quality
from rpg.language.grammar.things.nouns import noun_phrase
from rpg.language.grammar.things.of_listed import one_of_more
from rpg.language.grammar.things.printed import colored_cubes
from rpg.language.grammar.things.retold import denied_of, none_of, one_heap
from rpg.language.meaning import (
    At,
    Clause,
    Coord,
    Manner,
    Meaning,
    Noun,
    Quality,
    Structure,
    Traits,
    Using,
    replace,
)
from rpg.language.phrases import Classes

MODALS = frozenset({
    "should", "must", "shall", "will", "would", "can", "could", "may", "might", "need", "needs", "has", "have", "ought",
    "want", "wants", "does", "do",
})  # fmt: skip
NOT = frozenset({"not", "never"})
_SWAPPED = tuple(
    f"{been}{swapped} {places}" for been in ("", "been ") for swapped in ("swapped", "traded", "changed", "exchanged",
    "switched") for places in ("places", "positions")
)  # fmt: skip
_SWAP = (
    *_SWAPPED, "be swapped", "swap", "swaps",
    *(f"{swap}{s} {places}" for swap in ("swap", "trade", "change", "exchange", "switch") for s in ("", "s")
      for places in ("places", "positions", "place", "their places", "their positions", "its place",
                    "the place", "the places", "the positions", "the position")),
)  # fmt: skip
_MOVE = frozenset({"move", "shift", "budge"})
_HAVE = frozenset({"have", "has"})
BOUND = frozenset({"goes", "go", "belongs", "belong", "comes", "come", "end", "ends", "ending", "finish", "finishes",
                    "finished", "winds", "finally", "eventually", "ultimately"})  # fmt: skip
"""Words of where things are to be, not of where they are."""
_BE = frozenset({"is", "are", "be", "being", "been", "was", "were"})
_PLACES = Classes(
    {
        "place": (
            "final|own|new|right|proper|correct|permanent|last|usual|end? "
            "place|position|spot|location|home|seat|destination|resting_place|places|positions|locations",
        ),
        "its": ("its|their|a|the|his|her",),
    }
)
_LEISURE = "party|picnic|meeting|nap|rest|break|chat|gathering|feast|sleepover|siesta|snooze|conference|reunion"
_HAS_PLACE = Patterns(
    "have|has|get|gets|find|finds|take|takes|has_found|have_found|has_got|takes_up|keeps <its> <place>",
    "'s <place> is|should_be|must_be|will_be|shall_be|has_to_be",
    f"is|are having|holding|enjoying|taking a|an|the|their|its|some? {_LEISURE}",
    "i|we|you would? want|need|like|put|place to_have|to_see|to_be|to_go|it|them?",
    classes=_PLACES,
)
"""Where something is, by the place that it has."""
_PLACE_OF = Patterns("the <place> of|for", classes=_PLACES)


@rule
def state(p: Parser, i: int, mode: str) -> Results[Meaning]:
    """ "the red block is on ...", "both blocks are blue", "the blocks form a circle", "A starts on B"."""
    inverted = p.one(i, _BE) if i else 0
    barred = p.any_of(i, BARRED)
    asked = p.one(barred or i, _ASKING) or (p.one(i, _DOES) if p.follows(i, ("that", "then")) else 0)
    if barred and not asked:
        return
    placed = max(_PLACE_OF.matches(p, i), default=0)
    for theme, j in noun_phrase(p, inverted or asked or placed or i):
        j = past(p, p.opt(j, "all", "each", "both", "then"))
        j = p.opt(j, ",") if _told_apart(p, i, j, theme) else j
        k, words = auxiliaries(p, j)
        if not _floats(theme, {*p.words[j - 1 : k]}) or one_heap(theme, p.words[j]) or _begun_anew(p, i, j, theme):
            continue
        if one_of_more(p, j, theme):
            continue
        negated = bool(words & NOT) or bool(barred)
        if inverted:
            new = 3 * (isinstance(theme, Structure) and theme.det == "a")  # "is a tower with ...": that is built
            yield from ((replace(x, cost=x.cost + new), k) for x, k in _predicate(p, i, j, theme, mode, False))
            continue
        readings = [*predicate_after_be(p, i, k, theme, mode, negated), *_subject_verb(p, i, k, theme, mode, negated)]
        readings += staying(p, i, k, theme, mode) if negated else becoming(p, i, k, theme, mode)
        for _, s in p.standing(k, STARTS):
            readings += _predicate(p, i, p.opt(s, "being"), theme, "start", negated)
            readings += starts_as(p, i, s, theme)
        for found, end in to_be_done(readings, MODALS & {*words, p.words[k]}):
            found = denied_of_all(p, j, found) if isinstance(found, Clause) else found
            lasting = lasts(words) or bool(barred)
            lasting = lasting or ("ever" in words and denied_of(theme))
            bound = (MODALS | BOUND) - (_HAVE if p.words[k] == "been" else set())  # "have been put", not "have to"
            found = perhaps_first(p, k, found, mode)
            if (
                isinstance(found, Clause)
                and found.verb == "be"
                and not {*words, p.words[k]} & bound
                and not _owed(p, k)
            ):
                found = replace(found, lemma="fact")
            idle = isinstance(found, Clause) and needless(
                words | {"not"} if getattr(theme, "det", "") == "no" else words
            )
            if idle and isinstance(found, Clause):
                found = replace(found, negated=False)
            may = words & {"may", "might"} and not asked and "either" not in p.words[j : k + 3]
            if isinstance(found, Clause) and (idle or may):
                found = leave(found, p.words[i] in ("only", "just") and not idle, p.span(j, k))
            yield (ever(nothing_at_all(found), lasting) if isinstance(found, Clause) else found), end


def _owed(p: Parser, k: int) -> bool:
    """ "is to be on it", "is supposed to stand there": how it has to be, and not how it is."""
    return any(p.words[n] == "to" and p.stands(n + 1, _TO_BE) for n in range(k + 1, min(k + 4, p.end)))


_TO_BE = frozenset({"be", *lexicon.POSTURE})


def lasts(words: Collection[str]) -> bool:
    return not {"never", "always"}.isdisjoint(words) or {"not", "ever"}.issubset(words)


def _told_apart(p: Parser, i: int, j: int, theme: Meaning) -> bool:
    """ "six blocks, three red and three white, stand ...": a comma closes what was set beside the noun."""
    return (
        isinstance(theme, Coord | Structure)
        and p.words[j : j + 1] == [","]
        and "," in p.words[i:j]
        and p.words[j + 1] in _GO_ON
    )


def _begun_anew(p: Parser, i: int, j: int, theme: Meaning) -> bool:
    """ "(then) white, and pink is on top": behind ", and" a verb for one thing speaks of the last one alone."""
    if not p.stands(j, _OF_ONE) or [",", "and"] not in (p.words[n : n + 2] for n in range(i + 1, j - 1)):
        return False
    several = len(theme.items) if isinstance(theme, Coord) else 0
    several = several or (len(theme.traits.colors) if isinstance(theme, Noun) else 0)
    return several == 2


_OF_ONE = frozenset({"is", "lies", "stands", "sits", "rests", "comes", "goes"})
_GO_ON = MODALS | _BE | lexicon.POSTURE
"""Words that only a predicate begins with."""


_ASKING = frozenset({"can", "could", "should", "may", "would", "shall", "must"})


_DOES = frozenset({"does", "do"})
"""These come first behind "only then": "only after that does the blue one go onto it"."""


_FILLERS = frozenset({
    "to", "also", "only", "all", "always", "both", "each", "ever", "end", "ends", "ended", "winds", "gets", "get", "up",
    "then", "still", "just", "simply", "finishes", "itself", "themselves",
})  # fmt: skip
_ADVERBS = frozenset({
    "all", "both", "each", "also", "still", "now", "currently", "already", "initially", "being", "originally",
    "be", "always", "then", "only", "going",
})  # fmt: skip
_UNREAL = frozenset({"if", "wish"})
"""After these "was" is no past: "it would be nice if the red block was ..."."""


def _floats(theme: Meaning, words: set[str]) -> bool:
    """Whether "both", "all" and "each" fit what they are said of: "the red block must both ..." they do not."""
    if not isinstance(theme, Noun) or not words & {"both", "all", "each"}:
        return True
    most = theme.amount.high if theme.amount is not None else None
    return (theme.plural and most != 1) and not ("both" in words and most not in (None, 2))


def _passive(p: Parser, j: int) -> bool:
    """ "should become placed": what is only the passive."""
    return p.words[j] in ("become", "becomes") and p.words[j + 1].endswith("ed") and p.words[j + 1] in lexicon.VERB


_AUXILIARY = MODALS | _FILLERS | NOT
_LASTLY = frozenset({"finally", "eventually", "ultimately"})
_ORDERED = frozenset({"first", "then", "before", "after", "next", "second", "firstly"})
"""Beside these "finally" tells a step, and not how it is in the end."""


def auxiliaries(p: Parser, j: int) -> tuple[int, set[str]]:
    words: set[str] = set()
    last = _LASTLY if p.all.isdisjoint(_ORDERED) else frozenset[str]()
    while j < p.end and (p.words[j] in _AUXILIARY or p.words[j] in last or _passive(p, j) or first_of_all(p, j)):
        if p.words[j] in words & NOT:
            break
        if p.words[j] == "up" and p.words[j - 1] not in ("end", "ends", "ended", "ending", "winds"):
            break
        if p.words[j] == "to" and p.words[j + 1] in ("the", "its", "their"):
            break
        if p.words[j] in ("end", "ends") and p.words[j + 1] != "up":
            break
        if p.words[j] == "both" and p.words[j - 1] == "up":
            break
        words.add(p.words[j])
        j = p.reach(j + 1)
    return j, words


def predicate_after_be(
    p: Parser, i: int, k: int, theme: Meaning, mode: str, negated: bool
) -> list[tuple[Meaning, int]]:
    had = k - 1 if p.follows(k, _HAVE) else k
    if end := max(_HAS_PLACE.matches(p, had), default=0):
        return list(_predicate(p, i, end, theme, mode, negated))
    if kept := list(keeps_away(p, i, k, theme, mode, negated)):
        return kept
    if j := p.one(k, _BE):
        if p.words[k] in ("was", "were") and _UNREAL.isdisjoint(p.words[:i]):
            mode = "start"
        lasting = False
        if p.seq(j, "no longer"):
            return predicate_after_be(p, i, j, theme, mode, True)
        while n := p.one(j, _ADVERBS if negated else NOT | _ADVERBS) or p.seq(j, "to be"):
            negated = negated or p.words[j] in NOT
            lasting = lasting or p.words[j] in ("always", "never")
            if p.words[j] in ("currently", "already", "initially", "originally"):
                mode = "start"
            j = n
        j += p.words[j] == "to" and p.words[j + 1] in lexicon.POSTURE
        j = p.opt(j, "either") if "or" in p.words[j:] else j
        told = p.any_of(j, ("supposed to also", "supposed to", "meant to also", "meant to", "to also"))
        told = told or (p.any_of(j, ("allowed to", "permitted to")) if none_of(theme) else 0)
        j = p.opt(told, "be") or j
        j += p.words[j] == "left" and p.words[j + 1] in ("on", "in", "there")
        readings = list(_predicate(p, i, j, theme, mode, negated))
        if p.words[k] == "being":  # "a row of A and B, B being on the left": said of the row
            readings = [(replace(c, cost=c.cost + int(_in_it(c))), e) for c, e in readings]
        return [(ever(c, lasting) if isinstance(c, Clause) else c, e) for c, e in readings]
    if k < p.end and p.words[k] in lexicon.POSTURE:
        if p.words[k] in ("stay", "stays", "remain", "remains") and (
            still := p.any_of(k + 1, ("put", "untouched", "in place", "unmoved", "the same", "as before"))
            or (k + 1) * (p.words[k + 1] in ("", ","))
        ):
            manner_ = Manner(kind="stay", span=p.span(k, still))
            return [(Clause(verb="be", theme=theme, adjuncts=(manner_,), mode=mode, span=p.span(i, still)), still)]
        allowed = p.words[k - 1] in ("may", "might")
        lasting = p.words[k] in ("stays", "stay", "remains", "remain", "staying", "remaining")
        readings = list(_predicate(p, i, p.reach(k + 1), theme, mode, negated))
        return [(stays(c, allowed) if lasting and isinstance(c, Clause) else c, e) for c, e in readings]
    if gone := p.seq(k, "no longer"):
        past = Manner(kind="gone", span=p.span(k, gone))
        longer = [*_subject_verb(p, i, gone, theme, mode, True), *_predicate(p, i, gone, theme, mode, True)]
        return [(replace(c, adjuncts=(*c.adjuncts, past)) if isinstance(c, Clause) else c, e) for c, e in longer]
    if (
        p.words[k - 1 : k] in (["up"], ["finishes"])
        or (p.words[k - 1] in ("get", "gets") and (p.stands(k, ("to", "onto", "into")) or _done(p, k)))
        or any(m.kind != "extra" for m, _ in manner(p, k) if isinstance(m, Manner))
        or p.words[k - 1 : k] in (["always"], ["never"])
    ):
        return list(_predicate(p, i, k, theme, mode, negated))
    return []


def _done(p: Parser, k: int) -> bool:
    """ "gets stacked on it": a passive like another."""
    return any(form == "past" for _, _, form in p.peek(k, lexicon.VERB) or ())


def _in_it(found: Meaning) -> bool:
    """Whether a clause tells of a place inside a structure."""
    return isinstance(found, Clause) and bool(found.adjuncts) and isinstance(found.adjuncts[0], At)


def _predicate(p: Parser, i: int, j: int, theme: Meaning, mode: str, negated: bool) -> Results[Meaning]:
    j = past(p, j)
    senses = p.lex(j, lexicon.VERB)
    for sense, lemma, form in senses or ():
        listed = theme.items if isinstance(theme, Coord) else (theme,)
        plain = all(isinstance(x, Noun) and x.traits.colors and not x.traits.labels for x in listed)
        if (lemma == "leave" and p.words[j - 1 : j] != ["be"]) or (sense == "spell" and plain):
            continue
        if lemma in ("take", "pull") and p.stands(j + 1, ("apart", "down")):
            sense = lemma = "unstack"
        if isinstance(theme, Structure) and lemma in ("put", "set") and p.stands(j + 1, ("up",)):
            sense = "build"
        if form == "past" or (form == "base" and lemma in ("put", "set", "spread", "split")):
            away = sense == "build" or p.words[j] not in ("put", "placed")
            end_particle = p.opt(j + 1, *PARTICLES) if away else j + 1
            for at_ in dict.fromkeys((j + 1, end_particle)):
                apart = [x for x in adjuncts(p, at_ + 1) if x[0]] if p.stands(at_, (",",)) else []
                high = [((), k) for k in AS_HIGH.matches(p, at_)] if sense == "stack" else []
                for found, k in [*adjuncts(p, at_), *apart, *high]:
                    if (
                        found
                        or sense in ("swap", "stack", "keep", "unstack")
                        or (sense in ("build", "arrange", "spell") and isinstance(theme, Structure))
                        or (lemma == "line" and p.words[at_ - 1] == "up")
                        or lemma == "alphabetize"
                        or (negated and lemma in ("move", "touch", "disturb", "shift", "turn", "rotate", "spin"))
                        or just_moved(p, j, at_, lemma, theme)
                    ):
                        done = Clause(verb=sense, lemma=lemma, theme=theme, adjuncts=found, negated=negated, mode=mode,
                                      span=p.span(i, k))  # fmt: skip
                        yield lifted_off(replace(done, word=p.span(j, j + 1))), k
                if sense in MADE:
                    built = Clause(verb="build", lemma=lemma, negated=negated, mode=mode, span=p.span(i, at_))
                    yield from made(p, i, at_, theme, replace(built, word=p.span(j, j + 1)))
    yield from under(p, i, j, theme, Clause(verb="be", negated=negated, mode=mode, span=p.span(i, j)))
    yield from drawn(p, i, j, theme, Clause(verb="build", negated=negated, mode=mode, span=p.span(i, j)))
    start = p.opt(p.reach(j + 1) if j < p.end and p.words[j] in lexicon.POSTURE else j, "also")
    start = p.opt(start, "both") if p.words[start - 1] in _PLACED and "and" in p.words[start:] else start
    for found, k in adjuncts(p, start):
        if any(not isinstance(a, Manner) or a.kind != "respectively" for a in found):
            said = Clause(verb="be", theme=theme, adjuncts=found, negated=negated, mode=mode, span=p.span(i, k))
            yield replace(said, word=p.span(j, j + 1)), k
    yield from nowhere(p, start, theme, mode, negated)
    head = theme.head if isinstance(theme, Noun) else "block"
    the = p.opt(j, "the")
    for marks, k in adjectives(p, the):
        if set(marks) == {"rank"} and marks["rank"] in ("top", "bottom", "left", "right", "front", "back", "middle"):
            k = p.opt(k, "one", "block", "cube")
            side = At(side=marks["rank"], utmost=p.words[the] in UTMOST, span=p.span(j, k))
            yield Clause(verb="be", theme=theme, adjuncts=(side,), negated=negated, mode=mode, span=p.span(i, k)), k
        elif marks and "rank" not in marks and the == j:
            k = p.opt(k, *lexicon.BLOCK) if marks.keys() <= {"edge", "size"} else k
            quality = Quality(traits=Traits(**marks), span=p.span(j, k))
            said = Clause(verb="be", theme=theme, adjuncts=(quality,), negated=negated, mode=mode, span=p.span(i, k))
            yield from throughout(p, i, said, k)
    yield from (*colored_cubes(p, i, j, theme), *sole(p, i, j, theme, mode)) if not negated else ()
    for marks, k in of_quality(p, j, head):
        quality = Quality(traits=Traits(**marks), span=p.span(j, k))
        yield Clause(verb="be", theme=theme, adjuncts=(quality,), negated=negated, mode=mode, span=p.span(i, k)), k


_PLACED = frozenset({"up", *lexicon.POSTURE})
"""Behind these "both" joins two places: "it ends up both behind red and left of green"."""


def _subject_verb(p: Parser, i: int, k: int, theme: Meaning, mode: str, negated: bool) -> Results[Meaning]:
    """ "the blocks form a ring", "the cubes spell CAT", "the red block touches the blue one", "it faces left"."""
    using = Using(members=theme, span=theme.span)
    for sense, lemma, form in p.lex(k, lexicon.VERB) or ():
        if form in ("base", "s") and lemma in ("form", "make", "spell", "build", "create", "compose"):
            spelt = sense == "spell"
            readings = spell(p, i, k + 1, lemma) if spelt else with_theme(p, i, k + 1, sense, lemma)
            for found, end in [r for r in readings if spelt or isinstance(r[0].theme, Structure | Coord)]:
                yield replace(found, adjuncts=(using, *found.adjuncts), negated=negated, mode=mode), end
    if (j := p.any_of(k, _SWAP)) and not negated:
        for other, end in adjuncts(p, j) if p.stands(j, ("with",)) else [((), j)]:
            yield Clause(verb="swap", lemma="swap", theme=theme, adjuncts=other, mode=mode, span=p.span(i, end)), end
    if j := p.one(k, ("alternate", "alternates")):
        for turns_, end in adjuncts(p, j):
            turns = Clause(verb="arrange", lemma="alternate", theme=theme, adjuncts=turns_, mode=mode,
                           span=p.span(i, end), cost=p.follows(i, ("where", "which", "that")))  # fmt: skip
            yield replace(turns, negated=negated), end
    if negated and (j := p.one(k, _MOVE)):
        unmoved = Clause(verb="place", lemma="move", theme=theme, negated=True, mode=mode, span=p.span(i, j))
        yield replace(unmoved, word=p.span(k, j)), j
    yield from touches(p, i, k, theme, mode, negated)
    if j := p.one(k, ("face", "faces", "point", "points", "look", "looks")):
        for side, end in direction(p, j):
            faced, span = Manner(kind="facing", value=side, span=p.span(k, end)), p.span(i, end)
            yield Clause(verb="be", theme=theme, adjuncts=(faced,), negated=negated, mode=mode, span=span), end
    if j := p.one(k, ("read", "reads", "show", "shows", "say", "says", "spell", "spells")):
        for told, end in reads(p, i, j, theme, mode):
            yield (replace(told, negated=negated) if isinstance(told, Clause) else told), end
    if j := p.one(k, _HAVE) or (k if p.words[k - 1] in _HAVE else 0):
        for traits, end in ((m, e) for m, e in of_quality(p, j - 1, "block")):
            quality = Quality(traits=Traits(**traits), span=p.span(k, end))
            said = Clause(verb="be", theme=theme, adjuncts=(quality,), mode=mode, span=p.span(i, end))
            yield replace(said, negated=negated), end
