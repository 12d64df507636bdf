"""The task stack-blocks, generated from its task.yaml."""

from rpg.env import BlockTask, ColoredCube, Verdict


class StackBlocks(BlockTask):
    """A red block and a blue block.

    Goal: The red block must be on the blue block.
    Success: red_on_blue; every block released, supported and at rest.
    """

    instruction = "Put one block on top of another."

    def _initialize_env(self) -> None:
        self.add(ColoredCube(name="red_block", color="red"))
        self.add(ColoredCube(name="blue_block", color="blue"))

    def _on_reset(self) -> None:
        self.scatter("red_block", "blue_block")

    def _success(self) -> Verdict:
        red_on_blue = self.on("red_block", "blue_block")
        at_rest = self.at_rest()
        _success_check = red_on_blue & at_rest
        return _success_check
