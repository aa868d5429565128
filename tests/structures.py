"""One arm of every structure, for tests that take seconds with each."""

STRUCTURES = (
    "cartesian",
    "concurrent_345",
    "cuspidal_3r",
    "fanuc_crx10ia",
    "franka_panda",
    "kuka_iiwa14",
    "kuka_iiwa14_arm_angle",
    "kuka_kr6_r900",
    "kuka_youbot",
    "olson_pprrrr",
    "planar_rr",
    "planar_rrrr",
    "puma560",
    "scara",
    "scorbot_pointing",
    "spherical_wrist_general_arm",
    "stanford",
    "ur5",
    "wrist_oblique",
)
