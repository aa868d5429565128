/* stanford: Stanford arm
 * Inverse kinematics, generated from robots/stanford.yaml and templates/c/solver.h.jinja.
 * Do not edit: run dhgen robots/stanford.yaml. The formulas and where they come from: stanford.md.
 *
 * Poses are row-major 4 x 4 matrices of the tool in the base frame, in m; angles are in rad.
 * Of a pose, the whole pose is meant; other entries are ignored.
 */
#ifndef STANFORD_H
#define STANFORD_H

#include <stddef.h>

#ifdef __cplusplus
extern "C" {
#endif

enum {
    STANFORD_DOF = 6,
    STANFORD_ROWS = 8
};

/* What a row of stanford_ik holds. */
enum {
    STANFORD_OK = 0,            /* joint values */
    STANFORD_UNREACHABLE = 1,   /* NaN: no solution in this branch, or one that a row before it holds */
    STANFORD_FREE_JOINT = 2,    /* joint values; a joint was indeterminate and took the seed's value */
    STANFORD_OUT_OF_LIMITS = 3, /* joint values, of which one is beyond its limits */
    STANFORD_INVALID_POSE = 4   /* NaN: T is no pose */
};

/* The name of every row: left-forward-noflip, left-forward-flip, left-backward-noflip, left-backward-flip, right-forward-noflip, right-forward-flip, right-backward-noflip, right-backward-flip. */
extern const char *const stanford_branches[8];

/* T of the joint values q. */
void stanford_fk(const double q[6], double T[16]);

/* The geometric Jacobian, 6 x 6 row by row: velocity of the tool's origin, angular velocity. */
void stanford_jacobian(const double q[6], double J[36]);

/* All solutions. Row b is always branch b. q_seed gives the values of joints that are indeterminate
 * (NULL: zeros). Returns the number of rows that are OK or FREE_JOINT, or -STANFORD_INVALID_POSE. */
int stanford_ik(const double T[16], const double *q_seed,
    double q[8][6], unsigned char status[8]);

/* The solution nearest to q_seed, angles moved by whole turns inside their limits. Returns STANFORD_OK or
 * STANFORD_FREE_JOINT, or minus STANFORD_UNREACHABLE, _OUT_OF_LIMITS or _INVALID_POSE (q is then NaN). */
int stanford_ik_nearest(const double T[16], const double q_seed[6], double q[6]);

/* stanford_ik for n poses: T is n x 16, q n x 8 x 6, status n x 8. */
void stanford_ik_batch(size_t n, const double *T, double *q, unsigned char *status);

#ifdef __cplusplus
}
#endif

#endif
