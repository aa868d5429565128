"""What the templates of the general algorithm are filled in with: strings and numbers.

Read `table`, the whole, with `constant_left_side` and `wrist`; `numbers` writes numbers.
"""
