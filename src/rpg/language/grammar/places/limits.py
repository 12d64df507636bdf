"""Words that bound a length, in front of it and behind it."""

from __future__ import annotations

AROUND = {"about": 0.25, "around": 0.25, "roughly": 0.25, "approximately": 0.25, "nearly": 0.25,
           "circa": 0.25, "ca": 0.25, "some": 0.25, "more or less": 0.25, "exactly": 0.0, "precisely": 0.0}  # fmt: skip
LIMITS = {
    "at least": "low", "more than": "low", "no less than": "low", "a minimum of": "low", "at most": "high",
    "less than": "high", "no more than": "high", "within": "high", "up to": "high", "not more than": "high",
    "not less than": "low", "not farther than": "high", "not further than": "high", "not closer than": "low",
    "a maximum of": "high", "closer than": "high", "over": "low", "under": "high",
    "maximum": "high", "minimum": "low", "nearer than": "high", "farther than": "low", "further than": "low",
    "no closer than": "low", "no nearer than": "low", "no farther than": "high", "no further than": "high",
    "not over": "high", "not under": "low", "below": "high", "above": "low", "not below": "low", "not above": "high",
    "beyond": "low",
    **{f"{no}{more} than": "high" if bool(no) == (way == "low") else "low"
       for way, words in (("high", ("smaller", "shorter", "narrower", "lower")),
                          ("low", ("greater", "larger", "bigger", "wider", "longer")))
       for more in words for no in ("", "no ", "not ")},
    "not exceeding": "high", "fewer than": "high",
}  # fmt: skip
"""What a length that follows bounds."""


OR_MORE = ("or more", "or farther", "or further", "and more", "at least", "at the least", "minimum", "at minimum")
OR_LESS = ("or less", "or closer", "or nearer", "at most", "at the most", "maximum", "at maximum")
"""What bounds a length in front of it."""


GIVE = (
    "plus or minus", "plus minus", "+ / -", "+ -", "give or take", "with a tolerance of", "tolerance",
    "tolerance of", "to within", "with tolerance", "tolerance :", "with an accuracy of", "with a precision of",
    "to an accuracy of", "with an error of at most", "accurate to", "accurate to within", "with a tolerance of at most",
    "with a margin of", "within a tolerance of", "to a tolerance of", "+ or -",
)  # fmt: skip
