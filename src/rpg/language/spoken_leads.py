"""Leads of any words: "Parity benchmark: (...)", "my idea for the display is (a plus ...)", "reward 1 if (...), else 0".

The form says that what stands behind is all that is asked for. So the words of a lead may be any that cannot tell of
blocks; but none that denies, that is of the start or of another time, that compares or leaves something open, and none
by which what stands behind is something else than a goal, as a distractor.
"""

from __future__ import annotations

from collections.abc import Sequence

from rpg.language import harmless, lexicon
from rpg.language.smalltalk import takes_back
from rpg.language.telling import may_tell
from rpg.language.tokens import Token


def _words(text: str) -> frozenset[str]:
    return frozenset(text.split())


_BINDING = _words(
    "if unless until till before after while when whenever once or either whether except but than then again same "
    "only always never ever constantly permanently throughout meanwhile during least most worst worse too "
    "start starts started starting begin begins beginning initial initially current currently now present existing "
    "old previous previously former formerly earlier yesterday already given givens original originally later "
    "afterwards eventually optional optionally bonus alternative alternatively alternatives option options choice "
    "maybe perhaps possibly them they these those it he she so much opposite contrary reset world background setup "
    "safety invariant available inventory material materials ingredients stock parts objects props fixed frozen "
    "immobile immovable static stationary movable question questions why who which what how hint false true "
    "variant variants version versions undo add remove delete change replace swap also"
)
"""Words of a lead with which more hangs on what stands behind, or something else, than that it is asked for."""
_AGAINST = (
    "forbid", "forbad", "prohibit", "avoid", "fail", "penal", "punish", "illegal", "invalid", "wrong", "bad", "negativ",
    "incorrect", "error", "mistak", "violat", "counter", "anti", "distract", "decoy", "obstacle", "ignor", "exclu",
    "hate", "hating", "dislik", "fear", "worr", "problem", "trouble", "danger", "taboo", "mess", "chaos", "nightmare",
    "warn", "caution", "never", "non", "unwanted", "undesir", "unaccept", "unallow", "disallow", "ban", "stop",
    "refus", "reject", "rumo", "joke", "lie", "imposs", "hardly", "barely", "rare", "seldom", "revers", "mirror",
    "rotat", "flip", "prevent", "bewar", "inhibit", "hinder", "cancel", "abort", "resist", "oppos", "deny", "deni", "exempt", "skip",
    "omit", "lack", "missing", "destroy", "ruin", "dismantl", "disassembl", "wreck", "demolish", "unstack", "unbuild", "protect",
    "sabotag", "trap", "doubt", "instead", "rather", "suppos", "assum", "hypothe", "imagin", "pretend",
)  # fmt: skip
"""How words of a lead begin that turn against what stands behind, or make no goal of it."""
_HARMLESS_HERE = _words(
    "big small little huge tiny short great up complete completed finished display sign setting returns"
)
"""Of an occasion, and of no block, where no block is spoken of."""
_DET = _words("the my our his her their your this a an today tonight tomorrow")
_MADE = _words("arrangement structure figure formation composition layout construction design pattern display sign")
"""What is built may be spoken of, where a figure is told behind."""
_IS = tuple(
    tuple(said.split())
    for said in (
        "is", "'s", "should be", "must be", "will be", "shall be", "would be", "has to be", "needs to be", "is to be",
        "should look like", "must look like", "looks like", "will look like", "shows", "should show", "must show",
        "depicts", "consists of", "features", "contains", "calls for", "asks for", "requires", "is called", "says",
        "specifies", "demands", "prescribes", "describes", "wants", "is that", "accepts",
    )
)  # fmt: skip
_POINTING = _words(
    "there here i we you somebody someone everybody everyone nobody nothing something anything everything and but so "
    "please in on at to of with by from"
)
_MERELY = _words("simply just basically actually simple really : following")
_BEGINS = _words("a an the any") | frozenset(lexicon.NUMBER)
_TESTS = _words(
    "benchmark test challenge task exercise puzzle quiz classification problem drill lesson game demo experiment "
    "evaluation check skill scenario episode mission assignment activity training practice trial stacking building "
    "sorting spelling counting arranging ordering grouping placing placement manipulation"
)
"""Heads of titles that may have in front of them what is tried, in words that tell of blocks elsewhere."""
_SHAPES = (lexicon.COLOR, lexicon.COLOR_PLURAL, lexicon.PATCH, lexicon.STRUCTURE, lexicon.NUMBER, lexicon.ORDINAL,
           lexicon.SIZE)  # fmt: skip
