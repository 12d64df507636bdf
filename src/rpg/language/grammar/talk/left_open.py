"""Phrases that leave open what is open anyway: "in any order", "whichever you like", "it does not matter where"."""

from __future__ import annotations

from collections.abc import Iterable

from rpg.language.grammar.core import Parser
from rpg.language.grammar.talk.slots import Patterns

_NUMBERS = "two|three|four|five|six|2|3|4|5|6"
_THEM = "of_them|of_these|of_those|of_the_two|of_the_three|of_the_four|of_the_five|of_both"
_ONES = "one|ones|blocks|cubes|bricks|boxes|block|cube|brick|box"
_YOU = "|".join(
    f"{who}_{like}"
    for who in ("you", "we", "they")
    for like in ("take", "pick", "choose", "use", "move", "like", "want", "please", "prefer", "fancy", "wish", "select")
)
_WHERE = "|".join(f"{goes}_where" for goes in ("goes", "go", "is", "are", "comes", "stands", "ends_up", "gets_put"))
_WHICH = f"which|what {_NUMBERS}? {_ONES}? {_THEM}? {_YOU}? it_is|they_are|that_is|those_are|{_WHERE}?"
_MINE = "really|entirely|completely|totally|quite|all? up_to_you|up_to_the_robot|your_choice|your_decision|left_to_you"
_VAIN = (f"{_MINE}|irrelevant|unimportant|immaterial|not_important|not_relevant|of_no_importance|all_the_same|all_one|"
         "no_matter to_me|to_us|for_me|here?")  # fmt: skip
_MATTERS = (
    "do|does not really|actually|particularly? matter|make_a_difference|make_any_difference to_me|to_us|here|at_all?"
)
_DOES = ("will|would do|do_just_fine|do_fine|work|be_fine|be_ok|be_okay|suit_me",
         "is|are|be perfectly|just? fine|ok|okay|good|acceptable|allowed|possible|all_right|alright with|by|"
         "for? me|us?",
         "works|work|does|do|counts|count|suits|suit for_me|for_us|me?")  # fmt: skip
WHICHEVER = Patterns(
    f"it|that|this really|actually? {_MATTERS} {_WHICH}",
    f"it|that makes|make really? no difference to_me|to_us|here|at_all? {_WHICH}",
    f"it|that is|remains {_VAIN} {_WHICH}",
    f"no_matter|never_mind|regardless_of|irrespective_of|does_not_matter|do_not_mind|do_not_care {_WHICH}",
    f"i|we really|honestly? do not really|particularly|much? care|mind about? {_WHICH}",
    f"you|the_robot can|may|get_to|are_free_to|is_free_to? choose|chooses|pick|decide|decides|select freely? {_WHICH}",
    f"i|we will|gladly? leave|leaves it to_you|up_to_you|open {_WHICH}",
    f"{_WHICH} really|actually? {_MATTERS}",
    f"{_WHICH} really? makes|make no difference to_me|to_us|here|at_all?",
    f"{_WHICH} is|are|remains {_VAIN}",
    f"whichever|whatever|any {_NUMBERS}? {_ONES}? {_THEM}? {_YOU}|is_easier|is_easiest|are_easiest|comes_to_hand",
    f"i|we am|are really|quite? indifferent|easy|not_fussed|not_fussy as_to|about|about_that? {_WHICH}",
    f"i|we have no preference as_to|about? {_WHICH}",
    "i|we am|are really|quite? indifferent|easy|not_fussed|not_fussy about_that?",
    *(f"{which} {_NUMBERS}? {_ONES}? {_THEM}? {does}" for which in ("any", "either|anyone") for does in _DOES),
)
"""What leaves open which of several it is, wherever it is set off."""
_OUT_OF_THEM = Patterns(f"any|either|whichever one|{_NUMBERS}? {_THEM}", f"any|whichever one|{_NUMBERS}")
"""The same of some that are taken out of several, in short: "one of the four, any of them"."""
_OF_THESE = frozenset({"the", "these", "those", "my", "our", "your", "them"})
_ONE = frozenset({"one", "either", "anyone"})
_CHOICE = frozenset({"or", "one", "any", "either", "some", "whichever", "side", "order", "way", "corner", "end"})


def left_to_choose(p: Parser, at: int) -> int:
    """The position behind words that leave open which ones; not where they speak of another number than the rest, or
    of one of those that are all asked for."""
    found = [*WHICHEVER.matches(p, at)] if p.stands(at, WHICHEVER.firsts) else []
    if not found and p.stands(at, _OUT_OF_THEM.firsts) and any(_taken(p, n) for n in range(at)):
        found = [*_OUT_OF_THEM.matches(p, at)]
    for end in reversed(found):
        told = {p.number(n) for n in range(at, end) if p.words[n - 1] != "the"} - {None, 1}
        if told and not told <= {p.number(n) for n in (*range(at), *range(end, p.end))}:
            continue
        one = not _ONE.isdisjoint(p.words[at:end]) and "where" not in p.words[at:end]
        if not one or _chosen_from(p, (*range(at), *range(end, p.end))):
            return end
    return 0


