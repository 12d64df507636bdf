"""Talk around an instruction: sentences, and parts of them set off by a comma, of words that ask for nothing of blocks.

Who wants it, what for, how it feels. None of these words is a block, a look, a number, a place, or something done to
blocks; a few that could be ("on", "first", "not") are taken for talk only before what makes them so.
"""

from __future__ import annotations

from collections.abc import Sequence

from rpg.language import lexicon
from rpg.language.grammar.talk.people import PEOPLE
from rpg.language.tokens import Token


def _words(*rows: str) -> frozenset[str]:
    return frozenset(word for row in rows for word in row.replace("|", " ").split())


_PERSONS = _words(
    PEOPLE,
    "robot robots machine helper assistant computer folks everyone everybody somebody someone guest visitor newcomer "
    "beginners supervisor manager director researcher researchers scientist engineer engineers designer editor artist "
    "photographer photographers parents neighbor neighbors uncle aunt cousin lady gentlemen ladies humans human "
    "baby toddler toddlers buddy partner mentor coach trainee apprentice apprentices girl boy girls boys examiner jury",
)
_ERRANDS = _words(
    "task tasks job jobs request requests plan idea goal instruction instructions wish exercise challenge puzzle "
    "question questions mission game games assignment demo demos demonstration test tests experiment experiments show "
    "presentation video videos photo photos paper lesson lessons class classes course lecture lectures school homework "
    "exam exams project projects birthday party story workshop practice training session poster website report thesis "
    "trick contest competition tournament fair festival exhibition museum library lab laboratory kindergarten nursery "
    "university college office benchmark experiment evaluation tutorial book magazine article brochure catalog "
    "picture pictures film movie stage play reason reasons thing news help favor chance time while day days morning "
    "afternoon evening night tomorrow yesterday week weekend month year monday tuesday wednesday thursday friday "
    "saturday sunday christmas easter holiday holidays moment minute future habit work breakfast lunch dinner "
    "description procedure assembly classroom audience science math art physics robotics history geometry",
)
_FEELINGS = _words(
    "thanks thank sorry hello hi hey welcome greetings obliged grateful appreciate appreciated appreciates easy simple "
    "fun difficult tricky important excited ready curious kind willing careful precise quick helpful great nice lovely "
    "wonderful perfect cool awesome amazing fantastic brilliant glad happy pleased proud delighted bored tired busy "
    "interested fond fancy favorite silly funny urgent complicated boring exciting interesting impressive useful cute "
    "pretty beautiful worry hurry rush patience apologies excuse pardon cheers bye goodbye congratulations luck best "
    "friendly clever smart accurate gentle patient honest fair warm bother trouble enjoy enjoys love loves hope hopes "
    "pleasure joy mood shame pity surprise mind",
)
_STRONG = _PERSONS | _ERRANDS | _FEELINGS
_GLUE = _words(
    "i we you he she they it this that these me us them him her my our your his their its mine yours "
    "am is are was were be been being do does did have has had having will would can could may might shall should must "
    "a an the of for to with about and but because since so as too also just now then today tonight here again really "
    "very quite much many lot lots bit little big whole more most enough still already soon later once ever yet only "
    "simply actually always often usually sometimes finally anyway well okay ok alright right yes what how why who "
    "whom where when which there some any every all other another new old young younger older good bad real special "
    "want wants wanted need needs needed like likes liked think thinks thinking thought know knows guess believe say "
    "says said tell tells told ask asks asked asking call called mean means matter teach teaches teaching learn learns "
    "learning study studying practise practising practicing preparing prepare prepares film filming shoot shooting "
    "record recording explain explaining present presenting testing try trying tries "
    "playing plays played working works help helping helps happen happens going gone go come comes coming look looks "
    "looking seeing see watch watching sounds seems feel feels "
    "imagine imagining wonder wondering thinking talk talking gives given doing done writing going decided "
    "planning plans use used using visiting visit tested bring brings wait waiting let listen "
    "s open sure long hear heard read reading remember forget welcome organizing organising control controlling "
    "operate operating programmed program understand",
)
_SUBJECTS = _words("colors letters numbers digits shapes blocks cubes towers patterns words equations figures order")
_LIKED = _words("about love loves like likes learn learning study studying teach teaching practise practising "
                "practicing practice enjoy enjoys favorite with")  # fmt: skip
