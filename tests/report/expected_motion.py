#!/usr/bin/env python3
"""What the page's module must answer, from the second reader of profiles (tests/crosscheck) and numpy.

    expected_motion.py PROFILE < question.json      prints {"poses": [pose], "fields": [field]}

A question is {"q": [joint values], "actions": [action], "theta_phi": [theta, phi of a point, of the next, ...]}. A pose has for
each link its frame in the palm's, 16 numbers column by column; a field has for each point its azimuth and radius.
"""

import json
import pathlib
import sys

import numpy as np

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent / "crosscheck"))

import read_profile

SAME_PLANE = np.radians(5)


def plane_groups(azimuths):
    """Lists of fingers whose planes follow each other closer than SAME_PLANE around the circle."""
    order = np.argsort(azimuths, kind="stable")
    gaps = np.append(np.diff(azimuths[order]), azimuths[order[0]] + 2 * np.pi - azimuths[order[-1]])
    ends = np.flatnonzero(gaps >= SAME_PLANE)
    if len(ends) == 0:
        return [order]
    turned = np.roll(order, -(ends[0] + 1))
    return np.split(turned, np.cumsum(np.diff(np.append(ends, ends[0] + len(order))))[:-1])


def field(profile, action, theta, phi):
    """Azimuth and radius [N] of points of the unit sphere, interpolated around the circle of planes
    (docs/method.md#the-interpolated-field)."""
    azimuths, turns, radii = [], [], []
    for group in plane_groups(profile["fingers"]["theta_initial"]):
        planes = [read_profile.finger_deformation(profile, finger, action) for finger in group]
        delta_theta, angles, displacements = (np.mean([plane[k] for plane in planes], axis=0) for k in range(3))
        azimuths.append(np.angle(np.mean(np.exp(1j * profile["fingers"]["theta_initial"][group]))))
        turns.append(delta_theta)
        radii.append(1 + np.interp(phi, angles, displacements))

    def around(values):
        return np.array([np.interp(t, azimuths, column, period=2 * np.pi) for t, column in zip(theta, np.transpose(values))])

    return theta + np.interp(theta, azimuths, turns, period=2 * np.pi), around(radii)


def main():
    profile = read_profile.load(sys.argv[1])
    question = json.load(sys.stdin)
    theta, phi = np.reshape(question["theta_phi"], (-1, 2)).T
    poses = [np.concatenate([T.T.ravel() for T in read_profile.fk(profile, q).values()]).tolist() for q in question["q"]]
    fields = [np.stack(field(profile, action, theta, phi), axis=1).ravel().tolist() for action in question["actions"]]
    json.dump({"poses": poses, "fields": fields}, sys.stdout)


if __name__ == "__main__":
    main()
