"""What blocks do in a story, and would like to, as rows that say where they are: "takes a nap on" is sleeps on, "hops
onto" is goes onto, "refuses to sit on" is does not want to, "guards it from the left" is to the left of it."""

from __future__ import annotations

from collections.abc import Iterator

from rpg.language import lexicon
from rpg.language.grammar.rows.said_short import THING
from rpg.language.grammar.rows.turned import Turn

_HARD = "(?:right |directly |just |immediately |safely |close |high )?"
_WHERE = (
    f"(?={_HARD}(?:on|onto|upon|atop|in|inside|under|underneath|below|beneath|next|beside|by|near|between|behind|left|"
    "right|among|above|against|over there|there|side by side|at|to the (?:left|right))\\b)"
)
_WHITHER = (
    f"(?={_HARD}(?:on|onto|upon|atop|into|under|underneath|next|beside|between|behind|in front|in between|left of|"
    "right of|to (?!the (?:left|right|top|front|back)(?! (?:half|corner|of)\\b)))\\b)"
)
_WILL = (
    "(?<=to )|(?<=must )|(?<=should )|(?<=shall )|(?<=will )|(?<=may )|(?<=can )|(?<=not )|(?<=and )|(?<=s )|"
    "(?<=block )|(?<=cube )|(?<=one )|"
    f"(?<= [a-z] )|{'|'.join(f'(?<={color} )' for color in lexicon.COLORS)}"
)
"""What stands before a verb that tells nobody's doing by its form, or several that do it."""
_STILL = (
    "doze|slumber|snore|nap|play|ride|wait|lurk|linger|crouch|squat|kneel|bask|sunbathe|reign|huddle|cuddle|snuggle|"
    "curl"
)
_MOVED = "hop|leap|jump|climb|clamber|crawl|scramble|fly|walk|run|wander|march|stroll|hurry|swim|travel|tiptoe|waddle"
_HAS_MOVED = "(?:climbed|hopped|jumped|leapt|leaped|crawled|clambered|fallen asleep|settled|sat)(?: up| down| over)?"
_ING = {"nap": "napping", "hop": "hopping", "run": "running", "swim": "swimming", "squat": "squatting"}
_REST = "(?:little |short |quick |long |good )?(?:nap|rest|break|seat|snooze|siesta|breather|catnap)"
_GUARD = "(?:guard|watch|sentry|sentinel|lookout)"
_STATE = (
    "(?:fast |sound |already )?(?:asleep|at rest|on guard|on watch|on duty|on the lookout|at home|waiting|hiding|"
    "dozing|snoring|playing|dreaming)"
)


def _s(verb: str) -> str:
    stem = verb[:-1] + "ie" if verb in ("fly", "hurry") else verb + "e" * verb.endswith(("sh", "ch", "go"))
    return f"{stem}s"


def _ing(verb: str) -> str:
    return _ING.get(verb, verb.removesuffix("e") + "ing")


def _in_each_form(verbs: str, behind: str, plain: tuple[str, str, str]) -> Iterator[Turn]:
    """Verbs with what follows them, as a plain one in the same form."""
    each = verbs.split("|")
    yield f"(?:{_WILL})(?:{verbs}){behind}", plain[0]
    yield f"\\b(?:{'|'.join(map(_s, each))}){behind}", plain[1]
    yield f"\\b(?:{'|'.join(map(_ing, each))}){behind}", plain[2]


_SLEEP = ("sleep", "sleeps", "sleeping")
_STAND = ("stand", "stands", "standing")
_SIT = ("sit", "sits", "sitting")
_GO = ("go", "goes", "going")
_ON_TOP = ("stand on top of", "stands on top of", "standing on top of")
_IN = ("stand in", "stands in", "standing in")

