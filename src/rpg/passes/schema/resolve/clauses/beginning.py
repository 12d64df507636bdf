"""What is told before a command is how things are: "a red block is on the blue patch. Move it to the green one"."""

from __future__ import annotations

import re
from functools import partial
from itertools import pairwise

from rpg.language.meaning import (
    At,
    Chain,
    Clause,
    Coord,
    In,
    Into,
    Loc,
    Meaning,
    Noun,
    Pronoun,
    Structure,
    TableTop,
    That,
    parts_of,
    replace,
)
from rpg.passes.schema.resolve.clauses.at_the_end import END, of_its_end
from rpg.passes.schema.resolve.clauses.bare_starts import bare_starts
from rpg.passes.schema.resolve.clauses.begun_facts import all_begun, indicative, lined_up_first, named_there
from rpg.passes.schema.resolve.clauses.heap_first import heap_first, heap_for
from rpg.passes.schema.resolve.clauses.in_parts import before_orders, lie_so, says_where
from rpg.passes.schema.resolve.clauses.joined_facts import (
    BESIDES,
    asked_of,
    asks,
    borne_in_turn,
    demanded,
    ends_elsewhere,
    facts_joined,
    how_far_off,
    instead_of,
    orders_something,
    same_one,
    staying,
)
from rpg.passes.schema.resolve.clauses.kept_there import kept_there
from rpg.passes.schema.resolve.clauses.lifted import lifted
from rpg.passes.schema.resolve.clauses.moved_from import moved_from
from rpg.passes.schema.resolve.clauses.other_way_round import other_way_round
from rpg.passes.schema.resolve.clauses.put_back import put_back
from rpg.passes.schema.resolve.clauses.shown_first import presented, shown, wanted_elsewhere
from rpg.passes.schema.resolve.clauses.there_later import there_is, there_on_it, there_so, they_begin_as
from rpg.passes.schema.resolve.clauses.told_then_asked import told_then_asked
from rpg.passes.schema.resolve.clauses.wished_after import wished_after
from rpg.passes.schema.resolve.clauses.worded_first import worded_first

UNMEANT = frozenset({"contradiction", "support-cycle"})
"""Refusals of facts and commands that cannot both be about the end."""


