#!/usr/bin/env python3
"""Draws the pictures of docs/method.md from what the tools say of the hands in hands/.

    python3 docs/figures/make_figures.py --bin build/dev/bin            # writes them to docs/
    python3 docs/figures/make_figures.py --bin build/dev/bin cascade    # one of them
    python3 docs/figures/make_figures.py --bin build/dev/bin -o FOLDER

Needs Python 3 and NumPy.
"""

import argparse
import pathlib

import numpy as np

from hand import ROOT, Hand
from picture import Picture, View, attributes

SLOT_NAMES = ["pinky", "ring", "middle", "index", "thumb"]
SLOT_COLOURS = ["#8e5bb5", "#2f7fc1", "#2a9d6f", "#d9822b", "#c4443f"]
INK, SOFT, SPHERE, TARGET = "#1d2733", "#5c6773", "#6f9fd8", "#c4443f"
AT_REST = {"stroke": SPHERE, "stroke_width": 1.4, "stroke_dasharray": "5 4"}


def on_sphere(theta, phi, radius=1.0):
    """Points of S at azimuth, polar angle and radius."""
    theta, phi, radius = np.broadcast_arrays(theta, phi, radius)
    return radius[..., None] * np.stack([np.sin(phi) * np.cos(theta), np.sin(phi) * np.sin(theta), -np.cos(phi)], -1)


def displacement(phi, at, delta_r):
    """Delta r at polar angles: 0 at the pole, linear between driving vectors, constant beyond the last."""
    return np.interp(phi, [0, *at], [0, *delta_r])


def ball(picture, view):
    picture.add(f'<defs><radialGradient id="ball" cx="0.36" cy="0.3" r="0.8">'
                f'<stop offset="0" stop-color="#fff" stop-opacity="0.75"/>'
                f'<stop offset="0.5" stop-color="#a9cbf2" stop-opacity="0.5"/>'
                f'<stop offset="1" stop-color="{SPHERE}" stop-opacity="0.6"/></radialGradient></defs>')
    picture.circle(view.centre, view.scale, fill="url(#ball)", stroke=SPHERE, stroke_width=1.2)


def plane_view(theta, centre, scale):
    """The half plane at azimuth `theta` from its side: the palm below, the fingertip to the right."""
    return View([np.cos(theta), np.sin(theta), 0], [0, 0, 1], centre, scale)


def subscript(text):
    return f"<tspan font-size='11' dy='3'>{text}</tspan>"


def driving_planes(bin_folder, output):
    hand = Hand("human_right", bin_folder)
    picture = Picture(1000, 470, "Left: the sphere in a hand, and in it five driving planes, each with driving "
                                 "vectors at 60 and 120 degrees from the palm. Right: the plane of the index finger "
                                 "from its side, at rest and deformed.")
    draw_planes_on_sphere(picture, hand)
    draw_index_plane(picture, hand)
    picture.write(output / "driving_planes.svg")


def draw_planes_on_sphere(picture, hand):
    view, box = View.from_direction(174, 30, (250, 184), 152), (0, 0, 500, 440)
    mesh = hand.triangles(hand.summary["q_sphere"])
    picture.mesh(*mesh, view, box, behind=True)
    ball(picture, view)
    picture.mesh(*mesh, view, box, front_of=True)
    phi = np.linspace(0, np.pi, 61)
    for name, colour in zip(SLOT_NAMES, SLOT_COLOURS):
        arc = view(on_sphere(hand.fingers[name]["theta_initial"], phi))
        picture.path(arc, closed=True, fill=colour, fill_opacity=0.11)
    for name, colour in zip(SLOT_NAMES, SLOT_COLOURS):
        theta = hand.fingers[name]["theta_initial"]
        picture.path(view(on_sphere(theta, phi)), stroke=colour, stroke_width=2.2)
        for angle in np.radians([60, 120]):
            picture.arrow(view.centre, view(on_sphere(theta, angle)), colour, 1.6, 9)
    # the pinky's plane turned by delta theta
    theta, turn = hand.fingers["pinky"]["theta_initial"], hand.fingers["pinky"]["delta_theta_range"][1]
    picture.path(view(on_sphere(theta + turn, phi)), stroke=SLOT_COLOURS[0], stroke_width=1.6, stroke_dasharray="5 4")
    way = view(on_sphere(np.linspace(theta, theta + turn, 9), np.radians(100)))
    picture.path(way[:-1], stroke=INK, stroke_width=1.8)
    picture.arrow(way[-3], way[-1], INK, 1.8, 8)
    picture.text(way[-1] + (-18, 4, 0), "Δθ", 16, "end", bold=True)
    for name, colour in zip(SLOT_NAMES, SLOT_COLOURS):
        tip = view(on_sphere(hand.fingers[name]["theta_initial"], hand.fingers[name]["tip_phi"]))
        picture.text(tip + (0, -14, 0), name, 15, colour=colour, bold=True)
    picture.text((250, 456), "five driving planes, each with two driving vectors", 15, colour=SOFT)


