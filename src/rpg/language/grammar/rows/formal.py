"""Which rows a sentence is turned by, in their order: those of every sentence, and those of one that cannot be read."""

from __future__ import annotations

import re
from dataclasses import replace

from rpg.language import lexicon
from rpg.language.grammar.rows.across import ACROSS
from rpg.language.grammar.rows.all_sides import all_sides
from rpg.language.grammar.rows.alternatives import ALTERNATIVES, ALTERNATIVES_AT_ONCE, EITHER_WAY
from rpg.language.grammar.rows.around_it import AROUND_AT_ONCE, around_named
from rpg.language.grammar.rows.asked_aloud import ASKED_ALOUD, ASKED_ALOUD_AT_ONCE
from rpg.language.grammar.rows.barred_there import BARRED_THERE, BARRED_THERE_AT_ONCE
from rpg.language.grammar.rows.become import BECOME, BECOME_AT_ONCE
from rpg.language.grammar.rows.before_and_after import BEFORE_AND_AFTER, ORDER_CHANGED, WITH_ITS_TOP
from rpg.language.grammar.rows.begun import BEGUN, BEGUN_AT_ONCE, FROM_BLOCK_TO_BLOCK
from rpg.language.grammar.rows.beside_it import BESIDE_IT, BESIDE_IT_AT_ONCE
from rpg.language.grammar.rows.besides import BESIDES, BESIDES_AT_ONCE
from rpg.language.grammar.rows.borne_first import BORNE_FIRST
from rpg.language.grammar.rows.both_bounds import BOTH_BOUNDS
from rpg.language.grammar.rows.bridges import BRIDGES
from rpg.language.grammar.rows.but_one import BUT_ONE, BUT_ONE_AT_ONCE, EXCEPTED_ACROSS
from rpg.language.grammar.rows.by_turns import BY_TURNS_AT_ONCE
from rpg.language.grammar.rows.cleared_parts import CLEARED_PARTS
from rpg.language.grammar.rows.column_words import column_words
from rpg.language.grammar.rows.contrasted import CONTRASTED
from rpg.language.grammar.rows.contrasts import CONTRASTS, CONTRASTS_ACROSS
from rpg.language.grammar.rows.corners import corners_again
from rpg.language.grammar.rows.corners_told import CORNERS_ACROSS, CORNERS_AT_ONCE, CORNERS_TOLD
from rpg.language.grammar.rows.counts import COUNTED, SHARED_OUT
from rpg.language.grammar.rows.data_sheets import DATA_SHEETS
from rpg.language.grammar.rows.destinations import DESTINATIONS
from rpg.language.grammar.rows.distances import DISTANCES, DISTANCES_AT_ONCE, SPACED_AT_ONCE
from rpg.language.grammar.rows.each_side import EACH_SIDE
from rpg.language.grammar.rows.emphatic import EMPHATIC, EMPHATIC_AT_ONCE
from rpg.language.grammar.rows.ends_of_towers import ENDS_OF_TOWERS, ENDS_OF_TOWERS_AT_ONCE
from rpg.language.grammar.rows.everyday import EVERYDAY, EVERYDAY_AT_ONCE
from rpg.language.grammar.rows.faced import FACED, FACED_AT_ONCE
from rpg.language.grammar.rows.figures import BOARDS, FIGURES
from rpg.language.grammar.rows.figures_asked import FIGURES_ASKED_AT_ONCE
from rpg.language.grammar.rows.from_to import FROM_TO
from rpg.language.grammar.rows.gapped import GAPPED, GAPPED_AT_ONCE
from rpg.language.grammar.rows.headed_start import headed_start
from rpg.language.grammar.rows.how_far import HOW_FAR, HOW_FAR_AT_ONCE
from rpg.language.grammar.rows.ignored_there import IGNORED_THERE
from rpg.language.grammar.rows.in_conversation import IN_CONVERSATION, TOLD_OF_BOTH
from rpg.language.grammar.rows.in_steps import IN_STEPS
from rpg.language.grammar.rows.in_writing import IN_WRITING
from rpg.language.grammar.rows.kept_and_moved import FALLEN, KEPT_AND_MOVED, KEPT_AT_ONCE
from rpg.language.grammar.rows.kinds_in_rows import KINDS_IN_ROWS
from rpg.language.grammar.rows.kinds_told_if import KINDS_ACROSS, KINDS_TOLD_IF
from rpg.language.grammar.rows.labels_counted import labels_counted
from rpg.language.grammar.rows.labels_there import LABELS_THERE
from rpg.language.grammar.rows.leave_to_move import leave_to_move
from rpg.language.grammar.rows.letters_of_a_word import LETTERS_OF_A_WORD, word_of_letters
from rpg.language.grammar.rows.lines import LINED_AT_ONCE, MIRRORS_AT_ONCE, PLACES_BY_NUMBER, RAINBOWS_AT_ONCE
from rpg.language.grammar.rows.listed_lines import listed_lines
from rpg.language.grammar.rows.listed_of_all import listed_of_all
from rpg.language.grammar.rows.lots_told import LOTS, LOTS_AT_ONCE
from rpg.language.grammar.rows.lying_there import LYING_THERE_AT_ONCE
from rpg.language.grammar.rows.mats_hold import MATS_HOLD, MATS_HOLD_AT_ONCE, ON_SOME_MAT
from rpg.language.grammar.rows.measured_so import MEASURED_SO
from rpg.language.grammar.rows.members_told import MEMBERS_TOLD
from rpg.language.grammar.rows.moved_off import MOVED_OFF_AT_ONCE, OFF_ONTO
from rpg.language.grammar.rows.nominal import NOMINAL, NOMINAL_AT_ONCE
from rpg.language.grammar.rows.not_at_end import NOT_THERE, NOT_THERE_AT_ONCE, not_at_end
from rpg.language.grammar.rows.not_consecutive import not_consecutive
from rpg.language.grammar.rows.not_falling import not_falling
from rpg.language.grammar.rows.noted_down import NOTED_DOWN
from rpg.language.grammar.rows.of_each_color import of_each_color
from rpg.language.grammar.rows.of_structures import OF_STRUCTURES, OF_STRUCTURES_AT_ONCE
from rpg.language.grammar.rows.on_several import ON_SEVERAL, ON_SEVERAL_AT_ONCE
from rpg.language.grammar.rows.one_color_each import ONE_COLOR_EACH
from rpg.language.grammar.rows.one_more import one_more
from rpg.language.grammar.rows.one_row_and_one import one_row_and_one
from rpg.language.grammar.rows.order_matters import ORDER_MATTERS_AT_ONCE
from rpg.language.grammar.rows.ordered import ORDERED, ORDERED_AT_ONCE
from rpg.language.grammar.rows.other_end import other_end_named, row_with_ends
from rpg.language.grammar.rows.others_counted import others_counted
from rpg.language.grammar.rows.others_elsewhere import others_elsewhere
from rpg.language.grammar.rows.own_color import OWN_COLOR, OWN_COLOR_ACROSS, OWN_COLOR_AT_ONCE
from rpg.language.grammar.rows.palindromes import palindromes
from rpg.language.grammar.rows.parts_of_each import parts_of_each
from rpg.language.grammar.rows.patches_told import ONE_AND_THE_OTHER, PATCHES_AT_ONCE, PATCHES_UNREAD
from rpg.language.grammar.rows.plain_talk import PLAIN_TALK, PLAIN_TALK_AT_ONCE
from rpg.language.grammar.rows.put_otherwise import OTHERWISE, OTHERWISE_AT_ONCE
from rpg.language.grammar.rows.pyramids import PYRAMIDS
from rpg.language.grammar.rows.quantified import EACH_THERE, QUANTIFIED, WHICHEVER
from rpg.language.grammar.rows.rainbow_told import RAINBOW_SPANS, announced_rainbow
from rpg.language.grammar.rows.range_but import range_but
from rpg.language.grammar.rows.related import RELATED, RELATED_AT_ONCE
from rpg.language.grammar.rows.result_told import result_told
from rpg.language.grammar.rows.reworded import REWORDED, REWORDED_AT_ONCE
from rpg.language.grammar.rows.roundabout import ROUNDABOUT, ROUNDABOUT_AT_ONCE
from rpg.language.grammar.rows.row_edited import row_edited
from rpg.language.grammar.rows.row_places import told_by_places
from rpg.language.grammar.rows.said_again import SAID_AGAIN
from rpg.language.grammar.rows.said_short import SHORT, SHORT_AT_ONCE
from rpg.language.grammar.rows.separately import ONE_TOPPED, SEPARATELY
from rpg.language.grammar.rows.sided import SIDED_AT_ONCE, UTMOST_TOLD
from rpg.language.grammar.rows.sizes_told import SIZES_TOLD, SIZES_TOLD_AT_ONCE
from rpg.language.grammar.rows.so_many_inside import so_many_inside
from rpg.language.grammar.rows.so_many_on_each import so_many_on_each
from rpg.language.grammar.rows.some_letters import some_of_the_letters
from rpg.language.grammar.rows.spawned import SPAWNED
from rpg.language.grammar.rows.specified import REQUIRED, REQUIRED_AT_ONCE, SPECIFIED, SPECIFIED_AT_ONCE
from rpg.language.grammar.rows.stairs import STAIRS, of_the_figure
from rpg.language.grammar.rows.sums import SUMS_AT_ONCE
from rpg.language.grammar.rows.sums_asked import sums_asked
from rpg.language.grammar.rows.sums_on_a_patch import sums_on_a_patch
from rpg.language.grammar.rows.swapped_over import swapped_over
from rpg.language.grammar.rows.task_told import TASK_TOLD
from rpg.language.grammar.rows.times import AT_THE_END, BEFORE_IT, IN_PASSING, OFF_FIRST
from rpg.language.grammar.rows.told_in_brief import ASSIGNED, TOLD_IN_BRIEF
from rpg.language.grammar.rows.told_once import TOLD_ONCE
from rpg.language.grammar.rows.tower_orders import UPRIGHT_AT_ONCE, UPWARD, UPWARD_AT_ONCE
from rpg.language.grammar.rows.towers import TOWERS, TOWERS_AT_ONCE
from rpg.language.grammar.rows.turned import Turns, all_of_it, turned
from rpg.language.grammar.rows.turned_round import TURNED_ROUND, TURNED_ROUND_AT_ONCE
from rpg.language.grammar.rows.two_rows import ROWS_PLACED, TWO_ROWS_AT_ONCE, rows_by_number
from rpg.language.grammar.rows.unidiomatic import UNIDIOMATIC, UNIDIOMATIC_AT_ONCE
from rpg.language.grammar.rows.verbs_of_place import VERBS_OF_PLACE
from rpg.language.grammar.rows.vocabulary import MUST
from rpg.language.grammar.rows.way_behind import PATTERNS_LINED, WAY_BEHIND
from rpg.language.grammar.rows.which_they_are import WHICH_THEY_ARE
from rpg.language.grammar.rows.wished_aloud import WISHED_ALOUD, WISHED_ALOUD_AT_ONCE
from rpg.language.grammar.rows.wished_such import WISHED_SUCH, WISHED_SUCH_AT_ONCE
from rpg.language.grammar.rows.word_again import word_again
from rpg.language.grammar.rows.wordier import WORDIER, WORDIER_AT_ONCE
from rpg.language.grammar.rows.written import WRITTEN, WRITTEN_AT_ONCE
from rpg.language.tokens import Token

