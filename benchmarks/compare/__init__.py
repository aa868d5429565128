"""Two folders of generated files against each other: are answers the same, and as fast?

poses      the joint values and poses that both are asked for
libraries  the C of a folder, compiled and called (driver.c)
modules    the Python of a folder, called in a process of its own
answers    what differs between the answers of two
timing     ratios of CPU time, in processes that each have fresh copies
__main__   the command line
"""
