"""The task rotate-cube, generated from its task.yaml."""

from rpg.env import BlockTask, SemanticCube, Verdict


class RotateCube(BlockTask):
    """A letter block (R).

    Goal: The R block must be upside down.
    Success: r_upside_down; every block released, supported and at rest.
    """

    instruction = "Turn the R block so that its letter is upside down."

    def _initialize_env(self) -> None:
        self.add(SemanticCube(name="R_block", label="R"))

    def _on_reset(self) -> None:
        self.scatter("R_block")

    def _success(self) -> Verdict:
        r_upside_down = self.facing("R_block", label="R", turn=180.0)
        at_rest = self.at_rest()
        _success_check = r_upside_down & at_rest
        return _success_check
