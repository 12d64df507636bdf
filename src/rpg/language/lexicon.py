"""The words of the language: plain tables from what people write to what it stands for.

Each table maps a sense to the words that have it; `LEXICON[category][word]` is the way back. Words that
only the grammar names (prepositions, determiners) stand in its rules.
"""

from __future__ import annotations

COLORS = {
    "red": "red crimson scarlet maroon ruby cherry reddish",
    "orange": "orange tangerine",
    "yellow": "yellow gold golden yellowish",
    "green": "green lime emerald olive jade greenish",
    "cyan": "cyan teal turquoise aqua",
    "blue": "blue navy azure cobalt sapphire bluish",
    "purple": "purple violet lilac lavender mauve plum purplish",
    "pink": "pink magenta rose fuchsia pinkish",
    "brown": "brown beige tan brownish",
    "black": "black",
    "gray": "gray grey grayish greyish",
    "white": "white",
}
RAINBOW = ("red", "orange", "yellow", "green", "cyan", "blue", "purple", "pink")
SHADES = (
    "light dark bright pale deep vivid sky royal baby ocean midnight electric powder forest grass mint neon lemon "
    "canary hot pastel jet snow charcoal chocolate blood tomato cherry"
)
"""What stands ahead of a colour and tells no other one of the palette."""

NUMBERS = {
    0: "zero", 1: "one", 2: "two", 3: "three", 4: "four", 5: "five", 6: "six", 7: "seven", 8: "eight", 9: "nine",
    10: "ten", 11: "eleven", 12: "twelve", 13: "thirteen", 14: "fourteen", 15: "fifteen", 16: "sixteen",
    17: "seventeen", 18: "eighteen", 19: "nineteen", 20: "twenty", 30: "thirty", 40: "forty", 50: "fifty",
    60: "sixty", 70: "seventy", 80: "eighty", 90: "ninety",
}  # fmt: skip
ORDINALS = {
    1: "first 1st", 2: "second 2nd", 3: "third 3rd", 4: "fourth 4th", 5: "fifth 5th", 6: "sixth 6th",
    7: "seventh 7th", 8: "eighth 8th", 9: "ninth 9th", 10: "tenth 10th",
}  # fmt: skip
UNITS = {
    "0.01": "cm centimeter centimeters centimetre centimetres cms",
    "0.001": "mm millimeter millimeters millimetre millimetres",
    "0.1": "dm decimeter decimeters decimetre decimetres",
    "0.0254": "inch inches in",
    "1": "m meter meters metre metres",
}
DEGREES = "degree degrees deg °"

BLOCK_NOUNS = "block cube brick box"
LOOSE_BLOCK_NOUNS = "object item piece stone thing part workpiece sample specimen element toy component module die"
PATCH_NOUNS = (
    "patch target goal mat spot zone area pad marker mark carpet rug field sheet coaster "
    "placemat napkin cloth towel sticker dropzone dot destination paper strip tray marking"
)
TABLE_NOUNS = "table tabletop workspace desk surface counter"
LETTER_NOUNS = "letter character"
DIGIT_NOUNS = "number digit numeral"
SYMBOL_NOUNS = "symbol sign"

STRUCTURES = {
    "stack": "stack tower skyscraper pillar",
    "row": "row",
    "line": "line queue lineup sequence countdown",
    "column": "column file",
    "grid": "grid matrix array",
    "checkerboard": "checkerboard chessboard",
    "wall": "wall",
    "pyramid": "pyramid",
    "staircase": "staircase stair stairway step stairs steps",
    "square": "square frame",
    "rectangle": "rectangle oblong",
    "triangle": "triangle",
    "circle": "circle ring loop",
    "plus": "plus cross",
    "pile": "pile heap jumble bunch cluster group bundle clump",
    "word": "word name acronym abbreviation",
    "equation": "equation sum formula multiplication addition subtraction division calculation product",
    "set": "set collection bunch_of",
}
SHAPE_ADJECTIVES = {
    "circle": "circular round ring_shaped",
    "square": "square",
    "rectangle": "rectangular",
    "triangle": "triangular",
    "staircase": "staircase",
}

SIZES = {"big": "big large huge giant", "small": "small little tiny mini", "medium": "medium standard normal"}
BIG_EDGE, MEDIUM_EDGE, SMALL_EDGE = 0.05, 0.04, 0.03

