"""The task arrange-shapes, generated from its task.yaml."""

from rpg.env import BlockTask, ColoredCube, Verdict


class ArrangeShapes(BlockTask):
    """A red block, a blue block, a green block, a yellow block, a purple block, an orange block, a
    cyan block and a pink block.

    Goal: The red, blue, green, yellow, purple, orange, cyan and pink blocks must form a circle.
    Success: blocks_form_circle; every block released, supported and at rest.
    """

    instruction = "Place eight blocks in a circle."
    blocks = (
        "red_block",
        "blue_block",
        "green_block",
        "yellow_block",
        "purple_block",
        "orange_block",
        "cyan_block",
        "pink_block",
    )

    def _initialize_env(self) -> None:
        self.add(ColoredCube(name="red_block", color="red"))
        self.add(ColoredCube(name="blue_block", color="blue"))
        self.add(ColoredCube(name="green_block", color="green"))
        self.add(ColoredCube(name="yellow_block", color="yellow"))
        self.add(ColoredCube(name="purple_block", color="purple"))
        self.add(ColoredCube(name="orange_block", color="orange"))
        self.add(ColoredCube(name="cyan_block", color="cyan"))
        self.add(ColoredCube(name="pink_block", color="pink"))

    def _on_reset(self) -> None:
        self.scatter(*self.blocks)

    def _success(self) -> Verdict:
        blocks_form_circle = self.figure(self.blocks, shape="circle")
        at_rest = self.at_rest()
        _success_check = blocks_form_circle & at_rest
        return _success_check
