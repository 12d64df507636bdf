"""The task align-blocks, generated from its task.yaml."""

from rpg.env import BlockTask, ColoredCube, Verdict


class AlignBlocks(BlockTask):
    """A red block, a blue block, a green block, a yellow block and a purple block.

    Goal: The red, blue, green, yellow and purple blocks must be in a row.
    Success: blocks_in_row; every block released, supported and at rest.
    """

    instruction = "Line up five blocks in a straight row from left to right."
    blocks = ("red_block", "blue_block", "green_block", "yellow_block", "purple_block")

    def _initialize_env(self) -> None:
        self.add(ColoredCube(name="red_block", color="red"))
        self.add(ColoredCube(name="blue_block", color="blue"))
        self.add(ColoredCube(name="green_block", color="green"))
        self.add(ColoredCube(name="yellow_block", color="yellow"))
        self.add(ColoredCube(name="purple_block", color="purple"))

    def _on_reset(self) -> None:
        self.scatter(*self.blocks)

    def _success(self) -> Verdict:
        blocks_in_row = self.row(self.blocks, axis="y")
        at_rest = self.at_rest()
        _success_check = blocks_in_row & at_rest
        return _success_check
