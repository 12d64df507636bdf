"""Long lists of names that code would repeat become one attribute of the class."""

from __future__ import annotations

import ast
from collections import Counter
from collections.abc import Iterable, Iterator

from rpg.passes.codegen.layout import Each, Expr, Group, Infix, Labelled
from rpg.passes.codegen.naming import collective, unique

FEWEST = 4
"""Names in a list that is worth sharing."""
Names = tuple[str, ...]


def shared(exprs: Iterable[Expr], blocks: Names, taken: Iterable[str]) -> dict[Names, str]:
    """The long lists that occur more than once, each with the name of its attribute; `blocks` are all of the task's."""
    uses = Counter(names for expr in exprs for names in _lists(expr))
    found: dict[Names, str] = {}
    for names, count in uses.items():
        if count > 1:
            words = "blocks" if plain(names) == blocks else collective(plain(names))
            found[names] = unique(words, (*taken, *found.values()))
    return found


def replaced(expr: Expr, attributes: dict[Names, str]) -> Expr:
    """`expr` with shared lists by their names."""
    match expr:
        case Group(head, items, brackets):
            name = attributes.get(_names(items))
            if name is not None:
                return Group(head, (f"*self.{name}",)) if head else f"self.{name}"
            return Group(head, tuple(replaced(item, attributes) for item in items), brackets)
        case Infix(operator, operands):
            return Infix(operator, tuple(replaced(operand, attributes) for operand in operands))
        case Labelled(label, value):
            return Labelled(label, replaced(value, attributes))
        case Each(element, variable, source):
            return Each(replaced(element, attributes), variable, replaced(source, attributes))
        case _:
            return expr


def _lists(expr: Expr) -> Iterator[Names]:
    """The lists of names in an expression that are long enough to be worth sharing."""
    match expr:
        case Group(_, items, _):
            names = _names(items) if len(items) >= FEWEST else ()
            if names:
                yield names
            for item in items:
                yield from _lists(item)
        case Infix(_, operands):
            for operand in operands:
                yield from _lists(operand)
        case Labelled(_, value):
            yield from _lists(value)
        case Each(element, _, source):
            yield from _lists(element)
            yield from _lists(source)


def _names(items: tuple[Expr, ...]) -> Names:
    """The items where all are strings in quotes, else nothing."""
    if items and all(isinstance(item, str) and item[:1] in "\"'" for item in items):
        return tuple(str(item) for item in items)
    return ()


def plain(names: Names) -> Names:
    """Quoted names without their quotes."""
    return tuple(str(ast.literal_eval(name)) for name in names)
