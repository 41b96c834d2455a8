"""The Allegro hand, right and left. Root frame: x out of the palm, z along the fingers; y towards the index finger of the
right hand, away from it on the left."""

from hand_description import Hand, Joint, Link, Solid
from hinge import on_barrel, with_barrel
from implicit_mesh import capsule, cylinder, half_space, intersection, round_box, union

# ---- kinematics of the right hand

FINGER_ROOTS = {"index": ((0, 0.0435, -0.001542), (-0.0872664626, 0, 0)),
                "middle": ((0, 0, 0.0007), (0, 0, 0)),
                "ring": ((0, -0.0435, -0.001542), (0.0872664626, 0, 0))}
FINGER_JOINTS = [((0, 0, 1), -0.47, 0.47), ((0, 1, 0), -0.196, 1.61), ((0, 1, 0), -0.174, 1.709), ((0, 1, 0), -0.227, 1.618)]
FINGER_OFFSETS = [(0, 0, 0.0164), (0, 0, 0.054), (0, 0, 0.0384), (0, 0, 0.0387)]  # from a joint to the next, or to the tip

THUMB_ROOT = ((-0.0182, 0.019333, -0.045987), (0, -1.6580627893, -1.5707963268))
THUMB_JOINTS = [((-1, 0, 0), 0.263, 1.396), ((0, 0, 1), -0.105, 1.163), ((0, 1, 0), -0.189, 1.644), ((0, 1, 0), -0.162, 1.719)]
THUMB_OFFSETS = [(-0.027, 0.005, 0.0399), (0, 0, 0.0177), (0, 0, 0.0514), (0, 0, 0.0543)]

# ---- shapes of the right hand: millimetres, in the frame of their link; +x is the pad side

HALF_X, HALF_Y = 9.8, 13.6  # a phalanx is 19.6 x 27.2 across
BARREL = 8.0
TIP_RADIUS, TIP_LENGTH = 12.0, 23.0


def beam(z_low, z_high):
    """The cross-section of a phalanx: flat on the pad side, domed on the back."""
    box = round_box([-HALF_X, -HALF_Y, z_low], [HALF_X, HALF_Y, z_high], 4)
    dome = cylinder(2, [4, 0, (z_low + z_high) / 2], 15.4, (z_high - z_low) / 2 + 20, 4)
    return intersection(box, dome, 4)


def base(length):
    """First link of a finger: turns about z on a short spigot, carries a barrel."""
    pillar = intersection(beam(-8, length + 20), half_space([0, 0, 0], [0, 0, -1]), 2)
    return union(with_barrel(pillar, length, BARREL, HALF_Y - 0.8), cylinder(2, [0, 0, 0], 7, 3.5, 1), 1)


def phalanx(length):
    return with_barrel(on_barrel(beam(-20, length + 20), BARREL), length, BARREL, HALF_Y - 0.8)


def distal(length):
    """Last link: ends where the fingertip begins."""
    return intersection(on_barrel(beam(-20, length), BARREL), half_space([0, 0, length - TIP_LENGTH], [0, 0, 1]), 2.5)


def tip():
    """Rubber fingertip, its end at the origin: a dome with a flattened pad."""
    dome = capsule([0, 0, -TIP_RADIUS], [0, 0, -TIP_RADIUS - 30], TIP_RADIUS)
    dome = intersection(dome, half_space([0, 0, -TIP_LENGTH], [0, 0, -1]), 2.5)
    return intersection(dome, half_space([10.8, 0, 0], [1, 0, 0]), 3)


def thumb_mount(y):
    """First link of the thumb: a barrel about x in the palm's pocket, an arm to the second joint, `y` to the side."""
    barrel = cylinder(0, [-17.5, 0, 0], 8.5, 17, 2)
    arm = round_box([-36.8, y - 12, -2], [-3, y + 12.5, 39.3], 6)
    arm = intersection(arm, half_space([-3, 0, 18], [0.894, 0, 0.447]), 8)
    arm = intersection(arm, half_space([0, y + 12.5, 16], [0, 0.8, -0.6]), 8)
    return union(barrel, arm, 4)


