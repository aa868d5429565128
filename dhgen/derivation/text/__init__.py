"""Formulas and documents as values, and how they are printed: as Markdown, and as plain text.

Read `formula` and `blocks`, the values; `walk`, which looks into formulas; `template`, blocks from
Markdown with places; `words`. Then the printing: `style` and `show` for the parts of a formula,
`lines` for long ones, `inline` for prose; `markdown`, `plain`, `html` and `latex`, with
`latex_text`, for documents.
"""