def draw_index_plane(picture, hand):
    finger = hand.fingers["index"]
    view, colour = plane_view(finger["theta_initial"], (730, 205), 142), SLOT_COLOURS[3]
    at, delta_r = np.radians([60, 120]), (-0.35, 0.25)
    action = [0.0] * 15
    action[11:13] = delta_r
    mesh = hand.triangles(hand.solve(action), {"palm", *hand.finger_links("index")})
    picture.mesh(*mesh, view, (520, 0, 480, 440), opacity=0.55)
    picture.circle(view.centre, view.scale, fill=SPHERE, fill_opacity=0.10, **AT_REST)
    phi = np.linspace(0, np.pi, 121)

    def place(angle, radius):
        return view(on_sphere(finger["theta_initial"], angle, radius))

    picture.path([place(0, 1), place(np.pi, 1 + delta_r[1])], stroke=SOFT, stroke_width=1, stroke_dasharray="2 4")
    picture.path(place(phi, 1 + displacement(phi, at, delta_r)), stroke=colour, stroke_width=3)
    for j, (angle, d) in enumerate(zip(at, delta_r), 1):
        reach = 0.14 + 0.17 * j
        picture.path(place(np.linspace(0, angle, 31), reach), stroke=SOFT, stroke_width=1.2)
        label = place(np.radians(65 * j - 38), reach + 0.09) + (0, 5, 0)
        picture.text(label, f"φ{subscript(j)}", 15, colour=SOFT)
        picture.path([place(angle, 0), place(angle, min(1, 1 + d))], stroke=SOFT, stroke_width=1.6)
        picture.arrow(place(angle, 1), place(angle, 1 + d), colour, 3, 11)
        picture.circle(place(angle, 1), 4, fill="#fff", stroke=SPHERE, stroke_width=2)
    picture.text(place(at[0], 1) + (40, 14, 0), "Δr = −0.35", 15, "start", bold=True)
    picture.text(place(at[1], 1.25) + (12, 2, 0), "Δr = +0.25", 15, "start", bold=True)
    pole = view([0, 0, -1])
    picture.path([pole + (0, 6, 0), pole + (0, 62, 0)], stroke=SOFT, stroke_width=1)
    picture.text(pole + (0, 78, 0), "0 at the palm", 14, colour=SOFT)
    picture.text(place(np.pi, 1.25) + (-12, 5, 0), f"constant beyond φ{subscript(2)}", 14, "end", colour=SOFT)
    picture.circle(view.centre, 3, fill=INK)
    picture.text((730, 456), "the plane of the index finger, which follows the deformed sphere", 15, colour=SOFT)


def cascade(bin_folder, output):
    hand = Hand("human_right", bin_folder)
    finger, delta_r, at = hand.fingers["index"], (-0.1, -0.45), np.radians([60, 120])
    picture = Picture(1000, 340, "The index finger from its side, four times: its surface points and their targets on "
                                 "the deformed sphere, at the start and after each of three joints has been fitted.")
    action = [0.0] * 15
    action[11:13] = delta_r
    solved, q = hand.solve(action), dict(hand.summary["q_sphere"])
    fitted = [joint["name"] for joint in finger["joints"] if joint["class"] == "encompassing"]
    for panel, joint in enumerate([None, *fitted]):
        if joint:
            q[joint] = solved[joint]
        draw_fit(picture, hand, finger, q, fitted, joint, lambda phi: displacement(phi, at, delta_r), 250 * panel)
    picture.circle((24, 30), 3.2, fill=INK)
    picture.text((34, 35), "surface point", 13, "start", SOFT)
    picture.circle((24, 52), 3.2, fill="#fff", stroke=TARGET, stroke_width=1.5)
    picture.text((34, 57), "its target", 13, "start", SOFT)
    picture.write(output / "cascade.svg")


