"""Lateral joints of an action, and the weights of points, computed from schemas/hand-profile-v1.md alone."""

import numpy as np

import read_profile


def table_value(tables, row, delta_theta):
    """Joint value of a lateral table at an azimuth within its bounds."""
    inverse_q = tables["inverse_q"][row]
    m = len(inverse_q) // 2
    bound = tables["delta_theta_lower" if delta_theta < 0 else "delta_theta_upper"][row]
    if delta_theta == 0 or bound == 0:
        return inverse_q[m]
    steps = min(delta_theta / bound, 1) * m * np.sign(delta_theta)
    return np.interp(m + steps, np.arange(len(inverse_q)), inverse_q)


def table_delta_theta(tables, row, q):
    """The way back."""
    return np.interp(q, tables["q"][row], tables["theta"][row]) - tables["theta_initial"][row]


def lateral_joints(profile, action, **options):
    """{joint: value} of every lateral joint, followers included."""
    joints, fingers, tables = profile["joints"], profile["fingers"], profile["lateral_tables"]
    q = joints["q_sphere"].copy()
    for finger, row in enumerate(fingers["lateral_table"]):
        if row >= 0:
            delta_theta = read_profile.finger_deformation(profile, finger, action, **options)[0]
            q[tables["joint"][row]] = table_value(tables, row, delta_theta)
    masters = joints["mimic_master"]
    followed = np.where(masters >= 0, joints["mimic_multiplier"] * q[masters] + joints["mimic_offset"], q)
    return {i: followed[i] for i in np.flatnonzero(joints["class"] == 0)}


def spread_points(points, count):
    """Indices of at most `count` of `points`, in the order in which the page's rule chooses them."""
    chosen = [np.linalg.norm(points - points.mean(axis=0), axis=1).argmin()]
    while len(chosen) < count:
        gap = np.linalg.norm(points[:, None] - points[chosen], axis=2).min(axis=1)
        if gap.max() == 0:
            break
        chosen.append(gap.argmax())
    return chosen


def weights(profile, points_per_link):
    """[N] weights of the correspondences by the page's rule."""
    correspondences = profile["correspondences"]
    moves = profile["links"]["joint"][correspondences["link"]] >= 0
    result = np.zeros(len(moves))
    for link in np.unique(correspondences["link"][moves]):
        rows = np.flatnonzero(correspondences["link"] == link)
        points = correspondences["p_link"][rows]
        chosen = spread_points(points, points_per_link)
        nearest = np.linalg.norm(points[:, None] - points[chosen], axis=2).argmin(axis=1)
        result[rows[chosen]] = np.bincount(nearest, minlength=len(chosen))
    return result / moves.sum()


def compare_tables(profile, tolerance=1e-3):
    """Messages on tables whose two directions disagree; the joint's radians or metres."""
    tables = profile["lateral_tables"]
    for row, inverse_q in enumerate(tables["inverse_q"]):
        delta_theta = [table_delta_theta(tables, row, q) for q in inverse_q]
        again = np.array([table_value(tables, row, d) for d in delta_theta])
        if not np.abs(again - inverse_q).max() <= tolerance:
            yield f"lateral table {row}: there and back differs by {np.abs(again - inverse_q).max()}"
        if not abs(table_delta_theta(tables, row, tables["neutral"][row])) <= tolerance:
            yield f"lateral table {row}: theta at neutral is not theta_initial"


def compare_weights(profile, points_per_link, tolerance=1e-12):
    difference = np.abs(weights(profile, points_per_link) - profile["correspondences"]["weight"]).max()
    if not difference <= tolerance:
        yield f"weights differ by {difference}"


def compare_lateral_joints(profile, solution, actions, tolerance):
    """Messages on lateral joints of a solution file that stand elsewhere than the tables say."""
    options = {"driving_vectors_phi": actions.get("driving_vectors_phi"), "normalized": actions.get("normalized", False)}
    for i, (found, action) in enumerate(zip(solution["solutions"], actions["actions"])):
        q = read_profile.in_profile_order(profile, solution["joint_names"], found["q"])
        for joint, expected in lateral_joints(profile, read_profile.flat_action(action), **options).items():
            if not abs(q[joint] - expected) <= tolerance:
                yield f"solution {i}: {profile['joints']['name'][joint]} is {q[joint]}, computed {expected}"
