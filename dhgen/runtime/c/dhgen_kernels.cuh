/* SPDX-License-Identifier: MIT
 *
 * dhgen_kernels: a robot's C as CUDA kernels for many poses.
 * Part of dhgen, which puts a copy of this file beside the robots that it generates.
 *
 *   #define DHGEN_ROBOT scara
 *   #define DHGEN_GIVEN 0 // values that the caller gives besides the pose
 *   #include "scara.c"
 *   #include "dhgen_kernels.cuh"
 *
 * A batch goes through two kernels on one stream. The first solves regular poses, one a thread, and
 * writes the numbers of all others into a list, whose length has to be zero before. The second
 * solves these with the careful functions, one a warp: some take a hundred times as long, and no
 * other pose should wait for them.
 *
 *   dhgen_batch<double> batch = {n, T, NULL, NULL, q, status, left};
 *   cudaMemsetAsync(left, 0, sizeof *left, stream);
 *   dhgen_all_rows<double, 16><<<dhgen_blocks(n), DHGEN_THREADS, 0, stream>>>(batch);
 *   dhgen_careful_rows<double, 16><<<blocks, 32, 0, stream>>>(batch);
 *
 * Arms without regular poses (DHGEN_SOLVE_WIDE is not defined) have no first kernel: there a batch
 * without a list goes through the second, one pose a thread. Those of the general algorithm take a
 * group of threads for each pose, in blocks of DHGEN_GROUP_THREADS, where before their source
 *
 *   #define DHGEN_GROUP 16 // or 8, or 32
 *
 * stands: then all threads of a group call what they call alike. Nothing is allocated, nothing
 * waits. Numbers of arrays are double or float; it is doubles that are computed with. Rounded
 * poses, as those in single precision are, become the nearest rotation in the first kernel. */
#ifndef DHGEN_KERNELS_CUH
#define DHGEN_KERNELS_CUH

#define DHGEN_PASTE_(a, b) a##b
#define DHGEN_PASTE(a, b) DHGEN_PASTE_(a, b)
#define DHGEN_CALL(end) DHGEN_PASTE(DHGEN_ROBOT, end)
#if DHGEN_GIVEN > 0
#define DHGEN_HELD(held) (held),
#else
#define DHGEN_HELD(held)
#endif

/* The status of rows that need the careful functions, where these were not called. */
enum { DHGEN_SKIPPED = 5 };

/* The arrays of a batch, row by row. Of a kernel's arguments those that it does not need may be
 * NULL. `q` and poses begin at multiples of 16 bytes. */
template <class Number> struct dhgen_batch {
    unsigned long long n;
    const Number *T;           /* n x 4 x 4, or n x 3 x 4 */
    const Number *free_joints; /* n x DHGEN_GIVEN */
    const Number *values;      /* n x DHGEN_DOF: seeds, or joint values */
    Number *q;                 /* n x DHGEN_ROWS x DHGEN_DOF, n x DHGEN_DOF, or poses */
    unsigned char *status;     /* n x DHGEN_ROWS, or n: statuses, or counts */
    unsigned *left; /* 1 + n: how many poses are left to the careful functions, and which */
};

/* Sizes: of results in words of 16 bytes where they fill these, else in numbers; a row of the stage
 * in shared memory has a word more, so that threads that write to it meet in no bank. */
template <class Number, bool FILLS> struct dhgen_word {
    typedef Number type;
};
template <class Number> struct dhgen_word<Number, true> {
    typedef int4 type;
};
template <class Number> struct dhgen_sizes {
    enum { RESULTS = DHGEN_ROWS * DHGEN_DOF, BYTES = RESULTS * (int)sizeof(Number) };
    typedef typename dhgen_word<Number, BYTES % 16 == 0>::type word;
    enum { WORDS = BYTES / (int)sizeof(word), STRIDE = WORDS + 1, PER = RESULTS / WORDS };
};

/* Threads of a block of the first kernel: one warp where two would not fit shared memory. Ten warps
 * of a multiprocessor have room for their registers. */
#define DHGEN_THREADS (DHGEN_ROWS * DHGEN_DOF <= 94 ? 64 : 32)

DHGEN_INLINE unsigned dhgen_blocks(unsigned long long n)
{
    return (unsigned)((n + DHGEN_THREADS - 1) / DHGEN_THREADS);
}

