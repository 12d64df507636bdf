"""How something is turned, spelt, timed or counted: closed lists of small phrases."""

from __future__ import annotations

from rpg.language import lexicon
from rpg.language.grammar.clauses.colors_told import colors_told
from rpg.language.grammar.clauses.numbers_denied import EXACTLY, number_denied
from rpg.language.grammar.clauses.on_the_way import on_the_way
from rpg.language.grammar.clauses.pointing import direction, points
from rpg.language.grammar.clauses.shifts import shifted, straight
from rpg.language.grammar.core import Parser, Results, choice, rule
from rpg.language.grammar.places.sides import TOWERS
from rpg.language.grammar.talk.framing import IN_PICTURE, WHEN_DONE
from rpg.language.grammar.talk.slots import Patterns
from rpg.language.grammar.things.excepted import NO_MORE
from rpg.language.grammar.things.standby import AS_EXTRAS, said_idle
from rpg.language.grammar.things.strangers import strangers
from rpg.language.meaning import Manner, Meaning

_ANY_WAY = Patterns(
    ", or|in? any|either|whatever|whichever direction|orientation|rotation|way|way_round|way_around "
    "you_like|you_want|you_please|you_prefer|will_do|is_fine|works|is_ok|is_okay|allowed|goes?",
    ",? it|they|which|the_row|the_line|the_tower may|can|might|could run|go|point|lie|stand|face|be_turned|be_rotated "
    "in? any|either|whatever|whichever direction|orientation|way",
    ",? facing|pointing|turned|rotated|lying|oriented in? any|either|whatever|whichever direction|orientation|way "
    "you_like?",
    "in|with any|whatever|whichever orientation|rotation you_like|you_want|you_please?",
    "whichever|whatever|any way round|around you_like?",
    ",? the|its? orientation|direction|rotation does_not_matter|is_irrelevant|is_up_to_you|is_free|free|irrelevant|"
    "is_your_choice|up_to_you|is_not_important|arbitrary|is_arbitrary",
)
"""How a figure lies is not asked for anyway."""
_LEFTWARD = tuple(f"{way} from right to left" for way in ("going up", "rising", "ascending", "climbing"))


@rule
def manner(p: Parser, i: int) -> Results[Meaning]:
    """How something is turned, spelt, spaced or counted."""
    for phrases, degrees in ((_DOWN, 180.0), (_UPRIGHT, 0.0), (("sideways", "on its side"), 90.0)):
        if j := p.any_of(i, phrases):
            yield Manner(kind="turn", value=degrees, span=p.span(i, j)), j
    yield from (*shifted(p, i), *straight(p, i), *colors_told(p, i), *on_the_way(p, i))
    comma = p.opt(i, ",")
    if k := p.any_of(comma, _FACING):
        for side, end in direction(p, k):
            if not any(degrees_of(p, end)):  # "turned to the left by 90 degrees"
                yield Manner(kind="facing", value=side, span=p.span(i, end)), end
    yield from points(p, i, comma)
    if j := p.any_of(i, _RISING):
        yield from _rising(p, i, j)
    if j := p.any_of(i, _LEFTWARD):
        yield Manner(kind="rising", value="left", span=p.span(i, j)), j
    yield from ((Manner(kind="idle", value="any way", span=p.span(i, j)), j) for j in _ANY_WAY.matches(p, i))
    spun = p.opt(i, "turned", "rotated", "twisted", "spun")
    for n, j in degrees_of(p, spun):
        yield from _spun(p, i, j, n)
    for clockwise, way in ((True, p.any_of(spun, _CLOCKWISE)), (False, p.any_of(spun, _COUNTER))):
        for n, j in degrees_of(p, p.opt(way, ",")) if way else ():  # "clockwise by 90 degrees"
            yield Manner(kind="by", value=-n if clockwise else n, span=p.span(i, j)), j
    yield from strangers(p, i)
    for kind, frame in (("finally", WHEN_DONE), ("idle", IN_PICTURE)):
        for j in frame.matches(p, i):
            yield Manner(kind=kind, span=p.span(i, j)), j
    if p.anywhere(_NO_MORE_OF) and (j := p.any_of(comma, _NO_MORE)):
        yield Manner(kind="idle", span=p.span(i, j)), j
    if p.anywhere(EXACTLY):
        yield from ((Manner(kind="idle", span=p.span(i, j)), j) for _, j in number_denied(p, comma))
    if i > 0 and (j := p.any_of(comma, NO_MORE)) and (j >= p.end or p.stands(j, _POLITE)):
        yield Manner(kind="no more", span=p.span(i, j)), j
    if j := p.any_of(i, _ONE_EACH) if i > 0 else 0:
        yield Manner(kind="respectively", value="alike", span=p.span(i, j)), j
    if j := max((k for at in {i, comma} for k in _STREWN.matches(p, at)), default=0):
        yield Manner(kind="strewn", span=p.span(i, j)), j
    if j := max((k for at in {i, comma} for k in AS_EXTRAS.matches(p, at)), default=0):
        yield Manner(kind="extra", span=p.span(i, j)), j
    for j in said_idle(p, i):
        yield Manner(kind="extra", span=p.span(i, j)), j
    for phrase, j in p.standing(i, _LITTLE):
        kind, value = _LITTLE[phrase]
        if phrase == "still" and j < p.end and not p.stands(j, _CLAUSE_ENDS):
            continue
        if phrase == "there" and p.follows(i, ("not",)):
            continue
        if phrase == "in place" and p.follows(i, ("is", "are", "be")):
            continue  # "when all are in place": where they were told to be
        counted = phrase in ("second", "third", "last") and p.follows(i, ("and",))  # "on top of the first and last"
        if kind == "time" and (counted or p.stands(j, ("from",))):  # "third from the left"
            continue
        if phrase in (", letters on top", "from above") and not TOWERS.isdisjoint(p.words):
            continue  # that tells of blocks, and not of the faces that are seen
        of_a_patch = phrase.startswith("where") and not lexicon.PATCH.keys().isdisjoint(p.words[:i])
        placed = of_a_patch or (phrase == "there" and p.follows(i, _PUT))  # "on the patch where it is"
        yield Manner(kind=kind, value=value, span=p.span(i, j), cost=2 * placed), j
        if kind == "extra":  # "lying around which are not needed"
            yield from ((Manner(kind=kind, value="around", span=p.span(i, k)), k) for k in said_idle(p, j))


