"""The entries of the pose and the named points as numbers, where the joints have values."""

from __future__ import annotations

from itertools import chain
from typing import TYPE_CHECKING

import numpy as np

from dhgen.kinematics.algebra import POSE_NAMES, POSE_PLACES, SHOULDER_NAMES
from dhgen.paul.samples import Sums

if TYPE_CHECKING:
    from dhgen.arrays import FloatArray
    from dhgen.paul.pool import Pool


class PoseValues:
    """What the forward model of an arm gives; made ready once for many places."""

    def __init__(self, pool: Pool) -> None:
        """Reads the links, the points and the shoulder of an arm."""
        problem = pool.problem
        links = [problem.spans.product(place, place + 1) for place in range(len(problem.links))]
        points, base_points = pool.points, pool.base_points
        shoulder = () if pool.plane is None else pool.plane.rotation
        self._links = Sums(link.entry(*place) for link in links for place in POSE_PLACES.values())
        self._in_tool = Sums(chain.from_iterable(point.in_tool for point in points))
        self._in_base = Sums(chain.from_iterable(point.in_base for point in base_points))
        self._shoulder = Sums(chain.from_iterable(shoulder))
        names = chain(
            POSE_NAMES,
            *(point.names for point in points),
            *(point.names for point in base_points),
            *SHOULDER_NAMES[: len(shoulder)],
        )
        self._places = [problem.algebra.index[name] for name in names]

    def fill(self, values: FloatArray) -> None:
        """Puts them where they belong.

        Args:
            values: Of every generator, (generators, places); joints and lengths have theirs.
        """
        count = values.shape[1]
        T = self._forward(values)
        rotation, origin = T[:, :3, :3], T[:, :3, 3:]
        in_tool, in_base = (
            each(values).reshape(-1, 3, count).T for each in (self._in_tool, self._in_base)
        )
        found = (
            T[:, :3].reshape(count, -1).T,
            _columns(_times(rotation, in_tool) + origin),
            _columns(_times(rotation.swapaxes(1, 2), in_base - origin)),
            self._shoulder(values),
        )
        values[self._places] = np.concatenate(found)

    def _forward(self, values: FloatArray) -> FloatArray:
        """A_1 ... A_n, (places, 4, 4): its entries have many terms, those of links few."""
        links = self._links(values).reshape(-1, 3, 4, values.shape[1])
        T = np.broadcast_to(np.eye(4), (values.shape[1], 4, 4))
        for link in np.moveaxis(links, -1, 1):
            A = np.broadcast_to(np.eye(4), T.shape).copy()
            A[:, :3] = link
            T = _times(T, A)
        return T


def _columns(vectors: FloatArray) -> FloatArray:
    """Vectors (places, 3, n) below each other, (3 n, places)."""
    return vectors.T.reshape(-1, len(vectors))


def _times(first: FloatArray, second: FloatArray) -> FloatArray:
    """Products of matrices, (places, n, k), by sums whose order no machine's library chooses."""
    return np.asarray((first[..., None] * second[:, None]).sum(axis=2))
