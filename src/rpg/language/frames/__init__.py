"""A second reader: what is said of one figure is gathered part by part, in whatever order and syntax it is said.

The grammar reads sentences. Where it finds none, a text that tells of one row, tower or other figure is cut into the
parts that such a thing has (`pieces`): lots of blocks, measures, places of some of them, a direction, an order. Each
family of figures (`tower`, `row`, ...) knows the words of its parts. When every word belongs to a part or only binds
parts together, and no part is told twice, the family tells the figure again in plain sentences, which the grammar
reads and everything behind it checks.
"""

from rpg.language.frames.retelling import retold, words

__all__ = ["retold", "words"]
