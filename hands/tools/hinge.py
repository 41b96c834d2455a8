"""A hinge about the y axis between two links of a finger: a barrel on the one, the cut that turns on it on the other.

The planes leave room for the second link to close, towards +x, by 97 degrees and to open by 13.
"""

from implicit_mesh import cylinder, difference, half_space, intersection, union

CLEARANCE = 0.6


def with_barrel(body, z, radius, half_width):
    """`body` ends in a hinge barrel at height z."""
    body = intersection(body, half_space([0, 0, z], [0.743, 0, 0.669]), 2)
    body = intersection(body, half_space([0, 0, z], [-0.174, 0, 0.985]), 2)
    return union(body, cylinder(1, [0, 0, z], radius, half_width, 2), 1.5)


def on_barrel(body, radius):
    """`body` turns on a barrel of this radius at the origin."""
    body = intersection(body, half_space([0, 0, 0], [0.743, 0, -0.669]), 2)
    body = intersection(body, half_space([0, 0, 0], [-0.342, 0, -0.94]), 2)
    return difference(body, cylinder(1, [0, 0, 0], radius + CLEARANCE, 40, 1), 1)
