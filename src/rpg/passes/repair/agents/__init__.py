"""The repair agents, one a file, by the class of failure that each mends."""

from rpg.ir.artifact import FailureClass
from rpg.passes.repair.agents.api import APIUsageFixAgent
from rpg.passes.repair.agents.bounds import GeometricBoundsFixAgent
from rpg.passes.repair.agents.constraint import ConstraintFixAgent
from rpg.passes.repair.agents.runtime import RuntimeFixAgent
from rpg.passes.repair.agents.stability import StructureStabilityFixAgent
from rpg.passes.repair.agents.success import SuccessCheckFixAgent
from rpg.passes.repair.agents.syntax import SyntaxFixAgent
from rpg.passes.repair.record import Agent

_ALL: tuple[Agent, ...] = (
    SyntaxFixAgent(),
    APIUsageFixAgent(),
    RuntimeFixAgent(),
    SuccessCheckFixAgent(),
    StructureStabilityFixAgent(),
    GeometricBoundsFixAgent(),
    ConstraintFixAgent(),
)
AGENTS: dict[FailureClass, Agent] = {agent.handles: agent for agent in _ALL}
__all__ = ["AGENTS"]
