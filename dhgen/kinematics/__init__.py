"""The exact forward model: chains of constant and joint transforms, and their products.

Read `chain`, what every robot file becomes, with its `drives` and their `turns`, and `build`, which
makes it, with `axes`, `common_normals`, `link_table`, `constants` and `expressions`. Polynomials:
`algebra`, an arm's ring, `normal`, `ring`, `transform`, `product`. Numbers: `rigid`, `numeric`,
`neighbours`, `arm_angle`, `given`, `task`, `order`.
"""
