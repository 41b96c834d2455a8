#!/usr/bin/env python3
"""Bad input, one row a kind: one line on stderr that says file, problem and remedy, exit code 1, nothing on stdout, and the
folder as it was: nothing written, nothing changed, nothing left behind.

    bad_input.py --bin build/dev/bin
"""
import argparse
import hashlib
import os
import pathlib
import shutil
import stat
import struct
import subprocess
import sys
import tempfile

import h5py

HERE = pathlib.Path(__file__).resolve().parent
HAND = HERE.parent.parent / "hands" / "allegro_right"

LARGE = 1 << 24  # bytes

LIMIT = '<limit lower="-1" upper="1" effort="1" velocity="1"/>'


def joint(name="knuckle", parent="palm", child="finger", inside='<axis xyz="0 1 0"/>' + LIMIT, kind="revolute"):
    return f'<joint name="{name}" type="{kind}"><parent link="{parent}"/><child link="{child}"/>{inside}</joint>\n'


def urdf(*elements, links=("palm", "finger")):
    return '<robot name="hand">\n' + "".join(f'<link name="{link}"/>\n' for link in links) + "".join(elements) + "</robot>\n"


def urdf_with_mesh(file):
    mesh = f'<link name="palm"><visual><geometry><mesh filename="{file}"/></geometry></visual></link>\n'
    return urdf(mesh, joint(), links=("finger",))


def actions(*values):
    return '{"format": "uhas-actions", "version": 1, "actions": [' + ", ".join(values) + "]}\n"


def lying_stl():
    """A binary STL that claims 100 million triangles and holds two."""
    return b" " * 80 + struct.pack("<I", 100_000_000) + bytes(100)


def stl_of_triangles(count):
    """A binary STL that holds as many triangles as it says."""
    corners = struct.pack("<12fH", 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0)
    return b" " * 80 + struct.pack("<I", count) + corners * count


def ply_of_vertices(count):
    """A PLY of one triangle and that many vertices."""
    return ("ply\nformat ascii 1.0\nelement vertex %d\nproperty uchar x\nelement face 1\nproperty list uchar int vertex_indices\n"
            "end_header\n" % count + "0\n" * count + "3 0 1 2\n")


def dae(indices="0 1 2", stride=3):
    """One triangle."""
    return ('<COLLADA version="1.4.1"><library_geometries><geometry id="g"><mesh><source id="p"><float_array id="a" count="9">'
            f'0 0 0 1 0 0 0 1 0</float_array><technique_common><accessor source="#a" count="3" stride="{stride}">'
            '<param name="X" type="float"/><param name="Y" type="float"/><param name="Z" type="float"/></accessor>'
            '</technique_common></source><vertices id="v"><input semantic="POSITION" source="#p"/></vertices>'
            f'<triangles count="1"><input semantic="VERTEX" source="#v" offset="0"/><p>{indices}</p></triangles></mesh></geometry>'
            '</library_geometries><library_visual_scenes><visual_scene id="s"><node id="n"><instance_geometry url="#g"/></node>'
            '</visual_scene></library_visual_scenes><scene><instance_visual_scene url="#s"/></scene></COLLADA>')


def crashing_trajectory():
    """A trajectory whose first name is number 2^32 - 1 of the names that the file holds, which HDF5 1.10.8 does not check."""
    with h5py.File("t.h5", "w") as file:
        file["q"] = [[0.4]]
        file["joint_names"] = ["index_joint_0"]
        name = file["joint_names"].id.get_offset()  # its length, the address of the names, the number
    content = bytearray(pathlib.Path("t.h5").read_bytes())
    content[name + 12:name + 16] = b"\xff" * 4
    write({"t.h5": bytes(content)})


BUILD = "uhas-build-profile hand.urdf -o new.h5"
SOLVE = "uhas-solve actions.json --profile hand.h5 -o new.json"
INSPECT = "uhas-inspect broken.h5"
RETARGET = "uhas-retarget --from hand.h5 --to hand.h5 t.h5 -o new.h5"

