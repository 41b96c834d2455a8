"""The Shadow Dexterous Hand, right, with its forearm; joints and links have the maker's names.

Every link frame is parallel to the root's when all joints are at 0, except those of the thumb: x out of the palm, y
towards the index finger, z along the fingers. In the thumb's frames z runs along the thumb, and the pad looks to -y.
"""

from math import cos, pi, radians, sin, sqrt

from hand_description import Hand, Joint, Link, Solid
from hinge import on_barrel, with_barrel
from implicit_mesh import capsule, cone, cylinder, difference, half_space, intersection, round_box, turned, union

# ---- kinematics

WRIST = [("WRJ2", "forearm", "wrist", (0.01, 0, 0.21301), (-1, 0, 0), -30, 10),
         ("WRJ1", "wrist", "palm", (0, 0, 0.034), (0, 1, 0), -40, 28)]

KNUCKLES = {"FF": (0, 0.033, 0.095), "MF": (0, 0.011, 0.099), "RF": (0, -0.011, 0.095), "LF": (0, 0, 0.06589)}
SIDEWAYS = {"FF": (1, 0, 0), "MF": (1, 0, 0), "RF": (-1, 0, 0), "LF": (-1, 0, 0)}
FINGER_LENGTHS = [0.045, 0.025, 0.026]
ARCH_ORIGIN, ARCH_TILT = (0, -0.033, 0.02071), 0.9599  # of the little finger's metacarpal; its axis leans off y

THUMB_ROOT = ((0.00858, 0.034, 0.029), (-pi / 4, 0, 0))
THUMB_LENGTHS = [0.038, 0.032, 0.0275]

# ---- shapes: millimetres, in the frame of their link

BARREL, HALF_WIDTH = 7.0, 8.4


def phalanx(length, radius):
    """A round phalanx between two hinges, flat on the pad side."""
    body = cone([0, 0, -12], [0, 0, length + 12], radius + 0.4, radius - 0.6)
    body = intersection(body, half_space([radius - 1.5, 0, 0], [1, 0, 0]), 4)
    return with_barrel(on_barrel(body, BARREL), length, BARREL, HALF_WIDTH)


def distal(length, radius):
    """Ends in a dome 4 beyond the fingertip frame; the pad bulges."""
    core = cone([0, 0, -12], [-0.5, 0, length + 4 - radius], radius + 0.6, radius)
    pad = cone([1.2, 0, 11], [0.8, 0, length + 2 - radius], radius - 0.2, radius - 0.8)
    return on_barrel(union(core, pad, 3), BARREL)


def knuckle():
    """A barrel on a fork that turns sideways in the palm."""
    return union(cylinder(1, [0, 0, 0], BARREL, HALF_WIDTH, 2), round_box([-6, -7, -11], [6, 7, 0], 3), 3)


def thumb_base():
    """Turns about the thumb's length in the palm; carries a barrel."""
    return union(cylinder(1, [0, 0, 0], 8.5, 10, 2), cylinder(2, [0, 0, -8], 9.5, 5, 2), 3)


def thumb_proximal():
    """From the barrel of the base to a ridge that carries the hub, with a cushion on the pad side."""
    body = cone([0, 0, -12], [0, 0, 50], 12.0, 10.4)
    body = union(body, cone([0, -3, 12], [0, -2, 26], 10.5, 9.5), 4)
    body = on_barrel(body, 8.5)
    for side in (-1, 1):
        body = intersection(body, half_space([0, 0, 38], [0, side * 5 / 13, 12 / 13]), 2)
    return body


def thumb_hub():
    """A barrel about the axis of the next joint."""
    return cylinder(0, [0, 0, 0], 7.5, 9.6, 2)


def thumb_middle():
    """Turns to either side on the hub; ends in a hinge. Its pad looks to +x here, and is turned."""
    body = cone([0, 0, -12], [0, 0, 44], 10.6, 9.2)
    body = intersection(body, half_space([8.4, 0, 0], [1, 0, 0]), 4)
    for side in (-1, 1):
        body = intersection(body, half_space([0, 0, 0], [side * 5 / 13, 0, -12 / 13]), 2)
    body = difference(body, cylinder(1, [0, 0, 0], 8.1, 40, 1), 1)
    return with_barrel(body, 32, BARREL, HALF_WIDTH)


def palm():
    """Columns under three fingers, a heel, a cushion before the thumb, a barrel at the wrist."""
    slope = half_space([0, 43, 56], [0, sqrt(0.5), -sqrt(0.5)])  # room for the thumb, which leaves at 45 degrees
    columns = union(round_box([-13, -21.5, 10], [11, 24, 85], 7), round_box([-13, 0.5, 60], [11, 21.5, 89], 7), 5)
    columns = union(columns, intersection(round_box([-13, 0, 24], [11, 43, 85], 7), slope, 7), 6)
    heel = round_box([-13, -43, 6], [11, 25, 24], 7)
    cushion = cone([3, 2, 20], [4, 22, 19], 9, 11)
    wrist = union(cylinder(1, [0, 0, 0], 10.5, 22, 2), round_box([-10.5, -22, 0], [10.5, 22, 24], 3), 2)
    return union(union(union(columns, heel, 7), cushion, 8), wrist, 3)


def metacarpal():
    """The edge of the palm under the little finger, which folds towards the thumb."""
    return union(round_box([-12, -10, 5], [10, 10, 56], 7), capsule([0, 0, 3], [0, 0, 20], 8), 3)


