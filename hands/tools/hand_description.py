"""A hand as data, and its files: a URDF and one OBJ mesh for each solid.

Lengths of joints are metres and angles radians, as in the URDF; solids are modelled in millimetres.
"""

from dataclasses import dataclass
from typing import Callable

import numpy as np

from implicit_mesh import check_closed, mesh

COLOURS = {"shell": (0.17, 0.19, 0.22), "joint": (0.42, 0.45, 0.49), "phalanx": (0.24, 0.27, 0.31),
           "rubber": (0.92, 0.9, 0.85), "motor": (0.13, 0.13, 0.14), "print": (0.86, 0.85, 0.82), "skin": (0.85, 0.66, 0.55)}


@dataclass
class Joint:
    """Carries its link; without an axis it is fixed."""
    name: str
    parent: str
    xyz: tuple
    rpy: tuple = (0, 0, 0)
    axis: tuple | None = None
    lower: float = 0
    upper: float = 0


@dataclass
class Link:
    """One rigid body. Without a solid it is a frame only; the root has no joint."""
    name: str
    joint: Joint | None = None
    solid: str | None = None
    colour: str | None = None


@dataclass
class Solid:
    """A shape (see implicit_mesh) with the box it is meshed in and the size of the mesh's cells; mirrored: y is negated."""
    shape: Callable
    low: list
    high: list
    cell: float
    mirrored: bool = False


@dataclass
class Hand:
    name: str
    about: str      # the comment at the head of the URDF
    chains: dict    # heading -> links, root to tip
    solids: dict    # name -> Solid
    effort: float = 10      # of every joint (N m)
    velocity: float = 3.14  # of every joint (rad/s)

    def files(self):
        """Path in the hand's folder -> text."""
        meshes = {f"meshes/{name}.obj": _obj_text(name, solid) for name, solid in self.solids.items()}
        return meshes | {f"{self.name}.urdf": _urdf_text(self)}


def _obj_text(name, solid):
    vertices, triangles = mesh(solid.shape, solid.low, solid.high, solid.cell)
    vertices = np.round(vertices, 3) + 0.0  # micrometres; no negative zero
    if solid.mirrored:
        vertices, triangles = vertices * [1, -1, 1] + 0.0, triangles[:, ::-1]
    try:
        check_closed(vertices, triangles)
    except ValueError as error:
        raise ValueError(f"{name}: {error}") from None
    lines = [f"# {name}: metres, written by make_hands.py", f"o {name}"]
    lines += ["v %.6f %.6f %.6f" % tuple(v / 1000) for v in vertices]
    lines += ["f %d %d %d" % tuple(t + 1) for t in triangles]
    return "\n".join(lines).replace("-0.000000", "0.000000") + "\n"


def _urdf_text(hand):
    links = [link for chain in hand.chains.values() for link in chain]
    text = f"""<?xml version="1.0"?>
<!-- {hand.about}
     Written by hands/tools/make_hands.py; see hands/README.md. -->
<robot name="{hand.name}">"""
    for name, rgb in COLOURS.items():
        if any(link.colour == name for link in links):
            text += f'\n  <material name="{name}"><color rgba="{_numbers(rgb)} 1"/></material>'
    for heading, chain in hand.chains.items():
        text += f"\n\n  <!-- {heading} -->"
        for link in chain:
            text += (_joint_text(hand, link) if link.joint else "") + _link_text(link)
    return text + "\n</robot>\n"


def _joint_text(hand, link):
    joint = link.joint
    lines = [f'  <joint name="{joint.name}" type="{"revolute" if joint.axis else "fixed"}">',
             f'    <parent link="{joint.parent}"/>', f'    <child link="{link.name}"/>',
             f'    <origin xyz="{_numbers(joint.xyz)}" rpy="{_numbers(joint.rpy)}"/>']
    if joint.axis:
        limits = f'lower="{joint.lower:.12g}" upper="{joint.upper:.12g}" effort="{hand.effort:g}" velocity="{hand.velocity:g}"'
        lines += [f'    <axis xyz="{_numbers(joint.axis)}"/>', f"    <limit {limits}/>"]
    return "\n" + "\n".join(lines + ["  </joint>"])


def _link_text(link):
    if not link.solid:
        return f'\n  <link name="{link.name}"/>'
    return f"""
  <link name="{link.name}">
    <visual>
      <geometry><mesh filename="meshes/{link.solid}.obj"/></geometry>
      <material name="{link.colour}"/>
    </visual>
    <collision>
      <geometry><mesh filename="meshes/{link.solid}.obj"/></geometry>
    </collision>
  </link>"""


def _numbers(values):
    return " ".join(f"{value + 0.0:.12g}" for value in values)  # + 0.0: no negative zero
