#!/usr/bin/env python3
"""Writes hands/allegro_right: the URDF and the link meshes of an Allegro right hand.

    make_allegro_right.py            write the files
    make_allegro_right.py --check    write nothing; exit 1 when a committed file differs

The kinematic numbers are facts about the hand; the shapes are modelled here. See hands/README.md.
"""

import argparse
import pathlib
import sys

import numpy as np

from implicit_mesh import capsule, check_closed, cylinder, difference, half_space, intersection, mesh, round_box, union

FOLDER = pathlib.Path(__file__).resolve().parent.parent / "allegro_right"

# ---- kinematics: metres and radians; x out of the palm, y towards the index finger, z along the fingers

# finger -> origin of its first joint in the palm: xyz, rpy
FINGER_ROOTS = {"index": ("0 0.0435 -0.001542", "-0.0872664626 0 0"),
                "middle": ("0 0 0.0007", "0 0 0"),
                "ring": ("0 -0.0435 -0.001542", "0.0872664626 0 0")}
# axis, lower and upper limit of joints 0 to 3
FINGER_JOINTS = [("0 0 1", -0.47, 0.47), ("0 1 0", -0.196, 1.61), ("0 1 0", -0.174, 1.709), ("0 1 0", -0.227, 1.618)]
FINGER_LENGTHS = [0.0164, 0.054, 0.0384, 0.0387]  # of links 0 to 3, from joint to next joint or to the tip

THUMB_ROOT = ("-0.0182 0.019333 -0.045987", "0 -1.6580627893 -1.5707963268")
THUMB_JOINTS = [("-1 0 0", 0.263, 1.396), ("0 0 1", -0.105, 1.163), ("0 1 0", -0.189, 1.644), ("0 1 0", -0.162, 1.719)]
THUMB_SECOND_JOINT = "-0.027 0.005 0.0399"
THUMB_LENGTHS = [None, 0.0177, 0.0514, 0.0543]

EFFORT, VELOCITY = 10, 3.14

COLOURS = {"shell": "0.17 0.19 0.22 1", "joint": "0.42 0.45 0.49 1", "phalanx": "0.24 0.27 0.31 1", "rubber": "0.92 0.9 0.85 1"}

# ---- shapes: millimetres, in the frame of their link; +x is the pad side

HALF_X, HALF_Y = 9.8, 13.6          # a phalanx is 19.6 x 27.2 across
BARREL, CLEARANCE = 8.0, 0.6        # hinge barrel of a link, gap to the next link that turns on it
TIP_RADIUS, TIP_LENGTH = 12.0, 23.0


def beam(z_low, z_high):
    """The cross-section of a phalanx: flat on the pad side, domed on the back."""
    box = round_box([-HALF_X, -HALF_Y, z_low], [HALF_X, HALF_Y, z_high], 4)
    dome = cylinder(2, [4, 0, (z_low + z_high) / 2], 15.4, (z_high - z_low) / 2 + 20, 4)
    return intersection(box, dome, 4)


def with_barrel(body, z):
    """`body` ends in a hinge barrel at height z. Room is left for the next link to close by 97 and to open by 13 degrees."""
    body = intersection(body, half_space([0, 0, z], [0.743, 0, 0.669]), 2)
    body = intersection(body, half_space([0, 0, z], [-0.174, 0, 0.985]), 2)
    return union(body, cylinder(1, [0, 0, z], BARREL, HALF_Y - 0.8, 2), 1.5)


def on_barrel(body):
    """`body` turns on the barrel of the link before it, about the y axis."""
    body = intersection(body, half_space([0, 0, 0], [0.743, 0, -0.669]), 2)
    body = intersection(body, half_space([0, 0, 0], [-0.342, 0, -0.94]), 2)
    return difference(body, cylinder(1, [0, 0, 0], BARREL + CLEARANCE, 40, 1), 1)


def base(length):
    """First link of a finger: turns about z on a short spigot, carries a barrel."""
    pillar = intersection(beam(-8, length + 20), half_space([0, 0, 0], [0, 0, -1]), 2)
    return union(with_barrel(pillar, length), cylinder(2, [0, 0, 0], 7, 3.5, 1), 1)


def phalanx(length):
    return with_barrel(on_barrel(beam(-20, length + 20)), length)


def distal(length):
    """Last link: ends where the fingertip begins."""
    return intersection(on_barrel(beam(-20, length)), half_space([0, 0, length - TIP_LENGTH], [0, 0, 1]), 2.5)


def tip():
    """Rubber fingertip, its end at the origin: a dome with a flattened pad."""
    dome = capsule([0, 0, -TIP_RADIUS], [0, 0, -TIP_RADIUS - 30], TIP_RADIUS)
    dome = intersection(dome, half_space([0, 0, -TIP_LENGTH], [0, 0, -1]), 2.5)
    return intersection(dome, half_space([10.8, 0, 0], [1, 0, 0]), 3)


def thumb_mount():
    """First link of the thumb: a barrel about x in the palm's pocket, an arm to the second joint."""
    barrel = cylinder(0, [-17.5, 0, 0], 8.5, 17, 2)
    arm = round_box([-36.8, -7, -2], [-3, 17.5, 39.3], 6)
    arm = intersection(arm, half_space([-3, 0, 18], [0.894, 0, 0.447]), 8)
    arm = intersection(arm, half_space([0, 17.5, 16], [0, 0.8, -0.6]), 8)
    return union(barrel, arm, 4)


def palm():
    """Finger mounts above, heel below on the little-finger side, a pocket for the thumb beside it, a wrist plate."""
    knuckles = round_box([-29.5, -56.5, -46], [11.3, 56.5, -1.5], 5.5)
    heel = round_box([-29.5, -52, -92], [11.3, -3, -30], 5.5)
    plate = round_box([-29.5, -42, -95], [11.3, 30.4, -84.5], 4)
    return union(union(knuckles, heel, 5), plate, 3)


