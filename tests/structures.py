"""One arm of every structure, for tests that take seconds with each."""

STRUCTURES = (
    "cartesian",
    "cuspidal_3r",
    "fanuc_crx10ia",
    "franka_panda",
    "kuka_iiwa14_arm_angle",
    "planar_rrrr",
    "puma560",
    "scara",
    "scorbot_pointing",
    "spherical_wrist_general_arm",
    "stanford",
    "ur5",
)

# Those whose Python numba compiles in the tests, at up to half a minute each; the Python of the
# others runs there without it.
COMPILED = ("scara", "ur5")
COMPILED_SLOWLY = ("fanuc_crx10ia", "scorbot_pointing")

# Those of the general algorithm whose programs are run: numba compiles it once a process, and a C
# compiler what they share.
GENERAL = frozenset({"close_pair", "fanuc_crx10ia", "offset_stop"})
