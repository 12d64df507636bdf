"""Small tasks written by hand, as generated code would have them."""

from __future__ import annotations

from rpg.env import Apart, BlockTask, ColoredCube, GoalPatch, Order, SemanticCube, Stack, Verdict


class RedOnYellow(BlockTask):
    """The red block is to be on the yellow one."""

    instruction = "put the red block on the yellow block"

    def _initialize_env(self) -> None:
        self.add(ColoredCube(name="red_block", color="red"))
        self.add(ColoredCube(name="yellow_block", color="yellow"))

    def _on_reset(self) -> None:
        self.scatter("red_block", "yellow_block")

    def _success(self) -> Verdict:
        red_on_yellow = self.on("red_block", "yellow_block")
        at_rest = self.at_rest()
        _success_check = red_on_yellow & at_rest
        return _success_check


class AlikeOnBlue(BlockTask):
    """Either red block is to be on the blue one, the other one behind it."""

    instruction = "put a red block on the blue block and the other red block behind it"
    interchangeable = ((("red_block_1",), ("red_block_2",)),)

    def _initialize_env(self) -> None:
        self.add(ColoredCube(name="red_block_1", color="red"))
        self.add(ColoredCube(name="red_block_2", color="red"))
        self.add(ColoredCube(name="blue_block", color="blue"))

    def _success(self) -> Verdict:
        on_blue = self.on("red_block_1", "blue_block")
        behind = self.behind("red_block_2", "blue_block")
        return on_blue & behind & self.at_rest()


class Farther(BlockTask):
    """Two blocks that are apart all the time are to be farther apart, as nearly all are that are drawn so."""

    instruction = "keep the red block 10 cm away from the blue block; in the end it is 15 cm away from it"

    def _initialize_env(self) -> None:
        self.add(ColoredCube(name="red_block", color="red"))
        self.add(ColoredCube(name="blue_block", color="blue"))

    def _on_reset(self) -> None:
        self.arrange(Apart(a=("red_block",), b=("blue_block",)))

    def _success(self) -> Verdict:
        apart = self.always(self.apart("red_block", "blue_block"))
        farther = self.distance("red_block", "blue_block", minimum=0.15)
        return apart & farther & self.at_rest()

    def _fail(self) -> Verdict:
        return self.lapsed()


class PatchThenStack(BlockTask):
    """First the red block goes to the patch, then the blue one on it; the green one never leaves its place."""

    instruction = "first the red block goes on the patch, then the blue block on the red block; leave the green block"

    def _initialize_env(self) -> None:
        for color in ("red", "blue", "green"):
            self.add(ColoredCube(name=f"{color}_block", color=color))
        self.add(GoalPatch(name="patch", color="yellow", position=(0.6, 0.1)))

    def _success(self) -> Verdict:
        red_on_patch = self.on_patch("red_block", "patch")
        blue_on_red = self.on("blue_block", "red_block")
        in_order = self.in_order(red_on_patch, blue_on_red)
        green_stayed = self.always(self.stayed("green_block"))
        return in_order & green_stayed & self.at_rest()

    def _fail(self) -> Verdict:
        return self.out_of_order() | self.lapsed()


class Restack(BlockTask):
    """A red block on a blue one comes off and goes back."""

    instruction = "unstack the blocks, then stack the red block on the blue block again"

    def _initialize_env(self) -> None:
        self.add(ColoredCube(name="red_block", color="red"))
        self.add(ColoredCube(name="blue_block", color="blue"))

    def _on_reset(self) -> None:
        self.arrange(
            Stack(blocks=("blue_block", "red_block"), order=Order(by="given", ranks=("blue_block", "red_block")))
        )

    def _success(self) -> Verdict:
        unstacked = self.on_table(["red_block", "blue_block"])
        stacked = self.on("red_block", "blue_block")
        return self.in_order(unstacked, stacked, undone=(0,)) & self.at_rest()

    def _fail(self) -> Verdict:
        return self.out_of_order()


class Heaped(BlockTask):
    """Letter cubes in a heap."""

    instruction = "take the letters out of the heap"

    def _initialize_env(self) -> None:
        for letter in "ABCD":
            self.add(SemanticCube(name=f"{letter}_block", label=letter))
        self.add(ColoredCube(name="red_block", color="red"))

    def _on_reset(self) -> None:
        self.heap("A_block", "B_block", "C_block", "D_block")
        self.scatter("red_block")

    def _success(self) -> Verdict:
        return self.on_table(["A_block", "B_block", "C_block", "D_block"]) & self.at_rest()


class AlreadyDone(RedOnYellow):
    """Nothing is left to do."""

    def _success(self) -> Verdict:
        return self.on_table("red_block") & self.at_rest()