DOINGS: tuple[Turn, ...] = (
    # who rests or watches there
    *_in_each_form("take|have", f" an? {_REST} {_WHERE}", _SLEEP),
    *_in_each_form("keep|stand", f" {_GUARD} {_WHERE}", _STAND),
    *_in_each_form("keep|stand", f" {_GUARD} from (?:the )?top of (?=the|an?)", _ON_TOP),
    *_in_each_form("go|get", f" to (?:sleep|bed|rest) {_WHERE}", _SLEEP),
    *_in_each_form("fall", f" (?:fast )?asleep {_WHERE}", _SLEEP),
    *_in_each_form(_STILL, f"(?: up| down| out| around| piggyback)? {_WHERE}", _SIT),
    *_in_each_form("sit|settle|lie|lay|rest", f" (?:itself |themselves )?down {_WHERE}", _SIT),
    *_in_each_form("have|make", f" (?:its|their|an?) (?:home|house|place|bed|nest|throne) {_WHERE}", _SLEEP),
    *_in_each_form("go|come|get", " for a (?:walk|stroll|march|hike) in (?=single file|an? (?:row|line))", _IN),
    (f"\\b(is|are|be|being|lies|lie) {_STATE} {_WHERE}", "{1}"),
    # who gets there
    (f"\\bhelp ((?:the|an?|this|my) [^,:]+?)(?: to)? (?:get|go|come|climb|move)(?: up| over| back| down| safely)? "
     f"{_WHITHER}", "move {1} "),
    *((f"\\b(?:{goes}) to (?:sit|stand|lie|sleep|rest)(?: down)? {_WHERE}", plain)
      for goes, plain in (("goes|comes|runs|hurries|walks", "goes"), ("go|come|run|hurry|walk", "go"))),
    *_in_each_form("go|come|get|walk|run", " (?:back )?home (?=to (?:the|its|their|an?)\\b)", _GO),
    *_in_each_form(_MOVED, f"(?: up| down| off| over| along| across| back)? {_WHITHER}", _GO),
    *((f"\\b{has} {_HAS_MOVED} {_WHITHER}", plain) for has, plain in (("has", "is"), ("have", "are"))),
    (f"^({THING}) (?:visits|meets|goes to (?:visit|see|meet)) ({THING})(?: ,)? and (\\w+(?: down)? (?:on|on top of|"
     "next to|beside|behind|in front of|under|on the (?:left|right) of|to the (?:left|right) of)) (?:it|him|her)$",
     "{1} {3} {2}"),
    # who watches whom
    *((f"\\b{guards}( {THING}) from {told}$", f"{plain} {side} {{1}}")
      for guards, plain in (("(?:guards|watches|protects|shields)", "is"), ("(?:guard|watch|protect|shield)", "are"))
      for told, side in (("the left(?: side)?", "to the left of"), ("the right(?: side)?", "to the right of"),
                         ("behind", "behind"), ("the front", "in front of"))),
)  # fmt: skip
"""What they do."""

_EAGER = "(?:eager|happy|glad|dying|keen)"
_GLADLY = "would (?:love|prefer|so like|really like)"
_LOVES = f"(?:longs|yearns|loves|prefers|decides|has decided|chooses|hopes|wishes|begs|is {_EAGER}|{_GLADLY})"
_LOVE = f"(?:long|yearn|love|prefer|decide|have decided|choose|hope|wish|beg|are {_EAGER}|{_GLADLY})"
_DOES = "(?:sit|stand|lie|be|rest|sleep|stay|touch|go)"
_ANYBODY = "(?:anybody|anyone)(?: else)?"
_ATOP = (
    "(?: be| sit| stand| lie| climb| sleep| sitting| standing)? (?:on top of (?:it|him|her)|on top|on (?:it|him|her)|"
    "on (?:its|his|her) (?:head|back|top|shoulders))"
)

WISHES: tuple[Turn, ...] = (
    *((f"\\b{loves} to (?={_DOES}\\b)", f"{wants} to ")
      for loves, wants in ((_LOVES, "wants"), (_LOVE, "want"), ("refuses", "does not want"),
                           ("refuse", "do not want"))),
    # nobody is nothing else
    ("\\b(not (?:want to |wish to )?(?:touch|(?:be |sit |stand |lie |sleep )(?:next to|near|beside|close to)))"
     f" {_ANYBODY}(?= |$)", "{1} anything"),
    (f"^({THING}) (?:do|does) not (?:want|like|let|allow) (?:{_ANYBODY}|any block|any other block|other blocks)(?: to)?"
     f"{_ATOP}$", "nothing may be on {1}"),
    (f"^({THING}) (?:wants|likes|lets|allows) (?:nobody|no one|none|nothing)(?: to)?{_ATOP}$",
     "nothing may be on {1}"),
)  # fmt: skip
"""What they would like, and what they would not."""