"""What letters, colours and the like as such may come after: "we are learning about colours"."""
_PLACED = _words("in on at from by during after before under through")
_TURN = _words("first second third next last final main only same open")
_NEGATED = _words("not no never nothing")
_CALM = _words("sure much long fair far any") | _FEELINGS
_VAGUE = _words("you we i it that he she they everyone")


def small_talk(tokens: Sequence[Token]) -> bool:
    """Whether these words ask for nothing."""
    words = [token.word for token in tokens]
    if not words or _STRONG.isdisjoint(words):
        return False
    return all(token.kind in ("word", "punct") and _talk(token, words, n) for n, token in enumerate(tokens))


def _talk(token: Token, words: list[str], n: int) -> bool:
    """Whether a word among others is one that asks for nothing."""
    if token.kind == "punct" or (len(token.raw) > 1 and token.raw.isupper()):
        return token.word in (",", "'s", "…")
    after = words[n + 1 : n + 5]
    match token.word:
        case word if word in _NEGATED:
            return not _CALM.isdisjoint(after[:3])
        case word if word in _TURN:
            return not _ERRANDS.isdisjoint(after[:2])
        case word if word in _PLACED:
            named = next((k for k, x in enumerate(after) if x in _PERSONS or x in _ERRANDS), None)
            return named is not None and all(x in _GLUE | _FEELINGS | _TURN for x in after[:named])
        case "if":
            return bool(after) and after[0] in _VAGUE
        case "one":
            return n > 0 and words[n - 1] in ("this", "that", "quick", "easy", "simple", "last", "next")
        case word if word in _SUBJECTS:
            return not _LIKED.isdisjoint(words[max(0, n - 3) : n])
    return token.word in _GLUE or token.word in _STRONG


_TASTES = _words("love loves like likes adore adores prefer prefers enjoy enjoys is fond favorite color")
_FOND = _TASTES - {"is", "color"}
_HUES = frozenset({*lexicon.COLOR, *lexicon.COLOR_PLURAL})
_SO = 12
"""So many words at most tell of a taste."""


def taste_told(tokens: Sequence[Token]) -> int:
    """ "My daughter loves purple, so make ...": where what follows from a liking begins; 0 where none is told."""
    words = [token.word for token in tokens[:_SO]]
    so = next((n for n, word in enumerate(words[:-1]) if word in (",", ".") and words[n + 1] == "so"), 0)
    said = words[:so]
    hues = [n for n, word in enumerate(said) if word in _HUES]
    if not hues or said[-1] not in _HUES or "would" in said or _FOND.isdisjoint(said[: hues[0]]):
        return 0
    rest = [(n, token) for n, token in enumerate(tokens[:so]) if n not in hues and token.word not in _TASTES]
    return so + 2 if all(_talk(token, words, n) for n, token in rest) else 0


_SET_OFF = frozenset({",", ":"})
_JOINS = frozenset({"so", "and", "but"})


def without_talk(tokens: list[Token]) -> list[Token] | None:
    """The words without the talk that they begin or end with; None where there is none."""
    if small_talk(tokens):
        return []
    marks = [n for n, t in enumerate(tokens) if t.word in _SET_OFF or t.word in _JOINS]
    for n in reversed(marks):
        if small_talk(tokens[:n]):
            return _wished(tokens[n + 1 :])
    for n in marks:
        if tokens[n].word in _SET_OFF and small_talk(tokens[n + 1 :]):
            return tokens[:n]
    return None


_WISHED = frozenset({"need", "want", "would", "wish"})


def _wished(tokens: list[Token]) -> list[Token]:
    """ "We are making a video and need a row": who needs it was said before."""
    if not tokens or tokens[0].word not in _WISHED:
        return tokens
    first = tokens[0]
    return [Token("word", "we", first.raw, first.span), *tokens]
