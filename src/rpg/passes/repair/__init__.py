"""Pass 4: failures mended by agents, one per class, in a bounded loop."""

from rpg.passes.repair.orchestrator import Repaired, repair
from rpg.passes.repair.record import Attempt, Tools

__all__ = ["Attempt", "Repaired", "Tools", "repair"]