# (what is wrong, command, files or a function that makes them, message after `tool: error: `), with FOLDER for the folder
# that the model may read from
CASES = [
    # the URDF
    ("missing file", BUILD, {}, "hand.urdf: the file does not exist; check the path"),
    ("a folder", BUILD, lambda: os.mkdir("hand.urdf"), "hand.urdf: is not a regular file; check the path and its permissions"),
    ("a pipe", BUILD, lambda: os.mkfifo("hand.urdf"), "hand.urdf: is not a regular file; check the path and its permissions"),
    ("a loop of symbolic links", BUILD, lambda: os.symlink("hand.urdf", "hand.urdf"),
     "hand.urdf: cannot be opened: Too many levels of symbolic links; check the path and its permissions"),
    ("a URDF that may not be read", BUILD, lambda: unreadable({"hand.urdf": urdf(joint())}),
     "hand.urdf: cannot be opened: Permission denied; check the path and its permissions"),
    ("not XML", BUILD, {"hand.urdf": "hello"},
     "hand.urdf: this is not well-formed XML (Error document empty.); correct the file"),
    ("XML that ends early", BUILD, {"hand.urdf": urdf(joint())[:-12]},
     "hand.urdf:4: the XML ends inside a tag or comment; complete the file"),
    ("not a URDF", BUILD, {"hand.urdf": "<sdf/>"},
     "hand.urdf: this is not a URDF: the root element is <sdf>, not <robot>; name a URDF file"),
    ("xacro", "uhas-build-profile hand.xacro -o new.h5", {"hand.xacro": urdf(joint())},
     "hand.xacro: this is a xacro file, not a URDF; expand it first: xacro hand.xacro > hand.urdf"),
    ("nested 200,000 deep", BUILD, {"hand.urdf": '<robot name="x">' + "<a>" * 200_000},
     "hand.urdf:1: elements are nested more than 100 deep; flatten the file"),
    ("a cycle", BUILD, {"hand.urdf": urdf(joint(), joint("back", "finger", "palm"))},
     "hand.urdf: the links form a cycle, so there is no root link; break it by removing a joint"),
    ("a cycle apart from the root", BUILD,
     {"hand.urdf": urdf(joint(), joint("k", "a", "b"), joint("l", "b", "a"), links=("palm", "finger", "a", "b"))},
     "hand.urdf: link 'a' hangs on a cycle of joints, apart from the root; break the cycle by removing a joint"),
    ("a disconnected tree", BUILD, {"hand.urdf": urdf(joint(), links=("palm", "finger", "lost"))},
     "hand.urdf: there are several root links, 'lost' and 'palm'; connect them by a fixed joint or remove one"),
    ("two parents", BUILD, {"hand.urdf": urdf(joint(), joint("k", "palm", "b"), joint("l", "b", "finger"),
                                              links=("palm", "finger", "b"))},
     "hand.urdf: link 'finger' has two parents, through joints 'knuckle' and 'l'; remove one of the joints"),
    ("an unknown parent", BUILD, {"hand.urdf": urdf(joint(parent="wrist"))},
     "hand.urdf: joint 'knuckle' has the unknown parent link 'wrist'; name a link of the file"),
    ("a link that is its own parent", BUILD, {"hand.urdf": urdf(joint(parent="finger"))},
     "hand.urdf: joint 'knuckle' has one link as parent and child; name two links"),
    ("a zero axis", BUILD, {"hand.urdf": urdf(joint(inside='<axis xyz="0 0 0"/>' + LIMIT))},
     "hand.urdf: joint 'knuckle' has an axis of length zero or without a direction; give its <axis> a direction, for"
     " example xyz=\"0 0 1\""),
    ("lower above upper", BUILD, {"hand.urdf": urdf(joint(inside=LIMIT.replace("-1", "2")))},
     "hand.urdf: joint 'knuckle' has a lower limit above its upper limit; exchange them"),
    ("no limits", BUILD, {"hand.urdf": urdf(joint(inside=""))},
     "hand.urdf: Joint [knuckle] is of type REVOLUTE but it does not specify limits, joint xml is not initialized "
     "correctly; correct the URDF"),
    ("a limit that is NaN", BUILD, {"hand.urdf": urdf(joint(inside=LIMIT.replace('"1"', '"nan"', 1)))},
     "hand.urdf: upper value (nan) is not a valid float, Could not parse limit element for joint [knuckle]; correct the URDF"),
    ("an absurd limit", BUILD, {"hand.urdf": urdf(joint(inside=LIMIT.replace('"1"', '"1e16"', 1)))},
     "hand.urdf: joint 'knuckle' has a limit beyond 1000 rad or m; correct it, or use type=\"continuous\" for a joint "
     "without limits"),
    ("an absurd origin", BUILD, {"hand.urdf": urdf(joint(inside='<origin xyz="1e30 0 0"/>' + LIMIT))},
     "hand.urdf: joint 'knuckle' has an origin that is not finite or more than 100 m away; give its <origin> in metres"),
    ("no movable joint", BUILD, {"hand.urdf": urdf(joint(inside="", kind="fixed"))},
     "hand.urdf: the model has no movable joint; name the URDF of a hand"),
    ("a floating joint", BUILD, {"hand.urdf": urdf(joint(inside="", kind="floating"))},
     "hand.urdf: joint 'knuckle' is floating or planar, which no joint of a hand can be; use fixed, revolute, "
     "continuous or prismatic joints"),
    ("a mimic of nothing", BUILD, {"hand.urdf": urdf(joint(inside=LIMIT + '<mimic joint="nobody"/>'))},
     "hand.urdf: joint 'knuckle' mimics 'nobody', which is no joint of the file; let it mimic an independent movable joint"),
    ("a mimic cycle", BUILD,
     {"hand.urdf": urdf(joint(inside=LIMIT + '<mimic joint="k"/>'), joint("k", "palm", "b", LIMIT + '<mimic joint="knuckle"/>'),
                        links=("palm", "finger", "b"))},
     "hand.urdf: joint 'k' mimics itself, through a cycle; let it mimic an independent movable joint"),
    ("no hand", BUILD, {"hand.urdf": urdf(joint())},
     'hand.urdf: only one finger was found; a hand needs two or more chains of movable joints on one palm; name the '
     'palm with "palm_link" in a hand config'),
    ("fingers without length", BUILD,
     {"hand.urdf": urdf(*(joint(f"joint{i}", "palm", f"link{i}") for i in range(3)), links=["palm", "link0", "link1", "link2"])},
     "hand.urdf: the finger of joint 'joint0' has no length: its tip lies on its joints; give its last link geometry, or name "
     'the joints of each finger by "fingers" in a hand config'),
    ("a larger URDF than any robot's", BUILD, lambda: sparse_file("hand.urdf", (16 << 20) + 1),
     "hand.urdf: has 16777217 bytes, more than the bound of 16777216; cut the hand out of its robot or raise the bound by "
     "--limit urdf-bytes=N"),
    ("a tag of 20,000 characters", BUILD, {"hand.urdf": '<robot name="' + "x" * 20_000 + '"/>'},
     "hand.urdf:1: a tag is longer than 16384 characters; shorten it"),
    ("a hundred fingers", BUILD,
     {"hand.urdf": urdf(*(joint(f"joint{i}", "palm", f"link{i}") for i in range(100)),
                        links=["palm", *(f"link{i}" for i in range(100))])},
     "hand.urdf: 100 chains of movable joints hang on one palm, too many for fingers; name the joints of each finger by "
     '"fingers" in a hand config'),
    # meshes
    ("a missing mesh", BUILD, {"hand.urdf": urdf_with_mesh("palm.stl")}, "palm.stl: the file does not exist; check the path"),
    ("a mesh on the network", BUILD, {"hand.urdf": urdf_with_mesh("https://example.org/palm.stl")},
     "hand.urdf: the mesh https://example.org/palm.stl is not on this machine; download it and name it by a path, "
     "file:// or package://"),
    ("a mesh of an unknown package", BUILD, {"hand.urdf": urdf_with_mesh("package://acme/palm.stl")},
     "hand.urdf: the mesh package://acme/palm.stl is in no folder known for its package; name its folder by --package NAME=DIR or "
     "set ROS_PACKAGE_PATH"),
    ("a mesh in a loop of symbolic links", BUILD,
     lambda: (write({"hand.urdf": urdf_with_mesh("palm.stl")}), os.symlink("palm.stl", "palm.stl")),
     "palm.stl: cannot be opened: Too many levels of symbolic links; check the path and its permissions"),
    ("a mesh that may not be read", BUILD,
     lambda: (write({"hand.urdf": urdf_with_mesh("palm.stl")}), unreadable({"palm.stl": stl_of_triangles(2)})),
     "palm.stl: cannot be opened: Permission denied; check the path and its permissions"),
    ("a mesh in a folder that may not be entered", BUILD,
     lambda: (write({"hand.urdf": urdf_with_mesh("meshes/palm.stl")}), os.mkdir("meshes", 0)),
     "meshes/palm.stl: cannot be opened: Permission denied; check the path and its permissions"),
    ("a mesh outside the folder of the model", BUILD, {"hand.urdf": urdf_with_mesh("../../palm.stl")},
     "hand.urdf: the mesh ../../palm.stl lies outside FOLDER, the folder of the model; name its package by --package NAME=DIR, "
     "or pass --allow-outside if you trust the model"),
    ("a symbolic link out of the folder of the model", BUILD,
     lambda: (write({"hand.urdf": urdf_with_mesh("palm.stl")}), os.symlink("/etc/passwd", "palm.stl")),
     "hand.urdf: the mesh palm.stl lies outside FOLDER, the folder of the model; name its package by --package NAME=DIR, "
     "or pass --allow-outside if you trust the model"),
    ("an empty mesh", BUILD, {"hand.urdf": urdf_with_mesh("palm.stl"), "palm.stl": ""},
     "palm.stl: the mesh file is empty; export the mesh again"),
    ("a mesh without triangles", BUILD, {"hand.urdf": urdf_with_mesh("palm.stl"), "palm.stl": "solid x\nendsolid x\n"},
     "palm.stl: the mesh has no triangle; export the mesh again"),
    ("a corrupt mesh", BUILD, {"hand.urdf": urdf_with_mesh("palm.dae"), "palm.dae": "<COLLADA><asset>"},
     "palm.dae: the mesh cannot be read (Unable to read file, malformed XML); export the mesh again"),
    ("a mesh whose indices are no numbers", BUILD, {"hand.urdf": urdf_with_mesh("palm.dae"), "palm.dae": dae(indices="0 1 z")},
     "palm.dae:1: a list of indices holds something else; export the mesh again"),
    ("a mesh that brings assimp down", BUILD, {"hand.urdf": urdf_with_mesh("palm.dae"), "palm.dae": dae(stride=900000000)},
     "palm.dae: the process that read it was brought down (Segmentation fault); do not trust the file"),
    ("a mesh of another format", BUILD, {"hand.urdf": urdf_with_mesh("palm.fbx"), "palm.fbx": "x"},
     "palm.fbx: meshes of the type '.fbx' cannot be read; convert it to STL, OBJ, DAE, PLY, GLB or glTF"),
    ("a mesh that claims 100 million triangles", BUILD, {"hand.urdf": urdf_with_mesh("palm.stl"), "palm.stl": lying_stl()},
     "palm.stl: the mesh cannot be read (Failed to determine STL storage representation for palm.stl.); export the mesh again"),
    ("more triangles than allowed", BUILD + " --limit triangles=9",
     {"hand.urdf": urdf_with_mesh("palm.stl"), "palm.stl": stl_of_triangles(10)},
     "palm.stl: the mesh has more triangles than the bound of 9 for a hand; simplify the model or raise the bound by --limit triangles=N"),
    ("a larger mesh file than allowed", BUILD + " --limit mesh-bytes=583",
     {"hand.urdf": urdf_with_mesh("palm.stl"), "palm.stl": stl_of_triangles(10)},
     "palm.stl: has 584 bytes, more than the bound of 583; simplify the mesh or raise the bound by --limit mesh-bytes=N"),
    ("a larger mesh file than any hand's", BUILD,
     lambda: (write({"hand.urdf": urdf_with_mesh("palm.stl")}), sparse_file("palm.stl", (512 << 20) + 1)),
     "palm.stl: has 536870913 bytes, more than the bound of 536870912; simplify the mesh or raise the bound by --limit mesh-bytes=N"),
    ("few triangles and very many vertices", BUILD + " --limit triangles=9",
     {"hand.urdf": urdf_with_mesh("palm.ply"), "palm.ply": ply_of_vertices(28)},
     "palm.ply: the mesh has more vertices than the bound of 27, three for each triangle of a hand; leave out unused ones or "
     "raise the bound by --limit triangles=N"),
    ("more links than any robot has", BUILD,
     {"hand.urdf": urdf(*(joint(f"joint{i}", "palm", f"link{i}") for i in range(2000)),
                        links=["palm", *(f"link{i}" for i in range(2000))])},
     "hand.urdf: has 2001 links, more than the bound of 2000; cut the hand out of its robot or raise the bound by --limit links=N"),
    # hand configs
    ("a config that may not be read", BUILD + " --config config.json",
     lambda: (write({"hand.urdf": urdf(joint())}), unreadable({"config.json": "{}"})),
     "config.json: cannot be opened: Permission denied; check the path and its permissions"),
    ("a config that is not JSON", BUILD + " --config config.json", {"config.json": "{", "hand.urdf": urdf(joint())},
     "config.json:1: not JSON: syntax error while parsing object key - unexpected end of input; expected string literal; correct the syntax"),
    ("a config with an unknown key", BUILD + " --config config.json",
     {"config.json": '{"palm": "x"}', "hand.urdf": urdf(joint())},
     'config.json: unknown key "palm"; did you mean "palm_link"?'),
    ("a missing config", BUILD + " --config config.json", {"hand.urdf": urdf(joint())},
     "config.json: the file does not exist; check the path"),
    ("a larger config than any hand's", BUILD + " --config config.json", lambda: sparse_file("config.json", (1 << 20) + 1),
     "config.json: has 1048577 bytes, more than the bound of 1048576; make sure that it is a hand config, or raise the bound by "
     "--limit config-bytes=N"),
    ("a config nested 100,000 deep", BUILD + " --config config.json", {"config.json": "[" * 100_000},
     "config.json: nested more than 8 levels deep; use fewer levels"),
    # actions
    ("missing actions", SOLVE, {}, "actions.json: the file does not exist; check the path"),
    ("actions that may not be read", SOLVE, lambda: unreadable({"actions.json": actions("[]")}),
     "actions.json: cannot be opened: Permission denied; check the path and its permissions"),
    ("actions that are not JSON", SOLVE, {"actions.json": "[1, 2"},
     "actions.json:1: not JSON: syntax error while parsing array - unexpected end of input; expected ']'; correct the syntax"),
    ("too short an action", SOLVE, {"actions.json": actions("[0, 0]")},
     "actions.json: action 0: has 2 numbers; write 5 + 5 V numbers for V = 1 to 4 driving vectors, 15 for the usual two"),
    ("NaN in an action", SOLVE, {"actions.json": actions("[" + "0, " * 14 + "NaN]")},
     "actions.json:1: not JSON: syntax error while parsing value - invalid literal; last read: '0, N'; correct the syntax"),
    ("infinity in an action", SOLVE, {"actions.json": actions("[" + "0, " * 14 + "1e999]")},
     "actions.json: number overflow parsing '1e999'; write numbers within the range of double"),
    ("a string in an action", SOLVE, {"actions.json": actions("[" + "0, " * 14 + '"1"]')},
     'actions.json: action 0: element 14 is "1"; write a number'),
    ("another version", SOLVE, {"actions.json": actions("[]").replace('"version": 1', '"version": 2')},
     'actions.json: version is 2, this tool reads 1; write "version": 1'),
    ("nested 100,000 deep", SOLVE, {"actions.json": "[" * 100_000},
     "actions.json: nested more than 8 levels deep; use fewer levels"),
    ("an object of very many keys", SOLVE, {"actions.json": "{" + ", ".join(f'"k{i}": 0' for i in range(10_001)) + "}"},
     "actions.json: an object has more than 10000 keys; use fewer keys"),
    ("a larger file of actions than allowed", SOLVE, lambda: sparse_file("actions.json", (64 << 20) + 1),
     "actions.json: has 67108865 bytes, more than the bound of 67108864; split it, or raise the bound by --limit json-bytes=N"),
    ("more actions than a file may have", SOLVE, {"actions.json": actions(*["[]"] * 1_000_001)},
     "actions.json: has 1000001 actions, more than the bound of 1000000 for a file; stream them through uhas-solve -, which "
     "takes any number, or raise the bound by --limit actions=N"),
    # profiles
    ("a profile that may not be read", INSPECT, lambda: (edit_profile(lambda b: b), os.chmod("broken.h5", 0)),
     "broken.h5: cannot be opened: Permission denied; check the path and its permissions"),
    ("a truncated profile", INSPECT, lambda: edit_profile(lambda b: b[:-1]),
     "broken.h5: the file is truncated: it has 326751 bytes of 326752; rebuild it with uhas-build-profile"),
    ("a profile cut within its first block", INSPECT, lambda: edit_profile(lambda b: b[:100]),
     "broken.h5: the file is truncated: it has 100 bytes of 326752; rebuild it with uhas-build-profile"),
    ("a flipped bit", INSPECT, lambda: edit_profile(lambda b: b[:9999] + bytes([b[9999] ^ 1]) + b[10000:]),
     "broken.h5: the file is damaged: its content does not have the SHA-256 and length that it states; rebuild it "
     "with uhas-build-profile, or reseal it with uhas-inspect if you edited it"),
    ("bytes after the end", INSPECT, lambda: edit_profile(lambda b: b + b"x"),
     "broken.h5: the file is damaged: its content does not have the SHA-256 and length that it states; rebuild it "
     "with uhas-build-profile, or reseal it with uhas-inspect if you edited it"),
    ("another major version", INSPECT, lambda: edit_profile(lambda b: b.replace(b"hand-profile 1.", b"hand-profile 2.", 1)),
     "broken.h5: the profile has format version 2.0, this reader knows version 1.0; rebuild it with uhas-build-profile"),
    ("alien HDF5", INSPECT, lambda: edit_profile(lambda b: b[512:]),
     "broken.h5: this is not a hand profile: it does not begin with 'uhas-hand-profile'; name a file that uhas-"
     "build-profile wrote"),
    ("an empty profile", INSPECT, {"broken.h5": ""}, "broken.h5: the file is empty; rebuild it with uhas-build-profile"),
    ("a profile that is text", INSPECT, {"broken.h5": "hello"},
     "broken.h5: this is not a hand profile: it does not begin with 'uhas-hand-profile'; name a file that uhas-"
     "build-profile wrote"),
    ("a larger profile than any hand's", INSPECT, lambda: sparse_file("broken.h5", (256 << 20) + 1),
     "broken.h5: has 268435457 bytes, more than the bound of 268435456; make sure that it is the right file"),
    # trajectories
    ("a larger trajectory than allowed", RETARGET.replace("t.h5", "t.json"), lambda: sparse_file("t.json", (64 << 20) + 1),
     "t.json: has 67108865 bytes, more than the bound of 67108864; split it, or raise the bound by --limit json-bytes=N"),
    ("a trajectory with a line of 2 MiB", RETARGET.replace("t.h5", "t.jsonl"), {"t.jsonl": " " * (2 << 20)},
     "t.jsonl:1: the line is longer than 1 MiB; write one frame a line"),
    ("a trajectory of 8 GiB", RETARGET,
     lambda: trajectory(lambda file: file.create_dataset("q", (1 << 20, 1024), "f8", chunks=(64, 1024))),
     "t.h5: /q is larger than a trajectory can be; cut it into parts or raise the bound by --limit hdf5-bytes=N"),
    ("a trajectory that may not be read", RETARGET, lambda: unreadable({"t.h5": "hello"}),
     "t.h5: cannot be opened: Permission denied; check the path and its permissions"),
    ("a trajectory that is text", RETARGET, {"t.h5": "hello"},
     "t.h5: cannot be opened as HDF5; check the path and what wrote the file"),
    ("a trajectory that links to another file", RETARGET,
     lambda: trajectory(lambda file: file.update(q=h5py.ExternalLink("hand.h5", "/q"))),
     "t.h5: /q is a soft, external or user-defined link; store plain numbers and names"),
    ("a trajectory stored in another file", RETARGET,
     lambda: trajectory(lambda file: file.create_dataset("q", (2, 2), "f8", external=[("hand.h5", 0, 32)])),
     "t.h5: /q is stored in other files; store plain numbers and names"),
    ("a trajectory that brings the HDF5 library down", RETARGET, crashing_trajectory,
     "t.h5: the process that read it was brought down (Segmentation fault); do not trust the file"),
    ("a trajectory of compound values", RETARGET,
     lambda: trajectory(lambda file: file.create_dataset("q", (2, 2), [("a", "f8"), ("b", "f8")])),
     "t.h5: /q is neither of numbers nor of fixed-length strings; store plain numbers and names"),
    ("a trajectory of terabytes", RETARGET,
     lambda: trajectory(lambda file: file.create_dataset("q", (1 << 40, 16), "f8", chunks=(1024, 16))),
     "t.h5: /q has more rows than a trajectory can have; cut it into parts or raise the bound by --limit hdf5-bytes=N"),
    ("a trajectory whose chunk is a gigabyte", RETARGET,
     lambda: trajectory(lambda file: file.create_dataset("q", (1 << 23, 16), "f8", chunks=(1 << 23, 16))),
     "t.h5: /q has a larger chunk than a trajectory can have; store it in smaller chunks"),
]


