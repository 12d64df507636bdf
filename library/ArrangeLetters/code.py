"""The task arrange-letters, generated from its task.yaml."""

from rpg.env import BlockTask, Order, SemanticCube, Verdict


class ArrangeLetters(BlockTask):
    """Five letter blocks (A, B, C, D, E).

    Goal: The blocks A to E must be in a row from left to right in alphabetical order.
    Success: letters_in_row_alphabetically; every block released, supported and at rest.
    """

    instruction = (
        "Arrange the letter blocks A, B, C, D and E in alphabetical order from left to right."
    )
    blocks = ("A_block", "B_block", "C_block", "D_block", "E_block")

    def _initialize_env(self) -> None:
        self.add(SemanticCube(name="A_block", label="A"))
        self.add(SemanticCube(name="B_block", label="B"))
        self.add(SemanticCube(name="C_block", label="C"))
        self.add(SemanticCube(name="D_block", label="D"))
        self.add(SemanticCube(name="E_block", label="E"))

    def _on_reset(self) -> None:
        self.scatter(*self.blocks)

    def _success(self) -> Verdict:
        letters_in_row_alphabetically = self.row(
            self.blocks, axis="y", order=Order(by="label", first="left"), readable=True
        )
        at_rest = self.at_rest()
        _success_check = letters_in_row_alphabetically & at_rest
        return _success_check
