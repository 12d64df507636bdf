"""The task stack-blocks, generated from its task.yaml."""

from rpg.env import BlockTask, ColoredCube, Verdict


class StackBlocks(BlockTask):
    """Two red blocks.

    Goal: A red block must be on the other red block.
    Success: red_1_on_red_2; every block released, supported and at rest.
    """

    instruction = "Put one block on top of another."
    interchangeable = ((("red_block_1",), ("red_block_2",)),)

    def _initialize_env(self) -> None:
        self.add(ColoredCube(name="red_block_1", color="red"))
        self.add(ColoredCube(name="red_block_2", color="red"))

    def _on_reset(self) -> None:
        self.scatter("red_block_1", "red_block_2")

    def _success(self) -> Verdict:
        red_1_on_red_2 = self.on("red_block_1", "red_block_2")
        at_rest = self.at_rest()
        _success_check = red_1_on_red_2 & at_rest
        return _success_check
