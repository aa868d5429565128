"""The derivation in French.

It is made of the finished English document, block by block: `catalogue` reads the pairs of
sentences in `sentences/`, `sentences` finds the French of a text by them, `notation` writes
formulas as French courses do, `language` puts both together.
"""
