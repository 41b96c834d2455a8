#!/usr/bin/env python3
"""Checks that includes follow the arrows between the rooms of lib/uhas.

    layering.py SOURCE_FOLDER      exit 1 when a file in lib, tools or tests includes what its place must not
    layering.py --self-test        exit 1 when one of the forbidden includes planted here goes unnoticed
"""

import pathlib
import re
import sys
import tempfile

# Which rooms a room includes, besides itself. Data flows down this list, and so do nearly all arrows.
ROOMS = {
    "base": [],
    "profile": ["base"],
    "profile_io": ["base", "profile"],
    "runtime": ["base", "profile"],
    "c": ["base", "profile", "profile_io", "runtime"],
    "model": ["base", "profile", "runtime"],
    "anatomy": ["base", "profile", "runtime", "model"],
    "sphere_frame": ["base", "profile", "runtime", "model", "anatomy"],
    "classification": ["base", "profile", "runtime", "model", "anatomy", "sphere_frame"],
    "wrap": ["base", "profile", "runtime", "model", "anatomy", "sphere_frame", "classification"],
    "lateral_tables": ["base", "profile", "runtime", "model", "anatomy", "sphere_frame", "classification", "wrap"],
    "correspondences": ["base", "profile", "runtime", "model", "anatomy", "sphere_frame"],
    "profile_builder": ["base", "profile", "runtime", "model", "anatomy", "sphere_frame", "classification", "wrap",
                        "lateral_tables", "correspondences"],
    "geometry": ["base", "profile", "model"],
    "collision": ["base", "profile", "runtime", "model", "geometry"],
    "evaluation": ["base", "profile", "runtime", "model", "geometry", "collision"],
    "report": ["base", "profile", "profile_io", "runtime", "model", "geometry"],
}

# The rooms that may include a library; every other library but C++'s and the system's own is for nobody in lib.
LIBRARIES = {
    "Eigen": list(ROOMS),
    "hdf5": ["profile_io"],
    "urdf_parser": ["model"],
    "urdf_model": ["model"],
    "tinyxml": ["model"],
    "console_bridge": ["model"],
    "assimp": ["model", "report"],
    "nlohmann": ["model", "anatomy", "profile_builder", "report"],
    "embree3": ["correspondences"],
    "embree4": ["correspondences"],
    "meshoptimizer": ["geometry"],
    "fcl": ["collision"],
    "nlopt": ["evaluation"],
}

# What users of the runtime see: its public headers include C++'s own and each other, no library.
RUNTIME = ["base", "profile", "profile_io", "runtime", "c"]

SYSTEM = re.compile(r"[a-z0-9_]+|(?:sys/)?[a-z]+\.h")  # <vector>, <cstdint>; <unistd.h>, <sys/stat.h>
INCLUDE = re.compile(r'^\s*#\s*include\s*(["<])([^">]+)[">]', re.MULTILINE)
SOURCES = {".hpp", ".cpp", ".h", ".c"}


def library_of(header):
    """The first part of a header's path: `assimp` of assimp/scene.h, `hdf5` of hdf5.h."""
    return re.split(r"[/.]", header)[0]


def problem_in_lib(room, path, quoted, header):
    """What is wrong with this include in a file of lib/uhas, or None."""
    if quoted:
        match = re.fullmatch(r"uhas/(\w+)/([\w.]+)", header)
        if not match:
            return 'write "uhas/<room>/<file>.hpp"'
        other, file = match.groups()
        if other not in ROOMS:
            return f"there is no room {other}"
        if other != room and other not in ROOMS[room]:
            return f"{room} may include only {', '.join(ROOMS[room]) or 'nothing of the other rooms'}"
        if other != room and "_detail." in file:
            return f"a private header of {other}"
        if "_detail." in file and path.suffix in {".hpp", ".h"} and "_detail" not in path.stem:
            return "a public header must not include a private one"
        return None
    library = library_of(header)
    if library in LIBRARIES:
        if room not in LIBRARIES[library]:
            return f"{library} is for {', '.join(LIBRARIES[library])} only"
        if room in RUNTIME and path.suffix in {".hpp", ".h"} and "_detail" not in path.stem:
            return f"a public header of {room} must not need {library}"
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
        if place == "tools" and "_detail." in header:
            return f"a private header of {room}"
    elif place == "tools" and header.startswith(("support/", "tests/")):
        return "tools must not include tests"
    return None


def problems(root):
    """One line for each include against the arrows, and the number of files read."""
    found, files = [], 0
    for place in ("lib", "tools", "tests"):
        for path in sorted((root / place).rglob("*")):
            if path.suffix not in SOURCES or not path.is_file():
                continue
            files += 1
            text = path.read_text(encoding="utf-8")
            parts = path.relative_to(root).parts  # lib, uhas, <room>, <file>
            for match in INCLUDE.finditer(text):
                quoted, header = match[1] == '"', match[2]
                if place != "lib":
                    problem = problem_outside(place, quoted, header)
                elif len(parts) != 4 or parts[2] not in ROOMS:
                    problem = "a file outside the rooms"
                else:
                    problem = problem_in_lib(parts[2], path, quoted, header)
                if problem:
                    line = text.count("\n", 0, match.start(1)) + 1
                    found.append(f"{path.relative_to(root)}:{line}: {header}: {problem}")
    return found, files