def palm():
    """Finger mounts above, heel below on the little-finger side, a pocket for the thumb beside it, a wrist plate."""
    knuckles = round_box([-29.5, -56.5, -46], [11.3, 56.5, -1.5], 5.5)
    heel = round_box([-29.5, -52, -92], [11.3, -3, -30], 5.5)
    plate = round_box([-29.5, -42, -95], [11.3, 30.4, -84.5], 4)
    return union(union(knuckles, heel, 5), plate, 3)


def solids(mirrored):
    y = -5 if mirrored else 5  # of the second thumb joint in its parent, on the hand before mirroring
    return {
        "palm": Solid(palm(), [-38, -65, -103], [20, 65, 8], 5.0, mirrored),
        "finger_base": Solid(base(16.4), [-13, -17, -7], [13, 17, 28], 2.2),
        "finger_proximal": Solid(phalanx(54.0), [-13, -17, -4], [13, 17, 66], 2.5),
        "finger_middle": Solid(phalanx(38.4), [-13, -17, -4], [13, 17, 50], 2.3),
        "finger_distal": Solid(distal(38.7), [-13, -17, -4], [13, 17, 20], 2.0),
        "thumb_mount": Solid(thumb_mount(y), [-42, y - 18, -13], [5, y + 19, 46], 3.0, mirrored),
        "thumb_base": Solid(base(17.7), [-13, -17, -7], [13, 17, 30], 2.2),
        "thumb_proximal": Solid(phalanx(51.4), [-13, -17, -4], [13, 17, 64], 2.5),
        "thumb_distal": Solid(distal(54.3), [-13, -17, -4], [13, 17, 36], 2.3),
        "fingertip": Solid(tip(), [-15, -15, -27], [15, 15, 4], 2.2),
    }


# ---- the hand


def digit(name, root, joints, offsets, solids):
    """Four joints in a row and a fixed tip frame."""
    links, parent = [], "palm"
    for i, (axis, lower, upper) in enumerate(joints):
        xyz, rpy = root if i == 0 else (offsets[i - 1], (0, 0, 0))
        joint = Joint(f"{name}_joint_{i}", parent, xyz, rpy, axis, lower, upper)
        parent = f"{name}_link_{i}"
        links.append(Link(parent, joint, solids[i], "joint" if i == 0 or solids[i].endswith("base") else "phalanx"))
    return links + [Link(f"{name}_tip", Joint(f"{name}_tip_joint", parent, offsets[-1]), "fingertip", "rubber")]


def flip(vector):
    """A position in the mirror y -> -y."""
    return (vector[0], -vector[1], vector[2])


def flip_turn(vector):
    """A rotation in the mirror y -> -y: an axis, or roll, pitch and yaw."""
    return (-vector[0], vector[1], -vector[2])


def hand(side):
    left = side == "left"
    thumb_root, thumb_joints, finger_roots = THUMB_ROOT, THUMB_JOINTS, FINGER_ROOTS
    if left:  # the joints of the fingers turn as on the right hand, those of the thumb are mirrored, all but one published number
        finger_roots = {name: (flip(xyz), flip_turn(rpy)) for name, (xyz, rpy) in FINGER_ROOTS.items()}
        thumb_root = (flip(THUMB_ROOT[0]), flip_turn(THUMB_ROOT[1]))
        thumb_joints = [(flip_turn(axis), lower, upper) for axis, lower, upper in THUMB_JOINTS]
    chains = {"palm": [Link("palm", None, "palm", "shell")]}
    for name, root in finger_roots.items():
        chains[name] = digit(name, root, FINGER_JOINTS, FINGER_OFFSETS,
                             ["finger_base", "finger_proximal", "finger_middle", "finger_distal"])
    chains["thumb"] = digit("thumb", thumb_root, thumb_joints, THUMB_OFFSETS,
                            ["thumb_mount", "thumb_base", "thumb_proximal", "thumb_distal"])
    about = (f"An Allegro {side} hand. Root frame: x out of the palm, y {'away from' if left else 'towards'} the index finger, "
             "z along the fingers; metres and radians.")
    return Hand(f"allegro_{side}", about, chains, solids(left))
