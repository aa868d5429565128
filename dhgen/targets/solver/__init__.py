"""What the templates of a solver name in every language: frozen groups of strings and numbers.

Read `common`, which has them all; `module` and `task`, what is solved; `programs` and `bodies`, the
formulas; `given` and `links`, `refinement` and `nearest`, what some arms have besides.
"""
