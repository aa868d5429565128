/* SPDX-License-Identifier: MIT
 *
 * What a table makes of a calibrated arm: numbers that are worked out once and read by every call.
 */
#ifndef DHGEN_CALIBRATION_H
#define DHGEN_CALIBRATION_H

/* One arm of a kind. It holds no pointers: it may be copied, kept in a file, and read by several
 * threads at once. Transforms are three rows of four. */
typedef struct dhgen_calibration {
    double constant[7][12];     /* C0 ... C6 of T = C0 J(q1) C1 ... J(q6) C6 */
    double facing[6];           /* whether a joint counts its angle forwards, 1, or back, -1 */
    double turned, moved;       /* its tool and the nearest arm's differ by no more [rad, length] */
    double loop[7][12];         /* K0 ... K4, L and R of J(q1) K0 J(q2) ... K4 J(q6) = L T R */
    double size;                /* the length that is one in this loop */
    double left[12], right[12]; /* the nearest arm's pose is left T right */
    double more[6];             /* the nearest arm's angles minus this arm's */
    double nominal[7][12];      /* C0 ... C6 of the nearest arm at joint values of this */
    double margin;              /* poses are left whose rows may end within so many times these
                                   bounds */
} dhgen_calibration;

#endif