_NOT = _words("not no never without none non un upside left right front back top bottom all each every any both")
_LONGEST = 8


def led_by_form(tokens: Sequence[Token]) -> int:
    """How many of the first words of a text are such a lead."""
    return (
        heading(tokens) or subject(tokens) or purpose(tokens) or dared(tokens) or glad_if(tokens)
        or favour(tokens) or clause(tokens) or announcement(tokens) or ability(tokens)
    )  # fmt: skip


def heading(tokens: Sequence[Token]) -> int:
    """How many of the first words are a heading: "Colour logic drill:", "Grandma's birthday surprise:"."""
    words = [token.word for token in tokens]
    end = next((n for n in range(min(_LONGEST + 1, len(words) - 1)) if _sets_off(tokens, n)), 0)
    mark = end
    if end > 1 and tokens[end - 1].kind == "number" and words[end - 2] in _TESTS:
        end -= 1
    if not end or mark + 3 > len(words) or not _plain(tokens[:end]) or "'re" in words[:end]:
        return 0
    tried = words[end - 1] in _TESTS and not any(w in table for w in words[:end] for table in _SHAPES)
    tried = tried and _NOT.isdisjoint(words[:end])
    seen = tuple(words[:3]) in _TRYING and not any(w in table for w in words[:end] for table in _SHAPES)
    plain = all(map(_tells_nothing, words[:end])) or (tried and not any(map(bends, words[: end - 1])))
    return mark + 1 if plain or (seen and _NOT.isdisjoint(words[:end])) else 0


_TRYING = {("let", who, done) for who in ("us", "me") for done in ("see", "try", "test", "check", "find", "practise")}


def subject(tokens: Sequence[Token]) -> int:
    """How many of the first words say what a figure is, "the finished mosaic should be (a 3x3 grid ...)"."""
    words = [token.word for token in tokens]
    if words[1:3] in (["'s", "either"], ["is", "either"]) and words[0] == "it":
        return 2
    if not words or not (words[0] in _DET or (_tells_nothing(words[0]) and words[0] not in _POINTING)):
        return 0
    for at in range(1 + (words[0] in _DET), min(_LONGEST + 1, len(words) - 3)):
        said = max((len(x) for x in _IS if tuple(words[at : at + len(x)]) == x), default=0)
        if said:
            plain = _plain(tokens[:at]) and all(word in _MADE or _tells_nothing(word) for word in words[1:at])
            end = at + said
            while end < len(words) and words[end] in _MERELY:
                end += 1
            begun = end < len(words) - 2 and (words[end] in _BEGINS or words[end - 1] == ":")
            return end if plain and begun else 0
    return 0


_LIGHTLY = (
    "not too", "not so", "not very", "not that", "can not reach", "can not wait", "can not manage", "can not do",
    "one thing", "one more", "one last", "one for", "this one", "next one", "easy one", "last one", "quick one",
    "simple one", "and then", "too hard", "too difficult", "too much", "in plain", "only one more", "the same as",
    "something different", "completely different", "totally different", "a bit different", "to the letter", "pay attention",
)  # fmt: skip
"""In an announcement these do not mean blocks, and do not deny it."""
_ASKING = _words("is are does do did was were has have had can could will would should may might whose whom")
_PAST = _words("was were had used did been failed")


