"""A small pretty-printer for the expressions that lowering emits, laid out as ruff formats them."""

from __future__ import annotations

from dataclasses import dataclass

WIDTH = 100
"""Longest line of generated code."""
INDENT = "    "


@dataclass(frozen=True)
class Group:
    """Items between brackets: a call, a list or a tuple. `head` stands before the opening bracket."""

    head: str
    items: tuple[Expr, ...]
    brackets: str = "()"


@dataclass(frozen=True)
class Infix:
    """Operands joined by one operator."""

    operator: str
    operands: tuple[Expr, ...]


@dataclass(frozen=True)
class Labelled:
    """A keyword argument, or a prefix such as `~`: `label` is glued to what follows."""

    label: str
    value: Expr


@dataclass(frozen=True)
class Each:
    """A list comprehension `[element for variable in source]`."""

    element: Expr
    variable: str
    source: Expr


Expr = str | Group | Infix | Labelled | Each


def flat(expr: Expr) -> str:
    """`expr` on one line."""
    match expr:
        case str():
            return expr
        case Group(head, items, brackets):
            inner = ", ".join(flat(item) for item in items)
            comma = "," if brackets == "()" and not head and len(items) == 1 else ""
            return f"{head}{brackets[0]}{inner}{comma}{brackets[1]}"
        case Infix(operator, operands):
            return f" {operator} ".join(_operand(operand) for operand in operands)
        case Labelled(label, value):
            return label + (_operand(value) if label == "~" else flat(value))
        case Each(element, variable, source):
            return f"[{flat(element)} for {variable} in {flat(source)}]"


def _operand(expr: Expr) -> str:
    return f"({flat(expr)})" if isinstance(expr, Infix) else flat(expr)


def statement(start: str, expr: Expr, depth: int) -> list[str]:
    """The lines of `start` followed by `expr`, indented `depth` levels; an operator chain gets parentheses to wrap."""
    line = INDENT * depth + start + flat(expr)
    if len(line) <= WIDTH:
        return [line]
    if isinstance(expr, Infix):
        return [INDENT * depth + start + "(", *_wrapped(expr, depth + 1, ""), INDENT * depth + ")"]
    return lines(start, expr, depth, "")


def lines(start: str, expr: Expr, depth: int, end: str) -> list[str]:
    """`expr` between `start` and `end`, broken at its outermost brackets where it is too long for one line."""
    pad = INDENT * depth
    whole = pad + start + flat(expr) + end
    if len(whole) <= WIDTH:
        return [whole]
    match expr:
        case Labelled(label, value):
            return lines(start + label, value, depth, end)
        case Group(head, items, brackets) if items:
            body = INDENT * (depth + 1) + ", ".join(flat(item) for item in items)
            single = not head and brackets == "()" and len(items) == 1
            if len(body) <= WIDTH and not single:
                inner = [body]
            else:
                inner = [line for item in items for line in lines("", item, depth + 1, ",")]
            return [pad + start + head + brackets[0], *inner, pad + brackets[1] + end]
        case Each(element, variable, source):
            inner = lines("", element, depth + 1, "") + lines(f"for {variable} in ", source, depth + 1, "")
            return [pad + start + "[", *inner, pad + "]" + end]
        case Infix():
            return _wrapped(expr, depth, end) if not start else [whole]
        case _:
            return [whole]


def _wrapped(expr: Infix, depth: int, end: str) -> list[str]:
    """An operator chain over several lines, each but the first opening with the operator; in one line if it fits."""
    whole = INDENT * depth + flat(expr) + end
    if len(whole) <= WIDTH:
        return [whole]
    found: list[str] = []
    for index, operand in enumerate(expr.operands):
        start = f"{expr.operator} " if index else ""
        last = end if index == len(expr.operands) - 1 else ""
        if isinstance(operand, Infix) and len(INDENT * depth + start + _operand(operand) + last) > WIDTH:
            pad = INDENT * depth
            found += [pad + start + "(", *_wrapped(operand, depth + 1, ""), pad + ")" + last]
        else:
            text = f"({flat(operand)})" if isinstance(operand, Infix) else operand
            found += lines(start, text, depth, last)
    return found


def quoted(text: str) -> str:
    """`text` as a Python string, in the quotes that need fewer escapes; whatever does not print is escaped."""
    quote = "'" if text.count('"') > text.count("'") else '"'
    if text.isprintable() and quote not in text and "\\" not in text:
        return quote + text + quote
    return quote + "".join(_escaped(char, quote) for char in text) + quote


def _escaped(char: str, quote: str) -> str:
    if char in (quote, "\\"):
        return "\\" + char
    return char if char.isprintable() else char.encode("unicode_escape").decode()


def long_string(start: str, text: str, depth: int) -> list[str]:
    """The lines of `start` followed by the string `text`, in parenthesised pieces where it is long."""
    line = INDENT * depth + start + quoted(text)
    if len(line) <= WIDTH:
        return [line]
    room = WIDTH - len(INDENT) * (depth + 1) - 2
    inner = [INDENT * (depth + 1) + quoted(piece) for piece in _pieces(text, room)]
    return [INDENT * depth + start + "(", *inner, INDENT * depth + ")"]


def _pieces(text: str, room: int) -> list[str]:
    """`text` cut after spaces into pieces whose escaped form is at most `room` long; longer words are cut anywhere."""
    pieces, piece, size = [], "", 0
    for word in _words(text, room):
        length = len(quoted(word)) - 2
        if piece and size + length > room:
            pieces.append(piece)
            piece, size = "", 0
        piece, size = piece + word, size + length
    return [*pieces, piece]


def _words(text: str, room: int) -> list[str]:
    """Words of `text`, each with the space that follows it; one too long for a line is cut into chunks."""
    whole = [word + " " for word in text.split(" ")]
    whole[-1] = whole[-1][:-1]
    chunk = max(1, room // 10)
    found: list[str] = []
    for word in whole:
        found += [word[i : i + chunk] for i in range(0, len(word), chunk)] if len(word) > room else [word]
    return found
