"""A human right hand with the joints of the MANO hand model: three along each finger. Its ball joints are split into
hinges that turn as far as those of a hand do: two at each knuckle and at the base of the thumb, one elsewhere.

Root frame at the wrist: x out of the palm, y towards the thumb, z along the middle finger. A finger's frames have x out
of its pad and z along it.
"""

from math import radians

from hand_description import Hand, Joint, Link, Solid
from implicit_mesh import capsule, cone, cylinder, half_space, intersection, union

HAND_LENGTH, HAND_BREADTH = 0.190, 0.085

# ---- kinematics: positions and lengths as shares of the hand's length, those to the side (y) of its breadth

FINGERS = ["index", "middle", "ring", "little"]
KNUCKLES = {"index": (0.447, 0.251), "middle": (0.446, 0), "ring": (0.409, -0.206), "little": (0.368, -0.402)}  # z, y
CARPUS = {"index": (0.073, 0.126), "middle": (0.073, 0), "ring": (0.073, -0.129), "little": (0.073, -0.223)}
PHALANGES = {"index": (0.245, 0.143, 0.097), "middle": (0.266, 0.170, 0.108), "ring": (0.244, 0.165, 0.107),
             "little": (0.204, 0.117, 0.093)}
FAN = {"index": 3, "middle": 0, "ring": -4, "little": -10}  # degrees towards the thumb, fingers at rest

THUMB_BASE = (0.073, 0.196)
THUMB_SEGMENTS = (0.251, 0.196, 0.158)
THUMB_HEIGHT = 0.008  # m, of its base before the plane of the knuckles
THUMB_RADIAL = 40  # degrees between the thumb and the middle finger at rest, in the plane of the palm
THUMB_TWIST = 40  # degrees by which its pad is turned from the palm's side to the fingers'

# ranges in degrees
KNUCKLE_SIDEWAYS, KNUCKLE_FLEXION, MIDDLE_FLEXION, LAST_FLEXION = (-20, 20), (-20, 90), (0, 100), (0, 80)
THUMB_SWING, THUMB_SIDEWAYS, THUMB_KNUCKLE, THUMB_LAST = (-10, 70), (-20, 25), (-10, 55), (-15, 80)

# ---- shapes: millimetres. A segment's skin is round about its joints, so that it meets the next one in every pose.

RADII = {"index": (10.4, 9.5, 8.3, 7.2), "middle": (10.6, 9.8, 8.5, 7.4), "ring": (10.0, 9.2, 8.0, 7.0),
         "little": (8.9, 8.0, 7.1, 6.2)}  # at the three joints and the tip
THUMB_RADII = (12.0, 11.4, 10.2, 8.6)


def millimetres(share, whole=HAND_LENGTH):
    return 1000 * share * whole


def segment(length, near, far):
    """A phalanx between joints, fuller on the pad side."""
    pad = cone([0.3 * near, 0, 0.3 * length], [0.3 * far, 0, 0.68 * length], 0.84 * near, 0.86 * far)
    return union(cone([0, 0, 0], [0, 0, length], near, far), pad, 3)


def fingertip(length, near, far):
    """The last phalanx: a full pad, flatter where the nail is."""
    core = cone([0, 0, 0], [0, 0, length - far], near, far)
    pad = cone([0.32 * near, 0, 0.4 * length], [0.25 * far, 0, length - 1.1 * far], 0.86 * near, 0.86 * far)
    return intersection(union(core, pad, 3), half_space([-0.8 * far, 0, length - far], [-0.96, 0, 0.28]), 3)


def thumb_metacarpal(length):
    """The ball of the thumb moves with it."""
    ball = cone([4, -4, 10], [3, -3, 0.66 * length], 11.5, 10)
    return union(cone([0, 0, 0], [0, 0, length], THUMB_RADII[0], THUMB_RADII[1]), ball, 5)


def place(shares, x=0.0):
    """Millimetres in the root frame of (z, y) shares."""
    return [x, millimetres(shares[1], HAND_BREADTH), millimetres(shares[0])]


def palm():
    """Metacarpals from wrist to knuckles, webs between the fingers and to the thumb, the balls of both edges."""
    knuckles = [place(KNUCKLES[name]) for name in FINGERS]
    body = intersection(union(cylinder(2, [0, 10, 0], 19, 40, 4), cylinder(2, [0, -10, 0], 19, 40, 4), 8),
                        half_space([0, 0, -22], [0, 0, -1]), 4)
    for name, knuckle, radius in zip(FINGERS, knuckles, (12.2, 12.4, 11.8, 10.8)):
        body = union(body, cone(place(CARPUS[name]), knuckle, 14, radius), 9)
    for (_, y, z), (_, next_y, next_z) in zip(knuckles, knuckles[1:]):
        body = union(body, capsule([3, y, z + 9], [3, next_y, next_z + 9], 8), 7)
    body = union(body, cone([6, -20, 16], [7, -30, 50], 13, 11), 8)
    body = union(body, cone([7, 11, 15], [7, 20, 36], 13, 10), 8)
    return union(body, capsule([3, 22, 40], [4, 32, 50], 8), 8)