def announcement(tokens: Sequence[Token]) -> int:
    """How many of the first words announce what is told behind their colon: "one thing at a time:", "I hope this is not
    too hard:"."""
    words = [token.word for token in tokens]
    end = next((n for n in range(min(2 * _LONGEST, len(words) - 1)) if _sets_off(tokens, n)), 0)
    if not end or len(words) < end + 4 or not _PAST.isdisjoint(words[:end]) or words[0] in _ASKING - {"can", "could"}:
        return 0
    light = {
        n + k for n in range(end) for said in _LIGHTLY if words[n : n + len(said.split())] == said.split()
        for k in range(len(said.split()))
    }  # fmt: skip
    spoken = _THEM | {",", "how", "what", "here", "also"}
    known = all(n in light or word in spoken or _tells_nothing(word) for n, word in enumerate(words[:end]))
    return end + 1 if known and all(t.word == "," or _plain([t]) for t in tokens[:end]) else 0


def ability(tokens: Sequence[Token]) -> int:
    """How many of the first words ask to find out whether it can be done: "the purpose is to check whether the arm can
    (build ...)"."""
    words = [token.word for token in tokens]
    for at in range(1, min(2 * _LONGEST, len(words) - 4)):
        who = next((len(x) for x in _AGENTS if tuple(words[at + 1 : at + 1 + len(x)]) == x), 0)
        can = next((len(x) for x in _CAN if tuple(words[at + 1 + who : at + 1 + who + len(x)]) == x), 0)
        if words[at] in ("if", "whether", "that", "how") and who and can:
            end = at + 1 + who + can
            tried = not _TRIED.isdisjoint(words[:at]) and all(map(_tells_nothing, words[:at]))
            return end if tried and _plain(tokens[:at]) and words[end] in _BASES else 0
    return 0


_AGENTS = (
    *((det, who) for det in ("the", "a", "your", "our", "this")
      for who in ("robot", "arm", "agent", "policy", "model", "gripper", "system", "machine")),
    ("you",), ("we",),
)  # fmt: skip
_CAN = (("can",), ("could",), ("is", "able", "to"), ("are", "able", "to"), ("manages", "to"), ("manage", "to"),
        ("knows", "how", "to"), ("know", "how", "to"))  # fmt: skip
_TRIED = _words("check test tests see find show verify evaluate examine demonstrate prove probe probes checks assess")
_EAGER = (
    "i bet you can not", "i bet you can 't", "i bet you could not", "bet you can not", "i dare you to", "we dare you to",
    "dare you to", "if i were you i 'd", "if i were you i would", "i 'd say we go for", "i only care that",
    "all i care about is that", "i just care that", "the main thing is that", "what matters is that",
    *(f"{just}do something {easy}{like}" for just in ("just ", "so just ", "please ", "")
      for easy in ("easy ", "simple ", "nice ", "fun ", "quick ", "") for like in ("like", "such as")),
)  # fmt: skip
_DARES = tuple(tuple(said.split()) for said in _EAGER)
_SORTED = _words(
    "i we you just want need would like love wish can could please let us get have 'd the this that all it everything "
    "things stuff mess chaos sorted tidied organized organised arranged tidy cleaned neat up out done fixed set laid "
    "properly nicely neatly honestly really now today so to be a bit little here well ok okay simply only"
)


def dared(tokens: Sequence[Token]) -> int:
    """How many of the first words only dare to do it, or say that all should be in order: "I bet you can't (build
    ...)", "I just want the mess sorted: (...)"."""
    words = [token.word for token in tokens]
    bet = max((len(said) for said in _DARES if tuple(words[: len(said)]) == said), default=0)
    colon = words.index(":") if ":" in words else 0
    wished = colon > 3 and _SORTED.issuperset(words[:colon]) and not {"i", "we", "let"}.isdisjoint(words[:colon])
    return colon + 1 if wished and len(words) > colon + 3 else bet


_GLAD = _words(
    "great nice good lovely wonderful perfect cool awesome amazing fantastic brilliant super neat fun happy glad "
    "delighted grateful thankful thrilled pleased proud love appreciate appreciated world moon day hug hugs kiss kisses "
    "excited helpful kind sweet ideal best dream ecstatic charmed impressed honored honoured cookie beer thanks"
)
_SAD = _words(
    "sad angry upset cry cries annoyed annoying furious disappointed mad hurt weep scream ashamed die mind kill quit "
    "scold bad terrible awful horrible silly stupid strange odd boring funny weird dangerous unhappy surprised shame pity"
)


