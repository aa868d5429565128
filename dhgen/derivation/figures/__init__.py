"""Drawings of an arm as SVG, made from its chain: the arm, an example's postures, its workspace.

| read      | what is in it                                                          |
|-----------|------------------------------------------------------------------------|
| figure    | a drawing with its name and its caption                                |
| sheet     | shapes on paper, their extent, and SVG out of them                     |
| view      | from where the arm is seen                                             |
| skeleton  | an arm at joint values as lines, axes and frames in space              |
| position  | the joint values at which the arm itself is drawn                      |
| places    | where on their axes joints are drawn                                   |
| symbols   | cylinders, boxes, arrows, frames and the ground                        |
| labels    | letters beside what they name, off each other and off lines            |
| arm       | the arm with its frames, axes and lengths                              |
| postures  | the solutions of the worked example, side by side                      |
| section   | what part of a plane a point of the arm reaches                        |
| outline   | the border of what a raster holds                                      |
| reach     | the point of the arm of which that is drawn                            |
| workspace | the section, drawn                                                     |
| svg       | shapes as SVG                                                          |
| tikz      | shapes as TikZ, for LaTeX                                              |
| all       | the figures of a derivation, and where they are shown                  |

Coordinates are rounded where they are printed, and what is decided by them is decided by rounded
ones: the same robot gives the same bytes on every machine.
"""
