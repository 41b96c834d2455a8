#!/usr/bin/env python3
"""Checks that includes follow the arrows between the rooms of lib/uhas, and that no text in lib names an option of the tools:
errors name fields of the library, which the tools translate.

    layering.py SOURCE_FOLDER      exit 1 when a file in lib, tools or tests includes what its place must not
    layering.py --self-test        exit 1 when one of the forbidden includes and texts planted here goes unnoticed
"""

import pathlib
import re
import sys
import tempfile

from planted import self_test

# Which rooms a room includes, besides itself. Data flows down this list, and so do all arrows.
STAGE = ["base", "profile", "kinematics", "model"]
ROOMS = {
    "base": [],
    "files": ["base"],
    "fence": ["base", "files"],
    "hdf5": ["base"],
    "profile": ["base"],
    "profile_io": ["base", "files", "fence", "hdf5", "profile"],
    "kinematics": ["base", "profile"],
    "runtime": ["base", "profile", "kinematics"],
    "c": ["base", "profile", "profile_io", "runtime"],
    "json": ["base", "files"],
    "model": ["base", "files", "fence", "profile"],
    "anatomy": [*STAGE, "json"],
    "sphere_frame": [*STAGE, "anatomy"],
    "classification": [*STAGE, "anatomy", "sphere_frame"],
    "wrap": [*STAGE, "anatomy", "sphere_frame", "classification"],
    "lateral_tables": [*STAGE, "anatomy", "sphere_frame", "classification", "wrap"],
    "correspondences": [*STAGE, "anatomy", "sphere_frame"],
    "profile_builder": [*STAGE, "json", "anatomy", "sphere_frame", "classification", "wrap", "lateral_tables", "correspondences"],
    "geometry": ["base", "profile", "model"],
    "collision": [*STAGE, "runtime", "geometry"],
    "evaluation": [*STAGE, "runtime", "geometry", "collision"],
    "trajectory": ["base", "files", "fence", "hdf5", "runtime", "json"],
    "report": [*STAGE, "json", "profile_io", "runtime", "geometry"],
}

# The rooms that may include a library; every other library but C++'s and the system's own is for nobody in lib.
LIBRARIES = {
    "Eigen": list(ROOMS),
    "hdf5": ["hdf5", "profile_io"],
    "urdf_parser": ["model"],
    "urdf_model": ["model"],
    "tinyxml": ["model"],
    "console_bridge": ["model"],
    "assimp": ["model", "report"],
    "nlohmann": ["json", "model"],
    "embree3": ["correspondences"],
    "embree4": ["correspondences"],
    "meshoptimizer": ["geometry"],
    "fcl": ["collision"],
    "nlopt": ["evaluation"],
}

# The headers that are installed, one a line after its library: they include C++'s own and each other, nothing else.
PUBLIC_HEADERS = "lib/public_headers.txt"
REFERENCE = "Doxyfile"  # describes the same headers

SYSTEM = re.compile(r"[a-z0-9_]+|(?:sys/)?[a-z]+\.h")  # <vector>, <cstdint>; <unistd.h>, <sys/stat.h>
INCLUDE = re.compile(r'^\s*#\s*include\s*(["<])([^">]+)[">]', re.MULTILINE)
TEXT = re.compile(r'//[^\n]*|"((?:[^"\\\n]|\\.)*)"')  # a comment, or a text in the first group
OPTION = re.compile(r"(?<!\S)--[a-z]")
SOURCES = {".hpp", ".cpp", ".h", ".c"}


def library_of(header):
    """The first part of a header's path: `assimp` of assimp/scene.h, `hdf5` of hdf5.h."""
    return re.split(r"[/.]", header)[0]


def problem_in_lib(path, public, quoted, header):
    """What is wrong with this include in a file of lib/uhas, or None. `path` is relative to lib/uhas, `public` lists such paths."""
    room, installed = path.parts[0], path.as_posix() in public
    if quoted:
        match = re.fullmatch(r"uhas/((\w+)/(?:(\w+)/)?[\w.]+)", header)
        if not match:
            return 'write "uhas/<room>/<file>.hpp"'
        included, other, folder = match.groups()
        if other not in ROOMS:
            return f"there is no room {other}"
        if other != room and other not in ROOMS[room]:
            return f"{room} may include only {', '.join(ROOMS[room]) or 'nothing of the other rooms'}"
        if other != room and folder:
            return f"folders in a room are its own: a private header of {other}"
        if installed and included not in public:
            return f"an installed header includes one that is not: add it to {PUBLIC_HEADERS} or do without it"
        return None
    library = library_of(header)
    if library in LIBRARIES:
        if room not in LIBRARIES[library]:
            return f"{library} is for {', '.join(LIBRARIES[library])} only"
        if installed:
            return f"an installed header must not need {library}"
    elif not SYSTEM.fullmatch(header):
        return "not a library that lib uses"
    return None


