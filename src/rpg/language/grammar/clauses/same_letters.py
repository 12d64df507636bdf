"""Words that are spelt one after the other, or either of them, with the same cubes."""

from __future__ import annotations

from rpg.language.meaning import Amount, Clause, Coord, Meaning, Noun, Pronoun, Structure, Using, replace


def same_letters(before: Clause, item: Meaning) -> Meaning:
    """ "spell TEA or EAT", "spell TEA, then EAT": either word is of the same cubes."""
    one, two = before.theme, item.theme if isinstance(item, Clause) else None
    if not (isinstance(one, Structure) and isinstance(two, Structure) and isinstance(item, Clause)):
        return item
    same = bool(one.letter) and one.kind == two.kind == "word" and sorted(one.letter or "") == sorted(two.letter or "")
    own = [a for a in item.adjuncts if isinstance(a, Using)]
    if not same or any(isinstance(a.members, Noun) and a.members.traits.labels for a in own):
        return item
    listed = [a.members for a in own if not isinstance(a.members, Noun | Structure)]
    if any(_one_each(members) != sorted(two.letter or "") for members in listed):
        return item
    them = Using(members=Pronoun(word="them", span=two.span), span=two.span)
    return replace(item, verb="spell", adjuncts=(*(a for a in item.adjuncts if a not in own), them))


def _one_each(members: Meaning | None) -> list[str]:
    """The letters of "one N cube and one O cube", sorted."""
    nouns = [x for x in members.items if isinstance(x, Noun)] if isinstance(members, Coord) else []
    single = [noun for noun in nouns if noun.amount in (None, Amount(1, 1))]
    return sorted(letter for noun in single for letter in noun.traits.labels)