def trajectory(fill):
    """An HDF5 file `t.h5` that `fill` writes into."""
    with h5py.File("t.h5", "w") as file:
        fill(file)


def unreadable(files):
    write(files)
    for name in files:
        os.chmod(name, 0)


def without_privileges():
    """What a command begins with so that permissions bind it, as they do not bind root; None when that cannot be had."""
    prefix = ["setpriv", "--inh-caps=-all", "--bounding-set=-all"] if os.geteuid() == 0 else []
    with tempfile.NamedTemporaryFile() as file:
        os.chmod(file.name, 0)
        try:
            done = subprocess.run([*prefix, "cat", file.name], capture_output=True)
        except FileNotFoundError:
            return None
    return prefix if b"Permission denied" in done.stderr else None


def sparse_file(name, size):
    """A file of that many zeros, which take no room on the disk."""
    pathlib.Path(name).touch()
    os.truncate(name, size)


def write(files):
    for name, content in files.items():
        pathlib.Path(name).write_bytes(content if isinstance(content, bytes) else content.encode())


def edit_profile(change):
    write({"broken.h5": change(pathlib.Path("hand.h5").read_bytes())})


def listing():
    """Everything in the current folder: names, kinds and contents; of large or unreadable files size and time."""
    entries = {}
    for entry in sorted(pathlib.Path().iterdir()):
        status = entry.lstat()
        if not stat.S_ISREG(status.st_mode):
            entries[entry.name] = status.st_mode
        elif status.st_size > LARGE or status.st_mode & stat.S_IRUSR == 0:
            entries[entry.name] = status.st_size, status.st_mtime_ns
        else:
            entries[entry.name] = hashlib.sha256(entry.read_bytes()).hexdigest()
    return entries


