/* puma: PUMA in its reference position
 * Inverse kinematics, generated from robots/puma.yaml and templates/c/solver.h.jinja.
 * Do not edit: run dhgen robots/puma.yaml. The formulas and where they come from: puma.md.
 *
 * Poses are row-major 4 x 4 matrices of the tool in the base frame, in m; angles are in rad.
 * Of a pose, the whole pose is meant; other entries are ignored.
 */
#ifndef PUMA_H
#define PUMA_H

#include <stddef.h>

#ifdef __cplusplus
extern "C" {
#endif

enum {
    PUMA_DOF = 6,
    PUMA_ROWS = 8
};

/* What a row of puma_ik holds. */
enum {
    PUMA_OK = 0,            /* joint values */
    PUMA_UNREACHABLE = 1,   /* NaN: no solution in this branch, or one that a row before it holds */
    PUMA_FREE_JOINT = 2,    /* joint values; a joint was indeterminate and took the seed's value */
    PUMA_OUT_OF_LIMITS = 3, /* joint values, of which one is beyond its limits */
    PUMA_INVALID_POSE = 4   /* NaN: T is no pose */
};

/* The name of every row: left-down-noflip, left-down-flip, left-up-noflip, left-up-flip, right-down-noflip, right-down-flip, right-up-noflip, right-up-flip. */
extern const char *const puma_branches[8];

/* T of the joint values q. */
void puma_fk(const double q[6], double T[16]);

/* The geometric Jacobian, 6 x 6 row by row: velocity of the tool's origin, angular velocity. */
void puma_jacobian(const double q[6], double J[36]);

/* All solutions. Row b is always branch b. q_seed gives the values of joints that are indeterminate
 * (NULL: zeros). Returns the number of rows that are OK or FREE_JOINT, or -PUMA_INVALID_POSE. */
int puma_ik(const double T[16], const double *q_seed,
    double q[8][6], unsigned char status[8]);

/* The solution nearest to q_seed, angles moved by whole turns inside their limits. Returns PUMA_OK or
 * PUMA_FREE_JOINT, or minus PUMA_UNREACHABLE, _OUT_OF_LIMITS or _INVALID_POSE (q is then NaN). */
int puma_ik_nearest(const double T[16], const double q_seed[6], double q[6]);

/* puma_ik for n poses: T is n x 16, q n x 8 x 6, status n x 8. */
void puma_ik_batch(size_t n, const double *T, double *q, unsigned char *status);

#ifdef __cplusplus
}
#endif

#endif