def phalanges(name, parts, lengths, radii):
    """Solids of a digit's phalanges; `radii` at each joint and the tip."""
    result = {}
    for part, length, near, far in zip(parts, lengths, radii, radii[1:]):
        reach = near + 5
        if part == "distal":
            solid = Solid(fingertip(length, near, far), [-reach] * 3, [reach, reach, length + 5], 1.9)
        else:
            solid = Solid(segment(length, near, far), [-reach] * 3, [reach, reach, length + far + 5], 2.6)
        result[f"{name}_{part}"] = solid
    return result


def solids():
    metacarpal, *lengths = map(millimetres, THUMB_SEGMENTS)
    result = {"palm": Solid(palm(), [-28, -58, -30], [36, 54, 112], 4.7),
              "thumb_metacarpal": Solid(thumb_metacarpal(metacarpal), [-20, -24, -20], [24, 20, 64], 2.9)}
    for name in FINGERS:
        result |= phalanges(name, ("proximal", "middle", "distal"), map(millimetres, PHALANGES[name]), RADII[name])
    return result | phalanges("thumb", ("proximal", "distal"), lengths, THUMB_RADII[1:])


SOLIDS = solids()

# ---- the hand


def hinge(name, parent, xyz, axis, limits, rpy=(0, 0, 0)):
    """Angles in degrees."""
    return Joint(name, parent, xyz, tuple(map(radians, rpy)), axis, *map(radians, limits))


def along(share):
    """The offset from a joint to the next, or to the tip."""
    return (0, 0, share * HAND_LENGTH)


def links(name, parts, joints):
    """A link for each joint, with its solid when it has one: knuckles lie inside the skin, tips are frames."""
    names = [f"{name}_{part}" for part in parts]
    return [Link(link, joint, link, "skin") if link in SOLIDS else Link(link, joint) for link, joint in zip(names, joints)]


def finger(name):
    z, y = KNUCKLES[name]
    proximal, middle, distal = map(along, PHALANGES[name])
    root, side, bend = (0, y * HAND_BREADTH, z * HAND_LENGTH), (-1, 0, 0), (0, 1, 0)
    joints = [
        hinge(f"{name}_mcp_abduction", "palm", root, side, KNUCKLE_SIDEWAYS, (-FAN[name], 0, 0)),
        hinge(f"{name}_mcp_flexion", f"{name}_knuckle", (0, 0, 0), bend, KNUCKLE_FLEXION),
        hinge(f"{name}_pip", f"{name}_proximal", proximal, bend, MIDDLE_FLEXION),
        hinge(f"{name}_dip", f"{name}_middle", middle, bend, LAST_FLEXION),
        Joint(f"{name}_tip_joint", f"{name}_distal", distal),
    ]
    return links(name, ("knuckle", "proximal", "middle", "distal", "tip"), joints)


def thumb():
    z, y = THUMB_BASE
    metacarpal, proximal, distal = map(along, THUMB_SEGMENTS)
    root, swing, side, bend = (THUMB_HEIGHT, y * HAND_BREADTH, z * HAND_LENGTH), (0, 0, -1), (1, 0, 0), (0, 1, 0)
    joints = [
        hinge("thumb_cmc_abduction", "palm", root, swing, THUMB_SWING),
        hinge("thumb_cmc_flexion", "thumb_base", (0, 0, 0), side, THUMB_SIDEWAYS, (-THUMB_RADIAL, 0, 0)),
        hinge("thumb_mcp", "thumb_metacarpal", metacarpal, bend, THUMB_KNUCKLE, (0, 0, -THUMB_TWIST)),
        hinge("thumb_ip", "thumb_proximal", proximal, bend, THUMB_LAST),
        Joint("thumb_tip_joint", "thumb_distal", distal),
    ]
    return links("thumb", ("base", "metacarpal", "proximal", "distal", "tip"), joints)


def hand():
    chains = {"palm": [Link("palm", None, "palm", "skin")]}
    chains |= {name: finger(name) for name in FINGERS} | {"thumb": thumb()}
    about = ("A human right hand. Root frame at the wrist: x out of the palm, y towards the thumb, z along the middle finger;\n"
             "     metres and radians.")
    return Hand("human_right", about, chains, SOLIDS)
