"""Talk around an instruction: sentences, and parts of them set off by a comma, of words that ask for nothing of blocks.

Who wants it, what for, how it feels. None of these words is a block, a look, a number, a place, or something done to
blocks; a few that could be ("on", "first", "not") are taken for talk only before what makes them so.
"""

from __future__ import annotations

from collections.abc import Sequence
from itertools import pairwise

from rpg.language import harmless, lexicon
from rpg.language.grammar.talk.people import WORKERS
from rpg.language.spelling import vocabulary
from rpg.language.telling import may_tell
from rpg.language.tokens import Token
from rpg.language.word_lists import listed

_ERRANDS = harmless.OCCASIONS - listed(
    "everything something way ways while time times bit lot lots stuff sort kind present"
) | listed(
    "assembly catalog chance classroom description geometry goal help instruction instructions picture pictures "
    "procedure robotics session stage trick tricks work"
)
_FELT = listed(
    "thanks thank sorry hello hi hey welcome greetings appreciate appreciates careful complicated enjoy enjoys enjoyed "
    "fancy gentle impressive mind precise accurate quick warm thrill love loves hope hopes hurry rush bother trouble"
)
_FEELINGS = _FELT | harmless.FINE | harmless.PERSONAL
PERSONS = harmless.PEOPLE | listed("computer examiner gentlemen human humans machine mentor robot robots")
_STRONG = PERSONS | _ERRANDS | _FEELINGS | {"sure"}
_GLUE = listed(
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
    "please kindly 'm 're 'd 'll 've s open sure long hear heard read reading remember forget welcome organizing "
    "organising control controlling name names "
    "start starts started "
    "operate operating programmed program understand out myself yourself ourselves himself herself such sound nicer "
    "perfectly",
)
_SUBJECTS = listed("colors letters numbers digits shapes blocks cubes towers patterns words equations figures order")
_LIKED = listed("about love loves like likes learn learning study studying teach teaching practise practising "
                "practicing practice enjoy enjoys favorite with")  # fmt: skip
"""What letters, colours and the like as such may come after: "we are learning about colours"."""
_PLACED = listed("in on at from by during after before under through")
_TURN = listed("first second third next last final main only same open")
_NEGATED = listed("not no never nothing")
_ABLE = listed("can could")
_CALM = listed("sure much long fair far any worry worried scared nervous") | _FEELINGS
_POLITELY = listed("can could may please would do ok okay fine possible alright")
_UNSURE = listed("curious wonder wondering know see sure ask doubt excuse forgive sorry pardon me")
_VAGUE = listed("you we i it this that he she they everyone")


_LEADS = listed("and but so please then also now just , well okay ok")
_ADDRESSED = listed(
    "thank hope guess imagine wish love enjoy trust forgive remember think suppose believe excuse wonder listen wait "
    "care worry mind hurry understand apologize apologise like need want appreciate expect pity please know"
)
_MORE_TO_DO = listed("bring write read use open let present watch look control operate start stop sit stand")
_DOABLE = (harmless.VERBS | _MORE_TO_DO) - _ADDRESSED
"""Commands that would be something else to do."""
_YIELDING = {("let", "me"), ("let", "us"), ("do", "you"), ("do", "not"), ("help", "me"), ("help", "us"),
             ("thank", "you"), ("pardon", "me"), ("watch", "out"), ("look", "here"), ("come", "on")}  # fmt: skip
"""Begun so they ask for nothing of their own."""
_HEADINGS = listed("exercise test practice request quiz challenge")
_SPEAKERS = listed("i we he she my our his her")
_HANDLING = listed(
    "make makes making made take takes taking took give gives giving gave given get gets getting got do does doing did "
    "done show shows buy buys sell sells"
)
_DAILY = (harmless.TIMES - {"second"}) | harmless.THINGS | harmless.ANIMALS | (harmless.DOINGS - _HANDLING)
"""What people have about them, and do, of whom it is told."""
_SOMEWHERE = _PLACED | listed("behind beside around near over next along since until till within")
_WHERE_PEOPLE_ARE = PERSONS | _ERRANDS | harmless.NAMES | harmless.THINGS | listed("me us you him her them work home")
"""What places of people are told by: "in the kitchen", "right next to me"."""
_POSTURES = listed(
    "stand stands standing sit sits sitting lie lies lying stood sat lay rest resting stay stays staying"
)
SAID_OF_SCENES = listed("picture pictures photo photos photograph scene image goal task tasks plan description "
                        "geometry session result assembly way everything something thing things rule")  # fmt: skip
