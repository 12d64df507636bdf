"""The task arrange-equation, generated from its task.yaml."""

from rpg.env import BlockTask, SemanticCube, Verdict


class ArrangeEquation(BlockTask):
    """Three number blocks (2, 3, 5) and two symbol blocks (+, =).

    Goal: The blocks 2, 3, 5, + and = must form a true equation.
    Success: equation_true; every block released, supported and at rest.
    """

    instruction = "Make a correct equation out of the blocks 2, 3, 5, + and =."
    blocks = ("2_block", "3_block", "5_block", "plus_block", "equals_block")

    def _initialize_env(self) -> None:
        self.add(SemanticCube(name="2_block", label="2"))
        self.add(SemanticCube(name="3_block", label="3"))
        self.add(SemanticCube(name="5_block", label="5"))
        self.add(SemanticCube(name="plus_block", label="+"))
        self.add(SemanticCube(name="equals_block", label="="))

    def _on_reset(self) -> None:
        self.scatter(*self.blocks)

    def _success(self) -> Verdict:
        equation_true = self.equation(self.blocks)
        at_rest = self.at_rest()
        _success_check = equation_true & at_rest
        return _success_check