def wrist():
    """A barrel about x in the forearm, a cradle for the palm's."""
    block = union(round_box([-11, -29, 4], [11, 29, 34], 5), cylinder(1, [0, 0, 34], 11, 29, 3), 2)
    block = difference(block, round_box([-30, -23, 27], [30, 23, 60], 3), 2)
    return union(difference(block, cylinder(1, [0, 0, 34], 11.5, 23, 1), 1), cylinder(0, [0, 0, 0], 12, 14, 2), 4)


def forearm():
    """The housing of the motors, tapering to a seat for the barrel of the wrist."""
    body = union(cylinder(2, [0, 0, 55], 64, 55, 12), cone([0, 0, 80], [7, 0, 172], 58, 34), 20)
    body = intersection(body, half_space([0, 0, 197], [0, 0, 1]), 8)
    return union(body, round_box([-10, -13, 170], [30, 13, 208], 5), 4)


SOLIDS = {
    "forearm": Solid(forearm(), [-80, -80, -16], [80, 80, 224], 8.8),
    "wrist": Solid(wrist(), [-20, -36, -18], [20, 36, 52], 3.2),
    "palm": Solid(palm(), [-20, -50, -17], [30, 50, 98], 4.2),
    "metacarpal": Solid(metacarpal(), [-18, -16, -11], [16, 16, 63], 3.0),
    "knuckle": Solid(knuckle(), [-11, -13, -16], [11, 13, 12], 2.0),
    "finger_proximal": Solid(phalanx(45, 9.5), [-14, -14, -12], [14, 14, 58], 2.2),
    "finger_middle": Solid(phalanx(25, 9.0), [-14, -14, -12], [14, 14, 38], 2.0),
    "finger_distal": Solid(distal(26, 7.4), [-14, -14, -12], [14, 14, 36], 1.8),
    "thumb_base": Solid(thumb_base(), [-14, -15, -18], [14, 15, 14], 2.2),
    "thumb_proximal": Solid(thumb_proximal(), [-18, -18, -16], [18, 18, 54], 2.7),
    "thumb_hub": Solid(thumb_hub(), [-14, -12, -12], [14, 12, 12], 2.0),
    "thumb_middle": Solid(turned(thumb_middle()), [-15, -15, -16], [15, 15, 45], 2.3),
    "thumb_distal": Solid(turned(distal(27.5, 8.6)), [-14, -14, -13], [14, 14, 38], 2.0),
}

# ---- the hand; limits in degrees


def revolute(name, parent, xyz, axis, lower, upper, rpy=(0, 0, 0)):
    return Joint(name, parent, xyz, rpy, axis, radians(lower), radians(upper))


def finger(name):
    """Two joints at the knuckle, two along the finger, a fixed tip frame."""
    link, parent = name.lower(), "palm" if name != "LF" else "lfmetacarpal"
    proximal, middle, distal = ((0, 0, length) for length in FINGER_LENGTHS)
    bend = (0, 1, 0)
    joints = [
        revolute(f"{name}J4", parent, KNUCKLES[name], SIDEWAYS[name], -20, 20),
        revolute(f"{name}J3", f"{link}knuckle", (0, 0, 0), bend, -15, 90),
        revolute(f"{name}J2", f"{link}proximal", proximal, bend, 0, 90),
        revolute(f"{name}J1", f"{link}middle", middle, bend, 0, 90),
    ]
    return [
        Link(f"{link}knuckle", joints[0], "knuckle", "joint"),
        Link(f"{link}proximal", joints[1], "finger_proximal", "phalanx"),
        Link(f"{link}middle", joints[2], "finger_middle", "phalanx"),
        Link(f"{link}distal", joints[3], "finger_distal", "rubber"),
        Link(f"{link}tip", Joint(f"{name}tip", f"{link}distal", distal)),
    ]


def thumb():
    root, turn = THUMB_ROOT
    proximal, middle, distal = ((0, 0, length) for length in THUMB_LENGTHS)
    return [
        Link("thbase", revolute("THJ5", "palm", root, (0, 0, -1), -60, 60, turn), "thumb_base", "joint"),
        Link("thproximal", revolute("THJ4", "thbase", (0, 0, 0), (0, 1, 0), 0, 70), "thumb_proximal", "phalanx"),
        Link("thhub", revolute("THJ3", "thproximal", proximal, (0, 1, 0), -12, 12), "thumb_hub", "joint"),
        Link("thmiddle", revolute("THJ2", "thhub", (0, 0, 0), (1, 0, 0), -40, 40), "thumb_middle", "phalanx"),
        Link("thdistal", revolute("THJ1", "thmiddle", middle, (1, 0, 0), -15, 90), "thumb_distal", "rubber"),
        Link("thtip", Joint("THtip", "thdistal", distal)),
    ]


def hand():
    arch = revolute("LFJ5", "palm", ARCH_ORIGIN, (0, cos(ARCH_TILT), sin(ARCH_TILT)), 0, 45)
    chains = {"forearm, wrist and palm": [Link("forearm", None, "forearm", "shell")]}
    chains["forearm, wrist and palm"] += [
        Link(link, revolute(name, parent, xyz, axis, lower, upper), link, "joint" if link == "wrist" else "shell")
        for name, parent, link, xyz, axis, lower, upper in WRIST]
    chains |= {"index": finger("FF"), "middle": finger("MF"), "ring": finger("RF")}
    chains["little finger"] = [Link("lfmetacarpal", arch, "metacarpal", "shell")] + finger("LF")
    chains["thumb"] = thumb()
    about = ("A Shadow Dexterous right hand with its forearm. Root frame: x out of the palm, y towards the index finger,\n"
             "     z along the fingers; metres and radians.")
    return Hand("shadow_right", about, chains, SOLIDS, effort=2, velocity=2)
