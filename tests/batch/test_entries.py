"""Lists in files: what they mean, and what is said of broken ones."""

from __future__ import annotations

import io
from pathlib import Path

import pytest

from rpg.batch.entries import Entry, read_entries, shard
from rpg.core.diagnostics import UsageError


def read(tmp_path: Path, name: str, text: str) -> tuple[Entry, ...]:
    path = tmp_path / name
    path.write_text(text, encoding="utf-8")
    return read_entries([str(path)])


def test_plain_text_has_an_instruction_per_line(tmp_path: Path) -> None:
    entries = read(tmp_path, "list.txt", "# ours\nStack two blocks\n\n  Make a row of three red blocks  \n")
    assert [(e.instruction, e.place.rsplit(":")[-1]) for e in entries] == [
        ("Stack two blocks", "2"),
        ("Make a row of three red blocks", "4"),
    ]


def test_yaml_takes_sentences_tasks_and_sessions(tmp_path: Path) -> None:
    listed = read(tmp_path, "a.yaml", "- Stack two blocks\n- {instruction: Make a row, seed: 3, author: Ada}\n")
    assert listed[0].instruction == "Stack two blocks"
    assert (listed[1].seed, listed[1].author) == (3, "Ada")
    text = "tasks:\n- {name: StackTwo, instruction: Stack two blocks}\nsessions:\n- {base: b, edits: [c, d]}\n"
    task, session = read(tmp_path, "b.yml", text)
    assert task.name == "stack-two"
    assert (session.instruction, session.edits, session.place.rsplit(":")[-1]) == ("b", ("c", "d"), "4")


def test_json_lines(tmp_path: Path) -> None:
    entries = read(
        tmp_path, "a.jsonl", '{"instruction": "Stack two blocks", "seed": 1}\n{"base": "x", "edits": ["y"]}\n'
    )
    assert [e.seed for e in entries] == [1, 0]
    assert entries[1].edits == ("y",)


@pytest.mark.parametrize(
    "text",
    [
        '{"instruction": "Stack two blocks"}\n',
        "Stack two blocks\n",
        "- Stack two blocks\n",
        "- {instruction: Stack two blocks}\n",
        "[Stack two blocks]\n",
    ],
)
def test_stdin_is_told_by_its_first_line(text: str, monkeypatch: pytest.MonkeyPatch) -> None:
    class Stdin:
        buffer = io.BytesIO(text.encode())

    monkeypatch.setattr("sys.stdin", Stdin())
    assert read_entries(["-"]) == (Entry("stdin:1", "Stack two blocks"),)


def test_globs_are_expanded_in_order(tmp_path: Path) -> None:
    for name in ("b.txt", "a.txt"):
        (tmp_path / name).write_text(f"from {name}\n")
    assert [e.instruction for e in read_entries([str(tmp_path / "*.txt")])] == ["from a.txt", "from b.txt"]


@pytest.mark.parametrize(
    ("name", "text", "said"),
    [
        ("a.yaml", "- instruction: x\n  seeed: 3\n", "a.yaml:1: an entry has no `seeed`"),
        ("a.yaml", "- a\n- {edits: [b]}\n", "a.yaml:2: an entry has"),
        ("a.yaml", "tasks: [x\n", "a.yaml:2"),
        ("a.yaml", "taks:\n- x\n", "a.yaml:1: `taks` is no list"),
        ("a.yaml", "- {name: Up, instruction: x}\n- {name: up, instruction: y}\n", "a.yaml:2: the name 'up' is taken"),
        ("a.yaml", "- {name: '!!', instruction: x}\n", "a.yaml:1: name"),
        ("a.yaml", "just words\n", "a.yaml:1: a list of entries"),
        ("a.jsonl", '{"instruction": "x"}\n{oops\n', "a.jsonl:2: not JSON"),
        ("a.jsonl", "[1]\n", "a.jsonl:1"),
        ("a.yaml", "- instruction: x\n  seed: 1\n  instruction: y\n", "a.yaml:3: `instruction` is there twice"),
        ("a.yaml", "- [x, y]\n", "a.yaml:1: an entry is a sentence"),
        ("a.txt", "", "no instruction in"),
        ("a.txt", "# nothing yet\n\n", "no instruction in"),
        ("a.yaml", "tasks: []\n", "no instruction in"),
        ("a.jsonl", "\n", "no instruction in"),
    ],
)
def test_what_is_wrong_is_said_with_its_line(tmp_path: Path, name: str, text: str, said: str) -> None:
    with pytest.raises(UsageError) as caught:
        read(tmp_path, name, text)
    assert said in str(caught.value)


def test_what_is_no_text_is_said_with_its_line(tmp_path: Path) -> None:
    (tmp_path / "a.txt").write_bytes(b"Stack two blocks\n\xff\n")
    with pytest.raises(UsageError, match=r"a\.txt:2: not UTF-8"):
        read_entries([str(tmp_path / "a.txt")])


def test_an_empty_list_beside_others_is_no_error(tmp_path: Path) -> None:
    (tmp_path / "a.txt").write_text("# none yet\n")
    (tmp_path / "b.txt").write_text("Stack two blocks\n")
    assert len(read_entries([str(tmp_path / "*.txt")])) == 1


def test_lines_are_counted_as_editors_count_them(tmp_path: Path) -> None:
    (tmp_path / "a.txt").write_bytes("Stack two\x0cblocks\r\nMake a row\u2028of blocks\n".encode())
    assert [entry.place.rsplit(":")[-1] for entry in read_entries([str(tmp_path / "a.txt")])] == ["1", "2"]


def test_missing_files_are_named(tmp_path: Path) -> None:
    with pytest.raises(UsageError, match=r"cannot read .*none\.txt"):
        read_entries([str(tmp_path / "none.txt")])
    with pytest.raises(UsageError, match="no file matches"):
        read_entries([str(tmp_path / "*.none")])


def test_shards_partition_the_entries() -> None:
    entries = tuple(Entry(f"x:{i}", str(i)) for i in range(10))
    parts = [shard(entries, f"{i}/3") for i in (1, 2, 3)]
    assert sorted(e.instruction for part in parts for e in part) == sorted(e.instruction for e in entries)
    for wrong in ("0/3", "4/3", "1", "a/b"):
        with pytest.raises(UsageError):
            shard(entries, wrong)


def test_a_digest_changes_with_what_the_result_depends_on() -> None:
    base = Entry("x:1", "Stack two blocks")
    assert base.digest == Entry("y:7", "Stack two blocks").digest
    others = [
        Entry("x:1", "Stack three blocks"),
        Entry("x:1", "Stack two blocks", edits=("undo",)),
        Entry("x:1", "Stack two blocks", seed=1),
        Entry("x:1", "Stack two blocks", name="a"),
    ]
    assert len({base.digest, *(other.digest for other in others)}) == 5