"""Whatever is told of these may be told of blocks."""
_ABOUT = (harmless.THINGS | harmless.ANIMALS | harmless.OCCASIONS) - SAID_OF_SCENES
_ONES_OWN = listed("my our his her their me us mine yours")
_OF_OURS = listed("is 's was reminds reminded helps helped would will makes made means meant comes came belongs")
_WORKS = listed("works worked went goes sounds sounded looks looked seems seemed")
_WELL = listed("well perfectly badly nicely fine before already too brilliantly smoothly")
_SCENES = listed("arrangement combination design pattern picture logo")
_AHEAD = (
    _LEADS
    | harmless.ADVERBS
    | harmless.INTERJECTIONS
    | listed("when while that because since after before how afterwards")
)
"""What may stand in front of whom it is told of."""
_WORKING = listed("you robot robots machine arm gripper")
"""Of these it is told what they have to do."""
ACTING = WORKERS | listed("children kids students pupils players somebody someone people they user users")
BEING = listed("is am are was were will would can could has have had 's 'm 're 'll")
_DOES = harmless.DOINGS | BEING
_DET = listed("the a an my our your his her their this")
LOOKS_OF_PEOPLE = harmless.FINE | harmless.PERSONAL | listed("little old young big small whole new good next other")
THING = listed("it this that they them these those everything")
_BINDING = listed("should must shall may might ought was were has have had")
_WANTED = listed("want wants wanted need needs needed like likes wish wishes hope hopes")
DEMANDED = _WANTED | listed(
    "would 'd should must shall ought wished hoped prefer prefers preferred insist insists insisted demand demands "
    "demanded "
    "require requires required expect expects expected ask asks asked order orders ordered request requests requested "
    "desire desires say says said tell tells told think thinks thought dream dreams dreamt dreamed "
    "dreaming hoping wishing"
)
"""What is wished for behind these may be told in words that are not known."""
_TAKEN_BACK = (
    "jok", "kidd", "prank", "cancel", "forbid", "forbad", "refus", "disagree", "disapprov", "object", "abort", "scrap",
    "annul", "revok", "retract", "withdr", "veto", "ban", "prohibit", "disallow", "oppos", "mistak", "wrong", "instead",
    "rather", "contrar", "undo", "dislik", "detest", "loath", "reject", "deny", "deni", "misle", "misspoke", "revers",
    "mirror", "lied", "fool", "trick", "pretend",
)  # fmt: skip
"""How words begin that take back what was asked for."""
_CHANGED = listed("plan plans idea ideas wish goal task tasks instruction instructions")
_OTHER = listed("old new other another bad real better best different more")
_HATED = listed("hate hates hated dread dreads fear fears mind minds forget")
_TWICE = listed("again more twice")
_POLITE = listed("thanks thank sorry hello hi welcome once")


def small_talk(tokens: Sequence[Token]) -> bool:
    """Whether these words ask for nothing."""
    words = [token.word for token in tokens]
    offered = words[:1] == ["here"] and words[-2:] == ["for", "you"]  # "here's a scale for you"
    of_people = offered or _of_people(words)
    strong = _STRONG | _DAILY if of_people else _STRONG
    if not words or asks(words):
        return False
    if _of_it(words):
        return True
    if strong.isdisjoint(words) and not offered:
        return False
    return all(
        (token.kind in ("word", "punct") and _talk(token, words, n)) or (of_people and _daily(tokens, words, n))
        for n, token in enumerate(tokens)
    )


def _of_people(words: Sequence[str]) -> bool:
    """Whether somebody is told of, "my wife is waiting", or something of daily life, "the soup gets cold"."""
    at = next((n for n, word in enumerate(words) if word not in _AHEAD), len(words))
    said = words[at:]
    spoken = said[1:] and said[0] in ("i", "we", "he", "she")
    if not said or (not spoken and _DOES.isdisjoint(said[1:])) or not _WORKING.isdisjoint(said[:2]):
        return False
    if not ACTING.isdisjoint(said[:2]) and said[0] not in _SPEAKERS and BEING.isdisjoint(said[1:4]):
        return False  # "the child sings a song" is asked for
    noun = next((word for word in said[1:4] if word not in LOOKS_OF_PEOPLE), "")
    return said[0] in _SPEAKERS or not PERSONS.isdisjoint(said[:2]) or (said[0] in _DET and noun in _ABOUT | PERSONS)