/* Reads the pose of a number in a batch. */
template <class Number, int ENTRIES>
__device__ inline void dhgen_load_pose(const Number *T, unsigned long long i, double *pose)
{
    enum { WORDS = ENTRIES * (int)sizeof(Number) / 16, PER = 16 / (int)sizeof(Number) };
    const int4 *const from = (const int4 *)(T + ENTRIES * i);
#pragma unroll
    for (int k = 0; k < WORDS; k++) {
        union {
            int4 word;
            Number numbers[PER];
        } read;
        read.word = __ldg(from + k);
#pragma unroll
        for (int j = 0; j < PER; j++)
            pose[PER * k + j] = read.numbers[j];
    }
    if (ENTRIES == 12) {
        pose[12] = pose[13] = pose[14] = 0.0;
        pose[15] = 1.0;
    }
}

/* Reads so many of a row's numbers. */
template <int COUNT, class Number>
__device__ inline void dhgen_load_values(const Number *from, unsigned long long i, double *values)
{
#pragma unroll
    for (int k = 0; k < COUNT; k++)
        values[k] = __ldg(from + COUNT * i + k);
}

#ifdef DHGEN_SOLVE_WIDE

/* Puts a pose's number on the list of poses that are left. */
template <class Number>
__device__ inline void dhgen_leave(const dhgen_batch<Number> &batch, size_t i)
{
    batch.left[1 + atomicAdd(batch.left, 1u)] = (unsigned)i;
}

/* Solves a pose of a batch if it is regular, be it rounded. Returns whether it is. */
template <class Number, int ENTRIES>
__device__ inline bool dhgen_regular_pose(
    const dhgen_batch<Number> &batch, size_t i, double *found, int *kind)
{
    double given[16], pose[16], held[DHGEN_GIVEN + 1];
    dhgen_load_pose<Number, ENTRIES>(batch.T, i, given);
    if (DHGEN_GIVEN > 0)
        dhgen_load_values<DHGEN_GIVEN>(batch.free_joints, i, held);
    return dhgen_read_pose(&arm, given, pose) != 0
        && !DHGEN_SOLVE_WIDE(pose, DHGEN_GIVEN > 0 ? held : NULL, found, kind);
}

/* The first kernel for all rows, until the results are in a warp's stage. */
template <class Number, int ENTRIES>
__device__ inline void dhgen_solve_lane(
    const dhgen_batch<Number> &batch, size_t i, int lane, typename dhgen_sizes<Number>::word *stage)
{
    typedef dhgen_sizes<Number> sizes;
    double found[DHGEN_ROWS * DHGEN_DOF];
    int kind[DHGEN_ROWS] = { 0 };
    const bool left = !dhgen_regular_pose<Number, ENTRIES>(batch, i, found, kind);
    const bool skipped = left && !batch.left;
#pragma unroll
    for (int k = 0; k < sizes::WORDS; k++) {
        union {
            typename sizes::word whole;
            Number numbers[sizes::PER];
        } write;
#pragma unroll
        for (int j = 0; j < sizes::PER; j++)
            write.numbers[j] = (Number)(skipped ? DHGEN_NAN : found[sizes::PER * k + j]);
        stage[lane * sizes::STRIDE + k] = write.whole;
    }
    enum { TOGETHER = DHGEN_ROWS % 8 == 0 ? 8 : DHGEN_ROWS % 4 == 0 ? 4 : 1 };
#pragma unroll
    for (int first = 0; first < DHGEN_ROWS; first += TOGETHER) {
        unsigned long long kinds = 0;
#pragma unroll
        for (int j = 0; j < TOGETHER; j++)
            kinds |= (unsigned long long)(skipped ? DHGEN_SKIPPED : kind[first + j]) << 8 * j;
        unsigned char *const to = batch.status + DHGEN_ROWS * i + first;
        if (TOGETHER == 8)
            *(unsigned long long *)to = kinds;
        else if (TOGETHER == 4)
            *(unsigned *)to = (unsigned)kinds;
        else
            *to = (unsigned char)kinds;
    }
    if (left && !skipped)
        dhgen_leave(batch, i);
}

/* Copies what a warp has staged: its poses' results are one run of memory. */
template <class Number>
__device__ inline void dhgen_copy_lane(const dhgen_batch<Number> &batch, size_t first, int lane,
    const typename dhgen_sizes<Number>::word *stage)
{
    typedef dhgen_sizes<Number> sizes;
    typename sizes::word *const to = (typename sizes::word *)(batch.q + sizes::RESULTS * first);
    const size_t poses = batch.n - first < 32 ? batch.n - first : 32;
    const int count = sizes::WORDS * (int)poses;
#pragma unroll 8
    for (int k = 0; k < sizes::WORDS; k++) {
        const int place = 32 * k + lane;
        if (place < count)
            __stcs(to + place, stage[place / sizes::WORDS * sizes::STRIDE + place % sizes::WORDS]);
    }
}

