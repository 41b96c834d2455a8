#!/usr/bin/env python3
"""A second reader of hand profiles, written from schemas/hand-profile-v1.md and its list of datasets alone (h5py and numpy).

    read_profile.py PROFILE                     checks the user block, reads everything, checks that an action of zeros
                                                fits q_sphere
    read_profile.py PROFILE SOLUTION ACTIONS    also compares the residuals of a solution file, made from ACTIONS, with
                                                residuals computed here; a key `poses` beside `solutions`, a list of
                                                {"q": [..], "T_palm_link": {link name: 4 x 4}}, compares kinematics too
"""

import argparse
import hashlib
import json
import re
import sys

import h5py
import numpy as np

import dataset_list
import relations
import screening

SLOTS = 5


def user_block(data, version):
    digest = hashlib.sha256(data[512:]).hexdigest()
    text = f"uhas-hand-profile {version}\nlength {len(data)}\nsha256 {digest}\n"
    return text.encode().ljust(512, b"\0")


def check_user_block(path):
    """(major, minor) that the user block states."""
    with open(path, "rb") as file:
        data = file.read()
    first_line = re.match(rb"uhas-hand-profile (\d+)\.(\d+)\n", data)
    if not first_line:
        raise ValueError(f"{path}: not a hand profile")
    major, minor = map(int, first_line.groups())
    if major != 1:
        raise ValueError(f"{path}: format version {major}.{minor}, this reader knows 1")
    if data[:512] != user_block(data, f"{major}.{minor}"):
        raise ValueError(f"{path}: damaged")
    return major, minor


def open_hdf5(path):
    try:
        return h5py.File(path, "r")
    except OSError as error:
        raise ValueError(f"{path}: {error}") from None


def seal(path):
    """Rewrites the user block of a file that was edited, for the version that it states."""
    with open(path, "r+b") as file:
        data = file.read()
        file.seek(0)
        file.write(user_block(data, data.split(b"\n", 1)[0].decode().partition(" ")[2]))


def values(dataset):
    """A dataset as numpy numbers, as a string, or as a list of strings."""
    content = dataset[()]
    if dataset.dtype.kind != "S":
        return content
    return content.decode() if dataset.shape == () else [text.decode() for text in content]


def load(path):
    """{group: {dataset: values}}; a list dataset becomes one array a row. ValueError on what the format does not allow."""
    major, minor = check_user_block(path)
    with open_hdf5(path) as file:
        screening.screen(file)
        if file.attrs.get("format") != b"uhas-hand-profile" or list(file.attrs.get("version", [])) != [major, minor]:
            raise ValueError(f"{path}: its root attributes do not agree with its user block")
        dataset_list.check(file)
        profile = {group: {name: values(file[group][name]) for name in file[group]} for group in file}
    for group in profile.values():
        for name in [name for name in group if name + "_offsets" in group]:
            offsets = group.pop(name + "_offsets")
            group[name] = [group[name][begin:end] for begin, end in zip(offsets, offsets[1:])]
    relations.check(profile)
    return profile


def joint_motion(kind, axis, q):
    """Transform of a joint's moved frame relative to its frame at q = 0."""
    T = np.eye(4)
    if kind == 2:
        T[:3, 3] = q * axis
    else:
        x, y, z = axis
        K = np.array([[0, -z, y], [z, 0, -x], [-y, x, 0]])
        T[:3, :3] += np.sin(q) * K + (1 - np.cos(q)) * K @ K
    return T


def fk(profile, q):
    """{link name: T_palm_link} at joint values q, in the order of /joints."""
    joints, links = profile["joints"], profile["links"]
    q = np.array(q, dtype=float)
    follows = joints["mimic_master"] >= 0
    masters = joints["mimic_master"][follows]
    q[follows] = joints["mimic_multiplier"][follows] * q[masters] + joints["mimic_offset"][follows]

    T_palm_joint = {-1: np.eye(4)}
    for i, parent in enumerate(joints["parent"]):
        motion = joint_motion(joints["kind"][i], joints["axis"][i], q[i])
        T_palm_joint[i] = T_palm_joint[parent] @ joints["T_parent_joint"][i] @ motion
    return {
        name: T_palm_joint[joint] @ T for name, joint, T in zip(links["name"], links["joint"], links["T_joint_link"])
    }