def _taken(p: Parser, at: int) -> bool:
    """ "(Exactly) one of the ...": so many out of several that were named."""
    return p.stands(at, ("of",)) and p.stands(at + 1, _OF_THESE) and at > 0 and p.number(at - 1) is not None


def _chosen_from(p: Parser, rest: Iterable[int]) -> bool:
    """Whether not all of what is named is asked for."""
    told = [p.words[n] for n in rest]
    return not _CHOICE.isdisjoint(told) or ("and" not in told and not {"a", "an"}.isdisjoint(told))


FREE = (
    *(
        f"{lead}{which} order{free}"
        for lead in ("", "in ")
        for which in ("any", "whatever", "whichever")
        for free in ("", " you like", " you want", " you please", " you prefer", " you wish", " you choose",
                     " suits you", " at all", " is fine with me", " you fancy", " will do", " is fine", " works",
                     " i do not mind")
    ),
    "the order does not matter", "order does not matter", "no matter the order",
    *(f"{the} order{of} {free}"
      for the in ("the", "their", "its")
      for of in ("", " of the rows", " of the columns", " of the layers", " of the colors",
                 *(f" {inside} {each} {whole}" for inside in ("inside", "within", "in") for each in ("the", "each", "a")
                   for whole in ("stack", "tower", "row", "line", "column", "pile", "group")))
      for free in ("does not matter", "is up to you", "is free", "is your choice", "is irrelevant", "is open",
                   "is not important", "is unimportant", "is of no importance", "is not relevant")),
    *(f"{lead} the order" for lead in ("i do not care about", "do not care about", "never mind", "ignore")),
    *(f"{it}does not matter {which} order" for it in ("it ", "") for which in ("in which", "in what", "which", "what")),
    *(f"{the}order of the {others} {free}"
      for the in ("the ", "") for others in ("other two", "others", "rest", "other ones", "other three")
      for free in ("open", "is open", "does not matter", "is up to you", "is free")),
    "its direction does not matter", "any orientation", "in any orientation",
    "no particular order", "in no particular order", "whichever way", "whichever way you like",
    "any way you like", "however you like", "whichever direction", "in whichever direction",
    "direction does not matter", "the direction does not matter", "in no particular direction",
    "regardless of the order", "regardless of order", "the exact order does not matter", "in random order",
    "in a random order", "hello", "hi", "hello there", "hi there", "hello robot", "hi robot", "hey", "hey robot",
    "hello everyone", "good morning", "good day", "dear robot", "ok", "okay", "alright", "great", "your choice",
    "up to you", "as you like", "you choose",
    "whichever", "whatever", "your pick", "you pick", "take your pick", "your call", "you decide", "you can decide",
    "whatever is easier", "whichever is easier", "whatever is easiest", "go", "easy one first", "next level", "today",
    "i do not care which of the others is on top", "please do one thing", "not even a bit", "not one bit",
    "i have no preference", "we have no preference", "no preference", "not fussy", "not fussed", "all the same to me",
    "it is all the same to me", "it is all the same to us", "it is all one to me", "it makes no difference",
    "makes no difference", "it makes no difference to me", "makes no difference to me", "i really do not care",
    "i do not really care", "i really do not mind", "either way works", "either way suits me",
    "that will do", "that will do fine", "that will be fine", "that would do",
    "i could not care less", "i could not care less which", "either side will do", "either way will do",
    *(f"{lead}{both}{free}" for lead in ("", "and ") for both in ("both count", "either counts", "either one counts")
      for free in ("", " as success", " as a success", " as done", " as solved", " as right", " as correct")),
    *(f"{both} {free}"
      for both in ("both is", "both are", "either side is", "either way is")
      for free in ("acceptable", "fine", "ok", "okay", "all right", "alright", "good", "possible", "allowed")),
    *(f"{lead} {which}"
      for lead in ("it does not matter", "does not matter", "no matter", "i do not care", "do not care",
                   "i do not mind")
      for which in ("which", "which one", "which ones", "where", "which side", "on which side", "how", "how exactly")),
    "distance does not matter", "the distance does not matter", "at whatever distance", "no matter how far",
    "any color", "any colors", "of any color", "whatever color", "whatever colors", "the color does not matter",
    "color does not matter", "colors do not matter", "the colors do not matter", "any color will do",
    "any color is fine", "i do not care", "do not care", "i do not mind", "rather", "whichever you prefer",
    "whatever you prefer", "whichever you like", "whatever you like",
    "the side does not matter", "on whichever side", "whichever side", "in either order", "either order is fine",
    "which goes where is up to you", "which one goes where is up to you", "which is which does not matter",
    "which goes where does not matter", "it does not matter which goes where", "in both cases", "in either case",
    "in any case", "however", "which ones does not matter", "which ones is up to you",
    "which ones you choose is up to you", "which ones you like", "whichever one",
    *(
        f"{lead} {which} {hue}{have}"
        for lead in ("it does not matter", "no matter", "i do not care", "i do not mind", "does not matter",
                     "do not care", "do not mind", "not fussed")
        for which in ("which", "what")
        for hue in ("color", "colors")
        for have in ("", " they have", " they are", " you use", " you take", " it has", " it is")
    ),
    *(f"{lead} {which} {blocks}{use}"
      for lead in ("it does not matter", "does not matter", "no matter", "i do not care", "do not care",
                   "i do not mind")
      for which in ("which", "what")
      for blocks in ("blocks", "cubes", "ones")
      for use in ("", " you use", " you take")),
    *(f"{lead} {hues}"
      for lead in ("i do not care about", "do not care about", "never mind", "no matter", "i do not mind")
      for hues in ("colors", "the colors", "the color")),
    *(f"{lead}{who} have no preference{tail}"
      for who in ("i", "we")
      for lead, tail in (*(("", f" {about} {hue}") for about in ("for", "on", "about", "regarding")
                           for hue in ("color", "colors", "the color", "the colors")),
                         *((f"for {hue} ", "") for hue in ("color", "colors", "the color", "the colors")))),
    "colors random", "color random", "nothing else counts", "it is fine either way", "fine either way",
    *(f"{the}order of {doing} {free}"
      for the in ("the ", "") for doing in ("stacking", "placing", "placement", "doing it")
      for free in ("does not matter", "is not important", "is free", "is irrelevant", "is up to you", "is open")),
    *(f"{what} {free}" for what in ("color", "colors", "order", "sizes", "the rest", "the others", "rest", "others")
      for free in ("whatever", "whichever", "any", "not important", "unimportant", "irrelevant", "up to you")),
    *(f"{who} do not {care} the {rest}" for who in ("i", "we") for care in ("care about", "mind", "mind about")
      for rest in ("rest", "others", "other ones", "other blocks")),
    "any corner", "whichever corner", "which corner does not matter", "no matter which corner",
    "not necessarily directly", "not necessarily next to it", "not necessarily adjacent",
    "that is all", "that is it", "finish", "i think", "nothing else matters", "nothing else really matters",
    "all good", "otherwise it does not count", "otherwise it is not done", "otherwise you fail",
    *(
        f"{lead}{which} {hue}{free}"
        for lead in ("", "in ", "of ", "with ", "using ")
        for which in ("any", "whatever", "whichever", "arbitrary", "random")
        for hue in ("color", "colors")
        for free in ("", " you like", " you want", " you have", " you please", " you prefer", " is fine", " are fine",
                     " will do", " there are", " at all", " will be fine", " is ok")
    ),
    "i leave it to you", "i leave that to you", "i will leave that to you", "i leave the choice to you",
    "i leave it up to you", "i leave which to you", "that is up to you", "the choice is yours",
    *(f"{lead}{choice}" for lead in ("with the ", "with ", "the ", "") for choice in (
        "colors however you like", "colors you choose", "colors you like", "colors you pick",
        "color however you like", "colors as you like", "colors of your choice",
        "colors up to you", "color up to you", "color of your choice", "colors are up to you", "color is up to you")),
)  # fmt: skip
"""What leaves open what is open anyway, beside a comma or at an end of the sentence."""
ANY_OF_THEM = tuple(
    f"{which} {blocks}{free}"
    for which in ("any", "whichever", "whatever", "just any", "any old", "random")
    for blocks in ("blocks", "cubes", "bricks", "ones")
    for free in ("", " you like", " you want", " will do", " are fine", " do")
)
"""Behind so many blocks, at the end of their sentence, that it may be any."""
ANYPLACE = ("anywhere", "anywhere you like", "anywhere you want", "wherever", "wherever you like", "wherever you want",
            "no matter where", "it does not matter where", "does not matter where")  # fmt: skip
