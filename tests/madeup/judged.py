"""What a made-up sentence is read as."""

from __future__ import annotations

from tests.corpus.entries import entry
from tests.corpus.judge import Score, judge
from tests.corpus.run import read
from tests.madeup.scenes import MadeUp


def judged(sentence: MadeUp) -> Score:
    """Whether it is read right, refused or read wrong."""
    return judge(entry("madeup", "madeup", sentence.text, sentence.meant()), read)
