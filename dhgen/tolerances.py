"""What generated code takes for rounding, in each arithmetic, with the reason.

A tolerance of one method alone is in its module: in `dhgen/general`, in `dhgen/numerical`, and in
`dhgen/targets` for families of solutions and for joints on a limit. So is what the compiler itself
takes for zero where it looks at numbers.

Lengths are relative to the size of the arm; rounding in a pose is a few 1e-16 of it, after the
products of a derivation a few 1e-15. In single precision it is a few 1e-8 and a few 1e-7.
"""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True, slots=True)
class Tolerances:
    """The frozen table.

    Attributes:
        free: A vector that should fix an angle is no longer than this: the joint is free. Above
            rounding, which is larger than usual where the arm is nearly folded; a direction taken
            from a vector just longer is good to 1e-3 rad and its residual is still this small.
        near: A unit vector's projection that should fix an angle and is no longer than this does so
            with rounding errors of 1e-13 rad or more, which an arm that is stretched may not bear.
        regular: A pose is singular to fast code if such a projection is no longer than this: of
            what it fixes, digits are lost to 1e-11 rad at worst, and few random poses are.
        reach: A pose may be this far out of reach: one on the workspace boundary, stretched or
            folded, lands there by rounding.
        reach_refined: `reach` where rows are refined: an angle before the boundary may be good to
            few digits, so the arm may be this far out of reach, and steps decide what is a
            solution.
        merge: Nearer to the boundary of reach than this, the two branches have met. Above
            rounding, so that a stretched arm is one solution, not two that differ by 1e-8.
        blur: `merge` where an angle before them is good to few digits only.
        near_reach_boundary: Nearer to it than this a pose is singular to fast code, and farther
            where an angle before is good to few digits. Rounding over the root of this is far below
            what a joint may miss its limit by.
        orthonormal: The sum of squares by which a rotation misses orthonormality, up to which it
            is taken as it is.
        rotation: The sum of squares up to which it is replaced by the nearest rotation: a pose in
            single precision, or rounded to six digits. Beyond it the pose is invalid.
        steep: Of the tool's x axis, the length of what is seen from above, below which it has no
            yaw there: as much as a pose of six digits rounds it by.
        consistent: A pose that has more entries than the arm has joints may miss by this: it
            may have been rounded to six digits.
        nothing: A square, or a sum of them, is rounded by this.
        exact: A row that misses its pose by no more is exact, but for rounding of the arithmetic;
            lengths count in arm sizes, or in the pose's distance where that is larger. Where one
            row is exact the pose was not rounded, and the others have to be exact, too.
        promised: A row misses its pose by no more wherever it has a solution, singular poses
            included: what the written files are held to, and a reason to refine rows.
        doubtful: A row may miss its pose by this before it is refined, and limits before its
            joints are put on them: an angle taken from a vector just longer than `free` is good to
            1e-3 rad.
        longest: Where the factor of a slide nearly vanishes, a length above this is no solution:
            its last digits are worth more than rounding of a pose.
        limit: A joint value may miss its limit by this: rounding of the angle itself.
        overshoot: Fast code may be wrong by this where an arm is nearly singular twice over: the
            direction to a wrist centre just farther than `regular` from an axis is taken from an
            elbow just farther than `near_reach_boundary` from stretched. A joint that is beyond a
            limit by no more may be on it: the pose is left.
        clamped: A joint that comes out a little beyond a limit is clamped to it if the pose is
            missed by so much more at most. Not above `merge`: where two branches are distinct, the
            one beyond the limit must not be taken for the other.
        distinct: Two rows closer than this are one solution [rad or length]. About the square root
            of `merge`, because merging branches separate like a square root.
        far: Angles are not moved by whole turns to an angle of the seed above this [rad]: they
            would lose digits there.
        refined: A candidate that was refined on the whole pose is a solution if it misses that
            by no more [arm sizes, rad]: far above rounding, far below where a near miss ends.
        fine: Always added to the damping of steps to a solution next to joint values, a square: its
            root is so far above rounding of the miss that this moves joints by 1e-3 rad at most, in
            single precision by 3e-3.
        double: An extremum of a polynomial this near to zero, relative to its coefficients, is a
            double root: rounding of the coefficients may move it either way.
        simple: Where the slope is above this, relative to the coefficients, a Newton step
            improves a root; below, it may leap away.
    """

    free: float = 1e-12
    near: float = 1e-3
    regular: float = 1e-4
    reach: float = 1e-13
    reach_refined: float = 1e-5
    merge: float = 1e-14
    blur: float = 1e-11
    near_reach_boundary: float = 1e-11
    orthonormal: float = 1e-24
    rotation: float = 1e-9
    steep: float = 1e-6
    consistent: float = 1e-5
    nothing: float = 1e-15
    exact: float = 1e-12
    promised: float = 1e-11
    doubtful: float = 1e-2
    longest: float = 1e4
    limit: float = 1e-9
    overshoot: float = 1e-6
    clamped: float = 1e-14
    distinct: float = 1e-6
    far: float = 1e5
    refined: float = 1e-10
    fine: float = 1e-26
    double: float = 1e-13
    simple: float = 1e-4

    @property
    def is_finer_than_poses(self) -> bool:
        """Whether the arithmetic is finer than a rounded pose, so that one can be recognized."""
        return self.exact < self.consistent

    @property
    def limit_slack(self) -> float:
        """Half of `overshoot`: what is as far from this at most is beyond a limit by rounding."""
        return 0.5 * self.overshoot


TOLERANCES = Tolerances()


@dataclass(frozen=True, slots=True)
class Precision:
    """The arithmetic that generated code uses.

    Attributes:
        name: What it is called.
        suffix: What it adds to the robot's name, in names of files and functions.
        tolerances: Its table.
    """

    name: str
    suffix: str
    tolerances: Tolerances


DOUBLE = Precision("double precision", "", TOLERANCES)

# As above with the rounding of a float, 5e8 times as coarse. The margins are narrower, or nothing
# would be left between them: a direction taken from a vector just longer than `free` is good to
# 1e-2 rad. What a user may have rounded (rotation, consistent) does not depend on the arithmetic.
# A wrist with oblique twists multiplies the rounding of a pose by 20 before its reach is decided.
SINGLE = Precision(
    "single precision",
    "_f32",
    Tolerances(
        free=2e-5,
        regular=1e-3,
        reach=4e-6,
        merge=1e-7,
        blur=1e-5,
        near_reach_boundary=4e-6,
        orthonormal=1e-12,
        nothing=5e-7,
        exact=5e-5,
        limit=2e-6,
        overshoot=1e-2,
        clamped=1e-6,
        fine=1e-10,
        distinct=3e-3,
        far=1e2,
    ),
)
