"""What is asked for as a task: "I'd like a pick-and-place task with three cubes and three patches", "a task where red
goes on blue"."""

from __future__ import annotations

from rpg.language.grammar.rows.turned import Turn
from rpg.language.grammar.rows.vocabulary import MANY

_ASKED = (
    "(?:(?:i|we) (?:want|need|would like|'d like|would love|propose|suggest|am after|have in mind) (?:to have |to "
    "see )?|(?:please )?(?:give|make|create|design|build|generate|set up|define|write|add|show) (?:me |us )?|"
    "(?:here|this) is |how about |what about )?"
)
_SORTS = (
    "(?:(?:new|another|simple|easy|quick|hard|small|short|basic|little|nice|pick|and|place|-|stacking|sorting|spelling|"
    "building|rearranging|rearrangement|manipulation|robot|tabletop|multi|step|block|toy) )*"
)
_TASK = (
    f"^{_ASKED}(?:an?|one|the|my|our) {_SORTS}(?:task|scenario|exercise|benchmark|episode|problem|puzzle|challenge) "
)

TASK_TOLD: tuple[Turn, ...] = (
    (f"{_TASK}(?:where|in which|such that|so that|that asks (?:for|that)|(?:that|which) requires that) ", ""),
    (f"{_TASK}(?:with|that has|which has|of) (?=(?:an?|{MANY}) )", "there are "),
)
"""What makes no sense as it stands."""