/* All rows of regular poses. */
template <class Number, int ENTRIES>
__global__ void __launch_bounds__(DHGEN_THREADS, 320 / DHGEN_THREADS)
    dhgen_all_rows(dhgen_batch<Number> batch)
{
    typedef dhgen_sizes<Number> sizes;
    __shared__ typename sizes::word stages[DHGEN_THREADS * sizes::STRIDE];
    const int lane = (int)threadIdx.x % 32;
    typename sizes::word *const stage = stages + ((int)threadIdx.x - lane) * sizes::STRIDE;
    const size_t i = blockIdx.x * (size_t)DHGEN_THREADS + threadIdx.x, first = i - (size_t)lane;
    if (i < batch.n)
        dhgen_solve_lane<Number, ENTRIES>(batch, i, lane, stage);
    __syncwarp();
    if (first < batch.n)
        dhgen_copy_lane(batch, first, lane, stage);
}

/* How many rows of regular poses are inside limits. */
template <class Number, int ENTRIES>
__global__ void __launch_bounds__(128, 3) dhgen_count_rows(dhgen_batch<Number> batch)
{
    const size_t i = blockIdx.x * (size_t)blockDim.x + threadIdx.x;
    double found[DHGEN_ROWS * DHGEN_DOF];
    int kind[DHGEN_ROWS] = { 0 }, count = 0;
    if (i >= batch.n)
        return;
    const bool left = !dhgen_regular_pose<Number, ENTRIES>(batch, i, found, kind);
#pragma unroll
    for (int row = 0; row < DHGEN_ROWS; row++)
        count += kind[row] == DHGEN_OK;
    batch.status[i] = (unsigned char)(left ? 255 : count);
    if (left && batch.left)
        dhgen_leave(batch, i);
}

/* The row that is nearest to a seed, as dhgen_nearest_row finds it. Returns its status, or
 * DHGEN_SKIPPED where a seed is not finite, or at an end of a range that a row was turned away
 * from. */
__device__ inline int dhgen_nearest_lane(
    const double *seed, const double *found, const int *kind, double *q)
{
    double least = HUGE_VAL;
    int result = DHGEN_UNREACHABLE, sure = 1;
#pragma unroll
    for (int j = 0; j < DHGEN_DOF; j++) {
        sure &= isfinite(seed[j]) != 0;
        q[j] = DHGEN_NAN;
    }
#pragma unroll
    for (int row = 0; row < DHGEN_ROWS; row++) {
        double values[DHGEN_DOF], distance = 0.0;
#pragma unroll
        for (int j = 0; j < DHGEN_DOF; j++) {
            const double value = found[DHGEN_DOF * row + j], low = arm.joints[j].lowest;
            const double end = fmin(arm.joints[j].highest - seed[j], seed[j] - low);
            if (arm.range_exceeds_a_turn && kind[row] == DHGEN_OK && end < DHGEN_BESIDE_SEED) {
                const double there = dhgen_at_an_end(&arm, j, value, seed[j]);
                sure &= dhgen_past_an_end(&arm, j, there) == 0.0;
            }
            values[j] = dhgen_turned(&arm, j, value, seed[j]);
            const double moved = values[j] - seed[j];
            distance += arm.joints[j].weight * moved * moved;
        }
        if (kind[row] == DHGEN_OUT_OF_LIMITS && result == DHGEN_UNREACHABLE)
            result = DHGEN_OUT_OF_LIMITS;
        if (kind[row] != DHGEN_OK || (result == DHGEN_OK && !(distance < least)))
            continue;
        least = distance;
        result = DHGEN_OK;
#pragma unroll
        for (int j = 0; j < DHGEN_DOF; j++)
            q[j] = values[j];
    }
    return sure ? result : DHGEN_SKIPPED;
}

