"""Square blocks with zeros beside them: the product of their determinants is that of the matrix."""

from __future__ import annotations

import math

import numpy as np
import pytest

from dhgen.derivation.velocity.triangle import triangle_of


@pytest.mark.parametrize("seed", range(20))
def test_the_product_of_the_blocks_is_the_determinant(seed: int) -> None:
    draw = np.random.default_rng(seed)
    matrix = draw.uniform(0.5, 2.0, (6, 6))
    matrix[draw.permutation(6)[:3, None], draw.permutation(6)[None, :3]] = 0.0
    found = triangle_of(matrix.tolist())
    assert found is not None
    assert sorted(column for _, columns in found.blocks for column in columns) == list(range(6))
    blocks = [matrix[np.ix_(rows, columns)] for rows, columns in found.blocks]
    product = found.sign * math.prod(map(float, map(np.linalg.det, blocks)))
    assert product == pytest.approx(float(np.linalg.det(matrix)))
    assert found.effort == 2 * 3**3


def test_of_a_triangle_every_block_is_one_entry() -> None:
    found = triangle_of(np.triu(np.ones((4, 4)))[::-1].tolist())
    assert found is not None
    assert [len(rows) for rows, _ in found.blocks] == [1] * 4


def test_of_zeros_in_a_whole_column_there_is_none() -> None:
    assert triangle_of([[1, 0], [1, 0]]) is None