def begun(chains: tuple[Chain, ...], text: str, bold: bool = False) -> tuple[Chain, ...]:
    """The sentences, with facts before a command about what they bring up told of the start.

    `bold`: facts about known things too ("the red block is on the patch. Move it to the left half"), whatever is said
    behind them of how it should be ("it should not be there at the end").
    """
    chains = tuple(facts_joined(moved_from(named_there(chain)), text) for chain in chains)
    chains = bare_starts(tuple(told_then_asked(chain, text) for chain in chains))
    chains = lifted(kept_there(instead_of(put_back(other_way_round(chains), text)), text), text)
    chains = worded_first(lined_up_first(they_begin_as(there_on_it(_lying_there(chains, text))), text), text)
    now = _as_it_is_now(chains[0], text, chains[1:])
    chains = (now, *(_there_too(chain, text) for chain in chains[1:]))
    chains = tuple(all_begun(chain, text, len(chains) == 1) for chain in chains)
    if (picture := _pictured(chains, text)) is not None:
        return picture
    chains = before_orders(staying(chains, text), text)
    told = [_facts(chain, bold) or (bold and indicative(chain, text)) or lie_so(chain, text, bold) for chain in chains]
    final = [of_its_end(chains, n, text) or demanded(chains, n, text) for n in range(len(chains))]
    told = [fact and not end for fact, end in zip(told, final, strict=True)]
    commands = [n for n, chain in enumerate(chains) if _commands(chain) or (bold and not indicative(chain, text))]
    commands = [n for n in commands if final[n] or not how_far_off(chains[n - 1 : n + 1])]
    undone = [n for n, chain in enumerate(chains) if _undoes(chain)]
    told = [
        x or (n < max(undone, default=0) and ((_so(chains[n], text) and not final[n]) or _looked_at(chains, n, text)))
        for n, x in enumerate(told)
    ]
    chains = tuple(heap_first(chain, chains[n + 1 : n + 2]) for n, chain in enumerate(chains))
    ordered = [n for n, chain in enumerate(chains) if orders_something(chain)]
    heaped = [
        n
        for n, chain in enumerate(chains)
        if n < max(ordered, default=0) and (_heaped(chain) or heap_for(chain, chains[n + 1]))
    ]
    heaped += [n for n, chain in enumerate(chains) if _heaped(chain) and not final[n] and any(final[n:])]
    heaped += [n for n in range(max(ordered, default=0)) if presented(chains, n, text)]
    heaped += _going_on(chains, final)
    plain = [
        not final[n] and (shown(chain, text) or (_facts(chain) and _unframed(chains, n, text)))
        for n, chain in enumerate(chains)
    ]
    for n in reversed(range(len(chains) - 1)):
        later = _moved_next(chains[n], chains[n + 1], text) or _wanted_later(chains[n], chains[n + 1], text)
        later = later or wanted_elsewhere(chains[n], chains[n + 1], final[n + 1])
        later = later or (final[n + 1] and ends_elsewhere(chains[n], chains[n + 1]))
        later = later and (final[n + 1] or not how_far_off(chains[n : n + 2]))
        if plain[n] and (later or (plain[n + 1] and n + 1 in heaped)):
            heaped.append(n)
    found = []
    for n, chain in enumerate(chains):
        chain = _wanted_elsewhere(chain, text) if bold else chain
        if n in heaped or (told[n] and any(m > n for m in (*commands, *undone))):
            clauses = tuple(
                c if _tally(c) else replace(c, mode="given" if c.verb == "exist" else "start")
                for c in chain.clauses
                if isinstance(c, Clause)
            )
            chain = replace(chain, clauses=clauses)
        found.append(borne_in_turn(chain))
    return wished_after(tuple(_so_now(chain, chains, text) for chain in found), text, final)


def _so_now(chain: Chain, chains: tuple[Chain, ...], text: str) -> Chain:
    """ "(Put A on B.) B is now on C": so it is at the start, where something is to be done."""
    told = chain.clauses[0]
    one = len(chain.clauses) == 1 and isinstance(told, Clause) and _fact(told, True)
    if not one or not isinstance(told, Clause):
        return chain
    said = text[slice(*told.span)] + re.split(r"[.;!?]", text[told.span[1] :])[0]
    if _NOW_SO.search(said) is None:
        return chain
    ordered = any(orders_something(other) or _ASKED.search(text[slice(*other.span)]) for other in chains)
    return replace(chain, clauses=(replace(told, mode="start"),)) if ordered else chain


_NOW_SO = re.compile(r"\b(?:is|are|lies?|stands?|sits?) now\b|\bnow$", re.IGNORECASE)


def _lying_there(chains: tuple[Chain, ...], text: str) -> tuple[Chain, ...]:
    """ "Six green bricks on the table. Make two towers": blocks that lie there before the first command say what
    there is."""
    if not isinstance(first := chains[0].clauses[0], Clause) or first.lemma or first.verb != "be" or first.negated:
        return chains
    table = [isinstance(a, Loc) and isinstance(a.landmark, TableTop) and a.rel == "on" for a in first.adjuncts]
    rest = (*chains[0].clauses[1:], *(c for chain in chains[1:] for c in chain.clauses))
    command = next((isinstance(c, Clause) and c.mode == "command" and not c.negated for c in rest), False)
    ended = text[first.span[1] :].lstrip()[:1] in (",", ".", ";", ":", "!")
    if table != [True] or not (command and ended) or first.mode != "goal" or not _indefinite(first.theme):
        return chains
    there = replace(first, verb="exist", mode="given")
    return (replace(chains[0], clauses=(there, *chains[0].clauses[1:])), *chains[1:])


_NOW = re.compile(r"(?:(?:please|ok|okay|so|right|well),? )?now,?", re.IGNORECASE)


