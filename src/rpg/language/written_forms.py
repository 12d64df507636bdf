"""Words as they are written: contractions, with and without their mark, and British spelling."""

from __future__ import annotations

CONTRACTIONS = {
    "don't": "do not", "doesn't": "does not", "didn't": "did not", "isn't": "is not", "aren't": "are not",
    "wasn't": "was not", "weren't": "were not", "shouldn't": "should not", "mustn't": "must not", "can't": "can not",
    "cannot": "can not", "won't": "will not", "wouldn't": "would not", "couldn't": "could not", "i'd": "i would",
    "i'll": "i will", "i'm": "i am", "i've": "i have", "it's": "it is", "that's": "that is", "there's": "there is",
    "theres": "there is", "eachother": "each other", "outa": "out of", "outta": "out of",
    "let's": "let us", "they're": "they are", "you're": "you are", "we're": "we are", "here's": "here is",
    "it'd": "it would", "it'll": "it will", "that'd": "that would", "that'll": "that will",
    "who's": "who is", "you've": "you have",
    "we've": "we have", "we'll": "we will", "you'll": "you will", "they've": "they have", "haven't": "have not",
    "hasn't": "has not",
    "what's": "what is", "we'd": "we would", "you'd": "you would", "dont": "do not", "lets": "let us",
    "thats": "that is", "doesnt": "does not", "didnt": "did not", "isnt": "is not", "arent": "are not",
    "shouldnt": "should not", "mustnt": "must not", "cant": "can not", "wouldnt": "would not", "wasnt": "was not",
    "ontop": "on top", "inbetween": "in between", "infront": "in front", "gotta": "have to", "wanna": "want to",
    "gimme": "give me", "lemme": "let me", "gonna": "going to", "ur": "your", "'em": "them", "em": "them",
    "w/": "with", "w/o": "without", "w/out": "without",
    "onto": "onto", "into": "into",
}  # fmt: skip

UNMARKED = {
    "ive": "i have", "im": "i am", "theyre": "they are", "youre": "you are", "theyve": "they have",
    "youve": "you have", "itll": "it will", "thatll": "that will", "werent": "were not", "havent": "have not",
    "hasnt": "has not", "couldnt": "could not", "whats": "what is", "heres": "here is", "id": "i would",
}  # fmt: skip
"""Typed without their mark; in capitals they are letters to be spelt."""

AMERICAN = {
    "colour": "color", "colours": "colors", "coloured": "colored", "colourful": "colorful", "grey": "gray",
    "centre": "center",
    "centres": "centers", "centred": "centered", "neighbour": "neighbor", "neighbours": "neighbors",
    "neighbouring": "neighboring",
    "metre": "meter", "metres": "meters", "organise": "organize", "multicoloured": "multicolored",
    "storey": "story", "storeys": "stories",
    "courses": "layers",
    "merely": "only", "solely": "only", "purely": "only", "whereby": "where", "unto": "onto", "him": "it",
    "upto": "up to",
    "invert": "reverse", "inverts": "reverses", "inverted": "reversed", "inverting": "reversing",
    "box": "block", "boxes": "blocks", "brick": "block", "bricks": "blocks",
    **{form + end: f"block{'s' * bool(end)}" for form in ("crate", "carton", "parcel", "package") for end in ("", "s")},
    "bin": "patch", "bins": "patches", "pallet": "patch", "pallets": "patches",
    "bench": "table", "workbench": "table", "worktop": "table", "countertop": "table",
    **{word + said: meant for word in ("terminat", "conclud")
       for said, meant in (("e", "end"), ("es", "ends"), ("ed", "ended"), ("ing", "ending"))},
    "policy": "agent", "controller": "agent", "planner": "agent", "learner": "agent",
}  # fmt: skip
"""Spellings that are read as one."""
