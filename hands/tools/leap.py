"""The LEAP hand, right.

Every link frame is parallel to the root's when all joints are at 0, except that of the thumb's tip: x out of the palm,
y towards the index finger, z along the fingers.
"""

from math import pi

from hand_description import Hand, Joint, Link, Solid
from implicit_mesh import capsule, cylinder, half_space, intersection, round_box, union

# ---- kinematics

FINGER_ROOTS = {"index": (0.0187, 0.061, 0.091), "middle": (0.0187, 0.0156, 0.0909), "ring": (0.0187, -0.0298, 0.09091)}
FINGER_JOINTS = [((0, 1, 0), -0.314, 2.23), ((1, 0, 0), -1.047, 1.047), ((0, 1, 0), -0.506, 1.885), ((0, 1, 0), -0.366, 2.042)]
FINGER_OFFSETS = [(-0.0122, -0.0145, 0.0381), (0.013, 0.0143, 0.015), (0, -0.0002, 0.0361)]  # from a joint to the next
FINGER_TIP = ((0, -0.015, 0.048), (0, 0, 0))

THUMB_ROOT = (0.0216, 0.0368, 0.0287)
THUMB_JOINTS = [((0, 0, -1), -0.349, 2.094), ((0, 1, 0), -0.47, 2.443), ((1, 0, 0), -1.2, 1.9), ((1, 0, 0), -1.34, 1.88)]
THUMB_OFFSETS = [(0, 0.0143, -0.013), (-0.0145, 0.017, 0), (-0.0002, 0.0466, 0)]
THUMB_TIP = ((0.015, 0.06, 0), (0, -pi / 2, -pi / 2))  # z along the thumb, x out of its pad

# ---- shapes: millimetres, in the frame of their link. A servo is a box of about 22 x 26 x 34 with a horn on either side of
# its axis; the next link is a bracket on the two horns.


def servo(low, high, axis, horn):
    """The box low..high; its horns stand 1.5 out of it along coordinate `axis`, about the point `horn`."""
    centre = list(horn)
    centre[axis] = (low[axis] + high[axis]) / 2
    return union(round_box(low, high, 2), cylinder(axis, centre, 7.5, (high[axis] - low[axis]) / 2 + 1.5, 1), 1)


def cheek(y_low, y_high, z):
    """Side of a bracket about the y axis: a plate with a round end at the joint, reaching up to z."""
    plate = round_box([-8.5, y_low, 0], [8.5, y_high, z], 1.5)
    return union(plate, cylinder(1, [0, (y_low + y_high) / 2, 0], 8.5, (y_high - y_low) / 2, 1.5), 1)


def bracket(z):
    """Two cheeks on the horns of the servo before it, which is 29 wide, and a bar across above it."""
    sides = union(cheek(0, 3.5, z + 6), cheek(-33, -29.5, z + 6), 1)
    return union(sides, round_box([-8.5, -33, z], [8.5, 3.5, z + 6], 1.5), 2)


def finger_first():
    """A bracket whose bar reaches back to the servo that turns the finger sideways."""
    bar = round_box([-40, -33, 14], [8.5, 3.5, 20.5], 2)
    side_servo = servo([-40, -25, 16], [-13.5, -4, 60], 0, [0, -14.5, 38.1])
    return union(union(bracket(14), bar, 2), side_servo, 2)


def finger_second():
    return servo([1.5, -13, -9], [22, 13, 24.5], 1, [13, 0, 15])


def finger_third():
    return union(bracket(16), servo([-24.5, -28, 18], [9.5, -2, 45.5], 1, [0, 0, 36.1]), 2)


def finger_last():
    """A bracket that carries the fingertip."""
    return union(bracket(16), round_box([-9, -26, 18], [8, -4, 31], 3), 5)


def fingertip():
    """Rubber, its end 1.5 beyond the origin: a dome with a flattened pad."""
    dome = union(capsule([-1.5, -1.5, -9], [-1.5, -1.5, -25], 10.5), capsule([-1.5, 1.5, -9], [-1.5, 1.5, -25], 10.5), 3)
    dome = intersection(dome, half_space([0, 0, -20], [0, 0, -1]), 2)
    return intersection(dome, half_space([8, 0, 0], [1, 0, 0]), 3)


def thumb_first():
    """A servo that hangs below its first joint."""
    vertical = cylinder(2, [0, 0, -6], 7.5, 6, 1)
    return union(servo([-24, -13, -23.5], [9.5, 12.8, -2], 1, [0, 0, -13]), vertical, 1)


