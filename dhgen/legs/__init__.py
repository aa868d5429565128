"""The file of a parallel robot: its legs, and how many freedoms they leave its platform.

Read `robot`, what such a file describes; `mobility`, its freedoms; `read`, from the file to that.
"""