# name -> shape, meshing box, cell size
SHAPES = {
    "palm": (palm(), [-38, -65, -103], [20, 65, 8], 5.0),
    "finger_base": (base(16.4), [-13, -17, -7], [13, 17, 28], 2.2),
    "finger_proximal": (phalanx(54.0), [-13, -17, -4], [13, 17, 66], 2.5),
    "finger_middle": (phalanx(38.4), [-13, -17, -4], [13, 17, 50], 2.3),
    "finger_distal": (distal(38.7), [-13, -17, -4], [13, 17, 20], 2.0),
    "thumb_mount": (thumb_mount(), [-42, -13, -13], [5, 24, 46], 3.0),
    "thumb_base": (base(17.7), [-13, -17, -7], [13, 17, 30], 2.2),
    "thumb_proximal": (phalanx(51.4), [-13, -17, -4], [13, 17, 64], 2.5),
    "thumb_distal": (distal(54.3), [-13, -17, -4], [13, 17, 36], 2.3),
    "fingertip": (tip(), [-15, -15, -27], [15, 15, 4], 2.2),
}


def obj_text(name):
    shape, low, high, cell = SHAPES[name]
    vertices, triangles = mesh(shape, low, high, cell)
    vertices = np.round(vertices, 3) + 0.0  # micrometres; no negative zero
    check_closed(vertices, triangles)
    lines = [f"# {name}: metres, written by make_allegro_right.py", f"o {name}"]
    lines += ["v %.6f %.6f %.6f" % tuple(v / 1000) for v in vertices]
    lines += ["f %d %d %d" % tuple(t + 1) for t in triangles]
    return "\n".join(lines).replace("-0.000000", "0.000000") + "\n"


# ---- URDF

def link_text(name, shape, colour):
    return f"""
  <link name="{name}">
    <visual>
      <geometry><mesh filename="meshes/{shape}.obj"/></geometry>
      <material name="{colour}"/>
    </visual>
    <collision>
      <geometry><mesh filename="meshes/{shape}.obj"/></geometry>
    </collision>
  </link>"""


def joint_text(name, parent, child, xyz, rpy, motion):
    lines = [f'  <joint name="{name}" type="{"revolute" if motion else "fixed"}">',
             f'    <parent link="{parent}"/>', f'    <child link="{child}"/>', f'    <origin xyz="{xyz}" rpy="{rpy}"/>']
    if motion:
        axis, lower, upper = motion
        lines += [f'    <axis xyz="{axis}"/>',
                  f'    <limit lower="{lower}" upper="{upper}" effort="{EFFORT}" velocity="{VELOCITY}"/>']
    return "\n" + "\n".join(lines + ["  </joint>"])


def finger_text(name, root, joints, origins, shapes, tip_distance):
    """Four joints in a row and a fixed tip frame."""
    text, parent = f"\n\n  <!-- {name} -->", "palm"
    for i in range(4):
        child = f"{name}_link_{i}"
        xyz, rpy = root if i == 0 else (origins[i], "0 0 0")
        text += joint_text(f"{name}_joint_{i}", parent, child, xyz, rpy, joints[i])
        text += link_text(child, shapes[i], "joint" if shapes[i].endswith(("base", "mount")) else "phalanx")
        parent = child
    text += joint_text(f"{name}_tip_joint", parent, f"{name}_tip", f"0 0 {tip_distance}", "0 0 0", None)
    return text + link_text(f"{name}_tip", "fingertip", "rubber")


def urdf_text():
    text = """<?xml version="1.0"?>
<!-- An Allegro right hand, written by hands/tools/make_allegro_right.py; see hands/README.md.
     Root frame: x out of the palm, y towards the index finger, z along the fingers; metres and radians. -->
<robot name="allegro_right">"""
    text += "".join(f'\n  <material name="{name}"><color rgba="{rgba}"/></material>' for name, rgba in COLOURS.items())
    text += "\n" + link_text("palm", "palm", "shell")
    for name, root in FINGER_ROOTS.items():
        origins = [None] + [f"0 0 {length}" for length in FINGER_LENGTHS[:3]]
        shapes = ["finger_base", "finger_proximal", "finger_middle", "finger_distal"]
        text += finger_text(name, root, FINGER_JOINTS, origins, shapes, FINGER_LENGTHS[3])
    origins = [None, THUMB_SECOND_JOINT] + [f"0 0 {length}" for length in THUMB_LENGTHS[1:3]]
    shapes = ["thumb_mount", "thumb_base", "thumb_proximal", "thumb_distal"]
    text += finger_text("thumb", THUMB_ROOT, THUMB_JOINTS, origins, shapes, THUMB_LENGTHS[3])
    return text + "\n</robot>\n"


def main():
    parser = argparse.ArgumentParser(description="Write hands/allegro_right, or check what is there.")
    parser.add_argument("--check", action="store_true", help="write nothing; exit 1 when a file differs")
    check = parser.parse_args().check

    files = {f"meshes/{name}.obj": obj_text(name) for name in SHAPES} | {"allegro_right.urdf": urdf_text()}
    differing = []
    for name, text in files.items():
        path = FOLDER / name
        if check:
            if not path.is_file() or path.read_bytes() != text.encode():
                differing.append(name)
        else:
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_bytes(text.encode())
    if differing:
        print(f"{FOLDER}: differs from what {sys.argv[0]} writes: {', '.join(differing)}; run it without --check", file=sys.stderr)
    return 1 if differing else 0


if __name__ == "__main__":
    sys.exit(main())