def glad_if(tokens: Sequence[Token]) -> int:
    """How many of the first words say that somebody would be glad: "it would mean the world to me if (...)"."""
    words = [token.word for token in tokens]
    at = next((n for n, word in enumerate(words[: 2 * _LONGEST]) if word in ("if", "when", ",", ":")), 0)
    if not at or words[at] in (",", ":") or len(words) < at + 5 or not _plain(tokens[:at]):
        return 0
    ahead = [
        word for n, word in enumerate(words[:at]) if not (word == "not" and words[n - 1 : n] == ["would"] and n < 2)
    ]
    glad = not _GLAD.isdisjoint(ahead) and _SAD.isdisjoint(ahead)
    return at + 1 if glad and all(w in _GLAD | _THEM or _tells_nothing(w) for w in ahead) else 0


_THEM = _words("it he she so much over only you me")


def favour(tokens: Sequence[Token]) -> int:
    """How many of the first words only ask to be kind: "can you do me a solid and (line up ...)"."""
    words = [token.word for token in tokens]
    begin = 2 if words[:2] in (["can", "you"], ["could", "you"], ["would", "you"], ["will", "you"]) else 0
    begin += words[begin : begin + 1] == ["please"]
    at = next((n for n in range(begin, min(begin + _LONGEST, len(words) - 3)) if words[n] == "and"), 0)
    kind = words[begin : begin + 3]
    asked = (
        (kind[:1] == ["do"] and kind[1:2] in (["me"], ["us"], ["yourself"]) and kind[2:3] in (["a"], ["the"], ["this"]))
        or (kind[:1] == ["make"] and kind[1:2] in (["me"], ["us"], ["my"], ["somebody"], ["someone"], ["mommy"])
            and not (_GLAD | {"smile", "laugh"}).isdisjoint(words[begin + 2 : at]))
        or kind[:2] in (["be", "a"], ["be", "an"], ["be", "my"])
    )  # fmt: skip
    plain = at and asked and all(w in _THEM or _tells_nothing(w) for w in words[begin + 1 : at])
    return at + 1 if plain and words[at + 1] in _BASES else 0


_BASES = frozenset(word for word, forms in lexicon.VERB.items() if any(form == "base" for _, _, form in forms))
_SPEAKERS = _words("i we he she my our his her the")
_ASKED = _words(
    "want wants wanted need needs needed like likes wish wishes wished prefer prefers require requires order orders "
    "ordered request requests requested demand demands build builds make makes must should shall have has you ask asks "
    "would will love loves get gets expect expects put place"
)
"""With these more is asked for in front than what stands behind."""
_AROUND_VERBS = _words("up out over down through off")
_GOING = _words("please can could would will let i we you need want kindly now just lets")


def clause(tokens: Sequence[Token]) -> int:
    """How many of the first words tell of people: "I am decorating a shop window and (need ...)", "our grandson calls
    it the sandwich: (...)"."""
    words = [token.word for token in tokens]
    if words[:1] == [] or words[0] not in _SPEAKERS:
        return 0
    for at in range(3, min(2 * _LONGEST, len(words) - 3)):
        joined = words[at] in ("and", "so", "but") and words[at + 1] in _GOING | _BASES
        if words[at] in (",", ":") or joined:
            break
    else:
        return 0
    said = words[1:at]
    known = all(
        word in _THEM - {"you", "only"} or _tells_nothing(word)
        or (word in _AROUND_VERBS and said[n - 1].endswith(("ing", "ed")))
        for n, word in enumerate(said)
    )  # fmt: skip
    acting = words[0] in ("i", "we", "he", "she") or not (harmless.PEOPLE | harmless.ANIMALS).isdisjoint(words[1:5])
    told = known and acting and _plain(tokens[:at]) and _ASKED.isdisjoint(said)
    return at + 1 + (words[at] == "," and words[at + 1] in ("and", "so", "but")) if told else 0