def problem_outside(place, quoted, header):
    """What is wrong with this include in tools or tests, or None. Private headers are open to tests, to try them alone."""
    if header.startswith("uhas/"):
        if not quoted:
            return 'write "uhas/<room>/<file>.hpp"'
        room = header.split("/")[1]
        if room not in ROOMS:
            return f"there is no room {room}"
        if place == "tools" and header.count("/") > 2:
            return f"folders in a room are its own: a private header of {room}"
    elif place == "tools" and header.startswith(("support/", "tests/")):
        return "tools must not include tests"
    return None


def public_headers(root):
    return [line.split()[1] for line in (root / PUBLIC_HEADERS).read_text().splitlines()]


def problems(root):
    """One line for each include against the arrows and each text with an option, and the number of files read."""
    found, files = [], 0
    public = public_headers(root)
    found += [f"{PUBLIC_HEADERS}: there is no {header}" for header in public if not (root / "lib/uhas" / header).is_file()]
    for place in ("lib", "tools", "tests"):
        for path in sorted((root / place).rglob("*")):
            if path.suffix not in SOURCES or not path.is_file():
                continue
            files += 1
            text = path.read_text(encoding="utf-8")
            parts = path.relative_to(root).parts  # lib, uhas, <room>, [<folder>,] <file>
            for match in INCLUDE.finditer(text):
                quoted, header = match[1] == '"', match[2]
                if place != "lib":
                    problem = problem_outside(place, quoted, header)
                elif len(parts) not in (4, 5) or parts[2] not in ROOMS:
                    problem = "a file outside the rooms"
                else:
                    problem = problem_in_lib(path.relative_to(root / "lib/uhas"), public, quoted, header)
                if problem:
                    line = text.count("\n", 0, match.start(1)) + 1
                    found.append(f"{path.relative_to(root)}:{line}: {header}: {problem}")
            for match in TEXT.finditer(text) if place == "lib" else ():
                if OPTION.search(match[1] or ""):
                    line = text.count("\n", 0, match.start()) + 1
                    found.append(f"{path.relative_to(root)}:{line}: names an option: name the field, and word it in "
                                 "tools/command_line/option_names.cpp")
    return found, files


