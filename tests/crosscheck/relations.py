"""What schemas/hand-profile-v1.md says of several values of a profile together; dataset_list.py looks at each alone."""

import numpy as np

TOLERANCE = 1e-9  # of postures


def joint_faults(joints):
    rows = np.arange(len(joints["name"]))
    masters = joints["mimic_master"]
    follows = masters >= 0
    yield "joints/name", len(set(joints["name"])) == len(rows) > 0
    yield "joints/parent", (joints["parent"] < rows).all()
    yield "joints/mimic_master", (masters != rows).all() and not follows[masters[follows]].any()
    yield "joints/upper", (joints["lower"] <= joints["upper"]).all()
    for name in ("q_open", "q_sphere", "q_closed"):
        q = joints[name]
        within = (q >= joints["lower"]) & (q <= joints["upper"])
        followed = joints["mimic_multiplier"] * q[masters] + joints["mimic_offset"]
        yield f"joints/{name}", np.where(follows, np.abs(q - followed) <= TOLERANCE, within).all()


def finger_faults(profile):
    fingers, parent = profile["fingers"], profile["joints"]["parent"]
    yield "fingers/slots", fingers["slots"].any(axis=0).all() and fingers["slots"].any(axis=1).all()
    yield "fingers/slots", (np.diff(fingers["slots"].argmax(axis=1)) >= 0).all()
    for chain, tip in zip(fingers["joints"], fingers["tip_link"]):
        yield "fingers/joints", len(chain) > 0 and (parent[chain[1:]] == chain[:-1]).all()
        yield "fingers/tip_link", profile["links"]["joint"][tip] == chain[-1]


def table_faults(profile):
    tables, joints, fingers = profile["lateral_tables"], profile["joints"], profile["fingers"]
    for row, joint in enumerate(tables["joint"]):
        q, theta, inverse_q = (tables[name][row] for name in ("q", "theta", "inverse_q"))
        steps, turns = np.diff(q), np.diff(theta)
        yield "lateral_tables/joint", joints["class"][joint] == 0 and joints["mimic_master"][joint] < 0
        yield "lateral_tables/q", len(q) >= 2 and (steps > 0).all() and np.ptp(steps) <= 1e-6 * steps.mean()
        yield "lateral_tables/theta", len(theta) == len(q) and ((turns > 0).all() or (turns < 0).all())
        yield "lateral_tables/inverse_q", len(inverse_q) >= 3 and len(inverse_q) % 2 == 1
        yield "lateral_tables/inverse_q", inverse_q[len(inverse_q) // 2] == tables["neutral"][row]
        yield "lateral_tables/inverse_q", (np.diff(inverse_q) * np.sign(turns[0]) >= 0).all()
        for finger in np.flatnonzero(fingers["lateral_table"] == row):
            yield "fingers/lateral_table", joint in fingers["joints"][finger]
            yield "lateral_tables/neutral", abs(tables["neutral"][row] - joints["q_sphere"][joint]) <= TOLERANCE


def check(profile):
    """Raises ValueError, which names the dataset, when values of the loaded profile contradict each other."""
    faults = [*joint_faults(profile["joints"]), *finger_faults(profile), *table_faults(profile)]
    faults.append(("correspondences/link", (np.diff(profile["correspondences"]["link"]) >= 0).all()))
    for path, holds in faults:
        if not holds:
            raise ValueError(f"{path} contradicts other values")
