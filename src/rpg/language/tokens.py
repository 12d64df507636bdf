"""Text -> tokens with spans: words, numbers, dimensions, quotations, equations, punctuation."""

from __future__ import annotations

import re
from dataclasses import dataclass, replace

from rpg.core.diagnostics import Span
from rpg.language import lexicon
from rpg.language.written_forms import AMERICAN, CONTRACTIONS, UNMARKED


@dataclass(frozen=True, slots=True)
class Token:
    """One item of the instruction. `word` is lower case; `raw` as written.

    `kind`: "word", "number" (`value` a float), "dims" (a tuple of ints), "quote" and "literal" (`value` the text in
    capitals), "equation" (`value` its text), "punct". `joined`: a hyphen binds it to the word before.
    """

    kind: str
    word: str
    raw: str
    span: Span
    value: float | str | tuple[int, ...] | None = None
    joined: bool = False

    @property
    def many(self) -> int:
        """The whole number that it says in digits or in a word; 0 for none."""
        if self.kind == "number" and isinstance(self.value, float) and self.value.is_integer():
            return int(self.value)
        return lexicon.NUMBER.get(self.word, 0) if self.kind == "word" else 0

    def saying(self, word: str) -> Token:
        """Another word, or a mark, in its place."""
        return replace(self, kind="word" if word[0].isalnum() else "punct", word=word, raw=word, value=None)


ARROW = "→"
"""What every arrow is read as."""
_SIGN = "[-+*/×÷−–x]"
_EQUATION = re.compile(rf"\d+(?:\s*{_SIGN}\s*\d+)+\s*=\s*\d+|\d+\s*=\s*\d+(?:\s*{_SIGN}\s*\d+)+")
_PIECES = re.compile(
    rf"""
    (?P<bullet>(?:(?<=\n)|^)\s*(?:[-*•]|\d{{1,2}}[.)])(?=\s)|(?<!\w)\d{{1,2}}\)(?=\s))
  | (?P<smile>(?<![\w:;])[:;]-?[)(]+(?=\s*$|\s*[.!?,;]|\s+[A-Za-z]))
  | (?P<line>\n\s*(?=[A-Z][a-z]+\b|[a-z]+(?:\ [a-z]+)?\s*[:=]))
  | (?P<equation>(?:{_EQUATION.pattern})(?!\w))
  | (?P<aside>(?:\b(?:i\.e\.|e\.g\.|viz\.)|(?<=[,:(]\ )for\ (?:example|instance)\b(?!\ [A-Z]{2}))[,:]?)
  | (?P<short>\b(?:max|min)\b\.?(?=\s*(?:\d|one\b|two\b|three\b|four\b|five\b))|\b(?:max|min|approx)\.(?=\s))
  | (?P<numbered>\b(?:[Nn]o|[Nn]um)\.(?=\s?\d\b)|\b[Nn]r\b\.?(?=\s?\d\b)|[#№](?=\s?\d\b))
  | (?P<word>(?<!\w)['’]em\b|\bw/(?:o(?:ut)?)?(?=\s))
  | (?P<bound>(?:[≤≥]|[<>]=)(?=\s*\d))
  | (?P<zero>\b(?:t\s?=\s?0|(?:time(?:\s?step)?|timestep|step)\s(?:0|zero))(?!\w|\.\d))
  | (?P<negative>(?<=\s)[-−–](?=\d+(?:\.\d+)?\s*(?:°|deg)))
  | (?P<share>(?<![\w/])(?:1/2|[12]/3|[13]/4)(?=\s+(?:of|turn)\b))
  | (?P<ormore>(?<=\d)\+(?=\s+(?:of|or\ more)\b))
  | (?P<quote>"[^"]{{1,80}}"|“[^”]{{1,80}}”|«[^»]{{1,80}}»|(?<!\w)[‘'][^'’]{{1,80}}[’'](?!\w)|`[^`]{{1,80}}`)
  | (?P<dims>\d+(?:\s*[x×*]\s*\d+){{1,2}}(?![\w.]))
  | (?P<number>\d+(?:\.\d+)?(?!\d*(?:\.\d+)?[A-Za-z]))
  | (?P<mixed>\d+(?:\.\d+)?(?=[A-Za-z]))
  | (?P<letters>[A-Za-z]+(?:['’][A-Za-z]+)?)
  | (?P<owned>(?<=s)['’](?=\s+[a-z]))
  | (?P<ellipsis>…|\.\.\.+|(?<=\b\w)\.\.(?=\w\b))
  | (?P<arrow>[-–—=]+>|[→⇒➔➜]|>)
  | (?P<sign>[-+*/×÷=−–—])
  | (?P<spread>±)
  | (?P<punct>[.,;:!?()\[\]&∧°%~])
    """,
    re.VERBOSE,
)
_GOES_ON = frozenset(
    {"the", "a", "an", "of", "on", "to", "and", "or", "in", "with", "at", "by", "from", "is", "are", "for", "onto"}
)
"""With these no line of a list ends: the sentence goes on in the next one."""
_SHARES = {"1/2": "half", "1/3": "a third", "2/3": "two thirds", "1/4": "a quarter", "3/4": "three quarters"}
_SHORT = {"max": "maximum", "min": "minimum", "approx": "approximately"}
_ORDINAL_TAIL = {"st", "nd", "rd", "th"}


