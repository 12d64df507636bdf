"""Tasks on disk: families, versions, their snapshots and lineage, and whether they can be trusted."""