/* The solution of regular poses that is nearest to a seed. */
template <class Number, int ENTRIES>
__global__ void __launch_bounds__(128, 3) dhgen_nearest_to_seeds(dhgen_batch<Number> batch)
{
    const size_t i = blockIdx.x * (size_t)blockDim.x + threadIdx.x;
    double found[DHGEN_ROWS * DHGEN_DOF], seed[DHGEN_DOF], q[DHGEN_DOF];
    int kind[DHGEN_ROWS] = { 0 };
    if (i >= batch.n)
        return;
    dhgen_load_values<DHGEN_DOF>(batch.values, i, seed);
    const bool left = arm.coupling || !dhgen_regular_pose<Number, ENTRIES>(batch, i, found, kind);
    const int result = left ? DHGEN_SKIPPED : dhgen_nearest_lane(seed, found, kind, q);
#pragma unroll
    for (int j = 0; j < DHGEN_DOF; j++)
        batch.q[DHGEN_DOF * i + j] = (Number)(result == DHGEN_SKIPPED ? DHGEN_NAN : q[j]);
    batch.status[i] = (unsigned char)result;
    if (result == DHGEN_SKIPPED && batch.left)
        dhgen_leave(batch, i);
}

#endif

#if defined(DHGEN_GROUP) && defined(DHGEN_GENERAL_LANES_H)
#define DHGEN_GROUP_THREADS 32 /* of a block, whose groups have room in its shared memory */
#define DHGEN_CAREFUL_BOUNDS __launch_bounds__(DHGEN_GROUP_THREADS)
#ifdef DHGEN_LANES_ARE_THREADS
static_assert(DHGEN_ROOM_EQUATIONS_END <= DHGEN_ROOM_SIZE, "equations in a room");
static_assert(DHGEN_ROOM_CANDIDATES_END <= DHGEN_ROOM_SIZE, "candidates in a room");
static_assert(DHGEN_ROOM_HARMONICS + DHGEN_SAMPLES <= DHGEN_ROOM_SAMPLES, "harmonics");
static_assert(DHGEN_ROOM_GRID + 2 * DHGEN_EDGES_IN_LANES <= DHGEN_ROOM_TURNING, "a grid");
static_assert(DHGEN_ROOM_TURNING + 10 * DHGEN_WAITING <= DHGEN_ROOM_CROSSING, "parts that turn");
static_assert(DHGEN_ROOM_CROSSING + 10 * DHGEN_PARTS <= DHGEN_ROOM_CELLS, "parts that cross");
static_assert(
    DHGEN_GROUP_THREADS / DHGEN_GROUP * DHGEN_ROOM_SIZE * 8 <= 48 << 10, "a block's rooms");
#endif

/* What the second kernels go through: the poses of the list, or all, one a group of threads, of
 * which each writes a part of the results. */
template <class Number> struct dhgen_listed {
    const dhgen_batch<Number> &batch;
    unsigned long long at, step, count;
    int part, parts;

    __device__ explicit dhgen_listed(const dhgen_batch<Number> &of)
        : batch(of), at((blockIdx.x * (size_t)blockDim.x + threadIdx.x) / DHGEN_GROUP),
          step((size_t)gridDim.x * blockDim.x / DHGEN_GROUP), count(of.left ? *of.left : of.n),
          part((int)threadIdx.x % DHGEN_GROUP), parts(DHGEN_GROUP)
    {
    }
    __device__ bool goes_on() const
    {
        return at < count;
    }
    __device__ size_t next()
    {
        const unsigned long long now = at;
        at += step;
        return batch.left ? batch.left[1 + now] : (size_t)now;
    }
};
#else
#define DHGEN_CAREFUL_BOUNDS

/* What the second kernels go through: the poses of the list, one a warp, or all, one a thread. */
template <class Number> struct dhgen_listed {
    const dhgen_batch<Number> &batch;
    unsigned long long at, step, count;
    enum { part = 0, parts = 1 };

    __device__ explicit dhgen_listed(const dhgen_batch<Number> &of)
        : batch(of), at(blockIdx.x), step(gridDim.x), count(of.left ? *of.left : of.n)
    {
        if (of.left) { /* the other threads of a warp have nothing to do */
            at = threadIdx.x % 32 ? count : at * (blockDim.x / 32) + threadIdx.x / 32;
            step *= blockDim.x / 32;
        } else {
            at = at * blockDim.x + threadIdx.x;
            step *= blockDim.x;
        }
    }
    __device__ bool goes_on() const
    {
        return at < count;
    }
    __device__ size_t next()
    {
        const unsigned long long now = at;
        at += step;
        return batch.left ? batch.left[1 + now] : (size_t)now;
    }
};
#endif

