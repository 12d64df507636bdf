"""The task stack-blocks-on-target, generated from its task.yaml."""

from rpg.env import BlockTask, ColoredCube, GoalPatch, Verdict


class StackBlocksOnTarget(BlockTask):
    """A red block, a blue block, a green block and a gray patch.

    Goal: The red, blue and green blocks must form a tower of exactly three on the gray patch.
    Success: blocks_stacked_on_gray_patch; every block released, supported and at rest.
    """

    instruction = "Build a tower of three blocks on the square patch."

    def _initialize_env(self) -> None:
        self.add(ColoredCube(name="red_block", color="red"))
        self.add(ColoredCube(name="blue_block", color="blue"))
        self.add(ColoredCube(name="green_block", color="green"))
        self.add(GoalPatch(name="gray_patch", color="gray", position=(0.55, 0.0)))

    def _on_reset(self) -> None:
        self.scatter("red_block", "blue_block", "green_block")

    def _success(self) -> Verdict:
        blocks_stacked_on_gray_patch = self.stack(
            ["red_block", "blue_block", "green_block"], exact=True, patch="gray_patch"
        )
        at_rest = self.at_rest()
        _success_check = blocks_stacked_on_gray_patch & at_rest
        return _success_check