def points_in_sphere(profile, q):
    """[N, 3] correspondences in S (m)."""
    correspondences = profile["correspondences"]
    T_sphere_palm = np.linalg.inv(profile["sphere"]["T_palm_sphere"])
    T_palm_link = fk(profile, q)
    T = np.array([T_sphere_palm @ T_palm_link[name] for name in profile["links"]["name"]])[correspondences["link"]]
    return np.einsum("kij,kj->ki", T[:, :3, :3], correspondences["p_link"]) + T[:, :3, 3]


def finger_of_point(profile):
    """[N] finger that each correspondence belongs to; -1 = none."""
    theta = profile["correspondences"]["theta"]
    joint_of_point = profile["links"]["joint"][profile["correspondences"]["link"]]
    owner, nearest = np.full(len(theta), -1), np.full(len(theta), np.inf)
    for finger, (joints, theta_initial) in enumerate(zip(profile["fingers"]["joints"], profile["fingers"]["theta_initial"])):
        distance = np.abs((theta - theta_initial + np.pi) % (2 * np.pi) - np.pi)
        nearer = np.isin(joint_of_point, joints) & (distance < nearest)
        owner[nearer], nearest[nearer] = finger, distance[nearer]
    return owner


def finger_deformation(profile, finger, action, driving_vectors_phi=None, normalized=False):
    """(delta theta, polar angles [1 + V], displacements [1 + V]) of a finger's plane; the first angle is the pole."""
    action = np.asarray(action, dtype=float)
    V = len(action) // SLOTS - 1
    theta, radial = action[:SLOTS].copy(), action[SLOTS:].reshape(SLOTS, V).copy()
    if driving_vectors_phi is None:
        driving_vectors_phi = np.pi * np.arange(1, V + 1) / (V + 1)
    phi = np.broadcast_to(np.reshape(driving_vectors_phi, (-1, V)), (SLOTS, V))

    table = profile["fingers"]["lateral_table"][finger]
    lower, upper = (
        (profile["lateral_tables"][name][table] if table >= 0 else 0.0)
        for name in ("delta_theta_lower", "delta_theta_upper")
    )
    if normalized:
        theta = np.where(theta < 0, -theta * lower, theta * upper)
        radial = 2 * radial
    theta, radial = np.clip(theta, lower, upper), np.clip(radial, -2, 2)

    own = profile["fingers"]["slots"][finger] == 1
    return (
        theta[own].mean(),
        np.concatenate([[0], phi[own].mean(axis=0)]),
        np.concatenate([[0], radial[own].mean(axis=0)]),
    )


def targets(profile, action, **options):
    """([N, 3] targets in S (m), [N] fades s); a point without a finger has fade 0."""
    correspondences = profile["correspondences"]
    owner = finger_of_point(profile)
    theta, radius, fade = (np.zeros(len(owner)) for _ in range(3))
    phi = correspondences["phi"]
    for finger in range(len(profile["fingers"]["name"])):
        delta_theta, angles, displacements = finger_deformation(profile, finger, action, **options)
        of_finger = owner == finger
        theta[of_finger] = correspondences["theta"][of_finger] + delta_theta
        delta_r = np.interp(phi[of_finger], angles, displacements)
        radius[of_finger] = np.maximum(correspondences["rho"][of_finger] + delta_r, 0)
        anchorless = np.interp(np.maximum(phi[of_finger], angles[1]), angles, displacements)
        u = np.clip((1 + anchorless) / 0.5, 0, 1)
        fade[of_finger] = u * u * (3 - 2 * u)
    azimuth = -theta if profile["hand"]["mirrored"] else theta
    directions = np.stack([np.sin(phi) * np.cos(azimuth), np.sin(phi) * np.sin(azimuth), -np.cos(phi)], axis=1)
    return profile["sphere"]["radius"] * radius[:, None] * directions, fade