@dataclass(frozen=True, slots=True)
class Stray:
    """A character that is no part of the language."""

    text: str
    span: Span


def tokenize(text: str) -> tuple[list[Token], list[Stray]]:
    """Every token of `text`, and every character that belongs to none."""
    tokens: list[Token] = []
    strays: list[Stray] = []
    text, steps = _stepped(text)
    text, more = _unnumbered(text)
    text = _BOUND.sub(" ", text)
    steps |= more
    at = 0
    while at < len(text):
        found = _PIECES.match(text, at)
        if found is None and text[at].isspace():
            at += 1
            continue
        if found is None:
            strays.append(Stray(text[at], (at, at + 1)))
            at += 1
            continue
        raw, end = found.group(), found.end()
        if found.lastgroup == "smile":  # in brackets it is a colon at their end
            inside = text.count("(", 0, at) > text.count(")", 0, at)
            mark = raw[0] if inside else _parted_by(tokens, text[end:].lstrip()[:1])
            tokens += [Token("punct", mark, mark, (at, at + 1))] if mark else []
            at = at + 1 if inside else end
            continue
        if found.lastgroup == "line":
            ended = tokens and tokens[-1].kind != "punct" and tokens[-1].word not in _GOES_ON
            tokens += [Token("punct", ";", raw, (at, end))] if ended else []
            at = end
            continue
        if found.lastgroup == "bullet" and raw.endswith(")") and text.count("(", 0, at) > text.count(")", 0, at):
            raw, end = raw[:-1], end - 1
            tokens.append(Token("number", raw.strip(), raw, (at, end), float(raw)))
        else:
            tokens += _tokens_of(str(found.lastgroup), raw, (at, end))
        at = end
    tokens = [replace(token, raw=steps.get(token.span[0], token.raw)) for token in tokens] if steps else tokens
    return _ordinals(_inline(tokens)), strays


def _parted_by(tokens: list[Token], after: str) -> str:
    """What stands for a smile between words: a stop where a sentence begins behind it, else a comma."""
    if not tokens or tokens[-1].kind == "punct" or not after.isalpha():
        return ""
    return "." if after.isupper() else ","


_LISTS = frozenset({"blocks", "cubes", "objects", "things", "inventory", "materials", "material", "items", "bricks",
                    "letters", "digits"})  # fmt: skip


def _inline(tokens: list[Token]) -> list[Token]:
    """ "Blocks:" over lines with bullets: a list, where other bullets begin sentences."""
    out: list[Token] = []
    listing = False
    for token in tokens:
        if token.word != ";":
            out.append(token)
        elif token.raw == ";" or token.raw.isspace():
            listing = False
            out.append(token)
        elif [t.word for t in out[-1:]] == [":"] and out[-2:][0].word in _LISTS:
            listing = True
        else:
            out.append(replace(token, word=",") if listing else token)
    return out


_BOUND = re.compile(r"(?<=[a-z])_(?=[a-z0-9])|(?<=[0-9])_(?=[a-z])")
"""What binds the words of a name: "red_block", "left_to_right"."""
_STEP = re.compile(r"(?<![\w.,])(\d{1,2})[.:](?=\s)")
_IN_TURN = re.compile(r"(?i)\b(?:order|sequence|steps|stages|first|then|turn|one by one|after)\b")
"""What is told behind these comes one after the other."""


