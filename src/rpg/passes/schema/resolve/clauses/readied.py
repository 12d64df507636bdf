"""What is made of the sentences before anything is looked for in them: each in plainer words of its own."""

from __future__ import annotations

from rpg.language.meaning import Chain
from rpg.passes.schema.resolve.clauses.at_the_end import there_before
from rpg.passes.schema.resolve.clauses.borne_there import borne_there
from rpg.passes.schema.resolve.clauses.faced_too import faced_too
from rpg.passes.schema.resolve.clauses.moved_alone import named_for_it
from rpg.passes.schema.resolve.clauses.none_told import none_told
from rpg.passes.schema.resolve.clauses.one_tense import in_one_tense
from rpg.passes.schema.resolve.clauses.rebuilt_of import rebuilt_of
from rpg.passes.schema.resolve.clauses.sorted_as_told import sorted_as_told
from rpg.passes.schema.resolve.clauses.taken_off import taken_off
from rpg.passes.schema.resolve.clauses.told_behind import told_behind
from rpg.passes.schema.resolve.orders.into_an_order import into_an_order
from rpg.passes.schema.resolve.orders.left_of_two import left_of_two
from rpg.passes.schema.resolve.places.both_of_a_stack import both_of_a_stack
from rpg.passes.schema.resolve.places.middle_of_ring import middle_of_ring
from rpg.passes.schema.resolve.places.no_gap import no_gap
from rpg.passes.schema.resolve.places.patch_in_common import patch_in_common
from rpg.passes.schema.resolve.places.shared_gaps import shared_gaps
from rpg.passes.schema.resolve.places.shared_sides import shared_sides
from rpg.passes.schema.resolve.structures.checkered_grid import checkered_grid
from rpg.passes.schema.resolve.structures.each_beside import each_beside
from rpg.passes.schema.resolve.structures.each_lot import each_lot
from rpg.passes.schema.resolve.structures.either_shape import either_shape
from rpg.passes.schema.resolve.structures.groups_listed import groups_listed
from rpg.passes.schema.resolve.structures.last_of_list import check_last
from rpg.passes.schema.resolve.structures.shared_between import shared_between
from rpg.passes.schema.resolve.structures.told_of_each import told_of_each
from rpg.passes.schema.resolve.things.members_later import members_later
from rpg.passes.schema.resolve.things.named_extras import named_extras
from rpg.passes.schema.resolve.things.one_in_each import one_in_each
from rpg.passes.schema.resolve.things.recounted import recounted
from rpg.passes.schema.resolve.things.tally_filled import tally_filled
from rpg.passes.schema.resolve.things.whichever import whichever


def readied(chains: tuple[Chain, ...], text: str) -> tuple[Chain, ...]:
    """The sentences with what one part of them tells of another put there."""
    for together in (
        check_last, shared_between, rebuilt_of,
        members_later, tally_filled, sorted_as_told, middle_of_ring, no_gap, both_of_a_stack, left_of_two, none_told,
        groups_listed, named_for_it,
    ):  # fmt: skip
        chains = together(chains)
    chains = tuple(borne_there(faced_too(told_of_each(chain, text), text), text) for chain in chains)
    for each in (named_extras, each_beside, each_lot, checkered_grid, one_in_each, either_shape):
        chains = tuple(map(each, chains))
    told = (shared_gaps(shared_sides(recounted(chain), text), text) for chain in chains)
    plain = (into_an_order(patch_in_common(taken_off(chain), text), text) for chain in told)
    chains = in_one_tense(tuple(whichever(chain, text) for chain in plain), text)
    return told_behind(there_before(chains, text), text)