/* Solves a pose of a batch by the robot's function for all poses. Returns its result. */
template <class Number, int ENTRIES>
__device__ __noinline__ int dhgen_any_pose(
    const dhgen_batch<Number> &batch, size_t i, double (*rows)[DHGEN_DOF], unsigned char *status)
{
    double pose[16], held[DHGEN_GIVEN + 1];
    dhgen_load_pose<Number, ENTRIES>(batch.T, i, pose);
    if (DHGEN_GIVEN > 0)
        dhgen_load_values<DHGEN_GIVEN>(batch.free_joints, i, held);
    return DHGEN_CALL(_ik)(pose, DHGEN_HELD(held) NULL, rows, status);
}

/* All rows of the poses that are left, or of all. */
template <class Number, int ENTRIES>
__global__ void DHGEN_CAREFUL_BOUNDS dhgen_careful_rows(dhgen_batch<Number> batch)
{
    for (dhgen_listed<Number> poses(batch); poses.goes_on();) {
        double rows[DHGEN_ROWS][DHGEN_DOF];
        unsigned char status[DHGEN_ROWS];
        const size_t i = poses.next();
        (void)dhgen_any_pose<Number, ENTRIES>(batch, i, rows, status);
        for (int row = poses.part; row < DHGEN_ROWS; row += poses.parts) {
            batch.status[DHGEN_ROWS * i + row] = status[row];
            for (int j = 0; j < DHGEN_DOF; j++)
                batch.q[(DHGEN_ROWS * i + row) * DHGEN_DOF + j] = (Number)rows[row][j];
        }
    }
}

/* How many rows of the poses that are left, or of all, are inside limits. */
template <class Number, int ENTRIES>
__global__ void DHGEN_CAREFUL_BOUNDS dhgen_careful_count(dhgen_batch<Number> batch)
{
    for (dhgen_listed<Number> poses(batch); poses.goes_on();) {
        double rows[DHGEN_ROWS][DHGEN_DOF];
        unsigned char status[DHGEN_ROWS];
        const size_t i = poses.next();
        const int count = dhgen_any_pose<Number, ENTRIES>(batch, i, rows, status);
        if (poses.part == 0)
            batch.status[i] = (unsigned char)(count < 0 ? 0 : count);
    }
}

/* The solution nearest to a seed of the poses that are left, or of all. */
template <class Number, int ENTRIES>
__global__ void DHGEN_CAREFUL_BOUNDS dhgen_careful_nearest(dhgen_batch<Number> batch)
{
    for (dhgen_listed<Number> poses(batch); poses.goes_on();) {
        double pose[16], held[DHGEN_GIVEN + 1], seed[DHGEN_DOF], q[DHGEN_DOF];
        const size_t i = poses.next();
        dhgen_load_pose<Number, ENTRIES>(batch.T, i, pose);
        dhgen_load_values<DHGEN_DOF>(batch.values, i, seed);
        if (DHGEN_GIVEN > 0)
            dhgen_load_values<DHGEN_GIVEN>(batch.free_joints, i, held);
        const int result = DHGEN_CALL(_ik_nearest)(pose, DHGEN_HELD(held) seed, q);
        if (poses.part == 0)
            batch.status[i] = (unsigned char)(result < 0 ? -result : result);
        for (int j = poses.part; j < DHGEN_DOF; j += poses.parts)
            batch.q[DHGEN_DOF * i + j] = (Number)q[j];
    }
}

/* The poses of joint values. */
template <class Number, int ENTRIES>
__global__ void __launch_bounds__(128) dhgen_poses(dhgen_batch<Number> batch)
{
    const size_t i = blockIdx.x * (size_t)blockDim.x + threadIdx.x;
    double values[DHGEN_DOF], T[16];
    if (i >= batch.n)
        return;
    dhgen_load_values<DHGEN_DOF>(batch.values, i, values);
    DHGEN_CALL(_fk)(values, T);
#pragma unroll
    for (int k = 0; k < ENTRIES; k++)
        batch.q[ENTRIES * i + k] = (Number)T[k];
}

/* The Jacobians of joint values, 6 x DHGEN_DOF. */
template <class Number, int ENTRIES>
__global__ void __launch_bounds__(128) dhgen_jacobians(dhgen_batch<Number> batch)
{
    enum { SIZE = 6 * DHGEN_DOF };
    const size_t i = blockIdx.x * (size_t)blockDim.x + threadIdx.x;
    double values[DHGEN_DOF], J[SIZE];
    if (i >= batch.n)
        return;
    dhgen_load_values<DHGEN_DOF>(batch.values, i, values);
    DHGEN_CALL(_jacobian)(values, J);
#pragma unroll
    for (int k = 0; k < SIZE; k++)
        batch.q[SIZE * i + k] = (Number)J[k];
}

#endif
