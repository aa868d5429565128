/* adept: Adept SCARA
 * Inverse kinematics, generated from robots/adept.yaml and templates/c/solver.h.jinja.
 * Do not edit: run dhgen robots/adept.yaml. The formulas and where they come from: adept.md.
 *
 * Poses are row-major 4 x 4 matrices of the tool in the base frame, in mm; angles are in rad.
 * Of a pose, the whole pose is meant; other entries are ignored.
 */
#ifndef ADEPT_H
#define ADEPT_H

#include <stddef.h>

#ifdef __cplusplus
extern "C" {
#endif

enum {
    ADEPT_DOF = 3,
    ADEPT_ROWS = 1
};

/* What a row of adept_ik holds. */
enum {
    ADEPT_OK = 0,            /* joint values */
    ADEPT_UNREACHABLE = 1,   /* NaN: no solution in this branch, or one that a row before it holds */
    ADEPT_FREE_JOINT = 2,    /* joint values; a joint was indeterminate and took the seed's value */
    ADEPT_OUT_OF_LIMITS = 3, /* joint values, of which one is beyond its limits */
    ADEPT_INVALID_POSE = 4   /* NaN: T is no pose */
};

/* The name of every row: only. */
extern const char *const adept_branches[1];

/* T of the joint values q. */
void adept_fk(const double q[3], double T[16]);

/* The geometric Jacobian, 6 x 3 row by row: velocity of the tool's origin, angular velocity. */
void adept_jacobian(const double q[3], double J[18]);

/* All solutions. Row b is always branch b. q_seed gives the values of joints that are indeterminate
 * (NULL: zeros). Returns the number of rows that are OK or FREE_JOINT, or -ADEPT_INVALID_POSE. */
int adept_ik(const double T[16], const double *q_seed,
    double q[1][3], unsigned char status[1]);

/* The solution nearest to q_seed, angles moved by whole turns inside their limits. Returns ADEPT_OK or
 * ADEPT_FREE_JOINT, or minus ADEPT_UNREACHABLE, _OUT_OF_LIMITS or _INVALID_POSE (q is then NaN). */
int adept_ik_nearest(const double T[16], const double q_seed[3], double q[3]);

/* adept_ik for n poses: T is n x 16, q n x 1 x 3, status n x 1. */
void adept_ik_batch(size_t n, const double *T, double *q, unsigned char *status);

#ifdef __cplusplus
}
#endif

#endif