def draw_fit(picture, hand, finger, q, fitted, joint, delta_r, x):
    theta = finger["theta_initial"]
    view, links = plane_view(theta, (x + 56, 104), 138), hand.finger_links(finger["name"])
    picture.mesh(*hand.triangles(q, {"palm", *links}), view, (x + 10, 0, 230, 284), opacity=0.42)
    phi = np.linspace(0, np.radians(130), 80)
    picture.path(view(on_sphere(theta, phi)), **AT_REST)
    picture.path(view(on_sphere(theta, phi, 1 + delta_r(phi))), stroke=TARGET, stroke_width=1.6)

    points = hand.surface_points(q, links)
    target = on_sphere(points["theta"], points["phi"], points["rho"] + delta_r(points["phi"]))
    residual = np.sqrt(np.average(((points["p"] - target) ** 2).sum(1), weights=points["weight"]))
    across = np.cross([np.cos(theta), np.sin(theta), 0], [0, 0, 1])
    middle = np.abs(target @ across) < 0.045
    for p, t in zip(view(points["p"][middle]), view(target[middle])):
        picture.path([p, t], stroke=TARGET, stroke_width=1, stroke_opacity=0.7)
        picture.circle(t, 2.6, fill="#fff", stroke=TARGET, stroke_width=1.3)
        picture.circle(p, 2.6, fill=INK)

    pose, done = hand.pose(q), fitted[:fitted.index(joint) + 1] if joint else []
    for name in fitted:
        at = view(pose[hand.child_link(name)][:3, 3])
        fill = "#ffd24d" if name == joint else "#2a9d6f" if name in done else "#fff"
        picture.circle(at, 9 if name == joint else 5.5, fill=fill, stroke=INK, stroke_width=1.6)
        if name == joint:
            picture.circle(at, 2, fill=INK)
    count = ("first", "second", "third")[fitted.index(joint)] if joint else None
    picture.text((x + 125, 306), f"{count} joint fitted" if joint else "start", 15, bold=True)
    picture.text((x + 125, 326), f"{residual:.3f} radii from the targets", 13, colour=SOFT)


def correspondences(bin_folder, output):
    hand = Hand("shadow_right", bin_folder, samples=4500)
    picture = Picture(1000, 400, "The surface points of the Shadow hand, each in one colour: at their coordinates on "
                                 "the sphere, on the hand wrapped on it, and on the hand closed further.")
    links = set(hand.meshes) - {"forearm", "wrist"}
    wrapped, closed = hand.summary["q_sphere"], hand.solve([0.0] * 5 + [-0.45] * 10)
    captions = ["(θ, φ): places on the sphere", "rays from the centre meet the hand", "another pose, the same points"]
    for panel, (q, caption) in enumerate(zip((None, wrapped, closed), captions)):
        x = 333 * panel
        view = View.from_direction(178, 52, (x + 167, 172), 128)
        points = hand.surface_points(q or wrapped, links, all_of_them=True)
        if q:
            seen = picture.mesh(*hand.triangles(q, links), view, (x, 0, 333, 366))(points["p"])
            draw_points(picture, view(points["p"])[seen], points, seen)
            if q is wrapped:
                draw_rays(picture, hand, view)
        else:
            ball(picture, view)
            draw_points(picture, view(on_sphere(points["theta"], points["phi"])), points, slice(None))
        picture.text((x + 167, 386), caption, 15, bold=True)
    picture.write(output / "correspondences.svg")


def draw_points(picture, at, points, which):
    """Dots, all of one colour in one path."""
    colours = np.stack([points[key] for key in ("red", "green", "blue")], -1)[which].astype(int) // 12 * 12
    dots = {}
    for (x, y), colour in zip(at[:, :2], map(tuple, colours.tolist())):
        dots.setdefault(colour, []).append(f"M{x:.1f} {y:.1f}h0")
    for colour, places in sorted(dots.items()):
        style = {"stroke": "#" + bytes(colour).hex(), "stroke_width": 5, "stroke_linecap": "round"}
        picture.add(f'<path d="{"".join(places)}"{attributes(style)}/>')


def draw_rays(picture, hand, view):
    """From the centre of the sphere to a point in the middle of each finger's outer half."""
    for name in SLOT_NAMES:
        points = hand.surface_points(hand.summary["q_sphere"], hand.finger_links(name))
        middle = np.argmin(np.abs(points["phi"] - 0.85 * hand.fingers[name]["tip_phi"]))
        picture.path(view([np.zeros(3), points["p"][middle]]), stroke=INK, stroke_width=1.4)
        picture.circle(view(points["p"][middle]), 3.4, fill="#fff", stroke=INK, stroke_width=1.4)
    picture.circle(view.centre, 4, fill=INK)


FIGURES = {"driving_planes": driving_planes, "cascade": cascade, "correspondences": correspondences}


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("figures", nargs="*", metavar="FIGURE", help=f"pictures to draw: {', '.join(FIGURES)} [all]")
    parser.add_argument("--bin", required=True, type=pathlib.Path, help="folder of the tools")
    parser.add_argument("-o", "--output", type=pathlib.Path, default=ROOT / "docs", help="folder to write to [docs]")
    arguments = parser.parse_args()
    for name in arguments.figures or FIGURES:
        FIGURES[name](arguments.bin.resolve(), arguments.output)


if __name__ == "__main__":
    main()
