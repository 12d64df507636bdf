"""One self-contained HTML page of a workspace: cards with pictures and checks, and lineage graphs."""

from rpg.gallery.page import gallery_page

__all__ = ["gallery_page"]
