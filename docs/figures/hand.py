"""A hand of hands/ as the tools describe it: its profile, meshes and surface points, and its forward kinematics."""

import json
import pathlib
import struct
import subprocess
import tempfile
import xml.etree.ElementTree as ElementTree

import numpy as np

ROOT = pathlib.Path(__file__).resolve().parents[2]
POINT_COLUMNS = ["theta", "phi", "rho", "weight", "red", "green", "blue"]


def rotation_about(axis, angle):
    x, y, z = axis
    k = np.array([[0, -z, y], [z, 0, -x], [-y, x, 0]])
    return np.eye(3) + np.sin(angle) * k + (1 - np.cos(angle)) * k @ k


def transform(rotation, translation=(0, 0, 0)):
    T = np.eye(4)
    T[:3, :3], T[:3, 3] = rotation, translation
    return T


def numbers(text):
    return np.array([float(word) for word in text.split()])


def axis_of(joint):
    return numbers(joint.find("axis").get("xyz"))


def origin_of(joint):
    origin = joint.find("origin")
    if origin is None:
        return np.eye(4)
    turn = np.eye(3)
    for axis, angle in zip(np.eye(3), numbers(origin.get("rpy", "0 0 0"))):
        turn = rotation_about(axis, angle) @ turn
    return transform(turn, numbers(origin.get("xyz", "0 0 0")))


class Hand:
    """A hand of hands/: what its profile says, its meshes, its surface points, and forward kinematics of its URDF."""

    def __init__(self, name, bin_folder, samples=20000):
        self.bin = bin_folder
        self.urdf = ROOT / "hands" / name / f"{name}.urdf"
        with tempfile.TemporaryDirectory() as scratch:
            folder = pathlib.Path(scratch)
            self.run("uhas-build-profile", self.urdf, "-o", folder / "hand.h5", "--samples", samples, "--quiet")
            inspect = ["uhas-inspect", folder / "hand.h5", "--quiet"]
            self.summary = json.loads(self.run(*inspect, "--json"))
            self.run(*inspect, "--gltf", folder / "hand.glb", "--ply", folder / "points.ply", "--urdf", self.urdf)
            self.meshes = read_glb((folder / "hand.glb").read_bytes())
            self.points = read_ply((folder / "points.ply").read_text())
            self.profile = (folder / "hand.h5").read_bytes()
        sphere = self.summary["sphere"]
        self.radius = sphere["radius"]
        self.T_root_sphere = transform(np.array(sphere["rotation_in_root"]), sphere["center_in_root"])
        self.fingers = {finger["name"]: finger for finger in self.summary["fingers"]}
        self.joints = ElementTree.parse(self.urdf).getroot().findall("joint")
        at_wrap = self.pose(self.summary["q_sphere"])
        for link, points in self.points.items():
            points["p_link"] = (np.linalg.inv(at_wrap[link]) @ homogeneous(points["p"] / self.radius))[:3].T

    def run(self, tool, *arguments, text=None):
        command = [self.bin / tool, *map(str, arguments)]
        return subprocess.run(command, input=text, capture_output=True, text=True, check=True).stdout

    def solve(self, action):
        """{joint: value} that uhas-solve answers an action with."""
        with tempfile.NamedTemporaryFile(suffix=".h5") as profile:
            profile.write(self.profile)
            profile.flush()
            answer = json.loads(self.run("uhas-solve", "-", "--profile", profile.name, text=json.dumps(action) + "\n"))
        return dict(zip(self.summary["joint_names"], answer["q"]))

    def pose(self, q):
        """{link: its pose in S, 4 x 4, lengths in sphere radii}."""
        to_radii = np.diag([1 / self.radius] * 3 + [1])
        root = self.joints[0].find("parent").get("link")  # these URDFs list joints from the root outward
        T_sphere = {root: np.linalg.inv(self.T_root_sphere)}
        for joint in self.joints:
            local = origin_of(joint)
            if joint.get("type") == "revolute":
                local = local @ transform(rotation_about(axis_of(joint), q.get(joint.get("name"), 0)))
            T_sphere[joint.find("child").get("link")] = T_sphere[joint.find("parent").get("link")] @ local
        return {link: to_radii @ T @ np.linalg.inv(to_radii) for link, T in T_sphere.items()}

    def child_link(self, joint_name):
        return next(joint.find("child").get("link") for joint in self.joints if joint.get("name") == joint_name)

    def finger_links(self, finger):
        """Its links from root to tip, the frame of the fingertip last."""
        finger = self.fingers[finger]
        return [self.child_link(joint["name"]) for joint in finger["joints"]] + [finger["tip_link"]]

    def triangles(self, q, links=None):
        """Triangles [n, 3, 3] of the posed links in S, and the normals of their corners."""
        pose, corners, normals = self.pose(q), [], []
        for link, (vertices, triangles) in self.meshes.items():
            if links is not None and link not in links:
                continue
            p = (pose[link] @ homogeneous(vertices / self.radius))[:3].T
            faces = np.cross(p[triangles[:, 1]] - p[triangles[:, 0]], p[triangles[:, 2]] - p[triangles[:, 0]])
            n = np.zeros_like(p)
            for corner in range(3):
                np.add.at(n, triangles[:, corner], faces)
            n /= np.linalg.norm(n, axis=1, keepdims=True) + 1e-30
            corners.append(p[triangles])
            normals.append(n[triangles])
        return np.concatenate(corners), np.concatenate(normals)

    def surface_points(self, q, links=None, all_of_them=False):
        """The surface points of the links, those that the solver uses or all: `p`, positions in S (radii), and the
        columns of the PLY."""
        pose, found = self.pose(q), []
        for link, points in self.points.items():
            if links is not None and link not in links:
                continue
            keep = slice(None) if all_of_them else points["weight"] > 0
            p = (pose[link] @ homogeneous(points["p_link"][keep]))[:3].T
            found.append({**{key: values[keep] for key, values in points.items()}, "p": p})
        return {key: np.concatenate([points[key] for points in found]) for key in ("p", *POINT_COLUMNS)}