def _of_it(words: Sequence[str]) -> bool:
    """ "It's the logo of our club", "this is what the customer ordered", "yesterday it worked perfectly"."""
    at = next((n for n, word in enumerate(words) if word not in _AHEAD or word == "that"), len(words))
    at += words[at : at + 1] == ["yesterday"]
    if words[at : at + 1] not in (["it"], ["this"], ["that"]) or len(words) < at + 3 or not _NEGATED.isdisjoint(words):
        return False
    verb, behind = words[at + 1], words[at + 2 :]
    whose = _ONES_OWN | harmless.PEOPLE | {"what"}
    if verb in _WORKS:
        return all(word in _GLUE | _FEELINGS | _WELL for word in behind)
    if verb in ("is", "'s") and behind[0] == "for" and behind[-1] in _ABOUT | harmless.PEOPLE and len(behind) < 4:
        return behind[1] in _DET
    if verb not in _OF_OURS or whose.isdisjoint(behind) or "too" in behind or any(map(may_tell, behind)):
        return False
    return all(
        word in _GLUE | _STRONG | _DAILY | _SCENES | harmless.EVERYDAY
        or (is_strange(word) and (behind[max(0, n - 1)] in _DET | {"of", "for"} or word.endswith("ly")))
        for n, word in enumerate(behind)
    )


def _daily(tokens: Sequence[Token], words: Sequence[str], n: int) -> bool:
    """Whether a word of a clause of people is of daily life; or means nothing here,
    and is nothing that is wished for."""
    word = words[n]
    if tokens[n].kind not in ("word", "number") or (len(tokens[n].raw) > 1 and tokens[n].raw.isupper()):
        return False
    after = words[n + 1 : n + 5]
    if word in _SOMEWHERE or (word in _POSTURES and words[0] not in THING):
        return word in _POSTURES or any(x in _WHERE_PEOPLE_ARE or is_strange(x) for x in after[:4])
    pointed = not THING.isdisjoint(words)
    if word in _HANDLING:
        return not pointed and not _ERRANDS.isdisjoint(after[:3])
    if tokens[n].kind == "number" or word in lexicon.NUMBER:
        return not harmless.TIMES.isdisjoint(after[:1])
    return word in _DAILY or (not pointed and DEMANDED.isdisjoint(words) and _of_nothing_here(word))


def _of_nothing_here(word: str) -> bool:
    """Whether a word can tell nothing of blocks where people are spoken of, and takes nothing back."""
    return is_strange(word) or (word.isalpha() and word in vocabulary() and not may_tell(word) and word not in _NEGATED)


def is_strange(word: str) -> bool:
    """Whether a word means nothing here, nor takes anything back."""
    return len(word) > 2 and word.isalpha() and word not in vocabulary() and not word.startswith(_TAKEN_BACK)


def asks(words: Sequence[str]) -> bool:
    """Whether they are a further command, tell what the blocks have to be like, or take back what was said."""
    starts = [0, *(n + 1 for n, word in enumerate(words[:-1]) if word in _LEADS)]
    if any(words[n] in _DOABLE and not _yields(words[n : n + 3]) for n in starts):
        return True
    if takes_back(words) or (not _TWICE.isdisjoint(words) and _POLITE.isdisjoint(words)):
        return True
    pairs = list(pairwise(words))
    told = any(
        word in THING and behind in _BINDING and not _judged(words[n + 1 : n + 4])
        for n, (word, behind) in enumerate(pairs)
    )
    if words[:2] == ["you", "have"] or (words[0] == "you" and len(words) > 1 and words[1] in _DOABLE):
        return True
    if any(
        word in _WANTED and behind in ("a", "an", "one", "some") and _of_things(words[n + 2 : n + 5])
        for n, (word, behind) in enumerate(pairs)
    ):
        return True  # "I want a heart"
    if not _HATED.isdisjoint(words) and not THING.isdisjoint(words):
        return True
    wanted = _WANTED | ({"do"} if words[0] == "does" else {"do", "does"})
    return told or any(
        word in wanted
        and behind in THING
        and _ABLE.isdisjoint(words[max(0, n - 2) : n])
        and not _content(words, n)
        and not _of_an_errand(words, n)
        for n, (word, behind) in enumerate(pairs)
    )