def _stepped(text: str) -> tuple[str, dict[int, str]]:
    """ "1. red on blue 2. green on red": each begins a sentence where the text, or what stands behind a colon, begins
    with the first; and the numbers of the later ones by where they stand."""
    marks: list[re.Match[str]] = []
    for mark in _STEP.finditer(text):
        ahead, behind = text[: mark.start()].rstrip(), text[mark.end() :].lstrip()
        begins = not ahead or (ahead[-1] == ":" and behind[:1].isalpha() and not _IN_TURN.search(ahead))
        if int(mark.group(1)) == len(marks) + 1 and (marks or begins):
            marks.append(mark)
    for number, mark in enumerate(marks if len(marks) > 1 else ()):
        begin, end = mark.span()
        text = text[:begin] + (";" if number else " ").ljust(end - begin) + text[end:]
    return text, {mark.start(): mark.group() for mark in marks[1:]}


_MARK = re.compile(r"(?:,?\s+and\s+|,\s+)?(?<![\w(])(?:\((?=\w+\)))?(\d{1,2}|[a-h]|i{1,3}|iv|v)\)(?=\s)")
_ALONG = re.compile(r"(?i)\b(?:left|right|top|bottom|front|back|row|line|tower|stack)\b")
_COUNTS = ("1 2 3 4 5 6 7 8 9", "a b c d e f g h", "i ii iii iv v")


def _unnumbered(text: str) -> tuple[str, dict[int, str]]:
    """ "(1) red on blue, and (2) ...", "(a) ...; (b) ...": each begins a sentence; and the numbers of the later ones,
    or of all behind "the steps are:", by where they stand. Of these at least two in order."""
    marks = list(_MARK.finditer(text))
    told = [mark.group(1) for mark in marks]
    ordered = any(told == counted.split()[: len(told)] for counted in _COUNTS)
    if len(told) < 2 or not ordered or (told[0] == "1" and "(" not in marks[0].group()):  # "1) ..." are bullets
        return text, {}
    begun, numbers = marks[0].start(), {}
    ahead = text[:begun].rstrip()
    stepped = told[0] == "1" and not _ALONG.search(ahead)
    headed = stepped and ahead.endswith(":") and _IN_TURN.search(ahead) is not None
    for number, mark in enumerate(marks):
        begin, end = mark.span() if number else (mark.start(1) - (text[mark.start(1) - 1] == "("), mark.end())
        text = text[:begin] + (";" if number or headed else " ").ljust(end - begin) + text[end:]
        if stepped and (number or headed):
            numbers[begin] = f"({mark.group(1)})"
    return text, numbers


def _tokens_of(kind: str, raw: str, span: Span) -> list[Token]:
    match kind:
        case "quote":
            inner = raw[1:-1].strip()
            return [Token("quote", inner.lower(), raw, span, inner)]
        case "equation":
            return [Token("equation", raw, raw, span, _plain_signs(re.sub(r"\s+", "", raw)))]
        case "dims":
            return [Token("dims", raw, raw, span, tuple(int(n[:6]) for n in re.findall(r"\d+", raw)))]
        case "number" | "mixed":
            return [Token("number", raw, raw, span, float(raw[:12]))]
        case "word" | "letters":
            return _word(raw, span)
        case "short":
            return [Token("word", _SHORT[raw.rstrip(".")], raw, span)]
        case "numbered":
            return [Token("word", "number", raw, span)]
        case "bound":
            return [Token("word", word, raw, span) for word in ("at", "most" if raw[0] in "≤<" else "least")]
        case "negative":  # which way that is nobody says
            return [Token("word", "negative", raw, span)]
        case "zero":
            return [Token("word", word, raw, span) for word in ("the", "start")]
        case "share":
            return [Token("word", word, raw, span) for word in _SHARES[raw].split()]
        case "ormore":
            return [Token("word", word, raw, span) for word in ("or", "more")]
        case "spread":
            return [Token("word", word, raw, span) for word in ("plus", "or", "minus")]
        case "bullet":
            return [Token("punct", ";", raw, span)]
        case "aside":
            return [Token("punct", ",", raw, span)]
        case "owned":  # "the kids' room"
            return [Token("punct", "'s", raw, span)]
        case "ellipsis":
            return [Token("punct", "…", raw, span)]
        case "arrow":
            return [Token("punct", ARROW, raw, span)]
        case "sign":
            return [Token("sign", _plain_signs(raw), raw, span)]
        case _ if raw == "&":
            return [Token("word", "and", raw, span)]
        case _:
            return [Token("punct", raw, raw, span)]