# file, what it includes, whether that is against the arrows; this one alone is installed:
PLANTED_PUBLIC = "runtime/cascade_solver.hpp"
PLANTED = [
    ("lib/uhas/base/errors.hpp", "<vector>", False),
    ("lib/uhas/base/errors.hpp", '"uhas/profile/hand_profile.hpp"', True),
    ("lib/uhas/hdf5/handle.hpp", "<hdf5.h>", False),
    ("lib/uhas/profile_io/write_profile.cpp", "<hdf5.h>", False),
    ("lib/uhas/profile_io/write_profile.cpp", '"uhas/anatomy/anatomy.hpp"', True),
    ("lib/uhas/runtime/cascade/lead.cpp", "<Eigen/Core>", False),
    ("lib/uhas/runtime/cascade_solver.cpp", '"uhas/runtime/cascade/cascade.hpp"', False),
    ("lib/uhas/runtime/cascade/lead.cpp", '"uhas/model/hand_model.hpp"', True),
    ("lib/uhas/runtime/cascade_solver.cpp", '"uhas/profile_io/read_profile.hpp"', True),
    ("lib/uhas/runtime/cascade_solver.cpp", "<hdf5.h>", True),
    ("lib/uhas/runtime/cascade_solver.hpp", "<Eigen/Core>", True),
    ("lib/uhas/runtime/cascade_solver.hpp", '"uhas/runtime/cascade/cascade.hpp"', True),
    ("lib/uhas/c/profile.cpp", '"uhas/profile_io/read_profile.hpp"', False),
    ("lib/uhas/runtime/cascade_solver.cpp", '"uhas/c/uhas.h"', True),
    ("lib/uhas/anatomy/palm/palm_tree.cpp", '"uhas/model/hand_model.hpp"', False),
    ("lib/uhas/anatomy/palm/palm_tree.cpp", '"uhas/anatomy/fingers/digits.hpp"', False),
    ("lib/uhas/anatomy/anatomy.cpp", '"uhas/model/meshes/mesh_reader.hpp"', True),
    ("lib/uhas/anatomy/anatomy.cpp", '"anatomy.hpp"', True),
    ("lib/uhas/anatomy/anatomy.cpp", "<uhas/anatomy/anatomy.hpp>", True),
    ("lib/uhas/anatomy/anatomy.cpp", "<assimp/scene.h>", True),
    ("lib/uhas/anatomy/anatomy.cpp", "<boost/optional.hpp>", True),
    ("lib/uhas/collision/surfaces/link_surface.hpp", "<fcl/geometry/bvh/BVH_model.h>", False),
    ("lib/uhas/collision/self_collision.cpp", '"uhas/report/hand_glb.hpp"', True),
    ("lib/uhas/geometry/hand_geometry.cpp", "<fcl/narrowphase/distance.h>", True),
    ("lib/uhas/wrap/wrap.cpp", '"uhas/lateral_tables/lateral_tables.hpp"', True),
    ("lib/uhas/wrap/wrap.cpp", '"uhas/runtime/cascade_solver.hpp"', True),
    ("lib/uhas/correspondences/rays/ray_caster.cpp", "<embree4/rtcore.h>", False),
    ("lib/uhas/correspondences/correspondences.cpp", '"uhas/wrap/wrap.hpp"', True),
    ("lib/uhas/profile_builder/build_profile.cpp", '"command_line/tool.hpp"', True),
    ("lib/uhas/profile_builder/build_profile.cpp", '"support/toy_hand.hpp"', True),
    ("lib/uhas/attic/attic.cpp", "<vector>", True),
    ("lib/uhas/anatomy/palm/back/attic.cpp", "<vector>", True),
    ("tools/uhas_solve.cpp", '"uhas/runtime/cascade_solver.hpp"', False),
    ("tools/uhas_solve.cpp", '"uhas/runtime/cascade/moments.hpp"', True),
    ("tools/uhas_solve.cpp", '"support/toy_hand.hpp"', True),
    ("tests/unit/runtime/moments_test.cpp", '"uhas/runtime/cascade/moments.hpp"', False),
]


# a line of lib, whether it names an option of the tools in a text
PLANTED_TEXTS = [
    ('throw Error("raise it by --limit links=N");', True),
    ('throw Error("a \\" quote; --limit links=N");', True),
    ('// "--config" says so', False),
    ('for (int i = 3; --i > 0;) names("x--y");', False),
]


def problems_of_planted(sample):
    """What is said of a folder with this file in it, which has that line alone."""
    file, line = sample
    with tempfile.TemporaryDirectory() as folder:
        root = pathlib.Path(folder)
        path, listed = root / file, root / "lib/uhas" / PLANTED_PUBLIC
        for parent in (path.parent, listed.parent):
            parent.mkdir(parents=True, exist_ok=True)
        listed.touch()
        (root / PUBLIC_HEADERS).write_text(f"runtime {PLANTED_PUBLIC}\n")
        path.write_text(f"// planted\n{line}\n", encoding="utf-8")
        return problems(root)[0]


def main():
    if sys.argv[1:] == ["--self-test"]:
        lines = [((file, f"  #  include {include}"), forbidden) for file, include, forbidden in PLANTED]
        texts = [(("lib/uhas/model/hand_model.cpp", text), forbidden) for text, forbidden in PLANTED_TEXTS]
        return self_test(lines + texts, problems_of_planted)
    if len(sys.argv) != 2:
        print(__doc__, file=sys.stderr)
        return 2
    root = pathlib.Path(sys.argv[1])
    found, files = problems(root)
    described = set(re.findall(r"lib/uhas/(\S+)", (root / REFERENCE).read_text()))
    found += [f"{header}: in one of {PUBLIC_HEADERS} and {REFERENCE} only" for header in sorted(described ^ set(public_headers(root)))]
    print("\n".join(found) or f"{files} files, every include along the arrows")
    return 0 if files and not found else 1


if __name__ == "__main__":
    sys.exit(main())
