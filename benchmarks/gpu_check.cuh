/* SPDX-License-Identifier: MIT
 *
 * What python -m benchmarks.gpu counts on the GPU, behind dhgen_kernels.cuh: rows by their statuses,
 * and the largest entry by which a row misses its pose. */

/* Into `left`: how many rows have status 0 to 7, and the bits of a float. */
template <class Number, int ENTRIES>
__global__ void __launch_bounds__(128) gpu_check(dhgen_batch<Number> batch)
{
    const size_t i = blockIdx.x * (size_t)blockDim.x + threadIdx.x;
    double pose[16];
    if (i >= batch.n)
        return;
    dhgen_load_pose<Number, ENTRIES>(batch.T, i, pose);
    for (int row = 0; row < DHGEN_ROWS; row++) {
        const int status = batch.status[DHGEN_ROWS * i + row];
        double q[DHGEN_DOF], reached[16], most = 0.0;
        atomicAdd(batch.left + (status & 7), 1u);
        if (status == DHGEN_UNREACHABLE || status > DHGEN_OUT_OF_LIMITS)
            continue;
        dhgen_load_values<DHGEN_DOF>(batch.q, DHGEN_ROWS * i + row, q);
        DHGEN_CALL(_fk)(q, reached);
        for (int k = 0; k < 12; k++) {
            const double off = fabs(reached[k] - pose[k]);
            most = off <= most ? most : off; /* also where it is no number */
        }
        const float told = (float)most;
        atomicMax(batch.left + 8, __float_as_uint(told == told ? told : INFINITY));
    }
}
