"""The sections of a document, each from the story of a derivation.

In the order of a document: `robot` with `tables`, `parameters` and `frames`; `drives`; `forward`
with `transforms` and `jacobian`; `inverse` with `given_entries`, `types_table`, `elements` and
`shoulder`; behind the steps `joints`, `turns`, `closing`, `listing`, `example`, `choosing` and
`velocity`. In place of all that follows the forward model, arms without a closed form have
`general` with `constant_transforms`, `numerical`, `nearest` or `calibrated`, and `whole_example`.
Within steps and examples are `wrist`, `other_ways` and `roots`.
"""
