"""What a goal takes for granted, beside what is said of it."""

from __future__ import annotations

from rpg.ir import goal as g
from rpg.ir.walk import transform
from rpg.passes.schema.resolve.clauses.kept import brought_about
from rpg.passes.schema.resolve.goals.denied_lines import none_of_a_tower
from rpg.passes.schema.resolve.goals.inserted import into_their_tower
from rpg.passes.schema.resolve.goals.lasting import beside_what_is_done
from rpg.passes.schema.resolve.goals.left_out_of_line import none_left_out_in_line
from rpg.passes.schema.resolve.goals.order_left_free import order_left_free
from rpg.passes.schema.resolve.goals.standing import none_left_out_on_top, still_standing
from rpg.passes.schema.resolve.goals.two_ways import two_ways
from rpg.passes.schema.resolve.orders.as_listed import both_as_listed
from rpg.passes.schema.resolve.orders.letter_by_letter import letters_in_place
from rpg.passes.schema.resolve.orders.order_kept import with_order_kept
from rpg.passes.schema.resolve.places.bare_table import besides_their_patches, off_is_elsewhere, off_their_patches
from rpg.passes.schema.resolve.structures.rows_apart import no_two_in_one_line
from rpg.passes.schema.resolve.structures.towers_apart import one_by_one
from rpg.passes.schema.resolve.things.premises import keep_premises
from rpg.passes.schema.resolve.things.world import Scene


def with_what_is_meant(goal: g.Goal, scene: Scene) -> g.Goal:
    """`goal` with the premises of its words: what landmarks are, what is left alone, towers that still stand,
    and what lasts beside what is done."""
    goal = both_as_listed(with_order_kept(order_left_free(letters_in_place(goal, scene), scene), scene), scene)
    goal = transform(one_by_one(none_of_a_tower(goal), scene), besides_their_patches)
    goal = off_is_elsewhere(goal)
    goal = brought_about(off_their_patches(keep_premises(goal, scene), scene), scene)
    goal = into_their_tower(beside_what_is_done(goal, scene), scene)
    goal = no_two_in_one_line(still_standing(two_ways(goal), scene))
    return none_left_out_in_line(none_left_out_on_top(goal, scene.left_out), scene)