def _as_it_is_now(chain: Chain, text: str, more: tuple[Chain, ...]) -> Chain:
    """ "Now red is on blue, afterwards blue is on red": what is so now is the start of what comes afterwards."""
    facts = 0
    for link, clause in zip(chain.links, chain.clauses, strict=True):
        if not isinstance(clause, Clause) or not _fact(clause, True) or (facts and link != "and"):
            break
        facts += 1
    later = facts < len(chain.clauses)
    if not facts or not (later or more) or _NOW.fullmatch(text[: chain.clauses[0].span[0]].strip()) is None:
        return _there_too(chain, text)
    begun = tuple(replace(c, mode="start") for c in chain.clauses[:facts] if isinstance(c, Clause))
    links = (*chain.links[:facts], "and", *chain.links[facts + 1 :]) if later else chain.links
    return replace(chain, clauses=(*begun, *chain.clauses[facts:]), links=links)


def _going_on(chains: tuple[Chain, ...], final: list[bool]) -> list[int]:
    """ "Initially red is on blue. Green is on yellow. Put ...": facts that follow what is told of the start are of the
    start as well, where something is asked for, or told of the end, behind them."""
    found: list[int] = []
    started = False
    for n, chain in enumerate(chains):
        asked = any(final[m] or orders_something(chains[m]) for m in range(n + 1, len(chains)))
        if started and asked and not final[n] and _facts(chain):
            found.append(n)
        else:
            started = all(isinstance(c, Clause) and c.mode == "start" for c in chain.clauses)
    return found


def _there_too(chain: Chain, text: str) -> Chain:
    """ "There is a red block on the blue one and a green block on the mat": "there is" is said of both."""
    told: list[Meaning] = []
    for link, clause in zip(chain.links, chain.clauses, strict=True):
        said = clause.verb if isinstance(clause, Clause) and (clause.lemma, clause.mode) == ("", "goal") else ""
        bare = said in ("be", "build") and isinstance(clause, Clause) and bool(clause.cost) and not clause.negated
        if link == "and" and told and there_is(told[-1]) and bare and isinstance(clause, Clause):
            spots = all(isinstance(a, Loc | In) and not a.negated for a in clause.adjuncts)
            asked = asks(text[told[-1].span[1] : clause.span[0]])
            if spots and not asked and (clause.adjuncts or said == "build") and _indefinite(clause.theme):
                clause = replace(clause, verb="exist", mode="given")
        told.append(clause)
    return replace(chain, clauses=tuple(told)) if tuple(told) != chain.clauses else chain


def _pictured(chains: tuple[Chain, ...], text: str) -> tuple[Chain, ...] | None:
    """Facts alone, "there is a red block on the blue one" among them: all of it pictures the end.

    So does what is said to be seen, in a picture or at the end, where nothing else is asked for.
    """
    clauses = [c for chain in chains for c in chain.clauses]
    if any(isinstance(c, Clause) and c.mode in ("start", "command") for c in clauses):
        return None
    listed = isinstance(clauses[0], Clause) and clauses[0].lemma in ("tally", "stock")
    seen = _SEEN.search(text[: clauses[0].span[listed]]) is not None
    final = [of_its_end(chains, n, text) for n in range(len(chains))]
    if any(final) and not final[0]:
        return None
    within = (text[a.span[1] : b.span[0]] for chain in chains for a, b in pairwise(chain.clauses))
    if not final[0] and (any(demanded(chains, n, text) for n in range(1, len(chains))) or any(map(asks, within))):
        return None
    if not all(isinstance(c, Clause) and _describes(c, text, seen) for c in clauses):
        return None
    pictured = partial(_of_the_end, seen=seen, whole=True)
    ends = [c for c in map(pictured, clauses) if isinstance(c, Clause) and c.mode == "goal"]
    if not ends:
        return None
    return tuple(replace(chain, clauses=tuple(map(pictured, chain.clauses))) for chain in chains)