_PUT = ("them", "up", "all", "three", "it", "two", "four", "five", "six")
"""Behind these "there" is a place: "stack them there"."""
_CLAUSE_ENDS = frozenset({",", ";", "and", "but", "while", "when", "as", "at", "throughout", "until"})
"""Only with these behind it "still" says that nothing moves: "still on the mat" is where something else is, too."""
_NO_MORE_OF = frozenset({"exactly", "precisely"})
_NO_MORE = ("not more", "no more", "no more and no less", "not more and not less", "no more , no less", "no less",
            "no more no less", "not more , not less", "neither more nor less",
            "nothing more", "and no more")  # fmt: skip
"""What "exactly" says already."""
_POLITE = frozenset({"please", "thanks", "thank"})
_ONE_EACH = (", one each", ", one on each", ", one on each of them", ", one on each one", ", one apiece", "one on each",
             ", each on a different one", ", each on one of them", ", one per block", ", one per patch",
             ", one per mat", ", one for each", ", each on one")  # fmt: skip
"""How as many things go on as many others."""
_STREWN = Patterns(
    "randomly|loosely|all|freely? scattered|strewn|spread_randomly|distributed_randomly|randomly_placed|"
    "randomly_distributed|placed_randomly|placed_at_random randomly|at_random|loosely? "
    "all? over|around|on|across|about? the|your|my? table|tabletop|workspace|desk?",
    "at|in|to random places|positions|spots|locations|poses|orientations",
    "at_random|randomly over|around|on|across the table|tabletop|workspace",
)
"""Of things that lie about: so they begin wherever nothing else is said of it."""
_DOWN = (
    "upside down", "flipped upside down", "inverted", "in an inverted orientation", "turned upside down",
    "rotated upside down",
)  # fmt: skip
_UPRIGHT = (
    "upright", "right side up", "right way up", "the right way up", "the right way round", "right side upward",
)  # fmt: skip
_FACING = (
    "facing", "faces", "face", "to face", "pointing", "points", "pointed", "showing", "turned", "so that it faces",
    "visible from",
)  # fmt: skip
_RISING = (
    *(
        f"{rise} {to}"
        for rise in ("rising", "going up", "ascending", "climbing", "leading up", "that goes up", "that go up",
                     "that rises", "that rise", "that climbs", "that climb", "which rises", "which goes up",
                     "which climbs", "going upward", "going upwards", "that leads up", "climbing up")
        for to in ("to the", "towards the", "toward the", "from left to")
    ),
    "up to the", "up towards the",
)  # fmt: skip
_AGAINST = ("counterclockwise", "counter clockwise", "anticlockwise", "anti clockwise")
_CLOCKWISE, _COUNTER = (
    (*(f"{lead}{way}{end}" for lead, end in (("", ""), ("in the ", " direction"), ("in a ", " direction"))
       for way in ways), side)
    for ways, side in ((("clockwise",), "to the right"), ((*_AGAINST,), "to the left"))
)  # fmt: skip


