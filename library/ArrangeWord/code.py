"""The task arrange-word, generated from its task.yaml."""

from rpg.env import BlockTask, SemanticCube, Verdict


class ArrangeWord(BlockTask):
    """Five letter blocks (R, O, B, O, T).

    Goal: The R block, the two blocks labelled 'O', the B block and the T block must spell the
    word ROBOT.
    Success: robot_spelled; every block released, supported and at rest.
    """

    instruction = "Spell the word ROBOT with letter blocks."
    blocks = ("R_block", "O_block_1", "B_block", "O_block_2", "T_block")

    def _initialize_env(self) -> None:
        self.add(SemanticCube(name="R_block", label="R"))
        self.add(SemanticCube(name="O_block_1", label="O"))
        self.add(SemanticCube(name="B_block", label="B"))
        self.add(SemanticCube(name="O_block_2", label="O"))
        self.add(SemanticCube(name="T_block", label="T"))

    def _on_reset(self) -> None:
        self.scatter(*self.blocks)

    def _success(self) -> Verdict:
        robot_spelled = self.spells(self.blocks, "ROBOT")
        at_rest = self.at_rest()
        _success_check = robot_spelled & at_rest
        return _success_check
