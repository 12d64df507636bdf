"""Codes reported while reading an instruction."""

from __future__ import annotations

from rpg.core.codes.base import Code

CODES: tuple[Code, ...] = (
    Code(
        "empty",
        "there is no instruction",
        "The text is empty or only white space.",
        " ",
        "put the red block on the blue block",
    ),
    Code(
        "too-long",
        "the instruction is too long",
        "Instructions have at most 1,000 characters. Longer texts are stories rather than tasks.",
        "put the red block on the blue block " * 30,
        "put the red block on the blue block",
    ),
    Code(
        "control-character",
        "there is a control character in the text",
        "Control and other invisible characters are refused, since what is seen would not be what is read.",
        "put the red block\x07 on the blue block",
        "put the red block on the blue block",
    ),
    Code(
        "no-words", "there are no words", "The text holds signs only.", "?!...", "put the red block on the blue block"
    ),
    Code(
        "other-language",
        "the text is not English",
        "Only English is understood by the built-in front end.",
        "stelle den roten block auf den blauen",
        "put the red block on the blue block",
    ),
    Code(
        "code",
        "the text is program code",
        "Instructions are sentences; code is never read or run.",
        "import os; os.remove('x')",
        "put the red block on the blue block",
    ),
    Code(
        "stray-character",
        "a character means nothing here",
        "A sign that is no part of the language stands in the text.",
        "put the red block on the blue block #",
        "put the red block on the blue block",
    ),
    Code(
        "unknown-word",
        "a word means nothing here",
        "The word is not in the lexicon and is not a misspelling of exactly one known word. No word is ever skipped.",
        "put the sofa on the blue block",
        "put the red block on the blue block",
    ),
    Code(
        "misplaced-word",
        "a known word stands where it does not fit",
        "Everything before the word was understood; with it, no reading of the sentence goes on.",
        "put the red block onto on the blue block",
        "put the red block on the blue block",
    ),
    Code(
        "incomplete",
        "the sentence stops too early, or its words do not add up",
        "All the words are known, but they do not add up to a statement of what should be done. Where the rest of the "
        "sentence is understood, only the part that is not is underlined.",
        "the red block and",
        "put the red block on the blue block",
    ),
    Code(
        "misplaced",
        "something is understood, but does not fit here",
        "A phrase has a meaning, but none that its verb or its structure can use. It is refused, not ignored.",
        "put the red block in the blue block",
        "put the red block on the blue block",
    ),
    Code(
        "too-complex",
        "the sentence is too tangled",
        "Reading the sentence would take more work than is allowed.",
        "a tower with red at the bottom, " * 18 + "a tower with red at the",
        "put the red block on the blue block",
    ),
    Code(
        "ambiguous",
        "the text can be read in two ways",
        "Two readings lead to different goals, and no convention of the domain decides between them.",
        "there are three red blocks. put the red block on the blue patch",
        "there are three red blocks. put one of the red blocks on the blue patch",
    ),
    Code(
        "no-referent",
        "a phrase refers to nothing",
        "A pronoun, a place or a part refers to something that was not mentioned.",
        "put it on the table",
        "put the red block on the blue block",
    ),
    Code(
        "no-goal",
        "nothing is asked for",
        "The text names blocks, but not where they should be at the end, or asks for what cannot be checked then.",
        "pick up the red block",
        "pick up the red block and put it on the blue block",
    ),
    Code(
        "conditional",
        "something depends on a condition",
        "A goal is to be reached in any case. What holds only if something else does cannot be checked at the end, and "
        "what comes before something is told by 'first' and 'then'.",
        "if the red block is on the blue patch, put the green block on it",
        "first put the red block on the blue patch, then put the green block on the red block",
    ),
    Code(
        "unused-block",
        "a block is named and then forgotten",
        "A block is spoken of, but no condition mentions it. It may have been meant as a distractor.",
        "a red, a blue and a green block: red on blue",
        "red on blue, with a green block as a distractor",
    ),
    Code(
        "unsupported-structure",
        "a structure is not understood",
        "The structure is known, but not in this number or form.",
        "build ten pyramids",
        "build a pyramid",
    ),
    Code(
        "between-two",
        '"between" does not have two ends',
        "Something lies between exactly two others.",
        "put the red block between the blue block",
        "put the red block between the blue block and the green block",
    ),
)