def _of_things(words: Sequence[str]) -> bool:
    return not (harmless.THINGS | harmless.ANIMALS).isdisjoint(words)


def _of_an_errand(words: Sequence[str], n: int) -> bool:
    """ "(I like) this game"."""
    return words[n + 1] in ("this", "that") and not (_ERRANDS - SAID_OF_SCENES).isdisjoint(words[n + 2 : n + 3])


def _content(words: Sequence[str], n: int) -> bool:
    """ "(The kids) like this", "(my wife) likes it that way"."""
    return words[n] in ("like", "likes") and (n + 2 == len(words) or words[n + 2 :] == ["that", "way"])


def _judged(words: Sequence[str]) -> bool:
    """ "(It) may sound silly", "(that) was hard"."""
    if words[1:2] in (["sound"], ["seem"]):
        return True
    liked = [word for word in words[1:] if word not in ("so", "very", "really", "a", "bit")]
    return words[0] in ("was", "has") and bool(liked) and liked[0] in harmless.FINE - {"better"}


def takes_back(words: Sequence[str]) -> bool:
    """Whether the mind was changed, "that was the old plan", "we had better not", or there should be "some more"."""
    bad = any(word == "bad" and behind in _CHANGED | {"example"} for word, behind in pairwise(words))
    if words[-1] in ("more", "another", "too") or bad:
        return True
    other = not _OTHER.isdisjoint(words)
    return other and not (_CHANGED | {"not", "never", "without"}).isdisjoint(words)


def _yields(words: Sequence[str]) -> bool:
    """ "Help me", "tell him:", and "exercise one", "test for today"."""
    errand = words[0] in _HEADINGS or not _ERRANDS.isdisjoint(words[2:])
    named = words[1:2] in (["one"], ["time"], ["of"]) or (words[1:2] == ["for"] and errand)
    return named or tuple(words[:2]) in _YIELDING or tuple(words) == ("tell", "it")  # "tell him:"


def harmless_word(tokens: Sequence[Token], n: int) -> bool:
    """Whether a word among others is one that asks for nothing."""
    return tokens[n].kind in ("word", "punct") and _talk(tokens[n], [token.word for token in tokens], n)


def _talk(token: Token, words: list[str], n: int) -> bool:
    """Whether a word among others is one that asks for nothing."""
    if token.kind == "punct" or (len(token.raw) > 1 and token.raw.isupper()):
        return token.word in (",", "'s", "…")
    after = words[n + 1 : n + 5]
    match token.word:
        case "next" | "rest" if not after and n > 1:
            return words[n - 1] in ("do", "comes", "may", "can", "could", "will")
        case word if word in _NEGATED:
            able = n > 0 and words[n - 1] in _ABLE and words[0] != "you"
            return able or not _CALM.isdisjoint(after[:3])
        case word if word in _TURN:
            return not (_ERRANDS | {"time"}).isdisjoint(after[:2])
        case word if word in _PLACED:
            if word == "at" and after and after[0] in harmless.DOINGS and after[0].endswith("ing"):
                return True
            named = next((k for k, x in enumerate(after) if x in PERSONS | _ERRANDS | harmless.NAMES | {"us"}), None)
            return named is not None and all(x in _GLUE | _FEELINGS | _TURN for x in after[:named])
        case "if":
            asked = not _UNSURE.isdisjoint(words[max(0, n - 3) : n])
            return bool(after) and after[0] in _VAGUE and (asked or not _POLITELY.isdisjoint(after[1:3]))
        case "forward":
            return n > 0 and words[n - 1].startswith("look")
        case "way":
            return words[n - 2 : n] == ["it", "that"]
        case "one":
            return n > 0 and words[n - 1] in ("this", "that", "you", "quick", "easy", "simple", "last", "next")
        case word if word in _SUBJECTS:
            return not _LIKED.isdisjoint(words[max(0, n - 3) : n])
    if harmless.exclaimed(token.word):
        return True
    named = token.word in harmless.NAMES and n > 0 and words[n - 1] in _PLACED
    return named or token.word in _GLUE or token.word in _STRONG
