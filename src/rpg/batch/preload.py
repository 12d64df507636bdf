"""Imported once by the process that workers are forked from: what every entry needs, without OpenGL.

What is imported, and what the first sentence makes for all others, is there for good: the garbage collector need never
look at it, nor copy, by touching them, the pages that workers share.
"""

import gc
from importlib import import_module

from rpg.batch.memory import give_back
from rpg.headless import load_mujoco

MODULES = (
    "rpg.pipeline",
    "rpg.passes.schema.frontend",
    "rpg.passes.schema.paraphrase",
    "rpg.publishing",
    "rpg.steering",
    "rpg.store.adopt",
    "rpg.upgrade",
)

gc.disable()
give_back()
load_mujoco()
for module in MODULES:
    import_module(module)
import_module("rpg.passes.schema.frontend").BuiltinFrontEnd().read("Put the red block on the blue block")
gc.enable()
gc.collect()
gc.freeze()
