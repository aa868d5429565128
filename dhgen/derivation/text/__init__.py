"""Formulas and documents as values, and how they are printed: as Markdown, and as plain text."""