def _spun(p: Parser, i: int, j: int, degrees: float) -> Results[Meaning]:
    """A turn by so many degrees, one way or either way."""
    clockwise = p.any_of(j, _CLOCKWISE)
    counter = p.any_of(j, _COUNTER)
    if p.stands(clockwise or counter, ("of",)):  # "turned by 90 degrees to the left of the mat"
        clockwise = counter = 0
    end = clockwise or counter or j
    kind = "by" if clockwise or counter else "by?"
    yield Manner(kind=kind, value=-degrees if clockwise else degrees, span=p.span(i, end)), end


def _rising(p: Parser, i: int, j: int) -> Results[Meaning]:
    if p.words[j : j + 1] and p.words[j] in ("left", "right", "front", "back"):
        yield Manner(kind="rising", value=p.words[j], span=p.span(i, j + 1)), p.reach(j + 1)


_EVENTS = ("episode", "task", "run", "game", "process", "procedure", "exercise", "operation", "trial", "simulation",
           "test")  # fmt: skip
_LITTLE: dict[str, tuple[str, float | str | None]] = {
    **{f"{lead} {whole} {event}": ("always", None)
       for lead in ("during", "throughout", "for", "over")
       for whole in ("the", "the whole", "the entire", "all of the", "the complete", "this", "this whole")
       for event in _EVENTS},
    **{f"{lead}{whole} time": ("always", None)
       for lead in ("", "during ", "for ") for whole in ("the whole", "the entire", "all of the", "all that")},
    **dict.fromkeys((
        "all along", "constantly", "continuously", "at every moment", "at each moment", "at every point",
        "at every step", "from beginning to end", "from the beginning to the end", "from the start to the end",
        "from start to end", "until the end",
        "until the very end", "up to the end", "till the end", "all the way through", "the whole way through"),
        ("always", None)),
    **{f"{at} of {the}{event}": (kind, None)
       for kind, places in (("start", ("at the start", "at the beginning", "at the very start", "in the beginning")),
                            ("finally", ("at the end", "by the end", "at the very end", "in the end")))
       for at in places for the in ("the ", "this ") for event in _EVENTS},
    **{f"{at} the {first} {state}": ("start", None)
       for at in ("in", "at") for first in ("initial", "starting", "start", "original", "opening")
       for state in ("state", "situation", "configuration", "scene", "setup", "arrangement", "layout", "picture")},
    "before that": ("time", 0.0), "beforehand": ("time", 0.0), "before this": ("time", 0.0),
    "right where it is": ("stay", None), "exactly where it is": ("stay", None), "where it stands": ("stay", None),
    "please": ("idle", None), ", please ,": ("idle", None), "if possible": ("idle", None),
    "from where i stand": ("idle", "view"), "as i see it": ("idle", "view"), "from my side": ("idle", "view"),
    "but not both": ("xor", None), ", but not both": ("xor", None), ", not both": ("xor", None),
    "but not on both": ("xor", None),
    "first": ("time", 1.0), "second": ("time", 2.0), "third": ("time", 3.0), "last": ("time", 99.0),
    "finally": ("time", 99.0), "eventually": ("finally", None), "ultimately": ("finally", None),
    "afterwards": ("time", 50.0), "initially": ("start", None),
    **{f"from the {very}{start}{on}": ("always" if on else "start", None)
       for very in ("", "very ") for start in ("start", "beginning", "outset") for on in ("", " on", " onwards")},
    "at the moment": ("start", None), "there from the start": ("start", None),
    "there at the start": ("start", None), "there already": ("start", None), "already there": ("start", None),
    "there now": ("start", None), "there initially": ("start", None), "there at the beginning": ("start", None),
    "there from the beginning": ("start", None),
    "at the start": ("start", None), "at the beginning": ("start", None), "at first": ("start", "first"),
    "at present": ("start", None), "for the moment": ("start", None),
    "right now": ("start", None), "at the outset": ("start", None),
    "at start": ("start", None), "before anything moves": ("start", None), "at the very outset": ("start", None),
    "in the beginning": ("start", None), "to begin with": ("start", "first"), "originally": ("start", None),
    "to start with": ("start", "first"),
    "currently": ("start", None), "at the start of the episode": ("start", None), "as distractors": ("extra", None),
    "as a distractor": ("extra", None), "lying around": ("extra", "around"),
    "there as distractors": ("extra", None), "also there": ("extra", "around"), "there too": ("extra", "around"),
    "there as well": ("extra", "around"), "also present": ("extra", "around"), "also lying around": ("extra", "around"),
    "lying around as distractors": ("extra", None),
    "distractors": ("extra", None), "a distractor": ("extra", None), "just distractors": ("extra", None),
    "only distractors": ("extra", None), "as decoration": ("extra", None), ", which do not matter": ("extra", None),
    "that do not matter": ("extra", None), "irrelevant": ("extra", None),
    "by the robot": ("idle", None), "by the arm": ("idle", None), "with the gripper": ("idle", None),
    "there": ("idle", None), "as seen from above": ("idle", "view"),
    **{f"{when}{seen} from above": ("idle", "view")
       for when in ("", "when ", "if ") for seen in ("seen", "viewed", "looked at")},
    "looking from above": ("idle", "view"), "as viewed from above": ("idle", "view"),
    "in the final scene": ("finally", None), "when you are done": ("finally", None),
    "in the target orientation": ("turn", 0.0), "in the right orientation": ("turn", 0.0), "readable": ("turn", 0.0),
    "in the correct orientation": ("turn", 0.0), "the right way around": ("turn", 0.0),
    **{f"{so}{can_read}": ("idle", "view") for so in ("so ", "so that ")
       for can_read in ("i can read it", "you can read it", "it is readable")},
    "readable upright": ("turn", 0.0), "readable from above": ("idle", "view"), ", letters on top": ("idle", None),
    "with the letters facing up": ("idle", None), "with letters facing up": ("idle", None),
    ", letters facing up": ("idle", None), ", letters readable from above": ("turn", 0.0),
    "partially stacked": ("partial", None),
    "partly stacked": ("partial", None), "of equal height": ("equal", None), "of the same height": ("equal", None),
    "equally tall": ("equal", None), "equally high": ("equal", None), "of equal heights": ("equal", None),
    **{f"{of} {other} {height}": ("unequal", None) for of in ("of", "with", "in")
       for other in ("different", "unequal") for height in ("height", "heights")},
    **{f"with {its} order {reversed_}": ("backwards", None)
       for its in ("the", "its", "their") for reversed_ in ("reversed", "inverted", "flipped", "turned around")},
    "differently tall": ("unequal", None), "differently high": ("unequal", None),
    "the same height": ("equal", None), "with the same height": ("equal", None), "reversed": ("backwards", None),
    "while doing so": ("always", None), "while doing this": ("always", None), "while you do so": ("always", None),
    "while you do that": ("always", None), "while you do this": ("always", None), "in the process": ("always", None),
    "at any moment": ("always", None), "at any stage": ("always", None), "in the meantime": ("always", None),
    **{f"{where} {it} {start}": ("begun", None)
       for where in ("where", ", where", "which is where", ", which is where", ", on which", "on which", ", in which")
       for it in ("it", "they", "it all", "they all", "they both", "both", "both of them", "all of them", "these")
       for start in ("starts", "start", "begins", "begin", "started", "began", "is at the start", "are at the start",
                     "is initially", "are initially", "lies at the start", "lie at the start", "starts out",
                     "start out", "is at the beginning", "are at the beginning", "initially lie", "initially lies")},
    ", as at the start": ("begun", None),
    "any more": ("gone", None), "anymore": ("gone", None), "any longer": ("gone", None),
    "all the time": ("always", None), "from start to finish": ("always", None),
    "during the whole task": ("always", None),
    "throughout the episode": ("always", None), "throughout the task": ("always", None),
    "during the whole episode": ("always", None), "during the task": ("always", None), "at any time": ("always", None),
    "at any point": ("always", None), "ever": ("always", None),
    "the other way round": ("backwards", None), "the other way around": ("backwards", None),
    "the other way up": ("backwards", None),
    "later": ("time", 50.0), "later on": ("time", 50.0),
    **{f"{lead}{wholly}": ("idle", "whole " + wholly)
       for lead in ("", ", ")
       for wholly in ("completely", "entirely", "fully", "totally", "altogether", "all the way")},
    "respectively": ("respectively", None), "backwards": ("backwards", None), "in reverse": ("backwards", None),
    "backward": ("backwards", None),
    "at the end": ("finally", None), "in the end": ("finally", None), "at once": ("idle", "pace at once"),
    "one by one": ("idle", None), "one block at a time": ("idle", None), "one cube at a time": ("idle", None),
    "one at a time": ("idle", None), "carefully": ("idle", "pace carefully"), "gently": ("idle", "pace gently"),
    **dict.fromkeys(("neatly", "nicely", "tidily", "prettily", "beautifully", "orderly"), ("idle", None)),
    "exactly": ("idle", None),
    "again": ("idle", "before again"), "precisely": ("idle", None), "instead": ("idle", "before instead"),
     "for me": ("idle", None), "slowly": ("idle", "pace slowly"), "quickly": ("idle", "pace quickly"),
    "in any way": ("idle", None), "in any arrangement": ("idle", None), "in any direction": ("idle", "any way"),
    "in the picture": ("idle", None), "at all times": ("always", None),
    "the whole time": ("always", None), "throughout": ("always", None), "always": ("always", None),
    "in the scene": ("idle", None), "side up": ("idle", None),
    "in place": ("stay", None),
    "as it is": ("stay", "wholly"), "as they are": ("stay", "wholly"),
    "untouched": ("stay", "wholly"), "alone": ("alone", "wholly"),
    "still": ("stay", None), "where they were": ("stay", None),
    "unmoved": ("stay", None),
    "in its place": ("stay", None), "in their places": ("stay", None), "at its place": ("stay", None),
    "undisturbed": ("stay", "wholly"),
    "to its original place": ("stay", None), "to its original position": ("stay", None),
    "back to its original place": ("stay", None), "back to its original position": ("stay", None),
    "to their original places": ("stay", None), "to their original positions": ("stay", None),
    "to its starting position": ("stay", None), "back to its starting position": ("stay", None),
    **{f"{at} {its}{same} {place}": ("stay", None)
       for at in ("in", "at", "on") for its in ("its ", "their ", "the ", "")
       for same in ("current", "original", "initial", "starting", "present", "old", "same", "own", "exact same")
       for place in ("position", "place", "spot", "positions", "places", "location", "locations")},
    **{f"{exactly}where {it} {was}": ("stay", None)
       for exactly in ("", "right ", "exactly ", "just ", "precisely ", "to ", "back to ", "back ")
       for it in ("it", "they") for was in (
           "is", "are", "was", "were", "stands", "stand", "lies", "lie", "sits", "sit", "is now", "are now", "starts",
           "is standing", "are standing", "is lying", "are lying", "started", "began", "currently is", "begins",
           "currently are", "is right now", "are right now", "happens to be", "happen to be",
           *(f"{was} {then}" for was in ("was", "were", "stood", "lay", "sat") for then in (
               "at the start", "at the beginning", "initially", "originally", "at first", "before", "to begin with",
               "in the beginning", "to start with")))},
    "as is": ("stay", "wholly"),
    "where it currently is": ("stay", None),
    "left to right": ("idle2", None), "in a single file": ("idle", None), "apart": ("idle2", None),
    "in a loop": ("idle2", None), "by hand": ("idle2", None),
}  # fmt: skip


_DEGREES = frozenset(lexicon.DEGREES.split())
_TURNS = {
    "turned a quarter turn": 90.0, "turned a half turn": 180.0, "turned half a turn": 180.0,
    "rotated a quarter turn": 90.0, "a quarter turn": 90.0, "a half turn": 180.0, "half a turn": 180.0,
    "a quarter of a turn": 90.0, "halfway around": 180.0, "quarter turn": 90.0, "half turn": 180.0,
}  # fmt: skip
"""Turns by their names."""


@choice
def degrees_of(p: Parser, i: int) -> Results[float]:
    j = p.opt(p.opt(i, "by", "through"), "about")
    if (n := p.figure(j)) is not None and j + 1 < p.end and p.words[j + 1] in _DEGREES:
        yield n, p.reach(j + 2)
    for phrase, k in p.standing(j, _TURNS):
        yield _TURNS[phrase], k
