#!/usr/bin/env python3
"""Runs a benchmark with --quick, validates its JSON, and looks for every requirement in its text and its Markdown.

    smoke_test.py PROGRAM SCHEMA URDF

Times are not looked at: they mean nothing here.
"""

import json
import pathlib
import subprocess
import sys

import jsonschema


def main():
    if len(sys.argv) != 4:
        print(__doc__, file=sys.stderr)
        return 2
    program, schema_file, urdf = sys.argv[1:]
    schema = json.loads(pathlib.Path(schema_file).read_text())
    jsonschema.Draft202012Validator.check_schema(schema)

    def run(*options):
        return subprocess.run([program, "--quick", *options, urdf], check=True, capture_output=True, text=True).stdout

    def refuse(constant):
        raise ValueError(f"{constant} is not JSON")

    document = json.loads(run("--json"), parse_constant=refuse)
    problems = [f"{error.json_path}: {error.message[:200]}" for error in
                jsonschema.Draft202012Validator(schema).iter_errors(document)]
    for options in ([], ["--markdown"]):
        text = run(*options)
        problems += [f"{options}: no row for {row['requirement']!r}" for row in document["requirements"]
                     if row["requirement"] not in text]
    print("\n".join(problems) or f"valid; {len(document['requirements'])} requirements in the tables")
    return 1 if problems else 0


if __name__ == "__main__":
    sys.exit(main())
