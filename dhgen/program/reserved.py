"""Names of the emitted code's own variables and functions, in any target: values get others."""

RESERVED = frozenset(
    {
        "T",
        "J",
        "R",
        "q",
        "q_seed",
        "q_free",
        "seed",
        "free_joints",
        "status",
        "row",
        "pose",
        "joint",
    }
    | {"math", "np", "njit", "prange", "fk", "ik", "ik_all", "ik_into", "ik_batch", "jacobian"}
    | {"solve", "wrap", "turn", "turned", "inside", "misfit", "straighten", "attempt", "lowest"}
    | {"highest", "weight", "revolute", "read_pose", "choose_again", "i1", "i2", "i3", "i4"}
    | {"NAME", "DOF", "JOINT_TYPES", "JOINT_LIMITS", "BRANCHES", "MAX_SOLUTIONS", "FREE_JOINTS"}
    | {"OK", "UNREACHABLE", "FREE_JOINT", "OUT_OF_LIMITS", "INVALID_POSE", "LOST", "Unreachable"}
)
