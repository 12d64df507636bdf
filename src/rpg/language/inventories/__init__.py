"""Inventories told first, in whole sentences: "five blocks lie on the table, three of them red and two green"."""

from rpg.language.inventories.ahead import stocks_ahead
from rpg.language.inventories.plain import Told, told_behind, told_plainly

__all__ = ["Told", "stocks_ahead", "told_behind", "told_plainly"]