"""The same of the place of what is built or put down."""
FOREIGN = (
    "grazie", "grazie mille", "merci", "merci beaucoup", "merci bien", "danke", "danke schon", "vielen dank",
    "bitte", "gracias", "muchas gracias", "por favor", "obrigado", "obrigada", "muito obrigado", "per favore",
    "prego", "s'il vous plait", "s il vous plait", "sil vous plait", "arigato", "dank je", "dank je wel",
    "alstublieft", "takk", "tak", "kiitos", "spasibo", "efharisto", "shukran", "dziekuje", "ciao", "hola",
    "bonjour", "hallo", "namaste", "guten tag", "buenos dias", "salut", "servus", "ta very much",
)  # fmt: skip
"""Greetings and thanks of those who speak other languages as well."""
LOOSE = tuple(
    f"{lead}{what}{free}"
    for what in ("which way round", "which way it points", "how far", "how far away", "how far away it is",
                 "how far away they are", "how far it is", "the distance", "the exact place",
                 "where exactly", "where on the table")
    for lead, free in (("it does not matter ", ""), ("does not matter ", ""), ("no matter ", ""),
                       ("", " does not matter"), ("", " is up to you"), ("", " is not important"),
                       *((f"{who} do not {mind} ", "") for who in ("i", "we") for mind in ("mind", "care")))
)  # fmt: skip
"""The same of places and ways round: what is told of a line or of a distance would not be so open."""
