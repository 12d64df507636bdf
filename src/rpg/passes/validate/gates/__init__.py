"""The gates, one a file, in the order in which they run: cheap before costly, each on what others left."""

from rpg.passes.validate.bench import Gate
from rpg.passes.validate.gates.bounds import BoundsGate
from rpg.passes.validate.gates.compile import CompileGate
from rpg.passes.validate.gates.constraint import ConstraintGate
from rpg.passes.validate.gates.determinism import DeterminismGate
from rpg.passes.validate.gates.goal_state import GoalStateGate
from rpg.passes.validate.gates.mutation import MutationGate
from rpg.passes.validate.gates.smoke import SmokeGate
from rpg.passes.validate.gates.text import TextGate
from rpg.passes.validate.gates.unsolved import UnsolvedGate

GATES: tuple[Gate, ...] = (
    TextGate(),
    CompileGate(),
    SmokeGate(),
    ConstraintGate(),
    GoalStateGate(),
    BoundsGate(),
    UnsolvedGate(),
    MutationGate(),
    DeterminismGate(),
)
__all__ = ["GATES"]