_OF_ALL = (
    *NOTED_DOWN,
    *UNIDIOMATIC_AT_ONCE,
    *EMPHATIC_AT_ONCE,
    *OF_STRUCTURES_AT_ONCE,
    *IN_WRITING,
    *IN_CONVERSATION,
    *CONTRASTS,
    *WITH_ITS_TOP,
    *ORDER_CHANGED,
    *PLAIN_TALK_AT_ONCE,
    *ORDER_MATTERS_AT_ONCE,
    *LABELS_THERE,
    *EACH_SIDE,
    *ORDERED_AT_ONCE,
    *WRITTEN_AT_ONCE,
    *FACED_AT_ONCE,
    *LINED_AT_ONCE,
    *MIRRORS_AT_ONCE,
    *RAINBOWS_AT_ONCE,
    *SIDED_AT_ONCE,
    *SPACED_AT_ONCE,
    *SUMS_AT_ONCE,
    *TWO_ROWS_AT_ONCE,
    *KINDS_IN_ROWS,
    *DISTANCES_AT_ONCE,
    *AROUND_AT_ONCE,
    *LOTS_AT_ONCE,
    *BUT_ONE_AT_ONCE,
    *BESIDES_AT_ONCE,
    *PATCHES_AT_ONCE,
    *FROM_TO,
    *MOVED_OFF_AT_ONCE,
    *CORNERS_AT_ONCE,
    *LETTERS_OF_A_WORD,
    *BEGUN_AT_ONCE,
    *OFF_FIRST,
    *AT_THE_END,
    *BECOME_AT_ONCE,
    *IN_STEPS,
    *BOTH_BOUNDS,
    *COUNTED,
    *SHARED_OUT,
    *GAPPED_AT_ONCE,
    *SHORT_AT_ONCE,
    *SPECIFIED_AT_ONCE,
    *FIGURES_ASKED_AT_ONCE,
    *BY_TURNS_AT_ONCE,
    *SIZES_TOLD_AT_ONCE,
    *ROUNDABOUT_AT_ONCE,
    *FIGURES,
    *BOARDS,
    *PYRAMIDS,
    *STAIRS,
    *ONE_COLOR_EACH,
    *TOWERS_AT_ONCE,
    *ENDS_OF_TOWERS_AT_ONCE,
    *UPWARD_AT_ONCE,
    *UPRIGHT_AT_ONCE,
    *OTHERWISE_AT_ONCE,
    *EVERYDAY_AT_ONCE,
    *REQUIRED_AT_ONCE,
    *RELATED_AT_ONCE,
    *REWORDED_AT_ONCE,
    *WORDIER_AT_ONCE,
    *ASKED_ALOUD_AT_ONCE,
    *NOT_THERE_AT_ONCE,
    *KEPT_AT_ONCE,
    *SEPARATELY,
    *LYING_THERE_AT_ONCE,
    *MATS_HOLD_AT_ONCE,
    *BARRED_THERE_AT_ONCE,
    *OWN_COLOR_AT_ONCE,
    *EACH_THERE,
    *ALTERNATIVES_AT_ONCE,
    *TOLD_ONCE,
    *ROWS_PLACED,
    *ON_SEVERAL_AT_ONCE,
    *WISHED_ALOUD_AT_ONCE,
    *WISHED_SUCH_AT_ONCE,
    *HOW_FAR_AT_ONCE,
    *BESIDE_IT_AT_ONCE,
    *NOMINAL_AT_ONCE,
    *TURNED_ROUND_AT_ONCE,
    *TOLD_IN_BRIEF,
)
"""The rows of every sentence."""
_OF_THE_UNREAD = (
    *WHICH_THEY_ARE,
    *SAID_AGAIN,
    *PLAIN_TALK,
    *ORDERED,
    *WRITTEN,
    *FACED,
    *DISTANCES,
    *LOTS,
    *BESIDES,
    *PATCHES_UNREAD,
    *SPECIFIED,
    *ROUNDABOUT,
    *CONTRASTED,
    *BUT_ONE,
    *BEFORE_IT,
    *BEGUN,
    *BECOME,
    *OTHERWISE,
    *EVERYDAY,
    *REWORDED,
    *WORDIER,
    *SHORT,
    *REQUIRED,
    *GAPPED,
    *RELATED,
    *VERBS_OF_PLACE,
    *BRIDGES,
    *ENDS_OF_TOWERS,
    *BORNE_FIRST,
    *NOT_THERE,
    *ALTERNATIVES,
    *OWN_COLOR,
    *QUANTIFIED,
    *UTMOST_TOLD,
    *KEPT_AND_MOVED,
    *ON_SEVERAL,
    *TOWERS,
    *UPWARD,
    *ASKED_ALOUD,
    *PATTERNS_LINED,
    *WISHED_ALOUD,
    *WISHED_SUCH,
    *HOW_FAR,
    *BESIDE_IT,
    *SPAWNED,
    *RAINBOW_SPANS,
    *TASK_TOLD,
    *SIZES_TOLD,
    *CORNERS_TOLD,
    *CLEARED_PARTS,
    *KINDS_TOLD_IF,
    *MATS_HOLD,
    *BARRED_THERE,
    *DATA_SHEETS,
    *NOMINAL,
    *TURNED_ROUND,
    *UNIDIOMATIC,
    *EMPHATIC,
    *OF_STRUCTURES,
    *DESTINATIONS,
)
"""The rows of a sentence that cannot be read as it stands."""
_LAST_ACROSS = (*WAY_BEHIND, *CORNERS_ACROSS, *MEASURED_SO, *ACROSS)
AT_ONCE, UNREAD, OVER_ALL = (
    Turns(_OF_ALL),
    Turns(_OF_THE_UNREAD),
    Turns(
        (
            *ASSIGNED,
            *IGNORED_THERE,
            *FALLEN,
            *IN_PASSING,
            *FROM_BLOCK_TO_BLOCK,
            *EITHER_WAY,
            *OFF_ONTO,
            *WHICHEVER,
            *ON_SOME_MAT,
            *KINDS_ACROSS,
            *OWN_COLOR_ACROSS,
            *EXCEPTED_ACROSS,
            *ONE_TOPPED,
            *TOLD_OF_BOTH,
            *ONE_AND_THE_OTHER,
            *MEMBERS_TOLD,
            *CONTRASTS_ACROSS,
            *BEFORE_AND_AFTER,
            *PLACES_BY_NUMBER,
            *_LAST_ACROSS,
        )
    ),
)


