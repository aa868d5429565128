/* spherical_offset: Spherical arm with a shoulder offset
 * Inverse kinematics, generated from robots/spherical_offset.yaml and templates/c/solver.h.jinja.
 * Do not edit: run dhgen robots/spherical_offset.yaml. The formulas and where they come from: spherical_offset.md.
 *
 * Poses are row-major 4 x 4 matrices of the tool in the base frame, in m; angles are in rad.
 * Of a pose, the position T[0:3, 3] is meant; other entries are ignored.
 */
#ifndef SPHERICAL_OFFSET_H
#define SPHERICAL_OFFSET_H

#include <stddef.h>

#ifdef __cplusplus
extern "C" {
#endif

enum {
    SPHERICAL_OFFSET_DOF = 3,
    SPHERICAL_OFFSET_ROWS = 4
};

/* What a row of spherical_offset_ik holds. */
enum {
    SPHERICAL_OFFSET_OK = 0,            /* joint values */
    SPHERICAL_OFFSET_UNREACHABLE = 1,   /* NaN: no solution in this branch, or one that a row before it holds */
    SPHERICAL_OFFSET_FREE_JOINT = 2,    /* joint values; a joint was indeterminate and took the seed's value */
    SPHERICAL_OFFSET_OUT_OF_LIMITS = 3, /* joint values, of which one is beyond its limits */
    SPHERICAL_OFFSET_INVALID_POSE = 4   /* NaN: T is no pose */
};

/* The name of every row: left-forward, left-backward, right-forward, right-backward. */
extern const char *const spherical_offset_branches[4];

/* T of the joint values q. */
void spherical_offset_fk(const double q[3], double T[16]);

/* The geometric Jacobian, 6 x 3 row by row: velocity of the tool's origin, angular velocity. */
void spherical_offset_jacobian(const double q[3], double J[18]);

/* All solutions. Row b is always branch b. q_seed gives the values of joints that are indeterminate
 * (NULL: zeros). Returns the number of rows that are OK or FREE_JOINT, or -SPHERICAL_OFFSET_INVALID_POSE. */
int spherical_offset_ik(const double T[16], const double *q_seed,
    double q[4][3], unsigned char status[4]);

/* The solution nearest to q_seed, angles moved by whole turns inside their limits. Returns SPHERICAL_OFFSET_OK or
 * SPHERICAL_OFFSET_FREE_JOINT, or minus SPHERICAL_OFFSET_UNREACHABLE, _OUT_OF_LIMITS or _INVALID_POSE (q is then NaN). */
int spherical_offset_ik_nearest(const double T[16], const double q_seed[3], double q[3]);

/* spherical_offset_ik for n poses: T is n x 16, q n x 4 x 3, status n x 4. */
void spherical_offset_ik_batch(size_t n, const double *T, double *q, unsigned char *status);

#ifdef __cplusplus
}
#endif

#endif