def residual_rms(profile, q, action, **options):
    """Weighted rms distance of points from targets in sphere radii; None when no point counts."""
    target, fade = targets(profile, action, **options)
    weight = profile["correspondences"]["weight"] * fade
    if weight.sum() == 0:
        return None
    error = np.linalg.norm(points_in_sphere(profile, q) - target, axis=1) / profile["sphere"]["radius"]
    return float(np.sqrt((weight * error**2).sum() / weight.sum()))


def flat_action(action):
    """An action of an actions file as 5 + 5 V numbers."""
    if isinstance(action, dict):
        return np.concatenate([action["lateral"], np.ravel(action["radial"])])
    return np.array(action, dtype=float)


def compare_residuals(profile, solution, actions, tolerance):
    """Messages, one for each residual of a solution file that differs from this reader's."""
    options = {
        "driving_vectors_phi": actions.get("driving_vectors_phi"),
        "normalized": actions.get("normalized", False),
    }
    if len(solution["solutions"]) != len(actions["actions"]):
        yield f"{len(solution['solutions'])} solutions for {len(actions['actions'])} actions"
    for i, (found, action) in enumerate(zip(solution["solutions"], actions["actions"])):
        q = in_profile_order(profile, solution["joint_names"], found["q"])
        computed, told = residual_rms(profile, q, flat_action(action), **options), found["residual_rms"]
        if (computed is None) != (told is None) or (told is not None and not abs(computed - told) <= tolerance):
            yield f"solution {i}: residual_rms is {told}, computed {computed}"


def compare_poses(profile, solution, tolerance):
    """Messages, one for each link pose that differs from this reader's."""
    for i, pose in enumerate(solution.get("poses", [])):
        links = fk(profile, in_profile_order(profile, solution["joint_names"], pose["q"]))
        for name, T in pose["T_palm_link"].items():
            difference = np.abs(links[name] - np.array(T)).max()
            if not difference <= tolerance:
                yield f"pose {i}: T_palm_link of {name} differs by {difference}"


def in_profile_order(profile, names, q):
    of_name = dict(zip(names, q))
    return [of_name[name] for name in profile["joints"]["name"]]


def main():
    parser = argparse.ArgumentParser(description="Reads a hand profile with h5py and compares solutions with it.")
    parser.add_argument("profile")
    parser.add_argument("solution", nargs="?")
    parser.add_argument("actions", nargs="?")
    parser.add_argument("--tolerance", type=float, default=1e-9, help="of residuals (radii) and transforms")
    arguments = parser.parse_args()
    if arguments.solution and not arguments.actions:
        parser.error("a solution is compared with the actions that it was made from: name both files")

    profile = load(arguments.profile)
    q_sphere = profile["joints"]["q_sphere"]
    rest = residual_rms(profile, q_sphere, np.zeros(15))
    messages = []
    if rest is not None and rest > arguments.tolerance:
        messages.append(f"residual_rms of q_sphere for an action of zeros is {rest}")
    if arguments.solution:
        with open(arguments.solution) as file:
            solution = json.load(file)
        with open(arguments.actions) as file:
            actions = json.load(file)
        messages += compare_residuals(profile, solution, actions, arguments.tolerance)
        messages += compare_poses(profile, solution, arguments.tolerance)
    for message in messages:
        print(f"read_profile.py: {arguments.profile}: {message}", file=sys.stderr)
    if not messages:
        print(f"{profile['hand']['name']}: {len(q_sphere)} joints, {len(profile['correspondences']['link'])} points, agreed")
    return 1 if messages else 0


if __name__ == "__main__":
    sys.exit(main())
