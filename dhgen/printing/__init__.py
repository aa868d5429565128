"""What every printer uses, of solvers and of derivations.

`templates` fills in what lies in templates/, `comments` spells users' words so that they end none.
"""
