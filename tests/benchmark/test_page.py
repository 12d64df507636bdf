"""The page of pictures in a browser: judging, and the export that rpg bench --verdicts reads. Needs Chromium."""

from __future__ import annotations

import html
import json
import re
import shutil
import subprocess
from pathlib import Path

import pytest

from rpg.benchmark.agreement import agreement, read_ratings
from rpg.benchmark.measure import Turn
from rpg.benchmark.page import page

BROWSER = shutil.which("chromium") or shutil.which("chromium-browser") or shutil.which("google-chrome")
CLICKS = """
<script>
  URL.createObjectURL = (blob) => {
    const shown = (textContent) => Object.assign(document.createElement("output"), { textContent });
    blob.text().then((text) => document.body.append(shown(text)));
    return "#";
  };
  const press = (key, value) => document.querySelector(`[data-key="${key}"][data-value="${value}"]`).click();
  rater.value = "@RATER@";
  rater.onchange();
  @CLICKS@
  document.getElementById("export").click();
</script>
"""


def judged(root: Path, rater: str, clicks: str) -> str:
    """The page's DOM after `clicks` and an export by `rater`."""
    turns = [
        Turn(case="a", number=number, words=f"Task <{number}>", directory=str(root), task_success=True)
        for number in range(3)
    ]
    file = root / f"{rater}.html"
    script = CLICKS.replace("@CLICKS@", clicks).replace("@RATER@", rater)
    file.write_text(page(turns).replace("</html>", script + "</html>"))
    command = [str(BROWSER), "--headless", "--no-sandbox", "--disable-gpu", f"--user-data-dir={root / 'profile'}"]
    done = subprocess.run(
        [*command, "--virtual-time-budget=2000", "--dump-dom", file.as_uri()],
        capture_output=True,
        text=True,
        timeout=60,
        check=False,
    )
    return done.stdout


@pytest.mark.skipif(BROWSER is None, reason="Chromium is not installed")
def test_verdicts_are_exported_and_compared(tmp_path: Path) -> None:
    clicks = {
        "Ann": 'press("a/0", true); press("a/1", true); press("a/1", false); press("a/2", true);',
        "Bob": 'press("a/0", true); press("a/1", true); press("a/2", true);',
    }
    exports = []
    for rater, presses in clicks.items():
        dom = judged(tmp_path, rater, presses)
        assert "3 of 3 judged" in dom and "Task &lt;0&gt;" in dom
        found = re.search(r"<output>(.*?)</output>", dom, re.DOTALL)
        assert found is not None
        exports.append(tmp_path / f"{rater}.json")
        exports[-1].write_text(html.unescape(found[1]))
    assert json.loads(exports[0].read_text()) == {"rater": "Ann", "verdicts": {"a/0": True, "a/1": False, "a/2": True}}
    assert "3 of 3 judged" in judged(tmp_path, "Ann", "")
    assert "0 of 3 judged" in judged(tmp_path, "Cleo", "")
    result = agreement(read_ratings(exports))
    assert (result.raters, result.tasks) == (2, 3)
    assert result.unanimous == pytest.approx(200 / 3)