def _plain_signs(text: str) -> str:
    for sign, plain in (("×", "*"), ("x", "*"), ("÷", "/"), ("−", "-"), ("–", "-"), ("—", "-")):
        text = text.replace(sign, plain)
    return text


def _word(raw: str, span: Span) -> list[Token]:
    lower = raw.lower().replace("’", "'")
    if lower in CONTRACTIONS:
        return [Token("word", part, raw, span) for part in CONTRACTIONS[lower].split()]
    if lower in UNMARKED and not raw.isupper():
        return [Token("word", part, raw, span) for part in UNMARKED[lower].split()]
    if "'" in lower:
        stem, tail = lower.split("'", 1)
        if tail == "s":
            middle = span[0] + len(stem)
            owner = Token("word", stem, raw[: len(stem)], (span[0], middle))
            return [owner, Token("punct", "'s", raw[len(stem) :], (middle, span[1]))]
    return [Token("word", AMERICAN.get(lower, lower), raw, span)]


_LISTING = frozenset({",", "and", "+", "*", "/", "="})
"""What a sign stands between in a list of symbols, where a dash never does."""


def _ordinals(tokens: list[Token]) -> list[Token]:
    """Join "1" "st"; drop hyphens between words, and signs that are dashes."""
    out: list[Token] = []
    for index, token in enumerate(tokens):
        before = out[-1] if out else None
        after = tokens[index + 1] if index + 1 < len(tokens) else None
        adjoining = before is not None and before.span[1] == token.span[0]
        if token.word == "'s" and before and _letter(before) and len(out) > 1 and _plural(out[-2], tokens[index + 1 :]):
            out.append(replace(token, kind="word", word="blocks"))
        elif before and _counts(before) and len(token.raw) == 2 and token.raw[0].isupper() and token.raw[1] == "s":
            letter = Token("word", token.word[0], token.raw[0], (token.span[0], token.span[0] + 1))
            out += [letter, replace(token, word="blocks", span=(token.span[0] + 1, token.span[1]))]
        elif before and adjoining and token.raw == "s" and before.raw in _DIGITS:
            out[-2:] = _so_many(out[-2:-1], before, token, listed=after is not None and after.word in _LISTING)
        elif before and _letter(token) and before.raw.lower() == "one" and (len(out) < 2 or out[-2].word in _LEADING):
            out[-1:] = [replace(before, word="a"), token]
        elif before and adjoining and before.kind == "number" and token.word in _ORDINAL_TAIL:
            out[-1] = Token("word", before.word + token.word, before.raw + token.raw, (before.span[0], token.span[1]))
        elif token.word == "-" and before and after and adjoining and after.span[0] == token.span[1]:
            if _is_range(before, after) and _in_a_chain(out, tokens, index):
                out.append(replace(token, kind="punct", word=","))
            elif _is_range(before, after):
                out.append(replace(token, kind="word", word="to"))
            elif after.kind == "word":
                tokens[index + 1] = replace(after, joined=True)
        elif token.raw == "x" and before and after and _multiplies(before, after, tokens):
            out.append(replace(token, kind="sign", word="*"))
        elif token.raw == "×" and _times(before, token, after):
            out.append(replace(token, kind="word", word="x"))
        elif before and after and _dashes(before, token, after, out, tokens[index + 1 : index + 3]):
            out.append(replace(token, kind="punct", word=","))
        else:
            out.append(token)
    return out


_LEADING = frozenset({
    ",", ":", ".", ";", "and", "with", "using", "of", "from", "are", "is", "have", "has", "need", "put", "place", "use",
    "take", "want", "move", "set", "lay", "stack", "bring", "add",
})  # fmt: skip
"""Behind these "one B" is a cube that shows it; "the red one B" is none."""


