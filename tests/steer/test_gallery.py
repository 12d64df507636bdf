"""The gallery: what is on the page, that it loads nothing, and that it works in a browser."""

from __future__ import annotations

import re
import shutil
import subprocess
from pathlib import Path

import pytest

from rpg.gallery import gallery_page
from rpg.pipeline import CompileOptions
from rpg.sessions import Session, run_session
from rpg.store import Workspace

BROWSER = shutil.which("chromium") or shutil.which("chromium-browser") or shutil.which("google-chrome")
QUIET = (
    "--headless",
    "--no-sandbox",
    "--disable-gpu",
    "--disable-quic",
    "--no-first-run",
    "--disable-background-networking",
    "--disable-component-update",
    "--disable-sync",
    "--virtual-time-budget=3000",
    "--window-size=1200,1400",
)


@pytest.fixture(scope="module")
def workspace(tmp_path_factory: pytest.TempPathFactory) -> Workspace:
    place = Workspace(tmp_path_factory.mktemp("gallery"))
    edits = (
        "add a green block on top",
        "go back to version 0 and add a yellow block on top",
        "undo",
        "reverse the order",
    )
    sessions = (
        Session("tower", "put the blue block on the red block", edits),
        Session("row", "make a row of three pink blocks"),
    )
    for session in sessions:
        assert list(run_session(session, place, CompileOptions(pictures=True), keep_going=True))
    return place


@pytest.fixture(scope="module")
def page(workspace: Workspace) -> Path:
    text, problems = gallery_page(workspace)
    assert not problems
    path = workspace.root / "gallery.html"
    path.write_text(text, encoding="utf-8")
    return path


def test_every_version_has_its_card_and_the_family_its_graph(page: Path, workspace: Workspace) -> None:
    text = page.read_text(encoding="utf-8")
    for family in workspace.families():
        for version in family.versions():
            assert f'id="{family.name}-{version.number}"' in text
    assert text.count('<svg class="lineage"') == 1
    assert "add a green block on top" in text
    assert "preserved: assets, positions, goals" in text
    assert text.count("data:image/jpeg;base64,") == 2 * sum(len(f.versions()) for f in workspace.families())


def test_nothing_is_loaded_from_outside(page: Path) -> None:
    text = page.read_text(encoding="utf-8")
    assert not re.findall(r"(?:src|href|url)\s*[=(]\s*[\"']?(?!data:|#)[^\"'\s)>]+", text)
    assert "http:" not in text and "https:" not in text
    assert "default-src 'none'" in text


def test_the_same_workspace_gives_the_same_page(page: Path, workspace: Workspace) -> None:
    assert gallery_page(workspace)[0] == page.read_text(encoding="utf-8")


def browse(page: Path, profile: Path, *options: str, query: str = "") -> str:
    command = [str(BROWSER), *QUIET, f"--user-data-dir={profile}", *options, page.as_uri() + query]
    return subprocess.run(command, capture_output=True, text=True, timeout=120, check=True).stdout


@pytest.mark.skipif(BROWSER is None, reason="no Chromium on this machine")
def test_a_browser_finds_what_is_looked_for(page: Path, tmp_path: Path) -> None:
    everything = browse(page, tmp_path / "a", "--dump-dom")
    assert "of 5 versions, 2 families" in everything
    found = browse(page, tmp_path / "b", "--dump-dom", query="#q=pink")
    assert "1 of 5 versions, 1 family" in found
    hidden = re.findall(r'<article class="card" id="([^"]+)"[^>]*hidden', found)
    assert sorted(hidden) == ["tower-0", "tower-1", "tower-2", "tower-3"]
    nothing = browse(page, tmp_path / "c", "--dump-dom", query="#q=elephant")
    assert "0 of 5 versions" in nothing and 'id="nothing" hidden' not in nothing


@pytest.mark.skipif(BROWSER is None, reason="no Chromium on this machine")
@pytest.mark.parametrize("scheme", ["0", "1"])
def test_a_browser_draws_it_light_and_dark(page: Path, tmp_path: Path, scheme: str) -> None:
    from PIL import Image

    picture = tmp_path / "page.png"
    browse(page, tmp_path / "p", f"--screenshot={picture}", f"--blink-settings=preferredColorScheme={scheme}")
    with Image.open(picture) as image:
        corner = image.convert("L").getpixel((5, 5))
        colors = image.convert("RGB").resize((120, 140)).getcolors(20000)
    assert isinstance(corner, int) and (corner < 80) == (scheme == "0")
    assert colors is not None and len(colors) > 300