_SEEN = re.compile(
    r"\b(?:sees?|seen|picture[ds]?|photo(?:graph)?s?|image|drawing|sketch|scene|looks?|shows?|imagine|end|finally|final|"
    r"done|finished)\b",
    re.IGNORECASE,
)
"""Words of frames in front of a picture."""
_ASKED = re.compile(
    r"\b(?:(?:must|should|ought)(?:n't)?|shall|has to|have to|needs? to|will|may|can|let|want|wish|belongs?)\b",
    re.IGNORECASE,
)


def _describes(clause: Clause, text: str, seen: bool) -> bool:
    """Whether a clause says how it is, and not what is wanted."""
    asked = _ASKED.search(text[slice(*clause.span)]) is not None
    if clause.lemma == "fact":
        return not asked
    return there_is(clause) or there_so(clause) or (seen and clause.mode in ("goal", "given") and not asked)


def _of_the_end(clause: Meaning, seen: bool, whole: bool = False) -> Meaning:
    """The clause, about the end if it says where something is: to be on the table is to be there. `whole`: all that is
    told is of the end, structures without a place too."""
    if not isinstance(clause, Clause) or (clause.verb, clause.mode, clause.lemma) != ("exist", "given", ""):
        return clause
    places = clause.adjuncts if seen or there_is(clause) else ()
    told = any(not (isinstance(a, Loc) and isinstance(a.landmark, TableTop)) for a in places)
    lined_up = any(isinstance(a, Into | At) for a in clause.adjuncts)
    if (seen or whole) and lined_up and not isinstance(clause.theme, Structure):
        return replace(clause, verb="be", mode="goal")
    told = told or ((seen or whole) and isinstance(clause.theme, Structure))
    return replace(clause, mode="goal") if told else clause


def _looked_at(chains: tuple[Chain, ...], n: int, text: str) -> bool:
    """ "I see a red block on a blue one. Swap them.": what is seen is so at the start where it is to be changed."""
    before = text[chains[n - 1].span[1] if n else 0 : chains[n].clauses[0].span[0]]
    plain = _ASKED.search(before) is None and _SEEN.search(before) is not None and not END.search(before)
    return plain and all(isinstance(c, Clause) and _describes(c, text, True) for c in chains[n].clauses)


def _undoes(chain: Chain) -> bool:
    """Whether a sentence changes what is there: swaps it, takes it apart, turns it round, clears what it lies on."""
    undoing = ("swap", "unstack", "reverse", "replace", "clear", "empty")
    said = [c for c in chain.clauses if isinstance(c, Clause)]
    over = any(c.verb == "turn" and isinstance(c.theme, Structure) for c in said)
    return over or any(not {c.verb, c.lemma}.isdisjoint(undoing) for c in said)


def _moved_next(before: Chain, after: Chain, text: str) -> bool:
    """ "the red block is on the green block. Move it next to the blue block": what is told of a block that the very
    next sentence moves, or says to belong elsewhere ("It has to go to the left half"), or what is told before another
    block is put somewhere ("Put the white block on top") or something is built.
    """
    fact, order = before.clauses[-1], asked_of(after)
    if not _facts(before) or not isinstance(fact, Clause) or not isinstance(order, Clause) or order.negated:
        return False
    if isinstance(fact.theme, Noun) and fact.theme.head == "patch":
        return False
    if BESIDES.search(text[slice(*order.span)]):
        return False
    if order.verb == "build" and order.mode == "command":
        return True
    so = order.mode == "command" and any(isinstance(a, That) and a.kind == "so" for a in order.adjuncts)
    if not so and not any(isinstance(a, Loc | In | At) for a in order.adjuncts):
        return False
    if order.verb in ("place", "stack") and order.mode == "command":
        return True
    wanted = order.mode == "goal" and (order.verb == "place" or (order.verb, order.lemma) == ("be", ""))
    return wanted and len(before.clauses) == 1 and same_one(fact, order)