def _dashes(before: Token, sign: Token, after: Token, out: list[Token], behind: list[Token]) -> bool:
    """Whether a minus stands between words as a dash does."""
    apart = sign.span[0] > before.span[1] and after.span[0] > sign.span[1]
    return sign.word == "-" and apart and not _listed_sign(out, behind)


def _listed_sign(before: list[Token], after: list[Token]) -> bool:
    """Whether a minus is one of a list of symbols: "5, -, 4", "the blocks 5 and - lie", "the blocks -, 4 and 5"."""
    if before[-1].word == "and" and len(before) > 1 and _symbolic(before[-2]):
        return True
    begun = before[-1].word in ("blocks", "cubes", "symbols") and _symbolic(after[-1])
    return after[0].word in _LISTING and (begun or _symbolic(before[-1]))


def _symbolic(token: Token) -> bool:
    return token.kind == "number" or token.word in _LISTING


def _multiplies(before: Token, after: Token, tokens: list[Token]) -> bool:
    """ "2, 4, 8, x and =": the sign, in a list with the one of equality."""
    beside = all(token.word in (",", "and") for token in (before, after))
    return beside and any(t.word == "=" for t in tokens) and any(t.kind == "number" for t in tokens)


def _times(before: Token | None, token: Token, after: Token | None) -> bool:
    """ "red ×3": so many of these, where a sign of multiplication stands between numbers or in a list of symbols."""
    told = before is not None and before.kind == "word" and len(before.raw) > 1 and before.word not in _LISTING
    return told and after is not None and after.kind == "number" and after.span[0] == token.span[1]


_DIGITS = frozenset("0123456789")


def _so_many(ahead: list[Token], digit: Token, ending: Token, listed: bool) -> list[Token]:
    """ "Two 3s": two blocks labelled 3; in a list, where that would hold of what follows as well, a 3 and a 3."""
    count = ahead[0] if ahead and _counts(ahead[0]) else None
    many = lexicon.NUMBER.get(count.word, int(count.word) if count.word.isdigit() else 0) if count else 0
    if listed and many > 1:
        one = [replace(ending, word="a", raw="a"), digit]
        return [*one, *[replace(ending, kind="punct", word=","), *one] * (many - 1)]
    if count is None or listed:
        whole = (digit.span[0], ending.span[1])
        return [*ahead, replace(ending, word=f"{digit.raw}s", raw=f"{digit.raw}s", span=whole)]
    return [count, *(replace(ending, word=word) for word in ("blocks", "labelled")), digit]


def _counts(token: Token) -> bool:
    """ "two As", "both Ms": what stands before the plural of a letter."""
    return _several(token) or (token.kind == "word" and token.word in ("all", "the"))


def _several(token: Token) -> bool:
    """ "two A's": where "the A's" may stand for "the A is"."""
    return token.kind == "number" or (token.kind == "word" and (token.word in lexicon.NUMBER or token.word == "both"))


def _plural(before: Token, after: list[Token]) -> bool:
    """ "two A's", "the A's are", "the A's in red": where "the A's" is not "the A is"."""
    words = [token.word for token in after[:2]]
    verb = words[:1] and words[0] in ("are", "should", "must", "have", "go", "stand", "lie")
    colored = words[:1] == ["in"] and words[1:] and words[1] in lexicon.COLOR
    return _several(before) or (before.word in ("the", "all") and bool(verb or colored))


def _letter(token: Token) -> bool:
    return token.kind == "word" and len(token.raw) == 1 and token.raw.isupper()


def _in_a_chain(out: list[Token], tokens: list[Token], index: int) -> bool:
    """ "A-B-C", "3-2-1": more than two symbols bound by hyphens are a list."""
    before = out[-2] if len(out) > 1 else None
    bound = before is not None and before.raw == "-" and before.span[1] == out[-1].span[0]
    after, further = tokens[index + 1], tokens[index + 2 : index + 4]
    goes_on = len(further) == 2 and further[0].word == "-" and _is_range(after, further[1])
    return bound or (goes_on and further[0].span == (after.span[1], further[1].span[0]))


def _is_range(before: Token, after: Token) -> bool:
    """ "A-Z" and "1-5" are ranges; other hyphens join words."""
    letters = len(before.raw) == len(after.raw) == 1 and before.raw.isalpha() and after.raw.isalpha()
    return letters or (before.kind == after.kind == "number")
