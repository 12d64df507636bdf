"""Tasks on disk: families, versions, their snapshots and lineage, and whether they can be trusted."""

from rpg.store.disk import replace_file
from rpg.store.layout import DEFAULT_WORKSPACE, Family, Version, Workspace
from rpg.store.records import Snapshot, SteeringMeta, TaskSnapshot
from rpg.store.resolve import resolve, resolve_family
from rpg.store.taskfile import dump_schema, parse_schema, read_schema
from rpg.store.verify import verify_family, verify_lineage, verify_version
from rpg.store.write import Content, Written, set_head, write_base, write_rejected, write_version

__all__ = [
    "DEFAULT_WORKSPACE",
    "Content",
    "Family",
    "Snapshot",
    "SteeringMeta",
    "TaskSnapshot",
    "Version",
    "Workspace",
    "Written",
    "dump_schema",
    "parse_schema",
    "read_schema",
    "replace_file",
    "resolve",
    "resolve_family",
    "set_head",
    "verify_family",
    "verify_lineage",
    "verify_version",
    "write_base",
    "write_rejected",
    "write_version",
]