VERBS = {
    "place": "put place add move set position lay bring transfer relocate drop push slide shift carry get deliver "
    "locate seat rest insert nudge drag pull deposit return hide balance tuck perch settle stick sandwich "
    "stand mount shove scoot whack chuck slap stash pose plop plant pop stow park sit load lower dump bung "
    "heave hoist install wedge fit slot squeeze center pack squish squash cram jam plonk toss plunk land lodge situate "
    "station nestle dock post deploy ferry haul lug guide send ship convey reposition store assign allocate serve "
    "shelve transport transplant shuttle dispatch maneuver manoeuvre steer escort rehome relegate banish exile",
    "pick": "pick grab grasp lift take find choose select fish dig retrieve snatch seize",
    "stack": "stack pile heap restack",
    "build": "build make create construct form assemble erect produce compose draw rebuild shape craft fabricate "
    "complete generate design fashion raise realize realise manufacture sculpt implement provide reproduce recreate "
    "render engineer establish simulate",
    "arrange": "alphabetize alternate space arrange align order organize organise line lay distribute spread position "
    "configure set rearrange straighten display present exhibit",
    "sort": "sort group gather herd cluster separate collect split divide partition categorize classify bunch merge "
    "combine unite segregate bundle lump crowd huddle",
    "spell": "spell write",
    "turn": "rotate turn flip spin face orient point tip transform convert change pivot swivel",
    "reverse": "reverse",
    "swap": "swap exchange switch interchange trade",
    "keep": "keep leave",
    "unstack": "unstack unload dismantle disassemble topple destack unpile tear demolish",
    "use": "use take",
    "touch": "touch disturb bump knock jostle",
    "ignore": "ignore",
    "remove": "remove clear empty",
}
PAST = {
    "put": "put", "place": "placed", "move": "moved", "set": "set", "lay": "laid", "bring": "brought",
    "get": "got", "take": "taken", "stack": "stacked", "pile": "piled", "build": "built", "rebuild": "rebuilt",
    "make": "made",
    "form": "formed",
    "spread": "spread", "split": "split", "spell": "spelled spelt", "write": "written", "keep": "kept", "leave": "left",
    "draw": "drawn", "swap": "swapped", "flip": "flipped", "spin": "spun", "tip": "tipped", "tear": "torn tore",
    "transfer": "transferred", "drag": "dragged", "hide": "hidden hid", "stick": "stuck", "drop": "dropped",
    "send": "sent", "ship": "shipped", "lug": "lugged",
    "grab": "grabbed", "cram": "crammed", "jam": "jammed", "choose": "chosen",
    "fit": "fitted", "slot": "slotted", "carry": "carried",
    "classify": "classified", "empty": "emptied", "sit": "sat", "slide": "slid", "stand": "stood",
}  # fmt: skip
DOUBLED = {
    "put": "putting", "set": "setting", "get": "getting", "split": "splitting", "swap": "swapping", "flip": "flipping",
    "spin": "spinning", "tip": "tipping", "transfer": "transferring", "drag": "dragging", "drop": "dropping",
    "ship": "shipping", "lug": "lugging",
    "grab": "grabbing", "cram": "cramming", "jam": "jamming", "sit": "sitting", "fit": "fitting", "slot": "slotting",
}  # fmt: skip
POSTURES = (
    "is are be being been was were sits sit sitting stands stand standing rests rest resting lies lie lying "
    "lay lays laying sleeps sleep sleeping stays stay stayed staying remains remain remained remaining seen shown "
    "visible come comes coming serve serves ends end goes go located positioned placed put found situated ending "
    "lounges lounge lounging camps camp camping naps napping dozes dozing snoozing relaxes relaxing sunbathing "
    "resides reside belong belongs live lives appear appears hidden act acts finish finishes finished "
    "wedged jammed tucked perched lodged squeezed nestled seated mounted balanced"
)


def _back(table: dict[str, str]) -> dict[str, str]:
    return {word: sense for sense, words in table.items() for word in words.split()}


def plural_of(noun: str) -> str:
    """The regular plural of an English noun."""
    if noun.endswith(("s", "x", "ch", "sh")):
        return noun + "es"
    if noun.endswith("y") and noun[-2] not in "aeiou":
        return noun[:-1] + "ies"
    return noun + "s"


def _nouns(words: str) -> dict[str, bool]:
    """Word -> whether it is a plural."""
    found: dict[str, bool] = {}
    for noun in words.split():
        found[plural_of(noun)] = True
        found[noun] = False
    return found


def _inflected(verb: str) -> dict[str, str]:
    """Form -> "base", "s", "ing" or "past"."""
    stem = verb[:-1] if verb.endswith("e") else verb
    forms = {plural_of(verb): "s", DOUBLED.get(verb, stem + "ing"): "ing"}
    for past in PAST.get(verb, stem + "ed").split():
        forms[past] = "past"
    forms[verb] = "base"
    return forms


def _verbs() -> dict[str, tuple[tuple[str, str, str], ...]]:
    found: dict[str, list[tuple[str, str, str]]] = {}
    for sense, words in VERBS.items():
        for verb in words.split():
            for form, tense in _inflected(verb).items():
                found.setdefault(form, []).append((sense, verb, tense))
                if form == PAST.get(verb):
                    continue
                if tense == "past" and form == verb:
                    found[form].append((sense, verb, "base"))
    for word in ("put", "set", "spread", "split"):
        found[word] += [(s, v, "base") for s, v, t in found[word] if t == "past"]
    return {form: tuple(dict.fromkeys(senses)) for form, senses in found.items()}


def _structures() -> dict[str, tuple[str, bool]]:
    found: dict[str, tuple[str, bool]] = {}
    for kind, words in STRUCTURES.items():
        for word in words.split():
            if not word.endswith("s") or word == "cross":
                found[plural_of(word)] = (kind, True)
            found[word] = (kind, False)
    return found


COLOR = _back(COLORS)
COLOR_PLURAL = {plural_of(word): sense for word, sense in COLOR.items()}
NUMBER = {word: n for n, word in NUMBERS.items()}
ORDINAL = {word: n for n, words in ORDINALS.items() for word in words.split()}
UNIT = {word: float(factor) for factor, words in UNITS.items() for word in words.split()}
BLOCK = _nouns(BLOCK_NOUNS)
LOOSE_BLOCK = _nouns(LOOSE_BLOCK_NOUNS) | {"dice": True}
PATCH = _nouns(PATCH_NOUNS)
TABLE = _nouns(TABLE_NOUNS)
LETTER = _nouns(LETTER_NOUNS) | {"initials": True}
DIGIT = _nouns(DIGIT_NOUNS)
SYMBOL = _nouns(SYMBOL_NOUNS)
STRUCTURE = _structures()
SHAPE_ADJECTIVE = _back(SHAPE_ADJECTIVES)
SIZE = _back(SIZES)
VERB = _verbs()
POSTURE = frozenset(POSTURES.split())
SHADE = frozenset(SHADES.split())
COMMANDS = frozenset(word for word, forms in VERB.items() if any(tense == "base" for _, _, tense in forms))
"""Verbs as commands have them: "put", and not "puts"."""
