"""The task arrange-numbers, generated from its task.yaml."""

from rpg.env import BlockTask, Order, SemanticCube, Verdict


class ArrangeNumbers(BlockTask):
    """Four number blocks (7, 2, 9, 4).

    Goal: The blocks 7, 2, 9 and 4 must be in a row from left to right in ascending numerical
    order.
    Success: blocks_in_row_numerically; every block released, supported and at rest.
    """

    instruction = "Arrange the number blocks 7, 2, 9 and 4 in increasing order from left to right."
    blocks = ("7_block", "2_block", "9_block", "4_block")

    def _initialize_env(self) -> None:
        self.add(SemanticCube(name="7_block", label="7"))
        self.add(SemanticCube(name="2_block", label="2"))
        self.add(SemanticCube(name="9_block", label="9"))
        self.add(SemanticCube(name="4_block", label="4"))

    def _on_reset(self) -> None:
        self.scatter(*self.blocks)

    def _success(self) -> Verdict:
        blocks_in_row_numerically = self.row(
            self.blocks, axis="y", order=Order(by="number", first="left"), readable=True
        )
        at_rest = self.at_rest()
        _success_check = blocks_in_row_numerically & at_rest
        return _success_check