def purpose(tokens: Sequence[Token]) -> int:
    """How many of the first words say what for, up to a comma or to who wishes it: "for the big finish (I'd like ...)",
    "as a little warm-up exercise, (put ...)"."""
    words = [token.word for token in tokens]
    if words[:1] not in (["for"], ["as"]) or len(words) < 5:
        return 0
    end = next((n for n, word in enumerate(words[: _LONGEST + 1]) if n > 1 and word in _GOES_ON), 0)
    known = words[1] in _DET and _plain(tokens[:end]) and all(map(_tells_nothing, words[1:end]))
    return end + (words[end] in (",", ":")) if end and known and len(words) > end + 3 else 0


_GOES_ON = _words(", : i we you please let could can would there")


def _sets_off(tokens: Sequence[Token], n: int) -> bool:
    """A colon, or a dash with room around it; "-1" is a number."""
    apart = n > 0 and tokens[n - 1].span[1] < tokens[n].span[0] and tokens[n].span[1] < tokens[n + 1].span[0]
    return tokens[n].word == ":" or (apart and tokens[n].raw in ("-", "—", "–"))


def _plain(tokens: Sequence[Token]) -> bool:
    """Whether these are words, and no symbols are named."""
    return all(
        (t.kind == "word" and not (len(t.raw) == 1 and t.raw.isupper() and n)) or t.word in _CLIPPED
        for n, t in enumerate(tokens)
    )


_CLIPPED = _words("'s 'd 'm 're 've 'll -")


def _tells_nothing(word: str) -> bool:
    """Whether a word of a lead carries nothing."""
    return not (may_tell(word) and word not in _HARMLESS_HERE) and not bends(word) and not takes_back([word])


def bends(word: str) -> bool:
    """Whether what stands behind a word may be no goal, or not at the end: "Invariant: (red on blue)"."""
    return word in _BINDING or word.startswith(_AGAINST)


_GIVEN = _words(
    "reward score return give award get grant assign output pay earn receive pass accept success succeed succeeds "
    "win terminate done solved point points the a an one 1 1.0 + full marks true yes agent robot policy you episode "
    "of is are will be it this task only as with and ends end finish finishes finished complete completed considered "
    "successful counted counts count positive credit mark judge grade evaluate to trial run attempt we i ok okay valid "
    "correct yield yields ticked tick green light candidate solution sparse binary reward : =  r"
)
"""What is said in front of the condition under which it is well done."""
_VERDICTS = _words(
    "reward score return award grant pass accept success succeed succeeds win terminate done solved credit yield "
    "yields successful correct valid point points marks true accepted complete completed finished passes passed solved "
    "succeeded rewarded wins won"
)
_WHEN = (("if", "and", "only", "if"), ("only", "if"), ("only", "when"), ("exactly", "when"), ("exactly", "if"),
         ("as", "soon", "as"), ("if",), ("when",), ("iff",), ("once",), ("whenever",), ("as", "long", "as"),
         ("provided", "that"), ("provided",))  # fmt: skip
_ELSE = _words("otherwise else or and 0 0.0 zero false failure fail nothing no not none reward it is return , give get you "
               "the agent gets point points mark marks score credit")  # fmt: skip
_ZERO = _words("0 0.0 zero false failure fail nothing no not none")


def judged(tokens: Sequence[Token]) -> tuple[int, int]:
    """How many of the first words say that it is judged by what comes behind them, "reward 1 if (...)"; and how many
    of the last say what there is else, "(...), otherwise 0"."""
    words = [token.word for token in tokens]
    lead = 0
    for at in range(1, min(_LONGEST + 4, len(words) - 3)):
        said = max((len(x) for x in _WHEN if tuple(words[at : at + len(x)]) == x), default=0)
        if said:
            ahead = words[:at]
            known = all(word in _GIVEN or _tells_nothing(word) for word in ahead[words[0] == "under" :])
            lead = at + said if known and not _VERDICTS.isdisjoint(ahead) else 0
            break
    if not lead:
        return 0, 0
    other = next((n for n in range(lead + 3, len(words)) if words[n] in ("otherwise", "else")), len(words))
    while lead + 3 < other < len(words) and words[other - 1] in _ELSE:
        other -= 1
    behind = words[other:]
    told = bool(behind) and _ELSE.issuperset(behind) and not _ZERO.isdisjoint(behind)
    return lead, len(behind) if told else 0