def homogeneous(points):
    return np.vstack([points.T, np.ones(len(points))])


def read_glb(data):
    """{link: (vertices [n, 3] in the link's frame, triangles [m, 3])} of a file of uhas-inspect --gltf."""
    length = struct.unpack_from("<I", data, 12)[0]
    scene, binary = json.loads(data[20:20 + length]), data[28 + length:]

    def read(accessor, kind, columns):
        a = scene["accessors"][accessor]
        start = scene["bufferViews"][a["bufferView"]].get("byteOffset", 0) + a.get("byteOffset", 0)
        return np.frombuffer(binary, kind, a["count"] * columns, start).reshape(-1, columns)

    meshes = {}
    for node in scene["nodes"]:
        if "mesh" not in node or node["name"] in ("correspondences", "sphere_axes", "sphere"):
            continue
        primitive = scene["meshes"][node["mesh"]]["primitives"][0]
        meshes[node["name"]] = (read(primitive["attributes"]["POSITION"], "<f4", 3).astype(float),
                                read(primitive["indices"], "<u4", 1).astype(int).reshape(-1, 3))
    return meshes


def read_ply(text):
    """{link: {p, theta, phi, rho, weight, red, green, blue}} of a file of uhas-inspect --ply; p in S (m)."""
    head, body = text.split("end_header\n")
    names = dict(line.split()[2:4] for line in head.splitlines() if line.startswith("comment link"))
    columns = [line.split()[2] for line in head.splitlines() if line.startswith("property")]
    table = np.array([numbers(line) for line in body.splitlines()])
    column = dict(zip(columns, table.T))
    of_link = {name: column["link"] == int(number) for number, name in names.items()}
    return {name: {"p": table[here][:, :3], **{key: column[key][here] for key in POINT_COLUMNS}}
            for name, here in of_link.items() if here.any()}
