/* cartesian: Cartesian arm
 * Inverse kinematics, generated from robots/cartesian.yaml and templates/c/solver.h.jinja.
 * Do not edit: run dhgen robots/cartesian.yaml. The formulas and where they come from: cartesian.md.
 *
 * Poses are row-major 4 x 4 matrices of the tool in the base frame, in m; angles are in rad.
 * Of a pose, the position T[0:3, 3] is meant; other entries are ignored.
 */
#ifndef CARTESIAN_H
#define CARTESIAN_H

#include <stddef.h>

#ifdef __cplusplus
extern "C" {
#endif

enum {
    CARTESIAN_DOF = 3,
    CARTESIAN_ROWS = 1
};

/* What a row of cartesian_ik holds. */
enum {
    CARTESIAN_OK = 0,            /* joint values */
    CARTESIAN_UNREACHABLE = 1,   /* NaN: no solution in this branch, or one that a row before it holds */
    CARTESIAN_FREE_JOINT = 2,    /* joint values; a joint was indeterminate and took the seed's value */
    CARTESIAN_OUT_OF_LIMITS = 3, /* joint values, of which one is beyond its limits */
    CARTESIAN_INVALID_POSE = 4   /* NaN: T is no pose */
};

/* The name of every row: only. */
extern const char *const cartesian_branches[1];

/* T of the joint values q. */
void cartesian_fk(const double q[3], double T[16]);

/* The geometric Jacobian, 6 x 3 row by row: velocity of the tool's origin, angular velocity. */
void cartesian_jacobian(const double q[3], double J[18]);

/* All solutions. Row b is always branch b. q_seed gives the values of joints that are indeterminate
 * (NULL: zeros). Returns the number of rows that are OK or FREE_JOINT, or -CARTESIAN_INVALID_POSE. */
int cartesian_ik(const double T[16], const double *q_seed,
    double q[1][3], unsigned char status[1]);

/* The solution nearest to q_seed, angles moved by whole turns inside their limits. Returns CARTESIAN_OK or
 * CARTESIAN_FREE_JOINT, or minus CARTESIAN_UNREACHABLE, _OUT_OF_LIMITS or _INVALID_POSE (q is then NaN). */
int cartesian_ik_nearest(const double T[16], const double q_seed[3], double q[3]);

/* cartesian_ik for n poses: T is n x 16, q n x 1 x 3, status n x 1. */
void cartesian_ik_batch(size_t n, const double *T, double *q, unsigned char *status);

#ifdef __cplusplus
}
#endif

#endif