_LATER = re.compile(r"\W*(?:and )?(?:afterwards?|after that|later|then)\W*", re.IGNORECASE)


def _wanted_later(before: Chain, after: Chain, text: str) -> bool:
    """ "Two red blocks lie on the mat. Afterwards they should be on the blue one": what is so, and what should be."""
    joint = text[before.span[1] : after.clauses[0].span[0]]
    asked = _ASKED.search(text[slice(*before.span)]), _ASKED.search(text[slice(*after.span)])
    return _LATER.fullmatch(joint) is not None and asked[0] is None and asked[1] is not None


def _wanted_elsewhere(chain: Chain, text: str) -> Chain:
    """ "The red block is on the green mat and must be on the blue one": where it is, and where it should be."""
    fact, *more = chain.clauses
    if not isinstance(fact, Clause) or not more or not _fact(fact, True) or _ASKED.search(text[slice(*fact.span)]):
        return chain
    wanted = text[fact.span[1] : chain.span[1]]
    elsewhere = all(isinstance(c, Clause) and not c.negated and same_one(fact, c) for c in more)
    if not elsewhere or _ASKED.search(wanted) is None:
        return chain
    return replace(chain, clauses=(replace(fact, mode="start"), *more))


_PLAINLY = re.compile(r"\W*(?:(?:ok|okay|so|now|well|hi|hello|hey|listen|robot|look)\W+)*", re.IGNORECASE)
"""What may stand before a fact that nobody asks for."""


def _unframed(chains: tuple[Chain, ...], n: int, text: str) -> bool:
    before = text[chains[n - 1].span[1] if n else 0 : chains[n].clauses[0].span[0]]
    return _PLAINLY.fullmatch(re.split(r"[.;!?]", before)[-1]) is not None


def _heaped(chain: Chain) -> bool:
    """ "the six blocks lie in a heap": before a command no end, for nobody asks for a heap in the indicative."""
    shapes = [a.structure for c in chain.clauses if isinstance(c, Clause) for a in c.adjuncts if isinstance(a, Into)]
    return _facts(chain) and bool(shapes) and all(isinstance(x, Structure) and x.kind == "pile" for x in shapes)


def _facts(chain: Chain, bold: bool = True) -> bool:
    told = [c for c in chain.clauses if not _tally(c)]
    return bool(told) and all(isinstance(c, Clause) and _fact(c, bold) for c in told)


def _so(chain: Chain, text: str) -> bool:
    return _facts(chain) or indicative(chain, text)


def _tally(clause: Meaning) -> bool:
    """A list of what there is, which goes with facts as with commands."""
    return isinstance(clause, Clause) and clause.lemma == "tally"


def _fact(clause: Clause, bold: bool) -> bool:
    told = clause.lemma == "fact" and clause.mode == "goal" and not clause.negated and says_where(clause)
    return told and (bold or _indefinite(clause.theme))


def _indefinite(theme: Meaning | None) -> bool:
    """Whether a phrase brings up what was not spoken of before."""
    if isinstance(theme, Coord):
        return all(_indefinite(item) for item in theme.items)
    return isinstance(theme, Noun | Structure) and (theme.det == "a" or (theme.det == "bare" and bool(theme.amount)))


def _commands(chain: Chain) -> bool:
    """Whether a sentence commands something about what was spoken of."""
    asked = [c for c in chain.clauses if isinstance(c, Clause) and (c.mode == "command" or _to_be_moved(c))]
    return any(not c.negated or isinstance(c.theme, Pronoun) for c in asked) and any(
        isinstance(part, Pronoun) or (isinstance(part, Noun | Structure) and part.det in ("the", "its", "all", "other"))
        for part in parts_of(chain)
    )


def _to_be_moved(clause: Clause) -> bool:
    """ "It must be moved to the left half": as good as a command."""
    return (clause.mode, clause.verb) == ("goal", "place") and clause.lemma in _MOVING and not clause.negated


_MOVING = frozenset({"move", "take", "bring", "carry", "transfer", "relocate", "shift", "get", "remove"})
