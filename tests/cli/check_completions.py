#!/usr/bin/env python3
"""The completion scripts of the tools, run in the shells that they are for.

    check_completions.py --bin build/dev/bin --completions build/dev/tools/completions

What a shell offers after `uhas-<tool> --` are the options of the tool's parser (--describe), after an option that takes one of a
few words those words, and after one that takes a file the files there. A shell that is not installed is skipped.
"""

import argparse
import json
import os
import pathlib
import pty
import re
import select
import shutil
import subprocess
import sys
import tempfile
import time

FILE = "some file.h5"  # what is there to complete


def describe(tool):
    return json.loads(subprocess.run([tool, "--describe", "json"], capture_output=True, text=True, check=True).stdout)


class Bash:
    def __init__(self, scripts, folder):
        self.scripts, self.folder = scripts, folder

    def offers(self, *words):
        """What `complete` offers for the last word; file names stand in for the default that the script leaves to readline."""
        tool = words[0]
        script = f"""
            source {self.scripts}/bash/{tool}
            files=default
            compopt() {{ [[ $* == "+o default" ]] && files=; }}
            COMP_WORDS=({" ".join(f"'{word}'" for word in words)})
            COMP_CWORD={len(words) - 1}
            [[ $(complete -p {tool}) == *"-o default -F "* ]] || exit 1
            _{tool.replace("-", "_")}
            if ((${{#COMPREPLY[@]}} == 0)) && [[ $files ]]; then mapfile -t COMPREPLY < <(compgen -f -- '{words[-1]}'); fi
            printf '%s\\n' "${{COMPREPLY[@]}}"
        """
        done = subprocess.run(["bash", "--norc", "-c", script], cwd=self.folder, capture_output=True, text=True, check=True)
        return set(done.stdout.split("\n")) - {""}


class Fish:
    def __init__(self, scripts, folder):
        self.scripts, self.folder = scripts, folder

    def offers(self, *words):
        script = f"source {self.scripts}/fish/{words[0]}.fish; complete -C '{' '.join(words)}'"
        done = subprocess.run(["fish", "--no-config", "-c", script], cwd=self.folder, capture_output=True, text=True, check=True)
        return {line.split("\t")[0] for line in done.stdout.splitlines()}


class Zsh:
    """An interactive shell: its completion runs nowhere else."""

    READY = "ready>"

    def __init__(self, scripts, folder):
        pid, self.terminal = pty.fork()
        if pid == 0:
            os.chdir(folder)
            os.execvpe("zsh", ["zsh", "-f", "-i"], dict(os.environ, TERM="dumb", PS1=self.READY))
        self.read_until(self.READY)
        for line in ("unset zle_bracketed_paste", "unsetopt prompt_sp", f"fpath=({scripts}/zsh $fpath)", "autoload -Uz compinit",
                     "compinit -u -D", "LISTMAX=9999", "zstyle ':completion:*' verbose no", "bindkey '^I' list-choices",
                     "stty cols 1000 rows 1000"):
            self.send(line + "\n")
            self.read_until(self.READY)

    def send(self, text):
        os.write(self.terminal, text.encode())

    def read_until(self, end):
        """Output, without control sequences, up to the pattern `end`."""
        text, give_up = "", time.monotonic() + 20
        while not re.search(end + "$", text):
            if time.monotonic() > give_up:
                raise TimeoutError(f"zsh says only {text!r}")
            if select.select([self.terminal], [], [], 1)[0]:
                text += os.read(self.terminal, 65536).decode(errors="replace")
                text = re.sub(r"\x1b\[[0-9;?]*[A-Za-z]", "", text)
        return text

    def offers(self, *words):
        self.send(" ".join(words) + "\t")
        self.send("\x15: end of list\n")  # control-U drops the line
        text = self.read_until("end of list\\s+" + self.READY)
        _, _, listed = text.partition("\r\n")  # after the line itself, until it is shown again
        return set(re.split(r"\s{2,}|[\r\n]+", listed.split(self.READY)[0])) - {""}


def check(shell, tool, parser):
    """Messages on what a shell offers for one tool."""
    long_names = {name for option in parser["options"] for name in option["names"] if name.startswith("--")}
    offered = {word for word in shell.offers(tool, "--") if word.startswith("--")}
    if offered != long_names:
        yield f"offers {sorted(offered)} for --, not {sorted(long_names)}"
    for option in parser["options"]:
        name = option["names"][-1]
        if option["kind"] == "words":
            offered, words = shell.offers(tool, name, ""), set(option["words"])
            if offered != words:
                yield f"offers {sorted(offered)} for {name}, not {sorted(words)}"
        if option["kind"] == "file" and not any(FILE in word.replace("\\", "") for word in shell.offers(tool, name, "")):
            yield f"offers no file for {name}"
    if not any(FILE in word.replace("\\", "") for word in shell.offers(tool, "")):
        yield "offers no file for its argument"


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--bin", required=True, type=pathlib.Path, help="folder of the tools")
    parser.add_argument("--completions", required=True, type=pathlib.Path, help="folder of the completion scripts")
    options = parser.parse_args()

    tools = {path.name: describe(path) for path in sorted(options.bin.glob("uhas-*")) if os.access(path, os.X_OK)}
    faults = [] if tools else ["no tools"]
    with tempfile.TemporaryDirectory() as folder:
        pathlib.Path(folder, FILE).touch()
        for shell in (Bash, Zsh, Fish):
            name = shell.__name__.lower()
            if not shutil.which(name):
                print(f"SKIPPED: completion in {name}: {name} is not installed")
                continue
            running = shell(options.completions.resolve(), folder)
            faults += [f"{name}: {tool} {fault}" for tool, parsed in tools.items() for fault in check(running, tool, parsed)]
    print("\n".join(faults) if faults else f"{len(tools)} tools complete")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