def thumb_second():
    """A plate on the horn about y, two arms to the horns about x."""
    plate = round_box([-18, 0, -9], [18, 4, 9], 1.5)
    arms = [union(round_box([x, 0, -9], [x + 3.5, 17, 9], 1.5), cylinder(0, [x + 1.75, 17, 0], 9, 1.75, 1.5), 1)
            for x in (-18, 14.5)]
    return union(union(plate, arms[0], 1.5), arms[1], 1.5)


def thumb_third():
    """A servo between the arms, and a bracket on to the last joint."""
    body = servo([2, -9.5, -11], [27, 24, 9.5], 0, [0, 0, 0])
    bar = round_box([-3.5, 23, -8.5], [32.5, 29, 8.5], 1.5)
    arms = [union(round_box([x, 23, -8.5], [x + 3.5, 46.6, 8.5], 1.5), cylinder(0, [x + 1.75, 46.6, 0], 8.5, 1.75, 1.5), 1)
            for x in (-3.5, 29)]
    return union(union(union(body, bar, 2), arms[0], 1.5), arms[1], 1.5)


def thumb_last():
    """The last servo and a stem to the fingertip."""
    return union(servo([2, -9.5, -11], [27, 24, 9.5], 0, [0, 0, 0]), round_box([4, 20, -9], [26, 43, 8], 3), 4)


def palm():
    """A box with three servos above, a heel on the little-finger side, the thumb's servo hanging beside it."""
    body = round_box([-11, -58, 40], [33, 62, 66], 4)
    body = union(body, round_box([-11, -50, -2], [33, 8, 50], 4), 4)
    body = union(body, round_box([-11, -50, -2], [-4, 50, 50], 3), 3)
    for y in (46.5, 1.1, -44.3):
        body = union(body, servo([-6, y - 13, 60], [28, y + 13, 100], 1, [18.7, 0, 91]), 2)
    return union(body, cylinder(2, [21.6, 36.8, 36], 7.5, 7, 1), 1)


SOLIDS = {
    "palm": Solid(palm(), [-16, -63, -7], [38, 67, 105], 5.6),
    "finger_first": Solid(finger_first(), [-45, -38, -13], [13, 8, 65], 2.75),
    "finger_second": Solid(finger_second(), [-3, -18, -14], [27, 18, 29], 2.4),
    "finger_third": Solid(finger_third(), [-29, -38, -13], [14, 8, 50], 2.8),
    "finger_last": Solid(finger_last(), [-14, -38, -13], [13, 8, 36], 2.5),
    "fingertip": Solid(fingertip(), [-16, -17, -24], [12, 17, 6], 2.0),
    "thumb_first": Solid(thumb_first(), [-29, -18, -28], [14, 18, 5], 2.4),
    "thumb_second": Solid(thumb_second(), [-22, -4, -13], [22, 30, 13], 2.2),
    "thumb_third": Solid(thumb_third(), [-8, -14, -16], [37, 60, 14], 2.8),
    "thumb_last": Solid(thumb_last(), [-4, -14, -16], [32, 48, 14], 2.8),
}

# ---- the hand


def digit(name, root, joints, offsets, tip, solids, colours):
    """Four joints in a row and a fixed tip frame."""
    links, parent = [], "palm"
    for i, (axis, lower, upper) in enumerate(joints):
        xyz = root if i == 0 else offsets[i - 1]
        joint = Joint(f"{name}_joint_{i}", parent, xyz, (0, 0, 0), axis, lower, upper)
        parent = f"{name}_link_{i}"
        links.append(Link(parent, joint, solids[i], colours[i]))
    return links + [Link(f"{name}_tip", Joint(f"{name}_tip_joint", parent, *tip), "fingertip", "rubber")]


def hand():
    chains = {"palm": [Link("palm", None, "palm", "print")]}
    for name, root in FINGER_ROOTS.items():
        chains[name] = digit(name, root, FINGER_JOINTS, FINGER_OFFSETS, FINGER_TIP,
                             ["finger_first", "finger_second", "finger_third", "finger_last"],
                             ["phalanx", "motor", "phalanx", "print"])
    chains["thumb"] = digit("thumb", THUMB_ROOT, THUMB_JOINTS, THUMB_OFFSETS, THUMB_TIP,
                            ["thumb_first", "thumb_second", "thumb_third", "thumb_last"],
                            ["motor", "print", "phalanx", "motor"])
    about = ("A LEAP right hand. Root frame: x out of the palm, y towards the index finger, z along the fingers;\n"
             "     metres and radians.")
    return Hand("leap_right", about, chains, SOLIDS, effort=0.95, velocity=8.48)