def run(command, files, prefix, environment):
    """(exit code, stdout, stderr, whether the folder is as it was) of the command in a folder of those files."""
    if callable(files):
        files()
    else:
        write(files)
    before = listing()
    done = subprocess.run([*prefix, *command.split()], env=environment, stdin=subprocess.DEVNULL, capture_output=True, text=True, timeout=60)
    stderr = done.stderr.replace(os.path.realpath("."), "FOLDER").replace(os.path.realpath(".."), "FOLDER")
    return done.returncode, done.stdout, stderr, listing() == before


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--bin", required=True, type=pathlib.Path, help="folder of the built tools")
    options = parser.parse_args()
    environment = dict(os.environ, PATH=f"{options.bin.resolve()}{os.pathsep}{os.environ['PATH']}", LC_ALL="C")
    environment.pop("ROS_PACKAGE_PATH", None)

    failed = skipped = 0
    prefix = without_privileges()
    with tempfile.TemporaryDirectory() as scratch:
        profile = pathlib.Path(scratch) / "hand.h5"
        subprocess.run(["uhas-build-profile", "--quiet", HAND / "allegro_right.urdf", "-o", profile], env=environment,
                       check=True)
        for number, (name, command, files, message) in enumerate(CASES):
            folder = pathlib.Path(scratch) / str(number)
            folder.mkdir()
            os.chdir(folder)
            shutil.copy(profile, "hand.h5")
            if prefix is None and "Permission denied" in message:
                print(f"SKIPPED: {name}: permissions do not bind here")
                skipped += 1
                continue
            result = run(command, files, prefix or [], environment)
            expected = (1, "", f"{command.split()[0]}: error: {message}\n", True)
            print(f"{'ok' if result == expected else 'FAILED':6}  {name}")
            if result != expected:
                failed += 1
                print(f"  expected {expected}\n  found    {result}")
    print(f"{len(CASES)} cases, {failed} failed, {skipped} skipped")
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
