"""Words that tell of a task: looks, blocks, numbers, shapes, places, order, size, and what is done to blocks."""

from __future__ import annotations

from collections.abc import Collection, Sequence
from itertools import pairwise

from rpg.language import lexicon
from rpg.language.harmless import EVERYDAY
from rpg.language.tokens import Token
from rpg.language.word_lists import listed

_ALWAYS: tuple[Collection[str], ...] = (
    lexicon.COLOR, lexicon.COLOR_PLURAL, lexicon.BLOCK, lexicon.PATCH, lexicon.STRUCTURE, lexicon.NUMBER,
    lexicon.ORDINAL, lexicon.LETTER, lexicon.DIGIT, lexicon.SYMBOL, lexicon.SIZE,
    listed(
        "left right top bottom middle center front back behind order first last not no never without none upside "
        "reversed reverse touching apart each every"
    ),
)  # fmt: skip
_LIGHT = listed(
    "get gets got getting take takes took taken taking make makes made making give show shows showed find finds found "
    "send sends sent sending sit sits sat stand stands stood keep keeps kept serve serves served ordered write writes "
    "wrote written writing drop dropped order leave leaves left pack packed load loaded shift land landed turn turns "
    "turned stick store split draw drew drawn drawing face ship bring brings brought fit return choose chose pose "
    "guide collect stuck painted rest assemble deliver cut learn park craft"
)
"""What is done to blocks, and as often something else."""
_OF_BLOCKS = listed(
    "side sides corner corners edge edges face faces surface table tables tabletop workspace half halves quarter gap "
    "gaps space spaces room spacing distance distances layer layers level levels base above below under underneath "
    "beneath over between beside beneath around across through inside outside within near nearer close closer closest "
    "far farther further away next adjacent high higher highest low lower lowest tall taller tallest short shorter "
    "wide wider narrow deep long longer length height width size sizes bigger smaller larger equal equally same "
    "different other others another else rest remaining together alone separate separated free clear empty covered "
    "straight diagonal diagonally horizontal vertical upright tilted flat round even evenly odd uneven crooked "
    "symmetrical symmetric mirrored mirror pattern patterns alternating alternate alternately direction upwards "
    "downwards up down facing visible hidden touch touches contact aligned align centered balanced position positions "
    "place places placed color colors shape shapes sequence sorted mixed twice once only all both any some few many "
    "more most fewer less than exactly if unless until except instead or nor symmetry asymmetry asymmetric "
    "symmetrically asymmetrical parallel perpendicular zigzag spiral slanted leaning lean clockwise counterclockwise "
    "anticlockwise colorful colourful monochrome rainbow palindrome overlap overlapping overhang offset staggered "
    "scattered spread clutter cluttered tidy untidy neat neatly stable unstable steady sturdy firm firmly backwards "
    "forwards sideways vertically horizontally centrally central outermost innermost nearby opposite blocked aligning "
    "alignment toward towards against along onto sequence sequences arrangement arrangements"
)

LAID_OUT = listed("phone telephone keypad keypads calculator numpad keyboard dice die domino dominoes clock calendar")
"""What has its symbols in a certain order: "like on a phone" is no talk."""

_COLORED = listed("traffic flag flags zebra bee bees bumblebee wasp tiger skunk lighthouse candy pole piano sandwich "
                  "burger hamburger oreo watermelon rainbow sunset sunrise caterpillar football")  # fmt: skip
"""What has its colours in an order of its own."""
_ORDER_TOLD = listed("top bottom under below over above on then order first last left right alternating alternately")


def in_its_order(words: Collection[str], said: Collection[str]) -> bool:
    """Whether what blocks are like tells in which order their colours come, and nothing else that was said does."""
    several = len({lexicon.COLOR[word] for word in said if word in lexicon.COLOR}) > 1
    return several and not _COLORED.isdisjoint(words) and _ORDER_TOLD.isdisjoint(said)


SHAPES = listed(
    "zig zag zigzags spirals hexagon pentagon octagon heptagon polygon rhombus arc arch semicircle crescent helix "
    "trapezoid trapezium parallelogram oval ellipse sphere dome cylinder cone chevron herringbone honeycomb lattice "
    "pentagram hexagram labyrinth maze serpentine horseshoe hourglass wedge whirl swirl coil vortex fishbone quincunx "
    "meander asterisk cuboid prism tetrahedron boomerang squiggle wiggle curve wavy curvy curved "
    "topsy turvy askew lopsided"
)
"""Names of shapes that blocks have in no task, but that would be asked for."""

_HOW = ("ly", "wise", "ways", "ward", "wards")
"""So words end that tell how, and may tell how blocks lie."""


def tells(token: Token) -> bool:
    """Whether a word tells of the task, wherever it stands."""
    shown = token.kind in ("number", "dims", "literal", "quote") or (len(token.raw) == 1 and token.raw.isupper())
    return (shown and token.word != "a") or any(token.word in table for table in _ALWAYS)


def may_tell(word: str) -> bool:
    """Whether a word could tell of blocks even where people are spoken of."""
    handled = word in lexicon.VERB and word not in _LIGHT
    return handled or word in _OF_BLOCKS or word in SHAPES or any(word in table for table in _ALWAYS)


def turns(words: Sequence[str]) -> bool:
    """ "Turn it round": what there is would be another way round."""
    return any(verb in _TURNING and it in _IT for verb, it in pairwise(words))


_TURNING = listed("turn flip rotate spin reverse invert swap switch")
_IT = listed("it them this that these those both")


def may_tell_how(word: str) -> bool:
    """Whether a word that is not known may tell how something is done, or how blocks lie: "crookedly"."""
    return word.endswith(_HOW) and word not in EVERYDAY
