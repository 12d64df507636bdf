"""Compiler bones: source text and spans, diagnostics, passes, digests."""
