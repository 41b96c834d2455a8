#!/usr/bin/env python3
"""Validates the JSON that every tool writes, and the JSON files in this repository, against schemas/."""
import argparse
import json
import pathlib
import re
import subprocess
import sys
import tempfile

import jsonschema

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
HAND = ROOT / "hands" / "allegro_right" / "allegro_right.urdf"

ACTIONS = {
    "format": "uhas-actions", "version": 1, "profile": "hand.h5", "driving_vectors_phi": [1.0, 2.0], "normalized": False,
    "actions": [[0.0] * 15, [0.0] * 5 + [-2.0] * 10, {"lateral": [0.1] * 5, "radial": [[0.2, -0.2]] * 5}],
}
REPORT = re.compile(r'<script type="application/json" id="uhas-report">(.*?)</script>')
WRONG_ACTIONS = [
    {"format": "uhas-actions", "version": 1, "actions": [[0.0] * 14]},
    {"format": "uhas-actions", "version": 1, "actions": [["0"] * 15]},
    {"format": "uhas-actions", "version": 1, "actions": [], "extra": 1},
]


def load_schemas():
    schemas = {}
    for path in sorted((ROOT / "schemas").glob("*.schema.json")):
        schema = json.loads(path.read_text())
        jsonschema.Draft202012Validator.check_schema(schema)
        schemas[path.name.removesuffix(".schema.json")] = jsonschema.Draft202012Validator(schema)
    return schemas


def refuse_constant(name):
    raise ValueError(f"{name} is not JSON")


def parse(text):
    """JSON without the NaN and Infinity that Python would let pass."""
    return json.loads(text, parse_constant=refuse_constant)


def tool_documents(bin_dir, folder):
    """(schema, label, document) of everything that the tools write."""
    profile, config, points, actions = (folder / name for name in ("hand.h5", "hand.json", "points.json", "actions.json"))
    actions.write_text(json.dumps(ACTIONS))

    def run(tool, *arguments, **options):
        return subprocess.run([bin_dir / tool, *map(str, arguments)], check=True, capture_output=True, text=True, **options).stdout

    commands = [
        ("profile-summary", "uhas-build-profile", [HAND, "-o", profile, "--json"]),
        ("profile-summary", "uhas-inspect", [profile, "--json"]),
        ("command-line", "uhas-inspect", ["--describe", "json"]),
        ("hand-explanation", "uhas-explain-hand", [HAND, "--json", "--write-config", config]),
        ("profile-check", "uhas-inspect", [profile, "--validate", "--check", HAND, "--json"]),
        ("evaluation", "uhas-evaluate", [profile, profile, "--actions", "20", "--lines", "5", "--json", "--quiet"]),
        ("evaluation", "uhas-evaluate", [profile, "--actions", "20", "--lines", "5", "--json", "--urdf", HAND]),
        ("sphere-frame", "uhas-sphere-frame", [HAND, "--json"]),
        ("joint-classes", "uhas-classify-joints", [HAND, "--json"]),
        ("lateral-tables", "uhas-lateral-tables", [HAND, "--json"]),
        ("surface-hits", "uhas-project-surface", [HAND, "--json", "-o", points]),
        ("solution", "uhas-solve", [actions]),
        ("solution", "uhas-solve", [actions, "--closing", "hard", "--rule", "contact", "--field", "field", "--actuated-only"]),
        ("solution", "uhas-solve", [actions, "--collisions", "--avoid", "--urdf", HAND]),
        ("trajectory", "uhas-retarget", ["--from", profile, "--to", profile, folder / "trajectory.json"]),
        ("retarget-summary", "uhas-retarget",
         ["--from", profile, "--to", profile, folder / "trajectory.json", "-o", folder / "out.jsonl", "--json"]),
    ]
    for schema, tool, arguments in commands:
        if tool == "uhas-retarget":  # of what uhas-solve has just solved
            solved = parse(run("uhas-solve", actions))
            trajectory = {"format": "uhas-trajectory", "version": 1, "joint_names": solved["joint_names"],
                          "q": [solution["q"] for solution in solved["solutions"]]}
            (folder / "trajectory.json").write_text(json.dumps(trajectory))
        switches = [argument for argument in arguments if str(argument).startswith("-")]
        yield schema, " ".join([tool, *switches]), parse(run(tool, *arguments))
    yield "surface-points", "uhas-project-surface -o", parse(points.read_text())
    yield "hand-config", "uhas-explain-hand --write-config", parse(config.read_text())

    pages = [("uhas-inspect --html", "uhas-inspect", [profile, profile]), ("uhas-solve --html", "uhas-solve", [actions])]
    for label, tool, arguments in pages:
        run(tool, *arguments, "--html", folder / "page.html", "--urdf", HAND)
        report = parse(REPORT.search((folder / "page.html").read_text())[1])
        yield "report", label, report
        yield "profile-summary", f"{label}: summary", report["hands"][0]["summary"]

    run("uhas-evaluate", profile, "--actions", "20", "--lines", "5", "--urdf", HAND, "--html", folder / "page.html")
    evaluation = parse(REPORT.search((folder / "page.html").read_text())[1])["hands"][0]["evaluation"]
    yield "evaluation", "uhas-evaluate --html: evaluation", evaluation

    header, *frames, summary = [parse(line) for line in (folder / "out.jsonl").read_text().splitlines()]
    yield "trajectory", "uhas-retarget -o (lines)", header | summary | {"q": [frame["q"] for frame in frames]}

    lines = "".join(json.dumps(action) + "\n" for action in ACTIONS["actions"])
    whole = parse(run("uhas-solve", actions))
    streamed = [parse(line) for line in run("uhas-solve", "-", "--profile", profile, input=lines).splitlines()]
    yield "solution", "uhas-solve - (lines)", dict(whole, solutions=streamed)


def repository_documents():
    for path in sorted([*ROOT.glob("examples/*.json"), *ROOT.glob("schemas/*.datasets.json")]):
        document = parse(path.read_text())
        yield document["format"].removeprefix("uhas-"), str(path.relative_to(ROOT)), document


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--bin", required=True, type=pathlib.Path, help="folder of the built tools")
    options = parser.parse_args()

    schemas, used, failed = load_schemas(), {"actions", "hand-config"}, 0
    with tempfile.TemporaryDirectory() as folder:
        documents = [*tool_documents(options.bin, pathlib.Path(folder)), *repository_documents(), ("actions", "actions", ACTIONS),
                     ("hand-config", "hand config", {"palm_link": "palm", "q_open": {"joint": 0.1}})]
    for name, label, document in documents:
        used.add(name)
        problems = [f"{'/'.join(map(str, e.absolute_path)) or 'document'}: {e.message[:200]}" for e in schemas[name].iter_errors(document)]
        if document.get("format", f"uhas-{name}") != f"uhas-{name}" or (name != "hand-config" and list(document)[:2] != ["format", "version"]):
            problems.append("does not open with format and version")
        failed += bool(problems)
        print(f"{'FAILED' if problems else 'ok':6}  {name:16} {label}", *problems, sep="\n        " if problems else "")
    for document in WRONG_ACTIONS:
        if schemas["actions"].is_valid(document):
            failed += 1
            print(f"FAILED  the schema accepts {document}")
    for name in sorted(set(schemas) - used):
        failed += 1
        print(f"FAILED  nothing was validated against {name}")
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