# file, what it includes, whether that is against the arrows
PLANTED = [
    ("lib/uhas/base/errors.hpp", "<vector>", False),
    ("lib/uhas/base/errors.hpp", '"uhas/profile/hand_profile.hpp"', True),
    ("lib/uhas/profile_io/write_profile.cpp", "<hdf5.h>", False),
    ("lib/uhas/profile_io/hdf5_detail.hpp", "<hdf5.h>", False),
    ("lib/uhas/profile_io/write_profile.hpp", "<hdf5.h>", True),
    ("lib/uhas/profile_io/write_profile.cpp", '"uhas/anatomy/anatomy.hpp"', True),
    ("lib/uhas/runtime/cascade.cpp", "<Eigen/Core>", False),
    ("lib/uhas/runtime/cascade.cpp", '"uhas/runtime/cascade_detail.hpp"', False),
    ("lib/uhas/runtime/cascade.cpp", '"uhas/model/hand_model.hpp"', True),
    ("lib/uhas/runtime/cascade.cpp", '"uhas/profile_io/read_profile.hpp"', True),
    ("lib/uhas/runtime/cascade.cpp", "<hdf5.h>", True),
    ("lib/uhas/runtime/cascade_solver.hpp", "<Eigen/Core>", True),
    ("lib/uhas/runtime/cascade_solver.hpp", '"uhas/runtime/cascade_detail.hpp"', True),
    ("lib/uhas/c/profile.cpp", '"uhas/profile_io/read_profile.hpp"', False),
    ("lib/uhas/runtime/cascade.cpp", '"uhas/c/uhas.h"', True),
    ("lib/uhas/anatomy/anatomy.cpp", '"uhas/model/hand_model.hpp"', False),
    ("lib/uhas/anatomy/anatomy.cpp", '"uhas/model/mesh_reader_detail.hpp"', True),
    ("lib/uhas/anatomy/anatomy.cpp", '"anatomy.hpp"', True),
    ("lib/uhas/anatomy/anatomy.cpp", "<uhas/anatomy/anatomy.hpp>", True),
    ("lib/uhas/anatomy/anatomy.cpp", "<assimp/scene.h>", True),
    ("lib/uhas/anatomy/anatomy.cpp", "<boost/optional.hpp>", True),
    ("lib/uhas/collision/link_surface_detail.hpp", "<fcl/geometry/bvh/BVH_model.h>", False),
    ("lib/uhas/collision/self_collision.cpp", '"uhas/report/hand_glb.hpp"', True),
    ("lib/uhas/geometry/hand_geometry.cpp", "<fcl/narrowphase/distance.h>", True),
    ("lib/uhas/wrap/wrap.cpp", '"uhas/lateral_tables/lateral_tables.hpp"', True),
    ("lib/uhas/correspondences/ray_caster_detail.cpp", "<embree4/rtcore.h>", False),
    ("lib/uhas/correspondences/correspondences.cpp", '"uhas/wrap/wrap.hpp"', True),
    ("lib/uhas/profile_builder/build_profile.cpp", '"common/tool.hpp"', True),
    ("lib/uhas/profile_builder/build_profile.cpp", '"support/toy_hand.hpp"', True),
    ("lib/uhas/attic/attic.cpp", "<vector>", True),
    ("tools/uhas_solve.cpp", '"uhas/runtime/cascade_solver.hpp"', False),
    ("tools/uhas_solve.cpp", '"uhas/runtime/moments_detail.hpp"', True),
    ("tools/uhas_solve.cpp", '"support/toy_hand.hpp"', True),
    ("tests/unit/runtime/moments_test.cpp", '"uhas/runtime/moments_detail.hpp"', False),
]


def self_test():
    wrong = []
    for file, include, forbidden in PLANTED:
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder) / file
            path.parent.mkdir(parents=True)
            path.write_text(f"// planted\n  #  include {include}\n", encoding="utf-8")
            if bool(problems(pathlib.Path(folder))[0]) != forbidden:
                wrong.append(f"{file}: {include}: {'not caught' if forbidden else 'wrongly refused'}")
    print("\n".join(wrong) or f"{len(PLANTED)} planted includes, each judged rightly")
    return not wrong


def main():
    if sys.argv[1:] == ["--self-test"]:
        return 0 if self_test() else 1
    if len(sys.argv) != 2:
        print(__doc__, file=sys.stderr)
        return 2
    found, files = problems(pathlib.Path(sys.argv[1]))
    print("\n".join(found) or f"{files} files, every include along the arrows")
    return 0 if files and not found else 1


if __name__ == "__main__":
    sys.exit(main())
