"""Pass 3: nine gates from cheap to costly, with measured figures."""

from rpg.passes.validate.bench import Measures
from rpg.passes.validate.log import read_log, render_log
from rpg.passes.validate.runner import admitted, validate

__all__ = ["Measures", "admitted", "read_log", "render_log", "validate"]