def formal(tokens: list[Token]) -> list[Token]:
    """The tokens of a text, with what is said as in a specification in plainer words."""
    tokens = turned(tokens, OVER_ALL, all_of_it)
    for change in _CHANGES:
        tokens = change(tokens)
    return turned(tokens, AT_ONCE)


def _one_of_each(tokens: list[Token]) -> list[Token]:
    """ "One red, one white, one blue and one green cube": a red, a white, a blue and a green one."""
    words = [token.word for token in tokens]
    out, at = list(tokens), 0
    while at < len(words) - 1:
        ones, end = [], at
        while words[end : end + 1] == ["one"] and words[end + 1 : end + 2] and words[end + 1] in lexicon.COLOR:
            ones.append(end)
            end += 2
            while words[end : end + 1] in ([","], ["and"]):
                end += 1
        if len({words[n + 1] for n in ones}) == len(ones) > _FEW:
            for n in ones:
                out[n] = replace(tokens[n], kind="word", word="a", value=None)
        at = max(end, at + 1)
    return out


_FEW = 3
"""So many are read as they stand."""


def _steps_told(tokens: list[Token]) -> list[Token]:
    """ "Step 1: ... Step 2: ... Step 1 shall be completed before step 2.": as steps they follow each other anyway."""
    text = " ".join(token.word for token in tokens)
    done = f"\\bstep (\\d) {MUST} be (?:completed|finished|done) before step (\\d)(?: begins| starts)?(?= \\.|$)"
    told = re.search(done, text)
    if told is None or int(told[1]) >= int(told[2]) or not all(f"step {n} :" in text for n in told.groups()):
        return tokens
    begin, end = text[: told.start()].count(" "), text[: told.end()].count(" ") + 1
    return [*tokens[:begin], *tokens[end + 1 :]] if begin else tokens


_CHANGES = (
    headed_start, sums_asked, sums_on_a_patch, one_row_and_one, listed_lines, column_words, labels_counted,
    announced_rainbow, swapped_over, result_told, palindromes, one_more, all_sides, around_named, some_of_the_letters,
    row_with_ends,
    other_end_named, rows_by_number, told_by_places, _steps_told, _one_of_each, of_each_color, corners_again,
    not_at_end, of_the_figure, word_again, range_but, not_consecutive, so_many_inside, so_many_on_each,
    others_elsewhere, parts_of_each, others_counted, word_of_letters, leave_to_move, listed_of_all, row_edited,
    not_falling,
)  # fmt: skip
"""What is told otherwise before the rows are looked for, in this order."""


def plainly(tokens: list[Token]) -> list[list[Token]]:
    """The sentences that one is in plain words; none where it is as plain already."""
    plain = turned(tokens, UNREAD)
    if plain == tokens:
        return []
    out: list[list[Token]] = [[]]
    for token in plain:
        if token.kind == "punct" and token.word == ".":
            out.append([])
        else:
            out[-1].append(token)
    return [sentence for sentence in out if sentence]
