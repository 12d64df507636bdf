"""The task sequential-place-on-target, generated from its task.yaml."""

from rpg.env import BlockTask, ColoredCube, GoalPatch, Verdict


class SequentialPlaceOnTarget(BlockTask):
    """A blue block, a blue patch, a red block and a red patch.

    Goal: First, the blue block must be on the blue patch. Then, the red block must be on the red
    patch.
    Success: in_order; every block released, supported and at rest.
    """

    instruction = (
        "First put the blue block on the blue patch, then put the red block on the red patch."
    )

    def _initialize_env(self) -> None:
        self.add(ColoredCube(name="blue_block", color="blue"))
        self.add(GoalPatch(name="blue_patch", color="blue", position=(0.55, 0.1)))
        self.add(ColoredCube(name="red_block", color="red"))
        self.add(GoalPatch(name="red_patch", color="red", position=(0.55, -0.1)))

    def _on_reset(self) -> None:
        self.scatter("blue_block", "red_block")

    def _success(self) -> Verdict:
        blue_on_blue_patch = self.on_patch("blue_block", "blue_patch")
        red_on_red_patch = self.on_patch("red_block", "red_patch")
        in_order = self.in_order(blue_on_blue_patch, red_on_red_patch)
        at_rest = self.at_rest()
        _success_check = in_order & at_rest
        return _success_check

    def _fail(self) -> Verdict:
        _fail_check = self.out_of_order()
        return _fail_check
